//! Numbers as the command line has them.

/// Reads a smallest angle, in degrees.
pub fn angle(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(degrees) if (0.0..60.0).contains(&degrees) => Ok(degrees),
        _ => Err("an angle is needed, at least 0 and below 60 degrees".to_owned()),
    }
}

/// Reads a positive number.
pub fn positive(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if number > 0.0 && number < f64::INFINITY => Ok(number),
        _ => Err("a positive number is needed".to_owned()),
    }
}

/// Reads a number that is at least 1.
pub fn at_least_one(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if (1.0..f64::INFINITY).contains(&number) => Ok(number),
        _ => Err("a number is needed that is at least 1".to_owned()),
    }
}

/// Reads a number that is not negative.
pub fn radius(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(number) if (0.0..f64::INFINITY).contains(&number) => Ok(number),
        _ => Err("a number is needed that is not negative".to_owned()),
    }
}

/// Reads finite numbers set apart by commas.
pub fn several(text: &str) -> Result<Vec<f64>, String> {
    let number = |word: &str| word.trim().parse().ok().filter(|n: &f64| n.is_finite());
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    numbers.ok_or_else(|| format!("numbers set apart by commas are needed, not {text:?}"))
}

#[cfg(test)]
mod tests {
    use super::{angle, at_least_one, positive, radius, several};

    #[test]
    fn bounds_that_make_no_sense_are_refused() {
        assert_eq!(angle("0"), Ok(0.0));
        assert_eq!(angle("59.9"), Ok(59.9));
        for wrong in ["60", "-1", "NaN", "inf", "", "30°"] {
            assert!(angle(wrong).is_err(), "{wrong}");
        }
        assert_eq!(positive("1e-9"), Ok(1e-9));
        for wrong in ["0", "-1", "NaN", "inf", "1,5"] {
            assert!(positive(wrong).is_err(), "{wrong}");
        }
        assert_eq!(at_least_one("1"), Ok(1.0));
        for wrong in ["0.999", "-2", "NaN", "inf", ""] {
            assert!(at_least_one(wrong).is_err(), "{wrong}");
        }
        assert_eq!(radius("0"), Ok(0.0));
        for wrong in ["-1e-9", "NaN", "inf", ""] {
            assert!(radius(wrong).is_err(), "{wrong}");
        }
        assert_eq!(several("-1, 2.5,0"), Ok(vec![-1.0, 2.5, 0.0]));
        for wrong in ["", "1,,2", "1;2", "inf", "1,NaN"] {
            assert!(several(wrong).is_err(), "{wrong}");
        }
    }
}
