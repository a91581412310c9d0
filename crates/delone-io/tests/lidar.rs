//! Point clouds: exact coordinates, choices, damage.
#![cfg(feature = "las")]

use delone_io::{
    DomainData, Error, PointSet, ReadOptions, Returns, Source, read_domain, read_points,
};
use laz::LasZipCompressor;
use proptest::prelude::*;
use std::io::Cursor;
use std::path::{Path, PathBuf};

fn read(name: &str, bytes: &[u8], options: &ReadOptions) -> Result<PointSet, Error> {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: bytes.to_vec(),
    };
    read_points(&source, options, &())
}

fn read_all(bytes: &[u8]) -> Result<PointSet, Error> {
    read("c.laz", bytes, &ReadOptions::default())
}

fn fixture(name: &str) -> PathBuf {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/lidar");
    data.join(name)
}

fn read_file(path: &Path) -> PointSet {
    let read = read_points(&Source::from_arg(path), &ReadOptions::default(), &());
    read.unwrap_or_else(|error| panic!("{error}"))
}

fn column<'a>(set: &'a PointSet, name: &str) -> &'a [f64] {
    let found = set.attributes.iter().find(|a| a.name == name);
    &found.unwrap_or_else(|| panic!("no {name}")).values
}

/// A cloud that is written here: format 1 or 6, a scale of 0.01 and an offset of 1000.
#[derive(Clone, Debug)]
struct Written {
    format: u8,
    /// x, y, z, class, number of the return, number of returns, whether withheld.
    points: Vec<([i32; 3], u8, [u8; 2], bool)>,
}

impl Written {
    fn lattice(format: u8, count: usize) -> Self {
        let point = |i: usize| {
            let k = i as i32;
            let class = [1, 2, 2, 6][i % 4];
            let returns = [[1, 1], [1, 3], [2, 3], [3, 3], [1, 2]][i % 5];
            ([k * 7, k * k % 101, 500 - k], class, returns, i % 11 == 3)
        };
        let points = (0..count).map(point).collect();
        Self { format, points }
    }

    fn record_length(&self) -> usize {
        if self.format == 6 { 30 } else { 28 }
    }

    fn records(&self) -> Vec<u8> {
        let mut all = Vec::new();
        for (i, (place, class, [number, of], withheld)) in self.points.iter().enumerate() {
            let mut record = vec![0; self.record_length()];
            for k in 0..3 {
                record[4 * k..4 * k + 4].copy_from_slice(&place[k].to_le_bytes());
            }
            record[12] = (i % 50) as u8;
            if self.format == 6 {
                record[14] = number | of << 4;
                record[15] = u8::from(*withheld) << 2;
                record[16] = *class;
            } else {
                record[14] = number | of << 3;
                record[15] = class | u8::from(*withheld) << 7;
            }
            all.extend(record);
        }
        all
    }

    /// Returns a header of version 1.2 or 1.4 for points that begin at `start`.
    fn header(&self, start: usize, compression: u8, variable: u32) -> Vec<u8> {
        let is_long = self.format == 6;
        let mut h = vec![0; if is_long { 375 } else { 227 }];
        let length = h.len() as u16;
        let put = |h: &mut Vec<u8>, at: usize, bytes: &[u8]| {
            h[at..at + bytes.len()].copy_from_slice(bytes);
        };
        put(&mut h, 0, b"LASF");
        put(&mut h, 24, &[1, if is_long { 4 } else { 2 }]);
        put(&mut h, 94, &length.to_le_bytes());
        put(&mut h, 96, &(start as u32).to_le_bytes());
        put(&mut h, 100, &variable.to_le_bytes());
        put(&mut h, 104, &[self.format | compression]);
        put(&mut h, 105, &(self.record_length() as u16).to_le_bytes());
        let count = self.points.len();
        match is_long {
            true => put(&mut h, 247, &(count as u64).to_le_bytes()),
            false => put(&mut h, 107, &(count as u32).to_le_bytes()),
        }
        for k in 0..3 {
            put(&mut h, 131 + 8 * k, &0.01f64.to_le_bytes());
            put(&mut h, 155 + 8 * k, &1000f64.to_le_bytes());
        }
        h
    }

