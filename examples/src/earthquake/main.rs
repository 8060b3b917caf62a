//! Computes the two-storey frame of the tour under a synthetic earthquake, with and without a friction damper.
//!
//! `cargo run --release --example earthquake [FOLDER]` writes the picture and the data.

mod ground;

use frictiongen::friction_system;
use frictiongen_plot::{Axis, Colour, Figure, Line, Panel, Stroke};
use ground::{Ground, LENGTH, RATE, ground};
use std::error::Error;
use std::fmt::Write;
use std::path::PathBuf;

friction_system! {
    /// Two-storey shear frame; a friction damper holds the upper floor to the ground.
    struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - base,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [stepper],
        step: 1.0 / 200.0,
    }
}

/// Peak acceleration of the ground, in m/s².
const PEAK: f64 = 3.0;
/// Friction force of the damper, in N.
const FRICTION: f64 = 4.0;

/// Result of a simulation. For each step it has the displacement of the upper floor relative to the ground in mm, and
/// the force of the damper in N.
struct Run {
    drift: Vec<(f64, f64)>,
    force: Vec<(f64, f64)>,
    stuck: usize,
    work: frictiongen::answer::Work<f64>,
}

fn run(motion: &[Ground], friction: f64) -> Result<Run, frictiongen::Error> {
    let mut step = Frame::stepper(Frame::STEP)?;
    let (mut drift, mut force, mut stuck) = (Vec::new(), Vec::new(), 0);
    for ground in motion.iter().skip(1) {
        let state = step.advance(FrameInput {
            displacement: ground.displacement,
            velocity: ground.velocity,
            friction,
        })?;
        let moved = step.upper().displacement() - ground.displacement;
        drift.push((ground.time, moved * 1e3));
        force.push((ground.time, state.force));
        stuck += usize::from(step.contact().is_sticking());
    }
    Ok(Run {
        drift,
        force,
        stuck,
        work: step.work(),
    })
}

fn largest(values: &[(f64, f64)]) -> f64 {
    values
        .iter()
        .fold(0.0, |most, (_, value)| most.max(value.abs()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let motion = ground(PEAK);
    let free = run(&motion, 0.0)?;
    let damped = run(&motion, FRICTION)?;
    println!("ground: {PEAK} m/s² at most, {LENGTH} s at {RATE} steps a second");
    println!(
        "largest drift of the upper floor: {:.2} mm without the damper, {:.2} mm with {FRICTION} N",
        largest(&free.drift),
        largest(&damped.drift)
    );
    let work = damped.work;
    println!(
        "with it: {:.3} J from the ground, {:.3} J in the damper, {:.3} J in the frame's own damping, {:.1e} J still stored",
        work.load, work.friction, work.damping, work.stored
    );
    println!(
        "it sticks at the end of {} of {} steps",
        damped.stuck,
        damped.drift.len()
    );
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        return Ok(());
    };
    std::fs::write(
        folder.join("earthquake.svg"),
        picture(&motion, &free, &damped).svg(),
    )?;
    std::fs::write(
        folder.join("earthquake.csv"),
        data(&motion, &free, &damped)?,
    )?;
    Ok(())
}

fn picture(motion: &[Ground], free: &Run, damped: &Run) -> Figure {
    let shaken = motion
        .iter()
        .map(|ground| (ground.time, ground.acceleration));
    let time = || Axis::new("time, s", 0.0, LENGTH);
    let line = |name: &str, colour, data: Vec<(f64, f64)>| {
        Line::new(name, colour, Stroke::Solid, vec![data])
    };
    let most = (largest(&free.drift) / 5.0).ceil() * 5.0;
    let ground = Panel::new("", time(), Axis::new("ground, m/s²", -PEAK, PEAK)).with(line(
        "acceleration of the ground",
        Colour::Series(7),
        shaken.collect(),
    ));
    let drift = Panel::new("", time(), Axis::new("drift, mm", -most, most))
        .with(line(
            "without the damper",
            Colour::Series(1),
            free.drift.clone(),
        ))
        .with(line(
            "with the damper",
            Colour::Series(0),
            damped.drift.clone(),
        ));
    let edge = FRICTION * 1.5;
    let force = Panel::new("", time(), Axis::new("force, N", -edge, edge)).with(line(
        "force in the damper",
        Colour::Series(2),
        damped.force.clone(),
    ));
    Figure::new(
        "",
        "frame under a synthetic earthquake",
        1,
        vec![ground, drift, force],
    )
}

fn data(motion: &[Ground], free: &Run, damped: &Run) -> Result<String, std::fmt::Error> {
    let mut text = String::from("time_s,ground_m_per_s2,drift_free_mm,drift_mm,force_N\n");
    let runs = free.drift.iter().zip(&damped.drift).zip(&damped.force);
    for (ground, (((_, free), (_, drift)), (_, force))) in motion.iter().skip(1).zip(runs) {
        let Ground {
            time, acceleration, ..
        } = ground;
        writeln!(
            text,
            "{time:.3},{acceleration:.6},{free:.6},{drift:.6},{force:.6}"
        )?;
    }
    Ok(text)
}
