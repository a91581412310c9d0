//! Outputs, settled before the work begins: their names, their formats, and that none is in the way of another.

use super::content::Content;
use super::family::{self, Member};
use super::losses::Held;
use crate::exit::Failure;
use delone_io::{Format, Target};
use std::path::{Path, PathBuf};

/// Outputs whose names, formats and folders have been looked at before the work begins.
#[derive(Default)]
pub struct Outputs {
    pub(super) files: Vec<Target>,
    /// What is written besides: pages, diagrams, sites, reliefs.
    pub(super) asides: Vec<(Content, Target)>,
    /// The files that all these consist of.
    pub(super) members: Vec<Member>,
    pub(super) stream: Option<Target>,
    /// The papers that go with the mesh.
    pub(super) papers: PaperNames,
}

/// Names of the papers that go with a mesh.
#[derive(Clone, Default)]
pub struct PaperNames {
    /// The certificate.
    pub certificate: Option<PathBuf>,
    /// The table of lineage.
    pub lineage: Option<PathBuf>,
}

impl Outputs {
    /// Tells whether something goes to standard output.
    pub fn use_stdout(&self) -> bool {
        self.stream.is_some()
    }

    /// Requires that results told as JSON, if they are, have standard output to themselves.
    pub fn leave_stdout_to(&self, json: bool) -> Result<(), Failure> {
        if !json || !self.use_stdout() {
            return Ok(());
        }
        let clash = "--json and the output `-` both want standard output; name a file for one";
        Err(Failure::Usage(clash.to_owned()))
    }

    /// Tells whether there is nothing to write.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty() && self.asides.is_empty() && self.stream.is_none()
    }

    /// Requires that none of the files to be written is one of those that are read.
    pub fn spare(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        self.members
            .iter()
            .try_for_each(|member| member.require_not_among(inputs))
    }

    /// Says in words what of something the outputs have no place for.
    pub(super) fn losses(&self, held: &Held<'_>, ascii: bool) -> Vec<String> {
        let files = self.files.iter().map(|target| (target, false));
        let streams = self.stream.iter().map(|target| (target, true));
        let all = files.chain(streams);
        all.flat_map(|(target, alone)| held.losses(target, alone, ascii))
            .collect()
    }

    /// Settles a file that somebody else writes, alone.
    pub fn reserve(&mut self, path: &Path) -> Result<(), Failure> {
        self.add_member(family::alone(path))
    }

    /// Lists the files that are going to be written, as the command line names them.
    pub fn names(&self) -> Vec<PathBuf> {
        let asides = self.asides.iter().map(|(_, target)| target);
        let paths = self.files.iter().chain(asides);
        paths.filter_map(|target| target.path.clone()).collect()
    }

    /// Lists all files that these consist of: the output, the name, and the one true name if there is one.
    pub fn places(&self) -> impl Iterator<Item = (&Path, &Path, Option<&Path>)> {
        self.members.iter().map(Member::names)
    }

    /// Returns the first file that can be read back as a mesh.
    pub fn mesh_file(&self) -> Option<&Path> {
        let is_mesh = |target: &&Target| target.format.is_some_and(Format::reads_mesh);
        self.files.iter().find(is_mesh)?.path.as_deref()
    }

    /// Settles the papers that go with the mesh.
    pub fn add_papers(&mut self, papers: PaperNames) -> Result<(), Failure> {
        for path in papers.certificate.iter().chain(&papers.lineage) {
            self.reserve(path)?;
        }
        self.papers = papers;
        Ok(())
    }

    /// Returns the names of the papers that go with the mesh.
    pub fn papers(&self) -> &PaperNames {
        &self.papers
    }

    pub(super) fn add_member(&mut self, member: Member) -> Result<(), Failure> {
        member.require_writable()?;
        let apart = |other: &Member| member.require_apart_from(other);
        self.members.iter().try_for_each(apart)?;
        self.members.push(member);
        Ok(())
    }

    pub(super) fn add_file(
        &mut self,
        path: &Path,
        format: Format,
        content: Content,
    ) -> Result<(), Failure> {
        for member in family::members(path, format, content) {
            self.add_member(member)?;
        }
        let target = Target::from_arg(path, Some(format));
        if content.is_aside() {
            self.asides.push((content, target));
        } else {
            self.files.push(target);
        }
        Ok(())
    }

    /// Tells whether there is something of this content to be written besides.
    pub fn has_aside(&self, content: Content) -> bool {
        self.asides.iter().any(|(c, _)| *c == content)
    }

    /// Lists the files.
    pub fn pictures(&self) -> Vec<Target> {
        self.files.iter().chain(&self.stream).cloned().collect()
    }

    /// Lists what is written besides that has this content.
    pub(super) fn asides(&self, content: Content) -> Vec<Target> {
        let matching = self.asides.iter().filter(|(c, _)| *c == content);
        matching.map(|(_, target)| target.clone()).collect()
    }

    pub(super) fn add_stream(&mut self, format: Format) -> Result<(), Failure> {
        if self.stream.is_some() {
            let twice = "only one output can go to standard output; give the others a name";
            return Err(Failure::Usage(twice.to_owned()));
        }
        self.stream = Some(Target::from_arg("-", Some(format)));
        Ok(())
    }
}
