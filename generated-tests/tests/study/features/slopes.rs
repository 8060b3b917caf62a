//! Tests derivatives of features, against differences between features of changed scenes.

use frictiongen::study::{
    System,
    features::{Features, InvariantQuantity, RegimeEnd, Sensed},
    sensitivity::{Parameter, Quantity},
    units::Load,
};
use frictiongen::{Of, Regime};

const CHAIN: &str = "struct Chain {
    masses: { a: 1.3, b: 0.9 },
    springs: { base - a: 2.1, a - b: 1.2 },
    contact: b - wall, excitation: base, stiction: 1.15 }";
const DAMPED: &str = "struct Chain {
    masses: { a: 1.3, b: 0.9 },
    springs: { base - a: 2.1, a - b: 1.2, b - wall: 0.4 },
    contact: a - b, excitation: b, damping: rayleigh(0.02, 0.03), stiction: 1.15 }";

/// Friction force in N.
const FRICTION: f64 = 0.3;
/// Relative step of a difference quotient. The neglected third derivative causes an error of about 1e-8, and rounding
/// an error of 1e-10.
const STEP: f64 = 1e-4;

/// Returns all features as numbers with their derivatives.
fn all(system: &System, load: Load, friction: f64) -> Vec<Sensed> {
    let features = system.features(Some(load)).unwrap();
    let beta = system.load_scale(load).unwrap().friction_ratio(friction);
    let (low, high) = (0.55, 2.8);
    let range = [low, high].map(|omega| system.frequency_ratio(omega));
    let mut found = Vec::new();
    for resonance in features.resonances() {
        found.push(resonance.frequency);
        found.extend(resonance.threshold);
    }
    found.extend(
        features
            .held_resonances()
            .into_iter()
            .map(|held| held.frequency),
    );
    found.push(features.limits_at_rest().sliding);
    let end = features.limits_at_infinity();
    found.extend([end.continuous, end.sliding]);
    found.extend(
        features
            .quasi_static_start(beta)
            .unwrap()
            .into_iter()
            .flatten(),
    );
    undamped(&features, range, &mut found);
    for range in features.sliding_ranges(beta, range).unwrap() {
        found.extend(
            [range.from_frequency, range.to_frequency]
                .into_iter()
                .flatten(),
        );
    }
    for range in features.regimes(beta, range).unwrap().0 {
        if let RegimeEnd::Continuous(sensed) | RegimeEnd::Sliding(sensed) = range.end {
            found.push(sensed);
        }
    }
    for peak in features.resonant_peaks(Of::Mass(0), beta).unwrap() {
        found.extend(peak.estimate);
        let regular = peak
            .peak
            .filter(|peak| peak.regime == Some(Regime::Continuous));
        found.extend(
            regular
                .into_iter()
                .flat_map(|peak| [peak.amplitude, peak.frequency]),
        );
    }
    for crossing in features
        .crossings(Of::Mass(0), [0.5 * beta, beta], range)
        .unwrap()
    {
        found.push(crossing.frequency);
    }
    found
}

fn undamped(features: &Features<'_>, range: [f64; 2], found: &mut Vec<Sensed>) {
    if features.system().modal().is_damped() {
        return;
    }
    for of in [Of::Contact, Of::Mass(0)] {
        for zero in features.antiresonances(of, range).unwrap() {
            found.push(zero.frequency);
        }
        for measured in [InvariantQuantity::Amplitude, InvariantQuantity::Fundamental] {
            for point in features.invariant_points(of, measured, range).unwrap() {
                found.push(point.frequency);
            }
        }
    }
}

/// Returns the scene with one parameter multiplied by `factor`.
fn changed(text: &str, load: Load, parameter: Parameter, factor: f64) -> (System, Load, f64) {
    let mut scene = text.parse::<System>().unwrap().scene().clone();
    let (mut load, mut friction) = (load, FRICTION);
    match parameter {
        Parameter::Quantity(Quantity::Mass(place)) => scene.masses[place].value *= factor,
        Parameter::Quantity(Quantity::Stiffness(place)) => {
            scene.springs[place].stiffness *= factor;
        }
        Parameter::Quantity(Quantity::Stiction) => scene.stiction *= factor,
        Parameter::Quantity(quantity) => {
            let frictiongen::study::scene::Damping::Rayleigh { mass, stiffness } =
                &mut scene.damping
            else {
                panic!("{quantity:?}");
            };
            if quantity == Quantity::MassDamping {
                *mass *= factor;
            } else {
                *stiffness *= factor;
            }
        }
        Parameter::Friction => friction *= factor,
        Parameter::Load => {
            let (Load::Force(amplitude) | Load::Base(amplitude)) = &mut load else {
                panic!("a load of constant amplitude")
            };
            *amplitude *= factor;
        }
        Parameter::Frequency => panic!("no parameter of a feature"),
    }
    (System::try_from(scene).unwrap(), load, friction)
}

