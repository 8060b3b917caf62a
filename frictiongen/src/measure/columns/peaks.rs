//! Rows and columns of the table with the largest values of a motion.

use super::driven::part_beside;
use crate::Of;
use crate::measure::{Drive, DriveError};
use crate::study::System;
use crate::study::columns::{
    Column, Columns, Head, Measure, MovingPart, PhysicalQuantity, TableRow,
};
use crate::study::joined::{Joined, JoinedError, JoinedStepper, Peak};
use crate::study::response::MotionQuantity;
use crate::study::scene::Node;

/// Row of the table: the largest absolute value of one quantity.
#[derive(Clone, Debug)]
pub struct PeakRow {
    /// Kinetic friction force in N, if the user gave it.
    pub friction: Option<f64>,
    /// The contact, the mass or the combination, with the quantity of its motion.
    pub part: MovingPart,
    /// The largest value and the value at the end, in SI units.
    pub peak: Peak,
}

impl TableRow for PeakRow {}

/// The quantities whose largest values a table contains. Each of a contact has the index of the contact.
#[derive(Clone, Debug)]
pub struct PeakQuantities(Vec<(MovingPart, usize)>);

impl PeakQuantities {
    /// Returns the quantities with these names. `contacts` has the names of the contacts. Without names, returns slip,
    /// force and energy of all contacts, displacements and accelerations of all masses, displacements between masses that
    /// a spring joins, and the base shear.
    ///
    /// # Errors
    /// A message, which begins with the name of the `argument` that contains the names.
    pub fn named(
        system: &System,
        argument: &str,
        (contacts, names): (&[String], &[String]),
    ) -> Result<Self, String> {
        let known = of_contacts(contacts);
        let named = |name: &String| {
            let contact = known.iter().find(|(part, _)| part.name == *name);
            contact.cloned().map_or_else(
                || Ok((part_beside(system, argument, (contacts, name))?, 0)),
                Ok::<_, String>,
            )
        };
        Ok(Self(match names {
            [] => {
                let slips = known.iter().filter(|(part, _)| part.name.contains('('));
                slips.cloned().chain(of_masses(system)).collect()
            }
            names => names.iter().map(named).collect::<Result<_, _>>()?,
        }))
    }

    /// Makes a stepper follow the quantities from its next step on.
    ///
    /// # Errors
    /// [`JoinedError::Quantity`] for a quantity that the scene does not have.
    pub fn follow(&self, step: &mut JoinedStepper<'_>) -> Result<(), JoinedError> {
        let asked = self.0.iter();
        let asked: Vec<_> = asked
            .map(|(part, contact)| (part.of, part.size, *contact))
            .collect();
        step.follow_peaks(&asked)
    }

    /// Computes the rows of the motion under a recorded input, from a stepper that [follows](Self::follow) the quantities.
    /// The rows contain the friction force if the caller gives it. The motion ends early if `goes_on` returns false.
    ///
    /// # Errors
    /// Same errors as [`Drive::follow`].
    pub fn rows(
        &self,
        joined: &Joined<'_>,
        (inputs, mut step): (&dyn Drive, JoinedStepper<'_>),
        friction: Option<f64>,
        goes_on: &dyn Fn() -> bool,
    ) -> Result<Vec<PeakRow>, DriveError> {
        inputs.follow(&mut step, joined, &mut |_, _, _| goes_on())?;
        let found = self.0.iter().zip(step.peaks());
        let rows = found.map(|((part, _), peak)| PeakRow {
            friction,
            part: part.clone(),
            peak,
        });
        Ok(rows.collect())
    }
}

/// Returns the quantities of all contacts, with the index of the contact. The name of a contact means its slip.
fn of_contacts(contacts: &[String]) -> Vec<(MovingPart, usize)> {
    let all = contacts.iter().enumerate().flat_map(|(index, contact)| {
        [
            (contact.clone(), MotionQuantity::Displacement),
            (format!("slip({contact})"), MotionQuantity::Displacement),
            (format!("force({contact})"), MotionQuantity::Force),
            (format!("energy({contact})"), MotionQuantity::Energy),
        ]
        .map(|(name, size)| {
            let of = Of::Contact;
            (MovingPart { of, size, name }, index)
        })
    });
    all.collect()
}

/// Returns displacements and accelerations of all masses, displacements between masses that a spring joins, and the base
/// shear.
fn of_masses(system: &System) -> Vec<(MovingPart, usize)> {
    let scene = system.scene();
    let masses = || (0..scene.masses.len()).map(Of::Mass);
    let drifts = scene
        .springs
        .iter()
        .filter_map(|spring| match (spring.from, spring.to) {
            (Node::Mass(a), Node::Mass(b)) => Some(Of::Relative(a.max(b), a.min(b))),
            _ => None,
        });
    let shear = [Of::Shear].into_iter().filter(|of| system.has_motion(*of));
    let part = |of: Of, size: MotionQuantity| MovingPart {
        of,
        size,
        name: system.name_of_motion(of),
    };
    let moves = masses().chain(drifts).chain(shear);
    let moves = moves.map(|of| part(of, MotionQuantity::Displacement).from_base(system));
    let accelerations = masses().map(|of| {
        let part = part(of, MotionQuantity::Acceleration);
        let name = format!("accel({})", part.name);
        MovingPart { name, ..part }
    });
    moves.chain(accelerations).map(|part| (part, 0)).collect()
}

/// Returns the columns of the table of peaks.
#[must_use]
pub fn peak_columns<'a>(system: &System, rows: &[PeakRow]) -> Vec<Column<'a, PeakRow>> {
    let measure = Measure::si(system);
    let names = rows.iter().map(|row| row.part.name.as_str());
    let widest = names.max_by_key(|name| name.chars().count());
    let mut columns = Columns::new(&measure);
    if rows.iter().any(|row| row.friction.is_some()) {
        let head = Head::of("friction", PhysicalQuantity::Force);
        columns.converted(head, |row: &PeakRow| row.friction);
    }
    columns.word("quantity", widest.unwrap_or_default(), |row| {
        Some(&row.part.name)
    });
    columns.converted("peak", |row| Some(row.peak.value));
    let head = Head::of("time", PhysicalQuantity::Time);
    columns.converted(head, |row| Some(row.peak.time));
    columns.converted("end", |row| Some(row.peak.last));
    columns.word("unit", "m/s2", move |row| {
        Some(measure.unit(row.part.dimension()))
    });
    columns.done()
}
