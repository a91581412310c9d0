//! Looks at what a file declares before it is trusted: how deep its schema is, and how much its pages hold.

use super::thrift::{self, Reader};
use crate::Problem;

/// The mark at both ends of the file, and the bytes of the length before the last.
const MAGIC: &[u8] = b"PAR1";
const TAIL: usize = 8;

/// Most elements of a schema, and its deepest nesting.
const MAX_ELEMENTS: usize = 1 << 14;
const MAX_DEPTH: usize = 32;

/// Memory that the pages of a file may take, whatever its size, and what they may take more for each of its bytes.
const FREE: u64 = 1 << 29;
const FREE_PER_BYTE: u64 = 1 << 10;

/// Memory that is still allowed for what a file declares.
pub(super) struct Budget {
    left: u64,
    file: u64,
}

impl Budget {
    pub fn new(bytes: &[u8]) -> Self {
        let file = bytes.len() as u64;
        let left = FREE + FREE_PER_BYTE * file;
        Self { left, file }
    }

    /// Takes what is needed.
    pub fn take(&mut self, needed: u64) -> Result<(), Problem> {
        match self.left.checked_sub(needed) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err(Problem::Other(format!(
                "declares more than {} MB in a file of {} bytes; if that is right, save it without compression",
                (FREE + FREE_PER_BYTE * self.file) >> 20,
                self.file
            ))),
        }
    }
}

/// Checks the ends of the file, and that its schema is a small tree.
pub(super) fn check_footer(bytes: &[u8]) -> Result<(), Problem> {
    let other = |text: &str| Problem::Other(text.to_owned());
    if bytes.is_empty() {
        return Err(Problem::Empty);
    }
    if bytes.starts_with(b"PARE") || bytes.ends_with(b"PARE") {
        return Err(other("the file is encrypted; save it without encryption"));
    }
    if !bytes.starts_with(MAGIC) {
        return Err(other("no Parquet file: it does not begin with PAR1"));
    }
    let cut = || other("truncated: the file does not end with its table of contents and PAR1");
    let (rest, tail) = bytes
        .split_at_checked(bytes.len().saturating_sub(TAIL))
        .ok_or_else(cut)?;
    if bytes.len() < MAGIC.len() + TAIL || !tail.ends_with(MAGIC) {
        return Err(cut());
    }
    let length = u32::from_le_bytes([tail[0], tail[1], tail[2], tail[3]]) as usize;
    let start = rest
        .len()
        .checked_sub(length)
        .filter(|&start| start >= MAGIC.len());
    let footer = &rest[start.ok_or_else(cut)?..];
    let children = schema(footer).ok_or_else(|| other("the table of contents is broken"))?;
    check_tree(&children)
}

/// Returns how many children each element of the schema declares.
fn schema(footer: &[u8]) -> Option<Vec<i64>> {
    let mut children = Vec::new();
    let read = Reader::new(footer).fields(|reader, id, kind| {
        if id != 2 || !thrift::is_list(kind) {
            return Some(false);
        }
        let (length, kind) = reader.list()?;
        for _ in 0..length {
            thrift::is_struct(kind).then_some(())?;
            let mut count = 0;
            reader.fields(|reader, id, kind| {
                let is_it = id == 5 && thrift::is_integer(kind);
                if is_it {
                    count = reader.integer()?;
                }
                Some(is_it)
            })?;
            children.push(count);
            // Enough has been seen to refuse it.
            (children.len() <= MAX_ELEMENTS).then_some(())?;
        }
        Some(true)
    });
    (read.is_some() || children.len() > MAX_ELEMENTS).then_some(children)
}

/// Checks that elements in depth-first order are a tree, neither large nor deep.
fn check_tree(children: &[i64]) -> Result<(), Problem> {
    if children.len() > MAX_ELEMENTS {
        return Err(Problem::TooMany {
            items: "columns",
            given: children.len() as u64,
            limit: MAX_ELEMENTS as u64,
        });
    }
    let mut open = Vec::new();
    for &count in children {
        if let Some(last) = open.last_mut() {
            *last -= 1;
        }
        let is_possible = (0..=children.len() as i64).contains(&count);
        if is_possible && count > 0 {
            open.push(count);
        }
        if !is_possible || open.len() > MAX_DEPTH {
            let text = format!("a column of {count} parts, {} levels deep", open.len());
            return Err(Problem::Other(text));
        }
        while open.last() == Some(&0) {
            open.pop();
        }
    }
    Ok(())
}

/// What is wrong with the pages of a column, and where in them.
pub(super) type Broken = (usize, Problem);

