//! Computes the motion of four inertias with clutches between them, the example `CoupledClutches` of the Modelica
//! Standard Library.
//!
//! Four inertias of 1 kg·m² are in a row, and nothing holds them. The first one rotates at 10 rad/s, and a torque of
//! 10 sin 10πt N·m acts on it. The first clutch has the kinetic friction torque 10 cos 0.4πt N·m while this is positive,
//! and then none. The second clutch engages at 0.4 s with 10 N·m, and the third clutch at 0.9 s.

use frictiongen::System;
use frictiongen::study::joints::{Motion, Wave};
use std::error::Error;
use std::f64::consts::PI;

/// Time at which the motion ends, in s.
pub const END: f64 = 1.5;

/// Two rows of the published reference results of the Modelica Standard Library (`CoupledClutches.csv`). Each has the
/// time in s, the speed of the first inertia in rad/s, and the relative speed of the first clutch in rad/s.
pub const PUBLISHED: [(f64, f64, f64); 2] = [
    (1.05, 3.178_768_760_519_36, -0.358_960_991_320_035),
    (END, 3.247_034_565_240_66, -0.783_826_964_342_972),
];

/// An event of a clutch: it begins to stick or to slide.
#[derive(Clone, Copy, Debug)]
pub struct ClutchEvent {
    /// Number of the clutch, from 1.
    pub clutch: usize,
    /// True if the clutch begins to stick, false if it begins to slide.
    pub sticks: bool,
    /// Time of the event, in s.
    pub time: f64,
}

/// The computed motion of the four inertias and three clutches.
#[derive(Clone, Debug, Default)]
pub struct Clutches {
    /// All events of the clutches, in the order of time.
    pub events: Vec<ClutchEvent>,
    /// For each time of [`PUBLISHED`]: the time in s, and the speeds of the four inertias in rad/s.
    pub speeds: Vec<(f64, Vec<f64>)>,
}

/// Computes the motion of the inertias and clutches from the start to [`END`].
///
/// # Errors
/// Errors of the description and of the solver.
pub fn clutches() -> Result<Clutches, Box<dyn Error>> {
    let system: System = include_str!("../../scenes/clutches.friction").parse()?;
    let joined = system.joined()?;
    // The load in a description is a cosine, and its friction forces are constant. A chain from `joined.under` also
    // takes loads with other phases, and friction forces that change with time.
    let mut chain = joined.under(10.0 * PI, 10.0)?.chain(0.0)?;
    for (_, torque) in &mut chain.loads {
        torque.phase = -PI / 2.0;
    }
    if let Some(first) = chain.contacts.first_mut() {
        first.level = Wave::harmonic(10.0, 0.4 * PI);
    }
    let mut motion = Motion::from(&chain, &[0.0; 4], &[10.0, 0.0, 0.0, 0.0])?;
    let mut found = Clutches::default();
    // At some of these times the friction torque of a clutch changes. The clutches have the indices 0 to 2.
    let stops = [
        (0.4, Some((1, 10.0))),
        (0.9, Some((2, 10.0))),
        (1.05, None),
        (1.25, Some((0, 0.0))),
        (END, None),
    ];
    for (time, change) in stops {
        for event in motion.run(time, &mut |_, _, _| {})? {
            let phases = event.before.iter().zip(&event.after).enumerate();
            for (index, (_, after)) in phases.filter(|(_, (before, after))| before != after) {
                found.events.push(ClutchEvent {
                    clutch: index + 1,
                    sticks: *after == 0,
                    time: event.time,
                });
            }
        }
        match change {
            Some((clutch, torque)) => motion.set_level(clutch, Wave::constant(torque))?,
            None => found.speeds.push((time, motion.state().v.to_vec())),
        }
    }
    Ok(found)
}

/// Returns a text about the motion of the clutches, with the published speeds beside the computed ones.
///
/// # Errors
/// Same errors as [`clutches`].
pub fn report() -> Result<String, Box<dyn Error>> {
    let found = clutches()?;
    let mut lines = vec!["Coupled clutches".to_owned()];
    for event in &found.events {
        let does = if event.sticks { "sticks" } else { "slides" };
        lines.push(format!(
            "  {:.13} s: clutch {} {does}",
            event.time, event.clutch
        ));
    }
    lines.push(
        "  speed of the first inertia and relative speed of the first clutch, rad/s:".to_owned(),
    );
    for ((_, published, relative), (time, speeds)) in PUBLISHED.iter().zip(&found.speeds) {
        let (first, second) = (
            speeds.first().copied().unwrap_or_default(),
            speeds.get(1).copied().unwrap_or_default(),
        );
        lines.push(format!(
            "  {time:.4} s: {first:.12} and {:.12}; the published ones differ by {:.1e} and {:.1e}",
            second - first,
            (published - first).abs(),
            (relative - (second - first)).abs()
        ));
    }
    Ok(lines.join("\n"))
}
