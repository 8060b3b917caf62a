//! Results of the commands for a scene with several contacts, with dashpots, or with masses that no path of springs
//! connects to a support.

#[cfg(feature = "pictures")]
mod draw;
mod limits;
#[cfg(feature = "report")]
mod page;
mod report;
mod sensitivity;
mod time;

use crate::args::PointArguments;
use crate::asked::{self, MovingPart};
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::frequency::Frequencies;
use crate::friction::Frictions;
use crate::from;
use crate::measure::{self, Measure};
use crate::output;
use crate::summary::Summary;
use frictiongen::System;
use frictiongen::study::columns::{JoinedPart, JoinedTable, Setting};
use frictiongen::study::joined::Joined;
use frictiongen::study::scene::Scene;
use report::JoinedReport;
use sensitivity::SensitivityReport;
use std::io::Write;

#[cfg(feature = "pictures")]
pub use draw::{Picture, in_unit};
pub use limits::write as limits;
#[cfg(feature = "report")]
pub use page::write as write_page;
pub use time::OfTime;

/// Fails if the user gives one of these options, which are not available for a scene with several contacts.
pub fn refused(options: &[(bool, &str)]) -> Result<(), Failure> {
    match options.iter().find(|(given, _)| *given) {
        None => Ok(()),
        Some((_, option)) => Err(Failure::new(format_args!(
            "{option} has no answer for a scene with several `contacts`, `dampers` or `friction: stribeck`; leave it out"
        ))),
    }
}

/// Frequencies, frictions, load and masses that the user requests.
pub struct Asked<'a> {
    point: &'a PointArguments,
    frequencies: Frequencies,
    frictions: Frictions,
    of: &'a [String],
    /// Text of the initial state of the motions to steady states.
    from: Option<&'a str>,
    orders: Option<Vec<u32>>,
}

/// Frequencies, frictions, load and masses that the user requests, with the units of the results.
struct Question<'s> {
    system: &'s System,
    joined: &'s Joined<'s>,
    frequencies: Frequencies,
    frictions: Frictions,
    measure: Measure,
    parts: Vec<MovingPart>,
    /// Orders of the harmonics in the table. `None` for a table without phases and harmonics.
    orders: Option<Vec<u32>>,
}

impl Question<'_> {
    fn table(&self) -> JoinedTable<'_> {
        JoinedTable {
            setting: Setting {
                system: self.system,
                measure: self.measure,
                frequency: self.frequencies.unit(),
                frequencies: self.frequencies.given(),
                frictions: self.frictions.given(),
                forces: self.frictions.are_forces(),
                parts: &self.parts,
            },
            joined: self.joined,
            orders: self.orders.as_deref(),
        }
    }

    /// Returns the names of the motions that the user requests.
    #[cfg(feature = "report")]
    fn names(&self) -> Vec<String> {
        self.parts.iter().map(|part| part.name.clone()).collect()
    }

    fn summary(&self) -> Summary {
        Summary::of(self.system, self.frequencies.are_physical(), self.measure)
    }
}

/// Writes the free vibration of a scene with several contacts. `of` has the names of the masses in the output.
pub fn free(
    system: &System,
    time: &OfTime<'_>,
    (of, frictions): (&[String], Frictions),
    (form, out): (OutputFormat, &mut dyn Write),
) -> Result<(), Failure> {
    let joined = system.joined().map_err(Failure::new)?;
    let question = Question {
        system,
        joined: &joined,
        frequencies: Frequencies::none(),
        frictions,
        measure: Measure::si(system),
        parts: asked::motions(system, of)?,
        orders: None,
    };
    time::write(&question, time, form, out)
}

impl<'a> Asked<'a> {
    /// Collects the options of a command for a scene with several contacts.
    pub fn of(
        point: &'a PointArguments,
        frequencies: Frequencies,
        frictions: Frictions,
        of: &'a [String],
    ) -> Self {
        Self {
            point,
            frequencies,
            frictions,
            of,
            from: None,
            orders: None,
        }
    }

    /// Requests the phases of all motions, and their harmonics of these orders.
    pub fn with_harmonics(self, orders: Vec<u32>) -> Self {
        Self {
            orders: Some(orders),
            ..self
        }
    }

    /// Sets the initial state of the motions to steady states, if the user gives one.
    pub fn starting_from(self, from: Option<&'a str>) -> Self {
        Self { from, ..self }
    }

    /// Prepares the request with the units of the results, and calls `answer` with the request.
    fn question(
        self,
        scene: Scene,
        answer: impl FnOnce(&Question<'_>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let system = System::try_from(scene).map_err(Failure::new)?;
        self.frequencies.check(&system)?;
        let measure = measure::of(&self.point.load, &system)?;
        let system = from::started(self.from, system, &measure)?;
        let joined = system.joined().map_err(Failure::new)?;
        let parts = asked::motions(&system, self.of)?;
        let question = Question {
            system: &system,
            joined: &joined,
            frequencies: self.frequencies.under(&measure),
            frictions: self.frictions.under(&measure)?,
            measure,
            parts,
            orders: self.orders,
        };
        // A scene without springs requires physical units. This call reports the error before the command prints any
        // output.
        if let Some(first) = question.frequencies.all(&system).next() {
            question.table().at(first).map_err(Failure::new)?;
        }
        answer(&question)
    }

    /// Writes steady states over frequency and friction. If `states` is true, the output contains every steady state
    /// that the search finds.
    pub fn write(
        self,
        scene: Scene,
        states: bool,
        form: OutputFormat,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        self.question(scene, |question| {
            let report = JoinedReport { question, states };
            output::write(&report, &question.summary(), form, out)
        })
    }

    /// Writes derivatives of the motion of a mass, or of the numbers of a contact, with respect to every number of the
    /// scene.
    pub fn write_sensitivities(
        self,
        scene: Scene,
        of: &str,
        form: OutputFormat,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        self.question(scene, |question| {
            let of = JoinedPart::named(question.joined, "--of", of).map_err(Failure::new)?;
            let report = SensitivityReport {
                question,
                of: &of,
                with_answers: matches!(form, OutputFormat::Table(_)),
            };
            output::write(&report, &question.summary(), form, out)
        })
    }

    /// Draws the steady states of a scene with several contacts over frequency and friction.
    #[cfg(feature = "pictures")]
    pub fn draw(
        self,
        scene: Scene,
        picture: Picture,
        form: OutputFormat,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        self.question(scene, |question| {
            draw::steady(question, picture, (form, out))
        })
    }
}
