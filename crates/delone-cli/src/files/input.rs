//! Inputs as the command line names them, and what of them is left unused.

use super::unreadable;
use crate::exit::Failure;
use crate::progress::Progress;
use crate::refinable::Refinable;
use delone_io::{
    Column, DomainData, Error, Format, LeftOut, MeshData, PointSet, ReadOptions, Source,
};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Bytes of a file that betray its format.
const HEAD: u64 = 4096;

/// Options about inputs.
#[derive(clap::Args, Default)]
#[command(next_help_heading = "Files")]
pub struct Reading {
    /// Columns of x and y in a table: their names, or their places counted from 1
    #[arg(long, value_name = "X,Y", value_parser = columns)]
    columns: Option<[Column; 2]>,
    /// Format of the input, whatever its name and content say: poly, geojson, wkt, node, csv …
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
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

    /// Reads points and what lies between them.
    pub fn domain(&self, source: &Source, progress: &Progress) -> Result<DomainData, Failure> {
        delone_io::read_domain(source, &self.options(), progress).map_err(unreadable)
    }

    /// Reads points and triangles.
    pub fn mesh(&self, source: &Source, progress: &Progress) -> Result<MeshData, Failure> {
        delone_io::read_mesh(source, &self.options(), progress).map_err(unreadable)
    }

    /// Opens an input: from now on its format is known, if name or content tell it.
    ///
    /// A stream can be read but once, so one that has to be looked at is taken into memory.
    pub fn open(&self, arg: &Path) -> Result<Input, Failure> {
        let named = |source: &Source| match source {
            Source::Path(path) => Format::from_path(path),
            _ => None,
        };
        let source = Source::from_arg(arg);
        match self.from.or_else(|| named(&source)) {
            Some(format) => Ok(Input::new(source, Some(format), self.options())),
            None => {
                let source = in_hand(source)?;
                let format = Format::sniff(&head(&source));
                Ok(Input::new(source, format, self.options()))
            }
        }
    }

    /// Tells whether any of the options was given.
    pub fn is_given(&self) -> bool {
        self.columns.is_some() || self.from.is_some()
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

/// Takes standard input, a pipe or a device into memory; a file stays where it is.
pub fn in_hand(source: Source) -> Result<Source, Failure> {
    let mut bytes = Vec::new();
    let read = match &source {
        Source::Stdin => io::stdin().lock().read_to_end(&mut bytes),
        Source::Path(path) if is_stream(path) => {
            File::open(path).and_then(|mut file| file.read_to_end(&mut bytes))
        }
        _ => return Ok(source),
    };
    let name = source.to_string();
    match read {
        Ok(_) => Ok(Source::Memory { name, bytes }),
        Err(source) => Err(unreadable(Error::Io {
            action: "read",
            file: name,
            source,
        })),
    }
}

fn is_stream(path: &Path) -> bool {
    path.metadata().is_ok_and(|m| !m.is_file() && !m.is_dir())
}

/// Returns the first bytes; none if there are none to be had, which the reader will explain.
pub fn head(source: &Source) -> Vec<u8> {
    match source {
        Source::Memory { bytes, .. } => bytes[..bytes.len().min(HEAD as usize)].to_vec(),
        Source::Path(path) if path.is_file() => {
            let mut bytes = Vec::new();
            let read = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut bytes));
            read.map_or_else(|_| Vec::new(), |_| bytes)
        }
        _ => Vec::new(),
    }
}

/// An input whose format has been looked at.
pub struct Input {
    source: Source,
    format: Option<Format>,
    options: ReadOptions,
    /// Whether an array holds the corners of triangles, whose points stand beside it.
    holds_corners: bool,
}

impl Input {
    /// Takes a source of a format.
    pub fn new(source: Source, format: Option<Format>, options: ReadOptions) -> Self {
        let mut input = Self {
            source,
            format,
            options,
            holds_corners: false,
        };
        // Who names columns means the numbers in this very array.
        input.holds_corners = format == Some(Format::Npy)
            && input.options.columns.is_none()
            && input.beside("points.npy").is_some()
            && holds_corners(&head(&input.source));
        input
    }

