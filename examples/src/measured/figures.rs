//! Figures 4.3, 4.4, 4.7 and 6.19 in method: markers are read from recordings, lines are the theory.

use crate::recordings::two_storeys;
use frictiongen::measure::{
    Channel, IdentifyRequest, Measured, Observation, Recording, SweepPoint, Unit,
};
use frictiongen::{Complex, Of, System};
use frictiongen_examples::rig::{NATURAL, Noise, Y, decay, one_storey as rig, recording};
use frictiongen_plot::{Axis, Colour, Figure, Line, Marker, Markers, Panel, Stroke};
use std::error::Error;
use std::path::Path;

const BETAS: [f64; 3] = [0.2, 0.4, 0.6];
const COLOURS: [Colour; 3] = [Colour::Series(0), Colour::Series(1), Colour::Series(2)];

pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    for (name, figure) in [
        ("figure-4.3", one_storey()?),
        ("figure-4.4", free_decay()?),
        ("figure-4.7", forced()?),
        ("figure-6.19", storeys()?),
    ] {
        std::fs::write(folder.join(format!("{name}.svg")), figure.svg())?;
    }
    Ok(())
}

/// 4.3: the natural frequency from a sweep without friction.
fn one_storey() -> Result<Figure, Box<dyn Error>> {
    let system = rig("wall", "")?;
    let mut noise = Noise::new(43);
    let mut points = Vec::new();
    for i in 2..=16 {
        let hertz = 0.5 * f64::from(i);
        let size = 1.0 / (1.0 - (hertz / NATURAL).powi(2)).abs();
        let amplitude = size * (1.0 + 0.01 * noise.draw());
        points.push(SweepPoint {
            hertz,
            mass: 0,
            amplitude,
            deviation: Some(0.01 * size),
        });
    }
    let fit = system.fit_sweep(&points, false)?;
    let theory = |hertz: f64| 1.0 / (1.0 - (hertz / fit.reference.value).powi(2)).abs();
    let panel = swept(("*X̄*_fft", 10.0), "fitted (4.1)", theory, &points);
    Ok(Figure::new("4.3", "The natural frequency from a sweep", 1, vec![panel]).with_caption(format!(
        "Synthetic amplitudes with errors of 1 %: f_n = {:.4} Hz, 95 % from {:.4} to {:.4}.",
        fit.reference.value, fit.reference.from, fit.reference.to
    )))
}

/// Points of a curve, broken where it leaves the frame.
fn curve(end: f64, of: impl Fn(f64) -> f64, top: f64) -> Vec<Vec<(f64, f64)>> {
    let mut pieces = vec![Vec::new()];
    for i in 1..=1600 {
        let x = end * f64::from(i) / 1600.0;
        let y = of(x);
        if y <= 2.0 * top {
            if let Some(piece) = pieces.last_mut() {
                piece.push((x, y));
            }
        } else if pieces.last().is_some_and(|piece| !piece.is_empty()) {
            pieces.push(Vec::new());
        }
    }
    pieces
}

/// 4.4: friction from a free decay.
fn free_decay() -> Result<Figure, Box<dyn Error>> {
    let mut noise = Noise::new(44);
    let samples = decay(0.7, 1000.0, 4.0, &mut noise);
    let points: Vec<(f64, f64)> = samples
        .iter()
        .enumerate()
        .map(|(i, x)| (i as f64 / 1000.0, *x))
        .collect();
    let channel = Channel {
        name: "plate".to_owned(),
        unit: Unit::MILLIMETRE,
        samples,
    };
    let found = rig("wall", "")?.free_decay(&Recording::new(1000.0, vec![channel])?, None)?;
    let marks = found.extremes.iter().map(|(t, x)| (*t, 1e3 * x)).collect();
    let panel = Panel::new(
        "",
        Axis::new("time (s)", 0.0, 4.0),
        Axis::new("displacement (mm)", -20.0, 21.0),
    )
    .with(Line::new(
        "measured",
        COLOURS[0],
        Stroke::Solid,
        vec![points],
    ))
    .with(Markers::new(
        "extremes",
        Colour::Black,
        Marker::Circle,
        marks,
    ));
    Ok(Figure::new("4.4", "Friction from a free decay", 1, vec![panel]).with_caption(format!(
        "Synthetic, true β = 0.4: F/k falls out as {:.4} mm, 95 % from {:.4} to {:.4}; β = {:.4} by (4.3).",
        1e3 * found.length.value,
        1e3 * found.length.from,
        1e3 * found.length.to,
        found.friction_ratio(Y)
    )))
}

fn fundamental(system: &System, r: f64, beta: f64) -> Option<Complex<f64>> {
    system
        .at(r)
        .ok()?
        .response(beta)
        .ok()?
        .harmonic(Of::Mass(0), 1)
}

