//! Tests masses beyond the contact that act as absorbers. At the natural frequencies of these masses, V (response of
//! the contact to the load) and H (response of the contact to its own force) vanish together.
//!
//! With the contact stuck, the masses beyond it have no load and do not move. The tests compare every mass, including
//! the masses beyond the contact.

use frictiongen::{FrictionSystem, LimitsAt, Regime, StuckAt, System, friction_system};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Float, Scalar};

friction_system! {
    pub struct Three {
        masses: { m1: 1, m2: 1, m3: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1 },
        contact: m2 - wall,
        excitation: m1,
        provide: [limits, stuck],
    }
}

const THREE: &str = "struct Three { masses: { m1: 1, m2: 1, m3: 1 },
    springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1 }, contact: m2 - wall, excitation: m1 }";
const FIVE: &str = "struct Five { masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
    springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
    contact: m3 - wall, excitation: m1 }";

/// Returns the frequency ratio r, and ratios on both sides of r at decreasing distances.
fn beside(r: f64) -> Vec<f64> {
    let mut ratios = vec![r, r.next_up(), r.next_down()];
    for exponent in 1..=15 {
        let distance = 10.0_f64.powi(-exponent);
        ratios.extend([r * (1.0 - distance), r * (1.0 + 3.0 * distance)]);
    }
    ratios
}

/// Function of r that returns β*_lim, and the amplitude of each mass, divided by P/k₁.
type Exact = fn(f64) -> (f64, Vec<f64>);

/// Returns the exact result for three unit masses with the contact on m₂ stuck. Mass m₁ is between two unit springs.
/// Mass m₃ hangs on m₂, which is at rest, and does not move.
fn three(r: f64) -> (f64, Vec<f64>) {
    let first = 1.0 / (2.0 - r * r);
    (first.abs(), vec![first, 0.0, 0.0])
}

/// Returns the exact result for five unit masses with the contact on m₃ stuck. Masses m₁ and m₂ oscillate between the
/// base and m₃, and the force in the contact is the force of m₂ on m₃.
fn five(r: f64) -> (f64, Vec<f64>) {
    let a = 2.0 - r * r;
    let (first, second) = (a / (a * a - 1.0), 1.0 / (a * a - 1.0));
    (second.abs(), vec![first, second, 0.0, 0.0, 0.0])
}

/// Compares every limit and every amplitude of a system at frequency ratios near `r`. Each amplitude must be within
/// `tolerance` of the largest amplitude. Returns the number of compared values and the largest error.
fn check<F>(system: &F, r: f64, exact: Exact, tolerance: f64) -> (usize, f64)
where
    F: FrictionSystem,
    for<'a> F::At<'a>: LimitsAt<Scalar = F::Scalar> + StuckAt<Scalar = F::Scalar>,
    F::Scalar: Float,
{
    let (mut compared, mut worst) = (0, 0.0_f64);
    let mut note = |got: f64, want: f64, scale: f64, what: &str, r: f64| {
        let error = (got - want).abs() / scale;
        assert!(
            error < tolerance,
            "r = {r:e}: {what} {got} against {want}, off by {error:e}"
        );
        (compared, worst) = (compared + 1, worst.max(error));
    };
    for r in beside(r) {
        // The exact values are computed for r as rounded to the system's scalar.
        let read = F::Scalar::constant(r);
        let (limit, amplitudes) = exact(read.to_f64());
        let at = system.at(read).expect("in the domain");
        note(at.sliding_limit().to_f64(), limit, limit, "limit", r);
        let at_once = system.limits_without_search(read).expect("in the domain");
        assert_eq!(at_once.sliding, at.sliding_limit(), "at r = {r:e}");
        let largest = amplitudes.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert_eq!(system.masses(), amplitudes.len());
        for (mass, want) in amplitudes.into_iter().enumerate() {
            let got = at.stuck_mass(mass).expect("no resonance").expect("a mass");
            let what = format!("mass {}", mass + 1);
            note(got.re.to_f64(), want, largest, &what, r);
            note(got.im.to_f64(), 0.0, largest, &what, r);
        }
    }
    println!("{compared} compared, none skipped; worst {worst:.1e}");
    (compared, worst)
}

/// Tolerance in double precision. At a relative distance d from the absorber's frequency, the quotient V/H has an
/// error of ε/d, where ε is the rounding unit, and the series has an error of d⁴. Both errors are equal where d⁴ is
/// somewhat above ε. At this d about a quarter of the digits is lost.
const DOUBLE: f64 = 1e-11;
const SINGLE: f64 = 1e-4;
/// Tolerance in double-double. The formula keeps three quarters of 31 digits, which would allow 1e-23. The exact
/// values, however, are in double precision.
const EXACT: f64 = 2e-15;

#[test]
fn three_masses_at_the_absorbers_frequency() {
    let system: System = THREE.parse().expect("a valid scene");
    let single: System<f32> = THREE.parse().expect("a valid scene");
    let exact: System<Dd> = THREE.parse().expect("a valid scene");
    // Each check compares 33 frequencies, each with one limit and three complex amplitudes.
    for (compared, _) in [
        check(&Three, 1.0, three, DOUBLE),
        check(&system, 1.0, three, DOUBLE),
        check(&exact, 1.0, three, EXACT),
        check(&single, 1.0, three, SINGLE),
    ] {
        assert_eq!(compared, 33 * 7);
    }
    assert_eq!(
        Three::at(1.0).expect("in the domain").regime(2.0),
        Ok(Regime::Stuck)
    );
}

/// Checks five unit masses with the contact in the middle. The natural frequencies of the two masses beyond the
/// contact, as frequency ratios, are the golden ratio and its reciprocal.
#[test]
fn two_masses_beyond_the_contact() {
    let system: System = FIVE.parse().expect("a valid scene");
    let exact: System<Dd> = FIVE.parse().expect("a valid scene");
    for r in [0.618_033_988_749_894_9, 1.618_033_988_749_895] {
        for (compared, _) in [
            check(&system, r, five, DOUBLE),
            check(&exact, r, five, EXACT),
        ] {
            assert_eq!(compared, 33 * 11);
        }
    }
}
