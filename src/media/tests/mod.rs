mod electric;
mod optics;

use super::*;

#[test]
fn names_and_aliases_are_told_apart_and_found_in_any_writing() {
    let words: Vec<_> =
        SUBSTANCES.iter().flat_map(|m| std::iter::once(m.name).chain(m.aliases.iter().copied())).collect();
    for (i, word) in words.iter().enumerate() {
        assert!(words[..i].iter().all(|other| !same(word, other)), "{word} twice");
    }
    let written = [
        ("Fused_Silica", "fused-silica"),
        ("fused silica", "fused-silica"),
        ("SiO2", "fused-silica"),
        ("glass", "glass"),
        ("borosilicate", "glass"),
        ("Sea Water", "sea-water"),
        ("Fe", "iron"),
        ("N-BK7", "bk7"),
        ("n_sf11", "sf11"),
        ("TiO2", "tio2"),
        ("Au", "gold"),
        ("AG", "silver"),
        ("Cu", "copper"),
        ("Al", "aluminium"),
        ("aluminum", "aluminium"),
        ("Cr", "chromium"),
        ("si", "silicon"),
    ];
    for (word, name) in written {
        assert_eq!(named(word).map(|known| known.name), Some(name), "{word}");
    }
    assert!(["", "-", "unobtainium", "1.5"].iter().all(|word| named(word).is_none()));
}

#[test]
fn every_name_finds_its_own_entry_and_something_is_known_of_each() {
    for known in SUBSTANCES {
        for name in std::iter::once(&known.name).chain(known.aliases) {
            assert_eq!(named(name), Some(known));
        }
        assert!(known.optics.is_some() || known.electric.is_some(), "{}", known.name);
        let sources = [known.optics.as_ref().map(|own| own.source), known.electric.as_ref().map(|own| own.source)];
        assert!(sources.iter().flatten().all(|source| !source.is_empty()), "{}", known.name);
    }
}

/// What is typed for an index and what for (ε, μ, σ): a medium may be known to one of them alone.
#[test]
fn each_view_has_its_own_names() {
    let both = ["vacuum", "air", "fused-silica", "glass", "water", "copper", "silver", "gold", "aluminium", "silicon"];
    let light = ["bk7", "sf10", "sf11", "sapphire", "diamond", "mgf2", "tio2", "ice", "chromium"];
    let circuits = ["fresh-water", "sea-water", "wet-soil", "soil", "dry-soil", "iron", "graphite"];
    let listed = |name: &str, by_light: bool, by_circuits: bool| {
        assert_eq!(optical().any(|known| known.name == name), by_light, "{name}");
        assert_eq!(electric().any(|known| known.name == name), by_circuits, "{name}");
    };
    both.iter().for_each(|name| listed(name, true, true));
    light.iter().for_each(|name| listed(name, true, false));
    circuits.iter().for_each(|name| listed(name, false, true));
    assert_eq!(SUBSTANCES.len(), both.len() + light.len() + circuits.len());
    // Light does not tell them apart; circuits know DURAN.
    let index = |name| named(name).unwrap().index(589.3e-9).unwrap();
    assert_eq!(index("glass"), index("bk7"));
}
