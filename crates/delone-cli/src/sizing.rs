//! `--sizing`: how large triangles may be, place by place.

mod expression;
mod spec;

use crate::exit::Failure;
use crate::files::Reading;
use crate::numbering::Numbering;
use crate::progress::Progress;
use delone::sizing::{Areas, Background, Distance, Smallest};
use delone::{Point, SizingField, VertexId};
use delone_io::{DomainData, PointSet};
use expression::Expression;
use spec::{Features, Spec};
use std::fmt;
use std::path::{Path, PathBuf};

/// Options about sizes that depend on the place.
#[derive(clap::Args, Clone, Default)]
pub struct Sizing {
    /// Longest edge place by place: an expression of x and y, FILE:COLUMN, or
    /// distance:WHAT,at=SIZE,growth=RATE; repeatable, the smallest wins
    ///
    /// SPEC is one of
    ///
    ///   EXPRESSION   of x and y, as `0.01 + 0.1*hypot(x-3, y)`, with + - * / ^ ( ), pi, and the
    ///   functions abs sqrt exp ln log10 sin cos tan asin acos atan tanh, hypot atan2 pow of two
    ///   numbers, min max of any;
    ///
    ///   FILE:COLUMN   as `sizes.csv:size`: sizes at points (CSV, XYZ, .node …), linear in between, or
    ///   at the vertices of a mesh (.vtu, .ele), linear on its triangles; outside, those of the nearest
    ///   place. Columns have the names that the file gives them, or z, column4, attribute1 …;
    ///
    ///   distance:WHAT,at=SIZE,growth=RATE[,max=SIZE]   grows from SIZE with the distance: size = at +
    ///   growth × distance, at most max. WHAT is `segments` or `points`, those of the input, or a file
    ///   of points or of a domain. Growths from 0.1 to 0.5 are usual.
    ///
    /// Sizes must be positive. They hold besides --max-edge.
    #[arg(
        long = "sizing",
        value_name = "SPEC",
        verbatim_doc_comment,
        allow_hyphen_values = true
    )]
    specs: Vec<Spec>,
}

impl Sizing {
    /// Tells whether any size is asked for.
    pub fn is_given(&self) -> bool {
        !self.specs.is_empty()
    }

    /// Returns the files that are read, which no output may overwrite.
    pub fn files(&self) -> Vec<PathBuf> {
        let named = self.specs.iter().filter_map(Spec::file);
        let inputs = named.filter_map(|file| Reading::default().open(file).ok());
        inputs.flat_map(|input| input.files()).collect()
    }

    /// Names all that is asked for, files without their folders.
    pub fn names(&self) -> Vec<String> {
        self.specs.iter().map(Spec::name).collect()
    }

    /// Takes what was [named](Self::names); files lie in `folder`.
    pub fn named(names: &[String], folder: &Path) -> Result<Self, String> {
        let specs = names
            .iter()
            .map(|name| Ok(name.parse::<Spec>()?.within(folder)));
        let specs = specs.collect::<Result<_, String>>()?;
        Ok(Self { specs })
    }

    /// Makes the field, or none if none is asked for; `domain` is the input with its points and
    /// segments still in it, and may bring `areas`.
    pub fn build(
        &self,
        domain: &DomainData,
        areas: Option<Areas>,
        progress: &Progress,
    ) -> Result<Option<Box<dyn SizingField>>, Failure> {
        let fields = self.specs.iter().map(|spec| field(spec, domain, progress));
        let areas = areas.map(|areas| Ok(Box::new(areas) as Box<dyn SizingField>));
        let mut fields = fields.chain(areas).collect::<Result<Vec<_>, Failure>>()?;
        Ok(match fields.len() {
            0 | 1 => fields.pop(),
            _ => Some(Box::new(Smallest::of(fields))),
        })
    }
}

impl fmt::Display for Sizing {
    /// Writes all that is asked for.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let specs: Vec<String> = self.specs.iter().map(Spec::to_string).collect();
        f.write_str(&specs.join("; "))
    }
}

