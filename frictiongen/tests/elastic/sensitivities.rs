//! Sensitivities of responses and limits with an elastic contact, against differences.

use frictiongen::study::sensitivity::{OperatingPoint, Parameter, Quantity};
use frictiongen::study::{System, scene::Scene};
use frictiongen::{Of, Regime};

const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: 5.0e3,
    excitation: base, damping: rayleigh(0.2, 1e-3), stiction: 1.2, provide: [orbit] }";

/// Multiplies one parameter of a scene or of the point by a factor.
fn moved(scene: &Scene, point: [f64; 2], parameter: Parameter, factor: f64) -> (System, [f64; 2]) {
    let (mut scene, [mut r, mut beta]) = (scene.clone(), point);
    let times = |value: &mut f64| *value *= factor;
    match parameter {
        Parameter::Quantity(Quantity::Mass(place)) => times(&mut scene.masses[place].value),
        Parameter::Quantity(Quantity::Stiffness(place)) => {
            times(&mut scene.springs[place].stiffness)
        }
        Parameter::Quantity(Quantity::ContactStiffness) => {
            times(scene.stiffness.as_mut().expect("elastic"))
        }
        Parameter::Quantity(Quantity::Stiction) => times(&mut scene.stiction),
        Parameter::Quantity(Quantity::MassDamping) => rayleigh(&mut scene, 0, factor),
        Parameter::Quantity(Quantity::StiffnessDamping) => rayleigh(&mut scene, 1, factor),
        Parameter::Friction => times(&mut beta),
        Parameter::Frequency => times(&mut r),
        other => panic!("{other:?}"),
    }
    (System::try_from(scene).expect("a scene"), [r, beta])
}

fn rayleigh(scene: &mut Scene, which: usize, by: f64) {
    use frictiongen::study::scene::Damping::Rayleigh;
    if let Rayleigh { mass, stiffness } = &mut scene.damping {
        *[mass, stiffness][which] *= by;
    }
}

/// Every parameter, stuck and with slips.  The differences of steps of 1e-5 have errors of about 1e-8.
#[test]
fn derivatives_are_those_of_differences() {
    let system: System = FRAME.parse().expect("a scene");
    let limit = system.at(0.8).expect("in the domain").sliding_limit();
    let mut compared = 0;
    for (r, beta, regime) in [
        (0.8, 0.3 * limit, Regime::StickSlip),
        (1.3, 0.1, Regime::StickSlip),
        (0.8, 3.0 * limit, Regime::Stuck),
    ] {
        let point = OperatingPoint::Groups { r, beta };
        for of in [Of::Mass(0), Of::Contact] {
            let found = system
                .response_sensitivities(point, of)
                .expect("sensitivities");
            assert_eq!(found.regime, regime);
            for one in &found.parameters {
                let asked = |factor: f64| {
                    let (system, [r, beta]) =
                        moved(system.scene(), [r, beta], one.parameter, factor);
                    let at = system.at(r).expect("in the domain");
                    let response = at.response(beta).expect("a response");
                    let swing = response.swing(of).expect("a motion");
                    [
                        swing.amplitude,
                        swing.phase.expect("a phase"),
                        at.sliding_limit(),
                    ]
                };
                let step = 1e-5;
                let (above, below) = (asked(1.0 + step), asked(1.0 - step));
                let phase = one.phase.expect("a phase");
                let sliding = one.sliding_limit.expect("a limit");
                for (index, own) in [one.amplitude, phase, sliding].into_iter().enumerate() {
                    let difference = (above[index] - below[index]) / (2.0 * step);
                    let own = own.derivative * one.value;
                    assert!(
                        (own - difference).abs() < 1e-7 * (1.0 + difference.abs()),
                        "{:?} of {of:?} at r = {r}, number {index}: {own} for {difference}",
                        one.parameter
                    );
                    compared += 1;
                }
                let continuous = one.continuous_limit.expect("a limit");
                assert_eq!((continuous.value, continuous.derivative), (0.0, 0.0));
            }
        }
    }
    // Two masses, two springs, a, b, the stiffness of the contact, mu, beta and r.
    assert_eq!(compared, 3 * 2 * 10 * 3);
    let stiffness = system.tunable_named("stiffness").expect("a number");
    let stiffer = system.with_value(stiffness, 6.0e3).expect("a scene");
    assert_eq!(stiffer.scene().stiffness, Some(6.0e3));
    assert_eq!(stiffness.unit(), "N/m");
}
