//! This library's part of `scripts/trade map`: figure 3.12 of the thesis, a map over r and β of the stops in a cycle.
//!
//! `map_peer points` prints the points (r, β) of the map. `map_peer MU FILE STEPPER` reads the results of the plain
//! stepper at these points, one line each. Then it prints this library's time in seconds, the number of points where
//! the results differ, and the reason for each difference. STEPPER is the stepper with steps a tenth as long.

use frictiongen::kernel::simulation::Event;
use frictiongen::study::{
    map::{Map, MapPoint, MapRequest},
    response::SystemResponse,
};
use frictiongen::{Error, NoOrbit, NotContinuous, System};
use std::collections::BTreeMap;
use std::io::Write as _;
use std::process::{Command, Stdio};
use std::time::Instant;

/// Result of the plain stepper at one point (r, β).
struct Theirs {
    repeats: bool,
    stops: usize,
    reversals: usize,
    contact: f64,
}

fn grid() -> (Vec<f64>, Vec<f64>) {
    // A cycle at r = 0 never ends.
    let r = (1..=126).map(|i| f64::from(i) * 0.02).collect();
    let beta = (0..=400).map(|i| f64::from(i) * 0.01).collect();
    (r, beta)
}

fn read(text: &str) -> Vec<Theirs> {
    let line = |line: &str| {
        let values: Vec<f64> = line
            .split(' ')
            .map(|value| value.parse().expect("a number"))
            .collect();
        let &[_, repeats, stops, reversals, contact] = values.as_slice() else {
            panic!("five values a line");
        };
        let (stops, reversals) = (stops as usize, reversals as usize);
        Theirs {
            repeats: repeats == 1.0,
            stops,
            reversals,
            contact,
        }
    };
    text.lines().map(line).collect()
}

/// Runs the stepper with shorter steps at one point (r, β).
fn again(stepper: &str, mu: &str, r: f64, beta: f64) -> Theirs {
    let mut run = Command::new(stepper)
        .args(["1", "1", "0", "0", "-", mu, "5000"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the stepper");
    let mut input = run.stdin.take().expect("its input");
    writeln!(input, "{r:?} {beta:?}").expect("a point");
    drop(input);
    let output = run.wait_with_output().expect("its output");
    let found = read(&String::from_utf8(output.stdout).expect("text"));
    found.into_iter().next().expect("a line")
}

/// Returns the reason why the results of this library and of the plain stepper differ at a point.
fn reason(
    system: &System,
    r: f64,
    beta: f64,
    ours: &Result<MapPoint, Error>,
    theirs: &Theirs,
) -> String {
    let near = |shift: f64| {
        let at = system.at(r).expect("r");
        at.response(beta + shift)
    };
    let pattern = |response: &Result<SystemResponse<'_>, Error>| match response {
        Ok(response) => Some(frictiongen::study::map::Pattern::of(response)),
        Err(_) => None,
    };
    match ours {
        Err(
            Error::NotContinuous(NotContinuous::Unbounded) | Error::NoOrbit(NoOrbit::Unbounded),
        ) => {
            return "no steady state: on the undamped resonance the amplitude grows for ever"
                .to_owned();
        }
        Ok(_) if system.resonances().contains(&r) => {
            return "the stepper divides by zero on the undamped resonance".to_owned();
        }
        Ok(point) if point.marginal && point.stuck_fraction < 1.0 => {
            return "a continuum of steady states: which one depends on the way there".to_owned();
        }
        _ => {}
    }
    if !theirs.repeats {
        return "the stepper's transient had not died after 5000 cycles".to_owned();
    }
    let here = pattern(&near(0.0));
    let step = 1e-6 * beta.max(1e-3);
    if pattern(&near(step)) != here || pattern(&near(-step)) != here {
        return "on a boundary: a millionth of beta away we count otherwise too".to_owned();
    }
    let size = |response: &Result<SystemResponse<'_>, Error>| {
        let swing = response
            .as_ref()
            .ok()
            .and_then(|response| response.swing(frictiongen::Of::Contact));
        swing.map_or(f64::NAN, |swing| swing.amplitude)
    };
    if size(&near(0.0)) < 1e-6 {
        return "the contact hardly moves: the stepper ends a transient at 1e-9".to_owned();
    }
    if from_rest(system, r, beta) == (theirs.stops, theirs.reversals) {
        return "two steady states: from rest our simulation ends in the other one, too".to_owned();
    }
    format!(
        "UNEXPLAINED: ours {here:?} {:.9}, theirs {} stops {} reversals {:.9}",
        size(&near(0.0)),
        theirs.stops,
        theirs.reversals,
        theirs.contact
    )
}

