//! Any bytes, read as a VTU mesh, give a mesh whose corners are vertices, or an error.
#![no_main]

use delone_io::{Format, ReadOptions, Source, read_mesh};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let options = ReadOptions {
        format: Some(Format::Vtu),
        ..ReadOptions::default()
    };
    let source = Source::Memory {
        name: "fuzz".to_owned(),
        bytes: bytes.to_vec(),
    };
    if let Ok(mesh) = read_mesh(&source, &options, &()) {
        let n = mesh.vertices.points.len();
        assert!(mesh.triangles.as_flattened().iter().all(|v| v.index() < n));
    }
});
