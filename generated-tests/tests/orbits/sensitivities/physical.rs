//! Tests derivatives with respect to parameters in hertz, newtons and metres. They must equal differences of the
//! responses of changed descriptions, and must not depend on the order of masses and springs.

use crate::sensitivities::scene::moved;
use frictiongen::study::scene::Scene;
use frictiongen::study::units::reversed_phase;
use frictiongen::study::{
    System,
    scene::Damping,
    sensitivity::{OperatingPoint, Parameter, ParameterSensitivity, Quantity},
    units::Load,
};
use frictiongen::{NotContinuous, Of, Regime};

/// A frequency in Hz, a friction force in N, and the regime at this point.
type Place = (f64, f64, Regime);
/// A scene written with two orders of its masses and springs, with its load and the tested points.
type Case = (&'static str, &'static str, Load, &'static [Place]);

/// Scenes, each written with two orders of masses and springs. Parameters with the same symbol correspond to each
/// other.
const SCENES: &[Case] = &[
    (
        "struct A { masses: { a: 3.25, b: 3.5 }, springs: { base - a: 1190.0, a - b: 1323.0 },
         contact: b - wall, excitation: base, damping: modal[0.01, 0.02], stiction: 1.25, }",
        "struct A { masses: { b: 3.5, a: 3.25 }, springs: { a - b: 1323.0, base - a: 1190.0 },
         contact: b - wall, excitation: base, damping: modal[0.01, 0.02], stiction: 1.25, }",
        Load::Base(0.003),
        &[
            (1.75, 1.0, Regime::Continuous),
            (2.5, 2.0, Regime::StickSlip),
            (1.0, 1.0, Regime::StickSlip),
            (3.0, 80.0, Regime::Stuck),
        ],
    ),
    (
        "struct A { masses: { a: 1.0, b: 0.75, c: 1.5 },
         springs: { base - a: 100.0, a - b: 50.0, b - c: 37.5, c - wall: 25.0 }, contact: a - c,
         excitation: b, damping: rayleigh(0.0625, 0.03125), stiction: 1.5, }",
        "struct A { masses: { c: 1.5, a: 1.0, b: 0.75 },
         springs: { b - c: 37.5, c - wall: 25.0, base - a: 100.0, a - b: 50.0 }, contact: a - c,
         excitation: b, damping: rayleigh(0.0625, 0.03125), stiction: 1.5, }",
        Load::Force(10.0),
        &[
            (0.5, 0.125, Regime::Continuous),
            (0.5, 2.0, Regime::StickSlip),
            (0.5, 80.0, Regime::Stuck),
        ],
    ),
];

/// Returns amplitude in m and phase in rad of a motion, from a response without derivatives.
fn response(scene: &Scene, (hertz, friction, load): (f64, f64, Load), of: Of) -> (f64, f64) {
    let system = System::<f64>::try_from(scene.clone()).expect("a valid scene");
    let scale = system.load_scale(load).expect("a load");
    let at = system
        .at(system.frequency_ratio_at_hertz(hertz))
        .expect("in the domain");
    let beta = scale.friction_ratio(friction);
    let turned = of == Of::Contact && system.contact_is_reversed();
    let (amplitude, phase) = match (at.motion(beta), of) {
        (Ok(motion), Of::Contact) => {
            let (amplitude, phase) = (motion.contact().amplitude(), motion.contact().phase());
            (
                amplitude,
                if turned { reversed_phase(phase) } else { phase },
            )
        }
        (Ok(motion), of) => {
            let motion = motion.motion_of(of).expect("a motion");
            (motion.amplitude(), motion.phase())
        }
        (Err(NotContinuous::StickSlip), of) => {
            let orbit = at.orbit(beta).expect("an orbit");
            match of {
                Of::Contact if turned => {
                    (orbit.contact().amplitude(), orbit.reversed_contact_phase())
                }
                of => orbit
                    .ask_of(of, |motion| motion.largest())
                    .expect("a motion"),
            }
        }
        (Err(_), Of::Contact) => (0.0, 0.0),
        (Err(_), Of::Mass(mass)) => {
            let stuck = at.stuck().expect("no resonance");
            let motion = stuck.mass_at(mass).expect("a mass");
            (motion.re.hypot(motion.im), -motion.im.atan2(motion.re))
        }
        (Err(_), of) => {
            let response = at.response(beta).expect("a response");
            let motion = response.harmonic(of, 1).expect("a motion");
            (motion.re.hypot(motion.im), -motion.im.atan2(motion.re))
        }
    };
    (scale.displacement(amplitude), phase)
}

