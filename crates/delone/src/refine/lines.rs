//! The edges that were constrained before refinement, and what has become of them.
//!
//! A line is a subsegment of the input, from one vertex to the next. Refinement cuts it into a chain; each
//! vertex that it puts there knows its line, and its neighbours upon it.
//!
//! At *acute* corners, where two lines meet at less than 60 degrees with the domain between them, lines
//! are cut at distances from the corner that are as round as possible in binary. So the vertices on all
//! lines of a corner lie on common circles about it, and none encroaches upon another line: concentric
//! shells (Ruppert 1995), continued along the whole line.

use super::canvas::Canvas;
use crate::predicates::point_between;
use crate::{HalfEdgeId, Point, VertexId};

/// Stands for the line of a vertex that is on none.
pub(super) const NO_LINE: u32 = u32::MAX;

pub(super) struct Lines {
    lines: Vec<Line>,
    /// How many vertices there were before refinement.
    num_old: usize,
    /// For each vertex since: its line, and the vertex next to it there.
    places: Vec<Place>,
}

/// A line that has been cut.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub ends: [VertexId; 2],
    /// Which of the ends is an acute corner.
    acute: [bool; 2],
    /// The vertex after the first end.
    first: VertexId,
}

#[derive(Clone, Copy, Debug)]
struct Place {
    line: u32,
    next: VertexId,
}

impl Lines {
    /// Begins with nothing cut, and so many vertices.
    pub fn new(num_old: usize) -> Self {
        Self {
            lines: Vec::new(),
            num_old,
            places: Vec::new(),
        }
    }

    #[inline]
    pub fn get(&self, line: u32) -> &Line {
        &self.lines[line as usize]
    }

    pub fn num_old(&self) -> usize {
        self.num_old
    }

    /// Returns the line of a vertex that refinement has added; of all others, and of free ones, none.
    #[inline]
    pub fn of_vertex(&self, v: VertexId) -> Option<u32> {
        let place = self.places.get(v.index().checked_sub(self.num_old)?)?;
        Some(place.line).filter(|&line| line != NO_LINE)
    }

    #[inline]
    pub fn is_old(&self, v: VertexId) -> bool {
        v.index() < self.num_old
    }

    /// Returns the ends of the line that a subsegment belongs to.
    pub fn ends_of(&self, subsegment: [VertexId; 2]) -> [VertexId; 2] {
        match self.of_edge(subsegment) {
            Some(line) => self.get(line).ends,
            None => subsegment,
        }
    }

    /// Returns the line of a subsegment, unless it has not been cut yet.
    fn of_edge(&self, [a, b]: [VertexId; 2]) -> Option<u32> {
        self.of_vertex(a).or_else(|| self.of_vertex(b))
    }

    /// Returns the line of the subsegment of `h`.
    pub fn of_subsegment(&self, canvas: &Canvas, h: HalfEdgeId) -> Line {
        let ends = canvas.ends(h);
        match self.of_edge(ends) {
            Some(line) => self.lines[line as usize],
            None => Line {
                ends,
                acute: [h, canvas.mesh.twin(h)].map(|h| is_acute(canvas, h)),
                first: ends[1],
            },
        }
    }

    /// Registers the next vertex, which is free.
    pub fn push_free(&mut self) {
        self.places.push(Place {
            line: NO_LINE,
            next: VertexId::INFINITE,
        });
    }

    /// Registers the next vertex, which splits the subsegment from `x` to `y` of `line`.
    pub fn push_between(&mut self, line: Line, [x, y]: [VertexId; 2]) {
        let v = VertexId::new(self.num_old + self.places.len());
        let line = self.of_edge([x, y]).unwrap_or_else(|| {
            self.lines.push(line);
            self.lines.len() as u32 - 1
        });
        let [from, to] = match self.after(line, x) == y {
            true => [x, y],
            false => [y, x],
        };
        debug_assert_eq!(
            self.after(line, from),
            to,
            "bug: no subsegment of this line"
        );
        self.places.push(Place { line, next: to });
        match self.place_on(from) {
            None => self.lines[line as usize].first = v,
            Some(i) => self.places[i].next = v,
        }
    }

    /// Returns the vertex after `v` on `line`, or the infinite one if `v` is the last.
    fn after(&self, line: u32, v: VertexId) -> VertexId {
        let Line { ends, first, .. } = self.lines[line as usize];
        match self.place_on(v) {
            Some(i) => self.places[i].next,
            None if v == ends[0] => first,
            None => VertexId::INFINITE,
        }
    }

    /// Returns the index of the place of `v` unless it is an end of its line.
    fn place_on(&self, v: VertexId) -> Option<usize> {
        v.index().checked_sub(self.num_old)
    }

    /// Visits the vertices inside `line`, from its first end to its second.
    pub fn inside(&self, line: u32) -> impl DoubleEndedIterator<Item = VertexId> + use<> {
        let Line {
            ends, mut first, ..
        } = self.lines[line as usize];
        let mut inside = Vec::new();
        while first != ends[1] {
            inside.push(first);
            first = self.after(line, first);
        }
        inside.into_iter()
    }

