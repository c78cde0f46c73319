//! What a picture took and what is known of it, for scripts.

use super::clock::{Spent, efficiency};
use super::deviation;
use crate::run::machine;
use light::radiosity::Routes;
use light::transport::estimate::Estimate;
use light::transport::radiosity::{self, Solver};
use serde::Serialize;
use views::number::Number;
use views::report::Machine;

/// The version of the document.
const SCHEMA: u32 = 1;

/// What the estimate is.
const ESTIMATE: &str = "mean over pixels and channels of (x − truth)²/(truth² + 0.01), as the picture's two independent halves A, B tell it: mean of (A − B)²/4/(m² + 0.01), m = (A + B)/2, and as far as the halves of a pixel disagree, of its eight neighbours; deviation: its standard error, by how pixels differ";

/// What is known after a round of work.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Round {
    /// Samples a pixel so far.
    pub spp: u32,
    /// So far, without making ready.
    #[serde(flatten)]
    pub spent: Spent,
    /// The picture's relative mean square error [1].
    #[serde(serialize_with = "number")]
    pub relative_mse: f64,
    /// Its standard error [1], if that is known.
    pub deviation: Option<f64>,
}

/// What is known of the patches of a radiosity, from a sample of every pixel on until there are others.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Patches {
    first_sample: u32,
    faces: usize,
    /// Those of the faces that are backs.
    backs: usize,
    patches: usize,
    pairs: Pairs,
    /// The least and the largest sum of what a patch sees of all others [1].
    row_sums: [Number; 2],
    /// elimination, conjugate gradients or bounces.
    solver: &'static str,
    /// Steps of the solver, if it goes by steps.
    iterations: Option<u32>,
    /// The largest that is left of any patch's equation, over the brightest patch [1].
    residual: Number,
    /// The mean of what patches send back [W m⁻² sr⁻¹].
    mean: Number,
}

/// Pairs of patches, by how their form factors were found; those that are hidden are among them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
struct Pairs {
    behind: usize,
    closed: usize,
    contour: usize,
    points: usize,
    hidden: usize,
}

impl Patches {
    /// Of the patches that are those of a sample.
    pub fn of(first_sample: u32, facts: &radiosity::Facts) -> Self {
        let radiosity::Facts { faces, backs, patches, routes, sums, solver, residual, mean } = *facts;
        let Routes { behind, closed, points, contour, hidden } = routes;
        let (solver, iterations) = match solver {
            Solver::Direct => ("elimination", None),
            Solver::Conjugate(steps) => ("conjugate gradients", Some(steps)),
            Solver::Bounces(bounces) => ("bounces", Some(bounces)),
        };
        let pairs = Pairs { behind, closed, contour, points, hidden };
        let (row_sums, residual, mean) = (sums.map(Number), Number(residual), Number(mean));
        Self { first_sample, faces, backs, patches, pairs, row_sums, solver, iterations, residual, mean }
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        self.patches
    }
}

/// The document, but for what it finds out itself.
#[derive(Debug)]
pub struct Facts<'a> {
    pub scene: &'a str,
    pub size: [u32; 2],
    pub integrator: &'a str,
    pub seed: u64,
    pub max_depth: Option<u32>,
    /// What the scene needs, in words.
    pub needs: Vec<String>,
    /// What was left out, and why.
    pub left_out: Vec<(&'a str, &'a str)>,
    /// What the scene ready for rays occupies [B].
    pub bytes: usize,
    pub making_ready: Spent,
    /// Without making ready.
    pub spent: Spent,
    pub spp: u32,
    /// Those that a film had before.
    pub spp_before: u32,
    pub found: Estimate,
    pub rounds: &'a [Round],
    /// Of a radiosity, as their number grows; none of other integrators.
    pub patches: &'a [Patches],
}

#[derive(Serialize)]
struct Document<'a> {
    schema: u32,
    version: &'static str,
    machine: Machine,
    threads: usize,
    scene: &'a str,
    width: u32,
    height: u32,
    integrator: &'a str,
    seed: u64,
    max_depth: Option<u32>,
    needs: &'a [String],
    left_out: Vec<LeftOut<'a>>,
    scene_bytes: usize,
    making_ready: Spent,
    #[serde(flatten)]
    spent: Spent,
    spp: u32,
    spp_before: u32,
    relative_mse: Number,
    deviation: Option<Number>,
    relative_error: Number,
    relative_mse_is: &'static str,
    /// 1/(relMSE × CPU s); none for a picture that was partly rendered before, or is without error.
    efficiency: Option<f64>,
    mean: [Number; 3],
    broken_pixels: usize,
    rounds: &'a [Round],
    patches: &'a [Patches],
}

#[derive(Serialize)]
struct LeftOut<'a> {
    what: &'a str,
    why: &'a str,
}

fn number<S: serde::Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    Number(*x).serialize(serializer)
}

