//! The constants of the vacuum, from CODATA 2022 (Mohr, Newell, Taylor & Tiesinga, *Rev. Mod. Phys.* 97, 025002, 2025).

/// c: speed of light in vacuum [m s⁻¹], exact since 1983 (E11).
pub const C: f64 = 299_792_458.0;

/// μ₀: permeability of the vacuum [H m⁻¹], CODATA 2022. Measured since 2019, when the ampere was fixed by e instead;
/// its relative uncertainty is 1.6e−10.
pub const MU_0: f64 = 1.256_637_061_27e-6;

/// ε₀ = 1/(μ₀c²): permittivity of the vacuum [F m⁻¹]. It rounds to CODATA 2022's 8.854 187 8188e−12; formed here, so
/// that 1/√(ε₀μ₀) is c to the last digit instead of the tenth.
pub const EPSILON_0: f64 = 1.0 / (MU_0 * C * C);

/// Z₀ = μ₀c: impedance of the vacuum [Ω], 376.730 313 412 (E17).
pub const Z_0: f64 = MU_0 * C;
