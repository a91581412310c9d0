//! The triangles that do not meet the bounds, grouped by reason.

use crate::words::counted;
use delone::{Reason, RefinedMesh, Unmet};

/// Triangles left for one kind of reason, the worst first.
pub(super) struct Group<'a> {
    pub title: &'static str,
    /// What the reason means, and what can be done.
    pub meaning: &'static str,
    pub is_excused: bool,
    pub unmet: Vec<&'a Unmet>,
    /// How many of them are shown.
    pub shown: usize,
}

/// Groups, and shares out which are shown: as many of each group as there is room for.
pub(super) fn groups(refined: &RefinedMesh, room: usize) -> Vec<Group<'_>> {
    let mut unmet: Vec<&Unmet> = refined.report.unmet.iter().collect();
    // The sort is stable: equal ones stay in the order of the triangles.
    unmet.sort_by(|a, b| {
        let key = |u: &Unmet| (kind(u.reason), u.min_angle.to_degrees());
        let [(a, x), (b, y)] = [key(a), key(b)];
        a.cmp(&b).then(x.total_cmp(&y))
    });
    let alike = unmet.chunk_by(|a, b| kind(a.reason) == kind(b.reason));
    let mut groups: Vec<Group<'_>> = alike.map(Group::of).collect();
    let shown = |groups: &[Group<'_>]| groups.iter().map(|g| g.shown).sum::<usize>();
    while shown(&groups) < room.min(unmet.len()) {
        let left = room - shown(&groups);
        let waiting = groups.iter_mut().filter(|g| g.shown < g.unmet.len());
        waiting.take(left).for_each(|g| g.shown += 1);
    }
    groups
}

/// Orders the reasons: what nothing excuses comes first.
fn kind(reason: Reason) -> u8 {
    match reason {
        Reason::Stopped => 0,
        Reason::Gradation => 1,
        Reason::Precision => 3,
        Reason::LockedBoundary => 4,
        Reason::SmallInputAngle { .. } => 5,
        _ => 2,
    }
}

impl<'a> Group<'a> {
    fn of(unmet: &[&'a Unmet]) -> Self {
        let reason = unmet[0].reason;
        let (title, meaning) = describe(reason);
        Self {
            title,
            meaning,
            is_excused: reason.is_excused(),
            unmet: unmet.to_vec(),
            shown: 0,
        }
    }
}

fn describe(reason: Reason) -> (&'static str, &'static str) {
    match reason {
        Reason::Stopped => (
            "The work stopped before their turn",
            "A larger budget would improve them.",
        ),
        Reason::Gradation => (
            "Vertices would crowd far beyond the features of the input",
            "Better triangles here would take ever smaller ones around them. A smaller bound for angles \
             needs fewer.",
        ),
        Reason::Precision => (
            "Coordinates have no room for another vertex",
            "The shortest edge is within a few thousand units in the last place of the coordinates. Moving \
             the input nearer to the origin, or removing its finest details, would make room.",
        ),
        Reason::LockedBoundary => (
            "An edge lies on a boundary that must not be split",
            "The boundary was to be kept as it is; without that, its edges could be split.",
        ),
        Reason::SmallInputAngle { .. } => (
            "Two segments of the input meet at a small angle",
            "No mesh has a larger angle in such a corner: only another input would.",
        ),
        _ => ("Other reasons", ""),
    }
}

/// Says how many of a group are not shown.
pub(super) fn rest(group: &Group<'_>) -> Option<String> {
    let rest = group.unmet.len() - group.shown;
    (rest > 0).then(|| format!("and {}", counted(rest, "more triangle", "more triangles")))
}
