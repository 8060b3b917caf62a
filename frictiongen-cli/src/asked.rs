//! What is asked of commands that go over frequency and friction: points, masses, harmonics.

use crate::failure::Failure;
use frictiongen::study::UnknownMass;
use frictiongen::{Of, System};
use std::ops::RangeInclusive;

/// The highest harmonic there may be.
pub const MOST_HARMONICS: u32 = 9999;

/// What the contact is called; no mass can be.
pub const CONTACT: &str = "contact";

/// A mass asked for.
#[derive(Clone, Debug)]
pub struct Mass {
    /// Its place in the description.
    pub index: usize,
    /// Its name.
    pub name: String,
}

/// What moves: the contact or a mass.
#[derive(Clone, Debug)]
pub struct Part {
    /// Which.
    pub of: Of,
    /// Its name.
    pub name: String,
}

impl From<Mass> for Part {
    fn from(mass: Mass) -> Self {
        Self {
            of: Of::Mass(mass.index),
            name: mass.name,
        }
    }
}

/// The highest harmonic asked for, if any is.
pub fn harmonics(highest: Option<&str>) -> Result<Option<u32>, Failure> {
    let of = |text| whole("--harmonics", text, 1..=MOST_HARMONICS);
    highest.map(of).transpose()
}

/// The number of an option.
pub fn number(option: &str, text: &str) -> Result<f64, Failure> {
    text.trim()
        .parse()
        .map_err(|_| Failure::new(format_args!("{option} `{text}`: it is not a number")))
}

/// The finite number of an option that has to be such a one, as the words say.
pub fn number_that(
    option: &str,
    text: &str,
    sound: impl Fn(f64) -> bool,
    needed: &str,
) -> Result<f64, Failure> {
    let number: Option<f64> = text.trim().parse().ok();
    number
        .filter(|number| number.is_finite() && sound(*number))
        .ok_or_else(|| Failure::new(format_args!("{option} `{text}`: {needed} is needed")))
}

/// The whole number of an option.
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

/// The masses asked for, each once, or all.
pub fn masses(system: &System, names: &[String]) -> Result<Vec<Mass>, Failure> {
    if names.is_empty() {
        return Ok(known(system).collect());
    }
    let mut masses: Vec<Mass> = Vec::new();
    for name in names {
        let mass = mass(system, "--mass", name)?;
        if masses.iter().all(|known| known.index != mass.index) {
            masses.push(mass);
        }
    }
    Ok(masses)
}

/// What was asked for by name, nothing twice, or the contact and all masses.
pub fn parts(system: &System, names: &[String]) -> Result<Vec<Part>, Failure> {
    let contact = || Part {
        of: Of::Contact,
        name: CONTACT.to_owned(),
    };
    if names.is_empty() {
        let masses = known(system).map(Part::from);
        return Ok(std::iter::once(contact()).chain(masses).collect());
    }
    let mut parts: Vec<Part> = Vec::new();
    for name in names {
        if parts.iter().any(|part| part.name == *name) {
            return Err(Failure::new(format_args!(
                "--of `{name}`: it is given twice"
            )));
        }
        parts.push(match name.as_str() {
            CONTACT => contact(),
            name => mass(system, "--of", name)?.into(),
        });
    }
    Ok(parts)
}

/// All masses.
fn known(system: &System) -> impl Iterator<Item = Mass> + '_ {
    let masses = system.scene().masses.iter().enumerate();
    masses.map(|(index, mass)| Mass {
        index,
        name: mass.name.clone(),
    })
}

/// The mass of a name.
fn mass(system: &System, option: &str, name: &str) -> Result<Mass, Failure> {
    known(system).find(|mass| mass.name == name).ok_or_else(|| {
        let (name, known) = (name.to_owned(), known(system).map(|mass| mass.name));
        let known = known.collect();
        Failure::new(format_args!("{option}: {}", UnknownMass { name, known }))
    })
}

/// The one motion asked for.
pub fn part(system: &System, name: &str) -> Result<Part, Failure> {
    let mut parts = parts(system, &[name.to_owned()])?;
    parts
        .pop()
        .ok_or_else(|| Failure::new("--of: give the motion"))
}
