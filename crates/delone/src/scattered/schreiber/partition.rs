//! Points shared out among centers, and how centers are split, points reassigned and centers moved.
//!
//! *Nearest* is what has the least rounded [`square`] of the distance; of equal ones the lowest number. Reassigning
//! looks only at who can change, and finds what looking at everybody would:
//!
//! - Between two centers that have not moved since points were last reassigned nothing changes. So a point whose
//!   center has not moved is compared with those that have, and only a point whose center has moved with all.
//! - A center that is further from the point's own than twice the point is, is not nearer. So centers are tried
//!   in the order of their distance from the own one, and the trial ends at the first that is too far
//!   ([`reach`], with room for rounding). After Elkan (2003).

use super::cell::{Cell, mean};
use super::rows::{Rows, reach, square};
use crate::observe::{Cut, Event, Observer};
use crate::{Error, Phase, Point, Watch};

/// Steps between two looks at the watch.
const STRIDE: usize = 1 << 16;

/// Centers and the points that each has.
pub(super) struct Partition<'a, O, const D: usize> {
    rows: &'a Rows<'a, D>,
    centers: Vec<f64>,
    pub cells: Vec<Cell>,
    /// Whether a center has moved, or is new, since points were last reassigned.
    has_moved: Vec<bool>,
    teller: Teller<'a, O>,
}

/// Who is told how far it has come, and what happens.
pub(super) struct Teller<'a, O> {
    pub watch: &'a dyn Watch,
    /// How many clusters are expected.
    pub total: u64,
    pub observer: O,
    pub steps: usize,
}

impl<'a, O: Observer, const D: usize> Partition<'a, O, D> {
    /// Gives all points, which must be some, to their mean.
    pub fn new(rows: &'a Rows<'a, D>, teller: Teller<'a, O>) -> Self {
        let members: Vec<u32> = (0..rows.len() as u32).collect();
        let mut partition = Self {
            rows,
            centers: mean(rows, &members),
            cells: vec![Cell::of(members)],
            has_moved: vec![false],
            teller,
        };
        partition.tell_moved(0, None);
        partition.measure(0);
        partition
    }

    pub fn center(&self, cluster: usize) -> &[f64] {
        center(&self.centers, self.rows.dim(), cluster)
    }

    /// Returns the centers, one after the other.
    pub fn centers(&self) -> &[f64] {
        &self.centers
    }

    /// Returns the cluster of largest error; of equal ones that of lowest number.
    pub fn worst(&self) -> usize {
        let error = |cluster: usize| self.cells[cluster].error;
        let worse = |worst: usize, other: usize| match error(other) > error(worst) {
            true => other,
            false => worst,
        };
        (0..self.cells.len()).fold(0, worse)
    }

    /// Cuts a cluster, whose error must not be 0, in two: puts centers at the means of both parts.
    pub fn split(&mut self, cluster: usize) -> Result<(), Error> {
        let new = self.cells.len();
        let old = self.center(cluster).to_vec();
        let (at, members) = self.cells[cluster].cut(self.rows, &old);
        self.tell_split([cluster, new], at);
        let near = mean(self.rows, &self.cells[cluster].members);
        self.move_to(cluster, &near);
        self.teller.ask()?;
        self.centers.extend(mean(self.rows, &members));
        self.cells.push(Cell::of(members));
        self.has_moved.push(true);
        self.tell_moved(new, None);
        [cluster, new].into_iter().for_each(|c| self.measure(c));
        self.teller.tell_progress(new + 1)
    }

    /// Gives each point to the nearest center, and moves each center whose points have changed to their mean; tells
    /// whether any point has changed. A center without points stays.
    pub fn relax(&mut self) -> Result<bool, Error> {
        let changed = self.reassign()?;
        self.has_moved.fill(false);
        for (cluster, _) in changed.iter().enumerate().filter(|(_, changed)| **changed) {
            let members = &self.cells[cluster].members;
            self.teller.step(members.len())?;
            if !members.is_empty() {
                let mean = mean(self.rows, members);
                self.move_to(cluster, &mean);
            }
            self.measure(cluster);
        }
        Ok(changed.contains(&true))
    }

    /// Gives each point to the nearest center, and tells which clusters have others than before.
    fn reassign(&mut self) -> Result<Vec<bool>, Error> {
        let moved: Vec<usize> = (0..self.cells.len())
            .filter(|&c| self.has_moved[c])
            .collect();
        let mut changed = vec![false; self.cells.len()];
        let mut transfers = Vec::new();
        for (cluster, has_changed) in changed.iter_mut().enumerate() {
            let known = transfers.len();
            let rivals = match self.has_moved[cluster] {
                true => self.rivals(cluster, 0..self.cells.len()),
                false => self.rivals(cluster, moved.iter().copied()),
            };
            self.teller.step(moved.len())?;
            if !rivals.is_empty() {
                self.send_off(cluster, &rivals, &mut transfers)?;
            }
            *has_changed = transfers.len() > known;
        }
        // By cluster, and within it by number.
        transfers.sort_unstable();
        for arrivals in transfers.chunk_by(|a, b| a.0 == b.0) {
            let cluster = arrivals[0].0 as usize;
            let members = &mut self.cells[cluster].members;
            members.extend(arrivals.iter().map(|(_, point)| point));
            // Two ascending runs, which a stable sort merges.
            members.sort();
            changed[cluster] = true;
        }
        Ok(changed)
    }

