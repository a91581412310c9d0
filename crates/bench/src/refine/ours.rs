//! This project at refinement.

use super::goal::Goal;
use super::job::Answer;
use super::quality::Quality;
use crate::measure::under_the_clock;
use delone::{
    Angle, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Point, Pslg, RefinedMesh,
    Refinement, VertexId,
};
use delone_samples::Drawing;

/// Refines `drawing` on so many threads; checks the mesh afterwards if asked.
///
/// # Errors
/// What the mesher says, or what is wrong with its mesh.
pub fn mesh(drawing: Drawing, goal: Goal, threads: usize, check: bool) -> Result<Answer, String> {
    let input = pslg(drawing);
    let holes = input.holes.clone();
    let asked = delone::Quality {
        min_angle: Some(Angle::degrees(goal.angle)),
        max_area: goal.area,
        ..delone::Quality::default()
    };
    let refinement = Refinement::new(asked)
        .domain(DomainRule::Carve)
        .threads(threads);
    let (refined, cost) = under_the_clock(|| refinement.mesh(input));
    let refined = refined.map_err(|error| error.to_string())?;
    let quality = check.then(|| inspect(&refined, goal, holes)).transpose()?;
    Ok(Answer { cost, quality })
}

fn pslg(drawing: Drawing) -> Pslg {
    let ends = drawing.segments.into_iter();
    Pslg {
        segments: ends.map(|ends| ends.map(VertexId::from)).collect(),
        holes: drawing.holes.into_iter().map(Point::from).collect(),
        ..Pslg::from_points(drawing.points)
    }
}

/// Measures the mesh; holds it against its own report, and against the constrained Delaunay
/// triangulation of its points and subsegments, of which there is but one.
fn inspect(refined: &RefinedMesh, goal: Goal, holes: Vec<Point>) -> Result<Quality, String> {
    let triangulation = refined.mesh.triangulation();
    let points = triangulation.points();
    let corners = |ids: &[VertexId; 3]| ids.map(|v| [points[v.index()].x, points[v.index()].y]);
    let quality = Quality::of(triangulation.triangles().iter().map(corners), goal);
    let report = &refined.report;
    let reported = |is_broken: fn(&delone::Broken) -> bool| {
        let unmet = report.unmet.iter();
        unmet.filter(|unmet| is_broken(&unmet.broken)).count()
    };
    for (what, found, reported) in [
        ("skinny", quality.skinny, reported(|broken| broken.angle)),
        (
            "oversized",
            quality.oversized,
            reported(|broken| broken.area),
        ),
    ] {
        if found > reported {
            return Err(format!("{found} {what} triangles, {reported} reported"));
        }
    }
    let hash = triangulation.hash();
    let again = rebuild(&refined.mesh, holes)?.triangulation().hash();
    if again != hash {
        return Err(format!(
            "not constrained Delaunay: {hash} should be {again}"
        ));
    }
    Ok(Quality {
        unexcused: Some(report.num_unexcused()),
        hash: Some(hash.to_string()),
        ..quality
    })
}

fn rebuild(
    mesh: &ConstrainedTriangulation,
    holes: Vec<Point>,
) -> Result<ConstrainedTriangulation, String> {
    let points = mesh.triangulation().points().iter().copied();
    let input = Pslg {
        segments: mesh.constrained_edges().collect(),
        holes,
        ..Pslg::from_points(points)
    };
    let builder = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    builder
        .triangulate(input)
        .map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::{Goal, inspect, mesh, pslg};
    use delone::{DomainRule, Refinement};
    use delone_samples::Domain;

    const MODEST: Goal = Goal {
        angle: 20.0,
        area: None,
    };

    #[test]
    fn a_good_mesh_passes_on_any_number_of_threads() {
        let [one, two] = [1, 2].map(|threads| {
            let drawing = Domain::Square.draw(4, 1);
            mesh(drawing, MODEST, threads, true)
                .unwrap()
                .quality
                .unwrap()
        });
        assert_eq!((one.triangles, one.unexcused), (2, Some(0)));
        assert_eq!(one, two);
        let unchecked = mesh(Domain::Square.draw(4, 1), MODEST, 1, false).unwrap();
        assert_eq!(unchecked.quality, None);
    }

    #[test]
    fn triangles_that_miss_a_bound_must_be_reported() {
        let asked = delone::Quality::default();
        let star = pslg(Domain::Star.draw(60, 1));
        let refinement = Refinement::new(asked).domain(DomainRule::Carve);
        let refined = refinement.mesh(star).unwrap();
        let complaint = inspect(&refined, MODEST, Vec::new()).unwrap_err();
        assert!(complaint.contains("skinny triangles, 0 reported"));
        let tiny = Goal {
            angle: 0.1,
            area: Some(1e-3),
        };
        let complaint = inspect(&refined, tiny, Vec::new()).unwrap_err();
        assert!(complaint.contains("oversized triangles, 0 reported"));
    }

    #[test]
    fn a_mesh_of_another_domain_is_noticed() {
        let asked = delone::Quality::default();
        let input = pslg(Domain::Gear.draw(60, 1));
        let refinement = Refinement::new(asked).domain(DomainRule::Carve);
        let refined = refinement.mesh(input).unwrap();
        let anything = Goal {
            angle: 0.0,
            area: None,
        };
        let complaint = inspect(&refined, anything, Vec::new()).unwrap_err();
        assert!(complaint.contains("not constrained Delaunay"));
    }
}
