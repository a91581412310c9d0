//! Why a triangle is as it is, as a value: its shape, the bounds it breaks, and where its corners come from.

use super::Mesh;
use super::causes::{Cause, Rule};
use crate::Trouble;
use crate::bounds::{Bound, within};
use delone::check::Shape;
use delone::predicates::{CircleSide, circumcenter, in_circle};
use delone::{Broken, Origin, Point, Reason, TriangleId, Unmet, VertexId};
use serde::Serialize;

/// All that is to be said of a triangle.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Explanation {
    pub triangle: usize,
    pub corners: [usize; 3],
    /// In degrees.
    pub angles: [f64; 3],
    /// Lengths, each opposite its corner.
    pub edges: [f64; 3],
    pub area: f64,
    pub region: Option<usize>,
    pub unmet: Option<Shortfall>,
    pub vertices: [Corner; 3],
    pub circumcenter: Option<[f64; 2]>,
    pub radius: Option<f64>,
    /// Whether no vertex at all lies within its circle.
    pub is_delaunay: bool,
}

/// What a triangle lacks, and why.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Shortfall {
    /// `angle`, `edge`, `area`; several with blanks between.
    pub broken: String,
    pub reason: &'static str,
    pub excused: bool,
    pub corner: Option<usize>,
    pub segments: Option<[usize; 2]>,
    /// Between the segments, in degrees.
    pub angle: Option<f64>,
}

/// A corner, and why it is there.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Corner {
    pub vertex: usize,
    pub at: [f64; 2],
    pub origin: &'static str,
    pub segment: Option<usize>,
    pub segments: Option<[usize; 2]>,
    pub cause: Option<Why>,
}

/// Why a vertex was added.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Why {
    pub rule: &'static str,
    /// The corners of the triangle that was to go, or the ends of the edge that was divided.
    pub parent: Vec<[f64; 2]>,
    /// The ends of the edge that was divided.
    pub edge: Option<[[f64; 2]; 2]>,
    pub by: Option<usize>,
    pub step: u32,
    /// The rest is for sentences.
    #[serde(skip)]
    pub kind: Rule,
    #[serde(skip)]
    pub triangle: Option<[VertexId; 3]>,
    #[serde(skip)]
    pub divided: Option<[VertexId; 2]>,
}

impl Explanation {
    /// Explains a triangle.
    ///
    /// *Cost*: a test for each vertex, some milliseconds for a million.
    ///
    /// # Errors
    /// If there is no such triangle.
    pub fn of(mesh: &Mesh, triangle: usize) -> Result<Self, Trouble> {
        let t = mesh.triangulation();
        within(Bound::TRIANGLE, triangle, t.num_triangles()).map_err(Trouble::asked)?;
        let id = TriangleId::new(triangle);
        let corners = t.triangles()[triangle];
        let [a, b, c] = corners.map(|v| t.point(v));
        let shape = Shape::of([a, b, c]);
        let center = circumcenter(a, b, c).filter(|center| center.is_finite());
        let is_empty = |&p: &Point| in_circle(a, b, c, p) != CircleSide::Inside;
        Ok(Self {
            triangle,
            corners: corners.map(VertexId::index),
            angles: shape.angles,
            edges: shape.edges,
            area: shape.area,
            region: mesh.domain().and_then(|domain| domain.region(id)),
            unmet: unmet(mesh, id).map(|unmet| Shortfall::of(unmet, num_segments(mesh))),
            vertices: corners.map(|v| Corner::of(mesh, v)),
            circumcenter: center.map(xy),
            radius: center.map(|o| f64::hypot(a.x - o.x, a.y - o.y)),
            is_delaunay: t.points().iter().all(is_empty),
        })
    }
}

/// Finds what refinement reports of a triangle.
fn unmet(mesh: &Mesh, triangle: TriangleId) -> Option<&Unmet> {
    let unmet = &mesh.refined()?.report.unmet;
    let i = unmet.binary_search_by_key(&triangle, |u| u.triangle);
    i.ok().map(|i| &unmet[i])
}

