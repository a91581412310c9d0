//! Which triangle holds which data.

use crate::TriangleId;
use crate::mesh::Moved;

/// A datum that a triangle holds, and whether it may lie on the triangle's boundary, so that another could hold it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Held(u32);

/// The bit of data that may lie on a boundary. Ids of points take at most 30 bits.
const BORDER: u32 = 1 << 31;

impl Held {
    pub fn new(datum: usize, is_on_border: bool) -> Self {
        Self(datum as u32 | if is_on_border { BORDER } else { 0 })
    }

    /// Returns the datum.
    #[inline]
    pub fn datum(self) -> usize {
        (self.0 & !BORDER) as usize
    }

    /// False: it lies inside of its triangle, for sure.
    #[inline]
    pub fn may_be_on_border(self) -> bool {
        self.0 & BORDER != 0
    }
}

/// The data of each face; ghosts hold none.
#[derive(Clone, Debug, Default)]
pub(super) struct Stock {
    lists: Vec<Vec<Held>>,
    /// Faces whose list has changed since this was last asked.
    touched: Vec<TriangleId>,
}

impl Stock {
    /// Makes room for so many faces.
    pub fn set_number(&mut self, faces: usize) {
        self.lists.resize(faces, Vec::new());
    }

    /// Lists what a face holds.
    #[inline]
    pub fn held(&self, t: TriangleId) -> &[Held] {
        &self.lists[t.index()]
    }

    /// Counts what a face holds.
    #[inline]
    pub fn count(&self, t: TriangleId) -> usize {
        self.lists[t.index()].len()
    }

    /// Takes all from a face.
    pub fn take(&mut self, t: TriangleId) -> Vec<Held> {
        self.touched.push(t);
        std::mem::take(&mut self.lists[t.index()])
    }

    /// Gives a face one more.
    #[inline]
    pub fn give(&mut self, t: TriangleId, held: Held) {
        self.lists[t.index()].push(held);
    }

    /// Notes that a face has got, or lost, something.
    pub fn touch(&mut self, t: TriangleId) {
        self.touched.push(t);
    }

    /// Gives a datum at `place` in the list of one face to another, on whose boundary it lies as well.
    pub fn pass_on(&mut self, from: TriangleId, place: usize, to: TriangleId) {
        let held = self.lists[from.index()].remove(place);
        self.lists[to.index()].push(held);
        self.touched.extend([from, to]);
    }

    /// Follows a face that has got another id, or vanished.
    pub fn follow(&mut self, moved: Moved) {
        let last = self.lists.pop().expect("bug: no face is left");
        if let Some(list) = self.lists.get_mut(moved.to.index()) {
            *list = last;
            self.touched.push(moved.to);
        }
    }

    /// Lists the faces that have changed since it was last asked, some perhaps several times.
    pub fn drain_touched(&mut self) -> std::vec::Drain<'_, TriangleId> {
        self.touched.drain(..)
    }
}
