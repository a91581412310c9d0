//! On which lines of a text points stand.
//!
//! Most often each stands on the line behind the one before, so only the first of each row of such lines is
//! kept.

/// The lines on which the points of a file stand, if it is a text with a line for each.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Lines {
    /// Points that do not stand on the line behind the one before, and their lines.
    breaks: Vec<(usize, u64)>,
    len: usize,
}

impl Lines {
    /// Adds the next point.
    pub(crate) fn push(&mut self, line: u64) {
        let behind = self.breaks.last();
        let behind = behind.map(|&(point, at)| at + (self.len - point) as u64);
        if behind != Some(line) {
            self.breaks.push((self.len, line));
        }
        self.len += 1;
    }

    /// Returns the line of a point, counted from 1; `None` if it is not known.
    ///
    /// *Cost*: O(log b) for b comments or blank lines between the points.
    pub fn of(&self, point: usize) -> Option<u64> {
        let after = self.breaks.partition_point(|&(first, _)| first <= point);
        let &(first, line) = self.breaks[..after].last()?;
        (point < self.len).then(|| line + (point - first) as u64)
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;

    #[test]
    fn lines_are_those_pushed() {
        let pushed = [2, 3, 4, 7, 8, 10, 13];
        let mut lines = Lines::default();
        pushed.into_iter().for_each(|line| lines.push(line));
        assert_eq!(lines.breaks.len(), 4);
        let found: Vec<_> = (0..8).map(|point| lines.of(point)).collect();
        let expected = pushed.into_iter().map(Some).chain([None]);
        assert!(expected.eq(found));
        assert_eq!(Lines::default().of(0), None);
    }
}
