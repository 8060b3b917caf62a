//! Compares the states that motion from rest reaches, for β below and above β*_lim, with runs of the integrator
//! [`Plain`].

use super::plain::{Plain, Run};
use frictiongen::study::{SystemAt, orbit::SystemOrbit};
use frictiongen::{Of, Regime, System};
use fuzzing::Random;
use nalgebra::DVector;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Number of cycles after which a run counts as one that does not repeat.
const MOST: usize = 1500;
/// Longest period for which the test looks in a run, in cycles.
const LONGEST: usize = 64;
/// Largest change of the state over a period for which a run counts as settled.
const SETTLED: f64 = 1e-10;
/// If the state of a run changes by less than this over a shorter period, the run does not count as settled. A free
/// vibration that decays slowly nearly repeats after a shorter period.
const APART: f64 = 1e-6;
/// Tolerance of the comparison. The events of the run have errors of 2e-11, and the settled run still changes by up
/// to 1e-10.
const TOLERANCE: f64 = 1e-8;
/// Tested friction ratios, divided by β*_lim.
const FACTORS: [f64; 10] = [1.001, 1.003, 1.01, 1.02, 1.03, 1.05, 1.08, 1.12, 1.2, 1.3];

/// Returns a damped chain of one to four masses with a random contact.
fn chain(random: &mut Random) -> String {
    let n = 1 + random.below(4);
    let name = |i: usize| format!("m{}", i + 1);
    let masses = (0..n).map(|i| format!("{}: {:.4}", name(i), random.log_uniform(0.3, 3.0)));
    let masses: Vec<String> = masses.collect();
    let mut springs = vec![format!("base - m1: {:.4}", random.log_uniform(0.3, 3.0))];
    for i in 1..n {
        let k = random.log_uniform(0.3, 3.0);
        springs.push(format!("{} - {}: {k:.4}", name(i - 1), name(i)));
    }
    let j = random.below(n);
    let contact = match random.below(3) {
        0 => format!("{} - wall", name(j)),
        1 if n > 1 => {
            let other = (j + 1 + random.below(n - 1)) % n;
            format!("{} - {}", name(j), name(other))
        }
        _ => format!("{} - base", name(j)),
    };
    let excitation = if random.below(2) == 0 {
        "base".into()
    } else {
        name(random.below(n))
    };
    let damping = if random.below(3) == 0 {
        format!(
            "rayleigh({:.4}, {:.4})",
            random.power(-3.0, -1.0),
            random.power(-3.0, -1.0)
        )
    } else {
        let zetas = (0..n).map(|_| format!("{:.5}", random.power(-2.5, -0.7)));
        format!("modal[{}]", zetas.collect::<Vec<_>>().join(", "))
    };
    let mu = if random.below(10) == 0 {
        1.0
    } else {
        random.between(1.0, 3.0)
    };
    format!(
        "struct Chain {{ masses: {{ {} }}, springs: {{ {} }}, contact: {contact}, \
         excitation: {excitation}, damping: {damping}, stiction: {mu:.4} }}",
        masses.join(", "),
        springs.join(", ")
    )
}

/// Steady state of a run: its period in cycles, its events and its amplitudes.
#[derive(Debug)]
struct Settled {
    period: usize,
    stops: usize,
    reversals: usize,
    stuck: f64,
    largest: Vec<f64>,
}

/// Runs until the motion has settled. At the start, `nudge` displaces the first mass by a small length.
fn settled(plain: &Plain, masses: usize, nudge: f64) -> Option<Settled> {
    let mut run = plain.rest();
    run.state[0] += nudge;
    settles(run, masses, MOST)
}

/// Follows a run for at most `most` cycles, until it has settled.
fn settles(mut run: Run<'_>, masses: usize, most: usize) -> Option<Settled> {
    let mut states = vec![run.state.clone()];
    let apart = |states: &[DVector<f64>], period: usize| {
        let last = states.len() - 1;
        let back = |back: usize| {
            let now = last.checked_sub(back)?;
            Some((&states[now] - &states[now.checked_sub(period)?]).amax())
        };
        let apart = (0..2 * period).map(|count| back(count).unwrap_or(f64::MAX));
        let size = states[last].rows(0, 2 * masses).amax().max(1e-3);
        apart.fold(0.0, f64::max) / size
    };
    let period = |states: &[DVector<f64>]| {
        let period = (1..=LONGEST).find(|period| apart(states, *period) < APART)?;
        (apart(states, period) < SETTLED).then_some(period)
    };
    for _ in 0..most {
        run.cycle();
        states.push(run.state.clone());
        if let Some(period) = period(&states) {
            run.count();
            for _ in 0..period {
                run.cycle();
            }
            return Some(Settled {
                period,
                stops: run.stops,
                reversals: run.reversals,
                stuck: run.stuck / (period as f64 * std::f64::consts::TAU),
                largest: run.largest.expect("asked for"),
            });
        }
    }
    None
}