    /// Returns the name, as the command line has it.
    pub fn name(&self) -> String {
        self.source.to_string()
    }

    /// Tells whether the input brings triangles, in itself or in a file beside it.
    pub fn brings_triangles(&self) -> bool {
        match self.format {
            Some(Format::Ele | Format::Vtu) => true,
            Some(Format::Node) => self.beside("ele").is_some(),
            Some(Format::Npy) => self.holds_corners,
            _ => false,
        }
    }

    /// Tells whether the input is itself a mesh, and does not just stand beside one.
    fn is_mesh(&self) -> bool {
        self.format != Some(Format::Node) && self.brings_triangles()
    }

    /// Tells whether the input may bring segments.
    pub fn brings_segments(&self) -> bool {
        self.format.is_some_and(Format::reads_segments)
    }

    /// Returns the files that are read, those beside it included.
    pub fn files(&self) -> Vec<PathBuf> {
        let Source::Path(path) = &self.source else {
            return Vec::new();
        };
        let siblings: &[&str] = match self.format {
            Some(Format::Node) => &["ele", "poly"],
            Some(Format::Ele) => &["node", "poly"],
            Some(Format::Poly) if names_no_points(&head(&self.source)) => &["node"],
            Some(Format::Npy) if self.holds_corners => &["points.npy", "segments.npy"],
            _ => &[],
        };
        let siblings = siblings.iter().filter_map(|s| self.beside(s));
        std::iter::once(path.clone()).chain(siblings).collect()
    }

    /// Reads the points, and says in words what is left unused of the rest.
    pub fn points(&self, progress: &Progress) -> Result<(PointSet, Vec<String>), Failure> {
        let (set, mut unused) = match (self.format, self.beside("points.npy")) {
            (Some(Format::Vtu), _) => self.points_of_mesh(progress)?,
            (_, Some(points)) if self.holds_corners => {
                let unused = format!("only the points in {} are used", points.display());
                (self.read(&Source::Path(points), progress)?, vec![unused])
            }
            (format, _) => {
                let unused = match format {
                    Some(format) if format.reads_segments() => {
                        Some("only the points are used, segments and holes are not")
                    }
                    Some(Format::Ele) => Some("only the points in the .node file are used"),
                    _ => None,
                };
                let unused = unused.map(str::to_owned).into_iter().collect();
                (self.read(&self.source, progress)?, unused)
            }
        };
        unused.extend(columns_left_out(&set));
        Ok((set, self.named(unused)))
    }

    /// Reads the points with what the input says about segments, and says in words what is left
    /// unused of the rest.
    pub fn domain(&self, progress: &Progress) -> Result<(DomainData, Vec<String>), Failure> {
        if self.brings_triangles() {
            let (points, unused) = self.points(progress)?;
            return Ok((points.into(), unused));
        }
        let domain = delone_io::read_domain(&self.source, &self.options, progress);
        let domain = domain.map_err(unreadable)?;
        let unused = columns_left_out(&domain.vertices).into_iter().collect();
        Ok((domain, self.named(unused)))
    }

    /// Reads what can be refined, with its `.area` file if `takes_areas` and there is one, and says in
    /// words what is left unused.
    pub fn refinable(
        &self,
        takes_areas: bool,
        progress: &Progress,
    ) -> Result<(Refinable, Vec<String>), Failure> {
        if !self.is_mesh() {
            let (domain, unused) = self.domain(progress)?;
            return Ok((domain.into(), unused));
        }
        let mesh = self.mesh(progress)?;
        let unused = columns_left_out(&mesh.vertices).into_iter().collect();
        if mesh.triangles.is_empty() {
            let points = DomainData::from(mesh.vertices);
            return Ok((points.into(), self.named(unused)));
        }
        let is_bounded = takes_areas && self.format == Some(Format::Ele);
        let areas = self.beside("area").filter(|_| is_bounded);
        let refinable = Refinable::of_mesh(mesh, &self.name(), areas, progress)?;
        Ok((refinable, self.named(unused)))
    }

