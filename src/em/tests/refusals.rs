use crate::Polarisation;
use crate::em::plane::{self, Region, Sides};
use crate::em::{Cpml, Line, Medium, Plane, Pulse, Refusal, Stepping, Wall, line};

fn line_of(edit: impl Fn(&mut line::Setup)) -> Result<Line, Refusal> {
    let mut setup = line::Setup::vacuum(100, 1e-3, line::Ends::open(10), Stepping::at(0.5));
    edit(&mut setup);
    Line::new(setup)
}

fn plane_of(edit: impl Fn(&mut plane::Setup)) -> Result<Plane, Refusal> {
    let mut setup = plane::Setup::vacuum([50, 50], 1e-3, Polarisation::S, Stepping::at(0.5)).open(10);
    edit(&mut setup);
    Plane::new(setup)
}

#[test]
fn unphysical_media_are_refused_by_name() {
    let media = [
        (Medium::dielectric(0.0), "permittivity"),
        (Medium::dielectric(-1.0), "permittivity"),
        (Medium::dielectric(f64::NAN), "permittivity"),
        (Medium { mu_r: 0.0, ..Medium::VACUUM }, "permeability"),
        (Medium { mu_r: f64::NAN, ..Medium::VACUUM }, "permeability"),
        (Medium::conductor(1.0, -1.0), "conductivity"),
        (Medium::conductor(1.0, f64::NAN), "conductivity"),
        (Medium::metal(0.0, 1.0), "plasma"),
        (Medium::metal(1.0, -1.0), "collision"),
        (Medium::metal(1.0, f64::NAN), "collision"),
    ];
    for (medium, word) in media {
        let on_line = line_of(|setup| setup.layers = vec![(40..60, medium)]).unwrap_err().to_string();
        let in_plane = plane_of(|setup| setup.background = medium).unwrap_err().to_string();
        assert!(on_line.contains(word) && in_plane.contains(word), "{on_line} / {in_plane}");
    }
}

#[test]
fn numbers_out_of_range_are_refused() {
    for courant in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(line_of(|setup| setup.stepping.courant = courant).is_err(), "{courant}");
        assert!(plane_of(|setup| setup.stepping.courant = courant).is_err(), "{courant}");
    }
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(line_of(|setup| setup.spacing = spacing).is_err(), "{spacing}");
    }
    assert!(line_of(|setup| setup.cells = 0).is_err());
    assert!(line_of(|setup| setup.ends = line::Ends::open(50)).is_err());
    for layer in [90..101, 50..50] {
        assert!(line_of(|setup| setup.layers = vec![(layer.clone(), Medium::VACUUM)]).is_err());
    }
    assert!(plane_of(|setup| setup.cells = [50, 0]).is_err());
    assert!(plane_of(|setup| setup.sides = Sides::Bloch(f64::NAN)).is_err());
    assert!(plane_of(|setup| setup.ends[0] = Wall::Open(Cpml { kappa: 0.5, ..Cpml::thick(5) })).is_err());
    assert!(line_of(|_| ()).unwrap().run(0).is_err());
    assert!(plane_of(|_| ()).unwrap().run(0).is_err());
    let pulse = || Pulse::Gaussian { delay: 1.0, width: 1.0 };
    assert!(line_of(|_| ()).unwrap().illuminate(5, 1.0, pulse()).is_err());
    assert!(line_of(|_| ()).unwrap().inject(100, 1.0, pulse()).is_err());
    assert!(line_of(|_| ()).unwrap().inject(50, f64::NAN, pulse()).is_err());
    assert!(plane_of(|_| ()).unwrap().illuminate(20, 1.0, pulse()).is_err());
    assert!(plane_of(|_| ()).unwrap().inject([50, 20], 1.0, pulse()).is_err());
}

#[test]
fn an_incident_wave_enters_one_medium() {
    let packet = || super::packet(1e10, 1.0);
    let glass = Medium::dielectric(4.0);
    let on_line = |node| line_of(|setup| setup.layers = vec![(50..60, glass)]).unwrap().illuminate(node, 1.0, packet());
    let mixed = |refusal| matches!(refusal, Err(Refusal::Mixed { .. }));
    for (node, refused) in [(49, false), (50, true), (51, false), (60, true), (61, false)] {
        assert_eq!(mixed(on_line(node)), refused, "{node}");
        assert_eq!(on_line(node).is_ok(), !refused, "{node}");
    }
    assert!(on_line(50).unwrap_err().to_string().contains("cells of 49 and 50"));
    // A disc from x = 24 to 26 mm, away from column 0, in rows 24 and 25.
    let in_plane = |row, medium| {
        let mut plane = plane_of(|setup| {
            setup.sides = Sides::Bloch(0.1);
            setup.regions = vec![Region::disc([0.025; 2], 1e-3, medium)];
        });
        plane.as_mut().unwrap().illuminate(row, 1.0, packet())
    };
    for (row, refused) in [(23, false), (24, true), (25, true), (26, true), (27, false)] {
        assert_eq!(mixed(in_plane(row, glass)), refused, "{row}");
        assert!(in_plane(row, Medium::VACUUM).is_ok(), "{row}");
    }
}

