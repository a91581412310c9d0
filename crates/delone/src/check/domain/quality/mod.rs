//! Quality: which triangles of a refined mesh break the bounds, and does anything excuse them?
//!
//! [`verify_quality`] first proves the mesh, as [`verify_domain`](super::verify_domain) does, and then
//! measures every triangle anew. It shares nothing with refinement but the types in which people say
//! what they want.
//!
//! # When a triangle is excused
//! * *Small input angle*: two segments meet at less than 60 degrees, and the triangle has their corner or
//!   its shortest edge goes from one to the other ([`corners`]). Miller, Pav and Walkington (2003) show
//!   that nothing else needs to stay. This excuses an angle, and no size: segments at any angle may be
//!   cut as short as wanted.
//! * *Locked*: one of its edges lies on a segment that must not be split; or such an edge is where its path
//!   of longest edges ends ([`paths`]), so that it hangs on an edge still longer than its own. This excuses
//!   angles and sizes, since a vertex that would help may be too close to that edge to be inserted.
//! * *Precision*: its shortest edge is below 2¹² units in the last place of its largest coordinate. This
//!   too excuses whatever is broken: there is no room for vertices.
//!
//! A triangle that breaks several bounds needs an excuse that goes for all of them.
//!
//! # Numbers
//! Shapes are measured in rounded numbers; angles, lengths and areas may miss a bound by a part in 10⁹
//! ([`SLACK`]), some million times what rounding does to them, and far less than anyone could see.
//! Which segments meet is decided exactly.
//!
//! *Cost*: that of [`verify_domain`](super::verify_domain), and 0.2 µs a triangle. An unmet triangle costs
//! as many comparisons as pairs of segments run through the ends of its shortest edge.

mod corners;
mod excuse;
mod paths;
pub(super) mod regions;
mod verdict;

pub use excuse::Excuse;
pub use verdict::{Counts, Encroached, QualityVerdict, Unmet};

use super::super::{Defects, Shape, Verifier, require_points};
use super::places::Place;
use super::{DomainMesh, DomainVerifier, Found, input};
use crate::pace::Pace;
use crate::{
    Broken, DomainRule, Error, HalfEdgeId, Locked, Phase, Point, Pslg, Quality, Seed, TriangleId,
    VertexId, Watch,
};
use excuse::Excuses;

/// The part of a bound by which a measure may miss it.
const SLACK: f64 = 1e-9;

/// What was asked of a refined mesh.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    quality: Quality,
    sizes: Option<&'a dyn Fn(Point) -> [f64; 2]>,
    locked: Locked,
    is_conforming: bool,
}

impl<'a> Asked<'a> {
    /// Takes the bounds.
    pub fn new(quality: Quality) -> Self {
        Self {
            quality,
            sizes: None,
            locked: Locked::Nothing,
            is_conforming: false,
        }
    }

    /// Adds the longest edge and the largest area that a triangle may have, given its centroid; a
    /// value that is not positive, or NaN, is no bound.
    pub fn sizes(self, sizes: &'a dyn Fn(Point) -> [f64; 2]) -> Self {
        Self {
            sizes: Some(sizes),
            ..self
        }
    }

    /// Says which edges had to stay as they were.
    pub fn locked(self, locked: Locked) -> Self {
        Self { locked, ..self }
    }

    /// Asks that no vertex that sees a subsegment lies inside its diametral circle; then all triangles
    /// are Delaunay, segments or not.
    pub fn conforming(self) -> Self {
        Self {
            is_conforming: true,
            ..self
        }
    }

    /// Tells whether the areas of regions matter.
    fn needs_regions(&self, input: &Pslg) -> bool {
        self.quality.region_areas && input.regions.iter().any(|r| r.max_area.is_some())
    }
}

