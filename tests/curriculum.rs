//! The curriculum as tests, one per address: `cargo test fresnel/energy` finds its way. Everything claimed must
//! hold, every hop of a derivation must be decided symbolically, and every planted mistake must be caught.

use chapters::setting::Setting;
use chapters::vocabulary::{Bench, Bound, Check, Derivation, Lane, Race, SEED, Stress, rms, verify};
use chapters::{CURRICULUM, Step};
use equation::derivation::{Chain, Verdict};
use libtest_mimic::{Arguments, Failed, Trial};

fn main() {
    let arguments = Arguments::from_args();
    let steps = CURRICULUM.iter().flat_map(|chapter| chapter.steps.iter().map(|step| (chapter.id, step)));
    let trials = steps.flat_map(|(chapter, step)| trials(format!("{chapter}/{}", step.id), step)).collect();
    libtest_mimic::run(&arguments, trials).exit();
}

fn trials(place: String, step: &'static Step) -> Vec<Trial> {
    let mut trials = Vec::new();
    let setting = || Setting::defaults(step.parameters);
    for derivation in step.derivations {
        let address = format!("{place}/{}", derivation.id);
        let again = address.clone();
        trials.push(Trial::test(format!("{address} holds"), move || follows(&(derivation.chain)(), &address)));
        trials.push(Trial::test(format!("{again} can fail"), move || is_refused(derivation, &again)));
    }
    for check in step.checks {
        let address = format!("{place}/{}", check.id);
        let again = address.clone();
        trials.push(Trial::test(format!("{address} holds"), move || holds(check, &setting(), &address)));
        trials.push(Trial::test(format!("{again} can fail"), move || can_fail(check, &setting(), &again)));
    }
    for stress in step.stress {
        trials.push(Trial::test(format!("{place}/{} holds", stress.id), move || survives(stress, &setting())));
        trials.push(Trial::test(format!("{place}/{} can fail", stress.id), move || bites(stress, &setting())));
    }
    for race in step.races {
        for lane in race.lanes {
            let address = format!("{place}/{}/{}", race.id, lane.id);
            trials.push(Trial::test(format!("{address} keeps its order"), move || {
                runs(race, lane, &setting(), &address)
            }));
        }
    }
    trials
}

/// So many lines of a derivation are displayed at most.
const LONGEST: usize = 12;

fn follows(chain: &Chain, address: &str) -> Result<(), Failed> {
    let chain = chain.complete();
    chain.units().map_err(|mismatch| mismatch.to_string())?;
    let hops = verify(&chain, address);
    match hops.iter().find(|hop| hop.verdict != Verdict::Proved) {
        Some(hop) => Err(format!("line {} by {:?}: {:?}", hop.line, hop.by, hop.verdict).into()),
        None if hops.is_empty() => Err("a chain of one line derives nothing".into()),
        None if chain.lines.len() > LONGEST => Err(format!("{} lines are too many to read", chain.lines.len()).into()),
        None if chain.lines.iter().any(|line| line.by == ["identity"]) => Err("no way to a goal was found".into()),
        None => Ok(()),
    }
}

fn is_refused(derivation: &Derivation, address: &str) -> Result<(), Failed> {
    let hops = verify(&(derivation.spoiled)(), address);
    let (refuted, others): (Vec<_>, Vec<_>) =
        hops.iter().partition(|hop| matches!(&hop.verdict, Verdict::Refuted { at, .. } if !at.is_empty()));
    // What is not the slip must stand, or it would be refused for another reason.
    match !refuted.is_empty() && others.iter().all(|hop| hop.verdict == Verdict::Proved) {
        true => Ok(()),
        false => Err(format!("the planted mistake passed ({}): {hops:?}", derivation.slip).into()),
    }
}

fn holds(check: &Check, setting: &Setting, address: &str) -> Result<(), Failed> {
    let measured = (check.measure)(&mut Bench::new(setting, SEED, address));
    match check.bound.admits(measured.value, chapters::statistical_checks()) {
        true => Ok(()),
        false => Err(format!("{}: {measured:?} against {:?}", check.claim, check.bound).into()),
    }
}

fn can_fail(check: &Check, setting: &Setting, address: &str) -> Result<(), Failed> {
    let measured = (check.spoiled)(&mut Bench::new(setting, SEED, address));
    if check.bound.admits(measured.value, chapters::statistical_checks()) {
        return Err(
            format!("the planted mistake passed ({}): {measured:?} against {:?}", check.slip, check.bound).into()
        );
    }
    // A mistake that computes nothing would break the bound for the wrong reason.
    match check.bound {
        Bound::AtMost { .. } | Bound::Order { .. } if measured.cases == 0 => {
            Err("the planted mistake measured nothing".into())
        }
        _ => Ok(()),
    }
}

fn survives(stress: &Stress, setting: &Setting) -> Result<(), Failed> {
    let cases = (stress.cases)(setting);
    let broken: Vec<String> = cases
        .iter()
        .filter(|case| !case.holds())
        .map(|case| {
            let (ours, allowed) = (case.digits(case.ours), case.allowed());
            format!(
                "{} at {}: {:e} keeps {ours:.1} digits, error allowed {allowed:.1e}",
                case.quantity, case.input, case.ours
            )
        })
        .collect();
    match broken.len() {
        0 => Ok(()),
        count => Err(format!("{count} of {} cases: {}", cases.len(), broken[..count.min(5)].join("\n")).into()),
    }
}

fn bites(stress: &Stress, setting: &Setting) -> Result<(), Failed> {
    match (stress.cases)(setting).iter().any(|case| case.textbook_breaks()) {
        true => Ok(()),
        false => Err("the textbook form survives every case: this stress shows nothing".into()),
    }
}

fn runs(race: &Race, lane: &Lane, setting: &Setting, address: &str) -> Result<(), Failed> {
    let point = |&work: &u64| {
        let errors: Vec<f64> = lane.heats(setting, address, work).map(|mut heat| (heat.error)(&(heat.run)())).collect();
        (work as f64, rms(&errors))
    };
    let points: Vec<(f64, f64)> = lane.works.iter().map(point).collect();
    match lane.expects.admits(&points) {
        true => Ok(()),
        false => Err(format!("{}: {points:?} against {:?}", race.claim, lane.expects).into()),
    }
}