    fn named(&self, unused: Vec<String>) -> Vec<String> {
        let name = self.name();
        let unused = unused.iter().map(|what| format!("{name}: {what}"));
        unused.collect()
    }

    fn points_of_mesh(&self, progress: &Progress) -> Result<(PointSet, Vec<String>), Failure> {
        let mesh = self.mesh(progress)?;
        let mut unused = Vec::new();
        if !mesh.triangles.is_empty() {
            unused.push("only the points are used, triangles and their data are not".to_owned());
        }
        Ok((mesh.vertices, unused))
    }

    /// Reads points and triangles.
    pub fn mesh(&self, progress: &Progress) -> Result<MeshData, Failure> {
        delone_io::read_mesh(&self.source, &self.options, progress).map_err(unreadable)
    }

    fn read(&self, source: &Source, progress: &Progress) -> Result<PointSet, Failure> {
        delone_io::read_points(source, &self.options, progress).map_err(unreadable)
    }

    /// Returns the file of the same stem with another extension, if there is one.
    fn beside(&self, extension: &str) -> Option<PathBuf> {
        match &self.source {
            Source::Path(path) => Some(path.with_extension(extension)).filter(|p| p.is_file()),
            _ => None,
        }
    }
}

fn columns_left_out(set: &PointSet) -> Option<String> {
    let columns: Vec<String> = set.left_out.iter().map(|c| in_words(c, set)).collect();
    let columns = columns.join(", ");
    let says = || format!("left out, because they hold no numbers: {columns}");
    (!columns.is_empty()).then(says)
}

/// Names a column that was left out; if it began with numbers, with what stands there instead, and where.
fn in_words(left_out: &LeftOut, set: &PointSet) -> String {
    let LeftOut { name, point, text } = left_out;
    match set.lines.of(*point) {
        Some(line) if *point > 0 => format!("{name} (line {line}: {text:?})"),
        _ => name.clone(),
    }
}

/// Tells whether the head of an array declares integers in rows of three.
fn holds_corners(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    let value = |key: &str, end: char| {
        let (_, rest) = text.split_once(key)?;
        rest.split_once(end).map(|(value, _)| value)
    };
    let kind = value("'descr':", ',').map(|v| v.trim_start_matches([' ', '\'', '<', '>', '|']));
    let shape = value("'shape':", ')').map(str::trim_end);
    kind.is_some_and(|k| k.starts_with(['i', 'u'])) && shape.is_some_and(|s| s.ends_with(", 3"))
}

/// Tells whether a `.poly` file declares no points, so that they are read from the `.node` file.
fn names_no_points(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    let mut lines = text
        .lines()
        .map(|l| l.split('#').next().unwrap_or(l).trim());
    let header = lines.find(|l| !l.is_empty());
    header.is_some_and(|l| l.split_whitespace().next() == Some("0"))
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

    #[test]
    fn corners_are_integers_in_rows_of_three() {
        let head = |descr, shape| {
            format!(
                "\u{93}NUMPY{{'descr': '{descr}', 'fortran_order': False, 'shape': ({shape}), }}"
            )
        };
        for (descr, shape, expected) in [
            ("<i4", "7, 3", true),
            ("|u1", "7, 3", true),
            ("<f8", "7, 3", false),
            ("<i8", "7, 2", false),
            ("<i8", "3,", false),
        ] {
            let head = head(descr, shape);
            assert_eq!(holds_corners(head.as_bytes()), expected, "{head}");
        }
    }

    #[test]
    fn a_poly_without_points_declares_zero() {
        assert!(names_no_points(b"# of k.node\n0 2 0 0\n1 0\n"));
        assert!(!names_no_points(b"3 2 0 0\n0 0 0\n"));
    }
}
