//! The library's own work: triangulations, domains, refined meshes.

mod figures;

use crate::drawing::{Drawing, Rule};
use crate::progress::Progress;
use crate::save::{self, SavedFile};
use crate::{Trouble, json};
use delone::{
    Angle, Budget, ConstrainedDelaunay, ConstrainedTriangulation, Delaunay, DomainRule,
    Encroachment, Outcome, Quality, RefinedMesh, Refinement, SegmentPolicy, Strategy,
    Triangulation,
};
use delone_io::DomainData;
use figures::Figures;
use js_sys::Function;
use serde::Deserialize;
use wasm_bindgen::prelude::wasm_bindgen;

/// Vertices beyond which refinement does not go unless it is asked to.
const USUAL_BUDGET: usize = 1_000_000;

/// A finished triangulation.
#[wasm_bindgen]
pub struct Mesh {
    pub(crate) built: Built,
    /// Attributes and markers; points and segments are in what was built.
    pub(crate) data: DomainData,
}

/// What was built.
pub(crate) enum Built {
    Points(Triangulation),
    Domain(Box<ConstrainedTriangulation>),
    Refined(Box<RefinedMesh>),
}

/// How a domain is understood, and how good its triangles are to be.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
struct Options {
    domain: Option<Rule>,
    crossings: Crossings,
    min_angle: Option<f64>,
    max_edge: Option<f64>,
    max_area: Option<f64>,
    region_areas: bool,
    max_vertices: Option<usize>,
    smoothing: usize,
    conforming: bool,
    thesis: bool,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Crossings {
    #[default]
    Error,
    Split,
}

impl From<Crossings> for SegmentPolicy {
    fn from(crossings: Crossings) -> Self {
        match crossings {
            Crossings::Error => Self::Error,
            Crossings::Split => Self::Split,
        }
    }
}

impl Options {
    fn rule(&self, data: &DomainData) -> DomainRule {
        self.domain.map_or(data.usual_rule, Into::into)
    }

    fn quality(&self) -> Quality {
        Quality {
            min_angle: self.min_angle.filter(|&a| a != 0.0).map(Angle::degrees),
            max_edge: self.max_edge,
            max_area: self.max_area,
            region_areas: self.region_areas,
        }
    }

    fn refinement(&self, data: &DomainData) -> Refinement<'_> {
        let budget = Budget {
            vertices: Some(self.max_vertices.unwrap_or(USUAL_BUDGET)),
            ..Budget::default()
        };
        let encroachment = match self.conforming {
            true => Encroachment::Circle,
            false => Encroachment::Lens,
        };
        let strategy = match self.thesis {
            true => Strategy::Thesis,
            false => Strategy::Delaunay,
        };
        Refinement::new(self.quality())
            .budget(budget)
            .encroachment(encroachment)
            .smoothing(self.smoothing)
            .strategy(strategy)
            .crossings(self.crossings.into())
            .domain(self.rule(data))
    }
}

#[wasm_bindgen]
impl Mesh {
    /// Triangulates the points alone; segments and holes are left aside.
    ///
    /// `progress` is called with `(phase, done, total)` now and then; the work stops, with an error, once it
    /// returns `false`.
    pub fn triangulate(drawing: &Drawing, progress: Option<Function>) -> Result<Self, Trouble> {
        let progress = Progress::told_to(progress);
        let mut data = DomainData::from(drawing.data.vertices.clone());
        let points = std::mem::take(&mut data.vertices.points);
        let built = Delaunay::new()
            .watch(&progress)
            .triangulate(points)
            .map_err(|error| Trouble::of_drawing(error, drawing))?;
        let built = Built::Points(built);
        Ok(Self { built, data })
    }

