//! Every free choice of the algorithms, as options; their defaults are the library's, which are those of the text.

use crate::numbers;
use delone::Point;
use delone::scattered::Cover;

/// How many data a triangle holds at least, if nothing is said: as many as a quadratic polynomial has coefficients.
const QUADRATIC: u32 = 6;

/// Options about how many data triangles hold, and what is done about it.
#[derive(clap::Args, Clone)]
pub struct Choices {
    /// Fewest data in a triangle, d; 3d - 1 are the most that it should hold [default: 6, as many as a
    /// quadratic polynomial has coefficients]
    #[arg(short, long, value_name = "D", help_heading = None, value_parser = clap::value_parser!(u32).range(1..))]
    data_per_triangle: Option<u32>,
    /// Degree of the polynomials to be fitted, in place of -d: 1, 2 and 3 need 3, 6 and 10 data
    #[arg(long, value_name = "K", help_heading = None, conflicts_with = "data_per_triangle",
          value_parser = clap::value_parser!(u32).range(0..=100))]
    degree: Option<u32>,
    /// Size of the outer polygon, as a multiple of the convex hull of the data: at least 1 [default: 1.1]
    #[arg(long, value_name = "FACTOR", help_heading = "Algorithm A", value_parser = numbers::at_least_one,
          allow_negative_numbers = true)]
    factor: Option<f64>,
    /// How many triangulations in a row may be no good before Algorithm A ends [default: 3]
    #[arg(long, value_name = "N", help_heading = "Algorithm A")]
    misses: Option<u32>,
    /// Do not add centers of clusters: the outer polygon alone is triangulated
    #[arg(long, help_heading = "Algorithm A")]
    no_inner_points: bool,
    /// How many places on an edge Algorithm B tries [default: 25; the text leaves it open]
    #[arg(
        long,
        value_name = "N",
        help_heading = "Algorithms B and C",
        conflicts_with = "no_edges"
    )]
    bisections: Option<u32>,
    /// Leave Algorithm B out: put no vertices on edges
    #[arg(long, help_heading = "Algorithms B and C")]
    no_edges: bool,
    /// Leave Algorithm C out: put no vertices into triangles, which may then hold any number of data
    #[arg(long, help_heading = "Algorithms B and C")]
    no_interior: bool,
    /// Do not flip edges for larger angles after each vertex
    #[arg(long, help_heading = "Algorithms B and C")]
    no_optimize: bool,
}

impl Choices {
    /// Returns the library's options, with this domain if there is one.
    pub fn builder(&self, domain: Option<Vec<Point>>) -> Cover<'static> {
        let mut cover = Cover::new(self.least())
            .inner_points(!self.no_inner_points)
            .divides_edges(!self.no_edges)
            .divides_triangles(!self.no_interior)
            .optimizes(!self.no_optimize);
        if let Some(factor) = self.factor {
            cover = cover.factor(factor);
        }
        if let Some(misses) = self.misses {
            cover = cover.misses(misses as usize);
        }
        if let Some(bisections) = self.bisections {
            cover = cover.bisections(bisections);
        }
        match domain {
            Some(corners) => cover.domain(corners),
            None => cover,
        }
    }

    fn least(&self) -> usize {
        let least = match (self.data_per_triangle, self.degree) {
            (Some(least), _) => least,
            (None, Some(k)) => (k + 1) * (k + 2) / 2,
            (None, None) => QUADRATIC,
        };
        least as usize
    }
}
