//! Ctrl-C and its like: the work ends, and what there is of it is kept.

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// What has been asked of this process since it was made.
pub struct Interrupt {
    /// The signal's number; 0 is none.
    by: Arc<AtomicUsize>,
}

impl Interrupt {
    /// From now on a first signal is noted, and a second one ends the process at once.
    pub fn watched() -> Self {
        let (asked, by) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicUsize::new(0)));
        for signal in [SIGINT, SIGTERM] {
            // Where a signal cannot be watched it ends the process, as it would without us.
            let watched = flag::register_conditional_shutdown(signal, code(signal), Arc::clone(&asked))
                .and_then(|_| flag::register(signal, Arc::clone(&asked)))
                .and_then(|_| flag::register_usize(signal, Arc::clone(&by), signal as usize));
            drop(watched);
        }
        Self { by }
    }

    /// From now on no such signal ends the process: for whoever looks often and has a terminal to give back.
    pub fn noted() -> Self {
        let by = Arc::new(AtomicUsize::new(0));
        let deadly = [
            SIGINT,
            SIGTERM,
            #[cfg(unix)]
            signal_hook::consts::SIGHUP,
            #[cfg(unix)]
            signal_hook::consts::SIGQUIT,
        ];
        for signal in deadly {
            drop(flag::register_usize(signal, Arc::clone(&by), signal as usize));
        }
        Self { by }
    }

    /// The exit code of who was asked to end, if that is so.
    pub fn code(&self) -> Option<u8> {
        let signal = self.by.load(Ordering::Relaxed);
        (signal > 0).then(|| code(signal as i32) as u8)
    }
}

/// The exit code of a process that a signal ended, as shells tell it.
fn code(signal: i32) -> i32 {
    128 + signal
}
