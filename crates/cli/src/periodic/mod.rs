//! `frictiongen periodic`: finds the steady state under any periodic load.

#[cfg(feature = "pictures")]
mod draw;
mod load;

use crate::args::{FileArgument, PeriodicArguments};
use crate::asked::{parts, without_rates};
use crate::destination::Destination;
use crate::failure::Failure;
use crate::grid::{self, GridQuantity};
use crate::measure::Measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::study::columns::{Column, PeriodicRow, PeriodicSample, PeriodicTable};
use frictiongen::study::periodic::PeriodicRequest;
use frictiongen::study::scene::{Excitation, StepInput};
use frictiongen::{Of, System};
use frictiongen_codegen::SizeLimits;
use std::io::Write;

/// Runs `frictiongen periodic`.
pub fn run(arguments: &PeriodicArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let (scene_file, output) = (&arguments.scene, arguments.output.as_deref());
    let destination = Destination::of(output, Some(scene_file), &arguments.format, true)?;
    let form = destination.form;
    if form.is_picture() && !arguments.motion {
        return Err(Failure::new(
            "a picture shows the motion over a period: add --motion",
        ));
    }
    let system = scene(arguments)?;
    let mut parts = parts(&system, &arguments.of)?;
    without_rates(&parts)?;
    if arguments.of.is_empty() && system.scene().excitation == Excitation::Base {
        for part in &mut parts {
            if let Of::Mass(index) = part.of {
                part.of = Of::FromBase(index);
                part.name = system.name_of_motion(part.of);
            }
        }
    }
    let load = load::of(arguments, &system)?;
    let forces =
        grid::parse(&arguments.friction, GridQuantity::FrictionForce).map_err(Failure::new)?;
    if arguments.motion && forces.len() != 1 {
        return Err(Failure::new(
            "--motion prints one motion: give one force with --friction",
        ));
    }
    let asked = PeriodicQuestion {
        table: PeriodicTable {
            system: &system,
            parts: &parts,
        },
        request: PeriodicRequest {
            load,
            friction: 0.0,
            of: parts.iter().map(|part| part.of).collect(),
        },
        forces,
    };
    let summary = Summary::of(&system, true, Measure::groups(&system));
    destination.write(out, |out| {
        if !arguments.motion {
            return output::write(&StatesReport(&asked), &summary, form, out);
        }
        let force = asked.forces.first().copied().unwrap_or_default();
        let row = asked.row(force)?;
        #[cfg(feature = "pictures")]
        if form.is_picture() {
            return draw::motion(&asked.table, &row, form, out);
        }
        output::write(
            &MotionReport {
                asked: &asked,
                row: &row,
            },
            &summary,
            form,
            out,
        )
    })
}

/// Reads the scene from the file with its description. With `--hold` the scene keeps each force constant between
/// samples.
fn scene(arguments: &PeriodicArguments) -> Result<System, Failure> {
    let file = FileArgument {
        file: Some(arguments.scene.clone()),
    };
    let mut description = file.description(&SizeLimits::RUN_TIME)?;
    if arguments.hold {
        description.scene.stepping.input = StepInput::Hold;
    }
    System::try_from(description.scene).map_err(Failure::new)
}

/// Parsed arguments of `frictiongen periodic`.
struct PeriodicQuestion<'a> {
    table: PeriodicTable<'a>,
    request: PeriodicRequest,
    forces: Vec<f64>,
}

impl PeriodicQuestion<'_> {
    /// Finds the steady state at one kinetic friction force, in N.
    fn row(&self, friction: f64) -> Result<PeriodicRow, Failure> {
        let request = PeriodicRequest {
            friction,
            ..self.request.clone()
        };
        let state = self.table.system.periodic(&request);
        let state = state.map_err(|error| {
            Failure::new(format_args!(
                "with a friction force of {friction} N: {error}"
            ))
        })?;
        Ok(PeriodicRow { friction, state })
    }
}

/// Report of the steady states, one for each friction force.
struct StatesReport<'a>(&'a PeriodicQuestion<'a>);

impl ResultTable for StatesReport<'_> {
    type Row = PeriodicRow;

    fn len(&self) -> usize {
        self.0.forces.len()
    }

    fn each(&self, visit: Visitor<'_, PeriodicRow>) -> Result<(), Failure> {
        let mut forces = self.0.forces.iter();
        forces.try_for_each(|force| visit(&self.0.row(*force)?))
    }

    fn columns(&self) -> Vec<Column<'_, PeriodicRow>> {
        self.0.table.columns()
    }
}

/// Report of the motion over one period of a steady state.
struct MotionReport<'a> {
    asked: &'a PeriodicQuestion<'a>,
    row: &'a PeriodicRow,
}

impl<'a> ResultTable for MotionReport<'a> {
    type Row = PeriodicSample<'a>;

    fn len(&self) -> usize {
        self.row.state.forces().len()
    }

    fn each(&self, visit: Visitor<'_, PeriodicSample<'a>>) -> Result<(), Failure> {
        self.row.samples().try_for_each(|sample| visit(&sample))
    }

    fn columns(&self) -> Vec<Column<'_, PeriodicSample<'a>>> {
        self.asked.table.sample_columns()
    }
}
