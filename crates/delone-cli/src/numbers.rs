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

#[cfg(test)]
mod tests {
    use super::{angle, positive};

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
    }
}
