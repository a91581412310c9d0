//! Claims to be verified, and small inputs.

use delone::check::{self, Certificate, Defects, DomainMesh, DomainNumbers};
use delone::{DomainRule, Error, Point, Pslg, VertexId};
use delone_testkit::naive::{naive_constrained, naive_domain, naive_noding};

pub const RULES: [DomainRule; 3] = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];

/// An input, and a mesh that is claimed to be its triangulation.
#[derive(Clone, Debug)]
pub struct Claim {
    pub input: Pslg,
    pub rule: DomainRule,
    pub points: Vec<Point>,
    pub triangles: Vec<[VertexId; 3]>,
    pub subsegments: Vec<[VertexId; 2]>,
    pub chains: Vec<Vec<VertexId>>,
}

impl Claim {
    /// Makes the right claim by the definitions, or none if a seed lies on a segment.
    pub fn right(input: &Pslg, rule: DomainRule) -> Option<Self> {
        let noding = naive_noding(&input.points, &input.segments);
        let mut subsegments = noding.edges();
        subsegments.iter_mut().for_each(|ends| ends.sort_unstable());
        subsegments.sort_unstable();
        subsegments.dedup();
        let triangles = naive_constrained(&noding.points, &subsegments);
        let domain = naive_domain(input, &noding, &triangles, rule).ok()?;
        Some(Self {
            input: input.clone(),
            rule,
            points: noding.points,
            triangles: domain.triangles,
            subsegments,
            chains: noding.chains,
        })
    }

    pub fn verify(&self) -> Result<Certificate, Defects> {
        let mesh = DomainMesh::new(&self.points, &self.triangles, &self.subsegments);
        let verdict = check::verify_domain(&self.input, self.rule, &mesh, &());
        verdict.expect("a proper input").into_result()
    }

    pub fn verify_chains(&self) -> Result<Certificate, Defects> {
        let chains = |segment: usize| &self.chains[segment][..];
        let mesh = DomainMesh::new(&self.points, &self.triangles, &self.subsegments);
        let mesh = mesh.with_chains(&chains);
        let verdict = check::verify_domain(&self.input, self.rule, &mesh, &());
        verdict.expect("a proper input").into_result()
    }

    pub fn numbers(&self) -> DomainNumbers {
        let certificate = self.verify().unwrap_or_else(|d| panic!("{d}\n{self:?}"));
        assert_eq!(self.verify_chains(), Ok(certificate));
        certificate.domain.expect("numbers of the domain")
    }

    pub fn error(&self) -> Error {
        let mesh = DomainMesh::new(&self.points, &self.triangles, &self.subsegments);
        let verdict = check::verify_domain(&self.input, self.rule, &mesh, &());
        verdict.expect_err("an improper input")
    }
}

macro_rules! assert_rejected {
    ($claim:expr, $($kind:pat),+ $(,)?) => {
        assert_defects!($claim.verify(), $($kind),+)
    };
}

macro_rules! assert_defects {
    ($verdict:expr, $($kind:pat),+ $(,)?) => {{
        let defects = $verdict.expect_err("a wrong triangulation passed");
        $(assert!(
            defects.listed().iter().any(|d| matches!(d, $kind)),
            "no {} among:\n{defects}", stringify!($kind)
        );)+
        defects
    }};
}

pub fn point(x: f64, y: f64) -> Point {
    Point::new(x, y)
}

/// Adds a square ring around a centre.
pub fn add_square(input: &mut Pslg, [x, y]: [f64; 2], half: f64) {
    let first = input.points.len() as u32;
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    let corners = corners.map(|(dx, dy)| point(x + dx, y + dy));
    input.points.extend(corners);
    input.add_ring(first..first + 4);
}

/// Rings in rings: a lake, an island in it, a pond on the island; and loose points all around.
pub fn lake() -> Pslg {
    let mut input = Pslg::default();
    for half in [8.0, 5.0, 2.0] {
        add_square(&mut input, [0.0, 0.0], half);
    }
    let loose = [
        (7.0, 0.5),
        (4.0, 0.5),
        (1.0, 0.5),
        (9.0, 11.0),
        (-7.0, -6.0),
    ];
    input.points.extend(loose.map(Point::from));
    input
}

/// Two segments that cross in a rounded point, in a square.
pub fn crossed() -> Pslg {
    let mut input = Pslg::default();
    add_square(&mut input, [0.5, 0.5], 2.0);
    let ends = [(0.0, 0.0), (1.0, 1.0), (0.1, 0.7), (0.9, 0.2)];
    input.points.extend(ends.map(Point::from));
    input.add_segment(4, 5);
    input.add_segment(6, 7);
    input
}

pub fn right(input: &Pslg, rule: DomainRule) -> Claim {
    Claim::right(input, rule).expect("no seed on a segment")
}

/// The claim that is right for another rule, or for another input with the same points.
pub fn misread(claim: Claim, change: impl FnOnce(&mut Claim)) -> Claim {
    let mut wrong = claim;
    change(&mut wrong);
    wrong
}

/// Replaces the edge opposite some corner of a triangle by the other diagonal.
pub fn flip(claim: &mut Claim, t: usize) -> Option<()> {
    let [a, b, c] = claim.triangles[t];
    let turned = |[a, b, c]: [VertexId; 3]| [[a, b, c], [b, c, a], [c, a, b]];
    let across = |other: &[VertexId; 3]| {
        let apex = turned(*other).into_iter().find(|r| r[..2] == [c, b]);
        apex.map(|r| r[2])
    };
    let (u, d) = claim
        .triangles
        .iter()
        .enumerate()
        .find_map(|(u, o)| Some((u, across(o)?)))?;
    claim.triangles[t] = [a, b, d];
    claim.triangles[u] = [a, d, c];
    Some(())
}