/// 4.7: transmissibility and phase from recordings, and the friction that they tell.
fn forced() -> Result<Figure, Box<dyn Error>> {
    let system = rig("wall", "")?;
    let mut noise = Noise::new(47);
    let x = || Axis::new("*r*", 0.0, 2.5);
    let mut sizes = Panel::new("(a) transmissibility", x(), Axis::new("*X̄*_fft", 0.0, 5.0));
    let mut phases = Panel::new(
        "(b) phase",
        x(),
        Axis::new("*φ*_fft (degrees)", -30.0, 190.0),
    );
    let mut said = Vec::new();
    for (beta, colour) in BETAS.into_iter().zip(COLOURS) {
        let lag = |value: Complex<f64>| -value.im.atan2(value.re).to_degrees();
        let size =
            |r: f64| fundamental(&system, r, beta).map_or(f64::INFINITY, |value| value.norm());
        let phase = |r: f64| fundamental(&system, r, beta).map_or(f64::INFINITY, lag);
        let name = format!("*β* = {beta}");
        sizes = sizes.with(Line::new(
            name.as_str(),
            colour,
            Stroke::Solid,
            curve(2.5, size, 5.0),
        ));
        phases = phases.with(Line::unnamed(
            colour,
            Stroke::Solid,
            curve(2.5, phase, 190.0),
        ));
        let (mut amplitudes, mut lags, mut seen) = (Vec::new(), Vec::new(), Vec::new());
        for r in [0.3, 0.6, 0.8, 0.95, 1.15, 1.5, 2.0, 2.4] {
            let recording = recording(&system, (r * NATURAL, beta), (200.0, 20.0), &mut noise)?;
            let measured = Measured::of(&recording, system.scene())?;
            let found = measured.transmissibility(0).ok_or("not recorded")?;
            amplitudes.push((r, found.amplitude()));
            lags.push((r, found.lag().to_degrees()));
            seen.push(Observation::of(&measured, &system, 1));
        }
        let found = system.identify(&seen, &IdentifyRequest::default())?;
        let force = system.scene().springs[0].stiffness * Y;
        said.push(format!(
            "{:.4} ± {:.4} for {beta}",
            found.friction.value / force,
            (found.friction.to - found.friction.value) / force
        ));
        sizes = sizes.with(Markers::unnamed(colour, Marker::Circle, amplitudes));
        phases = phases.with(Markers::unnamed(colour, Marker::Circle, lags));
    }
    Ok(Figure::new("4.7", "Fixed wall: recordings and theory", 2, vec![sizes, phases]).with_caption(format!(
        "Circles are read from synthetic recordings of 20 s at 200 Hz with noise of 40 dB. The friction that all eight tell together: {}.",
        said.join(", ")
    )))
}

/// 6.19: three parameters from a sweep of the lower mass.
fn storeys() -> Result<Figure, Box<dyn Error>> {
    let guess: System = "struct Storeys {
        masses: { m1: 3.0, m2: 3.0 }, springs: { base - m1: 1000.0, m1 - m2: 1000.0 }, contact: m1 - wall, excitation: base,
    }"
    .parse()?;
    let mut noise = Noise::new(619);
    let mut points = Vec::new();
    for i in 1..=26 {
        let hertz = 0.3 * f64::from(i);
        let size = two_storeys(hertz).abs();
        points.push(SweepPoint {
            hertz,
            mass: 0,
            amplitude: size * (1.0 + 0.01 * noise.draw()),
            deviation: Some(0.01 * size),
        });
    }
    let fit = guess.fit_sweep(&points, false)?;
    let theory = |hertz: f64| {
        let r = fit.system.frequency_ratio_at_hertz(hertz);
        fundamental(&fit.system, r, 0.0).map_or(f64::INFINITY, |value| value.norm())
    };
    let panel = swept(("*X̄*_{1,fft}", 6.0), "fitted (6.15)", theory, &points);
    let (gamma, kappa) = (fit.masses[0], fit.springs[0]);
    Ok(Figure::new("6.19", "Two storeys from a sweep of the lower one", 1, vec![panel]).with_caption(format!(
        "Synthetic amplitudes with errors of 1 %: r_1 = {:.4} s × f, γ = {:.4} ({:.4} to {:.4}), κ = {:.4} ({:.4} to {:.4}); true are 0.3419 s, 0.9772 and 1.1119.",
        1.0 / fit.reference.value, gamma.value, gamma.from, gamma.to, kappa.value, kappa.from, kappa.to
    )))
}

/// A sweep up to 8 Hz, and what was fitted to it.
fn swept(
    (label, high): (&str, f64),
    name: &str,
    theory: impl Fn(f64) -> f64,
    points: &[SweepPoint],
) -> Panel {
    let fitted = curve(8.0, theory, high);
    let marks = points.iter().map(|point| (point.hertz, point.amplitude));
    Panel::new(
        "",
        Axis::new("frequency (Hz)", 0.0, 8.0),
        Axis::new(label, 0.0, high),
    )
    .with(Line::new(name, COLOURS[0], Stroke::Solid, fitted))
    .with(Markers::new(
        "measured",
        Colour::Black,
        Marker::Circle,
        marks.collect(),
    ))
}
