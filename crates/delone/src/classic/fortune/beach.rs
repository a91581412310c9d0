//! The beach line: arcs from left to right, in a treap and in a list.
//!
//! The treap (Seidel and Aragon 1996) is ordered by the place on the line and nothing else: an arc is put
//! behind another, never compared. Its priorities come from the arcs' numbers, so every run is alike.
//!
//! *Cost*: O(log n) expected to find or put an arc; constant for neighbours.

use crate::VertexId;
use std::cmp::Ordering;

/// Names an arc; numbers are not used again.
pub(super) type ArcId = u32;

/// A part of a parabola.
struct Arc {
    /// Its focus.
    site: VertexId,
    /// The arcs to its left and right.
    neighbors: [Option<ArcId>; 2],
    /// In the treap.
    parent: Option<ArcId>,
    children: [Option<ArcId>; 2],
}

const LEFT: usize = 0;
const RIGHT: usize = 1;

/// All arcs that there have been, and the order of those that are there.
#[derive(Default)]
pub(super) struct Beach {
    arcs: Vec<Arc>,
    root: Option<ArcId>,
}

impl Beach {
    /// Returns the focus of an arc.
    pub fn site(&self, arc: ArcId) -> VertexId {
        self.arc(arc).site
    }

    /// Returns the arc to the left.
    pub fn before(&self, arc: ArcId) -> Option<ArcId> {
        self.arc(arc).neighbors[LEFT]
    }

    /// Returns the arc to the right.
    pub fn after(&self, arc: ArcId) -> Option<ArcId> {
        self.arc(arc).neighbors[RIGHT]
    }

    /// Searches for an arc; `side` tells where what is searched for lies, seen from an arc.
    pub fn find(&self, mut side: impl FnMut(ArcId) -> Ordering) -> Option<ArcId> {
        let mut arc = self.root?;
        loop {
            let child = match side(arc) {
                Ordering::Equal => return Some(arc),
                Ordering::Less => self.arc(arc).children[LEFT],
                Ordering::Greater => self.arc(arc).children[RIGHT],
            };
            match child {
                Some(child) => arc = child,
                None => return Some(arc),
            }
        }
    }

    /// Begins with one arc.
    pub fn begin(&mut self, site: VertexId) -> ArcId {
        let arc = self.push(site, [None; 2]);
        self.root = Some(arc);
        arc
    }

    /// Puts an arc to the right of another.
    pub fn insert_after(&mut self, left: ArcId, site: VertexId) -> ArcId {
        let right = self.after(left);
        let arc = self.push(site, [Some(left), right]);
        self.arc_mut(left).neighbors[RIGHT] = Some(arc);
        // Of two neighbours in order, one has no child on the side of the other.
        let (parent, side) = match right {
            Some(right) if self.arc(left).children[RIGHT].is_some() => (right, LEFT),
            _ => (left, RIGHT),
        };
        if let Some(right) = right {
            self.arc_mut(right).neighbors[LEFT] = Some(arc);
        }
        self.hang(parent, side, Some(arc));
        while let Some(parent) = self.arc(arc).parent {
            if priority(parent) > priority(arc) {
                break;
            }
            self.rotate_up(arc, parent);
        }
        arc
    }

    /// Takes an arc out.
    pub fn remove(&mut self, arc: ArcId) {
        let [left, right] = self.arc(arc).neighbors;
        if let Some(left) = left {
            self.arc_mut(left).neighbors[RIGHT] = right;
        }
        if let Some(right) = right {
            self.arc_mut(right).neighbors[LEFT] = left;
        }
        let upper = |beach: &Self| {
            let children = beach.arc(arc).children.into_iter().flatten();
            children.max_by_key(|&child| priority(child))
        };
        while let Some(child) = upper(self) {
            self.rotate_up(child, arc);
        }
        match self.arc(arc).parent {
            Some(parent) => {
                let side = self.side_of(arc, parent);
                self.arc_mut(parent).children[side] = None;
            }
            None => self.root = None,
        }
    }

