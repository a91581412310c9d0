//! Which region each triangle of a verified mesh lies in.

use super::super::{Certificate, Defects, Verifier, require_points};
use super::quality::{region_seeds, regions};
use super::{DomainMesh, DomainVerifier, input, work};
use crate::pace::Pace;
use crate::{DomainRule, Error, Phase, Pslg, Watch};

/// Does what [`verify_domain`](super::verify_domain()) does, and finds the region of each triangle: the first of
/// those whose seeds its face has.
///
/// ```
/// use delone::check::{self, DomainMesh};
/// use delone::{DomainRule, Point, Pslg, Region, VertexId};
///
/// let mut input = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)]);
/// input.add_ring([0, 1, 2]);
/// input.regions.push(Region { at: Point::new(1.0, 1.0), attribute: 7.0, max_area: None });
/// let triangles = [[0, 1, 2].map(VertexId::from)];
/// let mesh = DomainMesh::new(&input.points, &triangles, &input.segments);
/// let (_, region_of) = check::verify_regions(&input, DomainRule::Carve, &mesh, &())??;
/// assert_eq!(region_of, [Some(0)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of [`verify_domain`](super::verify_domain()), and [`Error::SeedNotFinite`] and [`Error::SeedOnSegment`]
/// for regions. A wrong mesh is no error but [`Defects`] within.
///
/// *Cost*: that of [`verify_domain`](super::verify_domain()), and a twentieth more.
#[allow(
    clippy::type_complexity,
    reason = "errors of two kinds, as elsewhere here"
)]
pub fn verify_regions(
    input: &Pslg,
    rule: DomainRule,
    mesh: &DomainMesh,
    watch: &dyn Watch,
) -> Result<Result<(Certificate, Vec<Option<usize>>), Defects>, Error> {
    let mut pace = Pace::new(watch, Phase::Check, work(input, mesh));
    input::require(input, &mut pace)?;
    require_points(mesh.points, &mut pace)?;
    let mut seeds = input.holes.clone();
    seeds.extend(region_seeds(input, &mut pace)?);
    let verifier = Verifier {
        points: mesh.points,
        triangles: mesh.triangles,
        pace,
        defects: Defects::default(),
    };
    let verifier = DomainVerifier {
        input,
        rule,
        mesh,
        verifier,
    };
    verifier.everything(&seeds, |found, pace| regions::find(found, pace))
}