    /// Visits the lines that have been cut, with their numbers.
    pub fn iter(&self) -> impl Iterator<Item = (u32, &Line)> {
        (0..).zip(&self.lines)
    }

    /// Visits for each added vertex its line, or [`NO_LINE`].
    pub fn owners(&self) -> impl ExactSizeIterator<Item = u32> + '_ {
        self.places.iter().map(|place| place.line)
    }

    /// Returns the corner at which two lines meet below 60 degrees, if they do.
    pub fn acute_corner(&self, canvas: &Canvas, [l, m]: [u32; 2]) -> Option<VertexId> {
        let [l, m] = [self.get(l), self.get(m)];
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            if l.ends[i] == m.ends[j] {
                let ends = [l.ends[1 - i], m.ends[1 - j]].map(|v| canvas.point(v));
                if is_sharp(canvas.point(l.ends[i]), ends) {
                    return Some(l.ends[i]);
                }
            }
        }
        None
    }
}

impl Line {
    /// Returns where to split the subsegment between two vertices; `culprit` is the vertex that is too close
    /// to it, if it is that.
    pub fn split_point(
        &self,
        canvas: &Canvas,
        ends: [VertexId; 2],
        culprit: Option<Culprit>,
    ) -> Point {
        let [x, y] = ends.map(|v| canvas.point(v));
        if let Some(culprit) = culprit.filter(|culprit| touches(canvas, [x, y], culprit)) {
            return point_between([x, y], foot([x, y], culprit.at));
        }
        let t = match (self.corner(canvas, ends, culprit), culprit) {
            (Some(corner), _) => on_shell([x, y], corner, culprit),
            (None, Some(culprit)) => beside([x, y], culprit),
            (None, None) => 0.5,
        };
        match t == 0.5 || !(0.25..=0.75).contains(&t) {
            true => Point::new(0.5 * x.x + 0.5 * y.x, 0.5 * x.y + 0.5 * y.y),
            false => point_between([x, y], t),
        }
    }

    /// Returns the acute corner on whose shells to split: of two the nearer one, and none that the line of
    /// the culprit does not have.
    fn corner(
        &self,
        canvas: &Canvas,
        ends: [VertexId; 2],
        culprit: Option<Culprit>,
    ) -> Option<Point> {
        let is_shared = |v: &VertexId| {
            let line = culprit.and_then(|culprit| culprit.line);
            line.is_none_or(|ends| ends.contains(v))
        };
        let acute = [0, 1].map(|i| Some(self.ends[i]).filter(|v| self.acute[i] && is_shared(v)));
        match acute.map(|v| v.map(|v| canvas.point(v))) {
            [Some(_), Some(_)] if culprit.is_none() && sorted(ends) == sorted(self.ends) => None,
            [Some(a), Some(b)] => {
                let [x, y] = ends.map(|v| canvas.point(v));
                let middle = Point::new(0.5 * x.x + 0.5 * y.x, 0.5 * x.y + 0.5 * y.y);
                let at = culprit.map_or(middle, |culprit| culprit.at);
                Some(if distance(at, a) < distance(at, b) {
                    a
                } else {
                    b
                })
            }
            [a, b] => a.or(b),
        }
    }
}

/// What a subsegment is to be split for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Culprit {
    pub at: Point,
    /// The ends of the line it is on, if it was added there.
    pub line: Option<[VertexId; 2]>,
    pub nature: Nature,
}

/// What kind of place the culprit is at.
#[derive(Clone, Copy, Debug)]
pub(super) enum Nature {
    /// A vertex that is too close: at distance d beside the middle of a subsegment it encroaches upon
    /// what is longer than `reach` times d.
    Vertex { reach: f64 },
    /// The middle of a subsegment on the other side of a channel.
    Middle,
}

/// Tells whether there is no room for a vertex between a subsegment and the culprit beside it. A vertex where
/// they come nearest makes the gap an edge, the shortest one for the triangles on both of its sides, and
/// coordinates have nothing better to offer; anywhere else it would only make one more such gap.
fn touches(canvas: &Canvas, [x, y]: [Point; 2], culprit: &Culprit) -> bool {
    let [ux, uy] = [y.x - x.x, y.y - x.y];
    let [vx, vy] = [culprit.at.x - x.x, culprit.at.y - x.y];
    let height = (ux * vy - uy * vx).abs() / (ux * ux + uy * uy).sqrt();
    let t = foot([x, y], culprit.at);
    let is_vertex = matches!(culprit.nature, Nature::Vertex { .. });
    is_vertex && 0.0 < t && t < 1.0 && height < canvas.closest(culprit.at)
}

/// Returns the share of the way from `x` to `y` at which that comes nearest to `p`.
fn foot([x, y]: [Point; 2], p: Point) -> f64 {
    let [ux, uy] = [y.x - x.x, y.y - x.y];
    let [vx, vy] = [p.x - x.x, p.y - x.y];
    (ux * vx + uy * vy) / (ux * ux + uy * uy)
}

