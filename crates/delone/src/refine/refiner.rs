//! The loop: take the worst element, propose a point, ask what it conflicts with; then insert it, split
//! the segment that is in its way, or leave the element alone.

use super::Locked;
use super::bounds::{Bounds, Shape};
use super::candidates::{Candidates, circumcenter};
use super::canvas::{Canvas, Traits};
use super::cavity::Cavity;
use super::lines::{Culprit, Lines, Nature, distance};
use super::patch::Patch;
use super::queue::Queue;
use crate::predicates::{Orientation, in_circle_perturbed, is_between, orient2d};
use crate::{HalfEdgeId, Point, TriangleId, VertexId};
use std::collections::VecDeque;

/// The same if segments must not be split: then vertices have to crowd before long ones.
const GRADATION_LOCKED: f64 = 1.0 / 256.0;

/// A cavity of more faces than this is the end of a fan: so many triangles from a far vertex to a row of
/// near ones.
const FAN: usize = 48;

/// Vertices that are to improve angles keep at least this part of the local feature size away from all
/// others.
const GRADATION: f64 = 1.0 / 16.0;

/// Triangles whose shortest edge is below so many times the distance that vertices keep are left alone:
/// coordinates have no room to make them better. 2¹² units in the last place.
const LEAST: f64 = 4.0;

/// Two ends are as far from a corner as each other if their distances differ by less than this part.
const EQUALLY_FAR: f64 = 1.0 / (1 << 20) as f64;

/// A refinement under way.
pub(super) struct Refiner<'a> {
    pub canvas: Canvas,
    pub lines: Lines,
    pub bounds: Bounds<'a>,
    locked: Locked,
    candidates: Candidates,
    /// For each vertex the feature size of where its ancestors come from.
    base: Vec<f64>,
    encroached: VecDeque<Encroached>,
    oversized: Queue,
    skinny: Queue,
    /// The cavity of the best candidate so far, and of the one that is looked at.
    best: Cavity,
    spare: Cavity,
    /// Whether vertices that were there at the beginning are of a lattice.
    pub sown: Vec<bool>,
    is_sown: bool,
    pub(super) patch: Patch,
}

/// A subsegment that has to be split.
#[derive(Clone, Copy, Debug)]
struct Encroached {
    half_edge: HalfEdgeId,
    ends: [VertexId; 2],
}

/// What came of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// A vertex was added.
    Added,
    /// An element was left as it is, or had vanished.
    Passed,
    /// Nothing is left to do.
    Finished,
}

/// What a candidate would do.
#[derive(Clone, Copy, Debug)]
enum Verdict {
    /// Make so many more skinny triangles than it destroys, and come so close to others (squared).
    Fine { gain: i32, spacing: f64 },
    /// Encroach upon the subsegment, or lie behind it; perhaps upon another, too. Half-edges in the faces
    /// beyond.
    Blocked(HalfEdgeId, Option<HalfEdgeId>),
    /// Come too close to other vertices, or lie nowhere.
    Cramped,
}

/// Why a vertex is to be added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Motive {
    Size,
    Angle {
        /// Whether another triangle may be opened instead, amid a fan.
        may_divide: bool,
    },
}

impl<'a> Refiner<'a> {
    pub fn new(canvas: Canvas, sown: Vec<bool>, bounds: Bounds<'a>, locked: Locked) -> Self {
        let base = feature_sizes(&canvas);
        let mut refiner = Self {
            candidates: Candidates::new(bounds.min_angle),
            lines: Lines::new(canvas.points.len()),
            canvas,
            bounds,
            locked,
            base,
            encroached: VecDeque::new(),
            oversized: Queue::new(),
            skinny: Queue::new(),
            best: Cavity::default(),
            spare: Cavity::default(),
            is_sown: sown.contains(&true),
            sown,
            patch: Patch::default(),
        };
        let faces = (0..refiner.canvas.mesh.num_faces()).map(TriangleId::new);
        for t in faces {
            if !refiner.canvas.traits(t).is_outside() {
                refiner.examine(t, true);
            }
        }
        refiner
    }

