//! Checks derivatives of steady states in three ways. The tests compare the derivatives with those of the solver for a
//! single contact, with differences of steady states from rest, and with two laws of scale.

use super::{FRAME, system};
use crate::study::joined::parameter::JoinedPoint;
use crate::study::joined::sensitivity::operating;
use crate::study::joined::{JoinedError, JoinedParameter, JoinedSensitivities};
use crate::study::parameter::{Parameter, Slope};
use crate::study::sensitivity::{NoDerivative, OperatingPoint, Quantity};
use crate::study::units::{Load, LoadError};
use crate::{Of, Regime, System};

/// Returns the value of a parameter, the amplitudes and the energies, with their derivatives with respect to it.
fn of(all: &JoinedSensitivities, parameter: JoinedParameter) -> Option<(f64, [Vec<Slope>; 2])> {
    let mut found = all.parameters.iter();
    let found = found.find(|found| found.parameter == parameter)?;
    let energies = found.contacts.iter().map(|contact| contact.energy);
    Some((found.value, [found.amplitudes.clone(), energies.collect()]))
}

/// Returns the parameter of several contacts that corresponds to a parameter of a single contact.
fn of_several(parameter: Parameter) -> JoinedParameter {
    match parameter {
        Parameter::Quantity(Quantity::Stiction) => JoinedParameter::Stiction(0),
        Parameter::Quantity(Quantity::ContactStiffness) => JoinedParameter::ContactStiffness(0),
        Parameter::Quantity(quantity) => JoinedParameter::Quantity(quantity),
        Parameter::Friction => JoinedParameter::Friction,
        Parameter::Load => JoinedParameter::Load,
        Parameter::Frequency => JoinedParameter::Frequency,
    }
}

/// Compares amplitudes and phases of a scene with one contact, and their derivatives, with those of the solver for a single
/// contact. It uses closed forms, or modes in double-double.
#[test]
fn derivatives_are_those_of_a_single_contact() {
    let single = |contact: &str, excitation: &str, rest: &str| {
        format!(
            "struct Chain {{ masses: {{ a: 2.0, b: 1.5 }}, springs: {{ base - a: 1500.0, a - b: 1200.0 }},
            contact: {contact}, excitation: {excitation}, {rest}, provide: [orbit] }}"
        )
    };
    let scenes = [
        single("b - a, stiffness: 4000.0", "a", "damping: modal(0.02)"),
        single("b - a", "a", "damping: rayleigh(0.3, 4e-4)"),
        single("b - wall, stiction: 1.2", "a", "damping: modal(0.02)"),
        single("b - a", "base", "damping: modal(0.02), damping_from: base"),
        single("a - base", "base", "damping: rayleigh(0.3, 4e-4)"),
        single("b - wall", "a", "damping: none"),
    ];
    let points = |is_force: bool| {
        let load = |force: f64| match is_force {
            true => Load::Force(force),
            false => Load::Base(1e-3 * force),
        };
        let other = match is_force {
            true => Load::Unbalance(0.02),
            false => Load::BaseAcceleration(5.0),
        };
        let physical = |hertz, friction, load| OperatingPoint::Physical {
            hertz,
            friction,
            load,
        };
        let groups = |r, beta| OperatingPoint::Groups { r, beta };
        [
            groups(0.45, 0.08),
            groups(0.31, 0.3),
            groups(0.9, 3.0),
            physical(3.1, 1.2, load(11.0)),
            physical(1.4, 4.5, load(11.0)),
            physical(5.0, 1.2, other),
        ]
    };
    let mut cases: Vec<(String, OperatingPoint)> = Vec::new();
    for scene in scenes {
        let all = points(scene.contains("excitation: a"));
        cases.extend(all.map(|point| (scene.clone(), point)));
    }
    // This state has a period of two cycles.
    let rubbing =
        "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - base,
        excitation: base, stiction: 2, provide: [orbit] }";
    let (r, beta) = (0.4076, 0.01787);
    cases.push((rubbing.to_owned(), OperatingPoint::Groups { r, beta }));
    let (mut compared, mut regimes, mut worst) = (0, [0; 3], 0.0_f64);
    for (text, point) in &cases {
        let (regime, count, differs) = differs_from_single(text, *point);
        println!("{point:?} {regime:?} {count} {differs:.1e}");
        regimes[regime as usize] += 1;
        (compared, worst) = (compared + count, worst.max(differs));
    }
    println!("{compared} derivatives, {regimes:?}: {worst:.1e}");
    assert!(worst < 1e-11 && compared > 1300, "{worst} {compared}");
}

