//! Domains: is this *the* constrained Delaunay triangulation of what a user drew?
//!
//! [`verify_domain`] compares a claimed mesh with the input itself, points, segments, holes and rule,
//! and trusts nothing else; like [`verify`](super::verify) it shares the predicates, and only them,
//! with the builders.
//!
//! # What is tested
//! 1. The points are those of the input, followed by added ones that are new.
//! 2. Triangles are strictly counter-clockwise; an edge has one, or two that run through it in
//!    opposite directions; of equal points at most one is a corner.
//! 3. The *graph*, subsegments and under [`DomainRule::Hull`] the edges of the convex hull, is planar:
//!    edges share ends only, and no point lies inside one ([`sweep`]).
//! 4. Every segment is a chain of subsegments, near to it as rounding demands ([`drift`]), bent only
//!    where segments cross or have crossed ([`bends`]); every subsegment is part of a segment; every
//!    added vertex lies where two cross ([`chains`]).
//! 5. The faces of the graph ([`faces`]) that the rule takes in ([`rule`]), less those with a hole's
//!    seed ([`area`]), are the domain. A triangle lies to the left of a dart of the graph if and only
//!    if the domain does; an edge with one triangle is an edge of the graph ([`cover`]).
//! 6. Every point in the domain or on its boundary is a corner, or equal to one.
//! 7. Every edge that has two triangles and is no subsegment is locally Delaunay under the symbolic
//!    perturbation.
//!
//! # Why that is enough
//! *Domain.* By 3 the graph cuts the plane into faces; triangulation plays no part in them. A segment
//! separates what its chain does, by 4. All rules speak of what cannot be reached, or only by so many
//! crossings, without crossing segments: of faces. With the hull in the graph that holds for
//! [`DomainRule::Hull`] too, whose flood from a seed ends at the hull: what segments leave of the
//! hull falls into faces. (If all points lie on one line, the hull encloses none.)
//!
//! *Cover.* Let p lie on no edge. The number of triangles that contain p is the sum of their winding
//! numbers around p, in which edges with two triangles cancel. What is left are the half-edges without
//! twin; by 5 they are the darts with the domain to their left and not to their right. The winding
//! numbers of those around p sum up to that of the boundaries of the domain's faces, since darts with
//! the domain on both sides cancel: one if p lies in the domain, else zero. So triangles cover the
//! domain once and nothing else. No triangles at all are right just if no dart has the domain to
//! its left, that is if the domain is empty: every face but the outer one is bounded by darts.
//!
//! *Constraints.* A subsegment with the domain on both sides has, by 5, triangles on both sides: it is
//! an edge. By 6 no vertex lies inside a triangle or an edge, for its own triangles would overlap
//! those around it, or it would lie inside an edge of the graph.
//!
//! *Delaunay.* Cut the domain along the subsegments. By 7 every other edge is locally Delaunay, and
//! a triangulation with all constrained edges for which that holds is the constrained Delaunay
//! triangulation (Lee and Lin 1986); under the perturbation there is one only.
//!
//! *Cost*: O((n + m) log (n + m)) for n points and m subsegments, some 2 s for a million of each;
//! memory about 150 bytes a point and 40 a triangle. Where the plane or the segments turn out wrong,
//! there is no domain to compare with, and the verification ends.
//!
//! # Refined meshes
//! A mesh that is [said to be refined](DomainMesh::refined) may have vertices that nobody drew, as long as
//! triangles have them: inside the domain on no subsegment, or on the chain of a segment, near to it
//! as repeated rounding demands ([`drift`]), which is the one other reason for it to bend. Under
//! [`DomainRule::Hull`] the hull is then split and rounded like any segment: the edges of the *input's*
//! hull are segments, and the domain is what their chains enclose. All else stays proven as above.
//!
//! [`verify_domain`] does not look at regions, [`verify_regions`] does; neither checks that added vertices are rounded correctly. The seed of a hole
//! that lies within the drift of a segment may be found on its other side.

mod area;
mod bends;
mod chains;
mod claim;
mod cover;
mod drift;
mod edges;
mod faces;
mod found;
mod graph;
mod input;
mod places;
mod planar;
mod quality;
mod regional;
mod rule;
mod sort;
mod sweep;
mod union;

use super::certificate::DomainNumbers;
pub use claim::DomainMesh;
pub use drift::{CROSSING_DRIFT, STEINER_DRIFT};
pub(super) use planar::{Meeting, find_meeting};
pub use quality::{Asked, Counts, Encroached, Excuse, QualityVerdict, Unmet, verify_quality};
pub use regional::verify_regions;

