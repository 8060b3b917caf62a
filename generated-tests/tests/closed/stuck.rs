//! Tests the frequencies at which `StuckResonance` refuses the response while the contact is stuck. The tests cover
//! emitted code and run-time systems, both precisions, and every mass. No frequency near a refused one is refused.

use frictiongen::{FrictionSystem, StuckAt, StuckResonance, System, friction_system};
use frictiongen_kernel::{Float, Scalar};

friction_system! {
    /// A symmetric chain. The contact in the middle does not touch the second mode, (1, 0, −1) at r = √2.
    pub struct Symmetric {
        masses: { left: 1, middle: 1, right: 1 },
        springs: { base - left: 1, left - middle: 1, middle - right: 1, right - wall: 1 },
        contact: middle - wall,
        excitation: left,
        provide: [limits, stuck],
    }
}

const SYMMETRIC: &str = "struct Symmetric { masses: { left: 1, middle: 1, right: 1 },
    springs: { base - left: 1, left - middle: 1, middle - right: 1, right - wall: 1 },
    contact: middle - wall, excitation: left }";

/// Description of a symmetric chain of seven masses, whose contact does not move in three of its modes.
const SEVEN: &str = "struct Seven { masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1 },
    springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 - m7: 1,
    m7 - wall: 1 }, contact: m4 - wall, excitation: m1 }";

/// Asserts that every mass is refused on the resonances with the numbers in `invisible`. No mass may be refused on
/// another resonance, or one rounding unit next to any resonance. Returns the number of answers.
fn check<F>(system: &F, invisible: &[usize]) -> usize
where
    F: FrictionSystem,
    for<'a> F::At<'a>: StuckAt<Scalar = F::Scalar>,
    F::Scalar: Float,
{
    let (mut asked, mut refused) = (0, 0);
    let one = F::Scalar::constant(1.0);
    let rounding = F::Scalar::constant(F::Scalar::EPSILON);
    for (number, resonance) in system.resonances().iter().copied().enumerate() {
        for (r, on) in [
            (resonance, true),
            (resonance * (one + rounding), false),
            (resonance * (one - rounding), false),
        ] {
            let at = system.at(r).expect("in the domain");
            for mass in 0..system.masses() {
                let answer = at.stuck_mass(mass);
                asked += 1;
                if on && invisible.contains(&number) {
                    assert_eq!(answer.err(), Some(StuckResonance), "r = {r:?}");
                    refused += 1;
                    continue;
                }
                let answer = answer.unwrap_or_else(|error| panic!("r = {r:?}: {error}"));
                let answer = answer.expect("a mass");
                assert!(answer.re.is_finite() && answer.im.is_finite(), "r = {r:?}");
            }
        }
    }
    println!("{asked} answers asked for, {refused} refused, none skipped");
    assert_eq!(refused, invisible.len() * system.masses());
    asked
}

#[test]
fn a_resonance_that_the_contact_does_not_touch() {
    let system: System = SYMMETRIC.parse().expect("a valid scene");
    let single: System<f32> = SYMMETRIC.parse().expect("a valid scene");
    let seven: System = SEVEN.parse().expect("a valid scene");
    assert_eq!(check(&Symmetric, &[1]), 27);
    assert_eq!(check(&system, &[1]), 27);
    assert_eq!(check(&single, &[1]), 27);
    assert_eq!(check(&seven, &[1, 3, 5]), 147);
    // The inherent functions must return the same results as those of the trait.
    let r = Symmetric::RESONANCES[1];
    let refused = |at: Result<_, _>| matches!(at, Err(StuckResonance));
    assert!(refused(
        Symmetric::at(r).expect("in the domain").stuck().map(|_| ())
    ));
    assert!(refused(
        system.at(r).expect("in the domain").stuck().map(|_| ())
    ));
}

#[test]
fn a_damped_one_is_bounded() {
    let text = SYMMETRIC.replace("excitation", "damping: modal(0.01), excitation");
    let system: System = text.parse().expect("a valid scene");
    assert_eq!(check(&system, &[]), 27);
    // The difference between the left and the right mass contains only the second mode. Each mass has φ² = 1/2, and λ
    // is 2, so the mode moves each mass by (1/4)/(2iζ), with opposite signs.
    let at = system.at(system.resonances()[1]).expect("in the domain");
    let stuck = at.stuck().expect("damped");
    let mass = |name| stuck.mass(name).expect("a mass");
    let apart = mass("left") - mass("right");
    assert!(
        apart.re.abs() < 1e-12 && (apart.im + 25.0).abs() < 1e-12,
        "{apart}"
    );
}

/// Checks that a mode that neither the contact nor the load drives is not in the response. The load of this scene
/// acts on the middle mass.
#[test]
fn one_that_nothing_drives_is_not_there() {
    let text = SYMMETRIC.replace("excitation: left", "excitation: middle");
    let system: System = text.parse().expect("a valid scene");
    assert_eq!(check(&system, &[]), 27);
}

/// Checks the response at a resonance of the chain with its contact stuck, where H vanishes. Mass m₁ is then between a
/// spring to the base and one that is three times as stiff. The exact response is 1/(4 − r²). With the rounding of the
/// natural frequencies it must be above 10¹⁴, or be refused.
#[test]
fn a_resonance_of_the_held_chain() {
    let text = "struct Held { masses: { m1: 1, m2: 1 }, springs: { base - m1: 1, m1 - m2: 3 },
        contact: m2 - wall, excitation: m1 }";
    let system: System = text.parse().expect("a valid scene");
    let (mut refused, mut answered) = (0, 0);
    let mut see = |answer: Result<f64, StuckResonance>, r: f64| match answer {
        Err(StuckResonance) if r == 2.0 => refused += 1,
        Err(StuckResonance) => panic!("refused at {r}"),
        Ok(x) if r == 2.0 => {
            assert!(x.abs() > 1e14, "{x} at the resonance");
            answered += 1;
        }
        Ok(x) => {
            let exact = 1.0 / (4.0 - r * r);
            // λ and r have one rounding each, and the small distance from the resonance magnifies the two roundings.
            let tolerance = 64.0 * f64::EPSILON / (2.0 - r).abs();
            assert!((x / exact - 1.0).abs() < tolerance, "{x} {exact}");
            answered += 1;
        }
    };
    for r in [2.0, 1.999_999_999, 1.99, 1.3, 0.7, 2.01, 2.000_000_001, 5.0] {
        let at = system.at(r).expect("in the domain");
        see(
            at.stuck().map(|stuck| stuck.mass("m1").expect("a mass").re),
            r,
        );
    }
    println!("{answered} answers, {refused} refused on the resonance itself");
    assert_eq!(refused + answered, 8);
    assert!(refused <= 1);
}
