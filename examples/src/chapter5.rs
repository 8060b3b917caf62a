//! Chapter 5: what the theory of chains gives, beside its shortcuts.
//! `cargo run --release --example chapter5`

use frictiongen::friction_system;
use frictiongen_examples::album::Album;
use frictiongen_examples::curve::sample;
use frictiongen_examples::figure::{Axis, Colour, Curve, Figure, Panel, Stroke};
use frictiongen_examples::panels::cycle;
use frictiongen_examples::scene;
use frictiongen_examples::scene::Of;
use std::error::Error;
use std::f64::consts::PI;

friction_system! {
    /// Two equal storeys, loaded below, in contact with a wall above.
    pub struct Wall {
        masses: { m1: 1.0, m2: 1.0 },
        springs: { base - m1: 1.0, m1 - m2: 1.0 },
        contact: m2 - wall,
        excitation: m1,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

friction_system! {
    /// The two masses rub on each other.
    pub struct Between {
        masses: { m1: 1.0, m2: 0.5 },
        springs: { base - m1: 1.0, m1 - m2: 0.5 },
        contact: m1 - m2,
        excitation: m1,
        provide: [limits, motion, stuck, orbit, simulation],
    }
}

friction_system! {
    /// Five equal storeys, contact and load on the lowest.
    pub struct Five {
        masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 },
        springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0 },
        contact: m1 - wall,
        excitation: m1,
    }
}

scene!(Wall, Between);

/// The three limits of continuous motion over r.
macro_rules! limits {
    ($title:literal, $name:ident, $top:literal) => {{
        let y = Axis::new("friction ratio β", 0.0, $top);
        let curve = |index, name: &str, stroke, read: &dyn Fn(f64) -> Option<f64>| Curve {
            name: name.to_owned(),
            colour: Colour::Series(index),
            stroke,
            pieces: sample(&Axis::new("", 0.05, TO), &y, &$name::RESONANCES, read),
        };
        let curves = vec![
            curve(0, "exact S", Stroke::Solid, &|r| {
                Some($name::at(r).ok()?.continuous_limit())
            }),
            curve(1, "S per mode", Stroke::Dashed, &|r| {
                Some($name::at(r).ok()?.continuous_limit_per_mode())
            }),
            curve(3, "without S", Stroke::Dotted, &|r| {
                Some($name::at(r).ok()?.continuous_limit_without_search())
            }),
        ];
        panel($title, y, curves)
    }};
}

/// The amplitude of m₁ over r, exact and by the monoharmonic estimate, for a few β.
macro_rules! amplitudes {
    ($title:literal, $name:ident) => {{
        let y = Axis::new("X̄₁", 0.0, 5.0);
        let drawn = Axis::new("", 0.05, TO);
        let mut curves = Vec::new();
        for (index, beta) in [0.1, 0.2, 0.4].into_iter().enumerate() {
            let motion = |r| $name::at(r).ok()?.motion(beta).ok();
            let curve = |name: &str, stroke, pieces| Curve {
                name: format!("β = {beta}, {name}"),
                colour: Colour::Series(index),
                stroke,
                pieces,
            };
            let exact = sample(&drawn, &y, &$name::RESONANCES, |r| {
                Some(motion(r)?.m1().amplitude())
            });
            let estimate = sample(&drawn, &y, &$name::RESONANCES, |r| {
                Some(motion(r)?.m1().amplitude_monoharmonic())
            });
            curves.push(curve("exact", Stroke::Solid, exact));
            curves.push(curve("monoharmonic", Stroke::Dashed, estimate));
        }
        panel($title, y, curves)
    }};
}

const TO: f64 = 2.5;

fn panel(title: &str, y: Axis, curves: Vec<Curve>) -> Panel {
    Panel {
        title: title.to_owned(),
        x: Axis::new("frequency ratio r", 0.0, TO),
        y,
        curves,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(3)?;
    Figure::new(
        "5.2",
        "two masses between two maxima of the mass in contact",
        1,
        vec![cycle(
            "r = 0.8, β = 0.4, contact m₂-wall, load on m₁",
            &Wall,
            (0.8, 0.4),
            &[("contact x̄_j", Of::Mass(1)), ("other x̄_k", Of::Mass(0))],
            (2.0 * PI, 3.0),
        )],
    )
    .save(&mut album)?;
    Figure::new(
        "5-limits",
        "β_lim with the exact S, with S per mode (5.55), and without it (5.64)",
        2,
        vec![
            limits!("(a) two masses, contact m₂-wall", Wall, 0.8),
            limits!("(b) five masses, contact m₁-wall", Five, 1.2),
        ],
    )
    .save(&mut album)?;
    Figure::new(
        "5-amplitudes",
        "amplitude of m₁, exact and monoharmonic",
        2,
        vec![
            amplitudes!("(a) contact m₂-wall (5.50)", Wall),
            amplitudes!("(b) contact m₁-m₂, γ = κ = 0.5 (5.74)", Between),
        ],
    )
    .save(&mut album)?;
    album.close()
}
