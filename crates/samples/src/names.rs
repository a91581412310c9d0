//! Finds what commands and tables call by name.

/// A name that nothing has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no {kind} is called `{given}`; there are {known}")]
pub struct UnknownName {
    kind: &'static str,
    given: String,
    known: String,
}

/// Returns the one of `all` that is called `given`; `kind` says in an error what was looked for.
pub(crate) fn find<T: Copy>(
    kind: &'static str,
    all: &[T],
    name: impl Fn(T) -> &'static str,
    given: &str,
) -> Result<T, UnknownName> {
    let found = all.iter().copied().find(|&item| name(item) == given);
    found.ok_or_else(|| UnknownName {
        kind,
        given: given.to_owned(),
        known: all
            .iter()
            .map(|&item| name(item))
            .collect::<Vec<_>>()
            .join(", "),
    })
}
