//! Any bytes, read as `wkt`, give a domain or an error: no panic, no allocation out of proportion.
#![no_main]

use delone_fuzz::check_domain;
use delone_io::Format;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| check_domain(Format::Wkt, bytes));
