//! Measures the times of a step without event, of a step with one event, and of the slowest step under violent loads.

use crate::run::median;
use crate::scenes;
use fuzzing::Random;
use std::fmt::Write;
use std::hint::black_box;
use std::time::Instant;

/// Length of a step in units of √(m/k), with mass m and stiffness k. A cycle of a single mass's free oscillation has
/// 63 steps.
const STEP: f64 = 0.1;
/// Number of steps of a run in which the program looks for steps with and without an event.
const STEPS: usize = 2000;
/// Number of steps of each kind that are timed.
const TIMED: usize = 40;
/// Number of repetitions of each timed step. Each repetition starts from the same state.
const REPEATS: u32 = 200;
/// Amplitudes of the load, divided by the friction force: a usual one and a very large one.
const LOADS: [f64; 2] = [3.0, 1e4];

/// Returns the time of one step from a given state, in ns. The time of copying the state is subtracted.
fn time<T: Clone>(state: &T, mut advance: impl FnMut(&mut T)) -> f64 {
    let mut of = |steps: bool| {
        let times = (0..7).map(|_| {
            let start = Instant::now();
            for _ in 0..REPEATS {
                let mut stepper = black_box(state).clone();
                if steps {
                    advance(&mut stepper);
                }
                black_box(&stepper);
            }
            start.elapsed().as_secs_f64()
        });
        times.fold(f64::INFINITY, f64::min)
    };
    1e9 * (of(true) - of(false)) / f64::from(REPEATS)
}

/// Returns three times in ns: the median of steps without an event, the median of steps with one event, and the time
/// of the slowest step under the very large load. The last number is how many events the slowest step had.
fn kinds<T: Clone>(start: &T, advance: impl Fn(&mut T, f64) -> u32) -> (f64, f64, f64, u32) {
    let mut noise = Random(7);
    let (mut stepper, mut seen) = (start.clone(), [Vec::new(), Vec::new()]);
    for _ in 0..STEPS {
        let (before, force) = (stepper.clone(), LOADS[0] * noise.signed());
        let events = advance(&mut stepper, force) as usize;
        if let Some(kind) = seen.get_mut(events).filter(|kind| kind.len() < TIMED) {
            kind.push(time(&before, |stepper| {
                black_box(advance(stepper, black_box(force)));
            }));
        }
    }
    let [without, one] = seen.map(median);
    let (mut stepper, mut slowest) = (start.clone(), (0.0, 0));
    for _ in 0..STEPS / 8 {
        let (before, force) = (stepper.clone(), LOADS[1] * noise.signed());
        let events = advance(&mut stepper, force);
        let time = time(&before, |stepper| {
            black_box(advance(stepper, black_box(force)));
        });
        if slowest.0 < time {
            slowest = (time, events);
        }
    }
    (without, one, slowest.0, slowest.1)
}

macro_rules! row {
    ($table:ident, $masses:literal, $frame:ident, $input:ident) => {{
        let input = |force| scenes::$input {
            force,
            friction: 1.0,
        };
        let mut stepper = scenes::$frame::stepper(STEP).expect("a step");
        stepper.begin(input(0.0)).expect("a sound input");
        let (without, one, slowest, events) = kinds(&stepper, |stepper, force| {
            stepper.advance(input(force)).expect("a sound input").events
        });
        writeln!(
            $table,
            "{},{without:.0},{one:.0},{slowest:.0},{events}",
            $masses
        )?;
    }};
}

/// Returns a CSV table of the times of steps, with one row for each number of masses.
pub fn table() -> Result<String, std::fmt::Error> {
    let mut table =
        String::from("masses,no event ns,one event ns,slowest ns,events of the slowest\n");
    row!(table, 1, Line1, Line1Input);
    row!(table, 2, Line2, Line2Input);
    row!(table, 5, Line5, Line5Input);
    row!(table, 10, Line10, Line10Input);
    Ok(table)
}
