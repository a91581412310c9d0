//! The files that an output consists of, and which of them are in the way of others.

use super::Content;
use crate::exit::Failure;
use delone_io::Format;
use std::path::{Path, PathBuf};

/// What one file of an output holds: files of one name must hold the same.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Whole(Format),
    Corners,
    Coordinates,
    Edges,
    Page,
    /// Points besides something else, which may be points too.
    Sites,
    /// Something that no other output is.
    Own,
}

/// A file that is going to be written.
pub struct Member {
    /// The output as the command line names it.
    output: PathBuf,
    name: PathBuf,
    part: Part,
    /// Its one true name; devices and pipes, which nothing can overwrite, have none.
    place: Option<PathBuf>,
}

/// Lists the files of an output.
pub fn members(output: &Path, format: Format, content: Content) -> Vec<Member> {
    let sibling = |extension: &str, part| member(output, output.with_extension(extension), part);
    let whole = |part| member(output, output.to_owned(), part);
    match (format, content) {
        (Format::Npy, Content::Mesh) => vec![
            whole(Part::Corners),
            sibling("points.npy", Part::Coordinates),
            // This one, and the .poly below, only if there are segments.
            sibling("segments.npy", Part::Edges),
        ],
        (Format::Parquet, Content::Mesh) => vec![
            whole(Part::Corners),
            sibling("points.parquet", Part::Coordinates),
            sibling("segments.parquet", Part::Edges),
        ],
        (_, Content::Sites) => vec![whole(Part::Sites)],
        (Format::Npy | Format::Parquet, _) => vec![whole(Part::Coordinates)],
        (
            Format::Node | Format::Ele | Format::Edge | Format::Neigh | Format::Poly,
            Content::Mesh | Content::QuadraticMesh,
        ) => [
            Format::Node,
            Format::Ele,
            Format::Edge,
            Format::Neigh,
            Format::Poly,
        ]
        .map(|f| sibling(f.name(), Part::Whole(f)))
        .into(),
        (_, Content::Diagram) => vec![
            sibling("node", Part::Whole(Format::Node)),
            sibling("edge", Part::Whole(Format::Edge)),
        ],
        (_, Content::Report) => vec![whole(Part::Page)],
        _ => vec![whole(Part::Whole(format))],
    }
}

/// The file of an output that consists of one, and is nothing else.
pub fn alone(output: &Path) -> Member {
    member(output, output.to_owned(), Part::Own)
}

fn member(output: &Path, name: PathBuf, part: Part) -> Member {
    Member {
        output: output.to_owned(),
        place: place(&name),
        name,
        part,
    }
}

/// Returns the one true name of a file that exists or might; `None` for devices and pipes.
pub fn place(path: &Path) -> Option<PathBuf> {
    match path.metadata() {
        Ok(known) if !known.is_file() && !known.is_dir() => None,
        Ok(_) => path.canonicalize().ok(),
        Err(_) => {
            let folder = match path.parent() {
                Some(parent) if !parent.as_os_str().is_empty() => parent,
                _ => Path::new("."),
            };
            Some(folder.canonicalize().ok()?.join(path.file_name()?))
        }
    }
}

impl Member {
    /// Returns the output that the file belongs to, its name, and its one true name if it has one.
    pub fn names(&self) -> (&Path, &Path, Option<&Path>) {
        (&self.output, &self.name, self.place.as_deref())
    }

    /// Requires that the file can be made: its folder is there, and it is none itself.
    pub fn require_writable(&self) -> Result<(), Failure> {
        let name = self.name.display();
        if self.name.is_dir() {
            let problem = format!("cannot write {name}: it is a folder; name a file");
            return Err(Failure::NotReached(problem));
        }
        match self.name.parent() {
            Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
                let folder = folder.display();
                Err(Failure::NotReached(format!(
                    "cannot write {name}: there is no folder {folder}; create it first"
                )))
            }
            _ => Ok(()),
        }
    }

    /// Requires that no file written for another output has this name but other content.
    pub fn require_apart_from(&self, other: &Self) -> Result<(), Failure> {
        if self.part == other.part || self.place.is_none() || self.place != other.place {
            return Ok(());
        }
        let [first, second, name] = [&other.output, &self.output, &self.name].map(|p| p.display());
        Err(Failure::Usage(format!(
            "outputs {first} and {second} would both write {name}; name another output"
        )))
    }

    /// Requires that this is none of the files that are read.
    pub fn require_not_among(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        let is_this = |input: &&PathBuf| self.place.is_some() && place(input) == self.place;
        let Some(input) = inputs.iter().find(is_this) else {
            return Ok(());
        };
        let [output, name, input] = [&self.output, &self.name, input].map(|p| p.display());
        let what = if self.output == self.name {
            format!("output {output}")
        } else {
            format!("output {output} with its file {name}")
        };
        Err(Failure::Usage(format!(
            "{what}: {input} is the input; name another output"
        )))
    }
}