/// Proves that `mesh` is a refined mesh of the domain that `rule` makes of `input`, and finds the triangles
/// that break what was asked for. Whether the mesh is [said to be refined](DomainMesh::refined) does not
/// matter.
///
/// ```
/// use delone::check::{self, Asked, DomainMesh};
/// use delone::{Angle, DomainRule, Pslg, Quality, VertexId};
///
/// let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 1.0)]);
/// input.add_ring([0, 1, 2]);
/// let triangles = [[0, 1, 2].map(VertexId::from)];
/// let mesh = DomainMesh::new(&input.points, &triangles, &input.segments);
/// let quality = Quality { min_angle: Some(Angle::degrees(30.0)), ..Quality::default() };
/// let verdict = check::verify_quality(&input, DomainRule::Carve, &mesh, &Asked::new(quality), &())?;
/// // The corner at the origin has 14 degrees, so nothing better is possible.
/// assert_eq!(verdict?.counts().small_input_angle, 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of [`verify_domain`](super::verify_domain); [`Error::BadQuality`] if a bound makes no sense; and if
/// the areas of regions matter, [`Error::SeedNotFinite`] and [`Error::SeedOnSegment`] for regions. A wrong
/// mesh is no error but [`Defects`] within, and a mesh of poor quality is a [`QualityVerdict`].
///
/// *Cost*: that of [`verify_domain`](super::verify_domain), and 0.2 µs a triangle.
pub fn verify_quality(
    input: &Pslg,
    rule: DomainRule,
    mesh: &DomainMesh,
    asked: &Asked,
    watch: &dyn Watch,
) -> Result<Result<QualityVerdict, Defects>, Error> {
    asked.quality.require()?;
    let work = super::work(input, mesh) + mesh.triangles.len() as u64;
    let mut pace = Pace::new(watch, Phase::Check, work);
    input::require(input, &mut pace)?;
    require_points(mesh.points, &mut pace)?;
    let mut seeds = input.holes.clone();
    if asked.needs_regions(input) {
        seeds.extend(region_seeds(input, &mut pace)?);
    }
    let mesh = mesh.refined();
    let verifier = DomainVerifier {
        input,
        rule,
        mesh: &mesh,
        verifier: Verifier {
            points: mesh.points,
            triangles: mesh.triangles,
            pace,
            defects: Defects::default(),
        },
    };
    let proven = verifier.everything(&seeds, |found, pace| Judge { found, asked }.judge(pace))?;
    Ok(proven.map(|(certificate, judgement)| judgement.certified(certificate)))
}

/// Lists where the seeds of regions lie.
pub(super) fn region_seeds(input: &Pslg, pace: &mut Pace) -> Result<Vec<Point>, Error> {
    for (region, &crate::Region { at, .. }) in input.regions.iter().enumerate() {
        pace.step()?;
        if !at.is_finite() {
            let seed = Seed::Region(region);
            return Err(Error::SeedNotFinite { seed, at });
        }
    }
    Ok(input.regions.iter().map(|region| region.at).collect())
}

/// What is found before there is a certificate.
struct Judgement {
    unmet: Vec<Unmet>,
    encroached: Vec<Encroached>,
    on_locked: Vec<VertexId>,
}

/// Compares a mesh that is right with what was asked for.
struct Judge<'j> {
    found: &'j Found<'j>,
    asked: &'j Asked<'j>,
}

