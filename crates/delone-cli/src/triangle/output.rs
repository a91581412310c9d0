//! The files that are written: those that Triangle would write, all or none of them.

use super::family::Family;
use super::names::Names;
use super::switches::Switches;
use crate::exit::Failure;
use crate::files;
use crate::progress::Progress;
use delone::ConstrainedTriangulation;
use delone_io::{Format, MeshView, Target, WriteOptions};
use std::path::PathBuf;

/// Writes a mesh as the switches ask for.
pub struct Writer<'a> {
    pub names: &'a Names,
    pub switches: &'a Switches,
    /// Whether numbers begin with 1.
    pub one_based: bool,
    /// Whether the points were read from a `.node` file, which `-I` must spare.
    pub holds_nodes: bool,
}

impl Writer<'_> {
    /// Writes the files and returns their names.
    pub fn write(
        &self,
        mesh: &ConstrainedTriangulation,
        family: Family,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        if self.switches.jettison {
            let jettisoned = family.jettison(mesh);
            self.write_view(jettisoned.view(), progress)
        } else {
            self.write_view(family.view(mesh), progress)
        }
    }

    fn write_view(&self, view: MeshView<'_>, progress: &Progress) -> Result<Vec<PathBuf>, Failure> {
        let view = match self.switches.quadratic {
            true => view.quadratic(),
            false => view,
        };
        let options = WriteOptions {
            one_based: self.one_based,
            one_by_one: true,
            without_markers: self.switches.no_markers,
            voronoi: self.switches.voronoi.then(|| self.names.output_stem()),
            ..WriteOptions::default()
        };
        delone_io::write_mesh(&self.targets(), &view, &options, progress).map_err(files::unwritable)
    }

    fn targets(&self) -> Vec<Target> {
        let Switches {
            no_node,
            no_ele,
            no_poly,
            in_place,
            ..
        } = *self.switches;
        let has_segments = self.switches.graph || self.switches.hull;
        let asked = [
            (Format::Node, !(no_node || in_place && self.holds_nodes)),
            (Format::Ele, !no_ele),
            (Format::Poly, has_segments && !no_poly && !in_place),
            (Format::Edge, self.switches.edges),
            (Format::Neigh, self.switches.neighbors),
            (Format::Off, self.switches.off),
        ];
        let asked = asked.into_iter().filter(|&(_, is_asked)| is_asked);
        let target = |(format, _): (Format, bool)| {
            Target::from_arg(self.names.output(format.name()), Some(format))
        };
        asked.map(target).collect()
    }
}