    pub fn num_vertices(&self) -> usize {
        self.canvas.points.len()
    }

    /// Tells whether nothing waits any more.
    pub fn is_finished(&self) -> bool {
        self.encroached.is_empty() && self.oversized.len() == 0 && self.skinny.len() == 0
    }

    /// Estimates how many vertices are still to come.
    pub fn backlog(&self) -> usize {
        self.encroached.len() + self.oversized.len() + self.skinny.len() / 2
    }

    /// Treats one element.
    #[inline]
    pub fn step(&mut self) -> Step {
        if let Some(subsegment) = self.encroached.pop_front() {
            return self.relieve(subsegment);
        }
        if let Some((t, corners)) = self.oversized.pop() {
            return self.shrink(t, corners);
        }
        if let Some((t, corners)) = self.skinny.pop() {
            return self.improve(t, corners);
        }
        Step::Finished
    }

    /// Looks at a new triangle of the domain, and lets it queue up if it is bad. `watches` says whether
    /// its edges may be encroached upon.
    #[inline]
    fn examine(&mut self, t: TriangleId, watches: bool) {
        let corners = self.canvas.mesh.corners(t);
        let points = corners.map(|v| self.canvas.point(v));
        let traits = self.canvas.traits(t);
        if watches && traits.has_constraint() {
            self.watch_edges(t, points, traits);
        }
        let shape = Shape::of(points);
        if self.bounds.has_sizes() {
            let oversize = self.bounds.oversize(points, &shape, self.canvas.region(t));
            if oversize > 1.0 {
                self.oversized.push(1.0 / oversize, t, corners);
            }
        }
        if self.bounds.is_skinny(shape.squares, shape.cross) {
            self.canvas.set_skinny(t, true);
            self.skinny.push(shape.shortest().1, t, corners);
        }
    }

    #[cold]
    fn watch_edges(&mut self, t: TriangleId, points: [Point; 3], traits: Traits) {
        for h in t.half_edges() {
            let k = h.slot();
            let ends = [points[(k + 1) % 3], points[(k + 2) % 3]];
            if traits.is_constrained(k) && self.bounds.encroaches(ends, points[k]) {
                let ends = self.canvas.ends(h);
                self.encroached.push_back(Encroached { half_edge: h, ends });
            }
        }
    }

    /// Splits an encroached subsegment, unless it has vanished.
    fn relieve(&mut self, Encroached { half_edge: h, ends }: Encroached) -> Step {
        if self.canvas.ends(h) != ends || !self.canvas.is_constrained(h) {
            return Step::Passed;
        }
        let apex = self.canvas.mesh.apex(h);
        let points = ends.map(|v| self.canvas.point(v));
        if self.canvas.is_outside(h) || !self.bounds.encroaches(points, self.canvas.point(apex)) {
            return Step::Passed;
        }
        let is_forced = match self.lines.of_vertex(apex) {
            // A vertex of the input, or of a line that is no neighbour.
            None => self.lines.is_old(apex),
            Some(of_apex) => {
                let line = self.lines.ends_of(ends);
                let other = self.lines.get(of_apex).ends;
                !line.iter().any(|v| other.contains(v))
            }
        };
        let base = (!is_forced).then(|| self.base[apex.index()]);
        let is_free = !self.lines.is_old(apex) && self.lines.of_vertex(apex).is_none();
        let floor = match is_free {
            true => self.gradation() * self.base[apex.index()],
            false => 0.0,
        };
        let culprit = (!is_free).then(|| self.culprit(apex));
        self.split(h, base, floor, culprit)
    }

