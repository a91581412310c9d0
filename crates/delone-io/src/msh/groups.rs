//! Physical groups and what they are called.

use super::{MARKER, NO_REGION, REGION, REGIONS};
use crate::MeshView;
use std::collections::BTreeMap;

/// Returns the number that a name says: `marker 7`, `region 2 (attribute 5.5)`.
pub(super) fn number_in(name: &str, start: &str) -> Option<i32> {
    let rest = name.strip_prefix(start)?;
    let number = rest.split(" (").next().unwrap_or(rest);
    number.parse().ok()
}

/// Entities of one dimension, and which element lies on which.
pub(super) struct Groups {
    /// Those that elements lie on: entity *i* + 1 is the one at place *i*.
    pub entities: Vec<Group>,
    /// For each element the place of its entity.
    pub of: Vec<u32>,
}

/// An entity, and the physical group that is just this.
pub(super) struct Group {
    /// Its tag, if it is in a group.
    pub tag: Option<i32>,
    /// What the group is called.
    pub name: String,
}

impl Groups {
    /// Groups constrained edges by their markers; 0 is none.
    pub fn of_edges(markers: &[i32]) -> Self {
        let name = |marker: i32| (marker != 0).then(|| format!("{MARKER}{marker}"));
        Self::new(markers.iter().copied(), name)
    }

    /// Groups triangles by regions: those of the constraints, or else an attribute that counts them.
    pub fn of_triangles(mesh: &MeshView<'_>) -> Self {
        let constraints = mesh
            .constraints
            .and_then(|c| Some((c, c.region_of.as_ref()?)));
        if let Some((constraints, region_of)) = constraints {
            let regions = region_of.iter().map(|r| r.map_or(-1, |r| r as i32));
            return Self::new(regions, |r| {
                let region = constraints.regions.get(usize::try_from(r).ok()?)?;
                Some(format!("{REGION}{r} (attribute {})", region.attribute))
            });
        }
        let name = |region: i32| (region != NO_REGION as i32).then(|| format!("{REGION}{region}"));
        match regions_in(mesh) {
            Some(values) => Self::new(values.iter().map(|&v| v as i32), name),
            None => Self::new(mesh.triangles.iter().map(|_| NO_REGION as i32), name),
        }
    }

    fn new(
        numbers: impl Iterator<Item = i32> + Clone,
        name: impl Fn(i32) -> Option<String>,
    ) -> Self {
        let mut places: BTreeMap<i32, u32> = numbers.clone().map(|n| (n, 0)).collect();
        // Gmsh's tags are positive: numbers that are not get those that are left, and keep their names.
        let mut free = places
            .keys()
            .next_back()
            .map_or(1, |&n| n.max(0))
            .checked_add(1);
        let mut unused = 1;
        let is_taken = |tag: i32| places.contains_key(&tag);
        let entities = places.keys().map(|&number| {
            let name = name(number);
            let tag = name.is_some().then(|| match number {
                1.. => number,
                _ => match free {
                    Some(tag) => {
                        free = tag.checked_add(1);
                        tag
                    }
                    None => {
                        while is_taken(unused) {
                            unused += 1;
                        }
                        unused += 1;
                        unused - 1
                    }
                },
            });
            let name = name.unwrap_or_default();
            Group { tag, name }
        });
        let entities = entities.collect();
        places
            .values_mut()
            .zip(0..)
            .for_each(|(place, i)| *place = i);
        let of = numbers.map(|n| places[&n]).collect();
        Self { entities, of }
    }
}

/// Returns the attribute of triangles that counts regions, if all its values fit.
pub(super) fn regions_in<'a>(mesh: &MeshView<'a>) -> Option<&'a [f64]> {
    let attribute = mesh
        .triangle_attributes
        .iter()
        .find(|a| a.name == REGIONS)?;
    let fits = |&v: &f64| f64::from(v as i32) == v;
    attribute
        .values
        .iter()
        .all(fits)
        .then_some(&attribute.values)
}

#[cfg(test)]
mod tests {
    use super::{Groups, number_in};

    #[test]
    fn numbers_stand_behind_the_kind() {
        let numbers = [
            "marker 7",
            "marker -3",
            "marker 1 (attribute 2.5)",
            "marker x",
            "wall",
        ]
        .map(|name| number_in(name, super::MARKER));
        assert_eq!(numbers, [Some(7), Some(-3), Some(1), None, None]);
    }

    #[test]
    fn tags_are_positive_and_differ() {
        let groups = Groups::of_edges(&[5, 0, -2, i32::MAX, 5, 1]);
        let tags: Vec<_> = groups.entities.iter().map(|g| g.tag).collect();
        assert_eq!(tags, [Some(2), None, Some(1), Some(5), Some(i32::MAX)]);
        assert_eq!(groups.of, [3, 1, 0, 4, 3, 2]);
        let groups = Groups::of_edges(&[-9, 0, 3]);
        let tags: Vec<_> = groups.entities.iter().map(|g| g.tag).collect();
        assert_eq!(tags, [Some(4), None, Some(3)]);
    }
}
