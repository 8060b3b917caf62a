//! `frictiongen limit-cycle`: prints the periodic motions that scenes have without a load.

use crate::args::LimitCycleArguments;
use crate::asked;
use crate::destination::Destination;
use crate::failure::Failure;
use crate::friction::Frictions;
use crate::from;
use crate::layout::Layout;
use crate::measure::Measure;
use crate::output::{self, ResultTable, Visitor};
use crate::summary::Summary;
use frictiongen::study::InitialState;
use frictiongen::study::columns::{Column, FrequencyUnit, JoinedRow, JoinedTable, Setting};
use std::cell::RefCell;
use std::io::Write;

/// Runs `frictiongen limit-cycle`.
pub fn run(arguments: &LimitCycleArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let (path, output) = (arguments.file.path(), arguments.output.as_deref());
    let destination = Destination::of(output, path, &arguments.format, false)?;
    let frictions = Frictions::parse(&arguments.friction, None)?;
    let mut system = arguments.file.maybe_unloaded()?;
    let measure = Measure::si(&system);
    let frictions = frictions.under(&measure)?;
    if let Some(text) = arguments.from.from.as_deref().map(str::trim)
        && text != from::REST
    {
        let state = from::state(text, &system, None, 1.0)?;
        system = system.starting_from(InitialState::groups(state));
    }
    let parts = asked::motions(&system, &arguments.of)?;
    let joined = system.joined().map_err(Failure::new)?;
    let report = CyclesReport {
        table: JoinedTable {
            setting: Setting {
                frictions: frictions.given(),
                forces: frictions.are_forces(),
                parts: &parts,
                ..Setting::new(&system, measure, FrequencyUnit::Hertz)
            },
            joined: &joined,
            orders: None,
        },
        frictions: &frictions,
        without: RefCell::new(Vec::new()),
    };
    let summary = Summary::of(&system, true, measure);
    destination.write(out, |out| {
        output::write(&report, &summary, destination.form, out)
    })
}

/// Limit cycles at the frictions that the user requests.
struct CyclesReport<'s> {
    table: JoinedTable<'s>,
    frictions: &'s Frictions,
    /// Frictions in N without a limit cycle.
    without: RefCell<Vec<f64>>,
}

impl ResultTable for CyclesReport<'_> {
    type Row = JoinedRow;

    fn len(&self) -> usize {
        self.frictions.len()
    }

    fn each(&self, visit: Visitor<'_, JoinedRow>) -> Result<(), Failure> {
        self.without.borrow_mut().clear();
        for friction in self.frictions.all() {
            match self.table.cycle(friction).map_err(Failure::new)? {
                Some(row) => visit(&row)?,
                None => self.without.borrow_mut().push(friction.force()),
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, JoinedRow>> {
        self.table.cycle_columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }

    fn list(&self) -> &'static str {
        "cycles"
    }

    fn tail(&self) -> Option<(&'static str, String)> {
        let without = self.without.borrow();
        let frictions: Vec<String> = without.iter().map(|force| format!("{force} N")).collect();
        (!frictions.is_empty()).then(|| {
            let text = format!(
                "no cycle at {}: from this start the motion comes to rest, slides steadily or does not repeat",
                frictions.join(", ")
            );
            ("without", text)
        })
    }
}
