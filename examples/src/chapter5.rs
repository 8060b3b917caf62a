//! Chapter 5: results of the theory of chains, compared with its approximations.
//! `cargo run --release --example chapter5`

use frictiongen::{Of, System};
use frictiongen_examples::album::Album;
use frictiongen_examples::draw::{
    Times, beta_colour, cycle, keys, part_colour, places, save, system,
};
use frictiongen_plot::desk::sketch;
use frictiongen_plot::{Axis, Figure, Line, Panel, Point, Sketch, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

const TO: f64 = 2.5;

/// Returns two equal masses on springs. The lower one is loaded, and the upper one rubs on a wall.
fn wall() -> System {
    system(
        "struct Wall {
            masses: { m1: 1.0, m2: 1.0 },
            springs: { base - m1: 1.0, m1 - m2: 1.0 },
            contact: m2 - wall,
            excitation: m1,
        }",
    )
}

/// Returns two masses that rub on each other.
fn between() -> System {
    system(
        "struct Between {
            masses: { m1: 1.0, m2: 0.5 },
            springs: { base - m1: 1.0, m1 - m2: 0.5 },
            contact: m1 - m2,
            excitation: m1,
        }",
    )
}

/// Returns a chain of five equal masses with the given contact and excitation.
fn five(contact: &str, excitation: &str) -> System {
    system(&format!(
        "struct Five {{
            masses: {{ m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0 }},
            springs: {{ base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0 }},
            contact: {contact},
            excitation: {excitation},
        }}"
    ))
}

fn drawn(system: &System) -> Sketch {
    sketch(system.scene(), false)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::open(6)?;
    let [any, two, base] = systems();
    save(&any, &mut album)?;
    save(&maxima()?, &mut album)?;
    save(&two, &mut album)?;
    save(&base, &mut album)?;
    save(&limits(), &mut album)?;
    save(&amplitudes(), &mut album)?;
    album.close()
}

/// Figures 5.1 and 5.3: sketches of the three kinds of contact.
fn systems() -> [Figure; 3] {
    [
        (
            "5.1",
            "A chain in contact with a fixed wall",
            five("m3 - wall", "m2"),
            "Any number of masses and springs; here five, the contact on *m*_3 and the load on *m*_2. *r*_1 = *ω*√(*m*_1/*k*_1), \
             *β* = *F*/*P*, *X̄*_i is the amplitude of *m*_i over *P*/*k*_1.",
        ),
        (
            "5.3a",
            "A chain with a contact between two masses",
            five("m3 - m4", "m1"),
            "The relative motion is that of the two masses that rub on each other, here *m*_3 and *m*_4.",
        ),
        (
            "5.3b",
            "A chain in contact with its moving base",
            five("m3 - base", "base"),
            "The base moves and carries the wall; *β* = *F*/(*k*_1*Y*).",
        ),
    ]
    .map(|(number, title, system, caption)| {
        Figure::new(number, title, 1, Vec::new())
            .with_sketch(drawn(&system))
            .with_caption(caption)
    })
}

