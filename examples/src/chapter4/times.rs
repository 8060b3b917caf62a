//! Figures of motions at β = 0.2, over time and by their harmonics: recordings compared with theory.

use crate::{PLATE, drawn, fixed};
use frictiongen::Complex;
use frictiongen::System;
use frictiongen::measure::Measured;
use frictiongen::study::response::SystemResponse;
use frictiongen_examples::draw::{Times, cycle, from_rest, part_colour};
use frictiongen_examples::rig::{LENGTH, NATURAL, Noise, one_storey, recording};
use frictiongen_plot::{
    Across, Axis, Colour, Figure, Guide, Key, Line, Marker, Markers, Panel, Stroke,
};
use std::error::Error;
use std::f64::consts::TAU;

const BETA: f64 = 0.2;
/// The motions of the figure: letter of the panel, frequency ratio r, and ratio μ of static to kinetic friction. With
/// μ = 1.2 the plate stops once a cycle at r = 0.5, as the measured plate does.
const CASES: [(&str, f64, f64); 4] = [
    ("a", 0.12, 1.0),
    ("b", 0.5, 1.2),
    ("c", 0.8, 1.0),
    ("d", 1.25, 1.0),
];
/// Length of the short time axis, in cycles.
const SHORT: f64 = 2.0;
/// Length of the long time axis, in cycles.
const LONG: f64 = 16.0;
/// Number of circles in a cycle in the panels with the short time axis.
const CIRCLES: u32 = 24;
/// Number of points in a cycle in the panels with the long time axis.
const POINTS: u32 = 48;
/// Number of cycles from which a spectrum is computed.
const CYCLES: f64 = 20.0;
/// Highest frequency of a spectrum, as a multiple of the excitation's frequency.
const HIGHEST: f64 = 12.0;
/// Lowest level of a spectrum that the figure shows, in dB.
const LOWEST: f64 = -100.0;

/// A recording of the plate, and the response identified from it.
struct Recorded {
    /// Displacement of the plate at each sample, divided by the identified amplitude of the base.
    plate: Vec<f64>,
    measured: Measured,
}

impl Recorded {
    fn new(index: usize) -> Result<Self, Box<dyn Error>> {
        let (_, r, stiction) = CASES[index];
        let rig = one_storey("wall", &format!("stiction: {stiction:?},"))?;
        let mut noise = Noise::new(412 + index as u64);
        let recording = recording(&rig, (r * NATURAL, BETA), LENGTH, &mut noise)?;
        let measured = Measured::of(&recording, rig.scene())?;
        let plate = recording.channel("plate").ok_or("no plate")?;
        let unit = 1e3 * measured.drive_amplitude();
        Ok(Self {
            plate: plate.samples.iter().map(|x| x / unit).collect(),
            measured,
        })
    }

    /// Returns the phase angle of the base at a sample, in rad. Identified phases count from the middle of the steady
    /// interval.
    fn angle(&self, index: usize) -> f64 {
        let (from, to) = self.measured.steady;
        let middle = 0.5 * (from + to) * self.measured.rate - 0.5;
        let drive = self.measured.drive.fundamental();
        let turn = TAU * self.measured.hertz / self.measured.rate;
        turn * (index as f64 - middle) + drive.im.atan2(drive.re)
    }

    /// Returns about `each` samples of the plate in each of `cycles` cycles, which begin at the phase angle `from`.
    /// The angles in the result count from the start of the first of these cycles.
    fn samples(&self, from: f64, cycles: f64, each: u32) -> Vec<(f64, f64)> {
        let per_sample = TAU * self.measured.hertz / self.measured.rate;
        let wait = (from - self.angle(0)).rem_euclid(TAU);
        let first = (wait / per_sample).ceil();
        let count = (cycles * f64::from(each)) as u32;
        (0..=count)
            .filter_map(|i| {
                let step = TAU * f64::from(i) / f64::from(each) / per_sample;
                let index = (first + step).round() as usize;
                let angle = index as f64 * per_sample - wait;
                Some((angle, *self.plate.get(index)?)).filter(|_| angle <= TAU * cycles)
            })
            .collect()
    }
}

/// Figure 4.12: recorded and computed motions over time.
pub fn motions() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for (index, (letter, r, stiction)) in CASES.into_iter().enumerate() {
        let recorded = Recorded::new(index)?;
        let system = fixed(stiction);
        let (origin, mut short) = theory(&system, &format!("({letter}) *r* = {r}"), r)?;
        if 1.0 < stiction {
            short = short.with(with_a_stop(&system, r, origin)?);
            (short.y.low, short.y.high) = (-1.65, 1.65);
        }
        short = short.with(Markers::new(
            "recorded",
            Colour::Black,
            Marker::Circle,
            recorded.samples(origin, SHORT, CIRCLES),
        ));
        let long = recorded.samples(origin, LONG, POINTS);
        let x = Axis::new("*τ*", 0.0, LONG * TAU).in_pi();
        let title = format!("({letter}) for longer");
        let long = Panel::new(title.as_str(), x, short.y.clone()).with(Line::new(
            "recorded",
            Colour::Black,
            Stroke::Thin,
            vec![long],
        ));
        panels.extend([short, long]);
    }
    Ok(Figure::new("4.12", "Steady motions at *β* = 0.2", 2, panels)
        .with_sketch(drawn(&fixed(1.0)))
        .with_keys([Key::marker("recorded", Marker::Circle)])
        .with_caption(
            "Fixed wall; synthetic recordings with noise of 40 dB, and the theory. The time *τ* counts by the phase of the base \
             that is read. *μ* = 1, in (b) 1.2: there the plate may slide all the time (line), but from rest it comes to another \
             motion (green), which is not symmetric and stops once a cycle, as that of the thesis does. The thesis does not state \
             all *r*.",
        ))
}

