//! At which levels to draw contour lines.

use crate::Error;

/// Most levels at once: more lines than that nobody can tell apart.
const MOST: usize = 100_000;

/// Returns up to `count` round levels strictly above `low` and up to `high`: all multiples of the
/// smallest step of the form 1, 2 or 5 · 10ᵏ that does not make more. Each is the `f64` nearest to its
/// decimal.
///
/// # Errors
/// [`Error::BadLevel`] unless `count` is from 1 to 100,000 and the range finite.
///
/// ```
/// use delone::surface::round_levels;
/// assert_eq!(round_levels(5, [0.05, 1.0])?, [0.2, 0.4, 0.6, 0.8, 1.0]);
/// assert_eq!(round_levels(3, [-731.0, 842.0])?, [-500.0, 0.0, 500.0]);
/// # Ok::<(), delone::Error>(())
/// ```
pub fn round_levels(count: usize, [low, high]: [f64; 2]) -> Result<Vec<f64>, Error> {
    let fits = (1..=MOST).contains(&count);
    require(
        "number of levels",
        count as f64,
        fits,
        "from 1 to 100,000 are possible",
    )?;
    require_range([low, high])?;
    if low >= high {
        return Ok(Vec::new());
    }
    let span = high / 2.0 - low / 2.0;
    // Below the smallest that can be right, so that it does not matter how the logarithm is rounded.
    let mut exponent = (span / count as f64).log10().floor().max(-325.0) as i32 - 1;
    loop {
        for digit in [1, 2, 5] {
            let step = Step { digit, exponent };
            if let Some(levels) = step.levels([low, high], count) {
                return Ok(levels);
            }
        }
        exponent += 1;
    }
}

/// Returns the levels `base + i · interval` above `low` and up to `high`, rounded.
///
/// # Errors
/// [`Error::BadLevel`] unless the interval is positive, all is finite, and there are at most 100,000
/// levels.
///
/// ```
/// let levels = delone::surface::levels_every(10.0, 5.0, [-12.0, 25.0])?;
/// assert_eq!(levels, [-5.0, 5.0, 15.0, 25.0]);
/// # Ok::<(), delone::Error>(())
/// ```
pub fn levels_every(interval: f64, base: f64, [low, high]: [f64; 2]) -> Result<Vec<f64>, Error> {
    let is_length = interval > 0.0 && interval.is_finite();
    require(
        "interval",
        interval,
        is_length,
        "it must be positive and finite",
    )?;
    require("base", base, base.is_finite(), "it must be finite")?;
    require_range([low, high])?;
    let [first, last] = [low, high].map(|value| ((value - base) / interval).floor());
    let few = last - first <= MOST as f64;
    require(
        "interval",
        interval,
        few,
        "it makes more than 100,000 levels",
    )?;
    // One more on either side, should rounding have lost one.
    let steps = (0..(last - first) as usize + 3).map(|i| first - 1.0 + i as f64);
    let mut levels: Vec<f64> = steps
        .map(|i| base + i * interval)
        .filter(|&level| low < level && level <= high)
        .collect();
    levels.dedup();
    Ok(levels)
}

fn require_range(range: [f64; 2]) -> Result<(), Error> {
    range
        .into_iter()
        .try_for_each(|end| require("range", end, end.is_finite(), "it must be finite"))
}

fn require(what: &'static str, given: f64, holds: bool, must: &'static str) -> Result<(), Error> {
    match holds {
        true => Ok(()),
        false => Err(Error::BadLevel { what, given, must }),
    }
}

/// A step `digit` · 10^`exponent`.
struct Step {
    digit: i32,
    exponent: i32,
}

impl Step {
    /// Returns the multiples above `low` and up to `high`, unless there are more than `most`, or too
    /// far from zero to be told apart.
    fn levels(&self, [low, high]: [f64; 2], most: usize) -> Option<Vec<f64>> {
        // Halves, for the step may be more than there is.
        let half = self.times(1.0) / 2.0;
        let [first, last] = [low, high].map(|end| (end / 2.0 / half).floor());
        let is_exact = first.abs().max(last.abs()) < (1_u64 << 52) as f64;
        if !is_exact || last - first > most as f64 + 2.0 {
            return None;
        }
        // One more on either side, should rounding have lost one.
        let number = (last - first) as usize + 3;
        let all = (0..number).map(|i| self.times(first - 1.0 + i as f64));
        let levels: Vec<f64> = all.filter(|&l| low < l && l <= high).collect();
        (levels.len() <= most).then_some(levels)
    }

    /// Returns the decimal `factor · digit · 10^exponent`, rounded once.
    fn times(&self, factor: f64) -> f64 {
        let text = format!("{}e{}", factor * f64::from(self.digit), self.exponent);
        let value: f64 = text.parse().expect("bug: a decimal number");
        // Adding zero turns −0.0 into 0.0.
        value + 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_round_and_as_many_as_fit() {
        for (count, range) in [
            (1, [0.3, 0.9]),
            (7, [-1e-300, 1e-300]),
            (10, [0.0, f64::MAX]),
            (10, [-f64::MAX, f64::MAX]),
            (9, [1e6, 1e6 + 1.0]),
            (12, [0.0, 5e-324]),
            (10, [1e17, 1e17 + 64.0]),
            (100, [-3.7, 12.4]),
        ] {
            let levels = round_levels(count, range).expect("levels");
            assert!(levels.len() <= count, "{range:?}: {levels:?}");
            assert!(levels.is_sorted_by(|a, b| a < b));
            assert!(levels.iter().all(|&l| range[0] < l && l <= range[1]));
            // From one step to the next there are at most two and a half times fewer.
            if range[1] < 1e17 && range[1] > 1e-320 {
                assert!(5 * levels.len() + 5 >= 2 * count, "{range:?}: {levels:?}");
            }
        }
        assert!(round_levels(5, [2.0, 2.0]).expect("none").is_empty());
        assert!(round_levels(0, [1.0, 2.0]).is_err());
        assert!(round_levels(3, [f64::NAN, 2.0]).is_err());
    }

    #[test]
    fn intervals_that_make_no_sense_are_refused() {
        for interval in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-9] {
            assert!(
                levels_every(interval, 0.0, [0.0, 1.0]).is_err(),
                "{interval}"
            );
        }
        let tenths = levels_every(0.1, 0.0, [0.0, 1.0]).expect("levels");
        assert_eq!((tenths.len(), tenths[9]), (10, 1.0));
    }
}