/// Returns the largest difference of the amplitudes, divided by the largest amplitude. Returns infinity if the
/// numbers of events differ.
fn difference(found: &Settled, expected: &Settled) -> f64 {
    let counts = |of: &Settled| (of.period, of.stops, of.reversals);
    if counts(found) != counts(expected) {
        return f64::INFINITY;
    }
    let scale = expected
        .largest
        .iter()
        .fold(1e-3, |most: f64, value| most.max(*value));
    let amplitudes = found.largest.iter().zip(&expected.largest);
    amplitudes.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs() / scale))
}

fn answered(orbit: &SystemOrbit<'_>, masses: usize) -> Settled {
    let largest = (0..masses).map(|mass| orbit.mass_at(mass).expect("a mass").amplitude());
    Settled {
        period: orbit.period() as usize,
        stops: orbit.stops(),
        reversals: orbit.reversals(),
        stuck: orbit.stuck_fraction(),
        largest: largest.collect(),
    }
}

/// Judges one point (r, β). Returns the kind of its state, and a text with the difference between answer and run. If
/// there is no difference, the text is empty.
fn judged(system: &System, at: &SystemAt<'_>, r: f64, beta: f64) -> (&'static str, String) {
    let masses = system.scene().masses.len();
    let plain = Plain::new(system.scene(), r, beta);
    let run = settled(&plain, masses, 0.0);
    // The run leaves a stuck contact away from its middle, as a start from a given state does.
    let rest = vec![0.0; masses];
    let answer = at.orbit_from(beta, (&rest, &rest));
    let answer = answer.map(|orbit| answered(&orbit, masses));
    let (answer, run) = match (answer, run) {
        (Ok(answer), Some(run)) => (answer, run),
        (Err(error), Some(run)) => return ("no answer", format!("{error}; {run:?}")),
        (Ok(answer), None) => return ("run does not settle", format!("{answer:?}")),
        (Err(_), None) => return ("neither settles", String::new()),
    };
    let apart = difference(&answer, &run);
    if apart < TOLERANCE {
        let kind = match (run.stuck > 1.0 - 1e-9, run.stops) {
            (true, _) => "stuck",
            (false, 0) => "slides",
            _ => "stick-slip",
        };
        return (kind, String::new());
    }
    // If a start that is displaced by 1e-9 changes the result, no program can decide which of the results is right.
    let sensitive = [1e-9, -1e-9, 1e-8].into_iter().any(|nudge| {
        settled(&plain, masses, nudge).is_none_or(|nudged| {
            0.1 * apart < difference(&nudged, &run) || difference(&answer, &nudged) < TOLERANCE
        })
    });
    let kind = if sensitive {
        "differs as much for a start 1e-9 away"
    } else {
        "differs"
    };
    (kind, format!("{apart:.1e}: {answer:?}, run {run:?}"))
}

