//! Files that are as they should be, small, and of every kind of what their formats can say.

use crate::film::{self, Head, Reel};
use crate::scene::gltf::tests as models;
use crate::scene::images::write_exr;
use crate::scene::tests::{WHOLE, as_json};
use crate::scene::toml;
use exr::image::{AnyChannel, AnyChannels, Encoding, FlatSamples, Layer};
use exr::prelude::{Compression, LineOrder, WritableImage};
use light::scene::Image;
use light::transport::film::{Film, Splats};
use std::io::Cursor;
use std::path::Path;

/// By libjpeg-turbo: two blocks of one colour each, one of greys in several passes, one whose colours are half as fine, and one
/// of four inks.
pub const JPEGS: [&[u8]; 4] = [
    include_bytes!("../jpeg/flat.jpg"),
    include_bytes!("../jpeg/progressive.jpg"),
    include_bytes!("../jpeg/halved.jpg"),
    include_bytes!("../jpeg/inks.jpg"),
];

const CAMERA: &str = "[camera]\norigin = [0, 0, -1]\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 4\nheight = 2\n";
pub const SKY: &str = "environment = { image = \"FILE\" }\ncamera = { origin = [0, 0, -1], target = [0, 0, 0], fov_y_deg = 40, width = 1, height = 1 }\n";
pub const WALL: &str = "[camera]\norigin = [0, 0, -1]\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 4\nheight = 2\n[materials.m]\ntype = \"diffuse\"\nreflectance = { image = \"FILE\" }\n";
pub const SKY_AND_WALL: &str = "environment = { image = \"FILE\", scale = 0.5 }\n[camera]\norigin = [0, 0, -1]\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 4\nheight = 2\n[materials.m]\ntype = \"diffuse\"\nreflectance = { image = \"FILE\" }\n";
pub const MESHES: &str = "[camera]\norigin = [0, 0, -1]\ntarget = [0, 0, 0]\nfov_y_deg = 40\nwidth = 4\nheight = 2\n[materials.m]\ntype = \"diffuse\"\nreflectance = [0.5, 0.5, 0.5]\n[materials.p]\ntype = \"diffuse\"\nreflectance = { checker = [[1, 1, 1], [0, 0, 0]] }\n[[shapes]]\ntype = \"mesh\"\nfile = \"FILE\"\nnormals = \"smooth\"\nmaterial = \"m\"\ntransform = { scale = 2, rotate_deg = [0, 90, 0] }\n[[shapes]]\ntype = \"mesh\"\nfile = \"FILE\"\nmaterial = \"p\"\n";

/// What good texts name beside them.
pub fn beside(file: &Path) -> Result<Vec<u8>, String> {
    match file.extension().and_then(|extension| extension.to_str()) {
        Some("exr") => Ok(write_exr(&image([2, 2]))),
        Some("hdr") => Ok(hdr().swap_remove(0)),
        Some("png") => Ok(png().swap_remove(0)),
        Some("jpg") => Ok(JPEGS[0].to_vec()),
        Some("ply") => Ok(ply().swap_remove(0)),
        Some("obj") => Ok(obj().swap_remove(0)),
        Some("glb") => Ok(glb().swap_remove(0)),
        Some("bin") => Ok(vec![0; 64]),
        _ => Err("is not there".to_owned()),
    }
}

fn image(size: [u32; 2]) -> Image {
    let texel = |at: u32| [at as f32 / (size[0] * size[1]) as f32, 0.5, 1.0 / (at + 1) as f32];
    Image::new(size, (0..size[0] * size[1]).map(texel).collect()).expect("as many")
}