/// Figure 5.2: motion between two maxima of the mass that is in contact.
fn maxima() -> Result<Figure, Box<dyn Error>> {
    let system = wall();
    let parts = [
        ("in contact, *x̄*_j = *x̄*_2", Of::Mass(1), part_colour(1)),
        ("not in contact, *x̄*_k = *x̄*_1", Of::Mass(0), part_colour(0)),
    ];
    let times = Times {
        span: (0.0, TAU),
        circles: TAU / 24.0,
        excitation: true,
    };
    let panel = cycle("", &system, (0.8, 0.4), &parts, times).ok_or("no motion")?;
    Ok(Figure::new("5.2", "Two masses between two maxima of the one in contact", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_keys(keys())
        .with_caption(
            "*r*_1 = 0.8, *β* = 0.4, equal masses and springs. Time counts from a maximum of *x̄*_2, where the friction force \
             changes its sign; *x̄*_1 has its maximum at another time.",
        ))
}

/// Figure of the ratio of approximate limits of continuous motion to the exact limit.
fn limits() -> Figure {
    let (two, chain) = (wall(), five("m1 - wall", "m1"));
    let panel = |title: &str, system: &System| {
        let places = places(system, (0.15, 0.8));
        let ratio = |shortcut: &dyn Fn(f64) -> Option<f64>| -> Vec<Point> {
            let places = places.iter().filter(|(_, limits)| 1e-6 < limits.continuous);
            let point = |(r, limits): &(f64, frictiongen::Limits<f64>)| {
                Some((*r, shortcut(*r)? / limits.continuous))
            };
            places.filter_map(point).collect()
        };
        let per_mode = ratio(&|r| Some(system.at(r).ok()?.continuous_limit_per_mode()));
        let without = ratio(&|r| Some(system.at(r).ok()?.continuous_limit_without_search()));
        let x = Axis::new("frequency ratio *r*_1", 0.15, 0.8);
        Panel::new(title, x, Axis::new("*β*_lim over the exact one", 0.0, 3.0))
            .with(Line::new(
                "without *S* (5.64)",
                part_colour(2),
                Stroke::Solid,
                vec![without],
            ))
            .with(Line::new(
                "*S* mode by mode (5.55)",
                part_colour(1),
                Stroke::Solid,
                vec![per_mode],
            ))
    };
    let panels = vec![
        panel("(a) two masses, contact on *m*_2", &two),
        panel("(b) five masses, contact on *m*_1", &chain),
    ];
    Figure::new("5-limits", "Shortcuts to the limit of continuous motion", 2, panels).with_caption(
        "Not in the thesis: the limit with *S* summed mode by mode, as the thesis prints it, and without *S*, over the exact \
         one; load on *m*_1, equal masses and springs, *μ* = 1. The first is never too high, the second never too low; at \
         higher *r*_1 both are exact.",
    )
}

/// Figure of the ratio of the monoharmonic estimate of an amplitude to the exact amplitude.
fn amplitudes() -> Figure {
    let panel = |title: &str, system: &System, (low, high): (f64, f64)| {
        let x = Axis::new("frequency ratio *r*_1", 0.0, TO);
        let mut panel = Panel::new(title, x, Axis::new("estimate over exact *X̄*_1", low, high));
        for beta in [0.1, 0.2, 0.4] {
            let mut pieces: Vec<Vec<Point>> = vec![Vec::new()];
            for i in 1..=1250 {
                let r = TO * f64::from(i) / 1250.0;
                let motion = system.at(r).ok().and_then(|at| at.motion(beta).ok());
                let ratio = motion.and_then(|motion| {
                    let mass = motion.mass_at(0)?;
                    Some(mass.amplitude_monoharmonic() / mass.amplitude())
                });
                match (ratio, pieces.last_mut()) {
                    (Some(ratio), Some(piece)) => piece.push((r, ratio)),
                    _ => pieces.push(Vec::new()),
                }
            }
            pieces.retain(|piece| 1 < piece.len());
            let name = format!("*β* = {beta}");
            panel = panel.with(Line::new(name, beta_colour(beta), Stroke::Solid, pieces));
        }
        panel
    };
    let panels = vec![
        panel(
            "(a) contact of *m*_2 with a wall (5.50)",
            &wall(),
            (0.9, 1.3),
        ),
        panel(
            "(b) contact of *m*_1 with *m*_2 (5.74)",
            &between(),
            (0.8, 1.1),
        ),
    ];
    Figure::new("5-amplitudes", "The monoharmonic estimate of an amplitude", 2, panels).with_caption(
        "Not in the thesis: the estimate over the exact amplitude of *m*_1, motions without stops, load on *m*_1; *γ* = *κ* = 1 \
         in (a) and 0.5 in (b). Against a wall it is good but for narrow ranges; \
         between two masses it is up to 16 % too low.",
    )
}
