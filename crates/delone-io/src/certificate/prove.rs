//! What the verifier says about a mesh: from points, triangles and constrained edges alone.

use super::AskedFor;
use crate::Error;
use delone::check::{
    self, Asked, Below, Certificate, Defects, DomainMesh, LocalTests, QualityVerdict, Statistics,
    Verdict,
};
use delone::{DomainRule, Point, Pslg, SizingField, VertexId, Watch};

/// A mesh, and what it is said to be.
#[derive(Clone, Copy)]
pub struct Claim<'a> {
    /// What was drawn.
    pub input: &'a Pslg,
    /// Which triangles belong to it; `None` for bare points.
    pub rule: Option<DomainRule>,
    /// The points: those of the input, and behind them those that were added.
    pub points: &'a [Point],
    /// The triangles.
    pub triangles: &'a [[VertexId; 3]],
    /// The constrained edges, those outside the domain included.
    pub edges: &'a [[VertexId; 2]],
    /// The vertices along each segment, if they are known.
    pub chains: Option<&'a [Vec<VertexId>]>,
    /// Whether there may be Steiner points.
    pub is_refined: bool,
    /// What was asked of the triangles, if anything was.
    pub asked: Option<&'a AskedFor>,
    /// How large triangles may be, place by place.
    pub sizes: Option<&'a dyn SizingField>,
}

/// What has been proven.
#[derive(Clone, Debug)]
pub struct Proof {
    pub(super) certificate: Certificate,
    /// How good the mesh is, if that was asked.
    pub quality: Option<QualityVerdict>,
    /// The region of each triangle, if there are regions.
    pub regions: Option<Vec<Option<usize>>>,
    pub(super) tests: LocalTests,
    pub(super) statistics: Statistics,
    pub(super) below: Option<Below>,
}

impl Proof {
    /// Returns the numbers of the verifier.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }
}

/// Why there is no proof.
type NoProof = Vec<String>;

/// Proves a claim, or says in words what is wrong with it.
///
/// # Errors
/// What the verifier finds wrong with the input, and cancelling; of the words of `asked`, [`Error::BadMesh`].
///
/// *Cost*: a few seconds for a million points or triangles on one thread; twice that if there are regions and
/// bounds.
pub fn prove(claim: &Claim<'_>, watch: &dyn Watch) -> Result<Result<Proof, NoProof>, ProveError> {
    let (certificate, quality, regions) = match claim.rule {
        None => match points_alone(claim, watch)? {
            Ok(certificate) => (certificate, None, None),
            Err(wrong) => return Ok(Err(wrong)),
        },
        Some(rule) => match domain(claim, rule, watch)? {
            Ok(found) => found,
            Err(defects) => return Ok(Err(in_words(&defects))),
        },
    };
    let (points, triangles) = (claim.points, claim.triangles);
    let bound = claim.asked.and_then(|asked| asked.quality().min_angle);
    Ok(Ok(Proof {
        certificate,
        quality,
        regions,
        tests: check::count_stages(points, triangles, claim.edges, watch)?,
        statistics: check::statistics(points, triangles),
        below: bound
            .map(|bound| check::count_below(points, triangles, bound, watch))
            .transpose()?,
    }))
}

