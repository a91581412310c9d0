//! Figures as people read them.

use std::time::Duration;

/// Writes a count with its digits in groups of three: `1,249`.
pub fn count(n: usize) -> String {
    let digits = n.to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3);
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Writes a count of things: `1 triangle`, `2,475 triangles`, `0 vertices`.
pub fn counted(n: usize, one: &str, many: &str) -> String {
    format!("{} {}", count(n), if n == 1 { one } else { many })
}

/// Writes a duration with three digits and its unit: `0.412 ms`, `97.3 ms`, `1.24 s`.
pub fn duration(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    let (value, unit) = if seconds < 0.9995 {
        (seconds * 1e3, "ms")
    } else {
        (seconds, "s")
    };
    let decimals = match value {
        v if v >= 100.0 => 0,
        v if v >= 10.0 => 1,
        v if v >= 1.0 => 2,
        _ => 3,
    };
    format!("{value:.decimals$} {unit}")
}

/// Writes a measure with four digits: `28.91`, `0.01799`, `2.100e-7`, `217.7`.
pub fn measure(value: f64) -> String {
    let magnitude = value.abs();
    if value != 0.0 && !(1e-4..1e6).contains(&magnitude) {
        return format!("{value:.3e}");
    }
    let before_point = magnitude.max(f64::MIN_POSITIVE).log10().floor().max(-4.0) as i32;
    let decimals = (3 - before_point).clamp(0, 7) as usize;
    format!("{value:.decimals$}")
}

/// Joins names: `a`, `a and b`, `a, b and c`.
pub fn list(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_grouped_by_three_digits() {
        let grouped = [0, 7, 999, 1000, 12345, 1234567].map(count);
        assert_eq!(
            grouped,
            ["0", "7", "999", "1,000", "12,345", "1,234,567"].map(String::from)
        );
        assert_eq!(counted(1, "vertex", "vertices"), "1 vertex");
        assert_eq!(counted(0, "vertex", "vertices"), "0 vertices");
    }

    #[test]
    fn durations_have_three_digits() {
        let micros = [412, 4_120, 41_200, 412_000, 4_120_000, 99_000_000];
        let shown = micros.map(|m| duration(Duration::from_micros(m)));
        assert_eq!(
            shown,
            [
                "0.412 ms", "4.12 ms", "41.2 ms", "412 ms", "4.12 s", "99.0 s"
            ]
            .map(String::from)
        );
    }

    #[test]
    fn measures_have_four_digits() {
        let shown = [28.912, 0.017_994, 2.1e-7, 217.67, 123_456.7, 1e30].map(measure);
        assert_eq!(
            shown,
            [
                "28.91", "0.01799", "2.100e-7", "217.7", "123457", "1.000e30"
            ]
            .map(String::from)
        );
    }

    #[test]
    fn lists_read_like_prose() {
        let names = ["a", "b", "c"].map(String::from);
        assert_eq!(list(&names), "a, b and c");
        assert_eq!(list(&names[..2]), "a and b");
        assert_eq!(list(&names[..1]), "a");
    }
}
