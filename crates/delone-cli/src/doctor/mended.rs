//! The repaired drawing with all that its file said besides: markers, attributes, holes, regions.
//!
//! Points that are left keep what they had; of merged ones, the one that stays, except that it takes over a
//! marker if it has none. A cut has the marker of the first of its two segments that has one, and attributes
//! interpolated along the first. A segment has the first marker that is not 0 among those along it.

use super::report::{Listed, RepairReport};
use super::{Describer, Patient};
use crate::exit::Failure;
use crate::progress::Progress;
use delone::doctor::{Diagnosis, Kind, Repair};
use delone::{ConstrainedDelaunay, DomainRule, Point, SegmentPolicy, VertexId};
use delone_io::{Attribute, DomainData, PointSet};
use std::collections::BTreeMap;
use std::path::Path;

/// A repair, and what it has come to.
pub struct Mended {
    repair: Repair,
    /// What is to be written.
    pub domain: DomainData,
    /// What is left.
    after: Diagnosis,
    closed: u64,
}

impl Mended {
    pub fn new(repair: Repair, domain: DomainData, before: &Diagnosis, after: Diagnosis) -> Self {
        let unclosed = |found: &Diagnosis| found.count_of(Kind::UnclosedRing);
        let closed = unclosed(before).saturating_sub(unclosed(&after));
        Self {
            repair,
            domain,
            after,
            closed,
        }
    }

    /// Tells whether neither errors nor warnings are left.
    pub fn is_healthy(&self) -> bool {
        self.after.is_healthy()
    }

    /// Lists what has been changed, in the numbers of the input.
    pub fn report(&self, out: &Path, patient: &Patient, limit: usize) -> RepairReport {
        let repair = &self.repair;
        let base = patient.base();
        let point = |v: VertexId| v.index() + base;
        let largest = repair
            .moved()
            .map(|moved| moved.distance)
            .fold(0.0, f64::max);
        let moved = repair.moved().map(|moved| {
            let [from, at] = [moved.from, moved.at].map(<[f64; 2]>::from);
            (point(moved.point), from, at, moved.distance)
        });
        let merged = repair.merged().map(|pair| pair.map(point));
        let split = repair.bent().map(|bent| {
            let at: [f64; 2] = bent.at.into();
            (bent.segment + base, at, bent.distance)
        });
        let first_cut = repair.pslg.points.len() - repair.crossings.len();
        let cuts = repair
            .crossings
            .iter()
            .zip(&repair.pslg.points[first_cut..]);
        let cuts = cuts.map(|(pair, &at)| (pair.map(|s| s + base), <[f64; 2]>::from(at)));
        RepairReport {
            file: out.display().to_string(),
            points: self.domain.vertices.points.len(),
            segments: self.domain.segments.len(),
            rounds: repair.rounds,
            settled: repair.is_settled,
            largest,
            moved: Listed::of(moved, limit),
            merged: Listed::of(merged, limit),
            split: Listed::of(split, limit),
            cuts: Listed::of(cuts, limit),
            vanished: Listed::of(repair.vanished().map(|s| s + base), limit),
            doubled: Listed::of(repair.doubled().into_iter().map(|s| s + base), limit),
            closed: self.closed,
            dropped: dropped(repair, &patient.domain),
            left: Describer::of(patient).kinds(&self.after),
            healthy: self.after.is_healthy(),
        }
    }
}

/// Counts merged points whose attributes or markers are not those of the point that stays.
fn dropped(repair: &Repair, domain: &DomainData) -> usize {
    let set = &domain.vertices;
    let differs = |[v, kept]: &[VertexId; 2]| {
        let [v, kept] = [v.index(), kept.index()];
        let mut attributes = set.attributes.iter().map(|a| &a.values);
        let marker = |i: usize| set.markers.as_ref().map_or(0, |m| m[i]);
        attributes.any(|a| a[v].to_bits() != a[kept].to_bits())
            || (marker(v) != 0 && marker(kept) != 0 && marker(v) != marker(kept))
    };
    repair.merged().filter(differs).count()
}

/// Puts the repaired drawing together. Formats that know no polygons get seeds of holes instead.
pub fn domain(
    repair: &Repair,
    patient: &Patient,
    keeps_polygons: bool,
    progress: &Progress,
) -> Result<DomainData, Failure> {
    let input = &patient.domain;
    let markers = input.segment_markers.as_ref().map(|markers| {
        let first = |owners: &Vec<usize>| first_marker(owners.iter().map(|&s| markers[s]));
        repair.owners.iter().map(first).collect()
    });
    let domain = DomainData {
        vertices: PointSet {
            points: repair.pslg.points.clone(),
            attributes: attributes(repair, patient),
            markers: point_markers(repair, input),
            base: input.vertices.base,
            ..PointSet::default()
        },
        segments: repair.pslg.segments.clone(),
        segment_markers: markers,
        polygons: repair.pslg.polygons.clone(),
        holes: input.holes.clone(),
        regions: input.regions.clone(),
        usual_rule: patient.rule,
    };
    match domain.polygons.is_empty() || keeps_polygons {
        true => Ok(domain),
        false => flat(domain, repair, patient, progress),
    }
}

