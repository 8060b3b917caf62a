//! Figures of responses and regimes over the frequency ratio.

use frictiongen::{Of, System};
use frictiongen_examples::draw::{
    RATIO, Responses, Row, block, chain, drawn, strokes, tidy, variant_colour,
};
use frictiongen_plot::desk::{Scales, limit_lines};
use frictiongen_plot::{
    Anchor, Axis, Colour, End, Figure, Key, Line, Note, Panel, Sketch, Spring, Stroke,
};
use std::error::Error;

type Drawn = Result<Figure, Box<dyn Error>>;

const DAMPINGS: [f64; 3] = [0.001, 0.01, 0.1];

/// Returns one mass that rubs on a wall, with the modal damping ratio `zeta`.
pub fn one_mass(zeta: f64) -> System {
    block("wall", "block", &format!("damping: modal({zeta:?}),"))
}

/// Returns two equal masses. The lower one is loaded, and the upper one rubs on a wall. The damping ratio of a mode
/// is `zeta` divided by its natural frequency ratio.
fn two_masses(zeta: f64) -> System {
    let resonances = [1.0, -1.0].map(|sign| 0.5 * (5.0_f64.sqrt() - sign));
    let [first, second] = resonances.map(|resonance| zeta / resonance);
    let damping = format!("damping: modal[{first:?}, {second:?}],");
    chain(&[1.0; 2], &[1.0; 2], "m2 - wall", "m1", &damping)
}

/// Returns the sketch of one mass with a dashpot.
pub fn with_dashpot() -> Sketch {
    let mut sketch = drawn(&one_mass(0.1));
    sketch.dashpots.push(Spring {
        between: (End::Base, End::Mass(0)),
        label: "*c*".into(),
    });
    sketch
}

/// Returns panels with amplitude and phase over the frequency ratio, one row for each system.
fn rows(
    systems: &[(String, System)],
    betas: &[f64],
    part: (Of, [&str; 2], (f64, f64)),
) -> Result<Vec<Panel>, Box<dyn Error>> {
    let (of, labels, sizes) = part;
    let mut panels = Vec::new();
    for ((name, system), letter) in systems.iter().zip(["a", "b", "c"]) {
        let responses = Responses::up_to(2000.0, 5e-4, system, (0.1, 2.5), betas, &[of])?;
        let title = format!("({letter}) {name}");
        let row = Row {
            part: 0,
            titles: [&title, &title],
            labels,
            sizes,
            stuck: of == Of::Mass(0) && !single(systems),
            limit_from: 0.2,
            circles: 0.2,
            harmonic: false,
        };
        panels.extend(row.panels(&responses));
    }
    if single(systems) {
        for panel in &mut panels {
            panel.x.label = "frequency ratio *r*".into();
        }
    }
    Ok(panels)
}

/// Returns true if every system has a single mass.
fn single(systems: &[(String, System)]) -> bool {
    systems
        .iter()
        .all(|(_, system)| system.scene().masses.len() == 1)
}

fn ones() -> Vec<(String, System)> {
    let named = |zeta: f64| (format!("*ζ* = {zeta}"), one_mass(zeta));
    DAMPINGS.map(named).into()
}

fn twos() -> Vec<(String, System)> {
    let named = |zeta: f64| (format!("*ζ_i* = {zeta}/*r*_{{n,*i*}}"), two_masses(zeta));
    DAMPINGS.map(named).into()
}

/// Figure 7.3: responses of one mass.
pub fn one() -> Drawn {
    let betas = [0.0, 0.2, 0.4, 0.6, 0.8];
    let part = (Of::Mass(0), ["*X̄*", "*φ* (degrees)"], (0.02, 1000.0));
    Ok(Figure::new("7.3", "Responses of one damped mass", 2, rows(&ones(), &betas, part)?)
        .with_sketch(with_dashpot())
        .with_keys(strokes(false, true))
        .with_caption(
            "*μ* = 1; amplitudes on a logarithmic axis, amplitude left and phase right for each *ζ*. With modal damping all resonances are finite, and \
             friction lowers them without stops; far from the resonance the damping hardly counts.",
        ))
}

const BETAS: [f64; 6] = [0.0, 0.2, 0.5, 1.0, 1.5, 2.0];

