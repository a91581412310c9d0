//! Sites that all lie on one line: their lower convex hull, by one pass from end to end.

use super::order::Sites;
use crate::pace::Pace;
use crate::predicates::in_power_segment_perturbed;
use crate::{Error, Mesh, VertexId};

/// Makes the mesh of at least one site, all on one line.
///
/// *Cost*: O(n log n).
pub(super) fn build(sites: &Sites, pace: &mut Pace<'_>) -> Result<Mesh, Error> {
    let mut order: Vec<VertexId> = (0..sites.points.len()).map(VertexId::new).collect();
    order.sort_unstable_by(|&i, &j| sites.points[i.index()].lex_cmp(&sites.points[j.index()]));
    let mut chain: Vec<VertexId> = Vec::new();
    for v in order {
        pace.step()?;
        while let [.., a, b] = chain[..] {
            let [a, b, c] = [a, b, v].map(|v| sites.site(v));
            if in_power_segment_perturbed(a, c, b) {
                break;
            }
            chain.pop();
        }
        chain.push(v);
    }
    Ok(strung(&chain))
}

/// Strings vertices up in a row.
fn strung(chain: &[VertexId]) -> Mesh {
    let mut mesh = Mesh::default();
    if let [a, b, rest @ ..] = chain {
        // From the last vertex to infinity.
        let mut end = mesh.seed(*a, *b).next();
        for &v in rest {
            let [from_infinity, _] = mesh.open_edge(end, v);
            end = from_infinity.prev();
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_a_sphere_with_its_edges_in_order() {
        for n in 0..6 {
            let chain: Vec<_> = (0..n).map(VertexId::new).collect();
            let mesh = strung(&chain);
            assert_eq!(mesh.num_faces(), if n < 2 { 0 } else { 2 * n - 2 });
            mesh.validate().expect("a sphere");
            let finite = mesh.half_edges().map(|h| [mesh.origin(h), mesh.dest(h)]);
            let edges = finite.filter(|e| e.iter().all(|v| !v.is_infinite()));
            assert!(
                edges
                    .into_iter()
                    .all(|[a, b]| a.index().abs_diff(b.index()) == 1)
            );
        }
    }
}