/// Returns the regime of a steady state of a scene with one contact, the number of derivatives, and their largest difference
/// from those of the solver for a single contact.
fn differs_from_single(text: &str, point: OperatingPoint) -> (Regime, usize, f64) {
    let one = system(text);
    let joined = one.joined().expect("answers");
    let all = joined.sensitivities(point).expect("derivatives");
    let (mut compared, mut worst) = (0, 0.0_f64);
    for mass in 0..one.scene().masses.len() {
        let known = one.response_sensitivities(point, Of::Mass(mass));
        for known in known.expect("derivatives").parameters {
            let parameter = of_several(known.parameter);
            let mut found = all.parameters.iter();
            let found = found.find(|found| found.parameter == parameter);
            let found = found.expect("the parameter");
            let still = Slope {
                value: 0.0,
                derivative: 0.0,
            };
            let phase = found.phases[mass].unwrap_or(still);
            let pairs = [
                (
                    found.amplitudes[mass],
                    known.amplitude,
                    known.amplitude.value,
                ),
                (phase, known.phase.unwrap_or(still), 1.0),
            ];
            for (got, expected, size) in pairs {
                let differs = (got.value - expected.value).abs();
                assert!(
                    differs <= 1e-9 * size,
                    "{parameter:?}: {got:?} {expected:?}"
                );
                // Next to a resonance or a fold the derivatives are large.
                let size = size + (expected.derivative * found.value).abs();
                let differs = (got.derivative - expected.derivative).abs() * found.value;
                worst = worst.max(if differs == 0.0 { 0.0 } else { differs / size });
                compared += 1;
            }
        }
    }
    (all.regime, compared, worst)
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
        let (own, [amplitudes, energies]) = of(&all, parameter).expect("the parameter");
        assert_eq!(own, value, "{parameter:?}");
        let step = 1e-4 * value;
        let [above, below] = [value + step, value - step].map(|value| {
            let text = FRAME.replacen(old, &format!("{before}{value:?}{after}"), 1);
            assert_ne!(text, FRAME, "{parameter:?}");
            from_rest(&text, (r, beta))
        });
        let size = [amplitudes[1].value, energies.iter().map(|e| e.value).sum()];
        let numbers = amplitudes.iter().chain(&energies).enumerate();
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
        let (value, numbers) = of(&all, parameter).expect("the parameter");
        let slope = numbers.iter().flatten().nth(index).expect("a number");
        slope.relative(value).expect("a number")
    };
    use JoinedParameter::{ContactStiffness, Dashpot, Friction, Load as OfLoad, Share};
    let quantity = JoinedParameter::Quantity;
    for index in 0..4 {
        let both = relative(Friction, index) + relative(OfLoad, index);
        // Amplitudes are proportional to the forces, and energies to the squares of the forces.
        let degree = if index < 2 { 1.0 } else { 2.0 };
        assert!((both - degree).abs() < 1e-11, "{index}: {both}");
        let shares = relative(Share(0), index) + relative(Share(1), index);
        assert!(
            (shares - relative(Friction, index)).abs() < 1e-11,
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
        assert!((sum - expected).abs() < 1e-11, "{index}: {sum}");
    }
}

fn refused(system: &System, r: f64, beta: f64) -> JoinedError {
    let joined = system.joined().expect("answers");
    let refused = joined.sensitivities(OperatingPoint::Groups { r, beta });
    refused.expect_err("a state without derivatives")
}

#[test]
fn states_without_derivatives_are_refused_by_name() {
    // The constant force keeps the contacts away from the middle, where the motion from rest leaves them.
    let pushed = FRAME.replace("damping: modal", "constant: { upper: 3.0 }, damping: modal");
    let joined = system(&pushed);
    let joined = joined.joined().expect("answers");
    let stuck = OperatingPoint::Physical {
        hertz: 2.6,
        friction: 90.0,
        load: Load::Base(2e-3),
    };
    let error = joined.sensitivities(stuck).expect_err("a continuum");
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
    assert_eq!(error, JoinedError::NoDerivative(NoDerivative::Graze));
    // The bound of the conditions is 1e-9 of the watched quantity.
    for beta in [low * (1.0 - 1e-4), high * (1.0 + 1e-4)] {
        let point = OperatingPoint::Groups { r: 0.6, beta };
        assert!(joined.sensitivities(point).is_ok(), "{beta}");
    }
}

