//! Chapter 3: one mass on a base that carries the wall. `cargo run --release --example chapter3`

mod amplitudes;
mod branches;
mod regimes;
mod viscous;

use frictiongen::{Of, System};
use frictiongen_examples::album::Album;
use frictiongen_examples::draw::{Times, block, cycle, keys, part_colour, save};
use frictiongen_plot::desk::sketch;
use frictiongen_plot::{Figure, Sketch};
use std::error::Error;
use std::f64::consts::{PI, TAU};

const MASS: Of = Of::Mass(0);

/// Returns a mass on a spring. It rubs on a wall that moves with the base. `stiction` is the ratio μ of static to
/// kinetic friction.
fn joined(stiction: f64) -> System {
    block("base", "base", &format!("stiction: {stiction:?},"))
}

fn drawn(system: &System) -> Sketch {
    sketch(system.scene(), false)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(13)?;
    for figure in [
        amplitudes::relative,
        regimes::constraint,
        regimes::map,
        regimes::stiction,
        one_cycle,
        amplitudes::transmissibility,
        amplitudes::phase,
        viscous::dashpots,
        half_cycles,
        regimes::stops,
        regimes::few_stops,
        amplitudes::all_regimes,
        branches::stiction,
    ] {
        save(&figure()?, &mut album)?;
    }
    album.close()
}

/// Figure 3.6: motion of mass and contact over one cycle.
fn one_cycle() -> Result<Figure, Box<dyn Error>> {
    let system = joined(1.0);
    let times = Times {
        span: (0.0, TAU),
        circles: 0.0,
        excitation: true,
    };
    let panel = cycle("", &system, (0.9, 0.4), &parts(), times).ok_or("no motion")?;
    Ok(Figure::new("3.6", "Absolute and relative motion over a cycle", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_caption(
            "*r* = 0.9, *β* = 0.4, from a maximum of the relative motion *z̄*. The text of the thesis does not give these \
             parameters; they are chosen. The mass, *x̄*, reaches its maximum at \
             another time: its amplitude has to be searched for.",
        ))
}

/// Figure 3.11: closed form compared with the simulation.
fn half_cycles() -> Result<Figure, Box<dyn Error>> {
    let times = Times {
        span: (0.0, PI),
        circles: PI / 20.0,
        excitation: true,
    };
    let panel =
        |title, system: &System, at| cycle(title, system, at, &parts(), times).ok_or("no motion");
    let panels = vec![
        panel(
            "(a) *r* = 0.9, *β* = 0.4, *μ* = 1",
            &joined(1.0),
            (0.9, 0.4),
        )?,
        panel("(b) *r* = 2, *β* = 1, *μ* = 1.5", &joined(1.5), (2.0, 1.0))?,
    ];
    Ok(Figure::new("3.11", "Closed form and simulation over half a cycle", 2, panels)
        .with_sketch(drawn(&joined(1.0)))
        .with_keys(keys())
        .with_caption(
            "Lines are the closed form, circles a simulation from rest after 1000 cycles: they lie on each other. The text of \
             the thesis does not give these parameters; they are chosen.",
        ))
}

fn parts() -> [(&'static str, Of, frictiongen_plot::Colour); 2] {
    [
        ("mass *x̄*", MASS, part_colour(0)),
        ("relative *z̄*", Of::Contact, part_colour(1)),
    ]
}
