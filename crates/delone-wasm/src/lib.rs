//! The browser module: all that the theatre needs of Delone, in memory.
//!
//! - [`drawing`]: points, segments and holes: given, read from a file's bytes, or a preset.
//! - [`play`]: a classical algorithm at work, played forwards and backwards.
//! - [`look`]: what lies at a place, for whoever points at it.
//! - [`mesh`]: the library's own triangulation and refinement.
//! - [`save`]: every format, as bytes; [`formats`]: which these are.
//!
//! Long lists cross as typed arrays: coordinates as `Float64Array` (x, y, x, y, …), indices as `Uint32Array`.
//! Whatever has a structure crosses as JSON text, with keys in camel case; options are JSON objects in which every
//! key may be left out, and an unknown one is an error. Every failure is a JavaScript `Error` whose message is
//! meant for people, with the properties `places` (x, y, …), `segments` and `points` (numbers) that it is about, and
//! perhaps `line`.
//!
//! Everything runs on the thread of the caller, which should be a worker's for large inputs, and gives the result
//! that the command line gives, bit for bit.

mod bounds;
pub mod drawing;
pub mod formats;
mod json;
pub mod look;
pub mod mesh;
pub mod play;
mod progress;
pub mod save;
mod trouble;

pub use trouble::{Marks, Trouble};

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_namespace = console, js_name = error)]
    fn console_error(message: &str);
}

/// Called once, when the module is loaded: a bug is told to the console, with its place.
#[wasm_bindgen(start)]
pub fn start() {
    if cfg!(target_family = "wasm") {
        std::panic::set_hook(Box::new(|info| console_error(&format!("delone: {info}"))));
    }
}

/// Returns the version of the library.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").to_owned()
}
