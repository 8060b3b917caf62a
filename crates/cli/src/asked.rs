//! Parses the options that several commands share: masses, motions, harmonics and numbers.

use crate::failure::Failure;
use crate::hint;
use frictiongen::study::UnknownMass;
pub use frictiongen::study::columns::MovingPart;
use frictiongen::study::response::MotionQuantity;
use frictiongen::{Of, System};
use std::ops::RangeInclusive;

/// Largest order of a harmonic that the user may request.
pub const MOST_HARMONICS: u32 = 9999;

/// A mass whose motion the user has requested.
#[derive(Clone, Debug)]
pub struct RequestedMass {
    /// Index of the mass in the scene description.
    pub index: usize,
    /// Name of the requested mass.
    pub name: String,
}

impl From<RequestedMass> for MovingPart {
    fn from(mass: RequestedMass) -> Self {
        Self {
            of: Of::Mass(mass.index),
            size: MotionQuantity::Displacement,
            name: mass.name,
        }
    }
}

/// Parses the highest order of a harmonic, if the user has given an order.
pub fn harmonics(highest: Option<&str>) -> Result<Option<u32>, Failure> {
    let of = |text| whole("--harmonics", text, 1..=MOST_HARMONICS);
    highest.map(of).transpose()
}

/// Parses a number that is the value of an option.
pub fn number(option: &str, text: &str) -> Result<f64, Failure> {
    text.trim().parse().map_err(|_| {
        let hint = hint::of(text);
        Failure::new(format_args!("{option} `{text}`: it is not a number{hint}"))
    })
}

/// Parses the value of an option as a finite number that satisfies the condition `sound`. If the number does not, the
/// error message states the condition in the words of `needed`.
pub fn number_that(
    option: &str,
    text: &str,
    sound: impl Fn(f64) -> bool,
    needed: &str,
) -> Result<f64, Failure> {
    let number: Option<f64> = text.trim().parse().ok();
    number
        .filter(|number| number.is_finite() && sound(*number))
        .ok_or_else(|| {
            let hint = hint::of(text);
            Failure::new(format_args!("{option} `{text}`: {needed} is needed{hint}"))
        })
}

/// Parses a whole number that is the value of an option.
pub fn whole(option: &str, text: &str, range: RangeInclusive<u32>) -> Result<u32, Failure> {
    let number = text.trim().parse().ok();
    number
        .filter(|number| range.contains(number))
        .ok_or_else(|| {
            let (least, most) = range.into_inner();
            Failure::new(format_args!(
                "{option} `{text}`: a whole number from {least} to {most} is needed"
            ))
        })
}

/// Returns the masses with the given names, each once. Without names, returns all masses. Error messages contain the
/// name of the option.
pub fn masses(
    system: &System,
    option: &str,
    names: &[String],
) -> Result<Vec<RequestedMass>, Failure> {
    if names.is_empty() {
        return Ok(known(system).collect());
    }
    let mut masses: Vec<RequestedMass> = Vec::new();
    for name in names {
        let mass = mass(system, option, name)?;
        if masses.iter().all(|known| known.index != mass.index) {
            masses.push(mass);
        }
    }
    Ok(masses)
}

/// Returns the contact and the motions with the given names, each once. Without names, returns the contact and all
/// masses.
pub fn contact_and(system: &System, names: &[String]) -> Result<Vec<MovingPart>, Failure> {
    let mut once: Vec<String> = Vec::new();
    for name in names {
        if !once.contains(name) {
            once.push(name.clone());
        }
    }
    let mut parts = parts(system, &once)?;
    let contact = MovingPart::contact(system);
    parts.retain(|part| part.name != contact.name);
    parts.insert(0, contact);
    Ok(parts)
}

/// Returns the motions with the given names, each once. Without names, returns the contact and all masses.
pub fn parts(system: &System, names: &[String]) -> Result<Vec<MovingPart>, Failure> {
    if names.is_empty() {
        let masses = known(system).map(MovingPart::from);
        return Ok(std::iter::once(MovingPart::contact(system))
            .chain(masses)
            .collect());
    }
    let mut parts: Vec<MovingPart> = Vec::new();
    for name in names {
        if parts.iter().any(|part| part.name == *name) {
            return Err(Failure::new(format_args!(
                "--of `{name}`: it is given twice"
            )));
        }
        let part = MovingPart::named(system, name);
        parts.push(part.map_err(|error| Failure::new(format_args!("--of: {error}")))?);
    }
    Ok(parts)
}

/// Returns the motions with the given names for a scene with several contacts. Without names, returns all masses.
pub fn motions(system: &System, names: &[String]) -> Result<Vec<MovingPart>, Failure> {
    MovingPart::of_joined(system, "--of", names).map_err(Failure::new)
}

/// Returns all masses of the system.
fn known(system: &System) -> impl Iterator<Item = RequestedMass> + '_ {
    let masses = system.scene().masses.iter().enumerate();
    masses.map(|(index, mass)| RequestedMass {
        index,
        name: mass.name.clone(),
    })
}

/// Returns the mass called `name`, which the option `option` gives.
fn mass(system: &System, option: &str, name: &str) -> Result<RequestedMass, Failure> {
    known(system).find(|mass| mass.name == name).ok_or_else(|| {
        match MovingPart::named(system, name) {
            Ok(_) => {
                return Failure::new(format_args!(
                    "{option}: `{name}` is no mass, and this answer has masses only; write the name of a mass"
                ));
            }
            Err(error) if name.contains('-') => return Failure::new(format_args!("{option}: {error}")),
            Err(_) => {}
        }
        let (name, known) = (name.to_owned(), known(system).map(|mass| mass.name));
        let known = known.collect();
        Failure::new(format_args!("{option}: {}", UnknownMass { name, known }))
    })
}

/// Fails if the user has requested a velocity or an acceleration. Commands that print only displacements and forces
/// call this check.
pub fn without_rates(parts: &[MovingPart]) -> Result<(), Failure> {
    match parts.iter().find(|part| part.has_rate()) {
        Some(part) => Err(Failure::new(format_args!(
            "--of `{}`: this command has displacements and forces of springs only; `curve`, `response`, `orbit` and `optimum` have velocities, accelerations, and force, energy and equivalent damping of the contact",
            part.name
        ))),
        None => Ok(()),
    }
}

/// Returns the contact, the mass or the combination of masses with this name.
pub fn part(system: &System, name: &str) -> Result<MovingPart, Failure> {
    let mut parts = parts(system, &[name.to_owned()])?;
    parts
        .pop()
        .ok_or_else(|| Failure::new("--of: give the name of a mass or of the contact"))
}
