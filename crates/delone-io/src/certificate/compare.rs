//! Certificates are made of proofs, read back, and compared with proofs made anew.

use super::{
    AskedFor, FileFact, InputFacts, Maker, MeshCertificate, MeshFacts, Proof, Reached, RegionFacts,
    UnmetFact, hex,
};
use crate::{Error, Place, Problem, Source};
use delone::check::{CROSSING_DRIFT, Certificate, DomainNumbers, Excuse, STEINER_DRIFT, Unmet};
use delone::{DomainRule, VertexId, Watch};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// The version of the format.
const VERSION: u32 = 1;

/// Deepest nesting of what is compared; certificates have five levels.
const MOST_DEPTH: usize = 16;

impl MeshCertificate {
    /// Puts together what was proven; output and lineage are added when they are written.
    pub fn new(
        made_by: Maker,
        input: InputFacts,
        rule: Option<DomainRule>,
        is_refined: bool,
        asked: Option<AskedFor>,
        triangles: &[[VertexId; 3]],
        proof: &Proof,
    ) -> Self {
        let quality = proof.quality.as_ref();
        let mut unmet: Vec<_> = quality.map_or(&[][..], |q| &q.unmet).to_vec();
        unmet.sort_by_key(|u| corners(u, triangles));
        let statistics = &proof.statistics;
        Self {
            certificate: VERSION,
            made_by,
            input,
            domain: rule.map(|rule| rule_name(rule).to_owned()),
            refined: is_refined,
            asked,
            mesh: mesh_facts(&proof.certificate),
            reached: (statistics.triangles > 0).then(|| Reached {
                min_angle_degrees: statistics.min_angle,
                max_edge: statistics.longest_edge,
                max_area: statistics.largest_area,
                asked_tangent: proof.below.map(|below| below.tangent),
                triangles_below: proof.below.map(|below| below.triangles),
            }),
            unmet: unmet.iter().map(|u| unmet_fact(u, triangles)).collect(),
            other_unmet: quality.map_or(0, |q| {
                let encroached = q.encroached.iter().filter(|e| e.excuse.is_none());
                encroached.count() + q.on_locked.len()
            }),
            regions: region_facts(proof.regions.as_deref()),
            proven: proven(&proof.certificate, is_refined, proof.regions.is_some()),
            drift_ulps: CROSSING_DRIFT,
            drift_ulps_per_halving: if is_refined { STEINER_DRIFT } else { 0.0 },
            local_tests: proof.tests.into(),
            output: Vec::new(),
            lineage: None,
            checksum: String::new(),
        }
    }

    /// Adds the files and the checksum.
    pub fn sealed(self, output: Vec<FileFact>, lineage: Option<FileFact>) -> Self {
        let sealed = Self {
            output,
            lineage,
            ..self
        };
        Self {
            checksum: sealed.expected_checksum(),
            ..sealed
        }
    }

    fn expected_checksum(&self) -> String {
        let open = Self {
            checksum: String::new(),
            ..self.clone()
        };
        hex(&Sha256::digest(
            serde_json::to_vec(&open).unwrap_or_default(),
        ))
    }

    /// Reads a certificate.
    ///
    /// # Errors
    /// If the file cannot be read, is no certificate (with line and column), is of another version of the format, or
    /// the watch cancels.
    pub fn read(source: &Source, watch: &dyn Watch) -> Result<Self, Error> {
        let bytes = source.load(watch)?;
        let malformed = |place, problem| Error::Malformed {
            file: source.to_string(),
            place,
            problem: Problem::Other(problem),
        };
        let read: Self = serde_json::from_slice(&bytes).map_err(|error| {
            let place = Place::Column(error.line() as u64, error.column() as u64);
            malformed(place, format!("not a certificate of a mesh: {error}"))
        })?;
        match read.certificate {
            VERSION => Ok(read),
            other => Err(malformed(
                Place::File,
                format!("a certificate of version {other}; this program reads version {VERSION}"),
            )),
        }
    }

    /// Returns the rule of the domain, if there is one.
    ///
    /// # Errors
    /// If its name is none.
    pub fn rule(&self) -> Result<Option<DomainRule>, Error> {
        let Some(name) = &self.domain else {
            return Ok(None);
        };
        let rules = [DomainRule::Hull, DomainRule::Carve, DomainRule::EvenOdd];
        let named = rules.into_iter().find(|&rule| rule_name(rule) == name);
        named.map(Some).ok_or_else(|| {
            Error::BadMesh(format!(
                "the certificate's domain is {name:?}; it can be hull, carve or evenodd"
            ))
        })
    }

    /// Says in words where this certificate differs from what was `found` anew, and whether its checksum is wrong;
    /// nothing if it holds.
    pub fn disagreements(&self, found: &Self) -> Vec<String> {
        let mut words = Vec::new();
        if self.checksum != self.expected_checksum() {
            words.push("checksum: the certificate is not as it was written".to_owned());
        }
        let [claimed, found] = [self, found].map(|certificate| {
            let open = Self {
                checksum: String::new(),
                ..certificate.clone()
            };
            serde_json::to_value(open).unwrap_or_default()
        });
        differ("", &claimed, &found, &mut words, MOST_DEPTH);
        words
    }
}