    /// Lets an arc change places with its parent.
    ///
    /// ```text
    ///        parent                arc
    ///        /    \               /   \        and the same in a mirror
    ///      arc     z      →      x   parent
    ///      / \                       /    \
    ///     x   y                     y      z
    /// ```
    fn rotate_up(&mut self, arc: ArcId, parent: ArcId) {
        let side = self.side_of(arc, parent);
        let inner = self.arc(arc).children[1 - side];
        match self.arc(parent).parent {
            Some(above) => {
                let side = self.side_of(parent, above);
                self.hang(above, side, Some(arc));
            }
            None => {
                self.arc_mut(arc).parent = None;
                self.root = Some(arc);
            }
        }
        self.hang(parent, side, inner);
        self.hang(arc, 1 - side, Some(parent));
    }

    fn side_of(&self, child: ArcId, parent: ArcId) -> usize {
        usize::from(self.arc(parent).children[RIGHT] == Some(child))
    }

    fn hang(&mut self, parent: ArcId, side: usize, child: Option<ArcId>) {
        self.arc_mut(parent).children[side] = child;
        if let Some(child) = child {
            self.arc_mut(child).parent = Some(parent);
        }
    }

    fn push(&mut self, site: VertexId, neighbors: [Option<ArcId>; 2]) -> ArcId {
        let arc = self.arcs.len() as ArcId;
        self.arcs.push(Arc {
            site,
            neighbors,
            parent: None,
            children: [None; 2],
        });
        arc
    }

    fn arc(&self, arc: ArcId) -> &Arc {
        &self.arcs[arc as usize]
    }

    fn arc_mut(&mut self, arc: ArcId) -> &mut Arc {
        &mut self.arcs[arc as usize]
    }
}

/// Scatters numbers (the last step of SplitMix64); a bijection, so there are no ties.
fn priority(arc: ArcId) -> u64 {
    let z = (u64::from(arc) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depth(beach: &Beach, arc: ArcId) -> usize {
        std::iter::successors(beach.arc(arc).parent, |&a| beach.arc(a).parent).count()
    }

    /// Arcs in the order of the treap, each found by a search that knows its place.
    fn check(beach: &Beach, order: &[ArcId]) {
        let place = |arc| order.iter().position(|&a| a == arc).expect("is there");
        for (i, &arc) in order.iter().enumerate() {
            assert_eq!(beach.find(|a| i.cmp(&place(a))), Some(arc));
            assert_eq!(beach.before(arc), i.checked_sub(1).map(|i| order[i]));
            assert_eq!(beach.after(arc), order.get(i + 1).copied());
        }
    }

    #[test]
    fn arcs_come_and_go() {
        let mut beach = Beach::default();
        assert_eq!(beach.find(|_| Ordering::Equal), None);
        let mut order = vec![beach.begin(VertexId::new(0))];
        for i in 1..200 {
            let at = priority(1000 + i) as usize % order.len();
            let arc = beach.insert_after(order[at], VertexId::new(i as usize));
            assert_eq!(beach.site(arc).index(), i as usize);
            order.insert(at + 1, arc);
            if i % 3 == 0 {
                let at = priority(2000 + i) as usize % order.len();
                beach.remove(order.remove(at));
            }
            check(&beach, &order);
        }
        while let Some(arc) = order.pop() {
            beach.remove(arc);
            check(&beach, &order);
        }
        assert_eq!(beach.find(|_| Ordering::Equal), None);
    }

    #[test]
    fn a_row_is_not_deep() {
        let mut beach = Beach::default();
        let mut last = beach.begin(VertexId::new(0));
        for i in 1..10_000 {
            last = beach.insert_after(last, VertexId::new(i));
        }
        let deepest = (0..10_000).map(|arc| depth(&beach, arc)).max();
        assert!(deepest < Some(60), "{deepest:?}");
    }
}