fn field(
    spec: &Spec,
    domain: &DomainData,
    progress: &Progress,
) -> Result<Box<dyn SizingField>, Failure> {
    Ok(match spec {
        Spec::Expression(text, expression) => {
            require_sizes(text, expression, &domain.vertices)?;
            Box::new(expression.clone())
        }
        Spec::Column { file, column } => Box::new(background(file, column, progress)?),
        Spec::Distance {
            features,
            at,
            growth,
            max,
        } => {
            let (points, segments) = match features {
                Features::Points => (domain.vertices.points.clone(), Vec::new()),
                Features::Segments => (Vec::new(), segments(domain)),
                Features::File(file) => features_of(file, progress)?,
            };
            if points.is_empty() && segments.is_empty() {
                return Err(Failure::Usage(format!(
                    "{features}: there are none to measure from"
                )));
            }
            let field = Distance::from_features(&points, &segments, *at, *growth);
            let field = field.and_then(|field| field.at_most(max.unwrap_or(f64::INFINITY)));
            Box::new(
                field.map_err(|error| Failure::Usage(format!("--sizing {features}: {error}")))?,
            )
        }
    })
}

/// Refuses an expression without sizes at points of the input: it would bound nothing there.
fn require_sizes(text: &str, expression: &Expression, vertices: &PointSet) -> Result<(), Failure> {
    let sizes = vertices.points.iter().map(|&p| expression.max_edge(p));
    match sizes
        .enumerate()
        .find(|&(_, size)| size.is_nan() || size <= 0.0)
    {
        None => Ok(()),
        Some((i, size)) => {
            let (Point { x, y }, number) = (vertices.points[i], i + vertices.base as usize);
            Err(Failure::BadInput(format!(
                "--sizing `{text}` is {size} at point {number} ({x}, {y}): sizes must be positive; \
                 `max(0.01, …)` keeps them so"
            )))
        }
    }
}

/// Reads sizes at points or at the vertices of a mesh.
fn background(file: &Path, column: &str, progress: &Progress) -> Result<Background, Failure> {
    let input = Reading::default().open(file)?;
    let (vertices, triangles, others) = if input.brings_triangles(progress)? {
        let mesh = input.mesh(progress)?;
        (
            mesh.vertices,
            Some(mesh.triangles),
            mesh.triangle_attributes,
        )
    } else {
        (input.points(progress)?.0, None, Vec::new())
    };
    let named = |name: &str| name.eq_ignore_ascii_case(column);
    let Some(attribute) = vertices.attributes.iter().find(|a| named(&a.name)) else {
        let file = file.display();
        return Err(Failure::Usage(
            match others.iter().any(|a| named(&a.name)) {
                true => format!("{file}: {column} is of triangles; sizes are those of vertices"),
                false => format!("{file}: no column {column}; there {}", available(&vertices)),
            },
        ));
    };
    let (points, sizes) = (&vertices.points, &attribute.values);
    let field = match &triangles {
        Some(triangles) => Background::from_mesh(points, triangles, sizes),
        None => Background::from_points(points, sizes),
    };
    field.map_err(|error| Numbering::of_points(&input.name(), &vertices).failure(error))
}

fn available(vertices: &PointSet) -> String {
    let names: Vec<_> = vertices
        .attributes
        .iter()
        .map(|a| a.name.as_str())
        .collect();
    match names.is_empty() {
        true => "is none besides x and y".to_owned(),
        false => format!("are {}", names.join(", ")),
    }
}

/// Points and segments.
type Shapes = (Vec<Point>, Vec<[Point; 2]>);

/// Reads the segments of a file, and its points that are in none.
fn features_of(file: &Path, progress: &Progress) -> Result<Shapes, Failure> {
    let (domain, _) = Reading::default().open(file)?.domain(progress)?;
    let points = &domain.vertices.points;
    let mut is_end = vec![false; points.len()];
    for v in domain.segments.as_flattened() {
        is_end[v.index()] = true;
    }
    let loose = points.iter().zip(is_end).filter(|(_, is_end)| !is_end);
    Ok((loose.map(|(&p, _)| p).collect(), segments(&domain)))
}