    fn las(&self) -> Vec<u8> {
        let length = if self.format == 6 { 375 } else { 227 };
        let mut bytes = self.header(length, 0, 0);
        bytes.extend(self.records());
        bytes
    }

    /// Compresses in chunks of so many points; `None` ends chunks after 1, 2, 3 … points.
    fn laz(&self, chunk: Option<u32>) -> Vec<u8> {
        let vlr = laz::LazVlrBuilder::default()
            .with_point_format(self.format, 0)
            .expect("format");
        let vlr = match chunk {
            Some(points) => vlr.with_fixed_chunk_size(points).build(),
            None => vlr.with_variable_chunk_size().build(),
        };
        let mut data = Vec::new();
        vlr.write_to(&mut data).expect("vlr");
        let length = if self.format == 6 { 375 } else { 227 };
        let start = length + 54 + data.len();
        let mut bytes = self.header(start, 0x80, 1);
        let mut head = [0; 54];
        head[2..16].copy_from_slice(b"laszip encoded");
        head[18..20].copy_from_slice(&22204u16.to_le_bytes());
        head[20..22].copy_from_slice(&(data.len() as u16).to_le_bytes());
        bytes.extend(head);
        bytes.extend(data);
        let mut cursor = Cursor::new(bytes);
        cursor.set_position(start as u64);
        let mut compressor = LasZipCompressor::new(&mut cursor, vlr).expect("compressor");
        let records = self.records();
        let mut rest = &records[..];
        let mut size = 1;
        while !rest.is_empty() && chunk.is_none() {
            let now = (size * self.record_length()).min(rest.len());
            compressor.compress_many(&rest[..now]).expect("points");
            rest = &rest[now..];
            size += 1;
            if !rest.is_empty() {
                compressor.finish_current_chunk().expect("chunk");
            }
        }
        compressor.compress_many(rest).expect("points");
        compressor.done().expect("done");
        drop(compressor);
        cursor.into_inner()
    }
}

#[test]
fn points_are_what_exact_arithmetic_says() {
    for name in ["one", "seven"] {
        let expected = read_file(&fixture(&format!("{name}.csv")));
        assert_eq!(expected.points.len(), 237);
        for extension in ["las", "laz"] {
            let found = read_file(&fixture(&format!("{name}.{extension}")));
            assert_eq!(found.points, expected.points, "{name}.{extension}");
            for attribute in &expected.attributes {
                let values = column(&found, &attribute.name);
                assert_eq!(values, attribute.values, "{name} {}", attribute.name);
            }
            assert_eq!(found.attributes.len(), expected.attributes.len());
        }
    }
}

#[test]
fn clouds_of_others_have_the_points_of_their_text() {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let root = std::env::var_os("DELONE_SHARED").map_or_else(beside, PathBuf::from);
    for (name, count) in [("autzen-thin", 10_653), ("epsg_4326", 5380)] {
        let path = root.join("data/lidar").join(name);
        if !path.with_extension("las").is_file() {
            eprintln!("skipped: the shared data are absent (set DELONE_SHARED)");
            return;
        }
        let cloud = read_file(&path.with_extension("las"));
        let text = read_file(&path.with_extension("xyz"));
        assert_eq!(cloud.points.len(), count);
        // The text has six places, one less than the degrees of the second cloud.
        let near = match name {
            "autzen-thin" => 0.0,
            _ => 6e-7,
        };
        let heights = column(&cloud, "z").iter().zip(column(&text, "z"));
        for ((p, q), (z, height)) in cloud.points.iter().zip(&text.points).zip(heights) {
            let apart = [p.x - q.x, p.y - q.y, z - height];
            assert!(
                apart.iter().all(|d| d.abs() <= near),
                "{name}: {p:?} {q:?} {z} {height}"
            );
        }
    }
}

#[test]
fn chunks_of_any_kind_are_read() {
    for format in [1, 6] {
        let written = Written::lattice(format, 300);
        let expected = read_all(&written.las()).expect("las");
        assert!(expected.points.len() > 250);
        for chunk in [Some(1), Some(7), Some(100), Some(300), Some(50_000), None] {
            let found = read_all(&written.laz(chunk));
            let found = found.unwrap_or_else(|error| panic!("{format} {chunk:?}: {error}"));
            assert_eq!(found, expected, "{format} {chunk:?}");
        }
    }
}

