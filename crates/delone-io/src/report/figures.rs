//! The figures of a report, and what became of the work, in words.

use super::ReportOptions;
use crate::unmet::{bound, degrees, degrees_of};
use crate::words::{count, counted, measure};
use delone::{Outcome, RefinedMesh, Report};

/// A row of the table of figures.
pub(super) struct Figure {
    pub name: String,
    /// What the mesh has.
    pub value: String,
    /// What was asked for, if anything was.
    pub asked: Option<String>,
}

impl Figure {
    fn new(name: &str, value: String) -> Self {
        let name = name.to_owned();
        Self {
            name,
            value,
            asked: None,
        }
    }

    fn asked(self, bound: &str, asked: Option<String>) -> Self {
        let asked = asked.map(|asked| format!("{bound} {asked}"));
        Self { asked, ..self }
    }
}

/// Lists the figures that matter most.
pub(super) fn principal(refined: &RefinedMesh) -> Vec<Figure> {
    let Report {
        asked,
        on_segments,
        free,
        unmet,
        ..
    } = &refined.report;
    let found = refined.statistics();
    let vertices = refined.mesh.triangulation().num_vertices();
    let mut figures = vec![
        Figure::new("triangles", count(found.triangles)),
        Figure::new("vertices", count(vertices)),
        Figure::new("Steiner points", count(on_segments + free)),
    ];
    if found.triangles > 0 {
        let [angle, edge, area] = [
            asked.min_angle.map(degrees_of),
            asked.max_edge.map(bound),
            asked.max_area.map(bound),
        ];
        figures.extend([
            Figure::new("smallest angle", degrees(found.min_angle)).asked("at least", angle),
            Figure::new("longest edge", measure(found.longest_edge)).asked("at most", edge),
            Figure::new("largest area", measure(found.largest_area)).asked("at most", area),
        ]);
    }
    let excused = unmet.len() - refined.report.num_unexcused();
    let unmet = match unmet.len() {
        0 => "none".to_owned(),
        1 if excused == 1 => "1, excused".to_owned(),
        n if n == excused => format!("{}, all excused", count(n)),
        n if excused == 0 => count(n),
        n => format!("{}, {} excused", count(n), count(excused)),
    };
    figures.push(Figure::new("unmet triangles", unmet));
    figures
}

/// Lists the other figures.
pub(super) fn further(refined: &RefinedMesh) -> Vec<Figure> {
    let (report, found) = (&refined.report, refined.statistics());
    let mut figures = vec![
        Figure::new("Steiner points on segments", count(report.on_segments)),
        Figure::new("Steiner points elsewhere", count(report.free)),
        Figure::new("edges", count(found.edges.total())),
    ];
    if found.triangles > 0 {
        figures.extend(shapes(refined));
    }
    figures
}

/// Lists what else the caller has to say.
pub(super) fn details(options: &ReportOptions<'_>) -> Vec<Figure> {
    let details = options.details.iter();
    details
        .map(|(name, value)| Figure::new(name, value.clone()))
        .collect()
}

/// Lists figures that only triangles have.
fn shapes(refined: &RefinedMesh) -> [Figure; 9] {
    let found = refined.statistics();
    let both = |worst: f64, mean: f64| format!("{}; mean {}", measure(worst), measure(mean));
    [
        Figure::new("largest angle", degrees(found.max_angle)),
        Figure::new("mean smallest angle", degrees(found.mean_min_angle)),
        Figure::new("shortest edge", measure(found.shortest_edge)),
        Figure::new("mean edge", measure(found.mean_edge)),
        Figure::new("area", measure(found.area)),
        Figure::new("smallest area", measure(found.smallest_area)),
        Figure::new("mean area", measure(found.mean_area())),
        Figure::new("worst aspect", both(found.worst_aspect, found.mean_aspect)),
        Figure::new(
            "worst circumradius to shortest edge",
            both(found.worst_radius_edge, found.mean_radius_edge),
        ),
    ]
}

/// Says what was asked for.
pub(super) fn asked(report: &Report) -> String {
    let quality = &report.asked;
    let bounds = [
        quality
            .min_angle
            .map(|angle| format!("no angle below {}", degrees_of(angle))),
        quality
            .max_edge
            .map(|edge| format!("no edge longer than {}", bound(edge))),
        quality
            .max_area
            .map(|area| format!("no area above {}", bound(area))),
        quality
            .region_areas
            .then(|| "the areas of the regions".to_owned()),
    ];
    match bounds.into_iter().flatten().collect::<Vec<_>>() {
        none if none.is_empty() => "Asked: nothing of angles, edges and areas.".to_owned(),
        bounds => format!("Asked: {}.", crate::words::list(&bounds)),
    }
}

/// Says what became of it.
pub(super) fn outcome(report: &Report) -> String {
    let left = report.num_unexcused();
    let unmet = counted(report.unmet.len(), "triangle", "triangles");
    let unmet = match (report.unmet.len(), left) {
        (0, _) => "every triangle meets the bounds".to_owned(),
        (_, 0) => format!("{unmet} cannot meet the bounds, all others do"),
        (1, _) => format!("{unmet} does not meet the bounds"),
        (all, left) if all == left => {
            format!("{unmet} do not meet the bounds, and the input is no excuse")
        }
        _ => format!(
            "{unmet} do not meet the bounds, {} of them without excuse",
            count(left)
        ),
    };
    match report.outcome {
        Outcome::Complete => format!("Complete: {unmet}."),
        Outcome::BudgetExhausted => format!("Stopped when the budget was used up: {unmet}."),
        Outcome::PrecisionLimit => format!(
            "Stopped where vertices would come closer together than coordinates or the features of the \
             input allow: {unmet}."
        ),
        Outcome::Cancelled => format!("Cancelled: {unmet}; the mesh is valid as it is."),
        _ => format!("Stopped: {unmet}."),
    }
}
