//! A scene made ready for rays: its shapes, lamps, surfaces and camera about the camera, in one unit of length.
//!
//! What is asked of it are calls, each vector code of its own: one long function of many lanes would take a compiler minutes.

use super::caustics::Caustics;
use super::lamp::{Arrival, Lamp, Piece};
use super::panorama::Panorama;
use super::patterns::Patterns;
use super::surfaces::{Met, Surfaces};
use super::{Lens, Needless, Needs};
use crate::bsdf::dispersive::Hue;
use crate::bsdf::{Rgb, Sample, grey, rgb};
use crate::geometry::{Bounds, Ends, Hit, Owners, Primitive, Ray, Settings, Structure, Surface, World, flatten};
use crate::number::{Frame, Mask, Vector, Width, exp, length_and_way, vectorised_lanes};
use crate::sampling::Row;
use crate::scene::triple::{minus, times};
use crate::scene::{Emission, Environment, Flaw, Light, Material, Scene};
use std::sync::Arc;

/// A scene made ready.
pub struct Stage<N: Width> {
    world: World<N>,
    owners: Owners,
    lens: Lens<N>,
    surfaces: Surfaces<N>,
    lamps: Vec<Lamp<N>>,
    /// What all lanes ask of what they have met: material, lamp, whether it turns, whether it shines on both sides, paint.
    shapes: Vec<[N::Scalar; 8]>,
    /// What lamps send out; by shape.
    emission: Vec<[N::Scalar; 8]>,
    environment: Option<Rgb<N>>,
    panorama: Option<Arc<Panorama>>,
    patterns: Option<Patterns>,
    max_depth: Option<u32>,
    size: [u32; 2],
    /// The angle [rad] of a filter before the camera.
    polariser: Option<f64>,
    scale: f64,
    needless: Needless,
    needs: Needs,
    caustics: Option<Caustics<N>>,
}

/// Where a path has met a shape.
pub struct Vertex<'a, N: Width> {
    /// How far the path came.
    pub distance: N,
    /// Where, and the shape's own normal.
    pub surface: Surface<N>,
    /// Where rays begin on the side that the path came from: off the surface, so that they do not meet it.
    pub start: Vector<N>,
    /// Axes about the normal that shades; z is on the side that was met, or where something gets in, outside.
    pub frame: Frame<N>,
    /// Where the path came from, along these axes.
    pub wo: Vector<N>,
    /// Of what the shape is made.
    pub met: Met<'a, N>,
    /// Which lamp it is; −1 for none.
    pub lamp: N,
    /// |cos| [1] of where the path came from to the shape's own normal.
    pub cos: N,
    /// What it sends back [W m⁻² sr⁻¹].
    pub emitted: Rgb<N>,
    /// What is left [1] of light on the way from here to where the path came from.
    pub clarity: Rgb<N>,
}

impl<N: Width> Stage<N> {
    /// Of a scene without a [`Flaw`], its rays met by a structure.
    ///
    /// # Errors
    /// If a medium is not known.
    pub fn new(scene: &Scene, structure: Structure) -> Result<Self, Flaw> {
        Self::with(scene, structure, &Needless::default())
    }

