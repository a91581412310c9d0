//! A head start where triangles have to be of one size: a lattice of equilateral ones.
//!
//! Whoever halves triangles until they are small enough ends, on average, at two thirds of the largest area
//! allowed. Equilateral triangles can be as large as allowed, everywhere but along the segments. So before
//! refinement begins, segments are cut into equal pieces as long as the sides of such triangles, and the
//! vertices of a hexagonal lattice are spread over the domain, but for those close to a segment or vertex.
//! The bulk builder triangulates them; the loop has only to mend what lies between.
//!
//! The lattice is shaken a little: an exact one has six vertices around every seventh, all cocircular, and
//! each tie would have to be found out exactly.
//!
//! *Cost*: linear in faces and vertices, and that of a triangulation.

use super::lines::distance;
use crate::constrained::{Additions, Prepared};
use crate::{HalfEdgeId, Point, Quality, TriangleId};

/// The lattice's triangles are so much smaller than allowed, so that shaking does not make them too large.
const FILLED: f64 = 0.985;
/// Its sides are so much shorter than allowed: vertices along segments need room to move (measured: where half
/// of the triangles lie there, 0.985 takes 5 % more of them, and where few do, 6 % fewer).
const STRETCHED: f64 = 0.95;
/// Nothing of the lattice lies closer than this to segments and vertices, in units of its side.
const CLEAR: f64 = 0.6;
/// Segments with something closer by than this are not cut beforehand, in units of the side.
const NARROW: f64 = 1.0 / 16.0;
/// How far vertices are shaken, in units of its side.
const SHAKEN: f64 = 1e-4;
/// Fewer triangles are not worth a lattice; more would take memory and seconds before anybody is asked.
const WORTHWHILE: std::ops::Range<f64> = 64.0..3e7;
/// The area of an equilateral triangle of side 1, and its height.
const AREA: f64 = 0.433_012_701_892_219_3;
const HEIGHT: f64 = 0.866_025_403_784_438_6;

/// Says which vertices give refinement a head start; `None` if sizes are not bounded, or if they are more than
/// there is `room` for.
pub(super) fn sow(prepared: &Prepared, quality: &Quality, room: usize) -> Option<Additions> {
    let plan = Plan::new(prepared, quality)?;
    let mut sizes: Vec<f64> = plan
        .sides
        .iter()
        .copied()
        .filter(|s| s.is_finite())
        .collect();
    sizes.sort_by(f64::total_cmp);
    sizes.dedup();
    let triangles = plan.expected();
    // There are half as many vertices, and the lattice is not quite full.
    if !WORTHWHILE.contains(&triangles) || 0.3 * triangles > room as f64 {
        return None;
    }
    let mut additions = Additions {
        cuts: plan.cuts(),
        free: Vec::new(),
    };
    for side in sizes {
        let mut lattice = Lattice::over(&plan, side, triangles)?;
        lattice.clear(&plan, &additions.cuts);
        lattice.fill(&plan, &mut additions.free);
    }
    let on_edges = additions.cuts.iter().map(|(_, points)| points.len());
    let vertices = additions.free.len() + on_edges.sum::<usize>();
    (vertices <= room).then_some(additions)
}

/// The domain, and how long sides may be in it.
struct Plan<'a> {
    prepared: &'a Prepared,
    /// For each region, that of none first.
    sides: Vec<f64>,
}

impl<'a> Plan<'a> {
    fn new(prepared: &'a Prepared, quality: &Quality) -> Option<Self> {
        let side = |area: Option<f64>| {
            let area = area
                .unwrap_or(f64::INFINITY)
                .min(quality.max_area.unwrap_or(f64::INFINITY));
            let edge = quality.max_edge.unwrap_or(f64::INFINITY);
            (FILLED * area / AREA).sqrt().min(STRETCHED * edge)
        };
        let regions = prepared.context.pslg.regions.iter();
        let of_regions = regions.map(|r| side(r.max_area.filter(|_| quality.region_areas)));
        let sides: Vec<f64> = std::iter::once(side(None)).chain(of_regions).collect();
        sides
            .iter()
            .any(|s| s.is_finite())
            .then_some(Self { prepared, sides })
    }

    /// Returns the longest side allowed in face `t`; infinite outside.
    fn side(&self, t: TriangleId) -> f64 {
        let faces = &self.prepared.faces;
        match faces.outside[t.index()] {
            true => f64::INFINITY,
            false => self.sides[faces.region_of.get(t.index()).map_or(0, |&r| r as usize)],
        }
    }

