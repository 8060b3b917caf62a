//! Tests a contact that the load reaches through a very weak spring. The residues of this contact are at most 1e-14
//! of the largest possible ones, but they are not noise. The reference solves the equations of two masses by hand.

use frictiongen::{FrictionSystem, LimitsAt, StuckAt, System, friction_system};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Float, Scalar};

friction_system! {
    pub struct Weak {
        masses: { m1: 1, m2: 2 },
        springs: { base - m1: 1, m1 - m2: 1e-14, m2 - wall: 3 },
        contact: m2 - wall,
        excitation: m1,
        provide: [limits, stuck],
    }
}

fn text(coupling: f64) -> String {
    format!(
        "struct Weak {{ masses: {{ m1: 1, m2: 2 }},
            springs: {{ base - m1: 1, m1 - m2: {coupling:e}, m2 - wall: 3 }},
            contact: m2 - wall, excitation: m1 }}"
    )
}

/// Compares the limits and the stuck response with formulas for the two masses that were derived by hand.
///
/// The force in the stuck contact of m₂ is κx₁ with x₁ = 1/(1 + κ − r²). β_lim without search is |V|/√(U² + (m*/r² +
/// H_c)²). Without damping, H_c = 0 and V = κ/((1 + κ − r²)(3 + κ − 2r²) − κ²). U is that of m₂ alone on its spring,
/// up to a relative κ².
fn check<F>(system: &F, coupling: f64, tolerance: f64) -> usize
where
    F: FrictionSystem,
    for<'a> F::At<'a>: LimitsAt<Scalar = F::Scalar> + StuckAt<Scalar = F::Scalar>,
    F::Scalar: Float,
{
    let compared = std::cell::Cell::new(0);
    let close = |got: F::Scalar, want: f64, what: &str, r: f64| {
        let error = (got.to_f64() / want - 1.0).abs();
        assert!(
            error < tolerance,
            "r = {r}: {what} {got:?} against {want:e}, off by {error:e}"
        );
        compared.set(compared.get() + 1);
    };
    for r in [0.3, 0.6, 0.8, 1.1, 1.7, 3.0] {
        let (first, second) = (1.0 + coupling - r * r, 3.0 + coupling - 2.0 * r * r);
        let at = system.at(F::Scalar::constant(r)).expect("in the domain");
        close(
            at.sliding_limit(),
            (coupling / first).abs(),
            "sliding limit",
            r,
        );
        let driven = coupling / (first * second - coupling * coupling);
        let own = 1.5_f64.sqrt() / r;
        let quadrature = (std::f64::consts::FRAC_PI_2 * own).tan() * own / 3.0;
        let break_away = 0.5 / (r * r);
        close(
            at.continuous_limit_without_search(),
            driven.abs() / quadrature.hypot(break_away),
            "limit without search",
            r,
        );
        let stuck = |mass| at.stuck_mass(mass).expect("no resonance").expect("a mass");
        close(stuck(0).re, 1.0 / first, "m1 while stuck", r);
        assert_eq!(stuck(1).re.to_f64(), 0.0);
        assert_eq!(stuck(0).im.to_f64(), 0.0);
        compared.set(compared.get() + 2);
    }
    let compared = compared.get();
    println!("coupling {coupling:e}: {compared} compared, none skipped");
    compared
}

/// Tolerance: 450 rounding units. The formulas that were derived by hand lose tens of rounding units near their own
/// poles.
const TOLERANCE: f64 = 1e-13;

#[test]
fn residues_that_are_small_are_not_noise() {
    let run_time = |coupling: f64| -> System { text(coupling).parse().expect("a valid scene") };
    let exact = |coupling: f64| -> System<Dd> { text(coupling).parse().expect("a valid scene") };
    let compared = [
        check(&Weak, 1e-14, TOLERANCE),
        check(&run_time(1e-14), 1e-14, TOLERANCE),
        check(&run_time(1e-20), 1e-20, TOLERANCE),
        check(&exact(1e-14), 1e-14, TOLERANCE),
        check(&exact(1e-20), 1e-20, TOLERANCE),
    ];
    assert_eq!(compared, [30; 5]);
}