use super::{Certificate, Corner, Defect, Defects, Verdict, Verifier, adjacency, require_points};
use crate::pace::Pace;
use crate::{DomainRule, Error, Phase, Point, Pslg, VertexId, Watch};
use adjacency::Adjacency;
use area::Area;
use chains::Chains;
use cover::Borders;
use found::Found;
use graph::{Dart, Graph};
use places::{Place, Places};
use std::borrow::Cow;
use sweep::{Below, Conflict};

/// Decides whether `mesh` is the canonical constrained Delaunay triangulation of the domain that
/// `rule` makes of `input`.
///
/// Triangles and subsegments may come in any order, rotation and direction. Of several equal points
/// any one may be the corner, but only one.
///
/// ```
/// use delone::check::{self, DomainMesh};
/// use delone::{DomainRule, Pslg, VertexId};
///
/// let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0), (1.0, 9.0)]);
/// input.add_ring([0, 1, 2]);
/// let triangles = [[0, 1, 2].map(VertexId::from)];
/// let mesh = DomainMesh::new(&input.points, &triangles, &input.segments);
/// let verdict = check::verify_domain(&input, DomainRule::Carve, &mesh, &())?;
/// let domain = verdict.into_result()?.domain.expect("numbers");
/// assert_eq!((domain.components, domain.carved), (1, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// What is wrong with the input, as the builder says it: [`Error::NotFinite`] (for added points too),
/// [`Error::TooManyPoints`], [`Error::BadSegment`], [`Error::TooManySegments`], [`Error::BadPolygon`],
/// [`Error::OpenPolygon`] (where it matters), [`Error::SeedNotFinite`] and [`Error::SeedOnSegment`] for holes; and
/// [`Error::Cancelled`] if `watch` asks for it. A wrong mesh is no error but [`Verdict::Wrong`].
///
/// *Cost*: O(n log n) for n points and subsegments; a few seconds for a million on one thread.
pub fn verify_domain(
    input: &Pslg,
    rule: DomainRule,
    mesh: &DomainMesh,
    watch: &dyn Watch,
) -> Result<Verdict, Error> {
    let mut pace = Pace::new(watch, Phase::Check, work(input, mesh));
    input::require(input, &mut pace)?;
    require_points(mesh.points, &mut pace)?;
    let verifier = Verifier {
        points: mesh.points,
        triangles: mesh.triangles,
        pace,
        defects: Defects::default(),
    };
    let verifier = DomainVerifier {
        input,
        rule,
        mesh,
        verifier,
    };
    Ok(match verifier.everything(&input.holes, |_, _| Ok(()))? {
        Ok((certificate, ())) => Verdict::Right(certificate),
        Err(defects) => Verdict::Wrong(defects),
    })
}

/// Estimates the steps of a verification without defects.
fn work(input: &Pslg, mesh: &DomainMesh) -> u64 {
    let [points, triangles, subsegments] = [
        mesh.points.len(),
        mesh.triangles.len(),
        mesh.subsegments.len(),
    ]
    .map(|n| n as u64);
    let sorting = |n: u64| n * u64::from(n.max(1).ilog2().saturating_sub(9));
    let per_triangle = 4 + 3 * 3 + adjacency::STEPS_PER_TRIANGLE;
    let per_segment = 3 * input.segments.len() as u64;
    12 * points
        + sorting(points)
        + 25 * subsegments
        + sorting(subsegments)
        + per_segment
        + per_triangle * triangles
}

/// One verification under way.
struct DomainVerifier<'v, 'm> {
    input: &'v Pslg,
    rule: DomainRule,
    mesh: &'v DomainMesh<'m>,
    verifier: Verifier<'v>,
}

