//! The polygon that is to be covered, as a file has it.

use crate::exit::Failure;
use crate::files::Outputs;
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::task::Task;
use delone::{Point, VertexId};
use delone_io::DomainData;
use std::path::Path;

/// A polygon and the file that it comes from.
pub struct Polygon {
    /// Its corners, one after the other.
    pub corners: Vec<Point>,
    pub numbering: Numbering,
}

/// Reads a polygon; no output may overwrite its file.
pub fn read(
    file: &Path,
    task: &Task,
    outputs: &Outputs,
    progress: &Progress,
) -> Result<Polygon, Failure> {
    let input = task.open_another(file)?;
    outputs.spare(&input.files())?;
    let (domain, unused) = input.domain(progress)?;
    progress.note(&unused);
    let numbering = Numbering::of(&input.name(), &domain);
    let corners = ring(&domain).map_err(|why| {
        let file = numbering.file();
        Failure::BadInput(format!(
            "{file}: {why}; a domain to cover is one closed ring"
        ))
    })?;
    Ok(Polygon { corners, numbering })
}

/// Follows the segments once around, or says why that cannot be.
fn ring(domain: &DomainData) -> Result<Vec<Point>, &'static str> {
    if !domain.holes.is_empty() {
        return Err("it has holes");
    }
    let Some(&[first, _]) = domain.segments.first() else {
        return Err("there is no polygon");
    };
    let ends = neighbours(domain)?;
    let mut ring = vec![first];
    let (mut before, mut here) = (first, ends[first.index()][0]);
    while here != first {
        ring.push(here);
        let [a, b] = ends[here.index()];
        (before, here) = (here, if a == before { b } else { a });
    }
    if ring.len() < domain.segments.len() {
        return Err("it has more than one ring");
    }
    let point = |v: VertexId| domain.vertices.points[v.index()];
    Ok(ring.into_iter().map(point).collect())
}

/// Lists the two neighbours of each vertex that segments join; others have none.
fn neighbours(domain: &DomainData) -> Result<Vec<[VertexId; 2]>, &'static str> {
    let mut lists = vec![Vec::new(); domain.vertices.points.len()];
    for &[a, b] in &domain.segments {
        lists[a.index()].push(b);
        lists[b.index()].push(a);
    }
    let pair = |(v, list): (usize, Vec<VertexId>)| match list[..] {
        [] => Ok([VertexId::new(v); 2]),
        [a, b] => Ok([a, b]),
        [_] => Err("its outline is not closed"),
        _ => Err("its outline meets itself"),
    };
    lists.into_iter().enumerate().map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::Pslg;

    fn of(segments: &[[usize; 2]]) -> Result<Vec<Point>, &'static str> {
        let points = (0..9).map(|i| (f64::from(i), f64::from(i * i)));
        let segments = segments.iter().map(|ends| ends.map(VertexId::new));
        ring(&DomainData::from(Pslg {
            segments: segments.collect(),
            ..Pslg::from_points(points)
        }))
    }

    #[test]
    fn a_ring_is_followed_whatever_the_order_of_its_segments() {
        let xs = |ring: Vec<Point>| ring.iter().map(|p| p.x).collect::<Vec<_>>();
        let found = of(&[[2, 4], [7, 5], [4, 5], [7, 2]]).map(xs);
        assert_eq!(found, Ok(vec![2.0, 4.0, 5.0, 7.0]));
    }

    #[test]
    fn what_is_no_ring_is_refused() {
        for (segments, why) in [
            (&[][..], "no polygon"),
            (&[[0, 1], [1, 2]], "not closed"),
            (
                &[[0, 1], [1, 2], [2, 0], [0, 3], [3, 4], [4, 0]],
                "meets itself",
            ),
            (
                &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]],
                "more than one",
            ),
        ] {
            assert!(of(segments).unwrap_err().contains(why), "{segments:?}");
        }
    }

    /// Wherever it goes, it comes back.
    #[test]
    fn segments_from_a_point_to_itself_are_a_ring() {
        assert_eq!(of(&[[3, 3]]).map(|ring| ring.len()), Ok(1));
        assert_eq!(of(&[[3, 4], [4, 3]]).map(|ring| ring.len()), Ok(2));
    }
}
