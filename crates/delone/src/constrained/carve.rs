//! Which triangles belong to the domain, and to which region: floods that stop at segments.

use super::draft::Draft;
use super::seeds::{Locator, Place};
use super::segments::Segments;
use super::witness::{Witness, tell_reached};
use super::{Warning, polygons};
use crate::pace::Pace;
use crate::{DomainRule, Error, Phase, Point, Region, Seed, TriangleId, Watch};

/// What the floods found out about each face.
pub(super) struct Carving {
    /// Whether a face lies outside the domain; ghosts do.
    pub outside: Vec<bool>,
    /// For each face one more than its region, or 0; empty if there are no regions.
    pub region_of: Vec<u32>,
    pub warnings: Vec<Warning>,
}

/// Carves the domain and its holes out of the hull and finds its regions.
///
/// *Cost*: linear in the faces, plus a location for each seed.
pub(super) fn carve(
    draft: &Draft,
    rule: DomainRule,
    segments: &Segments,
    seeds: (&[Point], &[Region]),
    watch: &dyn Watch,
    witness: impl Witness,
) -> Result<Carving, Error> {
    let mut pace = Pace::new(watch, Phase::Carve, draft.mesh.num_faces() as u64);
    let mut outside = match rule {
        DomainRule::Hull => ghosts(draft),
        DomainRule::Carve => reach_from_outside(draft, &mut pace, witness)?,
        DomainRule::EvenOdd if segments.are_taken_together() => {
            odd_depth(draft, &mut pace, witness)?
        }
        DomainRule::EvenOdd => polygons::outside_union(draft, segments, &mut pace, witness)?,
    };
    let mut warnings = Vec::new();
    let mut places = Places {
        draft,
        locator: Locator::new(draft),
        segments,
        pace,
        witness,
    };
    places.carve_holes(rule, seeds.0, &mut outside, &mut warnings)?;
    let is_empty = !outside.contains(&false);
    if is_empty && draft.mesh.triangles().next().is_some() {
        warnings.push(Warning::Empty);
    }
    let region_of = places.find_regions(seeds.1, &outside, &mut warnings)?;
    places.pace.finish();
    witness.carve(draft, &outside);
    Ok(Carving {
        outside,
        region_of,
        warnings,
    })
}

fn ghosts(draft: &Draft) -> Vec<bool> {
    let faces = draft.mesh.faces();
    faces
        .iter()
        .map(|f| f.iter().any(|v| v.is_infinite()))
        .collect()
}

/// Marks what can be reached from outside without crossing a segment.
fn reach_from_outside(
    draft: &Draft,
    pace: &mut Pace,
    witness: impl Witness,
) -> Result<Vec<bool>, Error> {
    let mut reached = vec![false; draft.mesh.num_faces()];
    for ghost in draft.mesh.ghosts() {
        flood(draft, ghost, pace, |t| {
            let is_new = !std::mem::replace(&mut reached[t.index()], true);
            if is_new {
                tell_reached(witness, draft, t);
            }
            is_new
        })?;
    }
    Ok(reached)
}

/// Marks the faces from which the outside is an even number of segments away, on the shortest way: a
/// breadth-first search by levels.
fn odd_depth(draft: &Draft, pace: &mut Pace, witness: impl Witness) -> Result<Vec<bool>, Error> {
    let faces = draft.mesh.num_faces();
    let mut seen = vec![false; faces];
    let mut outside = vec![false; faces];
    let (mut level, mut is_even): (Vec<TriangleId>, bool) = (draft.mesh.ghosts().collect(), true);
    let (mut stack, mut next) = (Vec::new(), Vec::new());
    while !level.is_empty() {
        for start in level.drain(..) {
            if !std::mem::replace(&mut seen[start.index()], true) {
                stack.push(start);
            }
            while let Some(t) = stack.pop() {
                pace.step()?;
                tell_reached(witness, draft, t);
                outside[t.index()] = is_even;
                for h in t.half_edges() {
                    let neighbor = draft.mesh.twin(h).triangle();
                    if seen[neighbor.index()] {
                        continue;
                    }
                    if draft.marks.is_odd(h) {
                        next.push(neighbor);
                    } else {
                        seen[neighbor.index()] = true;
                        stack.push(neighbor);
                    }
                }
            }
        }
        std::mem::swap(&mut level, &mut next);
        is_even = !is_even;
    }
    Ok(outside)
}

