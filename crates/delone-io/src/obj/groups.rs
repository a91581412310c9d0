//! Names of groups, objects and materials, which become numbers.
//!
//! What has the same group (`g`), object (`o`) and material (`usemtl`) has the same number. Groups named as we write
//! them, `region_2` and `marker_7`, have that in their name; if there are others, all are numbered from 1 in the order
//! in which they appear. If there is one only, it tells nothing apart, and there are no numbers.

use std::collections::BTreeMap;

/// Group, object and material, as numbers of names.
type Key = [u32; 3];

/// The names in force, and what has been put under them.
#[derive(Default)]
pub(super) struct Names<'a> {
    /// Every name once: a long one may be in force for many others.
    known: BTreeMap<&'a [u8], u32>,
    texts: Vec<&'a [u8]>,
    current: Key,
}

impl<'a> Names<'a> {
    pub fn new() -> Self {
        let mut names = Self::default();
        names.number(b"");
        names
    }

    /// Puts a name into force: in place 0 that of a group, in 1 of an object, in 2 of a material.
    pub fn set(&mut self, place: usize, name: &'a [u8]) {
        self.current[place] = self.number(name);
    }

    fn number(&mut self, name: &'a [u8]) -> u32 {
        let next = self.texts.len() as u32;
        let number = *self.known.entry(name).or_insert(next);
        if number == next {
            self.texts.push(name);
        }
        number
    }
}

/// The groups of triangles, or those of lines.
#[derive(Default)]
pub(super) struct Groups {
    known: BTreeMap<Key, u32>,
    keys: Vec<Key>,
    last: Option<(Key, u32)>,
    /// The group of each element.
    of: Vec<u32>,
}

impl Groups {
    /// Adds an element to what is in force.
    pub fn push(&mut self, names: &Names<'_>) {
        let key = names.current;
        let group = match self.last {
            Some((last, group)) if last == key => group,
            _ => self.find(key),
        };
        self.last = Some((key, group));
        self.of.push(group);
    }

    /// Adds elements to the group without names: the sides of an outline.
    pub fn mark_rest(&mut self, elements: usize) {
        let group = self.find(Key::default());
        self.of.resize(self.of.len() + elements, group);
    }

    fn find(&mut self, key: Key) -> u32 {
        let next = self.keys.len() as u32;
        let group = *self.known.entry(key).or_insert(next);
        if group == next {
            self.keys.push(key);
        }
        group
    }

    /// Numbers the elements by their groups, if these tell anything apart; `none` is the name of the group without
    /// number, and what its elements get.
    pub fn numbers(&self, names: &Names<'_>, prefix: &str, none: (&str, i32)) -> Option<Vec<i32>> {
        let own = |&key: &Key| number_in(names.texts[key[0] as usize], prefix, none);
        let own: Option<Vec<i32>> = self.keys.iter().map(own).collect();
        let numbers = match own {
            Some(own) if own.iter().all(|&n| n == none.1) => return None,
            Some(own) => own,
            None if self.keys.len() < 2 => return None,
            None => (1..=self.keys.len() as i32).collect(),
        };
        Some(self.of.iter().map(|&g| numbers[g as usize]).collect())
    }
}

/// Returns the number in a name that we have given.
fn number_in(name: &[u8], prefix: &str, none: (&str, i32)) -> Option<i32> {
    let name = std::str::from_utf8(name).ok()?;
    match name.strip_prefix(prefix) {
        Some(number) => number.parse().ok(),
        None => (name == none.0).then_some(none.1),
    }
}

#[cfg(test)]
mod tests {
    use super::{Groups, Names};

    fn numbers(of: &[(usize, &'static str)]) -> Option<Vec<i32>> {
        let (mut names, mut groups) = (Names::new(), Groups::default());
        for &(place, name) in of {
            names.set(place, name.as_bytes());
            groups.push(&names);
        }
        groups.numbers(&names, "region_", ("triangles", -1))
    }

    #[test]
    fn names_of_ours_carry_their_numbers() {
        let ours = [(0, "region_3"), (0, "triangles"), (0, "region_-2")];
        assert_eq!(numbers(&ours), Some(vec![3, -1, -2]));
        assert_eq!(numbers(&[(0, "region_5")]), Some(vec![5]));
    }

    #[test]
    fn other_names_are_numbered_as_they_appear() {
        let others = [(0, "roof"), (1, "house"), (0, "wall"), (0, "roof")];
        assert_eq!(numbers(&others), Some(vec![1, 2, 3, 2]));
        let mixed = [(0, "region_9"), (2, "brick"), (0, "roof")];
        assert_eq!(numbers(&mixed), Some(vec![1, 2, 3]));
    }

    #[test]
    fn a_single_name_tells_nothing() {
        assert_eq!(numbers(&[(1, "Plane")]), None);
        assert_eq!(numbers(&[(0, "triangles")]), None);
    }
}
