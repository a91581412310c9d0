//! Typed 32-bit ids. `next` and `prev` are arithmetic on the id alone.

use std::fmt;

macro_rules! id {
    ($(#[$doc:meta])* $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[repr(transparent)]
        pub struct $name(u32);

        impl $name {
            /// Makes an id from an index.
            ///
            /// # Panics
            /// If `index` does not fit 32 bits; builders refuse such inputs before.
            #[inline]
            pub const fn new(index: usize) -> Self {
                assert!(index <= u32::MAX as usize, "bug: id out of range");
                Self(index as u32)
            }

            /// Returns the index.
            #[inline]
            pub const fn index(self) -> usize {
                self.0 as usize
            }

            /// Returns the index as it is stored.
            #[inline]
            pub const fn raw(self) -> u32 {
                self.0
            }
        }

        impl From<u32> for $name {
            #[inline]
            fn from(raw: u32) -> Self {
                Self(raw)
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }
    };
}

id!(
    /// A vertex; for the result of a builder, the index of the caller's point.
    VertexId, "v"
);
id!(
    /// A half-edge: `3t + k` is the one opposite corner `k` of triangle `t`.
    HalfEdgeId, "h"
);
id!(
    /// A face: a triangle, or a ghost.
    TriangleId, "t"
);

impl VertexId {
    /// The vertex at infinity, shared by all ghosts.
    pub const INFINITE: Self = Self(u32::MAX);

    /// Tells whether this is the vertex at infinity.
    #[inline]
    pub const fn is_infinite(self) -> bool {
        self.0 == u32::MAX
    }
}

impl fmt::Display for VertexId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl HalfEdgeId {
    /// Returns the half-edge after this one, counter-clockwise in its triangle.
    #[inline]
    pub const fn next(self) -> Self {
        Self(if self.0 % 3 == 2 {
            self.0 - 2
        } else {
            self.0 + 1
        })
    }

    /// Returns the half-edge before this one, counter-clockwise in its triangle.
    #[inline]
    pub const fn prev(self) -> Self {
        Self(if self.0.is_multiple_of(3) {
            self.0 + 2
        } else {
            self.0 - 1
        })
    }

    /// Returns which of its triangle's three half-edges this is: the corner it lies opposite to.
    #[inline]
    pub const fn slot(self) -> usize {
        (self.0 % 3) as usize
    }

    /// Returns the triangle that owns this half-edge.
    #[inline]
    pub const fn triangle(self) -> TriangleId {
        TriangleId(self.0 / 3)
    }
}

impl TriangleId {
    /// Returns the three half-edges; the `k`-th lies opposite corner `k`.
    #[inline]
    pub const fn half_edges(self) -> [HalfEdgeId; 3] {
        let first = 3 * self.0;
        [
            HalfEdgeId(first),
            HalfEdgeId(first + 1),
            HalfEdgeId(first + 2),
        ]
    }
}
