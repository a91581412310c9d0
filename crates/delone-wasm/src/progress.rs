//! Progress, told to a JavaScript function, which may stop the work.

use delone::{Phase, Watch};
use js_sys::Function;
use std::cell::RefCell;
use wasm_bindgen::JsValue;

thread_local! {
    /// Whoever is to be told; a watch must be `Sync`, and a function is not.
    static LISTENER: RefCell<Option<Listener>> = const { RefCell::new(None) };
}

struct Listener {
    function: Function,
    has_stopped: bool,
}

/// Tells a function of progress as long as it lives: `(phase, done, total)`. The work stops once the function
/// returns `false` or throws.
pub(crate) struct Progress(());

impl Progress {
    pub fn told_to(function: Option<Function>) -> Self {
        let listener = function.map(|function| Listener {
            function,
            has_stopped: false,
        });
        LISTENER.set(listener);
        Self(())
    }

    /// Tells that `done` of `total` units of a phase are finished, and asks whether to go on.
    pub fn tell(&self, phase: &str, done: u64, total: u64) -> bool {
        let function = LISTENER.with_borrow(|l| l.as_ref().map(|l| l.function.clone()));
        let Some(function) = function else {
            return true;
        };
        // Called while nothing is borrowed: it may do what it likes.
        let [done, total] = [done, total].map(|n| JsValue::from_f64(n as f64));
        let answer = function.call3(&JsValue::NULL, &JsValue::from_str(phase), &done, &total);
        let goes_on = answer.is_ok_and(|answer| answer != JsValue::FALSE);
        if !goes_on {
            LISTENER.with_borrow_mut(|l| {
                if let Some(listener) = l {
                    listener.has_stopped = true;
                }
            });
        }
        goes_on
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        LISTENER.set(None);
    }
}

impl Watch for Progress {
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        self.tell(&format!("{phase:?}").to_lowercase(), done, total);
    }

    fn is_cancelled(&self) -> bool {
        LISTENER.with_borrow(|l| l.as_ref().is_some_and(|l| l.has_stopped))
    }
}