/// Why nothing could be proven or disproven.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ProveError {
    /// The input makes no sense, or the watch cancels.
    #[error(transparent)]
    Input(#[from] delone::Error),
    /// What was asked makes no sense.
    #[error(transparent)]
    Asked(#[from] Error),
}

/// Proves that a mesh is the Delaunay triangulation of points, which are those of the input one by one.
fn points_alone(
    claim: &Claim<'_>,
    watch: &dyn Watch,
) -> Result<Result<Certificate, NoProof>, delone::Error> {
    let input = claim.input;
    if input.segments.len() + input.holes.len() + input.regions.len() > 0 {
        let words = "the input is more than points, so there is a domain";
        return Ok(Err(vec![words.to_owned()]));
    }
    let (given, expected) = (claim.points, &input.points);
    if given.len() != expected.len() {
        let [given, expected] = [given, expected].map(<[Point]>::len);
        return Ok(Err(vec![format!(
            "{given} points instead of the {expected} of the input"
        )]));
    }
    let moved = given.iter().zip(expected).enumerate();
    let moved = moved.filter(|(_, (p, q))| p != q).map(|(i, (p, q))| {
        format!(
            "point {i} is at ({:?}, {:?}) instead of ({:?}, {:?})",
            p.x, p.y, q.x, q.y
        )
    });
    let moved: Vec<String> = moved.take(MOST_NAMED).collect();
    if !moved.is_empty() {
        return Ok(Err(moved));
    }
    Ok(match check::verify(given, claim.triangles, watch)? {
        Verdict::Right(certificate) => Ok(certificate),
        Verdict::Wrong(defects) => Err(in_words(&defects)),
    })
}

/// Most defects of one kind that are put into words.
const MOST_NAMED: usize = 8;

type OfDomain = (
    Certificate,
    Option<QualityVerdict>,
    Option<Vec<Option<usize>>>,
);

fn domain(
    claim: &Claim<'_>,
    rule: DomainRule,
    watch: &dyn Watch,
) -> Result<Result<OfDomain, Defects>, ProveError> {
    let mesh = DomainMesh::new(claim.points, claim.triangles, claim.edges);
    let mesh = if claim.is_refined {
        mesh.refined()
    } else {
        mesh
    };
    let chain = |segment: usize| claim.chains.map_or(&[][..], |chains| &chains[segment][..]);
    let mesh = match claim.chains {
        Some(chains) if chains.len() == claim.input.segments.len() => mesh.with_chains(&chain),
        _ => mesh,
    };
    let (mut certificate, mut quality, mut regions) = (None, None, None);
    if let Some(asked) = claim.asked {
        let sizes = claim
            .sizes
            .map(|field| move |p: Point| [field.max_edge(p), field.max_area(p)]);
        let bounds = bounds(asked)?;
        let bounds = match &sizes {
            Some(sizes) => bounds.sizes(sizes),
            None => bounds,
        };
        match check::verify_quality(claim.input, rule, &mesh, &bounds, watch)? {
            Ok(verdict) => {
                certificate = Some(verdict.certificate);
                quality = Some(verdict);
            }
            Err(defects) => return Ok(Err(defects)),
        }
    }
    if !claim.input.regions.is_empty() {
        match check::verify_regions(claim.input, rule, &mesh, watch)? {
            Ok((proven, of)) => {
                certificate = Some(proven);
                regions = Some(of);
            }
            Err(defects) => return Ok(Err(defects)),
        }
    }
    let certificate = match certificate {
        Some(certificate) => certificate,
        None => match check::verify_domain(claim.input, rule, &mesh, watch)? {
            Verdict::Right(certificate) => certificate,
            Verdict::Wrong(defects) => return Ok(Err(defects)),
        },
    };
    Ok(Ok((certificate, quality, regions)))
}

/// Makes what the verifier understands of what was asked.
fn bounds(asked: &AskedFor) -> Result<Asked<'static>, Error> {
    let locked = asked.locked().ok_or_else(|| {
        let word = asked.keep_boundary.as_deref().unwrap_or_default();
        Error::BadMesh(format!("keep_boundary is {word:?}; it can be outer or all"))
    })?;
    let bounds = Asked::new(asked.quality()).locked(locked);
    Ok(match asked.conforming {
        true => bounds.conforming(),
        false => bounds,
    })
}

fn in_words(defects: &Defects) -> Vec<String> {
    let mut words: Vec<String> = defects.listed().iter().map(ToString::to_string).collect();
    match defects.total() - defects.listed().len() {
        0 => {}
        more => words.push(format!("and {more} more of the same kinds")),
    }
    words
}
