//! Points and edits from bytes: edited live, and compared with what is made from scratch after each.

#![no_main]

use delone_testkit::fuzz::Case;
use delone_testkit::fuzz::edit::{check, script_from_bytes};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let script = script_from_bytes(bytes);
    if let Err(reason) = check(&script) {
        panic!("{reason}\n{}", script.as_source());
    }
});
