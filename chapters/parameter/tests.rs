//! What holds of every kind, on arbitrary input.

use super::*;
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;
use yardstick::random::stream;

const FIELDS: &[Parameter] = &[
    Parameter::new("n", "", "", Kind::Medium).aliases(&[Alias::same("medium")]),
    Parameter::new("d", "", "", Kind::number(0.0, 1e6, "m")).aliases(&[Alias::counted_in("d_nm", "nm")]),
    Parameter::new("pairs", "", "", Kind::Count { min: 0, max: 9 }).default("3"),
];
const ANGLE: Range = Range::new(0.0, FRAC_PI_2, "rad");
const WHOLE: Kind = Kind::Count { min: 1, max: 1 << 53 };

/// One of every kind.
const ALL: &[Parameter] = &[
    Parameter::new("angle", "", "", Kind::Number(ANGLE)),
    Parameter::new("any", "", "", Kind::Number(Range::any("1"))),
    Parameter::new("sheet", "", "", Kind::Number(Range::positive(1e12, "Ω"))),
    WAVELENGTH,
    Parameter::new("count", "", "", WHOLE),
    Parameter::new("pol", "", "", Kind::Choice(&["s", "p"])),
    Parameter::new("n_t", "", "", Kind::Medium),
    Parameter::new("n_i", "", "", Kind::ClearMedium),
    MEDIUM,
    Parameter::new("wo", "", "", Kind::Vector(Range::new(-1.0, 1.0, "1"))),
    Parameter::new("layers", "", "", Kind::List { of: &Kind::Record(FIELDS), most: 5 }),
    Parameter::new("substrate", "", "", Kind::Record(FIELDS)),
];

/// Something that a kind takes.
fn taken_by(kind: Kind) -> impl Strategy<Value = Argument> {
    any::<u64>().prop_map(move |seed| kind.draw(&mut stream(seed, kind.name())))
}

/// A parameter and something that it takes.
fn taken() -> impl Strategy<Value = (Parameter, Argument)> {
    prop::sample::select(ALL).prop_flat_map(|parameter| (Just(parameter), taken_by(parameter.kind)))
}

/// Anything at all.
fn anything() -> impl Strategy<Value = Argument> {
    let word = prop_oneof![
        any::<String>(),
        "[-+0-9.eEinfa/]{0,12}",
        "[0-9]{1,3}(deg|nm|GHz|Ω| )?",
        prop::sample::select(vec!["gold", "s", "copper", "n", "d", "nan", "1e400", "-0", "[", "{", "\""])
            .prop_map(String::from),
    ];
    let leaf = prop_oneof![
        any::<f64>().prop_map(Argument::Number),
        word.clone().prop_map(Argument::Text),
        Just(Argument::Other),
    ];
    leaf.prop_recursive(4, 32, 6, move |inner| {
        let name = prop_oneof![word.clone(), prop::sample::select(vec!["n", "k", "d", "d_nm"]).prop_map(String::from)];
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..6).prop_map(Argument::List),
            prop::collection::vec((name, inner), 0..4).prop_map(Argument::Record),
        ]
    })
}

fn read(parameter: &Parameter, argument: &Argument) -> Result<Value, Fault> {
    parameter.read(Form::Same, argument)
}

