//! The figures of the chapters chosen as features, over a plain C ABI for WebAssembly.
//!
//! A host asks with the text that [`views::request`] describes and gets SVG or the text of a fault:
//!
//! 1. `lesson_request(length)` makes room for a request of so many bytes and returns where to write it (UTF-8);
//! 2. `lesson_answer()` serves it and returns 0 if the answer is an SVG, 1 if it is a fault's text;
//! 3. `lesson_text()` and `lesson_length()` tell where the answer stands and how many bytes it has, until the next request.
//!
//! Memory may grow in every one of these calls: take the view of it anew after each. The module imports nothing. Should
//! it panic, the call traps; the host then throws the instance away and says so.

use chapters::vocabulary::Gallery;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What the chapters in this module show.
const GALLERIES: &[Gallery] = &[
    #[cfg(feature = "maxwell")]
    chapters::maxwell::FIGURES,
    #[cfg(feature = "plane-wave")]
    chapters::plane_wave::FIGURES,
    #[cfg(feature = "poynting")]
    chapters::poynting::FIGURES,
    #[cfg(feature = "radiometry")]
    chapters::radiometry::FIGURES,
    #[cfg(feature = "fresnel")]
    chapters::fresnel::FIGURES,
    #[cfg(feature = "brdf")]
    chapters::brdf::FIGURES,
];

/// The request that the host writes, and after `lesson_answer` the answer that it reads.
static TEXT: Mutex<Vec<u8>> = Mutex::new(Vec::new());

fn text() -> MutexGuard<'static, Vec<u8>> {
    // A panic ends the module; there is no half-done text to protect anybody from.
    TEXT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes room for a request of `length` bytes, and returns where the host is to write it.
#[allow(unsafe_code)] // the name alone; nothing here is unsafe to do
#[unsafe(no_mangle)]
pub extern "C" fn lesson_request(length: usize) -> *mut u8 {
    let mut text = text();
    *text = vec![0; length];
    text.as_mut_ptr()
}

/// Serves the request: 0 if the answer is an SVG, 1 if it is the text of a fault.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn lesson_answer() -> u32 {
    let mut text = text();
    let answer = match str::from_utf8(&text) {
        Ok(request) => views::request::answer(request, GALLERIES).map_err(|fault| fault.to_string()),
        Err(_) => Err("request: not UTF-8".to_owned()),
    };
    let failed = answer.is_err();
    *text = answer.unwrap_or_else(|fault| fault).into_bytes();
    failed.into()
}

/// Where the answer stands.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn lesson_text() -> *const u8 {
    text().as_ptr()
}

/// How many bytes the answer has.
#[allow(unsafe_code)]
#[unsafe(no_mangle)]
pub extern "C" fn lesson_length() -> usize {
    text().len()
}
