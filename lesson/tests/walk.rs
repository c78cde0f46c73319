//! What a reader sees, and what a script gets, from the real binary.

#[allow(dead_code, reason = "each test file uses its part")]
mod common;

use common::{command, folder, lesson};
use serde_json::Value;
use std::io::{BufRead, BufReader};

fn json(arguments: &str) -> Value {
    let run = lesson(arguments);
    assert!(run.code <= 1, "{run:?}");
    serde_json::from_str(&run.out).unwrap_or_else(|error| panic!("{error}: {}", run.out))
}

#[test]
fn the_map_is_one_screen_and_the_contents_have_a_line_for_each_step() {
    let map = lesson("");
    assert_eq!((map.code, map.err.as_str()), (0, ""));
    assert!(map.out.lines().count() <= 24, "{}", map.out);
    for word in ["maxwell", "path-tracing", "lesson contents", "lesson --help", "lesson fresnel"] {
        assert!(map.out.contains(word), "{word}");
    }
    let all = lesson("contents").out;
    for chapter in chapters::CURRICULUM {
        let own = lesson(&format!("contents {}", chapter.id)).out;
        assert!(all.contains(own.trim_end()), "{own}");
        // A heading, and a line each.
        let lines: Vec<_> = own.lines().filter(|line| !line.is_empty()).collect();
        assert_eq!(lines.len(), 1 + chapter.steps.len(), "{own}");
        assert!(chapter.steps.iter().zip(&lines[1..]).all(|(step, line)| line.trim_start().starts_with(step.id)));
    }
}

#[test]
fn text_fits_eighty_columns_and_carries_no_escapes_into_a_pipe() {
    for arguments in [
        "",
        "contents",
        "plane-wave",
        "poynting --stress",
        "fresnel",
        "fresnel --check",
        "fresnel brewster --stress",
        "coverage",
        "eval --list",
        "--help",
        "-h",
        "contents --help",
        "coverage --help",
        "eval --help",
        "prove --help",
        "completions --help",
        "help --help",
        "help eval",
        "all --help",
        "fresnel --help",
        "plane-wave conductor --help",
    ] {
        let run = lesson(arguments);
        assert!(!run.out.is_empty() && !run.out.contains('\x1b'), "{arguments}");
        for line in run.out.lines() {
            assert!(unicode_width::UnicodeWidthStr::width(line) <= 80, "{arguments}: {line}");
        }
    }
}

#[test]
fn help_on_a_step_tells_what_it_has_and_takes() {
    let help = lesson("fresnel brewster --help");
    assert_eq!((help.code, help.err.as_str()), (0, ""));
    for same in
        ["fresnel/brewster -h", "help fresnel brewster", "--help fresnel brewster", "fresnel/brewster/square --help"]
    {
        assert_eq!(lesson(same).out, help.out, "{same}");
    }
    for chapter in chapters::CURRICULUM {
        let whole = lesson(&format!("{} --help", chapter.id)).out;
        for step in chapter.steps {
            let help = lesson(&format!("{} {} --help", chapter.id, step.id)).out;
            // Columns are wrapped; words are not.
            let words: Vec<_> = help.split([' ', ',', '\n']).collect();
            for item in step.items() {
                assert!(words.contains(&item.id()), "{}/{}: {help}", step.id, item.id());
            }
            for parameter in step.parameters() {
                let media = parameter.kind.names();
                for word in parameter.names().chain(media).chain(parameter.default) {
                    assert!(words.contains(&word), "{}: {word}: {help}", step.id);
                }
                assert!(whole.contains(&format!("    {} ", parameter.name)), "{}: {whole}", parameter.name);
            }
            assert!(whole.contains(step.title), "{}", step.id);
        }
    }
    assert!(
        help.out.contains("θ₁") && help.out.contains("[rad]") && help.out.contains("valid: 0deg to"),
        "{}",
        help.out
    );
}

