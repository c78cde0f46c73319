//! What a scene's surfaces are made of, as models of [`crate::bsdf`], for lanes that meet different ones.

use crate::bsdf::coated::Film;
use crate::bsdf::dispersive::{Dispersive, Hue};
use crate::bsdf::fresnel::dielectric;
use crate::bsdf::lambert::Lambert;
use crate::bsdf::{self, Bsdf, Painted, Rgb, Sample, rgb, zoo};
use crate::colour::response::BAND;
use crate::media;
use crate::number::{Mask, Vector, Width};
use crate::scene::{Coating, Energy, Facets, Flaw, Material, Metal};
use num_complex::Complex64;

/// The materials of a scene.
pub struct Surfaces<N: Width> {
    models: Vec<Model<N>>,
    /// ρ of every material, and its role: [`LAMBERT`], [`CASTER`] or [`OTHER`].
    paints: Vec<[f64; 4]>,
    /// Whether Lambert's too are asked as models.
    all_by_models: bool,
}

struct Model<N: Width> {
    asked: Asked<N>,
    /// Whether its back is like its front.
    turns: bool,
    /// Absorption inside [1 over the unit of length]; 0 for what nothing gets into.
    absorption: [f64; 3],
    is_specular: bool,
    dispersion: Option<Dispersive>,
    polished: Option<Polished>,
}

/// Who is asked of what it scatters.
enum Asked<N: Width> {
    Plain(Box<dyn Bsdf<N>>),
    /// With ρ of the place.
    Painted(Box<dyn Painted<N>>),
}

impl<N: Width> Model<N> {
    fn eval_pdf(&self, rho: Rgb<N>, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        match &self.asked {
            Asked::Plain(bsdf) => bsdf.eval_pdf(wi, wo),
            Asked::Painted(bsdf) => bsdf.painted_eval_pdf(rho, wi, wo),
        }
    }

    fn sample(&self, rho: Rgb<N>, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        match &self.asked {
            Asked::Plain(bsdf) => bsdf.sample(wo, u),
            Asked::Painted(bsdf) => bsdf.painted_sample(rho, wo, u),
        }
    }
}

/// What is polished, as far as its polarisation is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Polished {
    /// The same share [1] at every angle, phases as of a perfect conductor.
    Mirror(Rgb<f64>),
    /// n + iκ [1] over that outside, by channel.
    Metal([Complex64; 3]),
    /// n [1] inside over that outside.
    Clear(f64),
}

impl Polished {
    /// The chance [1] with which [`Met::sample`] lets light that goes to a direction of that z come through, or be reflected.
    pub fn chance(&self, z: f64, is_transmitted: bool) -> f64 {
        let Self::Clear(index) = self else { return 1.0 };
        let eta = if z < 0.0 { 1.0 / index } else { *index };
        let reflected = dielectric(z.abs().min(1.0), eta).reflectance;
        if is_transmitted { 1.0 - reflected } else { reflected }
    }
}

/// What a surface is to paths, besides its model.
const OTHER: f64 = 0.0;
/// Lambert's: light is joined to the camera there.
const LAMBERT: f64 = 1.0;
/// Rough, and still so polished that it gathers a lamp's light somewhere.
const CASTER: f64 = 2.0;

/// The largest roughness [1] that does: what rougher ones send on is spread so wide that chance finds it.
const GATHERS: f64 = 0.25;