/// Visits the faces that no segment separates from `start`; `enter` says whether a face is new.
pub(super) fn flood(
    draft: &Draft,
    start: TriangleId,
    pace: &mut Pace,
    mut enter: impl FnMut(TriangleId) -> bool,
) -> Result<(), Error> {
    let mut stack = Vec::new();
    if enter(start) {
        stack.push(start);
    }
    while let Some(t) = stack.pop() {
        pace.step()?;
        for h in t.half_edges() {
            let neighbor = draft.mesh.twin(h).triangle();
            if !draft.marks.is_constrained(h) && enter(neighbor) {
                stack.push(neighbor);
            }
        }
    }
    Ok(())
}

/// Finds the places of seeds, and refuses those on segments.
struct Places<'a, W> {
    draft: &'a Draft,
    locator: Locator<'a>,
    segments: &'a Segments<'a>,
    pace: Pace<'a>,
    witness: W,
}

impl<W: Witness> Places<'_, W> {
    fn triangle_of(&mut self, seed: Seed, at: Point) -> Result<Option<TriangleId>, Error> {
        self.pace.step()?;
        match self.locator.place(at) {
            Place::In(t) => Ok(Some(t)),
            Place::On(h) => Err(Error::SeedOnSegment {
                seed,
                at,
                segment: self.segments.first_along(self.draft, h),
            }),
            Place::Outside => Ok(None),
        }
    }

    fn carve_holes(
        &mut self,
        rule: DomainRule,
        holes: &[Point],
        outside: &mut [bool],
        warnings: &mut Vec<Warning>,
    ) -> Result<(), Error> {
        let before: Vec<bool> = if holes.is_empty() {
            Vec::new()
        } else {
            outside.to_vec()
        };
        for (hole, &at) in holes.iter().enumerate() {
            let triangle = self.triangle_of(Seed::Hole(hole), at)?;
            // The parity rule may have carved it already: then both agree.
            let is_idle = match triangle {
                None => true,
                Some(t) => before[t.index()] && rule != DomainRule::EvenOdd,
            };
            if is_idle {
                warnings.push(Warning::HoleOutside { hole, at });
            } else if let Some(t) = triangle {
                // Ghosts count as outside, so no flood leaves the hull.
                let (draft, witness) = (self.draft, self.witness);
                flood(draft, t, &mut self.pace, |t| {
                    let is_new = !std::mem::replace(&mut outside[t.index()], true);
                    if is_new {
                        tell_reached(witness, draft, t);
                    }
                    is_new
                })?;
            }
        }
        Ok(())
    }

    fn find_regions(
        &mut self,
        regions: &[Region],
        outside: &[bool],
        warnings: &mut Vec<Warning>,
    ) -> Result<Vec<u32>, Error> {
        if regions.is_empty() {
            return Ok(Vec::new());
        }
        let mut region_of = vec![0; self.draft.mesh.num_faces()];
        for (region, &Region { at, .. }) in regions.iter().enumerate() {
            let triangle = self.triangle_of(Seed::Region(region), at)?;
            match triangle.filter(|t| !outside[t.index()]) {
                None => warnings.push(Warning::RegionOutside { region, at }),
                Some(t) if region_of[t.index()] != 0 => warnings.push(Warning::RegionTwice {
                    region,
                    first: region_of[t.index()] as usize - 1,
                }),
                Some(t) => flood(self.draft, t, &mut self.pace, |t| {
                    let of = &mut region_of[t.index()];
                    let is_new = *of == 0 && !outside[t.index()];
                    if is_new {
                        *of = region as u32 + 1;
                    }
                    is_new
                })?,
            }
        }
        Ok(region_of)
    }
}
