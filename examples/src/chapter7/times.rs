//! Figures of motions over time.

use super::responses::{one_mass, with_dashpot};
use frictiongen::{Of, System};
use frictiongen_examples::draw::{Times, chain, cycle, drawn, keys, part_colour};
use frictiongen_plot::{Figure, Panel};
use std::error::Error;
use std::f64::consts::{PI, TAU};

type Drawn = Result<Figure, Box<dyn Error>>;

const NAMES: [&str; 5] = ["*x̄*_1", "*x̄*_2", "*x̄*_3", "*x̄*_4", "*x̄*_5"];

/// Returns five equal masses with the modal damping ratio `zeta`. The first one is loaded, and the mass with the
/// number `contact` rubs on a wall.
fn five(contact: usize, zeta: f64) -> System {
    let contact = format!("m{contact} - wall");
    let damping = format!("damping: modal({zeta:?}),");
    chain(&[1.0; 5], &[1.0; 5], &contact, "m1", &damping)
}

/// Returns panels with the motion of all five masses over half a cycle, one for each of two damping ratios.
fn cycles(contact: usize) -> Result<Vec<Panel>, Box<dyn Error>> {
    let times = Times {
        span: (0.0, PI),
        circles: PI / 20.0,
        excitation: true,
    };
    let parts: Vec<_> = NAMES
        .iter()
        .enumerate()
        .map(|(index, name)| (*name, Of::Mass(index), part_colour(index)))
        .collect();
    let mut panels = Vec::new();
    for (title, zeta) in [("(a) *ζ_i* = 0.01", 0.01), ("(b) *ζ_i* = 0.1", 0.1)] {
        let panel = cycle(title, &five(contact, zeta), (0.9, 0.2), &parts, times);
        panels.push(panel.ok_or("no motion")?);
    }
    // The panels have equal ranges of displacements, so that they can be compared.
    let reach = panels.iter().map(|panel| panel.y.high).fold(0.0, f64::max);
    for panel in &mut panels {
        (panel.y.low, panel.y.high) = (-reach, reach);
    }
    Ok(panels)
}

/// Figure 7.1: motions of five damped masses with the contact on m₁.
pub fn low_contact() -> Drawn {
    Ok(Figure::new("7.1", "Five damped masses, load and contact on the lowest", 2, cycles(1)?)
        .with_sketch(drawn(&five(1, 0.01)))
        .with_keys(keys())
        .with_caption(
            "Half a cycle from a maximum of *m*_1, equal masses and springs, *r*_1 = 0.9, *β* = 0.2, *μ* = 1. With little modal damping all \
             masses turn at nearly the same time; with more they do not.",
        ))
}

/// Figure 7.2: motions of five damped masses with the contact on m₃.
pub fn middle_contact() -> Drawn {
    Ok(Figure::new("7.2", "Five damped masses, load on the lowest, contact on the middle one", 2, cycles(3)?)
        .with_sketch(drawn(&five(3, 0.01)))
        .with_keys(keys())
        .with_caption(
            "Half a cycle from a maximum of *m*_3, equal masses and springs, *r*_1 = 0.9, *β* = 0.2, *μ* = 1. With little modal damping *m*_3, \
             *m*_4 and *m*_5 turn together; with more, one after the other.",
        ))
}

/// Figure 7.10: slow motion of a mass with stops.
pub fn slow() -> Drawn {
    let times = Times {
        span: (0.0, TAU),
        circles: TAU / 60.0,
        excitation: true,
    };
    let parts = [("block *x̄*", Of::Mass(0), part_colour(0))];
    let mut panels = Vec::new();
    for (letter, zeta) in [("a", 0.001), ("b", 0.01), ("c", 0.1)] {
        let title = format!("({letter}) *ζ* = {zeta}");
        let panel = cycle(&title, &one_mass(zeta), (0.1, 0.2), &parts, times);
        let mut panel = panel.ok_or("no motion")?;
        panel.height = Some(190.0);
        panels.push(panel);
    }
    Ok(Figure::new("7.10", "Slow motion of a damped mass with stops", 1, panels)
        .with_sketch(with_dashpot())
        .with_keys(keys())
        .with_caption(
            "One cycle from a maximum, *r* = 0.1, *β* = 0.2, *μ* = 1. The mass follows the load in steps, and rests in the shaded times; more damping makes \
             the steps smoother.",
        ))
}
