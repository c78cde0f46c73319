//! The equations L = L_e + ρ F L of a network, solved: five ways to one answer, radiances [W m⁻² sr⁻¹].

use super::{Light, Network};

/// The first `terms` ≥ 1 terms of the series L_e + ρF L_e + (ρF)² L_e + …: light that was reflected less often than that.
pub fn series(network: &Network, light: &Light, terms: u32) -> Vec<f64> {
    let mut found = light.emitted.clone();
    for _ in 1..terms {
        let next: Vec<f64> = (0..network.len())
            .map(|at| light.emitted[at] + light.reflected(at) * network.arriving(at, &found))
            .collect();
        // What stays as it is once stays so.
        if next == found {
            break;
        }
        found = next;
    }
    found
}

/// After `sweeps` over all patches, each taking what the others have become already (Gauss and Seidel).
pub fn seidel(network: &Network, light: &Light, sweeps: u32) -> Vec<f64> {
    let mut found = light.emitted.clone();
    for _ in 0..sweeps {
        for at in 0..network.len() {
            // A patch that sees itself, as those of a sphere do, is solved for.
            let (rho, own) = (light.reflected(at), network.row(at)[at]);
            let others = network.arriving(at, &found) - own * found[at];
            found[at] = (light.emitted[at] + rho * others) / (1.0 - rho * own);
        }
    }
    found
}

/// After so many `shots`: each time the patch that holds most light which it has not sent yet sends it to all others
/// (M. F. Cohen, S. E. Chen, J. R. Wallace, D. P. Greenberg, *A progressive refinement approach to fast radiosity image
/// generation*, SIGGRAPH '88, 75). Also what is left unsent, over what the lamps send [1].
pub fn shooting(network: &Network, light: &Light, shots: u32) -> (Vec<f64>, f64) {
    let (mut found, mut unsent) = (light.emitted.clone(), light.emitted.clone());
    let held = |at: usize, unsent: &[f64]| network.areas[at] * unsent[at];
    let all = |unsent: &[f64]| (0..network.len()).map(|at| held(at, unsent)).sum::<f64>();
    for _ in 0..shots {
        let most = |a: &usize, b: &usize| held(*a, &unsent).total_cmp(&held(*b, &unsent));
        let Some(from) = (0..network.len()).max_by(most) else { break };
        let sent = network.areas[from] * std::mem::take(&mut unsent[from]);
        for (to, factor) in network.row(from).iter().enumerate() {
            // A F is the same both ways.
            let gained = light.reflected(to) * factor * sent / network.areas[to];
            found[to] += gained;
            unsent[to] += gained;
        }
    }
    (found, all(&unsent) / all(&light.emitted))
}

/// After so many `steps` of conjugate gradients (M. R. Hestenes and E. Stiefel, *J. Res. NBS* 49 (1952) 409) on the symmetric
/// form of the equations, for √(ρA) of what arrives.
pub fn conjugate(network: &Network, light: &Light, steps: u32) -> Vec<f64> {
    let n = network.len();
    let root: Vec<f64> = (0..n).map(|at| (light.reflected(at) * network.areas[at]).sqrt()).collect();
    let share: Vec<f64> = (0..n).map(|at| (light.reflected(at) / network.areas[at]).sqrt()).collect();
    let weighted = |weights: &[f64], of: &[f64]| -> Vec<f64> { weights.iter().zip(of).map(|(w, x)| w * x).collect() };
    // (1 − S) x, S = √(ρA) F √(ρ/A).
    let applied = |x: &[f64]| -> Vec<f64> {
        let inner = weighted(&share, x);
        (0..n).map(|at| x[at] - root[at] * network.arriving(at, &inner)).collect()
    };
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
    let mut rest: Vec<f64> = (0..n).map(|at| root[at] * network.arriving(at, &light.emitted)).collect();
    let (mut found, mut way) = (vec![0.0; n], rest.clone());
    let mut square = dot(&rest, &rest);
    for _ in 0..steps {
        let image = applied(&way);
        let along = dot(&way, &image);
        if along <= 0.0 || square == 0.0 {
            break;
        }
        let step = square / along;
        for at in 0..n {
            found[at] += step * way[at];
            rest[at] -= step * image[at];
        }
        let next = dot(&rest, &rest);
        let turn = next / square;
        way = rest.iter().zip(&way).map(|(rest, way)| rest + turn * way).collect();
        square = next;
    }
    (0..n).map(|at| light.emitted[at] + share[at] * found[at]).collect()
}

/// At once, by elimination without a difference: the diagonal is what a patch absorbs and loses and sends to others, all of
/// it positive, and stays so (W. K. Grassmann, M. I. Taksar, D. P. Heyman, *Oper. Res.* 33 (1985) 1107; C. A. O'Cinneide,
/// *Numer. Math.* 65 (1993) 109). Every radiance keeps its digits, however little is absorbed; where nothing is and nothing is
/// lost it is infinite, or not a number. Work grows as n³.
pub fn direct(network: &Network, light: &Light) -> Vec<f64> {
    let n = network.len();
    let mut sent: Vec<f64> =
        (0..n).flat_map(|at| network.row(at).iter().map(move |factor| light.reflected(at) * factor)).collect();
    let mut kept: Vec<f64> = (0..n).map(|at| light.absorbed[at] + light.reflected(at) * network.lost[at]).collect();
    let mut found = light.emitted.clone();
    let mut diagonal = vec![0.0; n];
    for k in 0..n {
        let (above, below) = sent.split_at_mut((k + 1) * n);
        let pivot = &above[k * n + k + 1..];
        diagonal[k] = kept[k] + pivot.iter().sum::<f64>();
        for (row, at) in below.chunks_exact_mut(n).zip(k + 1..) {
            let share = row[k] / diagonal[k];
            if share > 0.0 {
                row[k + 1..].iter_mut().zip(pivot).for_each(|(to, more)| *to += share * more);
                kept[at] += share * kept[k];
                found[at] += share * found[k];
            }
        }
    }
    for k in (0..n).rev() {
        let others: f64 = sent[k * n + k + 1..(k + 1) * n].iter().zip(&found[k + 1..]).map(|(to, of)| to * of).sum();
        found[k] = (found[k] + others) / diagonal[k];
    }
    found
}

/// The same by plain elimination, its diagonal 1 − ρF: what cancels there is lost.
pub fn plain(network: &Network, light: &Light) -> Vec<f64> {
    let n = network.len();
    let entry = |at: usize, to: usize| f64::from(u8::from(at == to)) - light.reflected(at) * network.row(at)[to];
    let mut rows: Vec<Vec<f64>> = (0..n).map(|at| (0..n).map(|to| entry(at, to)).collect()).collect();
    let mut found = light.emitted.clone();
    for k in 0..n {
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot = &above[k];
        for (row, at) in below.iter_mut().zip(k + 1..) {
            let share = row[k] / pivot[k];
            row[k..].iter_mut().zip(&pivot[k..]).for_each(|(x, y)| *x -= share * y);
            found[at] -= share * found[k];
        }
    }
    for k in (0..n).rev() {
        let others: f64 = rows[k][k + 1..].iter().zip(&found[k + 1..]).map(|(x, y)| x * y).sum();
        found[k] = (found[k] - others) / rows[k][k];
    }
    found
}
