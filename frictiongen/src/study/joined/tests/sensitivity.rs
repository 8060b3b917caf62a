//! Checks derivatives of steady states in three ways. The tests compare the derivatives with those of the solver for a
//! single contact, with differences of steady states from rest, and with two laws of scale.

use super::{FRAME, system};
use crate::study::joined::{JoinedError, JoinedParameter, JoinedSensitivities};
use crate::study::parameter::{Parameter, Slope};
use crate::study::sensitivity::{NoDerivative, OperatingPoint, Quantity};
use crate::study::units::{Load, LoadError};
use crate::{Of, System};

/// Returns the value of a parameter, and the derivatives of amplitudes and energies with respect to this parameter.
fn of(all: &JoinedSensitivities, parameter: JoinedParameter) -> Option<(f64, &[Slope], &[Slope])> {
    let mut found = all.parameters.iter();
    let found = found.find(|found| found.parameter == parameter)?;
    Some((found.value, &found.amplitudes, &found.energies))
}

/// Compares the derivatives of a scene with one contact with those of the solver for a single contact, which uses dual
/// numbers.
#[test]
fn derivatives_are_those_of_a_single_contact() {
    let single = |contact: &str, damping: &str| {
        format!(
            "struct Chain {{ masses: {{ a: 2.0, b: 1.5 }}, springs: {{ base - a: 1500.0, a - b: 1200.0 }},
            contact: b - a{contact}, excitation: a, damping: {damping}, provide: [orbit] }}"
        )
    };
    let scenes = [
        single(", stiffness: 4000.0", "modal(0.02)"),
        single("", "rayleigh(0.3, 4e-4)"),
    ];
    let points = [
        OperatingPoint::Groups {
            r: 0.45,
            beta: 0.08,
        },
        OperatingPoint::Physical {
            hertz: 3.1,
            friction: 1.2,
            load: Load::Force(11.0),
        },
        OperatingPoint::Physical {
            hertz: 5.0,
            friction: 1.2,
            load: Load::Unbalance(0.02),
        },
    ];
    let (mut compared, mut worst) = (0, 0.0_f64);
    for one in &scenes {
        let one = system(one);
        let joined = one.joined().expect("answers");
        for point in points {
            let all = joined.sensitivities(point).expect("derivatives");
            for mass in 0..2 {
                let known = one.response_sensitivities(point, Of::Mass(mass));
                for known in known.expect("derivatives").parameters {
                    let parameter = match known.parameter {
                        Parameter::Quantity(Quantity::Stiction) => continue,
                        Parameter::Quantity(Quantity::ContactStiffness) => {
                            JoinedParameter::ContactStiffness(0)
                        }
                        Parameter::Quantity(quantity) => JoinedParameter::Quantity(quantity),
                        Parameter::Friction => JoinedParameter::Friction,
                        Parameter::Load => JoinedParameter::Load,
                        Parameter::Frequency => JoinedParameter::Frequency,
                    };
                    let (value, amplitudes, _) = of(&all, parameter).expect("the parameter");
                    let got = amplitudes[mass];
                    assert_eq!(value, known.value);
                    let differs = (got.value - known.amplitude.value).abs();
                    assert!(differs < 1e-9 * got.value, "{parameter:?}: {got:?}");
                    let differs = (got.derivative - known.amplitude.derivative) * value;
                    worst = worst.max(differs.abs() / got.value);
                    compared += 1;
                }
            }
        }
    }
    println!("{compared} derivatives: {worst:.1e} of the amplitude");
    // The residual of a steady state is below 1e-11 of the motion, and the smaller step of a difference is at most
    // 2.5e-4 of the parameter.
    assert!(worst < 1e-6 && compared > 80, "{worst} {compared}");
}

/// Returns the amplitudes and energies of the steady state that the motion from rest reaches.
fn from_rest(text: &str, (r, beta): (f64, f64)) -> Vec<f64> {
    let system = system(text);
    let joined = system.joined().expect("answers");
    let orbit = joined.at(r).expect("a frequency").orbit(beta);
    let orbit = orbit.expect("a steady state");
    let energies = orbit.contacts().map(|contact| contact.energy());
    orbit.amplitudes().into_iter().chain(energies).collect()
}

/// Compares the derivatives with differences of steady states that motions from rest reach.
#[test]
fn derivatives_are_differences_of_motions_from_rest() {
    let (r, beta) = (0.6, 0.3);
    let system = system(FRAME);
    let joined = system.joined().expect("answers");
    let all = joined.sensitivities(OperatingPoint::Groups { r, beta });
    let all = all.expect("derivatives");
    // Each number in the text is replaced by a number that is larger or smaller by one ten-thousandth.
    let changes = [
        (
            JoinedParameter::Quantity(Quantity::Mass(1)),
            "upper: 1.5 }",
            "upper: ",
            1.5,
            " }",
        ),
        (
            JoinedParameter::Quantity(Quantity::Stiffness(1)),
            "upper: 1200.0",
            "upper: ",
            1200.0,
            "",
        ),
        (
            JoinedParameter::ContactStiffness(0),
            "stiffness: 4.0e3",
            "stiffness: ",
            4.0e3,
            "",
        ),
        (JoinedParameter::Share(1), "share: 0.6", "share: ", 0.6, ""),
        (
            JoinedParameter::Stiction(1),
            "stiction: 1.2",
            "stiction: ",
            1.2,
            "",
        ),
        (
            JoinedParameter::Dashpot(0),
            "upper: 1.5 },\n    damping",
            "upper: ",
            1.5,
            " },\n    damping",
        ),
    ];
    let mut worst = 0.0_f64;
    for (parameter, old, before, value, after) in changes {
        let (own, amplitudes, energies) = of(&all, parameter).expect("the parameter");
        assert_eq!(own, value, "{parameter:?}");
        let step = 1e-4 * value;
        let [above, below] = [value + step, value - step].map(|value| {
            let text = FRAME.replacen(old, &format!("{before}{value:?}{after}"), 1);
            assert_ne!(text, FRAME, "{parameter:?}");
            from_rest(&text, (r, beta))
        });
        let size = [amplitudes[1].value, energies.iter().map(|e| e.value).sum()];
        let numbers = amplitudes.iter().chain(energies).enumerate();
        for (index, slope) in numbers {
            let expected = (above[index] - below[index]) / (2.0 * step);
            let differs = (slope.derivative - expected).abs() * value;
            worst = worst.max(differs / size[usize::from(index > 1)]);
        }
    }
    println!("{worst:.1e} of the amplitude and of the energy");
    // The error of these differences is the square of 1e-4 times a third derivative of about 10.
    assert!(worst < 1e-6, "{worst}");
}