/// Judges random scenes at the friction ratios `FACTORS`. Returns the number of states of each kind, and the
/// differences.
fn survey(
    scenes: usize,
    factors: &[f64],
    limit: impl Fn(&SystemAt<'_>) -> f64 + Sync,
) -> (BTreeMap<&'static str, usize>, Vec<String>) {
    let seeds: Vec<u64> = (0..scenes as u64).collect();
    let places = seeds.into_par_iter().flat_map_iter(|seed| {
        let mut random = Random(0x5eed_0000 + 977 * seed);
        let text = chain(&mut random);
        let r = random.log_uniform(0.2, 3.0);
        factors.iter().map(move |factor| (text.clone(), r, *factor))
    });
    let found = places.map(|(text, r, factor)| {
        let system: System = text.parse().expect("a scene");
        let at = system.at(r).expect("in the domain");
        let beta = factor * limit(&at);
        if !(beta.is_finite() && beta > 1e-9) {
            return ("no limit", String::new());
        }
        let (kind, told) = judged(&system, &at, r, beta);
        (
            kind,
            format!("{kind}: {text} r = {r}, β = {beta} ({factor} of the limit): {told}"),
        )
    });
    let found: Vec<(&str, String)> = found.collect();
    let mut counts = BTreeMap::new();
    for (kind, _) in &found {
        *counts.entry(*kind).or_insert(0) += 1;
    }
    (
        counts,
        found
            .into_iter()
            .map(|(_, told)| told)
            .filter(|told| !told.ends_with(": "))
            .collect(),
    )
}

/// Judges a few scenes in every test run. [`long`] judges more scenes.
#[test]
fn short() {
    let (counts, told) = survey(10, &[1.003, 1.03, 1.3], |at| at.sliding_limit());
    println!("{counts:?}");
    let wrong = told
        .iter()
        .filter(|told| told.starts_with("differs:") || told.starts_with("no answer"));
    assert_eq!(wrong.collect::<Vec<_>>(), Vec::<&String>::new());
    let compared =
        ["stuck", "slides", "stick-slip"].map(|kind| counts.get(kind).copied().unwrap_or(0));
    assert!(
        compared.iter().all(|count| *count > 0) && compared.iter().sum::<usize>() >= 24,
        "{counts:?}"
    );
}

#[test]
#[ignore = "minutes: SCENES=1000 cargo test --release -p generated-tests --test orbits stick_slip::from_rest::long -- --ignored --nocapture"]
fn long() {
    let scenes = std::env::var("SCENES").map_or(100, |text| text.parse().expect("a number"));
    let (counts, told) = survey(scenes, &FACTORS, |at| at.sliding_limit());
    println!("{counts:?}");
    for line in told {
        println!("{line}");
    }
}

/// Motions from rest that do not settle in the first 1024 cycles, with μ > 1: scene, r and β.
const LATE: [(&str, f64, f64); 2] = [
    (
        "struct Late { masses: { m1: 1.9312, m2: 0.8426, m3: 2.1029 },
            springs: { base - m1: 0.7829, m1 - m2: 0.4534, m2 - m3: 2.5535 }, contact: m1 - base,
            excitation: base, damping: modal[0.00554, 0.01146, 0.03719], stiction: 1.4197 }",
        0.106_504_694_525_991_68,
        0.021_171_964_623_000_368,
    ),
    (
        "struct Late { masses: { m1: 0.3520, m2: 1.7202, m3: 1.5650, m4: 0.4278 },
            springs: { base - m1: 0.3820, m1 - m2: 0.4127, m2 - m3: 2.4208, m3 - m4: 0.9872 },
            contact: m4 - base, excitation: base, stiction: 1.4514 }",
        0.197_407_997_017_730_49,
        0.310_714_027_527_257,
    ),
];
/// Motions from rest that wander for ever beside a stable steady state, with the stops and reversals of this state.
const WANDERING: [(&str, f64, f64, [usize; 2]); 3] = [
    (
        "struct Block { masses: { m: 2.0236 }, springs: { base - m: 2.1892 }, contact: m - base, excitation: m,
            damping: modal[0.01283], stiction: 2.0819 }",
        0.272_131_354_600_063_4,
        0.156_816_634_854_327_79,
        [2, 0],
    ),
    (
        "struct Pair { masses: { m1: 1.0, m2: 0.04735 }, springs: { base - m1: 1.0, m1 - m2: 2.257 },
            contact: m2 - base, excitation: base, damping: modal[0.08133, 0.00365], stiction: 1.5 }",
        0.2895,
        0.043_41,
        [7, 0],
    ),
    (
        "struct Pair { masses: { m1: 1.8418, m2: 0.3275 }, springs: { base - m1: 0.4389, m1 - m2: 0.7116 },
            contact: m1 - wall, excitation: base, stiction: 1.9165 }",
        1.225_881_152_073_909_2,
        0.521_136_158_233_311_7,
        [0, 2],
    ),
];

