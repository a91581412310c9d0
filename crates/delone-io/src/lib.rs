//! Files: reads point sets, domains and meshes, writes meshes, draws them.
//!
//! One file per format, each with the functions it has: `read_points`, `read_domain`, `read_mesh`,
//! `write`. A further format is a further file, a [`Format`] variant, and a line in the dispatch of
//! [`read_points`], [`read_domain`], [`read_mesh`], [`write_mesh`] or [`write_domain`].
//!
//! Readers take the whole file into memory, but for point clouds (cost proportional to the file, never to a number that
//! the file declares) and answer malformed input with an [`Error`] that names file and line.
//! Writers fill temporary files and rename them only when all are complete. Every loop looks at the
//! caller's [`Watch`](delone::Watch), some hundred times a second or more.
//!
//! | format | points | domain | mesh | write |
//! |---|---|---|---|---|
//! | `.node`, `.ele` (Triangle) | read | points | read, with `.poly` | both |
//! | `.edge`, `.neigh` (Triangle) | | | | mesh |
//! | `.area` (Triangle) | | | [`read_areas`] | |
//! | `.v.node`, `.v.edge` (Triangle) | | | | [mesh](WriteOptions::voronoi) |
//! | `.poly` (Triangle) | read | read | beside `.ele` | domain; mesh with its family |
//! | `.geojson` (RFC 7946) | read | read | | domain, mesh, contour lines |
//! | `.json` (bare arrays of coordinates) | read | read | | |
//! | `.wkt` (well-known text, or binary in hexadecimal digits) | read | read | | |
//! | `.shp` (shapefile), with `.dbf` | read | read | | |
//! | `.parquet`, GeoParquet (feature `parquet`) | read | read | read, with `.points.parquet` | both |
//! | `.npy` (NumPy) | read | points | read, with `.points.npy` | both, raster |
//! | `.csv`, `.tsv`, `.txt`, `.xyz` … | read | points | | points |
//! | `.vtu` (VTK, ParaView) | read | lines | read | all |
//! | `.vtk` (VTK, legacy) | read | lines | read | all |
//! | `.msh`, `.msh2` (Gmsh 4.1, 2.2) | read | lines | read | all |
//! | `.msh`, `.jigsaw` (JIGSAW) | read | read | read | |
//! | `.mesh` (Medit, FreeFem, Mmg) | read | read | read | all |
//! | `.obj` (Wavefront) | read | read | read | all |
//! | `.off` (Geomview) | read | points | read | points, mesh |
//! | `.ply` (Stanford) | read | read | read | all |
//! | `.stl` (stereolithography) | | | | mesh |
//! | `.dxf` (AutoCAD) | read | read | | points, domain, mesh |
//! | `.dat` (airfoils) | read | read | | |
//! | `.las`, `.laz` (laser scanners) | read | points | | |
//! | `.asc` (ESRI's ASCII grid) | read | points | | raster |
//! | `.tikz`, `.tex` (LaTeX) | | | | all |
//! | `.svg` | read | read | | all, report |
//! | `.png` | | | | all, report |
//! | `.gif` | | | | [run](write_animation) |
//! | `.html` | | | | report |
//!
//! [`Format::keeps`] tells what of points, domains and meshes survives in each. [`write_cells`] writes [Voronoi cells](CellsView) to `.geojson`, `.vtu`, `.svg` and `.png`; [`write_links`]
//! writes [links between points](Links) to tables, `.npy`, `.geojson`, `.svg` and `.png`; [`write_clusters`] draws
//! [clusters of points](ClustersView); [`write_troubles`] shows [what is wrong with a drawing](TroublesView). [Runs](Recording) of
//! classical algorithms have [log files](LogFormat) of their own, `.json` and `.dlog`; [`write_animation`] shows
//! them.
//!
//! Points become a mesh:
//!
//! ```
//! use delone_io::{MeshView, ReadOptions, Source, Target, WriteOptions};
//!
//! # let folder = tempfile::tempdir()?;
//! # std::env::set_current_dir(&folder)?;
//! # std::fs::write("survey.csv", "x,y,height\n0,0,5\n1,0,6\n1,1,7\n0,1,8\n")?;
//! let source = Source::from_arg("survey.csv");
//! let set = delone_io::read_points(&source, &ReadOptions::default(), &())?;
//! assert_eq!(set.attributes[0].name, "height");
//!
//! let triangulation = delone::triangulate(set.points.iter().copied())?;
//! let mesh = MeshView::from(&triangulation).with_data(&set);
//! let targets = ["survey.ele", "survey.png"].map(|name| Target::from_arg(name, None));
//! let written = delone_io::write_mesh(&targets, &mesh, &WriteOptions::default(), &())?;
//! assert_eq!(written.len(), 5); // survey.node, .ele, .edge, .neigh and .png
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Where there are no files, [`Source::Memory`] and [`Source::Together`] are read, and [`in_memory`] keeps what is written.
//!
//! So do domains, whose markers and attributes the mesh [inherits](Inherited):
//!
//! ```
//! use delone::ConstrainedDelaunay;
//! use delone_io::{Inherited, MeshView, ReadOptions, Source, Target, WriteOptions};
//!
//! # let folder = tempfile::tempdir()?;
//! # let place = |name: &str| folder.path().join(name);
//! # std::fs::write(place("pond.wkt"), "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 6 3, 3 6, 3 3))")?;
//! let source = Source::from_arg(place("pond.wkt"));
//! let mut domain = delone_io::read_domain(&source, &ReadOptions::default(), &())?;
//! let rule = domain.usual_rule;
//!
//! let graph = domain.take_pslg();
//! let result = ConstrainedDelaunay::new().domain(rule).triangulate(graph)?;
//! let inherited = Inherited::new(&result, domain, &())?;
//! let mesh = MeshView::constrained(&result, &inherited);
//! let target = Target::from_arg(place("triangles.ele"), None);
//! let written = delone_io::write_mesh(&[target], &mesh, &WriteOptions::default(), &())?;
//! assert_eq!(written.len(), 5); // triangles.node, .ele, .edge, .neigh and .poly
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod airfoil;
mod animation;
mod areas;
mod asc;
mod cancel;
mod cells;
mod certificate;
mod clusters;
mod commit;
mod constraints;
mod counts;
mod cursor;
mod curve;
mod decimal;
mod domain;
mod dxf;
mod edge;
mod ele;
mod error;
mod exact;
mod features;
mod foreign;
mod format;
mod geojson;
mod inherit;
mod jigsaw;
mod las;
mod lines;
mod links;
mod medit;
mod memory;
mod mesh;
mod msh;
pub mod narration;
mod neigh;
mod node;
mod npy;
mod obj;
mod off;
mod outline;
mod parquet;
mod picture;
mod plot;
mod ply;
mod png;
mod points;
mod poly;
mod relief;
mod report;
mod scan;
mod shapes;
mod shp;
mod six_nodes;
mod source;
mod space;
mod stl;
mod svg;
mod table;
mod target;
mod tikz;
mod topology;
mod trace;
mod triangle_files;
mod troubles;
mod unfinished;
mod unmet;
mod unrefined;
mod voronoi;
mod vtk;
mod vtu;
mod wkb;
mod wkt;
pub mod words;
mod write;

