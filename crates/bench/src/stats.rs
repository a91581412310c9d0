//! The median, and how sizes are written.

/// Returns the median (of an even number the mean of the middle two), or `None` of nothing.
pub fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let middle = sorted.len() / 2;
    let upper = *sorted.get(middle)?;
    Some(if sorted.len() % 2 == 1 {
        upper
    } else {
        (sorted[middle - 1] + upper) / 2.0
    })
}

/// Writes a number of points or segments as people say it: `10k`, `1M`, `12345`.
pub fn size_name(count: usize) -> String {
    match count {
        0 => "0".to_owned(),
        n if n % 1_000_000 == 0 => format!("{}M", n / 1_000_000),
        n if n % 1000 == 0 => format!("{}k", n / 1000),
        n => n.to_string(),
    }
}

/// Reads a number of points or segments: digits, then perhaps `k` or `M`.
///
/// # Errors
/// Says what it could not read.
pub fn parse_size(text: &str) -> Result<usize, String> {
    let (digits, unit) = match text.strip_suffix(['k', 'K']) {
        Some(digits) => (digits, 1000),
        None => match text.strip_suffix(['m', 'M']) {
            Some(digits) => (digits, 1_000_000),
            None => (text, 1),
        },
    };
    let number = digits.parse::<usize>().ok();
    let size = number.and_then(|number| number.checked_mul(unit));
    size.ok_or_else(|| format!("`{text}` is no size; write 5000, 100k or 1M"))
}

#[cfg(test)]
mod tests {
    use super::{median, parse_size, size_name};

    #[test]
    fn medians() {
        assert_eq!(median([]), None);
        assert_eq!(median([3.0]), Some(3.0));
        assert_eq!(median([9.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median([9.0, 1.0, 2.0, 4.0]), Some(3.0));
    }

    #[test]
    fn sizes_read_back() {
        for size in [0, 7, 999, 1000, 12_345, 100_000, 1_000_000, 10_000_000] {
            assert_eq!(parse_size(&size_name(size)), Ok(size));
        }
        assert_eq!(parse_size("3m"), Ok(3_000_000));
        for wrong in ["", "k", "1.5M", "-3", "99999999999999999M"] {
            assert!(parse_size(wrong).is_err(), "{wrong}");
        }
    }
}
