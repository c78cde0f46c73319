use crate::em::plane::{self, Polarisation, Sides};
use crate::em::{Cpml, Line, Medium, Plane, Pulse, Refusal, Stepping, Wall, line};

fn line_of(edit: impl Fn(&mut line::Setup)) -> Result<Line, Refusal> {
    let mut setup = line::Setup::vacuum(100, 1e-3, line::Ends::open(10), Stepping::at(0.5));
    edit(&mut setup);
    Line::new(setup)
}

fn plane_of(edit: impl Fn(&mut plane::Setup)) -> Result<Plane, Refusal> {
    let mut setup = plane::Setup::vacuum([50, 50], 1e-3, Polarisation::Tm, Stepping::at(0.5)).open(10);
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
    assert!(line_of(|setup| setup.layers = vec![(90..101, Medium::VACUUM)]).is_err());
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
fn the_limit_of_memory_is_told_in_bytes() {
    let refusal = plane_of(|setup| setup.cells = [1 << 20, 1 << 20]).unwrap_err();
    let bytes = ((1u64 << 20) + 1).pow(2) * 24;
    assert_eq!(refusal, Refusal::TooLarge { bytes, limit: 2 << 30 });
    assert!(refusal.to_string().contains(&bytes.to_string()) && refusal.to_string().contains("2147483648"));
    assert!(matches!(line_of(|setup| setup.cells = usize::MAX / 2), Err(Refusal::TooLarge { .. })));
    assert!(matches!(plane_of(|setup| setup.cells = [usize::MAX; 2]), Err(Refusal::TooLarge { .. })));
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
