//! Progress on standard error: only on a terminal, only for what takes longer than a moment.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, stderr};
use std::time::{Duration, Instant};

/// How long a run may be silent.
const MOMENT: Duration = Duration::from_millis(700);

/// A bar that appears once a run has lasted a moment.
#[derive(Debug)]
pub struct Progress {
    bar: ProgressBar,
    begun: Instant,
    terminal: bool,
}

impl Progress {
    /// A bar that is not yet shown.
    pub fn new() -> Self {
        let style = ProgressStyle::with_template("{bar:24} {pos}/{len} {wide_msg}").expect("a valid template");
        let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()).with_style(style);
        Self { bar, begun: Instant::now(), terminal: stderr().is_terminal() }
    }

    /// `jobs` more are to come.
    pub fn expect(&self, jobs: u64) {
        self.bar.set_length(self.bar.length().unwrap_or(0) + jobs);
    }

    /// Does `job` under its `address`.
    pub fn during<T>(&self, address: String, job: impl FnOnce(String) -> T) -> T {
        if self.begun.elapsed() > MOMENT {
            self.reveal();
        }
        self.bar.set_message(address.clone());
        let result = job(address);
        self.bar.inc(1);
        result
    }

    /// Shows the bar now: what comes is known to take long.
    pub fn reveal(&self) {
        if self.terminal && self.bar.is_hidden() {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }

    /// Does `job`, which may write to the terminal, while the bar is off the screen.
    pub fn hidden(&self, job: impl FnOnce()) {
        self.bar.suspend(job);
    }

    /// Takes the bar off the screen.
    pub fn end(&self) {
        self.bar.finish_and_clear();
    }
}
