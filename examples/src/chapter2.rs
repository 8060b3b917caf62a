//! Chapter 2: one mass against a fixed wall, Den Hartog's problem.
//! `cargo run --release --example chapter2`

use frictiongen::{Of, System};
use frictiongen_examples::album::Album;
use frictiongen_examples::draw::{Responses, Times, block, cycle, keys, part_colour, save, system};
use frictiongen_plot::desk::{Reading, Scales, regimes, sketch};
use frictiongen_plot::{Axis, Colour, End, Figure, Line, Panel, Point, Sketch, Spring, Stroke};
use std::error::Error;
use std::f64::consts::{PI, TAU};

const BLOCK: Of = Of::Mass(0);

/// Returns a loaded block on a spring. The block rubs on a fixed wall.
fn wall() -> System {
    block("wall", "block", "")
}

/// Returns the system of [`wall`] with a dashpot, whose damping ratio ζ is 0.2.
fn damped() -> System {
    block("wall", "block", "damping: modal(0.2),")
}

/// Returns two masses on springs. The lower one is loaded, and rubs on a wall.
fn two() -> System {
    system(
        "struct Two {
            masses: { lower: 1.0, upper: 1.0 },
            springs: { base - lower: 1.0, lower - upper: 1.0 },
            contact: lower - wall,
            excitation: lower,
        }",
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(10)?;
    for figure in [
        laws()?,
        loaded(),
        half_periods()?,
        amplitudes()?,
        map()?,
        two_stops()?,
        dashpot()?,
    ]
    .into_iter()
    .chain(systems())
    {
        save(&figure, &mut album)?;
    }
    album.close()
}

/// Figure 2.1: friction force over sliding velocity, and over displacement.
fn laws() -> Result<Figure, Box<dyn Error>> {
    let (low, high, least) = (-4.0, 4.0, 1e-6);
    let steps = 200;
    let side = |sign: f64, law: &dyn Fn(f64) -> f64| -> Vec<Point> {
        let speed = |i: u32| least + (high - least) * f64::from(i) / f64::from(steps);
        let point = |i: u32| (sign * speed(i), -sign * law(speed(i)));
        if sign < 0.0 {
            (0..=steps).rev().map(point).collect()
        } else {
            (0..=steps).map(point).collect()
        }
    };
    let panel = |title: &str, most: f64, law: &dyn Fn(f64) -> f64| {
        let rest = vec![(0.0, most), (0.0, -most)];
        let law = vec![side(-1.0, law), side(1.0, law)];
        Panel::new(
            title,
            Axis::new("sliding velocity *v*_r / *v*_s", low, high),
            Axis::new("force *F*_f / (*μ*_d *F*_n)", -1.8, 1.8),
        )
        .with(Line::new(
            "at rest: what keeps it there",
            Colour::Black,
            Stroke::Dotted,
            vec![rest],
        ))
        .with(Line::new("sliding", part_colour(0), Stroke::Solid, law))
    };
    let stiction = 1.5;
    let stribeck = |v: f64| 1.0 + (stiction - 1.0) * (-v).exp();
    let panels = vec![
        panel("(a) Coulomb", 1.0, &|_| 1.0),
        panel("(b) Coulomb with stiction", stiction, &|_| 1.0),
        panel("(c) Stribeck", stiction, &stribeck),
        loop_of_work()?,
    ];
    Ok(Figure::new("2.1", "Laws of dry friction", 2, panels).with_caption(
        "The force on the sliding body over its velocity: it opposes the motion, and at rest takes any value up to \
         *μ*_s *F*_n, here with *μ*_s = 1.5 *μ*_d in (b) and (c). (d), not in the thesis: with law (a) the block of figure \
         2.6 (*r* = 0.6, *β* = 0.6) goes round a rectangle in each cycle; its area is the work lost.",
    ))
}

/// Returns a panel with the friction force over the displacement, in a motion with two stops in a cycle.
fn loop_of_work() -> Result<Panel, Box<dyn Error>> {
    let system = wall();
    let mut run = system.simulation(0.6, 0.6)?;
    while run.cycles() < 200 {
        run.advance(PI)?;
    }
    let mut points = Vec::new();
    let step = TAU / 720.0;
    for _ in 0..=720 {
        points.push((run.run().mass(0).displacement(), -run.friction()));
        let mut left = step;
        while 1e-12 < left {
            let segment = run.advance(left)?;
            left -= segment.length;
            if 1e-12 < left {
                // At an event the force jumps. The loop contains the values before and after the jump.
                points.push((run.run().mass(0).displacement(), -run.friction()));
            }
        }
    }
    let line = Line::unnamed(part_colour(0), Stroke::Solid, vec![points]);
    let x = Axis::new("displacement *x̄*", -1.8, 1.8);
    let y = Axis::new("force over *P*", -0.9, 0.9);
    Ok(Panel::new("(d) over a cycle with two stops", x, y).with(line))
}

/// Figure 2.3a: sketch of a loaded block on a spring, which rubs on a fixed wall.
fn loaded() -> Figure {
    Figure::new("2.3a", "A block on a spring against a fixed wall", 1, Vec::new())
        .with_sketch(drawn(&wall()))
        .with_caption(
            "A force of amplitude *P* moves the block; *F* is the kinetic friction force, *μF* the static one. \
             *r* = *ω*√(*m*/*k*), *β* = *F*/*P*, *x̄* = *x*/(*P*/*k*), *τ* = *ωt*.",
        )
}

