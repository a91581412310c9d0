//! The domain that a mesh is checked against.

use crate::domain::Rule;
use crate::exit::Failure;
use crate::numbering::Numbering;
use crate::progress::Progress;
use delone::check::{DomainMesh, Verdict, verify_domain};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Point, Pslg, SegmentPolicy,
};
use delone_io::{DomainData, MeshData, Source};

/// A domain, and what it means.
pub struct Drawing {
    /// Where it comes from.
    pub file: String,
    /// What of it should be covered.
    pub rule: Rule,
    pslg: Pslg,
    numbering: Numbering,
}

impl Drawing {
    /// Takes a domain, with its usual rule unless there is another one.
    pub fn new(source: &Source, mut domain: DomainData, rule: Option<Rule>) -> Self {
        let file = source.to_string();
        Self {
            rule: rule.unwrap_or(domain.usual_rule.into()),
            numbering: Numbering::of(&file, &domain),
            pslg: domain.take_pslg(),
            file,
        }
    }

    /// Verifies that `mesh` is the triangulation of this domain.
    pub fn verify(&self, mesh: &MeshData, progress: &Progress) -> Result<Verdict, Failure> {
        let edges = mesh.constraints.as_ref().map(|c| &c.edges[..]);
        if edges.is_none() && !self.pslg.segments.is_empty() {
            return Err(Failure::BadInput(
                "the mesh holds no segments, so it cannot be checked against a domain; name one as \
                 .ele with its .poly, or as .vtu"
                    .to_owned(),
            ));
        }
        let (points, rule) = (&mesh.vertices.points, DomainRule::from(self.rule));
        let claim = DomainMesh::new(points, &mesh.triangles, edges.unwrap_or_default());
        let lineage = self.lineage(points, progress);
        let verdict = match &lineage {
            Some(t) => {
                let chains = |segment| t.chain(segment);
                verify_domain(&self.pslg, rule, &claim.with_chains(&chains), progress)
            }
            None => verify_domain(&self.pslg, rule, &claim, progress),
        };
        verdict.map_err(|error| self.numbering.failure(error))
    }

    /// Makes up for the chains of segments, which no file holds: where segments run side by side within
    /// rounding, several chains fit. The verifier trusts these no more than the rest of the claim.
    fn lineage(&self, points: &[Point], progress: &Progress) -> Option<ConstrainedTriangulation> {
        if points.len() == self.pslg.points.len() {
            return None;
        }
        let builder = ConstrainedDelaunay::new().crossings(SegmentPolicy::Split);
        let t = builder
            .watch(progress)
            .triangulate(self.pslg.clone())
            .ok()?;
        (t.triangulation().points() == points).then_some(t)
    }
}
