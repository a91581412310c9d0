//! Which triangles belong to the domain: floods through edges that are no constraints.
//!
//! The thesis counts, for each triangle, the edges of the rings that a horizontal ray from its centroid
//! crosses: odd is inside. Crossing an edge of a ring changes sides, wherever it is crossed; so the parity
//! can be handed on from triangle to triangle, and no centroid is needed, which would be rounded.
//!
//! The [rules](DomainRule) are those of the engine, holes named by points included. *Cost*: linear, for each
//! polygon if there are several. For who watches, the crossings of each ray are counted, in rounded numbers:
//! O(m) for each triangle.

use super::{Board, Input, ascending};
use crate::locate::{Location, locate};
use crate::predicates::{Orientation, orient2d};
use crate::{DomainRule, Error, Event, HalfEdgeId, Observer, Point, Seed, TriangleId, VertexId};
use std::collections::BTreeMap;

/// Which lines of pseudocode test and delete.
#[derive(Clone, Copy)]
pub(super) struct Lines {
    /// A triangle is tested.
    pub test: u16,
    /// Triangles are deleted.
    pub delete: u16,
}

/// How often segments run along an edge, smaller end first.
type Uses = BTreeMap<[VertexId; 2], usize>;

/// Carves away what the input's rule and holes say; `chains` holds the vertices along each segment. Polygons must
/// be closed.
///
/// # Errors
/// [`Error::SeedOnSegment`], [`Error::Cancelled`].
pub(super) fn carve<O: Observer>(
    board: &mut Board<O>,
    input: &Input,
    chains: &[Vec<VertexId>],
    lines: Lines,
) -> Result<(), Error> {
    let mut outside = outside(board, input, chains);
    carve_holes(board, &input.pslg.holes, chains, &mut outside)?;
    if input.domain == DomainRule::Hull && input.pslg.holes.is_empty() {
        return Ok(());
    }
    board.at(lines.test);
    tell_tests(board, chains, &outside)?;
    board.at(lines.delete);
    board.carve(outside);
    Ok(())
}

/// Tells for each face whether the rule leaves it outside; ghosts are.
fn outside<O: Observer>(board: &Board<O>, input: &Input, chains: &[Vec<VertexId>]) -> Vec<bool> {
    let mesh = board.mesh();
    match input.domain {
        DomainRule::Hull => mesh
            .faces()
            .iter()
            .map(|f| f.iter().any(|v| v.is_infinite()))
            .collect(),
        DomainRule::Carve => {
            let depths = depths(board, |h| board.is_locked(h));
            depths.into_iter().map(|depth| depth == 0).collect()
        }
        DomainRule::EvenOdd if input.pslg.polygons.is_empty() => is_even(board, &uses(chains)),
        DomainRule::EvenOdd => {
            let mut outside = vec![true; mesh.num_faces()];
            for polygon in &input.pslg.polygons {
                let of_this = is_even(board, &uses(&chains[polygon.clone()]));
                outside
                    .iter_mut()
                    .zip(of_this)
                    .for_each(|(all, this)| *all &= this);
            }
            outside
        }
    }
}

fn uses(chains: &[Vec<VertexId>]) -> Uses {
    let mut uses = Uses::new();
    for edge in chains.iter().flat_map(|chain| chain.windows(2)) {
        *uses.entry(ascending([edge[0], edge[1]])).or_default() += 1;
    }
    uses
}

/// Tells for each face whether an even number of segments separates it from infinity, on the shortest way.
fn is_even<O: Observer>(board: &Board<O>, uses: &Uses) -> Vec<bool> {
    let is_border = |h| {
        uses.get(&ascending(board.ends(h)))
            .is_some_and(|n| n % 2 == 1)
    };
    let depths = depths(board, is_border);
    depths.into_iter().map(|depth| depth % 2 == 0).collect()
}

/// Counts for each face how many borders must be crossed on the way from infinity: a search by levels.
fn depths<O: Observer>(board: &Board<O>, is_border: impl Fn(HalfEdgeId) -> bool) -> Vec<u32> {
    const UNSEEN: u32 = u32::MAX;
    let mesh = board.mesh();
    let mut depths = vec![UNSEEN; mesh.num_faces()];
    let (mut level, mut depth): (Vec<_>, _) = (mesh.ghosts().collect(), 0);
    while !level.is_empty() {
        let mut next = Vec::new();
        while let Some(t) = level.pop() {
            if depths[t.index()] != UNSEEN {
                continue;
            }
            depths[t.index()] = depth;
            for h in t.half_edges() {
                let way = if is_border(h) { &mut next } else { &mut level };
                way.push(mesh.twin(h).triangle());
            }
        }
        (level, depth) = (next, depth + 1);
    }
    depths
}

