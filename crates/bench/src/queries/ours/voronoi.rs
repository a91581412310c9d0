//! Cells clipped to the bounds of the sites.

use super::Asked;
use crate::measure::under_the_clock;
use crate::queries::bounds::Bounds;
use crate::queries::job::Answer;
use delone::voronoi::{Domain, Voronoi};
use delone::{Delaunay, Error, on_threads};

impl Asked<'_> {
    /// All of it may use threads.
    pub(super) fn voronoi(self) -> Result<Answer, String> {
        let bounds = Bounds::of(&self.input.points);
        let points = self.input.points.clone();
        let builder = Delaunay::new().threads(self.threads());
        let threads = self.threads();
        let diagram = || {
            let triangulation = builder.triangulate(points)?;
            on_threads(threads, || Voronoi::new(&triangulation, &()))?
        };
        let (voronoi, made) = under_the_clock(diagram);
        let voronoi = voronoi.map_err(say)?;
        let clip = || {
            let rectangle = Domain::rectangle(bounds.low, bounds.high)?;
            on_threads(threads, || voronoi.clip(&rectangle, &()))?
        };
        let (clipped, cut) = under_the_clock(clip);
        let clipped = clipped.map_err(say)?;
        // In a rectangle no cell has more than one part; equal points have one cell together.
        let sites: Vec<_> = voronoi.cells().map(|cell| cell.site()).collect();
        let parts = sites.iter().flat_map(|&site| clipped.parts(site));
        let cells = parts.map(|part| {
            let corners = part.outline().iter();
            corners.map(|&p| p.into()).collect::<Vec<[f64; 2]>>()
        });
        Answer::of_clipped(self.input, made.and_then(cut), &bounds, cells)
    }
}

fn say(error: Error) -> String {
    error.to_string()
}
