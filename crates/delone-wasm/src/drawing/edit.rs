//! Changing a drawing, one edit after the other.
//!
//! A list of edits is made as a whole or not at all. Points are numbered from 0 without gaps, so those behind a
//! removed one move down; the same holds for segments, holes and regions. What stays keeps its attributes, markers
//! and regions. A new point has no value in any attribute (NaN, as where a file has none) and the marker 0; a new
//! segment has the marker 0, which is what the formats take for "none".
//!
//! *Cost*: O(1) for an edit that adds or moves, O(n + m) for n points and m segments if one is removed; rows of
//! removals of points, the last point first, cost that once. A list of several edits copies the drawing besides.

use super::Drawing;
use crate::Trouble;
use crate::bounds::{Bound, finite, pair, within};
use delone::{DomainRule, Point, Region, VertexId};
use delone_io::{DomainData, Lines};
use serde::Deserialize;
use serde_json::Value;

/// A coordinate, as JSON has it: NaN and infinity come as `null`.
type Coordinate = Option<f64>;

/// A change of a drawing.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) enum Edit {
    /// Adds a point, behind all others.
    AddPoint([Coordinate; 2]),
    /// Moves a point.
    MovePoint(usize, Coordinate, Coordinate),
    /// Removes a point with the segments that end there.
    RemovePoint(usize),
    /// Adds a segment between two points, behind all others.
    AddSegment([usize; 2]),
    /// Removes a segment; its points stay.
    RemoveSegment(usize),
    /// Marks a hole by a place in it.
    AddHole([Coordinate; 2]),
    /// Moves the place that marks a hole.
    MoveHole(usize, Coordinate, Coordinate),
    /// Marks a hole no more.
    RemoveHole(usize),
    /// Names a region by a place in it, with its attribute and, or `null`, its largest area.
    AddRegion(Coordinate, Coordinate, Coordinate, Option<f64>),
    /// Moves the place that names a region.
    MoveRegion(usize, Coordinate, Coordinate),
    /// Names a region no more.
    RemoveRegion(usize),
    /// Removes everything; always `true`.
    Clear(bool),
}

impl Edit {
    /// Reads a list of edits.
    pub fn list(text: &str) -> Result<Vec<Self>, Trouble> {
        let list: Vec<Value> = serde_json::from_str(text).map_err(Trouble::Edits)?;
        let read = |(i, value): (usize, Value)| {
            let text = value.to_string();
            serde_json::from_value(value)
                .map_err(|error| Trouble::asked(format!("edit {i}, {text}: {error}")))
        };
        list.into_iter().enumerate().map(read).collect()
    }

    /// Its key in JSON.
    fn name(self) -> &'static str {
        match self {
            Self::AddPoint(..) => "addPoint",
            Self::MovePoint(..) => "movePoint",
            Self::RemovePoint(..) => "removePoint",
            Self::AddSegment(..) => "addSegment",
            Self::RemoveSegment(..) => "removeSegment",
            Self::AddHole(..) => "addHole",
            Self::MoveHole(..) => "moveHole",
            Self::RemoveHole(..) => "removeHole",
            Self::AddRegion(..) => "addRegion",
            Self::MoveRegion(..) => "moveRegion",
            Self::RemoveRegion(..) => "removeRegion",
            Self::Clear(..) => "clear",
        }
    }
}

/// Makes all edits, or none and says which is wrong.
pub(super) fn apply(drawing: &mut Drawing, edits: &[Edit]) -> Result<(), Trouble> {
    if let [only] = edits {
        // Dragging a point is this: what fails has changed nothing, so there is nothing to copy.
        return drawing.change(*only).map_err(|why| refusal(0, *only, &why));
    }
    let mut changed = drawing.clone();
    let mut rest = edits;
    while let Some(first) = rest.first() {
        let at = edits.len() - rest.len();
        let row = falling(rest);
        if row.len() > 1 {
            changed
                .remove_points(&row)
                .map_err(|why| refusal(at, *first, &why))?;
            rest = &rest[row.len()..];
        } else {
            changed
                .change(*first)
                .map_err(|why| refusal(at, *first, &why))?;
            rest = &rest[1..];
        }
    }
    *drawing = changed;
    Ok(())
}

fn refusal(i: usize, edit: Edit, why: &str) -> Trouble {
    Trouble::asked(format!("edit {i}, {}: {why}", edit.name()))
}

/// Lists the points that the first edits remove, as long as each lies before the last one: so their numbers are
/// those from before the first.
fn falling(edits: &[Edit]) -> Vec<usize> {
    let mut row = Vec::new();
    for edit in edits {
        match *edit {
            Edit::RemovePoint(i) if row.last().is_none_or(|&last| i < last) => row.push(i),
            _ => break,
        }
    }
    row
}

