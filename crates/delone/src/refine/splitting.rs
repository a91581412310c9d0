//! Splitting subsegments: where the new vertex goes, what inherits from whom, and how the faces on both sides
//! give way.
//!
//! A place on a segment has to be rounded, so it lies upon the subsegment, strictly inside one of the two faces
//! beside it, or, where these are too thin to have places inside, beyond them.

use super::canvas::Traits;
use super::code;
use super::lines::{Culprit, Nature, distance};
use super::refiner::{Encroached, Refiner, Step};
use crate::predicates::{Orientation, is_between, orient2d};
use crate::{Event, HalfEdgeId, Observer, Point, VertexId};

/// Where a vertex may split an edge.
#[derive(Clone, Copy, Debug)]
enum Site {
    /// On the edge of the half-edge.
    On(HalfEdgeId),
    /// Inside the face of the half-edge.
    Beside(HalfEdgeId),
}

impl<O: Observer> Refiner<'_, O> {
    /// Splits an encroached subsegment, unless it has vanished.
    pub(super) fn relieve(&mut self, Encroached { half_edge: h, ends }: Encroached) -> Step {
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
        self.teller
            .because(code::ENCROACHED, |teller| Event::Encroached {
                segment: teller.names(ends),
                by: teller.names([apex])[0],
            });
        let step = self.split(h, base, floor, culprit);
        self.teller.forget();
        step
    }

    /// Splits the subsegment of `h`; the new vertex inherits `base`, or takes its distance from others, and
    /// keeps `floor` away from them. If a vertex is too close to it, that is the `culprit`.
    pub(super) fn split(
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
        let vertex = VertexId::new(self.num_vertices());
        self.teller
            .because(code::SPLIT, |teller| Event::SegmentSplit {
                edge: teller.names(ends),
                vertex,
            });
        let v = self.push_vertex(p, base.unwrap_or(spacing), code::SPLIT);
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
    pub(super) fn culprit_opposite(&self, h: HalfEdgeId) -> Culprit {
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
        let before = self.teller.before(&self.canvas, &cavity.faces);
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
        self.teller.after(before, &self.canvas, &cavity.faces);
        self.examine_all(&cavity);
        self.best = cavity;
    }
}