impl Material {
    /// The model's name in the [`zoo`], and what it is made from.
    ///
    /// # Errors
    /// If there is no such metal, or no such medium of a film.
    pub fn model(&self) -> Result<(&'static str, bsdf::Setting), Flaw> {
        let plain = bsdf::Setting::default();
        let faceted = |facets: &Facets| bsdf::Setting { alpha: facets.alpha, slopes: facets.slopes, ..plain };
        Ok(match self {
            Self::Diffuse { reflectance } => ("lambert", bsdf::Setting { albedo: *reflectance, ..plain }),
            Self::RoughDiffuse { reflectance, roughness } => {
                ("eon", bsdf::Setting { albedo: *reflectance, roughness: *roughness, ..plain })
            }
            Self::Mirror { reflectance } => ("mirror", bsdf::Setting { albedo: *reflectance, ..plain }),
            Self::Conductor { metal, coating } => {
                let film = coating.as_ref().map(|coating| coating.film(1.0)).transpose()?;
                ("conductor", bsdf::Setting { metal: metal.indices()?, film, ..plain })
            }
            Self::RoughConductor { metal, facets, masking, energy, coating } => {
                let name = match energy {
                    Energy::Compensated => "conductor-compensated",
                    Energy::Single => "rough-conductor",
                    Energy::Walk => "conductor-walk",
                };
                let film = coating.as_ref().map(|coating| coating.film(1.0)).transpose()?;
                (name, bsdf::Setting { metal: metal.indices()?, joint: *masking, film, ..faceted(facets) })
            }
            Self::Dielectric { ior, outside, coating, .. } => {
                let film = coating.as_ref().map(|coating| coating.film(*outside)).transpose()?;
                ("dielectric", bsdf::Setting { index: ior / outside, film, ..plain })
            }
            Self::Dispersive { .. } => {
                // What looks at no wavelength takes it for glass of one index.
                let index = self.dispersion()?.map_or(plain.index, |glass| glass.middle());
                ("dielectric", bsdf::Setting { index, ..plain })
            }
            Self::RoughDielectric { ior, outside, facets, energy, .. } => {
                let name = match energy {
                    Energy::Compensated => "dielectric-compensated",
                    Energy::Single => "rough-dielectric",
                    Energy::Walk => "dielectric-walk",
                };
                (name, bsdf::Setting { index: ior / outside, ..faceted(facets) })
            }
            Self::Plastic { ior, reflectance, alpha } => {
                let name = if alpha.is_some() { "rough-plastic" } else { "plastic" };
                let alpha = alpha.map_or(plain.alpha, |alpha| [alpha; 2]);
                (name, bsdf::Setting { index: *ior, albedo: *reflectance, alpha, ..plain })
            }
            Self::Patterned { of, .. } => return of.model(),
        })
    }

    /// Absorption [m⁻¹] inside what it encloses.
    pub fn absorption(&self) -> [f64; 3] {
        match self {
            Self::Dielectric { absorption, .. }
            | Self::Dispersive { absorption, .. }
            | Self::RoughDielectric { absorption, .. } => *absorption,
            _ => [0.0; 3],
        }
    }

    /// Whether light gets into it.
    pub fn is_clear(&self) -> bool {
        matches!(self, Self::Dielectric { .. } | Self::Dispersive { .. } | Self::RoughDielectric { .. })
    }

    /// Whether its index depends on the wavelength.
    pub fn disperses(&self) -> bool {
        matches!(self, Self::Dispersive { .. })
    }

    /// What it does to wavelengths, if it disperses.
    ///
    /// # Errors
    /// If there is no medium of that name, or it is not known at all wavelengths that are seen.
    pub fn dispersion(&self) -> Result<Option<Dispersive>, Flaw> {
        let Self::Dispersive { glass, outside, .. } = self else { return Ok(None) };
        for end in BAND {
            glass.index(end)?;
        }
        // Between the ends of the band it is known as well.
        Ok(Some(Dispersive::new(|wavelength| glass.index(wavelength).unwrap_or(1.0) / outside)))
    }

    /// What it is if it is polished and bare.
    ///
    /// # Errors
    /// If there is no such metal.
    pub fn polished(&self) -> Result<Option<Polished>, Flaw> {
        Ok(match self {
            Self::Mirror { reflectance } => Some(Polished::Mirror(*reflectance)),
            Self::Conductor { metal, coating: None } => Some(Polished::Metal(metal.indices()?)),
            Self::Dielectric { ior, outside, coating: None, .. } => Some(Polished::Clear(ior / outside)),
            _ => None,
        })
    }

    /// Whether it is known what it does to polarised light: what is matt forgets it.
    pub fn is_polarising(&self) -> bool {
        let is_matt = matches!(self.base(), Self::Diffuse { .. } | Self::RoughDiffuse { .. });
        is_matt || self.polished().is_ok_and(|polished| polished.is_some())
    }

    /// Whether any of its light has no choice of where to go.
    pub fn is_specular(&self) -> bool {
        match self.base() {
            Self::Mirror { .. } | Self::Conductor { .. } | Self::Dielectric { .. } | Self::Dispersive { .. } => true,
            Self::Plastic { alpha, .. } => alpha.is_none(),
            _ => false,
        }
    }