pub fn toml() -> Vec<Vec<u8>> {
    let drawn = "[materials.a]\ntype = \"diffuse\"\nreflectance = { image = \"a.png\" }\n[materials.b]\ntype = \"rough_diffuse\"\nroughness = 0.5\nreflectance = { checker = [[0, 1, 0.5], [1, 1, 1]], scale = 3 }\n[materials.c]\ntype = \"dielectric\"\nglass = \"bk7\"\nabsorption = [0, 1, 2]\n[materials.d]\ntype = \"dielectric\"\nior = 1.5\nabbe = 40\n";
    let named = "[[shapes]]\ntype = \"mesh\"\nfile = \"a.ply\"\nnormals = \"smooth\"\nmaterial = \"a\"\n[[shapes]]\ntype = \"mesh\"\nfile = \"sub/a.obj\"\nmaterial = \"b\"\n[[shapes]]\ntype = \"mesh\"\nfile = \"a.glb\"\nmaterial = \"c\"\n[environment]\nimage = \"a.hdr\"\nscale = 2\nrotate_deg = 90\n";
    vec![WHOLE.into(), format!("{CAMERA}{drawn}{named}").into(), CAMERA.into()]
}

pub fn json() -> Vec<Vec<u8>> {
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("a text");
    toml().into_iter().map(|bytes| as_json(&toml::parse(&text(bytes)).expect("a tree")).into_bytes()).collect()
}

pub fn glb() -> Vec<Vec<u8>> {
    models::seeds().iter().map(models::Model::bytes).collect()
}

pub fn gltf() -> Vec<Vec<u8>> {
    models::seeds().iter().map(models::Model::as_text).collect()
}

/// Of every compression that is written, with single, half and whole numbers, in tiles and lines.
pub fn exr() -> Vec<Vec<u8>> {
    use exr::image::Blocks;
    use exr::prelude::Text;
    let size = exr::math::Vec2(9, 5);
    let count = size.0 * size.1;
    let singles = || FlatSamples::F32((0..count).map(|k| k as f32 / count as f32).collect());
    let halves = || {
        FlatSamples::F16(
            (0..count).map(|k| exr::prelude::f16::from_f32(0.5 + 0.25 * k as f32 / count as f32)).collect(),
        )
    };
    let kinds = [
        (Compression::Uncompressed, Blocks::ScanLines, false),
        (Compression::RLE, Blocks::ScanLines, true),
        (Compression::ZIP1, Blocks::ScanLines, false),
        (Compression::ZIP16, Blocks::Tiles(exr::math::Vec2(4, 4)), true),
        (Compression::PIZ, Blocks::ScanLines, true),
        (Compression::PXR24, Blocks::ScanLines, false),
        (Compression::B44, Blocks::ScanLines, true),
    ];
    let made = |(compression, blocks, is_half): (Compression, Blocks, bool)| {
        let channel = |name: &str| AnyChannel::new(Text::from(name), if is_half { halves() } else { singles() });
        let channels = AnyChannels::sort(["R", "G", "B"].map(channel).into_iter().collect());
        let encoding = Encoding { compression, blocks, line_order: LineOrder::Increasing };
        let whole = exr::image::Image::from_layer(Layer::new(size, Default::default(), encoding, channels));
        let mut bytes = Cursor::new(Vec::new());
        whole.write().non_parallel().to_buffered(&mut bytes).expect("into memory");
        bytes.into_inner()
    };
    kinds.into_iter().map(made).chain([write_exr(&image([3, 2]))]).collect()
}

/// By channel in runs; as plain texels, with runs of the old kind; from the bottom.
pub fn hdr() -> Vec<Vec<u8>> {
    let runs: [&[u8]; 3] = [
        b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2.0\n\n-Y 2 +X 8\n",
        &[2, 2, 0, 8, 136, 128, 8, 0, 1, 2, 3, 4, 5, 6, 7, 132, 1, 4, 2, 2, 2, 2, 136, 137],
        &[2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 130],
    ];
    let old: [&[u8]; 2] =
        [b"#?RGBE\n# by hand\nFORMAT=32-bit_rle_rgbe\n\n+Y 1 +X 8\n", &[7, 8, 9, 128, 1, 1, 1, 6, 1, 2, 3, 129]];
    vec![runs.concat(), old.concat()]
}