/// Returns where to split a subsegment so that the vertex lies as far from an acute corner as the culprit,
/// if that is well inside; else as roundly as possible.
fn on_shell([x, y]: [Point; 2], corner: Point, culprit: Option<Culprit>) -> f64 {
    let [r, s] = [x, y].map(|p| distance(p, corner));
    let vertex = culprit.filter(|culprit| matches!(culprit.nature, Nature::Vertex { .. }));
    let at = vertex.map(|culprit| (distance(culprit.at, corner) - r) / (s - r));
    at.filter(|t| (0.25..=0.75).contains(t)).unwrap_or_else(|| {
        let [low, high] = [r.min(s), r.max(s)];
        let third = (high - low) / 3.0;
        (roundest(low + third, high - third) - r) / (s - r)
    })
}

/// Returns where to split a subsegment beside which a line might run along, at the distance of the culprit.
///
/// Opposite the middle of a subsegment beyond a channel, where vertices on both sides then take turns.
/// Opposite a vertex, halving it again and again would end anywhere between the length that the other line permits and half
/// of it. So it is cut where one of as many equal pieces as are needed ends: they all have nearly that
/// length, and are a quarter fewer.
fn beside([x, y]: [Point; 2], culprit: Culprit) -> f64 {
    let [ux, uy] = [y.x - x.x, y.y - x.y];
    let [vx, vy] = [culprit.at.x - x.x, culprit.at.y - x.y];
    let squared = ux * ux + uy * uy;
    let Nature::Vertex { reach } = culprit.nature else {
        return foot([x, y], culprit.at).clamp(0.25, 0.75);
    };
    // How many pieces of the length that the other line permits there is room for, and how many of them
    // lie between the middle and halfway between two vertices beyond.
    let room = squared / (reach * (ux * vy - uy * vx).abs());
    if !(1.0..1e9).contains(&room) {
        return 0.5;
    }
    let t = foot([x, y], culprit.at);
    let steps = ((0.5 - t) * room - 0.5).round() + 0.5;
    (t + steps / room).clamp(0.25, 0.75)
}

/// Returns the number between two positive ones that has the fewest binary digits.
fn roundest(low: f64, high: f64) -> f64 {
    if !(low > 0.0 && low <= high && high.is_finite()) {
        return high;
    }
    // The largest power of two that is not above.
    let mut step = f64::from_bits(high.to_bits() & 0xfff0_0000_0000_0000);
    loop {
        let candidate = (high / step).floor() * step;
        if candidate >= low || step == 0.0 {
            return candidate;
        }
        step *= 0.5;
    }
}

pub(super) fn sorted([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}

pub(super) fn distance(a: Point, b: Point) -> f64 {
    let [x, y] = [b.x - a.x, b.y - a.y];
    (x * x + y * y).sqrt()
}

/// Tells whether the angle at a corner, between the directions to two points, is below 60 degrees.
fn is_sharp(corner: Point, [a, b]: [Point; 2]) -> bool {
    let [ux, uy] = [a.x - corner.x, a.y - corner.y];
    let [vx, vy] = [b.x - corner.x, b.y - corner.y];
    let dot = ux * vx + uy * vy;
    // The cosine of 60 degrees is one half. A little more counts, too: it does no harm.
    dot > 0.0 && 4.0 * dot * dot > 0.999 * (ux * ux + uy * uy) * (vx * vx + vy * vy)
}

/// Tells whether at the origin of the constrained half-edge `h` another line is less than 60 degrees away,
/// with the domain between.
fn is_acute(canvas: &Canvas, h: HalfEdgeId) -> bool {
    let [corner, end] = canvas.ends(h).map(|v| canvas.point(v));
    let is_near = |g: HalfEdgeId| {
        let other = canvas.point(canvas.mesh.dest(g));
        is_sharp(corner, [end, other])
    };
    // Counter-clockwise, the wedges lie in the faces of the half-edges; clockwise in those of the twins.
    let mut g = h;
    while !canvas.is_outside(g) {
        g = canvas.mesh.onext(g);
        if canvas.is_constrained(g) {
            if g != h && is_near(g) {
                return true;
            }
            break;
        }
    }
    let mut g = h;
    while !canvas.is_outside(canvas.mesh.twin(g)) {
        g = canvas.mesh.oprev(g);
        if canvas.is_constrained(g) {
            return g != h && is_near(g);
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::roundest;

    #[test]
    fn round_numbers_have_few_digits() {
        assert_eq!(roundest(1.0 / 3.0, 2.0 / 3.0), 0.5);
        assert_eq!(roundest(1.23, 1.47), 1.25);
        assert_eq!(roundest(5.1, 5.3), 5.25);
        assert_eq!(roundest(1e-300, 1e300), 2f64.powi(996));
        assert_eq!(roundest(3.0, 3.0), 3.0);
    }
}
