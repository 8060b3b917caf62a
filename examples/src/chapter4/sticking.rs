//! Draws figure 4.11: a plate that finally sticks while the friction grows.

use crate::{drawn, fixed};
use frictiongen::measure::{Channel, IdentifyRequest, Measured, Observation, Recording};
use frictiongen_examples::draw::part_colour;
use frictiongen_examples::rig::{LENGTH, NATURAL, Noise, Y, followed, noisy, one_storey, reach};
use frictiongen_plot::{Axis, Figure, Line, Panel, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

const R: f64 = 1.15;
const BETA: f64 = 0.7;
/// Time from which the friction ratio β grows, in s.
const GROWS: f64 = 50.0;
/// Growth of the friction ratio β in one second.
const GROWTH: f64 = 0.1;
/// Number of cycles of motion from rest that the recording leaves out.
const SKIPPED: f64 = 200.0;

/// Figure 4.11: displacements while the friction grows, until the plate sticks.
pub fn stuck_at_last() -> Result<Figure, Box<dyn Error>> {
    let rig = one_storey("wall", "")?;
    let (rate, seconds) = LENGTH;
    let hertz = R * NATURAL;
    let count = (rate * seconds) as u32;
    let friction = |time: f64| BETA + GROWTH * (time - GROWS).max(0.0);
    let (mut base, mut plate) = (Vec::new(), Vec::new());
    let mut run = rig.simulation(R, BETA)?;
    reach(&mut run, TAU * SKIPPED)?;
    // Within a cycle friction is constant. Each cycle starts from the state in which the cycle before it ended.
    let mut cycle = 0.0;
    let mut index = 0_u32;
    while index < count {
        let state = run.run().mass(0);
        let (x, v) = (state.displacement(), state.velocity());
        run = rig.simulation_from(R, friction(cycle / hertz), (&[x], &[v]))?;
        let last = (rate * (cycle + 1.0) / hertz).ceil() as u32;
        let samples = last.min(count) - index;
        let from = hertz * f64::from(index) / rate - cycle;
        let [y, x] = followed(&mut run, from, (hertz, rate), samples)?;
        base.extend(y);
        plate.extend(x);
        reach(&mut run, TAU)?;
        (index, cycle) = (last, cycle + 1.0);
    }
    let recording = noisy(&rig, &[base, plate], rate, &mut Noise::new(411))?;
    let refused = match Measured::of(&recording, rig.scene()) {
        Ok(_) => return Err("a motion that dies was taken for steady".into()),
        Err(error) => error,
    };
    let measured = Measured::of(&until(&recording, GROWS)?, rig.scene())?;
    let seen = Observation::of(&measured, &rig, 1);
    let found = rig.identify(&[seen], &IdentifyRequest::default())?.friction;
    let force = rig
        .scene()
        .springs
        .first()
        .map_or(1.0, |spring| spring.stiffness)
        * Y;
    let plate = recording.channels().last().ok_or("no channel")?;
    let whole = displacements(plate, rate, (0.0, seconds), 40);
    let late = displacements(plate, rate, (49.0, 58.0), 8);
    let panel = |title: &str, (from, to): (f64, f64), points| {
        let time = Axis::new("time (s)", from, to);
        let line = Line::unnamed(part_colour(0), Stroke::Solid, vec![points]);
        Panel::new(title, time, Axis::new("*x* (mm)", -2.5, 2.5)).with(line)
    };
    Ok(Figure::new(
        "4.11",
        "A plate that sticks at last",
        2,
        vec![panel("(a)", (0.0, seconds), whole), panel("(b) its end", (49.0, 58.0), late)],
    )
    .with_sketch(drawn(&fixed(1.0)))
    .with_caption(format!(
        "Synthetic, *r* = {R}, *β* = {BETA}, noise of 40 dB. The thesis's plate stuck for good after 54.8 s, for reasons not known; here \
         *β* grows by {GROWTH} a second from {GROWS} s on. Read whole, the recording is refused: {refused}. What lies before tells \
         *β* = {:.5}, 95 % from {:.5} to {:.5}.",
        found.value / force,
        found.from / force,
        found.to / force,
    )))
}

/// Returns the first part of a recording, up to the time `end` in s.
fn until(recording: &Recording, end: f64) -> Result<Recording, Box<dyn Error>> {
    let count = (recording.rate() * end) as usize;
    let cut = |channel: &Channel| Channel {
        samples: channel.samples.iter().copied().take(count).collect(),
        ..channel.clone()
    };
    let channels = recording.channels().iter().map(cut).collect();
    Ok(Recording::new(recording.rate(), channels)?)
}

/// Returns the displacements of a channel between two times in s. The result has every `every`-th sample, as a pair
/// of time and displacement.
fn displacements(
    channel: &Channel,
    rate: f64,
    (from, to): (f64, f64),
    every: usize,
) -> Vec<(f64, f64)> {
    let times = channel.samples.iter().enumerate().step_by(every);
    let times = times.map(|(i, x)| (i as f64 / rate, *x));
    times.filter(|(t, _)| from <= *t && *t <= to).collect()
}
