//! What can go wrong, in the words of whoever noticed it, and where: so that a page can show it on the drawing.

mod marks;

use crate::drawing::Drawing;
use delone::Pslg;
use js_sys::{Error, Float64Array, Object, Reflect, Uint32Array};
pub use marks::Marks;
use wasm_bindgen::JsValue;

/// Crossings, and vertices on segments, that are looked for if segments cross.
const MOST_FACTS: usize = 10_000;

/// Why something cannot be done.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Trouble {
    /// The library refuses the input.
    #[error(transparent)]
    Refused(#[from] delone::Error),
    /// The library refuses a drawing.
    #[error("{error}")]
    Drawn {
        /// Why.
        #[source]
        error: delone::Error,
        /// Where.
        marks: Box<Marks>,
    },
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] delone_io::Error),
    /// A log is not that of a run.
    #[error(transparent)]
    Unfit(#[from] delone::NoSuchStep),
    /// Options are no JSON, or not those there are.
    #[error("options: {0}")]
    Options(#[from] serde_json::Error),
    /// Edits are no JSON, or no list.
    #[error("edits: {0}")]
    Edits(#[source] serde_json::Error),
    /// Something is asked for that is not there, or would be too much.
    #[error("{0}")]
    Asked(String),
}

impl Trouble {
    /// Refuses what is asked for.
    pub(crate) fn asked(message: impl Into<String>) -> Self {
        Self::Asked(message.into())
    }

    /// Tells where in a drawing lies what the library refuses: points by their places, and if segments cross,
    /// not the first two alone.
    pub(crate) fn of_drawing(error: delone::Error, drawing: &Drawing) -> Self {
        let mut marks = Marks::of(&error);
        if let delone::Error::Crossing { .. } = error {
            let graph = Pslg {
                points: drawing.data.vertices.points.clone(),
                segments: drawing.data.segments.clone(),
                ..Pslg::default()
            };
            if let Ok(facts) = graph.facts(MOST_FACTS, &()) {
                marks.add_crossings(&facts);
            }
        }
        marks.place_points(&drawing.data.vertices.points);
        let marks = marks.into();
        Self::Drawn { error, marks }
    }

    /// Tells where the trouble is, as far as that is known.
    pub(crate) fn marks(&self) -> Marks {
        match self {
            Self::Refused(error) => Marks::of(error),
            Self::Drawn { marks, .. } => (**marks).clone(),
            Self::File(error) => Marks::of_file(error),
            _ => Marks::default(),
        }
    }
}

/// An `Error` with a message for people, and the properties `places` (x, y, x, y, …), `segments` and `points`
/// (numbers), all three perhaps empty, and `line`, if one of a file is to blame.
impl From<Trouble> for JsValue {
    fn from(trouble: Trouble) -> Self {
        let error: Object = Error::new(&trouble.to_string()).into();
        let marks = trouble.marks();
        let set = |name: &str, value: Self| {
            // Only a frozen object refuses, and this one is new.
            let _ = Reflect::set(&error, &name.into(), &value);
        };
        set("places", Float64Array::from(&marks.places[..]).into());
        set("segments", Uint32Array::from(&marks.segments[..]).into());
        set("points", Uint32Array::from(&marks.points[..]).into());
        if let Some(line) = marks.line {
            set("line", Self::from_f64(line as f64));
        }
        error.into()
    }
}