/// Returns the scene and the point after a shift of one parameter.
fn shifted(
    scene: &Scene,
    (hertz, friction, load): (f64, f64, Load),
    parameter: Parameter,
    by: f64,
) -> (Scene, (f64, f64, Load)) {
    let load_by = |by| match load {
        Load::Force(force) => Load::Force(force + by),
        Load::Base(length) => Load::Base(length + by),
        Load::BaseVelocity(velocity) => Load::BaseVelocity(velocity + by),
        Load::BaseAcceleration(acceleration) => Load::BaseAcceleration(acceleration + by),
        Load::Unbalance(unbalance) => Load::Unbalance(unbalance + by),
    };
    let still = scene.clone();
    match parameter {
        Parameter::Quantity(Quantity::DampingRatio(mode)) => {
            let mut scene = still;
            if let Damping::Modal(ratios) = &mut scene.damping {
                ratios[mode] += by;
            }
            (scene, (hertz, friction, load))
        }
        Parameter::Quantity(quantity) => (moved(scene, quantity, by), (hertz, friction, load)),
        Parameter::Friction => (still, (hertz, friction + by, load)),
        Parameter::Load => (still, (hertz, friction, load_by(by))),
        Parameter::Frequency => (still, (hertz + by, friction, load)),
    }
}

#[test]
fn in_physical_units() {
    let (mut compared, mut worst, mut invariant) = (0, 0.0_f64, 0);
    for (text, other, load, points) in SCENES {
        let systems = [text, other].map(|text| text.parse::<System>().expect("a valid scene"));
        for (hertz, friction, regime) in *points {
            let masses = systems[0].scene().masses.iter();
            let mut names: Vec<String> = masses.map(|mass| mass.name.clone()).collect();
            if let [first, .., last] = names.as_slice() {
                names.extend([format!("{last}-base"), format!("{last}-{first}")]);
            }
            names.push("contact".to_owned());
            let point = OperatingPoint::Physical {
                hertz: *hertz,
                friction: *friction,
                load: *load,
            };
            for name in &names {
                let all = [0, 1].map(|which| {
                    let system = &systems[which];
                    let of = system.motion_named(name).expect("a motion");
                    let all = system
                        .response_sensitivities(point, of)
                        .expect("derivatives");
                    assert_eq!(all.regime, *regime, "{name} at {hertz} Hz, {friction} N");
                    all.parameters
                });
                let symbol = |which: usize, found: &ParameterSensitivity| {
                    found.parameter.symbol(systems[which].scene(), &point)
                };
                // The order of masses and springs must change the derivatives only by rounding of the values.
                for found in &all[0] {
                    let twin = all[1]
                        .iter()
                        .find(|twin| symbol(1, twin) == symbol(0, found))
                        .expect("the same parameter");
                    for (a, b) in [
                        (Some(found.amplitude), Some(twin.amplitude)),
                        (found.phase, twin.phase),
                        (found.continuous_limit, twin.continuous_limit),
                        (found.sliding_limit, twin.sliding_limit),
                    ] {
                        let (Some(a), Some(b)) = (a, b) else {
                            assert_eq!(a, b);
                            continue;
                        };
                        let size = a.derivative.abs() + a.value.abs() / found.value;
                        let off = (a.derivative - b.derivative).abs();
                        assert!(
                            off <= 1e-12 * size,
                            "{name}, {}: {a:?} {b:?}",
                            symbol(0, found)
                        );
                        invariant += 1;
                    }
                }
                let scene = systems[0].scene();
                let of = systems[0].motion_named(name).expect("a motion");
                let at = (*hertz, *friction, *load);
                for found in &all[0] {
                    // The steps are powers of two near p/10³ and half of that, where p is the value of the parameter.
                    // The extrapolation leaves an error of fourth order, about 1e-8 of an answer's relative change.
                    // The rounding of the values adds 1e-11.
                    let h = (found.value.log2().floor() - 11.0).exp2();
                    let middle = response(scene, at, of);
                    let turn = std::f64::consts::TAU;
                    let near = |value: f64| value - ((value - middle.1) / turn).round() * turn;
                    let [coarse, fine] = [h, h / 2.0].map(|h| {
                        let [above, below] = [h, -h].map(|by| {
                            let (scene, at) = shifted(scene, at, found.parameter, by);
                            response(&scene, at, of)
                        });
                        let phase = (near(above.1) - near(below.1)) / (h + h);
                        [(above.0 - below.0) / (h + h), phase]
                    });
                    let answers = [(Some(found.amplitude), middle.0), (found.phase, middle.1)];
                    for (place, (slope, value)) in answers.into_iter().enumerate() {
                        let Some(slope) = slope.filter(|slope| place == 1 || slope.value != 0.0)
                        else {
                            continue;
                        };
                        assert!((value - slope.value).abs() <= 1e-12 * value.abs().max(1e-3));
                        let difference = (4.0 * fine[place] - coarse[place]) / 3.0;
                        let own = if place == 0 { value } else { 1.0 };
                        let size = slope.derivative.abs() + own / found.value;
                        let off = (difference - slope.derivative).abs() / size;
                        assert!(
                            off <= 1e-7,
                            "{name} at {hertz} Hz, {friction} N, {}: {slope:?} {difference:e}",
                            symbol(0, found)
                        );
                        worst = worst.max(off);
                        compared += 1;
                    }
                }
            }
        }
    }
    println!(
        "{compared} derivatives within {worst:.1e} of differences, {invariant} the same in another order"
    );
    assert_eq!((compared, invariant), (776, 1690));
}

