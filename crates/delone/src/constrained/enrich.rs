//! A prepared domain once more, with many vertices added at once: at the speed of the bulk builder.
//!
//! What belongs to the domain is not asked of seeds and rules again, but is what lies beside the same
//! subsegments as before.
//!
//! *Cost*: that of a triangulation.

use super::build::{Faces, Prepared, insert_noded, start};
use super::draft::Draft;
use super::lengthen::{Cuts, NO_SEGMENT};
use super::result::Lineage;
use crate::parallel::Workers;
use crate::{Error, HalfEdgeId, Point, VertexId, Watch};

/// Vertices to add. They get the numbers after those that exist, those on edges first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Additions {
    /// Constrained edges to be cut, each once, with the points between their ends, in order.
    pub cuts: Vec<([VertexId; 2], Vec<Point>)>,
    /// Points on no edge.
    pub free: Vec<Point>,
}

/// Adds vertices to a domain, or returns it as it was if one of them coincides with another, or if
/// subsegments cross because of the rounding.
///
/// # Errors
/// [`Error::TooManyPoints`], and [`Error::Cancelled`].
pub(crate) fn enrich(
    mut prepared: Prepared,
    additions: Additions,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<Prepared, Error> {
    let context = &mut prepared.context;
    let num_old = context.pslg.points.len();
    let on_edges = additions.cuts.iter().flat_map(|(_, points)| points);
    let added = on_edges.chain(&additions.free);
    context.pslg.points.extend(added);
    let (lineage, numbers) = descend(&prepared, &additions, num_old);
    let context = &mut prepared.context;
    let (mut draft, names) = start(&context.pslg.points, workers, watch)?;
    let is_new = names.duplicates == context.names.duplicates;
    let segments = &context.pslg.segments;
    let chains = &lineage.chains;
    if !(is_new && insert_noded(&mut draft, &names, segments, chains, workers, watch)?) {
        context.pslg.points.truncate(num_old);
        return Ok(prepared);
    }
    let position = |v: VertexId| names.positions[v.index()];
    let sides = Sides::of(&prepared, &additions, numbers, position);
    let (outside, region_of) = sides.spread(&draft, prepared.faces.region_of.is_empty());
    let Draft {
        points,
        mesh,
        marks,
        ..
    } = draft;
    let faces = Faces {
        mesh,
        constrained: marks.into_bytes(),
        outside,
        region_of,
    };
    let mut context = prepared.context;
    context.lineage = lineage;
    context.names = names;
    Ok(Prepared {
        points,
        faces,
        context,
    })
}

/// Finds out where everything comes from, and the number of the first vertex on each edge that is cut.
fn descend(prepared: &Prepared, additions: &Additions, num_old: usize) -> (Lineage, Vec<u32>) {
    let old = &prepared.context.lineage;
    let names = &prepared.context.names;
    let mut next = num_old as u32;
    let numbers = additions.cuts.iter().map(|(_, points)| {
        let first = next;
        next += points.len() as u32;
        first
    });
    let numbers: Vec<u32> = numbers.collect();
    let ends = additions.cuts.iter().map(|&(ends, _)| ends);
    let cuts = Cuts::new(prepared.points.len(), ends);
    let (chains, segment_of) = cuts.lengthen(
        &prepared.context.pslg.segments,
        &old.chains,
        |v| names.positions[v.index()],
        |cut, from, chain| {
            let (ends, points) = &additions.cuts[cut as usize];
            let first = numbers[cut as usize];
            let inside = (first..first + points.len() as u32).map(VertexId::from);
            match ends[0] == from[0] {
                true => chain.extend(inside),
                false => chain.extend(inside.rev()),
            }
        },
    );
    let on_edges = additions.cuts.iter().zip(segment_of);
    let on_edges = on_edges.flat_map(|((_, points), s)| std::iter::repeat_n(s, points.len()));
    let free = std::iter::repeat_n(NO_SEGMENT, additions.free.len());
    let lineage = Lineage {
        num_segments: old.num_segments,
        chains,
        crossings: old.crossings.clone(),
        steiner: old
            .steiner
            .iter()
            .copied()
            .chain(on_edges)
            .chain(free)
            .collect(),
    };
    (lineage, numbers)
}

/// For directed edges of a draft what lies to their left: whether it is outside, and the region.
struct Sides(Vec<([VertexId; 2], (bool, u32))>);

impl Sides {
    /// Reads them off a domain, for the pieces of its constrained edges.
    fn of(
        prepared: &Prepared,
        additions: &Additions,
        numbers: Vec<u32>,
        position: impl Fn(VertexId) -> VertexId,
    ) -> Self {
        let Prepared {
            faces,
            context,
            points,
        } = prepared;
        let ends = additions.cuts.iter().map(|&(ends, _)| ends);
        let cuts = Cuts::new(points.len(), ends);
        let side = |h: HalfEdgeId| {
            let t = h.triangle().index();
            let region = faces.region_of.get(t).copied().unwrap_or(0);
            (faces.outside[t], region)
        };
        let is_constrained =
            |h: &HalfEdgeId| faces.constrained[h.triangle().index()] >> h.slot() & 1 == 1;
        let mut sides = Vec::new();
        for h in faces.mesh.half_edges().filter(is_constrained) {
            let ends = [faces.mesh.origin(h), faces.mesh.dest(h)];
            let [from, to] = ends.map(|v| position(context.names.callers[v.index()]));
            // One piece tells what lies beside all of them.
            let next = match cuts.find(ends) {
                None => to,
                Some(cut) => {
                    let (given, points) = &additions.cuts[cut as usize];
                    let last = points.len() as u32 - 1;
                    let offset = if given[0] == ends[0] { 0 } else { last };
                    position(VertexId::from(numbers[cut as usize] + offset))
                }
            };
            sides.push(([from, next], side(h)));
        }
        Self(sides)
    }

    /// Floods the faces of a draft from the sides of its segments.
    fn spread(self, draft: &Draft, without_regions: bool) -> (Vec<bool>, Vec<u32>) {
        let faces = draft.mesh.num_faces();
        let mut known = vec![false; faces];
        let mut outside = vec![true; faces];
        let mut region_of = vec![0; if without_regions { 0 } else { faces }];
        let mut stack = Vec::new();
        for (ends, (is_outside, region)) in self.0 {
            let h = draft.find_edge(ends[0], ends[1]);
            let h = h.expect("bug: a piece of a segment is an edge");
            let h = match draft.mesh.origin(h) == ends[0] {
                true => h,
                false => draft.mesh.twin(h),
            };
            stack.push(h.triangle());
            while let Some(t) = stack.pop() {
                if std::mem::replace(&mut known[t.index()], true) {
                    continue;
                }
                outside[t.index()] = is_outside;
                if !without_regions {
                    region_of[t.index()] = region;
                }
                let free = t.half_edges().into_iter();
                let free = free.filter(|&h| !draft.marks.is_constrained(h));
                stack.extend(free.map(|h| draft.mesh.twin(h).triangle()));
            }
        }
        (outside, region_of)
    }
}
