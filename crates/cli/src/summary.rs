//! Lines before a table: the scene, its natural frequencies and the non-dimensional groups.

use crate::measure::{self, Measure};
use crate::number::computed;
use frictiongen::System;
use frictiongen::study::scene::{CONTACT, Damping, DampingFrom, Excitation, Node, Scene};
use frictiongen::study::units;
use std::io::{self, Write};

/// Largest number of natural frequencies in the lines before a table.
const MOST_SHOWN: usize = 8;

/// Contents of the lines before a table.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Name of the scene.
    pub scene: String,
    /// Natural frequencies in the units of the scene's masses and stiffnesses (rad/s for kg and N/m), in ascending
    /// order.
    pub natural_frequencies: Vec<f64>,
    /// Natural frequencies of the scene, as frequency ratios r.
    pub resonances: Vec<f64>,
    /// Contact, excitation, damping and μ of the scene, in words.
    description: String,
    /// True if the excitation is base motion.
    base_motion: bool,
    /// Natural frequencies in Hz. `None` if the user gave all frequencies as ratios.
    pub hertz: Option<Vec<f64>>,
    /// Units of the results: SI units if the amplitude of the load is given, otherwise non-dimensional groups.
    pub measure: Measure,
}

impl Summary {
    /// Collects the contents of the lines before a table, for a system.
    pub fn of(system: &System, physical: bool, measure: Measure) -> Self {
        let scene = system.scene();
        let natural_frequencies = system.natural_frequencies();
        let in_hertz = || natural_frequencies.iter().copied().map(units::hertz);
        let hertz = physical.then(|| in_hertz().collect());
        Self {
            scene: scene.name.clone(),
            natural_frequencies,
            resonances: system.resonances().to_vec(),
            description: description(scene, measure.is_free().then_some("no load")),
            base_motion: scene.excitation == Excitation::Base,
            hertz,
            measure,
        }
    }

    /// Says that inputs over time act on the scene.
    pub fn under_inputs(self, scene: &Scene) -> Self {
        Self {
            description: description(scene, Some("inputs over time")),
            ..self
        }
    }

    /// Returns the definition of the friction ratio β for this excitation, as text.
    pub fn friction_ratio(&self) -> &'static str {
        if self.base_motion { "F/(k1 Y)" } else { "F/P" }
    }

    /// Writes the text of [`write`](Self::write), with `# ` before each line, so that a CSV reader skips the lines.
    pub fn comment(&self, out: &mut dyn Write, more: &[(&str, String)]) -> io::Result<()> {
        let mut text = Vec::new();
        self.write(&mut text, more)?;
        let text = String::from_utf8_lossy(&text).into_owned();
        let mut lines = text.lines().filter(|line| !line.is_empty());
        lines.try_for_each(|line| writeln!(out, "# {line}"))
    }

    /// Writes the lines before a table, and then additional lines of the command.
    pub fn write(&self, out: &mut dyn Write, more: &[(&str, String)]) -> io::Result<()> {
        writeln!(out, "{}: {}", self.scene, self.description)?;
        writeln!(out)?;
        let frequencies = row(&self.natural_frequencies);
        let ratios = row(&self.resonances);
        writeln!(out, "natural frequencies (rad/s)  {frequencies}")?;
        if let Some(hertz) = &self.hertz {
            writeln!(out, "natural frequencies (Hz)     {}", row(hertz))?;
        }
        if !self.measure.is_free() {
            writeln!(out, "resonances r                 {ratios}")?;
            writeln!(
                out,
                "groups                       r = omega sqrt(m1/k1), beta = {}",
                self.friction_ratio()
            )?;
        }
        if let Some(load) = measure::description(&self.measure, computed) {
            writeln!(out, "load                         {load}")?;
        }
        for (title, text) in more {
            writeln!(out, "{title:<27}  {text}")?;
        }
        writeln!(out)
    }
}

