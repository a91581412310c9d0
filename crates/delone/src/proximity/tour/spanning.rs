//! Shortest spanning trees with tolls: among the edges of the triangulation, or among all pairs.
//!
//! Borůvka's algorithm (*O jistém problému minimálním*, 1926): every part of the forest takes the shortest
//! edge that leaves it. Which one of equally short ones does not matter, as long as none closes a ring.
//! For all pairs a tree of boxes (Bentley, *Multidimensional binary search trees*, 1975) is searched for
//! an edge that is shorter still than the best one of the triangulation; boxes that lie in the part, or
//! too far away even for the least toll in them, are left out.

use super::sites::Sites;
use crate::Error;
use crate::pace::Pace;
use crate::proximity::forest::Forest;

/// The edge that a part of the forest takes: its length with tolls, and its ends.
type Best = (i64, [u32; 2]);

const NONE: Best = (i64::MAX, [0; 2]);

/// The edges of the triangulation, and room to find trees among them again and again.
pub(super) struct Candidates {
    edges: Vec<([u32; 2], i64)>,
    /// Edges between different parts.
    alive: Vec<u32>,
    /// The part of each site, named by one of its sites.
    parts: Vec<u32>,
    best: Vec<Best>,
    degrees: Vec<u32>,
}

impl Candidates {
    pub fn new(sites: &Sites) -> Self {
        let n = sites.num_places();
        let of_site = |a: u32| {
            let above = sites.neighbors(a).iter().filter(move |&&b| a < b);
            above.map(move |&b| ([a, b], sites.distance(a, b)))
        };
        Self {
            edges: (0..n as u32).flat_map(of_site).collect(),
            alive: Vec::new(),
            parts: vec![0; n],
            best: vec![NONE; n],
            degrees: vec![0; n],
        }
    }

    /// Returns how many edges of the last tree meet at each site.
    pub fn degrees(&self) -> &[u32] {
        &self.degrees
    }

    /// Finds the shortest spanning tree in the triangulation, and returns its length.
    pub fn shortest(&mut self, tolls: &[i64], pace: &mut Pace) -> Result<i128, Error> {
        let tree = self.grow(tolls, None, pace)?;
        Ok(tree.expect("bug: given up without a limit"))
    }

    /// Returns the length of the shortest spanning tree of all pairs; `None` if the search for it takes
    /// too long.
    pub fn shortest_of_all(
        &mut self,
        mut pairs: Pairs,
        tolls: &[i64],
        pace: &mut Pace,
    ) -> Result<Option<i128>, Error> {
        self.grow(tolls, Some(&mut pairs), pace)
    }

    fn grow(
        &mut self,
        tolls: &[i64],
        mut pairs: Option<&mut Pairs>,
        pace: &mut Pace,
    ) -> Result<Option<i128>, Error> {
        let n = tolls.len();
        let mut forest = Forest::new(n);
        self.alive = (0..self.edges.len() as u32).collect();
        self.degrees.fill(0);
        let (mut length, mut joined) = (0, 1);
        while joined < n {
            for site in 0..n {
                self.parts[site] = forest.find(site) as u32;
            }
            self.ask_edges(tolls, pace)?;
            if let Some(pairs) = pairs.as_deref_mut()
                && !pairs.improve(&self.parts, &mut self.best, pace)?
            {
                return Ok(None);
            }
            for site in 0..n {
                let (toll_length, [a, b]) = self.best[site];
                if toll_length != i64::MAX && forest.join(a as usize, b as usize) {
                    length += i128::from(toll_length);
                    joined += 1;
                    self.degrees[a as usize] += 1;
                    self.degrees[b as usize] += 1;
                }
            }
        }
        Ok(Some(length))
    }

    /// Finds for each part the shortest edge of the triangulation that leaves it.
    fn ask_edges(&mut self, tolls: &[i64], pace: &mut Pace) -> Result<(), Error> {
        let Self {
            edges, parts, best, ..
        } = self;
        best.fill(NONE);
        let mut kept = 0;
        for i in 0..self.alive.len() {
            pace.step()?;
            let edge = self.alive[i];
            let ([a, b], length) = edges[edge as usize];
            let [part_a, part_b] = [a, b].map(|v| parts[v as usize]);
            if part_a == part_b {
                continue;
            }
            self.alive[kept] = edge;
            kept += 1;
            let length = length + tolls[a as usize] + tolls[b as usize];
            for part in [part_a, part_b] {
                let best = &mut best[part as usize];
                if length < best.0 {
                    *best = (length, [a, b]);
                }
            }
        }
        self.alive.truncate(kept);
        Ok(())
    }
}

/// Sites in a leaf.
const LEAF: usize = 8;

