//! From the input to the result in one go: triangulate the points, insert the segments, node them
//! first if they cross, carve, hand out.

use super::carve::{Carving, carve};
use super::draft::Draft;
use super::export::hand_out;
use super::insert::{Outcome, insert_all};
use super::names::Names;
use super::result::Lineage;
use super::segments::Segments;
use super::witness::Witness;
use super::{ConstrainedTriangulation, Options, Warning};
use crate::delaunay::{Curve, check_number};
use crate::parallel::Workers;
use crate::pslg::{self, Chains, Noding, input};
use crate::{DomainRule, Error, Mesh, Point, Pslg, SegmentPolicy, VertexId, Watch};

/// A domain that is triangulated and carved, in the numbering of the curve: the result but for its
/// handing out.
pub(crate) struct Prepared {
    /// Where the vertices of the faces lie.
    pub points: Vec<Point>,
    pub faces: Faces,
    pub context: Context,
}

/// Faces, in any order, and what is known of them.
pub(crate) struct Faces {
    pub mesh: Mesh,
    /// Bit k of each says whether half-edge k is constrained; higher bits mean nothing.
    pub constrained: Vec<u8>,
    /// Whether a face lies outside the domain; ghosts do.
    pub outside: Vec<bool>,
    /// For each face one more than its region, or 0; empty if there are no regions.
    pub region_of: Vec<u32>,
}

/// The input, and what leads back to it.
pub(crate) struct Context {
    pub pslg: Pslg,
    pub names: Names,
    pub lineage: Lineage,
    pub warnings: Vec<Warning>,
}

impl Prepared {
    pub(super) fn new(
        draft: Draft,
        carving: Carving,
        pslg: Pslg,
        names: Names,
        lineage: Lineage,
    ) -> Self {
        let Draft {
            points,
            mesh,
            marks,
            ..
        } = draft;
        Self {
            points,
            faces: Faces {
                mesh,
                constrained: marks.into_bytes(),
                outside: carving.outside,
                region_of: carving.region_of,
            },
            context: Context {
                pslg,
                names,
                lineage,
                warnings: carving.warnings,
            },
        }
    }

    /// Puts the result together, in the caller's numbering.
    pub fn hand_out(
        self,
        workers: Workers,
        watch: &dyn Watch,
    ) -> Result<ConstrainedTriangulation, Error> {
        hand_out(self.faces, self.context, workers, watch)
    }
}

