//! Tests the best friction of every quantity, with bounds on other quantities and under loads whose amplitude depends on
//! frequency, against maps of single steady states over friction and frequency.

use frictiongen::Of;
use frictiongen::study::{
    System,
    optimum::{FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumKind, OptimumRequest},
    response::Size,
    units::Load,
};

/// A frame of two storeys with a friction damper below the first, under base motion.
const FRAME: &str = "struct Frame { masses: { f1: 2000, f2: 2000 },
    springs: { base - f1: 1.5e6, f1 - f2: 1.5e6 }, contact: base - f1, excitation: base,
    damping: modal(0.02), damping_from: base }";
/// A block on a foundation with a rotating unbalance.
const ROTOR: &str = "struct Rotor { masses: { rotor: 50, frame: 20 },
    springs: { base - frame: 4e4, frame - rotor: 9e4 }, contact: base - frame, excitation: rotor,
    damping: modal(0.02) }";

fn frame(text: &str) -> System {
    text.parse().expect("a valid scene")
}

/// Returns the amplitude P or Y of a load at a frequency in Hz, by hand.
fn amplitude(load: Load, hertz: f64) -> f64 {
    let omega = 2.0 * std::f64::consts::PI * hertz;
    match load {
        Load::Force(force) => force,
        Load::Base(length) => length,
        Load::BaseVelocity(velocity) => velocity / omega,
        Load::BaseAcceleration(acceleration) => acceleration / omega.powi(2),
        Load::Unbalance(unbalance) => unbalance * omega.powi(2),
    }
}

/// Returns a quantity in SI units at a frequency in Hz and a friction force in N. The load is computed by hand, and the
/// steady state is followed from rest.
fn quantity(system: &System, (of, size): (Of, Size), load: Load, hertz: f64, newtons: f64) -> f64 {
    let omega = 2.0 * std::f64::consts::PI * hertz;
    let scene = system.scene();
    let (mass, stiffness) = (scene.masses[0].value, scene.springs[0].stiffness);
    let load_at = amplitude(load, hertz);
    let (length, force) = match load {
        Load::Force(_) | Load::Unbalance(_) => (load_at / stiffness, load_at),
        _ => (load_at, stiffness * load_at),
    };
    let at = system
        .at(omega * (mass / stiffness).sqrt())
        .expect("a frequency");
    // A motion with too many stops in a cycle has no answer, and neither search nor map takes it into account.
    let Ok(response) = at.response(newtons / force) else {
        return 0.0;
    };
    let value = response.largest(of, size).expect("a quantity");
    match size {
        Size::Displacement if of.is_force() => value * force,
        Size::Displacement => value * length,
        Size::Velocity => value * length * omega,
        Size::Acceleration => value * length * omega * omega,
        Size::Force => value * force,
        Size::Energy => value * force * length,
    }
}

/// Returns the largest value over a band, from 160 frequencies and golden sections around the larger maxima.
fn largest(of: impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    let place = |i: u32| from + (to - from) * f64::from(i) / 160.0;
    let values: Vec<f64> = (0..=160).map(|i| of(place(i))).collect();
    let mut best = values.iter().copied().fold(0.0, f64::max);
    for i in 1..160 {
        let [before, here, after] = [i - 1, i, i + 1].map(|place| values[place as usize]);
        if here < before || here < after || here < 0.9 * best {
            continue;
        }
        let (mut low, mut high) = (place(i - 1), place(i + 1));
        for _ in 0..22 {
            let step = 0.381_966 * (high - low);
            let (a, b) = (low + step, high - step);
            if of(a) < of(b) { low = a } else { high = b }
        }
        best = best.max(of(0.5 * (low + high)));
    }
    best
}

fn request(system: &System, of: &str, load: Load, [from, to]: [f64; 2]) -> OptimumRequest {
    let (of, size) = system.quantity_named(of).expect("a quantity");
    OptimumRequest {
        of,
        size,
        band: FrequencyBand::Hertz(from, to),
        load: Some(load),
        keep: Vec::new(),
    }
}

/// Returns best friction in N and its value in SI units.
fn physical(system: &System, request: &OptimumRequest, optimum: &Optimum) -> (f64, f64) {
    let scale = system
        .load_scale(request.load.expect("a load"))
        .expect("a scale");
    let omega = system.angular_frequency(1.0);
    let unit = match request.size {
        Size::Displacement if request.of.is_force() => scale.force(),
        Size::Displacement => scale.length(),
        Size::Velocity => scale.length() * omega,
        Size::Acceleration => scale.length() * omega * omega,
        Size::Force => scale.force(),
        Size::Energy => scale.force() * scale.length(),
    };
    (scale.friction(optimum.beta), unit * optimum.amplitude)
}

/// Checks one optimum: its value is that of the map at its friction, and no friction of the map is better.
fn check(system: &System, of: &str, load: Load, band: [f64; 2], shares: &[f64]) {
    let request = request(system, of, load, band);
    let optimum = system.optimum(&request).expect("an optimum");
    let (friction, value) = physical(system, &request, &optimum);
    let at = |newtons: f64| {
        let one = |hertz| quantity(system, (request.of, request.size), load, hertz, newtons);
        largest(one, band)
    };
    let there = at(friction);
    assert_ne!(optimum.end, OptimumEnd::WorkSpent, "{of} {load:?}");
    // The golden sections of the map have an error of 2 µHz. The height of a flat maximum is then exact, and that of a
    // maximum at a jump over frequency is below the exact one by up to 1e-5.
    let over = there / value - 1.0;
    assert!(
        -1e-5 < over && over < 1e-8,
        "{of} {load:?}: {value} {there}"
    );
    for share in shares {
        let other = at(share * friction);
        assert!(
            value <= other * (1.0 + 1e-5),
            "{of} {load:?}: {other} at {share}"
        );
    }
}

