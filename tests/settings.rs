//! Whatever its parameters admit, a step holds: settings drawn over whole domains, one test a step.
//!
//! `LESSON_SETTINGS` says how many settings a step is tried at.

use chapters::parameter::Setting;
use chapters::vocabulary::{Item, SEED};
use chapters::{Step, judge, steps};
use libtest_mimic::{Arguments, Failed, Trial};
use std::collections::HashSet;
use yardstick::random::stream;

/// So many settings a step is tried at unless more are asked for.
const SETTINGS: usize = 8;

fn main() {
    let settings = std::env::var("LESSON_SETTINGS").ok().map_or(SETTINGS, |count| count.parse().expect("a count"));
    let trial = |address: String, step: &'static Step| {
        Trial::test(format!("{address} holds at any setting"), move || holds(step, &address, settings))
    };
    let open = steps().filter(|(_, step)| !step.parameters().is_empty());
    let trials = open.map(|(chapter, step)| trial(format!("{}/{}", chapter.id, step.id), step)).collect();
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

/// Readout, questions, checks and extreme cases, at each setting.
fn holds(step: &'static Step, address: &str, settings: usize) -> Result<(), Failed> {
    let dice = &mut stream(SEED, &format!("{address}/settings"));
    let mut fallen = Vec::new();
    // Checks that were tried and do not look at what is set: again they would be the same, number by number.
    let mut same = HashSet::new();
    for _ in 0..settings {
        let setting = Setting::draw(step.parameters(), dice);
        step.readout.map(|readout| readout(&setting));
        let is_moved = |item: &Item| matches!(item, Item::Check(_) | Item::Stress(_) | Item::Question(_));
        for item in step.items().filter(is_moved) {
            let place = format!("{address}/{}", item.id());
            let fault = match item {
                Item::Check(_) if same.contains(item.id()) => None,
                Item::Check(check) => {
                    let found = judge::check(check, &setting, &place);
                    if !found.reads_setting {
                        same.insert(item.id());
                    }
                    found.fault(check)
                }
                item => judge::holds(item, &setting, &place).err(),
            };
            if let Some(why) = fault {
                fallen.push(format!("{}: {why}\n    at {}", item.id(), words(&setting)));
            }
        }
    }
    if fallen.is_empty() { Ok(()) } else { Err(format!("{} fell:\n  {}", fallen.len(), fallen.join("\n  ")).into()) }
}

/// As one would set it.
fn words(setting: &Setting) -> String {
    setting
        .entries()
        .map(|(parameter, text, _)| format!("--set {}={text}", parameter.name))
        .collect::<Vec<_>>()
        .join(" ")
}