proptest! {
    #[test]
    fn what_is_taken_comes_back_from_text_and_from_json((parameter, argument) in taken()) {
        let value = read(&parameter, &argument).unwrap_or_else(|fault| panic!("{}: {argument:?}: {fault}", parameter.name));
        let text = parameter.write(&value);
        prop_assert_eq!(&parameter.parse(&text).unwrap(), &value, "{}", text);
        prop_assert_eq!(parameter.write(&parameter.parse(&text).unwrap()), text);
        let json = serde_json::to_string(&value.argument()).unwrap();
        prop_assert_eq!(&read(&parameter, &Argument::from_json(&json).unwrap()).unwrap(), &value, "{}", json);
        // As it was given, too.
        prop_assert_eq!(&parameter.parse(&argument.to_string()).unwrap(), &value);
        let json = serde_json::to_string(&argument).unwrap();
        prop_assert_eq!(&read(&parameter, &Argument::from_json(&json).unwrap()).unwrap(), &value, "{}", json);
    }

    #[test]
    fn numbers_outside_are_refused_with_place_and_range(value in any::<f64>()) {
        for parameter in ALL {
            let Kind::Number(range) = parameter.kind else { continue };
            match parameter.parse(&format!("{value:?}")) {
                Ok(read) => prop_assert!(range.holds(value) && read == Value::Number(value)),
                Err(fault) => {
                    prop_assert!(!range.holds(value));
                    prop_assert_eq!(&fault.place, parameter.name);
                    prop_assert!(fault.message.contains("valid: "), "{}", fault);
                }
            }
        }
    }

    #[test]
    fn whatever_is_refused_says_where_and_what_would_be_valid(argument in anything()) {
        for parameter in ALL {
            let Err(fault) = read(parameter, &argument) else { continue };
            let fault = fault.within(parameter.name);
            prop_assert!(fault.place.starts_with(parameter.name), "{}", fault);
            let helps = fault.unknown.is_some() || fault.message.contains("valid: ") || fault.message == "given twice"
                || fault.message.contains("give one of them");
            prop_assert!(helps, "{}", fault);
            prop_assert!(fault.to_string().len() < 600, "{}", fault);
        }
    }

    #[test]
    fn text_and_json_of_anything_agree(argument in anything()) {
        for parameter in ALL {
            let json = serde_json::to_string(&argument).unwrap();
            let Ok(again) = Argument::from_json(&json) else { continue };
            // JSON has no number that is not finite.
            if json.contains("nan") || json.contains("inf") { continue }
            prop_assert_eq!(read(parameter, &again), read(parameter, &argument));
            if matches!(argument, Argument::List(_) | Argument::Record(_)) {
                prop_assert_eq!(parameter.parse(&json).ok(), read(parameter, &argument).ok());
            }
        }
    }

    #[test]
    fn a_frequency_is_a_wavelength(hertz in 3e11..=2.9e17_f64) {
        let Value::Number(metres) = WAVELENGTH.parse_as("freq", &format!("{hertz:?}")).unwrap() else { panic!() };
        prop_assert!((metres * hertz / 299_792_458.0 - 1.0).abs() < 4.0 * f64::EPSILON);
    }
}

#[test]
fn absurd_input_is_refused_in_a_line() {
    let long = "9".repeat(1 << 20);
    let deep = "[".repeat(10_000);
    let open = "{\"n\":".repeat(10_000);
    let closed = format!("{}{}", deep, "]".repeat(10_000));
    let mut nested = Argument::Other;
    for _ in 0..10_000 {
        nested = Argument::List(vec![nested]);
    }
    let wide = Argument::List(vec![Argument::Other; 1_000_000]);
    let crowded = Argument::Record((0..200_000).map(|at| (format!("field{at}"), Argument::Other)).collect());
    for parameter in ALL {
        let texts = [&long, &deep, &open, &closed].map(String::as_str);
        for text in texts
            .into_iter()
            .chain(["", " ", "nan", "-nan", "inf", "1e400", "\u{0}", "[", "{", "\"", "[]", "{}", "\"\""])
        {
            let fault = parameter.parse(text);
            let is_empty_list = text == "[]" && parameter.name == "layers";
            assert!(is_empty_list || fault.is_err() || parameter.name == "any", "{}: {text:.20}", parameter.name);
            assert!(fault.is_ok() || fault.unwrap_err().to_string().len() < 600, "{}: {text:.20}", parameter.name);
        }
        for argument in [&nested, &wide, &crowded, &f64::NAN.into(), &f64::INFINITY.into(), &f64::NEG_INFINITY.into()] {
            assert!(read(parameter, argument).is_err(), "{}", parameter.name);
        }
    }
}

