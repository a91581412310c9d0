//! The part of a mesh that lies in some of its regions.

use crate::exit::Failure;
use crate::words::list;
use delone::VertexId;
use delone_io::{Attribute, Constraints, Lines, MeshData, PointSet};
use std::collections::BTreeSet;

/// The attributes of triangles that tell regions, the first that there is: numbers of regions, or what Triangle writes.
const NAMES: [&str; 4] = ["region", "ref", "attribute", "attribute1"];

/// Most regions that an error lists.
const LISTED: usize = 20;

/// Keeps the triangles of regions, with their corners, their data, and the constrained edges among their sides.
///
/// *Cost*: O(n log n) for n triangles.
pub fn restrict(mesh: MeshData, wanted: &[f64], file: &str) -> Result<MeshData, Failure> {
    let mut attributes = NAMES.iter().filter_map(|name| {
        let mut all = mesh.triangle_attributes.iter();
        all.find(|a| a.name == *name)
    });
    let Some(regions) = attributes.next() else {
        return Err(Failure::Usage(format!(
            "--region: {file} brings no triangles that have regions"
        )));
    };
    require_there(wanted, regions, file)?;
    let keeps: Vec<bool> = regions.values.iter().map(|r| wanted.contains(r)).collect();
    Ok(Cut::new(mesh, keeps).mesh())
}

/// Requires that every region wanted has triangles.
fn require_there(wanted: &[f64], regions: &Attribute, file: &str) -> Result<(), Failure> {
    let Some(missing) = wanted.iter().find(|w| !regions.values.contains(w)) else {
        return Ok(());
    };
    let mut there: Vec<f64> = regions.values.clone();
    there.sort_by(f64::total_cmp);
    there.dedup();
    let mut names: Vec<String> = there.iter().take(LISTED).map(f64::to_string).collect();
    if there.len() > LISTED {
        names.push(format!("{} more", there.len() - LISTED));
    }
    let there = list(&names);
    Err(Failure::Usage(format!(
        "--region: {file} has no region {missing}; there are {there}"
    )))
}

/// A mesh, and what is kept of it.
struct Cut {
    mesh: MeshData,
    keeps_triangle: Vec<bool>,
    /// For each vertex its new number, if it is kept.
    numbers: Vec<Option<usize>>,
}

impl Cut {
    fn new(mesh: MeshData, keeps_triangle: Vec<bool>) -> Self {
        let mut is_used = vec![false; mesh.vertices.points.len()];
        let triangles = mesh.triangles.iter().zip(&keeps_triangle);
        for (corners, _) in triangles.filter(|(_, keeps)| **keeps) {
            corners.iter().for_each(|v| is_used[v.index()] = true);
        }
        let mut next = 0..;
        let numbers = is_used.into_iter();
        let numbers = numbers.map(|used| used.then(|| next.next()).flatten());
        Self {
            numbers: numbers.collect(),
            mesh,
            keeps_triangle,
        }
    }

    fn mesh(self) -> MeshData {
        let of_triangles = |i: usize| self.keeps_triangle[i];
        let of_vertices = |i: usize| self.numbers[i].is_some();
        let MeshData {
            vertices,
            triangles,
            triangle_attributes,
            constraints,
            quadratic,
        } = self.mesh;
        let number = |v: VertexId| self.numbers[v.index()].map(VertexId::new);
        let all = |corners: [VertexId; 3]| -> Option<[VertexId; 3]> {
            let [a, b, c] = corners.map(number);
            Some([a?, b?, c?])
        };
        let triangles = pick(triangles, of_triangles);
        let triangles: Vec<_> = triangles.into_iter().filter_map(all).collect();
        let constraints = constraints.map(|constraints| {
            let edges = constraints
                .edges
                .iter()
                .map(|&[a, b]| Some([number(a)?, number(b)?]));
            let sides = sides(&triangles);
            let edges: Vec<_> = edges
                .map(|edge| edge.filter(|&[a, b]| sides.contains(&[a.min(b), a.max(b)])))
                .collect();
            let is_side = |e: usize| edges[e].is_some();
            let region_of = constraints.region_of;
            Constraints {
                markers: constraints.markers.map(|markers| pick(markers, is_side)),
                edges: edges.iter().copied().flatten().collect(),
                region_of: region_of.map(|regions| pick(regions, of_triangles)),
                crossings: 0..0,
                ..constraints
            }
        });
        let pick_all = |attributes: Vec<Attribute>, keeps: &dyn Fn(usize) -> bool| {
            let picked = attributes.into_iter().map(|a| Attribute {
                values: pick(a.values, keeps),
                ..a
            });
            picked.collect()
        };
        MeshData {
            triangle_attributes: pick_all(triangle_attributes, &of_triangles),
            triangles,
            constraints,
            quadratic,
            vertices: PointSet {
                points: pick(vertices.points, of_vertices),
                attributes: pick_all(vertices.attributes, &of_vertices),
                markers: vertices.markers.map(|markers| pick(markers, of_vertices)),
                // Vertices have other numbers than in the file.
                lines: Lines::default(),
                ..vertices
            },
        }
    }
}

fn sides(triangles: &[[VertexId; 3]]) -> BTreeSet<[VertexId; 2]> {
    let edges = |&[a, b, c]: &[VertexId; 3]| [[a, b], [b, c], [c, a]];
    let edges = triangles.iter().flat_map(edges);
    edges.map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

fn pick<T>(values: Vec<T>, keeps: impl Fn(usize) -> bool) -> Vec<T> {
    let all = values.into_iter().enumerate();
    all.filter(|&(i, _)| keeps(i))
        .map(|(_, value)| value)
        .collect()
}
