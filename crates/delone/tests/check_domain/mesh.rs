//! Refined meshes made by hand: whatever is split, and the constrained triangulation of what results.

use delone::check::{self, Asked, Certificate, Defects, DomainMesh, QualityVerdict};
use delone::{ConstrainedDelaunay, DomainRule, Error, Point, Pslg, SegmentPolicy, VertexId};

/// An input, the chains of its segments, and the triangles that come of it.
#[derive(Clone, Debug)]
pub struct Mesh {
    pub input: Pslg,
    pub rule: DomainRule,
    pub points: Vec<Point>,
    pub triangles: Vec<[VertexId; 3]>,
    /// Under the rule of the hull its edges have chains behind those of the input.
    pub chains: Vec<Vec<VertexId>>,
}

impl Mesh {
    /// Triangulates an input without Steiner points.
    pub fn new(input: &Pslg, rule: DomainRule) -> Self {
        let mut whole = input.clone();
        if rule == DomainRule::Hull {
            let hull = delone::triangulate(input.points.iter().copied()).expect("finite");
            let mut hull: Vec<VertexId> = hull.hull().collect();
            let lex = |&v: &usize| input.points[hull[v].index()];
            let first = (0..hull.len()).min_by(|v, w| lex(v).lex_cmp(&lex(w)));
            hull.rotate_left(first.unwrap_or(0));
            whole.add_ring(hull);
        }
        let cutting = ConstrainedDelaunay::new().crossings(SegmentPolicy::Split);
        let t = cutting.triangulate(whole.clone()).expect("a proper input");
        let mut mesh = Self {
            input: input.clone(),
            rule,
            points: t.triangulation().points().to_vec(),
            triangles: Vec::new(),
            chains: (0..whole.segments.len())
                .map(|s| t.chain(s).to_vec())
                .collect(),
        };
        mesh.triangulate().expect("no crossings are left");
        mesh
    }

    /// Adds a vertex on no segment.
    pub fn free(&mut self, x: f64, y: f64) -> VertexId {
        self.points.push(Point::new(x, y));
        VertexId::new(self.points.len() - 1)
    }

    /// Puts a vertex between two neighbours in all chains.
    pub fn split(&mut self, [a, b]: [VertexId; 2], at: Point) -> VertexId {
        let v = self.free(at.x, at.y);
        for chain in &mut self.chains {
            let place = chain
                .windows(2)
                .position(|step| [[a, b], [b, a]].iter().any(|e| e == step));
            if let Some(place) = place {
                chain.insert(place + 1, v);
            }
        }
        v
    }

    /// Splits the piece of a segment that begins with its `k`-th vertex in the middle, rounded.
    pub fn halve(&mut self, segment: usize, k: usize) -> VertexId {
        let [a, b] = [k, k + 1].map(|k| self.chains[segment][k]);
        let [p, q] = [a, b].map(|v| self.points[v.index()]);
        let middle = Point::new(0.5 * p.x + 0.5 * q.x, 0.5 * p.y + 0.5 * q.y);
        self.split([a, b], middle)
    }

    pub fn subsegments(&self) -> Vec<[VertexId; 2]> {
        let steps = self.chains.iter().flat_map(|chain| chain.windows(2));
        let mut edges: Vec<_> = steps.map(|s| [s[0].min(s[1]), s[0].max(s[1])]).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// Makes the triangles of the points and chains there are.
    pub fn triangulate(&mut self) -> Result<(), Error> {
        let mut whole = Pslg::from_points(self.points.iter().copied());
        whole.holes.clone_from(&self.input.holes);
        let mut starts = Vec::new();
        for chain in &self.chains {
            starts.push(whole.segments.len());
            whole.add_polyline(chain.iter().copied());
        }
        starts.push(whole.segments.len());
        let polygons = self.input.polygons.iter();
        whole.polygons = polygons.map(|p| starts[p.start]..starts[p.end]).collect();
        let rule = match self.rule {
            DomainRule::Hull => DomainRule::Carve,
            rule => rule,
        };
        let t = ConstrainedDelaunay::new().domain(rule).triangulate(whole)?;
        self.triangles = t.triangulation().triangles().to_vec();
        Ok(())
    }

    /// Lets the verifier look, with claimed chains and without.
    pub fn verify(&self) -> Result<Certificate, Defects> {
        let subsegments = self.subsegments();
        let mesh = DomainMesh::new(&self.points, &self.triangles, &subsegments).refined();
        let chains = |segment: usize| &self.chains[segment][..];
        let verify = |mesh: &DomainMesh| {
            let verdict = check::verify_domain(&self.input, self.rule, mesh, &());
            verdict.expect("a proper input").into_result()
        };
        let found = verify(&mesh);
        assert_eq!(verify(&mesh.with_chains(&chains)).is_ok(), found.is_ok());
        found
    }

    /// Returns Steiner points on segments, and elsewhere.
    pub fn steiner(&self) -> [usize; 2] {
        let certificate = self.verify().unwrap_or_else(|d| panic!("{d}\n{self:?}"));
        let numbers = certificate.domain.expect("numbers of the domain");
        [numbers.on_segments, numbers.free]
    }

    pub fn judge(&self, asked: &Asked) -> QualityVerdict {
        let subsegments = self.subsegments();
        let mesh = DomainMesh::new(&self.points, &self.triangles, &subsegments);
        let verdict = check::verify_quality(&self.input, self.rule, &mesh, asked, &());
        verdict
            .expect("a proper input")
            .unwrap_or_else(|d| panic!("{d}\n{self:?}"))
    }

    /// Names the vertices of an edge of the mesh from number to number.
    pub fn corners(&self, t: delone::TriangleId) -> [Point; 3] {
        self.triangles[t.index()].map(|v| self.points[v.index()])
    }
}
