//! Films as bytes: what is written is read, what is damaged is refused, and nothing that is claimed is believed.

use super::bytes::{read, write};
use super::{Head, Reel};
use light::scene::builtin::BUILTIN;
use light::scene::{Geometry, Mesh, Scene};
use light::transport::film::{Film, Splats, branches};
use light::transport::kernel::Tactics;
use light::transport::simple::INTEGRATORS;
use light::transport::{Manner, Method, Needless};
use proptest::prelude::*;
use std::path::Path;
use std::sync::Arc;

/// Bytes before the text of what is told, and after it before the branches.
const FIXED: usize = 8 + 3 * 4 + 32 + 8 + 4;
const COUNTS: usize = 3 * 4;

fn written(reel: &Reel) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(&reel.head, &reel.film, &mut bytes).expect("memory takes all");
    bytes
}

fn reread(bytes: &[u8]) -> Result<Reel, String> {
    read(bytes, bytes.len() as u64)
}

/// CRC-32 as IEEE 802.3 has it, bit by bit.
fn crc(bytes: &[u8]) -> [u8; 4] {
    let mut rest = u32::MAX;
    for byte in bytes {
        rest ^= u32::from(*byte);
        for _ in 0..8 {
            rest = rest >> 1 ^ if rest & 1 == 1 { 0xEDB8_8320 } else { 0 };
        }
    }
    (!rest).to_le_bytes()
}

/// With the checksum that belongs to what they say now.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 4;
    let sum = crc(&bytes[..end]);
    bytes[end..].copy_from_slice(&sum);
    bytes
}

/// Some numbers, and now and then one that is none.
fn sum() -> impl Strategy<Value = f32> {
    prop_oneof![9 => any::<f32>(), 1 => Just(f32::NAN), 1 => Just(f32::INFINITY)]
}

fn count() -> impl Strategy<Value = i64> {
    prop_oneof![9 => any::<i64>(), 1 => Just(i64::MIN)]
}

