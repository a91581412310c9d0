//! What a certificate says, as JSON has it: field by field, in this order.

use delone::check::{LocalTests, StageCounts};
use delone::{Angle, Locked, Quality};
use serde::{Deserialize, Serialize};

/// A certificate of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshCertificate {
    /// The version of this format: 1.
    pub certificate: u32,
    /// Who made the mesh, and how. Nothing but the checksum vouches for this part.
    pub made_by: Maker,
    /// What was read.
    pub input: InputFacts,
    /// Which triangles belong to the domain, `hull`, `carve` or `evenodd`; null for bare points.
    pub domain: Option<String>,
    /// Whether the mesh may have Steiner points.
    pub refined: bool,
    /// What was asked of the triangles; null if nothing was.
    pub asked: Option<AskedFor>,
    /// The mesh, counted and named.
    pub mesh: MeshFacts,
    /// What was reached; null without triangles.
    pub reached: Option<Reached>,
    /// The triangles that break a bound, by their corners.
    pub unmet: Vec<UnmetFact>,
    /// Subsegments that are encroached upon without an excuse, and vertices on segments that had to stay.
    pub other_unmet: usize,
    /// How many triangles lie in each region; empty if the input has none.
    pub regions: Vec<RegionFacts>,
    /// What was proven in exact arithmetic, clause by clause.
    pub proven: Vec<String>,
    /// How far off its segment a vertex may lie, on each axis, in units in the last place of the segment's largest
    /// coordinate there.
    pub drift_ulps: f64,
    /// How much farther a Steiner point may, each time its segment has been halved.
    pub drift_ulps_per_halving: f64,
    /// The local tests on which the proof rests, by the arithmetic that decided them.
    pub local_tests: Tests,
    /// The files that were written, but for report pages, which tell times.
    pub output: Vec<FileFact>,
    /// The table of lineage, if one was written.
    pub lineage: Option<FileFact>,
    /// SHA-256 of this certificate as compact JSON with an empty checksum.
    pub checksum: String,
}

/// Who made a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Maker {
    /// The program.
    pub program: String,
    /// Its version.
    pub version: String,
    /// The command.
    pub command: String,
    /// Options that matter and cannot be seen in the mesh, as `name=value`.
    pub options: Vec<String>,
}

/// A file, without its folder.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileFact {
    /// Its name.
    pub name: String,
    /// SHA-256 of its bytes.
    pub sha256: String,
}

/// What was read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InputFacts {
    /// The name of the built-in sample, if there was no file.
    pub sample: Option<String>,
    /// The files.
    pub files: Vec<FileFact>,
    /// Options that tell which part of them was read, and how, as `name=value`; left out if there were none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub reading: Vec<String>,
    /// How many points they hold.
    pub points: usize,
    /// How many segments.
    pub segments: usize,
    /// How many polygons.
    pub polygons: usize,
    /// How many holes.
    pub holes: usize,
    /// How many regions.
    pub regions: usize,
    /// The name of what is drawn, whatever its order: see [`delone::Pslg::hash`].
    pub hash: String,
}

impl InputFacts {
    /// Counts and names a drawing.
    pub fn of(pslg: &delone::Pslg, files: Vec<FileFact>) -> Self {
        Self {
            sample: None,
            files,
            reading: Vec::new(),
            points: pslg.points.len(),
            segments: pslg.segments.len(),
            polygons: pslg.polygons.len(),
            holes: pslg.holes.len(),
            regions: pslg.regions.len(),
            hash: pslg.hash().to_string(),
        }
    }
}

/// What was asked of the triangles.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AskedFor {
    /// The smallest angle.
    pub min_angle_degrees: Option<f64>,
    /// The longest edge.
    pub max_edge: Option<f64>,
    /// The largest area.
    pub max_area: Option<f64>,
    /// Whether regions, or the `.area` file of a mesh, bound areas.
    pub area_per_region: bool,
    /// Sizes that depend on the place, as the program takes them, files without their folders.
    pub sizing: Vec<String>,
    /// Which segments had to stay as they were: `outer`, `all`, or null.
    pub keep_boundary: Option<String>,
    /// Whether no vertex may lie in the diametral circle of a subsegment.
    pub conforming: bool,
}

