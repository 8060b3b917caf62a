//! Computes a bolted joint as an Iwan element, which consists of four elastic contacts side by side. Its force over
//! its displacement is a Masing loop, which has a closed form.

use frictiongen::System;
use frictiongen_plot::{Axis, Colour, Figure, Line, Panel, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

/// Frequency of the load on the joint, in Hz.
pub const HERTZ: f64 = 8.0;
/// Common friction force of the contacts, in N. Each contact has a share of it.
pub const FRICTION: f64 = 40.0;
/// Amplitudes of the load for which the joint is computed, in N.
pub const LOADS: [f64; 3] = [8.0, 20.0, 40.0];
/// Stiffness in N/m and share of the common friction force of each contact, as in the description.
pub const CONTACTS: [(f64, f64); 4] = [(4000.0, 0.1), (3000.0, 0.2), (2000.0, 0.3), (1000.0, 0.4)];

/// The hysteresis loop of the joint in a steady state.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Amplitude of the load, in N.
    pub load: f64,
    /// Amplitude of the displacement, in m.
    pub amplitude: f64,
    /// Energy that the contacts dissipate in a cycle, in J.
    pub energy: f64,
    /// Samples over one cycle: displacement of the joint in m, its velocity in m/s, and the force of all contacts in
    /// N.
    pub samples: Vec<(f64, f64, f64)>,
}

/// Computes the steady state of the joint under a load, and samples its hysteresis loop. `load` is the amplitude in
/// N.
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

/// Returns the force of the joint at a displacement z ≥ 0 in m when it is loaded for the first time. Its curve is the
/// backbone.
#[must_use]
pub fn backbone(z: f64) -> f64 {
    let contacts = CONTACTS.iter();
    contacts
        .map(|(stiffness, share)| (stiffness * z).min(share * FRICTION))
        .sum()
}

/// Returns the force at the displacement z on the closed hysteresis loop with the given displacement amplitude. By
/// Masing's rule, each branch of the loop is the curve of first loading, twice as large in both directions.
#[must_use]
pub fn masing(amplitude: f64, z: f64, rises: bool) -> f64 {
    let top = backbone(amplitude);
    match rises {
        true => 2.0 * backbone(0.5 * (amplitude + z)) - top,
        false => top - 2.0 * backbone(0.5 * (amplitude - z)),
    }
}

/// Returns the area of the closed loop: the sum of 4F(X − F/k) over the contacts that slide. X is the displacement
/// amplitude, and F and k are friction force and stiffness of a contact.
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

/// Returns the largest difference of the forces of a computed loop and Masing's loop, divided by the largest force.
#[must_use]
pub fn difference(found: &Loop) -> f64 {
    let apart = found.samples.iter().map(|(z, v, force)| {
        // At the two ends of the loop both branches have the same force.
        (force - masing(found.amplitude, *z, 0.0 < *v)).abs()
    });
    apart.fold(0.0, f64::max) / backbone(found.amplitude)
}

/// Returns a text about the hysteresis loops for all amplitudes of the load.
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

/// Returns a figure of the hysteresis loops for all amplitudes of the load.
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
