//! An observer: a program that computes quantities which no sensor measures. From the recorded motion of the base it
//! computes the position of the upper floor and the force in the damper. The program compares the position and the
//! force with the recordings of other sensors.
#![no_std]
#![no_main]

use bench::timer;
use core::hint::black_box;
use core::panic::PanicInfo;
use cortex_m::peripheral::{Peripherals, SYST};
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};

frictiongen::friction_system! {
    /// Two floors on a shaking base, a friction damper between the upper one and the wall.
    pub struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.01, 0.012],
        stiction: 1.2,
        scalar: f32,
        provide: [stepper],
        step: 1e-3,
    }
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

/// Recording at 1 kHz with four 16-bit counts a sample: displacement and velocity of the base, displacement of the
/// upper floor, force in the damper.
static RECORDING: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/recording.bin"));
/// The value of one count, for each quantity of the recording: in m, m/s, m and N.
const COUNTS: [f32; 4] = [1e-6, 1e-5, 1e-6, 1e-3];
/// Standard deviations of the sensors at the upper floor, in m, and in the damper, in N. The check allows a tenth
/// more, because the input also has noise.
const NOISE: [f32; 2] = [1e-5, 0.02];
/// Friction force of the damper, N.
const FRICTION: f32 = 3.5;

fn samples() -> impl Iterator<Item = [f32; 4]> {
    RECORDING.chunks_exact(8).map(|sample| {
        let mut values = [0.0; 4];
        let pairs = sample.chunks_exact(2).zip(COUNTS);
        for (value, (pair, count)) in values.iter_mut().zip(pairs) {
            if let [low, high] = pair {
                *value = f32::from(i16::from_le_bytes([*low, *high])) * count;
            }
        }
        values
    })
}

/// Results of the observer over the whole recording.
#[derive(Default)]
struct Found {
    steps: u32,
    sticking: u32,
    events: u32,
    /// Deviations of the computed displacement from the recorded displacement: the largest, and the sum of their
    /// squares. `force` has the largest deviation of the force, and the sum of the squares of its deviations.
    place: [f32; 2],
    force: [f32; 2],
    /// Number of samples in which the force deviates by more than a tenth of F.
    off: u32,
    least: u64,
    most: u64,
    sum: u64,
}

fn follow(timer: &mut SYST) -> Option<Found> {
    let mut stepper = Frame::stepper(Frame::STEP).ok()?;
    let input = |[displacement, velocity, ..]: [f32; 4]| FrameInput {
        displacement,
        velocity,
        friction: FRICTION,
    };
    let mut samples = samples();
    stepper.begin(input(samples.next()?)).ok()?;
    let empty = timer::ticks(timer, || ());
    let mut found = Found {
        least: u64::MAX,
        ..Found::default()
    };
    for sample in samples {
        let mut stepped = None;
        let ticks = timer::ticks(timer, || {
            stepped = stepper.advance(black_box(input(sample))).ok();
        });
        let stepped = stepped?;
        let count = ((ticks - empty) * timer::INSTRUCTIONS + timer::TICKS / 2) / timer::TICKS;
        found.least = found.least.min(count);
        found.most = found.most.max(count);
        found.sum += count;
        found.steps += 1;
        found.events += stepped.events;
        found.sticking += u32::from(stepper.contact().is_sticking());
        let [_, _, place, force] = sample;
        let off = [
            stepper.upper().displacement() - place,
            stepped.force - force,
        ];
        for ([most, sum], off) in [&mut found.place, &mut found.force].into_iter().zip(off) {
            *most = most.max(off.abs());
            *sum += off * off;
        }
        found.off += u32::from(off[1].abs() > 0.1 * FRICTION);
    }
    Some(found)
}

#[entry]
fn main() -> ! {
    if let Some(mut peripherals) = Peripherals::take() {
        timer::set_up(&mut peripherals.SYST);
        match follow(&mut peripherals.SYST) {
            Some(found) if print(&found) => debug::exit(debug::EXIT_SUCCESS),
            _ => hprintln!("an error, or more than the sensors' noise"),
        }
    }
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

/// Prints the results. Returns true if the deviations are within the noise of the sensors.
fn print(found: &Found) -> bool {
    let steps = found.steps as f32;
    let [place, force] = [found.place[1], found.force[1]].map(|sum| root_of(sum / steps));
    hprintln!(
        "{} steps, {} sticking, {} events",
        found.steps,
        found.sticking,
        found.events
    );
    hprintln!(
        "upper floor: largest deviation {:.1} um, root mean square {:.1} um",
        found.place[0] * 1e6,
        place * 1e6
    );
    hprintln!(
        "force in the damper: largest deviation {:.3} N, root mean square {:.3} N, {} samples off by more than a tenth of F",
        found.force[0],
        force,
        found.off
    );
    hprintln!(
        "instructions a step: {} to {}, {} in the mean",
        found.least,
        found.most,
        found.sum / u64::from(found.steps.max(1))
    );
    let [of_place, of_force] = NOISE;
    place < 1.1 * of_place && force < 1.1 * of_force
}

/// Returns a square root by Newton's method, because the standard library's is not available here.
fn root_of(value: f32) -> f32 {
    let mut root = if value > 1.0 { value } else { 1.0 };
    for _ in 0..60 {
        root = 0.5 * (root + value / root);
    }
    root
}
