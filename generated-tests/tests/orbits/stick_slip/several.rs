//! Compares steady states that repeat after several cycles of the excitation with a run in time, for emitted and
//! run-time solvers.

use frictiongen::study::orbit::SystemOrbit;
use frictiongen::{Complex, Of, SteadyState, System};
use std::f64::consts::TAU;

/// Emits a scene. Compares its orbit, and the orbit of the run-time system of the same text, with a run in time.
macro_rules! repeats {
    ($test:ident, $period:expr, $r:expr, $beta:expr, struct $name:ident { $($body:tt)* }) => {
        mod $test {
            frictiongen::friction_system! {
                pub struct $name { $($body)* provide: [limits, orbit], }
            }
            pub mod single {
                frictiongen::friction_system! {
                    pub struct $name { $($body)* provide: [limits, orbit], scalar: f32, }
                }
            }
        }

        #[test]
        fn $test() {
            let text = stringify!(struct $name { $($body)* });
            let system: System = text.parse().expect("a scene");
            let at = system.at($r).expect("in the domain");
            let orbit = at.orbit($beta).expect("a steady state");
            assert_eq!(orbit.period(), $period);
            against_a_run(&system, ($r, $beta), &orbit);
            let emitted = $test::$name::at($r).expect("in the domain");
            let emitted = emitted.orbit($beta).expect("a steady state");
            let single = $test::single::$name::at($r as f32).expect("in the domain");
            let single = single.orbit($beta as f32).expect("a steady state");
            alike(&orbit, &emitted, 1e-13);
            alike(&orbit, &single, 2e-4);
        }
    };
}

repeats!(
    after_two_cycles, 2, 0.4076, 0.01787,
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - base, excitation: base, stiction: 2.0,
    }
);
repeats!(
    after_three_cycles, 3, 0.352, 0.1563,
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: block, stiction: 2.0,
    }
);
repeats!(
    after_five_cycles, 5, 0.25, 0.1521,
    struct Block {
        masses: { block: 1.0 }, springs: { base - block: 1.0 },
        contact: block - wall, excitation: base, damping: modal(0.03443), stiction: 3.0,
    }
);
// This motion has more segments than the orbit can store. The orbit therefore recomputes every second segment.
repeats!(
    after_five_cycles_of_many_segments, 5, 0.07241, 0.2439,
    struct Pair {
        masses: { m1: 1.0, m2: 0.4146 }, springs: { base - m1: 1.0, m1 - m2: 2.49 },
        contact: m2 - wall, excitation: base, stiction: 2.0,
    }
);

/// Compares the answers of two orbits that may differ in precision.
fn alike<T: SteadyState>(one: &SystemOrbit<'_>, other: &T, tolerance: f64) {
    use frictiongen::kernel::Float;
    assert_eq!(one.period(), other.period());
    assert_eq!(
        (one.stops(), one.reversals()),
        (other.stops(), other.reversals())
    );
    assert_eq!(one.is_symmetric(), other.is_symmetric());
    let stuck = one.stuck_fraction() - other.stuck_fraction().to_f64();
    assert!(stuck.abs() < tolerance, "{stuck:e}");
    let amplitude = other.ask(Of::Contact, |motion| motion.amplitude().to_f64());
    let apart = amplitude.expect("the contact") / one.contact().amplitude() - 1.0;
    assert!(apart.abs() < tolerance, "{apart:e}");
}

