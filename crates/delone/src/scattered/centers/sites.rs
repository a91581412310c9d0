//! Where centers are: sites, in a Delaunay triangulation, each with the data to which it is nearest.
//!
//! Several centers may share a site: means of different halves may be equal, rounded as they are. The first of them
//! has the data of the site; its number is the site's *rank*, which decides ties.

use crate::edit::LiveTriangulation;
use crate::predicates::{CircleSide, compare_distances, in_circle};
use crate::{HalfEdgeId, Point, VertexId};
use std::cmp::Ordering;

/// A site, by its vertex.
pub(super) type Site = VertexId;

/// The sites of centers.
#[derive(Clone, Debug, Default)]
pub(super) struct Sites {
    live: LiveTriangulation,
    /// By site.
    rooms: Vec<Room>,
    /// By center.
    of_center: Vec<Site>,
}

/// What is at a site.
#[derive(Clone, Debug, Default)]
struct Room {
    at: Point,
    /// Its centers, ascending.
    centers: Vec<usize>,
    data: Vec<u32>,
}

impl Sites {
    /// Lets a center be at a finite place, where others may be, too.
    pub fn enter(&mut self, center: usize, at: Point) -> Site {
        // Centers are not more than data, which ids can number.
        let inserted = self.live.insert(at).expect("bug: a place without a number");
        let site = inserted.vertex();
        if self.rooms.len() <= site.index() {
            self.rooms.resize_with(site.index() + 1, Room::default);
        }
        let room = &mut self.rooms[site.index()];
        room.at = at;
        let (Ok(k) | Err(k)) = room.centers.binary_search(&center);
        room.centers.insert(k, center);
        if self.of_center.len() <= center {
            self.of_center.resize(center + 1, site);
        }
        self.of_center[center] = site;
        site
    }

    /// Takes a center away, and its site if no other is there; that must have no data then.
    pub fn leave(&mut self, center: usize) {
        let site = self.of_center[center];
        let room = &mut self.rooms[site.index()];
        room.centers.retain(|&c| c != center);
        if room.centers.is_empty() {
            debug_assert!(room.data.is_empty(), "bug: its data are lost");
            self.live.remove(site).expect("bug: a site is a vertex");
        }
    }

    /// Returns where a center is.
    pub fn of_center(&self, center: usize) -> Site {
        self.of_center[center]
    }

    /// Returns the data of a site.
    pub fn data_of(&mut self, site: Site) -> &mut Vec<u32> {
        &mut self.rooms[site.index()].data
    }

    /// Returns the data of a center.
    pub fn data_of_center(&self, center: usize) -> &[u32] {
        let room = &self.rooms[self.of_center[center].index()];
        match room.centers.first() {
            Some(&first) if first == center => &room.data,
            _ => &[],
        }
    }

    /// Returns where a site is.
    pub fn at(&self, site: Site) -> Point {
        self.rooms[site.index()].at
    }

    /// Returns the first center of a site.
    pub fn rank(&self, site: Site) -> usize {
        self.rooms[site.index()].centers[0]
    }

    /// Tells whether a datum belongs to `site` rather than to `other`.
    pub fn is_better(&self, p: Point, site: Site, other: Site) -> bool {
        match compare_distances(p, self.at(site), self.at(other)) {
            Ordering::Less => true,
            Ordering::Equal => self.rank(site) < self.rank(other),
            Ordering::Greater => false,
        }
    }

    /// Visits the neighbours of a site.
    pub fn neighbors(&self, site: Site) -> impl Iterator<Item = Site> + '_ {
        let spokes = self.live.star(site);
        let ends = spokes.map(|h| self.live.mesh().dest(h));
        ends.filter(|v| !v.is_infinite())
    }

    /// Lists the sites that are no neighbours of a site, but share an empty circle with it and with two of its
    /// neighbours.
    ///
    /// Sites on an empty circle are the corners of a convex polygon, which is triangulated. From the triangles at
    /// the site, the rest of it is reached across its diagonals; and never twice, for they make a tree of it.
    pub fn beyond_neighbors(&self, site: Site) -> Vec<Site> {
        let mesh = self.live.mesh();
        let mut diagonals: Vec<HalfEdgeId> = self.live.star(site).map(HalfEdgeId::next).collect();
        diagonals.retain(|h| !mesh.is_ghost(h.triangle()));
        let mut found = Vec::new();
        while let Some(h) = diagonals.pop() {
            let beyond = mesh.twin(h);
            if mesh.is_ghost(beyond.triangle()) {
                continue;
            }
            let [a, b, c] = mesh.corners(h.triangle()).map(|v| self.at(v));
            if in_circle(a, b, c, self.at(mesh.apex(beyond))) == CircleSide::On {
                found.push(mesh.apex(beyond));
                diagonals.extend([beyond.next(), beyond.prev()]);
            }
        }
        found
    }
}
