//! The borders between Voronoi cells, to be drawn.

use crate::Trouble;
use crate::save::around;
use delone::voronoi::{Domain, Voronoi};
use delone::{Point, triangulate};

/// Lists the borders within a box as segments: four coordinates each, sorted by where they begin.
///
/// They are read off the clipped cells, whose corners are rounded correctly however far away a vertex of the diagram
/// lies; that a border is a side of two cells shows in what is left once each is sorted.
pub(super) fn borders(points: &[Point], clip: Option<&[f64]>) -> Result<Vec<f64>, Trouble> {
    let corners = match clip {
        None => around(points),
        Some(&[x0, y0, x1, y1]) => [(x0, y0), (x1, y1)].map(Point::from),
        Some(other) => {
            let message = format!("clip: a box has 4 coordinates, not {}", other.len());
            return Err(Trouble::asked(message));
        }
    };
    let voronoi = Voronoi::new(&triangulate(points.iter().copied())?, &())?;
    let clipped = voronoi.clip(&Domain::rectangle(corners[0], corners[1])?, &())?;
    let mut borders = Vec::new();
    for site in voronoi.cells().map(|cell| cell.site()) {
        for part in clipped.parts(site) {
            borders.extend(sides(part.outline()).filter(|side| !lies_on(*side, corners)));
        }
    }
    borders.sort_by(|[a, b], [c, d]| a.lex_cmp(c).then(b.lex_cmp(d)));
    borders.dedup();
    let ends = borders.into_iter().flatten();
    Ok(ends.flat_map(|p| [p.x, p.y]).collect())
}

/// Visits the sides of a ring, each from its smaller end.
fn sides(ring: &[Point]) -> impl Iterator<Item = [Point; 2]> + '_ {
    let nexts = ring.iter().cycle().skip(1);
    ring.iter().zip(nexts).map(|(&a, &b)| match a.lex_cmp(&b) {
        std::cmp::Ordering::Greater => [b, a],
        _ => [a, b],
    })
}

/// Tells whether a segment is part of the border of a box.
fn lies_on([a, b]: [Point; 2], [low, high]: [Point; 2]) -> bool {
    let vertically = a.x == b.x && [low.x, high.x].contains(&a.x);
    let horizontally = a.y == b.y && [low.y, high.y].contains(&a.y);
    vertically || horizontally
}
