//! What is asked of local fits.

use super::bernstein::{MOST_DEGREE, terms};
use crate::Error;

/// Which polynomials are fitted, and when data count as too few for them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitOptions {
    /// The degree, from 0 to 5. By default 2.
    pub degree: usize,
    /// The largest [condition](super::LocalFit::condition) that is taken. By default 5.
    ///
    /// Data spread evenly over their triangle have 1. What is well above comes of corners without data, where the
    /// polynomial is at liberty, or of data near a curve of its degree. A larger bound admits overshoots there, a
    /// smaller one widens and lowers where that costs more accuracy than it saves.
    pub max_condition: f64,
    /// How many rings of neighbours lend their data at most, before a lower degree is tried. By default 2.
    pub max_rings: usize,
}

impl Default for FitOptions {
    fn default() -> Self {
        Self {
            degree: 2,
            max_condition: 5.0,
            max_rings: 2,
        }
    }
}

impl FitOptions {
    /// Asks for polynomials of a degree; all else is as by default.
    pub fn degree(degree: usize) -> Self {
        Self {
            degree,
            ..Self::default()
        }
    }

    /// Returns how many data determine a polynomial of the degree, if they lie well: 1, 3, 6, 10, 15, 21.
    pub fn least_data(&self) -> usize {
        terms(self.degree)
    }

    /// Fails if they make no sense.
    pub(super) fn check(&self) -> Result<(), Error> {
        let wrong = |what, given, must| Err(Error::BadChoice { what, given, must });
        if self.degree > MOST_DEGREE {
            let given = self.degree as f64;
            return wrong("the degree of local fits", given, "it must be from 0 to 5");
        }
        if self.max_condition.is_nan() || self.max_condition <= 0.0 {
            let must = "it must be positive";
            return wrong(
                "the largest condition of local fits",
                self.max_condition,
                must,
            );
        }
        Ok(())
    }
}
