//! Computes the motion of a scene with several contacts under a recorded input, sample by sample.

use super::read;
use crate::args::RecordingArguments;
use crate::asked::{MovingPart, without_rates};
use crate::destination::OutputFormat;
use crate::failure::Failure;
use crate::measure::Measure;
use crate::number::computed;
use crate::output::{self, ResultTable, Visitor};
#[cfg(feature = "pictures")]
use crate::picture;
use crate::summary::Summary;
use frictiongen::measure::Inputs;
use frictiongen::measure::columns::{JoinedDriven, JoinedDrivenRow, JoinedPart};
use frictiongen::study::columns::Column;
use frictiongen::study::joined::{Joined, JoinedContactNow, JoinedInput};
use frictiongen::study::scene::Excitation;
use frictiongen::{Of, System};
#[cfg(feature = "pictures")]
use frictiongen_plot::{
    Label,
    desk::{ContactTrack, JoinedMotion, joined_motion_figure, sketch_under_record},
};
use serde_json::{Value as Json, json};
use std::io::Write;

/// Motions and friction that the user requests for a scene with several contacts under a recorded input.
pub struct DriveRequest<'s> {
    system: &'s System,
    joined: Joined<'s>,
    parts: Vec<JoinedPart>,
    friction: Option<f64>,
}

impl<'s> DriveRequest<'s> {
    /// Returns the motions that the option `--of` names. Without names, returns all contacts and all masses. If the
    /// base moves, these displacements of the masses are relative to the base.
    pub fn of(
        system: &'s System,
        names: &[String],
        friction: Option<f64>,
    ) -> Result<Self, Failure> {
        let joined = system.joined().map_err(Failure::new)?;
        let contacts = joined.contact_names();
        let mut parts: Vec<JoinedPart> = Vec::new();
        if names.is_empty() {
            // Under a recorded acceleration the base drifts by metres. This drift would hide all relative motion.
            let masses = system.scene().masses.iter();
            let masses = masses.map(|mass| MovingPart::named(system, &mass.name));
            parts.extend((0..contacts.len()).map(JoinedPart::Contact));
            for mass in masses {
                let mass = mass.map_err(Failure::new)?.from_base(system);
                parts.push(JoinedPart::Mass(mass));
            }
        }
        for (place, name) in names.iter().enumerate() {
            if names.iter().take(place).any(|earlier| earlier == name) {
                return Err(Failure::new(format_args!(
                    "--of `{name}`: it is given twice"
                )));
            }
            let contact = contacts.iter().position(|contact| contact == name);
            parts.push(match contact {
                Some(contact) => JoinedPart::Contact(contact),
                None => JoinedPart::Mass(named(system, name, &contacts)?),
            });
        }
        Ok(Self {
            system,
            joined,
            parts,
            friction,
        })
    }

    /// Computes the motion under the recorded input, and writes it.
    pub fn write(
        &self,
        files: &RecordingArguments,
        form: OutputFormat,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let recording = files.inputs()?;
        let inputs = read::drive(files, &recording, self.system, self.friction)?;
        let report = DriveReport {
            asked: self,
            motion: self.motion(&inputs)?,
        };
        #[cfg(feature = "pictures")]
        if form.is_picture() {
            let title = Label::verbatim(&self.system.scene().name);
            let figure = joined_motion_figure(title, &report.drawn());
            let (what, energy) = report.energy();
            let caption = Label::verbatim(&format!("{what} {energy}"));
            let sketch = sketch_under_record(self.system.scene());
            return picture::write_with(figure.with_caption(caption), sketch, form, out);
        }
        let summary = Summary::of(self.system, true, Measure::groups(self.system));
        output::write(&&report, &summary, form, out)
    }

    /// Computes the motion under the recorded input, sample by sample.
    fn motion(&self, inputs: &Inputs<'_>) -> Result<JoinedDriven, Failure> {
        let (displacements, velocities) = inputs.initial_state(self.system);
        let step = self
            .joined
            .stepper_from(inputs.dt(), (&displacements, &velocities));
        let mut step = step.map_err(|_| {
            Failure::new(format_args!(
                "the samples are {} s apart: too far for the fastest mode of the scene",
                computed(inputs.dt())
            ))
        })?;
        let scene = self.system.scene();
        let excited = match scene.excitation {
            Excitation::Force(mass) => scene.masses.get(mass).map(|mass| mass.name.as_str()),
            Excitation::Base => None,
        };
        let contacts = scene.named_contacts();
        let asked = (self.system, self.parts.as_slice());
        let mut motion = JoinedDriven::default();
        for sample in 0..inputs.len() {
            let input = inputs.sample(sample);
            let mut forces = input.others;
            forces.extend(excited.map(|mass| (mass, input.force)));
            let frictions = contacts.iter();
            let frictions: Vec<(&str, f64)> = frictions
                .map(|contact| {
                    let friction = contact.law.share * input.friction;
                    (contact.name.as_str(), friction)
                })
                .collect();
            let now = JoinedInput {
                base: input.base,
                start_velocity: input.start_velocity,
                forces: &forces,
                frictions: &frictions,
            };
            let events = match sample {
                0 => step.begin(now).map(|()| 0),
                _ => step.advance(now),
            };
            let events = events.map_err(|error| {
                Failure::new(format_args!("sample {sample} of the recording: {error}"))
            })?;
            motion.push(&step, asked, input.end, events);
        }
        Ok(motion)
    }
}

