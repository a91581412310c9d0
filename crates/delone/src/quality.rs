//! What a good triangle is: bounds on angles, edges and areas; and what must not be touched for it.

use crate::Error;

/// An angle, with its unit in the name of whatever makes or reads it.
///
/// ```
/// use delone::Angle;
/// assert_eq!(Angle::degrees(30.0).to_degrees(), 30.0);
/// assert!((Angle::radians(1.0).to_degrees() - 57.2957795).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Angle {
    // In degrees: what people write must come back as they wrote it.
    degrees: f64,
}

impl Angle {
    /// Makes an angle of degrees.
    pub const fn degrees(degrees: f64) -> Self {
        Self { degrees }
    }

    /// Makes an angle of radians.
    pub const fn radians(radians: f64) -> Self {
        Self {
            degrees: radians * (180.0 / std::f64::consts::PI),
        }
    }

    /// Returns it in degrees.
    pub const fn to_degrees(self) -> f64 {
        self.degrees
    }

    /// Returns it in radians.
    pub const fn to_radians(self) -> f64 {
        self.degrees * (std::f64::consts::PI / 180.0)
    }
}

/// What every triangle of a refined mesh should meet; nothing is asked for where a bound is `None`.
///
/// A [`SizingField`](crate::SizingField) adds bounds that depend on the place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Quality {
    /// No angle smaller than this; at least 0 and below 60 degrees. Up to 33 end well in practice.
    pub min_angle: Option<Angle>,
    /// No edge longer than this, in units of the coordinates.
    pub max_edge: Option<f64>,
    /// No area larger than this, in squared units of the coordinates.
    pub max_area: Option<f64>,
    /// Also obey [`Region::max_area`](crate::Region::max_area) in each region that has one.
    pub region_areas: bool,
}

impl Quality {
    /// Refuses bounds that make no sense.
    pub(crate) fn require(&self) -> Result<(), Error> {
        let bad = |what, given| Err(Error::BadQuality { what, given });
        if let Some(angle) = self.min_angle.map(Angle::to_degrees)
            && !(0.0..60.0).contains(&angle)
        {
            return bad(
                "smallest angle, in degrees, which must be at least 0 and below 60",
                angle,
            );
        }
        for (what, bound) in [
            ("longest edge, which must be positive", self.max_edge),
            ("largest area, which must be positive", self.max_area),
        ] {
            if let Some(bound) = bound.filter(|&b| b.is_nan() || b <= 0.0) {
                return bad(what, bound);
            }
        }
        Ok(())
    }
}

/// Which bounds a triangle breaks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Broken {
    /// Its smallest angle is below the bound.
    pub angle: bool,
    /// Its longest edge is above the bound, or above what the sizing field allows.
    pub edge: bool,
    /// Its area is above the bound, that of its region, or what the sizing field allows.
    pub area: bool,
}

/// Which edges must stay as they are: no vertex is put on them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Locked {
    /// None: vertices may go wherever they are needed.
    #[default]
    Nothing,
    /// Segments with the domain on one side only.
    Boundary,
    /// All segments.
    Segments,
}
