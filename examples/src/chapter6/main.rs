//! Chapter 6: chains of two, three and five masses.  `cargo run --release --example chapter6`

mod scenes;

use frictiongen_examples::album::Album;
use frictiongen_examples::figure::{Figure, Panel};
use frictiongen_examples::panels::{Sweep, cycle, regimes};
use frictiongen_examples::scene::{Measure, Of, Scene};
use scenes::*;
use std::error::Error;
use std::f64::consts::PI;

const M1: Of = Of::Mass(0);
const M2: Of = Of::Mass(1);
const M3: Of = Of::Mass(2);
const FIVE: [(&str, Of); 5] = [
    ("m₁", M1),
    ("m₂", M2),
    ("m₃", M3),
    ("m₄", Of::Mass(3)),
    ("m₅", Of::Mass(4)),
];
const LOWER: [f64; 5] = [0.0, 0.2, 0.4, 0.6, 0.8];
const UPPER: [f64; 8] = [0.0, 0.2, 0.4, 0.5, 1.0, 1.5, 2.0, 5.0];

fn sweep<'a>(scene: &'a dyn Scene, betas: &'a [f64]) -> Sweep<'a> {
    Sweep {
        scene,
        from: 0.0,
        to: 2.5,
        betas,
        measure: Measure::Peak,
        markers: 0.0,
        beyond: true,
    }
}

/// Amplitude and lag of both masses, row by row; a mass that rubs on a fixed wall is asked as the
/// contact, whose motion it shares.
fn masses(sweep: &Sweep, [lower, upper]: [Of; 2], top: f64) -> Vec<Panel> {
    vec![
        sweep.amplitude("(a) m₁, amplitude", "X̄₁", lower, top),
        sweep.lag("(a) m₁, phase", "lag, degrees", lower, -90.0, 270.0),
        sweep.amplitude("(b) m₂, amplitude", "X̄₂", upper, top),
        sweep.lag("(b) m₂, phase", "lag, degrees", upper, -90.0, 270.0),
    ]
}

/// Draws amplitude and lag of every one of five masses, as two files.
fn five(
    album: &mut Album,
    number: &str,
    title: &str,
    (scene, contact): (&dyn Scene, Of),
    betas: &[f64],
) -> Result<(), Box<dyn Error>> {
    let sweep = sweep(scene, betas);
    let asked = |of| if of == contact { Of::Contact } else { of };
    let amplitudes = FIVE.map(|(name, of)| sweep.amplitude(name, "X̄", asked(of), 5.0));
    let lags = FIVE.map(|(name, of)| sweep.lag(name, "lag, degrees", of, -90.0, 270.0));
    Figure::new(
        &format!("{number}a"),
        &format!("{title}, amplitudes"),
        2,
        amplitudes.into(),
    )
    .save(album)?;
    Figure::new(
        &format!("{number}b"),
        &format!("{title}, phases"),
        2,
        lags.into(),
    )
    .save(album)
}

/// Lags of five masses at β = 0.4, with the simulation.
fn lags(scene: &dyn Scene) -> Vec<Panel> {
    let sweep = Sweep {
        markers: 0.1,
        beyond: false,
        ..sweep(scene, &[0.4])
    };
    FIVE.iter()
        .map(|(name, of)| {
            sweep.lag(
                &format!("(b) {name}, β = 0.4"),
                "lag, degrees",
                *of,
                -90.0,
                270.0,
            )
        })
        .collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(23)?;
    walls(&mut album)?;
    fives(&mut album)?;
    rigs(&mut album)?;
    moving(&mut album)?;
    album.close()
}

/// Three and two storeys against a fixed wall.
fn walls(album: &mut Album) -> Result<(), Box<dyn Error>> {
    let betas = [0.0, 0.2, 0.4, 0.6, 1.0, 1.5, 2.0];
    let three = Sweep {
        beyond: false,
        ..sweep(&Three, &betas)
    };
    let mut panel = three.amplitude("contact m₂-wall, load on m₁", "X̄₁", M1, 4.0);
    panel.curves.push(three.stuck(&panel.y, M1));
    Figure::new(
        "6.2",
        "continuous transmissibility of m₁, three masses",
        1,
        vec![panel],
    )
    .save(album)?;

    let two = [("m₁", M1), ("m₂", M2)];
    Figure::new(
        "6.5",
        "two masses, contact and load on m₁: motion over half a cycle",
        2,
        vec![
            cycle(
                "(a) r = 0.8, β = 0.4, μ = 1",
                &Lower,
                (0.8, 0.4),
                &two,
                (PI, 3.0),
            ),
            cycle(
                "(b) r = 2, β = 0.3, μ = 1.2",
                &Lower12,
                (2.0, 0.3),
                &two,
                (PI, 1.5),
            ),
        ],
    )
    .save(album)?;
    let lower = Sweep {
        markers: 0.1,
        ..sweep(&Lower, &LOWER)
    };
    Figure::new(
        "6.6",
        "two masses, contact and load on m₁",
        2,
        masses(&lower, [Of::Contact, M2], 5.0),
    )
    .save(album)?;
    Figure::new(
        "6.7",
        "motion regimes, contact and load on m₁",
        3,
        vec![
            regimes("(a) μ = 1", &Lower, 2.5, 1.2),
            regimes("(b) μ = 1.2", &Lower12, 2.5, 1.2),
            regimes("(c) μ = 1.5", &Lower15, 2.5, 1.2),
        ],
    )
    .save(album)?;
    Figure::new(
        "6.12",
        "two masses, contact on m₂, load on m₁: motion over half a cycle",
        2,
        vec![
            cycle(
                "(a) r = 0.8, β = 0.4, μ = 1",
                &Upper,
                (0.8, 0.4),
                &two,
                (PI, 3.0),
            ),
            cycle(
                "(b) r = 1.4, β = 0.5, μ = 1.2",
                &Upper12,
                (1.4, 0.5),
                &two,
                (PI, 2.5),
            ),
        ],
    )
    .save(album)?;
    let upper = Sweep {
        markers: 0.1,
        ..sweep(&Upper, &UPPER)
    };
    Figure::new(
        "6.13",
        "two masses, contact on m₂, load on m₁",
        2,
        masses(&upper, [M1, Of::Contact], 5.0),
    )
    .save(album)?;
    Figure::new(
        "6.14",
        "motion regimes, contact on m₂, load on m₁",
        3,
        vec![
            regimes("(a) μ = 1", &Upper, 2.5, 3.0),
            regimes("(b) μ = 1.2", &Upper12, 2.5, 3.0),
            regimes("(c) μ = 1.5", &Upper15, 2.5, 3.0),
        ],
    )
    .save(album)
}

