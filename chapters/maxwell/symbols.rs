//! The quantities at an interface as symbols: 1 is the side from which the normal n points, 2 the side to which it points.

use equation::{Dimension, Symbol};

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