/// Motions that wander for hundreds to thousands of cycles before they settle: scene, r, β, and the period, stops and
/// reversals of the state in which they end. Rounding decides when a motion settles.
const WANDERING_FIRST: [(&str, f64, f64, [usize; 3]); 2] = [
    (
        "struct Stuck { masses: { m1: 0.4017, m2: 2.5901, m3: 1.7860 },
            springs: { base - m1: 2.8542, m1 - m2: 1.8006, m2 - m3: 2.8881 }, contact: m2 - m1,
            excitation: base, damping: modal(0.0247), stiction: 1.659 }",
        0.130_048_033_467_854,
        0.161_694_918_442_958_77,
        [1, 0, 0],
    ),
    (
        "struct Seven { masses: { m1: 1.0890, m2: 1.0547, m3: 0.5132 },
            springs: { base - m1: 0.6098, m1 - m2: 1.7813, m2 - m3: 2.3646 }, contact: m3 - wall,
            excitation: base, stiction: 2.127 }",
        0.234_732_069_263_847_32,
        0.253_637_776_405_939_6,
        [7, 23, 0],
    ),
];

/// A motion that wanders for more than 16,000 cycles although the contact can stick: scene, r and β.
const STUCK_BESIDE: (&str, f64, f64) = (
    "struct Pair { masses: { m1: 0.3584, m2: 1.7200 }, springs: { base - m1: 0.7824, m1 - m2: 1.5214 },
        contact: m2 - wall, excitation: base, stiction: 1.9505 }",
    0.412_569_016_535_721_9,
    0.486_445_807_406_602_2,
);

/// Checks motions that wander before they end in a stuck or in a subharmonic state. Most of them settle while the search
/// follows them. If a stuck state exists, every answer is a steady state.
#[test]
fn after_wandering() {
    for (text, r, beta, [period, stops, reversals]) in WANDERING_FIRST {
        let system: System = text.parse().expect("a scene");
        let at = system.at(r).expect("in the domain");
        let mut settled = 0;
        for nudge in 0..8 {
            let start = [1e-9 * f64::from(nudge), 0.0, 0.0];
            let orbit = match nudge {
                0 => at.orbit(beta),
                _ => at.orbit_from(beta, (&start, &[0.0; 3])),
            };
            let Ok(orbit) = orbit else {
                assert!(beta < at.sliding_limit(), "{text}: {nudge}");
                continue;
            };
            let found = [orbit.period() as usize, orbit.stops(), orbit.reversals()];
            assert_eq!(found, [period, stops, reversals], "{text}: {nudge}");
            assert!(orbit.is_stable(), "{text}: {nudge}");
            assert_eq!(
                orbit.is_from_rest(),
                orbit.cycles_followed().is_none(),
                "{text}: {nudge}"
            );
            settled += usize::from(orbit.is_from_rest());
        }
        assert!(settled >= 5, "{text}: {settled} of 8");
    }
}

/// Checks a stuck state beside a motion that wanders for ever. The answer is the stuck state in the middle of its
/// interval, which the motion does not reach.
#[test]
fn stuck_beside_a_motion_that_wanders() {
    let (text, r, beta) = STUCK_BESIDE;
    let system: System = text.parse().expect("a scene");
    let at = system.at(r).expect("in the domain");
    let orbit = at.orbit(beta).expect("a state");
    assert!(at.sliding_limit() <= beta && orbit.never_slides());
    assert!(!orbit.is_from_rest() && orbit.is_stable());
    assert!(orbit.cycles_followed().is_some_and(|cycles| cycles >= 4096));
    assert!(orbit.offset().abs().max(orbit.middle().abs()) < 1e-12);
}

/// Checks motions from rest that settle only after more than 1024 cycles. A run in time ends in the same state.
#[test]
fn after_a_long_time() {
    for (text, r, beta) in LATE {
        let system: System = text.parse().expect("a scene");
        let orbit = system.at(r).expect("in the domain").orbit(beta);
        let orbit = orbit.unwrap_or_else(|error| panic!("{text}: {error}"));
        assert!(
            orbit.is_from_rest() && orbit.cycles_followed().is_none(),
            "{text}"
        );
        assert_eq!(
            (orbit.period(), orbit.stops(), orbit.reversals()),
            (1, 2, 0),
            "{text}"
        );
        let mut run = system.simulation(r, beta).expect("a run");
        let mut apart = || {
            let mut left = TAU;
            while left > 0.0 {
                left -= run.advance(left).expect("a reach").length;
            }
            let masses = 0..system.scene().masses.len();
            let apart = masses.map(|mass| {
                let expected = orbit
                    .mass_at(mass)
                    .expect("a mass")
                    .displacement(-orbit.origin());
                (run.run().mass(mass).displacement() - expected).abs()
            });
            apart.fold(0.0, f64::max)
        };
        let all: Vec<f64> = (0..8000).map(|_| apart()).collect();
        assert!(
            all[..1024].iter().all(|apart| *apart > 1e-6),
            "{text}: settles early"
        );
        assert!(all[7900..].iter().all(|apart| *apart < TOLERANCE), "{text}");
    }
}

