//! The domain that a mesh is checked against.

use super::bounds::Bounds;
use crate::domain::Rule;
use crate::exit::Failure;
use crate::numbering::Numbering;
use crate::progress::Progress;
use delone::check::{DomainMesh, QualityVerdict, Verdict, verify_domain, verify_quality};
use delone::{
    ConstrainedDelaunay, ConstrainedTriangulation, Error, Point, Pslg, SegmentPolicy, SizingField,
    VertexId,
};
use delone_io::{DomainData, MeshData, Source};
use std::borrow::Cow;

/// What a verification has found.
pub struct Findings {
    /// Whether the mesh is right.
    pub verdict: Verdict,
    /// How good it is, if that was asked and it is right.
    pub quality: Option<QualityVerdict>,
}

impl From<Verdict> for Findings {
    fn from(verdict: Verdict) -> Self {
        Self {
            verdict,
            quality: None,
        }
    }
}

impl From<QualityVerdict> for Findings {
    fn from(quality: QualityVerdict) -> Self {
        Self {
            verdict: Verdict::Right(quality.certificate),
            quality: Some(quality),
        }
    }
}

/// A domain, and what it means.
pub struct Drawing {
    /// Where it comes from.
    pub file: String,
    /// What of it should be covered.
    pub rule: Rule,
    /// Whether it counts from 1.
    pub is_one_based: bool,
    /// How large triangles may be, if that depends on the place.
    sizes: Option<Box<dyn SizingField>>,
    pslg: Pslg,
    numbering: Numbering,
}

impl Drawing {
    /// Takes a domain, with its usual rule unless there is another one, and the sizes in it.
    pub fn new(
        source: &Source,
        mut domain: DomainData,
        rule: Option<Rule>,
        sizes: Option<Box<dyn SizingField>>,
    ) -> Self {
        let file = source.to_string();
        Self {
            rule: rule.unwrap_or(domain.usual_rule.into()),
            is_one_based: domain.vertices.base == 1,
            numbering: Numbering::of(&file, &domain),
            sizes,
            pslg: domain.take_pslg(),
            file,
        }
    }

    /// Verifies that `mesh` is the triangulation of this domain, or a refined mesh within bounds.
    pub fn verify(
        &self,
        mesh: &MeshData,
        bounds: &Bounds,
        progress: &Progress,
    ) -> Result<Findings, Failure> {
        let edges = self.subsegments(mesh, bounds.is_refined())?;
        let points = &mesh.vertices.points;
        let claim = DomainMesh::new(points, &mesh.triangles, &edges);
        if bounds.is_refined() {
            return self.verify_refined(&claim.refined(), bounds, progress);
        }
        let lineage = self.lineage(points, progress);
        let verdict = match &lineage {
            Some(t) => {
                let chains = |segment| t.chain(segment);
                self.verify_plain(&claim.with_chains(&chains), progress)
            }
            None => self.verify_plain(&claim, progress),
        };
        verdict.map(Findings::from)
    }

    fn verify_plain(&self, claim: &DomainMesh, progress: &Progress) -> Result<Verdict, Failure> {
        verify_domain(&self.pslg, self.rule.into(), claim, progress)
            .map_err(|error| self.numbering.failure(error))
    }

    fn verify_refined(
        &self,
        claim: &DomainMesh,
        bounds: &Bounds,
        progress: &Progress,
    ) -> Result<Findings, Failure> {
        let Some(asked) = bounds.asked() else {
            return self.verify_plain(claim, progress).map(Findings::from);
        };
        let sizes = self.sizes.as_deref();
        let sizes = sizes.map(|field| move |p: Point| [field.max_edge(p), field.max_area(p)]);
        let asked = match &sizes {
            Some(sizes) => asked.sizes(sizes),
            None => asked,
        };
        match verify_quality(&self.pslg, self.rule.into(), claim, &asked, progress) {
            Ok(Ok(quality)) => Ok(quality.into()),
            Ok(Err(defects)) => Ok(Verdict::Wrong(defects).into()),
            Err(error @ Error::BadQuality { .. }) => Err(Failure::Usage(error.to_string())),
            Err(error) => Err(self.numbering.failure(error)),
        }
    }

    /// Returns the constrained edges of a mesh.
    ///
    /// A format without them will do if nothing was drawn: of refined points alone, only the hull is made
    /// of segments, and that is where triangles end.
    fn subsegments<'m>(
        &self,
        mesh: &'m MeshData,
        is_refined: bool,
    ) -> Result<Cow<'m, [[VertexId; 2]]>, Failure> {
        match &mesh.constraints {
            Some(constraints) => Ok(Cow::Borrowed(&constraints.edges)),
            None if !self.pslg.segments.is_empty() => Err(Failure::BadInput(
                "the mesh holds no segments, so it cannot be checked against a domain; name one as \
                 .ele with its .poly, or as .vtu"
                    .to_owned(),
            )),
            None if is_refined => Ok(Cow::Owned(border(&mesh.triangles))),
            None => Ok(Cow::default()),
        }
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

/// Lists the edges that one triangle has.
fn border(triangles: &[[VertexId; 3]]) -> Vec<[VertexId; 2]> {
    let edges =
        |&[a, b, c]: &[VertexId; 3]| [[a, b], [b, c], [c, a]].map(|[v, w]| [v.min(w), v.max(w)]);
    let mut edges: Vec<_> = triangles.iter().flat_map(edges).collect();
    edges.sort_unstable();
    let alone = edges
        .chunk_by(|e, f| e == f)
        .filter(|group| group.len() == 1);
    alone.map(|group| group[0]).collect()
}
