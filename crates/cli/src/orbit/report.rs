//! Table of steady states. The printed table has one line for each moving contact or mass. CSV has one line for each
//! point, and JSON one object.

use crate::failure::Failure;
use crate::grids::Grids;
use crate::layout::Layout;
use crate::number::computed;
use crate::output::{ResultTable, Visitor};
use frictiongen::study::columns::{Column, OrbitRow, OrbitTable};

/// Explains a stuck state in which motion from rest does not end.
const COULD_STICK: &str = "The line belongs to the stuck state, in which this motion does not end.";
/// Explains another steady state in which motion from rest does not end.
const VISITED: &str = "The line belongs to a stable state that Newton's method found from the states that this motion visited.";

/// Steady states over frequency and friction, with the options for the output.
pub struct OrbitReport {
    /// Grids, units, and the contact and masses whose motions the output contains.
    pub grids: Grids,
    /// Orders n of the harmonics in the output.
    pub orders: Vec<u32>,
    /// True if the output contains every steady state that the search finds. If false, the output contains only the
    /// steady state that motion from rest reaches.
    pub states: bool,
}

impl OrbitReport {
    fn table(&self) -> OrbitTable<'_> {
        OrbitTable {
            setting: self.grids.setting(),
            orders: &self.orders,
        }
    }
}

impl ResultTable for OrbitReport {
    type Row = OrbitRow;

    fn len(&self) -> usize {
        self.grids.len()
    }

    fn each(&self, visit: Visitor<'_, OrbitRow>) -> Result<(), Failure> {
        let (table, grids) = (self.table(), &self.grids);
        for frequency in grids.frequencies.all(&grids.system) {
            let at = grids.system.at(frequency.r).map_err(Failure::new)?;
            for friction in grids.frictions.all() {
                let rows = if self.states {
                    table.states(&at, frequency, friction)
                } else {
                    table.row(&at, frequency, friction).map(|row| vec![row])
                };
                rows.map_err(Failure::new)?
                    .iter()
                    .try_for_each(&mut *visit)?;
            }
        }
        Ok(())
    }

    fn columns(&self) -> Vec<Column<'_, OrbitRow>> {
        self.table().columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }

    fn has_motions(&self, row: &OrbitRow) -> bool {
        row.is_known()
    }

    fn note(&self, row: &OrbitRow) -> Option<String> {
        let mut said = Vec::new();
        if let Some(cycles) = row.cycles_followed() {
            said.push(does_not_settle(cycles));
        }
        if row.is_settled() {
            row.cycles_followed()?;
            said.push(other_state(row.regime).to_owned());
        } else if self.states {
            let starts = if self.grids.system.scene().stiction > 1.0 {
                "from rest, from the stuck contact, from the closed form and from motions at neighbouring frictions"
            } else {
                "from rest, which is the only start with stiction 1"
            };
            said.push(format!("The search finds no stable state {starts}."));
        }
        (!said.is_empty()).then(|| at_point((row.frequency.r, row.friction.beta), &said))
    }
}

/// Returns the note that a motion does not settle.
pub fn does_not_settle(cycles: usize) -> String {
    format!("Motion from rest does not settle in {cycles} cycles.")
}

/// Returns the note that says which steady state stands in the row of a motion that does not settle.
pub fn other_state(regime: &str) -> &'static str {
    if regime == "stuck" {
        COULD_STICK
    } else {
        VISITED
    }
}

/// Returns the note on a row, which begins with its frequency and friction ratio.
pub fn at_point((r, beta): (f64, f64), said: &[String]) -> String {
    let [r, beta] = [r, beta].map(|value| computed(value).trim().to_owned());
    format!("r {r}, beta {beta}: {}", said.join(" "))
}
