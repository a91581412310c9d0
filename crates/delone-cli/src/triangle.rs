//! `delone triangle`: Triangle's switches in, Triangle's files out, for the scripts that people have.

mod family;
mod help;
mod input;
mod names;
mod output;
mod summary;
mod switches;

use crate::exit::Failure;
use crate::files;
use crate::job::refine;
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::refinable::Refinable;
use crate::unmet::Unexcused;
use delone::sizing::Areas;
use delone::{
    Angle, Budget, ConstrainedDelaunay, ConstrainedTriangulation, DomainRule, Encroachment, Locked,
    Pslg, Quality, RefinedMesh, Refinement, Report, SegmentPolicy,
};
use delone_io::Inherited;
use family::Family;
use input::Input;
use names::Names;
use output::Writer;
use std::ffi::OsString;
use summary::Summary;
use switches::Switches;

/// Do what Triangle does: the same switches, the same files
///
/// A compatibility entry for scripts: reads FILE.node, FILE.poly (-p) or FILE.ele (-r), and writes
/// FILE.1.node, FILE.1.ele and what else the switches ask for, FILE.2.* of FILE.1.*, and so on. Numbers
/// begin with 0 or 1 as in the input, and markers are given as Triangle gives them. The triangles are
/// Delone's own: fewer of them, exact, and refinement ends for every angle.
///
/// A summary goes to standard output.
#[derive(clap::Args)]
#[command(
    override_usage = "delone triangle [-prq__a__AcDjenvgBPNEIOo_YS__QVh] FILE",
    after_help = help::SWITCHES,
    after_long_help = format!("{}\n\n{}", help::SWITCHES, crate::exit::HELP)
)]
pub struct Triangle {
    /// Switches, bundled as in -pq30a0.1D or one by one, and the name of one input file
    #[arg(required = true, value_name = "SWITCHES|FILE")]
    arguments: Vec<OsString>,
}

/// What has been made of an input.
enum Made {
    /// Nothing was asked for that needs more.
    Triangulated(Box<ConstrainedTriangulation>),
    Refined(Box<RefinedMesh>),
}

impl Made {
    fn mesh(&self) -> &ConstrainedTriangulation {
        match self {
            Self::Triangulated(mesh) => mesh,
            Self::Refined(refined) => &refined.mesh,
        }
    }

    /// Returns what refinement has reached, if there was any.
    fn report(&self) -> Option<&Report> {
        match self {
            Self::Triangulated(_) => None,
            Self::Refined(refined) => Some(&refined.report),
        }
    }

    /// Looks for triangles that are not as asked without excuse.
    fn unexcused(&self, numbering: &Numbering) -> Option<Unexcused> {
        match self {
            Self::Triangulated(_) => None,
            Self::Refined(refined) => Unexcused::of(refined, numbering, "-S"),
        }
    }
}

impl Triangle {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let (mut switches, file) = Switches::parse(&self.arguments)?;
        let names = Names::of(&file, &mut switches)?;
        let quiet = quiet || switches.quiet;
        let progress = Progress::new(quiet);

        let input = Input::read(&names, &switches, &progress)?;
        let Input {
            refinable,
            rule,
            holds_nodes,
            file,
        } = input;
        let Refinable {
            mut domain,
            sizes,
            ancestors,
        } = refinable;
        let numbering = Numbering::of(&file, &domain);
        let pslg = domain.take_pslg();
        let mut summary = Summary::of_input(&file, &pslg);
        let maker = Maker {
            switches: &switches,
            rule,
            numbering: &numbering,
            progress: &progress,
        };
        let made = maker.make(pslg, sizes.as_ref())?;
        progress.note(&numbering.notes(made.mesh()));

        let writer = Writer {
            names: &names,
            switches: &switches,
            one_based: domain.vertices.base == 1,
            holds_nodes,
        };
        let inherited = Inherited::as_in_triangle(made.mesh(), domain, &progress);
        let inherited = inherited.map_err(files::unwritable)?;
        let family = Family::new(made.mesh(), inherited, ancestors.as_ref(), &switches);
        let written = writer.write(made.mesh(), family, &progress)?;
        progress.finish();
        if !quiet {
            summary.add_mesh(made.mesh(), made.report());
            summary.add_files(&written);
            files::print(&summary.to_string())?;
        }
        let unexcused = made.unexcused(&numbering);
        unexcused.map_or(Ok(()), |u| Err(Failure::NotReached(u.to_string())))
    }
}

