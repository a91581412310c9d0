//! Where jobs are done: in children of this program, or in Python.

use crate::process::{Fault, Launcher};
use crate::python::{Files, Python};
use serde::de::DeserializeOwned;
use std::io;
use std::time::Duration;

/// What a process of its own can be asked.
pub trait Errand {
    /// What it answers, in JSON.
    type Answer: DeserializeOwned;

    /// Returns the command line that makes a child of this program do it.
    fn to_args(&self) -> Vec<String>;

    /// Returns the words that make the script do it, if it is for Python; what is to be read lies in `files`.
    fn to_words(&self, files: &Files) -> Option<io::Result<Vec<String>>>;
}

/// Does errands, wherever and however.
pub trait Worker<E: Errand> {
    /// Does one, for no longer than `timeout`.
    ///
    /// # Errors
    /// What became of it, if there is no answer.
    fn run(&self, errand: &E, timeout: Duration) -> Result<E::Answer, Fault>;
}

/// Does errands in children of this program, and in Python.
#[derive(Debug)]
pub struct Workshop {
    /// Runs this program.
    pub launcher: Launcher,
    /// Runs the script, if there is a Python.
    pub python: Option<Python>,
}

impl<E: Errand> Worker<E> for Workshop {
    fn run(&self, errand: &E, timeout: Duration) -> Result<E::Answer, Fault> {
        let python = self.python.as_ref();
        let Some((python, words)) = python.and_then(|p| Some((p, errand.to_words(p.files())?)))
        else {
            return self.launcher.answer(&errand.to_args(), timeout);
        };
        let words = words.map_err(|error| Fault::failed("no file", error))?;
        python.answer(words, timeout)
    }
}

/// Answers from thin air and remembers what it was asked.
#[cfg(test)]
pub struct Actor<E, F> {
    /// What it answers.
    pub answer: F,
    /// What it was asked.
    pub asked: std::cell::RefCell<Vec<E>>,
}

#[cfg(test)]
impl<E: Errand + Clone, F: Fn(&E) -> Result<E::Answer, Fault>> Worker<E> for Actor<E, F> {
    fn run(&self, errand: &E, _: Duration) -> Result<E::Answer, Fault> {
        self.asked.borrow_mut().push(errand.clone());
        (self.answer)(errand)
    }
}