    /// Splits the subsegment of `h`; the new vertex inherits `base`, or takes its distance from others, and
    /// keeps `floor` away from them. If a vertex is too close to it, that is the `culprit`.
    fn split(
        &mut self,
        h: HalfEdgeId,
        base: Option<f64>,
        floor: f64,
        culprit: Option<Culprit>,
    ) -> Step {
        if self.is_locked(h) {
            return Step::Passed;
        }
        let ends = self.canvas.ends(h);
        let line = self.lines.of_subsegment(&self.canvas, h);
        let p = line.split_point(&self.canvas, ends, culprit);
        let Some((p, site)) = self.site_near(h, p) else {
            return Step::Passed;
        };
        let spacing = ends.map(|v| distance(self.canvas.point(v), p));
        let spacing = spacing[0].min(spacing[1]);
        if spacing < self.canvas.closest(p).max(floor) || !spacing.is_finite() {
            return Step::Passed;
        }
        let v = self.push_vertex(p, base.unwrap_or(spacing));
        self.lines.push_between(line, ends);
        self.split_at(site, v);
        if base.is_none() {
            self.base[v.index()] = self.clearance(p).min(spacing);
        }
        Step::Added
    }

    /// Describes a vertex that is too close to a subsegment.
    fn culprit(&self, v: VertexId) -> Culprit {
        Culprit {
            at: self.canvas.point(v),
            line: self
                .lines
                .of_vertex(v)
                .map(|line| self.lines.get(line).ends),
            nature: Nature::Vertex {
                reach: 0.98 * self.bounds.reach(),
            },
        }
    }

    /// Describes the subsegment of `h`, which is in the way as another is.
    fn culprit_opposite(&self, h: HalfEdgeId) -> Culprit {
        let ends = self.canvas.ends(h);
        let [a, b] = ends.map(|v| self.canvas.point(v));
        Culprit {
            at: Point::new(0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y),
            line: Some(self.lines.ends_of(ends)),
            nature: Nature::Middle,
        }
    }

    /// Returns how far `p`, which has just been inserted, is from the vertices around it in the domain.
    fn clearance(&self, p: Point) -> f64 {
        let inside = self.best.rim.iter().filter(|rim| !rim.traits.is_outside());
        let distances = inside.map(|rim| distance(self.canvas.point(rim.origin), p));
        distances.fold(f64::INFINITY, f64::min)
    }

    /// Finds out where near `p` a vertex may split the edge of `h`.
    fn site_near(&mut self, h: HalfEdgeId, p: Point) -> Option<(Point, Site)> {
        let up = |c: f64, i: i32| match i {
            0 => c,
            1 => c.next_up(),
            _ => c.next_down(),
        };
        let steps = [0, 1, -1];
        let places = steps.map(|i| steps.map(|j| Point::new(up(p.x, i), up(p.y, j))));
        let places = places.as_flattened().iter().map(|&p| self.canvas.placed(p));
        let places: [Point; 9] = places.collect::<Vec<_>>().try_into().expect("nine of them");
        let site = places.into_iter().find_map(|p| Some((p, self.site(h, p)?)));
        // Where faces on both sides are too thin to have places inside, beyond them will do.
        let mut others = places.into_iter();
        site.or_else(|| others.find_map(|p| self.sees_all(h, p).then_some((p, Site::On(h)))))
    }

    /// Tells whether `p` is in conflict with both faces of `h`, and sees the whole rim of the cavity.
    fn sees_all(&mut self, h: HalfEdgeId, p: Point) -> bool {
        let canvas = &self.canvas;
        let both = [h, canvas.mesh.twin(h)];
        if !both.iter().all(|h| canvas.conflicts(h.triangle(), p)) {
            return false;
        }
        self.spare.dig_both(canvas, h, p);
        let rim = &self.spare.rim;
        let ends = canvas.ends(h);
        let next = rim.iter().cycle().skip(1);
        let is_seen = rim.iter().zip(next).all(|(a, b)| {
            let [a, b] = [a.origin, b.origin];
            // Beyond the hull everything is in sight of what lies outside of it.
            a.is_infinite()
                || b.is_infinite()
                || orient2d(canvas.point(a), canvas.point(b), p) == Orientation::Left
        });
        is_seen && ends.iter().all(|&v| rim.iter().any(|rim| rim.origin == v))
    }