#[test]
fn counts_are_whole() {
    const PAIRS: Parameter = Parameter::new("pairs", "", "", Kind::Count { min: 1, max: 9 }).default("3");
    assert_eq!(Setting::defaults(&[PAIRS]).number("pairs"), 3.0);
    for nine in ["9", "9.0", "9e0", " 9 "] {
        assert_eq!(PAIRS.parse(nine), Ok(Value::Number(9.0)));
    }
    for bad in ["0", "10", "2.5", "-1", "1e400", "three", ""] {
        assert!(PAIRS.parse(bad).unwrap_err().message.ends_with("valid: 1 to 9"), "{bad}");
    }
}

#[test]
fn one_quantity_is_given_once_by_any_of_its_names() {
    const OPTICS: &[Parameter] = &[WAVELENGTH, THETA];
    let with = |changes: &[(&str, &str)]| {
        let changes: Vec<_> = changes.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        Setting::defaults(OPTICS).with(&changes)
    };
    let setting = with(&[("freq", "500THz")]).unwrap();
    assert_eq!(setting.wavelength(), 299_792_458.0 / 500e12);
    assert_eq!(setting.frequency(), 299_792_458.0 / setting.wavelength());
    assert_eq!(setting.text("wavelength"), "5.99584916e-7m");
    let twice = with(&[("wavelength", "500nm"), ("freq", "500THz")]).unwrap_err();
    assert_eq!((twice.place.as_str(), twice.message.contains("beside wavelength")), ("freq", true));
    assert!(with(&[("freq", "10GHz")]).unwrap_err().message.contains("valid: 299.792458GHz to"));
    assert_eq!(with(&[("fre", "1")]).unwrap_err().unknown.unwrap().names, ["wavelength", "freq", "theta"]);
}

#[test]
fn alternatives_stand_for_one_another() {
    const COS: Parameter = Parameter::new("cos", "", "", Kind::number(0.0, 1.0, "1")).instead_of(&["theta"]);
    const LENS: Parameter = Parameter::new("lens", "", "", Kind::number(0.0, 1.0, "m")).instead_of(&[]);
    const FUNCTION: Function = Function {
        name: "f",
        says: "",
        inputs: &[THETA.required().aliases(&[Alias::same("theta1")]), COS, LENS],
        outputs: &[],
        compute: |_| Ok(vec![]),
    };
    let call = |given: &[&str]| {
        let given: Vec<_> = given.iter().map(|name| ((*name).to_owned(), Argument::Number(0.5))).collect();
        FUNCTION.call(&given).map_err(|fault| fault.to_string())
    };
    assert!(call(&["theta"]).is_ok() && call(&["theta1"]).is_ok() && call(&["cos", "lens"]).is_ok());
    assert_eq!(
        call(&["lens"]).unwrap_err(),
        "theta: missing (or theta1); give theta or cos; valid: 0 to 1.570796327 rad"
    );
    assert_eq!(call(&["cos", "theta1"]).unwrap_err(), "cos: given beside theta1; give one of them");
    assert_eq!(call(&["x"]).unwrap_err(), "x: no such input of f. Known: theta, theta1, cos, lens");
}

