//! A figure for a text: the one protocol by which a page asks for any figure at any setting.
//!
//! The first line is the figure's address, each further line sets a parameter as `--set` does; empty lines count for
//! nothing. The answer is an SVG, or a fault that names the place and what is valid there:
//!
//! ```text
//! fresnel/natural/reflectance
//! n_t=2.4
//! theta=56deg
//! ```

use crate::plot;
use chapters::parameter::{Fault, Parameter, Setting, excerpt};
use chapters::vocabulary::{Figure, Gallery};

/// The figure that `request` asks for, out of those in `galleries`, as an SVG.
///
/// # Errors
/// Names the part of the address, the line or the parameter that cannot be used, and what can.
pub fn answer(request: &str, galleries: &[Gallery]) -> Result<String, Fault> {
    let mut lines = request.lines().map(str::trim).filter(|line| !line.is_empty());
    let address = lines.next().ok_or_else(|| Fault::new("request", "empty; its first line is a figure's address"))?;
    let (parameters, figure) = find(address, galleries)?;
    let changes = lines.map(change).collect::<Result<Vec<_>, Fault>>()?;
    let setting = Setting::defaults(parameters).with(&changes);
    // The place may be a name from the request, which may be of any length.
    let setting = setting.map_err(|fault| Fault { place: excerpt(&fault.place), ..fault })?;
    Ok(plot::svg(&(figure.plot)(&setting)))
}

/// Every address that [`answer`] takes, in teaching order.
pub fn addresses(galleries: &[Gallery]) -> Vec<String> {
    let exhibits =
        galleries.iter().flat_map(|gallery| gallery.exhibits.iter().map(|exhibit| (gallery.chapter, exhibit)));
    let figures = exhibits.flat_map(|(chapter, exhibit)| {
        exhibit.figures.iter().map(move |figure| format!("{chapter}/{}/{}", exhibit.step, figure.id))
    });
    figures.collect()
}

/// The figure at an address, and what can be set for it.
fn find(address: &str, galleries: &[Gallery]) -> Result<(&'static [Parameter], &'static Figure), Fault> {
    let mut parts = address.split('/');
    let mut part = || parts.next().unwrap_or_default();
    let (chapter, step, figure) = (part(), part(), part());
    if let Some(extra) = parts.next() {
        return Err(Fault::new(excerpt(extra), "a figure's address has the parts chapter/step/figure"));
    }
    let gallery = pick("chapter", chapter, "", galleries, |gallery| gallery.chapter)?;
    let exhibit = pick("step", step, gallery.chapter, gallery.exhibits, |exhibit| exhibit.step)?;
    let place = format!("{}/{}", gallery.chapter, exhibit.step);
    Ok((exhibit.parameters, pick("figure", figure, &place, exhibit.figures, |figure| figure.id)?))
}

/// The one of `items` whose id is `word`.
fn pick<'a, T>(
    what: &str,
    word: &str,
    place: &str,
    items: impl IntoIterator<Item = &'a T>,
    id: fn(&T) -> &'static str,
) -> Result<&'a T, Fault> {
    let mut known = Vec::new();
    for item in items {
        if id(item) == word {
            return Ok(item);
        }
        known.push(id(item));
    }
    let place = if place.is_empty() { excerpt(word) } else { format!("{place}/{}", excerpt(word)) };
    let message = if word.is_empty() { format!("the {what} is missing") } else { format!("no such {what}") };
    Err(Fault::unknown(place, word, message, known))
}

/// A line `name=value`.
fn change(line: &str) -> Result<(String, String), Fault> {
    let (name, value) =
        line.split_once('=').ok_or_else(|| Fault::new(excerpt(line), "not a setting; valid: name=value"))?;
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use chapters::{CURRICULUM, fresnel};

    fn all() -> Vec<Gallery> {
        CURRICULUM.iter().map(|chapter| chapter.figures).collect()
    }

    fn fault(request: &str) -> String {
        answer(request, &all()).expect_err(request).to_string()
    }

    /// A figure that is drawn at an angle of incidence and an index.
    fn of_an_angle() -> String {
        "fresnel/brewster/zero_of_r_p".to_owned()
    }

    #[test]
    fn a_setting_changes_the_figure() {
        let address = of_an_angle();
        let drawn = |lines: &str| answer(&format!("{address}\n{lines}"), &all()).unwrap();
        let plain = drawn("");
        assert!(plain.starts_with("<svg"));
        assert_eq!(plain, drawn("\r\n\n  theta = 45deg  \r\n"), "the default, spelt out");
        assert_ne!(plain, drawn("n_t=2.4"));
        assert_eq!(fault(&format!("{address}\nn_t=7\nn_t=2.4")), "n_t: given twice");
    }

    #[test]
    fn every_address_is_taken() {
        let addresses = addresses(&all());
        assert!(!addresses.is_empty());
        for address in &addresses {
            assert!(find(address, &all()).is_ok(), "{address}");
        }
    }

    #[test]
    fn faults_name_the_place_and_what_is_valid() {
        let address = of_an_angle();
        let (step, figure) = address.rsplit_once('/').unwrap();
        assert_eq!(fault(" \n"), "request: empty; its first line is a figure's address");
        assert!(fault("fresnell/a/b").starts_with("fresnell: no such chapter. Known: maxwell, plane-wave,"));
        assert!(fault("fresnel").starts_with("fresnel/: the step is missing. Known: snell,"));
        assert!(fault("fresnel/brewstr/a").starts_with("fresnel/brewstr: no such step. Known: "));
        assert!(fault(&format!("{step}/x")).starts_with(&format!("{step}/x: no such figure. Known: {figure}")));
        assert!(fault(&format!("{address}/more")).starts_with("more: a figure's address has the parts"));
        assert_eq!(fault(&format!("{address}\nn_t")), "n_t: not a setting; valid: name=value");
        assert!(fault(&format!("{address}\nnt=2")).starts_with("nt: no such parameter here. Known: n_i, n_t"));
        assert!(fault(&format!("{address}\ntheta=95deg")).starts_with("theta: 95deg is out of range; valid: 0deg"));
    }

    #[test]
    fn no_message_repeats_a_megabyte() {
        let (long, address) = ("x".repeat(1 << 20), of_an_angle());
        for request in [
            long.clone(),
            format!("fresnel/{long}"),
            format!("{address}/{long}"),
            format!("{address}\n{long}"),
            format!("{address}\n{long}=1"),
            format!("{address}\ntheta={long}"),
        ] {
            assert!(fault(&request).len() < 1000, "{}", fault(&request).len());
        }
    }

    #[test]
    fn a_chapter_left_out_is_not_known() {
        let fault = answer("maxwell/grid/x", &[fresnel::FIGURES]).unwrap_err();
        assert_eq!(fault.to_string(), "maxwell: no such chapter. Known: fresnel");
    }
}