impl<'v> DomainVerifier<'v, '_> {
    /// Verifies everything, finding out where `seeds` lie, and if all is right, lets `judge` look at it.
    fn everything<T>(
        mut self,
        seeds: &[Point],
        judge: impl FnOnce(&Found, &mut Pace<'v>) -> Result<T, Error>,
    ) -> Result<Result<(Certificate, T), Defects>, Error> {
        self.check_ids()?;
        if self.is_wrong() {
            // Without corners and ends there is nothing to speak of.
            return Ok(Err(self.verifier.defects));
        }
        let places = Places::find(self.mesh.points, &mut self.verifier.pace)?;
        if self.rule == DomainRule::EvenOdd {
            input::require_closed(self.input, &places, &mut self.verifier.pace)?;
        }
        let corners = self.check_places(&places)?;
        let graph = self.graph(&places)?;
        let (adjacency, borders) = self.check_triangles(&graph)?;
        let Some(below) = self.check_plane(&graph, seeds)? else {
            return Ok(Err(self.verifier.defects));
        };
        let segments = self.segments(&places)?;
        let Some(chains) = self.check_chains(&graph, &segments, &corners)? else {
            return Ok(Err(self.verifier.defects));
        };
        let area = self.area(&graph, &below, &chains)?;
        borders.check(&mut self.verifier, &graph, &area, &self.input.holes)?;
        self.check_presence(&graph, &below, &area, &corners)?;
        if self.is_wrong() {
            return Ok(Err(self.verifier.defects));
        }
        let found = Found {
            input: self.input,
            points: self.mesh.points,
            triangles: self.mesh.triangles,
            segments: &segments,
            graph: &graph,
            chains: &chains,
            area: &area,
            adjacency: &adjacency,
            borders: &borders,
        };
        let judgement = judge(&found, &mut self.verifier.pace)?;
        let numbers = self.numbers(&found, &corners)?;
        let vertices = places.len();
        let edges = (3 * self.mesh.triangles.len() + borders.count()) / 2;
        let certificate = self
            .verifier
            .certificate(vertices, edges, borders.count())?;
        Ok(Ok((certificate.of_domain(numbers), judgement)))
    }

    fn is_wrong(&self) -> bool {
        !self.verifier.defects.is_empty()
    }

    /// Requires the points of the input, and corners and ends among them.
    fn check_ids(&mut self) -> Result<(), Error> {
        let (given, expected) = (self.mesh.points.len(), self.input.points.len());
        if given < expected {
            let defect = Defect::TooFewPoints { given, expected };
            self.verifier.defects.push(defect);
            return Ok(());
        }
        for (v, &expected) in self.input.points.iter().enumerate() {
            self.verifier.pace.step()?;
            let corner = self.verifier.corner(VertexId::new(v));
            if corner.at != expected {
                let defect = Defect::MovedPoint { corner, expected };
                self.verifier.defects.push(defect);
            }
        }
        self.verifier.check_corners()?;
        let Verifier { pace, defects, .. } = &mut self.verifier;
        edges::check_ends(self.mesh.points, self.mesh.subsegments, pace, defects)
    }

    /// Requires one corner a place, and added points at places of their own; returns the places that
    /// are corners.
    fn check_places(&mut self, places: &Places) -> Result<Vec<bool>, Error> {
        let points = self.mesh.points.len();
        for v in (self.input.points.len()..points).map(VertexId::new) {
            self.verifier.pace.step()?;
            let [added, first] = [v, places.vertex(places.of(v))].map(|v| self.verifier.corner(v));
            if first != added {
                self.verifier.defects.push(Defect::NotNew { added, first });
            }
        }
        let mut corners: Vec<Option<VertexId>> = vec![None; places.len()];
        for &v in self.mesh.triangles.as_flattened() {
            self.verifier.pace.step()?;
            let first = *corners[places.of(v) as usize].get_or_insert(v);
            if first != v {
                let corners = [first.min(v), first.max(v)].map(|v| self.verifier.corner(v));
                self.verifier
                    .defects
                    .push(Defect::SharedPosition { corners });
            }
        }
        Ok(corners.iter().map(Option::is_some).collect())
    }

    fn graph<'p>(&mut self, places: &'p Places<'p>) -> Result<Graph<'p>, Error> {
        let pace = &mut self.verifier.pace;
        let with_hull = self.rule == DomainRule::Hull && !self.mesh.is_refined;
        let (edges, repeated) = edges::collect(places, self.mesh.subsegments, with_hull, pace)?;
        for ends in repeated {
            let edge = ends.map(|end| places.corner(end));
            self.verifier
                .defects
                .push(Defect::RepeatedSubsegment { edge });
        }
        Graph::new(places, edges, &mut self.verifier.pace)
    }

    /// Tests triangles and the edges between them.
    fn check_triangles(&mut self, graph: &Graph) -> Result<(Adjacency<'v>, Borders), Error> {
        let verifier = &mut self.verifier;
        let upright = verifier.check_orientations()?;
        let Verifier { pace, defects, .. } = verifier;
        let adjacency = Adjacency::find(self.mesh.points, self.mesh.triangles, pace, defects)?;
        let borders = Borders::find(verifier, graph, &adjacency)?;
        verifier.check_edges(&adjacency, &upright, |h| borders.is_constrained(h))?;
        Ok((adjacency, borders))
    }

    /// Tests whether the graph is planar, and finds out what lies where.
    fn check_plane(&mut self, graph: &Graph, seeds: &[Point]) -> Result<Option<Below>, Error> {
        let found = sweep::sweep(graph, seeds, &mut self.verifier.pace)?;
        let edge = |edge: usize| graph.corners(Dart::rightward(edge));
        let conflict = match found {
            Ok(below) => return Ok(Some(below)),
            Err(conflict) => conflict,
        };
        self.verifier.defects.push(match conflict {
            Conflict::Edges(edges) => Defect::CrossingSubsegments {
                edges: edges.map(edge),
            },
            Conflict::Place(place, inside) => Defect::VertexOnSubsegment {
                corner: graph.places.corner(place),
                edge: edge(inside),
            },
        });
        Ok(None)
    }

    /// Lists the segments of the input, and behind them those that make its hull.
    fn segments(&mut self, places: &Places) -> Result<Cow<'v, [[VertexId; 2]]>, Error> {
        let segments = &self.input.segments[..];
        if self.rule != DomainRule::Hull || !self.mesh.is_refined {
            return Ok(segments.into());
        }
        let num_points = self.input.points.len();
        let hull = edges::hull_segments(places, num_points, &mut self.verifier.pace)?;
        Ok([segments, &hull].concat().into())
    }

    /// Tests segments and added vertices; where they are wrong, there is no domain to speak of.
    fn check_chains(
        &mut self,
        graph: &Graph,
        segments: &[[VertexId; 2]],
        corners: &[bool],
    ) -> Result<Option<Chains>, Error> {
        let (mesh, input) = (self.mesh, self.input);
        let pace = &mut self.verifier.pace;
        let claimed = |segment| mesh.chains.map(|chains| chains(segment));
        let drawn = input.segments.len();
        let chains = Chains::find(graph, segments, drawn, &claimed, mesh.is_refined, pace)?;
        let is_steiner = |place: Place| {
            mesh.is_refined && graph.places.vertex(place).index() >= input.points.len()
        };
        let corner = |place: Place| graph.places.corner(place);
        let ends = |segment: usize| segments[segment].map(|v| Corner::new(self.mesh.points, v));
        let defects = &mut self.verifier.defects;
        let before = defects.total();
        for &(segment, reached) in &chains.broken {
            defects.push(Defect::BrokenChain {
                segment,
                ends: ends(segment),
                reached: corner(reached),
            });
        }
        for (segment, place) in chains.bends.unfounded(is_steiner) {
            defects.push(Defect::BentChain {
                segment,
                ends: ends(segment),
                corner: corner(place),
            });
        }
        for edge in chains.stray(graph) {
            let edge = graph.corners(Dart::rightward(edge));
            defects.push(Defect::StraySubsegment { edge });
        }
        self.check_added(graph, &chains, corners)?;
        let is_right = self.verifier.defects.total() == before;
        Ok(is_right.then_some(chains))
    }

    /// Requires a reason for every added vertex: that segments cross there, or that the mesh is refined
    /// and triangles have it.
    fn check_added(
        &mut self,
        graph: &Graph,
        chains: &Chains,
        corners: &[bool],
    ) -> Result<(), Error> {
        for v in (self.input.points.len()..self.mesh.points.len()).map(VertexId::new) {
            self.verifier.pace.step()?;
            let place = graph.places.of(v);
            if chains.bends.is_crossing(place) {
                continue;
            }
            let corner = self.verifier.corner(v);
            let is_used = corners[place as usize];
            self.verifier.defects.push(match self.mesh.is_refined {
                true if is_used => continue,
                true => Defect::UnusedVertex { corner },
                false => Defect::NeedlessVertex { corner },
            });
        }
        Ok(())
    }

    fn area(&mut self, graph: &Graph, below: &Below, chains: &Chains) -> Result<Area, Error> {
        let pace = &mut self.verifier.pace;
        Area::find(self.input, self.rule, graph, below, chains, pace)
    }

    /// Requires all places in the domain and on its boundary to be corners.
    fn check_presence(
        &mut self,
        graph: &Graph,
        below: &Below,
        area: &Area,
        corners: &[bool],
    ) -> Result<(), Error> {
        for place in graph.places.all() {
            self.verifier.pace.step()?;
            if !corners[place as usize] && area.touches(graph, below, place) {
                let corner = graph.places.corner(place);
                self.verifier.defects.push(Defect::MissingPoint { corner });
            }
        }
        Ok(())
    }

    fn numbers(&mut self, found: &Found, corners: &[bool]) -> Result<DomainNumbers, Error> {
        let Found { graph, area, .. } = *found;
        let [components, holes] = area.count_parts(graph, &mut self.verifier.pace)?;
        let steiner = |on_segment: bool| {
            let bends = &found.chains.bends;
            let places = found.added().filter(|&place| !bends.is_crossing(place));
            places.filter(|&p| bends.is_passed(p) == on_segment).count()
        };
        let [free, on_segments] = [false, true].map(steiner);
        Ok(DomainNumbers {
            added: found.added().count() - free - on_segments,
            on_segments,
            free,
            carved: corners.iter().filter(|&&is_corner| !is_corner).count(),
            subsegments: self.mesh.subsegments.len(),
            components,
            holes,
        })
    }
}
