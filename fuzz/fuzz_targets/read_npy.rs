//! Any bytes, read as `npy`, give points or an error: no panic, no allocation out of proportion.
#![no_main]

use delone_fuzz::check_points;
use delone_io::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| check_points(Format::Npy, bytes));