    /// Finds those of the centers `among` which some point of a cluster may be nearer to, by their distance from its
    /// center.
    fn rivals(&self, cluster: usize, among: impl Iterator<Item = usize>) -> Vec<(f64, u32)> {
        let own = self.center(cluster);
        let reach = reach(self.cells[cluster].radius, self.rows.dim());
        let distance = |other: usize| (square(own, self.center(other)), other as u32);
        let others = among.filter(|&other| other != cluster).map(distance);
        let mut rivals: Vec<_> = others.filter(|(far, _)| *far <= reach).collect();
        rivals.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        rivals
    }

    /// Takes those points out of a cluster that are nearer to one of the rivals of its center, and lists where they
    /// go.
    fn send_off(
        &mut self,
        cluster: usize,
        rivals: &[(f64, u32)],
        transfers: &mut Vec<(u32, u32)>,
    ) -> Result<(), Error> {
        let dim = self.rows.dim();
        let own = center(&self.centers, dim, cluster);
        let members = &mut self.cells[cluster].members;
        let mut kept = 0;
        for i in 0..members.len() {
            let point = members[i];
            let row = self.rows.row(point);
            let here = square(row, own);
            let reach = reach(here, dim);
            let mut nearest = (here, cluster as u32);
            let near = rivals.iter().take_while(|(far, _)| *far <= reach);
            let mut tried = 1;
            for &(_, rival) in near {
                let there = square(row, center(&self.centers, dim, rival as usize));
                if (there, rival) < nearest {
                    nearest = (there, rival);
                }
                tried += 1;
            }
            if nearest.1 == cluster as u32 {
                members[kept] = point;
                kept += 1;
            } else {
                transfers.push((nearest.1, point));
            }
            self.teller.step(tried)?;
        }
        members.truncate(kept);
        Ok(())
    }

    fn measure(&mut self, cluster: usize) {
        let center = center(&self.centers, self.rows.dim(), cluster);
        self.cells[cluster].measure(self.rows, center);
    }

    /// Moves a center, if it is not there already.
    fn move_to(&mut self, cluster: usize, to: &[f64]) {
        if self.center(cluster) == to {
            return;
        }
        let from = self.center(cluster).to_vec();
        let first = cluster * self.rows.dim();
        self.centers[first..first + to.len()].copy_from_slice(to);
        self.has_moved[cluster] = true;
        self.tell_moved(cluster, Some(&from));
    }

    fn tell_moved(&mut self, cluster: usize, from: Option<&[f64]>) {
        let Self { rows, teller, .. } = self;
        let to = center(&self.centers, rows.dim(), cluster);
        if rows.dim() == 2 {
            teller.observer.tell(0, || Event::ClusterMoved {
                cluster: cluster as u32,
                from: from.map(|from| point(rows, from)),
                to: Some(point(rows, to)),
            });
        }
    }

    fn tell_split(&mut self, clusters: [usize; 2], at: f64) {
        let (rows, axis) = (self.rows, self.cells[clusters[0]].axis);
        if rows.dim() == 2 {
            self.teller.observer.tell(0, || {
                let at = rows.given(&[at])[0];
                Event::ClusterSplit {
                    clusters: clusters.map(|c| c as u32),
                    cut: match axis {
                        0 => Cut::Vertical(at),
                        _ => Cut::Horizontal(at),
                    },
                }
            });
        }
    }
}

impl<O> Teller<'_, O> {
    /// Counts steps of work, and asks now and then whether to give up.
    #[inline]
    fn step(&mut self, steps: usize) -> Result<(), Error> {
        self.steps += steps;
        if self.steps < STRIDE {
            return Ok(());
        }
        self.steps = 0;
        self.ask()
    }

    #[cold]
    fn ask(&self) -> Result<(), Error> {
        match self.watch.is_cancelled() {
            true => Err(Error::Cancelled),
            false => Ok(()),
        }
    }

    fn tell_progress(&self, clusters: usize) -> Result<(), Error> {
        let done = (clusters as u64).min(self.total);
        self.watch.progress(Phase::Cluster, done, self.total);
        self.ask()
    }
}

#[inline]
fn center(centers: &[f64], dim: usize, cluster: usize) -> &[f64] {
    &centers[cluster * dim..][..dim]
}

/// Returns a point of the plane as it was given.
fn point<const D: usize>(rows: &Rows<'_, D>, coordinates: &[f64]) -> Point {
    let given = rows.given(coordinates);
    Point::new(given[0], given[1])
}