/// Replaces polygons by the seeds of what they leave out, and lists each edge once.
fn flat(
    mut domain: DomainData,
    repair: &Repair,
    patient: &Patient,
    progress: &Progress,
) -> Result<DomainData, Failure> {
    let builder = ConstrainedDelaunay::new()
        .domain(patient.rule)
        .watch(progress);
    let builder = builder.crossings(SegmentPolicy::Split);
    match builder.triangulate(repair.pslg.clone()) {
        Ok(result) if domain.holes.is_empty() => domain.holes = result.hole_seeds(),
        Err(delone::Error::Cancelled) => return Err(Failure::Cancelled),
        // What keeps it from being triangulated is told as what is left.
        _ => {}
    }
    let mut places: BTreeMap<[VertexId; 2], usize> = BTreeMap::new();
    let mut segments: Vec<[VertexId; 2]> = Vec::new();
    let mut markers: Vec<i32> = Vec::new();
    for (s, &[a, b]) in domain.segments.iter().enumerate() {
        let marker = domain.segment_markers.as_ref().map_or(0, |m| m[s]);
        let place = *places.entry([a.min(b), a.max(b)]).or_insert(segments.len());
        if place == segments.len() {
            segments.push([a, b]);
            markers.push(marker);
        } else if markers[place] == 0 {
            markers[place] = marker;
        }
    }
    Ok(DomainData {
        segments,
        segment_markers: domain.segment_markers.is_some().then_some(markers),
        polygons: Vec::new(),
        usual_rule: DomainRule::Carve,
        ..domain
    })
}

fn first_marker(markers: impl Iterator<Item = i32>) -> i32 {
    let mut such = markers.filter(|&marker| marker != 0);
    such.next().unwrap_or(0)
}

fn point_markers(repair: &Repair, input: &DomainData) -> Option<Vec<i32>> {
    let own = input.vertices.markers.as_ref()?;
    let mut markers = vec![0; repair.pslg.points.len()];
    for (v, source) in repair.sources.iter().enumerate() {
        markers[v] = source.map_or(0, |source| own[source.index()]);
    }
    for (point, v) in repair.vertex_of.iter().enumerate() {
        let marker = &mut markers[v.index()];
        if *marker == 0 {
            *marker = own[point];
        }
    }
    if let Some(of_segments) = &input.segment_markers {
        let first = markers.len() - repair.crossings.len();
        for (marker, pair) in markers[first..].iter_mut().zip(&repair.crossings) {
            *marker = first_marker(pair.iter().map(|&s| of_segments[s]));
        }
    }
    Some(markers)
}

fn attributes(repair: &Repair, patient: &Patient) -> Vec<Attribute> {
    let inherit = |Attribute { name, values }: &Attribute| {
        let kept = repair.sources.iter().flatten().map(|v| values[v.index()]);
        let first = repair.pslg.points.len() - repair.crossings.len();
        let cuts = repair.crossings.iter().zip(&repair.pslg.points[first..]);
        let cuts = cuts.map(|(&[segment, _], &at)| {
            let ends = patient.pslg.segments[segment].map(|v| v.index());
            let places = ends.map(|v| patient.pslg.points[v]);
            interpolate(ends.map(|v| values[v]), share(places, at))
        });
        Attribute {
            name: name.clone(),
            values: kept.chain(cuts).collect(),
        }
    };
    patient
        .domain
        .vertices
        .attributes
        .iter()
        .map(inherit)
        .collect()
}

fn interpolate([low, high]: [f64; 2], share: f64) -> f64 {
    match low == high {
        true => low,
        false => low * (1.0 - share) + high * share,
    }
}

/// How far along a segment, from 0 to 1, a place near it lies; halved so that no difference overflows.
fn share([a, b]: [Point; 2], at: Point) -> f64 {
    let along = |from: f64, to: f64| to / 2.0 - from / 2.0;
    let [dx, dy] = [along(a.x, b.x), along(a.y, b.y)];
    let share = match dx.abs() >= dy.abs() {
        true => along(a.x, at.x) / dx,
        false => along(a.y, at.y) / dy,
    };
    match share.is_nan() {
        true => 0.0,
        false => share.clamp(0.0, 1.0),
    }
}
