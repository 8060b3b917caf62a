//! The friction and one number of the description that keep the largest amplitude over a band smallest, against maps by
//! brute force: descriptions written anew for each value, with groups made by hand.
//!
//! ```sh
//! cargo test --release -p generated-tests --test tuned_optimum -- --include-ignored --nocapture
//! ```

use frictiongen::study::{
    FrequencyBand, Load, OptimumError, OptimumKind, OptimumRequest, System, TunedOptimum, Tuning,
};
use std::time::Instant;

/// What is varied, by its place in the text.
struct Case {
    /// With `#` for the number.
    text: &'static str,
    /// The first mass and the first spring; none where it is the number.
    first: [Option<f64>; 2],
    base: bool,
    of: &'static str,
    name: &'static str,
    interval: [f64; 2],
    /// In rad/s.
    band: [f64; 2],
    load: f64,
}

/// A mass that rubs on the main one, on resonances that nothing else damps.
const ABSORBER: Case = Case {
    text: "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: 1.0, a - b: # }, contact: a - b, excitation: a }",
    first: [Some(1.0), Some(1.0)],
    base: false,
    of: "a",
    name: "k a - b",
    interval: [0.05, 0.15],
    band: [0.5, 1.6],
    load: 1.0,
};
/// The same, where the first spring is the number: all groups move with it.
const FIRST_SPRING: Case = Case {
    text: "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: #, a - b: 0.085 }, contact: a - b, excitation: a }",
    first: [Some(1.0), None],
    name: "k base - a",
    interval: [0.6, 1.2],
    ..ABSORBER
};
/// The same between frequencies of which one is beside either resonance: without friction both ends are as high for one mass.
const SHARP: Case = Case {
    text: "struct Absorber { masses: { a: 1.0, b: # },
        springs: { base - a: 1.0, a - b: 0.085 }, contact: a - b, excitation: a }",
    name: "m b",
    interval: [0.06, 0.16],
    band: [0.83, 1.0],
    ..ABSORBER
};
/// One mass between its moving base, on which it rubs, and a wall.
const BLOCK: Case = Case {
    text: "struct Block { masses: { block: 1 }, springs: { base - block: #, block - wall: 1 },
        contact: block - base, excitation: base, damping: modal(0.05) }",
    first: [Some(1.0), None],
    base: true,
    of: "block",
    name: "k base - block",
    interval: [0.1, 3.0],
    band: [0.3, 3.5],
    load: 0.01,
};

impl Case {
    fn system(&self, value: f64) -> System {
        let text = self.text.replace('#', &format!("{value:?}"));
        text.parse().expect("a valid scene")
    }

    fn tuned(&self, described: f64) -> TunedOptimum {
        let system = self.system(described);
        let hertz = self.band.map(|omega| omega / std::f64::consts::TAU);
        let request = OptimumRequest {
            of: system.motion_named(self.of).expect("a motion"),
            band: FrequencyBand::Hertz(hertz[0], hertz[1]),
            load: Some(self.load()),
        };
        let tuning = Tuning {
            of: system.tunable_named(self.name).expect("a number"),
            from: self.interval[0],
            to: self.interval[1],
        };
        system.tuned_optimum(&request, &tuning).expect("an optimum")
    }

    fn load(&self) -> Load {
        if self.base {
            Load::Base(self.load)
        } else {
            Load::Force(self.load)
        }
    }

    /// Friction in N and amplitude in m.
    fn physical(&self, described: f64, tuned: &TunedOptimum) -> [f64; 2] {
        let scale = self
            .system(described)
            .load_scale(self.load())
            .expect("a load");
        let optimum = &tuned.optimum;
        [
            scale.friction(optimum.beta),
            scale.displacement(optimum.amplitude),
        ]
    }
}

/// One value of the number by brute force, in N, m and rad/s.
struct Tried<'c> {
    case: &'c Case,
    system: System,
    mass: f64,
    stiffness: f64,
    count: usize,
}

