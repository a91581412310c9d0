//! `delone theatre`: the page on which algorithms are played and domains are meshed, served from the program itself.
//!
//! - [`page`]: the page, which the build has put into the program;
//! - [`given`]: the file that it is to open;
//! - [`answer`]: what is said to whom;
//! - [`server`]: sockets and threads.
//!
//! All work is done by the page. It is served rather than opened as a file, because browsers give pages from the disk
//! neither modules nor workers.

mod answer;
mod given;
mod page;
mod server;

use crate::exit::Failure;
use crate::progress::Progress;
use crate::{files, interrupt, voice};
use answer::House;
use page::{Asset, PAGE};
use server::{Door, Service};
use std::io;
use std::path::PathBuf;
use std::time::Duration;

const EXAMPLES: &str = "\
Examples:
  delone theatre                        the algorithms, in your browser
  delone theatre outline.poly           … on your own outline, which can be meshed there, too
  delone theatre mesh.ele               a mesh, with the .node and .poly beside it
  delone theatre run.json               a run that `delone algorithms run --log run.json` has kept
  delone sample lake | delone theatre - what comes from another program
  delone theatre --no-open --port 8000  only the address: for a browser of your choice";

/// What is said if there is no page.
const NO_PAGE: &str = "this program was built without the page of the theatre; in a clone of its repository \
    `cargo run --release -p delone-web-build -- --open` builds both and opens it (Node.js 20.19 or later is needed)";

/// How long a program that opens browsers may take to say that it cannot.
const PATIENCE: Duration = Duration::from_secs(2);

/// Open a page on which algorithms are played, stepped and raced, and domains meshed
///
/// The page is part of this program, works without a network, and keeps all data on this machine: it is served to this
/// machine alone. The address goes to standard output; Ctrl-C ends the program, with exit code 0.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{}", crate::exit::HELP))]
pub struct Theatre {
    /// File to open there: points, a domain, a mesh, a run (.json, .dlog), or `-`
    file: Option<PathBuf>,
    /// Port to listen on, of 127.0.0.1; 0 is any that is free
    #[arg(short, long, value_name = "N", default_value_t = 0)]
    port: u16,
    /// Do not open a browser
    #[arg(long)]
    no_open: bool,
}

impl Theatre {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let (address, service) = self.begin(PAGE, quiet)?;
        // From here on there is nothing to cancel: this is how it ends.
        interrupt::expect();
        files::print(&address)?;
        let note = match self.no_open {
            true => None,
            false => opened(&address),
        };
        if !quiet {
            note.iter().for_each(|note| voice::note(note));
            voice::say("the page is there as long as this program runs; Ctrl-C ends it");
        }
        Err(stopped(&service.wait()))
    }

    /// Serves a page, and returns its address.
    fn begin(&self, page: &'static [Asset], quiet: bool) -> Result<(String, Service), Failure> {
        if page.is_empty() {
            return Err(Failure::NotReached(NO_PAGE.to_owned()));
        }
        let progress = Progress::new(quiet);
        let lent = self
            .file
            .as_deref()
            .map(|file| given::look_at(file, &progress));
        let lent = lent.transpose()?.unwrap_or_default();
        progress.finish();
        let door = Door::open(self.port).map_err(|error| self.taken(&error))?;
        let port = door.port();
        let address = format!("http://127.0.0.1:{port}/{}", given::fragment(&lent));
        let service = door.serve(House { page, lent, port });
        Ok((address, service.map_err(|error| stopped(&error))?))
    }

    fn taken(&self, error: &io::Error) -> Failure {
        let port = self.port;
        Failure::NotReached(format!(
            "cannot listen on port {port} of 127.0.0.1: {error}; without --port any that is free will do"
        ))
    }
}

/// Opens a browser, or says that there is none.
fn opened(address: &str) -> Option<&'static str> {
    let tried = open::that_detached_with_timeout(address, PATIENCE);
    tried
        .err()
        .map(|_| "no browser could be opened: open the address yourself")
}

fn stopped(error: &io::Error) -> Failure {
    Failure::NotReached(format!("the server cannot go on: {error}; start it again"))
}

#[cfg(test)]
mod tests;
