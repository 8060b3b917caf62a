//! Draws figures of the rig of section 6.4: the support of its disc, and the tests that give its parameters (6.4.2,
//! appendix A).

use super::systems::{M1, rig};
use frictiongen::measure::{Measured, SweepFit, SweepPoint};
use frictiongen::{Complex, Of, System};
use frictiongen_examples::draw::{drawn, part_colour, tidy};
use frictiongen_examples::rig::{
    LENGTH, Noise, STOREYS, two_storeys, without_friction as recorded,
};
use frictiongen_plot::{
    Across, Anchor, Axis, Figure, Guide, Key, Line, Marker, Markers, Note, Panel, Sketch, Stroke,
};
use std::error::Error;

type Drawn = Result<Figure, Box<dyn Error>>;

const GAMMA: f64 = STOREYS[0];
const KAPPA: f64 = STOREYS[1];
/// The frequency ratio r₁ at a frequency of 1 Hz.
const SECONDS: f64 = STOREYS[2];

fn configuration(number: &str, title: &str, contact: &str, caption: &str) -> Figure {
    Figure::new(number, title, 1, Vec::new())
        .with_sketch(drawn(&rig(contact)))
        .with_caption(caption)
}

/// Figure 6.18a: sketch of the rig with its disc on the lower plate.
pub fn disc_on_the_lower() -> Drawn {
    let caption = "Two storeys on a base that moves; a counterweight pinned to the external frame presses a disc on the lower plate.";
    Ok(configuration(
        "6.18a",
        "Contact of the lower plate",
        "m1 - wall",
        caption,
    ))
}

/// Figure 6.18b: sketch of the rig with its disc on the upper plate.
pub fn disc_on_the_upper() -> Drawn {
    let caption = "The same with the disc on the upper plate.";
    Ok(configuration(
        "6.18b",
        "Contact of the upper plate",
        "m2 - wall",
        caption,
    ))
}

/// A driving frequency in Hz, the complex transmissibility X₁/Y at that frequency, and its standard deviation.
type Point = (f64, Complex<f64>, f64);

/// Identifies the transmissibility X₁/Y of the lower plate from simulated recordings without friction.
fn read() -> Result<Vec<Point>, Box<dyn Error>> {
    let rig = two_storeys()?;
    let mut noise = Noise::new(619);
    let mut points = Vec::new();
    for i in 2..=32 {
        let recording = recorded(&rig, 0.25 * f64::from(i), LENGTH, &mut noise)?;
        let measured = Measured::of(&recording, rig.scene())?;
        let found = measured.transmissibility(0).ok_or("not recorded")?;
        points.push((measured.hertz, found.value, found.deviation));
    }
    Ok(points)
}

/// Fits the parameters of the rig to the amplitudes of the lower plate. The fit starts from two equal storeys.
fn fitted(points: &[Point]) -> Result<SweepFit, Box<dyn Error>> {
    let guess: System = "struct Storeys {
        masses: { m1: 3.0, m2: 3.0 }, springs: { base - m1: 1000.0, m1 - m2: 1000.0 }, contact: m1 - wall, excitation: base,
    }"
    .parse()?;
    let sweep: Vec<SweepPoint> = points
        .iter()
        .map(|(hertz, value, deviation)| SweepPoint {
            hertz: *hertz,
            mass: 0,
            amplitude: value.norm(),
            deviation: Some(*deviation),
        })
        .collect();
    Ok(guess.fit_sweep(&sweep, false)?)
}