/// Checks that a load of the wrong kind is refused with a message about the load.
#[test]
fn a_load_must_be_of_the_kind_of_the_excitation() {
    let on_base = system(FRAME);
    let on_mass = system(&FRAME.replace("excitation: base", "excitation: upper"));
    for (system, load, expected) in [
        (&on_base, Load::Force(30.0), LoadError::DrivenByBase),
        (
            &on_mass,
            Load::Base(1e-3),
            LoadError::DrivenByForce("upper".to_owned()),
        ),
    ] {
        let joined = system.joined().expect("answers");
        let refused = joined.sensitivities(OperatingPoint::Physical {
            hertz: 2.6,
            friction: 9.0,
            load,
        });
        assert_eq!(refused.err(), Some(JoinedError::Load(expected)));
    }
}

/// Checks two laws of scale. If all forces grow by one factor, all displacements grow by this factor. If friction,
/// load, masses, all stiffnesses and dashpots grow by one factor, no displacement changes.
#[test]
fn derivatives_follow_the_laws_of_scale() {
    let text = FRAME
        .replace("excitation: base", "excitation: upper")
        .replace("modal(0.01)", "rayleigh(0.2, 1e-4)");
    let system = system(&text);
    let joined = system.joined().expect("answers");
    let point = OperatingPoint::Physical {
        hertz: 2.6,
        friction: 9.0,
        load: Load::Force(30.0),
    };
    let all = joined.sensitivities(point).expect("derivatives");
    let relative = |parameter, index: usize| {
        let (value, amplitudes, energies) = of(&all, parameter).expect("the parameter");
        let slope = amplitudes
            .iter()
            .chain(energies)
            .nth(index)
            .expect("a number");
        slope.relative(value).expect("a number")
    };
    use JoinedParameter::{ContactStiffness, Dashpot, Friction, Load as OfLoad, Share};
    let quantity = JoinedParameter::Quantity;
    for index in 0..4 {
        let both = relative(Friction, index) + relative(OfLoad, index);
        // Amplitudes are proportional to the forces, and energies to the squares of the forces.
        let degree = if index < 2 { 1.0 } else { 2.0 };
        assert!((both - degree).abs() < 1e-7, "{index}: {both}");
        let shares = relative(Share(0), index) + relative(Share(1), index);
        assert!(
            (shares - relative(Friction, index)).abs() < 1e-7,
            "{index}: {shares}"
        );
        let stiff = [
            quantity(Quantity::Mass(0)),
            quantity(Quantity::Mass(1)),
            quantity(Quantity::Stiffness(0)),
            quantity(Quantity::Stiffness(1)),
            ContactStiffness(0),
            Dashpot(0),
        ];
        let stiff: f64 = stiff.into_iter().map(|p| relative(p, index)).sum();
        let sum = both + stiff;
        let expected = if index < 2 { 0.0 } else { 1.0 };
        assert!((sum - expected).abs() < 1e-7, "{index}: {sum}");
    }
}

fn refused(system: &System, r: f64, beta: f64) -> JoinedError {
    let joined = system.joined().expect("answers");
    let refused = joined.sensitivities(OperatingPoint::Groups { r, beta });
    refused.expect_err("a state without derivatives")
}

#[test]
fn states_without_derivatives_are_refused_by_name() {
    let system = system(FRAME);
    let joined = system.joined().expect("answers");
    let at = joined.at(0.6).expect("a frequency");
    // At three times the limit of the stuck state all contacts stick, and the steady state is marginal.
    let beta = 3.0 * at.stuck().expect("a state").limit();
    let error = refused(&system, 0.6, beta);
    assert_eq!(error, JoinedError::NoDerivative(NoDerivative::Marginal));
    // With μ = 1, there is only one steady state. Between the frictions `low` and `high`, the numbers of stops and
    // reversals of this state change.
    let system = super::system(&FRAME.replace(", stiction: 1.2", ""));
    let joined = system.joined().expect("answers");
    let at = joined.at(0.6).expect("a frequency");
    let events = |beta: f64| -> Vec<(usize, usize)> {
        let orbit = at.orbit(beta).expect("a steady state");
        orbit
            .contacts()
            .map(|c| (c.stops(), c.reversals()))
            .collect()
    };
    let (mut low, mut high) = (0.02, 0.3);
    let (below, above) = (events(low), events(high));
    assert_ne!(below, above);
    for _ in 0..34 {
        let middle = 0.5 * (low + high);
        if events(middle) == below {
            low = middle;
        } else {
            high = middle;
        }
    }
    let error = refused(&system, 0.6, 0.5 * (low + high));
    println!("the events change at β = {low}: {error}");
    assert!(matches!(error, JoinedError::NoDerivative(_)), "{error:?}");
}
