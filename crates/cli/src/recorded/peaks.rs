//! Computes the largest values of the motion under a recorded input.

use super::drive::named;
use super::driven::{follow, start};
use crate::failure::Failure;
use crate::output::{ResultTable, Visitor};
use frictiongen::measure::Inputs;
use frictiongen::measure::columns::{PeakRow, peak_columns};
use frictiongen::study::columns::{Column, MovingPart};
use frictiongen::study::joined::Joined;
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::scene::Node;
use frictiongen::{Of, System};

/// Largest values of the motion of a scene under a recorded input.
pub struct PeaksReport<'s> {
    system: &'s System,
    /// The quantities. Each of a contact has the index of the contact.
    parts: Vec<(MovingPart, usize)>,
    rows: Vec<PeakRow>,
}

impl<'s> PeaksReport<'s> {
    /// Returns a report without rows, of the quantities that the option `--of` names. Without names, it has slip, force and
    /// energy of all contacts, displacements and accelerations of all masses, displacements between masses that a
    /// spring joins, and the base shear.
    pub fn new(system: &'s System, contacts: &[String], names: &[String]) -> Result<Self, Failure> {
        let known = of_contacts(contacts);
        let named = |name: &String| {
            let contact = known.iter().find(|(part, _)| part.name == *name);
            contact
                .cloned()
                .map_or_else(|| Ok((named(system, contacts, name)?, 0)), Ok::<_, Failure>)
        };
        let parts = match names {
            [] => {
                let slips = known.iter().filter(|(part, _)| part.name.contains('('));
                slips.cloned().chain(of_masses(system)).collect()
            }
            names => names.iter().map(named).collect::<Result<_, _>>()?,
        };
        Ok(Self {
            system,
            parts,
            rows: Vec::new(),
        })
    }

    /// Adds the peaks of the motion under the recorded input. The rows contain the friction force if the user gave it.
    pub fn add(
        &mut self,
        joined: &Joined<'_>,
        inputs: &Inputs<'_>,
        friction: Option<f64>,
    ) -> Result<(), Failure> {
        let asked = self.parts.iter();
        let asked: Vec<_> = asked
            .map(|(part, contact)| (part.of, part.size, *contact))
            .collect();
        let mut step = start(joined, self.system, inputs)?;
        step.follow_peaks(&asked).map_err(Failure::new)?;
        follow(&mut step, self.system, inputs, |_, _, _| ())?;
        let found = self.parts.iter().zip(step.peaks());
        self.rows.extend(found.map(|((part, _), peak)| PeakRow {
            friction,
            part: part.clone(),
            peak,
        }));
        Ok(())
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

impl ResultTable for PeaksReport<'_> {
    type Row = PeakRow;

    fn len(&self) -> usize {
        self.rows.len()
    }

    fn each(&self, visit: Visitor<'_, PeakRow>) -> Result<(), Failure> {
        self.rows.iter().try_for_each(visit)
    }

    fn columns(&self) -> Vec<Column<'_, PeakRow>> {
        peak_columns(self.system, &self.rows)
    }
}