/// Figure 7.5: responses of the lower of two masses.
pub fn lower() -> Drawn {
    let part = (Of::Mass(0), ["*X̄*_1", "*φ*_1 (degrees)"], (0.02, 1000.0));
    Ok(Figure::new("7.5", "Responses of two damped masses, contact on the upper one: the lower mass", 2, rows(&twos(), &BETAS, part)?)
        .with_sketch(drawn(&two_masses(0.1)))
        .with_keys(strokes(true, true))
        .with_caption(
            "Equal masses and springs, *μ* = 1, *r*_{n,1} = 0.618, *r*_{n,2} = 1.618. As *β* grows, the two resonances give way to that of the \
             stuck system at *r*_1 = √2, in black.",
        ))
}

/// Figure 7.6: responses of the upper of two masses.
pub fn upper() -> Drawn {
    let part = (Of::Mass(1), ["*X̄*_2", "*φ*_2 (degrees)"], (0.005, 500.0));
    Ok(Figure::new("7.6", "Responses of two damped masses, contact on the upper one: the upper mass", 2, rows(&twos(), &BETAS, part)?)
        .with_sketch(drawn(&two_masses(0.1)))
        .with_keys(strokes(false, true))
        .with_caption(
            "Equal masses and springs, *μ* = 1, *r*_{n,1} = 0.618, *r*_{n,2} = 1.618. More friction means less motion of the mass in contact, which \
             rests where a curve ends. Phases are of the largest displacement; where the contact stops there, of the beginning of \
             the stop.",
        ))
}

/// Returns a panel with the limits β_lim and β*_lim of each system. If all systems have the same β*_lim, it is drawn
/// once.
fn limits(
    systems: &[(String, System)],
    label: &str,
    top: f64,
    names: [(&str, (f64, f64)); 3],
) -> Result<Panel, Box<dyn Error>> {
    let mut panel = Panel::new(
        "",
        Axis::new(label, 0.0, 2.5),
        Axis::new("friction ratio *β*", 0.0, top),
    );
    panel.height = Some(380.0);
    let one = single(systems);
    for (index, (name, system)) in systems.iter().enumerate() {
        let found = system.limit_lines(0.0, 2.5, 1e-4)?;
        let scales = Scales::groups(system);
        for line in limit_lines(&found, top, &scales, variant_colour(index)) {
            let sliding = line.stroke == Stroke::Dashed;
            if sliding && one {
                if index == 0 {
                    panel = panel.with(Line {
                        name: None,
                        colour: Colour::Black,
                        ..line
                    });
                }
                continue;
            }
            let name = (!sliding).then(|| name.as_str().into());
            panel = panel.with(Line { name, ..line });
        }
    }
    for (name, at) in names {
        panel = panel.with(Note::new(name, at, Anchor::Middle));
    }
    Ok(tidy(panel))
}

fn limit_keys() -> [Key; 2] {
    [
        Key::stroke("*β*_lim, continuous below", Stroke::Solid),
        Key::stroke("*β*_lim^*, stuck state above", Stroke::Dashed),
    ]
}

/// Figure 7.4: regimes of one mass.
pub fn one_regimes() -> Drawn {
    let names = [
        ("continuous", (1.25, 0.3)),
        ("stick-slip", (1.75, 0.8)),
        ("stuck", (1.25, 1.1)),
    ];
    let panel = limits(&ones(), "frequency ratio *r*", 1.2, names)?;
    Ok(Figure::new("7.4", "Motion regimes of one damped mass", 1, vec![panel])
        .with_sketch(with_dashpot())
        .with_keys(limit_keys())
        .with_caption(
            "*μ* = 1. Damping up to *ζ* = 0.01 leaves *β*_lim nearly as it is; *ζ* = 0.1 lowers it at the resonance and smooths it below. No damping \
             changes *β*_lim^* = 1.",
        ))
}

/// Figure 7.7: regimes of two masses.
pub fn two_regimes() -> Drawn {
    let names = [
        ("continuous", (1.15, 0.25)),
        ("stick-slip", (0.2, 0.3)),
        ("stuck", (0.6, 1.8)),
    ];
    let panel = limits(&twos(), RATIO, 4.0, names)?;
    Ok(Figure::new("7.7", "Motion regimes of two damped masses, contact on the upper one", 1, vec![panel])
        .with_sketch(drawn(&two_masses(0.1)))
        .with_keys(limit_keys())
        .with_caption(
            "Equal masses and springs, *μ* = 1. Damping counts at *r*_1 = √2, where the stuck system has its resonance: it makes the limit of \
             sticking finite and the range of motion without stops smaller. Elsewhere the dashed lines of the three lie on each other.",
        ))
}