#[test]
fn a_whole_chapter_has_a_line_for_each_item_until_more_is_asked_for() {
    let folded = lesson("fresnel");
    assert_eq!(folded.code, 0);
    let lines: Vec<_> = folded.out.lines().collect();
    let chapter = chapters::CURRICULUM.iter().find(|chapter| chapter.id == "fresnel").unwrap();
    let claims = chapter.steps.iter().flat_map(|step| {
        let derivations = step.derivations.iter().map(|derivation| derivation.id);
        derivations.chain(step.checks.iter().map(|check| check.head().id))
    });
    for id in claims {
        assert!(lines.iter().any(|line| line.starts_with(&format!("    ✓ {id}  "))), "{id}");
    }
    assert!(!folded.out.contains("measured ") && folded.out.contains("--unfold all of it"));
    assert!(folded.out.contains("To set: n_i, n_t"), "the walk names what can be set");
    for open in ["fresnel --unfold", "fresnel --units", "fresnel brewster", "fresnel --check"] {
        assert!(lesson(open).out.contains("measured "), "{open}");
    }
    assert!(lesson("fresnel brewster").out.contains("gold, aluminium"), "a step names the media");
}

#[test]
fn a_step_is_found_by_word_and_by_address() {
    let step = lesson("fresnel brewster");
    assert!(step.out.contains("fresnel/brewster"), "{step:?}");
    for other in ["fresnel/brewster", "Fresnel BREWSTER", "fresnel/brewster/"] {
        assert_eq!(lesson(other).out, step.out, "{other}");
    }
    assert!(!step.out.contains("fresnel/natural/"));
    assert_eq!(lesson("fresnel total-reflection").out, lesson("fresnel total_reflection").out);
}

#[test]
fn an_item_is_run_alone() {
    let report = json("fresnel brewster --check --json");
    let check = report["chapters"][0]["steps"][0]["checks"][0]["address"].as_str().unwrap().to_owned();
    let run = lesson(&check);
    assert!(run.out.contains(&check) && run.out.ends_with("1 passed, 0 failed\n"), "{run:?}");
}

#[test]
fn a_question_is_folded_until_it_is_asked_for() {
    const RISES: &str = "changes its sign on the way";
    let folded = lesson("fresnel brewster --plain").out;
    assert!(folded.contains("how does R") && folded.contains("lesson fresnel/brewster/p_alone"), "{folded}");
    assert!(!folded.contains(RISES), "{folded}");
    let open = lesson("fresnel/brewster/p_alone");
    assert_eq!((open.code, open.err.as_str()), (0, ""));
    assert!(open.out.contains(RISES) && open.out.contains("right angles"), "{}", open.out);
    // The right answer follows the setting: equal media reflect nothing at any angle.
    for (setting, right) in [("n_t=1.5", 3), ("n_t=1", 1)] {
        let report = json(&format!("fresnel brewster --json --set {setting}"));
        let options = report["chapters"][0]["steps"][0]["questions"][0]["options"].as_array().unwrap();
        let rights: Vec<_> = options.iter().map(|option| option["right"].as_bool().unwrap()).collect();
        assert_eq!(rights.iter().position(|right| *right), Some(right), "{setting}");
        assert_eq!(rights.iter().filter(|right| **right).count(), 1);
    }
}

#[test]
fn every_run_ends_with_the_tally_that_its_exit_code_and_report_agree_with() {
    for arguments in ["fresnel", "fresnel --check", "fresnel brewster --stress", "fresnel brewster --check --stress"] {
        let run = lesson(arguments);
        let last = run.out.lines().last().unwrap();
        let report = json(&format!("{arguments} --json"));
        assert_eq!(last, format!("{} passed, {} failed", report["passed"], report["failed"]));
        assert_eq!(run.code == 0, report["failed"] == 0);
        let marks = |sign: char| run.out.lines().filter(|line| line.trim_start().starts_with(sign)).count() as u64;
        assert_eq!(marks('✗') > 0, report["failed"].as_u64() > Some(0), "{arguments}");
        assert!(marks('✓') <= report["passed"].as_u64().unwrap(), "{arguments}");
    }
}

