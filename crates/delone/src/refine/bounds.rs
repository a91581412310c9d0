//! What is asked of a triangle, as numbers that are cheap to compare with.
//!
//! The smallest angle of a triangle lies opposite its shortest edge, between the two others. With twice
//! the area A as their cross product, its sine is 2A over the product of their lengths: no root, no
//! trigonometric function is ever taken of a triangle.

use super::{Encroachment, SizingField};
use crate::predicates::{CircleSide, in_diametral_circle};
use crate::{Angle, Point, Quality, Region};

/// Bounds are tightened by this much, so that whoever measures with other roundings finds them met.
const SLACK: f64 = 1e-12;

pub(super) struct Bounds<'a> {
    /// The squared sine of the smallest angle.
    sin_squared: f64,
    /// The square of the longest edge.
    max_edge_squared: f64,
    /// Twice the largest area.
    max_cross: f64,
    /// Twice the largest area of each region, that of no region first.
    region_cross: Vec<f64>,
    field: Option<&'a dyn SizingField>,
    /// The squared cosine of the angle of a lens; zero for circles.
    lens: f64,
    /// Coordinates here are those of the input times this power of two.
    scale: f64,
    pub min_angle: f64,
}

/// The shape of a triangle, as far as the bounds need it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// The squared length of the edge opposite each corner.
    pub squares: [f64; 3],
    /// Twice the area.
    pub cross: f64,
    /// By which all these were multiplied, so that they do not vanish.
    zoom: f64,
}

/// Below this the fourth powers of lengths could vanish.
const SMALLEST_SQUARE: f64 = 1e-150;
/// What a triangle is enlarged by that is smaller.
const ZOOM: f64 = f64::from_bits((1023 + 500) << 52);

impl Shape {
    #[inline]
    pub fn of(corners: [Point; 3]) -> Self {
        let shape = Self::zoomed(corners, 1.0);
        match shape.longest().1 > SMALLEST_SQUARE {
            true => shape,
            false => Self::zoomed(corners, ZOOM),
        }
    }

    #[inline]
    fn zoomed([a, b, c]: [Point; 3], zoom: f64) -> Self {
        let side = |p: Point, q: Point| [(q.x - p.x) * zoom, (q.y - p.y) * zoom];
        let [[ux, uy], [vx, vy], [wx, wy]] = [side(a, b), side(a, c), side(b, c)];
        Self {
            squares: [wx * wx + wy * wy, vx * vx + vy * vy, ux * ux + uy * uy],
            cross: ux * vy - uy * vx,
            zoom: zoom * zoom,
        }
    }

    /// Returns the slot of the shortest edge, and its squared length.
    #[inline]
    pub fn shortest(&self) -> (usize, f64) {
        let [a, b, c] = self.squares;
        let (k, least) = if b < a { (1, b) } else { (0, a) };
        if c < least { (2, c) } else { (k, least) }
    }

    /// Returns the slot of the longest edge, and its squared length.
    #[inline]
    pub fn longest(&self) -> (usize, f64) {
        let [a, b, c] = self.squares;
        let (k, most) = if b > a { (1, b) } else { (0, a) };
        if c > most { (2, c) } else { (k, most) }
    }
}

impl<'a> Bounds<'a> {
    pub fn new(
        quality: &Quality,
        regions: &[Region],
        field: Option<&'a dyn SizingField>,
        encroachment: Encroachment,
        scale: f64,
    ) -> Self {
        let min_angle = quality.min_angle.map_or(0.0, Angle::to_radians);
        let sin = libm::sin(min_angle);
        let lens = match encroachment {
            Encroachment::Lens => libm::cos(2.0 * min_angle.min(std::f64::consts::FRAC_PI_4)),
            Encroachment::Circle => 0.0,
        };
        let cross = |area: Option<f64>| {
            area.map_or(f64::INFINITY, |a| 2.0 * a * scale * scale * (1.0 - SLACK))
        };
        let of_regions = regions.iter().map(|region| cross(region.max_area));
        let region_cross = match quality.region_areas {
            true => std::iter::once(f64::INFINITY).chain(of_regions).collect(),
            false => Vec::new(),
        };
        let max_edge = quality
            .max_edge
            .map_or(f64::INFINITY, |h| h * scale * (1.0 - SLACK));
        Self {
            sin_squared: sin * sin * (1.0 + SLACK),
            max_edge_squared: max_edge * max_edge,
            max_cross: cross(quality.max_area),
            region_cross,
            field,
            lens: lens * lens,
            scale,
            min_angle,
        }
    }

    /// Tells whether the smallest angle is too small, given squared lengths and twice the area.
    #[inline]
    pub fn is_skinny(&self, [a, b, c]: [f64; 3], cross: f64) -> bool {
        // Comparisons, because `min` and `max` take twice as long to get along with NaN.
        let (low, high) = if a < b { (a, b) } else { (b, a) };
        let middle = if low < c { c } else { low };
        cross * cross < self.sin_squared * high * middle
    }

    /// Tells whether there is a bound on size anywhere.
    pub fn has_sizes(&self) -> bool {
        self.field.is_some()
            || self.max_edge_squared.is_finite()
            || self.max_cross.is_finite()
            || !self.region_cross.is_empty()
    }

    /// Returns by how much a triangle is too large, as ratio of areas: at most 1 if it is not.
    pub fn oversize(&self, corners: [Point; 3], shape: &Shape, region: u32) -> f64 {
        let [edge, area] = self.oversizes(corners, shape, region);
        edge.max(area)
    }

    /// Returns the square of the longest edge and the area as multiples of what is allowed.
    pub fn oversizes(&self, corners: [Point; 3], shape: &Shape, region: u32) -> [f64; 2] {
        let mut edge = self.max_edge_squared;
        let mut cross = self.max_cross;
        if let Some(&of_region) = self.region_cross.get(region as usize) {
            cross = cross.min(of_region);
        }
        if let Some(field) = self.field {
            let [a, b, c] = corners;
            let mean = |a: f64, b: f64, c: f64| (a + b + c) / 3.0 / self.scale;
            let at = Point::new(mean(a.x, b.x, c.x), mean(a.y, b.y, c.y));
            let bound = |value: f64, scale: f64| match value > 0.0 {
                true => value * scale * (1.0 - SLACK),
                false => f64::INFINITY,
            };
            let longest = bound(field.max_edge(at), self.scale);
            edge = edge.min(longest * longest);
            cross = cross.min(bound(field.max_area(at), 2.0 * self.scale * self.scale));
        }
        [
            shape.longest().1 / shape.zoom / edge,
            shape.cross / shape.zoom / cross,
        ]
    }

    /// Returns how long a subsegment may be if a vertex lies beside its middle, as a multiple of the
    /// vertex' distance from it.
    pub fn reach(&self) -> f64 {
        // The cosine of the lens' angle, and the tangent of half of it.
        let cos = -self.lens.sqrt();
        2.0 * ((1.0 - cos) / (1.0 + cos)).sqrt()
    }

    /// Tells whether `p` is too close to the subsegment `ab`.
    #[inline]
    pub fn encroaches(&self, [a, b]: [Point; 2], p: Point) -> bool {
        if in_diametral_circle(a, b, p) != CircleSide::Inside {
            return false;
        }
        if self.lens == 0.0 {
            return true;
        }
        let [ux, uy] = [a.x - p.x, a.y - p.y];
        let [vx, vy] = [b.x - p.x, b.y - p.y];
        let dot = ux * vx + uy * vy;
        dot * dot >= self.lens * (ux * ux + uy * uy) * (vx * vx + vy * vy)
    }
}
