//! `lesson eval` as scripts use it.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{command, lesson, lesson_fed};
use serde_json::Value;
use std::io::{BufRead, BufReader, Write};

const CALL: [&str; 5] = ["eval", "fresnel", "n1=1", "n2=1.5", "theta1=0"];
const LINES: [&str; 3] = ["eval", "fresnel", "--json-lines"];

/// The answers to `input`, with the exit code.
fn answers(input: &[u8]) -> (i32, Vec<Value>) {
    let run = lesson_fed(&LINES, input);
    assert_eq!(run.err, "", "{run:?}");
    (run.code, run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect())
}

#[test]
fn values_survive_the_trip_through_text() {
    let run = lesson_fed(&CALL, b"");
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let (_, answers) = answers(br#"{"n1": 1, "n2": 1.5, "theta1": 0}"#);
    let mut count = 0;
    for line in run.out.lines() {
        let (name, text) = line.split_once(' ').unwrap();
        let value: f64 = text.parse().unwrap();
        assert!(value.is_nan() || format!("{value:.16e}") == text, "{line}");
        match &answers[0][name] {
            Value::Number(number) => assert_eq!(number.as_f64().map(f64::to_bits), Some(value.to_bits()), "{line}"),
            name => assert!(!value.is_finite() && name.is_string(), "{line}"),
        }
        count += 1;
    }
    assert_eq!(count, answers[0].as_object().unwrap().len());
    let r_s: f64 = run.out.lines().find_map(|line| line.strip_prefix("R_s ")).unwrap().parse().unwrap();
    assert!((r_s - 0.04).abs() < 1e-16);
}

#[test]
fn angles_may_carry_their_unit() {
    let degrees = lesson("eval fresnel n1=1 n2=1.5 theta1=60deg");
    let radians = lesson(&format!("eval fresnel n1=1 n2=1.5 theta1={:?}", 60_f64.to_radians()));
    assert_eq!((degrees.code, &degrees.out), (0, &radians.out));
    let (code, lines) =
        answers(b"{\"n1\":1,\"n2\":1.5,\"theta1\":\"60deg\"}\n{\"n1\":1,\"n2\":1.5,\"theta1\":1.0471975511965976}\n");
    assert_eq!((code, &lines[0]), (0, &lines[1]));
}

#[test]
fn bad_arguments_name_their_place_and_range() {
    for (arguments, words) in [
        ("eval fresnell n1=1", &["fresnell", "did you mean `fresnel`"][..]),
        ("eval fresnel n1=1 n2=-1.5 theta1=0", &["n2", "valid"]),
        ("eval fresnel n1=1 n2=nan theta1=0", &["n2", "valid"]),
        ("eval plane-wave eps_r=0 mu_r=1 sigma=5.8e7 freq_hz=50", &["eps_r", "valid"]),
        ("eval plane-wave eps_r=1 mu_r=-1 sigma=5.8e7 freq_hz=50", &["mu_r", "valid"]),
        ("eval plane-wave eps_r=1 mu_r=1 sigma=-1 freq_hz=50", &["sigma", "valid"]),
        ("eval plane-wave eps_r=1 mu_r=1 sigma=nan freq_hz=50", &["sigma", "valid"]),
        ("eval plane-wave eps_r=1 mu_r=1 sigma=0 freq_hz=0", &["freq_hz", "valid"]),
        ("eval fresnel n1=1 n2=1e400 theta1=0", &["n2", "1e400", "valid"]),
        ("eval fresnel n1=1 n2=1.5 theta1=95deg", &["theta1", "95deg", "valid: 0deg to 90deg"]),
        ("eval fresnel n1=1 n2=1.5 thet1=0", &["no such input of fresnel", "did you mean `theta1`"]),
        ("eval fresnel n1=1 n2=1.5 theta1=[1]", &["theta1", "must be a number"]),
        ("eval fresnel n1=1 n2=1.5 theta1=[1", &["theta1", "column"]),
        ("eval fresnel n1=1 n2=1.5 psi=0", &["psi", "n1"]),
        ("eval fresnel n1=1 n1=1 n2=1.5 theta1=0", &["n1", "twice"]),
        ("eval fresnel n1=1", &["missing"]),
        ("eval fresnel n_i=1 n_t=1.5 theta=56.3", &["theta", "valid: 0 to 1.57", "did you mean `56.3deg`"]),
        ("eval fresnel n_i=1 n_t=glod theta=0", &["n_t", "glod", "did you mean `gold`"]),
        ("eval fresnel n_i=gold n_t=1 theta=0", &["n_i", "absorbs"]),
        ("eval fresnel n_i=1 n_t=gold k2=1 theta=0", &["k2", "gold"]),
        ("eval fresnel n_i=1 n_t=gold theta=0 wavelength=5um", &["n_t", "gold at 5000 nm"]),
        ("eval fresnel n_i=1 n_t=1 theta=0 wavelength=5um freq=1THz", &["freq", "wavelength", "give one of them"]),
        ("eval fresnel n_i=1 n1=1 n_t=1 theta=0", &["n1", "n_i", "give one of them"]),
    ] {
        let run = lesson(arguments);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (2, "", 1), "{arguments}: {run:?}");
        assert!(run.err.starts_with("error: "), "{run:?}");
        assert!(words.iter().all(|word| run.err.contains(word)), "{arguments}: {}", run.err);
    }
    assert_eq!(lesson("eval").code, 2);
}