/// Figure 2.3b: one cycle of continuous motion.
fn half_periods() -> Result<Figure, Box<dyn Error>> {
    let system = wall();
    let times = Times {
        span: (0.0, TAU),
        circles: TAU / 24.0,
        excitation: true,
    };
    let parts = [("block *x̄*", BLOCK, part_colour(0))];
    let panel = cycle("", &system, (0.7, 0.4), &parts, times).ok_or("no motion")?;
    Ok(Figure::new("2.3b", "Motion without stops", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_keys(keys())
        .with_caption(
            "One cycle from a maximum of the motion, *r* = 0.7, *β* = 0.4. The velocity keeps its sign for half a cycle, \
             the friction force is constant there, and the second half repeats the first with the opposite sign.",
        ))
}

/// Figure 2.4: amplitude and phase over the frequency ratio in continuous motion.
fn amplitudes() -> Result<Figure, Box<dyn Error>> {
    let system = wall();
    let betas = [0.0, 0.2, 0.4, 0.6, 0.8];
    let responses = Responses::new(&system, (0.1, 2.5), &betas, &[BLOCK])?.continuous();
    let panels = vec![
        responses
            .amplitude("(a) amplitude", 0, "*X̄*", 5.0)
            .with(responses.limit(0, Reading::Amplitude)),
        responses
            .phase("(b) phase", 0, "*φ* (degrees)", (-45.0, 190.0))
            .with(responses.limit(0, Reading::Phase)),
    ];
    Ok(Figure::new("2.4", "Continuous response against a fixed wall", 2, panels)
        .with_sketch(drawn(&system))
        .with_caption(
            "Motions without stops only; they end at the dashed line, drawn from *r* = 0.2 on. Friction does not make the \
             resonance finite as long as *β* = *F*/*P* is below π/4; *φ* is the lag of the maximum.",
        ))
}

/// Figure 2.5: regimes over frequency ratio and friction ratio.
fn map() -> Result<Figure, Box<dyn Error>> {
    let system = wall();
    let lines = system.limit_lines(0.0, 2.5, 1e-4)?;
    let panel = regimes("", &lines, 1.2, &Scales::groups(&system));
    Ok(Figure::new("2.5", "Motion regimes against a fixed wall", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_caption(
            "*μ* = 1. *β*_lim reaches zero at *r* = 1/3, 1/5, 1/7, … and π/4 at the resonance, and tends to 0.537 for \
             large *r*. From *β* = 1 on the load never overcomes the friction.",
        ))
}

/// Figure 2.6: displacement over a cycle with two stops.
fn two_stops() -> Result<Figure, Box<dyn Error>> {
    let system = wall();
    let times = Times {
        span: (0.0, TAU),
        circles: TAU / 36.0,
        excitation: true,
    };
    let parts = [("block *x̄*", BLOCK, part_colour(0))];
    let panel = cycle("", &system, (0.6, 0.6), &parts, times).ok_or("no motion")?;
    Ok(Figure::new("2.6", "A motion with two stops", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_keys(keys())
        .with_caption(
            "One cycle from where the block leaves its maximum, *r* = 0.6, *β* = 0.6. It reaches its minimum before half a \
             cycle is over, and rests there until the load overcomes friction again.",
        ))
}

/// Figure 2.7: amplitude and phase over the frequency ratio, with a dashpot.
fn dashpot() -> Result<Figure, Box<dyn Error>> {
    let system = damped();
    let betas = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5];
    let responses = Responses::new(&system, (0.1, 2.5), &betas, &[BLOCK])?.continuous();
    let panel = responses
        .amplitude("", 0, "*X̄*", 2.75)
        .with(responses.limit(0, Reading::Amplitude));
    let mut drawn = drawn(&system);
    drawn.dashpots.push(Spring {
        between: (End::Base, End::Mass(0)),
        label: "*c*".into(),
    });
    Ok(Figure::new("2.7", "A dashpot beside the friction contact", 1, vec![panel])
        .with_sketch(drawn)
        .with_caption(
            "*ζ* = 0.2, motions without stops. The dashpot makes the resonance finite, and friction lowers it further.",
        ))
}

/// Figures 2.8a to 2.8c: sketches of the systems of the next chapters.
fn systems() -> [Figure; 3] {
    [
        ("2.8a", "Base motion, fixed wall", block("wall", "base", ""),
         "The base moves; the block rubs on a wall that stands still. With *P* = *kY* its motion is that of figure 2.4."),
        ("2.8b", "Base and wall move together", block("base", "base", ""),
         "The wall is joined to the moving base: chapter 3."),
        ("2.8c", "Two masses, load and contact below", two(), "The chains of chapter 5 begin with this one."),
    ]
    .map(|(number, title, system, caption)| {
        Figure::new(number, title, 1, Vec::new())
            .with_sketch(drawn(&system))
            .with_caption(caption)
    })
}

fn drawn(system: &System) -> Sketch {
    sketch(system.scene(), false)
}
