//! Making bad triangles vanish: candidates for a vertex are judged by the cavities that they would dig, and the
//! best is inserted, or the subsegment that is in the way is split.

use super::bounds::Shape;
use super::candidates::circumcenter;
use super::cavity::Cavity;
use super::code;
use super::lines::distance;
use super::refiner::{Refiner, Step};
use crate::predicates::{Orientation, in_circle_perturbed, orient2d};
use crate::{Event, HalfEdgeId, Observer, Point, TriangleId, VertexId};

/// A cavity of more faces than this is the end of a fan: so many triangles from a far vertex to a row of
/// near ones.
const FAN: usize = 48;

/// Triangles whose shortest edge is below so many times the distance that vertices keep are left alone:
/// coordinates have no room to make them better. 2¹² units in the last place.
const LEAST: f64 = 4.0;

/// Two ends are as far from a corner as each other if their distances differ by less than this part.
const EQUALLY_FAR: f64 = 1.0 / (1 << 20) as f64;

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

impl<O: Observer> Refiner<'_, O> {
    /// Makes an oversized triangle smaller, unless it has vanished.
    pub(super) fn shrink(&mut self, t: TriangleId, corners: [VertexId; 3]) -> Step {
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
        let is_long = edge > 1.0 && self.canvas.is_constrained(longest);
        let line = if is_long { code::LONG } else { code::LARGE };
        self.teller
            .because(line, |teller| Event::TriangleConsidered {
                triangle: teller.names(corners),
            });
        let step = if is_long {
            self.teller.at(code::LONG);
            self.split(longest, None, 0.0, None)
        } else {
            self.insert_best(t, &[circumcenter(points)], longest, Motive::Size)
        };
        match step {
            Step::Added => self.requeue(t, corners),
            _ => self.teller.tell_left(corners),
        }
        step
    }

    /// Makes a skinny triangle vanish, unless it has vanished or is left alone.
    pub(super) fn improve(&mut self, t: TriangleId, corners: [VertexId; 3]) -> Step {
        if self.canvas.mesh.corners(t) != corners || !self.canvas.traits(t).is_skinny() {
            return Step::Passed;
        }
        if self.has_lattice && self.relocate(t) {
            return Step::Passed;
        }
        let step = self.open(t, true);
        if step != Step::Added {
            self.teller.tell_left(corners);
        }
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
            self.teller.at(code::GIVEN);
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
                    in_the_way.get_or_insert((outer, other, c));
                    // Others may fit in, but too close to a segment: vertices would crowd there.
                    if i == 0 {
                        break;
                    }
                }
                Verdict::Cramped => {}
            }
        }
        if let Some((c, _, spacing)) = best {
            self.tell_proposal(t, c, motive);
            let base = match motive {
                // Sizes set a scale of their own.
                Motive::Size => base.min(spacing.sqrt()),
                Motive::Angle { .. } => base,
            };
            let v = self.push_vertex(c, base, code::INSERT);
            self.lines.push_free();
            let mut cavity = std::mem::take(&mut self.best);
            let before = self.teller.before(&self.canvas, &cavity.faces);
            cavity.fill(&mut self.canvas, v);
            self.teller.after(before, &self.canvas, &cavity.faces);
            self.examine_all(&cavity);
            self.best = cavity;
            return Step::Added;
        }
        self.teller.at(code::REJECT);
        match in_the_way {
            Some((outer, other, c)) => {
                let h = self.canvas.mesh.twin(outer);
                self.tell_proposal(t, c, motive);
                self.tell_rejection(t, h);
                let culprit = other.map(|other| self.culprit_opposite(other));
                let base = Some(base).filter(|_| motive != Motive::Size);
                let step = self.split(h, base, floor, culprit);
                self.teller.forget();
                step
            }
            None => Step::Passed,
        }
    }

    /// Says that a vertex at `c` is to make triangle `t` vanish.
    #[inline]
    fn tell_proposal(&mut self, t: TriangleId, c: Point, motive: Motive) {
        let line = match motive {
            Motive::Size => code::LARGE,
            Motive::Angle { .. } => code::SKINNY,
        };
        let corners = self.canvas.mesh.corners(t);
        self.teller
            .because(line, |teller| Event::CircumcenterProposed {
                triangle: teller.names(corners),
                at: teller.unscaled(c),
            });
    }

    /// Says that instead the subsegment of `h` is to be split.
    #[inline]
    fn tell_rejection(&mut self, t: TriangleId, h: HalfEdgeId) {
        let (corners, ends) = (self.canvas.mesh.corners(t), self.canvas.ends(h));
        self.teller
            .because(code::REJECT, |teller| Event::CircumcenterRejected {
                triangle: teller.names(corners),
                edge: teller.names(ends),
            });
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
}

/// Tells whether `p` lies strictly to the left of the edge from `a` to `b`.
fn is_left([a, b]: [Point; 2], p: Point) -> bool {
    orient2d(a, b, p) == Orientation::Left
}
