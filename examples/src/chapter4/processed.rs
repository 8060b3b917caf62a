//! Draws figure 4.6: spectra of a recording, with and without a window, and with and without zero padding.

use crate::{drawn, fixed};
use frictiongen::Complex;
use frictiongen::measure::Measured;
use frictiongen_examples::draw::part_colour;
use frictiongen_examples::rig::{NATURAL, Noise, Y, one_storey, recording};
use frictiongen_plot::{Axis, Colour, Figure, Line, Marker, Markers, Panel, Point, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

const R: f64 = 0.85;
const BETA: f64 = 0.2;
/// Sampling rate of the recording, in Hz. It is low, so that the width of a spectral line is visible.
const RATE: f64 = 100.0;
const SECONDS: f64 = 6.0;
/// Length of the recording after zero padding, divided by its length before.
const PADDED: usize = 4;
/// Highest frequency of the spectra, in Hz.
const HIGHEST: f64 = 12.0;
/// Range of the levels that the figure shows, in dB.
const LEVELS: (f64, f64) = (-80.0, 20.0);

/// One way to compute a spectrum: with or without a window and zero padding.
struct Way {
    titles: [&'static str; 2],
    windowed: bool,
    padding: usize,
}

/// Returns the samples multiplied by the Hann window if `windowed` is true, and otherwise the samples.
fn weighed(samples: &[f64], windowed: bool) -> Vec<f64> {
    let count = samples.len() as f64;
    let weight = |t: usize| {
        if windowed {
            0.5 - 0.5 * (TAU * (t as f64 + 1.0) / (count + 1.0)).cos()
        } else {
            1.0
        }
    };
    let each = samples.iter().enumerate();
    each.map(|(t, x)| weight(t) * x).collect()
}

/// Returns the level of a spectrum at a frequency in Hz, in dB relative to `unit`. The amplitude of a pure tone is
/// twice its Fourier sum divided by `whole`, the sum of the window's weights.
fn level(samples: &[f64], hertz: f64, whole: f64, unit: f64) -> f64 {
    let turn = Complex::from_polar(1.0, -TAU * hertz / RATE);
    let mut power = Complex::new(1.0, 0.0);
    let mut sum = Complex::new(0.0, 0.0);
    for x in samples {
        sum += power * x;
        power *= turn;
    }
    20.0 * (2.0 * sum.norm() / (whole * unit)).log10()
}

/// Figure 4.6: spectra of one recording with and without window and zero padding.
pub fn spectra() -> Result<Figure, Box<dyn Error>> {
    let rig = one_storey("wall", "")?;
    let recording = recording(
        &rig,
        (R * NATURAL, BETA),
        (RATE, SECONDS),
        &mut Noise::new(406),
    )?;
    let measured = Measured::of(&recording, rig.scene())?;
    let found = measured.transmissibility(0).ok_or("not recorded")?;
    let unit = 1e3 * Y;
    let base = measured.drive_amplitude() / Y;
    let read = |size: f64| 20.0 * (size * base).log10();
    let ways = [
        Way {
            titles: ["(a) recorded", "its spectrum"],
            windowed: false,
            padding: 1,
        },
        Way {
            titles: ["(b) under a Hann window", "its spectrum"],
            windowed: true,
            padding: 1,
        },
        Way {
            titles: ["(c) and with zeros", "its spectrum"],
            windowed: true,
            padding: PADDED,
        },
    ];
    let mut panels = Vec::new();
    for way in ways {
        let whole: f64 = weighed(&vec![1.0; recording.len()], way.windowed)
            .iter()
            .sum();
        let end = SECONDS * way.padding as f64;
        let time = Axis::new("time (s)", 0.0, end);
        let mut motion = Panel::new(
            way.titles[0],
            time,
            Axis::new("displacement/*Y*", -4.0, 4.0),
        );
        let x = Axis::new("frequency (Hz)", 0.0, HIGHEST);
        let y = Axis::new("level (dB)", LEVELS.0, LEVELS.1);
        let mut spectrum = Panel::new(way.titles[1], x, y);
        for (channel, name) in recording.channels().iter().zip(["base *y*", "plate *x*"]) {
            let colour = if channel.name == "base" {
                Colour::Black
            } else {
                part_colour(0)
            };
            let samples = weighed(&channel.samples, way.windowed);
            let mut points: Vec<Point> = samples
                .iter()
                .enumerate()
                .map(|(t, x)| (t as f64 / RATE, x / unit))
                .collect();
            if 1 < way.padding {
                points.extend([(SECONDS, 0.0), (end, 0.0)]);
            }
            let step = 1.0 / end;
            let bins = (1..).map(|bin: u32| f64::from(bin) * step);
            let bins = bins.take_while(|hertz| *hertz <= HIGHEST);
            let levels = bins.map(|hertz| (hertz, level(&samples, hertz, whole, unit)));
            motion = motion.with(Line::new(name, colour, Stroke::Solid, vec![points]));
            let levels = vec![levels.collect()];
            spectrum = spectrum.with(Line::new(name, colour, Stroke::Solid, levels));
        }
        let marks = [1.0, found.amplitude()].map(|size| (measured.hertz, read(size)));
        spectrum = spectrum.with(Markers::new(
            "read",
            Colour::Black,
            Marker::Circle,
            marks.into(),
        ));
        panels.extend([motion, spectrum]);
    }
    Ok(Figure::new("4.6", "A recording before and after it is processed", 2, panels)
        .with_sketch(drawn(&fixed(1.0)))
        .with_caption(format!(
            "Synthetic, *r* = {R}, *β* = {BETA}, {SECONDS} s at {RATE} Hz with noise of 40 dB; levels over the motion *Y* of the base. A part of a \
             cycle too many spreads each line over the spectrum; the window holds it together, and zeros fill in between the lines. Read are \
             {:.4} Hz, *X̄*_fft = {:.4} and *φ*_fft = {:.2}°. Unlike that of the thesis, this base has no harmonics of its own; those of \
             the plate are friction's.",
            measured.hertz,
            found.amplitude(),
            found.lag().to_degrees(),
        )))
}