/// Triangulates and carves a domain.
pub(crate) fn prepare(
    pslg: Pslg,
    options: Options,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<Prepared, Error> {
    prepare_before(pslg, options, workers, watch, ())
}

/// Does the same before a witness. If segments are split where they cross, that begins anew, and a witness is not
/// told: it is for those who refuse.
pub(super) fn prepare_before(
    mut pslg: Pslg,
    options: Options,
    workers: Workers,
    watch: &dyn Watch,
    witness: impl Witness,
) -> Result<Prepared, Error> {
    input::check(&pslg)?;
    let (mut draft, mut names) = start(&pslg.points, workers, watch)?;
    witness.begin(&draft, &names.callers);
    if options.domain == DomainRule::EvenOdd {
        input::require_closed(&pslg)?;
    }
    let edges = names.edges(pslg.segments.iter().copied(), workers, watch);
    let edges = edges.ok_or(Error::Cancelled)?;
    let (chains, crossings) = match insert_all(&mut draft, &edges, workers, watch, witness) {
        Outcome::Cancelled => return Err(Error::Cancelled),
        Outcome::Done(cuts) => (names.chains_of_cuts(&pslg.segments, cuts), Vec::new()),
        Outcome::Blocked => {
            drop((draft, edges));
            let noding = node(&pslg, &names, options.crossings, workers, watch)?;
            pslg.points.extend(noding.points);
            (draft, names) = start(&pslg.points, workers, watch)?;
            let chains = &noding.chains;
            let is_planar =
                insert_noded(&mut draft, &names, &pslg.segments, chains, workers, watch)?;
            assert!(is_planar, "bug: noded segments meet inside of one");
            (noding.chains, noding.crossings)
        }
    };
    let segments = Segments {
        ends: &pslg.segments,
        chains: &chains,
        polygons: &pslg.polygons,
        positions: &names.positions,
    };
    let seeds = (&pslg.holes[..], &pslg.regions[..]);
    let carving = carve(&draft, options.domain, &segments, seeds, watch, witness)?;
    let lineage = Lineage {
        num_segments: pslg.segments.len(),
        chains,
        crossings,
        steiner: Vec::new(),
    };
    Ok(Prepared::new(draft, carving, pslg, names, lineage))
}

/// Triangulates the points, with nothing constrained yet.
pub(super) fn start(
    points: &[Point],
    workers: Workers,
    watch: &dyn Watch,
) -> Result<(Draft, Names), Error> {
    check_number(points.len())?;
    if points.is_empty() {
        return Ok((Draft::new(Vec::new(), Mesh::default()), Names::default()));
    }
    let curve = Curve::build(points, workers, watch)?.into_parts();
    let names = Names::of(&curve);
    Ok((Draft::new(curve.points, curve.mesh), names))
}

/// Cuts the segments of positive length where they cross, or refuses to.
fn node(
    pslg: &Pslg,
    names: &Names,
    policy: SegmentPolicy,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<Noding, Error> {
    let vertices = names.vertices();
    let ends = pslg.segments.iter();
    let ends: Vec<_> = ends
        .map(|ends| ends.map(|v| names.representative(v)))
        .collect();
    let proper: Vec<usize> = (0..ends.len())
        .filter(|&i| ends[i][0] != ends[i][1])
        .collect();
    let segments: Vec<[VertexId; 2]> = proper.iter().map(|&i| ends[i]).collect();
    match policy {
        SegmentPolicy::Error => {
            let found = pslg::first_crossing(&pslg.points, &vertices, &segments, workers, watch);
            let crossing = found.ok_or(Error::Cancelled)?;
            let (pair, at) = crossing.expect("bug: a segment was blocked by none that it crosses");
            let segments = pair.map(|i| proper[i]);
            Err(Error::Crossing { segments, at })
        }
        SegmentPolicy::Split => {
            let noding = pslg::node(&pslg.points, &vertices, &segments, workers, watch);
            let noding = noding.ok_or(Error::Cancelled)?;
            Ok(in_terms_of_all(noding, &proper, names, &pslg.segments))
        }
    }
}

/// Renumbers the segments of a noding, which knows those of positive length only.
fn in_terms_of_all(
    noding: Noding,
    proper: &[usize],
    names: &Names,
    segments: &[[VertexId; 2]],
) -> Noding {
    let mut cut = noding.chains.iter().peekable();
    let chains = names.chains(segments, |segment, _| {
        let of_this = cut.next_if(|&(i, _)| proper[i] == segment);
        of_this.map_or_else(Vec::new, |(_, chain)| chain[1..chain.len() - 1].to_vec())
    });
    let crossings = noding.crossings.iter();
    let crossings = crossings.map(|pair| pair.map(|i| proper[i as usize] as u32));
    Noding {
        crossings: crossings.collect(),
        chains,
        points: noding.points,
    }
}

/// Inserts segments that meet only at shared ends; false if they do not.
pub(super) fn insert_noded(
    draft: &mut Draft,
    names: &Names,
    segments: &[[VertexId; 2]],
    chains: &Chains,
    workers: Workers,
    watch: &dyn Watch,
) -> Result<bool, Error> {
    let chain = |(i, ends)| chains.get(i).unwrap_or(ends);
    let all = segments.iter().enumerate().map(|(i, ends)| (i, &ends[..]));
    let edges = all
        .flat_map(|segment| chain(segment).windows(2))
        .map(|pair| [pair[0], pair[1]]);
    let edges = names.edges(edges, workers, watch).ok_or(Error::Cancelled)?;
    match insert_all(draft, &edges, workers, watch, ()) {
        Outcome::Cancelled => Err(Error::Cancelled),
        Outcome::Done(cuts) => Ok(cuts.is_empty()),
        Outcome::Blocked => Ok(false),
    }
}