/// Marks what lies around the seeds of holes, up to constraints.
fn carve_holes<O: Observer>(
    board: &Board<O>,
    holes: &[Point],
    chains: &[Vec<VertexId>],
    outside: &mut [bool],
) -> Result<(), Error> {
    let mesh = board.mesh();
    if mesh.num_faces() == 0 {
        return Ok(());
    }
    for (i, &at) in holes.iter().enumerate() {
        let around: Vec<_> = match locate(mesh, board.points(), HalfEdgeId::new(0), at) {
            Location::Face(t) => {
                flood(board, t, outside);
                continue;
            }
            Location::Edge(h) => vec![h, mesh.twin(h)],
            Location::Vertex(v) => {
                let spoke = mesh.half_edges().find(|&h| mesh.origin(h) == v);
                let spoke = spoke.expect("bug: a vertex without star");
                mesh.star(spoke).collect()
            }
            _ => continue,
        };
        if let Some(segment) = first_along(board, &around, chains) {
            let seed = Seed::Hole(i);
            return Err(Error::SeedOnSegment { seed, at, segment });
        }
        let mut faces = around.iter().map(|h| h.triangle());
        if let Some(t) = faces.find(|&t| !mesh.is_ghost(t)) {
            flood(board, t, outside);
        }
    }
    Ok(())
}

/// Finds the first segment along some edges.
fn first_along<O: Observer>(
    board: &Board<O>,
    edges: &[HalfEdgeId],
    chains: &[Vec<VertexId>],
) -> Option<usize> {
    let locked = edges.iter().filter(|&&h| board.is_locked(h));
    let locked: Vec<_> = locked.map(|&h| ascending(board.ends(h))).collect();
    let is_locked = |pair: &[VertexId]| locked.contains(&ascending([pair[0], pair[1]]));
    let mut all = 0..chains.len();
    all.find(|&segment| !locked.is_empty() && chains[segment].windows(2).any(is_locked))
}

/// Marks the faces that no constraint separates from `start`, as far as they are not outside anyway.
fn flood<O: Observer>(board: &Board<O>, start: TriangleId, outside: &mut [bool]) {
    let mut stack = vec![start];
    while let Some(t) = stack.pop() {
        if board.mesh().is_ghost(t) || std::mem::replace(&mut outside[t.index()], true) {
            continue;
        }
        let open = t.half_edges().into_iter().filter(|&h| !board.is_locked(h));
        stack.extend(open.map(|h| board.mesh().twin(h).triangle()));
    }
}

/// Tells of each triangle how many edges of segments the ray from its centroid to the right crosses, and
/// what came of it.
fn tell_tests<O: Observer>(
    board: &mut Board<O>,
    chains: &[Vec<VertexId>],
    outside: &[bool],
) -> Result<(), Error> {
    if !board.is_watched() {
        return Ok(());
    }
    let uses: Vec<_> = uses(chains).into_iter().collect();
    for t in board.mesh().triangles().collect::<Vec<_>>() {
        board.spend(uses.len())?;
        let triangle = board.mesh().corners(t);
        let center = centroid(triangle.map(|v| board.point(v)));
        let crossed = uses
            .iter()
            .filter(|(edge, _)| crosses(center, edge.map(|v| board.point(v))));
        let crossings = crossed.map(|&(_, n)| n as u32).sum();
        let is_inside = !outside[t.index()];
        board.tell(|| Event::InsideTested {
            triangle,
            crossings,
            is_inside,
        });
    }
    Ok(())
}

/// Returns the centroid of a triangle, rounded.
pub(super) fn centroid([a, b, c]: [Point; 3]) -> Point {
    let third = |a: f64, b: f64, c: f64| a / 3.0 + b / 3.0 + c / 3.0;
    Point::new(third(a.x, b.x, c.x), third(a.y, b.y, c.y))
}

/// Tells whether the horizontal ray from `from` to the right crosses an edge: exactly one of its ends lies
/// strictly above.
pub(super) fn crosses(from: Point, [a, b]: [Point; 2]) -> bool {
    if (a.y > from.y) == (b.y > from.y) {
        return false;
    }
    let [low, high] = if a.y < b.y { [a, b] } else { [b, a] };
    orient2d(low, high, from) == Orientation::Left
}