fn segments(domain: &DomainData) -> Vec<[Point; 2]> {
    let at = |v: VertexId| domain.vertices.points[v.index()];
    domain.segments.iter().map(|ends| ends.map(at)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;
    use delone::Pslg;
    use std::fs;

    #[derive(clap::Parser)]
    struct Line {
        #[command(flatten)]
        sizing: Sizing,
    }

    fn sizing(specs: &[&str]) -> Sizing {
        let pairs = specs.iter().flat_map(|&spec| ["--sizing", spec]);
        Line::parse_from(["line"].into_iter().chain(pairs)).sizing
    }

    /// A line from (0, 0) to (4, 0) and a loose point at (0, 4).
    fn domain() -> DomainData {
        let mut pslg = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]);
        pslg.add_segment(0, 1);
        pslg.into()
    }

    fn build(specs: &[&str]) -> Result<Option<Box<dyn SizingField>>, Failure> {
        sizing(specs).build(&domain(), None, &Progress::new(true))
    }

    fn sizes<const N: usize>(specs: &[&str], at: [(f64, f64); N]) -> [f64; N] {
        let field = build(specs).unwrap().unwrap();
        at.map(|p| field.max_edge(p.into()))
    }

    fn refusal(spec: &str) -> Failure {
        build(&[spec]).err().expect("refused")
    }

    #[test]
    fn the_smallest_wins() {
        assert!(build(&[]).unwrap().is_none());
        assert_eq!(sizes(&["1+x"], [(0.0, 0.0), (1.0, 0.0)]), [1.0, 2.0]);
        let both = ["1+x", "distance:segments,at=0.5,growth=1,max=1.5"];
        assert_eq!(
            sizes(&both, [(0.0, 9.0), (1.0, 9.0), (1.0, 0.5)]),
            [1.0, 1.5, 1.0]
        );
    }

    #[test]
    fn distances_are_from_what_is_named() {
        let from = |what: &str| {
            let spec = format!("distance:{what},at=1,growth=1");
            sizes(&[&spec], [(0.0, 4.0), (2.0, 0.0)])
        };
        assert_eq!(from("segments"), [5.0, 1.0]);
        assert_eq!(from("points"), [1.0, 3.0]);
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("wall.poly");
        let text = "3 2 0 0\n1 0 1\n2 4 1\n3 2 -2\n1 0\n1 1 2\n0\n";
        fs::write(&file, text).unwrap();
        assert_eq!(from(file.to_str().unwrap()), [4.0, 2.0]);
        let spec = format!("distance:{},at=1,growth=1", file.display());
        assert_eq!(sizing(&[&spec]).files(), [file]);
    }

    #[test]
    fn points_and_meshes_have_sizes() {
        let folder = tempfile::tempdir().unwrap();
        let place = |name: &str| folder.path().join(name);
        fs::write(place("cloud.csv"), "x,y,h\n0,0,1\n4,0,3\n0,4,5\n").unwrap();
        fs::write(place("mesh.node"), "3 2 1 0\n1 0 0 1\n2 4 0 3\n3 0 4 5\n").unwrap();
        fs::write(place("mesh.ele"), "1 3 1\n1 1 2 3 7\n").unwrap();
        for name in ["cloud.csv:H", "mesh.ele:attribute1", "mesh.node:attribute1"] {
            let spec = place(name).display().to_string();
            assert_eq!(
                sizes(&[&spec], [(2.0, 0.0), (0.0, 2.0), (9.0, 9.0)]),
                [2.0, 3.0, 4.0]
            );
        }
        let inputs = sizing(&[&place("mesh.ele:attribute1").display().to_string()]).files();
        assert_eq!(inputs, ["mesh.ele", "mesh.node"].map(place));
        let said = |name: &str| refusal(&place(name).display().to_string());
        let Failure::Usage(text) = said("cloud.csv:size") else {
            panic!("a usage error");
        };
        assert!(text.ends_with("no column size; there are h"), "{text}");
        assert!(matches!(said("none.csv:size"), Failure::BadInput(_)));
    }

    #[test]
    fn sizes_must_be_positive() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("cloud.node");
        fs::write(&file, "3 2 1 0\n1 0 0 1\n2 4 0 0\n3 0 4 5\n").unwrap();
        let Failure::BadInput(text) = refusal(&format!("{}:attribute1", file.display())) else {
            panic!("bad input");
        };
        assert!(text.contains("the size at point 2 is 0"), "{text}");
        for (expression, said) in [("x", "is 0 at point 0 (0, 0)"), ("2-x", "is -2 at point 1")] {
            let Failure::BadInput(text) = refusal(expression) else {
                panic!("bad input");
            };
            assert!(text.contains(said), "{text}");
        }
        assert!(build(&["1/x^2 + 1"]).is_ok(), "infinity is no bound");
    }

    #[test]
    fn features_must_exist_and_numbers_make_sense() {
        for spec in [
            "distance:segments,at=0,growth=1",
            "distance:segments,at=1,growth=-1",
            "distance:segments,at=1,growth=1,max=0",
        ] {
            assert!(matches!(refusal(spec), Failure::Usage(_)), "{spec}");
        }
        let bare = DomainData::from(Pslg::from_points([(0.0, 0.0)]));
        let lines = sizing(&["distance:segments,at=1,growth=1"]);
        let Err(Failure::Usage(text)) = lines.build(&bare, None, &Progress::new(true)) else {
            panic!("a usage error");
        };
        assert!(text.contains("distance:segments"), "{text}");
    }
}