    /// The same with some work that the scene may not need.
    ///
    /// # Errors
    /// If a medium is not known.
    pub fn with(scene: &Scene, structure: Structure, needless: &Needless) -> Result<Self, Flaw> {
        let structure = if needless.hierarchy && structure == Structure::Best { Structure::Bvh } else { structure };
        let middle = scene.camera.origin;
        let flat = flatten(scene);
        let all = flat.primitives.iter().fold(Bounds::NOTHING, |all, one| all.union(&one.bounds()));
        let about = Bounds { low: minus(all.low, middle), high: minus(all.high, middle) };
        let extent = about.reach();
        // A power of two changes no digit.
        let scale = if extent > 0.0 { 2f64.powi(-(extent.log2().ceil() as i32)) } else { 1.0 };
        let flat = flat.seen_from(middle, scale);
        let patterns = Patterns::new(scene, &flat);

        let number = |name: &str| scene.materials.iter().position(|(known, _)| known == name).unwrap_or(0);
        let surfaces = Surfaces::new(scene.materials.iter().map(|(_, material)| material), scale, needless.models)?;
        let mut lamps = Vec::new();
        let (mut shapes, mut shining_out) = (Vec::new(), Vec::new());
        for (at, shape) in scene.shapes.iter().enumerate() {
            let material = number(&shape.material);
            let lamp = shape.emission.and_then(|emission| shining(flat.of_shape(at), &emission));
            let emission = shape.emission.filter(|_| lamp.is_some());
            let [red, green, blue] = emission.map_or([0.0; 3], |emission| emission.radiance);
            let flag = |holds: bool| f64::from(u8::from(holds));
            let [rho_red, rho_green, rho_blue, role] = surfaces.paint(material);
            let row = [
                material as f64,
                if lamp.is_some() { lamps.len() as f64 } else { -1.0 },
                flag(surfaces.turns(material)),
                flag(emission.is_some_and(|emission| emission.two_sided)),
                rho_red,
                rho_green,
                rho_blue,
                role,
            ];
            let number = |part: f64| N::of(part).get(0);
            shapes.push(row.map(number));
            shining_out.push([red, green, blue, 0.0, 0.0, 0.0, 0.0, 0.0].map(number));
            lamps.extend(lamp);
        }
        // Where rays end besides surfaces; nowhere if some come from infinitely far.
        let mut ends = Some(Vec::new());
        for light in &scene.lights {
            let from_middle = |place: &[f64; 3]| times(minus(*place, middle), scale);
            lamps.push(match light {
                Light::Point { position, intensity } => {
                    ends.iter_mut().for_each(|ends| ends.push(from_middle(position)));
                    Lamp::point(from_middle(position), intensity.map(|i| i * scale * scale))
                }
                Light::Directional { direction, irradiance } => {
                    ends = None;
                    Lamp::sun(length_and_way(Vector::<f64>::of(*direction)).1.lane(0), *irradiance)
                }
            });
        }
        let panorama = match &scene.environment {
            Some(Environment::Image(sky)) => Panorama::new(sky).map(Arc::new),
            _ => None,
        };
        if let Some(panorama) = &panorama {
            lamps.push(Lamp::panorama(Arc::clone(panorama)));
            ends = None;
        }
        let lens = Lens::new(&scene.camera, scene.filter, (middle, scale), needless.lens);
        let casters: Vec<Bounds> = scene
            .shapes
            .iter()
            .enumerate()
            .filter(|(_, shape)| scene.material(&shape.material).is_some_and(Material::casts))
            .map(|(at, _)| flat.of_shape(at).iter().fold(Bounds::NOTHING, |all, one| all.union(&one.bounds())))
            .collect();
        let [width, height] = [scene.camera.width, scene.camera.height];
        let caustics =
            if lens.is_plain() { Caustics::new(&lamps, &casters, 1.0, width.saturating_mul(height)) } else { None };
        if caustics.is_some() {
            // Their light is joined to the camera, which is the origin.
            ends.iter_mut().for_each(|ends| ends.push([0.0; 3]));
        }
        let ends = ends.filter(|_| !needless.walls).map_or(Ends::Anywhere, Ends::OnSurfaces);
        let world = World::with(&flat.primitives, &Settings { structure, ends });
        let needs = Needs {
            hierarchy: !world.is_brute(),
            walls: world.walls() as u32,
            light_paths: caustics.is_some(),
            ..Needs::of(scene)
        };
        let sky = match &scene.environment {
            Some(Environment::Constant(radiance)) => Some(*radiance),
            // What the image shows is added where a ray goes.
            _ => needless.sky.then_some([0.0; 3]),
        };
        Ok(Self {
            world,
            owners: flat.owners,
            lens,
            surfaces,
            lamps,
            shapes,
            emission: shining_out,
            environment: sky.map(|radiance| radiance.map(N::of)),
            panorama,
            patterns,
            max_depth: scene.max_depth,
            size: [scene.camera.width, scene.camera.height],
            polariser: scene.camera.polariser_deg.map(f64::to_radians),
            scale,
            needless: *needless,
            needs,
            caustics,
        })
    }

    /// Its units of length in a metre [m⁻¹].
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// What it occupies in memory [B], but for materials and lamps.
    pub fn bytes(&self) -> usize {
        self.world.bytes()
    }

    /// What it needs.
    pub fn needs(&self) -> &Needs {
        &self.needs
    }

