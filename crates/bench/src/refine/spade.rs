//! `spade` at refinement: Ruppert's algorithm with rounded tests of encroachment.

use super::goal::Goal;
use super::job::Answer;
use super::quality::Quality;
use crate::measure::under_the_clock;
use delone_samples::Drawing;
use spade::{
    AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, RefinementResult,
    Triangulation,
};
use std::collections::HashSet;

type Mesh = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// More vertices than any run of the bench can need: its own limit, ten times the input, is lifted.
const MANY: usize = 100_000_000;

/// Refines `drawing`; measures the mesh afterwards if `check`. Holes are found by parity.
///
/// # Errors
/// What spade says, or that it gave up.
pub fn mesh(drawing: Drawing, goal: Goal, check: bool) -> Result<Answer, String> {
    let points = drawing.points.into_iter();
    let points = points.map(|[x, y]| Point2::new(x, y)).collect();
    let segments = drawing.segments.into_iter();
    let segments = segments.map(|ends| ends.map(|v| v as usize)).collect();
    let parameters = parameters(goal);
    let (refined, cost) = under_the_clock(|| {
        let mut mesh = Mesh::bulk_load_cdt(points, segments)?;
        let result = mesh.refine(parameters);
        Ok::<_, spade::InsertionError>((mesh, result))
    });
    let (mesh, result) = refined.map_err(|error| error.to_string())?;
    if !result.refinement_complete {
        return Err("gave up".to_owned());
    }
    let quality = check.then(|| inspect(&mesh, &result, goal));
    Ok(Answer { cost, quality })
}

fn parameters(goal: Goal) -> RefinementParameters<f64> {
    let parameters = RefinementParameters::new()
        .exclude_outer_faces(true)
        .with_angle_limit(AngleLimit::from_deg(goal.angle))
        .with_max_additional_vertices(MANY);
    match goal.area {
        Some(area) => parameters.with_max_allowed_area(area),
        None => parameters,
    }
}

fn inspect(mesh: &Mesh, result: &RefinementResult, goal: Goal) -> Quality {
    let outside: HashSet<_> = result.excluded_faces.iter().collect();
    let inside = mesh.inner_faces().filter(|f| !outside.contains(&f.fix()));
    let corners = inside.map(|face| face.positions().map(|p| [p.x, p.y]));
    Quality::of(corners, goal)
}

#[cfg(test)]
mod tests {
    use super::{Goal, mesh};
    use delone_samples::Domain;

    #[test]
    fn holes_stay_empty_and_bounds_are_met() {
        let drawing = Domain::Holes.draw(400, 1);
        let area = drawing.area();
        let goal = Goal {
            angle: 25.0,
            area: Some(1e-3),
        };
        let answer = mesh(drawing, goal, true).unwrap();
        let quality = answer.quality.unwrap();
        assert!((quality.area - area).abs() < 1e-9);
        assert_eq!((quality.skinny, quality.oversized), (0, 0));
        assert!(quality.triangles > 1000 && quality.min_angle < 30.0);
    }
}
