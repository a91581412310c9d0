//! Numbers that go with nodes or elements.

use super::read::Reader;
use crate::{Attribute, Error, Problem, points, scan};

/// Values of attributes that may be kept for each number in the file, and besides: most data are for all nodes, some for
/// a part, and a few numbers for many nodes would take memory out of proportion.
const MOST_SPARSE: usize = 64;
const SPARE_VALUES: usize = 1 << 20;

/// The data of nodes, or those of elements.
#[derive(Default)]
pub(super) struct Views(Vec<View>);

/// One field of numbers, in the parts that the file has it in.
struct View {
    name: String,
    step: i64,
    components: usize,
    tags: Vec<u64>,
    /// As many for each tag as there are components.
    values: Vec<f64>,
}

impl Views {
    /// Tells whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Reads a section.
    pub fn read(&mut self, reader: &mut Reader<'_>) -> Result<(), Error> {
        let mut name = None;
        let strings = reader.cursor.text_count("string tags")?;
        reader.cursor.line();
        for _ in 0..strings {
            if reader.cursor.left() == 0 {
                return Err(reader
                    .cursor
                    .refuse("truncated: the file ends among string tags"));
            }
            let line = String::from_utf8_lossy(reader.cursor.line()).into_owned();
            name.get_or_insert_with(|| line.trim_matches('"').to_owned());
        }
        for _ in 0..reader.cursor.text_count("real tags")? {
            reader.cursor.text_number("a real tag")?;
        }
        let mut integers = [0, 1, 0];
        let count = reader.cursor.text_count("integer tags")?;
        for i in 0..count {
            let value = reader.cursor.text_integer("an integer tag")?;
            if let Some(known) = integers.get_mut(usize::try_from(i).unwrap_or(usize::MAX)) {
                *known = value;
            }
        }
        if reader.is_binary {
            reader.cursor.line();
        }
        let [step, components, declared] = integers;
        let width = u64::try_from(components).unwrap_or(0);
        let width = points::check_columns(width).map_err(|p| reader.cursor.fail(p))?;
        let (true, Ok(declared)) = (width > 0, u64::try_from(declared)) else {
            let text = format!("{declared} rows of {components} components");
            return Err(reader.cursor.refuse(text));
        };
        points::check_columns(self.0.len() as u64 + 1).map_err(|p| reader.cursor.fail(p))?;
        let view = self.view(name.unwrap_or_else(|| "data".to_owned()), step, width);
        reader.cursor.reserve(&mut view.tags, 4, declared);
        for _ in 0..declared {
            let tag = reader.int("the tag of a row of data")?;
            view.tags.push(u64::try_from(tag).unwrap_or(u64::MAX));
            for _ in 0..width {
                view.values.push(reader.double("a value of data")?);
            }
        }
        Ok(())
    }

    /// Returns the view of a name and a step, with what is there already.
    fn view(&mut self, name: String, step: i64, components: usize) -> &mut View {
        let is_same = |v: &View| (&v.name, v.step, v.components) == (&name, step, components);
        let found = self.0.iter().position(is_same);
        let place = found.unwrap_or_else(|| {
            self.0.push(View {
                name,
                step,
                components,
                tags: Vec::new(),
                values: Vec::new(),
            });
            self.0.len() - 1
        });
        &mut self.0[place]
    }

    /// Requires that attributes of `len` values are not far more than the numbers that the file has for them.
    pub fn require_filled(&self, len: usize) -> Result<(), Problem> {
        let count = |of: fn(&View) -> usize| self.0.iter().map(of).sum::<usize>();
        let (given, columns) = (count(|v| v.values.len()), count(|v| v.components));
        let needed = columns.saturating_mul(len);
        if needed <= SPARE_VALUES + given.saturating_mul(MOST_SPARSE) {
            return Ok(());
        }
        Err(Problem::Other(format!(
            "{columns} columns of data have {given} numbers for {len} nodes or elements, too few to keep them; leave \
             data out"
        )))
    }

    /// Makes attributes of `len` values; `find` tells the place of a tag. Also tells whether rows were left
    /// over.
    pub fn into_attributes(
        self,
        len: usize,
        find: impl Fn(u64) -> Option<usize>,
    ) -> (Vec<Attribute>, bool) {
        let mut attributes: Vec<Attribute> = Vec::new();
        let mut has_others = false;
        for view in self.0 {
            let places: Vec<_> = view.tags.iter().map(|&tag| find(tag)).collect();
            has_others |= places.iter().any(Option::is_none);
            for k in 0..view.components {
                let mut values = vec![f64::NAN; len];
                let rows = view.values.chunks_exact(view.components);
                for (place, row) in places.iter().zip(rows) {
                    if let Some(place) = place {
                        values[*place] = row[k];
                    }
                }
                let name = view.column(k, &attributes);
                attributes.push(Attribute { name, values });
            }
        }
        (attributes, has_others)
    }
}

impl View {
    /// Names a component: steps after the first have theirs in the name.
    fn column(&self, k: usize, others: &[Attribute]) -> String {
        let name = match self.components {
            1 => self.name.clone(),
            _ => format!("{}_{k}", self.name),
        };
        match others.iter().any(|a| a.name == name) {
            true => format!("{name} (step {})", self.step),
            false => name,
        }
    }
}

/// Shows a name in a note.
pub(super) fn quoted(name: &str) -> String {
    format!("{:?}", scan::show(name.as_bytes()))
}
