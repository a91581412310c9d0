//! What an observer hears of edits: which triangles and edges have gone and come, and who holds which datum now.

use super::Field;
use crate::observe::{ascending, sides, smallest_first};
use crate::{Event, Observer, Point, VertexId};
use std::collections::{BTreeMap, BTreeSet};

/// What an observer has been told. Empty if nobody listens.
#[derive(Default)]
pub(super) struct Told {
    triangles: BTreeSet<[VertexId; 3]>,
    edges: BTreeSet<[VertexId; 2]>,
    /// By the name of the datum.
    holders: BTreeMap<VertexId, [VertexId; 3]>,
}

impl<O: Observer> Field<'_, O> {
    /// Tells of what has changed.
    ///
    /// *Cost*: linear in triangles and data, if anybody listens.
    pub(super) fn tell_changes(&mut self) {
        if !self.observer.is_watching() {
            return;
        }
        let now = self.present();
        let before = std::mem::take(&mut self.told);
        for &triangle in before.triangles.difference(&now.triangles) {
            self.tell(|| Event::TriangleDeleted { triangle });
        }
        for &edge in before.edges.difference(&now.edges) {
            self.tell(|| Event::EdgeDeleted { edge });
        }
        for &edge in now.edges.difference(&before.edges) {
            self.tell(|| Event::EdgeCreated { edge });
        }
        for &triangle in now.triangles.difference(&before.triangles) {
            self.tell(|| Event::TriangleCreated { triangle });
        }
        for &name in &self.data.names {
            let [from, to] = [&before, &now].map(|told| told.holders.get(&name).copied());
            if from != to {
                self.tell(|| Event::DatumReassigned {
                    datum: name,
                    from,
                    to,
                });
            }
        }
        self.told = now;
    }

    /// Tells of a flip.
    pub(super) fn tell_flip(&mut self, from: [VertexId; 2], to: [VertexId; 2]) {
        if !self.observer.is_watching() {
            return;
        }
        let [from, to] = [from, to].map(|edge| edge.map(|v| self.name(v)));
        self.tell(|| Event::EdgeFlipped { from, to });
        let now = self.present();
        (self.told.triangles, self.told.edges) = (now.triangles, now.edges);
        self.tell_changes();
    }

    /// Takes back all that was told of vertices and what hangs on them.
    pub(super) fn tell_end(&mut self) {
        self.draft.mesh.clear();
        self.stock = Default::default();
        self.tell_changes();
        let vertices: Vec<Point> = std::mem::take(&mut self.draft.points);
        for (v, at) in vertices.into_iter().enumerate().rev() {
            let vertex = self.name(VertexId::new(v));
            self.tell(|| Event::VertexDeleted { vertex, at });
        }
    }

    /// Tells of all vertices and what hangs on them.
    pub(super) fn tell_begin(&mut self) {
        for v in 0..self.draft.points.len() {
            let (vertex, at) = (self.name(VertexId::new(v)), self.draft.points[v]);
            self.tell(|| Event::VertexCreated { vertex, at });
        }
        self.tell_changes();
    }

    /// All that there is.
    fn present(&self) -> Told {
        let mut present = Told::default();
        for t in self.draft.mesh.triangles() {
            let triangle = smallest_first(self.names(t));
            present.edges.extend(sides(triangle).map(ascending));
            for held in self.stock.held(t) {
                present
                    .holders
                    .insert(self.data.names[held.datum()], triangle);
            }
            present.triangles.insert(triangle);
        }
        present
    }
}
