//! Inputs as the command line names them, and what of them is left unused.

use super::head::{head, holds_corners, in_hand, names_no_points, sniff};
use super::notes::notes;
use super::{region, unreadable};
use crate::config;
use crate::exit::Failure;
use crate::progress::Progress;
use crate::refinable::Refinable;
use crate::{voice, words};
use delone_io::{Column, DomainData, Format, MeshData, PointSet, ReadOptions, Returns, Source};
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Options about inputs.
#[derive(clap::Args, Clone, Default, PartialEq)]
#[command(next_help_heading = "Files")]
pub struct Reading {
    /// Columns of x and y in a table: their names, or their places counted from 1
    #[arg(long, value_name = "X,Y", value_parser = columns)]
    columns: Option<[Column; 2]>,
    /// Format of the input, whatever its name and content say: poly, geojson, wkt, node, csv …
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    /// Classes of the points to take from a .las or .laz, as in 2 or 2,9 (2 ground, 6 buildings, 9 water)
    #[arg(long = "class", value_name = "CLASSES", value_delimiter = ',')]
    classes: Vec<u8>,
    /// Returns of a laser's pulse to take from a .las or .laz
    #[arg(long = "return", value_name = "WHICH", value_enum, default_value_t)]
    returns: Return,
    /// Farthest that a curve of a .dxf or .svg may be from the lines that replace it, in units of the
    /// drawing [default: a thousandth of the curve's size]
    #[arg(long, value_name = "LENGTH", value_parser = flatness)]
    flatness: Option<f64>,
    /// Regions to take from a mesh, as in 2 or 1,3: their triangles alone, by the attribute `region`
    #[arg(
        long = "region",
        value_name = "REGIONS",
        value_delimiter = ',',
        allow_negative_numbers = true
    )]
    regions: Vec<f64>,
    /// Layers to take from a .dxf; their names, set apart by commas
    #[arg(long = "layer", value_name = "LAYERS", value_delimiter = ',')]
    layers: Vec<String>,
}

/// Writes a column as the option takes it.
fn word(column: &Column) -> String {
    match column {
        Column::Name(name) => name.clone(),
        Column::Index(place) => (place + 1).to_string(),
    }
}

/// Which returns of a laser's pulse are taken.
#[derive(Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum)]
enum Return {
    /// Every one
    #[default]
    All,
    /// The first of each pulse
    First,
    /// The last of each pulse
    Last,
    /// The only one of its pulse
    Single,
}

impl From<Return> for Returns {
    fn from(wanted: Return) -> Self {
        match wanted {
            Return::All => Self::All,
            Return::First => Self::First,
            Return::Last => Self::Last,
            Return::Single => Self::Single,
        }
    }
}

