//! `edge_flip` of the thesis: from any triangulation to the constrained Delaunay one, the edge of the lowest
//! number first.
//!
//! The mesh lies in the thesis' [tables](crate::tables), whose numbers decide the order: edges by their
//! smaller end, then by their larger; what a flip makes takes over the number of what it replaces.
//!
//! *Corrected*: the thesis leaves four points on a circle as they are, so its result depends on the order;
//! here the perturbation decides. And constraints may lie within the domain, not only around it.

use super::{About, Board, Input, Output, Takes};
use crate::pace::Pace;
use crate::tables::{FlipLines, Marks, Tables, Teller, examine};
use crate::{Error, Observer, Phase, VertexId};

/// What there is to say of it.
pub(super) const ABOUT: About = About {
    name: "edge-flip",
    title: "edge flips from marked edges",
    source: "Thesis on constrained Delaunay triangulation and refinement, Ulm 2012; Lawson 1977",
    idea: "Every edge may be wrong. Flip it if it is, and look again at the four edges around it.",
    cost: "O(n²) flips at worst, O(log n) each; far fewer from a good start",
    guarantees: "the canonical (constrained) Delaunay triangulation",
    takes: Takes::Triangulation,
    is_delaunay: true,
    code: &[
        "number the edges by their smaller, then by their larger end; mark them all",
        "while an edge is marked:",
        "  AB := the marked edge of the lowest number, A the larger end; unmark it",
        "  if AB is no constraint, and D beyond it lies inside the circle of ABC:",
        "    put CD in the place of AB; mark BC, CA, AD and DB",
    ],
};

/// Which lines flip.
const LINES: FlipLines = FlipLines {
    take: 3,
    examine: 4,
    flip: 5,
};

/// Flips until every edge is locally Delaunay.
pub(super) fn run(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let mut board = Board::begin(input, observer)?;
    let mut tables = tables_of(&board, &input.start);
    let names = (0..board.points().len()).map(VertexId::new).collect();
    let mut pace = Pace::new(input.watch, Phase::Triangulate, tables.rows.len() as u64);
    let mut teller = Teller::new(names, board.observer());
    let mut marks = Marks::default();
    teller.at(1);
    marks.add(0..tables.rows.len() as u32, &tables, &mut teller);
    while examine(&mut tables, &mut marks, &mut teller, LINES) {
        pace.step()?;
    }
    let triangles = tables.triangles.iter();
    let triangles = triangles.map(|&corners| teller.names().of(corners));
    Ok(Output {
        triangles: triangles.collect(),
        ..board.finish()
    })
}

/// Numbers vertices as the input does, and triangles as `start` does, if there is one.
fn tables_of<O: Observer>(board: &Board<O>, start: &[[VertexId; 3]]) -> Tables {
    let triangles: Vec<_> = match start {
        [] => board.triangles().collect(),
        given => given.to_vec(),
    };
    let number = |v: VertexId| board.representative(v).raw();
    let triangles = triangles.iter().map(|t| t.map(number)).collect();
    let is_constraint = |ends: [u32; 2]| {
        let [high, low] = ends.map(|v| VertexId::new(v as usize));
        board.locked().contains(&[low, high])
    };
    Tables::new(board.points().to_vec(), triangles, is_constraint)
}