/// Checks stable states beside a motion from rest that does not settle. A run that starts close to such a state comes
/// back to the state.
#[test]
fn beside_a_motion_that_wanders() {
    for (text, r, beta, events) in WANDERING {
        let system: System = text.parse().expect("a scene");
        let masses = system.scene().masses.len();
        let orbit = system.at(r).expect("in the domain").orbit(beta);
        let orbit = orbit.unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!([orbit.stops(), orbit.reversals()], events, "{text}");
        assert!(
            !orbit.is_from_rest() && orbit.is_stable() && !orbit.is_marginal(),
            "{text}"
        );
        assert!(
            orbit.cycles_followed().is_some_and(|cycles| cycles >= 4096),
            "{text}"
        );
        let largest = orbit.multipliers().iter().map(|value| value.norm());
        assert!(largest.fold(0.0, f64::max) < 1.0, "{text}");
        let motions = || (0..masses).map(|mass| orbit.mass_at(mass).expect("a mass"));
        let tau = -orbit.origin();
        let start = motions().map(|motion| motion.displacement(tau) + 1e-6);
        let start: Vec<f64> = start
            .chain(motions().map(|motion| motion.velocity(tau)))
            .collect();
        let plain = Plain::new(system.scene(), r, beta);
        let run = settles(plain.from(&start), masses, 4096).expect("it settles");
        assert!(
            difference(&answered(&orbit, masses), &run) < TOLERANCE,
            "{text}: {run:?}"
        );
    }
}

/// Checks states for β below both limits with μ > 1. The closed form exists at these β, but motion from rest may end in
/// stick-slip. `response` must then report the stick-slip state.
#[test]
fn response_from_rest() {
    let system: System = "struct Chain {
        masses: { m1: 1.0219, m2: 1.1027, m3: 0.8481 },
        springs: { base - m1: 0.4773, m1 - m2: 0.5388, m2 - m3: 0.4707 }, contact: m1 - m3,
        excitation: base, damping: rayleigh(0.0012, 0.0076), stiction: 2.7514,
    }"
    .parse()
    .expect("a scene");
    let r = 0.219_718_580_648_245_57;
    let at = system.at(r).expect("in the domain");
    let beta = 0.97 * at.continuous_limit().min(at.sliding_limit());
    assert_eq!(at.regime(beta), Ok(Regime::Continuous));
    let closed = at.motion(beta).expect("a motion");
    let run = settled(&Plain::new(system.scene(), r, beta), 3, 0.0).expect("it settles");
    let response = at.response(beta).expect("a response");
    assert_eq!((run.period, run.stops, run.reversals), (1, 1, 1));
    assert_eq!(response.regime(), Regime::StickSlip);
    for (mass, expected) in run.largest.into_iter().enumerate() {
        let found = response.swing(Of::Mass(mass)).expect("a mass").amplitude;
        assert!(
            (found - expected).abs() < TOLERANCE * expected,
            "{found} {expected}"
        );
        let other = closed.mass_at(mass).expect("a mass").amplitude();
        assert!((found - other).abs() > 1e-4 * expected, "{found} {other}");
    }
}

/// Judges states for β below both limits with μ > 1, where motion from rest may also end in stick-slip.
#[test]
#[ignore = "minutes: SCENES=300 cargo test --release -p generated-tests --test orbits stick_slip::from_rest::below -- --ignored --nocapture"]
fn below() {
    let scenes = std::env::var("SCENES").map_or(100, |text| text.parse().expect("a number"));
    let limit = |at: &SystemAt<'_>| at.continuous_limit().min(at.sliding_limit());
    let (counts, told) = survey(scenes, &[0.5, 0.8, 0.9, 0.97, 0.99, 0.999], limit);
    println!("{counts:?}");
    for line in told {
        println!("{line}");
    }
}
