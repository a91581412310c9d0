//! Values as they are fitted.

/// Values about their middle, of the size of 1: so squares neither over- nor underflow, and of values that are all
/// large and alike the differences count.
#[derive(Clone, Copy)]
pub(super) struct Scale {
    middle: f64,
    size: f64,
}

impl Scale {
    pub fn of(values: &[f64]) -> Self {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let middle = low * 0.5 + high * 0.5;
        match high - middle {
            size if size > 0.0 => Self { middle, size },
            _ => Self { middle, size: 1.0 },
        }
    }

    pub fn there(self, value: f64) -> f64 {
        (value - self.middle) / self.size
    }

    pub fn back(self, scaled: f64) -> f64 {
        self.size_back(scaled) + self.middle
    }

    /// As [`back`](Self::back), of a difference; what `f64` cannot hold becomes the largest.
    pub fn size_back(self, scaled: f64) -> f64 {
        (scaled * self.size).clamp(f64::MIN, f64::MAX)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_any_size_come_back() {
        for values in [
            [f64::MIN, f64::MAX],
            [5e-324, 5e-324],
            [1e9, 1e9 + 1.0],
            [0.0, 5e-324],
        ] {
            let scale = Scale::of(&values);
            let there = values.map(|v| scale.there(v));
            assert!(there.iter().all(|v| v.abs() <= 1.0), "{there:?}");
            assert_eq!(there.map(|v| scale.back(v)), values);
        }
    }
}
