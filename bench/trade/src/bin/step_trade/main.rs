//! Compares the stepper with usual fixed-step integrators: error against the exact steady state, nanoseconds per step,
//! and stops. A second table has the times of a step without event, of a step with one event, and of the slowest step.
//! `step_trade [--untimed] FOLDER` writes the tables `steps.csv` and `single-steps.csv` to a folder. With `--untimed` it
//! writes only `steps.csv`, without times.

mod kinds;
mod run;
mod scenes;

use run::{Point, Run, in_c, ours};
use std::f64::consts::TAU;
use std::fmt::Write;
use std::path::Path;

/// Numbers of steps in a cycle of the excitation, with which each method runs.
const STEPS: [usize; 3] = [50, 200, 1000];
/// Error above which a method is unstable.
const UNSTABLE: f64 = 10.0;
/// Methods of `bench/peers/time_stepping.c`. Each has its name in the program and its name in the table.
const IN_C: [(&str, &str); 4] = [
    ("moreau-half", "Moreau–Jean, θ = ½"),
    ("moreau-one", "Moreau–Jean, θ = 1"),
    ("rk4", "Runge–Kutta 4, switched"),
    ("rk4-located", "Runge–Kutta 4, located"),
];

/// The exact steady state at a point, with which the methods are compared.
struct Exact {
    amplitude: f64,
    stops: usize,
    /// Displacement of the contact at the end of each step of a cycle, one list for each number in [`STEPS`].
    displacements: [Vec<f64>; 3],
}

impl Exact {
    /// Returns the largest deviation of a run from the exact displacement at the ends of its steps, divided by the
    /// amplitude.
    fn error(&self, which: usize, run: &Run) -> f64 {
        let pairs = self.displacements[which].iter().zip(&run.displacements);
        pairs.fold(0.0, |worst: f64, (want, found)| {
            let error = (found - want).abs() / self.amplitude;
            if error.is_finite() {
                worst.max(error)
            } else {
                f64::INFINITY
            }
        })
    }
}

/// Runs a stepper at a point. Two arguments name the stepper's type and the type of its input.
macro_rules! stepper {
    ($frame:ident, $input:ident, $point:expr, $steps:expr, $runs:expr, $hold:literal) => {{
        let beta = $point.beta;
        ours(
            $point,
            ($steps, $runs, $hold),
            |dt| {
                let mut stepper = scenes::$frame::stepper(dt).expect("a step");
                let start = scenes::$input {
                    force: 1.0,
                    friction: beta,
                };
                stepper.begin(start).expect("a sound input");
                stepper
            },
            |stepper, force| {
                let input = scenes::$input {
                    force,
                    friction: beta,
                };
                stepper.advance(input).expect("a sound input").events
            },
            |stepper| stepper.contact().displacement(),
        )
    }};
}

/// Computes the exact state at a point, and the runs of all methods, for scenes with one number of masses.
macro_rules! of {
    ($point:expr, $runs:expr, $line:ident, $line_input:ident, $hold:ident, $hold_input:ident) => {{
        let at = scenes::$line::at($point.r).expect("in the domain");
        let orbit = at.orbit($point.beta).expect("a steady state");
        let exact = Exact {
            amplitude: orbit.contact().amplitude(),
            stops: orbit.stops(),
            displacements: STEPS.map(|steps| {
                let tau = |step: usize| TAU * step as f64 / steps as f64 - orbit.origin();
                (1..=steps)
                    .map(|step| orbit.contact().displacement(tau(step)))
                    .collect()
            }),
        };
        let line =
            STEPS.map(|steps| Some(stepper!($line, $line_input, $point, steps, $runs, false)));
        let hold =
            STEPS.map(|steps| Some(stepper!($hold, $hold_input, $point, steps, $runs, true)));
        (exact, line, hold)
    }};
}

const POINTS: [Point; 8] = [
    Point {
        masses: 1,
        r: 0.4,
        beta: 0.4,
    },
    Point {
        masses: 1,
        r: 0.05,
        beta: 0.4,
    },
    Point {
        masses: 2,
        r: 0.4,
        beta: 0.4,
    },
    Point {
        masses: 2,
        r: 0.05,
        beta: 0.2,
    },
    Point {
        masses: 5,
        r: 0.6,
        beta: 0.4,
    },
    Point {
        masses: 5,
        r: 0.05,
        beta: 0.1,
    },
    Point {
        masses: 10,
        r: 0.6,
        beta: 0.4,
    },
    Point {
        masses: 10,
        r: 0.05,
        beta: 0.05,
    },
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let timed = arguments.first().is_none_or(|word| word != "--untimed");
    if !timed {
        arguments.remove(0);
    }
    let [folder] = arguments.as_slice() else {
        return Err("step_trade [--untimed] FOLDER".into());
    };
    let folder = Path::new(folder);
    if cfg!(not(with_c)) {
        eprintln!("SKIPPED: no C compiler; the peers in C are left out");
    }
    std::fs::write(folder.join("steps.csv"), table(timed)?)?;
    if timed {
        std::fs::write(folder.join("single-steps.csv"), kinds::table()?)?;
    }
    Ok(())
}

/// Returns a CSV table with one row for each point, method and number of steps in a cycle.
fn table(timed: bool) -> Result<String, std::fmt::Error> {
    let runs = if timed { 7 } else { 1 };
    let mut table =
        String::from("masses,r,beta,by,steps a cycle,error,ns a step,stops,exact stops\n");
    for point in &POINTS {
        let (exact, line, hold) = match point.masses {
            1 => of!(point, runs, Line1, Line1Input, Hold1, Hold1Input),
            2 => of!(point, runs, Line2, Line2Input, Hold2, Hold2Input),
            5 => of!(point, runs, Line5, Line5Input, Hold5, Hold5Input),
            _ => of!(point, runs, Line10, Line10Input, Hold10, Hold10Input),
        };
        let mut row = |name: &str, found: &[Option<Run>; 3]| -> std::fmt::Result {
            let Point { masses, r, beta } = point;
            for (which, run) in found.iter().enumerate() {
                let Some(run) = run else { continue };
                let (steps, error) = (STEPS[which], exact.error(which, run));
                let time = if timed {
                    format!("{:.0}", run.time)
                } else {
                    String::new()
                };
                let (error, stops) = if error > UNSTABLE {
                    ("unstable".to_owned(), String::new())
                } else {
                    (format!("{error:.1e}"), run.stops.to_string())
                };
                writeln!(
                    table,
                    "{masses},{r},{beta},\"{name}\",{steps},{error},{time},{stops},{}",
                    exact.stops
                )?;
            }
            Ok(())
        };
        row("stepper, linear", &line)?;
        row("stepper, hold", &hold)?;
        for (method, name) in IN_C {
            row(name, &STEPS.map(|steps| in_c(method, point, steps, runs)))?;
        }
    }
    Ok(table)
}