#[test]
fn a_table_of_chunks_may_stand_at_the_very_end_or_be_absent() {
    let written = Written::lattice(1, 300);
    let expected = read_all(&written.las()).expect("las");
    let mut bytes = written.laz(Some(40));
    let start = u32::from_le_bytes(bytes[96..100].try_into().expect("four")) as usize;
    let table: [u8; 8] = bytes[start..start + 8].try_into().expect("eight");
    bytes[start..start + 8].copy_from_slice(&(-1i64).to_le_bytes());
    let absent = bytes.clone();
    bytes.extend(table);
    assert_eq!(read_all(&bytes).expect("at the end"), expected);
    // Chunks of equal size need no table.
    assert_eq!(read_all(&absent).expect("absent"), expected);
    let mut variable = written.laz(None);
    variable[start..start + 8].copy_from_slice(&(-1i64).to_le_bytes());
    let message = read_all(&variable).expect_err("no table").to_string();
    assert!(
        message.contains("the table of chunks is missing or broken"),
        "{message}"
    );
}

#[test]
fn classes_and_returns_choose() {
    for format in [1, 6] {
        let written = Written::lattice(format, 220);
        let count = |keep: &dyn Fn(u8, [u8; 2]) -> bool| {
            let kept = written.points.iter();
            kept.filter(|(_, class, returns, withheld)| !withheld && keep(*class, *returns))
                .count()
        };
        let options = |classes: &[u8], returns| ReadOptions {
            classes: classes.to_vec(),
            returns,
            ..ReadOptions::default()
        };
        for (options, expected) in [
            (options(&[], Returns::All), count(&|_, _| true)),
            (options(&[2], Returns::All), count(&|c, _| c == 2)),
            (options(&[1, 6], Returns::All), count(&|c, _| c != 2)),
            (options(&[], Returns::First), count(&|_, [n, _]| n == 1)),
            (options(&[], Returns::Last), count(&|_, [n, of]| n == of)),
            (options(&[], Returns::Single), count(&|_, [_, of]| of == 1)),
            (
                options(&[2], Returns::Last),
                count(&|c, [n, of]| c == 2 && n == of),
            ),
        ] {
            for bytes in [written.las(), written.laz(Some(50))] {
                let found = read("c.las", &bytes, &options).expect("points");
                assert_eq!(found.points.len(), expected, "{format} {options:?}");
            }
        }
        let none = read("c.las", &written.las(), &options(&[9], Returns::All));
        assert_eq!(
            none.expect_err("no water").to_string(),
            "c.las: none of the points is of the classes and returns asked for; there are classes 1, 2, 6"
        );
    }
}

#[test]
fn attributes_that_do_not_vary_are_left_out() {
    let mut written = Written::lattice(1, 30);
    for point in &mut written.points {
        (point.1, point.2) = (2, [1, 1]);
    }
    let names =
        |set: &PointSet| -> Vec<String> { set.attributes.iter().map(|a| a.name.clone()).collect() };
    let set = read_all(&written.las()).expect("las");
    assert_eq!(names(&set), ["z", "classification", "intensity"]);
}

#[test]
fn clouds_are_domains_and_need_no_name() {
    let folder = tempfile::tempdir().expect("folder");
    let path = folder.path().join("cloud");
    let written = Written::lattice(6, 50);
    std::fs::write(&path, written.laz(Some(20))).expect("write");
    let source = Source::from_arg(&path);
    let set = read_points(&source, &ReadOptions::default(), &()).expect("points");
    assert_eq!(set, read_all(&written.las()).expect("las"));
    let domain = read_domain(&source, &ReadOptions::default(), &()).expect("domain");
    assert_eq!(domain, DomainData::from(set.clone()));
    let in_memory = read("cloud", &written.laz(Some(20)), &ReadOptions::default());
    assert_eq!(in_memory.expect("by content"), set);
}