    /// Visits the faces of the domain.
    fn domain(&self) -> impl Iterator<Item = TriangleId> + '_ {
        let faces = &self.prepared.faces;
        let all = (0..faces.outside.len()).map(TriangleId::new);
        all.filter(|t| !faces.outside[t.index()])
    }

    fn corners(&self, t: TriangleId) -> [Point; 3] {
        let corners = self.prepared.faces.mesh.corners(t);
        corners.map(|v| self.prepared.points[v.index()])
    }

    /// Estimates the number of triangles.
    fn expected(&self) -> f64 {
        let of_face = |t: TriangleId| {
            let [a, b, c] = self.corners(t);
            let cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            let side = self.side(t);
            0.5 * cross / (AREA * side * side)
        };
        self.domain().map(of_face).sum()
    }

    /// Visits each constrained edge of the domain once, with the shorter of the sides beside it.
    fn segments(&self) -> impl Iterator<Item = (HalfEdgeId, f64)> + '_ {
        let faces = &self.prepared.faces;
        let all = faces.mesh.half_edges();
        let once = all.filter(|&h| {
            let bits = faces.constrained[h.triangle().index()];
            h < faces.mesh.twin(h) && bits >> h.slot() & 1 == 1
        });
        let beside = once.map(|h| {
            let [s, t] = [h, faces.mesh.twin(h)].map(|h| self.side(h.triangle()));
            (h, s.min(t))
        });
        beside.filter(|(_, side)| side.is_finite())
    }

    /// Cuts long segments into equal pieces.
    fn cuts(&self) -> Vec<([crate::VertexId; 2], Vec<Point>)> {
        let mesh = &self.prepared.faces.mesh;
        let cut = self.segments().filter_map(|(h, side)| {
            let ends = [mesh.origin(h), mesh.dest(h)];
            let [a, b] = ends.map(|v| self.prepared.points[v.index()]);
            let pieces = (distance(a, b) / side).ceil();
            let at = |i: u32| {
                let t = f64::from(i) / pieces;
                Point::new(a.x + t * (b.x - a.x) + 0.0, a.y + t * (b.y - a.y) + 0.0)
            };
            let is_open = pieces > 1.0 && self.is_open(h, NARROW * side);
            is_open.then(|| (ends, (1..pieces as u32).map(at).collect()))
        });
        cut.collect()
    }

    /// Tells whether nothing lies opposite a segment at less than this distance. In narrow channels
    /// refinement has to choose where vertices on both sides go.
    fn is_open(&self, h: HalfEdgeId, distance: f64) -> bool {
        let both = [h, self.prepared.faces.mesh.twin(h)].map(HalfEdgeId::triangle);
        both.into_iter()
            .filter(|&t| self.side(t).is_finite())
            .all(|t| {
                let [a, b, c] = self.corners(t);
                let cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
                let sides = [[a, b], [b, c], [c, a]].map(|[p, q]| self::distance(p, q));
                let longest = sides.into_iter().fold(0.0, f64::max);
                cross > distance * longest
            })
    }
}

/// A hexagonal lattice, and which of its vertices are taken.
struct Lattice {
    side: f64,
    origin: Point,
    columns: usize,
    rows: usize,
    taken: Vec<u64>,
}

impl Lattice {
    /// Lays a lattice over the domain; `None` if it were far larger than what it holds, or finer than
    /// coordinates are.
    fn over(plan: &Plan, side: f64, triangles: f64) -> Option<Self> {
        let points = plan.domain().flat_map(|t| plan.corners(t));
        let empty = [
            f64::INFINITY,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::NEG_INFINITY,
        ];
        let [left, low, right, high] = points.fold(empty, |[l, b, r, t], p| {
            [l.min(p.x), b.min(p.y), r.max(p.x), t.max(p.y)]
        });
        let largest = left.abs().max(right.abs()).max(low.abs()).max(high.abs());
        let [columns, rows] = [
            (right - left) / side + 3.0,
            (high - low) / (HEIGHT * side) + 3.0,
        ];
        let is_sparse = columns * rows > 64.0 * (triangles + 1e5);
        if is_sparse || side < 1e-9 * largest || !(columns * rows).is_finite() {
            return None;
        }
        let [columns, rows] = [columns as usize, rows as usize];
        Some(Self {
            side,
            origin: Point::new(left - side, low - 0.5 * HEIGHT * side),
            columns,
            rows,
            taken: vec![0; (columns * rows).div_ceil(64)],
        })
    }

    /// Returns how far row `j` is shifted, and its height.
    fn row(&self, j: usize) -> [f64; 2] {
        let shift = if j % 2 == 1 { 0.5 * self.side } else { 0.0 };
        let y = self.origin.y + HEIGHT * self.side * j as f64;
        [self.origin.x + shift, y]
    }

    fn at(&self, i: usize, j: usize) -> Point {
        let [x, y] = self.row(j);
        Point::new(x + self.side * i as f64, y)
    }