/// Checks the pages of a column of `rows` rows, whose bytes these are, and takes what they hold from the budget.
pub(super) fn check_pages(
    bytes: &[u8],
    rows: u64,
    budget: &mut Budget,
    is_cancelled: &dyn Fn() -> bool,
) -> Result<(), Broken> {
    let mut at = 0;
    let mut values = 0;
    while at < bytes.len() && values < rows && !is_cancelled() {
        let start = at;
        let other = |text: &str| (start, Problem::Other(text.to_owned()));
        let page = page(&bytes[at..]).ok_or_else(|| other("the header of a page is broken"))?;
        at += page.header;
        let size = usize::try_from(page.compressed).ok();
        let size = size.filter(|&size| size <= bytes.len() - at);
        at += size.ok_or_else(|| other("a page is longer than its column"))?;
        let memory = u64::try_from(page.memory);
        let memory = memory.map_err(|_| other("a page of negative length"))?;
        budget.take(memory).map_err(|problem| (start, problem))?;
        let count = u64::try_from(page.entries).unwrap_or(u64::MAX);
        if count > memory.max(1) {
            return Err(other("a page declares more entries than it has bytes"));
        }
        let count = u64::try_from(page.values);
        values += count.map_err(|_| other("a page of a negative number of values"))?;
    }
    Ok(())
}

/// What the header of a page declares.
#[derive(Default)]
struct Page {
    /// Bytes of the header itself.
    header: usize,
    /// Bytes in memory.
    memory: i64,
    /// Bytes in the file.
    compressed: i64,
    /// Values of the column.
    values: i64,
    /// Entries of a dictionary.
    entries: i64,
}

fn page(bytes: &[u8]) -> Option<Page> {
    let mut page = Page::default();
    let mut reader = Reader::new(bytes);
    reader.fields(|reader, id, kind| {
        match id {
            2 if thrift::is_integer(kind) => page.memory = reader.integer()?,
            3 if thrift::is_integer(kind) => page.compressed = reader.integer()?,
            5 | 7 | 8 if thrift::is_struct(kind) => {
                let place = match id {
                    7 => &mut page.entries,
                    _ => &mut page.values,
                };
                reader.fields(|reader, id, kind| {
                    let is_it = id == 1 && thrift::is_integer(kind);
                    if is_it {
                        *place = reader.integer()?;
                    }
                    Some(is_it)
                })?;
            }
            _ => return Some(false),
        }
        Some(true)
    })?;
    page.header = reader.position();
    Some(page)
}

#[cfg(test)]
mod tests {
    use super::{Budget, check_pages};

    /// A header of a page: bytes in memory, bytes in the file, and a header of data with a number of values.
    fn page(memory: i32, compressed: u8, kind: u8, values: i32) -> Vec<u8> {
        let mut bytes = vec![0x15, 0, 0x15];
        varint(&mut bytes, memory);
        bytes.extend([0x15, 2 * compressed]);
        bytes.push((kind - 3) << 4 | 12);
        bytes.push(0x15);
        varint(&mut bytes, values);
        bytes.extend([0, 0]);
        bytes.resize(bytes.len() + usize::from(compressed), 0);
        bytes
    }

    fn varint(bytes: &mut Vec<u8>, value: i32) {
        let mut rest = (value << 1 ^ value >> 31) as u32;
        while rest >= 0x80 {
            bytes.push(rest as u8 | 0x80);
            rest >>= 7;
        }
        bytes.push(rest as u8);
    }

    fn message(pages: &[Vec<u8>], rows: u64) -> String {
        let bytes = pages.concat();
        let checked = check_pages(&bytes, rows, &mut Budget::new(&bytes), &|| false);
        checked.map_or_else(
            |(at, problem)| format!("{at}: {problem}"),
            |()| String::new(),
        )
    }

    #[test]
    fn pages_that_hold_too_much_are_refused() {
        let good = page(80, 9, 5, 10);
        assert_eq!(message(&[good.clone(), good.clone()], 20), "");
        let huge = page(i32::MAX, 9, 5, 10);
        assert!(
            message(&[good.clone(), huge.clone()], 20).starts_with("21: declares more than 512 MB")
        );
        // Nobody reads what is behind the last row.
        assert_eq!(message(&[good.clone(), huge], 10), "");
        let half = page(1 << 28, 0, 8, 1);
        assert!(message(&[half.clone(), half.clone()], 9).is_empty());
        assert!(message(&[half.clone(), half.clone(), half], 9).contains("declares more"));
    }

    #[test]
    fn pages_that_are_broken_are_refused() {
        let good = page(80, 9, 5, 10);
        for (pages, expected) in [
            (
                &good[..good.len() - 1],
                "0: a page is longer than its column",
            ),
            (&good[..5], "0: the header of a page is broken"),
            (&page(-1, 0, 5, 1)[..], "0: a page of negative length"),
            (
                &page(1, 0, 5, -1)[..],
                "0: a page of a negative number of values",
            ),
            (
                &page(9, 0, 7, 10)[..],
                "0: a page declares more entries than it has bytes",
            ),
        ] {
            assert_eq!(message(&[pages.to_vec()], 20), expected);
        }
        // A field may be nested to no end.
        let nested = [0xfc].repeat(100_000);
        assert_eq!(message(&[nested], 20), "0: the header of a page is broken");
    }
}