fn flatness(text: &str) -> Result<f64, String> {
    let length = text
        .parse()
        .ok()
        .filter(|l: &f64| l.is_finite() && *l > 0.0);
    length.ok_or_else(|| format!("{text:?} is not a positive length"))
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

    /// Opens an input: from now on its format is known, if name or content tell it.
    ///
    /// A stream can be read but once, so one that has to be looked at is taken into memory.
    pub fn open(&self, arg: &Path) -> Result<Input, Failure> {
        let source = Source::from_arg(arg);
        let (source, format, why) = match (self.from, &source) {
            (Some(format), _) => (source, Some(format), "as --from says"),
            (None, Source::Path(path)) if Format::from_path(path).is_some() => {
                let format = Format::detect(Some(path), &head(&source));
                let why = match format == Format::from_path(path) {
                    true => "as its name says",
                    false => "by its name and content",
                };
                (source, format, why)
            }
            _ => {
                let source = in_hand(source)?;
                let format = sniff(&source);
                (source, format, "by its content")
            }
        };
        if let Some(format) = format.filter(|_| voice::is_verbose()) {
            voice::say(&format!("{source}: {format}, {why}"));
        }
        let input = Input::new(source, format, self.options());
        Ok(input.of_regions(self.regions.clone()))
    }

    /// Tells whether any of the options was given.
    pub fn is_given(&self) -> bool {
        *self != Self::default()
    }

    /// Returns the options for a second input, which has a format of its own.
    pub fn of_another_file(&self) -> Self {
        Self {
            from: None,
            regions: Vec::new(),
            ..self.clone()
        }
    }

    /// Lists the options that were given, as `name=value`.
    pub fn given(&self) -> Vec<String> {
        let returns = match self.returns {
            Return::All => None,
            Return::First => Some("first"),
            Return::Last => Some("last"),
            Return::Single => Some("single"),
        };
        let columns = self.columns.as_ref();
        let columns = columns.map(|[x, y]| format!("columns={},{}", word(x), word(y)));
        let all = |name: &str, values: Vec<String>| {
            (!values.is_empty()).then(|| format!("{name}={}", values.join(",")))
        };
        let single = [
            columns,
            self.from.map(|format| format!("from={format}")),
            all("class", self.classes.iter().map(u8::to_string).collect()),
            returns.map(|which| format!("return={which}")),
            self.flatness.map(|length| format!("flatness={length}")),
            all("region", self.regions.iter().map(f64::to_string).collect()),
            all("layer", self.layers.clone()),
        ];
        single.into_iter().flatten().collect()
    }

    /// Reads options as [`given`](Self::given) lists them.
    ///
    /// *Errors*: in words, if they are none.
    pub fn named(options: &[String]) -> Result<Self, String> {
        #[derive(clap::Parser)]
        #[command(no_binary_name = true)]
        struct Line {
            #[command(flatten)]
            reading: Reading,
        }
        let line = options.iter().map(|option| format!("--{option}"));
        let line = <Line as clap::Parser>::try_parse_from(line);
        line.map(|line| line.reading)
            .map_err(|error| config::in_words(&error))
    }

    fn options(&self) -> ReadOptions {
        ReadOptions {
            format: self.from,
            columns: self.columns.clone(),
            classes: self.classes.clone(),
            returns: self.returns.into(),
            flatness: self.flatness,
            layers: self.layers.clone(),
        }
    }
}

/// An input whose format has been looked at.
pub struct Input {
    source: Source,
    format: Option<Format>,
    options: ReadOptions,
    /// Whether an array holds the corners of triangles, whose points stand beside it.
    holds_corners: bool,
    /// The regions of a mesh that are taken; none means all.
    regions: Vec<f64>,
    /// What a file holds that had to be read to know whether there are triangles in it.
    held: RefCell<Option<MeshData>>,
}

impl Input {
    /// Takes a source of a format.
    pub fn new(source: Source, format: Option<Format>, options: ReadOptions) -> Self {
        let mut input = Self {
            source,
            format,
            options,
            holds_corners: false,
            regions: Vec::new(),
            held: RefCell::default(),
        };
        // Who names columns means the numbers in this very array.
        let is_alone = |points| input.beside(points).is_none();
        input.holds_corners = input.options.columns.is_none()
            && match format {
                Some(Format::Npy) => !is_alone("points.npy") && holds_corners(&head(&input.source)),
                Some(Format::Parquet) => !is_alone("points.parquet"),
                _ => false,
            };
        input
    }

    /// Returns the name, as the command line has it.
    pub fn name(&self) -> String {
        self.source.to_string()
    }

    /// Takes of a mesh some regions alone.
    fn of_regions(self, regions: Vec<f64>) -> Self {
        Self { regions, ..self }
    }

    /// Tells whether only the content says if there are triangles, lines or just points.
    fn must_be_looked_into(&self) -> bool {
        use Format::{Ele, Node, Npy, Parquet};
        self.format
            .is_some_and(|f| f.reads_mesh() && !matches!(f, Node | Ele | Npy | Parquet))
    }

