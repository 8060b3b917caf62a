//! Compares steady states under periodic loads with two references: the plain integrator, which follows the motion
//! from rest until it repeats, and the steady states under a cosine.

use crate::stepper::plain::Plain;
use crate::stepper::plain::chain::Chain;
use frictiongen::study::periodic::{
    BaseTable, Harmonic, PeriodicLoad, PeriodicRequest, PeriodicState,
};
use frictiongen::study::scene::Excitation;
use frictiongen::{Of, System};
use std::f64::consts::TAU;

/// A load over one period, in the form of the question and as polynomials for the plain integrator.
struct Case {
    what: &'static str,
    text: String,
    load: PeriodicLoad,
    period: f64,
    friction: f64,
    /// Number of steps of the plain integrator in a period.
    steps: usize,
    /// Returns, for the step with a given number, the polynomial of the force or of the base's displacement from its
    /// start on.
    along: Box<dyn Fn(usize) -> Vec<f64>>,
}

const PAIR: &str = "struct Pair { masses: { a: 2, b: 1.2 }, springs: { base - a: 900, a - b: 700 },
    contact: CONTACT, excitation: DRIVEN, damping: modal[0.05, 0.03], stiction: MU, MORE }";

fn pair(contact: &str, driven: &str, mu: &str, more: &str) -> String {
    let text = PAIR.replace("CONTACT", contact).replace("DRIVEN", driven);
    text.replace("MU", mu).replace("MORE", more)
}

/// Returns the function that gives the Taylor polynomial of a sum of harmonics at the start of a step.
fn taylor(harmonics: Vec<Harmonic>, period: f64, steps: usize) -> Box<dyn Fn(usize) -> Vec<f64>> {
    Box::new(move |step| {
        let mut terms = vec![0.0; 24];
        for one in &harmonics {
            let omega = TAU * f64::from(one.order) / period;
            let angle = omega * period * step as f64 / steps as f64 - one.lag;
            let (sine, cosine) = angle.sin_cos();
            let mut factor = one.amplitude;
            for (k, term) in terms.iter_mut().enumerate() {
                *term += factor * [cosine, -sine, -cosine, sine][k % 4];
                factor *= omega / (k + 1) as f64;
            }
        }
        terms
    })
}

fn harmonics() -> Vec<Harmonic> {
    let of = |order, amplitude, degrees: f64| Harmonic {
        order,
        amplitude,
        lag: degrees.to_radians(),
    };
    vec![of(1, 100.0, 0.0), of(3, 20.0, 45.0)]
}

/// Returns the polynomials of a base whose acceleration changes linearly between samples. The mean displacement of the
/// base has the value that the question prescribes.
fn integrated(samples: &[f64], step: f64) -> Vec<Vec<f64>> {
    let count = samples.len() - 1;
    let from = |start: [f64; 2]| {
        let [mut place, mut rate] = start;
        let mut all = Vec::new();
        for k in 0..count {
            let slope = (samples[k + 1] - samples[k]) / step;
            all.push(vec![place, rate, samples[k] / 2.0, slope / 6.0]);
            place += step * (rate + step * (samples[k] / 2.0 + step * slope / 6.0));
            rate += step * (samples[k] + step * slope / 2.0);
        }
        (all, place)
    };
    // With this initial velocity the base returns to its initial displacement after a period.
    let (_, drift) = from([0.0; 2]);
    let rate = -drift / (step * count as f64);
    let (all, _) = from([0.0, rate]);
    let mean = all.iter().map(|terms| terms[0]).sum::<f64>() / count as f64;
    from([-mean, rate]).0
}

fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (contact, mu) in [("b - wall", "1"), ("a - b", "1.2"), ("a - base", "1")] {
        let triangle = [0.0, 60.0, 120.0, 60.0, 0.0, -60.0, -120.0, -60.0, 0.0];
        cases.push(Case {
            what: "triangle",
            text: pair(contact, "b", mu, ""),
            load: PeriodicLoad::forces(0.09, &triangle).expect("a load"),
            period: 0.72,
            friction: 40.0,
            steps: 8,
            along: Box::new(move |k| vec![triangle[k], (triangle[k + 1] - triangle[k]) / 0.09]),
        });
        let square = [80.0, 80.0, -80.0, -80.0, 80.0];
        cases.push(Case {
            what: "square",
            text: pair(contact, "a", mu, "input: hold, provide: [stepper]"),
            load: PeriodicLoad::forces(0.2, &square).expect("a load"),
            period: 0.8,
            friction: 30.0,
            steps: 4,
            along: Box::new(move |k| vec![square[k]]),
        });
        cases.push(Case {
            what: "two harmonics",
            text: pair(contact, "a", mu, ""),
            load: PeriodicLoad::harmonics(0.7, &harmonics()).expect("a load"),
            period: 0.7,
            friction: 45.0,
            steps: 32,
            along: taylor(harmonics(), 0.7, 32),
        });
        let base: Vec<Harmonic> = harmonics()
            .into_iter()
            .map(|one| Harmonic {
                amplitude: one.amplitude * 5e-4,
                ..one
            })
            .collect();
        cases.push(Case {
            what: "two harmonics of the base",
            text: pair(contact, "base", mu, "damping_from: base"),
            load: PeriodicLoad::harmonics(0.5, &base).expect("a load"),
            period: 0.5,
            friction: 12.0,
            steps: 32,
            along: taylor(base, 0.5, 32),
        });
        let ground = [2.0, 5.0, -1.0, -4.0, -6.0, 3.0, 1.0, 0.0, 2.0];
        let curves = integrated(&ground, 0.08);
        cases.push(Case {
            what: "a table of the base's acceleration",
            text: pair(contact, "base", mu, "damping_from: base"),
            load: PeriodicLoad::base(0.08, &ground, BaseTable::Acceleration).expect("a load"),
            period: 0.64,
            friction: 4.0,
            steps: 8,
            along: Box::new(move |k| curves[k].clone()),
        });
    }
    cases
}

/// Runs the plain integrator from rest over `periods` periods of the load. Returns its states over the last `last`
/// periods.
fn followed(case: &Case, system: &System, periods: usize, last: usize) -> Vec<Vec<[f64; 2]>> {
    let scene = system.scene();
    let count = scene.masses.len();
    let rest = vec![0.0; count];
    let base_moves = scene.excitation == Excitation::Base;
    let first = (case.along)(0);
    let base = if base_moves {
        [first[0], first[1]]
    } else {
        [0.0; 2]
    };
    let mut plain = Plain::new(Chain::of(scene, &[]), (&rest, &rest), base);
    let step = case.period / case.steps as f64;
    let mut states = Vec::new();
    for cycle in 0..periods {
        for k in 0..case.steps {
            if cycle + last >= periods {
                let pairs = plain.x.iter().zip(plain.v.iter());
                states.push(pairs.map(|(x, v)| [*x, *v]).collect());
            }
            let along = (case.along)(k);
            let mut forces = vec![vec![0.0]; count];
            let mut motion = vec![0.0; 4];
            match scene.excitation {
                Excitation::Base => motion = along,
                Excitation::Force(mass) => forces[mass] = along,
            }
            plain.advance_along(&motion, &forces, case.friction, step);
        }
    }
    states
}

/// Returns the largest difference between an answer and the plain integrator, divided by the largest motion.
fn compared(case: &Case, state: &PeriodicState, states: &[Vec<[f64; 2]>]) -> f64 {
    let (mut size, mut apart) = ([0.0_f64; 2], [0.0_f64; 2]);
    let total = state.tracks()[0].values.len() - 1;
    let ahead = (state.start() / state.step()).round() as usize;
    let per = total / (case.steps * state.period());
    // The answer covers one or several periods of the load, and may begin in any of them. The integrator computes the
    // motion over all these periods.
    let mut best = f64::INFINITY;
    for shift in 0..state.period() {
        for (k, masses) in states.iter().enumerate() {
            let place = (k + shift * case.steps) * per + total - ahead;
            for (mass, found) in masses.iter().enumerate() {
                let own = state.tracks()[mass].values[place % total];
                for side in 0..2 {
                    size[side] = size[side].max(found[side].abs());
                    apart[side] = apart[side].max((own[side] - found[side]).abs());
                }
            }
        }
        best = best.min((apart[0] / size[0]).max(apart[1] / size[1]));
        apart = [0.0; 2];
    }
    best
}

