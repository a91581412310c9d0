//! What the sweep line will come to: the lowest points of circles.

use super::beach::ArcId;
use crate::VertexId;
use crate::predicates::Bottom;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// The lowest point of a circle that goes through the foci of three neighbouring arcs: there the middle one
/// ends.
pub(super) struct Circle {
    pub bottom: Bottom,
    /// The middle one.
    pub arc: ArcId,
    /// The foci, counter-clockwise.
    pub triangle: [VertexId; 3],
    number: u64,
}

/// Circles that wait, each on behalf of its arc.
#[derive(Default)]
pub(super) struct Circles {
    heap: BinaryHeap<Circle>,
    /// For each arc, by its number, the circle that waits for it.
    of_arcs: Vec<Option<(u64, [VertexId; 3])>>,
    count: u64,
}

impl Circles {
    /// Lets a circle wait for an arc, for which none waits.
    pub fn push(&mut self, arc: ArcId, triangle: [VertexId; 3], bottom: Bottom) {
        let number = self.count;
        self.count += 1;
        let i = arc as usize;
        if i >= self.of_arcs.len() {
            self.of_arcs.resize(i + 1, None);
        }
        self.of_arcs[i] = Some((number, triangle));
        self.heap.push(Circle {
            bottom,
            arc,
            triangle,
            number,
        });
    }

    /// Forgets the circle of an arc, and returns its triangle, if there was one.
    pub fn forget(&mut self, arc: ArcId) -> Option<[VertexId; 3]> {
        let waiting = self.of_arcs.get_mut(arc as usize)?.take();
        waiting.map(|(_, triangle)| triangle)
    }

    /// Takes out the circle with the highest of all lowest points, if that `is_next`.
    pub fn pop_if(&mut self, is_next: impl FnOnce(&Bottom) -> bool) -> Option<Circle> {
        while let Some(circle) = self.heap.peek() {
            let waiting = self.of_arcs[circle.arc as usize];
            if waiting.is_some_and(|(number, _)| number == circle.number) {
                break;
            }
            self.heap.pop(); // Forgotten long ago.
        }
        if !is_next(&self.heap.peek()?.bottom) {
            return None;
        }
        let circle = self.heap.pop()?;
        self.forget(circle.arc);
        Some(circle)
    }
}

impl Ord for Circle {
    /// Whose lowest point is higher is greater; of equal ones who came first.
    fn cmp(&self, other: &Self) -> Ordering {
        let by_height = self.bottom.compare(&other.bottom);
        by_height.then_with(|| other.number.cmp(&self.number))
    }
}

impl PartialOrd for Circle {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Circle {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Circle {}
