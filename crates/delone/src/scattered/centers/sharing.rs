//! What changes when one site has gone and two have come: who is nearest to which datum.
//!
//! Every datum belongs to the nearest site, of several to that of lowest rank. Let a and b be the sites of the new
//! centers, a with the rank of the old one or less, b with the highest of all unless it was there before.
//!
//! *Data of other sites* stay where they are, or go to a or b: no other site has come nearer, nor has a
//! better rank. Let p go from w to a or b.
//!
//! - If a or b is *nearer* to p than w: let the circle about p through w shrink towards w, touching itself there,
//!   until the last one of a and b is on it, or both are. Before, only these two were inside, because w was the
//!   nearest of the others. So nothing is inside now, and nothing else on the circle: in every Delaunay
//!   triangulation w is a neighbour of that one, or those. If w is a neighbour of a alone, and a is not nearer to p,
//!   neither is b, by the same argument for b alone.
//! - If p goes because of its *rank*, it goes to a, and a and w are on an empty circle about p. If nothing
//!   else is, they are neighbours; otherwise w is among those [beyond](super::sites::Sites::beyond_neighbors) the
//!   neighbours, too.
//!
//! *Data of the old center* may go anywhere. A site is nearest to a datum if no neighbour is nearer, so they
//! walk to it from neighbour to neighbour. All the nearest ones are on an empty circle, and joined along it by edges;
//! so from one of them the one of lowest rank is found.

use super::sites::{Site, Sites};
use crate::Point;
use crate::predicates::{compare_squared, squared_length};
use std::cmp::Ordering;

/// Lets data go where they belong after centers have been put at the sites `new`; `halves` are the data of the
/// center that they replace. Returns the sites whose data may have changed.
pub(super) fn share(
    sites: &mut Sites,
    data: &[Point],
    new: [Site; 2],
    halves: [Vec<u32>; 2],
) -> Vec<Site> {
    let mut changed = new.to_vec();
    attract(sites, data, new, &mut changed);
    for (site, half) in new.into_iter().zip(halves) {
        hand_out(sites, data, site, half, &mut changed);
    }
    changed.sort_unstable();
    changed.dedup();
    changed
}

/// Lets data of other sites go to the new ones.
fn attract(sites: &mut Sites, data: &[Point], new: [Site; 2], changed: &mut Vec<Site>) {
    let mut gains = [Vec::new(), Vec::new()];
    for (site, may_gain) in losers(sites, new) {
        let mut own = std::mem::take(sites.data_of(site));
        let count = own.len();
        own.retain(|&i| {
            let taker = taker(sites, data[i as usize], site, new, may_gain);
            taker.is_none_or(|k| {
                gains[k].push(i);
                false
            })
        });
        if own.len() < count {
            changed.push(site);
        }
        *sites.data_of(site) = own;
    }
    for (site, gains) in new.into_iter().zip(gains) {
        sites.data_of(site).extend(gains);
    }
}

/// Lists the sites that may lose data, each once, and which of the new ones may get them first.
fn losers(sites: &Sites, new: [Site; 2]) -> Vec<(Site, [bool; 2])> {
    // Those that were there before may have data, too.
    let mut pairs = vec![(new[0], 1), (new[1], 0)];
    for (k, &site) in new.iter().enumerate() {
        pairs.extend(sites.neighbors(site).map(|w| (w, k)));
    }
    pairs.extend(sites.beyond_neighbors(new[0]).into_iter().map(|w| (w, 0)));
    pairs.sort_unstable();
    let groups = pairs.chunk_by(|v, w| v.0 == w.0);
    let losers = groups.map(|group| {
        let has = |k| group.iter().any(|&(w, other)| other == k && w != new[k]);
        (group[0].0, [has(0), has(1)])
    });
    losers.collect()
}

/// Tells to which of the new sites a datum goes from `own`, if any.
fn taker(sites: &Sites, p: Point, own: Site, new: [Site; 2], may: [bool; 2]) -> Option<usize> {
    let first = (0..2).find(|&k| may[k] && sites.is_better(p, new[k], own))?;
    // The other one may be better still, though it is no neighbour.
    let other = 1 - first;
    let is_other = new[other] != own && sites.is_better(p, new[other], new[first]);
    Some(if is_other { other } else { first })
}

/// Lets data walk from a site to where they belong.
fn hand_out(
    sites: &mut Sites,
    data: &[Point],
    from: Site,
    half: Vec<u32>,
    changed: &mut Vec<Site>,
) {
    let around: Vec<(Site, Point)> = sites.neighbors(from).map(|w| (w, sites.at(w))).collect();
    let mut stay = Vec::with_capacity(half.len());
    for i in half {
        let p = data[i as usize];
        let nearest = match step(p, (from, sites.at(from)), around.iter().copied()) {
            Step::Here => from,
            Step::Tie => first_of_nearest(sites, p, from),
            Step::To(next) => nearest(sites, p, next),
        };
        if nearest == from {
            stay.push(i);
        } else {
            sites.data_of(nearest).push(i);
            changed.push(nearest);
        }
    }
    sites.data_of(from).append(&mut stay);
}

/// Where a walk to the nearest site goes.
enum Step {
    /// No neighbour is as near.
    Here,
    /// None is nearer, but one as near.
    Tie,
    /// To the nearest one of the neighbours.
    To(Site),
}

/// Looks for a neighbour that is nearer to a datum.
fn step(p: Point, here: (Site, Point), neighbors: impl Iterator<Item = (Site, Point)>) -> Step {
    let mut best = here;
    let mut best_square = squared_length([p, here.1]);
    let mut is_tied = false;
    for (site, at) in neighbors {
        let square = squared_length([p, at]);
        match compare_squared(p, [at, best.1], [square, best_square]) {
            Ordering::Less => (best, best_square) = ((site, at), square),
            Ordering::Equal => is_tied = true,
            Ordering::Greater => {}
        }
    }
    match best.0 == here.0 {
        false => Step::To(best.0),
        true if is_tied => Step::Tie,
        true => Step::Here,
    }
}

/// Walks to the nearest site of lowest rank. Every step leads nearer, so it ends.
fn nearest(sites: &Sites, p: Point, mut from: Site) -> Site {
    loop {
        let neighbors = sites.neighbors(from).map(|w| (w, sites.at(w)));
        match step(p, (from, sites.at(from)), neighbors) {
            Step::Here => return from,
            Step::Tie => return first_of_nearest(sites, p, from),
            Step::To(next) => from = next,
        }
    }
}

/// Finds, among the nearest sites, of which one is known, that of lowest rank.
fn first_of_nearest(sites: &Sites, p: Point, known: Site) -> Site {
    let square = |w: Site| squared_length([p, sites.at(w)]);
    let is_as_near = |w: Site| {
        compare_squared(
            p,
            [sites.at(w), sites.at(known)],
            [square(w), square(known)],
        )
        .is_eq()
    };
    let mut found = vec![known];
    let mut seen = 0;
    while let Some(&site) = found.get(seen) {
        seen += 1;
        for w in sites.neighbors(site) {
            if !found.contains(&w) && is_as_near(w) {
                found.push(w);
            }
        }
    }
    let first = found.into_iter().min_by_key(|&w| sites.rank(w));
    first.unwrap_or(known)
}

#[cfg(test)]
#[path = "sharing_tests.rs"]
mod tests;
