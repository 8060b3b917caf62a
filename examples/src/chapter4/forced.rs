//! Figures of transmissibility and phase of the first harmonic: theory, and values identified from recordings.

use crate::{PLATE, drawn, fixed, joined, on_wall};
use frictiongen::System;
use frictiongen_examples::draw::{Responses, beta_colour};
use frictiongen_examples::rig::{Noise, Point, frequencies, one_storey, points};
use frictiongen_plot::desk::{self, Reading};
use frictiongen_plot::{Anchor, Colour, Figure, Key, Marker, Markers, Note, Panel};
use std::error::Error;

const FIXED: [f64; 3] = [0.2, 0.4, 0.6];
const JOINED: [f64; 5] = [0.5, 0.75, 1.0, 1.5, 2.0];
const SIZE: Reading = Reading::Harmonic(0);
const PHASE: Reading = Reading::HarmonicPhase(0);

/// Responses identified from simulated recordings of the rig, one list for each friction ratio.
struct Read(Vec<(f64, Vec<Point>)>);

impl Read {
    fn new(
        disc: &str,
        betas: &[f64],
        (range, step): ((f64, f64), f64),
        seed: u64,
    ) -> Result<Self, Box<dyn Error>> {
        let rig = one_storey(disc, "")?;
        let mut noise = Noise::new(seed);
        let frequencies = frequencies(range, step);
        let each = betas
            .iter()
            .map(|beta| Ok((*beta, points(&rig, *beta, &frequencies, &mut noise)?)));
        Ok(Self(each.collect::<Result<_, Box<dyn Error>>>()?))
    }

    /// Returns circles that mark a quantity of each identified response. Their colour is that of the friction ratio.
    fn circles(&self, of: impl Fn(&Point) -> f64) -> impl Iterator<Item = Markers> {
        self.0.iter().map(move |(beta, points)| {
            let places = points.iter().map(|point| (point.r, of(point)));
            Markers::unnamed(beta_colour(*beta), Marker::Circle, places.collect())
        })
    }
}

/// Returns two panels over the frequency ratio, with transmissibility and phase of the first harmonic in all regimes.
/// Circles show the responses identified from recordings.
fn harmonics(
    responses: &Responses<'_>,
    (top, phases): (f64, (f64, f64)),
    read: &Read,
) -> Vec<Panel> {
    let sizes = ("*X̄*_fft", Some((0.0, top)));
    let mut amplitude = responses.panel("(a) transmissibility", 0, SIZE, sizes);
    let mut phase = responses.panel("(b) phase", 0, PHASE, ("*φ*_fft (degrees)", Some(phases)));
    phase.y = phase.y.degrees();
    amplitude = amplitude.with(responses.limit(0, SIZE));
    phase = phase.with(responses.limit(0, PHASE));
    for circles in read.circles(|point| point.amplitude) {
        amplitude = amplitude.with(circles);
    }
    for circles in read.circles(|point| point.lag) {
        phase = phase.with(circles);
    }
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
    // On a fixed wall the plate is never stuck at these friction ratios.
    let mut regimes = desk::keys();
    if on_wall(system) {
        regimes.truncate(2);
    }
    Figure::new(number, title, columns, panels)
        .with_sketch(drawn(system))
        .with_keys(regimes)
        .with_keys([Key::marker("read from recordings", Marker::Circle)])
        .with_caption(caption)
}

/// Figure 4.7: transmissibility and phase with the disc on the fixed wall.
pub fn fixed_wall() -> Result<Figure, Box<dyn Error>> {
    let system = fixed(1.0);
    let responses = Responses::new(&system, (0.1, 2.5), &FIXED, &[PLATE])?;
    let read = Read::new("wall", &FIXED, ((0.1, 2.5), 0.1), 407)?;
    let panels = harmonics(&responses, (5.0, (-45.0, 190.0)), &read);
    let caption = "Amplitude and lag of the first harmonic, *β* = *F*/(*kY*), *μ* = 1. The lag hardly depends on *r* but \
        much on *β*: it tells the friction from a measured response. Circles are read from synthetic recordings of 60 s at \
        2 kHz, with noise of 40 dB.";
    Ok(finished(
        "4.7",
        "Fixed wall, first harmonic",
        panels,
        &system,
        caption,
    ))
}

/// Figure 4.8: transmissibility and phase with the disc on the fixed wall, at low frequencies.
pub fn fixed_wall_slow() -> Result<Figure, Box<dyn Error>> {
    let system = fixed(1.0);
    let responses = Responses::new(&system, (0.05, 0.7), &FIXED, &[PLATE])?;
    let read = Read::new("wall", &FIXED, ((0.05, 0.7), 0.05), 408)?;
    let mut panels = harmonics(&responses, (2.0, (-15.0, 60.0)), &read);
    panels[0].y.low = 0.4;
    panels[0].x.low = 0.0;
    let caption = "Detail of figure 4.7. Between *r* = 0.334 and 0.605 the first harmonic of motions without stops grows with \
        friction, although the largest displacement falls; with stops it falls. Circles are read from synthetic recordings.";
    Ok(finished(
        "4.8",
        "Fixed wall, first harmonic at low frequency",
        panels,
        &system,
        caption,
    ))
}

/// Figure 4.9: transmissibility and phase with the disc on the moving base.
pub fn joined_wall() -> Result<Figure, Box<dyn Error>> {
    let system = joined();
    let responses = Responses::new(&system, (0.1, 2.5), &JOINED, &[PLATE])?;
    let read = Read::new("base", &JOINED, ((0.1, 2.5), 0.1), 409)?;
    let panels = harmonics(&responses, (5.0, (-15.0, 190.0)), &read);
    let caption = "Amplitude and lag of the first harmonic, *β* = *F*/(*kY*), *μ* = 1. The plate is stuck to its base up to \
        *r* = √*β*; beyond *r* = 1.506 friction increases the motion. Circles are read from synthetic recordings of 60 s at \
        2 kHz, with noise of 40 dB.";
    Ok(finished(
        "4.9",
        "Disc on the moving base, first harmonic",
        panels,
        &system,
        caption,
    ))
}

/// Figure 4.10: the frequencies at which the curves change their order.
pub fn inversion() -> Result<Figure, Box<dyn Error>> {
    let system = joined();
    let responses = Responses::new(&system, (1.3, 1.7), &JOINED, &[PLATE])?;
    let mut panel = responses.panel("", 0, SIZE, ("*X̄*_fft", Some((0.4, 1.4))));
    panel = panel.with(responses.limit(0, SIZE));
    let read = Read::new("base", &JOINED, ((1.3, 1.7), 0.04), 410)?;
    for circles in read.circles(|point| point.amplitude) {
        panel = panel.with(circles);
    }
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
        thesis reads 1.504. The largest displacements (figure 3.7) cross over a range instead. Circles are read from synthetic \
        recordings.";
    let figure = finished(
        "4.10",
        "Where the first harmonics change their order",
        vec![panel],
        &system,
        caption,
    );
    Ok(figure)
}
