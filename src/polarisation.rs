//! Which field lies across the plane of incidence.

/// One of the two waves that a plane structure does not mix.
///
/// The plane of incidence holds the direction of the light and the normal of what it meets. Where nothing varies along
/// z, as in [`em::Plane`](crate::em::Plane), it is the plane (x, y), and the letters name the field that has only a z
/// component, whether or not there is an interface to be incident on:
///
/// | | along z | in the plane | elsewhere |
/// |---|---|---|---|
/// | [`S`](Self::S) | E | H | TE in optics (Born & Wolf, §1.5.2), TM to z on grids (Taflove & Hagness, §3.3) |
/// | [`P`](Self::P) | H | E | TM in optics, TE to z on grids |
///
/// The two literatures use TE and TM the opposite way, so that neither word is used here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Polarisation {
    /// E across the plane of incidence (senkrecht).
    S,
    /// E in the plane of incidence (parallel), H across it.
    P,
}