    /// Whether what is left on the way is asked.
    #[inline(always)]
    pub fn absorbs(&self) -> bool {
        self.needs.absorption || self.needless.absorption
    }

    /// Whether paths may need a wavelength.
    #[inline(always)]
    pub fn disperses(&self) -> bool {
        self.needs.wavelength || self.needless.wavelengths
    }

    /// Whether pixels are looked at before there is any light ([`super::looks`]).
    pub fn is_looked_at(&self) -> bool {
        self.needs.specular || self.needs.rims || self.needless.looks
    }

    /// The camera.
    pub fn lens(&self) -> &Lens<N> {
        &self.lens
    }

    /// The paths from lamps that it asks for; None if nothing polished could cast their light on anything, or the picture is
    /// not that of a pinhole with a box filter.
    pub fn caustics(&self) -> Option<&Caustics<N>> {
        self.caustics.as_ref()
    }

    /// The most edges of a path.
    pub fn max_depth(&self) -> Option<u32> {
        self.max_depth
    }

    /// Width and height of the picture [pixels].
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The angle [rad] of an ideal polariser before the camera, from the picture's right to its up.
    pub fn polariser(&self) -> Option<f64> {
        self.polariser
    }

    /// The lamps.
    pub fn lamps(&self) -> &[Lamp<N>] {
        &self.lamps
    }

    /// Radiance from behind all shapes, where it is the same all around.
    pub fn environment(&self) -> Option<Rgb<N>> {
        self.environment
    }

    /// Whether there is an image behind all shapes, to which rays are sent as to a lamp.
    #[inline(always)]
    pub fn has_panorama(&self) -> bool {
        self.panorama.is_some()
    }

    /// What an image behind all shapes sends along rays, and the density [sr⁻¹] with which rays to it would have been sent this
    /// way; 0 where there is none, or the mask is false.
    #[inline(always)]
    pub fn panorama_along(&self, direction: Vector<N>, active: N::Mask) -> (Rgb<N>, N) {
        match &self.panorama {
            Some(panorama) => panorama.looked([direction.x, direction.y, direction.z], active),
            None => (grey(N::of(0.0)), N::of(0.0)),
        }
    }

    /// The ray through a pixel that belongs to four numbers.
    #[inline(always)]
    pub fn camera(&self, pixel: [N; 2], u: [N; 4]) -> Ray<N> {
        let [origin, direction] = self.lens.ray(pixel, u);
        Ray { origin, direction }
    }