/// Films of a few pixels and some ranges, with and without light of paths from lamps.
fn reels() -> impl Strategy<Value = Reel> {
    let size = (1_u32..4, 1_u32..3);
    let told = ("[a-zé ]{0,8}", proptest::collection::vec(("[a-z]{1,6}", "[ -~µ]{0,12}"), 0..4));
    let cuts = proptest::collection::btree_set(0_u32..40, 2..6);
    let numbers = (proptest::collection::vec(sum(), 64), proptest::collection::vec(count(), 64));
    (size, told, cuts, numbers, any::<[u8; 32]>(), 0.0..1e9, proptest::option::of(-90_i32..90)).prop_map(
        |((width, height), (name, manner), cuts, (sums, counts), scene, seconds, unit)| {
            let mut film = Film::new(width, height);
            let cuts: Vec<u32> = cuts.into_iter().collect();
            let (mut sums, mut counts) = (sums.into_iter().cycle(), counts.into_iter().cycle());
            for ends in cuts.chunks_exact(2) {
                for branch in branches(ends[0]..ends[1]) {
                    let pixels = (width * height) as usize;
                    let mut six = || [0, 1].map(|_| [0, 1, 2].map(|_| sums.next().expect("endless")));
                    let halves = (0..pixels).map(|_| six()).collect();
                    let splats = unit.map(|unit| {
                        let mut six = || [0, 1].map(|_| [0, 1, 2].map(|_| counts.next().expect("endless")));
                        Splats::of_parts(unit, (0..pixels).map(|_| six()).collect())
                    });
                    film.add_lit(branch, halves, splats).expect("new pairs");
                }
            }
            Reel { head: Head { name, scene, manner, seconds }, film }
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn what_is_written_is_read(reel in reels()) {
        let bytes = written(&reel);
        let again = reread(&bytes).expect("it was just written");
        prop_assert_eq!(&again.head, &reel.head);
        prop_assert_eq!(again.film.ranges(), reel.film.ranges());
        prop_assert_eq!(again.film.size(), reel.film.size());
        // What is no number is equal to nothing, but its bits are kept.
        let parts = |film: &Film| {
            let bits = |x: &[[f32; 3]; 2]| x.map(|half| half.map(f32::to_bits));
            let of = film.parts().map(|(pairs, sums, splats)| {
                (pairs, sums.iter().map(bits).collect::<Vec<_>>(), splats.cloned())
            });
            of.collect::<Vec<_>>()
        };
        prop_assert_eq!(parts(&again.film), parts(&reel.film));
    }

    /// CRC-32 finds every change within 32 bits.
    #[test]
    fn what_is_cut_longer_or_changed_anywhere_is_refused(reel in reels(), change in 1_u8..=255) {
        let mut bytes = written(&reel);
        for end in 0..bytes.len() {
            prop_assert!(reread(&bytes[..end]).is_err(), "cut at {}", end);
            // A file that is shorter than its system says.
            prop_assert!(read(&bytes[..end], bytes.len() as u64).is_err(), "cut at {} unseen", end);
        }
        for at in 0..bytes.len() {
            bytes[at] ^= change;
            prop_assert!(reread(&bytes).is_err(), "changed at {}", at);
            bytes[at] ^= change;
        }
        bytes.push(change);
        prop_assert!(reread(&bytes).is_err(), "longer");
    }

    /// Claims under a checksum that is right: refused, or a film no larger than the file.
    #[test]
    fn no_claim_is_believed(
        reel in reels(),
        at in any::<prop::sample::Index>(),
        claim in prop_oneof![any::<u32>(), Just(u32::MAX), Just(1 << 31), Just(0), 0_u32..64],
    ) {
        let mut bytes = written(&reel);
        let at = at.index(bytes.len() - 8);
        bytes[at..at + 4].copy_from_slice(&claim.to_le_bytes());
        let bytes = sealed(bytes);
        if let Ok(read) = reread(&bytes) {
            let held: usize = read.film.parts().map(|(_, sums, splats)| {
                24 * sums.len() + splats.map_or(0, |splats| 48 * splats.parts().1.len())
            }).sum();
            prop_assert!(held <= bytes.len(), "{} of {}", held, bytes.len());
            prop_assert!(read.film.pairs() <= super::MOST_PAIRS);
        }
    }

    #[test]
    fn no_bytes_at_all_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300), head in 0_usize..90) {
        let whole = written(&small());
        let bytes = sealed([&whole[..head.min(whole.len())], &bytes, &[0; 4]].concat());
        prop_assert!(reread(&bytes).is_err());
    }
}

/// One pixel, the samples 4 and 5.
fn small() -> Reel {
    let mut film = Film::new(1, 1);
    let splats = Splats::of_parts(-3, vec![[[1, -2, 3], [i64::MIN, 5, 1 << 40]]]);
    film.add_lit(2..3, vec![[[0.5, -1.0, 2.0], [0.0, 1.5, 3.0]]], Some(splats)).expect("new pairs");
    let manner = vec![("seed".to_owned(), "7".to_owned())];
    Reel { head: Head { name: "box".to_owned(), scene: [9; 32], manner, seconds: 1.5 }, film }
}