impl Drawing {
    /// Makes one edit, or none and says why.
    fn change(&mut self, edit: Edit) -> Result<(), String> {
        match edit {
            Edit::AddPoint(at) => self.add_point(finite(at)?),
            Edit::MovePoint(i, x, y) => {
                within(Bound::POINT, i, self.data.vertices.points.len())?;
                let at = finite([x, y])?;
                self.renumbered();
                self.data.vertices.points[i] = at;
            }
            Edit::RemovePoint(i) => self.remove_points(&[i])?,
            Edit::AddSegment(ends) => {
                let ends = pair(ends, self.data.vertices.points.len())?;
                self.add_segment(ends);
            }
            Edit::RemoveSegment(k) => {
                within(Bound::SEGMENT, k, self.data.segments.len())?;
                self.remove_segment(k);
            }
            Edit::AddHole(at) => self.data.holes.push(finite(at)?),
            Edit::MoveHole(k, x, y) => {
                within(Bound::HOLE, k, self.data.holes.len())?;
                self.data.holes[k] = finite([x, y])?;
            }
            Edit::RemoveHole(k) => {
                within(Bound::HOLE, k, self.data.holes.len())?;
                self.data.holes.remove(k);
            }
            Edit::AddRegion(x, y, attribute, max_area) => {
                let attribute = attribute.ok_or("the attribute must be a finite number")?;
                self.data.regions.push(Region {
                    at: finite([x, y])?,
                    attribute,
                    max_area,
                });
            }
            Edit::MoveRegion(k, x, y) => {
                within(Bound::REGION, k, self.data.regions.len())?;
                self.data.regions[k].at = finite([x, y])?;
            }
            Edit::RemoveRegion(k) => {
                within(Bound::REGION, k, self.data.regions.len())?;
                self.data.regions.remove(k);
            }
            Edit::Clear(true) => *self = Self::default(),
            Edit::Clear(false) => return Err("it is either true or left out".to_owned()),
        }
        Ok(())
    }

    fn add_point(&mut self, at: Point) {
        self.renumbered();
        let vertices = &mut self.data.vertices;
        vertices.points.push(at);
        for attribute in &mut vertices.attributes {
            attribute.values.push(f64::NAN);
        }
        if let Some(markers) = &mut vertices.markers {
            markers.push(0);
        }
    }

    /// Removes points, given the last one first, with their segments.
    fn remove_points(&mut self, falling: &[usize]) -> Result<(), String> {
        let before = self.data.vertices.points.len();
        for &i in falling {
            within(Bound::POINT, i, before)?;
        }
        self.renumbered();
        let mut is_kept = vec![true; before];
        falling.iter().for_each(|&i| is_kept[i] = false);
        let vertices = &mut self.data.vertices;
        keep(&mut vertices.points, &is_kept);
        for attribute in &mut vertices.attributes {
            keep(&mut attribute.values, &is_kept);
        }
        if let Some(markers) = &mut vertices.markers {
            keep(markers, &is_kept);
        }
        self.keep_segments_of(&is_kept);
        Ok(())
    }

    /// Keeps the segments between points that are kept, and names these anew.
    fn keep_segments_of(&mut self, is_kept: &[bool]) {
        let mut next = 0;
        let new = is_kept.iter().map(|&is_kept| {
            let number = VertexId::new(next);
            next += usize::from(is_kept);
            number
        });
        let new: Vec<VertexId> = new.collect();
        let segments = &mut self.data.segments;
        let stays = |ends: &[VertexId; 2]| ends.iter().all(|v| is_kept[v.index()]);
        let stay: Vec<bool> = segments.iter().map(stays).collect();
        if stay.contains(&false) {
            keep(segments, &stay);
            if let Some(markers) = &mut self.data.segment_markers {
                keep(markers, &stay);
            }
            let removed: Vec<usize> = (0..stay.len()).filter(|&k| !stay[k]).collect();
            segments_left(&mut self.data, &removed);
        }
        for ends in &mut self.data.segments {
            *ends = ends.map(|v| new[v.index()]);
        }
    }

    fn add_segment(&mut self, ends: [VertexId; 2]) {
        if self.data.segments.is_empty() {
            // As of a drawing that has segments from the beginning.
            self.data.usual_rule = DomainRule::Carve;
        }
        self.data.segments.push(ends);
        if let Some(markers) = &mut self.data.segment_markers {
            markers.push(0);
        }
    }

    fn remove_segment(&mut self, k: usize) {
        self.data.segments.remove(k);
        if let Some(markers) = &mut self.data.segment_markers {
            markers.remove(k);
        }
        segments_left(&mut self.data, &[k]);
    }

    /// Forgets what is true of the points as they were: on which lines of a file they stand, and the triangles
    /// between them.
    fn renumbered(&mut self) {
        self.start = Vec::new();
        self.data.vertices.lines = Lines::default();
    }
}

/// Keeps rule and polygons true once these segments, ascending, are gone.
///
/// A polygon that loses a segment is open, and there is no telling which segments will close it. So there are no
/// polygons any more, and where they bounded the domain, now all segments together do.
fn segments_left(data: &mut DomainData, removed: &[usize]) {
    let before = |end: usize| removed.partition_point(|&k| k < end);
    let is_whole = |range: &std::ops::Range<usize>| before(range.start) == before(range.end);
    if data.polygons.iter().all(is_whole) {
        for range in &mut data.polygons {
            let gone = before(range.start);
            *range = range.start - gone..range.end - gone;
        }
    } else {
        data.polygons.clear();
    }
    if data.segments.is_empty() {
        data.usual_rule = DomainRule::Hull;
    }
}

/// Keeps some of the entries of a list.
fn keep<T>(list: &mut Vec<T>, is_kept: &[bool]) {
    let mut kept = is_kept.iter();
    list.retain(|_| kept.next().is_none_or(|&is_kept| is_kept));
}
