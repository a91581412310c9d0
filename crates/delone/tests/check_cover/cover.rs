//! Covers made by hand, and from lattices.

use delone::check::{self, CoverCertificate, CoverVerdict, Defect, Defects};
use delone::{Error, Point, TriangleId, VertexId};
use delone_testkit::naive::{naive_largest_least, naive_sharing};

/// Triangles, data, and who holds them.
#[derive(Clone, Debug)]
pub struct Cover {
    pub points: Vec<Point>,
    pub triangles: Vec<[VertexId; 3]>,
    pub data: Vec<Point>,
    pub holders: Vec<TriangleId>,
    pub least: usize,
}

pub fn points(coordinates: &[(f64, f64)]) -> Vec<Point> {
    coordinates.iter().copied().map(Point::from).collect()
}

impl Cover {
    /// Triangles without data.
    pub fn bare(coordinates: &[(f64, f64)], triangles: &[[u32; 3]]) -> Self {
        Self {
            points: points(coordinates),
            triangles: triangles.iter().map(|t| t.map(VertexId::from)).collect(),
            data: Vec::new(),
            holders: Vec::new(),
            least: 0,
        }
    }

    /// Shares data out so that each triangle holds as many as it can hold at least.
    pub fn fed(mut self, data: Vec<Point>) -> Self {
        let (points, triangles) = (&self.points, &self.triangles);
        self.least = naive_largest_least(points, triangles, &data).expect("data in triangles");
        self.holders = naive_sharing(points, triangles, &data, self.least).expect("so many");
        self.data = data;
        self
    }

    /// One triangle, with corners at (0, 0), (12, 0) and (0, 12), that holds all data.
    pub fn triangle(data: &[(f64, f64)], least: usize) -> Self {
        let mut cover = Self::bare(&[(0., 0.), (12., 0.), (0., 12.)], &[[0, 1, 2]]);
        cover.data = points(data);
        cover.holders = vec![TriangleId::new(0); data.len()];
        cover.least = least;
        cover
    }

    /// A square of `side`² squares with sides of four, and a datum on each lattice point.
    pub fn lattice(side: usize) -> Self {
        let square = |n: usize, step: usize| {
            let at = move |i: usize| Point::new((i % n * step) as f64, (i / n * step) as f64);
            (0..n * n).map(at).collect::<Vec<_>>()
        };
        let t = delone::triangulate(square(side + 1, 4)).expect("finite");
        let cover = Self {
            points: t.points().to_vec(),
            triangles: t.triangles().to_vec(),
            ..Self::bare(&[], &[])
        };
        cover.fed(square(4 * side + 1, 1))
    }

    pub fn verdict(&self) -> Result<CoverVerdict, Error> {
        let Self {
            points,
            triangles,
            data,
            holders,
            least,
        } = self;
        check::verify_cover(points, triangles, data, holders, *least, &())
    }

    pub fn verify(&self) -> Result<CoverCertificate, Defects> {
        self.verdict().expect("finite vertices").into_result()
    }

    #[track_caller]
    pub fn certificate(&self) -> CoverCertificate {
        self.verify().unwrap_or_else(|defects| panic!("{defects}"))
    }

    /// Requires the verifier to find something wrong, among it what `is_expected` accepts.
    #[track_caller]
    pub fn refuses(&self, is_expected: impl Fn(&Defect) -> bool) {
        let defects = self.verify().expect_err("a wrong cover");
        let is_found = defects.listed().iter().any(is_expected);
        assert!(is_found, "{defects}");
        assert!(!defects.to_string().is_empty());
    }
}