    /// Whether it casts a lamp's light, gathered, on what is matt.
    pub fn casts(&self) -> bool {
        self.is_specular() || self.is_rough_caster()
    }

    /// Whether it does so although it is rough. A walk does not know its density.
    pub fn is_rough_caster(&self) -> bool {
        match self {
            Self::RoughConductor { facets, energy, .. } | Self::RoughDielectric { facets, energy, .. } => {
                *energy != Energy::Walk && facets.alpha.iter().all(|alpha| *alpha <= GATHERS)
            }
            _ => false,
        }
    }
}

impl Metal {
    /// n + iκ [1] by channel.
    ///
    /// # Errors
    /// If there is no metal of that name, or it is not known for light.
    pub fn indices(&self) -> Result<[Complex64; 3], Flaw> {
        match self {
            Self::Indices { eta, k } => Ok(std::array::from_fn(|c| Complex64::new(eta[c], k[c]))),
            Self::Named(name) => colour(name).map_err(|why| Flaw::of("metal", why)),
        }
    }
}

impl Coating {
    /// The film beside a medium of an index [1].
    ///
    /// # Errors
    /// If there is no medium of that name, or it is not known for light.
    pub fn film(&self, outside: f64) -> Result<Film, Flaw> {
        let index = colour(&self.medium).map_err(|why| Flaw::of("medium", why).within("coating"))?;
        Ok(Film { index: index.map(|index| index / outside), thickness: self.thickness_nm * 1e-9 * outside })
    }
}

/// The indices n + iκ [1] of a medium by channel.
fn colour(name: &str) -> Result<[Complex64; 3], String> {
    let medium = media::named(name).ok_or_else(|| format!("`{name}` is no known medium"))?;
    medium.colour().map_err(|error| error.to_string())
}

impl<N: Width> Surfaces<N> {
    /// Of a scene's materials, in a unit of length of which `scale` make a metre. If `all_by_models`, no model is done without.
    ///
    /// # Errors
    /// If one names a medium that there is not.
    pub fn new<'a>(
        materials: impl IntoIterator<Item = &'a Material>,
        scale: f64,
        all_by_models: bool,
    ) -> Result<Self, Flaw> {
        let zoo = zoo::<N>();
        let (mut models, mut paints) = (Vec::new(), Vec::new());
        for material in materials {
            let (name, setting) = material.model()?;
            let entry = zoo.iter().find(|entry| entry.name == name).expect("a model of the zoo");
            let painted = material.pattern().and_then(|_| entry.make_painted(&setting));
            models.push(Model {
                asked: painted.map_or_else(|| Asked::Plain(entry.make(&setting)), Asked::Painted),
                turns: !material.is_clear() && !matches!(material.base(), Material::Plastic { .. }),
                absorption: material.absorption().map(|a| a / scale),
                is_specular: material.is_specular(),
                dispersion: material.dispersion()?,
                polished: material.polished()?,
            });
            let role = match material.base() {
                Material::Diffuse { .. } => LAMBERT,
                _ if material.is_rough_caster() => CASTER,
                _ => OTHER,
            };
            let [red, green, blue] = setting.albedo;
            paints.push([red, green, blue, role]);
        }
        Ok(Self { models, paints, all_by_models })
    }

    /// Whether the back of a material is like its front, 1 or 0.
    pub fn turns(&self, material: usize) -> bool {
        self.models[material].turns
    }

    /// Absorption [1 over the unit of length] inside what a material encloses.
    pub fn absorption(&self, material: usize) -> [f64; 3] {
        self.models[material].absorption
    }

    /// ρ [1] of a material, and its role as [`Surfaces::met`] takes it.
    pub fn paint(&self, material: usize) -> [f64; 4] {
        self.paints[material]
    }

    /// What each lane has met, by the number of its material and its [`Surfaces::paint`], with ρ of the place where it has a pattern.
    #[inline(always)]
    pub fn met(&self, material: N, [red, green, blue, role]: [N; 4]) -> Met<'_, N> {
        let paint = Lambert { albedo: [red, green, blue] };
        let is_lambert = (role - N::of(LAMBERT)).abs().lt(N::of(0.5));
        let is_rough_caster = role.gt(N::of(CASTER - 0.5));
        let is_plain = if self.all_by_models { N::Mask::of(false) } else { is_lambert };
        Met { models: &self.models, material, paint, is_lambert, is_rough_caster, is_plain }
    }
}