    /// What a ray meets first; t is infinite where it meets nothing, or the mask is false.
    #[inline(never)]
    pub fn closest(&self, ray: &Ray<N>, active: N::Mask) -> Hit<N> {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.world.closest(ray, active),
        )
    }

    /// Where anything is between a ray's origin and `distance`.
    #[inline(never)]
    pub fn is_blocked(&self, ray: &Ray<N>, distance: N, active: N::Mask) -> N::Mask {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.world.is_blocked(ray, distance, active),
        )
    }

    /// What is known of a place that was met; of lanes where the mask is false, nothing that means anything.
    #[inline(never)]
    pub fn vertex(&self, ray: &Ray<N>, hit: &Hit<N>, met: N::Mask) -> Vertex<'_, N> {
        vectorised_lanes::<N, _>(
            #[inline(always)]
            || self.looked_at(ray, hit, met),
        )
    }

    #[inline(always)]
    fn looked_at(&self, ray: &Ray<N>, hit: &Hit<N>, met: N::Mask) -> Vertex<'_, N> {
        let (zero, half) = (N::of(0.0), N::of(0.5));
        let surface = self.world.surface(ray, hit);
        let row = N::columns(
            #[inline(always)]
            |lane| self.shapes[self.owners.shape(hit.primitive.place(lane))],
        );
        let [material, lamp, turns, two_sided, rho_red, rho_green, rho_blue, role] = row;
        let back = -ray.direction;
        let cos = back.dot(surface.normal);
        let is_back = cos.lt(zero);
        // A normal between those of corners may look away from who looks, where the surface itself does not.
        let agrees = (back.dot(surface.shading) * cos).gt(zero);
        let frame =
            Frame::about(Vector::select(agrees, surface.shading, surface.normal)).turned(is_back & turns.gt(half));
        let wo = frame.inward(back);
        let rho = match &self.patterns {
            None => [rho_red, rho_green, rho_blue],
            Some(patterns) => self.painted(patterns, hit, &surface, met, [rho_red, rho_green, rho_blue]),
        };
        let shines = met & lamp.ge(zero) & (!is_back | two_sided.gt(half));
        let emitted = if shines.any() { self.emitted(hit) } else { grey(zero) };
        let clarity = if self.absorbs() { self.clarity(material, wo.z.lt(zero), hit.t) } else { grey(N::of(1.0)) };
        Vertex {
            distance: hit.t,
            surface,
            start: surface.leave(back),
            frame,
            wo,
            met: self.surfaces.met(material, [rho[0], rho[1], rho[2], role]),
            lamp: N::select(shines, lamp, N::of(-1.0)),
            cos: cos.abs(),
            emitted,
            clarity,
        }
    }

    /// ρ [1] of the places that were met.
    #[inline(never)]
    fn painted(&self, patterns: &Patterns, hit: &Hit<N>, surface: &Surface<N>, met: N::Mask, plain: Rgb<N>) -> Rgb<N> {
        let shape = N::from_lanes(|lane| self.owners.shape(hit.primitive.place(lane)) as f64);
        patterns.painted(met, [shape, hit.primitive, surface.uv[0], surface.uv[1]], surface.normal, plain)
    }

    /// What the shapes that were met send out [W m⁻² sr⁻¹] if they are seen from where they shine.
    #[inline(always)]
    fn emitted(&self, hit: &Hit<N>) -> Rgb<N> {
        let [red, green, blue, ..] = N::columns(
            #[inline(always)]
            |lane| self.emission[self.owners.shape(hit.primitive.place(lane))],
        );
        [red, green, blue]
    }

    /// What is left [1] of light after a way inside what the materials enclose.
    #[inline(never)]
    fn clarity(&self, material: N, is_inside: N::Mask, distance: N) -> Rgb<N> {
        let a = N::columns(|lane| self.surfaces.absorption(material.lane(lane) as usize).map(|a| N::of(a).get(0)));
        rgb(|c| N::select(is_inside & a[c].gt(N::of(0.0)), exp(-(a[c] * distance)), N::of(1.0)))
    }

    /// The ray that leaves a vertex along a direction.
    #[inline(always)]
    pub fn leave(&self, vertex: &Vertex<'_, N>, direction: Vector<N>) -> Ray<N> {
        Ray { origin: vertex.surface.leave(direction), direction }
    }

    /// The density [sr⁻¹] with which a ray to the lamp that was met would have been sent this way; 0 where none was, or the mask
    /// is false.
    #[inline(always)]
    pub fn density_to(&self, ray: &Ray<N>, vertex: &Vertex<'_, N>, active: N::Mask) -> N {
        self.density_from(ray.origin, vertex.lamp, vertex.distance, vertex.cos, active)
    }

    /// The density [sr⁻¹] with which rays are sent from a point to a lamp that is so far away at a cosine to its normal; 0 where
    /// none is of that number, or the mask is false.
    #[inline(always)]
    pub fn density_from(&self, from: Vector<N>, lamp: N, distance: N, cos: N, active: N::Mask) -> N {
        let mut density = N::of(0.0);
        for (number, its) in self.lamps.iter().enumerate() {
            let is_it = active & (lamp - N::of(number as f64)).abs().lt(N::of(0.5));
            if is_it.any() {
                density = N::select(is_it, its.pdf(from, distance, cos), density);
            }
        }
        density
    }

    /// The ray to what arrives at a vertex, and how far it goes.
    #[inline(always)]
    pub fn towards(&self, vertex: &Vertex<'_, N>, arrival: &Arrival<N>) -> (Ray<N>, N) {
        let surface = &vertex.surface;
        let beside = (vertex.start - surface.point).dot(surface.normal);
        let is_through = (beside * arrival.wi.dot(surface.normal)).lt(N::of(0.0));
        let origin = Vector::select(is_through, surface.leave(arrival.wi), vertex.start);
        // The arrival is before the lamp; what is left is the rounding of the way, and through a surface that of its start.
        let reach = arrival.distance * N::of(1.0 - 4.0 * N::EPSILON);
        let short = (N::of(4.0) * surface.slack).only(is_through);
        (Ray { origin, direction: arrival.wi }, reach - short)
    }
}