/// Lists the leaves that differ, by their places.
fn differ(place: &str, claimed: &Value, found: &Value, words: &mut Vec<String>, depth: usize) {
    let at = |key: &str| match place {
        "" => key.to_owned(),
        place => format!("{place}.{key}"),
    };
    match (claimed, found) {
        _ if claimed == found => {}
        (Value::Object(claimed), Value::Object(found)) if depth > 0 => {
            for (key, value) in claimed {
                let other = found.get(key).unwrap_or(&Value::Null);
                differ(&at(key), value, other, words, depth - 1);
            }
        }
        (Value::Array(claimed), Value::Array(found))
            if depth > 0 && claimed.len() == found.len() =>
        {
            for (i, (value, other)) in claimed.iter().zip(found).enumerate() {
                differ(&at(&i.to_string()), value, other, words, depth - 1);
            }
        }
        (Value::Array(claimed), Value::Array(found)) => words.push(format!(
            "{place}: {} entries in the certificate, {} found",
            claimed.len(),
            found.len()
        )),
        _ => words.push(format!(
            "{place}: {claimed} in the certificate, {found} found"
        )),
    }
}

fn rule_name(rule: DomainRule) -> &'static str {
    match rule {
        DomainRule::Hull => "hull",
        DomainRule::Carve => "carve",
        DomainRule::EvenOdd => "evenodd",
    }
}

fn mesh_facts(proven: &Certificate) -> MeshFacts {
    let numbers = proven.domain;
    let number = |of: fn(DomainNumbers) -> usize| numbers.map_or(0, of);
    MeshFacts {
        hash: proven.hash.to_string(),
        points: proven.points,
        vertices: proven.vertices,
        duplicates: proven.duplicates,
        triangles: proven.triangles,
        edges: proven.edges,
        border_edges: proven.hull_edges,
        constrained_edges: number(|n| n.subsegments),
        crossings: number(|n| n.added),
        steiner_on_segments: number(|n| n.on_segments),
        steiner_free: number(|n| n.free),
        carved: number(|n| n.carved),
        components: number(|n| n.components),
        holes: number(|n| n.holes),
    }
}

fn proven(proven: &Certificate, is_refined: bool, has_regions: bool) -> Vec<String> {
    let clauses: &[&str] = match (proven.domain, is_refined) {
        (None, _) => &Certificate::PROVEN,
        (Some(_), false) => &DomainNumbers::PROVEN,
        (Some(_), true) => &DomainNumbers::PROVEN_REFINED,
    };
    let regions = has_regions.then_some("every triangle lies in the region that it is counted to");
    let clauses = clauses.iter().copied().chain(regions);
    clauses.map(str::to_owned).collect()
}

fn region_facts(regions: Option<&[Option<usize>]>) -> Vec<RegionFacts> {
    let mut counts: BTreeMap<Option<usize>, usize> = BTreeMap::new();
    for &region in regions.unwrap_or_default() {
        *counts.entry(region).or_default() += 1;
    }
    let facts = counts.into_iter();
    let facts = facts.map(|(region, triangles)| RegionFacts { region, triangles });
    facts.collect()
}

/// Returns the corners of an unmet triangle, counter-clockwise from the smallest number.
fn corners(unmet: &Unmet, triangles: &[[VertexId; 3]]) -> [u32; 3] {
    let mut corners = triangles[unmet.triangle.index()].map(VertexId::raw);
    let smallest = (0..3).min_by_key(|&k| corners[k]).unwrap_or_default();
    corners.rotate_left(smallest);
    corners
}

fn unmet_fact(unmet: &Unmet, triangles: &[[VertexId; 3]]) -> UnmetFact {
    let broken = unmet.broken;
    let bounds = [
        (broken.angle, "angle"),
        (broken.edge, "edge"),
        (broken.area, "area"),
    ];
    let breaks = bounds.into_iter().filter(|(is_broken, _)| *is_broken);
    let (excuse, at_vertex, between_segments) = match unmet.excuse {
        None => (None, None, None),
        Some(Excuse::SmallInputAngle {
            vertex, segments, ..
        }) => (
            Some("small_input_angle"),
            Some(vertex.raw()),
            Some(segments),
        ),
        Some(Excuse::Locked) => (Some("locked_boundary"), None, None),
        Some(Excuse::Precision) => (Some("precision"), None, None),
        Some(_) => (Some("other"), None, None),
    };
    UnmetFact {
        corners: corners(unmet, triangles),
        breaks: breaks.map(|(_, name)| name.to_owned()).collect(),
        min_angle_degrees: unmet.shape.min_angle(),
        excuse: excuse.map(str::to_owned),
        at_vertex,
        between_segments,
    }
}
