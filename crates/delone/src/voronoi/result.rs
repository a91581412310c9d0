//! The diagram as it is handed out.

use super::diagram::{AT_INFINITY, Diagram, Euclidean, Metric, Power, Side};
use super::dual::dual;
use super::measure::{Measure, Moments, difference, length};
use crate::{Delaunay, Duplicate, Error, Point, Triangulation, VertexId, Watch};
use std::borrow::Cow;

/// The Voronoi diagram of the vertices of a triangulation; site `i` is point `i`.
///
/// ```
/// use delone::voronoi::{Domain, Voronoi};
///
/// // The corners of a square lie on one circle: one vertex, from which four rays go.
/// let t = delone::triangulate([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])?;
/// let voronoi = Voronoi::new(&t, &())?;
/// assert_eq!(voronoi.vertices(), [(1.0, 1.0).into()]);
/// assert_eq!(voronoi.edges().count(), 4);
///
/// let window = Domain::rectangle((-1.0, -1.0), (4.0, 2.0))?;
/// let clipped = voronoi.clip(&window, &())?;
/// let areas: Vec<f64> = voronoi.cells().map(|c| clipped.measure(c.site()).area).collect();
/// assert_eq!(areas, [4.0, 6.0, 3.0, 2.0]);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Voronoi {
    pub(super) sites: Vec<Point>,
    pub(super) diagram: Diagram,
    pub(super) duplicates: Vec<Duplicate>,
    /// Of a power diagram.
    pub(super) weights: Option<Vec<f64>>,
    /// Sites without a cell, sorted.
    pub(super) hidden: Vec<VertexId>,
}

/// An edge: what is equally far from two sites, and not farther from them than from any other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The sites, the one to the left first, along the direction of the line.
    pub sites: [VertexId; 2],
    /// Where it runs.
    pub line: Line,
}

/// Where an edge runs. Directions have length 1, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// Between two vertices.
    Segment([usize; 2]),
    /// From a vertex to infinity.
    Ray {
        /// The vertex.
        from: usize,
        /// Where to.
        direction: [f64; 2],
    },
    /// From infinity to infinity; so it is if all sites lie on one line.
    Full {
        /// A point of it, rounded: the one between the two sites.
        through: Point,
        /// Where to.
        direction: [f64; 2],
    },
}

impl Voronoi {
    /// Makes the diagram of the vertices of a triangulation.
    ///
    /// What was carved away from a domain does not matter, nor do segments: the diagram is that of all
    /// vertices. If the triangulation is not Delaunay, because of segments, its vertices are triangulated
    /// anew.
    ///
    /// # Errors
    /// [`Error::Cancelled`] if the watch says so.
    ///
    /// *Cost*: linear; about 0.7 µs a site.
    pub fn new(triangulation: &Triangulation, watch: &dyn Watch) -> Result<Self, Error> {
        let points = triangulation.points();
        let dual = |t: &Triangulation| dual(t.mesh(), points.len(), &Euclidean(points), watch);
        let (t, diagram) = match dual(triangulation)? {
            Some(diagram) => (Cow::Borrowed(triangulation), diagram),
            None => {
                let builder = Delaunay::new().watch(watch);
                let t = builder.triangulate(points.iter().copied())?;
                let diagram = dual(&t)?.expect("bug: not Delaunay");
                (Cow::Owned(t), diagram)
            }
        };
        Ok(Self {
            sites: points.to_vec(),
            diagram,
            duplicates: t.duplicates().to_vec(),
            weights: None,
            hidden: Vec::new(),
        })
    }

    /// Returns the sites, duplicates included.
    pub fn sites(&self) -> &[Point] {
        &self.sites
    }

    /// Returns the vertices, rounded correctly; a coordinate beyond the largest number is that number.
    /// Each is equally far from three sites at least, and no site is nearer.
    pub fn vertices(&self) -> &[Point] {
        &self.diagram.vertices
    }

