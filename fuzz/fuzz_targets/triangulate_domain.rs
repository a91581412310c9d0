//! Points and segments from bytes: triangulated as a domain, checked, built again in another order,
//! and, if there are few, compared with the definitions.

#![no_main]

use delone_testkit::fuzz::Case;
use delone_testkit::fuzz::segments::{check, domain_from_bytes};
use libfuzzer_sys::fuzz_target;

/// Above these numbers the oracles would slow the fuzzer down.
const MAX_NAIVE: [usize; 2] = [9, 6];

fuzz_target!(|bytes: &[u8]| {
    let domain = domain_from_bytes(bytes);
    let [points, segments] = [domain.pslg.points.len(), domain.pslg.segments.len()];
    let is_deep = points <= MAX_NAIVE[0] && segments <= MAX_NAIVE[1];
    if let Err(reason) = check(&domain, is_deep, bytes.len() as u64) {
        panic!("{reason}\n{}", domain.as_source());
    }
});