    /// Asks the content; it is kept for whoever reads it next.
    fn look<T>(&self, progress: &Progress, at: impl Fn(&MeshData) -> T) -> Result<T, Failure> {
        if let Some(mesh) = &*self.held.borrow() {
            return Ok(at(mesh));
        }
        let mesh = self.read_mesh(progress)?;
        let seen = at(&mesh);
        self.held.replace(Some(mesh));
        Ok(seen)
    }

    /// Tells whether the input brings triangles, in itself or in a file beside it. Some formats hold triangles, lines
    /// or points, and have to be read for that.
    pub fn brings_triangles(&self, progress: &Progress) -> Result<bool, Failure> {
        match self.format {
            _ if self.must_be_looked_into() => self.look(progress, |m| !m.triangles.is_empty()),
            Some(Format::Ele) => Ok(true),
            Some(Format::Node) => Ok(self.beside("ele").is_some()),
            Some(Format::Npy | Format::Parquet) => Ok(self.holds_corners),
            _ => Ok(false),
        }
    }

    /// Tells whether the input is itself a mesh, and does not just stand beside one.
    fn is_mesh(&self, progress: &Progress) -> Result<bool, Failure> {
        Ok(self.format != Some(Format::Node) && self.brings_triangles(progress)?)
    }

    /// Tells whether the input may bring segments.
    pub fn brings_segments(&self, progress: &Progress) -> Result<bool, Failure> {
        if self.must_be_looked_into() {
            return self.look(progress, has_segments);
        }
        Ok(self.format.is_some_and(Format::reads_segments))
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
            Some(Format::Parquet) if self.holds_corners => &["points.parquet", "segments.parquet"],
            Some(Format::Shp) => &["dbf"],
            _ => &[],
        };
        let siblings = siblings.iter().filter_map(|s| self.beside(s));
        std::iter::once(path.clone()).chain(siblings).collect()
    }

    /// Reads the points, and says in words what is left unused of the rest.
    pub fn points(&self, progress: &Progress) -> Result<(PointSet, Vec<String>), Failure> {
        let points = match self.format {
            Some(Format::Parquet) => self.beside("points.parquet"),
            _ => self.beside("points.npy"),
        };
        let (set, mut unused) = match (self.format, points) {
            _ if self.must_be_looked_into() || !self.regions.is_empty() => {
                self.points_of_mesh(progress)?
            }
            (_, Some(points)) if self.holds_corners => {
                let unused = format!("only the points in {} are used", points.display());
                (self.read(&Source::Path(points), progress)?, vec![unused])
            }
            (format, _) => {
                let unused = match format {
                    Some(format) if format.reads_segments() => {
                        Some("only the points are used, segments and holes are not".to_owned())
                    }
                    Some(Format::Ele) => Some(match self.beside("poly") {
                        Some(graph) => format!(
                            "only the points in the .node file are used, the segments in {} are not",
                            graph.display()
                        ),
                        None => "only the points in the .node file are used".to_owned(),
                    }),
                    _ => None,
                };
                let unused = unused.into_iter().collect();
                (self.read(&self.source, progress)?, unused)
            }
        };
        unused.extend(notes(&set));
        progress.detail(|| format!("{}: {}", self.name(), words::points(&set)));
        Ok((set, self.named(unused)))
    }

    /// Reads the points with what the input says about segments, and says in words what is left
    /// unused of the rest.
    pub fn domain(&self, progress: &Progress) -> Result<(DomainData, Vec<String>), Failure> {
        if self.brings_triangles(progress)? || !self.regions.is_empty() {
            let (points, unused) = self.points(progress)?;
            return Ok((points.into(), unused));
        }
        let held = self.held.take();
        let domain = match held {
            // What bounds the parts of one of these is not known to a mesh.
            Some(mesh) if self.format != Some(Format::Jigsaw) => mesh.into(),
            _ => {
                let domain = delone_io::read_domain(&self.source, &self.options, progress);
                domain.map_err(unreadable)?
            }
        };
        let unused = notes(&domain.vertices);
        progress.detail(|| format!("{}: {}", self.name(), words::read(&domain)));
        Ok((domain, self.named(unused)))
    }

    /// Reads what can be refined, with its `.area` file if `takes_areas` and there is one, and says in
    /// words what is left unused.
    pub fn refinable(
        &self,
        takes_areas: bool,
        progress: &Progress,
    ) -> Result<(Refinable, Vec<String>), Failure> {
        if !self.is_mesh(progress)? {
            let (domain, unused) = self.domain(progress)?;
            return Ok((domain.into(), unused));
        }
        let mesh = self.mesh(progress)?;
        let unused = notes(&mesh.vertices);
        if mesh.triangles.is_empty() {
            let points = DomainData::from(mesh.vertices);
            return Ok((points.into(), self.named(unused)));
        }
        let is_bounded = takes_areas && self.format == Some(Format::Ele);
        let areas = self.beside("area").filter(|_| is_bounded);
        if areas.is_some() && !self.regions.is_empty() {
            let both = "--region takes some triangles alone, so an .area file for all does not fit";
            return Err(Failure::Usage(both.to_owned()));
        }
        let refinable = Refinable::of_mesh(mesh, &self.name(), areas, progress)?;
        Ok((refinable, self.named(unused)))
    }

    /// Puts the name before what is said about the input.
    pub fn named(&self, unused: Vec<String>) -> Vec<String> {
        let name = self.name();
        let unused = unused.iter().map(|what| format!("{name}: {what}"));
        unused.collect()
    }

    fn points_of_mesh(&self, progress: &Progress) -> Result<(PointSet, Vec<String>), Failure> {
        let mesh = self.mesh(progress)?;
        let unused = match (!mesh.triangles.is_empty(), has_segments(&mesh)) {
            (true, true) => {
                Some("only the points are used, triangles, segments and their data are not")
            }
            (true, false) => Some("only the points are used, triangles and their data are not"),
            (false, true) => Some("only the points are used, segments are not"),
            (false, false) => None,
        };
        let unused = unused.map(str::to_owned).into_iter().collect();
        Ok((mesh.vertices, unused))
    }

    /// Reads points and triangles: those of the regions that are taken.
    pub fn mesh(&self, progress: &Progress) -> Result<MeshData, Failure> {
        let held = self.held.take();
        let mesh = held.map_or_else(|| self.read_mesh(progress), Ok)?;
        match self.regions.as_slice() {
            [] => Ok(mesh),
            wanted => region::restrict(mesh, wanted, &self.name()),
        }
    }

    fn read_mesh(&self, progress: &Progress) -> Result<MeshData, Failure> {
        let mesh = delone_io::read_mesh(&self.source, &self.options, progress);
        let mesh = mesh.map_err(unreadable)?;
        progress.detail(|| {
            let triangles = words::counted(mesh.triangles.len(), "triangle", "triangles");
            format!(
                "{}: {triangles}, {}",
                self.name(),
                words::points(&mesh.vertices)
            )
        });
        Ok(mesh)
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

fn has_segments(mesh: &MeshData) -> bool {
    mesh.constraints
        .as_ref()
        .is_some_and(|c| !c.edges.is_empty())
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
    fn options_can_be_listed_and_read_again() {
        let some = Reading {
            columns: Some([Column::Name("lon".to_owned()), Column::Index(3)]),
            from: Some(Format::Table),
            classes: vec![2, 9],
            returns: Return::Last,
            flatness: Some(1e-9),
            regions: vec![-1.5, 3.0],
            layers: ["walls", "north side"].map(str::to_owned).to_vec(),
        };
        let listed = some.given();
        assert_eq!(listed.len(), 7);
        assert_eq!(listed[0], "columns=lon,4");
        assert_eq!(listed[5], "region=-1.5,3");
        for reading in [some, Reading::default()] {
            assert!(Reading::named(&reading.given()) == Ok(reading));
        }
        for wrong in ["flatness=-1", "output=a.csv", "help", "class=300"] {
            assert!(Reading::named(&[wrong.to_owned()]).is_err(), "{wrong}");
        }
    }
}
