//! Inputs and outputs as the command line names them.

mod content;
mod family;
mod head;
mod input;
mod losses;
mod notes;
mod outputs;
mod region;

use crate::exit::Failure;
use crate::progress::Progress;
use crate::voice;
pub use content::Content;
use delone::RefinedMesh;
use delone_io::{
    CellsView, ClustersView, Commit, DomainData, Error, Format, Links, MeshView, Papers,
    PictureOptions, PointSet, Relief, ReliefOptions, ReportOptions, Target, TroublesView,
    WriteOptions,
};
pub use family::place;
pub use head::{head, in_hand, sniff};
pub use input::{Input, Reading};
use losses::Held;
pub use notes::notes;
pub use outputs::{Outputs, PaperNames};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Options about outputs.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Files")]
pub struct Writing {
    /// Number points and triangles from 1 instead of 0 in .node, .ele, .edge, .neigh, .poly
    #[arg(long)]
    one_based: bool,
    /// Format of outputs whose name does not tell, such as `-`; if every name tells, it overrules
    /// them all but --picture: node, ele, poly, csv, npy, geojson, vtu, svg, png …
    #[arg(long, value_name = "FORMAT", alias = "format")]
    to: Option<Format>,
    /// Write text instead of bytes in .ply, .stl and .vtk
    #[arg(long)]
    ascii: bool,
    /// Longer side of pictures, in pixels [default: 1200]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(16..=8192))]
    size: Option<u32>,
}

impl Writing {
    /// Settles where and how to write, or says what is wrong with the names.
    pub fn outputs(
        &self,
        wanted: impl IntoIterator<Item = (PathBuf, Content)>,
    ) -> Result<Outputs, Failure> {
        let wanted: Vec<_> = wanted.into_iter().collect();
        let all_tell = wanted.iter().all(|(p, _)| Format::from_path(p).is_some());
        let mut outputs = Outputs::default();
        for (path, content) in wanted {
            let overrules = all_tell && content != Content::Picture && !content.is_aside();
            if content.is_aside() && path == Path::new("-") {
                return Err(content.needs_a_file());
            }
            let told = self.told(&path, overrules);
            let Some(format) = told.filter(|f| content.fits(*f)) else {
                return Err(content.misfit(&path, told));
            };
            // A family of files cannot stand beside a device, so both names mean the stream.
            if path == Path::new("-") || path == Path::new("/dev/stdout") {
                outputs.add_stream(format)?;
            } else {
                outputs.add_file(&path, format, content)?;
            }
        }
        Ok(outputs)
    }

    /// Returns the format that --to names.
    pub fn to(&self) -> Option<Format> {
        self.to
    }

    /// Returns the longer side of pictures, in pixels, if it was asked for.
    pub fn size(&self) -> Option<u32> {
        self.size
    }

    /// Returns the number that the first triangle has in files that can number from 1.
    pub fn base(&self) -> usize {
        self.one_based.into()
    }

    /// Settles on standard output alone.
    pub fn stdout(&self, content: Content, default: Format) -> Result<Outputs, Failure> {
        let format = self.to.unwrap_or(default);
        if !content.fits(format) {
            return Err(content.misfit(Path::new("-"), Some(format)));
        }
        let mut outputs = Outputs::default();
        outputs.add_stream(format)?;
        Ok(outputs)
    }

    /// Returns the format of an output that is the only one.
    pub fn format(&self, path: &Path) -> Option<Format> {
        self.told(path, true)
    }

    /// Returns the format that name and --to tell; where both do, the latter `overrules` or not.
    fn told(&self, path: &Path, overrules: bool) -> Option<Format> {
        let by_name = Format::from_path(path);
        if overrules {
            self.to.or(by_name)
        } else {
            by_name.or(self.to)
        }
    }

    /// Writes a mesh and returns the names of the files.
    pub fn mesh(
        &self,
        outputs: &Outputs,
        mesh: &MeshView<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.options();
        progress.note(&outputs.losses(&Held::by_mesh(mesh), self.ascii));
        write(outputs, |targets| {
            delone_io::write_mesh(targets, mesh, &options, progress)
        })
    }

