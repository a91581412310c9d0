//! Progress and cancellation of long work.

/// The phases of long work, from file to picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Phase {
    /// Reading input; units are bytes.
    Read,
    /// Sorting the points along the space-filling curve.
    Sort,
    /// Dividing and conquering.
    Triangulate,
    /// Cutting segments where they cross.
    Node,
    /// Inserting segments.
    Constrain,
    /// Finding the domain, its holes and regions.
    Carve,
    /// Refining; units are vertices, and nobody knows beforehand how many it will take: the total is an
    /// estimate.
    Refine,
    /// Moving vertices to better places.
    Smooth,
    /// Renumbering into the caller's order.
    Export,
    /// Making and clipping Voronoi cells.
    Voronoi,
    /// Relaxing points towards the centers of their cells; units are steps.
    Relax,
    /// Reading graphs off a triangulation; units are edges.
    Proximity,
    /// Shortening a tour; units are vertices, and nobody knows beforehand how many are looked at again.
    Tour,
    /// Splitting clusters; units are clusters, and fewer may be enough.
    Cluster,
    /// Covering data with triangles; units are triangles, and nobody knows beforehand how many it will take: the
    /// total is an estimate.
    Cover,
    /// Verifying a triangulation.
    Check,
    /// Answering queries: where points lie, what is nearest to them.
    Query,
    /// Evaluating a surface at many points, or preparing that.
    Interpolate,
    /// Following contour lines.
    Contour,
    /// Drawing a picture.
    Draw,
    /// Writing files.
    Write,
}

/// Someone who watches long work: is told how far it has come, and may stop it.
///
/// The methods are called from several threads, many times a second; work ends within 100 ms of
/// [`is_cancelled`](Self::is_cancelled) saying so. Longer without asking go only the last merges and the
/// export of tens of millions of points on one convex curve, whose hull is everything; one single
/// segment that crosses a million edges; and the sorting of millions of crossings.
pub trait Watch: Sync {
    /// Told that `done` of `total` units of `phase` are finished; calls may come out of order.
    fn progress(&self, phase: Phase, done: u64, total: u64) {
        let _ = (phase, done, total);
    }

    /// Asked whether to give up; once true, the work ends soon with [`Error::Cancelled`](crate::Error::Cancelled).
    fn is_cancelled(&self) -> bool {
        false
    }
}

/// Watches nothing and never cancels.
impl Watch for () {}
