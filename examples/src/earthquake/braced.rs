//! Computes the two-storey frame of the tour under a synthetic earthquake, with its friction damper on a brace, and with
//! the same damper on a rigid support.
//!
//! `cargo run --release --example braced [FOLDER]` writes the picture of both hysteresis loops.

mod ground;

use braced::FrameInput as BracedInput;
use frictiongen::answer::Work;
use frictiongen::friction_system;
use frictiongen_plot::{Axis, Colour, Figure, Line, Panel, Stroke};
use ground::{LENGTH, RATE, ground};
use std::error::Error;
use std::path::PathBuf;

/// Stiffness of the brace, in N/m. The macro needs a literal number, so the description repeats it.
const BRACE: f64 = 1.0e3;
/// Duration of the strong motion that the picture shows, in s.
const SHOWN: f64 = 12.0;
/// Peak acceleration of the ground, in m/s².
const PEAK: f64 = 3.0;
/// Friction force of the damper, in N.
const FRICTION: f64 = 4.0;

/// A frame whose upper floor has a friction damper to the ground. The brace is a spring in series with the damper.
mod braced {
    frictiongen::friction_system! {
        /// Two-storey shear frame with a damper on a brace.
        pub struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: upper - base,
            stiffness: 1.0e3,
            excitation: base,
            damping: modal[0.010, 0.012],
            provide: [stepper],
            step: 1.0 / 200.0,
        }
    }
}

friction_system! {
    /// Two-storey shear frame with a damper on a rigid support.
    struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - base,
        excitation: base,
        damping: modal[0.010, 0.012],
        provide: [stepper],
        step: 1.0 / 200.0,
    }
}

/// Result of a simulation of one frame.
struct Run {
    /// Each pair has the displacement of the upper floor relative to the ground in mm, and the force of the damper in
    /// N. The list covers the strong motion of the ground.
    loop_of_damper: Vec<(f64, f64)>,
    /// Largest displacement of the upper floor relative to the ground, in mm.
    largest: f64,
    steps: usize,
    stuck: usize,
    work: Work<f64>,
}

/// Simulates a frame under the ground motion. Both frames have items of the same names, so the macro serves both.
macro_rules! run {
    ($frame:ty, $input:ident, $motion:expr, $friction:expr) => {{
        let mut step = <$frame>::stepper(<$frame>::STEP)?;
        let (mut points, mut largest, mut steps, mut stuck) = (Vec::new(), 0.0_f64, 0, 0);
        for ground in $motion.iter().skip(1) {
            let state = step.advance($input {
                displacement: ground.displacement,
                velocity: ground.velocity,
                friction: $friction,
            })?;
            let drift = step.upper().displacement() - ground.displacement;
            largest = largest.max(1e3 * drift.abs());
            if ground.time < SHOWN {
                points.push((drift * 1e3, state.force));
            }
            steps += 1;
            stuck += usize::from(step.contact().is_sticking());
        }
        Run {
            loop_of_damper: points,
            largest,
            steps,
            stuck,
            work: step.work(),
        }
    }};
}

fn main() -> Result<(), Box<dyn Error>> {
    let motion = ground(PEAK);
    let free = run!(Frame, FrameInput, motion, 0.0);
    let rigid = run!(Frame, FrameInput, motion, FRICTION);
    let elastic = run!(braced::Frame, BracedInput, motion, FRICTION);
    let most = motion.iter().map(|one| one.acceleration.abs());
    let most = most.fold(0.0, f64::max);
    println!("ground: {most:.1} m/s² at most, {LENGTH} s at {RATE} steps a second");
    println!(
        "brace: {BRACE} N/m, so that the damper moves by {:.1} mm before it slides",
        1e3 * FRICTION / BRACE
    );
    println!("largest drift without the damper: {:.2} mm", free.largest);
    for (name, run) in [("on a rigid support", &rigid), ("on the brace", &elastic)] {
        println!(
            "with {FRICTION} N {name}: largest drift {:.2} mm; {:.3} J in the damper, {:.3} J in the frame's own damping; it sticks at the \
             end of {} of {} steps",
            run.largest, run.work.friction, run.work.damping, run.stuck, run.steps
        );
    }
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        return Ok(());
    };
    std::fs::write(
        folder.join("elastic-loop.svg"),
        picture(&rigid, &elastic).svg(),
    )?;
    Ok(())
}

fn picture(rigid: &Run, elastic: &Run) -> Figure {
    let most = (rigid.largest.max(elastic.largest) / 5.0).ceil() * 5.0;
    let panel = |title: &str, colour, run: &Run| {
        let across = Axis::new("drift of the upper floor, mm", -most, most);
        let up = Axis::new("force in the damper, N", -1.4 * FRICTION, 1.4 * FRICTION);
        let points = vec![run.loop_of_damper.clone()];
        Panel::new(title, across, up).with(Line::new(title, colour, Stroke::Thin, points))
    };
    let panels = vec![
        panel("rigid contact", Colour::Series(1), rigid),
        panel("damper on a brace", Colour::Series(0), elastic),
    ];
    Figure::new(
        "",
        "Hysteresis of a friction damper in an earthquake",
        2,
        panels,
    )
}
