//! Compares the stepper with usual fixed-step integrators: error against the exact steady state, nanoseconds per step,
//! and stops. A second table has the times of a step without event, of a step with one event, and of the slowest step.
//! `step_trade [--untimed] PAGE` rewrites the tables between the marks of the page.

mod kinds;
mod run;
mod scenes;

use run::{Point, Run, in_c, ours};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Numbers of steps in a cycle of the excitation, with which each method runs.
const STEPS: [usize; 3] = [50, 200, 1000];
const BEGIN: &str = "<!-- scripts/step-trade: begin -->\n";
const END: &str = "<!-- scripts/step-trade: end -->";
const KINDS: [&str; 2] = [
    "<!-- scripts/step-trade, kinds: begin -->\n",
    "<!-- scripts/step-trade, kinds: end -->",
];
/// Methods of `peers/time_stepping.c`. Each has its name in the program and its name in the table.
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
    let [page] = arguments.as_slice() else {
        return Err("step_trade [--untimed] PAGE".into());
    };
    if cfg!(not(with_c)) {
        eprintln!("SKIPPED: no C compiler; the peers in C are left out");
    }
    let text = std::fs::read_to_string(page)?;
    let mut text = between(&text, [BEGIN, END], &table(timed)?)?;
    if timed {
        text = between(&text, KINDS, &kinds::table()?)?;
    }
    std::fs::write(page, text)?;
    Ok(())
}

/// Returns the page with a new table between its marks `begin` and `end`.
fn between(page: &str, [begin, end]: [&str; 2], table: &str) -> Result<String, &'static str> {
    let (before, rest) = page.split_once(begin).ok_or("the page has no mark")?;
    let (_, after) = rest.split_once(end).ok_or("the page has no second mark")?;
    Ok(format!("{before}{begin}{table}{end}{after}"))
}

fn table(timed: bool) -> Result<String, std::fmt::Error> {
    let runs = if timed { 7 } else { 1 };
    let mut table = String::from(
        "| masses | r | β | by | error at 50 steps a cycle | at 200 | at 1000 | order | ns a step at 50, 200, 1000 | stops a cycle |\n\
         |---|---|---|---|---|---|---|---|---|---|\n",
    );
    for point in &POINTS {
        let (exact, line, hold) = match point.masses {
            1 => of!(point, runs, Line1, Line1Input, Hold1, Hold1Input),
            2 => of!(point, runs, Line2, Line2Input, Hold2, Hold2Input),
            5 => of!(point, runs, Line5, Line5Input, Hold5, Hold5Input),
            _ => of!(point, runs, Line10, Line10Input, Hold10, Hold10Input),
        };
        let mut row = |name: &str, found: &[Option<Run>; 3]| -> std::fmt::Result {
            let Point { masses, r, beta } = point;
            let all: Option<Vec<&Run>> = found.iter().map(Option::as_ref).collect();
            let Some(all) = all else { return Ok(()) };
            let errors: Vec<f64> = all
                .iter()
                .enumerate()
                .map(|(which, run)| exact.error(which, run))
                .collect();
            let shown = errors.iter().map(|error| {
                if *error > 10.0 {
                    "unstable".to_owned()
                } else {
                    format!("{error:.1e}")
                }
            });
            let order = (errors[1] / errors[2]).ln() / 5_f64.ln();
            let times = if timed {
                all.iter()
                    .map(|run| format!("{:.0}", run.time))
                    .collect::<Vec<_>>()
                    .join(", ")
            } else {
                "–".to_owned()
            };
            let stops: Vec<String> = all
                .iter()
                .zip(&errors)
                .map(|(run, error)| {
                    if *error > 10.0 {
                        "–".to_owned()
                    } else {
                        run.stops.to_string()
                    }
                })
                .collect();
            writeln!(
                table,
                "| {masses} | {r} | {beta} | {name} | {} | {order:.1} | {times} | {} of {} |",
                shown.collect::<Vec<_>>().join(" | "),
                stops.join(", "),
                exact.stops,
            )
        };
        row("stepper, linear", &line)?;
        row("stepper, hold", &hold)?;
        for (method, name) in IN_C {
            row(name, &STEPS.map(|steps| in_c(method, point, steps, runs)))?;
        }
    }
    Ok(table)
}
