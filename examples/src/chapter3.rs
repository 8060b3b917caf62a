//! Chapter 3: one mass on a base that carries the wall.  `cargo run --release --example chapter3`

use frictiongen::friction_system;
use frictiongen_examples::album::Album;
use frictiongen_examples::curve::sample;
use frictiongen_examples::figure::{Axis, Colour, Curve, Figure, Panel, Stroke};
use frictiongen_examples::panels::{Sweep, cycle, regimes};
use frictiongen_examples::scene;
use frictiongen_examples::scene::{Measure, Of, Scene};
use std::error::Error;
use std::f64::consts::{PI, TAU};

/// The same scene for a ratio of static to kinetic friction.
macro_rules! joined {
    ($name:ident, $stiction:literal) => {
        friction_system! {
            /// A mass on a spring rubs on a wall that moves with the base.
            pub struct $name {
                masses: { block: 1.0 },
                springs: { base - block: 1.0 },
                contact: block - base,
                excitation: base,
                stiction: $stiction,
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

joined!(Joined, 1.0);
joined!(Joined12, 1.2);
joined!(Joined15, 1.5);
joined!(Joined2, 2.0);

/// A block on a spring and a dashpot under a harmonic load, without friction.  The relative motion of
/// a block whose dashpot is fixed to the moving base (3.9) is r² times its.
macro_rules! viscous {
    ($name:ident, $zeta:literal) => {
        friction_system! {
            /// A loaded block on a spring and a dashpot.
            pub struct $name {
                masses: { block: 1.0 },
                springs: { base - block: 1.0 },
                contact: block - wall,
                excitation: block,
                damping: modal($zeta),
            }
        }
    };
}

viscous!(Viscous005, 0.05);
viscous!(Viscous01, 0.1);
viscous!(Viscous02, 0.2);
viscous!(Viscous05, 0.5);
viscous!(Viscous1, 1.0);

const MASS: Of = Of::Mass(0);
const BETAS: [f64; 7] = [0.0, 0.2, 0.5, 0.8, 1.0, 1.25, 1.5];

fn sweep<'a>(scene: &'a dyn Scene, betas: &'a [f64]) -> Sweep<'a> {
    Sweep {
        scene,
        from: 0.0,
        to: 2.5,
        betas,
        measure: Measure::Peak,
        markers: 0.0,
        beyond: false,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(11)?;
    let continuous = sweep(&Joined, &BETAS);
    Figure::new(
        "3.2",
        "relative motion in the contact, continuous",
        2,
        vec![
            continuous.amplitude("(a) amplitude", "Z̄", Of::Contact, 5.0),
            continuous.lag("(b) phase", "lag, degrees", Of::Contact, -90.0, 180.0),
        ],
    )
    .save(&mut album)?;
    Figure::new("3.3", "the function S", 1, vec![constraint()]).save(&mut album)?;
    Figure::new(
        "3.4",
        "motion regimes, μ = 1",
        1,
        vec![regimes("μ = 1", &Joined, 2.5, 4.0)],
    )
    .save(&mut album)?;
    Figure::new(
        "3.5",
        "motion regimes for static over kinetic friction μ",
        2,
        vec![
            regimes("(a) μ = 1", &Joined, 2.5, 4.0),
            regimes("(b) μ = 1.2", &Joined12, 2.5, 4.0),
            regimes("(c) μ = 1.5", &Joined15, 2.5, 4.0),
            regimes("(d) μ = 2", &Joined2, 2.5, 4.0),
        ],
    )
    .save(&mut album)?;
    let both = [("mass x̄", MASS), ("relative z̄", Of::Contact)];
    Figure::new(
        "3.6",
        "continuous motion over a cycle, r = 0.9, β = 0.4",
        1,
        vec![cycle(
            "r = 0.9, β = 0.4",
            &Joined,
            (0.9, 0.4),
            &both,
            (TAU, 6.0),
        )],
    )
    .save(&mut album)?;
    let near = Sweep {
        from: 1.3,
        to: 1.7,
        ..continuous
    };
    Figure::new(
        "3.7",
        "displacement transmissibility, continuous",
        2,
        vec![
            continuous.amplitude("(a)", "X̄", MASS, 5.0),
            near.detail("(b) where the curves invert", "X̄", MASS, (0.6, 1.6)),
        ],
    )
    .save(&mut album)?;
    Figure::new(
        "3.8",
        "phase of the mass behind the base, continuous",
        1,
        vec![continuous.lag("", "lag, degrees", MASS, -15.0, 180.0)],
    )
    .save(&mut album)?;
    Figure::new(
        "3.9",
        "the same with viscous damping in place of friction",
        1,
        vec![viscous()],
    )
    .save(&mut album)?;
    Figure::new(
        "3.11",
        "motion over half a cycle, closed form and simulation",
        2,
        vec![
            cycle(
                "(a) r = 0.9, β = 0.4, μ = 1",
                &Joined,
                (0.9, 0.4),
                &both,
                (PI, 6.0),
            ),
            cycle(
                "(b) r = 2, β = 1, μ = 1.5",
                &Joined15,
                (2.0, 1.0),
                &both,
                (PI, 1.5),
            ),
        ],
    )
    .save(&mut album)?;
    let betas = [0.2, 0.5, 0.8, 1.0, 1.25, 1.5, 2.0];
    let mut full = sweep(&Joined, &betas);
    full.beyond = true;
    full.markers = 0.05;
    Figure::new(
        "3.14",
        "amplitude in all regimes, with the simulation",
        2,
        vec![
            full.amplitude("(a) mass", "X̄", MASS, 5.0),
            full.amplitude("(b) relative motion", "Z̄", Of::Contact, 5.0),
        ],
    )
    .save(&mut album)?;
    Figure::new(
        "3.15",
        "β = 1 for static over kinetic friction μ",
        2,
        vec![
            stiction("(a) mass", "X̄", MASS),
            stiction("(b) relative motion", "Z̄", Of::Contact),
        ],
    )
    .save(&mut album)?;
    album.close()
}

/// S (2.27) out of the motion itself: z̄' = −Z̄ sin τ + β(…) is negative while Z̄ > βS/r² (3.16).
fn constraint() -> Panel {
    let x = Axis::new("frequency ratio r", 0.0, 2.5);
    let y = Axis::new("S", 0.0, 5.0);
    let instants = 400;
    // The odd sub-harmonics, where the damping function has poles.
    let marks = [1.0 / 3.0, 0.2, 1.0 / 7.0, 1.0 / 9.0];
    let pieces = sample(&Axis::new("", 0.1, 2.5), &y, &marks, |r| {
        let at = Joined::at(r).ok()?;
        let beta = 0.5 * at.continuous_limit().min(at.sliding_limit());
        let motion = at.motion(beta).ok()?;
        let contact = motion.contact();
        let amplitude = contact.amplitude();
        let largest = (1..instants)
            .map(|i| PI * f64::from(i) / f64::from(instants))
            // The supremum is often approached at the ends only.
            .chain([1e-3, PI - 1e-3])
            .map(|tau| contact.velocity(tau) / tau.sin())
            .fold(f64::NEG_INFINITY, f64::max);
        Some(r * r * (largest + amplitude) / beta)
    });
    let curve = Curve {
        name: "S".to_owned(),
        colour: Colour::Series(0),
        stroke: Stroke::Solid,
        pieces,
    };
    Panel {
        title: String::new(),
        x,
        y,
        curves: vec![curve],
    }
}

/// Transmissibility with dashpots only, β = 0.
fn viscous() -> Panel {
    let x = Axis::new("frequency ratio r", 0.0, 2.5);
    let y = Axis::new("X̄", 0.0, 5.0);
    let mut curves = Vec::new();
    macro_rules! add {
        ($($name:ident $zeta:literal),*) => {$(
            let pieces = sample(&Axis::new("", 0.02, 2.5), &y, &[1.0], |r| {
                let x = $name::at(r).ok()?.motion(0.0).ok()?.block().harmonic(1);
                let (re, im) = (1.0 + r * r * x.re, r * r * x.im);
                Some(re.hypot(im))
            });
            let colour = Colour::Series(curves.len());
            curves.push(Curve { name: format!("ζ = {}", $zeta), colour, stroke: Stroke::Solid, pieces });
        )*};
    }
    add!(Viscous005 0.05, Viscous01 0.1, Viscous02 0.2, Viscous05 0.5, Viscous1 1.0);
    Panel {
        title: String::new(),
        x,
        y,
        curves,
    }
}

/// Amplitudes at β = 1 in all regimes for several μ.
fn stiction(title: &str, label: &str, of: Of) -> Panel {
    let scenes: [(&str, &dyn Scene); 4] = [
        ("μ = 1", &Joined),
        ("μ = 1.2", &Joined12),
        ("μ = 1.5", &Joined15),
        ("μ = 2", &Joined2),
    ];
    let x = Axis::new("frequency ratio r", 0.0, 2.5);
    let y = Axis::new(label, 0.0, 2.5);
    let curves = scenes
        .iter()
        .enumerate()
        .map(|(index, (name, scene))| Curve {
            name: (*name).to_owned(),
            colour: Colour::Series(index),
            stroke: Stroke::Solid,
            pieces: sample(&Axis::new("", 0.02, 2.5), &y, &[1.0], |r| {
                Some(scene.response(r, 1.0, of, Measure::Peak)?.amplitude)
            }),
        })
        .collect();
    Panel {
        title: title.to_owned(),
        x,
        y,
        curves,
    }
}
