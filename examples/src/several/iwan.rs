//! A bolted joint as an Iwan element: four elastic contacts side by side. The force over the displacement is a Masing
//! loop, which has a closed form.

use frictiongen::System;
use frictiongen_plot::{Axis, Colour, Figure, Line, Panel, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

/// Frequency of the load, in Hz.
pub const HERTZ: f64 = 8.0;
/// Common friction force, in N.
pub const FRICTION: f64 = 40.0;
/// Amplitudes of the load, in N.
pub const LOADS: [f64; 3] = [8.0, 20.0, 40.0];
/// The contacts: stiffness in N/m, and share of the common friction force, as in the description.
pub const CONTACTS: [(f64, f64); 4] = [(4000.0, 0.1), (3000.0, 0.2), (2000.0, 0.3), (1000.0, 0.4)];

/// The loop of a steady state.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Amplitude of the load, in N.
    pub load: f64,
    /// Amplitude of the displacement, in m.
    pub amplitude: f64,
    /// Energy that the contacts dissipate in a cycle, in J.
    pub energy: f64,
    /// Displacement in m, velocity in m/s and force of all contacts in N, over one cycle.
    pub samples: Vec<(f64, f64, f64)>,
}

/// Computes the steady state under a load with an amplitude in N, and samples its loop.
///
/// # Errors
/// Errors of the description and of the solver.
pub fn joint(load: f64) -> Result<Loop, Box<dyn Error>> {
    let system: System = include_str!("../../scenes/iwan.friction").parse()?;
    let orbit = system.joined()?.under(TAU * HERTZ, load)?.orbit(FRICTION)?;
    let history = orbit.simulation()?.history(0, 1, 720)?;
    let samples = history.contacts.iter().map(|contacts| {
        let force = contacts.iter().map(|contact| contact.force).sum();
        let first = contacts.first();
        let (z, v) = first.map_or((0.0, 0.0), |now| (now.displacement, now.velocity));
        (z, v, force)
    });
    Ok(Loop {
        load,
        amplitude: orbit.amplitude("part")?,
        energy: orbit.contacts().map(|contact| contact.energy()).sum(),
        samples: samples.collect(),
    })
}

/// Returns the force at a displacement z ≥ 0 when the element is loaded for the first time.
#[must_use]
pub fn backbone(z: f64) -> f64 {
    let contacts = CONTACTS.iter();
    contacts
        .map(|(stiffness, share)| (stiffness * z).min(share * FRICTION))
        .sum()
}

/// Returns the force on the closed loop of a displacement amplitude. Masing's rule: each branch is the first loading,
/// twice as large in both directions.
#[must_use]
pub fn masing(amplitude: f64, z: f64, rises: bool) -> f64 {
    let top = backbone(amplitude);
    match rises {
        true => 2.0 * backbone(0.5 * (amplitude + z)) - top,
        false => top - 2.0 * backbone(0.5 * (amplitude - z)),
    }
}

/// Returns the area of the closed loop: 4F(X − F/k) for each contact that slides.
#[must_use]
pub fn area(amplitude: f64) -> f64 {
    let contacts = CONTACTS.iter();
    contacts
        .map(|(stiffness, share)| {
            let level = share * FRICTION;
            4.0 * level * (amplitude - level / stiffness).max(0.0)
        })
        .sum()
}

/// Returns the largest difference between a computed loop and Masing's, divided by the largest force.
#[must_use]
pub fn difference(found: &Loop) -> f64 {
    let apart = found.samples.iter().map(|(z, v, force)| {
        // At the two ends of the loop both branches have the same force.
        (force - masing(found.amplitude, *z, 0.0 < *v)).abs()
    });
    apart.fold(0.0, f64::max) / backbone(found.amplitude)
}

/// Returns the loops as text.
///
/// # Errors
/// Same errors as [`joint`].
pub fn report() -> Result<String, Box<dyn Error>> {
    let mut lines = vec!["Iwan element".to_owned()];
    for load in LOADS {
        let found = joint(load)?;
        lines.push(format!(
            "  load {load} N: amplitude {:.4} mm, {:.4} mJ in a cycle; the loop differs from Masing's by {:.0e}, its area by {:.0e}",
            1e3 * found.amplitude,
            1e3 * found.energy,
            difference(&found),
            (found.energy / area(found.amplitude) - 1.0).abs()
        ));
    }
    Ok(lines.join("\n"))
}

/// Draws the loops.
///
/// # Errors
/// Same errors as [`joint`].
pub fn picture() -> Result<Figure, Box<dyn Error>> {
    let loops = LOADS.iter().map(|load| joint(*load));
    let loops: Vec<Loop> = loops.collect::<Result<_, _>>()?;
    let points = |found: &Loop| -> Vec<(f64, f64)> {
        let samples = found.samples.iter();
        samples.map(|(z, _, force)| (1e3 * z, *force)).collect()
    };
    let all: Vec<(f64, f64)> = loops.iter().flat_map(points).collect();
    let across = Axis::fitted("displacement, mm", all.iter().map(|point| point.0));
    let up = Axis::fitted(
        "force of the four contacts, N",
        all.iter().map(|point| point.1),
    );
    let mut panel = Panel::new("", across, up);
    for (index, found) in loops.iter().enumerate() {
        let name = format!("load {} N", found.load);
        let line = Line::new(
            name,
            Colour::Series(index),
            Stroke::Solid,
            vec![points(found)],
        );
        panel = panel.with(line);
    }
    Ok(Figure::new(
        "",
        "bolted joint with four elastic contacts",
        1,
        vec![panel],
    ))
}
