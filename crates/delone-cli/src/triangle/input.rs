//! What is read: points, a graph, or a mesh that is to be refined, with the segments of its graph if
//! there is `-p`.

use super::names::Names;
use super::switches::Switches;
use crate::exit::Failure;
use crate::files;
use crate::progress::Progress;
use crate::refinable::Refinable;
use delone::DomainRule;
use delone_io::{Format, ReadOptions, Source};
use std::path::PathBuf;

/// What has been read.
pub struct Input {
    /// The name of the file, for messages.
    pub file: String,
    /// Domain or mesh.
    pub refinable: Refinable,
    /// What of it is kept.
    pub rule: DomainRule,
    /// Whether the points stood in a `.node` file.
    pub holds_nodes: bool,
}

impl Input {
    /// Reads what the switches ask for.
    pub fn read(names: &Names, switches: &Switches, progress: &Progress) -> Result<Self, Failure> {
        if switches.mesh {
            return Self::of_mesh(names, switches, progress);
        }
        let extension = if switches.graph { "poly" } else { "node" };
        let path = names.input(extension);
        let source = Source::Path(path.clone());
        let domain = delone_io::read_domain(&source, &ReadOptions::default(), progress);
        let mut domain = domain.map_err(files::unreadable)?;
        if switches.no_holes {
            domain.holes.clear();
        }
        let rule = match switches.graph && !switches.hull {
            true => DomainRule::Carve,
            false => DomainRule::Hull,
        };
        Ok(Self {
            file: path.display().to_string(),
            refinable: domain.into(),
            rule,
            holds_nodes: !switches.graph || stands_elsewhere(source),
        })
    }

    fn of_mesh(names: &Names, switches: &Switches, progress: &Progress) -> Result<Self, Failure> {
        let path = names.input("ele");
        let source = Source::Path(path.clone());
        let mesh = delone_io::read_mesh(&source, &ReadOptions::default(), progress);
        let mut mesh = mesh.map_err(files::unreadable)?;
        match &mut mesh.constraints {
            graph if !switches.graph => *graph = None,
            // Regions name no areas here, that is for the .area file.
            Some(graph) => graph.regions.clear(),
            None => require_empty_graph(names.input("poly"))?,
        }
        let areas = switches.own_areas.then(|| names.input("area"));
        let file = path.display().to_string();
        Ok(Self {
            refinable: Refinable::of_mesh(mesh, &file, areas, progress)?,
            file,
            rule: DomainRule::EvenOdd,
            holds_nodes: true,
        })
    }
}

/// Tells whether the points of a graph stand in a `.node` file.
fn stands_elsewhere(graph: Source) -> bool {
    let graph = files::Input::new(graph, Some(Format::Poly), ReadOptions::default());
    graph.files().len() > 1
}

/// Requires that a graph that says nothing is there, and has no points of its own.
fn require_empty_graph(graph: PathBuf) -> Result<(), Failure> {
    let name = graph.display().to_string();
    if !graph.is_file() {
        return Err(Failure::BadInput(format!(
            "cannot read {name}: -r with -p needs the segments of the mesh; leave -p out"
        )));
    }
    match stands_elsewhere(Source::Path(graph)) {
        true => Ok(()),
        false => Err(Failure::BadInput(format!(
            "{name} has points of its own, so it is not the graph of the mesh; leave -p out"
        ))),
    }
}