impl<N: Width> Vertex<'_, N> {
    /// What is kept [1] of light from a lamp that has come along `wo` and is drawn to go on in a direction. It is energy: no
    /// medium squeezes it. And of a surface whose normal is not its own, what goes to a side is by the one, what there is by the
    /// other (E. Veach, *Robust Monte Carlo methods for light transport simulation* (1997), §5.3).
    #[inline(always)]
    pub fn kept(&self, drawn: &Sample<N>, direction: Vector<N>) -> Rgb<N> {
        let least = N::of(f64::from(f32::MIN_POSITIVE));
        let aside = self.surface.normal.dot(direction).abs() * self.wo.z.abs();
        let factor = aside / (drawn.compression * (drawn.wi.z.abs() * self.cos).max(least));
        rgb(|c| drawn.weight[c] * factor)
    }
}

/// One path at a time, for who reads.
impl Stage<f64> {
    /// What a ray meets.
    pub fn meet(&self, ray: &Ray<f64>) -> Option<Vertex<'_, f64>> {
        let hit = self.closest(ray, true);
        hit.t.is_finite().then(|| self.vertex(ray, &hit, true))
    }

    /// Radiance [W m⁻² sr⁻¹] from behind all shapes along a ray.
    pub fn sky(&self, ray: &Ray<f64>) -> Rgb<f64> {
        if self.has_panorama() {
            self.panorama_along(ray.direction, true).0
        } else {
            self.environment.unwrap_or_default()
        }
    }

    /// The density [sr⁻¹] with which a ray to the sky would have been sent along this one: 0 of one that is the same all around,
    /// to which none are sent.
    pub fn density_to_sky(&self, ray: &Ray<f64>) -> f64 {
        self.panorama_along(ray.direction, true).1
    }

    /// Whether nothing is in the way of what arrives at a vertex.
    pub fn sees(&self, vertex: &Vertex<'_, f64>, arrival: &Arrival<f64>) -> bool {
        let (ray, distance) = self.towards(vertex, arrival);
        !self.is_blocked(&ray, distance, true)
    }
}

impl Vertex<'_, f64> {
    /// What it sends back [W m⁻² sr⁻¹].
    pub fn emitted(&self) -> Rgb<f64> {
        if self.lamp < 0.0 { [0.0; 3] } else { self.emitted }
    }

    /// f [sr⁻¹] for light from a direction along the vertex's axes.
    pub fn f(&self, wi: Vector<f64>) -> Rgb<f64> {
        self.f_pdf(wi).0
    }

    /// f [sr⁻¹], and the density [sr⁻¹] with which [`Vertex::scatter`] draws that direction.
    pub fn f_pdf(&self, wi: Vector<f64>) -> (Rgb<f64>, f64) {
        self.met.eval_pdf(true, wi, self.wo)
    }

    /// A direction for light to come from.
    pub fn scatter(&self, u: [f64; 3]) -> Sample<f64> {
        self.met.sample(true, self.wo, u)
    }

    /// The same, where glass disperses by what the path knows of its wavelength.
    pub fn scatter_hued(&self, row: &Row<f64>, hue: &mut Hue<f64>) -> Sample<f64> {
        let drawn = self.scatter(row.surface);
        self.met.dispersed(true, self.wo, (row.surface, row.wavelength), hue, drawn)
    }
}

/// The lamp that a shape is; None if it has no area or sends out nothing.
fn shining<N: Width>(its: &[Primitive], emission: &Emission) -> Option<Lamp<N>> {
    if emission.radiance == [0.0; 3] {
        return None;
    }
    let Emission { radiance, two_sided } = *emission;
    let mut pieces = Vec::new();
    for primitive in its {
        match *primitive {
            Primitive::Sphere { center, radius } => return Some(Lamp::ball(center, radius, radiance, two_sided)),
            Primitive::Disc { center, normal, radius } => {
                let normal = length_and_way(Vector::<f64>::of(normal)).1.lane(0);
                return Some(Lamp::disc(center, normal, radius, radiance, two_sided));
            }
            Primitive::Quad { corner, edges } => pieces.push(Piece::new(corner, edges, false)),
            Primitive::Triangle { corners: [a, b, c], .. } => {
                pieces.push(Piece::new(a, [minus(b, a), minus(c, a)], true));
            }
        }
    }
    Lamp::flat(pieces, radiance, two_sided)
}
