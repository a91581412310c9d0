//! Any bytes, for the body of `delone-filekit` that the environment variable `DELONE_BODY` names: every reader and
//! every command has one, and a program of its own for each would only take longer to build.
#![no_main]

use delone_filekit::Body;
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

fuzz_target!(|bytes: &[u8]| {
    static BODY: OnceLock<&Body> = OnceLock::new();
    let body = BODY.get_or_init(|| {
        // The hook of libFuzzer ends the program, even if the panic is going to be caught.
        delone_filekit::keep_panics_of_others_quiet();
        let name = std::env::var("DELONE_BODY").expect("DELONE_BODY names no body");
        Body::named(&name).unwrap_or_else(|| panic!("no body is called {name}"))
    });
    body.run(bytes);
});
