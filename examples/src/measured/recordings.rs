//! Simulates the recordings of the page `docs/guide.md`.

use frictiongen::measure::{Channel, Recording, Unit};
use frictiongen_examples::rig::{NATURAL, Noise, STOREYS, Y, decay, one_storey, recording};
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

/// Friction ratio β of the simulated recordings.
const BETA: f64 = 0.4;
/// Sampling rate of the simulated recordings, in samples a second.
const RATE: f64 = 100.0;
/// Returns the transmissibility (6.15) of the two-storey rig at a frequency in Hz. The roots are those of (A.2) and
/// (A.5).
fn two_storeys(hertz: f64) -> f64 {
    let [gamma, kappa, seconds] = STOREYS;
    let k1 = seconds.powi(-2);
    let k2 = kappa * k1;
    let b = ((k1 + k2) * gamma + k2) / (2.0 * gamma);
    let root = (b * b - k1 * k2 / gamma).sqrt();
    let [w0, w1, w2] = [k2 / gamma, b - root, b + root];
    let f = hertz * hertz;
    w1 * w2 / w0 * (w0 - f) / ((w1 - f) * (w2 - f))
}

/// Returns simulated amplitudes over frequency as CSV. They have a relative error of one in a thousand.
fn sweep(mass: &str, frequencies: &[f64], of: impl Fn(f64) -> f64, noise: &mut Noise) -> String {
    let mut text = format!("frequency_Hz,{mass}.transmissibility,{mass}.deviation\n");
    for hertz in frequencies {
        let size = of(*hertz).abs();
        let deviation = 1e-3 * size;
        let measured = size + deviation * noise.draw();
        let _ = writeln!(text, "{hertz:.3},{measured:.6},{deviation:.6}");
    }
    text
}

/// Formats a recording as CSV with six decimals.
fn csv(recording: &Recording) -> String {
    let mut text = "time_s".to_owned();
    for channel in recording.channels() {
        let _ = write!(text, ",{}_mm", channel.name);
    }
    for index in 0..recording.len() {
        let _ = write!(text, "\n{:.2}", index as f64 / recording.rate());
        for channel in recording.channels() {
            let _ = write!(text, ",{:.5}", channel.samples[index]);
        }
    }
    text + "\n"
}

/// Writes all recordings of the page to a folder.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let system = one_storey("wall", "")?;
    let mut noise = Noise::new(2026);
    for (name, hertz) in [
        ("slow", 1.543),
        ("below", 2.5),
        ("above", 3.9),
        ("fast", 5.0),
    ] {
        let recording = recording(&system, (hertz, BETA), (RATE, 12.0), &mut noise)?;
        std::fs::write(folder.join(format!("{name}.csv")), csv(&recording))?;
    }
    let samples = decay(1e3 * BETA * Y, RATE, 4.0, &mut noise);
    let channel = Channel {
        name: "plate".to_owned(),
        unit: Unit::MILLIMETRE,
        samples,
    };
    std::fs::write(
        folder.join("decay.csv"),
        csv(&Recording::new(RATE, vec![channel])?),
    )?;
    let frequencies: Vec<f64> = [0.8, 1.4, 2.0, 2.4, 2.7, 3.5, 4.0, 4.6, 5.5, 6.5, 7.2, 8.0].into();
    let one = |hertz: f64| 1.0 / (1.0 - (hertz / NATURAL).powi(2));
    std::fs::write(
        folder.join("sweep.csv"),
        sweep("plate", &frequencies, one, &mut noise),
    )?;
    let frequencies: Vec<f64> = (2..=32).map(|i| 0.25 * f64::from(i)).collect();
    std::fs::write(
        folder.join("storeys.csv"),
        sweep("m1", &frequencies, two_storeys, &mut noise),
    )?;
    Ok(())
}
