//! What a measurement may use, and the quantities that a step shows.

use crate::parameter::Setting;
use yardstick::random::{Stream, stream};

/// The seed of every random stream of the lecture.
pub const SEED: u64 = 0;

/// What a measurement may use: the setting and random numbers of its own.
#[derive(Debug)]
pub struct Bench<'a> {
    setting: &'a Setting,
    is_setting_read: bool,
    /// The stream named by the item's address.
    pub stream: Stream,
}

impl<'a> Bench<'a> {
    /// The bench of the item at `address`.
    pub fn new(setting: &'a Setting, seed: u64, address: &str) -> Self {
        Self { setting, is_setting_read: false, stream: stream(seed, address) }
    }

    /// The parameters in force.
    pub fn setting(&mut self) -> &'a Setting {
        self.is_setting_read = true;
        self.setting
    }

    /// Whether anybody has asked for them: if not, the measurement is the same whatever is set.
    pub fn is_setting_read(&self) -> bool {
        self.is_setting_read
    }
}

/// A named number shown for the current setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// Stable key in JSON (`r_s_re`).
    pub key: &'static str,
    /// Symbol, in the label markup of [`crate::figure`] (`R_s`, `θ_B`).
    pub symbol: &'static str,
    /// What it is.
    pub says: &'static str,
    /// Value in SI.
    pub value: f64,
    /// Unit shown; angles are stored in radians with unit `rad` and shown in degrees.
    pub unit: &'static str,
}