/// Returns a panel of the computed motion over two cycles, and the phase angle of the base at which the panel begins.
fn theory(system: &System, title: &str, r: f64) -> Result<(f64, Panel), Box<dyn Error>> {
    let times = Times {
        span: (0.0, SHORT * TAU),
        circles: 0.0,
        excitation: true,
    };
    let parts = [("plate *x̄*", PLATE, part_colour(0))];
    let panel = cycle(title, system, (r, BETA), &parts, times).ok_or("no motion")?;
    let origin = match system.at(r)?.response(BETA)? {
        SystemResponse::Continuous(motion) => motion.contact().phase(),
        SystemResponse::StickSlip(orbit) => orbit.origin(),
        SystemResponse::Stuck(_) => return Err("no motion".into()),
    };
    Ok((origin, panel))
}

/// Returns the steady state that motion from rest reaches, as a line over time. The line begins at the phase angle
/// `origin` of the base.
fn with_a_stop(system: &System, r: f64, origin: f64) -> Result<Line, Box<dyn Error>> {
    let count = 480;
    let taus: Vec<f64> = (0..=count)
        .map(|i| SHORT * TAU * f64::from(i) / f64::from(count))
        .collect();
    let start = origin.rem_euclid(TAU);
    let angles: Vec<f64> = taus.iter().map(|tau| tau + start).collect();
    let motion = from_rest(system, (r, BETA), &[PLATE], &angles).ok_or("no run")?;
    let points = taus.into_iter().zip(motion.into_iter().flatten()).collect();
    Ok(Line::new(
        "with one stop",
        part_colour(2),
        Stroke::Solid,
        vec![points],
    ))
}

/// Figure 4.13: recorded and computed harmonics of the motions.
pub fn harmonics() -> Result<Figure, Box<dyn Error>> {
    let mut panels = Vec::new();
    for (index, (letter, r, stiction)) in CASES.into_iter().enumerate() {
        let recorded = Recorded::new(index)?;
        let x = Axis::new("*f* over that of the base", 0.0, HIGHEST);
        let y = Axis::new("|*X̄*| (dB)", LOWEST, 10.0);
        let title = format!("({letter}) *r* = {r}");
        let panel = Panel::new(title.as_str(), x, y)
            .with(Guide::new(Across::Y(0.0)))
            .with(Line::new(
                "recorded",
                Colour::Black,
                Stroke::Thin,
                vec![spectrum(&recorded).ok_or("the recording is too short")?],
            ))
            .with(Markers::new(
                "theory",
                part_colour(0),
                Marker::Dot,
                exact(&fixed(stiction), r)?,
            ));
        panels.push(panel);
    }
    Ok(Figure::new("4.13", "Harmonics of the steady motions at *β* = 0.2", 2, panels)
        .with_sketch(drawn(&fixed(1.0)))
        .with_caption(
            "Of the recordings of figure 4.12, 20 cycles under a Hann window; 0 dB is the motion *Y* of the base. Friction puts in \
             odd harmonics; even ones show that a motion is not symmetric. What lies between the lines is noise.",
        ))
}

/// Returns the spectrum of 20 cycles of a recording under a Hann window. Each pair has the frequency as a multiple of
/// the excitation's, and the level in dB. Returns `None` if the recording is too short.
fn spectrum(recorded: &Recorded) -> Option<Vec<(f64, f64)>> {
    let per_sample = recorded.measured.hertz / recorded.measured.rate;
    let count = (CYCLES / per_sample).round() as usize;
    let samples = recorded.plate.get(..count)?.iter().enumerate();
    let weight = |t: usize| 0.5 - 0.5 * (TAU * (t as f64 + 1.0) / (count as f64 + 1.0)).cos();
    let windowed: Vec<f64> = samples.map(|(t, x)| weight(t) * x).collect();
    let whole: f64 = (0..count).map(weight).sum();
    let step = 0.5 / CYCLES;
    // The mean value has half the weight of a spectral line.
    let orders = (0..).map(|i: u32| f64::from(i) * step);
    let orders = orders.take_while(|order| *order <= HIGHEST);
    let level = |order: f64| {
        let turn = Complex::from_polar(1.0, -TAU * per_sample * order);
        let mut power = Complex::new(1.0, 0.0);
        let mut sum = Complex::new(0.0, 0.0);
        for x in &windowed {
            sum += power * x;
            power *= turn;
        }
        let share = if order == 0.0 { 1.0 } else { 2.0 };
        let level = 20.0 * (share * sum.norm() / whole).log10();
        (order, level.max(LOWEST))
    };
    Some(orders.map(level).collect())
}

/// Returns the harmonics of the steady state that motion from rest reaches, as levels in dB. The first one is the
/// mean.
fn exact(system: &System, r: f64) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let count = 4096;
    let angles: Vec<f64> = (0..count)
        .map(|i| TAU * f64::from(i) / f64::from(count))
        .collect();
    let motions = from_rest(system, (r, BETA), &[PLATE], &angles).ok_or("no run")?;
    let motion = motions.first().ok_or("no motion")?;
    let level = |n: u32| {
        let turned = motion.iter().zip(&angles);
        let sum: Complex<f64> = turned
            .map(|(x, angle)| Complex::from_polar(*x, -f64::from(n) * angle))
            .sum();
        let share = if n == 0 { 1.0 } else { 2.0 } / f64::from(count);
        (f64::from(n), 20.0 * (share * sum.norm()).log10())
    };
    let levels = (0..=HIGHEST as u32).map(level);
    Ok(levels.filter(|(_, level)| LOWEST < *level).collect())
}
