//! What is meshed, and how well.

use crate::stats::{parse_size, size_name};
use delone_samples::{Domain, Drawing};
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// Triangles leave, in the mean, this part of a bound on their area, if they are refined one by one
/// (Triangle, far from the border).
const FILLED: f64 = 0.645;

/// An outline of so many segments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Outline {
    /// Its kind.
    pub domain: Domain,
    /// How many segments.
    pub size: usize,
}

impl Outline {
    /// The standard ones, each of a size that makes meshes of comparable work.
    pub const ALL: [Self; 12] = [
        Self::new(Domain::Square, 4),
        Self::new(Domain::Holes, 18_004),
        Self::new(Domain::Coast, 100_000),
        Self::new(Domain::Fjords, 100_000),
        Self::new(Domain::Airfoil, 204),
        Self::new(Domain::Gear, 500),
        Self::new(Domain::Star, 200),
        Self::new(Domain::Comb, 400),
        Self::new(Domain::Spiral, 2000),
        Self::new(Domain::Rings, 10_000),
        Self::new(Domain::Joints, 10_004),
        Self::new(Domain::Town, 10_004),
    ];

    const fn new(domain: Domain, size: usize) -> Self {
        Self { domain, size }
    }

    /// Draws it.
    pub fn draw(self, seed: u64) -> Drawing {
        self.domain.draw(self.size, seed)
    }
}

impl fmt::Display for Outline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}", self.domain, size_name(self.size))
    }
}

impl FromStr for Outline {
    type Err = String;

    /// Reads `holes`, or `holes:5k`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, size) = text.split_once(':').unzip();
        let domain: Domain = name
            .unwrap_or(text)
            .parse()
            .map_err(|unknown: delone_samples::UnknownName| unknown.to_string())?;
        let standard = Self::ALL.into_iter().find(|o| o.domain == domain);
        let Some(standard) = standard else {
            return Err(format!("`{domain}` encloses no area that could be meshed"));
        };
        let size = size.map_or(Ok(standard.size), parse_size)?;
        Ok(Self { domain, size })
    }
}

/// What limits the size of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Load {
    /// Nothing: they are as large as angles allow.
    AngleOnly,
    /// A bound on their area that makes about so many.
    About(usize),
}

impl Load {
    /// Returns the largest area for a domain of `area`, of three digits, so that all read the same.
    pub fn bound(self, area: f64) -> Option<f64> {
        let Self::About(triangles) = self else {
            return None;
        };
        let bound = area / (FILLED * triangles.max(1) as f64);
        format!("{bound:.2e}").parse().ok()
    }
}

impl fmt::Display for Load {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AngleOnly => f.write_str("none"),
            Self::About(triangles) => f.write_str(&size_name(*triangles)),
        }
    }
}

impl FromStr for Load {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "none" => Ok(Self::AngleOnly),
            size => parse_size(size).map(Self::About),
        }
    }
}

/// What is asked of every triangle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, clap::Args)]
pub struct Goal {
    /// Smallest angle, degrees
    #[arg(long)]
    pub angle: f64,
    /// Largest area
    #[arg(long)]
    pub area: Option<f64>,
}

#[cfg(test)]
mod tests {
    use super::{Load, Outline};
    use delone_samples::Domain;

    #[test]
    fn outlines_parse_back_and_all_that_encloses_is_there() {
        for outline in Outline::ALL {
            assert_eq!(outline.to_string().parse(), Ok(outline));
            assert_eq!(outline.domain.name().parse(), Ok(outline));
        }
        let meshable = Domain::ALL.into_iter().filter(|d| d.encloses());
        assert_eq!(meshable.count(), Outline::ALL.len());
        assert!("tangle".parse::<Outline>().unwrap_err().contains("tangle"));
        assert!("holes:x".parse::<Outline>().unwrap_err().contains("`x`"));
        assert!("hole".parse::<Outline>().unwrap_err().contains("holes"));
    }

    #[test]
    fn area_bounds_have_three_digits() {
        assert_eq!("none".parse(), Ok(Load::AngleOnly));
        assert_eq!("100k".parse(), Ok(Load::About(100_000)));
        assert_eq!(Load::AngleOnly.bound(1.0), None);
        assert_eq!(Load::About(1_000_000).bound(1.0), Some(1.55e-6));
    }
}
