//! `delone mesh`: from an outline with holes to a mesh of good triangles, its report and its picture.

mod goals;
mod method;
mod reached;

use crate::batch::{self, Batching, Many, Naming};
use crate::exit::Failure;
use crate::files::{self, Content, Outputs};
use crate::job::{Figures, Job, Laps, Made, OfMesh, Report};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::refinable::{Ancestors, Refinable};
use crate::timing::timed;
use crate::unmet::Unexcused;
use crate::words::command_line;
use delone::{Angle, RefinedMesh, Refinement};
use delone_io::{AskedFor, DomainData, Inherited, MeshView, ReportOptions};
use goals::Goals;
use method::{Limits, Method};
use reached::Reached;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone mesh                                      the embedded lake: mesh, picture, report page
  delone mesh lake.poly --min-angle 30 --max-edge 0.05 -o lake.vtu --picture lake.png
  delone mesh plate.poly --max-area 0.1 -o plate.ele --report plate.html
  delone mesh map.geojson --crossings split --max-edge 500 -o map.vtu
  delone mesh wing.poly --sizing '0.01 + 0.1*hypot(x, y)' -o wing.vtu
  delone mesh part.poly --keep-boundary -o part.vtu   no vertex is added on a segment
  delone mesh part.poly --quadratic --smooth 3 -o part.vtu   six nodes each, vertices moved a little
  delone mesh old.ele --area-per-region -o new.ele   refines a mesh as old.area asks
  delone mesh parts/*.poly --out-dir meshes --to vtu   each of them, and a table of what has become of them
  delone mesh part.poly --json | jq .unmet_by_reason";

const JSON: &str = "\
The JSON object of --json has the keys of `delone triangulate --json`, of the refined mesh, and:
  steiner          vertices added for better triangles
  steiner_on_segments  those of them on segments, or on the edge of the convex hull
  min_angle_degrees, max_edge, max_area
                   what was reached: smallest angle, longest edge, largest area; null without triangles
  asked            what was asked for under the same names, null where nothing was; area_per_region
                   and sizing tell whether they counted
  outcome          complete, budget_exhausted, precision_limit, or of --strategy thesis fell_back
  unmet            triangles that miss a bound
  unexcused        those of them that nothing in the input excuses; if there are any, the exit code is 4
  unmet_by_reason  unmet triangles by reason: small_input_angle, locked_boundary and precision are
                   excuses, gradation and stopped are none
  seconds          has the phases refine and smooth, too";

/// What to do after the first try.
const NEXT: &str = "\
Next: open lake.html, or lake.png; or let the mesh be verified from its files alone:
  delone sample lake -o drawing.poly
  delone check lake.ele --domain drawing.poly --refined
Your own: delone mesh map.poly --max-edge 0.5 -o mesh.vtu --report mesh.html (`delone doctor map.poly` first)";

/// Mesh a domain with good triangles: from a file to mesh, picture, report and figures
///
/// Reads what `delone triangulate` reads, and adds vertices until no angle is smaller than
/// --min-angle, no edge longer than --max-edge and no triangle larger than --max-area: except where
/// the input forbids it, and then the report says which segments at which vertex do. It ends on every
/// input. The mesh is a constrained Delaunay triangulation; the same input and options give the same
/// mesh on every machine and with any number of threads, unless --max-time cuts it short.
///
/// A mesh (.ele, .vtu, .msh, .vtk, .npy of corners) is refined: its vertices, its segments if the file has them, and
/// its border stay, and the new triangles have the attributes of the old.
///
/// Without INPUT a sample is meshed: a lake with islands. Without -o only what --picture, --report and
/// --json ask for is written.
#[derive(clap::Args, Clone)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}\n\n{}", batch::HELP, crate::exit::HELP))]
pub struct Mesh {
    /// Report to write, .html (a page with everything), .svg or .png; repeatable
    #[arg(short, long, value_name = "PAGE")]
    report: Vec<PathBuf>,
    /// Write triangles of six nodes, with the midpoints of their edges: .node/.ele, .vtu, .vtk, .msh …
    #[arg(long)]
    quadratic: bool,
    #[command(flatten)]
    goals: Goals,
    #[command(flatten)]
    method: Method,
    #[command(flatten)]
    limits: Limits,
    #[command(flatten)]
    job: Job,
}

/// What has been made of an input.
struct Meshed {
    refined: RefinedMesh,
    laps: Laps,
    /// The input but for its graph.
    domain: DomainData,
    ancestors: Option<Ancestors>,
}

impl Many for Mesh {
    fn batching(&self) -> &Batching {
        &self.job.batching
    }

    fn inputs(&self) -> Vec<PathBuf> {
        self.job.inputs()
    }

    fn also_reads(&self) -> Vec<PathBuf> {
        self.goals.sizing.files()
    }

    fn asks_json(&self) -> bool {
        self.job.json
    }

    fn for_one(&self, input: &Path, naming: &Naming<'_>) -> Result<Self, Failure> {
        let report = naming.names(&self.report, input, "--report")?;
        Ok(Self {
            job: self.job.for_one(input, naming, !report.is_empty())?,
            report,
            ..self.clone()
        })
    }

    fn settle(&self) -> Result<Outputs, Failure> {
        self.method.require_sense(&self.goals)?;
        self.outputs()
    }

    fn in_a_batch(&mut self, threads: usize) {
        self.job.in_a_batch(threads);
    }

    fn run_alone(&self, quiet: bool) -> Result<(), Failure> {
        self.method.require_sense(&self.goals)?;
        let outputs = self.outputs()?;
        outputs.spare(&self.goals.sizing.files())?;
        let progress = Progress::new(quiet);

        let takes_areas = self.goals.area_per_region;
        let read = || self.job.read_refinable(&outputs, takes_areas, &progress);
        let ((input, numbering), read) = timed(read)?;
        progress.note(&self.notes(&input));
        let made = self.make(input, &numbering, &progress)?;
        progress.note(&numbering.notes(&made.refined.mesh));

        // Hashed before the files get their names, for after that nothing should take long.
        let figures = Figures::of_domain(&made.refined.mesh, self.job.threads());
        let details = self.details(&figures, &made.laps);
        let Meshed {
            refined,
            laps,
            domain,
            ancestors,
        } = made;
        let writing = || {
            let inherited = inherited(&refined, domain, ancestors.as_ref(), &progress)?;
            let options = ReportOptions {
                name: numbering.file(),
                base: numbering.base(),
                details: &details,
                ..ReportOptions::default()
            };
            self.write(&outputs, &refined, &inherited, options, &progress)
        };
        let (written, write) = timed(|| files::in_one_commit(writing))?;
        progress.finish();

        let reached = Reached::new(&refined, self.goals.sizing.is_given());
        let lines = reached.lines(&refined, &numbering);
        let report = Report::new(figures, reached, [read, write], &laps);
        if self.job.json {
            files::print(&report.json())?;
        } else if !quiet {
            let next = self.demonstrates().then_some(NEXT);
            report.summarise(&lines, next, &written);
        }
        let unexcused = Unexcused::of(&refined, &numbering, method::LIMITS);
        unexcused.map_or(Ok(()), |u| Err(Failure::NotReached(u.to_string())))
    }
}

impl Mesh {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        batch::run(self, quiet)
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        let mesh = if self.quadratic {
            Content::QuadraticMesh
        } else {
            Content::Mesh
        };
        self.job.outputs(mesh, Some(&self.report))
    }

    /// Tells whether nothing was named or asked for: somebody tries the program.
    fn demonstrates(&self) -> bool {
        self.job.demonstrates() && self.report.is_empty()
    }

    /// Says what deserves a word before the work begins.
    fn notes(&self, input: &Refinable) -> Vec<String> {
        let limits = self.limits.note(&self.goals, &input.domain);
        limits.into_iter().chain(self.goals.note(input)).collect()
    }

    /// Triangulates and refines.
    fn make(
        &self,
        input: Refinable,
        numbering: &Numbering,
        progress: &Progress,
    ) -> Result<Meshed, Failure> {
        let Refinable {
            mut domain,
            sizes,
            ancestors,
        } = input;
        let field = self.goals.sizing.build(&domain, sizes, progress)?;
        let mut refinement =
            Refinement::new(self.goals.quality()).budget(self.limits.budget(&self.goals, &domain));
        if let Some(field) = &field {
            refinement = refinement.sizing(field.as_ref());
        }
        let refinement = self.method.apply(refinement);
        let (building, threads) = (&self.job.building, self.job.threads());
        let (refined, laps) =
            building.refine(refinement, &mut domain, threads, numbering, progress)?;
        Ok(Meshed {
            refined,
            laps,
            domain,
            ancestors,
        })
    }

    /// Says what report pages cannot know: how the mesh was made.
    fn details(&self, figures: &Figures, laps: &Laps) -> Vec<(&'static str, String)> {
        let sizing = self.goals.sizing.to_string();
        let mut details = Vec::from_iter((!sizing.is_empty()).then_some(("sizing", sizing)));
        details.extend([
            ("time", laps.in_words(figures.threads())),
            ("hash of the triangles", figures.hash().to_owned()),
            ("command", command_line()),
        ]);
        details
    }

    /// Says what was asked of the triangles.
    fn asked(&self) -> AskedFor {
        let quality = self.goals.quality();
        AskedFor {
            min_angle_degrees: quality.min_angle.map(Angle::to_degrees),
            max_edge: quality.max_edge,
            max_area: quality.max_area,
            area_per_region: quality.region_areas,
            sizing: self.goals.sizing.names(),
            keep_boundary: self.method.kept().map(str::to_owned),
            conforming: self.method.is_conforming(),
        }
    }

    /// Lists the options that the mesh does not show.
    fn options(&self) -> Vec<String> {
        let quadratic = self.quadratic.then(|| "quadratic".to_owned());
        let method = self.method.options().into_iter();
        method
            .chain(self.limits.options())
            .chain(quadratic)
            .collect()
    }

    /// Writes mesh, pictures and pages, with what the mesh has inherited.
    fn write(
        &self,
        outputs: &Outputs,
        refined: &RefinedMesh,
        inherited: &Inherited,
        options: ReportOptions<'_>,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let mesh = MeshView::constrained(&refined.mesh, inherited);
        let writing = &self.job.writing;
        let elements = if self.quadratic {
            mesh.quadratic()
        } else {
            mesh
        };
        let made = Made {
            asked: Some(self.asked()),
            sizing: Some(&self.goals.sizing),
            options: self.options(),
            ..Made::of("mesh", OfMesh::Domain(&refined.mesh), &mesh)
        };
        let papers = self.job.certify(outputs, &made, progress)?;
        let mut written = writing.certified(outputs, &elements, &papers.view(), progress)?;
        written.extend(writing.reports(outputs, refined, &mesh, options, progress)?);
        Ok(written)
    }
}

/// Hands down what the mesh has from its domain, and from the triangles that were refined.
fn inherited(
    refined: &RefinedMesh,
    domain: DomainData,
    ancestors: Option<&Ancestors>,
    progress: &Progress,
) -> Result<Inherited, Failure> {
    let inherited = Inherited::new(&refined.mesh, domain, progress);
    let mut inherited = inherited.map_err(files::unwritable)?;
    if let Some(ancestors) = ancestors {
        inherited.triangle_attributes = ancestors.hand_down(&refined.mesh);
    }
    Ok(inherited)
}
