//! Chapter 7: modal damping and friction together.  `cargo run --release --example chapter7`

use frictiongen::friction_system;
use frictiongen_examples::figure::Figure;
use frictiongen_examples::panels::{Sweep, cycle, regimes_of};
use frictiongen_examples::scene;
use frictiongen_examples::scene::{Measure, Of, Scene};
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

/// Five equal masses.
macro_rules! five {
    ($name:ident, $contact:ident, $zeta:literal) => {
        friction_system! {
            /// Five damped masses.
            pub struct $name {
                masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 },
                springs: {
                    base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0
                },
                contact: $contact - wall,
                excitation: m1,
                damping: modal($zeta),
                provide: [limits, motion, stuck, orbit, simulation],
            }
        }
        scene!($name);
    };
}

five!(Low001, m1, 0.01);
five!(Low01, m1, 0.1);
five!(Middle001, m3, 0.01);
five!(Middle01, m3, 0.1);

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
        .save()?;
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
    .save()?;
    let betas = [0.0, 0.2, 0.5, 1.0, 1.5, 2.0];
    responses(
        "7.5",
        "two masses, contact on m₂: m₁",
        &twos,
        &betas,
        M1,
        (5.0, -90.0, 270.0),
    )?;
    responses(
        "7.6",
        "two masses, contact on m₂: m₂",
        &twos,
        &betas,
        M2,
        (5.0, -90.0, 270.0),
    )?;
    Figure::new(
        "7.7",
        "motion regimes of two masses with modal damping ζ_i = ζ/r_n,i",
        1,
        vec![regimes_of("μ = 1", &twos, 2.5, 3.0)],
    )
    .save()?;
    let slow =
        ones.map(|(name, scene)| cycle(name, scene, (0.1, 0.2), &[("block", M1)], (TAU, 1.2)));
    Figure::new(
        "7.10",
        "slow stick-slip motion, r = 0.1, β = 0.2",
        3,
        slow.into(),
    )
    .save()
}

/// Amplitudes and phases of a mass for three dampings, row by row.
fn responses(
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
    Figure::new(number, title, 2, panels.collect()).save()
}
