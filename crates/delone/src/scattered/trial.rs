//! A triangulation that is tried: corners that stay, and centers of clusters that come, one at a time.

use super::centers::Centers;
use super::field::Field;
use crate::{
    ConstrainedDelaunay, DomainRule, Error, Event, Observer, Point, Pslg, TriangleId, VertexId,
};
use std::collections::{BTreeMap, BTreeSet};

/// Corners, centers, and which of the centers are vertices: those that lie inside, and equal neither a corner nor a
/// center before them.
///
/// Center k is vertex k after the corners, for as long as it lives.
pub(super) struct Trial<'f, 'a, O> {
    pub field: &'f mut Field<'a, O>,
    corners: usize,
    centers: Centers<'a>,
    /// The centers at each place, the one that is a vertex first.
    places: BTreeMap<[u64; 2], Vec<u32>>,
    is_vertex: Vec<bool>,
    short: Short,
}

impl<'f, 'a, O: Observer> Trial<'f, 'a, O> {
    /// Begins with the corners alone.
    pub fn begin(
        field: &'f mut Field<'a, O>,
        corners: &[Point],
        centers: Centers<'a>,
    ) -> Result<Self, Error> {
        field.at(2);
        field.lay_out(corners.to_vec(), &triangulate(corners, &[])?)?;
        Ok(Self {
            corners: corners.len(),
            centers,
            places: BTreeMap::new(),
            is_vertex: Vec::new(),
            short: Short::default(),
            field,
        })
    }

    /// Adds one center; false if no cluster can be split any more.
    pub fn add_center(&mut self) -> Result<bool, Error> {
        let Some(any) = self.field.draft.mesh.triangles().next() else {
            return Ok(false);
        };
        if self.is_vertex.is_empty() {
            let mean = self.centers.positions()[0];
            self.tell_moved(0, None, Some(mean));
            self.create(mean)?;
            self.put_in(0, any)?;
            return Ok(true);
        }
        let Some(split) = self.centers.split() else {
            return Ok(false);
        };
        let [old, new] = split.centers.map(|center| center as u32);
        let cut = split.cut;
        self.field.tell(|| Event::ClusterSplit {
            clusters: [old, new],
            cut,
        });
        self.tell_moved(old, Some(split.before), Some(split.after[0]));
        self.tell_moved(new, None, Some(split.after[1]));
        let near = self.take_out(old, split.before, any)?;
        self.field.move_vertex(self.vertex(old), split.after[0]);
        self.create(split.after[1])?;
        self.put_in(old, near)?;
        self.put_in(new, near)?;
        Ok(true)
    }

    fn create(&mut self, at: Point) -> Result<(), Error> {
        self.field.create_vertex(at)?;
        self.is_vertex.push(false);
        Ok(())
    }

    fn vertex(&self, center: u32) -> VertexId {
        VertexId::new(self.corners + center as usize)
    }

    fn tell_moved(&mut self, cluster: u32, from: Option<Point>, to: Option<Point>) {
        self.field
            .tell(|| Event::ClusterMoved { cluster, from, to });
    }

    /// Makes a center a vertex, if it can be one.
    fn put_in(&mut self, center: u32, near: TriangleId) -> Result<(), Error> {
        let v = self.vertex(center);
        let here = self
            .places
            .entry(place(self.field.draft.point(v)))
            .or_default();
        here.push(center);
        if here.len() == 1 {
            self.is_vertex[center as usize] = self.field.insert(v, near)?;
        }
        Ok(())
    }

    /// Takes a center out, and returns a triangle near by. Another one at its place takes its part.
    fn take_out(&mut self, center: u32, at: Point, any: TriangleId) -> Result<TriangleId, Error> {
        let here = self
            .places
            .get_mut(&place(at))
            .expect("bug: the center is nowhere");
        here.retain(|&other| other != center);
        let heir = here.first().copied();
        if heir.is_none() {
            self.places.remove(&place(at));
        }
        if !std::mem::take(&mut self.is_vertex[center as usize]) {
            return Ok(any);
        }
        let near = self.field.remove(self.vertex(center))?;
        if let Some(heir) = heir {
            self.is_vertex[heir as usize] = self.field.insert(self.vertex(heir), near)?;
        }
        Ok(near)
    }

    /// Returns a triangle that cannot hold enough, if there is one; tells which in one of two lines of pseudocode, the
    /// first if all can.
    pub fn judge(&mut self, least: usize, [good, bad]: [u16; 2]) -> Option<TriangleId> {
        let found = self.short.settle(self.field, least);
        let field = &mut *self.field;
        match found {
            Some(t) => {
                field.at(bad);
                let (triangle, data) = (field.names(t), field.stock.count(t) as u32);
                field.tell(|| Event::CoverRejected { triangle, data });
            }
            None => {
                field.at(good);
                let triangles = match field.is_watched() {
                    true => field.draft.mesh.triangles().count() as u32,
                    false => 0,
                };
                field.tell(|| Event::CoverAccepted { triangles });
            }
        }
        found
    }

    /// Takes the centers back, for whoever watches; the mesh stays.
    pub fn end(mut self) {
        for cluster in 0..self.is_vertex.len() {
            let at = self.centers.positions()[cluster];
            self.tell_moved(cluster as u32, Some(at), None);
        }
    }

    /// Tells whether every center is a vertex of its own.
    pub fn has_all_centers(&self) -> bool {
        self.is_vertex.iter().all(|&is_vertex| is_vertex)
    }

    /// Lists the centers that are vertices.
    pub fn inner_points(&self) -> Vec<Point> {
        let vertices = self
            .is_vertex
            .iter()
            .enumerate()
            .filter(|(_, is_vertex)| **is_vertex);
        let points = vertices.map(|(center, _)| self.field.draft.points[self.corners + center]);
        points.collect()
    }
}

/// The triangles of a polygon and points in it: Delaunay, as far as its edges allow.
pub(super) fn triangulate(corners: &[Point], inner: &[Point]) -> Result<Vec<[VertexId; 3]>, Error> {
    let mut pslg = Pslg::from_points([corners, inner].concat());
    pslg.add_ring(0..corners.len() as u32);
    let builder = ConstrainedDelaunay::new().domain(DomainRule::Carve);
    Ok(builder
        .triangulate(pslg)?
        .into_triangulation()
        .triangles()
        .to_vec())
}

fn place(p: Point) -> [u64; 2] {
    [p.x, p.y].map(f64::to_bits)
}

/// Triangles that hold too few data, as far as it is known.
#[derive(Default)]
pub(super) struct Short(BTreeSet<TriangleId>);

impl Short {
    /// Chooses who holds what, as far as that is free, so that every triangle holds at least `least`; or returns a
    /// triangle that cannot then, the first that is found.
    ///
    /// *Cost*: linear in the triangles that have changed, but for chains of data on edges.
    pub fn settle(&mut self, field: &mut Field<impl Observer>, least: usize) -> Option<TriangleId> {
        self.0.extend(field.stock.drain_touched());
        let mesh = &field.draft.mesh;
        let exists = |t: &TriangleId| t.index() < mesh.num_faces() && !mesh.is_ghost(*t);
        self.0
            .retain(|t| exists(t) && field.stock.count(*t) < least);
        let short: Vec<_> = self.0.iter().copied().collect();
        let found = short.into_iter().find(|&t| !field.raise(t, least));
        self.0.extend(field.stock.drain_touched());
        found
    }
}
