//! What SVG and PNG pictures share: where things lie on the page and how they look.
//!
//! Triangles are coloured by their smallest angle. Edges are drawn thinner and fainter the shorter
//! they are, and not at all below a few pixels, so that a million triangles show as a map of their
//! quality; points are dots as long as there is room between them. y points up. What a domain adds is
//! in [`domain`], what data add that the triangles hold, in [`counts`].

pub(crate) mod accumulate;
mod angle;
pub(crate) mod cells;
mod color;
mod counts;
pub(crate) mod domain;
pub(crate) mod glyphs;
pub(crate) mod legend;
pub(crate) mod relief;
pub(crate) mod sheet;
mod view;

pub(crate) use angle::smallest_angle;
pub(crate) use color::{Color, INK, PAPER, even_scale, scale};
pub(crate) use view::{Page, View};

use crate::{Error, MeshView, PictureOptions, cancel};
use delone::{Phase, Point, VertexId, Watch};

/// Classes of colour: angles are rounded to half degrees.
pub(crate) const CLASSES: usize = 120;

/// Classes of line width.
const WIDTHS: usize = 8;

/// Triangles or edges between two looks at the watch.
const ITEMS_PER_POLL: usize = 4096;

/// Edges with less room than the first (in pixels at the usual size) are not drawn; from the second
/// on they have full width.
const FADE: [f32; 2] = [3.5, 22.0];

/// The passes over all triangles that a picture takes.
#[derive(Clone, Copy)]
enum Pass {
    Angles,
    Areas,
    Edges,
}

impl Pass {
    const COUNT: u64 = 3;
}

/// Edges of one width and opacity.
pub(crate) struct EdgeClass {
    /// Width in pixels.
    pub width: f32,
    /// Opacity from 0 to 1.
    pub opacity: f32,
    /// Ends in pixels.
    pub edges: Vec<[[f32; 2]; 2]>,
}

/// Refuses pictures that are too small or too large.
pub(crate) fn require_size(file: &str, options: &PictureOptions) -> Result<(), Error> {
    const SIZES: std::ops::RangeInclusive<u32> = 16..=8192;
    if SIZES.contains(&options.size) {
        return Ok(());
    }
    let reason = format!("size {} pixels: must be from 16 to 8192", options.size);
    let file = file.to_owned();
    Err(Error::Picture { file, reason })
}

/// Everything that is to be drawn, in pixels.
pub(crate) struct Scene<'a> {
    file: &'a str,
    mesh: &'a MeshView<'a>,
    watch: &'a dyn Watch,
    pub view: View,
    /// Class of colour of each triangle.
    classes: Vec<u8>,
    /// Size of a detail that should look alike at any size of the picture.
    pub unit: f32,
    pub legend: bool,
}

impl<'a> Scene<'a> {
    /// Lays the picture out. `file` is named in errors.
    pub fn new(
        file: &'a str,
        mesh: &'a MeshView<'a>,
        options: &PictureOptions,
        watch: &'a dyn Watch,
    ) -> Result<Self, Error> {
        require_size(file, options)?;
        let legend = options.legend && !mesh.triangles.is_empty();
        let page = Page::new(options.size as f32, legend);
        let mut scene = Self {
            file,
            mesh,
            watch,
            view: View::new(mesh.points, &page),
            classes: Vec::with_capacity(mesh.triangles.len()),
            unit: page.unit,
            legend,
        };
        for (t, &corners) in mesh.triangles.iter().enumerate() {
            scene.poll(Pass::Angles, t)?;
            let class = match mesh.counts {
                Some(counts) => counts::class(counts.held[t], counts.range),
                None => scene.class_of_angle(corners),
            };
            scene.classes.push(class);
        }
        Ok(scene)
    }

