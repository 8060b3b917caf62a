//! Computes the sound of a block that a moving belt drags along: stick-slip at audio rate.
//!
//! `cargo run --release --example bowed sound.wav` writes three seconds at 48 kHz. A spring holds the block, which rubs
//! on the belt. The friction force falls with the sliding speed. A second mass, light and barely damped, vibrates with
//! the block.

use frictiongen::friction_system;
use std::error::Error;

friction_system! {
    /// A block on a belt, with a second mass that vibrates with it.
    struct Bowed {
        masses: { block: 0.010, board: 0.040 },
        springs: { wall - block: 12000.0, block - board: 9000.0, wall - board: 60000.0 },
        contact: block - base,
        excitation: base,
        damping: modal[0.004, 0.006],
        stiction: 1.25,
        friction: stribeck(0.02: 0.9, 0.2: 0.55, 1.0: 0.4),
        provide: [stepper],
        step: 1.0 / 48000.0,
    }
}

/// Sampling rate of the sound, in samples a second.
const RATE: u32 = 48_000;
/// Length of the sound, in s.
const LENGTH: u32 = 3;
/// Speed of the belt, in m/s.
const SPEED: f64 = 0.12;
/// Friction force in N while the belt is fully pressed on.
const FRICTION: f64 = 2.5;

fn main() -> Result<(), Box<dyn Error>> {
    let mut step = Bowed::stepper(Bowed::STEP)?;
    let samples = RATE * LENGTH;
    let mut sound = Vec::new();
    let (mut events, mut stuck) = (0, 0_u32);
    for sample in 1..=samples {
        let time = f64::from(sample) / f64::from(RATE);
        // The normal force grows during the first third of a second and falls to zero in the last third.
        let press = (3.0 * time)
            .min(3.0 * (f64::from(LENGTH) - time))
            .clamp(0.0, 1.0);
        let state = step.advance(BowedInput {
            displacement: SPEED * time,
            velocity: SPEED,
            friction: FRICTION * press,
        })?;
        events += state.events;
        stuck += u32::from(step.contact().is_sticking());
        sound.push(step.board().velocity());
    }
    let loudest = sound
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    // The sound is checked in the second between 1 s and 2 s, in which the normal force is constant.
    let whole = RATE as usize..2 * RATE as usize;
    let steady = sound.get(whole).unwrap_or_default();
    let rises = steady
        .windows(2)
        .filter(|pair| matches!(pair, [before, after] if *before < 0.0 && 0.0 <= *after))
        .count();
    println!(
        "{samples} steps of 1/{RATE} s: {events} stops, break-aways and reversals; {} exceeded",
        step.exceeded()
    );
    println!(
        "the block sticks to the belt {:.0} % of the time; the board swings {rises} times a second, at most {:.1} mm/s",
        100.0 * f64::from(stuck) / f64::from(samples),
        loudest * 1e3
    );
    let Some(path) = std::env::args_os().nth(1) else {
        return Ok(());
    };
    let format = hound::WavSpec {
        channels: 1,
        sample_rate: RATE,
        bits_per_sample: 32,
        sample_format: hound::SampleFormat::Float,
    };
    let mut file = hound::WavWriter::create(path, format)?;
    for value in sound {
        #[allow(
            clippy::cast_possible_truncation,
            reason = "sound needs no more digits"
        )]
        file.write_sample((0.8 * value / loudest) as f32)?;
    }
    Ok(file.finalize()?)
}
