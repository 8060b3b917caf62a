//! Figures of three and of two masses, one of which rubs on a fixed wall.

use super::points::invariant;
use super::systems::{M1, M2, motions, three, two};
use frictiongen::System;
use frictiongen_examples::draw::{
    Responses, Row, Times, cycle, drawn, keys, map, over_r1, strokes, tidy, variant_colour,
};
use frictiongen_plot::desk::{Reading, Scales, limit_lines};
use frictiongen_plot::{
    Anchor, Axis, Colour, End, Figure, Line, Marker, Markers, Note, Panel, Sketch, Spring, Stroke,
};
use std::error::Error;
use std::f64::consts::PI;

type Drawn = Result<Figure, Box<dyn Error>>;

/// Colour of the invariant points. Curves do not have this colour.
const MAGENTA: Colour = Colour::Rgb(0xd1, 0x00, 0xa5);

/// Figure 6.1a: sketch of the three masses of section 6.2.
pub fn system_of_three() -> Drawn {
    Ok(Figure::new(
        "6.1a",
        "Three masses, the middle one in contact",
        1,
        Vec::new(),
    )
    .with_sketch(drawn(&three()))
    .with_caption(
        "All masses and springs are equal. The load acts on *m*_1, and *m*_2 rubs on a fixed wall.",
    ))
}

/// Figure 6.1b: sketch of the system that remains of figure 6.1a while the contact is stuck.
pub fn stuck_three() -> Drawn {
    let spring = |between, label: &str| Spring {
        between,
        label: label.into(),
    };
    let sketch = Sketch {
        masses: vec!["*m*_1".into()],
        springs: vec![
            spring((End::Base, End::Mass(0)), "*k*_1"),
            spring((End::Mass(0), End::Wall), "*k*_2"),
        ],
        contact: None,
        ..drawn(&three())
    };
    Ok(Figure::new("6.1b", "The same with the contact stuck", 1, Vec::new())
        .with_sketch(sketch)
        .with_caption(
            "*m*_2 is part of the wall and *m*_3 rests. *m*_1 moves between two springs, with its resonance at *r*_1 = √2.",
        ))
}

/// Figure 6.2: continuous responses and their invariant points.
pub fn invariant_points() -> Drawn {
    let system = three();
    let betas = [0.0, 0.2, 0.4, 0.6, 1.0, 1.5];
    let top = 4.0;
    let responses = Responses::new(&system, (0.1, 2.5), &betas, &[M1])?.continuous();
    let mut panel = over_r1(responses.amplitude("", 0, "*X̄*_1", top));
    panel = panel
        .with(responses.limit(0, Reading::Amplitude))
        .with(responses.stuck(0, Reading::Amplitude));
    panel.height = Some(380.0);
    let places = invariant(&system, M1, (1.2, 2.0));
    let amplitude = |r: &f64| {
        let swing = system.at(*r).ok()?.response(0.0).ok()?.swing(M1)?;
        Some((*r, swing.amplitude))
    };
    let points: Vec<(f64, f64)> = places.iter().filter_map(amplitude).collect();
    let mut said = Vec::new();
    for (index, (r, size)) in points.iter().enumerate() {
        let at = (r + 0.03, size + 0.16);
        let mut note = Note::new(format!("*P*_{}", index + 1), at, Anchor::Start);
        note.colour = MAGENTA;
        panel = panel.with(note);
        said.push(format!("{r:.3}"));
    }
    panel = panel.with(Markers::new(
        "invariant points",
        MAGENTA,
        Marker::Dot,
        points,
    ));
    let panel = tidy(panel);
    Ok(Figure::new("6.2", "Points that friction leaves alone", 1, vec![panel])
        .with_sketch(drawn(&system))
        .with_caption(format!(
            "Amplitude of *m*_1 in motions without stops, all masses and springs equal, *μ* = 1. All curves pass close by \
             *P*_1 and *P*_2, at *r*_1 = {} by (6.10); between them friction makes the motion larger, up to the resonance of \
             the stuck system.",
            said.join(" and "),
        )))
}

/// Figure 6.4: sketch of two masses with load and contact on the lower mass.
pub fn lower_system() -> Drawn {
    Ok(Figure::new(
        "6.4",
        "Two masses, load and contact on the lower one",
        1,
        Vec::new(),
    )
    .with_sketch(drawn(&two(1, 1.0)))
    .with_caption("The system of figures 6.5 to 6.7; *m*_2 is moved by its spring alone."))
}