    /// Tells whether a vertex at `p` may split the edge of `h`: it must lie on it, or strictly inside one
    /// of the two faces.
    fn site(&self, h: HalfEdgeId, p: Point) -> Option<Site> {
        let mesh = &self.canvas.mesh;
        let [a, b] = self.canvas.ends(h).map(|v| self.canvas.point(v));
        let inside = |h: HalfEdgeId| {
            let [b, a] = [mesh.origin(h.next()), mesh.dest(h.prev())].map(|v| self.canvas.point(v));
            let apex = mesh.apex(h);
            if apex.is_infinite() {
                return true;
            }
            let c = self.canvas.point(apex);
            orient2d(b, c, p) == Orientation::Left && orient2d(c, a, p) == Orientation::Left
        };
        let g = mesh.twin(h);
        match orient2d(a, b, p) {
            Orientation::Collinear => is_between(a, b, p).then_some(Site::On(h)),
            Orientation::Left => inside(h).then_some(Site::Beside(h)),
            Orientation::Right => inside(g).then_some(Site::Beside(g)),
        }
    }

    /// Splits a subsegment at the new vertex `v`.
    fn split_at(&mut self, site: Site, v: VertexId) {
        let p = self.canvas.point(v);
        let mut cavity = std::mem::take(&mut self.best);
        let (Site::On(h) | Site::Beside(h)) = site;
        let g = self.canvas.mesh.twin(h);
        let [a, b] = self.canvas.ends(h);
        let is_sliver = match site {
            Site::On(_) => false,
            Site::Beside(_) => !self.canvas.conflicts(g.triangle(), p),
        };
        if is_sliver {
            // The face beyond stays, and between it and the vertex a sliver of its kind comes to be.
            cavity.dig(&self.canvas, h.triangle(), p);
            let beyond = self.canvas.traits(g.triangle()).0 & Traits::OUTSIDE;
            let region = self.canvas.region(g.triangle());
            let rim = cavity.rim.iter_mut().find(|rim| rim.outer == g);
            let rim = rim.expect("bug: a constrained edge bounds the cavity");
            rim.traits = Traits(beyond);
            rim.region = region;
            self.canvas.set_constrained(g, false);
        } else {
            cavity.dig_both(&self.canvas, h, p);
        }
        cavity.fill(&mut self.canvas, v);
        let n = cavity.rim.len();
        for i in 0..n {
            if cavity.rim[i].origin == a || cavity.rim[i].origin == b {
                let [_, _, outgoing] = cavity.faces[i].half_edges();
                let [_, incoming, _] =
                    cavity.faces[if i == 0 { n - 1 } else { i - 1 }].half_edges();
                self.canvas.set_constrained(outgoing, true);
                self.canvas.set_constrained(incoming, true);
            }
        }
        self.examine_all(&cavity);
        self.best = cavity;
    }

    /// Looks at the triangles that fill a cavity.
    fn examine_all(&mut self, cavity: &Cavity) {
        for &t in &cavity.faces {
            if !self.canvas.traits(t).is_outside() {
                self.examine(t, true);
            }
        }
    }

    /// Makes an oversized triangle smaller, unless it has vanished.
    fn shrink(&mut self, t: TriangleId, corners: [VertexId; 3]) -> Step {
        if self.canvas.mesh.corners(t) != corners {
            return Step::Passed;
        }
        let points = self.canvas.triangle(t);
        let shape = Shape::of(points);
        let [edge, area] = self.bounds.oversizes(points, &shape, self.canvas.region(t));
        if edge.max(area) <= 1.0 {
            return Step::Passed;
        }
        let longest = t.half_edges()[shape.longest().0];
        let step = if edge > 1.0 && self.canvas.is_constrained(longest) {
            self.split(longest, None, 0.0, None)
        } else {
            self.insert_best(t, &[circumcenter(points)], longest, Motive::Size)
        };
        if step == Step::Added {
            self.requeue(t, corners);
        }
        step
    }