/// Boxes that a site may look into on average, over all rounds, before the search is given up.
const PATIENCE: usize = 4000;

/// What may be lost when distances to boxes are rounded, in the units of `sites.rs`: a few units in the
/// last place of coordinates below 1, which are 2⁵ of them.
const SLACK: f64 = 1024.0;

/// In the box of a node lie sites of several parts.
const MIXED: u32 = u32::MAX;

/// A node of the tree of boxes: the sites `from..to` of the order.
#[derive(Clone, Copy)]
struct Node {
    min: [f64; 2],
    max: [f64; 2],
    least_toll: i64,
    /// The part in which all its sites lie, or [`MIXED`].
    part: u32,
    range: [u32; 2],
}

/// All pairs of sites, to be searched for short edges.
pub(super) struct Pairs<'a> {
    sites: &'a Sites,
    tolls: &'a [i64],
    /// Places of the sites, in units of distance, rounded.
    places: Vec<[f64; 2]>,
    /// The sites, those of each node together.
    order: Vec<u32>,
    /// The root is 0, the children of i are 2i + 1 and 2i + 2; a leaf's do not exist.
    nodes: Vec<Node>,
    waiting: Vec<u32>,
    looks_left: usize,
}

impl<'a> Pairs<'a> {
    pub fn new(sites: &'a Sites, tolls: &'a [i64]) -> Self {
        let n = sites.num_places();
        let mut pairs = Self {
            sites,
            tolls,
            places: (0..n as u32).map(|site| sites.place(site)).collect(),
            order: (0..n as u32).collect(),
            nodes: Vec::new(),
            waiting: Vec::new(),
            looks_left: n * PATIENCE,
        };
        pairs.divide();
        pairs
    }

    /// Divides level by level, at the median of the longer side, until leaves are small.
    fn divide(&mut self) {
        let mut level = vec![[0, self.order.len() as u32]];
        loop {
            let is_last = level.iter().all(|[from, to]| (to - from) as usize <= LEAF);
            for &range in &level {
                let node = self.node(range);
                self.nodes.push(node);
            }
            if is_last {
                return;
            }
            let first = self.nodes.len() - level.len();
            level = (first..self.nodes.len())
                .flat_map(|i| self.halves(self.nodes[i]))
                .collect();
        }
    }

    fn node(&self, range: [u32; 2]) -> Node {
        let mut node = Node {
            min: [f64::INFINITY; 2],
            max: [f64::NEG_INFINITY; 2],
            least_toll: i64::MAX,
            part: MIXED,
            range,
        };
        for &site in self.of(range) {
            let place = self.places[site as usize];
            for k in [0, 1] {
                node.min[k] = node.min[k].min(place[k]);
                node.max[k] = node.max[k].max(place[k]);
            }
            node.least_toll = node.least_toll.min(self.tolls[site as usize]);
        }
        node
    }

    fn halves(&mut self, node: Node) -> [[u32; 2]; 2] {
        let [from, to] = node.range;
        let middle = from + (to - from) / 2;
        let [width, height] = [0, 1].map(|k| node.max[k] - node.min[k]);
        let axis = usize::from(height > width);
        let places = &self.places;
        let part = &mut self.order[from as usize..to as usize];
        if !part.is_empty() {
            part.select_nth_unstable_by((middle - from) as usize, |&a, &b| {
                let [p, q] = [a, b].map(|site| places[site as usize][axis]);
                p.total_cmp(&q).then(a.cmp(&b))
            });
        }
        [[from, middle], [middle, to]]
    }

    fn of(&self, [from, to]: [u32; 2]) -> &[u32] {
        &self.order[from as usize..to as usize]
    }

