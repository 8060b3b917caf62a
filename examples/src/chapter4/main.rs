//! Chapter 4: the theory of the one-storey rig, by the first harmonic.
//! `cargo run --release --example chapter4`

mod times;

use frictiongen::study::scene::Node;
use frictiongen::{Of, System};
use frictiongen_examples::album::Album;
use frictiongen_examples::draw::{Responses, block, part_colour, save, system};
use frictiongen_plot::desk::{self, Reading, Scales, sketch};
use frictiongen_plot::{
    Anchor, Axis, Colour, Figure, Key, Line, Marker, Markers, Note, Panel, Sketch, Stroke,
};
use std::error::Error;
use std::f64::consts::TAU;

const PLATE: Of = Of::Mass(0);
const FIXED: [f64; 3] = [0.2, 0.4, 0.6];
const JOINED: [f64; 5] = [0.5, 0.75, 1.0, 1.5, 2.0];
const SIZE: Reading = Reading::Harmonic(0);
const PHASE: Reading = Reading::HarmonicPhase(0);
/// The natural frequency of the rig, Hz.
const NATURAL: f64 = 3.086;

/// The plate rubs on a disc that stands still.
fn fixed(stiction: f64) -> System {
    block("wall", "base", &format!("stiction: {stiction:?},"))
}

/// The disc moves with the base.
fn joined() -> System {
    block("base", "base", "")
}

fn drawn(system: &System) -> Sketch {
    sketch(system.scene(), false)
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut album = Album::of_chapter(4, "The one-storey rig, theory", 7)?;
    for figure in [
        frictionless,
        fixed_wall,
        fixed_wall_slow,
        joined_wall,
        inversion,
        times::motions,
        times::spectra,
    ] {
        save(&figure()?, &mut album)?;
    }
    album.close()
}

/// 4.3: the rig without friction, over the frequency in Hz.
fn frictionless() -> Result<Figure, Box<dyn Error>> {
    let omega = TAU * NATURAL;
    let rig = system(&format!(
        "struct Rig {{ masses: {{ plate: 1.0 }}, springs: {{ base - plate: {:?} }}, contact: plate - wall, excitation: base }}",
        omega * omega
    ));
    let responses = Responses::new(&rig, (0.02, 8.0 / NATURAL), &[0.0], &[PLATE])?;
    let scales = Scales::groups(&rig).in_hertz(&rig);
    let x = Axis::new(scales.frequency_label(), 0.0, 8.0);
    let mut panel = Panel::new("", x, Axis::new("*X̄*_fft", 0.0, 10.0));
    for curve in responses.curves() {
        let drawn = desk::Drawn {
            curve,
            name: "1/|1 − *r*^2|".into(),
            colour: part_colour(0),
        };
        panel.layers.extend(desk::lines(&drawn, 0, SIZE, &scales));
    }
    let resonance = vec![vec![(NATURAL, 0.0), (NATURAL, 10.0)]];
    let panel = panel.with(Line::new(
        "natural frequency",
        Colour::Black,
        Stroke::Dashed,
        resonance,
    ));
    let mut drawn = drawn(&rig);
    drawn.contact = None;
    Ok(Figure::new("4.3", "The rig without friction", 1, vec![panel])
        .with_sketch(drawn)
        .with_caption(
            "Displacement transmissibility of one mass on a spring with a natural frequency of 3.086 Hz, with which the \
             thesis compares its measured points.",
        ))
}

/// Transmissibility and phase by the first harmonic, in all regimes.
fn harmonics(
    responses: &Responses<'_>,
    (top, phases): (f64, (f64, f64)),
    circles: f64,
) -> Vec<Panel> {
    let sizes = ("*X̄*_fft", Some((0.0, top)));
    let mut amplitude = responses.panel("(a) transmissibility", 0, SIZE, sizes);
    let mut phase = responses.panel("(b) phase", 0, PHASE, ("*φ*_fft (degrees)", Some(phases)));
    phase.y = phase.y.degrees();
    amplitude.layers.push(responses.limit(0, SIZE).into());
    phase.layers.push(responses.limit(0, PHASE).into());
    amplitude
        .layers
        .extend(responses.simulation(circles, 0, SIZE));
    phase.layers.extend(responses.simulation(circles, 0, PHASE));
    vec![amplitude, phase]
}