    /// Triangulates points and segments, and carves what lies outside.
    ///
    /// `options` is JSON: `{domain: "hull" | "carve" | "evenodd", crossings: "error" | "split"}`; by default the
    /// drawing's rule, and crossing segments are an error that names them.
    pub fn constrain(
        drawing: &Drawing,
        options: Option<String>,
        progress: Option<Function>,
    ) -> Result<Self, Trouble> {
        let options: Options = json::options(options.as_deref())?;
        let progress = Progress::told_to(progress);
        let mut data = drawing.data.clone();
        let built = ConstrainedDelaunay::new()
            .crossings(options.crossings.into())
            .domain(options.rule(&data))
            .watch(&progress)
            .triangulate(data.take_pslg())
            .map_err(|error| Trouble::of_drawing(error, drawing))?;
        let built = Built::Domain(built.into());
        Ok(Self { built, data })
    }

    /// Triangulates points and segments, and adds vertices until triangles are good.
    ///
    /// `options` is that of `constrain`, and `{minAngle, maxEdge, maxArea, regionAreas, maxVertices, smoothing,
    /// conforming, thesis}`: degrees, lengths, areas; at most a million vertices by default; passes of smoothing;
    /// Ruppert's circles instead of Chew's lenses; the strategy of the thesis.
    pub fn refine(
        drawing: &Drawing,
        options: Option<String>,
        progress: Option<Function>,
    ) -> Result<Self, Trouble> {
        let options: Options = json::options(options.as_deref())?;
        let progress = Progress::told_to(progress);
        let mut data = drawing.data.clone();
        let refinement = options.refinement(&data).watch(&progress);
        let refined = refinement
            .mesh(data.take_pslg())
            .map_err(|error| Trouble::of_drawing(error, drawing))?;
        if refined.report.outcome == Outcome::Cancelled {
            return Err(delone::Error::Cancelled.into());
        }
        let built = Built::Refined(refined.into());
        Ok(Self { built, data })
    }

    /// Returns the coordinates of the vertices: those of the drawing first, in its order.
    pub fn points(&self) -> Vec<f64> {
        json::coordinates(self.triangulation().points().iter().copied())
    }

    /// Returns the corners of the triangles, counter-clockwise.
    pub fn triangles(&self) -> Vec<u32> {
        json::indices(self.triangulation().triangles().iter().copied())
    }

    /// Returns the edges, as pairs of vertices.
    pub fn edges(&self) -> Vec<u32> {
        json::indices(self.triangulation().edges())
    }

    /// Returns the edges that are constraints, as pairs of vertices.
    pub fn constrained(&self) -> Vec<u32> {
        let domain = self.domain();
        domain.map_or_else(Vec::new, |d| json::indices(d.constrained_edges()))
    }

    /// Returns the triangles that refinement has left below what was asked for, by number.
    pub fn unmet(&self) -> Vec<u32> {
        let refined = self.refined();
        let unmet = refined.map_or(&[][..], |refined| &refined.report.unmet);
        unmet.iter().map(|u| u.triangle.index() as u32).collect()
    }

    /// Returns the name of the set of triangles: 32 hexadecimal digits, the same on every machine.
    pub fn hash(&self) -> String {
        self.triangulation().hash().to_string()
    }

    /// Tells what the mesh is like, as JSON: `{vertices, triangles, edges, duplicates, constrainedEdges,
    /// crossingsSplit, steiner, outcome, unmet, unexcused, minAngle, maxAngle, meanMinAngle, shortestEdge,
    /// longestEdge, smallestArea, largestArea, area, minAngles}`: `outcome` is null unless it was refined;
    /// `minAngles` counts triangles by their smallest angle in degrees; measures are null without triangles.
    pub fn quality(&self) -> String {
        json::write(&Figures::of(self))
    }

    /// Writes the mesh: `name` tells the format (`.ele` and its family, `.poly`, `.npy`, `.vtu`, `.geojson`,
    /// `.svg`, `.png`). `options` is JSON: `{oneBased, quadratic, size, legend}`.
    pub fn save(&self, name: &str, options: Option<String>) -> Result<Vec<SavedFile>, Trouble> {
        save::mesh(self, name, json::options(options.as_deref())?)
    }