    /// Looks at a triangle whose corners have changed or moved.
    pub(super) fn reexamine(&mut self, t: TriangleId) {
        self.canvas.set_skinny(t, false);
        if !self.canvas.traits(t).is_outside() {
            self.examine(t, true);
        }
    }

    /// Tells whether a vertex belongs to a lattice.
    pub(super) fn is_sown(&self, v: VertexId) -> bool {
        self.sown.get(v.index()) == Some(&true)
    }

    /// Returns the feature size of where the ancestors of a vertex come from.
    pub(super) fn base(&self, v: VertexId) -> f64 {
        self.base[v.index()]
    }

    /// Lets a triangle queue up again if it has survived.
    fn requeue(&mut self, t: TriangleId, corners: [VertexId; 3]) {
        if self.canvas.mesh.corners(t) == corners {
            self.examine(t, false);
        }
    }

    /// Makes a skinny triangle vanish, unless it has vanished or is left alone.
    fn improve(&mut self, t: TriangleId, corners: [VertexId; 3]) -> Step {
        if self.canvas.mesh.corners(t) != corners || !self.canvas.traits(t).is_skinny() {
            return Step::Passed;
        }
        if self.is_sown && self.relocate(t) {
            return Step::Passed;
        }
        let step = self.open(t, true);
        if self.canvas.mesh.corners(t) == corners {
            self.canvas.set_skinny(t, false);
            if step == Step::Added {
                self.examine(t, false);
            }
        }
        step
    }

    /// Opens up a skinny triangle, or one in the middle of the fan that it `may` be the end of: one after the
    /// other, each would tear up all that are left.
    fn open(&mut self, t: TriangleId, may_divide: bool) -> Step {
        self.canvas.set_skinny(t, false);
        let points = self.canvas.triangle(t);
        let shape = Shape::of(points);
        let (k, squared) = shape.shortest();
        let shortest = t.half_edges()[k];
        let least = LEAST * self.canvas.closest(points[0]);
        if self.is_given(shortest) || squared < least * least {
            return Step::Passed;
        }
        self.canvas.set_skinny(t, true);
        let ends = self.canvas.ends(shortest).map(|v| self.canvas.point(v));
        let candidates = self.candidates.of(ends, circumcenter(points));
        self.insert_best(t, &candidates, shortest, Motive::Angle { may_divide })
    }

    /// Returns a skinny triangle in the middle of the fan that the vertex judged last would tear up.
    fn middle_of_fan(&self) -> Option<TriangleId> {
        let faces = &self.spare.faces;
        let &middle = faces.get(faces.len() / 2).filter(|_| faces.len() > FAN)?;
        let is_other = middle != faces[0];
        (is_other && self.canvas.traits(middle).is_skinny()).then_some(middle)
    }

    /// Tells whether the small angle opposite `h` is one of the input, or unavoidable beside one: the
    /// shortest edge joins two lines that meet in it, or lies across them like a rung, equally far from
    /// their corner on both sides (Miller, Pav and Walkington 2003).
    fn is_given(&self, h: HalfEdgeId) -> bool {
        let canvas = &self.canvas;
        if canvas.is_constrained(h.next()) && canvas.is_constrained(h.prev()) {
            return true;
        }
        let [p, q] = canvas.ends(h);
        let (Some(l), Some(m)) = (self.lines.of_vertex(p), self.lines.of_vertex(q)) else {
            return false;
        };
        if l == m {
            return false;
        }
        let Some(corner) = self.lines.acute_corner(canvas, [l, m]) else {
            return false;
        };
        let [r, s] = [p, q].map(|v| distance(canvas.point(v), canvas.point(corner)));
        (r - s).abs() <= EQUALLY_FAR * r.max(s)
    }