impl<'c> Tried<'c> {
    fn new(case: &'c Case, value: f64) -> Self {
        let [mass, stiffness] = case.first.map(|known| known.unwrap_or(value));
        Self {
            case,
            system: case.system(value),
            mass,
            stiffness,
            count: 0,
        }
    }

    fn amplitude(&mut self, omega: f64, force: f64) -> f64 {
        self.count += 1;
        let of = self.system.motion_named(self.case.of).expect("a motion");
        let r = omega * (self.mass / self.stiffness).sqrt();
        let (load, length) = if self.case.base {
            (self.stiffness * self.case.load, self.case.load)
        } else {
            (self.case.load, self.case.load / self.stiffness)
        };
        let response = self.system.at(r).expect("r").response(force / load);
        response.map_or(f64::INFINITY, |response| {
            length * response.swing(of).expect("a motion").amplitude
        })
    }

    /// The largest over the band by samples alone.
    fn largest(&mut self, force: f64) -> f64 {
        const GRID: usize = 240;
        let [from, to] = self.case.band;
        let grid = |a: f64, b: f64, cells: usize| -> Vec<f64> {
            (0..=cells)
                .map(|place| a + (b - a) * place as f64 / cells as f64)
                .collect()
        };
        let places = grid(from, to, GRID);
        let values: Vec<f64> = places
            .iter()
            .map(|omega| self.amplitude(*omega, force))
            .collect();
        let most = values.iter().copied().fold(0.0, f64::max);
        let mut best = most;
        for place in 0..=GRID {
            let (before, after) = (place.saturating_sub(1), (place + 1).min(GRID));
            let top = values[before] <= values[place] && values[after] <= values[place];
            if !top || values[place] < 0.97 * most {
                continue;
            }
            let (mut a, mut b) = (places[before], places[after]);
            while b - a > 1e-7 * b {
                let finer = grid(a, b, 10);
                let found = finer.iter().map(|omega| self.amplitude(*omega, force));
                let (at, value) = found
                    .enumerate()
                    .max_by(|(_, x), (_, y)| x.total_cmp(y))
                    .expect("places");
                best = best.max(value);
                (a, b) = (finer[at.saturating_sub(1)], finer[(at + 1).min(10)]);
            }
        }
        best
    }

    /// The least of it over forces, about one of them: a grid, then golden sections.
    fn least(&mut self, about: f64) -> (f64, f64) {
        let window = if 0.0 < about {
            [0.8 * about, 1.25 * about]
        } else {
            [0.0, 0.05]
        };
        golden(window, 12, 1e-9, |force| self.largest(force))
    }
}

/// Where a function is least: the best of a grid, and golden sections about it.
fn golden(
    [from, to]: [f64; 2],
    cells: u32,
    near: f64,
    mut f: impl FnMut(f64) -> f64,
) -> (f64, f64) {
    let cell = (to - from) / f64::from(cells);
    let (mut x, mut least) = (from, f64::INFINITY);
    for place in 0..=cells {
        let at = from + cell * f64::from(place);
        let value = f(at);
        if value < least {
            (x, least) = (at, value);
        }
    }
    let (mut a, mut b) = ((x - cell).max(from), (x + cell).min(to));
    let share = 0.5 * (5.0_f64.sqrt() - 1.0);
    let at = |share: f64, a: f64, b: f64| a + share * (b - a);
    let (mut c, mut d) = (at(1.0 - share, a, b), at(share, a, b));
    let (mut fc, mut fd) = (f(c), f(d));
    while b - a > near * to {
        if fc < fd {
            (b, d, fd) = (d, c, fc);
            c = at(1.0 - share, a, b);
            fc = f(c);
        } else {
            (a, c, fc) = (c, d, fd);
            d = at(share, a, b);
            fd = f(d);
        }
    }
    [(x, least), (c, fc), (d, fd)]
        .into_iter()
        .min_by(|(_, a), (_, b)| a.total_cmp(b))
        .expect("three")
}

