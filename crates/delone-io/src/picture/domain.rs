//! What a domain adds to a picture: segments as heavy lines, crossings as small rings, and along the
//! border of each region, on its inner side, a band of its colour.
//!
//! The colour of triangles stays that of their angles, so a region shows by its border alone. Holes,
//! and all that was carved away, stay paper.

use super::{Color, EdgeClass, INK, PAPER, Scene};
use crate::Error;
use delone::VertexId;

/// Colours of regions, unlike those of angles; further regions begin again.
pub(crate) const REGION_COLORS: [Color; 6] = [
    Color([0.91, 0.27, 0.17]),
    Color([0.06, 0.72, 0.90]),
    Color([0.83, 0.13, 0.60]),
    Color([1.00, 0.62, 0.11]),
    Color([0.55, 0.29, 0.12]),
    Color([0.10, 0.13, 0.52]),
];

/// Width of segments in pixels of the usual size, where there is room and where there is none.
const WIDTHS: [f32; 2] = [3.6, 0.7];

/// Width of the paper around a segment, as a multiple of its own.
const CASING: f32 = 2.0;

/// Share of the page that segments may cover before they are drawn thinner.
const INKED: f32 = 0.04;

/// Width in pixels of the usual size, and opacity, of the bands.
pub(crate) const BAND_WIDTH: f32 = 10.0;
pub(crate) const BAND_OPACITY: f32 = 0.85;

/// Share of the radius of a ring that is paper.
pub(crate) const RING: f32 = 0.6;

/// Border of the regions of one colour.
pub(crate) struct Band {
    /// The colour.
    pub color: Color,
    /// Closed lines, all with the regions on the same side.
    pub loops: Vec<Vec<[f32; 2]>>,
}

impl Scene<'_> {
    /// Returns the constrained edges that are to be drawn: first a fainter and wider line of paper,
    /// which sets them off from dark triangles, then the line itself.
    pub fn segments(&self) -> Result<[(EdgeClass, Color); 2], Error> {
        let all = self.mesh.constraints.map_or(&[][..], |c| &c.edges);
        let mut edges = Vec::with_capacity(all.len());
        let mut length = 0.0;
        for (e, &ends) in all.iter().enumerate() {
            self.check_now_and_then(e)?;
            let [a, b] = ends.map(|v| self.place(v));
            length += (b[0] - a[0]).hypot(b[1] - a[1]) / self.unit;
            edges.push([a, b]);
        }
        let width = self.segment_width(length) * self.unit;
        let casing = EdgeClass {
            width: CASING * width,
            opacity: 0.5,
            edges: edges.clone(),
        };
        let line = EdgeClass {
            width,
            opacity: 1.0,
            edges,
        };
        Ok([(casing, PAPER), (line, INK)])
    }

    fn segment_width(&self, length: f32) -> f32 {
        let room = self.view.area() / (self.unit * self.unit);
        let fitting = INKED * room / length.max(1.0);
        fitting.clamp(WIDTHS[1], WIDTHS[0])
    }

    /// Returns where segments cross, and the radius of the rings there, if there is room for them.
    pub fn crossings(&self) -> Option<(impl Iterator<Item = [f32; 2]> + '_, f32)> {
        let crossings = self.mesh.constraints.map_or(0..0, |c| c.crossings.clone());
        let count = crossings.len();
        let spacing = (self.view.area() / count.max(1) as f32).sqrt() / self.unit;
        let radius = (0.07 * spacing).min(4.6);
        let places = crossings.map(|v| self.place(VertexId::new(v)));
        (count > 0 && radius >= 1.8).then_some((places, radius * self.unit))
    }

    /// Counts the constrained edges.
    pub fn num_segments(&self) -> usize {
        self.mesh.constraints.map_or(0, |c| c.edges.len())
    }

    /// Lists the attributes of the regions, if it is known which triangles are in them.
    pub fn regions(&self) -> Vec<f64> {
        let known = self.mesh.constraints.filter(|c| c.region_of.is_some());
        let regions = known.map_or(&[][..], |c| &c.regions);
        regions.iter().map(|region| region.attribute).collect()
    }

    /// Finds the borders of regions, those of one colour together.
    pub fn bands(&self) -> Result<Vec<Band>, Error> {
        let mut sides = self.sides()?;
        sides.sort_unstable();
        let mut borders = vec![Vec::new(); REGION_COLORS.len()];
        for same in sides.chunk_by(|a, b| a.edge == b.edge) {
            for side in same {
                let others = same.iter().filter(|other| other.region == side.region);
                if others.count() == 1 {
                    borders[side.region as usize % REGION_COLORS.len()].push(side.half_edge());
                }
            }
        }
        let bands = borders.into_iter().zip(REGION_COLORS);
        let band = |(border, color)| Band {
            color,
            loops: self.loops(border),
        };
        Ok(bands
            .map(band)
            .filter(|band| !band.loops.is_empty())
            .collect())
    }

    /// Lists the sides of all triangles in regions.
    fn sides(&self) -> Result<Vec<Side>, Error> {
        let mut sides = Vec::new();
        let regions = self.mesh.constraints.and_then(|c| c.region_of.as_deref());
        for (t, region) in regions.unwrap_or_default().iter().enumerate() {
            self.check_now_and_then(t)?;
            let Some(region) = *region else { continue };
            let [a, b, c] = self.mesh.triangles[t];
            sides.extend([[a, b], [b, c], [c, a]].map(|[from, to]| Side {
                edge: [from.min(to), from.max(to)],
                region,
                is_reversed: to < from,
            }));
        }
        Ok(sides)
    }

    /// Joins half-edges to closed lines. Where several meet in a vertex, any will do: what lies on
    /// their left stays the same.
    fn loops(&self, mut border: Vec<[VertexId; 2]>) -> Vec<Vec<[f32; 2]>> {
        border.sort_unstable();
        let mut is_used = vec![false; border.len()];
        let mut loops = Vec::new();
        for start in 0..border.len() {
            let mut line = Vec::new();
            let mut next = Some(start).filter(|&i| !is_used[i]);
            while let Some(i) = next {
                is_used[i] = true;
                let [from, to] = border[i];
                line.push(self.place(from));
                let first = border.partition_point(|h| h[0] < to);
                let leaving = border[first..].iter().take_while(|h| h[0] == to).count();
                next = (first..first + leaving).find(|&i| !is_used[i]);
            }
            if !line.is_empty() {
                loops.push(line);
            }
        }
        loops
    }
}

/// A side of a triangle in a region.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    edge: [VertexId; 2],
    region: u32,
    /// Whether the triangle's half-edge begins at the higher end.
    is_reversed: bool,
}

impl Side {
    fn half_edge(self) -> [VertexId; 2] {
        let [low, high] = self.edge;
        if self.is_reversed {
            [high, low]
        } else {
            [low, high]
        }
    }
}
