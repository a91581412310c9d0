//! What can go wrong in the library.

/// Why the library could not do what it was asked.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A coordinate is NaN or infinite.
    #[error("point {index} is ({x}, {y}): coordinates must be finite; remove or repair it")]
    NotFinite {
        /// Index of the point in the caller's numbering, from 0.
        index: usize,
        /// Its abscissa.
        x: f64,
        /// Its ordinate.
        y: f64,
    },
    /// More points than 32-bit half-edge ids can number.
    #[error(
        "{given} points given, but one triangulation holds at most {limit}; split the data into tiles"
    )]
    TooManyPoints {
        /// Number of points given.
        given: usize,
        /// Largest number of points in one triangulation.
        limit: usize,
    },
    /// The caller's [`Watch`](crate::Watch) asked to stop.
    #[error("cancelled")]
    Cancelled,
    /// The threads asked for could not be started.
    #[error("could not start {threads} threads: {reason}")]
    Threads {
        /// Number of threads asked for.
        threads: usize,
        /// What the thread pool said.
        reason: String,
    },
}
