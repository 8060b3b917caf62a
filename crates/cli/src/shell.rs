//! Prints or installs the manual pages and the completion scripts for shells. The crates `clap_complete` and
//! `clap_mangen` generate these texts from the definition of the arguments.

use crate::args::{Arguments, CompletionsArguments, ManArguments, SetupArguments};
use crate::failure::{Failure, reason};
use clap::CommandFactory;
use clap_complete::Shell;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The folder in which each shell looks for the completions of a program. The paths are relative to the folder of
/// shared data.
const FOLDERS: [(Shell, &str); 3] = [
    (Shell::Bash, "bash-completion/completions"),
    (Shell::Zsh, "zsh/site-functions"),
    (Shell::Fish, "fish/vendor_completions.d"),
];
/// Folder of the manual pages, relative to the folder of shared data.
const PAGES: &str = "man/man1";

/// Prints the completion script of a shell.
pub fn completions(arguments: &CompletionsArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let mut script = Vec::new();
    let mut command = Arguments::command();
    clap_complete::generate(arguments.shell, &mut command, "frictiongen", &mut script);
    out.write_all(&script)?;
    Ok(out.flush()?)
}

/// Prints the manual page of the program or of one command.
pub fn man(arguments: &ManArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let mut command = Arguments::command();
    command.build();
    if let Some(name) = arguments.command.as_deref() {
        let part = command.find_subcommand(name).cloned();
        command = part.ok_or_else(|| {
            Failure::new(format_args!(
                "there is no command {name}: see frictiongen --help"
            ))
        })?;
    }
    let mut page = Vec::new();
    clap_mangen::Man::new(command).render(&mut page)?;
    out.write_all(&page)?;
    Ok(out.flush()?)
}

/// Writes the completion scripts and the manual pages into the folders in which shells and `man` look for them. Prints
/// the path of each completion script, and the folder of the pages.
pub fn setup(arguments: &SetupArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let share = match &arguments.share {
        Some(share) => share.clone(),
        None => shared_data()?,
    };
    let mut command = Arguments::command();
    for (shell, folder) in FOLDERS {
        let folder = create(share.join(folder))?;
        let path = clap_complete::generate_to(shell, &mut command, "frictiongen", &folder)
            .map_err(|error| cannot_write(&folder, &error))?;
        writeln!(out, "{}", path.display())?;
    }
    let folder = create(share.join(PAGES))?;
    clap_mangen::generate_to(command, &folder).map_err(|error| cannot_write(&folder, &error))?;
    writeln!(out, "{}", folder.display())?;
    let zsh = share.join("zsh/site-functions");
    writeln!(
        out,
        "Open a new shell. If zsh completes nothing, write `fpath+=({})` into .zshrc, before compinit.",
        zsh.display()
    )?;
    Ok(out.flush()?)
}

/// Returns the folder of this user for data that programs share.
fn shared_data() -> Result<PathBuf, Failure> {
    let set = |name| std::env::var_os(name).filter(|value| !value.is_empty());
    let home = || set("HOME").map(|home| Path::new(&home).join(".local/share"));
    // According to the XDG standard, programs ignore a relative path in this variable.
    let given = set("XDG_DATA_HOME").map(PathBuf::from);
    let given = given.filter(|path| path.is_absolute());
    given.or_else(home).ok_or_else(|| {
        Failure::new(
            "HOME is not set; give the folder by --share, such as --share /usr/local/share",
        )
    })
}

fn create(folder: PathBuf) -> Result<PathBuf, Failure> {
    std::fs::create_dir_all(&folder).map_err(|error| cannot_write(&folder, &error))?;
    Ok(folder)
}

fn cannot_write(folder: &Path, error: &std::io::Error) -> Failure {
    Failure::new(format_args!(
        "cannot write into the folder {}: {}; give another folder by --share",
        folder.display(),
        reason(error)
    ))
}