pub fn png() -> Vec<Vec<u8>> {
    use png::{BitDepth, ColorType};
    let made = |size: [u32; 2], colour, depth, palette: Option<&[u8]>, numbers: &[u8]| {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, size[0], size[1]);
        encoder.set_color(colour);
        encoder.set_depth(depth);
        if let Some(palette) = palette {
            encoder.set_palette(palette);
            encoder.set_trns(&[0_u8, 255][..]);
        }
        encoder.write_header().expect("into memory").write_image_data(numbers).expect("into memory");
        bytes
    };
    vec![
        made(
            [3, 2],
            ColorType::Rgb,
            BitDepth::Eight,
            None,
            &[0, 9, 77, 78, 79, 80, 255, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9],
        ),
        made([8, 2], ColorType::Indexed, BitDepth::One, Some(&[1, 2, 3, 255, 254, 253]), &[0b1010_0000, 7]),
        made([1, 2], ColorType::GrayscaleAlpha, BitDepth::Sixteen, None, &[1, 2, 3, 4, 5, 6, 7, 8]),
        made([2, 1], ColorType::Rgba, BitDepth::Eight, None, &[1, 2, 3, 4, 5, 6, 7, 8]),
        made([4, 3], ColorType::Grayscale, BitDepth::Two, None, &[0b0001_1011, 0, 255]),
    ]
}

pub fn jpeg() -> Vec<Vec<u8>> {
    JPEGS.iter().map(|bytes| bytes.to_vec()).collect()
}

pub fn ply() -> Vec<Vec<u8>> {
    let head = |format: &str, more: &str| {
        format!(
            "ply\nformat {format} 1.0\ncomment by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n{more}element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let drawn = "property float s\nproperty float t\n";
    let text = head("ascii", drawn) + "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n4 0 1 2 3\n3 0 1 2\n";
    let places = [[0.0_f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let faces: [&[i32]; 2] = [&[0, 1, 2, 3], &[2, 3, 0]];
    let mut all = vec![text.into_bytes()];
    for is_big in [false, true] {
        let turned = |mut bytes: [u8; 4]| {
            if is_big {
                bytes.reverse();
            }
            bytes
        };
        let mut bytes = head(
            if is_big { "binary_big_endian" } else { "binary_little_endian" },
            &format!("property float nx\nproperty float ny\nproperty float nz\n{drawn}"),
        )
        .into_bytes();
        for [s, t] in places {
            [s, t, 0.0, 0.0, 0.0, 1.0, s, t].iter().for_each(|x| bytes.extend(turned(x.to_le_bytes())));
        }
        for face in faces {
            bytes.push(face.len() as u8);
            face.iter().for_each(|corner| bytes.extend(turned(corner.to_le_bytes())));
        }
        all.push(bytes);
    }
    all
}

pub fn obj() -> Vec<Vec<u8>> {
    let text = "# by hand\nmtllib a.mtl\no one\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1 0\nvt 0 1\nvn 0 0 1\nusemtl m\ns off\nf 1/1/1 2/2/1 \\\n 3/3/1 4/4/1\nf -4/-4/-1 -3/-3/-1 -2/-2/-1\n";
    let plain = "v 0 0 0\nv 1e0 0 0\nv 0 +1 -0.0\nvt .5 1.\nvt 0 0\nvt 1 1\nf 1/1 2/2 3/3\n";
    vec![text.into(), plain.into()]
}

/// Of two pixels, with two branches, with and without light of paths from lamps.
pub fn film() -> Vec<Vec<u8>> {
    let made = |is_lit: bool| {
        let mut film = Film::new(2, 1);
        for pairs in [0..2, 4..5] {
            let splats = is_lit.then(|| Splats::of_parts(-3, vec![[[1, -2, 3], [4, 5, 1 << 40]]; 2]));
            film.add_lit(pairs, vec![[[0.5, -1.0, 2.0], [0.0, 1.5, 3.0]]; 2], splats).expect("new pairs");
        }
        let manner = vec![("seed".to_owned(), "7".to_owned()), ("depth".to_owned(), "unlimited".to_owned())];
        let reel = Reel { head: Head { name: "box".to_owned(), scene: [9; 32], manner, seconds: 1.5 }, film };
        let mut bytes = Vec::new();
        film::write(&reel.head, &reel.film, &mut bytes).expect("into memory");
        bytes
    };
    vec![made(false), made(true)]
}