    /// Writes a mesh with its papers and returns the names of the files.
    pub fn certified(
        &self,
        outputs: &Outputs,
        mesh: &MeshView<'_>,
        papers: &Papers<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        if papers.certificate.is_none() && papers.lineage.is_none() {
            return self.mesh(outputs, mesh, progress);
        }
        let options = self.options();
        progress.note(&outputs.losses(&Held::by_mesh(mesh), self.ascii));
        delone_io::write_certified(&outputs.files, mesh, &options, papers, progress)
            .map_err(unwritable)
    }

    /// Writes the report pages about a mesh and returns the names of the files.
    pub fn reports(
        &self,
        outputs: &Outputs,
        refined: &RefinedMesh,
        mesh: &MeshView<'_>,
        options: ReportOptions<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = ReportOptions {
            picture: self.options().picture,
            ..options
        };
        let pages = outputs.asides(Content::Report);
        delone_io::write_report(&pages, refined, mesh, &options, progress).map_err(unwritable)
    }

    /// Writes points and returns the names of the files.
    pub fn points(
        &self,
        outputs: &Outputs,
        points: &PointSet,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.options();
        progress.note(&outputs.losses(&Held::by_points(points), self.ascii));
        write(outputs, |targets| {
            delone_io::write_points(targets, points, &options, progress)
        })
    }

    /// Writes points, pictures of their clusters, and returns the names of the files.
    pub fn clusters(
        &self,
        outputs: &Outputs,
        points: &PointSet,
        clusters: &ClustersView<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.options();
        progress.note(&outputs.losses(&Held::by_points(points), self.ascii));
        write(outputs, |targets| {
            let targets = targets.iter().cloned();
            let (pictures, tables): (Vec<_>, Vec<_>) =
                targets.partition(|target| target.format().is_ok_and(Format::is_picture));
            let mut written = delone_io::write_points(&tables, points, &options, progress)?;
            let picture = &options.picture;
            let drawn = delone_io::write_clusters(&pictures, clusters, picture, progress)?;
            written.extend(drawn);
            Ok(written)
        })
    }

    /// Writes a domain and returns the names of the files.
    pub fn domain(
        &self,
        outputs: &Outputs,
        domain: &DomainData,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.options();
        progress.note(&outputs.losses(&Held::by_domain(domain), self.ascii));
        write(outputs, |targets| {
            delone_io::write_domain(targets, domain, &options, progress)
        })
    }

    /// Writes links between points and returns the names of the files.
    pub fn links(
        &self,
        outputs: &Outputs,
        links: &Links<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let picture = self.options().picture;
        write(outputs, |targets| {
            delone_io::write_links(targets, links, &picture, progress)
        })
    }

    /// Writes Voronoi cells and returns the names of the files.
    pub fn cells(
        &self,
        outputs: &Outputs,
        cells: &CellsView<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.options();
        write(outputs, |targets| {
            delone_io::write_cells(targets, cells, &options, progress)
        })
    }

    /// Writes the dual of a mesh, as Triangle does, and returns the names of the files.
    pub fn diagrams(
        &self,
        outputs: &Outputs,
        mesh: &MeshView<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let mut written = Vec::new();
        for target in outputs.asides(Content::Diagram) {
            // The writer puts `.v.node` and `.v.edge` behind the stem.
            let stem = target.path.map(|p| p.with_extension("").with_extension(""));
            let options = WriteOptions {
                voronoi: stem,
                ..self.options()
            };
            let files = delone_io::write_mesh(&[], mesh, &options, progress);
            written.extend(files.map_err(unwritable)?);
        }
        Ok(written)
    }

    /// Writes points besides something else and returns the names of the files.
    pub fn sites(
        &self,
        outputs: &Outputs,
        points: &PointSet,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let targets = outputs.asides(Content::Sites);
        let written = delone_io::write_points(&targets, points, &self.options(), progress);
        written.map_err(unwritable)
    }

