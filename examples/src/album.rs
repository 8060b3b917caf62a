//! Where a program's figures go, and how far it is.

use std::error::Error;
use std::io::{IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};

/// The figures of one program.
#[derive(Debug)]
pub struct Album {
    folder: PathBuf,
    total: usize,
    done: usize,
}

impl Album {
    /// For so many figures, in the folder of the first argument, else in this crate's `figures`.
    ///
    /// # Errors
    /// Where the folder cannot be made.
    pub fn open(total: usize) -> Result<Self, Box<dyn Error>> {
        let folder = std::env::args_os().nth(1).map_or_else(
            || Path::new(env!("CARGO_MANIFEST_DIR")).join("figures"),
            PathBuf::from,
        );
        std::fs::create_dir_all(&folder)?;
        let album = Self {
            folder,
            total,
            done: 0,
        };
        album.show();
        Ok(album)
    }

    /// Writes `figure-<number>.svg` and `.csv`.
    ///
    /// # Errors
    /// Where writing fails.
    pub fn add(&mut self, number: &str, svg: &str, csv: &str) -> Result<(), Box<dyn Error>> {
        let name = format!("figure-{number}");
        std::fs::write(self.folder.join(format!("{name}.svg")), svg)?;
        std::fs::write(self.folder.join(format!("{name}.csv")), csv)?;
        self.done += 1;
        self.show();
        Ok(())
    }

    /// # Errors
    /// Where there are not as many figures as were announced.
    pub fn close(self) -> Result<(), Box<dyn Error>> {
        if self.done == self.total {
            println!("{} figures in {}", self.done, self.folder.display());
            Ok(())
        } else {
            Err(format!("{} figures announced, {} drawn", self.total, self.done).into())
        }
    }

    /// A line that rewrites itself, for somebody who waits.
    fn show(&self) {
        let mut screen = std::io::stderr();
        if screen.is_terminal() {
            let end = if self.done == self.total { "\n" } else { "" };
            // A screen that fails must not stop the figures.
            let _ = write!(screen, "\rfigure {} of {}{end}", self.done, self.total);
        }
    }
}
