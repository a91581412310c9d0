//! Whoever is not reported meets the bounds, and whoever is reported breaks what it is said to break.

use super::{Job, Shape, Verdict, at, ensure};
use delone::{
    Angle, Broken, ConstrainedTriangulation, Point, RefinedMesh, SizingField, TriangleId, Unmet,
};

/// Rounding that is overlooked, relative.
const SLACK: f64 = 1e-9;

/// The bounds that a triangle has to meet.
#[derive(Debug)]
struct Bounds {
    angle: f64,
    edge: f64,
    area: f64,
}

impl Bounds {
    fn of(job: &Job, mesh: &ConstrainedTriangulation, t: TriangleId, corners: [Point; 3]) -> Self {
        let mut bounds = Self {
            angle: job.quality.min_angle.map_or(0.0, Angle::to_degrees),
            edge: job.quality.max_edge.unwrap_or(f64::INFINITY),
            area: job.quality.max_area.unwrap_or(f64::INFINITY),
        };
        if job.quality.region_areas
            && let Some(area) = mesh.region(t).and_then(|r| mesh.regions()[r].max_area)
        {
            bounds.area = bounds.area.min(area);
        }
        if let Some(field) = &job.sizing {
            bounds.edge = bounds.edge.min(field.max_edge(centroid(corners)));
        }
        bounds
    }

    /// Tells which bounds are broken by more than `slack`, relative.
    fn broken_by(&self, shape: &Shape, slack: f64) -> Broken {
        Broken {
            angle: shape.min_angle() < self.angle * (1.0 - slack),
            edge: shape.longest() > self.edge * (1.0 + slack),
            area: shape.area > self.area * (1.0 + slack),
        }
    }
}

fn centroid(corners: [Point; 3]) -> Point {
    let sum = |of: fn(&Point) -> f64| corners.iter().map(|p| of(p) / 3.0).sum();
    Point::new(sum(|p| p.x), sum(|p| p.y))
}

pub(super) fn check_bounds(job: &Job, refined: &RefinedMesh) -> Verdict {
    let RefinedMesh { mesh, report, .. } = refined;
    let ascends = report.unmet.is_sorted_by(|a, b| a.triangle < b.triangle);
    ensure(ascends, || "unmet triangles do not ascend".to_owned())?;
    let mut unmet = report.unmet.iter().peekable();
    for (i, corners) in mesh.triangulation().triangles().iter().enumerate() {
        let t = TriangleId::new(i);
        let corners = corners.map(|v| at(mesh, v));
        let shape = Shape::of(corners);
        let bounds = Bounds::of(job, mesh, t, corners);
        let told = unmet.next_if(|u| u.triangle == t);
        check_triangle(&bounds, &shape, told)
            .map_err(|why| format!("{t:?} {corners:?} {why}\n{shape:?}\n{bounds:?}"))?;
    }
    ensure(unmet.next().is_none(), || {
        "an unmet triangle does not exist".to_owned()
    })?;
    check_statistics(refined)
}

fn check_triangle(bounds: &Bounds, shape: &Shape, told: Option<&Unmet>) -> Verdict {
    let surely = bounds.broken_by(shape, SLACK);
    let perhaps = bounds.broken_by(shape, -SLACK);
    let broken = told.map(|u| u.broken).unwrap_or_default();
    let is_told = |told: bool, surely: bool, perhaps: bool| told >= surely && told <= perhaps;
    let is_right = is_told(broken.angle, surely.angle, perhaps.angle)
        && is_told(broken.edge, surely.edge, perhaps.edge)
        && is_told(broken.area, surely.area, perhaps.area);
    ensure(is_right, || format!("breaks {surely:?}, told {broken:?}"))?;
    let Some(unmet) = told else { return Ok(()) };
    ensure(broken != Broken::default(), || "breaks nothing".to_owned())?;
    let angle = unmet.min_angle.to_degrees();
    ensure(is_near(angle, shape.min_angle()), || {
        format!("is said to have {angle} degrees")
    })
}

/// Smallest angle and longest edge of the statistics are those of the triangles.
fn check_statistics(refined: &RefinedMesh) -> Verdict {
    let mesh = &refined.mesh;
    let triangles = mesh.triangulation().triangles();
    let shapes = triangles.iter().map(|t| Shape::of(t.map(|v| at(mesh, v))));
    let (min_angle, longest) = shapes.fold((180.0f64, 0.0f64), |(angle, edge), shape| {
        (angle.min(shape.min_angle()), edge.max(shape.longest()))
    });
    let told = refined.statistics();
    let is_right = told.triangles == triangles.len()
        && is_near(told.min_angle, min_angle)
        && is_near(told.longest_edge, longest);
    ensure(is_right, || {
        format!(
            "statistics of {}, {min_angle}, {longest} are told as {told:?}",
            triangles.len()
        )
    })
}

fn is_near(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= SLACK * a.abs().max(b.abs()) || (a - b).abs() <= 1e-13
}