    /// Takes a vertex; false if it is taken already.
    fn take(&mut self, i: usize, j: usize) -> bool {
        let k = j * self.columns + i;
        let bit = 1 << (k % 64);
        let was_free = self.taken[k / 64] & bit == 0;
        self.taken[k / 64] |= bit;
        was_free
    }

    /// Takes what lies close to segments and vertices.
    fn clear(&mut self, plan: &Plan, cuts: &[([crate::VertexId; 2], Vec<Point>)]) {
        let points = &plan.prepared.points;
        let mesh = &plan.prepared.faces.mesh;
        let corners = plan.domain().filter(|&t| plan.side(t) == self.side);
        for p in corners.flat_map(|t| plan.corners(t)).collect::<Vec<_>>() {
            self.clear_around(p, p);
        }
        let mut cut = cuts.iter().peekable();
        for (h, _) in plan.segments() {
            let ends = [mesh.origin(h), mesh.dest(h)];
            let [a, b] = ends.map(|v| points[v.index()]);
            let inside = cut.next_if(|(e, _)| *e == ends);
            let mut from = a;
            for &to in inside.iter().flat_map(|(_, inside)| inside).chain([&b]) {
                self.clear_around(from, to);
                from = to;
            }
        }
    }

    /// Takes what lies close to the piece of a segment from `a` to `b`.
    fn clear_around(&mut self, a: Point, b: Point) {
        let clear = CLEAR * self.side;
        let first = |low: f64, step: f64| ((low / step).ceil().max(0.0)) as usize;
        let rise = HEIGHT * self.side;
        let [low, high] = [a.y.min(b.y) - clear, a.y.max(b.y) + clear];
        let [left, right] = [a.x.min(b.x) - clear, a.x.max(b.x) + clear];
        for j in first(low - self.origin.y, rise)..self.rows {
            let [x, y] = self.row(j);
            if y > high {
                break;
            }
            for i in first(left - x, self.side)..self.columns {
                let p = self.at(i, j);
                if p.x > right {
                    break;
                }
                if distance_to([a, b], p) < clear {
                    self.take(i, j);
                }
            }
        }
    }

    /// Hands out the vertices that are free and inside the faces that this lattice is for.
    fn fill(&mut self, plan: &Plan, out: &mut Vec<Point>) {
        let side = self.side;
        for t in plan.domain().filter(|&t| plan.side(t) == side) {
            let corners = plan.corners(t);
            let [low, high] = corners
                .iter()
                .fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], p| {
                    [l.min(p.y), h.max(p.y)]
                });
            let rise = HEIGHT * self.side;
            let first = ((low - self.origin.y) / rise).ceil().max(0.0) as usize;
            for j in first..self.rows {
                let [x, y] = self.row(j);
                if y >= high {
                    break;
                }
                let [left, right] = span(corners, y);
                let begin = ((left - x) / self.side).ceil().max(0.0) as usize;
                for i in begin..self.columns {
                    let p = self.at(i, j);
                    if p.x >= right {
                        break;
                    }
                    if self.take(i, j) {
                        out.push(self.shaken(p, i, j));
                    }
                }
            }
        }
    }

    /// Moves a vertex a little, always by the same.
    fn shaken(&self, p: Point, i: usize, j: usize) -> Point {
        let mut hash = (i as u64) << 32 | j as u64;
        let mut next = || {
            // The finaliser of MurmurHash3, a public-domain mixing function.
            hash ^= hash >> 33;
            hash = hash.wrapping_mul(0xff51_afd7_ed55_8ccd);
            hash ^= hash >> 33;
            hash = hash.wrapping_mul(0xc4ce_b9fe_1a85_ec53);
            hash ^= hash >> 33;
            (hash >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let reach = SHAKEN * self.side;
        Point::new(p.x + reach * next() + 0.0, p.y + reach * next() + 0.0)
    }
}

/// Returns between which abscissas a horizontal line is inside a triangle: the same for both triangles
/// along an edge.
fn span(corners: [Point; 3], y: f64) -> [f64; 2] {
    let mut span = [f64::INFINITY, f64::NEG_INFINITY];
    for k in 0..3 {
        let [p, q] = [corners[k], corners[(k + 1) % 3]];
        let [low, high] = if p.y <= q.y { [p, q] } else { [q, p] };
        if low.y <= y && y < high.y {
            let x = low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x);
            span = [span[0].min(x), span[1].max(x)];
        }
    }
    span
}

/// Returns how far `p` is from the segment between `a` and `b`.
fn distance_to([a, b]: [Point; 2], p: Point) -> f64 {
    let [ux, uy] = [b.x - a.x, b.y - a.y];
    let squared = ux * ux + uy * uy;
    let t = match squared > 0.0 {
        true => ((ux * (p.x - a.x) + uy * (p.y - a.y)) / squared).clamp(0.0, 1.0),
        false => 0.0,
    };
    distance(Point::new(a.x + t * ux, a.y + t * uy), p)
}
