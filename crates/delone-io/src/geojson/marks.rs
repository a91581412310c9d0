//! Writing troubles: a feature each.

use super::write::List;
use crate::target::Output;
use crate::troubles::write_feature;
use crate::{Error, Mark};

/// Writes a feature for each trouble, where it is.
pub(crate) fn write_marks(out: &mut Output<'_>, marks: &[Mark]) -> Result<(), Error> {
    let mut list = List::begin(out)?;
    for mark in marks {
        list.next(|out| write_feature(out, mark))?;
    }
    list.end()
}
