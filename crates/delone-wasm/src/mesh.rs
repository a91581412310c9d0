//! The library's own work: triangulations, domains, refined meshes.

mod causes;
mod explain;
mod figures;
mod measures;
mod options;
mod sentence;
#[cfg(test)]
mod tests;

use crate::drawing::Drawing;
use crate::look::Looker;
use crate::progress::Progress;
use crate::save::{self, SavedFile};
use crate::{Trouble, json};
use causes::Causes;
use delone::locate::{Location, locate};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, Delaunay, HalfEdgeId, Outcome, Point,
    RefinedMesh, TriangleId, Triangulation,
};
use delone_io::DomainData;
use explain::Explanation;
use figures::Figures;
use js_sys::Function;
use measures::Measure;
use options::Options;
use std::cell::Cell;
use wasm_bindgen::prelude::wasm_bindgen;

/// A finished triangulation.
#[wasm_bindgen]
pub struct Mesh {
    pub(crate) built: Built,
    /// Attributes and markers; points and segments are in what was built.
    pub(crate) data: DomainData,
    /// Why vertices were added, if that was to be kept.
    causes: Option<Causes>,
    /// Where a point was found last: pointers move little between two questions.
    found: Cell<Option<HalfEdgeId>>,
}

/// What was built.
pub(crate) enum Built {
    Points(Triangulation),
    Domain(Box<ConstrainedTriangulation>),
    Refined(Box<RefinedMesh>),
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
        let built = Delaunay::new().watch(&progress).triangulate(points);
        let built = built.map_err(|error| Trouble::of_drawing(error, drawing))?;
        Ok(Self::of(Built::Points(built), data))
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
            .crossings(options.crossings())
            .domain(options.rule(&data))
            .watch(&progress)
            .triangulate(data.take_pslg())
            .map_err(|error| Trouble::of_drawing(error, drawing))?;
        Ok(Self::of(Built::Domain(built.into()), data))
    }

    /// Triangulates points and segments, and adds vertices until triangles are good.
    ///
    /// `options` is that of `constrain`, and `{minAngle, maxEdge, maxArea, regionAreas, maxVertices, smoothing,
    /// conforming, thesis, explains}`: degrees, lengths, areas; at most a million vertices by default; passes of
    /// smoothing; Ruppert's circles instead of Chew's lenses; the strategy of the thesis; whether to keep why each
    /// vertex was added, for `explain` and `sentence`: about 40 bytes a vertex.
    pub fn refine(
        drawing: &Drawing,
        options: Option<String>,
        progress: Option<Function>,
    ) -> Result<Self, Trouble> {
        let options: Options = json::options(options.as_deref())?;
        let progress = Progress::told_to(progress);
        let mut data = drawing.data.clone();
        let refinement = options.refinement(&data).watch(&progress);
        let pslg = data.take_pslg();
        let mut causes = options.explains().then(|| Causes::new(options.is_thesis()));
        let refined = match &mut causes {
            Some(causes) => refinement.observe(pslg, causes),
            None => refinement.mesh(pslg),
        };
        let refined = refined.map_err(|error| Trouble::of_drawing(error, drawing))?;
        if refined.report.outcome == Outcome::Cancelled {
            return Err(delone::Error::Cancelled.into());
        }
        let mesh = Self::of(Built::Refined(refined.into()), data);
        Ok(Self { causes, ..mesh })
    }

    /// Returns the coordinates of the vertices: those of the drawing first, in its order.
    pub fn points(&self) -> Vec<f64> {
        json::coordinates(self.triangulation().points().iter().copied())
    }

    /// Returns the corners of the triangles, counter-clockwise.
    pub fn triangles(&self) -> Vec<u32> {
        json::indices(self.triangulation().triangles().iter().copied())
    }

    /// Makes what finds places in the mesh.
    pub fn looker(&self) -> Looker {
        let t = self.triangulation();
        Looker::of(t.points().iter().copied(), t.triangles().iter().copied())
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

    /// Explains a triangle, as JSON: `{triangle, corners, angles, edges, area, region, unmet, vertices, circumcenter,
    /// radius, isDelaunay}`. Angles are degrees; edges lie opposite the corners; `isDelaunay`: no vertex at all is
    /// within its circle, not even behind segments. `unmet` is null if nothing is, otherwise `{broken, reason, excused,
    /// corner, segments, angle}`: `broken` is `"angle"`, `"edge"` or `"area"`, or several with blanks between; `reason` is
    /// `"smallInputAngle"` (with corner, segments and the angle between them), `"lockedBoundary"`, `"precision"`,
    /// `"gradation"` or `"stopped"`.
    ///
    /// A vertex is `{vertex, at, origin, segment, segments, cause}`: `origin` is `"input"`, `"crossing"` (of `segments`),
    /// `"onSegment"` (`segment` is null on the hull) or `"free"`. `cause` is null if it was not added, or not kept
    /// (`explains`), otherwise `{rule, parent, edge, by, step}`: `rule` is `"circumcenter"`, `"rejectedCircumcenter"`,
    /// `"encroachment"`, `"size"` or `"lattice"`; `parent` are the places of the corners of the triangle that was to go,
    /// or of the ends of the edge that was divided; `edge` those ends, or null; `by` is the vertex that lay too close.
    pub fn explain(&self, triangle: usize) -> Result<String, Trouble> {
        Ok(json::write(&Explanation::of(self, triangle)?))
    }

    /// Says why a triangle is as it is, in two or three sentences; `language` is `"en"` or `"de"`.
    pub fn sentence(&self, triangle: usize, language: &str) -> Result<String, Trouble> {
        let language = language.parse().map_err(Trouble::Asked)?;
        let told = Explanation::of(self, triangle)?;
        let asked = self.refined().map(|refined| &refined.report.asked);
        Ok(sentence::say(&told, asked, language))
    }

    /// Measures every triangle: `"minAngle"` and `"maxAngle"` in degrees, `"area"`, `"longestEdge"`, `"radiusRatio"` (1 for
    /// an equilateral triangle, 0 for a flat one) or `"region"` (its number, or −1).
    pub fn measures(&self, measure: &str) -> Result<Vec<f32>, Trouble> {
        let measure: Measure = measure.parse()?;
        let mut all = Vec::with_capacity(self.triangulation().num_triangles());
        all.extend(measure.all(self).map(|value| value as f32));
        Ok(all)
    }

    /// Returns the triangle of the domain in which a place lies, by number; `undefined` outside. Of several that it
    /// touches it is the first.
    ///
    /// *Cost*: a walk from the place that was asked for last.
    #[wasm_bindgen(js_name = triangleAt)]
    pub fn triangle_at(&self, x: f64, y: f64) -> Option<usize> {
        let (t, goal) = (self.triangulation(), Point::new(x, y));
        if !goal.is_finite() || t.num_triangles() == 0 {
            return None;
        }
        let hint = self.found.get().unwrap_or(HalfEdgeId::new(0));
        let location = locate(t.mesh(), t.points(), hint, goal);
        if let Location::Face(face) = location {
            self.found.set(Some(face.half_edges()[0]));
        }
        location.triangle(t).map(TriangleId::index)
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
    fn of(built: Built, data: DomainData) -> Self {
        Self {
            built,
            data,
            causes: None,
            found: Cell::new(None),
        }
    }

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