    /// Writes the report of a refined mesh, `.html`, `.svg` or `.png`; `headline` says what was meshed.
    #[wasm_bindgen(js_name = saveReport)]
    pub fn save_report(&self, name: &str, headline: &str) -> Result<Vec<SavedFile>, Trouble> {
        save::report(self, name, headline)
    }

    /// Writes the Voronoi cells of the points, clipped to a box around them: `.geojson`, `.vtu`, `.svg` or `.png`.
    /// `options` as for `save`.
    #[wasm_bindgen(js_name = saveCells)]
    pub fn save_cells(
        &self,
        name: &str,
        options: Option<String>,
    ) -> Result<Vec<SavedFile>, Trouble> {
        save::cells(self, name, json::options(options.as_deref())?)
    }
}

impl Mesh {
    pub(crate) fn triangulation(&self) -> &Triangulation {
        match &self.built {
            Built::Points(triangulation) => triangulation,
            Built::Domain(domain) => domain.triangulation(),
            Built::Refined(refined) => refined.mesh.triangulation(),
        }
    }

    pub(crate) fn domain(&self) -> Option<&ConstrainedTriangulation> {
        match &self.built {
            Built::Points(_) => None,
            Built::Domain(domain) => Some(domain),
            Built::Refined(refined) => Some(&refined.mesh),
        }
    }

    pub(crate) fn refined(&self) -> Option<&RefinedMesh> {
        match &self.built {
            Built::Refined(refined) => Some(refined),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn preset(name: &str) -> Drawing {
        Drawing::preset(name, 200, 1).expect("a preset")
    }

    #[test]
    fn points_are_triangulated_with_and_without_a_domain_alike() {
        let drawing = preset("uniform");
        let bare = Mesh::triangulate(&drawing, None).expect("a mesh");
        let domain = Mesh::constrain(&drawing, None, None).expect("a mesh");
        assert_eq!(bare.hash(), domain.hash());
        assert_eq!(bare.triangles().len() % 3, 0);
        assert!(bare.quality().contains(r#""outcome":null"#));
    }

    #[test]
    fn refinement_reaches_what_is_asked_for() {
        let options = r#"{"minAngle": 25, "maxEdge": 0.5, "smoothing": 1}"#.to_owned();
        let mesh = Mesh::refine(&preset("thesis"), Some(options), None).expect("a mesh");
        let figures = Figures::of(&mesh);
        assert!(figures.longest_edge.is_some_and(|edge| edge <= 0.5));
        assert!(mesh.quality().contains(r#""outcome":"complete""#));
        assert!(!mesh.constrained().is_empty());
    }

    #[test]
    fn crossings_are_an_error_unless_they_are_split() {
        let drawing = preset("degenerate-grid");
        let error = Mesh::constrain(&drawing, None, None)
            .err()
            .expect("crossings");
        assert!(error.to_string().contains("cross"), "{error}");
        let split = r#"{"crossings": "split"}"#.to_owned();
        let mesh = Mesh::constrain(&drawing, Some(split), None).expect("a mesh");
        assert!(Figures::of(&mesh).crossings_split > 0);
    }

    #[test]
    fn unknown_options_are_refused() {
        for bad in [r#"{"minangle": 25}"#, r#"{"minAngle": "x"}"#, "nonsense"] {
            let refused = Mesh::refine(&preset("thesis"), Some(bad.to_owned()), None);
            let error = refused.err().expect("nonsense");
            assert!(error.to_string().starts_with("options: "), "{error}");
        }
        let impossible = r#"{"minAngle": 90}"#.to_owned();
        let refused = Mesh::refine(&preset("thesis"), Some(impossible), None);
        assert!(refused.is_err());
    }

    #[test]
    fn points_on_a_line_have_no_triangles_and_no_measures() {
        let mesh = Mesh::triangulate(&preset("collinear"), None).expect("a mesh");
        assert!(mesh.triangles().is_empty());
        assert_eq!(mesh.edges().len(), 2 * 23);
        assert!(mesh.quality().contains(r#""minAngle":null"#));
    }
}
