//! Chapter 7: modal damping and friction together.  `cargo run --release --example chapter7`

use frictiongen::friction_system;
use frictiongen::study::System;
use frictiongen_examples::album::Album;
use frictiongen_examples::curve::{Pieces, sample};
use frictiongen_examples::figure::{Axis, Colour, Curve, Figure, Panel, Stroke};
use frictiongen_examples::panels::{Sweep, cycle, regimes_of};
use frictiongen_examples::scene;
use frictiongen_examples::scene::{Measure, Of, Scene};
use frictiongen_examples::scenes::{Low001, Low01, Middle001, Middle01};
use std::error::Error;
use std::f64::consts::{PI, TAU};

/// One mass against a wall.
macro_rules! one {
    ($name:ident, $zeta:literal) => {
        friction_system! {
            /// One damped mass.
            pub struct $name {
                masses: { block: 1.0 },
                springs: { base - block: 1.0 },
                contact: block - wall,
                excitation: block,
                damping: modal($zeta),
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

one!(One0001, 0.001);
one!(One001, 0.01);
one!(One01, 0.1);

/// Two equal masses, contact above, load below; ζ_i = ζ/r_n,i with r_n = 0.618034, 1.618034.
macro_rules! two {
    ($name:ident, $zeta:literal) => {
        friction_system! {
            /// Two damped masses.
            pub struct $name {
                masses: { m1: 1.0, m2: 1.0 },
                springs: { base - m1: 1.0, m1 - m2: 1.0 },
                contact: m2 - wall,
                excitation: m1,
                damping: modal[$zeta / 0.6180339887498949, $zeta / 1.618033988749895],
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

two!(Two0001, 0.001);
two!(Two001, 0.01);
two!(Two01, 0.1);

const M1: Of = Of::Mass(0);
const M2: Of = Of::Mass(1);
const FIVE: [(&str, Of); 5] = [
    ("m₁", M1),
    ("m₂", M2),
    ("m₃", Of::Mass(2)),
    ("m₄", Of::Mass(3)),
    ("m₅", Of::Mass(4)),
];

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(10)?;
    let point = (0.9, 0.2);
    for (number, title, light, heavy) in [
        (
            "7.1",
            "five masses, contact and load on m₁, r = 0.9, β = 0.2",
            &Low001 as &dyn Scene,
            &Low01 as &dyn Scene,
        ),
        (
            "7.2",
            "five masses, contact on m₃, load on m₁, r = 0.9, β = 0.2",
            &Middle001,
            &Middle01,
        ),
    ] {
        Figure::new(
            number,
            title,
            2,
            vec![
                cycle("(a) ζ = 0.01", light, point, &FIVE, (PI, 2.5)),
                cycle("(b) ζ = 0.1", heavy, point, &FIVE, (PI, 2.5)),
            ],
        )
        .save(&mut album)?;
    }
    let ones: [(&str, &dyn Scene); 3] = [
        ("ζ = 0.001", &One0001),
        ("ζ = 0.01", &One001),
        ("ζ = 0.1", &One01),
    ];
    let twos: [(&str, &dyn Scene); 3] = [
        ("ζ = 0.001", &Two0001),
        ("ζ = 0.01", &Two001),
        ("ζ = 0.1", &Two01),
    ];
    responses(
        &mut album,
        "7.3",
        "one mass",
        &ones,
        &[0.0, 0.2, 0.4, 0.6, 0.8],
        M1,
        (8.0, -90.0, 180.0),
    )?;
    Figure::new(
        "7.4",
        "motion regimes of one mass with modal damping ζ",
        1,
        vec![regimes_of("μ = 1", &ones, 2.5, 1.2)],
    )
    .save(&mut album)?;
    let betas = [0.0, 0.2, 0.5, 1.0, 1.5, 2.0];
    responses(
        &mut album,
        "7.5",
        "two masses, contact on m₂: m₁",
        &twos,
        &betas,
        M1,
        (5.0, -90.0, 270.0),
    )?;
    responses(
        &mut album,
        "7.6",
        "two masses, contact on m₂: m₂",
        &twos,
        &betas,
        // The mass in contact shares the contact's motion.
        Of::Contact,
        (5.0, -90.0, 270.0),
    )?;
    Figure::new(
        "7.7",
        "motion regimes of two masses with modal damping ζ_i = ζ/r_n,i",
        1,
        vec![regimes_of("μ = 1", &twos, 2.5, 3.0)],
    )
    .save(&mut album)?;
    Figure::new(
        "7.8",
        "resonant amplitude of one mass over modal damping and friction",
        1,
        vec![peaks()],
    )
    .save(&mut album)?;
    Figure::new(
        "7.9",
        "resonant amplitude of one mass over the friction ratio",
        2,
        estimates()?,
    )
    .save(&mut album)?;
    let slow =
        ones.map(|(name, scene)| cycle(name, scene, (0.1, 0.2), &[("block", M1)], (TAU, 1.2)));
    Figure::new(
        "7.10",
        "slow stick-slip motion, r = 0.1, β = 0.2",
        3,
        slow.into(),
    )
    .save(&mut album)?;
    album.close()
}

/// Amplitudes and phases of a mass for three dampings, row by row.
fn responses(
    album: &mut Album,
    number: &str,
    title: &str,
    scenes: &[(&str, &dyn Scene)],
    betas: &[f64],
    of: Of,
    (top, low, high): (f64, f64, f64),
) -> Result<(), Box<dyn Error>> {
    let panels = scenes.iter().flat_map(|(name, scene)| {
        let sweep = Sweep {
            scene: *scene,
            from: 0.0,
            to: 2.5,
            betas,
            measure: Measure::Peak,
            markers: 0.2,
            beyond: true,
        };
        [
            sweep.amplitude(name, "X̄", of, top),
            sweep.lag(name, "lag, degrees", of, low, high),
        ]
    });
    Figure::new(number, title, 2, panels.collect()).save(album)
}

/// One mass with a dashpot that is chosen at run time.
fn damped(zeta: f64) -> Result<System, Box<dyn Error>> {
    let text = format!(
        "struct Block {{
            masses: {{ block: 1.0 }}, springs: {{ base - block: 1.0 }}, contact: block - wall,
            excitation: block, damping: modal({zeta:?}),
        }}"
    );
    Ok(text.parse()?)
}

/// x̄'s amplitude at the undamped resonance; none where the contact stops.
fn at_resonance(system: &System, r: f64, beta: f64) -> Option<f64> {
    Some(system.at(r).ok()?.motion(beta).ok()?.contact().amplitude())
}

/// The largest amplitude of the resonance in continuous motion, which lies a little below r = 1.
fn peak(system: &System, beta: f64) -> Option<f64> {
    let steps = 2000;
    (0..=steps)
        .map(|i| 0.95 + 0.06 * f64::from(i) / f64::from(steps))
        .filter_map(|r| at_resonance(system, r, beta))
        .max_by(f64::total_cmp)
}

fn line(name: String, colour: Colour, stroke: Stroke, pieces: Pieces) -> Curve {
    Curve {
        name,
        colour,
        stroke,
        pieces,
    }
}

/// Resonant amplitudes over the modal damping ratio, up to the friction ratio that stops the contact.
fn peaks() -> Panel {
    let x = Axis::new("modal damping ratio ζ", 0.0, 0.1);
    let y = Axis::new("X̄ at r = 1", 0.0, 50.0);
    // Without damping there is no peak.
    let drawn = Axis::new("", 1e-3, 0.1);
    let mut curves: Vec<Curve> = [0.0, 0.2, 0.4, 0.6, 0.7]
        .iter()
        .enumerate()
        .map(|(index, beta)| {
            let pieces = sample(&drawn, &y, &[], |zeta| {
                at_resonance(&damped(zeta).ok()?, 1.0, *beta)
            });
            line(
                format!("β = {beta}"),
                Colour::Series(index),
                Stroke::Solid,
                pieces,
            )
        })
        .collect();
    let pieces = sample(&drawn, &y, &[], |zeta| {
        let system = damped(zeta).ok()?;
        // Just inside: on the limit itself the motion is no longer continuous.
        let limit = system.at(1.0).ok()?.continuous_limit();
        at_resonance(&system, 1.0, limit * (1.0 - 1e-13))
    });
    curves.push(line(
        "at β_lim".to_owned(),
        Colour::Black,
        Stroke::Dashed,
        pieces,
    ));
    Panel {
        title: String::new(),
        x,
        y,
        curves,
    }
}

/// Resonant amplitudes over the friction ratio: (7.61), at r = 1, and the largest there is.
fn estimates() -> Result<Vec<Panel>, Box<dyn Error>> {
    let x = || Axis::new("friction ratio β", 0.0, 0.8);
    let y = Axis::new("X̄", 0.0, 55.0);
    let light = damped(0.01)?;
    let compared = vec![
        line(
            "estimate (7.61)".to_owned(),
            Colour::Series(0),
            Stroke::Solid,
            sample(&x(), &y, &[], |beta| estimate(&light, beta)),
        ),
        line(
            "exact at r = 1".to_owned(),
            Colour::Series(1),
            Stroke::Dashed,
            sample(&x(), &y, &[], |beta| at_resonance(&light, 1.0, beta)),
        ),
        line(
            "exact resonant peak".to_owned(),
            Colour::Series(2),
            Stroke::Circles,
            vec![
                (0..=20)
                    .filter_map(|i| {
                        let beta = 0.04 * f64::from(i);
                        Some((beta, peak(&light, beta)?))
                    })
                    .collect(),
            ],
        ),
    ];
    let mut varying = Vec::new();
    for (index, zeta) in [0.01, 0.02, 0.05, 0.1].iter().enumerate() {
        let system = damped(*zeta)?;
        let pieces = sample(&x(), &y, &[], |beta| estimate(&system, beta));
        varying.push(line(
            format!("ζ = {zeta}"),
            Colour::Series(index + 3),
            Stroke::Solid,
            pieces,
        ));
    }
    Ok(
        [("(a) ζ = 0.01", compared), ("(b) estimate (7.61)", varying)]
            .map(|(title, curves)| Panel {
                title: title.to_owned(),
                x: x(),
                y: y.clone(),
                curves,
            })
            .into(),
    )
}

/// (7.61), while the motion at r = 1 is continuous.
fn estimate(system: &System, beta: f64) -> Option<f64> {
    at_resonance(system, 1.0, beta)?;
    system.resonant_peak_estimate(0, 0, beta)
}
