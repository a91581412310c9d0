//! What a cover is like.

use delone::check::verify_cover;
use delone::scattered::DataTriangulation;
use serde::{Deserialize, Serialize};

/// What the checker found, having proven that the cover is right.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Facts {
    /// Data, equal ones counted once.
    pub data: usize,
    /// Triangles.
    pub triangles: usize,
    /// Fewest data that a triangle holds.
    pub fewest: usize,
    /// Their mean number.
    pub mean: f64,
    /// Most data that a triangle holds.
    pub most: usize,
    /// Triangles that hold 3d or more.
    pub special: usize,
}

impl Facts {
    /// Checks a cover.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn find(cover: &DataTriangulation) -> Result<Self, String> {
        let verdict = verify_cover(
            cover.points(),
            cover.triangles(),
            cover.data(),
            cover.holders(),
            cover.least(),
            &(),
        );
        let verdict = verdict.map_err(|error| error.to_string())?;
        let found = verdict
            .into_result()
            .map_err(|defects| defects.to_string())?;
        let [listed, special] = [cover.exceptions().len(), found.special.len()];
        if listed != special {
            return Err(format!(
                "{listed} triangles are said to hold too many, and {special} do"
            ));
        }
        Ok(Self {
            data: found.data,
            triangles: found.triangles,
            fewest: found.fewest,
            mean: found.mean,
            most: found.most,
            special,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Facts;
    use delone::scattered::cover;

    #[test]
    fn a_cover_is_proven_and_counted() {
        let data = (0..400).map(|i| (f64::from(i % 20), f64::from(i / 20)));
        let facts = Facts::find(&cover(data, 6).unwrap()).unwrap();
        assert_eq!((facts.data, facts.special), (400, 0));
        assert!(6 <= facts.fewest && facts.most < 18);
        let product = facts.mean * facts.triangles as f64;
        assert!((product - 400.0).abs() < 1e-9);
    }
}
