//! What is on the diagrams, by content.

use super::super::canvas::Frame;
use super::{Arrangement, arrange, shapes};
use crate::plot::{ALONE, AMONG, gallery, png, svg};
use chapters::Chapter;
use chapters::diagram::{Behind, Diagram, Form, Part, Spot};
use chapters::figure::{Panel, Plot};
use chapters::parameter::Setting;

/// A figure at changed parameters.
fn figure(chapter: &Chapter, step: &str, id: &str, changes: &[(&str, &str)]) -> Plot {
    let step = chapter.steps.iter().find(|found| found.id == step).unwrap();
    let figure = step.exhibit.figures.iter().find(|figure| figure.id == id).unwrap();
    let changes: Vec<_> = changes.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
    (figure.plot)(&Setting::defaults(step.parameters()).with(&changes).unwrap())
}

/// The figure `fresnel/snell/geometry` between two media at an angle [°].
fn snell(n_i: &str, n_t: &str, degrees: f64) -> Plot {
    let changes = [("n_i", n_i), ("n_t", n_t), ("theta", &format!("{degrees}deg"))];
    figure(&chapters::fresnel::CHAPTER, "snell", "geometry", &changes)
}

fn diagram(plot: &Plot) -> &Diagram {
    match &plot.panels[0] {
        Panel::Diagram(diagram) => diagram,
        other => panic!("{other:?}"),
    }
}

fn arranged(diagram: &Diagram, usual: (f64, f64)) -> Arrangement<'_> {
    arrange(diagram, &Frame::at((10.0, 10.0), usual.0, super::height(diagram, usual)))
}

/// Why the labels of a diagram are not as they should be, if so.
fn fault(diagram: &Diagram, usual: (f64, f64)) -> Option<String> {
    let arrangement = arranged(diagram, usual);
    let labels = &arrangement.labels;
    for (k, one) in labels.iter().enumerate() {
        if let Some(other) = labels[..k].iter().find(|other| one.place.meets(&other.place)) {
            return Some(format!("{} and {} overlap", one.label, other.label));
        }
        let (place, frame) = (&one.place, &arrangement.frame);
        let is_inside = frame.left <= place.left && place.right <= frame.right;
        if !is_inside || place.top < frame.top || frame.bottom < place.bottom {
            return Some(format!("{} leaves the window", one.label));
        }
        let sight = super::Sight::new(diagram, *frame);
        let rays = diagram.parts.iter().filter(|part| matches!(part.form, Form::Ray { .. } | Form::Vector { .. }));
        for part in rays {
            let edges = shapes::of(&sight, part).iter().flat_map(shapes::Shape::edges).collect::<Vec<_>>();
            // By points every fifth of a pixel, not by the clipping that the placement relies on.
            let on = edges.iter().any(|(from, to, half)| {
                let steps = (5.0 * (to.0 - from.0).hypot(to.1 - from.1)).ceil() as usize;
                (0..=steps).any(|k| {
                    let share = k as f64 / steps.max(1) as f64;
                    let at = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
                    place.grown(*half).meets(&Frame::at(at, 1e-9, 1e-9))
                })
            });
            if on {
                return Some(format!("{} is on the ray {}", one.label, part.label));
            }
        }
    }
    None
}

#[test]
fn labels_keep_clear_at_every_angle() {
    let media = [("1", "1.5"), ("1.5", "1"), ("1", "1"), ("1", "gold"), ("1", "4"), ("2.4", "1.33"), ("1", "0.05+9i")];
    let angles = (0..=180).map(|half| f64::from(half) / 2.0).chain([0.1, 41.8, 41.82, 89.9]);
    let mut faults = Vec::new();
    for degrees in angles {
        for (n_i, n_t) in media {
            let plot = snell(n_i, n_t, degrees);
            for usual in [ALONE, AMONG] {
                let found = fault(diagram(&plot), usual);
                faults.extend(found.map(|fault| format!("{n_i} → {n_t} at {degrees}°, {} wide: {fault}", usual.0)));
            }
        }
    }
    assert!(faults.is_empty(), "{} faults, such as {:#?}", faults.len(), &faults[..faults.len().min(12)]);
}

#[test]
fn labels_of_the_gallery_keep_clear() {
    for usual in [ALONE, AMONG] {
        assert_eq!(fault(diagram(&gallery::facet()), usual), None);
    }
}

#[test]
fn labels_of_radiometry_keep_clear_over_whole_domains() {
    let indices =
        (100..=400).step_by(4).map(|hundredths| ("ray", "image", "n", format!("{}", f64::from(hundredths) / 100.0)));
    let angles = (0..=80).map(|degrees| ("irradiance", "cosines", "theta", format!("{degrees}deg")));
    let mut faults = Vec::new();
    for (step, id, name, value) in indices.chain(angles) {
        let plot = figure(&chapters::radiometry::CHAPTER, step, id, &[(name, &value)]);
        faults.extend(fault(diagram(&plot), ALONE).map(|fault| format!("{id} at {name} = {value}: {fault}")));
    }
    assert!(faults.is_empty(), "{} faults, such as {:#?}", faults.len(), &faults[..faults.len().min(12)]);
}

#[test]
fn a_label_on_a_ray_would_be_seen() {
    let crowded = (0..400).map(|k| f64::from(k) / 200.0 - 1.0).map(|x| Part::ray([x, -1.0], [x, 1.0]).label("k"));
    assert!(fault(&Diagram::new("", [-1.0; 2], [1.0; 2]).with_all(crowded), ALONE).is_some());
}

