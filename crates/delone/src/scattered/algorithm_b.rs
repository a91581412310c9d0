//! Algorithm B (chapter 3.34 to 3.37): vertices on edges.

use super::Cover;
use super::field::Field;
use crate::{Error, Observer};

/// Its pseudocode.
pub(crate) const CODE_B: &[&str] = &[];

/// Runs it.
pub(super) fn run(field: &mut Field<impl Observer>, options: &Cover) -> Result<(), Error> {
    let _ = (field, options);
    Ok(())
}