/// Returns the mass, or the combination of masses and base, with this name.
fn named(system: &System, name: &str, contacts: &[String]) -> Result<MovingPart, Failure> {
    let contacts = contacts.join(", ");
    let part = MovingPart::named(system, name);
    let part = part.map_err(|error| {
        Failure::new(format_args!("--of: {error}; the contacts are {contacts}"))
    })?;
    if part.of == Of::Contact {
        return Err(Failure::new(format_args!(
            "--of `{name}`: the scene has several contacts; name one of them: {contacts}"
        )));
    }
    without_rates(std::slice::from_ref(&part))?;
    Ok(part)
}

/// Motion of several contacts under a recorded input, with the options for the output.
struct DriveReport<'a, 's> {
    asked: &'a DriveRequest<'s>,
    motion: JoinedDriven,
}

impl DriveReport<'_, '_> {
    /// Returns the energy that friction has dissipated in each contact, with the name of the contact.
    fn energies(&self) -> Vec<(String, f64)> {
        let last: &[JoinedContactNow] = self.motion.contacts.last().map_or(&[], Vec::as_slice);
        let names = self.asked.joined.contact_names().into_iter().zip(last);
        names.map(|(name, now)| (name, now.energy)).collect()
    }

    /// Returns a title and a text with the energy that friction has dissipated in each contact.
    fn energy(&self) -> (&'static str, String) {
        let energies = self.energies();
        let total: f64 = energies.iter().map(|(_, energy)| energy).sum();
        let each = energies.iter();
        let each: Vec<String> = each
            .map(|(name, energy)| format!("{name} {} J", computed(*energy)))
            .collect();
        let text = format!("{} J: {}", computed(total), each.join(", "));
        ("friction energy", text)
    }

    /// Returns the motion in the type that the plotting library needs.
    #[cfg(feature = "pictures")]
    fn drawn(&self) -> JoinedMotion {
        let motion = &self.motion;
        let parts = self.asked.parts.iter().filter_map(JoinedPart::mass);
        let named = parts.zip(&motion.motions);
        let named = named.map(|(part, [values, _])| {
            let track = (part.name.clone(), values.clone());
            (part.of.is_force(), track)
        });
        let (springs, masses): (Vec<_>, Vec<_>) = named.partition(|(is_force, _)| *is_force);
        let tracks = |all: Vec<(bool, (String, Vec<f64>))>| -> Vec<(String, Vec<f64>)> {
            all.into_iter().map(|(_, track)| track).collect()
        };
        let names = self.asked.joined.contact_names().into_iter().enumerate();
        let contacts = names.map(|(index, name)| {
            let states = motion.contact(index);
            ContactTrack {
                name,
                displacement: states.iter().map(|now| now.displacement).collect(),
                force: states.iter().map(|now| now.force).collect(),
                sticks: states.iter().map(|now| now.is_sticking).collect(),
            }
        });
        JoinedMotion {
            times: motion.time.clone(),
            time_label: "time (s)".into(),
            displacement_label: "displacement (m)".into(),
            force_label: "force (N)".into(),
            masses: tracks(masses),
            springs: tracks(springs),
            contacts: contacts.collect(),
        }
    }
}

impl<'d> ResultTable for &'d DriveReport<'_, '_> {
    type Row = JoinedDrivenRow<'d>;

    fn len(&self) -> usize {
        self.motion.time.len()
    }

    fn each(&self, visit: Visitor<'_, JoinedDrivenRow<'d>>) -> Result<(), Failure> {
        self.motion.rows().try_for_each(|row| visit(&row))
    }

    fn columns(&self) -> Vec<Column<'_, JoinedDrivenRow<'d>>> {
        JoinedDriven::columns(self.asked.system, &self.asked.joined, &self.asked.parts)
    }

    fn head(&self) -> Vec<(String, Json)> {
        let energies = self.energies().into_iter();
        let energies: serde_json::Map<String, Json> = energies
            .map(|(name, energy)| (format!("{name}_J"), json!(energy)))
            .collect();
        vec![("friction_energy".to_owned(), Json::Object(energies))]
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        vec![self.energy()]
    }
}
