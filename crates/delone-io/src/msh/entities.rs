//! Names of physical groups, and which entities belong to which.

use super::read::{Reader, Version};
use crate::Error;
use crate::cursor::Cursor;
use std::collections::BTreeMap;

/// Dimension and tag, of an entity or of a group.
pub(super) type Key = (i64, i32);

/// What groups are called.
#[derive(Default)]
pub(super) struct PhysicalNames(pub BTreeMap<Key, String>);

impl PhysicalNames {
    /// Reads the section, which is text in every file.
    pub fn read(&mut self, cursor: &mut Cursor<'_>) -> Result<(), Error> {
        for _ in 0..cursor.text_count("names")? {
            let dimension = cursor.text_integer("the dimension of a group")?;
            let tag = cursor.text_integer("the tag of a group")?;
            let Ok(tag) = i32::try_from(tag) else {
                return Err(cursor.refuse(format!("group {tag} does not fit 32 bits")));
            };
            let name = String::from_utf8_lossy(cursor.line()).into_owned();
            let bare = name.strip_prefix('"').and_then(|n| n.strip_suffix('"'));
            let name = bare.unwrap_or(&name).to_owned();
            self.0.insert((dimension, tag), name);
        }
        Ok(())
    }
}

/// The physical groups of each entity, by dimension and tag.
#[derive(Default)]
pub(super) struct Entities(BTreeMap<Key, Vec<i32>>);

impl Entities {
    /// Returns the groups that an entity belongs to.
    pub fn groups(&self, dimension: i64, tag: i32) -> &[i32] {
        self.0.get(&(dimension, tag)).map_or(&[], Vec::as_slice)
    }

    /// Reads `$Entities`.
    pub fn read(&mut self, reader: &mut Reader<'_>) -> Result<(), Error> {
        self.read_all(reader, false)
    }

    /// Reads `$PartitionedEntities`: the same with more about each.
    pub fn read_partitioned(&mut self, reader: &mut Reader<'_>) -> Result<(), Error> {
        reader.size("partitions")?;
        for _ in 0..reader.size("ghost entities")? {
            reader.tag("a ghost entity")?;
            reader.tag("a partition")?;
        }
        self.read_all(reader, true)
    }

    fn read_all(&mut self, reader: &mut Reader<'_>, is_partitioned: bool) -> Result<(), Error> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = reader.size("entities")?;
        }
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                self.read_one(reader, dimension, is_partitioned)?;
            }
        }
        Ok(())
    }

    fn read_one(
        &mut self,
        reader: &mut Reader<'_>,
        dimension: i64,
        is_partitioned: bool,
    ) -> Result<(), Error> {
        let tag = reader.tag("the tag of an entity")?;
        if is_partitioned {
            reader.tag("a dimension")?;
            reader.tag("an entity")?;
            reader.tags("partitions")?;
        }
        let is_place = dimension == 0 && reader.version == Version::V41;
        reader.skip_doubles(if is_place { 3 } else { 6 })?;
        let groups = reader.tags("physical groups")?;
        if dimension > 0 {
            reader.tags("entities around")?;
        }
        if !groups.is_empty() {
            self.0.insert((dimension, tag), groups);
        }
        Ok(())
    }
}
