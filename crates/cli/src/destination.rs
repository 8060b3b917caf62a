//! Destination and format of a command's output. The file extension selects the format.

use crate::args::FormatArguments;
use crate::failure::Failure;
use crate::file;
use crate::fit::TableLayout;
use std::io::Write;
use std::path::Path;

/// Optional additions to a CSV file: a row of units, and comment lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extras {
    /// True if the CSV table has a second line with the units of its columns.
    pub unit_row: bool,
    /// True if comment lines (#) precede the CSV table.
    pub comments: bool,
}

/// The format of a command's output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OutputFormat {
    /// The output is a printed table for people, within the available width.
    Table(TableLayout),
    /// The output is a table of comma-separated values.
    Csv(Extras),
    /// The output is one JSON object.
    Json,
    /// The output is a vector picture (SVG).
    Svg,
    /// The output is a picture in pixels (PNG).
    Png,
}

impl OutputFormat {
    /// Returns true if the output is a picture.
    pub fn is_picture(self) -> bool {
        matches!(self, Self::Svg | Self::Png)
    }
}

impl FormatArguments {
    fn extras(&self) -> Extras {
        Extras {
            unit_row: self.unit_row,
            comments: self.comments,
        }
    }

    /// Returns the width of the printed table from the options, or the default width.
    fn fit(&self) -> TableLayout {
        match self.width {
            None => TableLayout::of_output(self.groups),
            Some(0) => TableLayout {
                width: None,
                groups: self.groups,
            },
            Some(width) => TableLayout {
                width: Some(usize::from(width)),
                groups: self.groups,
            },
        }
    }

    /// Fails if the user gives an option for CSV together with another format.
    fn check(&self, form: OutputFormat) -> Result<(), Failure> {
        let asked = [(self.unit_row, "--unit-row"), (self.comments, "--comments")];
        match (form, asked.iter().find(|(asked, _)| *asked)) {
            (OutputFormat::Csv(_), _) | (_, None) => Ok(()),
            (_, Some((_, option))) => Err(Failure::new(format_args!(
                "{option} applies only to CSV; give --csv, or a file whose name ends in .csv"
            ))),
        }
    }

    /// Returns the format that the options select for standard output. Fails if the options contradict each other.
    pub fn checked(&self) -> Result<OutputFormat, Failure> {
        self.check(self.form()).map(|()| self.form())
    }

    /// Returns the output format that the options select, without checking the other options.
    fn form(&self) -> OutputFormat {
        match (self.json, self.csv) {
            (true, _) => OutputFormat::Json,
            (_, true) => OutputFormat::Csv(self.extras()),
            _ => OutputFormat::Table(self.fit()),
        }
    }
}

/// The destination of a command's output: its format, and the file or standard output.
#[derive(Debug)]
pub struct Destination<'a> {
    /// Format of the output: table, CSV, JSON or picture.
    pub form: OutputFormat,
    /// The file, and the path of the scene description, which the command must not overwrite. `None` is standard
    /// output.
    file: Option<(&'a Path, Option<&'a Path>)>,
}

impl<'a> Destination<'a> {
    /// Reads the destination from the options. `draws` is true if the command can draw a picture.
    pub fn of(
        path: Option<&'a Path>,
        description: Option<&'a Path>,
        format: &FormatArguments,
        draws: bool,
    ) -> Result<Self, Failure> {
        let asked = format.form();
        let Some(path) = path else {
            format.check(asked)?;
            return Ok(Self {
                form: asked,
                file: None,
            });
        };
        let shown = path.display();
        let ending = path
            .extension()
            .map(|ending| ending.to_string_lossy().to_lowercase());
        let pictures = draws && cfg!(feature = "pictures");
        let form = match ending.as_deref() {
            Some("csv") => OutputFormat::Csv(format.extras()),
            Some("json") => OutputFormat::Json,
            Some("svg") if pictures => OutputFormat::Svg,
            Some("png") if pictures && cfg!(feature = "png") => OutputFormat::Png,
            Some("png") if pictures => {
                return Err(Failure::new(format_args!(
                    "--output `{shown}`: this program writes .svg but not .png; for .png build it with `--features png`"
                )));
            }
            _ => {
                let endings = if pictures && cfg!(feature = "png") {
                    ".csv, .json, .svg or .png"
                } else if pictures {
                    ".csv, .json or .svg"
                } else {
                    ".csv or .json"
                };
                return Err(Failure::new(format_args!(
                    "--output `{shown}`: the name of the file must end in {endings}"
                )));
            }
        };
        if !matches!(asked, OutputFormat::Table(_)) && asked != form {
            let option = if matches!(asked, OutputFormat::Csv(_)) {
                "--csv"
            } else {
                "--json"
            };
            return Err(Failure::new(format_args!(
                "--output `{shown}`: the name means {}, but {option} is given; leave one of the two out",
                ending.unwrap_or_default().to_uppercase()
            )));
        }
        format.check(form)?;
        // The command checks the file before it computes. The user then gets an error about the file without waiting.
        file::check(path, description)?;
        Ok(Self {
            form,
            file: Some((path, description)),
        })
    }

    /// Writes the output to the file or to standard output.
    pub fn write(
        &self,
        out: &mut dyn Write,
        answer: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        match self.file {
            Some((path, description)) => file::write_with(path, description, answer),
            None => answer(out),
        }
    }
}
