//! Cline and Renka's triangulation, as chapter 3.19 to 3.21 gives it: start, locate, extend, optimise.
//!
//! The text keeps for each vertex a list of its neighbours; [`lists`] reads these off the half-edge
//! mesh. Its swap test compares minimum angles, which is the test of the circle; ties are decided by the
//! perturbation.

mod lists;
mod search;

use super::{About, Board, Input, Output, Takes};
use crate::locate::Location;
use crate::predicates::Orientation;
use crate::{Error, Event, HalfEdgeId, Observer, VertexId};
use lists::List;
use search::Place;

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "cline-renka",
    title: "Cline–Renka",
    source: "Diploma thesis, Duisburg, about 1998, algorithms 3.19 to 3.21; Cline and Renka 1984",
    idea: "Point by point, with lists of neighbours alone: rotate about the first vertex until the new point \
           lies between two neighbours, walk towards it, join it, and swap edges around it.",
    cost: "O(n²) at worst; a walk always begins at the first vertex, some √n triangles away",
    guarantees: "the canonical Delaunay triangulation, after every point",
    takes: Takes::Points,
    is_delaunay: true,
    code: &[
        "j := the smallest number such that t_1 … t_j are not collinear",
        "join t_j to each two neighbours in the row t_1 … t_{j-1}",
        "for each further point t:",
        "  δ := 1",
        "  ε, λ := first and last neighbour of δ",
        "  δ on the boundary: if t is right of δ→ε: (α,β) := (δ,ε), outside; of λ→δ: (α,β) := (λ,δ), outside",
        "  β := a neighbour of δ with t right of δ→β; without one δ := k with [k,λ,δ], and again",
        "  α := k with [k,β,δ]; while t is right of δ→α: β := α, and again",
        "  γ := δ; while t is right of α→β:",
        "    if αβ is outer: outside",
        "    κ := k with [κ,β,α]; t left of δ→κ: γ := α, α := κ; else γ := β, β := κ",
        "  t on an outer edge γα or αβ: (α,β) := that edge, on the boundary",
        "  outside: while t is right of β→first(β): β := first(β)",
        "  outside: while t is right of last(α)→α: α := last(α)",
        "  join t: outside to α … β, on an edge to four or three vertices, inside to three",
        "  for each edge αβ opposite to t, counter-clockwise:",
        "    while it is inner and swapping it makes the least angle larger: swap it, β := the vertex behind",
    ],
};

/// Lines of the pseudocode.
mod line {
    pub const START: u16 = 1;
    pub const FAN: u16 = 2;
    pub const POINT: u16 = 3;
    pub const LISTS: u16 = 5;
    pub const BOUNDARY: u16 = 6;
    pub const NEIGHBOUR: u16 = 7;
    pub const ROTATE: u16 = 8;
    pub const WALK: u16 = 9;
    pub const CROSS: u16 = 11;
    pub const BORDER: u16 = 12;
    pub const ONWARDS: u16 = 13;
    pub const BACKWARDS: u16 = 14;
    pub const JOIN: u16 = 15;
    pub const OPPOSITE: u16 = 16;
    pub const SWAP: u16 = 17;
}

/// Inserts the points in the given order.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let (mut board, order) = Board::new(input, observer)?;
    let rest = start(&mut board, &order)?;
    for &t in rest {
        board.step()?;
        board.at(line::POINT);
        board.tell(|| Event::PointConsidered { vertex: t });
        let place = search::locate(&mut board, order[0], t);
        extend(&mut board, place, t);
        optimise(&mut board, t);
    }
    Ok(board.finish())
}

/// Algorithm 3.19: joins the first point off the line of those before it to all of them. Returns the points
/// that are left.
fn start<'a, O: Observer>(
    board: &mut Board<O>,
    order: &'a [VertexId],
) -> Result<&'a [VertexId], Error> {
    board.at(line::START);
    let (row, rest) = board.first_row(order)?;
    board.lay_row(&row);
    let Some((&t, rest)) = rest.split_first() else {
        return Ok(&[]);
    };
    board.at(line::FAN);
    let [a, b] = [row[0], row[1]];
    let is_left = board.orient(a, b, t) == Orientation::Left;
    let ghost = if is_left { [a, b] } else { [b, a] };
    let outer = board
        .edge(ghost)
        .expect("bug: neighbours in a row are joined");
    board.join(Location::Outside(outer), t);
    Ok(rest)
}

/// Joins a vertex where it was found to lie.
fn extend<O: Observer>(board: &mut Board<O>, place: Place, t: VertexId) {
    board.at(line::JOIN);
    match place {
        Place::Inside(h) => {
            let at = within(board, h, t);
            board.join(at, t);
        }
        Place::Boundary(h) => {
            board.join(Location::Edge(h), t);
        }
        Place::Outside(h, chain) => {
            let ghost = board.mesh().twin(h);
            board.join_chain(ghost, t, chain);
        }
    }
}

/// The triangle of `h`, in which `t` lies, or one of its edges.
fn within<O: Observer>(board: &mut Board<O>, h: HalfEdgeId, t: VertexId) -> Location {
    for side in [h, h.next(), h.prev()] {
        let [a, b] = board.ends(side);
        if board.orient(a, b, t) == Orientation::Collinear {
            return Location::Edge(side);
        }
    }
    Location::Face(h.triangle())
}

/// Algorithm 3.21: goes around `t` and swaps what is opposite to it, as long as that helps.
fn optimise<O: Observer>(board: &mut Board<O>, t: VertexId) {
    let List {
        first,
        last,
        is_boundary,
    } = lists::list(board, t);
    let mut spoke = first;
    loop {
        // αβ, in the triangle [β, t, α]. A swap makes it α and the vertex behind.
        let opposite = spoke.next();
        board.at(line::OPPOSITE);
        while !board.is_locally_delaunay(opposite) {
            board.at(line::SWAP);
            board.flip(opposite);
        }
        spoke = board.mesh().onext(spoke);
        if spoke == if is_boundary { last } else { first } {
            return;
        }
    }
}