#[test]
fn as_by_the_plain_integrator() {
    let (mut worst, mut count, mut stops, mut stuck) = (0.0_f64, 0, 0, 0);
    for case in cases() {
        let system: System = case.text.parse().expect("a scene");
        let request = PeriodicRequest {
            load: case.load.clone(),
            friction: case.friction,
            of: vec![Of::Mass(0), Of::Mass(1)],
        };
        let what = format!("{} {}", case.what, case.text);
        let state = system.periodic(&request);
        let state = state.unwrap_or_else(|error| panic!("{what}: {error}"));
        let states = followed(&case, &system, 120, state.period());
        let error = compared(&case, &state, &states);
        println!(
            "{error:.1e} {} events {} period {} {:.4} {:.1e}",
            case.what,
            state.events(),
            state.period(),
            state.multipliers()[0].norm(),
            state.residual()
        );
        assert!(error < 1e-9, "{what}: {error:e}");
        let work = state.work();
        let slides = state.events() > 0;
        // A contact that never slides keeps its displacement, which depends on earlier motion.
        assert_eq!(state.is_stable(), slides, "{what}");
        assert_eq!(work.friction > 0.0, slides, "{what}: {work:?}");
        assert!(work.damping > 0.0, "{what}: {work:?}");
        stops += u32::from(state.events() >= 4);
        stuck += u32::from(!slides);
        assert!(work.stored.abs() < 1e-9 * work.load, "{what}: {work:?}");
        worst = worst.max(error);
        count += 1;
    }
    println!("{count} steady states, {stops} with stops, {stuck} stuck, to {worst:.1e}");
    assert_eq!(count, 15);
    assert!(stops >= 5 && stuck < 4, "{stops} {stuck}");
}

/// Checks that under one harmonic the amplitude, the energy and the largest multiplier agree with those under a
/// cosine load.
#[test]
fn one_harmonic_is_a_cosine() {
    let mut compared = 0;
    let soft = "stiffness: 3000, provide: [orbit, simulation]";
    for (driven, contact, more) in [
        ("b", "a - b", ""),
        ("base", "b - wall", ""),
        ("base", "a - base", ""),
        ("b", "a - base", soft),
    ] {
        let system: System = pair(contact, driven, "1", more).parse().expect("a scene");
        for (r, share) in [(0.35, 0.6), (0.8, 0.4)] {
            let at = system.at(r).expect("in the domain");
            let beta = share * at.sliding_limit();
            let orbit = at.orbit(beta).expect("an orbit");
            let response = at.response(beta).expect("a response");
            let (amplitude, stiffness) = match driven {
                "base" => (0.01, 900.0),
                _ => (9.0, 900.0),
            };
            let [length, force] = match driven {
                "base" => [amplitude, amplitude * stiffness],
                _ => [amplitude / stiffness, amplitude],
            };
            let one = Harmonic {
                order: 1,
                amplitude,
                lag: 0.3,
            };
            let period = TAU / system.angular_frequency(r);
            let request = PeriodicRequest {
                load: PeriodicLoad::harmonics(period, &[one]).expect("a load"),
                friction: beta * force,
                of: vec![Of::Mass(0), Of::Mass(1)],
            };
            let what = format!("{driven} {contact} {more} r = {r}, β = {beta}");
            let state = system.periodic(&request);
            let state = state.unwrap_or_else(|error| panic!("{what}: {error}"));
            for (mass, track) in state.tracks().iter().enumerate() {
                let [least, most] = track.extremes();
                let want = orbit.mass_at(mass).expect("a mass").centred_amplitude() * length;
                let got = 0.5 * (most - least);
                assert!((got / want - 1.0).abs() < 3e-9, "{what}: {got} {want}");
            }
            let energy = response.friction_work() * length * force;
            let got = state.work().friction;
            assert!(
                (got - energy).abs() < 1e-8 * energy,
                "{what}: {got} {energy}"
            );
            let largest = orbit
                .multipliers()
                .iter()
                .map(|m| m.norm())
                .fold(0.0, f64::max);
            let got = state.multipliers()[0].norm();
            assert!((got - largest).abs() < 1e-7, "{what}: {got} {largest}");
            assert_eq!(state.period(), orbit.period() as usize, "{what}");
            compared += 1;
        }
    }
    assert_eq!(compared, 8);
}
