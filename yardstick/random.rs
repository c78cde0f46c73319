//! Random numbers that depend on a name and a seed alone.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

/// The generator of the whole project: PCG XSL-RR 128/64 (O'Neill 2014), the same on every machine.
pub type Stream = Pcg64;

/// The stream that belongs to `address` (`fresnel/natural/hemisphere`) under `seed`. Neither threads
/// nor new neighbours move its numbers.
pub fn stream(seed: u64, address: &str) -> Stream {
    // FNV-1a (Fowler, Noll, Vo), 64 bits: a fixed, portable hash of the name.
    let hash = address
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    let mut key = [0_u8; 32];
    key[..8].copy_from_slice(&seed.to_le_bytes());
    key[8..16].copy_from_slice(&hash.to_le_bytes());
    key[16..24].copy_from_slice(&hash.rotate_left(32).to_le_bytes());
    Pcg64::from_seed(key)
}

/// A number [1] drawn evenly from `low` to `high`.
pub fn uniform(stream: &mut Stream, low: f64, high: f64) -> f64 {
    low + (high - low) * rand::RngExt::random::<f64>(stream)
}