/// The best friction for drift, velocity, acceleration and spring force, each against a map near it and far from it.
#[test]
fn every_quantity_as_by_a_map() {
    let system = frame(FRAME);
    let shares = [0.7, 0.98, 1.02, 1.4];
    for of in ["f2-f1", "vel(f2)", "accel(f2)", "spring(f1-f2)"] {
        check(&system, of, Load::Base(0.002), [2.5, 9.0], &shares);
    }
}

/// The best friction under loads whose amplitude depends on frequency, against a map with the load computed by hand at
/// every frequency.
#[test]
fn loads_over_frequency_as_by_a_map() {
    let system = frame(FRAME);
    let shares = [0.7, 0.98, 1.02, 1.4];
    check(
        &system,
        "f2-base",
        Load::BaseAcceleration(2.0),
        [2.5, 9.0],
        &shares,
    );
    check(
        &system,
        "accel(f2)",
        Load::BaseAcceleration(2.0),
        [2.5, 9.0],
        &shares,
    );
    check(
        &system,
        "f2-base",
        Load::BaseVelocity(0.05),
        [2.5, 9.0],
        &shares,
    );
    check(
        &frame(ROTOR),
        "rotor",
        Load::Unbalance(0.02),
        [2.0, 14.0],
        &shares,
    );
}

/// The largest drift is bounded, and the acceleration is least within the bound. The bound is met exactly, and on the
/// other side of it the acceleration would be less.
#[test]
fn a_bound_is_met() {
    let system = frame(FRAME);
    let (load, band) = (Load::BaseAcceleration(2.0), [2.5, 9.0]);
    let free = request(&system, "accel(f2)", load, band);
    let drift = request(&system, "f2-base", load, band);
    let (without, least) = (system.optimum(&free), system.optimum(&drift));
    let (without, least) = (without.expect("an optimum"), least.expect("an optimum"));
    let (alone, _) = physical(&system, &free, &without);
    let (_, reachable) = physical(&system, &drift, &least);
    let at = |newtons: f64, of: &OptimumRequest| {
        let one = |hertz| quantity(&system, (of.of, of.size), load, hertz, newtons);
        largest(one, band)
    };
    let most = 0.5 * (reachable + at(alone, &drift));
    assert!(reachable < most && most < at(alone, &drift));
    let kept = OptimumRequest {
        keep: vec![(drift.of, drift.size, most)],
        ..free.clone()
    };
    let bounded = system.optimum(&kept).expect("an optimum");
    assert_eq!(bounded.kind, OptimumKind::Bound);
    let (friction, value) = physical(&system, &kept, &bounded);
    // Thirty bisections of the scan's interval find the friction at the bound to 1e-9.
    assert!(
        (bounded.kept[0] / most - 1.0).abs() < 1e-8,
        "{most} {bounded:?}"
    );
    let over = at(friction, &drift) / most - 1.0;
    assert!(-1e-5 < over && over < 1e-8, "{over}");
    let over = at(friction, &free) / value - 1.0;
    assert!(-1e-5 < over && over < 1e-8, "{over}");
    // Every friction of a map that keeps the bound has a larger acceleration.
    let mut inside = 0;
    for step in 1..=24 {
        let newtons = 0.125 * f64::from(step) * friction;
        if at(newtons, &drift) <= most {
            inside += 1;
            assert!(value <= at(newtons, &free) * (1.0 + 1e-9), "{newtons}");
        }
    }
    assert!(0 < inside, "no friction of the map keeps the bound");
    // A bound that the best friction keeps anyway changes nothing.
    let loose = OptimumRequest {
        keep: vec![(drift.of, drift.size, 2.0 * at(alone, &drift))],
        ..free.clone()
    };
    let same = system.optimum(&loose).expect("an optimum");
    assert!((same.beta / without.beta - 1.0).abs() < 1e-6 && same.kind == without.kind);
    // A bound below the smallest drift cannot be kept.
    let tight = OptimumRequest {
        keep: vec![(drift.of, drift.size, 0.9 * reachable)],
        ..free
    };
    let Err(OptimumError::Bounds(text)) = system.optimum(&tight) else {
        panic!("the bound is kept");
    };
    assert!(
        text.contains("f2-base") && text.contains(" mm, with "),
        "{text}"
    );
}

/// Trivial answers have a name: the slip of a locked contact, and the contact force without friction.
#[test]
fn trivial_answers_are_named() {
    let system = frame(&FRAME.replace("contact: base - f1", "contact: f2 - wall"));
    let load = Load::Base(0.002);
    for of in ["slip(contact)", "force(contact)"] {
        let request = request(&system, of, load, [2.5, 9.0]);
        let optimum = system.optimum(&request).expect("an optimum");
        assert_eq!(optimum.kind, OptimumKind::Trivial, "{of}: {optimum:?}");
    }
    let wrong = OptimumRequest {
        size: Size::Force,
        ..request(&system, "f2", load, [2.5, 9.0])
    };
    assert_eq!(
        system.optimum(&wrong).map(|best| best.beta),
        Err(OptimumError::Size)
    );
}
