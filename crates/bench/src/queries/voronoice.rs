//! `voronoice` at Voronoi diagrams.

use super::bounds::Bounds;
use super::input::Input;
use super::job::Answer;
use crate::measure::under_the_clock;
use voronoice::{BoundingBox, Point, VoronoiBuilder};

/// Makes the cells, clipped to the bounds of the points.
///
/// # Errors
/// If there are none, or if they do not cover the bounds.
pub fn answer(input: &Input) -> Result<Answer, String> {
    let bounds = Bounds::of(&input.points);
    let sites = input.points.iter().map(|&[x, y]| Point { x, y }).collect();
    let [width, height] = bounds.sides();
    let [x, y] = [0, 1].map(|k| bounds.low[k] + 0.5 * bounds.sides()[k]);
    let window = BoundingBox::new(Point { x, y }, width, height);
    let builder = VoronoiBuilder::default()
        .set_sites(sites)
        .set_bounding_box(window);
    let (diagram, work) = under_the_clock(|| builder.build());
    let diagram = diagram.ok_or("no diagram")?;
    let vertices = diagram.vertices();
    let corners = |cell: &Vec<usize>| -> Vec<_> {
        let corners = cell.iter().map(|&v| &vertices[v]);
        corners.map(|p| [p.x, p.y]).collect()
    };
    let cells = diagram.cells().iter().map(corners);
    Answer::of_clipped(input, work, &bounds, cells)
}