#[test]
fn the_json_report_keeps_its_contract() {
    let report = json("fresnel brewster --check --stress --json");
    for key in ["schema", "version", "machine", "chapters", "passed", "failed"] {
        assert!(!report[key].is_null(), "{key}");
    }
    for step in report["chapters"][0]["steps"].as_array().unwrap() {
        let lists = ["rows", "setting", "readout", "statements", "derivations", "checks", "stress", "races", "figures"];
        assert!(lists.iter().all(|key| step[key].is_array()), "{step}");
        for check in step["checks"].as_array().unwrap() {
            for key in ["address", "claim", "value", "limit", "unit", "verdict", "at", "cases", "seconds"] {
                assert!(!check[key].is_null(), "{key}: {check}");
            }
        }
        for statement in step["statements"].as_array().unwrap() {
            for key in ["address", "latex", "unicode", "dimension"] {
                assert!(statement[key].as_str().is_some_and(|text| !text.is_empty()), "{key}: {statement}");
            }
        }
        for case in step["stress"].as_array().unwrap().iter().flat_map(|stress| stress["cases"].as_array().unwrap()) {
            let reference = case["reference"].as_str().unwrap();
            assert!(reference.contains('e') && reference.len() >= 20, "{case}");
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_numbers_on_any_number_of_threads() {
    let report = |threads: &str| {
        let output = command(&["fresnel", "--check", "--json"]).env("RAYON_NUM_THREADS", threads).output();
        let mut report: Value = serde_json::from_slice(&output.unwrap().stdout).unwrap();
        forget(&mut report, "seconds");
        report["chapters"].take()
    };
    assert_eq!(report("1"), report("4"));
}

/// Empties every field called `key`.
fn forget(value: &mut Value, key: &str) {
    match value {
        Value::Object(fields) => fields.iter_mut().for_each(|(name, field)| match name == key {
            true => *field = Value::Null,
            false => forget(field, key),
        }),
        Value::Array(items) => items.iter_mut().for_each(|item| forget(item, key)),
        _ => {}
    }
}

#[test]
fn set_changes_the_readout() {
    let angle = |arguments: &str| json(arguments)["chapters"][0]["steps"][0]["readout"].clone();
    assert_ne!(angle("fresnel brewster --json"), angle("fresnel brewster --set n_t=2.4 --json"));
    let setting = json("fresnel brewster --set theta=56.3deg --json")["chapters"][0]["steps"][0]["setting"].clone();
    let theta = setting.as_array().unwrap().iter().find(|parameter| parameter["name"] == "theta").unwrap();
    assert_eq!(theta["value"].as_f64(), Some(56.3_f64.to_radians()));
}

#[test]
fn an_explosion_is_shown_on_demand() {
    for (arguments, courant) in [("", 1.02), ("--set courant=1.3", 1.3)] {
        let report = json(&format!("maxwell grid growth --unstable {arguments} --json"));
        let mut quantities = vec![];
        having(&report, "key", &mut quantities);
        let value = |key: &str| quantities.iter().find(|quantity| quantity["key"] == key).expect(key)["value"].as_f64();
        let theory = 2.0 * f64::acosh(courant);
        assert!((value("growth").unwrap() / theory - 1.0).abs() < 1e-12, "{arguments}");
        assert!((value("growth_found").unwrap() / theory - 1.0).abs() < 1e-9, "{arguments}");
    }
}

#[test]
fn a_metal_goes_where_it_can_and_nowhere_else() {
    let run = lesson("fresnel --check --set n_t=gold --set wavelength=550nm");
    assert!(run.code <= 1, "{run:?}");
    assert!(run.err.lines().all(|line| line.starts_with("note: fresnel/") && line.contains("keeps its own n_t")));
}

#[test]
fn a_wavelength_that_a_default_has_no_data_for_is_left_where_it_clashes() {
    for (setting, own) in [("wavelength=190nm", "fresnel/films"), ("wavelength=5um", "fresnel/metals")] {
        let run = lesson(&format!("fresnel --check --set {setting}"));
        assert!(run.code <= 1, "{run:?}");
        assert!(run.err.contains(&format!("note: {own} keeps its own wavelength: ")), "{}", run.err);
    }
}

#[test]
fn nothing_of_the_kind_is_explained() {
    let run = lesson("fresnel digits --check");
    // What is judged is its question.
    assert!(run.code == 0 && run.out.ends_with("\n1 passed, 0 failed\n"), "{run:?}");
    assert_eq!(run.err, "note: fresnel/digits has no checks; it has --stress, --race, --plot\n");
}

#[test]
fn symbols_are_typeset_and_what_is_typed_is_not() {
    let text = lesson("fresnel r_s --stress").out;
    assert!(text.contains("Re rₛ") && text.contains("digits owed") && text.contains("fresnel/r_s/"), "{text}");
    assert!(!text.contains("rₛᵣe") && !text.contains("-0.0"), "{text}");
    let lecture = lesson("fresnel r_s").out;
    assert!(lecture.contains("under") && !lecture.contains("2⁻⁵²"), "{lecture}");
    assert!(lecture.contains("n_i=1, n_t=1.5"), "{lecture}");
}

#[test]
fn a_flag_may_be_repeated() {
    assert_eq!(lesson("fresnel snell --check --check").out, lesson("fresnel snell --check").out);
}

#[test]
fn a_race_reports_error_and_time() {
    let report = json("fresnel natural --race --json");
    let race = &report["chapters"][0]["steps"][0]["races"][0];
    assert!(race["lanes"].as_array().unwrap().len() >= 2);
    for point in race["lanes"].as_array().unwrap().iter().flat_map(|lane| lane["points"].as_array().unwrap()) {
        assert!(point["seconds"].as_f64().unwrap() > 0.0 && point["ns_per_work"].as_f64().unwrap() > 0.0, "{point}");
        assert!(!point["error"].is_null());
    }
    assert!(report["machine"]["cores"].as_u64() >= Some(1));
}

#[test]
fn figures_are_written_where_asked_and_their_paths_printed() {
    let out = folder("figures");
    for format in ["png", "svg"] {
        let run = lesson(&format!("fresnel brewster --plot --format {format} --out {}", out.display()));
        let paths: Vec<_> = run.out.lines().filter(|line| line.ends_with(&format!(".{format}"))).collect();
        assert!(!paths.is_empty(), "{run:?}");
        for path in paths {
            assert!(std::fs::metadata(path).unwrap().len() > 0, "{path}");
        }
    }
    assert!(
        std::fs::read_dir(&out).unwrap().all(|file| !file.unwrap().file_name().to_string_lossy().ends_with(".tmp"))
    );
}

#[test]
fn figures_come_before_races_and_their_paths_last() {
    let out = folder("early");
    let arguments = ["fresnel", "natural", "--plot", "--out", out.to_str().unwrap()];
    let mut child = command(&arguments).spawn().unwrap();
    let mut first = String::new();
    let mut talk = BufReader::new(child.stderr.take().unwrap());
    talk.read_line(&mut first).unwrap();
    let path = first.trim_end().strip_prefix("wrote ").unwrap_or_else(|| panic!("{first}"));
    assert!(std::fs::metadata(path).unwrap().len() > 0, "{path}");
    // Standard output has its turn when all is done: the races are still to come.
    assert!(child.try_wait().unwrap().is_none(), "the run ended before its first figure was told");
    let output = child.wait_with_output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let last = text.lines().rev().filter(|line| !line.is_empty()).nth(1).unwrap();
    assert!(last.ends_with(".png") && std::fs::exists(last).unwrap(), "{last}");
    let tail = text.split_once("ns per work").unwrap().1;
    assert!(tail.contains(path), "{tail}");
}

#[test]
fn what_a_killed_run_left_is_gone_after_the_next() {
    let out = folder("killed");
    let hidden = || {
        let names = std::fs::read_dir(&out).unwrap().map(|file| file.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name.starts_with('.')).collect::<Vec<_>>()
    };
    let arguments = ["fresnel", "natural", "--plot", "--out", out.to_str().unwrap()];
    let mut child = command(&arguments).spawn().unwrap();
    let mut first = String::new();
    BufReader::new(child.stderr.take().unwrap()).read_line(&mut first).unwrap();
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(hidden().len(), 1, "a killed run leaves its drafts");
    assert_eq!(lesson(&format!("fresnel brewster/zero_of_r_p --out {} --plot", out.display())).code, 0);
    assert_eq!(hidden(), [""; 0]);
}

#[test]
fn a_closed_pipe_ends_quietly() {
    for arguments in [&["fresnel"][..], &["coverage", "--json"], &["eval", "--list"], &["fresnel", "--json"]] {
        let mut child = command(arguments).spawn().unwrap();
        let mut first = String::new();
        BufReader::with_capacity(1, child.stdout.take().unwrap()).read_line(&mut first).unwrap();
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(!String::from_utf8_lossy(&output.stderr).contains("panic"), "{arguments:?}");
    }
}

#[test]
fn coverage_has_a_row_for_every_row_of_the_lecture() {
    let coverage = json("coverage --json");
    let rows = coverage["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 76);
    for row in rows {
        let list = |key: &str| row[key].as_array().unwrap().clone();
        let mut sorted = [list("met"), list("missing")].concat();
        let mut need = list("need");
        [&mut sorted, &mut need].into_iter().for_each(|letters| letters.sort_by_key(Value::to_string));
        assert_eq!(sorted, need, "{row}");
        assert!(list("steps").iter().all(|step| step.as_str().unwrap().contains('/')), "{row}");
    }
    assert!(rows.iter().any(|row| row["chapter"] == "fresnel" && !row["steps"].as_array().unwrap().is_empty()));
    assert!(lesson("coverage").out.contains("of 76 rows whole"));
}

#[test]
fn help_teaches_and_completions_know_the_steps() {
    let help = lesson("--help");
    assert_eq!(lesson("help").out, help.out);
    assert!(help.code == 0 && help.out.contains("lesson fresnel brewster") && help.out.contains("--set"));
    assert!(help.out.contains("ulp = 2⁻⁵²") && help.out.contains("the condition number"), "{}", help.out);
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = lesson(&format!("completions {shell}")).out;
        assert!(script.contains("brewster") && script.contains("unstable"), "{shell}");
    }
}

/// Every object of `report` that holds `key`.
fn having<'a>(report: &'a Value, key: &str, found: &mut Vec<&'a Value>) {
    match report {
        Value::Object(entries) => {
            if entries.contains_key(key) {
                found.push(report);
            }
            entries.values().for_each(|value| having(value, key, found));
        }
        Value::Array(values) => values.iter().for_each(|value| having(value, key, found)),
        _ => {}
    }
}

#[test]
fn every_hop_has_a_reason_and_every_unit_is_one_that_people_write() {
    let report = json("all --check --json");
    let (mut hops, mut units) = (Vec::new(), Vec::new());
    having(&report, "hop", &mut hops);
    having(&report, "dimension", &mut units);
    assert!(hops.len() > 100 && units.len() > 300, "{} hops, {} units", hops.len(), units.len());
    for line in hops {
        let by = line["by"].as_array().unwrap();
        assert!(!by.is_empty() && by.iter().all(|rule| rule != ""), "{line}");
    }
    for line in units {
        let unit = line["dimension"].as_str().unwrap();
        assert!(!unit.contains('⁻'), "{line}");
    }
}

#[test]
fn what_derivations_share_is_said_once() {
    let count =
        |text: &str, phrase: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").matches(phrase).count();
    let powers = lesson("fresnel powers").out;
    // All three rest on it; two of them have the fields of s.
    assert_eq!(count(&powers, "in all that follows Sᵢ = (Eᵢ×Hᵢ)/2"), 1, "{powers}");
    assert_eq!(count(&powers, "Sᵢ = (Eᵢ×Hᵢ)/2"), 1);
    assert_eq!(count(&powers, "Eₜ = (0, E₂, 0) ("), 1);
    assert_eq!(count(&powers, "under Eᵢ, Hᵢ, Eᵣ, Hᵣ, Eₜ, Hₜ as in reflected_from_poynting, E₂ = tₛ E₁"), 1);
    // One that is asked for by itself says all.
    let one = lesson("fresnel powers from_poynting").out;
    assert_eq!((count(&one, "Sᵢ = (Eᵢ×Hᵢ)/2"), count(&one, "Eₜ = (0, E₂, 0) (")), (1, 1), "{one}");
    assert!(!one.contains("as in"), "{one}");
}
