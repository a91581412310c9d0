//! Options about what good triangles are.

use crate::numbers::{angle, positive};
use crate::refinable::Refinable;
use crate::sizing::Sizing;
use delone::{Angle, Quality};

/// The smallest angle if none is named.
///
/// Below it the Delaunay refinement of Miller, Pav and Walkington is proven to end for every domain
/// (26.45°), so what is left below the bound is the input's own; and it costs few triangles more than
/// the 20° of Triangle, while the worst element is far better.
const USUAL_ANGLE: f64 = 25.0;

/// The largest angle up to which refinement ends in practice without crowding vertices.
pub const SAFE_ANGLE: f64 = 33.0;

/// Bounds on triangles.
#[derive(clap::Args, Clone)]
#[command(next_help_heading = "Quality")]
pub struct Goals {
    /// No angle smaller than this, in degrees: 0 is no bound, up to 33 ends well in practice
    #[arg(long, value_name = "DEG", default_value_t = USUAL_ANGLE, value_parser = angle,
          allow_negative_numbers = true)]
    pub min_angle: f64,
    /// No edge longer than this
    #[arg(long, value_name = "LENGTH", value_parser = positive, allow_negative_numbers = true)]
    max_edge: Option<f64>,
    /// No triangle larger than this
    #[arg(long, value_name = "AREA", value_parser = positive, allow_negative_numbers = true)]
    pub max_area: Option<f64>,
    /// In each region of the input no triangle larger than the region allows; of a mesh MESH.ele, in
    /// each triangle none larger than MESH.area allows
    #[arg(long)]
    pub area_per_region: bool,
    #[command(flatten, next_help_heading = "Quality")]
    pub sizing: Sizing,
}

impl Goals {
    /// Returns the bounds that are the same everywhere, or in a region.
    pub fn quality(&self) -> Quality {
        Quality {
            min_angle: (self.min_angle > 0.0).then_some(Angle::degrees(self.min_angle)),
            max_edge: self.max_edge,
            max_area: self.max_area,
            region_areas: self.area_per_region,
        }
    }

    /// Says if a bound means nothing to this input.
    pub fn note(&self, input: &Refinable) -> Option<String> {
        let regions = &input.domain.regions;
        let is_bounded = input.sizes.is_some() || regions.iter().any(|r| r.max_area.is_some());
        let is_idle = self.area_per_region && !is_bounded;
        let note = "--area-per-region: no region of the input has a largest area, and no mesh has an \
                    .area file beside it";
        is_idle.then(|| note.to_owned())
    }
}