#[test]
fn one_quantity_has_one_name_and_the_older_ones_still_serve() {
    let old = lesson("eval fresnel n1=1 n2=0.2 k2=3.4 theta1=60deg");
    assert_eq!(old.code, 0, "{old:?}");
    for arguments in [
        "eval fresnel n_i=1 n_t=0.2 k_t=3.4 theta=60deg",
        "eval fresnel n_i=1 n_t=0.2+3.4i theta=60deg",
        r#"eval fresnel n_i=1 n_t={"n":0.2,"k":3.4} theta=60deg"#,
    ] {
        assert_eq!(lesson(arguments).out, old.out, "{arguments}");
    }
    let step = |arguments: &str| lesson(arguments).out;
    assert_eq!(
        step("eval thin-film lambda_nm=550 n0=1 layers=[] substrate={\"n\":1.5} theta0=0 pol=s"),
        step("eval thin-film wavelength=550nm n_i=1 layers=[] substrate={\"n\":1.5} theta=0deg pol=s"),
    );
    assert_eq!(
        step("eval plane-wave eps_r=1 mu_r=1 sigma=5.8e7 freq_hz=50"),
        step("eval plane-wave medium=1/1/5.8e7 freq=50Hz")
    );
}

#[test]
fn media_go_by_name() {
    let gold = lesson("eval fresnel n_i=1 n_t=gold wavelength=550nm theta=45deg");
    assert_eq!((gold.code, gold.out.lines().count()), (0, 14), "{gold:?}");
    assert_eq!(lesson("eval fresnel n_i=1 n_t=gold wavelength=550nm theta1=45deg").out, gold.out);
    let film = |layer: &str| {
        lesson(&format!(
            "eval thin-film wavelength=550nm n_i=1 theta=0 pol=p layers=[{layer}] substrate={{\"n\":\"bk7\"}}"
        ))
    };
    let named = film(r#"{"medium":"gold","d_nm":20}"#);
    assert_eq!((named.code, &named.out), (0, &film(r#"{"n":"gold","d":"20nm"}"#).out));
}

#[test]
fn every_bad_line_leaves_its_error_in_its_place() {
    let deep = format!("{{\"n1\":{}1{}}}", "[".repeat(100_000), "]".repeat(100_000));
    let good = r#"{"n1":1,"n2":1.5,"theta1":0}"#;
    let bad: [&[u8]; 14] = [
        b"{\"n1\":1,",
        b"nonsense",
        b"[1,2]",
        b"42",
        b"{\"n1\":true,\"n2\":1.5,\"theta1\":0}",
        b"{\"n1\":null,\"n2\":1.5,\"theta1\":0}",
        b"{\"n1\":\"one\",\"n2\":1.5,\"theta1\":0}",
        b"{\"n1\":1e400,\"n2\":1.5,\"theta1\":0}",
        b"{\"n1\":1,\"n1\":2,\"n2\":1.5,\"theta1\":0}",
        b"{\"n1\":1,\"n2\":1.5,\"theta1\":0} {}",
        b"{\"n\xff1\":1}",
        b"\xff\xfe",
        b"{\"n1\":1,\"n2\":1.5,\"theta1\":3}",
        deep.as_bytes(),
    ];
    let mut input = Vec::new();
    for line in bad {
        input.extend_from_slice(line);
        input.extend_from_slice(b"\n");
        input.extend_from_slice(good.as_bytes());
        input.extend_from_slice(b"\r\n\n");
    }
    let (code, answers) = answers(&input);
    // The blank line after the last answer is no question.
    assert_eq!((code, answers.len()), (2, 3 * bad.len() - 1));
    for (at, pair) in answers.chunks(3).enumerate() {
        let error = pair[0]["error"].as_str().unwrap_or_else(|| panic!("{:?}: {}", bad[at], pair[0]));
        assert!(error.starts_with(&format!("line {}: ", 3 * at + 1)) && error.len() < 400, "{error}");
        assert!(pair[1]["R_s"].is_f64(), "{}", pair[1]);
        assert!(pair.get(2).is_none_or(|blank| blank["error"] == format!("line {}: empty", 3 * at + 3)));
    }
}

#[test]
fn values_of_the_wrong_kind_name_their_field_and_range() {
    for value in ["true", "null", "1e400", "[1]", "{}", "\"one\"", "-1"] {
        let (code, answers) = answers(format!("{{\"n1\":1,\"n2\":{value},\"theta1\":0}}").as_bytes());
        let error = answers[0]["error"].as_str().unwrap();
        assert!(code == 2 && error.starts_with("line 1: n2: ") && error.contains("valid: 1e-9 to 1e9"), "{error}");
    }
}

#[test]
fn outputs_come_as_one_object_too() {
    let object: Value = serde_json::from_str(&lesson("eval fresnel n1=1 n2=1.5 theta1=0 --json").out).unwrap();
    assert_eq!(object, answers(br#"{"n1": 1, "n2": 1.5, "theta1": 0}"#).1[0]);
}

#[test]
fn a_huge_line_is_skipped_and_the_next_one_read() {
    let mut input = br#"{"n1":""#.to_vec();
    input.resize(40 << 20, b'x');
    input.extend_from_slice(b"\"}\n{\"n1\":1,\"n2\":1.5,\"theta1\":0}");
    let (code, answers) = answers(&input);
    assert_eq!((code, answers.len()), (2, 2));
    assert_eq!(answers[0]["error"], "line 1: longer than 16 MiB");
    assert!(answers[1]["R_s"].is_f64());
}

#[test]
fn no_input_is_no_output() {
    assert_eq!(answers(b""), (0, vec![]));
    assert_eq!(answers(b"\n  \n"), (0, vec![]));
}

#[test]
fn an_answer_comes_before_the_next_question() {
    let mut child = command(&LINES).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let mut stdout = BufReader::new(child.stdout.take().unwrap());
    for _ in 0..3 {
        stdin.write_all(b"{\"n1\":1,\"n2\":1.5,\"theta1\":0}\n").unwrap();
        let mut line = String::new();
        stdout.read_line(&mut line).unwrap();
        assert!(line.starts_with("{\"") && line.ends_with("}\n"));
    }
    drop(stdin);
    assert!(child.wait().unwrap().success());
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let mut child = command(&LINES).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    drop(child.stdout.take());
    // As much as it takes to notice.
    while stdin.write_all(b"{\"n1\":1,\"n2\":1.5,\"theta1\":0}\n").is_ok() {}
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
}

#[test]
fn the_list_documents_inputs_and_outputs() {
    let list: Value = serde_json::from_str(&lesson("eval --list --json").out).unwrap();
    let function = list["functions"].as_array().unwrap().iter().find(|function| function["name"] == "fresnel").unwrap();
    for field in function["inputs"].as_array().unwrap().iter().chain(function["outputs"].as_array().unwrap()) {
        assert!(field["name"].is_string() && !field["says"].as_str().unwrap().is_empty(), "{field}");
        assert!(field["unit"].is_string(), "{field}");
    }
    assert!(lesson("eval --list").out.contains("theta1"));
    let inputs = function["inputs"].as_array().unwrap();
    let theta = inputs.iter().find(|input| input["name"] == "theta").unwrap();
    assert_eq!(
        (&theta["kind"], &theta["aliases"][0], &theta["symbol"]),
        (&"number".into(), &"theta1".into(), &"θ_1".into())
    );
    assert_eq!((&theta["domain"][0], &theta["takes"]["unit"]), (&0.0.into(), &"rad".into()));
}

#[test]
fn a_report_tells_what_its_parameters_may_be() {
    let report: Value = serde_json::from_str(&lesson("fresnel brewster --check --json").out).unwrap();
    let setting = report["chapters"][0]["steps"][0]["setting"].as_array().unwrap();
    let of = |name: &str| setting.iter().find(|parameter| parameter["name"] == name).unwrap();
    let wavelength = of("wavelength");
    assert_eq!((&wavelength["symbol"], &wavelength["default"]), (&"λ".into(), &"550nm".into()));
    assert_eq!((&wavelength["domain"]["min"], &wavelength["domain"]["scale"]), (&1e-9.into(), &"logarithmic".into()));
    let names = of("n_t")["domain"]["names"].as_array().unwrap();
    assert!(
        names.contains(&"gold".into()) && !of("n_i")["domain"]["names"].as_array().unwrap().contains(&"gold".into())
    );
}

#[test]
fn a_byte_order_mark_before_the_first_line_is_no_part_of_it() {
    let line = "{\"n_i\":1,\"n_t\":1.5,\"theta\":0}\n";
    let plain = lesson_fed(&["eval", "fresnel", "--json-lines"], line.as_bytes());
    let marked = lesson_fed(&["eval", "fresnel", "--json-lines"], format!("\u{feff}{line}").as_bytes());
    assert_eq!((marked.code, marked.out), (0, plain.out));
    // Anywhere else it is an error.
    let second = lesson_fed(&["eval", "fresnel", "--json-lines"], format!("{line}\u{feff}{line}").as_bytes());
    assert!(second.code == 2 && second.out.contains("line 2"), "{second:?}");
}

#[test]
fn a_fault_at_no_place_names_none() {
    for (line, place) in [("[1]", None), ("1", None), ("{\"n_i\":}", Some("(column 8)"))] {
        let run = lesson_fed(&["eval", "fresnel", "--json-lines"], line.as_bytes());
        assert!(!run.out.contains("column 0"), "{run:?}");
        assert!(place.is_none_or(|place| run.out.contains(place)), "{run:?}");
    }
    let folded = lesson_fed(&["eval", "thin-film", "layers=[\n]x"], b"");
    assert!(folded.err.contains("(line 2, column 2)"), "{folded:?}");
}