    /// Replaces the best edge of each part where some pair is shorter; `false` if that takes too long.
    fn improve(
        &mut self,
        parts: &[u32],
        best: &mut [Best],
        pace: &mut Pace,
    ) -> Result<bool, Error> {
        self.refresh(parts);
        for i in 0..self.order.len() {
            pace.step()?;
            let site = self.order[i];
            let part = parts[site as usize];
            if !self.search(site, part, parts, &mut best[part as usize]) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Finds out which nodes lie in one part.
    fn refresh(&mut self, parts: &[u32]) {
        for i in (0..self.nodes.len()).rev() {
            let part = match self.nodes.get(2 * i + 1..2 * i + 3) {
                Some([a, b]) if a.part == b.part => a.part,
                Some(_) => MIXED,
                None => {
                    let mut sites = self.of(self.nodes[i].range).iter();
                    let first = sites.next().map_or(MIXED, |&site| parts[site as usize]);
                    let is_one = sites.all(|&site| parts[site as usize] == first);
                    if is_one { first } else { MIXED }
                }
            };
            self.nodes[i].part = part;
        }
    }

    /// Looks for an edge from `site` to another part that is shorter than `best`.
    fn search(&mut self, site: u32, part: u32, parts: &[u32], best: &mut Best) -> bool {
        let (place, toll) = (self.places[site as usize], self.tolls[site as usize]);
        self.waiting.push(0);
        while let Some(i) = self.waiting.pop() {
            let node = self.nodes[i as usize];
            if node.part == part || node.least_toll == i64::MAX {
                continue;
            }
            if distance_to(&node, place) + toll + node.least_toll >= best.0 {
                continue;
            }
            self.looks_left = self.looks_left.saturating_sub(1);
            if self.looks_left == 0 {
                return false;
            }
            if 2 * i as usize + 2 < self.nodes.len() {
                self.waiting.extend(self.nearer_last(i, place));
                continue;
            }
            for &other in self.of(node.range) {
                if parts[other as usize] != part {
                    let length = self.sites.distance(site, other);
                    let length = length + toll + self.tolls[other as usize];
                    if length < best.0 {
                        *best = (length, [site, other]);
                    }
                }
            }
        }
        true
    }

    /// The children of a node, the nearer one last, where it is taken first.
    fn nearer_last(&self, i: u32, place: [f64; 2]) -> [u32; 2] {
        let children = [2 * i + 1, 2 * i + 2];
        let [a, b] = children.map(|i| distance_to(&self.nodes[i as usize], place));
        if a < b {
            [children[1], children[0]]
        } else {
            children
        }
    }
}

/// The distance from a place to a box, or a little less.
fn distance_to(node: &Node, place: [f64; 2]) -> i64 {
    let [x, y] = [0, 1].map(|k| {
        let beside = (node.min[k] - place[k]).max(place[k] - node.max[k]);
        beside.max(0.0)
    });
    ((x * x + y * y).sqrt() * (1.0 - 1e-12) - SLACK) as i64
}

#[cfg(test)]
mod tests {
    use super::super::sites::Kind;
    use super::*;
    use crate::proximity::Proximity;
    use crate::{Phase, Point, VertexId};

    /// The length of the shortest tree of all pairs, after Prim.
    fn naive(sites: &Sites, tolls: &[i64]) -> i128 {
        let n = tolls.len() as u32;
        let mut nearest = vec![i64::MAX; n as usize];
        let mut is_left = vec![true; n as usize];
        let (mut last, mut length) = (0, 0);
        for _ in 1..n {
            is_left[last as usize] = false;
            for site in (0..n).filter(|&site| is_left[site as usize]) {
                let [here, there] = [last, site].map(|v| tolls[v as usize]);
                let new = sites.distance(last, site) + here + there;
                let old = &mut nearest[site as usize];
                *old = new.min(*old);
            }
            let left = (0..n).filter(|&site| is_left[site as usize]);
            last = left.min_by_key(|&v| nearest[v as usize]).expect("a site");
            length += i128::from(nearest[last as usize]);
        }
        length
    }

    /// Tolls that lead the tree far out of the triangulation.
    #[test]
    fn no_pair_is_overlooked() {
        for (n, side) in [(2, 3), (9, 4), (40, 6), (300, 1000), (700, 40)] {
            let mut seed = n as u64;
            let mut random = move |below: u64| {
                seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (seed >> 33) % below
            };
            let point = |_| Point::new(random(side) as f64, random(side) as f64);
            let t = crate::triangulate((0..n).map(point)).expect("finite");
            let proximity = Proximity::new(&t, &()).expect("not cancelled");
            let sorted = proximity.sorted_edges().expect("not cancelled");
            let vertices = (0..n).map(VertexId::new);
            let vertices = vertices.filter(|&v| t.representative(v) == v).collect();
            let sites = Sites::new(&proximity, vertices, &sorted, Kind::Closed);
            let mut pace = Pace::new(&(), Phase::Tour, 1);
            let mut candidates = Candidates::new(&sites);
            for size in [0, 1 << 50, 1 << 54, 1 << 58] {
                let mut toll = |_| (random(1 << 31) as i64 - (1 << 30)) * (size >> 30);
                let tolls: Vec<i64> = (0..sites.num_places()).map(&mut toll).collect();
                let among_edges = candidates.shortest(&tolls, &mut pace).unwrap();
                let pairs = Pairs::new(&sites, &tolls);
                let found = candidates.shortest_of_all(pairs, &tolls, &mut pace);
                let expected = naive(&sites, &tolls);
                assert_eq!(found, Ok(Some(expected)), "{n} {size}");
                assert!(expected <= among_edges && (size > 0 || expected == among_edges));
                assert!(
                    n < 40 || size < 1 << 58 || expected < among_edges,
                    "no test"
                );
            }
        }
    }
}
