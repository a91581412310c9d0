//! What comes after the sweep: helpers and triangles that go, and segments that are missing.

use super::{Replay, edges};
use crate::Failure;
use crate::classic::inside::{centroid, crosses};
use crate::classic::sides;
use crate::predicates::Orientation;
use crate::{Error, Event, Observer, Stage, VertexId};
use std::collections::BTreeSet;

impl<O: Observer> Replay<'_, O> {
    /// Deletes the helpers and all that hangs on them; the hull is left dented.
    pub(super) fn strip(&mut self) {
        self.board.at(10);
        let helpers = std::mem::take(&mut self.helpers);
        let touches = |corners: &[VertexId]| corners.iter().any(|v| helpers.contains(v));
        let all = std::mem::take(&mut self.triangles);
        let (gone, kept) = all.into_iter().partition(|t| touches(t));
        self.triangles = kept;
        self.tell_deleted(gone);
        self.hide(|edge| touches(edge));
        helpers.iter().for_each(|_| self.board.delete_last_vertex());
        self.board.end(Stage::StripHelpers);
    }

    /// Turns triangles that are clockwise, and leaves those out that then lie upon others.
    pub(super) fn turn(&mut self) {
        self.board.at(11);
        let mut taken: BTreeSet<_> = self.triangles.iter().flat_map(|&t| sides(t)).collect();
        for triangle @ [a, b, c] in std::mem::take(&mut self.triangles) {
            if self.board.orient(a, b, c) != Orientation::Right {
                self.triangles.push(triangle);
                continue;
            }
            self.tell_deleted(vec![triangle]);
            let turned = [a, c, b];
            for side in sides(triangle) {
                taken.remove(&side);
            }
            if sides(turned).iter().any(|side| taken.contains(side)) {
                self.fail(Failure::Overlaps(triangle));
            } else {
                taken.extend(sides(turned));
                self.board
                    .tell(|| Event::TriangleCreated { triangle: turned });
                self.triangles.push(turned);
            }
        }
    }

    /// Says which segments are sides of no triangle.
    pub(super) fn look_for_segments(&mut self) {
        let edges_left: BTreeSet<_> = self.triangles.iter().flat_map(|&t| edges(t)).collect();
        for segment in self
            .segments
            .difference(&edges_left)
            .copied()
            .collect::<Vec<_>>()
        {
            self.fail(Failure::SegmentLost(segment));
        }
    }

    /// Deletes the triangles outside of the rings, and the edges that are sides of none any more.
    pub(super) fn remove_outside(&mut self) -> Result<(), Error> {
        let (mut kept, mut gone) = (Vec::new(), Vec::new());
        for t in std::mem::take(&mut self.triangles) {
            self.board.spend(self.segments.len())?;
            let of_its_kind = if self.is_inside(t) {
                &mut kept
            } else {
                &mut gone
            };
            of_its_kind.push(t);
        }
        self.board.at(14);
        self.triangles = kept;
        self.tell_deleted(gone);
        let edges_left: BTreeSet<_> = self.triangles.iter().flat_map(|&t| edges(t)).collect();
        let segments = std::mem::take(&mut self.segments);
        self.hide(|edge| !edges_left.contains(edge) && !segments.contains(edge));
        self.segments = segments;
        self.board.end(Stage::InsideTest);
        Ok(())
    }

    /// Counts the segments that the ray from the centroid of a triangle to the right crosses: odd is inside.
    fn is_inside(&mut self, triangle: [VertexId; 3]) -> bool {
        self.board.at(13);
        let center = centroid(triangle.map(|v| self.board.point(v)));
        let ends = self.segments.iter();
        let ends = ends.map(|edge| edge.map(|v| self.board.point(v)));
        let crossings = ends.filter(|&ends| crosses(center, ends)).count() as u32;
        let is_inside = crossings % 2 == 1;
        self.board.tell(|| Event::InsideTested {
            triangle,
            crossings,
            is_inside,
        });
        is_inside
    }

    fn tell_deleted(&mut self, triangles: Vec<[VertexId; 3]>) {
        for triangle in triangles {
            self.board.tell(|| Event::TriangleDeleted { triangle });
        }
    }

    /// Shows some edges no longer.
    fn hide(&mut self, is_gone: impl Fn(&[VertexId; 2]) -> bool) {
        for edge in std::mem::take(&mut self.shown) {
            if is_gone(&edge) {
                self.board.tell(|| Event::EdgeDeleted { edge });
            } else {
                self.shown.insert(edge);
            }
        }
    }
}
