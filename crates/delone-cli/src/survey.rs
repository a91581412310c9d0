//! Surfaces over points and domains: values at the vertices, taken from a column of the input.

use crate::column;
use crate::exit::Failure;
use crate::files::{self, Outputs};
use crate::job::{Building, Built};
use crate::numbering::Numbering;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::task::Task;
use delone::surface::{Grid, Samples, average_duplicates};
use delone::{Point, Triangulation};
use delone_io::{Column, Inherited};

/// Cells along the longer side of a raster that is only looked at.
const SHOWN: f64 = 800.0;

/// Options about the values, and the triangles over which the surface lies.
#[derive(clap::Args)]
pub struct Surveying {
    /// Column of the values: its name, or its number among those that are not coordinates [default: the
    /// only one, or z]
    #[arg(long, value_name = "COLUMN", help_heading = None)]
    value: Option<Column>,
    /// Give equal points the mean of their values, instead of refusing different ones
    #[arg(long, help_heading = None)]
    average: bool,
    #[command(flatten)]
    building: Building,
}

/// Triangles with a value at each vertex.
pub struct Survey {
    built: Built,
    values: Vec<f64>,
    /// What the values are called.
    pub name: String,
    numbering: Numbering,
}

impl Surveying {
    /// Reads points and values, and triangulates.
    pub fn survey(
        &self,
        task: &Task,
        outputs: &Outputs,
        phases: &mut Phases,
        progress: &Progress,
    ) -> Result<Survey, Failure> {
        let read = phases.time("read", || task.domain(outputs, progress))?;
        let (mut domain, numbering) = read;
        let points = &mut domain.vertices;
        let attribute = column::take(points, self.value.as_ref(), "--value", &numbering)?;
        let name = attribute.name.clone();
        points.attributes = vec![attribute];
        phases.time("triangulate", || {
            let building = &self.building;
            let (built, _) = building.build(&mut domain, task.threads(), &numbering, progress)?;
            progress.note(&built.notes(&numbering));
            let mut attributes = match &built {
                Built::Points(_) => domain.vertices.attributes,
                // Where segments cross, vertices were added.
                Built::Domain(result) => {
                    let inherited = Inherited::new(result, domain, progress);
                    inherited.map_err(files::unwritable)?.attributes
                }
            };
            let mut survey = Survey {
                built,
                values: attributes.swap_remove(0).values,
                name,
                numbering,
            };
            if self.average {
                survey.average()?;
            }
            survey.require_triangles()?;
            Ok(survey)
        })
    }
}

impl Survey {
    /// Returns the triangles.
    pub fn triangulation(&self) -> &Triangulation {
        match &self.built {
            Built::Points(triangulation) => triangulation,
            Built::Domain(result) => result.triangulation(),
        }
    }

    /// Returns the values over the triangles.
    pub fn samples(&self) -> Result<Samples<'_>, Failure> {
        let values = self.values.clone();
        let samples = match &self.built {
            Built::Points(triangulation) => Samples::new(triangulation, values),
            Built::Domain(result) => Samples::new(&**result, values),
        };
        samples.map_err(|error| self.refused(error))
    }

    /// Says why something cannot be done.
    pub fn refused(&self, error: delone::Error) -> Failure {
        self.numbering.failure(error)
    }

    /// Returns opposite corners of the box around the triangles.
    pub fn corners(&self) -> [Point; 2] {
        let t = self.triangulation();
        let corners = t.triangles().as_flattened().iter().map(|&v| t.point(v));
        let corners = corners.map(|p| [p, p]);
        let bounds = corners.reduce(|[low, high], [p, _]| {
            [
                Point::new(low.x.min(p.x), low.y.min(p.y)),
                Point::new(high.x.max(p.x), high.y.max(p.y)),
            ]
        });
        bounds.unwrap_or_default()
    }

    /// Returns a grid over the triangles that is fine enough to be looked at.
    pub fn grid_to_show(&self) -> Result<Grid, Failure> {
        let [low, high] = self.corners();
        let side = (high.x - low.x).max(high.y - low.y) / SHOWN;
        Grid::with_cells(low, high, side).map_err(|error| self.refused(error))
    }

    fn average(&mut self) -> Result<(), Failure> {
        let triangulation = match &self.built {
            Built::Points(triangulation) => triangulation,
            Built::Domain(result) => result.triangulation(),
        };
        let averaged = average_duplicates(triangulation, &mut self.values);
        averaged.map_err(|error| self.numbering.failure(error))
    }

    fn require_triangles(&self) -> Result<(), Failure> {
        if self.triangulation().num_triangles() > 0 {
            return Ok(());
        }
        let file = self.numbering.file();
        Err(Failure::BadInput(format!(
            "{file}: there is no triangle, so there is no surface; three points that do not lie on one line \
             are needed, and a domain that is not empty"
        )))
    }
}