impl Facts<'_> {
    /// As JSON.
    pub fn json(&self) -> Vec<u8> {
        let Self { found, spent, .. } = self;
        let efficiency = efficiency(found.relative_mse, spent.cpu_seconds);
        let document = Document {
            schema: SCHEMA,
            version: env!("CARGO_PKG_VERSION"),
            machine: machine(),
            threads: rayon::current_num_threads(),
            scene: self.scene,
            width: self.size[0],
            height: self.size[1],
            integrator: self.integrator,
            seed: self.seed,
            max_depth: self.max_depth,
            needs: &self.needs,
            left_out: self.left_out.iter().map(|(what, why)| LeftOut { what, why }).collect(),
            scene_bytes: self.bytes,
            making_ready: self.making_ready,
            spent: *spent,
            spp: self.spp,
            spp_before: self.spp_before,
            relative_mse: Number(found.relative_mse),
            deviation: deviation(found, self.size[0] as usize * self.size[1] as usize).map(Number),
            relative_error: Number(found.relative_error()),
            relative_mse_is: ESTIMATE,
            efficiency: Some(efficiency).filter(|x| x.is_finite() && self.spp_before == 0),
            mean: found.mean.map(Number),
            broken_pixels: found.broken,
            rounds: self.rounds,
            patches: self.patches,
        };
        let mut bytes = serde_json::to_vec_pretty(&document).expect("numbers and texts can be written as JSON");
        bytes.push(b'\n');
        bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(rounds: &[Round]) -> Facts<'_> {
        Facts {
            scene: "a \"box\"",
            size: [3, 2],
            integrator: "fast",
            seed: u64::MAX,
            max_depth: None,
            needs: vec!["a lamp".to_owned()],
            left_out: vec![("all", "for a test")],
            bytes: 7,
            making_ready: Spent { seconds: 0.5, cpu_seconds: 0.25 },
            spent: Spent { seconds: 2.0, cpu_seconds: 4.0 },
            spp: 8,
            spp_before: 0,
            found: Estimate { relative_mse: 0.0025, deviation: 1e-4, mean: [1.0, f64::NAN, 2.0], broken: 1 },
            rounds,
            patches: &[],
        }
    }

    fn read(facts: &Facts) -> serde_json::Value {
        serde_json::from_slice(&facts.json()).expect("JSON")
    }

    #[test]
    fn the_document_says_what_is_known_and_nothing_else() {
        let spent = Spent { seconds: 1.0, cpu_seconds: 2.0 };
        let rounds = [Round { spp: 4, spent, relative_mse: f64::INFINITY, deviation: Some(0.5) }];
        let found = read(&facts(&rounds));
        // 1/(0.0025 · 4): by the processors' time.
        assert_eq!(found["efficiency"], 100.0);
        assert_eq!((&found["seconds"], &found["cpu_seconds"]), (&2.0.into(), &4.0.into()));
        assert_eq!(found["relative_error"], 0.05);
        assert_eq!((&found["scene"], &found["seed"]), (&"a \"box\"".into(), &u64::MAX.into()));
        assert_eq!(found["mean"], serde_json::json!([1.0, "nan", 2.0]));
        assert_eq!(found["left_out"], serde_json::json!([{"what": "all", "why": "for a test"}]));
        let round = serde_json::json!(
            {"spp": 4, "seconds": 1.0, "cpu_seconds": 2.0, "relative_mse": "inf", "deviation": 0.5}
        );
        assert_eq!(found["rounds"], serde_json::json!([round]));
        assert!(found["machine"]["cpu"].is_string() && found["threads"].as_u64() > Some(0));
        assert!(found["relative_mse_is"].as_str().is_some_and(|text| text.contains("(A − B)²/4")));
    }

    #[test]
    fn patches_are_told_as_they_were_solved() {
        let routes = Routes { behind: 1, closed: 2, points: 3, contour: 4, hidden: 5 };
        let facts = radiosity::Facts {
            faces: 6,
            backs: 1,
            patches: 128,
            routes,
            sums: [0.5, 1.0],
            solver: Solver::Conjugate(32),
            residual: 1e-11,
            mean: f64::INFINITY,
        };
        let patches = [
            Patches::of(0, &facts),
            Patches::of(4, &radiosity::Facts { solver: Solver::Direct, residual: f64::NAN, ..facts }),
        ];
        let found = &read(&Facts { patches: &patches, ..self::facts(&[]) })["patches"];
        let pairs = serde_json::json!({"behind": 1, "closed": 2, "contour": 4, "points": 3, "hidden": 5});
        let first = serde_json::json!({"first_sample": 0, "faces": 6, "backs": 1, "patches": 128, "pairs": pairs,
            "row_sums": [0.5, 1.0], "solver": "conjugate gradients", "iterations": 32, "residual": 1e-11, "mean": "inf"});
        assert_eq!(found[0], first);
        assert_eq!((&found[1]["first_sample"], &found[1]["solver"]), (&4.into(), &"elimination".into()));
        assert!(found[1]["iterations"].is_null() && found[1]["residual"] == "nan");
        assert_eq!(read(&self::facts(&[]))["patches"], serde_json::json!([]));
    }

    #[test]
    fn what_was_rendered_before_has_no_price() {
        let resumed = read(&Facts { spp_before: 4, ..facts(&[]) });
        assert!(resumed["efficiency"].is_null() && resumed["spp_before"] == 4);
        let exact = Estimate { relative_mse: 0.0, ..Estimate::default() };
        assert!(read(&Facts { found: exact, ..facts(&[]) })["efficiency"].is_null());
        // Of one pixel nothing tells how sure its error is.
        let one = Facts { size: [1, 1], found: exact, ..facts(&[]) };
        assert!(read(&one)["deviation"].is_null() && read(&facts(&[]))["deviation"] == 1e-4);
    }
}