/// Returns the numbers of stops and reversals in the 5000th cycle of this library's simulation from rest.
fn from_rest(system: &System, r: f64, beta: f64) -> (usize, usize) {
    let mut run = system.simulation(r, beta).expect("in the domain");
    let (mut stops, mut reversals) = (0, 0);
    while run.cycles() < 5000 {
        let segment = run.advance(1.0).expect("a reach");
        if run.cycles() == 4999 {
            match segment.event {
                Some(Event::Stop) => stops += 1,
                Some(Event::Reversal) => reversals += 1,
                _ => {}
            }
        }
    }
    (stops, reversals)
}

fn counts(point: &MapPoint) -> (usize, usize) {
    // The stepper counts within one cycle, so the counts of a period are divided by its number of cycles.
    let period = point.pattern.period.max(1) as usize;
    (
        point.pattern.stops / period,
        point.pattern.reversals / period,
    )
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (r, beta) = grid();
    if arguments
        .first()
        .is_some_and(|argument| argument == "points")
    {
        for r in &r {
            for beta in &beta {
                println!("{r:?} {beta:?}");
            }
        }
        return;
    }
    let [mu, file, finer] = arguments.as_slice() else {
        panic!("map_peer points, or map_peer MU FILE STEPPER");
    };
    let scene = format!(
        "struct Joined {{ masses: {{ block: 1 }}, springs: {{ base - block: 1 }}, contact: block - base,
         excitation: base, stiction: {mu} }}"
    );
    let request = MapRequest {
        r,
        beta,
        of: vec![frictiongen::Of::Contact],
    };
    let mut times = Vec::new();
    let mut answer: Option<(System, Map)> = None;
    for _ in 0..5 {
        // The measured time includes the parsing of the scene's text.
        let start = Instant::now();
        let system: System = scene.parse().expect("a scene");
        let map = system.map(&request, |_| true).expect("a map");
        times.push(start.elapsed().as_secs_f64());
        answer = Some((system, map));
    }
    times.sort_by(f64::total_cmp);
    let (system, map) = answer.expect("a run");
    let theirs = read(&std::fs::read_to_string(file).expect("the stepper's answers"));
    assert_eq!(theirs.len(), map.points().count(), "a line for each point");
    let mut reasons: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
    let mut farthest = 0.0_f64;
    for ((r, beta, ours), theirs) in map.points().zip(&theirs) {
        let same = ours
            .as_ref()
            .is_ok_and(|ours| counts(ours) == (theirs.stops, theirs.reversals));
        // A difference of a hundredth of the amplitude means another motion, even if the counts agree.
        let size = ours.as_ref().map_or(0.0, |ours| ours.amplitudes[0]);
        if same && (size - theirs.contact).abs() < 0.01 * size + 1e-6 {
            farthest = farthest.max((size - theirs.contact).abs() / size.max(1.0));
        } else {
            let mut reason = reason(&system, r, beta, ours, theirs);
            if reason.starts_with("UNEXPLAINED") {
                let again = again(finer, mu, r, beta);
                if ours
                    .as_ref()
                    .is_ok_and(|ours| counts(ours) == (again.stops, again.reversals))
                {
                    reason =
                        "with steps a tenth as long the stepper agrees: it stepped over events"
                            .to_owned();
                }
            }
            reasons.entry(reason).or_default().push((r, beta));
        }
    }
    println!("{} {:.6}", theirs.len(), times[times.len() / 2]);
    println!("amplitudes of the others differ by at most {farthest:.1e}");
    for (reason, points) in reasons {
        let shown: Vec<String> = points
            .iter()
            .take(4)
            .map(|(r, beta)| format!("({r}, {beta})"))
            .collect();
        println!("{:5}  {reason}: {}", points.len(), shown.join(" "));
    }
}
