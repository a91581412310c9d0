//! Inputs and outputs as the command line names them.

use crate::exit::Failure;
use crate::progress::Progress;
use delone_io::{
    Column, Error, Format, MeshData, MeshView, PictureOptions, PointSet, ReadOptions, Source,
    Target, WriteOptions,
};
use std::path::{Path, PathBuf};

/// Options about inputs.
#[derive(clap::Args, Default)]
pub struct Reading {
    /// Columns of x and y in a table: their names, or their places counted from 1
    #[arg(long, value_name = "X,Y", value_parser = columns)]
    columns: Option<[Column; 2]>,
    /// Format of the input where neither its name nor its content tells: node, csv, npy, vtu …
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
}

/// Options about outputs.
#[derive(clap::Args)]
pub struct Writing {
    /// Number points and triangles from 1 instead of 0 in .node, .ele, .edge and .neigh
    #[arg(long)]
    one_based: bool,
    /// Format of outputs whose name does not tell, such as `-`: node, ele, csv, npy, vtu, svg, png …
    #[arg(long, value_name = "FORMAT", alias = "format")]
    to: Option<Format>,
    /// Longer side of pictures, in pixels
    #[arg(long, value_name = "PIXELS", default_value_t = PictureOptions::default().size,
          value_parser = clap::value_parser!(u32).range(16..=8192))]
    size: u32,
}

fn columns(text: &str) -> Result<[Column; 2], String> {
    let parse = |column: &str| column.trim().parse::<Column>().ok();
    let Some((x, y)) = text.split_once(',') else {
        return Err("two columns are needed, as in `lon,lat` or `2,3`".to_owned());
    };
    parse(x)
        .zip(parse(y))
        .map(|(x, y)| [x, y])
        .ok_or_else(|| format!("{text:?} names no columns"))
}

impl Reading {
    /// Reads points.
    pub fn points(&self, source: &Source, progress: &Progress) -> Result<PointSet, Failure> {
        delone_io::read_points(source, &self.options(), progress).map_err(unreadable)
    }

    /// Reads points and triangles.
    pub fn mesh(&self, source: &Source, progress: &Progress) -> Result<MeshData, Failure> {
        delone_io::read_mesh(source, &self.options(), progress).map_err(unreadable)
    }

    /// Returns the format that was asked for, or that the name tells.
    pub fn format(&self, source: &Source) -> Option<Format> {
        let by_name = || match source {
            Source::Path(path) => Format::from_path(path),
            _ => None,
        };
        self.from.or_else(by_name)
    }

    /// Returns the options for a second input, which has a format of its own.
    pub fn of_another_file(&self) -> Self {
        Self {
            columns: self.columns.clone(),
            from: None,
        }
    }

    fn options(&self) -> ReadOptions {
        ReadOptions {
            format: self.from,
            columns: self.columns.clone(),
        }
    }
}

/// Outputs whose names, formats and folders have been looked at before the work begins.
#[derive(Default)]
pub struct Outputs {
    files: Vec<Target>,
    stream: Option<Target>,
}

impl Outputs {
    /// Tells whether something goes to standard output.
    pub fn use_stdout(&self) -> bool {
        self.stream.is_some()
    }

    /// Tells whether there is nothing to write.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty() && self.stream.is_none()
    }

    fn add(&mut self, target: Target) -> Result<(), Failure> {
        match &target.path {
            Some(path) => require_folder(path)?,
            None if self.stream.is_some() => {
                let twice = "only one output can go to standard output; give the others a name";
                return Err(Failure::Usage(twice.to_owned()));
            }
            None => {
                self.stream = Some(target);
                return Ok(());
            }
        }
        self.files.push(target);
        Ok(())
    }
}

fn require_folder(path: &Path) -> Result<(), Failure> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => return Ok(()),
    };
    if folder.is_dir() {
        Ok(())
    } else {
        let [path, folder] = [path, folder].map(Path::display);
        Err(Failure::NotReached(format!(
            "cannot write {path}: there is no folder {folder}; create it first"
        )))
    }
}

/// What an output must be able to hold.
#[derive(Clone, Copy)]
pub enum Content {
    /// Points alone.
    Points,
    /// Points and triangles.
    Mesh,
    /// A picture.
    Picture,
}

