//! Time: that of the clock on the wall, and that of processors.

use cpu_time::ProcessTime;
use serde::Serialize;
use std::time::{Duration, Instant};

/// A watch that runs since it was made.
#[derive(Clone, Copy, Debug)]
pub struct Watch {
    wall: Instant,
    cpu: ProcessTime,
}

/// What some work took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Spent {
    /// On the wall [s].
    pub seconds: f64,
    /// Of all processors that worked for this program [s].
    pub cpu_seconds: f64,
}

impl Watch {
    pub fn started() -> Self {
        Self { wall: Instant::now(), cpu: ProcessTime::now() }
    }

    /// On the wall, since it was started.
    pub fn elapsed(&self) -> Duration {
        self.wall.elapsed()
    }

    /// Since it was started.
    pub fn spent(&self) -> Spent {
        Spent { seconds: self.wall.elapsed().as_secs_f64(), cpu_seconds: self.cpu.elapsed().as_secs_f64() }
    }
}

impl Spent {
    /// That and more.
    pub fn plus(self, more: Self) -> Self {
        Self { seconds: self.seconds + more.seconds, cpu_seconds: self.cpu_seconds + more.cpu_seconds }
    }

    /// The processors' time, for who counts by it.
    pub fn cpu(&self) -> Duration {
        Duration::from_secs_f64(self.cpu_seconds)
    }
}

/// How good an error is for the time that it took [s⁻¹]: 1/(relMSE × CPU s), which more samples leave as it is where they are
/// independent; not a number for an error that is not above 0, as that of a picture of nothing.
pub fn efficiency(relative_mse: f64, cpu_seconds: f64) -> f64 {
    if relative_mse > 0.0 { 1.0 / (relative_mse * cpu_seconds) } else { f64::NAN }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn processors_are_counted_and_sleep_is_not() {
        let watch = Watch::started();
        std::thread::sleep(Duration::from_millis(30));
        let slept = watch.spent();
        assert!(slept.seconds >= 0.03);
        // Work goes on until the clock of processors has seen it: a clock that stands still never ends this.
        let mut x = 1_u64;
        while watch.spent().cpu_seconds < slept.cpu_seconds + 0.01 {
            x = std::hint::black_box(x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1));
        }
        assert!(watch.spent().cpu_seconds > slept.cpu_seconds);
    }

    #[test]
    fn efficiency_is_the_same_for_more_independent_samples() {
        assert_eq!(efficiency(0.01, 2.0), efficiency(0.01 / 4.0, 8.0));
        assert_eq!(efficiency(0.001, 4.0), 250.0);
        assert!(efficiency(0.0, 1.0).is_nan() && efficiency(-1e-9, 1.0).is_nan());
    }
}