/// Checks derivatives of a state whose contact is stuck at its position at rest on a moving base. In this state, the
/// masses that are not in the contact are displaced from their positions at rest too.
#[test]
fn stuck_off_its_centre() {
    let text = "struct A { masses: { a: 1.0, b: 2.0 }, springs: { base - a: 100.0, a - b: 50.0 }, contact: b - base,
        excitation: base, damping: modal(0.02) }";
    let system: System = text.parse().expect("a valid scene");
    let load = Load::Base(0.003);
    let (hertz, friction) = (1.5, 30.0);
    let size = |system: &System| {
        let scale = system.load_scale(load).expect("a load");
        let at = system
            .at(system.frequency_ratio_at_hertz(hertz))
            .expect("in the domain");
        let response = at.response(scale.friction_ratio(friction)).expect("stuck");
        assert_eq!(
            (response.regime(), response.offset()),
            (Regime::Stuck, -1.0)
        );
        scale.displacement(response.swing(Of::Mass(0)).expect("a mass").amplitude)
    };
    let point = OperatingPoint::Physical {
        hertz,
        friction,
        load,
    };
    let all = system.response_sensitivities(point, Of::Mass(0));
    let all = all.expect("derivatives").parameters;
    let here = size(&system);
    for quantity in [
        Quantity::Mass(0),
        Quantity::Stiffness(0),
        Quantity::Stiffness(1),
    ] {
        let of = Parameter::Quantity(quantity);
        let found = all.iter().find(|found| found.parameter == of);
        let found = found.expect("a derivative");
        assert!((found.amplitude.value / here - 1.0).abs() < 1e-13);
        // The step is a power of two, so that adding it causes no rounding.
        let by = found.value / 8192.0;
        let [up, down] = [by, -by].map(|by| {
            size(&System::<f64>::try_from(moved(system.scene(), quantity, by)).expect("valid"))
        });
        let expected = (up - down) / (2.0 * by);
        // The error of the difference is of the order of the step's square. The bound has a margin for the second
        // derivative.
        let scale = here / found.value;
        assert!(
            (found.amplitude.derivative - expected).abs() < 1e-6 * scale,
            "{quantity:?}: {:?} for {expected}",
            found.amplitude
        );
    }
}
