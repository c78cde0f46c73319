//! draft
use super::symbols::*;
use equation::derivation::Chain;
use equation::expr::{cos, d, integral_between, partial, pi, ratio, sin, sqrt, tan};
use equation::{Equation, Expr};

pub fn e47(last: Expr) -> Chain {
    Chain::new(d(L_R) / d(E)).given(d(E), L_IN * cos(THETA_I) * d(OMEGA_I), "what one bundle adds to E").then(last, ["what one bundle adds to E"])
}
pub fn e48(last: Expr) -> Chain {
    Chain::assume(Equation::new(integral_between(2 * pi() * K * E * cos(THETA_O) * sin(THETA_O), THETA_O, 0, pi() / 2), RHO * E), "what leaves is ρ of what arrives")
        .primitive(pi() * K * E * sin(THETA_O).pow(2), THETA_O)
        .solve_for([K])
        .then(Equation::new(K, last), ["∂ sin² θ = 2 sin θ cos θ"])
}
pub fn e50(last: Expr) -> Chain {
    Chain::assume(Equation::new(L_R, F_R * L_IN * cos(THETA_I) * PATCH), "E47 of a narrow patch")
        .and(Equation::new(L_R, L_IN), "a perfect mirror")
        .solve_for([F_R, L_R])
        .given(PATCH, 1 / DELTA, "δ of that patch")
        .then(Equation::new(F_R, last), ["linear solve"])
}
pub fn half(last: Expr) -> Chain {
    Chain::new(sin(THETA_I) * partial(THETA_I, THETA_H) / sin(THETA_H))
        .because("turn about ω_o")
        .given(THETA_I, 2 * THETA_H, "the mirror law")
        .then(last, ["sin 2θ = 2 sin θ cos θ"])
}
pub fn refr(last: Expr) -> Chain {
    Chain::new(sin(THETA_O - THETA_I) * (1 - TURN) / sin(THETA_O))
        .given(TURN, N_O * cos(THETA_O) / (N_I * cos(THETA_I)), "Snell's law, differentiated")
        .given(N_I, N_O * sin(THETA_O) / sin(THETA_I), "Snell's law")
        .then(last, ["Snell's law"])
}
pub fn snell(last: Expr) -> Chain {
    Chain::assume(Equation::new(N_I * cos(THETA_I) * TURN, partial(N_O * sin(THETA_O), THETA_O)), "Snell, both sides differentiated")
        .solve_for([TURN])
        .then(Equation::new(TURN, last), ["chain rule"])
}
pub fn smith(last: Expr) -> Chain {
    Chain::new(1 / MU * integral_between(ratio(1, 2) * (ALPHA * sin(PSI) - MU * cos(PSI)), PSI, PSI_0, pi() / 2))
        .given(MU, ALPHA * tan(PSI_0), "grazed")
        .primitive(-(ratio(1, 2) * (ALPHA * cos(PSI) + MU * sin(PSI))), PSI)
        .then(last, ["x"])
}
pub fn smith2(last: Expr) -> Chain {
    Chain::new((1 + 2 * LAMBDA).pow(2))
        .given(LAMBDA, (1 / sin(PSI_0) - 1) / 2, "l")
        .given(MU, ALPHA * tan(PSI_0), "grazed")
        .then(last, ["x"])
}
pub fn weight(last: Expr) -> Chain {
    Chain::new(F_R * C_I / PDF)
        .given(F_R, D_M * F * G_2 / (4 * C_I * C_O), "facets")
        .given(PDF, G_1 * D_M * C_M / C_O * (1 / (4 * C_M)), "visible")
        .then(last, ["cancel"])
}
#[test]
fn drafts() {
    let go = |name: &str, chain: Chain| {
        let found = crate::judge::follow(&chain, name);
        println!("{name}: {} {:?} {:?}", found.holds(), found.mismatch, found.hops.iter().map(|h| &h.verdict).collect::<Vec<_>>());
    };
    go("e47", e47(d(L_R) / (L_IN * cos(THETA_I) * d(OMEGA_I))));
    go("e47!", e47(d(L_R) / (L_IN * d(OMEGA_I))));
    go("e48", e48(RHO / pi()));
    go("e48!", e48(RHO / (2 * pi())));
    go("e50", e50(DELTA / cos(THETA_I)));
    go("e50!", e50(DELTA.into()));
    go("half", half(4 * cos(THETA_H)));
    go("half!", half(Expr::from(4)));
    let up = || (N_O * cos(THETA_O) - N_I * cos(THETA_I)).pow(2);
    go("refr", refr(up() / (N_I.pow(2) * cos(THETA_I))));
    go("refr!", refr(up() / (N_O.pow(2) * cos(THETA_I))));
    go("snell", snell(N_O * cos(THETA_O) / (N_I * cos(THETA_I))));
    go("smith", smith((1 / sin(PSI_0) - 1) / 2));
    go("smith!", smith((1 / sin(PSI_0) + 1) / 2));
    go("smith2", smith2(1 + (ALPHA / MU).pow(2)));
    go("smith2!", smith2(1 + ALPHA / MU));
    go("smith3", smith((sqrt(1 + (ALPHA / MU).pow(2)) - 1) / 2));
    go("weight", weight(F * G_2 / G_1));
    go("weight!", weight(F * G_2));
}
const TURN: equation::Symbol = equation::Symbol::scalar("tau", equation::Dimension::ONE).real(0.5, 1.5);