/// Returns the first numbers of a list as text, each with a fixed width. The text ends with the number of omitted
/// numbers.
pub fn row(values: &[f64]) -> String {
    let mut cells: Vec<String> = values
        .iter()
        .take(MOST_SHOWN)
        .map(|value| format!("{:>12}", computed(*value)))
        .collect();
    if values.len() > MOST_SHOWN {
        cells.push(format!("... ({} in all)", values.len()));
    }
    cells.join("  ")
}

/// Describes the excitation of a scene in a few words. `load` has words for a load that is not the excitation.
fn excitation(scene: &Scene, load: Option<&str>) -> String {
    if let Some(load) = load {
        return load.to_owned();
    }
    match scene.excitation {
        Excitation::Base => "base motion".to_owned(),
        Excitation::Force(index) => {
            let mass = scene.masses.get(index).map_or("?", |mass| &mass.name);
            format!("force on {mass}")
        }
    }
}

/// Describes a scene with several contacts or dashpots in a few words.
fn joints(scene: &Scene, masses: &str, load: Option<&str>) -> String {
    let ends = |from, to| format!("{} - {}", scene.node_name(from), scene.node_name(to));
    let contacts = scene.named_contacts().into_iter().map(|contact| {
        let stiffness = contact.law.stiffness.map_or_else(String::new, |stiffness| {
            format!(", stiffness {stiffness:?}")
        });
        let speed = match contact.law.speed {
            0.0 => String::new(),
            speed => format!(", speed {speed:?}"),
        };
        format!(
            "{} ({}{stiffness}, stiction {:?}, share {:?}{speed})",
            contact.name,
            ends(contact.sides.from, contact.sides.to),
            contact.law.stiction,
            contact.law.share
        )
    });
    let dampers = scene.joints.dampers.iter();
    let dampers = dampers.map(|damper| {
        let ends = ends(damper.from, damper.to);
        format!("dashpot {ends} of {:?}", damper.coefficient)
    });
    let stops = scene.joints.stops.iter();
    let stops = stops.map(|stop| {
        let ends = ends(stop.sides.from, stop.sides.to);
        format!("{} (stop {ends}, gap {:?})", stop.name, stop.law.gap)
    });
    let constant = scene.joints.constant.iter();
    let constant = constant.map(|own| {
        let mass = scene.node_name(Node::Mass(own.mass));
        format!("constant force {:?} on {mass}", own.force)
    });
    let parts = contacts.chain(dampers).chain(stops).chain(constant);
    let parts = parts.chain([excitation(scene, load)]);
    format!("{masses}, {}", parts.collect::<Vec<_>>().join(", "))
}

/// Describes a scene in a few words.
fn description(scene: &Scene, load: Option<&str>) -> String {
    let masses = match scene.masses.len() {
        1 => "1 mass".to_owned(),
        count => format!("{count} masses"),
    };
    if scene.is_joined() {
        return joints(scene, &masses, load);
    }
    let name = match scene.contact_name.as_str() {
        CONTACT => String::new(),
        name => format!("{name}: "),
    };
    let from = scene.node_name(scene.contact.from);
    let to = scene.node_name(scene.contact.to);
    let excitation = excitation(scene, load);
    let damping = match &scene.damping {
        Damping::None => "undamped",
        Damping::Uniform(_) | Damping::Modal(_) => "modal damping",
        Damping::Rayleigh { .. } => "Rayleigh damping",
    };
    let acts_on = match (scene.damping_acts_on(), scene.damping_from) {
        (None, _) => "",
        (Some(_), DampingFrom::Rest) => " on absolute velocities",
        (Some(_), DampingFrom::Base) => " relative to the base",
    };
    let stiction = scene.stiction;
    let stiffness = scene.stiffness.map_or_else(String::new, |stiffness| {
        format!(" of stiffness {stiffness:?}")
    });
    format!(
        "{masses}, contact {name}{from} - {to}{stiffness}, {excitation}, {damping}{acts_on}, stiction {stiction:?}"
    )
}