impl Judge<'_> {
    fn judge(&self, pace: &mut Pace) -> Result<Judgement, Error> {
        let mut excuses = Excuses::new(self.found, self.asked.locked);
        let mut unmet = self.unmet(&mut excuses, pace)?;
        let key = |u: &Unmet| (u.excuse.is_some(), u.shape.min_angle());
        unmet.sort_by(|a, b| {
            let [(is_excused, angle), (other_is_excused, other)] = [a, b].map(key);
            is_excused
                .cmp(&other_is_excused)
                .then(angle.total_cmp(&other))
        });
        Ok(Judgement {
            unmet,
            encroached: match self.asked.is_conforming {
                true => self.encroached(&excuses, pace)?,
                false => Vec::new(),
            },
            on_locked: self.on_locked(&excuses, pace)?,
        })
    }

    /// Lists the triangles that break a bound.
    fn unmet(&self, excuses: &mut Excuses, pace: &mut Pace) -> Result<Vec<Unmet>, Error> {
        let areas = self.region_areas(pace)?;
        let mut unmet = Vec::new();
        for (t, &vertices) in self.found.triangles.iter().enumerate() {
            pace.step()?;
            let corners = vertices.map(|v| self.found.points[v.index()]);
            let shape = Shape::of(corners);
            let area = areas.get(t).copied().unwrap_or(f64::INFINITY);
            let broken = self.broken(corners, &shape, area);
            if broken != Broken::default() {
                unmet.push(Unmet {
                    triangle: TriangleId::new(t),
                    broken,
                    shape,
                    excuse: excuses.find(TriangleId::new(t), broken, &shape, pace)?,
                });
            }
        }
        Ok(unmet)
    }

    /// Returns the largest area that each triangle may have because of its region; nothing if no
    /// region has one.
    fn region_areas(&self, pace: &mut Pace) -> Result<Vec<f64>, Error> {
        let regions = &self.found.input.regions;
        if !self.asked.needs_regions(self.found.input) {
            return Ok(Vec::new());
        }
        let area = |region: Option<usize>| region.and_then(|r| regions[r].max_area);
        let of = regions::find(self.found, pace)?;
        Ok(of
            .into_iter()
            .map(|r| area(r).unwrap_or(f64::INFINITY))
            .collect())
    }

    /// Tells which bounds a triangle breaks.
    fn broken(&self, corners: [Point; 3], shape: &Shape, region_area: f64) -> Broken {
        let Quality {
            min_angle,
            max_edge,
            max_area,
            ..
        } = self.asked.quality;
        let bound = |bound: f64| if bound > 0.0 { bound } else { f64::INFINITY };
        let [edge, area] = match self.asked.sizes {
            Some(sizes) => sizes(centroid(corners)).map(bound),
            None => [f64::INFINITY; 2],
        };
        let edge = edge.min(max_edge.unwrap_or(f64::INFINITY));
        let area = area.min(max_area.unwrap_or(f64::INFINITY)).min(region_area);
        let longest = shape.edges.into_iter().fold(0.0, f64::max);
        Broken {
            angle: min_angle.is_some_and(|a| shape.min_angle() < a.to_degrees() * (1.0 - SLACK)),
            edge: longest > edge * (1.0 + SLACK),
            area: shape.area > area * (1.0 + SLACK),
        }
    }

    /// Lists the subsegments that see a vertex inside their diametral circle.
    fn encroached(&self, excuses: &Excuses, pace: &mut Pace) -> Result<Vec<Encroached>, Error> {
        let Found {
            points,
            adjacency,
            borders,
            ..
        } = *self.found;
        let mut encroached = Vec::new();
        for h in adjacency.half_edges() {
            pace.step()?;
            let [a, b, apex] = [adjacency.origin(h), adjacency.dest(h), adjacency.apex(h)];
            let shape = || Shape::of([apex, a, b].map(|v| points[v.index()]));
            if borders.is_constrained(h) && shape().angles[0] > 90.0 * (1.0 + SLACK) {
                encroached.push(Encroached {
                    edge: [a, b],
                    apex,
                    excuse: excuses.of_subsegment([a, b], apex),
                });
            }
        }
        encroached.sort_by_key(|e| e.excuse.is_some());
        Ok(encroached)
    }

    /// Lists the Steiner points on segments that had to stay as they were.
    fn on_locked(&self, excuses: &Excuses, pace: &mut Pace) -> Result<Vec<VertexId>, Error> {
        let Found { graph, chains, .. } = *self.found;
        let mut found = Vec::new();
        for place in self.found.added() {
            pace.step()?;
            let is_steiner = !chains.bends.is_crossing(place);
            let is_locked = |place: Place| graph.star(place).iter().any(|&d| excuses.is_locked(d));
            if is_steiner && is_locked(place) {
                found.push(graph.places.vertex(place));
            }
        }
        Ok(found)
    }
}

impl Judgement {
    fn certified(self, certificate: super::Certificate) -> QualityVerdict {
        QualityVerdict {
            certificate,
            unmet: self.unmet,
            encroached: self.encroached,
            on_locked: self.on_locked,
        }
    }
}

/// The mean of the corners, divided first so that no sum overflows.
fn centroid(corners: [Point; 3]) -> Point {
    let mean = |c: fn(&Point) -> f64| corners.iter().map(|p| c(p) / 3.0).sum();
    Point::new(mean(|p| p.x), mean(|p| p.y))
}

/// The half-edges of a triangle.
fn half_edges(triangle: usize) -> [HalfEdgeId; 3] {
    [0, 1, 2].map(|k| HalfEdgeId::new(3 * triangle + k))
}