#[test]
fn what_is_not_a_number_is_refused_wherever_it_stands() {
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        let layers: [fn(f64) -> Cpml; 4] = [
            |bad| Cpml { order: bad, ..Cpml::thick(5) },
            |bad| Cpml { reflection: bad, ..Cpml::thick(5) },
            |bad| Cpml { kappa: bad, ..Cpml::thick(5) },
            |bad| Cpml { alpha: bad, ..Cpml::thick(5) },
        ];
        for layer in layers {
            let walls = [Wall::Conductor, Wall::Open(layer(bad))];
            assert!(line_of(|setup| setup.ends = line::Ends::Walls(walls)).is_err());
            assert!(plane_of(|setup| setup.ends = walls).is_err());
            assert!(plane_of(|setup| setup.sides = Sides::Walls(walls)).is_err());
        }
        let media = [
            Medium::dielectric(bad),
            Medium { mu_r: bad, ..Medium::VACUUM },
            Medium::conductor(1.0, bad),
            Medium::metal(bad, 0.0),
            Medium::metal(1.0, bad),
        ];
        for medium in media {
            assert!(line_of(|setup| setup.layers = vec![(40..60, medium)]).is_err(), "{medium:?}");
            assert!(plane_of(|setup| setup.regions = vec![Region::disc([0.0; 2], 1.0, medium)]).is_err(), "{medium:?}");
        }
        assert!(
            plane_of(|setup| setup.spacing = bad).is_err() && plane_of(|setup| setup.stepping.courant = bad).is_err()
        );
        assert!(plane_of(|setup| setup.sides = Sides::Bloch(bad)).is_err());
        let pulses = [
            Pulse::Gaussian { delay: bad, width: 1.0 },
            Pulse::Gaussian { delay: 0.0, width: bad },
            Pulse::Modulated { frequency: bad, delay: 0.0, width: 1.0 },
            Pulse::Modulated { frequency: 1.0, delay: bad, width: 1.0 },
            Pulse::Modulated { frequency: 1.0, delay: 0.0, width: bad },
        ];
        let (line, periodic) = (line_of(|_| ()).unwrap(), plane_of(|setup| setup.sides = Sides::Bloch(0.1)).unwrap());
        let of_sources = |amplitude: f64, pulse: &Pulse| {
            let (mut line, mut plane) = (line.clone(), periodic.clone());
            assert!(line.inject(50, amplitude, pulse.clone()).is_err(), "{amplitude}, {pulse:?}");
            assert!(line.impose(50, amplitude, pulse.clone()).is_err(), "{amplitude}, {pulse:?}");
            assert!(line.illuminate(50, amplitude, pulse.clone()).is_err(), "{amplitude}, {pulse:?}");
            assert!(plane.inject([20, 20], amplitude, pulse.clone()).is_err(), "{amplitude}, {pulse:?}");
            assert!(plane.illuminate(20, amplitude, pulse.clone()).is_err(), "{amplitude}, {pulse:?}");
        };
        pulses.iter().for_each(|pulse| of_sources(1.0, pulse));
        of_sources(bad, &Pulse::Gaussian { delay: 0.0, width: 1.0 });
    }
    assert!(line_of(|_| ()).unwrap().probe(100).is_err());
    assert!(plane_of(|_| ()).unwrap().probe([50, 0]).is_err() && plane_of(|_| ()).unwrap().probe([0, 50]).is_err());
}

#[test]
fn the_limit_of_memory_is_told_in_bytes() {
    let refusal = plane_of(|setup| setup.cells = [1 << 20, 1 << 20]).unwrap_err();
    let Refusal::TooLarge { bytes, limit } = refusal else { panic!("{refusal}") };
    let fields = ((1u64 << 20) + 1).pow(2) * 24;
    assert!((fields..fields + fields / 100).contains(&bytes) && limit == 2 << 30);
    assert!(refusal.to_string().contains(&bytes.to_string()) && refusal.to_string().contains("2147483648"));
    for cells in [usize::MAX, usize::MAX / 2, 1 << 40] {
        assert!(matches!(line_of(|setup| setup.cells = cells), Err(Refusal::TooLarge { .. })), "{cells}");
        assert!(matches!(plane_of(|setup| setup.cells = [cells; 2]), Err(Refusal::TooLarge { .. })), "{cells}");
        assert!(matches!(plane_of(|setup| setup.cells = [1, cells]), Err(Refusal::TooLarge { .. })), "{cells}");
        let thick = [Wall::Open(Cpml::thick(cells)); 2];
        assert!(line_of(|setup| setup.ends = line::Ends::Walls(thick)).is_err(), "{cells}");
        assert!(plane_of(|setup| setup.ends = thick).is_err(), "{cells}");
    }
    assert!(matches!(plane_of(|setup| setup.cells = [1_000_000_000; 2]), Err(Refusal::TooLarge { .. })));
    assert!(line_of(|setup| setup.layers = vec![(usize::MAX - 1..usize::MAX, Medium::VACUUM)]).is_err());
}

