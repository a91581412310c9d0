//! Edges of triangles, each once, without a table of neighbours.
//!
//! An edge between two triangles is met from both sides; it counts where it ascends. Edges that have one
//! triangle only must be told from the others: at a vertex all around which there are triangles, every
//! edge that comes in goes out again, so a balance of the other ends comes to zero. Where it does not,
//! the vertex is on the border, and only edges between two such vertices have to be sorted.
//!
//! *Cost*: linear, but for the sorting of edges between vertices of the border.

use crate::VertexId;

/// An edge that has a triangle on its left.
type Directed = [VertexId; 2];

/// Visits the directed sides of a triangle, each opposite corner 0, 1, 2.
pub(super) fn sides([a, b, c]: [VertexId; 3]) -> [Directed; 3] {
    [[b, c], [c, a], [a, b]]
}

/// Tells from which of its sides an edge counts, provided that it has two.
pub(super) fn ascends([from, to]: Directed) -> bool {
    from < to
}

/// Finds the edges that do not ascend and have no triangle on the other side.
pub(super) fn lonely(num_points: usize, triangles: &[[VertexId; 3]]) -> Vec<Directed> {
    let balance = balances(num_points, triangles);
    let on_border = |v: VertexId| balance[v.index()] != 0;
    let mut border: Vec<Directed> = Vec::new();
    for &triangle in triangles {
        let [a, b, c] = triangle.map(on_border);
        if u8::from(a) + u8::from(b) + u8::from(c) < 2 {
            continue;
        }
        let both = [b && c, c && a, a && b];
        let sides = sides(triangle).into_iter().zip(both);
        border.extend(sides.filter(|side| side.1).map(|side| side.0));
    }
    border.sort_unstable_by_key(undirected);
    let edges = border.chunk_by(|a, b| undirected(a) == undirected(b));
    let lonely = edges.filter(|sides| !sides.iter().any(|&side| ascends(side)));
    lonely.map(|sides| sides[0]).collect()
}

/// Sums up the other ends of the edges of each vertex: those that go out, less those that come in.
fn balances(num_points: usize, triangles: &[[VertexId; 3]]) -> Vec<u64> {
    let mut balance = vec![0u64; num_points];
    for &triangle in triangles {
        let [a, b, c] = triangle.map(|v| scattered(v.index() as u64));
        for (v, out, back) in [
            (triangle[0], b, c),
            (triangle[1], c, a),
            (triangle[2], a, b),
        ] {
            let sum = &mut balance[v.index()];
            *sum = sum.wrapping_add(out).wrapping_sub(back);
        }
    }
    balance
}

/// Scatters a number over 64 bits: sums of a few of them do not cancel by accident.
fn scattered(number: u64) -> u64 {
    let mixed = (number + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed ^ mixed >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93)
}

fn undirected(&[a, b]: &Directed) -> Directed {
    [a.min(b), a.max(b)]
}