fn off(a: f64, b: f64) -> f64 {
    (a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE)
}

/// The least over number and force about the optimum, by golden sections within golden sections.
#[test]
#[ignore = "a million responses: minutes"]
fn two_masses_as_by_brute_force() {
    for (case, described, sharp) in [
        (&ABSORBER, 0.085, false),
        (&FIRST_SPRING, 1.0, false),
        (&SHARP, 0.1, true),
    ] {
        let start = Instant::now();
        let tuned = case.tuned(described);
        let seconds = start.elapsed().as_secs_f64();
        assert!(!tuned.at_end, "{}: {}", case.name, tuned.value);
        let [force, amplitude] = case.physical(described, &tuned);
        let start = Instant::now();
        let mut count = 0;
        // The value found is none of the grid's.
        let interval = [0.971, 1.032].map(|share| share * tuned.value);
        // A flat least is no nearer than the root of a rounding.
        let near = if sharp { 1e-10 } else { 1e-6 };
        let (value, least) = golden(interval, 6, near, |value| {
            let mut tried = Tried::new(case, value);
            let found = tried.least(force).1;
            count += tried.count;
            found
        });
        let (best, there) = Tried::new(case, tuned.value).least(force);
        let [in_value, in_force, in_amplitude, in_depth] = [
            off(tuned.value, value),
            off(force, best),
            off(amplitude, there),
            off(amplitude, least),
        ];
        println!(
            "{} = {} ({in_value:.1e} off), {force} N ({in_force:.1e} off), {amplitude} m ({in_amplitude:.1e} off, {in_depth:.1e} \
             from the least), {:?}; {} amplitudes in {seconds:.1} s, by brute force {count} in {:.0} s",
            case.name,
            tuned.value,
            tuned.optimum.kind,
            tuned.evaluations,
            start.elapsed().as_secs_f64()
        );
        assert!(in_force < 1e-6 && in_amplitude < 1e-9 && in_depth < 1e-9);
        assert!(in_value < if sharp { 1e-8 } else { 1e-4 });
    }
}

/// The sharp one by its receptances: at both ends of the band the undamped main mass moves as far.
#[test]
#[ignore = "many optima: a minute without optimisation"]
fn sharp_as_by_receptances() {
    let tuned = SHARP.tuned(0.1);
    let amplitude = |mass: f64, omega: f64| {
        let square = omega * omega;
        let (main, own) = (1.085 - square, 0.085 - mass * square);
        (own / (main * own - 0.085 * 0.085)).abs()
    };
    let higher = |mass: f64| {
        let [low, high] = SHARP.band.map(|omega| amplitude(mass, omega));
        low - high
    };
    let (mut a, mut b) = (0.1, 0.12);
    assert!(higher(a) * higher(b) < 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (a + b);
        if higher(a) * higher(middle) <= 0.0 {
            b = middle;
        } else {
            a = middle;
        }
    }
    let least = amplitude(a, SHARP.band[0]);
    println!("{} ({:.1e} off), {least}", tuned.value, off(tuned.value, a));
    assert_eq!(tuned.optimum.kind, OptimumKind::NoFriction);
    assert!(tuned.optimum.beta == 0.0 && off(tuned.value, a) < 1e-9);
    assert!(off(tuned.optimum.amplitude, least) < 1e-9);
}

