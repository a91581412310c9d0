//! Subsegments: each pair of ends once, with the pieces it was cut into.

use super::Chains;
use super::meeting::Ends;
use super::sorting::sort;
use super::vertices::Vertices;
use crate::parallel::Workers;
use crate::{Point, VertexId, Watch};

/// All subsegments that have ever been: those that were cut have pieces, the others are whole.
#[derive(Default)]
pub(super) struct Pieces {
    /// The ends of each, the lexicographically smaller first.
    pub ends: Vec<Ends>,
    /// For each the first segment of the input it is a part of.
    owners: Vec<u32>,
    /// For each where its pieces begin in `lists`, or `WHOLE`.
    starts: Vec<u32>,
    /// The pieces of one subsegment after the other, from its first end to its second, each list
    /// behind its length.
    lists: Vec<u32>,
}

/// Stands for the list of pieces of a subsegment that was not cut.
const WHOLE: u32 = u32::MAX;

/// A subsegment on its way into the table.
struct Entry {
    ends: Ends,
    owner: u32,
    /// Where its number is wanted.
    slot: usize,
}

impl Pieces {
    /// Counts the subsegments, cut or whole.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    pub fn is_cut(&self, s: u32) -> bool {
        self.starts[s as usize] != WHOLE
    }

    /// Returns the first pair of input segments that two subsegments are parts of, ascending. (They
    /// have none in common: pieces of one segment do not cross.)
    pub fn owners_of(&self, pair: [u32; 2]) -> [u32; 2] {
        let [a, b] = pair.map(|s| self.owners[s as usize]);
        [a.min(b), a.max(b)]
    }

    /// Enters subsegments, given by ends and owner, and returns the number of each; equal ones, also
    /// those already there, have the same. `num_vertices` is more than any end. `None` if the watch cancelled.
    pub fn intern(
        &mut self,
        given: impl Iterator<Item = (Ends, u32)>,
        num_vertices: usize,
        workers: Workers,
        watch: &dyn Watch,
    ) -> Option<Vec<u32>> {
        let mut entries: Vec<Entry> = given
            .enumerate()
            .map(|(slot, (ends, owner))| Entry { ends, owner, slot })
            .collect();
        let key = |e: &Entry| (e.ends, e.owner, e.slot);
        sort(&mut entries, |a, b| key(a).cmp(&key(b)), workers, watch)?;
        let groups: Vec<&[Entry]> = entries.chunk_by(|a, b| a.ends == b.ends).collect();
        let known = self.known(&groups, num_vertices);
        if watch.is_cancelled() {
            return None;
        }
        let mut numbers = vec![0; entries.len()];
        for (group, known) in groups.into_iter().zip(known) {
            let number = match known {
                WHOLE => self.push(group[0].ends, group[0].owner),
                number => {
                    let owner = &mut self.owners[number as usize];
                    *owner = group[0].owner.min(*owner);
                    number
                }
            };
            for entry in group {
                numbers[entry.slot] = number;
            }
        }
        Some(numbers)
    }

    fn push(&mut self, ends: Ends, owner: u32) -> u32 {
        let number = u32::try_from(self.ends.len()).expect("bug: 2³² subsegments");
        self.ends.push(ends);
        self.owners.push(owner);
        self.starts.push(WHOLE);
        number
    }

    /// Finds for each group the whole subsegment that it equals, or `WHOLE`.
    fn known(&self, groups: &[&[Entry]], num_vertices: usize) -> Vec<u32> {
        let mut known = vec![WHOLE; groups.len()];
        if self.ends.is_empty() {
            return known;
        }
        // Few old subsegments have both ends among the new ones: the others are not searched for.
        let mut is_end = vec![false; num_vertices];
        for v in groups.iter().flat_map(|group| group[0].ends) {
            is_end[v as usize] = true;
        }
        for (number, ends) in (0..).zip(&self.ends) {
            if ends.iter().all(|&v| is_end[v as usize])
                && !self.is_cut(number)
                && let Ok(i) = groups.binary_search_by_key(ends, |group| group[0].ends)
            {
                known[i] = number;
            }
        }
        known
    }

    /// Replaces subsegments by their pieces, all at once. `cuts` are subsegments and vertices to cut
    /// them at, sorted, none twice. `None` if the watch cancelled: then the pieces are not to be used any more.
    pub fn cut(
        &mut self,
        cuts: &[[u32; 2]],
        vertices: &Vertices,
        workers: Workers,
        watch: &dyn Watch,
    ) -> Option<()> {
        let mut pieces: Vec<(Ends, u32)> = Vec::with_capacity(2 * cuts.len());
        let mut lengths = Vec::new();
        for group in cuts.chunk_by(|a, b| a[0] == b[0]) {
            let s = group[0][0] as usize;
            let chain = chain_through(vertices, self.ends[s], group.iter().map(|cut| cut[1]));
            let steps = chain.array_windows().map(|&ends| vertices.sorted(ends));
            pieces.extend(steps.map(|ends| (ends, self.owners[s])));
            lengths.push((s, chain.len() - 1));
            // What is cut is no longer there for its pieces to equal.
            self.starts[s] = WHOLE - 1;
        }
        let numbers = self.intern(pieces.into_iter(), vertices.len(), workers, watch)?;
        let mut numbers = &numbers[..];
        for (s, length) in lengths {
            self.starts[s] = u32::try_from(self.lists.len()).expect("bug: 2³² pieces");
            self.lists.push(length as u32);
            self.lists.extend(
                numbers
                    .split_off(..length)
                    .expect("bug: a number is missing"),
            );
        }
        Some(())
    }

    /// Returns the pieces of a subsegment, from its first end to its second; none if it is whole.
    fn pieces_of(&self, s: u32) -> &[u32] {
        let start = self.starts[s as usize];
        if start == WHOLE {
            return &[];
        }
        let start = start as usize + 1;
        &self.lists[start..start + self.lists[start - 1] as usize]
    }

    /// Collects the chains of the segments that were cut. `roots` has for each segment its ends and
    /// its subsegment; `name` turns vertices into those of the result. `None` if the watch cancelled.
    pub fn chains(
        &self,
        roots: impl Iterator<Item = (u32, u32)>,
        name: impl Fn(u32) -> VertexId,
        watch: &dyn Watch,
    ) -> Option<Chains> {
        let mut chains = Chains::default();
        let mut stack = Vec::new();
        for (segment, (start, root)) in roots.enumerate() {
            if segment.is_multiple_of(1 << 10) && watch.is_cancelled() {
                return None;
            }
            if self.is_cut(root) {
                chains.push(segment, self.chain(start, root, &mut stack).map(&name));
            }
        }
        Some(chains)
    }

    /// Walks along the whole subsegments of `root` from its end `start`.
    fn chain<'s>(
        &'s self,
        start: u32,
        root: u32,
        stack: &'s mut Vec<u32>,
    ) -> impl Iterator<Item = u32> + 's {
        stack.clear();
        stack.push(root);
        let mut at = start;
        let rest = std::iter::from_fn(move || {
            loop {
                let s = stack.pop()?;
                let [a, b] = self.ends[s as usize];
                let pieces = self.pieces_of(s);
                match (pieces.is_empty(), at == a) {
                    (true, is_forward) => {
                        at = if is_forward { b } else { a };
                        return Some(at);
                    }
                    (false, true) => stack.extend(pieces.iter().rev()),
                    (false, false) => stack.extend(pieces),
                }
            }
        });
        std::iter::once(start).chain(rest)
    }
}

/// Orders vertices along a segment, from its first end to its second, ends included.
///
/// Rounding is monotone: what follows each other on the segment has weakly ascending x, and weakly
/// ascending or descending y, after rounding too; so this is the exact order, up to points that
/// became equal.
fn chain_through(vertices: &Vertices, [a, b]: Ends, inner: impl Iterator<Item = u32>) -> Vec<u32> {
    let descends = vertices.at(b).y < vertices.at(a).y;
    let place = |v: u32| {
        let Point { x, y } = vertices.at(v);
        Point::new(x, if descends { -y } else { y })
    };
    let mut chain: Vec<u32> = std::iter::once(a).chain(inner).collect();
    chain[1..].sort_unstable_by(|&u, &v| place(u).lex_cmp(&place(v)));
    chain.push(b);
    chain
}
