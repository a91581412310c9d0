//! What can go wrong, in the words of whoever noticed it.

use wasm_bindgen::{JsError, JsValue};

/// Why something cannot be done.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Trouble {
    /// The library refuses the input.
    #[error(transparent)]
    Refused(#[from] delone::Error),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] delone_io::Error),
    /// A log is not that of a run.
    #[error(transparent)]
    Unfit(#[from] delone::NoSuchStep),
    /// Options are no JSON, or not those there are.
    #[error("options: {0}")]
    Options(#[from] serde_json::Error),
    /// Something is asked for that is not there, or would be too much.
    #[error("{0}")]
    Asked(String),
}

impl Trouble {
    /// Refuses what is asked for.
    pub(crate) fn asked(message: impl Into<String>) -> Self {
        Self::Asked(message.into())
    }
}

impl From<Trouble> for JsValue {
    fn from(trouble: Trouble) -> Self {
        JsError::new(&trouble.to_string()).into()
    }
}
