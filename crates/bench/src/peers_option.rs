//! Options that the subcommands share: which peers, and where those of Python are.

use clap::Args;
use delone_bench::peer::Peer;
use delone_bench::python::{Python, Script};
use std::path::PathBuf;

/// Where Python is.
#[derive(Args)]
pub struct PythonOption {
    /// Python with numpy and the packages of the peers, or some of them
    #[arg(long, value_name = "PATH", default_value = "python3")]
    python: PathBuf,
}

impl PythonOption {
    /// Looks for Python if a peer needs it; says so if it is not there.
    pub fn find(&self, peers: &[impl Peer], script: Script) -> Option<Python> {
        peers.iter().find_map(|peer| peer.python_package())?;
        let found = Python::find(&self.python, script);
        let tell = |error| eprintln!("{}: {error}", self.python.display());
        found.map_err(tell).ok()
    }
}

/// Leaves out the peers that cannot be reached, and says so.
pub fn reachable<P: Peer>(peers: Vec<P>, python: Option<&Python>) -> Vec<P> {
    let is_here = |peer: &P| {
        let Some(package) = peer.python_package() else {
            return true;
        };
        let is_here = python.is_some_and(|python| python.version(package).is_some());
        if !is_here {
            eprintln!("{peer} is left out: `pip install {package} numpy`, and name that Python");
        }
        is_here
    };
    peers.into_iter().filter(is_here).collect()
}
