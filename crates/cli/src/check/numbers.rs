//! Prints numbers that reveal a wrong unit: natural frequencies, damping, mass and static displacement.

use crate::modes;
use crate::number::computed;
use crate::summary::row;
use frictiongen::System;
use frictiongen::study::scene::{Excitation, Scene};
use frictiongen::study::units::{Load, hertz};
use serde_json::{Map, Value as Json, json};
use std::io::{self, Write};

/// Amplitude of the base motion under which the command prints the static displacement, in m.
const BASE: f64 = 1e-3;
/// Force under which the command prints the static displacement, in N.
const FORCE: f64 = 1.0;

/// Writes natural frequencies in Hz, modal damping ratios, the total mass, and the static displacement under a load.
pub fn write(scene: &Scene, out: &mut dyn Write) -> io::Result<()> {
    let Ok(system) = System::try_from(scene.clone()) else {
        return Ok(());
    };
    match modes::of(&system) {
        Some(sets) => modes::write(&sets, out)?,
        None => {
            let frequencies = system.natural_frequencies().into_iter().map(hertz);
            let frequencies: Vec<f64> = frequencies.collect();
            writeln!(out, "natural frequencies (Hz)   {}", row(&frequencies))?;
            let ratios = system.modal().damping_ratios.iter().map(|zeta| zeta.hi);
            let ratios: Vec<f64> = ratios.collect();
            writeln!(out, "modal damping ratios       {}", row(&ratios))?;
        }
    }
    let mass: f64 = scene.masses.iter().map(|mass| mass.value).sum();
    writeln!(out, "total mass (kg)            {}", row(&[mass]))?;
    let (load, words) = match scene.excitation {
        Excitation::Base => (Load::Base(BASE), "1 mm of the base".to_owned()),
        Excitation::Force(index) => {
            let name = scene.masses.get(index).map_or("?", |mass| &mass.name);
            (Load::Force(FORCE), format!("1 N on {name}"))
        }
    };
    // A mass without a path of springs to a support has no static displacement, because nothing holds it.
    let held = system.resonances().iter().all(|root| *root > 0.0);
    if let Ok(scale) = system.load_scale(load)
        && held
    {
        let placed = statics(&system)
            .into_iter()
            .map(|x| 1e3 * scale.displacement(x));
        let named = scene.masses.iter().zip(placed);
        let named: Vec<String> = named
            .map(|(mass, x)| format!("{} {}", mass.name, computed(x).trim()))
            .collect();
        let shown = match named.as_slice() {
            [first, .., last] if MOST < named.len() => format!("{first}, ..., {last}"),
            _ => named.join(", "),
        };
        writeln!(
            out,
            "static displacement (mm)   {shown}; under {words}, without friction"
        )?;
    }
    Ok(())
}

/// Returns the numbers of the scene as JSON, including the mass and the static displacement of every mass. Returns
/// `None` if the scene is not valid.
pub fn json(scene: &Scene) -> Option<Map<String, Json>> {
    let system = System::try_from(scene.clone()).ok()?;
    let frequencies: Vec<f64> = system
        .natural_frequencies()
        .into_iter()
        .map(hertz)
        .collect();
    let ratios: Vec<f64> = system
        .modal()
        .damping_ratios
        .iter()
        .map(|zeta| zeta.hi)
        .collect();
    let mass: f64 = scene.masses.iter().map(|mass| mass.value).sum();
    let load = match scene.excitation {
        Excitation::Base => Load::Base(BASE),
        Excitation::Force(_) => Load::Force(FORCE),
    };
    let scale = system.load_scale(load).ok()?;
    let placed = statics(&system).into_iter().map(|x| scale.displacement(x));
    let placed: Map<String, Json> = scene
        .masses
        .iter()
        .zip(placed)
        .map(|(mass, x)| (mass.name.clone(), x.into()))
        .collect();
    let under = match scene.excitation {
        Excitation::Base => "a base motion of 1 mm",
        Excitation::Force(_) => "a force of 1 N",
    };
    let mut fields = json!({
        "natural_frequencies_Hz": frequencies,
        "damping_ratios": ratios,
        "damping": scene.damping_acts_on(),
        "total_mass_kg": mass,
        "static_displacements_m": placed,
        "static_displacements_under": under,
    });
    if let (Some(sets), Some(fields)) = (modes::of(&system), fields.as_object_mut()) {
        fields.insert("damped_modes".to_owned(), modes::json(&sets));
    }
    match fields {
        Json::Object(fields) => Some(fields),
        _ => None,
    }
}

/// Largest number of masses for which the command prints every static displacement.
const MOST: usize = 4;

/// Returns the non-dimensional static displacement x̄ of each mass under a unit load, while the contact carries no
/// force.
fn statics(system: &System) -> Vec<f64> {
    let modal = system.modal();
    let masses = system.scene().masses.len();
    let modes = || modal.shapes.iter().zip(&modal.loads).zip(&modal.resonances);
    let displacement = |mass: usize| {
        let terms = modes().filter_map(|((shape, load), root)| {
            Some(shape.get(mass)?.hi * load.hi / (root.hi * root.hi))
        });
        terms.sum()
    };
    (0..masses).map(displacement).collect()
}
