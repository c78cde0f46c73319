//! The curriculum as tests, one per address: `cargo test fresnel/energy` finds its way. The judge of the program decides:
//! everything claimed must hold, and every planted mistake must be caught.

use chapters::judge;
use chapters::parameter::Setting;
use chapters::vocabulary::{Derivation, Item, Race};
use libtest_mimic::{Arguments, Failed, Trial};

fn main() {
    let arguments = Arguments::from_args();
    let trials = chapters::steps().flat_map(|(chapter, step)| {
        step.items()
            .flat_map(move |item| trials(item, step.parameters(), format!("{}/{}/{}", chapter.id, step.id, item.id())))
    });
    libtest_mimic::run(&arguments, trials.collect()).exit();
}

fn trials(item: Item, parameters: &'static [chapters::parameter::Parameter], address: String) -> Vec<Trial> {
    let setting = move || Setting::defaults(parameters);
    let (there, place) = (address.clone(), address.clone());
    let can_fail = Trial::test(format!("{address} can fail"), move || {
        judge::can_fail(item, &setting(), &there).unwrap_or(Ok(())).map_err(Failed::from)
    });
    let holds = move || {
        Trial::test(format!("{address} holds"), move || judge::holds(item, &setting(), &address).map_err(Failed::from))
    };
    match item {
        // Looked at in tests/shape.rs.
        Item::Statement(_) | Item::Figure(_) => Vec::new(),
        Item::Race(race) => lanes(race, parameters, &place),
        Item::Derivation(derivation) => vec![holds(), can_fail, is_readable(derivation, place)],
        Item::Question(_) | Item::Check(_) | Item::Stress(_) => vec![holds(), can_fail],
    }
}

fn lanes(race: &'static Race, parameters: &'static [chapters::parameter::Parameter], place: &str) -> Vec<Trial> {
    let trial = |lane: &'static chapters::vocabulary::Lane| {
        let address = format!("{place}/{}", lane.id);
        Trial::test(format!("{address} keeps its order"), move || {
            judge::keeps(race, lane, &Setting::defaults(parameters), &address).map_err(Failed::from)
        })
    };
    race.lanes.iter().map(trial).collect()
}

/// So many lines of a derivation are displayed at most.
const LONGEST: usize = 12;

fn is_readable(derivation: &'static Derivation, address: String) -> Trial {
    Trial::test(format!("{address} is readable"), move || {
        let chain = (derivation.chain)().complete();
        match chain.lines.len() {
            lines if lines > LONGEST => Err(format!("{lines} lines are too many to read").into()),
            _ if chain.lines.iter().any(|line| line.by == ["identity"]) => Err("no way to a goal was found".into()),
            _ => Ok(()),
        }
    })
}