    /// Writes a raster or contour lines and returns the names of the files.
    pub fn relief(
        &self,
        outputs: &Outputs,
        relief: Relief<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.relief_options();
        write(outputs, |targets| {
            delone_io::write_relief(targets, relief, &options, progress)
        })
    }

    /// Draws a surface besides something else, if that is wanted, and returns the names of the files.
    pub fn reliefs(
        &self,
        outputs: &Outputs,
        relief: Relief<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let targets = outputs.asides(Content::Relief);
        delone_io::write_relief(&targets, relief, &self.relief_options(), progress)
            .map_err(unwritable)
    }

    /// Shows troubles besides something else and returns the names of the files.
    pub fn troubles(
        &self,
        outputs: &Outputs,
        view: &TroublesView<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let targets = outputs.asides(Content::Troubles);
        let picture = self.options().picture;
        delone_io::write_troubles(&targets, view, &picture, progress).map_err(unwritable)
    }

    fn relief_options(&self) -> ReliefOptions {
        ReliefOptions {
            picture: self.options().picture,
            ..ReliefOptions::default()
        }
    }

    fn options(&self) -> WriteOptions {
        let usual = PictureOptions::default();
        WriteOptions {
            one_based: self.one_based,
            ascii: self.ascii,
            picture: PictureOptions {
                size: self.size.unwrap_or(usual.size),
                ..usual
            },
            ..WriteOptions::default()
        }
    }
}

/// Lets all files that `work` writes, whatever they hold, get their names together: all appear, or none.
pub fn in_one_commit<T>(work: impl FnOnce() -> Result<T, Failure>) -> Result<T, Failure> {
    let commit = Commit::begin();
    let done = work();
    // That nobody listens any more is no fault of the files.
    if matches!(done, Ok(_) | Err(Failure::BrokenPipe)) {
        commit.finish().map_err(unwritable)?;
    }
    done
}

/// Writes the files, all or none of them, then the stream, whose reader may have gone.
fn write(
    outputs: &Outputs,
    to: impl Fn(&[Target]) -> Result<Vec<PathBuf>, Error>,
) -> Result<Vec<PathBuf>, Failure> {
    let names = if outputs.files.is_empty() {
        Vec::new()
    } else {
        to(&outputs.files).map_err(unwritable)?
    };
    if let Some(stream) = &outputs.stream {
        to(std::slice::from_ref(stream)).map_err(unwritable)?;
    }
    Ok(names)
}

/// Says why something could not be read.
pub fn unreadable(error: Error) -> Failure {
    match error {
        Error::Cancelled => Failure::Cancelled,
        Error::NoSuchColumn { .. } | Error::SameColumn { .. } => Failure::Usage(error.to_string()),
        _ => Failure::BadInput(error.to_string()),
    }
}

/// Says why something could not be written.
pub fn unwritable(error: Error) -> Failure {
    match error {
        Error::Cancelled => Failure::Cancelled,
        Error::Io { file, source, .. }
            if file == "-" && source.kind() == std::io::ErrorKind::BrokenPipe =>
        {
            Failure::BrokenPipe
        }
        Error::Unsupported { .. } => Failure::Usage(error.to_string()),
        _ => Failure::NotReached(error.to_string()),
    }
}

/// Prints one JSON object, or array, on standard output.
pub fn print_json(what: &impl Serialize) -> Result<(), Failure> {
    let json = serde_json::to_string(what);
    print(&json.expect("bug: numbers and strings always serialise"))
}

/// Prints one line on standard output.
pub fn print(line: &str) -> Result<(), Failure> {
    use std::io::{ErrorKind, Write};
    if voice::keep(line, |kept| &mut kept.results) {
        return Ok(());
    }
    let mut stdout = std::io::stdout().lock();
    writeln!(stdout, "{line}")
        .and_then(|()| stdout.flush())
        .map_err(|error| match error.kind() {
            ErrorKind::BrokenPipe => Failure::BrokenPipe,
            _ => Failure::NotReached(format!("cannot write to standard output: {error}")),
        })
}
