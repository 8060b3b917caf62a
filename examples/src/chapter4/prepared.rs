//! Figures of the preparations for the main test: the natural frequency, the friction force, and the support of the
//! disc.

use crate::{drawn, fixed, joined};
use frictiongen::measure::{Channel, Measured, Recording, SweepPoint, Unit};
use frictiongen::{Of, System};
use frictiongen_examples::draw::part_colour;
use frictiongen_examples::rig::{LENGTH, NATURAL, Noise, Y, decay, one_storey, without_friction};
use frictiongen_plot::{
    Axis, Colour, Excitation, Figure, Line, Marker, Markers, Panel, Sketch, Stroke,
};
use std::error::Error;

type Drawn = Result<Figure, Box<dyn Error>>;

/// Friction ratio β that corresponds to the friction force of the free decay.
const BETA: f64 = 0.4;
/// Largest amplitude that the figure shows.
const TOP: f64 = 10.0;

/// Figure 4.3: the natural frequency, from recordings without friction.
pub fn frictionless() -> Drawn {
    // The fit starts from a natural frequency that is a tenth too high.
    let mut scene = one_storey("wall", "")?.scene().clone();
    for spring in &mut scene.springs {
        spring.stiffness *= 1.2;
    }
    let guess = System::try_from(scene)?;
    let rig = one_storey("wall", "")?;
    let mut noise = Noise::new(403);
    let mut points = Vec::new();
    for i in 2..=31 {
        let recording = without_friction(&rig, 0.25 * f64::from(i), LENGTH, &mut noise)?;
        let measured = Measured::of(&recording, rig.scene())?;
        let found = measured.transmissibility(0).ok_or("not recorded")?;
        points.push(SweepPoint {
            hertz: measured.hertz,
            mass: 0,
            amplitude: found.amplitude(),
            deviation: Some(found.deviation),
        });
    }
    let found = guess.fit_sweep(&points, false)?;
    let natural = found.reference;
    let size = |hertz: f64| {
        let r = found.system.frequency_ratio_at_hertz(hertz);
        let response = found.system.at(r).ok()?.response(0.0).ok()?;
        Some(response.harmonic(Of::Mass(0), 1)?.norm())
    };
    let places = (1..=1600).map(|i| 8.0 * f64::from(i) / 1600.0);
    let read = places.map(|hertz| (hertz, size(hertz).filter(|size| *size < 1.2 * TOP)));
    let all: Vec<(f64, Option<f64>)> = read.collect();
    let pieces = all.split(|(_, size)| size.is_none()).map(|piece| {
        let points = piece.iter();
        points
            .filter_map(|(hertz, size)| Some((*hertz, (*size)?)))
            .collect()
    });
    let circles = points.iter().map(|point| (point.hertz, point.amplitude));
    let panel = Panel::new(
        "",
        Axis::new("frequency (Hz)", 0.0, 8.0),
        Axis::new("*X̄*_fft", 0.0, TOP),
    )
    .with(Line::new(
        "fitted, 1/|1 − *r*^2|",
        part_colour(0),
        Stroke::Solid,
        pieces.collect(),
    ))
    .with(Line::new(
        "natural frequency",
        Colour::Black,
        Stroke::Dashed,
        vec![vec![(natural.value, 0.0), (natural.value, TOP)]],
    ))
    .with(Markers::new(
        "read from recordings",
        Colour::Black,
        Marker::Circle,
        circles.collect(),
    ));
    let sketch = Sketch {
        contact: None,
        ..drawn(&fixed(1.0))
    };
    Ok(Figure::new("4.3", "The rig without friction", 1, vec![panel])
        .with_sketch(sketch)
        .with_caption(format!(
            "Displacement transmissibility from synthetic recordings of 60 s at 2 kHz with noise of 40 dB, and (4.1) fitted to \
             it. The natural frequency comes out as {:.6} Hz, 95 % from {:.6} to {:.6}; the recordings were made with {NATURAL} Hz.",
            natural.value, natural.from, natural.to,
        )))
}

/// Figure 4.4: the friction force, from a free decay.
pub fn free_decay() -> Drawn {
    let rate = 1000.0;
    let samples = decay(1e3 * BETA * Y, rate, 4.0, &mut Noise::new(404));
    let points: Vec<(f64, f64)> = samples
        .iter()
        .enumerate()
        .map(|(i, x)| (i as f64 / rate, *x))
        .collect();
    let channel = Channel {
        name: "plate".to_owned(),
        unit: Unit::MILLIMETRE,
        samples,
    };
    let rig = one_storey("wall", "")?;
    let found = rig.free_decay(&Recording::new(rate, vec![channel])?, None)?;
    let marks: Vec<(f64, f64)> = found.extremes.iter().map(|(t, x)| (*t, 1e3 * x)).collect();
    let peaks = marks.iter().copied().filter(|(_, x)| 0.0 < *x).collect();
    let panel = Panel::new(
        "",
        Axis::new("time (s)", 0.0, 4.0),
        Axis::new("*x* (mm)", -22.0, 22.0),
    )
    .with(Line::new(
        "recorded",
        part_colour(0),
        Stroke::Solid,
        vec![points],
    ))
    .with(Line::new(
        "peaks",
        Colour::Black,
        Stroke::Dashed,
        vec![peaks],
    ))
    .with(Markers::new(
        "extremes that were found",
        Colour::Black,
        Marker::Circle,
        marks,
    ));
    // The base does not move during the free decay.
    let sketch = Sketch {
        excitation: Excitation::None,
        ..drawn(&fixed(1.0))
    };
    Ok(Figure::new("4.4", "A free decay", 1, vec![panel])
        .with_sketch(sketch)
        .with_caption(format!(
            "The plate is pulled by 20 mm and released, *β* = {BETA}; synthetic, at 1 kHz. Its peaks fall along a line, by 4*F*/*k* a \
             cycle. The linear decrement (4.3) gives *β* = {:.4}, a fit of all samples *F*/(*kY*) = {:.4}, 95 % from {:.4} to {:.4}.",
            found.friction_ratio(Y),
            found.length.value / Y,
            found.length.from / Y,
            found.length.to / Y,
        )))
}

fn configuration(number: &str, title: &str, system: &System, caption: &str) -> Figure {
    Figure::new(number, title, 1, Vec::new())
        .with_sketch(drawn(system))
        .with_caption(caption)
}

/// Figure 4.5a: sketch of the rig with its disc on the fixed wall.
pub fn disc_on_the_wall() -> Drawn {
    let caption = "The counterweight that presses the disc on the plate is pinned to the external frame, which stands still.";
    Ok(configuration("4.5a", "Fixed wall", &fixed(1.0), caption))
}

/// Figure 4.5b: sketch of the rig with its disc on the moving base.
pub fn disc_on_the_base() -> Drawn {
    let caption = "The counterweight is pinned to a post on the base: the disc moves with it.";
    Ok(configuration(
        "4.5b",
        "Disc on the moving base",
        &joined(),
        caption,
    ))
}
