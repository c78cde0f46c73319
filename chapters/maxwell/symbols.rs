//! The quantities of the chapter as symbols. Letters without an index are fields; 1 is the side from which the normal n
//! points, 2 the side to which it points.

use light::equation::{Dimension, Symbol};

/// Electric field.
pub const E: Symbol = Symbol::vector("E", Dimension::VOLT_PER_METRE).field();
/// Magnetic flux density.
pub const B: Symbol = Symbol::vector("B", Dimension::TESLA).field();
/// Electric flux density.
pub const D: Symbol = Symbol::vector("D", Dimension::COULOMB_PER_SQUARE_METRE).field();
/// Magnetic field.
pub const H: Symbol = Symbol::vector("H", Dimension::AMPERE_PER_METRE).field();
/// Current density.
pub const J: Symbol = Symbol::vector("J", Dimension::AMPERE_PER_SQUARE_METRE).field();
/// Charge density.
pub const RHO: Symbol = Symbol::scalar("rho", Dimension::COULOMB_PER_CUBIC_METRE).field();

/// Time.
pub const T: Symbol = Symbol::scalar("t", Dimension::SECOND).real(0.25, 1.25);
/// Permittivity.
pub const EPSILON: Symbol = Symbol::scalar("epsilon", Dimension::FARAD_PER_METRE).real(0.5, 2.0);
/// Permeability.
pub const MU: Symbol = Symbol::scalar("mu", Dimension::HENRY_PER_METRE).real(0.5, 2.0);
/// Conductivity.
pub const SIGMA: Symbol = Symbol::scalar("sigma", Dimension::SIEMENS_PER_METRE).real(0.5, 2.0);
/// Impedance of the vacuum.
pub const Z_0: Symbol = Symbol::scalar("Z_0", Dimension::OHM).real(0.5, 2.0);

/// Normal of the interface.
pub const NORMAL: Symbol = Symbol::vector("n", Dimension::ONE);
/// Electric field on either side.
pub const E_1: Symbol = Symbol::vector("E_1", Dimension::VOLT_PER_METRE);
/// See [`E_1`].
pub const E_2: Symbol = Symbol::vector("E_2", Dimension::VOLT_PER_METRE);
/// Magnetic field on either side.
pub const H_1: Symbol = Symbol::vector("H_1", Dimension::AMPERE_PER_METRE);
/// See [`H_1`].
pub const H_2: Symbol = Symbol::vector("H_2", Dimension::AMPERE_PER_METRE);
/// Electric flux density on either side.
pub const D_1: Symbol = Symbol::vector("D_1", Dimension::COULOMB_PER_SQUARE_METRE);
/// See [`D_1`].
pub const D_2: Symbol = Symbol::vector("D_2", Dimension::COULOMB_PER_SQUARE_METRE);
/// Magnetic flux density on either side.
pub const B_1: Symbol = Symbol::vector("B_1", Dimension::TESLA);
/// See [`B_1`].
pub const B_2: Symbol = Symbol::vector("B_2", Dimension::TESLA);

/// Charge on the interface.
pub const RHO_S: Symbol = Symbol::scalar("rho_s", Dimension::COULOMB_PER_SQUARE_METRE);
/// Current in the interface.
pub const K_S: Symbol = Symbol::vector("K", Dimension::AMPERE_PER_METRE);