#[test]
fn what_is_wrong_is_said() {
    let las = Written::lattice(1, 20).las();
    let laz = Written::lattice(1, 20).laz(Some(8));
    let with = |bytes: &[u8], at: usize, new: &[u8]| {
        let mut bytes = bytes.to_vec();
        bytes[at..at + new.len()].copy_from_slice(new);
        bytes
    };
    let start = u32::from_le_bytes(laz[96..100].try_into().expect("four")) as usize;
    let table = u64::from_le_bytes(laz[start..start + 8].try_into().expect("eight")) as usize;
    for (bytes, message) in [
        (Vec::new(), "the file is empty"),
        (
            b"LAZ?".to_vec(),
            "c.laz at byte 0: not a point cloud: the file does not begin with LASF",
        ),
        (
            las[..100].to_vec(),
            "c.laz at byte 100: truncated: the file ends within the header",
        ),
        (
            las[..500].to_vec(),
            "c.laz: truncated: header says 20 points, file has 9",
        ),
        (
            with(&las, 107, &u32::MAX.to_le_bytes()),
            "c.laz: truncated: header says 4294967295 points, file has 20",
        ),
        (
            with(&las, 24, &[3]),
            "c.laz at byte 24: version 3.2: known are 1.0 to 1.4",
        ),
        (
            with(&las, 104, &[11]),
            "c.laz at byte 104: point format 11: known are 0 to 10",
        ),
        (
            with(&las, 105, &[27, 0]),
            "c.laz at byte 105: records of 27 bytes: those of format 1 have 28 or more",
        ),
        (
            with(&las, 96, &9999u32.to_le_bytes()),
            "c.laz at byte 94: header of 227 bytes, points at byte 9999 of 787: cannot be",
        ),
        (
            with(&las, 139, &0f64.to_le_bytes()),
            "c.laz at byte 139: scale 0 and offset 1000 of y: the scale must not be 0",
        ),
        (
            with(&las, 155, &f64::NAN.to_le_bytes()),
            "c.laz at byte 131: scale 0.01 and offset NaN of x: must be finite",
        ),
        (
            with(&las, 104, &[0x81]),
            "c.laz at byte 227: compressed, but without the record that tells how; was it renamed or cut off?",
        ),
        (
            laz[..start + 200].to_vec(),
            "c.laz: truncated: header says 20 points, file has",
        ),
        (
            with(&laz, 107, &21u32.to_le_bytes()),
            "chunk 2 (from 0) is broken: its points do not end where it ends; get the file once more",
        ),
        (
            with(&laz, table + 4, &u32::MAX.to_le_bytes()),
            "the table of chunks is broken: 4294967295 do not fit into the file",
        ),
        (
            with(&laz, 227 + 54 + 34, &[7, 0]),
            "the record of LASzip is broken: its fields are not those of the points",
        ),
    ] {
        let found = read_all(&bytes).expect_err(message).to_string();
        assert!(found.contains(message), "{found:?} lacks {message:?}");
    }
}

/// A bit that has flipped in a pointwise chunk shows by where the chunk ends, most often.
#[test]
fn broken_chunks_are_noticed() {
    for format in [1, 6] {
        let written = Written::lattice(format, 400);
        let whole = written.laz(Some(50));
        let expected = read_all(&whole).expect("whole");
        let start = u32::from_le_bytes(whole[96..100].try_into().expect("four")) as usize;
        let (mut errors, mut silent) = (0, 0);
        for at in (start + 8..whole.len() - 40).step_by(17) {
            let mut bytes = whole.clone();
            bytes[at] ^= 0x10;
            match read_all(&bytes) {
                Err(_) => errors += 1,
                Ok(set) => silent += usize::from(set != expected),
            }
        }
        assert!(errors > 5, "{format}: {errors} errors, {silent} silent");
    }
}

#[test]
fn files_cut_anywhere_are_errors() {
    for format in [1, 6] {
        let written = Written::lattice(format, 60);
        for bytes in [written.las(), written.laz(Some(16)), written.laz(None)] {
            let table = 40; // Without the table, chunks of equal size are still whole.
            for end in (0..bytes.len() - table).step_by(7) {
                assert!(read_all(&bytes[..end]).is_err(), "{format} cut at {end}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn damage_does_no_harm(
        format in prop::sample::select(vec![1u8, 6]),
        kind in 0..3,
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let written = Written::lattice(format, 60);
        let mut bytes = match kind {
            0 => written.las(),
            1 => written.laz(Some(16)),
            _ => written.laz(None),
        };
        for (at, byte) in damage {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        drop(read_all(&bytes));
    }
}
