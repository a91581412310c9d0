//! `voronator` at Voronoi diagrams.

use super::bounds::Bounds;
use super::input::Input;
use super::job::Answer;
use crate::measure::under_the_clock;
use voronator::VoronoiDiagram;
use voronator::delaunator::Point;

/// Makes the cells, clipped to the bounds of the points.
///
/// # Errors
/// If there are none, or if they do not cover the bounds.
pub fn answer(input: &Input) -> Result<Answer, String> {
    let bounds = Bounds::of(&input.points);
    let sites: Vec<_> = input.points.iter().map(|&p| p.into()).collect();
    let [low, high] = [bounds.low, bounds.high].map(Into::into);
    let (diagram, work) =
        under_the_clock(|| VoronoiDiagram::<Point>::from_tuple(&low, &high, &sites));
    let diagram = diagram.ok_or("no diagram")?;
    let corners = |corners: &[Point]| corners.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
    let cells = diagram.cells().iter().map(|cell| corners(cell.points()));
    Answer::of_clipped(input, work, &bounds, cells)
}