/// Compares the derivatives of motions with stops, moving surfaces, Stribeck's law, damping relative to the base, free
/// masses and several cycles in a period with central differences of steady states.
#[test]
fn derivatives_are_differences_of_steady_states() {
    let chain = |contacts: &str, rest: &str| {
        format!(
            "struct Chain {{ masses: {{ a: 2.0, b: 1.5, c: 1.0 }},
            springs: {{ base - a: 1500.0, a - b: 1200.0, b - c: 900.0 }},
            contacts: {{ {contacts} }}, {rest} }}"
        )
    };
    let two = "first: a - base, second: c - b { share: 0.5, stiction: 1.1 }";
    let mixed = "first: a - base { stiffness: 3e3 }, second: c - b { share: 0.5, stiction: 1.1 }";
    let force = |hertz, friction, force| OperatingPoint::Physical {
        hertz,
        friction,
        load: Load::Force(force),
    };
    let base = |hertz, friction, base| OperatingPoint::Physical {
        hertz,
        friction,
        load: Load::Base(base),
    };
    let scenes = [
        (chain(two, "damping: modal(0.02), excitation: c"), force(2.1, 3.0, 9.0)),
        (
            chain(mixed, "damping: modal(0.02), damping_from: base, excitation: base"),
            base(2.1, 2.0, 4e-3),
        ),
        (
            chain(two, "damping: rayleigh(0.2, 1e-4), damping_from: base, excitation: base"),
            base(1.3, 0.5, 4e-3),
        ),
        (
            chain(mixed, "dampers: { b - wall: 3.0 }, friction: stribeck(0.05: 0.7, 0.3: 0.5), damping: modal(0.02), excitation: c"),
            force(2.1, 3.0, 9.0),
        ),
        (
            chain(two, "stops: { bump: c - wall { gap: 4e-3, stiffness: 5e3, damping: 2.0 } }, damping: modal(0.02),
                excitation: c"),
            force(2.1, 3.0, 9.0),
        ),
        (
            chain(two, "stops: { bump: c - wall { gap: 4e-3, restitution: 0.6 } }, damping: modal(0.02), excitation: c"),
            force(2.1, 3.0, 9.0),
        ),
        (
            chain("first: a - base { speed: 0.02 }, second: c - b { share: 0.5 }", "damping: modal(0.02), excitation: c"),
            force(2.1, 3.0, 9.0),
        ),
        (
            chain(two, "constant: { b: 1.0 }, damping: modal(0.02), excitation: c"),
            force(2.1, 3.0, 9.0),
        ),
        (
            "struct Free { masses: { a: 2.0, b: 1.5, c: 1.0 }, springs: { a - b: 1200.0, b - c: 900.0 },
            contacts: { first: a - b { stiffness: 4e3 }, second: b - c { share: 0.5 } }, damping: modal(0.02),
            excitation: c }".to_owned(),
            force(4.1, 3.0, 9.0),
        ),
    ];
    let (mut worst, mut regimes) = (0.0_f64, [0; 3]);
    for (text, point) in &scenes {
        for factor in [1.0, 2.0] {
            let mut point = *point;
            if let OperatingPoint::Physical { friction, .. } = &mut point {
                *friction *= factor;
            }
            match differs(text, point) {
                Ok((regime, differs)) => {
                    println!("{point:?} {regime:?}: {differs:.1e}");
                    regimes[regime as usize] += 1;
                    worst = worst.max(differs);
                }
                // A contact rests away from its middle, or a stop bounces ever faster until it rests.
                Err(error) => println!("{point:?}: {error}"),
            }
        }
    }
    println!("{regimes:?}: {worst:.1e}");
    assert!(
        worst < 1e-7 && regimes.iter().sum::<usize>() > 14,
        "{worst}"
    );
}

/// Returns the regime of a steady state, and the largest difference of its relative derivatives from central differences
/// with Richardson's extrapolation.
fn differs(text: &str, point: OperatingPoint) -> Result<(Regime, f64), JoinedError> {
    let own = system(text);
    let joined = own.joined().expect("answers");
    let all = joined.sensitivities(point)?;
    let setting = JoinedPoint::new(joined.scene(), point);
    let mut largest = 0.0_f64;
    for found in &all.parameters {
        // A μ below 1 does not exist.
        let is_least =
            matches!(found.parameter, JoinedParameter::Stiction(_)) && found.value == 1.0;
        if is_least {
            continue;
        }
        let [coarse, fine] = [2e-4, 1e-4].map(|step| -> Vec<f64> {
            let step = step * found.value;
            let ends = [found.value + step, found.value - step];
            let [above, below] = ends.map(|value| numbers(&setting.with(found.parameter, value)));
            let pairs = above.iter().zip(below);
            pairs
                .map(|(above, below)| (above - below) / (2.0 * step))
                .collect()
        });
        let contacts = found.contacts.iter().flat_map(|own| {
            [
                own.energy,
                own.force,
                own.slip,
                own.displacement,
                own.stuck_fraction,
            ]
        });
        let slopes = found.amplitudes.iter().copied().chain(contacts);
        for (index, slope) in slopes.enumerate() {
            let expected = fine[index] + (fine[index] - coarse[index]) / 3.0;
            let size = slope.value.abs() + (slope.derivative * found.value).abs();
            let away = (slope.derivative - expected).abs() * found.value / size.max(1e-4);
            if away > 1e-7 {
                println!("{:?} {index} {slope:?} {expected:e}", found.parameter);
            }
            largest = largest.max(away);
        }
    }
    Ok((all.regime, largest))
}

/// Returns the numbers of a steady state in the order of the test.
fn numbers(setting: &JoinedPoint) -> Vec<f64> {
    let own = System::try_from(setting.scene.clone()).expect("a system");
    let joined = own.joined().expect("answers");
    let (at, friction) = operating(&own, &joined, setting.point).expect("a point");
    let orbit = at.orbit(friction).expect("a steady state");
    let contacts = orbit.contacts().flat_map(|own| {
        [
            own.energy(),
            own.force(),
            own.slip(),
            own.displacement(),
            own.stuck_fraction(),
        ]
    });
    orbit.amplitudes().into_iter().chain(contacts).collect()
}