/// Figure 6.11: sketch of two masses with the load on the lower mass and the contact on the upper one.
pub fn upper_system() -> Drawn {
    Ok(Figure::new(
        "6.11",
        "Two masses, load on the lower one, contact on the upper",
        1,
        Vec::new(),
    )
    .with_sketch(drawn(&two(2, 1.0)))
    .with_caption("The system of figures 6.12 to 6.14. With *m*_2 stuck, *m*_1 moves on."))
}

/// Returns a panel with the motion of both masses over half a cycle, at the frequency ratio and the friction ratio
/// `at`.
fn half_cycle(title: &str, system: &System, at: (f64, f64)) -> Result<Panel, Box<dyn Error>> {
    let times = Times {
        span: (0.0, PI),
        circles: PI / 20.0,
        excitation: true,
    };
    let parts = motions(&["*x̄*_1", "*x̄*_2"]);
    Ok(cycle(title, system, at, &parts, times).ok_or("no motion")?)
}

/// Figure 6.5: motions with load and contact on the lower mass.
pub fn lower_cycles() -> Drawn {
    let systems = [two(1, 1.0), two(1, 1.2)];
    let limit = systems[0].at(0.8)?.limits().continuous;
    let panels = vec![
        half_cycle(
            "(a) *r*_1 = 0.8, *β* = 0.2, *μ* = 1",
            &systems[0],
            (0.8, 0.2),
        )?,
        half_cycle(
            "(b) *r*_1 = 2, *β* = 0.3, *μ* = 1.2",
            &systems[1],
            (2.0, 0.3),
        )?,
    ];
    Ok(Figure::new("6.5", "Half a cycle, load and contact on the lower mass", 2, panels)
        .with_sketch(drawn(&systems[0]))
        .with_keys(keys())
        .with_caption(format!(
            "From a maximum of *m*_1, equal masses and springs. The text of the thesis does not give its parameters; these are \
             two with motion without stops, which at *r*_1 = 0.8 needs *β* below {limit:.2}. Both masses turn at nearly the same \
             time.",
        )))
}

/// Figure 6.12: motions with the contact on the upper mass.
pub fn upper_cycles() -> Drawn {
    let systems = [two(2, 1.0), two(2, 1.2)];
    let panels = vec![
        half_cycle(
            "(a) *r*_1 = 0.8, *β* = 0.4, *μ* = 1",
            &systems[0],
            (0.8, 0.4),
        )?,
        half_cycle(
            "(b) *r*_1 = 1.4, *β* = 0.5, *μ* = 1.2",
            &systems[1],
            (1.4, 0.5),
        )?,
    ];
    Ok(Figure::new("6.12", "Half a cycle, contact on the upper mass", 2, panels)
        .with_sketch(drawn(&systems[0]))
        .with_keys(keys())
        .with_caption(
            "From a maximum of *m*_2, equal masses and springs. The text of the thesis does not give these parameters; they are \
             chosen. *m*_1 turns at another time than *m*_2, which friction holds \
             back.",
        ))
}

/// Returns panels with the amplitudes and the phases of both masses over the frequency ratio.
fn rows(stuck: bool, responses: &Responses<'_>, sizes: [(f64, f64); 2]) -> Vec<Panel> {
    let row = |part, titles, labels| Row {
        part,
        titles,
        labels,
        sizes: sizes[part],
        stuck,
        limit_from: 0.2,
        circles: 0.1,
        harmonic: false,
    };
    let lower = row(
        0,
        ["(a) *m*_1, amplitude", "(a) *m*_1, phase"],
        ["*X̄*_1", "*φ*_1 (degrees)"],
    );
    let upper = row(
        1,
        ["(b) *m*_2, amplitude", "(b) *m*_2, phase"],
        ["*X̄*_2", "*φ*_2 (degrees)"],
    );
    let [lower, upper] = [lower.panels(responses), upper.panels(responses)];
    lower.into_iter().chain(upper).collect()
}