/// By hand, as the page has it.
#[test]
fn the_format_is_the_one_that_is_described() {
    let mut bytes = vec![0x89, b'f', b'i', b'l', b'm', 13, 10, 26];
    bytes.extend([2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
    bytes.extend([9; 32]);
    bytes.extend([0, 0, 0, 0, 0, 0, 0xF8, 0x3F]);
    bytes.extend([12, 0, 0, 0]);
    bytes.extend(b"box\nseed: 7\n");
    bytes.extend([1, 0, 0, 0, 0xFD, 0xFF, 0xFF, 0xFF, 1, 0, 0, 0]);
    bytes.extend([2, 0, 0, 0, 1, 0, 0, 0]);
    bytes.extend([0, 0, 0, 0x3F, 0, 0, 0x80, 0xBF, 0, 0, 0, 0x40, 0, 0, 0, 0, 0, 0, 0xC0, 0x3F, 0, 0, 0x40, 0x40]);
    let counts = [
        [1, 0, 0, 0, 0, 0, 0, 0],
        [0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF],
        [3, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 0, 0, 0x80],
        [5, 0, 0, 0, 0, 0, 0, 0],
        [0, 0, 0, 0, 0, 1, 0, 0],
    ];
    bytes.extend(counts.as_flattened());
    bytes.extend(crc(&bytes));
    assert_eq!(written(&small()), bytes);
    assert_eq!(reread(&bytes), Ok(small()));
    // The check value of the sum, of the catalogue of CRCs.
    assert_eq!(crc(b"123456789"), 0xCBF4_3926_u32.to_le_bytes());
}

#[test]
fn what_is_wrong_is_said() {
    let whole = written(&small());
    let changed = |at: usize, new: &[u8]| {
        let mut bytes = whole.clone();
        bytes[at..at + new.len()].copy_from_slice(new);
        sealed(bytes)
    };
    let (many, few) = (u32::MAX.to_le_bytes(), 0_u32.to_le_bytes());
    let after = FIXED + 12;
    let branch = after + COUNTS;
    for (bytes, why) in [
        (b"P6\n".to_vec(), "is no film"),
        (changed(0, b"X"), "is no film"),
        (changed(8, &1_u32.to_le_bytes()), "version 1, which is not known; valid: 2"),
        (changed(12, &few), "absurd"),
        (changed(12, &many), "172 bytes, and"),
        (changed(52, &(-1.0_f64).to_le_bytes()), "absurd"),
        (changed(52, &f64::NAN.to_le_bytes()), "absurd"),
        (changed(60, &many), "absurdly long"),
        (changed(60, &1000_u32.to_le_bytes()), "ends too early"),
        (changed(64, b"\xFF"), "a text is none"),
        (changed(64, b"\x1B"), "cannot be read"),
        (changed(after, &2_u32.to_le_bytes()), "a count is absurd"),
        (changed(after, &few), "172 bytes, and"),
        (changed(after + 8, &few), "a count is absurd"),
        (changed(after + 8, &many), "a count is absurd"),
        (changed(after + 8, &2_u32.to_le_bytes()), "172 bytes, and"),
        (changed(branch, &many), "a range is absurd"),
        (changed(branch, &(super::MOST_PAIRS).to_le_bytes()), "a range is absurd"),
        (changed(branch + 4, &few), "a range is absurd"),
        (changed(branch + 4, &3_u32.to_le_bytes()), "a range is absurd"),
        (changed(branch + 4, &4_u32.to_le_bytes()), "a range is absurd"),
        ([&whole[..100], &whole[101..]].concat(), "bytes, and"),
    ] {
        let found = reread(&bytes).expect_err(why);
        assert!(found.contains(why), "should say `{why}`: {found}");
    }
    assert_eq!(whole.len(), 172);
    let mut bytes = whole.clone();
    bytes[branch + 20] ^= 1;
    assert!(reread(&bytes).is_err_and(|why| why.contains("checksum")));
}

#[test]
fn samples_that_a_film_has_twice_are_refused() {
    let mut film = Film::new(1, 1);
    let splats = || Some(Splats::of_parts(0, vec![[[0; 3]; 2]]));
    film.add_lit(0..1, vec![[[1.0; 3]; 2]], splats()).expect("new pairs");
    film.add_lit(2..3, vec![[[1.0; 3]; 2]], splats()).expect("new pairs");
    let reel = Reel { film, ..small() };
    let mut bytes = written(&reel);
    let second = FIXED + 12 + COUNTS + 8 + 24 + 48;
    assert_eq!(bytes[second], 2);
    bytes[second] = 0;
    assert!(reread(&sealed(bytes)).is_err_and(|why| why.contains("a range is absurd")));
    // Nor is a film written that has nothing.
    assert!(write(&reel.head, &Film::new(1, 1), &mut Vec::new()).is_err());
}

#[test]
fn films_that_are_joined_took_the_time_of_both() {
    let mut film = Film::new(1, 1);
    film.add_lit(0..2, vec![[[1.0; 3]; 2]], Some(Splats::of_parts(-3, vec![[[2; 3]; 2]]))).expect("new pairs");
    let mut reel = Reel { film, ..small() };
    reel.join(Path::new("b.film"), small()).expect("other pairs");
    assert_eq!((reel.head.seconds, reel.film.pairs()), (3.0, 3));
    // Nothing has changed where nothing could be joined.
    let before = reel.clone();
    let twice = reel.join(Path::new("b.film"), small()).map_err(|stop| stop.to_string());
    assert!(twice.is_err_and(|why| why.starts_with("b.film: has samples 4..6 that")) && reel == before);
    let mut dark = Film::new(1, 1);
    dark.add(4..5, vec![[[1.0; 3]; 2]]).expect("new pairs");
    let dark = Reel { film: dark, ..small() };
    let dark = reel.join(Path::new("d.film"), dark).map_err(|stop| stop.to_string());
    assert!(dark.is_err_and(|why| why.contains("light of paths from lamps")) && reel == before);
}

fn scene(name: &str) -> Scene {
    (BUILTIN.iter().find(|builtin| builtin.name == name).expect("a scene of the lecture").make)()
}

#[test]
fn a_scene_is_known_by_all_there_is_of_it() {
    let of = |scene: &Scene| Head::new(scene, &Manner::default()).scene;
    for builtin in BUILTIN {
        let scene = (builtin.make)();
        let own = of(&scene);
        assert_eq!(own, of(&Scene { name: "other".into(), ..scene.clone() }), "{}", builtin.name);
        let mut others = vec![scene.clone(); 4];
        others[0].camera.fov_y_deg += 1e-12;
        others[1].camera.height += 1;
        others[2].camera.width += 1;
        others[3].materials.reverse();
        others[3].materials.push(scene.materials[0].clone());
        for other in others {
            assert_ne!(own, of(&other), "{}", builtin.name);
        }
    }
    // A corner of a mesh, and what file it is from.
    let meshed = |change: &dyn Fn(&mut Mesh)| {
        let mut scene = scene("mesh");
        for shape in &mut scene.shapes {
            if let Geometry::Mesh { mesh, file, .. } = &mut shape.geometry {
                let mut own = Mesh::clone(mesh);
                change(&mut own);
                (*mesh, *file) = (Arc::new(own), Some("elsewhere/any.obj".into()));
            }
        }
        of(&scene)
    };
    let own = of(&scene("mesh"));
    assert_eq!(meshed(&|_| ()), own);
    assert_ne!(meshed(&|mesh| mesh.positions[7][1] += 1e-3), own);
    assert_ne!(meshed(&|mesh| mesh.triangles[7].rotate_left(1)), own);
}

#[test]
fn films_made_otherwise_are_refused_with_what_differs() {
    let deeper =
        |scene: &Scene| Scene { max_depth: Some(scene.max_depth.map_or(3, |depth| depth + 1)), ..scene.clone() };
    let usual = Manner::default();
    let own = Reel { head: Head::new(&scene("cornell"), &usual), film: Film::new(1, 1) };
    let refuse = |scene: &Scene, manner: Manner, size| own.refuse(&Head::new(scene, &manner), size, "this run");
    let cornell = scene("cornell");
    assert_eq!(refuse(&cornell, usual, [1, 1]), None);
    assert_eq!(refuse(&cornell, Manner { needless: Needless::EVERYTHING, ..usual }, [1, 1]), None);
    let tactics = Tactics { patience: 7, ..Tactics::default() };
    for (found, words) in [
        (refuse(&scene("glass"), usual, [1, 1]), "is of the scene cornell, this run of glass"),
        (refuse(&deeper(&cornell), usual, [1, 1]), "has depth "),
        (refuse(&cornell, Manner { seed: 2, ..usual }, [1, 1]), "has seed 0, this run 2"),
        (
            refuse(&cornell, Manner { method: Method::Simple(&INTEGRATORS[0]), ..usual }, [1, 1]),
            "has integrator fast, this run ",
        ),
        (refuse(&cornell, Manner { method: Method::Fast(tactics), ..usual }, [1, 1]), "patience: 7"),
        (refuse(&cornell, usual, [2, 1]), "has 1 × 1 pixels, this run 2 × 1"),
    ] {
        assert!(found.as_ref().is_some_and(|found| found.contains(words)), "should say `{words}`: {found:?}");
    }
}