/// Every stroke of an SVG with its class and width: its ends.
fn strokes(written: &str, class: &str, width: &str) -> Vec<[Spot; 2]> {
    let document = roxmltree::Document::parse(written).unwrap();
    let is_meant = |node: &roxmltree::Node| {
        node.attribute("class") == Some(class) && node.attribute("stroke-width") == Some(width)
    };
    let ends = document.descendants().filter(is_meant).map(|node| {
        let corners: Vec<Spot> = node.attribute("d").unwrap()[1..]
            .split('L')
            .map(|corner| {
                let (x, y) = corner.split_once(' ').unwrap();
                [x.parse().unwrap(), y.parse().unwrap()]
            })
            .collect();
        [corners[0], corners[corners.len() - 1]]
    });
    ends.collect()
}

/// Measured off the written picture with a protractor and a ruler.
#[test]
fn rays_and_wavefronts_obey_snell() {
    for degrees in [10.0f64, 40.0, 75.0] {
        let (n, written) = (1.5, svg(&snell("1", "1.5", degrees)));
        let angle = |[[x, y], [x_to, y_to]]: [Spot; 2]| (x_to - x).abs().atan2((y_to - y).abs()).to_degrees();
        let above = strokes(&written, "s-ink", "2.41");
        assert_eq!(above.len(), 2, "incident and reflected ray");
        assert!(above.iter().all(|ray| (angle(*ray) - degrees).abs() < 0.05), "{above:?}");
        let refracted = strokes(&written, "s-transmitted", "2.41");
        let expected = (degrees.to_radians().sin() / n).asin().to_degrees();
        assert!((angle(refracted[0]) - expected).abs() < 0.05, "{} for {expected}", angle(refracted[0]));
        let spacing = |class: &str| {
            let fronts = strokes(&written, class, "1.3");
            let across = |front: &[Spot; 2]| (front[0][0] - front[1][0]).hypot(front[0][1] - front[1][1]) > 20.0;
            let middle = |front: &[Spot; 2]| [0, 1].map(|k| (front[0][k] + front[1][k]) / 2.0);
            let middles: Vec<Spot> = fronts.iter().filter(|front| across(front)).map(middle).collect();
            (middles[1][0] - middles[0][0]).hypot(middles[1][1] - middles[0][1])
        };
        let ratio = spacing("s-transmitted") * n / spacing("s-ink");
        assert!((ratio - 1.0).abs() < 0.01, "the wavelengths are as {ratio}");
    }
}

#[test]
fn no_angle_has_no_arc_and_no_name() {
    let labels = |degrees: f64| {
        let plot = snell("1", "1.5", degrees);
        let arranged = arranged(diagram(&plot), ALONE);
        arranged.labels.iter().map(|label| label.label.to_owned()).collect::<Vec<_>>()
    };
    assert!(!labels(0.0).iter().any(|label| label == "θ_1" || label == "θ_2"));
    // One too narrow for its name to stand on its own side has none either.
    assert!(!labels(3.0).iter().any(|label| label == "θ_1") && labels(8.0).iter().any(|label| label == "θ_1"));
    assert!(labels(0.0).iter().any(|label| label == "θ_2 = 0.0°"));
}

#[test]
fn degenerate_diagrams_can_be_drawn() {
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1e300, 1e-300, -1.0];
    let spots: Vec<Spot> = odd.iter().flat_map(|x| odd.map(|y| [*x, y])).collect();
    for window in [[[-1.0; 2], [1.0; 2]], [[0.0; 2], [0.0; 2]], [[1.0; 2], [-1.0; 2]], [[f64::NAN; 2], [1.0; 2]]] {
        for [a, b] in spots.iter().flat_map(|a| spots.iter().step_by(5).map(move |b| [*a, *b])) {
            let parts = [
                Part::line(a, b),
                Part::ray_with_heads(a, b, &[0.0, 0.5, 1.0, f64::NAN]),
                Part::vector(a, b),
                Part::surface(a, b, Behind::Hatched),
                Part::surface(b, a, Behind::Tinted(a[0])),
                Part::arc(a, b[0], a[1], b[1]),
                Part::point(a),
                Part::across(b, true),
                Part::curve(vec![a, b, a]),
                Part::new(Form::Wavefronts { from: a, to: b, first: a[0], spacing: b[1], sides: b }),
                Part::note(b, "b"),
            ];
            let parts = parts.map(|part| part.label("x_1"));
            let plot = Plot::of("", Diagram::new("t", window[0], window[1]).with_all(parts));
            roxmltree::Document::parse(&svg(&plot)).expect("well-formed XML");
        }
    }
}

/// Writes the drawing at several settings to a folder named by `LESSON_GALLERY`, for looking at.
#[test]
fn settings_can_be_written() {
    let Some(folder) = std::env::var_os("LESSON_GALLERY") else { return };
    let folder = std::path::Path::new(&folder);
    std::fs::create_dir_all(folder).unwrap();
    let settings = [
        ("1", "1.5", 40.0),
        ("1", "1.5", 0.0),
        ("1", "1.5", 6.0),
        ("1", "1.5", 75.0),
        ("1", "1.5", 90.0),
        ("1", "1", 40.0),
        ("1", "4", 20.0),
        ("1", "gold", 50.0),
        ("1.5", "1", 41.5),
        ("1.5", "1", 41.9),
        ("1.5", "1", 60.0),
        ("1", "diamond", 56.0),
    ];
    for (n_i, n_t, degrees) in settings {
        let plot = snell(n_i, n_t, degrees);
        std::fs::write(folder.join(format!("snell-{n_i}-{n_t}-{degrees}.svg")), svg(&plot)).unwrap();
        std::fs::write(folder.join(format!("snell-{n_i}-{n_t}-{degrees}.png")), png(&plot)).unwrap();
    }
}
