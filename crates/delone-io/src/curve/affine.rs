//! Affine maps of space, as drawings put parts into one another.

/// A place in space; the plane is z = 0.
pub(crate) type Place3 = [f64; 3];

/// An affine map: the images of the three axes, and of the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Affine {
    pub axes: [Place3; 3],
    pub origin: Place3,
}

impl Affine {
    /// Leaves everything in its place.
    pub const IDENTITY: Self = Self::scale([1.0; 3]);

    /// Multiplies the coordinates.
    pub const fn scale([x, y, z]: Place3) -> Self {
        Self {
            axes: [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]],
            origin: [0.0; 3],
        }
    }

    /// Adds to the coordinates.
    pub const fn shift(origin: Place3) -> Self {
        Self {
            origin,
            ..Self::IDENTITY
        }
    }

    /// Makes a map of the plane, as SVG writes it: x' = a x + c y + e, y' = b x + d y + f.
    pub const fn plane([a, b, c, d, e, f]: [f64; 6]) -> Self {
        Self {
            axes: [[a, b, 0.0], [c, d, 0.0], [0.0, 0.0, 1.0]],
            origin: [e, f, 0.0],
        }
    }

    /// Turns about the z axis, counter-clockwise; quarter turns are exact.
    pub fn turn(degrees: f64) -> Self {
        let [cos, sin] = super::unit(degrees);
        Self::plane([cos, sin, -sin, cos, 0.0, 0.0])
    }

    /// Makes the map that takes `first`, then this.
    pub fn after(&self, first: &Self) -> Self {
        Self {
            axes: first.axes.map(|axis| self.direction(axis)),
            origin: self.place(first.origin),
        }
    }

    /// Maps a place.
    pub fn place(&self, place: Place3) -> Place3 {
        let moved = self.direction(place);
        [0, 1, 2].map(|k| moved[k] + self.origin[k])
    }

    /// Maps a direction, which shifts do not move.
    pub fn direction(&self, d: Place3) -> Place3 {
        [0, 1, 2].map(|k| {
            let [x, y, z] = self.axes;
            // Without terms that are zero: zero times infinity would be no number.
            let term = |axis: f64, along: f64| if along == 0.0 { 0.0 } else { axis * along };
            term(x[k], d[0]) + term(y[k], d[1]) + term(z[k], d[2])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Affine;

    #[test]
    fn maps_are_composed_from_the_right() {
        let turned = Affine::turn(90.0).after(&Affine::shift([2.0, 0.0, 5.0]));
        assert_eq!(turned.place([1.0, 0.0, 0.0]), [0.0, 3.0, 5.0]);
        let shifted = Affine::shift([2.0, 0.0, 0.0]).after(&Affine::turn(90.0));
        assert_eq!(shifted.place([1.0, 0.0, 0.0]), [2.0, 1.0, 0.0]);
        assert_eq!(shifted.direction([1.0, 0.0, 0.0]), [0.0, 1.0, 0.0]);
        let plane = Affine::plane([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!(plane.place([10.0, 100.0, 0.0]), [315.0, 426.0, 0.0]);
    }
}
