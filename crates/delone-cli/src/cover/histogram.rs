//! How many triangles hold how many data, in lines of text.

/// Most lines.
const LINES: usize = 24;

/// Most width of the longest bar, in characters; if there are no more, each is one triangle.
const WIDTH: usize = 40;

/// Draws a bar for each number, or for a few: `12-13 ########## 7`. `pairs` are numbers, ascending, and how often
/// there are such.
pub fn lines(pairs: &[[usize; 2]]) -> Vec<String> {
    let (Some(&[least, _]), Some(&[most, _])) = (pairs.first(), pairs.last()) else {
        return Vec::new();
    };
    let step = step(most - least);
    // Bars begin at round numbers.
    let least = least / step * step;
    let bars = (most - least) / step + 1;
    let mut times = vec![0; bars];
    for [number, often] in pairs {
        times[(number - least) / step] += often;
    }
    let longest = times.iter().copied().max().unwrap_or(0).max(1);
    let name = |bar: usize| {
        let from = least + bar * step;
        match step {
            1 => from.to_string(),
            _ => format!("{from}-{}", from + step - 1),
        }
    };
    let width = (0..bars).map(|bar| name(bar).len()).max().unwrap_or(0);
    let line = |(bar, &often): (usize, &usize)| {
        // Whatever is there is seen.
        let length = (often * WIDTH.min(longest)).div_ceil(longest);
        let name = name(bar);
        match often {
            0 => format!("  {name:>width$}"),
            _ => format!("  {name:>width$} {} {often}", "#".repeat(length)),
        }
    };
    times.iter().enumerate().map(line).collect()
}

/// Returns how many numbers share a bar: one, or a round number.
fn step(extent: usize) -> usize {
    let powers = (0..20).map(|k| 10usize.saturating_pow(k));
    let mut steps = powers.flat_map(|power| [1, 2, 5].map(|m: usize| m.saturating_mul(power)));
    // One more may be needed where the first begins before the least.
    let enough = |step: &usize| extent / step + 2 <= LINES;
    steps.find(enough).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::lines;

    #[test]
    fn every_number_between_the_ends_has_a_line() {
        assert_eq!(lines(&[[3, 2], [4, 1]]), ["  3 ## 2", "  4 # 1"]);
        let drawn = lines(&[[6, 2], [7, 80], [9, 1]]);
        let expected = [
            "  6 # 2".to_owned(),
            format!("  7 {} 80", "#".repeat(40)),
            "  8".to_owned(),
            "  9 # 1".to_owned(),
        ];
        assert_eq!(drawn, expected);
        assert!(lines(&[]).is_empty());
    }

    #[test]
    fn many_numbers_share_lines() {
        let drawn = lines(&[[10, 1], [1000, 3]]);
        assert!(drawn.len() <= 24, "{drawn:?}");
        assert!(drawn[0].ends_with("0-49 # 1"), "{drawn:?}");
        assert!(drawn[drawn.len() - 1].ends_with(" 3"), "{drawn:?}");
    }
}
