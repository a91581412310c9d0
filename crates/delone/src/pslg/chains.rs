//! Into which chain of vertices each segment was cut.

use crate::VertexId;

/// The chains of the segments that are more than one edge, or less: all others are their own chain.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Chains {
    /// The segments that were cut, ascending.
    segments: Vec<u32>,
    /// Where the chain of each begins in `vertices`, and where the last one ends.
    starts: Vec<u32>,
    vertices: Vec<VertexId>,
}

impl Chains {
    /// Adds the chain of `segment`, which must be greater than those before.
    pub fn push(&mut self, segment: usize, chain: impl IntoIterator<Item = VertexId>) {
        debug_assert!(self.segments.last().is_none_or(|&s| (s as usize) < segment));
        if self.starts.is_empty() {
            self.starts.push(0);
        }
        self.segments.push(segment as u32);
        self.vertices.extend(chain);
        self.starts.push(self.vertices.len() as u32);
    }

    /// Returns the chain of `segment` if it was cut.
    pub fn get(&self, segment: usize) -> Option<&[VertexId]> {
        let i = self.segments.binary_search(&(segment as u32)).ok()?;
        Some(&self.vertices[self.starts[i] as usize..self.starts[i + 1] as usize])
    }

    /// Visits the segments that were cut, with their chains, ascending.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &[VertexId])> {
        self.segments.iter().enumerate().map(|(i, &segment)| {
            let range = self.starts[i] as usize..self.starts[i + 1] as usize;
            (segment as usize, &self.vertices[range])
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_are_found_by_segment() {
        let [a, b, c] = [7, 8, 9].map(VertexId::new);
        let mut chains = Chains::default();
        assert_eq!(chains.get(0), None);
        chains.push(2, [a, b, c]);
        chains.push(5, [c]);
        assert_eq!(chains.get(2), Some(&[a, b, c][..]));
        assert_eq!(chains.get(3), None);
        assert_eq!(chains.get(5), Some(&[c][..]));
        assert_eq!(chains.iter().map(|(s, c)| s + c.len()).sum::<usize>(), 11);
    }
}