/// Triangulates, and refines if a switch asks for it.
struct Maker<'a> {
    switches: &'a Switches,
    rule: DomainRule,
    numbering: &'a Numbering,
    progress: &'a Progress,
}

impl Maker<'_> {
    fn make(&self, pslg: Pslg, sizes: Option<&Areas>) -> Result<Made, Failure> {
        let switches = self.switches;
        if !switches.refines() {
            return Ok(Made::Triangulated(self.triangulate(pslg)?.into()));
        }
        let budget = self.budget(&pslg)?;
        let mut refinement = Refinement::new(self.quality())
            .domain(self.rule)
            .crossings(SegmentPolicy::Split)
            .locked(match switches.locked {
                0 => Locked::Nothing,
                1 => Locked::Boundary,
                _ => Locked::Segments,
            })
            .encroachment(match switches.conforming {
                true => Encroachment::Circle,
                false => Encroachment::Lens,
            })
            .budget(budget)
            .watch(self.progress);
        if let Some(sizes) = sizes {
            refinement = refinement.sizing(sizes);
        }
        let refined = refine(refinement, pslg, self.numbering)?;
        Ok(Made::Refined(refined.into()))
    }

    /// Triangulates; Triangle always splits segments that cross.
    fn triangulate(&self, pslg: Pslg) -> Result<ConstrainedTriangulation, Failure> {
        let builder = ConstrainedDelaunay::new()
            .domain(self.rule)
            .crossings(SegmentPolicy::Split)
            .watch(self.progress);
        let built = builder.triangulate(pslg);
        built.map_err(|error| self.numbering.failure(error))
    }

    fn quality(&self) -> Quality {
        Quality {
            min_angle: self.switches.min_angle.map(Angle::degrees),
            max_area: self.switches.max_area,
            region_areas: self.switches.own_areas,
            ..Quality::default()
        }
    }

    /// Limits the number of Steiner points; vertices where segments cross do not count as such.
    fn budget(&self, pslg: &Pslg) -> Result<Budget, Failure> {
        let Some(most) = self.switches.steiner else {
            return Ok(Budget::default());
        };
        let crossings = self.triangulate(pslg.clone())?.num_crossings();
        Ok(Budget {
            vertices: Some(pslg.points.len() + crossings + most),
            ..Budget::default()
        })
    }
}

/// Sets off the arguments of `delone triangle` by `--`, so that no switch of Triangle is taken for an
/// option of ours: `-q30` has nothing to do with `--quiet`.
pub fn set_off(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let is_option = |a: &OsString| a.to_string_lossy().starts_with('-');
    let command = arguments.iter().skip(1).position(|a| !is_option(a));
    let Some(place) = command.map(|i| i + 1) else {
        return arguments;
    };
    if arguments[place] != "triangle" {
        return arguments;
    }
    let asks = |a: &OsString| a == "--help" || Switches::ask_for_help(a);
    if arguments[place + 1..].iter().any(asks) {
        arguments.truncate(place + 1);
        arguments.push("--help".into());
    } else if arguments.len() > place + 1 && arguments[place + 1] != "--" {
        arguments.insert(place + 1, "--".into());
    }
    arguments
}

#[cfg(test)]
mod tests {
    use super::set_off;
    use std::ffi::OsString;

    #[test]
    fn switches_of_triangle_are_set_off_from_ours() {
        let set_off = |line: &str| {
            let words = set_off(line.split(' ').map(OsString::from).collect());
            words.join(" ".as_ref()).into_string().expect("UTF-8")
        };
        for (given, expected) in [
            ("delone triangle -q a.node", "delone triangle -- -q a.node"),
            ("delone -q triangle -p a", "delone -q triangle -- -p a"),
            ("delone triangle -- -p a", "delone triangle -- -p a"),
            ("delone triangle -ph a", "delone triangle --help"),
            ("delone triangle a --help", "delone triangle --help"),
            ("delone triangle", "delone triangle"),
            ("delone mesh -q triangle", "delone mesh -q triangle"),
            ("delone", "delone"),
        ] {
            assert_eq!(set_off(given), expected);
        }
    }
}