pub use animation::{AnimationOptions, AnimationReport, Pace, ShownSteps, Strip, write_animation};
pub use areas::read_areas;
pub use cells::CellsView;
pub use certificate::{
    Along, AskedFor, Claim, FileFact, InputFacts, Lineage, Maker, MeshCertificate, MeshFacts,
    OfEdge, OfVertex, Papers, Proof, ProveError, Reached, RegionFacts, Stages, Tests, UnmetFact,
    Within, digest_file, prove, write_certified,
};
pub use clusters::{ClustersView, write_clusters};
pub use commit::Commit;
pub use constraints::Constraints;
pub use counts::Counts;
pub use domain::{DomainData, read_domain};
pub use error::{Error, Place, Problem};
pub use foreign::is_reading_with_others;
pub use format::{Format, Keeps, Precision, Trait};
pub use inherit::Inherited;
pub use lines::Lines;
pub use links::{Link, Links, write_links};
pub use memory::{MemoryFile, in_memory};
pub use mesh::{MeshData, MeshView, read_mesh};
pub use plot::{Curve, Panel, write_plot};
pub use points::{Attribute, Column, LeftOut, PointSet, ReadOptions, Returns, read_points};
pub use relief::{Relief, ReliefOptions, write_relief};
pub use report::{ReportOptions, write_report};
pub use source::Source;
pub use target::Target;
pub use trace::{LogFormat, Recording, read_log, write_log};
pub use troubles::{Mark, TroublesView, write_troubles};
pub use unfinished::discard_unfinished_files;
pub use unmet::Explainer;
pub use write::{
    PictureOptions, WriteOptions, write_cells, write_domain, write_mesh, write_points,
};

/// Runs the examples of pages of the documentation.
#[cfg(doctest)]
mod pages {
    #[doc = include_str!("../../../docs/library.md")]
    struct Library;

    #[doc = include_str!("../../../docs/exactness.md")]
    struct Exactness;
}
