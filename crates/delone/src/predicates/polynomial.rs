//! The two polynomials from which all predicates are made, over any exact ring.

use std::ops::{Add, Mul, Sub};

/// Returns `ax·by − ay·bx`, positive if `b` is counter-clockwise of `a`.
#[inline(always)]
pub(super) fn cross<T>([ax, ay]: &[T; 2], [bx, by]: &[T; 2]) -> T
where
    T: Sub<Output = T>,
    for<'t> &'t T: Mul<Output = T>,
{
    ax * by - ay * bx
}

/// Returns `ax·bx + ay·by`.
#[inline(always)]
pub(super) fn dot<T>([ax, ay]: &[T; 2], [bx, by]: &[T; 2]) -> T
where
    T: Add<Output = T>,
    for<'t> &'t T: Mul<Output = T>,
{
    ax * bx + ay * by
}

/// Returns the squared length of each of three vectors and the cross product of the other two; the
/// in-circle determinant is the sum of their products.
#[inline(always)]
pub(super) fn in_circle_terms<T>([a, b, c]: &[[T; 2]; 3]) -> [[T; 2]; 3]
where
    T: Add<Output = T> + Sub<Output = T>,
    for<'t> &'t T: Mul<Output = T>,
{
    [
        [dot(a, a), cross(b, c)],
        [dot(b, b), cross(c, a)],
        [dot(c, c), cross(a, b)],
    ]
}