    /// Inserts the best of several candidates for triangle `t`, or splits the subsegment that is in the
    /// way of the first that is blocked. The new vertex takes after the ends of `h`.
    fn insert_best(
        &mut self,
        t: TriangleId,
        candidates: &[Point],
        h: HalfEdgeId,
        motive: Motive,
    ) -> Step {
        let parents = self.canvas.ends(h);
        let base = parents.map(|v| self.base[v.index()]);
        let base = base[0].min(base[1]);
        let floor = match motive {
            Motive::Size => 0.0,
            Motive::Angle { .. } => self.gradation() * base,
        };
        let mut best: Option<(Point, i32, f64)> = None;
        let mut in_the_way = None;
        for (i, &candidate) in candidates.iter().enumerate() {
            let c = self.canvas.placed(candidate);
            let mut verdict = self.judge(t, c, floor);
            if motive == (Motive::Angle { may_divide: true })
                && let Some(middle) = self.middle_of_fan()
            {
                if self.open(middle, false) == Step::Added {
                    return Step::Added;
                }
                // Nothing has changed, but the cavities are others.
                verdict = self.judge(t, c, floor);
            }
            match verdict {
                Verdict::Fine { gain, spacing } => {
                    if best.is_none_or(|(_, g, s)| gain < g || gain == g && spacing > s) {
                        best = Some((c, gain, spacing));
                        std::mem::swap(&mut self.best, &mut self.spare);
                    }
                    // Which candidate is best matters little here, and looking at each takes long.
                    if self.best.faces.len() > FAN {
                        break;
                    }
                }
                Verdict::Blocked(outer, other) => {
                    in_the_way.get_or_insert((outer, other));
                    // Others may fit in, but too close to a segment: vertices would crowd there.
                    if i == 0 {
                        break;
                    }
                }
                Verdict::Cramped => {}
            }
        }
        if let Some((c, _, spacing)) = best {
            let base = match motive {
                // Sizes set a scale of their own.
                Motive::Size => base.min(spacing.sqrt()),
                Motive::Angle { .. } => base,
            };
            let v = self.push_vertex(c, base);
            self.lines.push_free();
            let mut cavity = std::mem::take(&mut self.best);
            cavity.fill(&mut self.canvas, v);
            self.examine_all(&cavity);
            self.best = cavity;
            return Step::Added;
        }
        match in_the_way {
            Some((outer, other)) => {
                let h = self.canvas.mesh.twin(outer);
                let culprit = other.map(|other| self.culprit_opposite(other));
                let base = Some(base).filter(|_| motive != Motive::Size);
                self.split(h, base, floor, culprit)
            }
            None => Step::Passed,
        }
    }

    /// Finds out what a vertex at `c` would do to triangle `t` and those around it.
    fn judge(&mut self, t: TriangleId, c: Point, floor: f64) -> Verdict {
        if !(c.x.is_finite() && c.y.is_finite()) {
            return Verdict::Cramped;
        }
        let [p, q, r] = self.canvas.triangle(t);
        if !in_circle_perturbed(p, q, r, c) {
            return Verdict::Cramped;
        }
        let mut cavity = std::mem::take(&mut self.spare);
        cavity.dig(&self.canvas, t, c);
        let verdict = self.survey(&cavity, c, floor);
        self.spare = cavity;
        verdict
    }