/// Counts the segments of the input.
fn num_segments(mesh: &Mesh) -> usize {
    mesh.domain()
        .map_or(0, |domain| domain.num_input_segments())
}

impl Shortfall {
    /// `inputs` is the number of segments of the input; edges of the hull, behind them, have no number there.
    fn of(unmet: &Unmet, inputs: usize) -> Self {
        let Broken { angle, edge, area } = unmet.broken;
        let broken = [(angle, "angle"), (edge, "edge"), (area, "area")];
        let broken = broken.into_iter().filter(|&(is_broken, _)| is_broken);
        let names: Vec<_> = broken.map(|(_, name)| name).collect();
        let corner = match unmet.reason {
            Reason::SmallInputAngle {
                vertex,
                segments,
                angle,
            } => Some((vertex.index(), segments, angle.to_degrees())),
            _ => None,
        };
        Self {
            broken: names.join(" "),
            reason: match unmet.reason {
                Reason::SmallInputAngle { .. } => "smallInputAngle",
                Reason::LockedBoundary => "lockedBoundary",
                Reason::Precision => "precision",
                Reason::Gradation => "gradation",
                Reason::Stopped => "stopped",
                _ => "other",
            },
            excused: unmet.reason.is_excused(),
            corner: corner.map(|(vertex, _, _)| vertex),
            segments: corner
                .map(|(_, segments, _)| segments)
                .filter(|segments| segments.iter().all(|&k| k < inputs)),
            angle: corner.map(|(_, _, angle)| angle),
        }
    }
}

impl Corner {
    fn of(mesh: &Mesh, v: VertexId) -> Self {
        let domain = mesh.domain();
        let origin = domain.map_or(Origin::Input(v), |domain| domain.origin(v));
        let (origin, segment, segments) = match origin {
            Origin::Input(_) => ("input", None, None),
            Origin::Crossing(pair) => ("crossing", None, Some(pair)),
            Origin::OnSegment(k) => {
                let segment = Some(k).filter(|&k| k < num_segments(mesh));
                ("onSegment", segment, None)
            }
            _ => ("free", None, None),
        };
        let is_added = matches!(origin, "onSegment" | "free");
        let causes = mesh.causes.as_ref().filter(|_| is_added);
        let cause = causes.and_then(|causes| causes.of(v));
        Self {
            vertex: v.index(),
            at: xy(mesh.triangulation().point(v)),
            origin,
            segment,
            segments,
            cause: cause.map(|cause| Why::of(mesh, v, cause)),
        }
    }
}

impl Why {
    fn of(mesh: &Mesh, v: VertexId, cause: &Cause) -> Self {
        let points = mesh.triangulation().points();
        // Whoever was only proposed, or has been taken back, is not there to be shown.
        let places = |vertices: &[VertexId]| -> Option<Vec<[f64; 2]>> {
            let known = vertices.iter().map(|v| points.get(v.index()).copied());
            known.map(|p| p.map(xy)).collect()
        };
        let triangle = cause.triangle().and_then(|corners| places(&corners));
        let edge = cause.edge().and_then(|ends| places(&ends));
        let is_on_segment = mesh
            .domain()
            .is_some_and(|domain| matches!(domain.origin(v), Origin::OnSegment(_)));
        let kind = match cause.rule {
            // What is sown on segments divides them.
            Rule::Lattice if is_on_segment => Rule::Size,
            rule => rule,
        };
        Self {
            rule: match kind {
                Rule::Circumcenter => "circumcenter",
                Rule::RejectedCircumcenter => "rejectedCircumcenter",
                Rule::Encroachment => "encroachment",
                Rule::Size => "size",
                Rule::Lattice => "lattice",
            },
            edge: edge.as_deref().and_then(|ends| ends.try_into().ok()),
            parent: triangle.or(edge).unwrap_or_default(),
            by: cause.by().map(VertexId::index).filter(|&by| by < v.index()),
            step: cause.step,
            kind,
            triangle: cause.triangle(),
            divided: cause.edge(),
        }
    }
}

fn xy(p: Point) -> [f64; 2] {
    [p.x, p.y]
}