impl Content {
    fn fits(self, format: Format) -> bool {
        match self {
            Self::Points => format.writes_points(),
            Self::Mesh => format.writes_mesh(),
            Self::Picture => format.is_picture(),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Mesh => "a mesh",
            Self::Picture => "a picture",
        }
    }

    /// Says why an output of the format that was `told` will not do.
    fn misfit(self, path: &Path, told: Option<Format>) -> Failure {
        let [path, what] = [path.display().to_string(), self.name().to_owned()];
        let names = Format::ALL.map(|f| self.fits(f).then_some(f.name()));
        let names: Vec<&str> = names.into_iter().flatten().collect();
        let names = names.join(", ");
        Failure::Usage(match told {
            Some(format) => format!("{path}: {format} cannot hold {what}; these can: {names}"),
            None => format!(
                "{path}: the name tells no format; add an extension or --to with one of: {names}"
            ),
        })
    }
}

impl Writing {
    /// Settles where and how to write, or says what is wrong with the names.
    pub fn outputs(
        &self,
        wanted: impl IntoIterator<Item = (PathBuf, Content)>,
    ) -> Result<Outputs, Failure> {
        let mut outputs = Outputs::default();
        for (path, content) in wanted {
            outputs.add(self.target(path, content)?)?;
        }
        Ok(outputs)
    }

    /// Settles on standard output alone.
    pub fn stdout(&self, default: Format) -> Outputs {
        let format = Some(self.to.unwrap_or(default));
        Outputs {
            stream: Some(Target { path: None, format }),
            ..Outputs::default()
        }
    }

    /// Returns the format that the name tells, or that was asked for.
    pub fn format(&self, path: &Path) -> Option<Format> {
        Format::from_path(path).or(self.to)
    }

    fn target(&self, path: PathBuf, content: Content) -> Result<Target, Failure> {
        let told = self.format(&path);
        match told.filter(|f| content.fits(*f)) {
            // A family of files cannot stand beside a device, so both names mean the stream.
            Some(format) if path == Path::new("/dev/stdout") => {
                Ok(Target::from_arg("-", Some(format)))
            }
            Some(format) => Ok(Target::from_arg(path, Some(format))),
            None => Err(content.misfit(&path, told)),
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
        write(outputs, |targets| {
            delone_io::write_mesh(targets, mesh, &options, progress)
        })
    }

    /// Writes points and returns the names of the files.
    pub fn points(
        &self,
        outputs: &Outputs,
        points: &PointSet,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let options = self.options();
        write(outputs, |targets| {
            delone_io::write_points(targets, points, &options, progress)
        })
    }

    fn options(&self) -> WriteOptions {
        WriteOptions {
            one_based: self.one_based,
            picture: PictureOptions {
                size: self.size,
                ..PictureOptions::default()
            },
        }
    }
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

fn unreadable(error: Error) -> Failure {
    match error {
        Error::Cancelled => Failure::Cancelled,
        Error::NoSuchColumn { .. } => Failure::Usage(error.to_string()),
        _ => Failure::BadInput(error.to_string()),
    }
}

fn unwritable(error: Error) -> Failure {
    match error {
        Error::Cancelled => Failure::Cancelled,
        Error::Io { file, source, .. }
            if file == "-" && source.kind() == std::io::ErrorKind::BrokenPipe =>
        {
            Failure::BrokenPipe
        }
        _ => Failure::NotReached(error.to_string()),
    }
}

/// Prints one line on standard output.
pub fn print(line: &str) -> Result<(), Failure> {
    use std::io::{ErrorKind, Write};
    let mut stdout = std::io::stdout().lock();
    writeln!(stdout, "{line}")
        .and_then(|()| stdout.flush())
        .map_err(|error| match error.kind() {
            ErrorKind::BrokenPipe => Failure::BrokenPipe,
            _ => Failure::NotReached(format!("cannot write to standard output: {error}")),
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_two_names_or_places_from_one() {
        assert_eq!(
            columns("lon, lat"),
            Ok(["lon", "lat"].map(|n| Column::Name(n.to_owned())))
        );
        assert_eq!(columns("2,1"), Ok([1, 0].map(Column::Index)));
        assert!(columns("lon").is_err());
    }
}
