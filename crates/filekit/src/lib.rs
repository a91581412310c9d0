//! Any bytes, for every reader and every way through the library: what must hold of the outcome.
//!
//! A [`Body`] takes bytes for a file, or for the input of a command, and panics if something comes out that must not:
//! numbers that are not finite, tables of different lengths, indices of nothing, files that cannot be read again. An
//! error is always right. There is one list of bodies, [`BODIES`], and two programs that feed them:
//!
//! - `fuzz-files` of this crate breaks [files that are right](seeds) [in many ways](Breaker), the same for a seed on
//!   every machine, and needs no special compiler;
//! - the target `files` in `fuzz/` is guided by coverage and watched by the address sanitizer.
//!
//! Both count memory ([`Meter`]): a body that takes more than its [share](Body::memory) fails, too.

mod bodies;
mod breaker;
mod memory;
mod paths;
mod readers;
mod seeds;

pub use bodies::{BODIES, Body};
pub use breaker::Breaker;
pub use memory::{LIMIT, Meter};
pub use seeds::{Seed, seeds};

/// Leaves panics to the hook that there is, but for those in readers of others, which become errors.
pub fn keep_panics_of_others_quiet() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !delone_io::is_reading_with_others() {
            usual(panic);
        }
    }));
}