    /// Walks around the cavity of `c`.
    #[inline]
    fn survey(&self, cavity: &Cavity, c: Point, floor: f64) -> Verdict {
        let mut gain = -cavity.skinny;
        let mut spacing = f64::INFINITY;
        let mut blocked: Option<(bool, HalfEdgeId)> = None;
        let mut also = None;
        let mut is_hidden = false;
        let mut edge = cavity.rim.last().expect("bug: a cavity has a rim");
        for next in &cavity.rim {
            let (a, b, cross) = (edge.from, next.from, edge.cross);
            let [al, bl] = [a.square, b.square];
            let ends = || [edge.origin, next.origin].map(|v| self.canvas.point(v));
            if cross <= 4.0 * f64::EPSILON * (al + bl) && !is_left(ends(), c) {
                is_hidden = true;
                if edge.is_constrained()
                    && blocked.is_none_or(|(is_behind, _)| !is_behind)
                    && !self.is_locked(edge.outer)
                {
                    blocked = Some((true, edge.outer));
                }
            } else if edge.is_constrained()
                && self.bounds.encroaches(ends(), c)
                && !self.is_locked(edge.outer)
            {
                match blocked {
                    None => blocked = Some((false, edge.outer)),
                    Some(_) => also = Some(edge.outer),
                }
            }
            let [ex, ey] = [b.x - a.x, b.y - a.y];
            gain += i32::from(self.bounds.is_skinny([al, bl, ex * ex + ey * ey], cross));
            spacing = if bl < spacing { bl } else { spacing };
            edge = next;
        }
        if let Some((is_behind, outer)) = blocked {
            return Verdict::Blocked(outer, also.filter(|_| !is_behind));
        }
        let floor = floor.max(self.canvas.closest(c));
        // Written so that NaN is refused.
        match spacing >= floor * floor && spacing.is_finite() && !is_hidden {
            true => Verdict::Fine { gain, spacing },
            false => Verdict::Cramped,
        }
    }

    /// Returns which part of the feature size vertices keep away from others.
    pub(super) fn gradation(&self) -> f64 {
        match self.locked {
            Locked::Nothing => GRADATION,
            _ => GRADATION_LOCKED,
        }
    }

    /// Tells whether the subsegment of `h` must not be split.
    fn is_locked(&self, h: HalfEdgeId) -> bool {
        match self.locked {
            Locked::Nothing => false,
            Locked::Boundary => {
                self.canvas.is_outside(h) != self.canvas.is_outside(self.canvas.mesh.twin(h))
            }
            Locked::Segments => true,
        }
    }

    fn push_vertex(&mut self, p: Point, base: f64) -> VertexId {
        let v = VertexId::new(self.canvas.points.len());
        self.canvas.points.push(p);
        self.base.push(base);
        v
    }
}

/// Tells whether `p` lies strictly to the left of the edge from `a` to `b`.
fn is_left([a, b]: [Point; 2], p: Point) -> bool {
    orient2d(a, b, p) == Orientation::Left
}

/// Where a vertex may split an edge.
#[derive(Clone, Copy, Debug)]
enum Site {
    /// On the edge of the half-edge.
    On(HalfEdgeId),
    /// Inside the face of the half-edge.
    Beside(HalfEdgeId),
}

/// Estimates the local feature size at each vertex: its distance from the nearest vertex or subsegment that
/// it sees in the domain and does not belong to.
fn feature_sizes(canvas: &Canvas) -> Vec<f64> {
    let mut squares = vec![f64::INFINITY; canvas.points.len()];
    for (t, corners) in canvas.mesh.faces().iter().enumerate() {
        let t = TriangleId::new(t);
        let traits = canvas.traits(t);
        if traits.is_outside() {
            continue;
        }
        let shape = Shape::of(canvas.triangle(t));
        for k in 0..3 {
            let [next, previous] = [(k + 1) % 3, (k + 2) % 3];
            let mut least = shape.squares[next].min(shape.squares[previous]);
            if traits.is_constrained(k) {
                // If the foot of the height lies outside, the nearest point is an end.
                let [long, short] = [shape.squares[next], shape.squares[previous]];
                let base = shape.squares[k];
                if (long - short).abs() <= base {
                    least = least.min(shape.cross * shape.cross / base);
                }
            }
            let of_vertex = &mut squares[corners[k].index()];
            *of_vertex = of_vertex.min(least);
        }
    }
    squares.into_iter().map(f64::sqrt).collect()
}
