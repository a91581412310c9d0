//! What an algorithm is given.

use crate::delaunay::check_number;
use crate::pslg::DomainRule;
use crate::{Duplicate, Error, Point, Pslg, Quality, VertexId, Watch};

/// Points, segments and triangles to begin with, and what some algorithms want to know besides.
#[derive(Clone)]
pub struct Input<'w> {
    /// Points, and segments for algorithms that take a domain.
    pub pslg: Pslg,
    /// Which triangles belong to the domain, for algorithms that take one.
    pub domain: DomainRule,
    /// Triangles to begin with, for algorithms that flip; none: they begin with those of the sweep.
    pub start: Vec<[VertexId; 3]>,
    /// For random orders.
    pub seed: u64,
    /// For refinement.
    pub quality: Quality,
    /// For algorithms that cover data: how many each triangle is to hold at least. The default is 6, enough for
    /// polynomials of degree 2.
    pub least: usize,
    /// Who may stop it.
    pub watch: &'w dyn Watch,
}

impl Input<'_> {
    /// Begins with points alone.
    pub fn from_points<P: Into<Point>>(points: impl IntoIterator<Item = P>) -> Self {
        Self::from_pslg(Pslg::from_points(points))
    }

    /// Begins with points and segments.
    pub fn from_pslg(pslg: Pslg) -> Self {
        Self {
            pslg,
            domain: DomainRule::Hull,
            start: Vec::new(),
            seed: 0,
            quality: Quality::default(),
            least: 6,
            watch: &(),
        }
    }
}

/// The distinct points of an input.
pub(super) struct Sites {
    /// All points, −0.0 as 0.0.
    pub points: Vec<Point>,
    /// The distinct ones, in the order of the input.
    pub order: Vec<VertexId>,
    /// The others, sorted.
    pub duplicates: Vec<Duplicate>,
}

impl Sites {
    /// Checks the points of an input, and tells which of them are distinct.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooManyPoints`].
    pub fn of(input: &Input) -> Result<Self, Error> {
        let given = &input.pslg.points;
        check_number(given.len())?;
        if let Some(index) = given.iter().position(|p| !p.is_finite()) {
            let Point { x, y } = given[index];
            return Err(Error::NotFinite { index, x, y });
        }
        // Adding zero turns −0.0 into 0.0.
        let points: Vec<_> = given
            .iter()
            .map(|p| Point::new(p.x + 0.0, p.y + 0.0))
            .collect();
        let mut sorted: Vec<_> = (0..points.len()).collect();
        sorted.sort_by(|&i, &j| points[i].lex_cmp(&points[j]));
        let mut duplicates = Vec::new();
        for equal in sorted.chunk_by(|&i, &j| points[i] == points[j]) {
            let kept = VertexId::new(equal[0]);
            let dropped = equal[1..].iter().map(|&i| VertexId::new(i));
            duplicates.extend(dropped.map(|dropped| Duplicate { dropped, kept }));
        }
        duplicates.sort_unstable_by_key(|d| d.dropped);
        let is_dropped = |v| duplicates.binary_search_by_key(&v, |d| d.dropped).is_ok();
        let order = (0..points.len()).map(VertexId::new);
        let order = order.filter(|&v| !is_dropped(v)).collect();
        Ok(Self {
            points,
            order,
            duplicates,
        })
    }
}
