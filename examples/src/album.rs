//! Manages the figures that a program writes: their folder and the progress of the work.

use std::error::Error;
use std::io::{IsTerminal as _, Write as _};
use std::path::{Path, PathBuf};

/// The figures of one program, with the folder to which they are written.
#[derive(Debug)]
pub struct Album {
    folder: PathBuf,
    total: usize,
    done: usize,
}

impl Album {
    /// Creates an album of `total` figures in the folder of the first argument, by default in this crate's `figures`.
    ///
    /// # Errors
    /// Fails if the folder cannot be created.
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

    /// Writes a picture to the file `figure-<name>.png`.
    ///
    /// # Errors
    /// Fails if the file cannot be written.
    #[cfg(feature = "png")]
    pub fn picture(&self, name: &str, png: &[u8]) -> Result<(), Box<dyn Error>> {
        Ok(std::fs::write(
            self.folder.join(format!("figure-{name}.png")),
            png,
        )?)
    }

    /// Writes a figure to `figure-<number>.svg`, and its data to `figure-<number>.csv`.
    ///
    /// # Errors
    /// Fails if a file cannot be written.
    pub fn add(&mut self, number: &str, svg: &str, csv: &str) -> Result<(), Box<dyn Error>> {
        let name = format!("figure-{number}.csv");
        std::fs::write(self.folder.join(name), csv)?;
        self.add_picture(number, svg)
    }

    /// Writes `figure-<number>.svg` of a figure without data, such as a sketch.
    ///
    /// # Errors
    /// Fails if the file cannot be written.
    pub fn add_picture(&mut self, number: &str, svg: &str) -> Result<(), Box<dyn Error>> {
        let name = format!("figure-{number}.svg");
        std::fs::write(self.folder.join(name), svg)?;
        self.done += 1;
        self.show();
        Ok(())
    }

    /// Ends the album.
    ///
    /// # Errors
    /// Fails if the number of figures is not the announced one.
    pub fn close(self) -> Result<(), Box<dyn Error>> {
        if self.done == self.total {
            println!("{} figures in {}", self.done, self.folder.display());
            Ok(())
        } else {
            Err(format!("{} figures announced, {} drawn", self.total, self.done).into())
        }
    }

    /// Shows how many figures are finished, in one line of a terminal that each call overwrites.
    fn show(&self) {
        let mut screen = std::io::stderr();
        if screen.is_terminal() {
            let end = if self.done == self.total { "\n" } else { "" };
            // A terminal error must not stop the figures.
            let _ = write!(screen, "\rfigure {} of {}{end}", self.done, self.total);
        }
    }
}
