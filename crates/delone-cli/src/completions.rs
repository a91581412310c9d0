//! `delone completions` and `delone man`: what shells and readers of manuals want to know of the program.

use crate::cli::Cli;
use crate::exit::Failure;
use crate::files;
use crate::words;
use clap::CommandFactory;
use clap_complete::Shell;
use std::path::{Path, PathBuf};

const COMPLETIONS: &str = "\
Examples:
  delone completions bash > ~/.local/share/bash-completion/completions/delone
  delone completions zsh > ~/.zfunc/_delone            with ~/.zfunc in $fpath
  delone completions fish > ~/.config/fish/completions/delone.fish
  delone completions powershell >> $PROFILE";

const PAGES: &str = "\
Examples:
  delone man | man -l -                        the page of the program
  delone man mesh | man -l -                   the page of a command
  delone man --out-dir ~/.local/share/man/man1   all pages, as delone.1, delone-mesh.1, …";

/// Print what a shell needs to complete options and names of formats
#[derive(clap::Args)]
#[command(after_help = COMPLETIONS, after_long_help = format!("{COMPLETIONS}\n\n{}", crate::exit::HELP))]
pub struct Completions {
    /// Which shell
    shell: Shell,
}

/// Print manual pages, or write them all
#[derive(clap::Args)]
#[command(after_help = PAGES, after_long_help = format!("{PAGES}\n\n{}", crate::exit::HELP))]
pub struct Man {
    /// Command whose page is printed, as in mesh or algorithms run [default: the program]
    command: Vec<String>,
    /// Folder to write the pages of all commands to; it is made if it is not there
    #[arg(long, value_name = "DIR", conflicts_with = "command")]
    out_dir: Option<PathBuf>,
}

impl Completions {
    /// Runs the command.
    pub fn run(&self) -> Result<(), Failure> {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut Cli::command(), "delone", &mut text);
        files::print(String::from_utf8_lossy(&text).trim_end())
    }
}

impl Man {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let mut cli = Cli::command().disable_help_subcommand(true);
        cli.build();
        if let Some(folder) = &self.out_dir {
            let pages = write_all(&cli, folder)?;
            if !quiet {
                let what = words::counted(pages, "page", "pages");
                crate::voice::say(&format!("wrote {what} to {}", folder.display()));
            }
            return Ok(());
        }
        let mut command = &cli;
        for name in &self.command {
            command = command.find_subcommand(name).ok_or_else(|| {
                Failure::Usage(format!("there is no command {}", self.command.join(" ")))
            })?;
        }
        files::print(page(command)?.trim_end())
    }
}

/// Writes the page of a command.
fn page(command: &clap::Command) -> Result<String, Failure> {
    let mut text = Vec::new();
    let rendered = clap_mangen::Man::new(command.clone()).render(&mut text);
    rendered.map_err(|error| Failure::NotReached(error.to_string()))?;
    Ok(portable(&String::from_utf8_lossy(&text)))
}

/// Replaces what is not ASCII by escapes, for not every reader of manuals expects UTF-8.
fn portable(text: &str) -> String {
    let mut page = String::with_capacity(text.len());
    for c in text.chars() {
        match c.is_ascii() {
            true => page.push(c),
            false => page += &format!("\\[u{:04X}]", c as u32),
        }
    }
    page
}

/// Writes the pages of a command and all below it, and returns how many these are.
fn write_all(command: &clap::Command, folder: &Path) -> Result<usize, Failure> {
    let name = command
        .get_display_name()
        .unwrap_or_else(|| command.get_name());
    let path = folder.join(format!("{name}.1"));
    let text = page(command)?;
    let written = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| {
        Failure::NotReached(format!("cannot write {}: {error}", path.display()))
    })?;
    let below = command.get_subcommands().filter(|c| !c.is_hide_set());
    let below = below.map(|command| write_all(command, folder));
    below.sum::<Result<usize, Failure>>().map(|n| n + 1)
}