impl AskedFor {
    /// Returns the bounds that are the same everywhere.
    pub fn quality(&self) -> Quality {
        Quality {
            min_angle: self.min_angle_degrees.map(Angle::degrees),
            max_edge: self.max_edge,
            max_area: self.max_area,
            region_areas: self.area_per_region,
        }
    }

    /// Returns which segments had to stay; `None` if that is no word of this format.
    pub fn locked(&self) -> Option<Locked> {
        match self.keep_boundary.as_deref() {
            None => Some(Locked::Nothing),
            Some("outer") => Some(Locked::Boundary),
            Some("all") => Some(Locked::Segments),
            Some(_) => None,
        }
    }
}

/// A mesh, counted and named.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshFacts {
    /// The name of the set of triangles: see [`delone::TriangulationHash`].
    pub hash: String,
    /// All points.
    pub points: usize,
    /// Distinct points.
    pub vertices: usize,
    /// Points that equal another one.
    pub duplicates: usize,
    /// Triangles.
    pub triangles: usize,
    /// Edges.
    pub edges: usize,
    /// Edges with one triangle.
    pub border_edges: usize,
    /// Constrained edges.
    pub constrained_edges: usize,
    /// Vertices where segments cross that are no points of the input.
    pub crossings: usize,
    /// Steiner points on segments.
    pub steiner_on_segments: usize,
    /// Steiner points elsewhere.
    pub steiner_free: usize,
    /// Distinct points that no triangle has.
    pub carved: usize,
    /// Parts of the domain.
    pub components: usize,
    /// Holes that the domain encloses.
    pub holes: usize,
}

/// What was reached, rounded, and the angle that was asked for, exactly.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reached {
    /// The smallest angle.
    pub min_angle_degrees: f64,
    /// The longest edge.
    pub max_edge: f64,
    /// The largest area.
    pub max_area: f64,
    /// The tangent of the smallest angle asked for, as the number that angles were compared with.
    pub asked_tangent: Option<f64>,
    /// How many triangles have an angle of a smaller tangent, compared exactly.
    pub triangles_below: Option<usize>,
}

/// A triangle that breaks a bound.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UnmetFact {
    /// Its corners, counter-clockwise from the smallest number.
    pub corners: [u32; 3],
    /// The bounds that it breaks: `angle`, `edge`, `area`.
    pub breaks: Vec<String>,
    /// Its smallest angle.
    pub min_angle_degrees: f64,
    /// `small_input_angle`, `locked_boundary`, `precision`, or null.
    pub excuse: Option<String>,
    /// For a small angle of the input, the vertex where it is.
    pub at_vertex: Option<u32>,
    /// For a small angle of the input, its segments.
    pub between_segments: Option<[usize; 2]>,
}

/// How many triangles lie in a region.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RegionFacts {
    /// Its number in the input, from 0; null is outside of all.
    pub region: Option<usize>,
    /// Its triangles.
    pub triangles: usize,
}

/// The local tests: see [`delone::check::count_stages`].
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tests {
    /// Orientations, one a triangle.
    pub orient2d: Stages,
    /// Circles, one an edge between two triangles that is not constrained.
    pub in_circle: Stages,
}

/// Tests by the arithmetic that decided them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stages {
    /// Floating point with an error bound.
    pub filter: u64,
    /// Integers of fixed width.
    pub integer: u64,
    /// Integers of any width.
    pub big_integer: u64,
}

impl From<LocalTests> for Tests {
    fn from(tests: LocalTests) -> Self {
        Self {
            orient2d: tests.orient2d.into(),
            in_circle: tests.in_circle.into(),
        }
    }
}

impl From<StageCounts> for Stages {
    fn from(counts: StageCounts) -> Self {
        let StageCounts {
            filter,
            integer,
            big_integer,
        } = counts;
        Self {
            filter,
            integer,
            big_integer,
        }
    }
}
