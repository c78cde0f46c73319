//! A browser without a window, driven by WebDriver (W3C, *WebDriver*, 2018).

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStdout, Command, Stdio};
use std::time::Duration;

/// What a browser that is driven must not do by itself, and how it runs on a machine without a screen.
const FLAGS: [&str; 8] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
];

/// A browser with a profile of its own, ended when this is dropped.
pub struct Browser {
    driver: Child,
    /// Kept, since what writes to a pipe that nobody has ends.
    _told: BufReader<ChildStdout>,
    session: String,
    agent: ureq::Agent,
}

impl Browser {
    /// A fresh one; None if there is none on this machine.
    pub fn start() -> Option<Self> {
        let mut driver =
            Command::new("chromedriver").arg("--port=0").stdout(Stdio::piped()).stderr(Stdio::null()).spawn().ok()?;
        let mut told = BufReader::new(driver.stdout.take().expect("piped"));
        let port = told.by_ref().lines().map_while(Result::ok).find_map(|line| {
            line.split_once("successfully on port ").map(|(_, port)| port.trim_end_matches('.').to_owned())
        });
        let port = port.expect("chromedriver says its port");
        let agent = ureq::Agent::config_builder()
            .timeout_global(Some(Duration::from_secs(300)))
            .http_status_as_error(false)
            .build()
            .new_agent();
        let mut browser = Self { driver, _told: told, session: String::new(), agent };
        let address = format!("http://127.0.0.1:{port}/session");
        let asked = json!({"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": {"args": FLAGS},
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
            // A page is there at once or never; what a script asks of a module may take its time [ms].
            "timeouts": {"pageLoad": 60_000, "script": 240_000},
        }}});
        let found = browser.send(&address, &asked);
        let id = found["sessionId"].as_str().unwrap_or_else(|| panic!("a session: {found}")).to_owned();
        browser.session = format!("{address}/{id}");
        Some(browser)
    }

    fn send(&self, url: &str, body: &Value) -> Value {
        let mut answer = self.agent.post(url).send_json(body).expect("the driver answers");
        let mut found: Value = answer.body_mut().read_json().expect("in JSON");
        found["value"].take()
    }

    fn ask(&self, command: &str, body: &Value) -> Value {
        let found = self.send(&format!("{}/{command}", self.session), body);
        assert!(found["error"].is_null(), "{command}: {found}");
        found
    }

    /// Loads a page and waits until it is there.
    pub fn load(&self, url: &str) {
        self.ask("url", &json!({"url": url}));
    }

    /// What a function's body returns there; a promise is waited for.
    pub fn run(&self, body: &str, arguments: Value) -> Value {
        let script = format!(
            "const done = arguments[arguments.length - 1]; (async (...given) => {{ {body} }})(...arguments).then(done, \
             (error) => done({{fault: String(error)}}));"
        );
        let found = self.ask("execute/async", &json!({"script": script, "args": arguments}));
        assert!(found["fault"].is_null(), "{body}: {}", found["fault"]);
        found
    }

    /// How large the window is [px].
    pub fn resize(&self, width: u32, height: u32) {
        self.ask("window/rect", &json!({"width": width, "height": height}));
    }

    /// What a log has had since it was last asked for.
    pub fn log(&self, kind: &str) -> Vec<Value> {
        self.ask("se/log", &json!({"type": kind})).as_array().cloned().unwrap_or_default()
    }

    /// Where the page that is shown asked for something since this was last asked.
    pub fn requests(&self) -> Vec<String> {
        let events = self.log("performance").into_iter().filter_map(|entry| {
            let event: Value = serde_json::from_str(entry["message"].as_str()?).ok()?;
            (event["message"]["method"] == "Network.requestWillBeSent")
                .then(|| event["message"]["params"]["request"]["url"].as_str().map(str::to_owned))?
        });
        events.collect()
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        if !self.session.is_empty() {
            let _ = self.agent.delete(&self.session).call();
        }
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}
