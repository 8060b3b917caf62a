//! What is asked of commands that go over frequency and friction: points, masses, harmonics.

use crate::failure::Failure;
use frictiongen::study::{SystemAt, SystemMotion, UnknownMass};
use frictiongen::{Complex, Error, NoOrbit, NotContinuous, Of, OutOfDomain, Regime, System};
use std::f64::consts::PI;

/// The highest harmonic there may be.
const MOST_HARMONICS: u32 = 9999;

/// A mass asked for.
#[derive(Clone, Debug)]
pub struct Mass {
    /// Its place in the description.
    pub index: usize,
    /// Its name.
    pub name: String,
}

/// The highest harmonic asked for, if any is.
pub fn harmonics(highest: Option<&str>) -> Result<Option<u32>, Failure> {
    let Some(text) = highest else {
        return Ok(None);
    };
    match text.trim().parse() {
        Ok(highest @ 1..=MOST_HARMONICS) => Ok(Some(highest)),
        _ => Err(Failure::new(format_args!(
            "--harmonics `{text}`: a whole number from 1 to {MOST_HARMONICS} is needed"
        ))),
    }
}

/// The masses asked for, each once, or all.
pub fn masses(system: &System, names: &[String]) -> Result<Vec<Mass>, Failure> {
    let known = || system.scene().masses.iter().enumerate();
    let all = known().map(|(index, mass)| Mass {
        index,
        name: mass.name.clone(),
    });
    if names.is_empty() {
        return Ok(all.collect());
    }
    let mut masses: Vec<Mass> = Vec::new();
    for name in names {
        let Some(mass) = all.clone().find(|mass| mass.name == *name) else {
            let name = name.clone();
            let known = known().map(|(_, mass)| mass.name.clone()).collect();
            return Err(Failure::new(format_args!(
                "--mass: {}",
                UnknownMass { name, known }
            )));
        };
        if masses.iter().all(|known| known.index != mass.index) {
            masses.push(mass);
        }
    }
    Ok(masses)
}

/// What the contact is called; no mass can be.
pub const CONTACT: &str = "contact";

/// A motion asked for.
#[derive(Clone, Debug)]
pub struct Part {
    /// Whose.
    pub of: Of,
    /// Its name.
    pub name: String,
}

/// The motions asked for, each once, or all: the contact's, then the masses'.
pub fn parts(system: &System, names: &[String]) -> Result<Vec<Part>, Failure> {
    let contact = Part {
        of: Of::Contact,
        name: CONTACT.to_owned(),
    };
    let masses = system.scene().masses.iter().enumerate();
    let masses = masses.map(|(index, mass)| Part {
        of: Of::Mass(index),
        name: mass.name.clone(),
    });
    let all: Vec<Part> = std::iter::once(contact).chain(masses).collect();
    if names.is_empty() {
        return Ok(all);
    }
    let mut parts: Vec<Part> = Vec::new();
    for name in names {
        let Some(part) = all.iter().find(|part| part.name == *name) else {
            let known = all.iter().map(|part| part.name.clone()).collect();
            let name = name.clone();
            return Err(Failure::new(format_args!(
                "--of: {}",
                UnknownMass { name, known }
            )));
        };
        if parts.iter().all(|known| known.of != part.of) {
            parts.push(part.clone());
        }
    }
    Ok(parts)
}

/// The one motion asked for.
pub fn part(system: &System, name: &str) -> Result<Part, Failure> {
    let mut parts = parts(system, &[name.to_owned()])?;
    parts
        .pop()
        .ok_or_else(|| Failure::new("--of: give the motion"))
}

/// The regime in a word.
pub fn regime_name(regime: Regime) -> &'static str {
    match regime {
        Regime::Continuous => "continuous",
        Regime::StickSlip => "stick-slip",
        Regime::Stuck => "stuck",
        _ => "",
    }
}

/// Why there is no response, in a word.
pub fn no_answer(error: Error) -> &'static str {
    match error {
        Error::NoOrbit(error) => reason(error),
        Error::NotContinuous(_) | Error::StuckResonance(_) => "unbounded",
        _ => "no cycle",
    }
}

/// The regime in a word, the same in every command.
pub fn regime(
    at: &SystemAt<'_>,
    motion: &Result<SystemMotion<'_>, NotContinuous>,
) -> Result<&'static str, OutOfDomain> {
    Ok(match motion {
        Ok(_) => regime_name(Regime::Continuous),
        Err(NotContinuous::StickSlip) => regime_name(Regime::StickSlip),
        Err(NotContinuous::Stuck) if at.stuck().is_ok() => regime_name(Regime::Stuck),
        // On an undamped resonance, of the chain or of the chain with its contact stuck.
        Err(NotContinuous::Stuck | NotContinuous::Unbounded) => "unbounded",
        Err(_) => return Err(OutOfDomain { argument: "beta" }),
    })
}

/// Why there is no steady state, in a word.
pub fn reason(error: NoOrbit) -> &'static str {
    match error {
        NoOrbit::OutOfDomain(_) => "no cycle",
        NoOrbit::TooManyEvents => "crowded",
        NoOrbit::Unbounded => "unbounded",
        NoOrbit::Undamped(_) => "undamped",
        NoOrbit::Unstable => "unstable",
        NoOrbit::Unsettled => "unsettled",
        _ => "none",
    }
}

/// |z|, and −arg z in (−π, π].
pub fn polar(z: Complex<f64>) -> (f64, f64) {
    let lag = -z.im.atan2(z.re);
    (z.re.hypot(z.im), if lag == -PI { PI } else { lag })
}
