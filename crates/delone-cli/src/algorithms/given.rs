//! What an algorithm is given: a file, or something small to try it on.

use crate::domain::Rule;
use crate::exit::Failure;
use crate::files::{Input as File, Outputs, Reading};
use crate::numbering::Numbering;
use crate::numbers::{angle, positive};
use crate::progress::Progress;
use crate::sample::scene_data;
use crate::words::counted;
use delone::classic::{About, Algorithm, Input, Takes};
use delone::predicates::{Orientation, orient2d};
use delone::{Angle, DomainRule, Point, Quality, VertexId};
use delone_io::{DomainData, PointSet};
use delone_samples::{Distribution, Scene};
use std::path::PathBuf;

/// What is to be done about segments that cross: no classical algorithm cuts them.
const CUT: &str = "take the cut.poly of `delone triangulate INPUT --crossings split -o cut.poly`";

/// Points that are taken if no file is named.
const FEW: usize = 30;

/// Data that are taken if no file is named.
const FEW_DATA: usize = 60;

/// Options about what an algorithm works on.
#[derive(clap::Args)]
pub struct Given {
    /// File of points, of a domain or, for algorithms that flip, of a mesh, or `-`; by default something
    /// small
    #[arg(help_heading = None)]
    input: Option<PathBuf>,
    /// Seed of random orders
    #[arg(long, value_name = "SEED", default_value_t = 0, help_heading = None)]
    seed: u64,
    /// For algorithms that refine: no edge longer than this
    #[arg(long, value_name = "LENGTH", help_heading = None, value_parser = positive,
          allow_negative_numbers = true)]
    max_edge: Option<f64>,
    /// For algorithms that refine: no angle smaller than this, in degrees
    #[arg(long, value_name = "DEG", help_heading = None, value_parser = angle,
          allow_negative_numbers = true)]
    min_angle: Option<f64>,
    /// For algorithms that cover data: how many each triangle is to hold at least
    #[arg(short = 'd', long, value_name = "DATA", help_heading = None)]
    data_per_triangle: Option<usize>,
    /// For algorithms on domains: which triangles to keep [default: carve for the segments of a .poly,
    /// evenodd for polygons of GeoJSON and WKT, otherwise hull]
    #[arg(long, value_enum, value_name = "RULE", help_heading = None)]
    domain: Option<Rule>,
    #[command(flatten)]
    reading: Reading,
}

/// Tells whether an algorithm works on points alone.
fn is_bare(takes: Takes) -> bool {
    matches!(takes, Takes::Points | Takes::Data)
}

impl Given {
    /// Reads what the algorithm takes, and says what of the rest is left unused.
    pub fn read<'w>(
        &self,
        algorithm: Algorithm,
        outputs: &Outputs,
        progress: &'w Progress,
    ) -> Result<(Input<'w>, Numbering), Failure> {
        let takes = algorithm.about().takes;
        self.require_use(algorithm)?;
        let (mut input, usual_rule, numbering) = match &self.input {
            Some(path) => {
                let file = self.reading.open(path)?;
                outputs.spare(&file.files())?;
                self.of_file(&file, takes, progress)?
            }
            None if is_bare(takes) => {
                let number = if takes == Takes::Data { FEW_DATA } else { FEW };
                let points = Distribution::Uniform.points(number, 1);
                let points = points.into_iter().map(Point::from).collect();
                of_domain(
                    "the sample",
                    PointSet {
                        points,
                        ..PointSet::default()
                    }
                    .into(),
                )
            }
            None => of_domain(Scene::Thesis.name(), scene_data(Scene::Thesis)),
        };
        if is_bare(takes) && !input.pslg.segments.is_empty() {
            let segments = counted(input.pslg.segments.len(), "segment", "segments");
            let name = algorithm.about().name;
            progress.note(&[format!(
                "`{name}` works on points alone: {segments} not used"
            )]);
            input = Input::from_points(input.pslg.points);
        }
        input.seed = self.seed;
        input.domain = self.domain.map_or(usual_rule, Into::into);
        if self.domain.is_some() && !input.start.is_empty() {
            progress.note(&[
                "--domain is not used: the triangles of the mesh are the domain".to_owned(),
            ]);
        }
        input.quality = self.quality(algorithm);
        input.least = self.data_per_triangle.unwrap_or(input.least);
        input.watch = progress;
        Ok((input, numbering.about_crossings(CUT)))
    }

    /// Refuses options that would have no effect.
    fn require_use(&self, algorithm: Algorithm) -> Result<(), Failure> {
        let About { name, takes, .. } = algorithm.about();
        let is_bounded = self.max_edge.is_some() || self.min_angle.is_some();
        let idle = if is_bounded && !algorithm.refines() {
            format!(
                "--max-edge and --min-angle are for `thesis` and `refinement`; `{name}` knows no bounds"
            )
        } else if self.data_per_triangle.is_some() && *takes != Takes::Data {
            format!("--data-per-triangle is for algorithms that cover data; `{name}` does not")
        } else if self.domain.is_some() && is_bare(*takes) {
            format!("--domain is about segments; `{name}` works on points alone")
        } else if self.input.is_none() && self.reading.is_given() {
            "--from and --columns are about INPUT, and none is named".to_owned()
        } else {
            return Ok(());
        };
        Err(Failure::Usage(idle))
    }

    fn of_file<'w>(
        &self,
        file: &File,
        takes: Takes,
        progress: &Progress,
    ) -> Result<(Input<'w>, DomainRule, Numbering), Failure> {
        if takes == Takes::Triangulation && file.brings_triangles(progress)? {
            let mesh = file.mesh(progress)?;
            let numbering = Numbering::of_points(&file.name(), &mesh.vertices);
            let mut input = Input::from_points(mesh.vertices.points);
            input.start = counter_clockwise(mesh.triangles, &input.pslg.points);
            input.pslg.segments = mesh.constraints.map_or_else(Vec::new, |c| c.edges);
            return Ok((input, DomainRule::Hull, numbering));
        }
        let (domain, unused) = file.domain(progress)?;
        progress.note(&unused);
        Ok(of_domain(&file.name(), domain))
    }

    fn quality(&self, algorithm: Algorithm) -> Quality {
        let is_bounded = self.max_edge.is_some() || self.min_angle.is_some();
        // Without any, what the thesis' own example asks for.
        let given = |bound: Option<f64>, usual| if is_bounded { bound } else { Some(usual) };
        Quality {
            max_edge: match algorithm {
                Algorithm::Thesis => given(self.max_edge, 3.0),
                _ => self.max_edge,
            },
            min_angle: given(self.min_angle, 20.0).map(Angle::degrees),
            ..Quality::default()
        }
    }
}

fn of_domain<'w>(name: &str, mut domain: DomainData) -> (Input<'w>, DomainRule, Numbering) {
    let numbering = Numbering::of(name, &domain);
    let rule = domain.usual_rule;
    (Input::from_pslg(domain.take_pslg()), rule, numbering)
}

/// Turns triangles counter-clockwise; a file may have them either way.
fn counter_clockwise(mut triangles: Vec<[VertexId; 3]>, points: &[Point]) -> Vec<[VertexId; 3]> {
    for corners in &mut triangles {
        let [a, b, c] = corners.map(|v| points[v.index()]);
        if orient2d(a, b, c) == Orientation::Right {
            corners.swap(1, 2);
        }
    }
    triangles
}