/// A material a lane.
pub struct Met<'a, N: Width> {
    models: &'a [Model<N>],
    material: N,
    /// All that are Lambert's at once, each of its own colour; and the ρ of whatever has a pattern.
    paint: Lambert<N>,
    is_lambert: N::Mask,
    is_rough_caster: N::Mask,
    /// Where that is known to be enough.
    is_plain: N::Mask,
}

impl<N: Width> Met<'_, N> {
    /// Where it is Lambert's.
    #[inline(always)]
    pub fn is_lambert(&self) -> N::Mask {
        self.is_lambert
    }

    /// Where it is rough and casts light ([`Material::is_rough_caster`]).
    #[inline(always)]
    pub fn is_rough_caster(&self) -> N::Mask {
        self.is_rough_caster
    }

    /// ρ [1] where it is Lambert's.
    #[inline(always)]
    pub fn paint(&self) -> Rgb<N> {
        self.paint.albedo
    }

    /// Whether any of the light of what a lane has met has no choice of where to go.
    pub fn is_specular(&self, lane: usize) -> bool {
        self.models[self.material.place(lane)].is_specular
    }

    /// What the first lane has met, if it is polished and bare.
    pub fn polished(&self) -> Option<&Polished> {
        self.models[self.material.place(0)].polished.as_ref()
    }

    /// f [sr⁻¹] and the density [sr⁻¹], 0 where the mask is false.
    #[inline(always)]
    pub fn eval_pdf(&self, active: N::Mask, wi: Vector<N>, wo: Vector<N>) -> (Rgb<N>, N) {
        let (f, pdf) = self.paint.eval_pdf(wi, wo);
        let lambert = active & self.is_plain;
        let mut found = (rgb(|c| f[c].only(lambert)), pdf.only(lambert));
        self.others(active, |mask, model| {
            let (f, pdf) = model.eval_pdf(self.paint.albedo, wi, wo);
            found = (rgb(|c| N::select(mask, f[c], found.0[c])), N::select(mask, pdf, found.1));
        });
        found
    }

    /// A direction for light that goes to `wo` to come from, none where the mask is false.
    #[inline(always)]
    pub fn sample(&self, active: N::Mask, wo: Vector<N>, u: [N; 3]) -> Sample<N> {
        let mut found = Sample::select(active & self.is_plain, self.paint.sample(wo, u), Sample::none(wo));
        self.others(active, |mask, model| {
            found = Sample::select(mask, model.sample(self.paint.albedo, wo, u), found);
        });
        found
    }

    /// What [`Met::sample`] has drawn, but where glass disperses, by what the path knows of its wavelength, and by a number for
    /// one where it needs it.
    #[inline(never)]
    pub fn dispersed(
        &self,
        active: N::Mask,
        wo: Vector<N>,
        (u, number): ([N; 3], N),
        hue: &mut Hue<N>,
        drawn: Sample<N>,
    ) -> Sample<N> {
        let mut found = drawn;
        let mut left = active & !self.is_plain;
        while let Some(lane) = left.lanes().next() {
            let same = left & (self.material - N::all(self.material.get(lane))).abs().lt(N::of(0.5));
            if let Some(glass) = &self.models[self.material.place(lane)].dispersion {
                let (sample, known) = glass.sample(same, wo, u, number, *hue);
                found = Sample::select(same, sample, found);
                *hue = Hue::select(same, known, *hue);
            }
            left = left & !same;
        }
        found
    }

    /// Each other model among the lanes once, and whose it is.
    #[inline(always)]
    fn others(&self, active: N::Mask, mut use_of: impl FnMut(N::Mask, &Model<N>)) {
        let mut left = active & !self.is_plain;
        if !left.any() {
            return;
        }
        while let Some(lane) = left.lanes().next() {
            let number = self.material.get(lane);
            let same = left & (self.material - N::all(number)).abs().lt(N::of(0.5));
            use_of(same, &self.models[self.material.place(lane)]);
            left = left & !same;
        }
    }
}