/// One mass: softer to its base it moves less, and at the end of the interval friction is best as a map has it. Nowhere on a
/// map of the whole interval is it less.
#[test]
#[ignore = "a map of a million responses: a minute"]
fn one_mass_as_by_brute_force() {
    let tuned = BLOCK.tuned(1.0);
    assert!(tuned.at_end && tuned.value == 0.1, "{}", tuned.value);
    assert_ne!(tuned.optimum.kind, OptimumKind::Stuck);
    let [force, amplitude] = BLOCK.physical(1.0, &tuned);
    let mut tried = Tried::new(&BLOCK, tuned.value);
    let (best, least) = tried.least(force);
    let offs = [off(force, best), off(amplitude, least)];
    println!(
        "{force} N ({:.1e} off), {amplitude} m ({:.1e} off)",
        offs[0], offs[1]
    );
    assert!(offs[0] < 1e-6 && offs[1] < 1e-9, "{offs:?}");
    let mut count = 0;
    for place in 0..=15 {
        let value = 0.1 * 30.0_f64.powf(f64::from(place) / 15.0);
        let mut tried = Tried::new(&BLOCK, value);
        for step in 0..=30 {
            let share = f64::from(step) / 30.0;
            let there = tried.largest(0.12 * share * share);
            assert!(amplitude <= there * (1.0 + 1e-9), "{value}: {there}");
        }
        count += tried.count;
    }
    println!("nowhere less among {count} responses");
}

/// The scan holds what `optimum` says of each value, in the units of the scene as it is described, however that is.
#[test]
#[ignore = "many optima: half a minute without optimisation"]
fn whatever_is_described() {
    let [one, other] = [0.9, 1.1].map(|described| (described, FIRST_SPRING.tuned(described)));
    let [a, b] = [&one, &other].map(|(described, tuned)| FIRST_SPRING.physical(*described, tuned));
    assert!(off(one.1.value, other.1.value) < 1e-6);
    assert!(
        off(a[0], b[0]) < 1e-6 && off(a[1], b[1]) < 1e-12,
        "{a:?} {b:?}"
    );
    let point = one.1.scan[4];
    let system = FIRST_SPRING.system(point.value);
    let request = OptimumRequest {
        of: system.motion_named("a").expect("a"),
        band: FrequencyBand::Ratio(
            FIRST_SPRING.band[0] / point.value.sqrt(),
            FIRST_SPRING.band[1] / point.value.sqrt(),
        ),
        load: None,
    };
    let there = system.optimum(&request).expect("an optimum");
    // P is the unit of β; the unit of amplitudes is P/k₁.
    assert!(off(there.beta, point.beta) < 1e-7, "{there:?} {point:?}");
    let amplitude = there.amplitude * 0.9 / point.value;
    assert!(
        off(amplitude, point.amplitude) < 1e-10,
        "{amplitude} {point:?}"
    );
}

/// What makes no sense is an error, each its own.
#[test]
fn what_makes_no_sense() {
    let system = ABSORBER.system(0.085);
    let request = OptimumRequest {
        of: system.motion_named("a").expect("a"),
        band: FrequencyBand::Ratio(0.5, 1.6),
        load: None,
    };
    let of = system.tunable_named("k2").expect("a spring");
    assert_eq!(system.tunable_named(" k  b-a "), Ok(of));
    let asked = |from: f64, to: f64| {
        let found = system.tuned_optimum(&request, &Tuning { of, from, to });
        found.expect_err("nonsense")
    };
    for (from, to) in [
        (0.2, 0.1),
        (0.1, 0.1),
        (f64::NAN, 1.0),
        (0.1, f64::INFINITY),
    ] {
        assert_eq!(asked(from, to), OptimumError::Interval, "{from} {to}");
    }
    for (from, to) in [(-0.1, 0.1), (0.0, 0.1), (0.1, 1e30)] {
        assert!(
            matches!(asked(from, to), OptimumError::Scene(_)),
            "{from} {to}"
        );
    }
    let unknown = system.tunable_named("k a - c").expect_err("no such spring");
    assert_eq!(
        unknown.known,
        [
            "m a",
            "m b",
            "k base - a",
            "k a - b",
            "mu",
            "zeta",
            "zeta 1",
            "zeta 2",
            "a",
            "b"
        ]
    );
    let band = OptimumRequest {
        band: FrequencyBand::Ratio(1.0, 1.0),
        ..request.clone()
    };
    let found = system.tuned_optimum(
        &band,
        &Tuning {
            of,
            from: 0.1,
            to: 0.2,
        },
    );
    assert_eq!(found.err(), Some(OptimumError::Width));
}