fn against_differences(text: &str, load: Load) -> usize {
    let system: System = text.parse().unwrap();
    let own = all(&system, load, FRICTION);
    let mut parameters: Vec<(Parameter, f64)> = Vec::new();
    for slope in own.iter().flat_map(|sensed| &sensed.slopes) {
        if parameters
            .iter()
            .all(|(known, _)| *known != slope.parameter)
        {
            parameters.push((slope.parameter, slope.value));
        }
    }
    // The parameters are two masses, two or three springs, μ, friction, load, and damping.
    assert!(7 <= parameters.len(), "{parameters:?}");
    let mut seen = 0;
    for (parameter, value) in parameters {
        let [less, more] = [1.0 - STEP, 1.0 + STEP].map(|factor| {
            let (system, load, friction) = changed(text, load, parameter, factor);
            all(&system, load, friction)
        });
        assert_eq!(
            (less.len(), more.len()),
            (own.len(), own.len()),
            "{parameter:?}"
        );
        for ((less, more), own) in less.iter().zip(&more).zip(&own) {
            let slope = own.slopes.iter().find(|slope| slope.parameter == parameter);
            let Some(slope) = slope else { continue };
            let difference = (more.value - less.value) / (2.0 * STEP * value);
            let error = (difference - slope.derivative).abs() * value;
            assert!(
                error <= 2e-5 * (own.value.abs() + (slope.derivative * value).abs()),
                "{parameter:?} of {}: {} instead of {difference}",
                own.value,
                slope.derivative
            );
            seen += 1;
        }
    }
    println!("{} features, {seen} derivatives", own.len());
    seen
}

#[test]
fn undamped_by_differences() {
    assert!(against_differences(CHAIN, Load::Base(0.7)) > 170);
}

#[test]
fn damped_by_differences() {
    assert!(against_differences(DAMPED, Load::Force(1.9)) > 100);
}

/// Checks peaks whose width in r is a thousandth, by differences.
#[test]
fn sharp_peaks_by_differences() {
    let text = DAMPED.replace("rayleigh(0.02, 0.03)", "rayleigh(0.001, 0.001)");
    assert!(against_differences(&text, Load::Force(1.9)) > 100);
    for text in [DAMPED, text.as_str()] {
        let system: System = text.parse().unwrap();
        let load = Load::Force(1.9);
        let beta = system.load_scale(load).unwrap().friction_ratio(FRICTION);
        let features = system.features(Some(load)).unwrap();
        let peaks = features.resonant_peaks(Of::Mass(0), beta).unwrap();
        let mut smooth = peaks.iter().filter_map(|peak| peak.peak.as_ref());
        assert!(
            smooth.any(|peak| {
                7 <= peak.frequency.slopes.len() && 7 <= peak.amplitude.slopes.len()
            }),
            "{peaks:?}"
        );
    }
}

/// Checks that the frequencies of invariant points do not change if all masses and springs change by the same factor.
#[test]
fn scaled() {
    let system: System = CHAIN.parse().unwrap();
    let features = system.features(Some(Load::Base(0.7))).unwrap();
    let points = features
        .invariant_points(Of::Mass(0), InvariantQuantity::Amplitude, [0.5, 3.0])
        .unwrap();
    assert!(!points.is_empty());
    for point in points {
        let sum: f64 = point
            .frequency
            .slopes
            .iter()
            .filter(|slope| {
                matches!(
                    slope.parameter,
                    Parameter::Quantity(Quantity::Mass(_) | Quantity::Stiffness(_))
                )
            })
            .filter_map(|slope| point.frequency.relative(slope.parameter))
            .sum();
        assert!(sum.abs() < 1e-12, "{sum}");
    }
}
