//! Any bytes, read as a VTU mesh, give a mesh whose corners are vertices, or an error.
#![no_main]

use delone_fuzz::check_mesh;
use delone_io::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| check_mesh(Format::Vtu, bytes));