/// Compares every answer with a run from rest after the run has settled. The run is sampled at 2^12 instants of a
/// period.
fn against_a_run(system: &System, (r, beta): (f64, f64), orbit: &SystemOrbit<'_>) {
    const INSTANTS: usize = 1 << 12;
    const SETTLED: usize = 1200;
    let period = orbit.period();
    let whole = TAU * f64::from(period);
    let names: Vec<&str> = system
        .scene()
        .masses
        .iter()
        .map(|mass| mass.name.as_str())
        .collect();
    let masses = names.len();
    let mut run = system.simulation(r, beta).expect("a run");
    let on = |run: &mut frictiongen::study::simulation::SystemSimulation<'_>, mut left: f64| {
        while left > 0.0 {
            left -= run.advance(left).expect("a reach").length;
        }
    };
    for _ in 0..SETTLED * period as usize {
        on(&mut run, TAU);
    }
    // The run is at a maximum of the excitation, but the number of its cycle within the period is unknown.
    let origin = orbit.origin();
    let apart = |cycle: u32, x: f64| {
        (orbit
            .contact()
            .displacement(TAU * f64::from(cycle) - origin)
            - x)
            .abs()
    };
    let x = run.relative().0;
    let first = (0..period).min_by(|a, b| apart(*a, x).total_cmp(&apart(*b, x)));
    let first = f64::from(first.expect("a cycle"));
    let (mut worst, mut largest, mut stuck) = (0.0_f64, vec![0.0_f64; masses], 0);
    let orders = 2 * period;
    let mut components = vec![Complex::new(0.0, 0.0); orders as usize + 1];
    let step = whole / INSTANTS as f64;
    for index in 0..INSTANTS {
        // The harmonics of the orbit count τ_e from the maximum of the excitation that is nearest to τ = 0, the
        // maximum of the contact's motion.
        let angle = TAU * first + step * index as f64;
        for (mass, largest) in largest.iter_mut().enumerate() {
            let moment = run.mass(names[mass]).expect("a mass");
            let motion = orbit.mass_at(mass).expect("a mass");
            let tau = angle - origin;
            worst = worst.max((motion.displacement(tau) - moment.displacement()).abs());
            worst = worst.max((motion.velocity(tau) - moment.velocity()).abs());
            *largest = largest.max(moment.displacement().abs());
        }
        let x = run.mass(names[0]).expect("a mass").displacement();
        for (order, component) in components.iter_mut().enumerate() {
            let turned = angle * order as f64 / f64::from(period);
            *component += Complex::from_polar(2.0 * x / INSTANTS as f64, -turned);
        }
        stuck += usize::from(run.contact() == frictiongen::kernel::simulation::Contact::Stuck);
        on(&mut run, step);
    }
    assert!(worst < 1e-9, "off by {worst:e}");
    for (mass, largest) in largest.iter().enumerate() {
        let amplitude = orbit.mass_at(mass).expect("a mass").amplitude();
        // The largest sample misses the maximum by at most half the largest acceleration times the square of half a
        // step.
        assert!(
            largest - amplitude < 1e-9 && amplitude - largest < 1e-4,
            "{largest} {amplitude}"
        );
    }
    let share = stuck as f64 / INSTANTS as f64;
    assert!((share - orbit.stuck_fraction()).abs() < 0.01, "{share}");
    // The acceleration has jumps, so the trapezoidal sum has an error of about the step's square.
    let motion = orbit.mass_at(0).expect("a mass");
    for (order, found) in components.iter().enumerate() {
        let order = order as u32;
        let half = if order == 0 { 0.5 } else { 1.0 };
        let told = motion.subharmonic(order);
        assert!(
            (told - found * half).norm() < 1e-4,
            "{order}: {told} {found}"
        );
        if order.is_multiple_of(period) {
            let harmonic = motion.harmonic(order / period);
            assert!(
                (told - harmonic).norm() < 1e-13,
                "{order}: {told} {harmonic}"
            );
        }
    }
    let strongest = components.iter().skip(1).take(period as usize - 1);
    let strongest = strongest.fold(0.0, |most: f64, one| most.max(one.norm()));
    assert!(
        strongest > 1e-4,
        "the motion repeats after one cycle: {strongest:e}"
    );
    let intervals: Vec<(f64, f64)> = orbit.sticking_intervals().collect();
    assert!(
        intervals
            .iter()
            .all(|(start, _)| (0.0..whole).contains(start))
    );
    for (start, length) in &intervals {
        for part in [0.01, 0.5, 0.99] {
            let velocity = orbit.contact().velocity(start + part * length - origin);
            assert!(
                velocity.abs() < 1e-12,
                "it moves while it sticks: {velocity:e}"
            );
        }
    }
    println!(
        "period {period}: {} values within {worst:.1e}, {} intervals, {} components, strongest below the excitation {strongest:.1e}",
        2 * INSTANTS * masses,
        intervals.len(),
        components.len()
    );
}

/// Checks that the search does not report a period that is too long. A free vibration that decays slowly nearly
/// repeats after several cycles, although its final state repeats after fewer cycles.
#[test]
fn no_longer_than_it_is() {
    let one = |contact: &str, excitation: &str, stiction: f64| {
        format!(
            "struct Block {{ masses: {{ a: 1 }}, springs: {{ base - a: 1 }}, contact: a - {contact},
             excitation: {excitation}, stiction: {stiction} }}"
        )
    };
    let two = |m: f64, k: f64, excitation: &str, stiction: f64| {
        format!(
            "struct Pair {{ masses: {{ a: 1, b: {m} }}, springs: {{ base - a: 1, a - b: {k} }}, contact: b - wall,
             excitation: {excitation}, stiction: {stiction} }}"
        )
    };
    let points = [
        (
            one("base", "a", 1.9914900210889905),
            0.833277864994414,
            0.0014959268322095696,
            1,
        ),
        (
            one("base", "base", 1.2692444224818193),
            0.8184643171807298,
            0.0033660244085408127,
            1,
        ),
        (
            two(
                0.306962536677969,
                0.7882244329408343,
                "base",
                2.8014785271500657,
            ),
            0.3409563634278085,
            0.1252910943706212,
            2,
        ),
        (
            two(
                1.9351980989714754,
                0.25135574921161846,
                "a",
                1.72109970518232,
            ),
            1.2566202962426678,
            0.0022321389570099173,
            1,
        ),
        (
            one("base", "a", 2.764516441610219),
            1.0371642706935191,
            0.001896966486173567,
            1,
        ),
        (
            one("base", "base", 1.0547827191799066),
            0.8334604119401045,
            0.005051144359632517,
            1,
        ),
    ];
    for (text, r, beta, period) in &points {
        let system: System = text.parse().expect("a scene");
        let orbit = system.at(*r).expect("in the domain").orbit(*beta);
        let orbit = orbit.expect("a steady state");
        assert_eq!(orbit.period(), *period, "{text}, r = {r}, β = {beta}");
        assert!(orbit.is_stable(), "{text}");
    }
    println!("{} states compared, none skipped", points.len());
}
