//! Any bytes, read as `table`, give points or an error: no panic, no allocation out of proportion.
#![no_main]

use delone_io::{Format, ReadOptions, Source, read_points};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let options = ReadOptions {
        format: Some(Format::Table),
        ..ReadOptions::default()
    };
    let source = Source::Memory {
        name: "fuzz".to_owned(),
        bytes: bytes.to_vec(),
    };
    if let Ok(set) = read_points(&source, &options, &()) {
        assert!(set.points.iter().all(delone::Point::is_finite));
        assert!(set.attributes.iter().all(|a| a.values.len() == set.points.len()));
    }
});