fn finished(
    number: &str,
    title: &str,
    panels: Vec<Panel>,
    system: &System,
    caption: &str,
) -> Figure {
    let columns = panels.len();
    // On a fixed wall nothing is stuck at these β.
    let mut regimes = desk::keys();
    if system.scene().contact.to == Node::Wall {
        regimes.truncate(2);
    }
    Figure::new(number, title, columns, panels)
        .with_sketch(drawn(system))
        .with_keys(regimes)
        .with_keys([Key::marker("simulation from rest", Marker::Circle)])
        .with_caption(caption)
}

/// 4.7: fixed wall.
fn fixed_wall() -> Result<Figure, Box<dyn Error>> {
    let system = fixed(1.0);
    let responses = Responses::new(&system, (0.1, 2.5), &FIXED, &[PLATE])?;
    let panels = harmonics(&responses, (5.0, (-45.0, 190.0)), 0.1);
    let caption = "Amplitude and lag of the first harmonic, *β* = *F*/(*kY*), *μ* = 1. The lag hardly depends on *r* but \
        much on *β*: it tells the friction from a measured response. Circles are the first harmonic of a simulation.";
    Ok(finished(
        "4.7",
        "Fixed wall, first harmonic",
        panels,
        &system,
        caption,
    ))
}

/// 4.8: the same at low frequencies.
fn fixed_wall_slow() -> Result<Figure, Box<dyn Error>> {
    let system = fixed(1.0);
    let responses = Responses::new(&system, (0.05, 0.7), &FIXED, &[PLATE])?;
    let mut panels = harmonics(&responses, (2.0, (-15.0, 60.0)), 0.05);
    panels[0].y.low = 0.4;
    panels[0].x.low = 0.0;
    let caption = "Detail of figure 4.7. Between *r* = 0.334 and 0.605 the first harmonic of motions without stops grows with \
        friction, although the largest displacement falls; with stops it falls.";
    Ok(finished(
        "4.8",
        "Fixed wall, first harmonic at low frequency",
        panels,
        &system,
        caption,
    ))
}

/// 4.9: wall on the base.
fn joined_wall() -> Result<Figure, Box<dyn Error>> {
    let system = joined();
    let responses = Responses::new(&system, (0.1, 2.5), &JOINED, &[PLATE])?;
    let panels = harmonics(&responses, (5.0, (-15.0, 190.0)), 0.1);
    let caption = "Amplitude and lag of the first harmonic, *β* = *F*/(*kY*), *μ* = 1. The plate is stuck to its base up to \
        *r* = √*β*; beyond *r* = 1.506 friction increases the motion.";
    Ok(finished(
        "4.9",
        "Disc on the moving base, first harmonic",
        panels,
        &system,
        caption,
    ))
}

/// 4.10: where the curves change their order.
fn inversion() -> Result<Figure, Box<dyn Error>> {
    let system = joined();
    let responses = Responses::new(&system, (1.3, 1.7), &JOINED, &[PLATE])?;
    let mut panel = responses.panel("", 0, SIZE, ("*X̄*_fft", Some((0.4, 1.4))));
    panel.layers.push(responses.limit(0, SIZE).into());
    panel.layers.extend(responses.simulation(0.025, 0, SIZE));
    let at = 1.506_310;
    let size = 1.0 / (at * at - 1.0);
    let place = responses.curves().first().and_then(|curve| {
        let points = curve.pieces.iter().flat_map(|piece| &piece.points);
        let nearest = points.min_by(|a, b| (a.r - at).abs().total_cmp(&(b.r - at).abs()))?;
        let x = nearest.movements.first()?.harmonics.first()?;
        Some(x.re.hypot(x.im))
    });
    let panel = panel
        .with(Markers::unnamed(
            Colour::Black,
            Marker::Dot,
            vec![(at, place.unwrap_or(size))],
        ))
        .with(Note::new(
            "*r* = 1.5063",
            (at + 0.01, place.unwrap_or(size) + 0.05),
            Anchor::Start,
        ));
    let caption = "Detail of figure 4.9. The first harmonics are the same for every *β* at one frequency, *r* = 1.5063; the \
        thesis reads 1.504. The largest displacements (figure 3.7) cross over a range instead.";
    let figure = finished(
        "4.10",
        "Where the first harmonics change their order",
        vec![panel],
        &system,
        caption,
    );
    Ok(figure)
}