/// Five storeys.
fn fives(album: &mut Album) -> Result<(), Box<dyn Error>> {
    five(
        album,
        "6.8",
        "five masses, contact and load on m₁",
        (&FiveLow, M1),
        &LOWER,
    )?;
    let mut panels = vec![cycle(
        "(a) r = 1.6, β = 0.6",
        &FiveLow,
        (1.6, 0.6),
        &FIVE,
        (PI, 3.0),
    )];
    panels.extend(lags(&FiveLow));
    Figure::new(
        "6.9",
        "five masses, contact and load on m₁: motion and phases",
        2,
        panels,
    )
    .save(album)?;
    Figure::new(
        "6.10",
        "motion regimes of five masses, contact and load on m₁",
        1,
        vec![regimes("μ = 1", &FiveLow, 2.5, 1.2)],
    )
    .save(album)?;
    let betas = [0.0, 0.2, 0.4, 0.6, 1.0, 2.0];
    five(
        album,
        "6.15",
        "five masses, contact on m₃, load on m₁",
        (&FiveMiddle, M3),
        &betas,
    )?;
    let mut panels = vec![cycle(
        "(a) r = 0.9, β = 0.3",
        &FiveMiddle,
        (0.9, 0.3),
        &FIVE,
        (PI, 3.0),
    )];
    panels.extend(lags(&FiveMiddle));
    Figure::new(
        "6.16",
        "five masses, contact on m₃, load on m₁: motion and phases",
        2,
        panels,
    )
    .save(album)?;
    Figure::new(
        "6.17",
        "motion regimes of five masses, contact on m₃, load on m₁",
        1,
        vec![regimes("μ = 1", &FiveMiddle, 2.5, 3.0)],
    )
    .save(album)
}

/// The rig, amplitudes and phases of the first harmonic.
fn rigs(album: &mut Album) -> Result<(), Box<dyn Error>> {
    let rig = |scene, betas| Sweep {
        measure: Measure::Fundamental,
        ..sweep(scene, betas)
    };
    let lower = rig(&RigLower, &[0.2, 0.4, 0.6]);
    Figure::new(
        "6.20",
        "the rig, contact m₁-wall",
        2,
        masses(&lower, [Of::Contact, M2], 5.0),
    )
    .save(album)?;
    let upper = rig(&RigUpper, &[0.2, 0.5, 1.0, 1.5, 2.0]);
    Figure::new(
        "6.21",
        "the rig, contact m₂-wall",
        2,
        masses(&upper, [M1, Of::Contact], 5.0),
    )
    .save(album)?;
    let joined = rig(&RigBase, &[0.5, 0.75, 1.0, 2.0]);
    Figure::new(
        "6.28",
        "the rig, contact m₁-base",
        2,
        masses(&joined, [M1, M2], 5.0),
    )
    .save(album)?;
    Figure::new(
        "6.29",
        "the rig, relative motion of m₁ and base",
        2,
        vec![
            joined.amplitude("amplitude", "Z̄", Of::Contact, 5.0),
            joined.lag("phase", "lag, degrees", Of::Contact, -90.0, 270.0),
        ],
    )
    .save(album)
}

/// Contacts between parts that move.
fn moving(album: &mut Album) -> Result<(), Box<dyn Error>> {
    let absolute_and_relative = |sweep: &Sweep| {
        vec![
            sweep.amplitude("(a) m₁", "X̄₁", M1, 5.0),
            sweep.amplitude("(a) m₂", "X̄₂", M2, 5.0),
            sweep.amplitude("(b) relative motion", "Z̄", Of::Contact, 5.0),
        ]
    };
    let betas = [0.0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8];
    let between = Sweep {
        markers: 0.1,
        ..sweep(&Between, &betas)
    };
    Figure::new(
        "6.23",
        "contact between m₁ and m₂, γ = κ = 0.5",
        3,
        absolute_and_relative(&between),
    )
    .save(album)?;
    Figure::new(
        "6.24",
        "motion regimes, contact between m₁ and m₂",
        1,
        vec![regimes("γ = κ = 0.5, μ = 1", &Between, 2.5, 1.2)],
    )
    .save(album)?;
    let betas = [0.2, 0.5, 0.8, 1.0, 1.5, 2.0];
    let joined = Sweep {
        markers: 0.1,
        ..sweep(&Joined, &betas)
    };
    Figure::new(
        "6.25",
        "joined base and wall, contact on m₁",
        3,
        absolute_and_relative(&joined),
    )
    .save(album)?;
    Figure::new(
        "6.26",
        "motion regimes, joined base and wall, contact on m₁",
        1,
        vec![regimes("γ = κ = μ = 1", &Joined, 2.5, 4.0)],
    )
    .save(album)
}