#[test]
fn what_belongs_to_a_word_stands_and_falls_with_it() {
    const NUMBER: Kind = Kind::number(0.0, 1.0, "1");
    const FUNCTION: Function = Function {
        name: "f",
        says: "",
        inputs: &[
            Parameter::new("kind", "", "", Kind::Choice(&["disc", "box", "point"])),
            Parameter::new("a", "", "", NUMBER).default("0.25").only_with("kind", &["disc"]),
            Parameter::new("a", "", "", NUMBER).only_with("kind", &["box"]),
            Parameter::new("b", "", "", NUMBER).only_with("kind", &["box", "disc"]),
        ],
        outputs: &[],
        compute: |setting| {
            let [a, b] =
                ["a", "b"].map(|name| (name, if setting.word("kind") == "point" { 0.0 } else { setting.number(name) }));
            Ok(vec![a, b])
        },
    };
    let call = |given: &[(&str, Argument)]| {
        let given: Vec<_> = given.iter().map(|(name, argument)| ((*name).to_owned(), argument.clone())).collect();
        FUNCTION.call(&given).map_err(|fault| fault.to_string())
    };
    let half = || Argument::Number(0.5);
    // In any order.
    assert_eq!(call(&[("b", half()), ("kind", "disc".into())]).unwrap(), [("a", 0.25), ("b", 0.5)]);
    assert_eq!(call(&[("kind", "box".into()), ("a", half()), ("b", 1.0.into())]).unwrap(), [("a", 0.5), ("b", 1.0)]);
    assert!(call(&[("kind", "point".into())]).is_ok());
    let fault = |given: &[(&str, Argument)]| call(given).unwrap_err();
    assert_eq!(fault(&[("kind", "box".into()), ("b", half())]), "a: missing; valid: 0 to 1");
    assert_eq!(
        fault(&[("kind", "point".into()), ("b", half())]),
        "b: goes with kind=box or disc; kind=point takes nothing"
    );
    assert_eq!(fault(&[("b", half())]), "kind: missing; valid: disc, box, point");
    assert_eq!(fault(&[("kind", "disc".into()), ("c", half())]), "c: no such input of f. Known: kind, a, b");
    assert_eq!(fault(&[("kind", "disc".into()), ("b", half()), ("b", half())]), "b: given twice");
}

#[test]
fn ends_are_taken() {
    for parameter in ALL {
        for end in parameter.kind.ends() {
            let value = read(parameter, &end);
            assert!(value.is_ok() || matches!(parameter.kind, Kind::List { .. }), "{}: {end}", parameter.name);
        }
    }
}

#[test]
fn every_parameter_of_the_lecture_is_sound() {
    let steps = crate::CURRICULUM.iter().flat_map(|chapter| chapter.steps).map(|step| (step.id, step.parameters()));
    let functions = crate::CURRICULUM.iter().flat_map(|chapter| chapter.functions);
    for (place, parameters) in steps.chain(functions.map(|function| (function.name, function.inputs))) {
        // One name may stand for two that are never there together.
        let together = |one: &Parameter, other: &Parameter| match (one.only_with, other.only_with) {
            (Some((choice, words)), Some((also, others))) => {
                choice != also || words.iter().any(|word| others.contains(word))
            }
            _ => true,
        };
        for (at, one) in parameters.iter().enumerate() {
            for other in &parameters[at + 1..] {
                let shared = one.names().find(|name| other.form(name).is_some() && together(one, other));
                assert_eq!(shared, None, "{place}: a name stands for two");
            }
            let mut own: Vec<_> = one.names().collect();
            own.sort_unstable();
            own.dedup();
            assert_eq!(own.len(), one.names().count(), "{place}/{}: named twice", one.name);
            if let Some((choice, words)) = one.only_with {
                let known =
                    parameters.iter().find(|parameter| parameter.name == choice).map(|parameter| parameter.kind);
                let Some(Kind::Choice(known)) = known else { panic!("{place}/{}: no choice {choice}", one.name) };
                assert!(words.iter().all(|word| known.contains(word)), "{place}/{}", one.name);
            }
        }
        let names: Vec<_> = parameters.iter().flat_map(Parameter::names).collect();
        for parameter in parameters {
            let others = parameter.instead_of.unwrap_or(&[]);
            assert!(others.iter().all(|other| names.contains(other)), "{place}/{}", parameter.name);
            if let Some(default) = parameter.default {
                parameter.parse(default).unwrap_or_else(|fault| panic!("{place}: {fault}"));
            }
            let quantity = |own: &str| parameter.names().any(|name| name == own);
            assert_eq!(quantity("wavelength"), quantity("freq"), "{place}/{}: one gives the other", parameter.name);
            let described = serde_json::to_value(parameter.describe()).unwrap();
            assert_eq!(described["takes"]["kind"], parameter.kind.name());
        }
    }
}