#[test]
fn a_run_whose_records_would_exceed_the_limit_is_refused_before_it_starts() {
    let packet = || super::packet(1e10, 1.0);
    let mut line = line_of(|_| ()).unwrap();
    let mut plane = plane_of(|setup| setup.sides = Sides::Bloch(0.1)).unwrap();
    // Without records nothing grows; the number of steps is no limit.
    assert!(line.run(3).is_ok() && plane.run(3).is_ok());
    let of_records = |refusal| matches!(refusal, Err(Refusal::TooLarge { limit, .. }) if limit == 2 << 30);
    line.probe(50).unwrap();
    plane.probe([20, 20]).unwrap();
    // Twice 8 bytes a step, or twice 16, in 2 GiB.
    for steps in [1 << 27, u64::MAX] {
        assert!(of_records(line.run(steps)) && of_records(plane.run(steps)) && of_records(plane.run_serial(steps)));
    }
    let (mut line, mut plane) = (line_of(|_| ()).unwrap(), plane_of(|setup| setup.sides = Sides::Bloch(0.1)).unwrap());
    line.illuminate(50, 1.0, packet()).unwrap();
    plane.illuminate(20, 1.0, packet()).unwrap();
    assert!(of_records(line.run(1 << 27)) && of_records(plane.run(1 << 27)));
    assert!((line.steps(), plane.steps()) == (0, 0) && line.run(10).is_ok() && plane.run(10).is_ok());
}

#[test]
fn messages_are_short_whatever_the_number() {
    for spacing in [1e-300, 1e300, f64::INFINITY, f64::NAN, -1e-300] {
        let message = line_of(|setup| setup.spacing = spacing).unwrap_err().to_string();
        assert!(message.len() < 80, "{message}");
    }
    let message = line_of(|setup| setup.spacing = 1e-300).unwrap_err().to_string();
    assert!(message.starts_with("spacing is 1e-300; "), "{message}");
    let message = line_of(|setup| setup.stepping.courant = 1.5).unwrap_err().to_string();
    assert!(message.starts_with("a Courant number of 1.5 is unstable here: at most 1,"), "{message}");
}

#[test]
fn memory_is_counted_with_all_that_is_kept_and_to_the_byte_at_the_limit() {
    for medium in [Medium::dielectric(2.0), Medium::conductor(2.0, 1.0), Medium::metal(1e11, 1e10)] {
        for pruned in [true, false] {
            let line = line_of(|setup| {
                (setup.layers, setup.stepping.pruned) = (vec![(20..40, medium), (45..50, Medium::VACUUM)], pruned);
            });
            let line = line.unwrap();
            assert!(line.explain().bytes <= line.setup().peak_bytes());
            for (polarisation, sides) in [
                (Polarisation::S, Sides::Bloch(0.0)),
                (Polarisation::S, Sides::Bloch(0.1)),
                (Polarisation::P, Sides::Bloch(0.1)),
            ] {
                let edit = |setup: &mut plane::Setup| {
                    (setup.polarisation, setup.sides, setup.stepping.pruned) = (polarisation, sides, pruned);
                    setup.regions = vec![Region::disc([0.025; 2], 0.015, medium)];
                };
                let plane = plane_of(edit).unwrap();
                let peak = plane.setup().peak_bytes();
                assert!(plane.explain().bytes <= peak);
                let limited = |limit: u64| plane_of(|setup| (edit(setup), setup.stepping.memory_limit = limit).1);
                assert!(limited(peak).is_ok() && limited(peak - 1).is_err());
            }
        }
    }
}

#[test]
fn the_courant_limit_is_that_of_the_fastest_medium() {
    for (courant, ok) in [(1.0, true), (1.0 + 1e-12, false)] {
        assert_eq!(line_of(|setup| setup.stepping.courant = courant).is_ok(), ok);
    }
    let limit = std::f64::consts::FRAC_1_SQRT_2;
    for (courant, ok) in [(limit, true), (limit * (1.0 + 1e-12), false)] {
        assert_eq!(plane_of(|setup| setup.stepping.courant = courant).is_ok(), ok);
    }
    let slow = |setup: &mut line::Setup| {
        (setup.background, setup.stepping.courant) = (Medium::dielectric(4.0), 2.0);
    };
    assert!(line_of(slow).is_ok());
    assert!(line_of(|setup| (setup.stepping.courant, setup.stepping.unstable) = (1.5, true)).is_ok());
}
