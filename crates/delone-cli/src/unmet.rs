//! Triangles that are not as asked, and why, in the numbers of the input's file.

use crate::numbering::Numbering;
use crate::words::{count, counted};
use delone::{Outcome, Reason, RefinedMesh, Unmet};
use delone_io::Explainer;
use std::fmt;

/// Returns the name that programs know a reason by.
pub fn reason_name(reason: Reason) -> &'static str {
    match reason {
        Reason::SmallInputAngle { .. } => "small_input_angle",
        Reason::LockedBoundary => "locked_boundary",
        Reason::Precision => "precision",
        Reason::Gradation => "gradation",
        Reason::Stopped => "stopped",
        _ => "other",
    }
}

/// Says where a triangle lies, what it lacks, and why.
pub fn explain(unmet: &Unmet, refined: &RefinedMesh, numbering: &Numbering) -> String {
    let explainer = Explainer::new(refined, numbering.base());
    let hint = match unmet.reason {
        Reason::SmallInputAngle { .. } => numbering.hint(),
        _ => "",
    };
    format!(
        "near {} with {}; {}{hint}",
        explainer.place(unmet),
        explainer.lack(unmet),
        explainer.reason(unmet.reason),
    )
}

/// Triangles that are not as asked, and nothing excuses it.
pub struct Unexcused {
    file: String,
    number: usize,
    triangles: usize,
    worst: String,
    advice: String,
}

impl Unexcused {
    /// Looks for them; `None` if there are none. `limits` are the options that may have stopped the
    /// work.
    pub fn of(refined: &RefinedMesh, numbering: &Numbering, limits: &str) -> Option<Self> {
        let unmet = refined.report.unmet.iter();
        let worst = unmet.filter(|u| !u.reason.is_excused()).min_by(|a, b| {
            a.min_angle
                .to_degrees()
                .total_cmp(&b.min_angle.to_degrees())
        })?;
        Some(Self {
            file: numbering.file().to_owned(),
            number: refined.report.num_unexcused(),
            triangles: refined.mesh.triangulation().num_triangles(),
            worst: explain(worst, refined, numbering),
            advice: match refined.report.outcome {
                Outcome::FellBack => {
                    "ask for a smaller --min-angle, or do without --strategy thesis".to_owned()
                }
                Outcome::BudgetExhausted => format!("allow more with {limits}"),
                _ if worst.broken.angle => "ask for a smaller angle".to_owned(),
                _ => "ask for larger triangles".to_owned(),
            },
        })
    }
}

impl fmt::Display for Unexcused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}: {} of {} {} not as asked, and the input is no excuse; the worst lies {}; {}",
            self.file,
            count(self.number),
            counted(self.triangles, "triangle", "triangles"),
            if self.number == 1 { "is" } else { "are" },
            self.worst,
            self.advice
        )
    }
}
