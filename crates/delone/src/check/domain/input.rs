//! Is the input one that has a domain? What is wrong with it is an error, not a defect of a mesh.

use super::super::require_points;
use super::places::Places;
use crate::pace::Pace;
use crate::{Error, Pslg, Seed, VertexId};

/// Requires finite points and seeds, and segments and polygons that name what exists.
pub(super) fn require(input: &Pslg, pace: &mut Pace) -> Result<(), Error> {
    require_points(&input.points, pace)?;
    require_segments(input, pace)?;
    let segments = input.segments.len();
    for (polygon, range) in input.polygons.iter().enumerate() {
        pace.step()?;
        if range.start > range.end || range.end > segments {
            return Err(Error::BadPolygon {
                polygon,
                range: range.clone(),
                segments,
            });
        }
    }
    for (hole, &at) in input.holes.iter().enumerate() {
        pace.step()?;
        if !at.is_finite() {
            let seed = Seed::Hole(hole);
            return Err(Error::SeedNotFinite { seed, at });
        }
    }
    Ok(())
}

fn require_segments(input: &Pslg, pace: &mut Pace) -> Result<(), Error> {
    let points = input.points.len();
    let given = input.segments.len();
    let limit = u32::MAX as usize;
    if given > limit {
        return Err(Error::TooManySegments { given, limit });
    }
    for (segment, ends) in input.segments.iter().enumerate() {
        pace.step()?;
        if let Some(&vertex) = ends.iter().find(|v| v.index() >= points) {
            return Err(Error::BadSegment {
                segment,
                vertex,
                points,
            });
        }
    }
    Ok(())
}

/// Requires that an even number of a polygon's segments end in each place.
pub(super) fn require_closed(input: &Pslg, places: &Places, pace: &mut Pace) -> Result<(), Error> {
    let mut is_odd = vec![false; places.len()];
    let place = |v: &VertexId| places.of(*v) as usize;
    for (polygon, segments) in input.polygons.iter().enumerate() {
        let ends = input.segments[segments.clone()].as_flattened();
        for v in ends {
            pace.step()?;
            is_odd[place(v)] ^= true;
        }
        if let Some(&vertex) = ends.iter().find(|v| is_odd[place(v)]) {
            let at = input.points[vertex.index()];
            return Err(Error::OpenPolygon {
                polygon,
                vertex,
                at,
            });
        }
    }
    Ok(())
}
