//! The domain that a mesh is checked against.

use crate::domain::Rule;
use crate::exit::Failure;
use crate::numbering::Numbering;
use crate::progress::Progress;
use delone::check::{DomainMesh, Verdict, verify_domain};
use delone::{DomainRule, Pslg};
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
        let edges = mesh.constraints.as_ref().map_or(&[][..], |c| &c.edges);
        let claim = DomainMesh::new(&mesh.vertices.points, &mesh.triangles, edges);
        verify_domain(&self.pslg, DomainRule::from(self.rule), &claim, progress)
            .map_err(|error| self.numbering.failure(error))
    }
}