/// Figure 6.6: responses with load and contact on the lower mass.
pub fn lower_responses() -> Drawn {
    let system = two(1, 1.0);
    let betas = [0.0, 0.2, 0.4, 0.6, 0.8];
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &betas, &[M1, M2])?;
    let panels = rows(false, &responses, [(0.01, 20.0); 2]);
    Ok(Figure::new("6.6", "Responses, load and contact on the lower mass", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(false, true))
        .with_caption(
            "Equal masses and springs, *μ* = 1. Only for *β* = 0.8, above π/4, both resonances are finite; the contact stops \
             at low frequency and around *r*_1 = 1, where *m*_2 holds *m*_1 at rest. There the amplitude of *m*_2 tends to √(1 − *β*^2). \
             *m*_2 moves with *m*_1 below *r*_1 = 1 and against it above.",
        ))
}

/// Figure 6.13: responses with the contact on the upper mass.
pub fn upper_responses() -> Drawn {
    let system = two(2, 1.0);
    let betas = [0.0, 0.2, 0.4, 0.5, 1.0, 1.5, 2.0, 5.0];
    let responses = Responses::up_to(1e4, 5e-4, &system, (0.1, 2.5), &betas, &[M1, M2])?;
    let panels = rows(true, &responses, [(0.0, 8.0), (0.0, 5.0)]);
    Ok(Figure::new("6.13", "Responses, load on the lower mass, contact on the upper", 2, panels)
        .with_sketch(drawn(&system))
        .with_keys(strokes(true, true))
        .with_caption(
            "Equal masses and springs, *μ* = 1. The resonances become finite from *β* = 0.485 and *β* = 1.271 on. Between \
             *r*_1 = 0.83 and 1.55 more friction means more motion of *m*_1, up to the resonance of the stuck system at √2. Phases are \
             of the largest displacement; where the contact stops there, of the beginning of the stop.",
        ))
}

/// Returns four panels: the regimes for each of three values of μ, and the limits for all three values.
fn regimes(contact: usize, top: f64) -> Result<Vec<Panel>, Box<dyn Error>> {
    let stictions = [1.0, 1.2, 1.5];
    let mut panels = Vec::new();
    let mut lines = Vec::new();
    for (index, (stiction, letter)) in stictions.iter().zip(["a", "b", "c"]).enumerate() {
        let system = two(contact, *stiction);
        panels.push(map(&format!("({letter}) *μ* = {stiction}"), &system, top)?);
        let limits = system.limit_lines(0.0, 2.5, 1e-4)?;
        let scales = Scales::groups(&system);
        let colour = variant_colour(index);
        for line in limit_lines(&limits, top, &scales, colour) {
            let solid = line.stroke == Stroke::Solid;
            let name = solid.then(|| format!("*μ* = {stiction}").into());
            lines.push(Line { name, ..line });
        }
    }
    let mut all = Panel::new(
        "(d) all limits",
        Axis::new("", 0.0, 2.5),
        Axis::new("friction ratio *β*", 0.0, top),
    );
    all.layers.extend(lines.into_iter().map(Into::into));
    panels.push(tidy(over_r1(all)));
    Ok(panels)
}

/// Figure 6.7: regimes with load and contact on the lower mass.
pub fn lower_regimes() -> Drawn {
    Ok(Figure::new("6.7", "Motion regimes, load and contact on the lower mass", 2, regimes(1, 1.2)?)
        .with_sketch(drawn(&two(1, 1.0)))
        .with_caption(
            "Equal masses and springs. Stiction *μ* lowers the limit of sticking to 1/*μ*, below the other one in places: in these wedges \
             the contact may slide all the time or be stuck, as it starts, and the thesis draws them as stuck. At \
             *r*_1 = 1, where *m*_2 holds *m*_1 at rest, any friction stops the contact.",
        ))
}

/// Figure 6.14: regimes with the contact on the upper mass.
pub fn upper_regimes() -> Drawn {
    Ok(Figure::new("6.14", "Motion regimes, load on the lower mass, contact on the upper", 2, regimes(2, 3.0)?)
        .with_sketch(drawn(&two(2, 1.0)))
        .with_caption(
            "Equal masses and springs. Beside *r*_1 = √2, the resonance of the stuck system, no friction keeps the contact \
             at rest; both limits go to zero at high frequency. In the wedges of *μ* > 1 the contact may slide all the time or be \
             stuck, as it starts; the thesis draws them as stuck.",
        ))
}
