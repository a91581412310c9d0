//! Points from bytes: triangulated, validated, and compared with the other builder and, if there
//! are few, with the definition.

#![no_main]

use delone_testkit::fuzz::points::{Depth, check, points_from_bytes};
use libfuzzer_sys::fuzz_target;

/// Above this the O(n⁴) oracle would slow the fuzzer down.
const MAX_NAIVE: usize = 10;

fuzz_target!(|bytes: &[u8]| {
    let points = points_from_bytes(bytes);
    let seed = bytes.len() as u64;
    let depth = if points.len() <= MAX_NAIVE {
        Depth::Naive(seed)
    } else {
        Depth::Incremental(seed)
    };
    if let Err(reason) = check(&points, depth) {
        panic!("{reason}: {points:?}");
    }
});