/// Figure 6.19: responses without friction, recorded and fitted.
pub fn without_friction() -> Drawn {
    let points = read()?;
    let found = fitted(&points)?;
    let system = rig("m1 - base");
    let parts = [
        ("*X̄*_1, lower mass", M1),
        ("*Z̄*, lower mass and base", Of::Contact),
    ];
    let mut panel = Panel::new(
        "",
        Axis::new("frequency (Hz)", 0.0, 8.0),
        Axis::log("amplitude over *Y*", 1e-3, 1e3),
    );
    let antiresonance = (KAPPA / GAMMA).sqrt();
    let relative = (KAPPA * (1.0 + GAMMA) / GAMMA).sqrt();
    let resonances = system.resonances();
    let [first, second] = [0, 1].map(|i| resonances.get(i).copied().unwrap_or(f64::NAN));
    let guides = [
        ("*f*_1", first),
        ("*f*_0", antiresonance),
        ("*f*_{*z*0}", relative),
        ("*f*_2", second),
    ];
    for (name, r) in guides {
        let hertz = r / SECONDS;
        panel = panel.with(Guide::new(Across::X(hertz))).with(Note::new(
            name,
            (hertz + 0.06, 350.0),
            Anchor::Start,
        ));
    }
    for (index, (name, of)) in parts.into_iter().enumerate() {
        let stroke = if index == 0 {
            Stroke::Solid
        } else {
            Stroke::Dashed
        };
        let pieces = undamped(&system, of, &guides.map(|guide| guide.1));
        panel = panel.with(Line::new(name, part_colour(index), stroke, pieces));
        // The relative motion of the lower plate is z = x₁ − y, with the motion y of the base (A.12).
        let base = Complex::new(f64::from(index as u32), 0.0);
        let circles = points
            .iter()
            .map(|(hertz, value, _)| (*hertz, (value - base).norm()));
        let circles = circles.collect();
        panel = panel.with(Markers::unnamed(
            part_colour(index),
            Marker::Circle,
            circles,
        ));
    }
    let said = guides.map(|(name, r)| format!("{name} = {:.2} Hz", r / SECONDS));
    let sketch = Sketch {
        contact: None,
        ..drawn(&system)
    };
    let (gamma, kappa) = (found.masses.first(), found.springs.first());
    let (gamma, kappa) = gamma.zip(kappa).ok_or("no ratios")?;
    let reference = found.reference;
    Ok(Figure::new("6.19", "The rig without friction", 1, vec![tidy(panel)])
        .with_sketch(sketch)
        .with_keys([Key::marker("read from recordings", Marker::Circle)])
        .with_caption(format!(
            "Theory for *γ* = 0.9772, *κ* = 1.1119, *r*_1 = 0.3419 s × frequency in Hz, and synthetic recordings of 60 s at 2 kHz with \
             noise of 40 dB. Two resonances and two antiresonances, of the lower mass and of its motion relative to the base, give \
             all three parameters: {}. A fit of the amplitudes of the lower mass gives *γ* = {:.5} (95 % from {:.5} to {:.5}), \
             *κ* = {:.5} ({:.5} to {:.5}) and *r*_1 = {:.6} s × frequency.",
            said.join(", "),
            gamma.value,
            gamma.from,
            gamma.to,
            kappa.value,
            kappa.from,
            kappa.to,
            1.0 / reference.value,
        )))
}

/// Returns the amplitude without friction over the frequency ratio, as several lines. The lines end at the zeros and
/// poles in `marks`.
fn undamped(system: &System, of: Of, marks: &[f64]) -> Vec<Vec<(f64, f64)>> {
    let steps = 800;
    let width = 8.0 * SECONDS;
    let mut ends: Vec<f64> = marks.iter().copied().chain([0.0, width]).collect();
    ends.sort_by(f64::total_cmp);
    let mut pieces = Vec::new();
    for pair in ends.windows(2) {
        let &[from, to] = pair else { continue };
        // The points of a line are denser near its ends.
        let place = |i: u32| {
            let share = f64::from(i) / f64::from(steps);
            from + (to - from) * 0.5 * (1.0 + (6.0 * (2.0 * share - 1.0)).tanh() / 6.0_f64.tanh())
        };
        let read = |r: f64| {
            let swing = system.at(r).ok()?.response(0.0).ok()?.swing(of)?;
            (0.0 < swing.amplitude).then_some((r / SECONDS, swing.amplitude))
        };
        pieces.push((1..steps).filter_map(|i| read(place(i))).collect());
    }
    pieces
}
