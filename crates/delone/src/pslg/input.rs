//! The first look at the input: do indices, ranges and seeds make sense?

use super::Pslg;
use crate::{Error, Seed, VertexId};

/// The most segments that 32 bits can number, one number reserved.
const MAX_SEGMENTS: usize = u32::MAX as usize - 1;

/// Checks all but the coordinates of the points, which the Delaunay triangulation looks at.
pub(crate) fn check(pslg: &Pslg) -> Result<(), Error> {
    check_segments(&pslg.segments, pslg.points.len())?;
    check_polygons(pslg)?;
    let holes = pslg.holes.iter().enumerate();
    let regions = pslg.regions.iter().enumerate();
    let seeds = holes
        .map(|(i, &at)| (Seed::Hole(i), at))
        .chain(regions.map(|(i, region)| (Seed::Region(i), region.at)));
    for (seed, at) in seeds {
        if !at.is_finite() {
            return Err(Error::SeedNotFinite { seed, at });
        }
    }
    check_areas(pslg)
}

fn check_areas(pslg: &Pslg) -> Result<(), Error> {
    for (region, max_area) in pslg.regions.iter().map(|r| r.max_area).enumerate() {
        if let Some(max_area) = max_area.filter(|&area| area.is_nan() || area <= 0.0) {
            return Err(Error::BadArea { region, max_area });
        }
    }
    Ok(())
}

/// Requires that there are not too many segments, and that they name points.
pub(super) fn check_segments(segments: &[[VertexId; 2]], points: usize) -> Result<(), Error> {
    let given = segments.len();
    if given > MAX_SEGMENTS {
        let limit = MAX_SEGMENTS;
        return Err(Error::TooManySegments { given, limit });
    }
    for (segment, ends) in segments.iter().enumerate() {
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

/// Requires that polygons are ranges of segments, and have none in common.
fn check_polygons(pslg: &Pslg) -> Result<(), Error> {
    let segments = pslg.segments.len();
    for (polygon, range) in pslg.polygons.iter().enumerate() {
        if range.start > range.end || range.end > segments {
            return Err(Error::BadPolygon {
                polygon,
                range: range.clone(),
                segments,
            });
        }
    }
    let mut order: Vec<usize> = (0..pslg.polygons.len()).collect();
    order.retain(|&i| !pslg.polygons[i].is_empty());
    order.sort_unstable_by_key(|&i| (pslg.polygons[i].start, i));
    let shared = order.array_windows().find_map(|&[i, j]| {
        let segment = pslg.polygons[j].start;
        let is_shared = segment < pslg.polygons[i].end;
        is_shared.then_some(([i, j], segment))
    });
    match shared {
        Some((polygons, segment)) => Err(Error::SharedSegment { polygons, segment }),
        None => Ok(()),
    }
}

/// Requires that each polygon is closed: in every position an even number of its segments end.
pub(crate) fn require_closed(pslg: &Pslg) -> Result<(), Error> {
    let mut ends: Vec<VertexId> = Vec::new();
    for (polygon, range) in pslg.polygons.iter().enumerate() {
        ends.clear();
        ends.extend(pslg.segments[range.clone()].as_flattened());
        let at = |v: VertexId| pslg.points[v.index()];
        ends.sort_unstable_by(|&v, &w| at(v).lex_cmp(&at(w)).then(v.cmp(&w)));
        let mut meetings = ends.chunk_by(|&v, &w| at(v) == at(w));
        if let Some(odd) = meetings.find(|meeting| meeting.len() % 2 == 1) {
            return Err(Error::OpenPolygon {
                polygon,
                vertex: odd[0],
                at: at(odd[0]),
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Point;

    fn square() -> Pslg {
        let mut square = Pslg::from_points([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
        square.add_ring([0, 1, 2, 3]);
        square
    }

    #[test]
    fn segments_must_name_points() {
        let mut pslg = square();
        assert_eq!(check(&pslg), Ok(()));
        pslg.add_segment(2, 4);
        let expected = Error::BadSegment {
            segment: 4,
            vertex: VertexId::new(4),
            points: 4,
        };
        assert_eq!(check(&pslg), Err(expected));
    }

    #[test]
    fn polygons_must_be_ranges_and_closed() {
        let mut pslg = square();
        pslg.polygons = vec![0..4, 3..5];
        let Err(Error::BadPolygon { polygon: 1, .. }) = check(&pslg) else {
            panic!("a range beyond the end");
        };
        pslg.polygons = Vec::from([0..3, 2..4]);
        let shared = Error::SharedSegment {
            polygons: [0, 1],
            segment: 2,
        };
        assert_eq!(check(&pslg), Err(shared));
        pslg.polygons.clear();
        pslg.polygons.push(0..4);
        assert_eq!(require_closed(&pslg), Ok(()));
        pslg.polygons[0] = 1..4;
        let Err(Error::OpenPolygon { vertex, .. }) = require_closed(&pslg) else {
            panic!("an open polygon");
        };
        assert_eq!(vertex, VertexId::new(0));
    }

    #[test]
    fn a_ring_may_close_through_an_equal_point() {
        let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (-0.0, 0.0)];
        let mut pslg = Pslg::from_points(corners);
        pslg.add_polyline([0, 1, 2, 3]);
        pslg.polygons.push(0..3);
        assert_eq!(require_closed(&pslg), Ok(()));
    }

    #[test]
    fn areas_must_be_positive() {
        let mut pslg = square();
        let (at, attribute) = (Point::new(0.5, 0.5), 1.0);
        for (max_area, is_right) in [(None, true), (Some(0.1), true), (Some(0.0), false)] {
            pslg.regions = vec![crate::Region {
                at,
                attribute,
                max_area,
            }];
            assert_eq!(check(&pslg).is_ok(), is_right);
        }
    }

    #[test]
    fn seeds_must_be_finite() {
        let mut pslg = square();
        pslg.holes.push(Point::new(0.5, f64::NAN));
        let Err(Error::SeedNotFinite { seed, .. }) = check(&pslg) else {
            panic!("a seed that is nowhere");
        };
        assert_eq!(seed, Seed::Hole(0));
    }
}