    fn class_of_angle(&self, corners: [VertexId; 3]) -> u8 {
        let corners = corners.map(|v| self.view.normalized(self.mesh.points[v.index()]));
        let class = (smallest_angle(corners) / 60.0 * CLASSES as f64) as usize;
        class.min(CLASSES - 1) as u8
    }

    /// Lists the colours of the classes.
    pub fn colors(&self) -> Vec<Color> {
        match self.mesh.counts {
            Some(_) => (0..=counts::TOO_MANY).map(counts::color).collect(),
            None => (0..CLASSES)
                .map(|class| scale((class as f32 + 0.5) / CLASSES as f32))
                .collect(),
        }
    }

    /// Lays out the legend, if there is to be one.
    pub fn sheet_of_legend(&self) -> Option<sheet::Sheet> {
        let lay_out = || match self.mesh.counts {
            Some(held) => counts::legend(self, held),
            None => legend::legend(self),
        };
        self.legend.then(lay_out)
    }

    /// Returns the name of the picture, for messages.
    pub fn file(&self) -> &'a str {
        self.file
    }

    /// Reports that triangle `t` is done in this pass, now and then, and fails if cancelled.
    fn poll(&self, pass: Pass, t: usize) -> Result<(), Error> {
        if !t.is_multiple_of(ITEMS_PER_POLL) {
            return Ok(());
        }
        let m = self.mesh.triangles.len() as u64;
        let done = pass as u64 * m + t as u64;
        self.watch.progress(Phase::Draw, done, Pass::COUNT * m);
        self.check()
    }

    /// Fails if cancelled; asks in one of many rounds.
    fn check_now_and_then(&self, round: usize) -> Result<(), Error> {
        cancel::check(self.watch, round)
    }

    /// Fails if cancelled.
    pub fn check(&self) -> Result<(), Error> {
        cancel::check(self.watch, 0)
    }

    /// Returns where a vertex lies on the page.
    fn place(&self, v: VertexId) -> [f32; 2] {
        self.view.place(self.mesh.points[v.index()])
    }

    /// Tells whether there are points and nothing else.
    pub fn is_bare(&self) -> bool {
        self.num_triangles() == 0 && self.num_segments() == 0
    }

    /// Counts what would be drawn one by one.
    pub fn num_shapes(&self) -> usize {
        let points = self.dotted().len();
        self.num_triangles().max(points).max(self.num_segments())
    }

    pub fn num_triangles(&self) -> usize {
        self.mesh.triangles.len()
    }

    /// Gives each triangle, in pixels and counter-clockwise, with its class of colour to `take`.
    pub fn each_triangle(&self, mut take: impl FnMut([[f32; 2]; 3], usize)) -> Result<(), Error> {
        for (t, &[a, b, c]) in self.mesh.triangles.iter().enumerate() {
            self.poll(Pass::Areas, t)?;
            let corners = if self.is_clockwise([a, b, c]) {
                [a, c, b]
            } else {
                [a, b, c]
            };
            take(corners.map(|v| self.place(v)), self.classes[t].into());
        }
        Ok(())
    }

    /// Tells the direction of a triangle before its corners are rounded to pixels: triangles far
    /// below a pixel would often come out reversed, and break the tiling.
    fn is_clockwise(&self, corners: [VertexId; 3]) -> bool {
        let [a, b, c] = corners.map(|v| self.view.normalized(self.mesh.points[v.index()]));
        (b.x - a.x) * (c.y - a.y) < (b.y - a.y) * (c.x - a.x)
    }

    /// Sorts the edges that can be seen by width; each comes once.
    pub fn edges(&self) -> Result<Vec<EdgeClass>, Error> {
        let mut visible = Vec::new();
        for (t, &triangle) in self.mesh.triangles.iter().enumerate() {
            self.poll(Pass::Edges, t)?;
            for k in 0..3 {
                let [apex, a, b] = [0, 1, 2].map(|i| triangle[(k + i) % 3]);
                // The shortest are the most: they need no room in the list.
                if self.width_class(a, b, None).is_some() {
                    let class = self.width_class(a, b, Some(apex));
                    visible.push(([a.min(b), a.max(b)], class));
                }
            }
        }
        if self.mesh.triangles.is_empty() {
            let edges = self.mesh.collinear_edges();
            visible.extend(edges.map(|edge| (edge, None)));
        }
        visible.sort_unstable();
        let mut classes: Vec<_> = (0..WIDTHS).map(|i| self.edge_class(i)).collect();
        for same in visible.chunk_by(|a, b| a.0 == b.0) {
            // Of the two sides, the one with more room decides; it sorts last. Beyond the hull there
            // is room for any edge.
            let (ends, class) = match *same {
                [([a, b], _)] => ([a, b], self.width_class(a, b, None)),
                _ => same[same.len() - 1],
            };
            if let Some(class) = class {
                classes[class].edges.push(ends.map(|v| self.place(v)));
            }
        }
        Ok(classes)
    }

    fn edge_class(&self, class: usize) -> EdgeClass {
        let strength = (class + 1) as f32 / WIDTHS as f32;
        EdgeClass {
            width: self.unit * (0.45 + 0.85 * strength),
            opacity: 0.75 * strength.powf(0.8),
            edges: Vec::new(),
        }
    }

    /// Returns the class of width of an edge, or `None` if it is too short to be seen, or its
    /// triangle too narrow.
    fn width_class(&self, a: VertexId, b: VertexId, apex: Option<VertexId>) -> Option<usize> {
        let [a, b] = [a, b].map(|v| self.place(v));
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        let height = apex.map_or(length, |apex| {
            let c = self.place(apex);
            let cross = along[0] * (c[1] - a[1]) - along[1] * (c[0] - a[0]);
            cross.abs() / length.max(f32::MIN_POSITIVE)
        });
        let room = length.min(3.0 * height) / self.unit;
        let strength = (room - FADE[0]) / (FADE[1] - FADE[0]);
        let class = (strength * WIDTHS as f32).ceil().min(WIDTHS as f32);
        (class >= 1.0).then(|| class as usize - 1)
    }

    /// Returns the points in pixels and the radius of their dots, if there is room for dots.
    pub fn dots(&self) -> Option<(impl Iterator<Item = [f32; 2]> + '_, f32)> {
        let n = self.dotted().len().max(1) as f32;
        let spacing = (self.view.area() / n).sqrt() / self.unit;
        // What is the subject may be smaller than what is an addition.
        let (share, least, fits) = if self.is_bare() {
            (0.3, 0.6, 0.0)
        } else if self.mesh.counts.is_some() {
            (0.16, 0.0, 0.55)
        } else {
            (0.07, 0.0, 1.3)
        };
        let radius = (spacing * share).clamp(least, 4.5);
        let place = |&p: &Point| self.view.place(p);
        let dots = || (self.dotted().iter().map(place), radius * self.unit);
        (radius >= fits).then(dots)
    }

    /// Returns what may be shown as dots: the data if there are some, else the vertices.
    fn dotted(&self) -> &[Point] {
        self.mesh.counts.map_or(self.mesh.points, |held| held.data)
    }

    /// Says what is shown, for those who cannot see it.
    pub fn title(&self) -> String {
        let m = self.mesh.triangles.len();
        match self.mesh.counts {
            Some(held) => format!("{m} triangles that hold {} data", held.data.len()),
            None => format!("{m} triangles over {} points", self.mesh.points.len()),
        }
    }

    /// Returns the share of triangles in each of `N` equal ranges of angle, the largest share as 1.
    pub fn histogram<const N: usize>(&self) -> [f32; N] {
        let mut counts = [0u32; N];
        for &class in &self.classes {
            counts[usize::from(class) * N / CLASSES] += 1;
        }
        let most = counts.iter().copied().max().unwrap_or(0).max(1);
        counts.map(|count| count as f32 / most as f32)
    }
}
