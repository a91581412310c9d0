//! The command line.

use crate::place::root;
use crate::toolchain::Wanted;
use std::path::PathBuf;

/// Build the browser module and the page of the theatre
///
/// The module goes to web/src/wasm, the page to web/dist, where the program `delone` takes it from when it is built
/// the next time.
#[derive(clap::Parser, Debug)]
#[command(name = "delone-web-build")]
pub struct Options {
    /// Build the module alone, which needs no Node.js
    #[arg(long)]
    pub module_only: bool,
    /// Build what is stale, then the program with the page in it, and open the theatre, with FILE if one is named
    #[arg(long, value_name = "FILE", conflicts_with = "module_only")]
    pub open: Option<Option<PathBuf>>,
    /// Compiler of the module: the usual one or, if that does not know the target, Debian's
    #[arg(long, value_enum, default_value = "auto")]
    pub toolchain: Wanted,
    /// Leave the module as large as the compiler has made it
    #[arg(long)]
    pub no_opt: bool,
    /// Folder of the module, instead of web/src/wasm
    #[arg(long, value_name = "FOLDER", requires = "module_only")]
    pub out: Option<PathBuf>,
}

impl Options {
    /// Tells whether all is built, fresh or stale.
    pub fn builds_all(&self) -> bool {
        self.open.is_none()
    }

    /// Returns the folder of the module.
    pub fn module_folder(&self) -> PathBuf {
        let usual = || root().join("web/src/wasm");
        self.out.clone().unwrap_or_else(usual)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::{CommandFactory, Parser};
    use std::path::Path;

    fn parse(line: &str) -> Option<Options> {
        let words = std::iter::once("delone-web-build").chain(line.split_whitespace());
        Options::try_parse_from(words).ok()
    }

    #[test]
    fn options_are_read() {
        Options::command().debug_assert();
        let options = parse("--module-only --toolchain debian --no-opt --out x").expect("options");
        assert_eq!(options.toolchain, Wanted::Debian);
        assert!(options.no_opt && options.module_only);
        assert_eq!(options.module_folder(), Path::new("x"));
        let usual = parse("").expect("no options");
        assert!(usual.module_folder().ends_with("web/src/wasm") && usual.builds_all());
        for bad in [
            "--out x",
            "--module-only --out",
            "--toolchain other",
            "x",
            "--open --module-only",
        ] {
            assert!(parse(bad).is_none(), "{bad}");
        }
    }

    #[test]
    fn a_file_may_be_opened_or_none() {
        let open = |line| parse(line).expect("options").open;
        assert_eq!(open(""), None);
        assert_eq!(open("--open"), Some(None));
        assert_eq!(open("--open lake.poly"), Some(Some("lake.poly".into())));
    }
}
