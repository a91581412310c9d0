//! What a refined mesh is asked to be.

use crate::domain::Kept;
use crate::numbers::{angle, positive};
use crate::sizing::Sizing;
use delone::check::Asked;
use delone::{Angle, Locked, Quality};

/// Options about refined meshes.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Refined meshes", mut_arg("specs", |sizing| sizing.requires("domain")))]
pub struct Bounds {
    /// Allow Steiner points, on segments and elsewhere; all of the following imply it
    #[arg(long, requires = "domain")]
    refined: bool,
    /// No angle smaller than this, in degrees, unless something excuses it
    #[arg(long, value_name = "DEG", requires = "domain", value_parser = angle,
          allow_negative_numbers = true)]
    min_angle: Option<f64>,
    /// No edge longer than this
    #[arg(long, value_name = "LENGTH", requires = "domain", value_parser = positive,
          allow_negative_numbers = true)]
    max_edge: Option<f64>,
    /// No triangle larger than this
    #[arg(long, value_name = "AREA", requires = "domain", value_parser = positive,
          allow_negative_numbers = true)]
    max_area: Option<f64>,
    /// In each region of the domain no triangle larger than the region allows
    #[arg(long, requires = "domain")]
    area_per_region: bool,
    #[command(flatten, next_help_heading = "Refined meshes")]
    pub sizing: Sizing,
    /// No vertex was added on segments: on none, or on none with the domain on one side only
    #[arg(long, value_enum, value_name = "WHICH", requires = "domain",
          num_args = 0..=1, require_equals = true, default_missing_value = "all")]
    keep_boundary: Option<Kept>,
    /// No vertex lies inside the diametral circle of a subsegment that it sees
    #[arg(long, requires = "domain")]
    conforming: bool,
}

impl Bounds {
    /// Tells whether there may be Steiner points.
    pub fn is_refined(&self) -> bool {
        self.refined || self.asked().is_some()
    }

    /// Returns what is asked for, if anything is, but for the sizes.
    pub fn asked(&self) -> Option<Asked<'_>> {
        let quality = self.quality();
        let is_asked = quality != Quality::default()
            || self.sizing.is_given()
            || self.keep_boundary.is_some()
            || self.conforming;
        let asked =
            Asked::new(quality).locked(self.keep_boundary.map_or(Locked::Nothing, Into::into));
        is_asked.then_some(if self.conforming {
            asked.conforming()
        } else {
            asked
        })
    }

    fn quality(&self) -> Quality {
        Quality {
            min_angle: self.min_angle.map(Angle::degrees),
            max_edge: self.max_edge,
            max_area: self.max_area,
            region_areas: self.area_per_region,
        }
    }
}