    /// Visits the edges.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = Edge> + '_ {
        (0..self.diagram.edges.len()).map(|edge| self.edge(edge))
    }

    /// Returns an edge.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn edge(&self, edge: usize) -> Edge {
        let edge = self.diagram.edges[edge];
        let [left, right] = edge.sites;
        let reversed = [right, left];
        match edge.ends {
            [AT_INFINITY, AT_INFINITY] => Edge {
                sites: edge.sites,
                line: Line::Full {
                    through: self.middle(edge.sites),
                    direction: self.direction(edge.sites),
                },
            },
            [from, AT_INFINITY] => self.ray(edge.sites, from),
            [AT_INFINITY, to] => self.ray(reversed, to),
            ends => Edge {
                sites: edge.sites,
                line: Line::Segment(ends.map(|v| v as usize)),
            },
        }
    }

    fn ray(&self, sites: [VertexId; 2], from: u32) -> Edge {
        let line = Line::Ray {
            from: from as usize,
            direction: self.direction(sites),
        };
        Edge { sites, line }
    }

    /// Returns the direction that has the first site to its left.
    fn direction(&self, [left, right]: [VertexId; 2]) -> [f64; 2] {
        let [left, right] = [left, right].map(|v| self.sites[v.index()]);
        let ([x, y], _) = difference(left, right);
        let length = length(x, y);
        [0.0 - y / length, x / length]
    }

    /// Returns the point between two sites that is equally far from both; with weights, the point of their
    /// line of equal power.
    fn middle(&self, sites: [VertexId; 2]) -> Point {
        let [a, b] = sites.map(|v| self.sites[v.index()]);
        if let Some(metric) = self.power() {
            return metric.place([a, b], sites[0], sites[1]);
        }
        let between = |a: f64, b: f64| match (a + b).is_finite() {
            true => (a + b) / 2.0,
            false => a / 2.0 + b / 2.0,
        };
        Point::new(between(a.x, b.x), between(a.y, b.y))
    }

    /// Returns the metric of a power diagram.
    pub(super) fn power(&self) -> Option<Power<'_>> {
        let points = &self.sites;
        self.weights
            .as_deref()
            .map(|weights| Power { points, weights })
    }

    /// Returns the site that stands for another: itself unless it is a duplicate.
    ///
    /// *Cost*: O(log d) for d duplicates.
    pub fn representative(&self, site: VertexId) -> VertexId {
        match self.duplicates.binary_search_by_key(&site, |d| d.dropped) {
            Ok(i) => self.duplicates[i].kept,
            Err(_) => site,
        }
    }

    /// Returns the cell of a site, for a duplicate that of the site that stands for it. That of a site
    /// hidden in a power diagram has no sides.
    ///
    /// # Panics
    /// If there is no such site.
    pub fn cell(&self, site: VertexId) -> Cell<'_> {
        assert!(site.index() < self.sites.len(), "no site {site}");
        Cell {
            voronoi: self,
            site: self.representative(site),
        }
    }

    /// Visits the cells, one for each distinct site, by site; in a power diagram one for each that is not
    /// hidden.
    pub fn cells(&self) -> impl Iterator<Item = Cell<'_>> {
        let mut duplicates = self.duplicates.iter().map(|d| d.dropped).peekable();
        let mut hidden = self.hidden.iter().copied().peekable();
        let sites = (0..self.sites.len()).map(VertexId::new);
        let distinct = sites.filter(move |site| {
            duplicates.next_if_eq(site).is_none() && hidden.next_if_eq(site).is_none()
        });
        distinct.map(|site| Cell {
            voronoi: self,
            site,
        })
    }
}

/// The part of the plane of one site: a convex polygon, perhaps without end.
#[derive(Clone, Copy, Debug)]
pub struct Cell<'a> {
    voronoi: &'a Voronoi,
    site: VertexId,
}

/// A side of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellSide {
    /// The site beyond it.
    pub neighbor: VertexId,
    /// Its edge.
    pub edge: usize,
    /// The vertices where it begins and ends, counter-clockwise around the cell; `None` is infinity.
    pub ends: [Option<usize>; 2],
}

impl<'a> Cell<'a> {
    /// Returns the site.
    pub fn site(&self) -> VertexId {
        self.site
    }

    /// Returns the position of the site.
    pub fn point(&self) -> Point {
        self.voronoi.sites[self.site.index()]
    }

    /// Tells whether the cell has an end everywhere: whether its site lies inside the convex hull.
    pub fn is_bounded(&self) -> bool {
        let diagram = &self.voronoi.diagram;
        match self.inner_sides().next() {
            Some(side) => diagram.ends(side)[0] != AT_INFINITY,
            // A lone site has the plane; among others, weights may leave one a point or nothing.
            None => !diagram.edges.is_empty(),
        }
    }

    /// Visits the sides counter-clockwise. If the cell is not bounded, the first begins at infinity and the
    /// last ends there; between two lines, both do. The cell of a lone site has no sides; in a power diagram there may be
    /// cells without sides that are a point or nothing.
    pub fn sides(&self) -> impl ExactSizeIterator<Item = CellSide> + Clone + use<'a> {
        let diagram = &self.voronoi.diagram;
        self.inner_sides().map(|side| CellSide {
            neighbor: diagram.beyond(side),
            edge: side.edge as usize,
            ends: diagram
                .ends(side)
                .map(|v| (v != AT_INFINITY).then_some(v as usize)),
        })
    }

    fn inner_sides(&self) -> impl ExactSizeIterator<Item = Side> + Clone + use<'a> {
        self.voronoi.diagram.sides(self.site)
    }

    /// Visits the corners counter-clockwise; if the cell is not bounded, from the first ray to the last.
    pub fn corners(&self) -> impl Iterator<Item = Point> + Clone + use<'a> {
        let vertices = &self.voronoi.diagram.vertices;
        let ends = self.sides().filter_map(|side| side.ends[1]);
        ends.map(|v| vertices[v])
    }

    /// Measures a cell, in rounded numbers; `None` if it is not bounded.
    pub fn measure(&self) -> Option<Measure> {
        let corners = || self.corners().collect::<Vec<_>>();
        self.is_bounded()
            .then(|| Moments::of(std::iter::once(&corners()[..])).finish())
    }
}
