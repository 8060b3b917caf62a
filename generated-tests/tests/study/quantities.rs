//! Compares the best friction for every quantity with maps of single steady states over friction and frequency. Some
//! loads have an amplitude that depends on frequency.

use frictiongen::Of;
use frictiongen::study::{
    InitialState, System,
    optimum::{
        FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumKind, OptimumOptions,
        OptimumRequest, QuantityValue, Tuning,
    },
    response::MotionQuantity,
    units::Load,
};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A frame of two storeys under base motion, with a friction damper below the first floor.
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

/// Returns the amplitude P or Y of a load at a frequency in Hz, by formulas written for this test.
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

/// Returns a quantity in SI units at a frequency in Hz and a friction force in N. The test's own formulas give the
/// load. The steady state is that of motion from rest.
fn quantity(
    system: &System,
    (of, size): (Of, MotionQuantity),
    load: Load,
    hertz: f64,
    newtons: f64,
) -> f64 {
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
    // A motion with too many stops in a cycle gives no answer. The search and the map omit this motion.
    let Ok(response) = at.response(newtons / force) else {
        return 0.0;
    };
    let value = response.largest(of, size).expect("a quantity");
    match size {
        MotionQuantity::Displacement if of.is_force() => value * force,
        MotionQuantity::Displacement => value * length,
        MotionQuantity::Velocity => value * length * omega,
        MotionQuantity::Acceleration => value * length * omega * omega,
        MotionQuantity::Force => value * force,
        MotionQuantity::Energy => value * force * length,
        MotionQuantity::Damping => value,
    }
}

/// Returns the largest value over a band, from 160 frequencies and golden section searches around the larger maxima.
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
    }
}

/// Returns the best friction in N, and the value of the quantity at this friction in SI units.
fn physical(system: &System, request: &OptimumRequest, optimum: &Optimum) -> (f64, f64) {
    let scale = system
        .load_scale(request.load.expect("a load"))
        .expect("a scale");
    let omega = system.angular_frequency(1.0);
    let unit = match request.size {
        MotionQuantity::Displacement if request.of.is_force() => scale.force(),
        MotionQuantity::Displacement => scale.length(),
        MotionQuantity::Velocity => scale.length() * omega,
        MotionQuantity::Acceleration => scale.length() * omega * omega,
        MotionQuantity::Force => scale.force(),
        MotionQuantity::Energy => scale.force() * scale.length(),
        MotionQuantity::Damping => 1.0,
    };
    (scale.friction(optimum.beta), unit * optimum.amplitude)
}

/// Checks one optimum: at its friction the map has its value, and no friction of the map has a smaller value.
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
    // The golden section searches of the map have an error of 2 µHz. The height of a flat maximum is then exact. The
    // height of a maximum at a jump over frequency is too small by up to 1e-5.
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

/// Multiples of the best friction at which the test compares the map with the search.
const SHARES: [f64; 4] = [0.7, 0.98, 1.02, 1.4];
/// The band of the frame, in Hz.
const BAND: [f64; 2] = [2.5, 9.0];

/// Checks the best friction for an acceleration, and for the base shear of a frame whose damper is fixed to the base.
/// From rest, the offset of a stuck damper loads the spring beside it, and the offset passes through 0 as friction
/// changes. Without an initial state, a stuck damper relieves this spring completely.
#[test]
fn quantities_as_by_a_map() {
    let system = frame(FRAME);
    check(&system, "accel(f2)", Load::Base(0.002), BAND, &SHARES[1..3]);
    let shear = request(&system, "shear", Load::BaseAcceleration(2.0), BAND);
    let optimum = system.optimum(&shear).expect("an optimum");
    assert_eq!(optimum.kind, OptimumKind::Trivial, "{optimum:?}");
    let system = system.starting_from(InitialState::rest(2));
    check(&system, "shear", Load::BaseAcceleration(2.0), BAND, &SHARES);
}

/// Checks the best friction under loads whose amplitude depends on frequency. The test's own formulas give the load
/// of the map at every frequency.
#[test]
fn loads_over_frequency_as_by_a_map() {
    let shares = &SHARES[1..3];
    let (frame, rotor) = (frame(FRAME), frame(ROTOR));
    check(&frame, "f2-base", Load::BaseAcceleration(2.0), BAND, shares);
    check(&rotor, "rotor", Load::Unbalance(0.02), [2.0, 14.0], shares);
}

/// Checks every quantity from rest, and every load whose amplitude depends on frequency. Long form of the two tests
/// above.
#[test]
#[ignore = "takes a minute"]
fn every_quantity_as_by_a_map() {
    let system = frame(FRAME).starting_from(InitialState::rest(2));
    for of in ["f2-f1", "vel(f2)", "accel(f2)", "spring(f1-f2)", "shear"] {
        for load in [
            Load::Base(0.002),
            Load::BaseVelocity(0.05),
            Load::BaseAcceleration(2.0),
        ] {
            check(&system, of, load, BAND, &SHARES);
        }
    }
    check(&system, "f2-base", Load::BaseVelocity(0.05), BAND, &SHARES);
}

/// Checks that trivial answers have a name: the slip of a locked contact, and the contact force without friction.
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
        size: MotionQuantity::Force,
        ..request(&system, "f2", load, [2.5, 9.0])
    };
    assert_eq!(
        system.optimum(&wrong).map(|best| best.beta),
        Err(OptimumError::Size)
    );
}

/// Checks the best acceleration of the roof under a bound on its drift. On the map the drift is within the bound, and
/// no friction of the map with a drift within the bound has a smaller acceleration. If no friction satisfies a bound,
/// the error has the best drift. `bounds_on_other_quantities` of the command's tests is the short form.
#[test]
#[ignore = "takes half a minute"]
fn bounds_hold_on_a_map() {
    let system = frame(FRAME);
    let load = Load::Base(0.002);
    let best = |of: &str| {
        let request = request(&system, of, load, BAND);
        let optimum = system.optimum(&request).expect("an optimum");
        (request, optimum)
    };
    let (own, free) = best("accel(f2)");
    let (drift, least) = best("f2-f1");
    let at = |request: &OptimumRequest, beta: f64| {
        let scale = system.load_scale(load).expect("a scale");
        let one = |hertz| {
            quantity(
                &system,
                (request.of, request.size),
                load,
                hertz,
                scale.friction(beta),
            )
        };
        largest(one, BAND)
    };
    let scale = system.load_scale(load).expect("a scale").length();
    let free_drift = at(&drift, free.beta) / scale;
    // The bound is between the best drift and the drift at the best acceleration.
    let most = 0.5 * (free_drift + least.amplitude);
    assert!(
        least.amplitude * 1.001 < most,
        "{free_drift} {}",
        least.amplitude
    );
    let within = |kept: &[QuantityValue]| {
        let options = OptimumOptions {
            kept,
            ..OptimumOptions::default()
        };
        system.optimum_with(&own, &options)
    };
    let kept = [QuantityValue {
        of: drift.of,
        size: drift.size,
        value: most,
    }];
    let found = within(&kept).expect("an optimum");
    let beta = found.beta;
    assert_eq!(found.kind, OptimumKind::Bounded);
    assert!(found.largest[0] <= most);
    let there = at(&drift, beta) / scale;
    assert!(there <= most * (1.0 + 1e-6), "{there} {most}");
    assert!(
        (there / found.largest[0] - 1.0).abs() < 1e-5,
        "{there} {}",
        found.largest[0]
    );
    // The bound decides: with slightly other friction, either the drift exceeds the bound or the acceleration is
    // larger.
    assert!(most * (1.0 - 1e-5) < there, "{there} {most}");
    let value = at(&own, beta);
    for share in [0.5, 0.8, 0.95, 1.05, 1.25, 2.0] {
        let other = share * beta;
        let holds = at(&drift, other) / scale <= most;
        assert!(!holds || value <= at(&own, other) * (1.0 + 1e-5), "{share}");
    }
    // A bound that the best friction already satisfies changes nothing.
    let wide = [QuantityValue {
        value: 1.01 * free_drift,
        ..kept[0]
    }];
    let same = within(&wide).expect("an optimum");
    assert_eq!((same.beta, same.kind), (free.beta, free.kind));
    // If the bound is below the best drift, no friction satisfies it.
    let narrow = [QuantityValue {
        value: 0.99 * least.amplitude,
        ..kept[0]
    }];
    let error = within(&narrow).map(|found| found.beta);
    let Err(OptimumError::Unreachable {
        index: 0,
        least: value,
        beta,
        value: None,
    }) = error
    else {
        panic!("{error:?}");
    };
    assert!((value / least.amplitude - 1.0).abs() < 1e-9, "{value}");
    assert!((beta / least.beta - 1.0).abs() < 1e-6, "{beta}");
    // Each of the two bounds alone can be satisfied, but no friction satisfies both bounds.
    let two = [
        QuantityValue {
            value: 1.0001 * least.amplitude,
            ..kept[0]
        },
        QuantityValue {
            of: own.of,
            size: own.size,
            value: 1.0001 * free.amplitude,
        },
    ];
    let error = within(&two).map(|found| found.beta);
    assert!(
        matches!(error, Err(OptimumError::Unreachable { index: 1, .. })),
        "{error:?}"
    );
}

/// Checks a search that the caller stops. It ends with the best friction that it has found, or with an error if it
/// has found none. The amplitude of an unfinished search is at least that of the finished one.
#[test]
fn a_stopped_search_keeps_its_best() {
    let block =
        "struct Block { masses: { block: 1 }, springs: { base - block: 1, block - wall: 1 },
        contact: block - base, excitation: base, damping: modal(0.05) }";
    let system: System = block.parse().expect("a description");
    let request = OptimumRequest {
        of: system.motion_named("block").expect("a motion"),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Ratio(0.2, 1.2),
        load: None,
    };
    let after = |most: usize| {
        let asked = AtomicUsize::new(0);
        move || asked.fetch_add(1, Ordering::Relaxed) < most
    };
    let stopped = |watch: &(dyn Fn() -> bool + Sync), vary: &[Tuning], kept: &[QuantityValue]| {
        let options = OptimumOptions {
            kept,
            vary,
            watch: Some(watch),
            ..OptimumOptions::default()
        };
        system.optimum_with(&request, &options)
    };
    let full = system.optimum(&request).expect("an optimum");
    assert_eq!(full.end, OptimumEnd::Converged);
    // More than half of the evaluations complete the result, which a caller does not stop.
    let early = after(full.evaluations / 8);
    let so_far = stopped(&early, &[], &[]).expect("the best so far");
    assert_eq!(so_far.end, OptimumEnd::Stopped);
    assert!(full.amplitude <= so_far.amplitude && so_far.amplitude.is_finite());
    assert!(so_far.bracket[0] <= full.beta && full.beta <= so_far.bracket[1]);
    let none = |error: OptimumError| assert_eq!(error, OptimumError::Stopped);
    // A scan of closed forms may give a friction from the beginning.
    match stopped(&after(0), &[], &[]) {
        Ok(first) => assert!(
            first.end == OptimumEnd::Stopped && full.amplitude <= first.amplitude,
            "{first:?}"
        ),
        Err(error) => none(error),
    }

    let of = system.tunable_named("k block - wall").expect("a number");
    let (from, to) = (1.0, 2.0);
    let tuning = [Tuning { of, from, to }];
    // Enough work for some of the 17 values, but not for all 17.
    let some = after(4 * full.evaluations);
    let best = stopped(&some, &tuning, &[]).expect("the best so far");
    assert_eq!(best.end, OptimumEnd::Stopped);
    assert!(best.scan.iter().any(|point| point.amplitude.is_nan()));
    let finished = best.scan.iter().map(|point| point.amplitude);
    let least = finished.fold(f64::INFINITY, f64::min);
    assert_eq!(best.amplitude, least);
    let alone = system.with_value(of, best.tuned[0].value).expect("a scene");
    let alone = alone.optimum(&request).expect("an optimum");
    assert!((best.amplitude / alone.amplitude - 1.0).abs() < 1e-9);
    let nothing = stopped(&after(0), &tuning, &[]);
    none(nothing.map(|_| ()).expect_err("no answer"));

    // The best friction does not satisfy the bound, so the search for the best friction within the bound begins.
    let bound = |most: f64| {
        [QuantityValue {
            of: request.of,
            size: MotionQuantity::Velocity,
            value: most,
        }]
    };
    let free = stopped(&|| true, &[], &bound(f64::INFINITY));
    let kept = bound(0.99 * free.expect("an optimum").largest[0]);
    for most in [0, full.evaluations / 4, full.evaluations / 2] {
        let found = stopped(&after(most), &[], &kept);
        none(found.map(|_| ()).expect_err("no answer"));
    }
}

/// Checks that the best friction for two quantities, each divided by a given value, is between the best friction of
/// each. At the best friction for two quantities the two quotients are equal, and no other friction gives a smaller
/// largest quotient. The maps of the test use single steady states. `several_quantities` of the command's tests is the
/// short form.
#[test]
#[ignore = "takes half a minute"]
fn two_quantities_in_balance() {
    let system = frame(FRAME);
    let load = Load::Base(0.002);
    let requests = ["f2-f1", "shear"].map(|of| request(&system, of, load, BAND));
    let scale = system.load_scale(load).expect("a scale");
    let value = |request: &OptimumRequest, beta: f64| {
        let unit = match request.of.is_force() {
            true => scale.friction(1.0),
            false => scale.length(),
        };
        let of = (request.of, request.size);
        largest(
            |hertz| quantity(&system, of, load, hertz, scale.friction(beta)),
            BAND,
        ) / unit
    };
    let weighted = |over: [f64; 2]| {
        let pairs = requests.iter().zip(over);
        let all: Vec<QuantityValue> = pairs
            .map(|(request, value)| QuantityValue {
                of: request.of,
                size: request.size,
                value,
            })
            .collect();
        let options = OptimumOptions {
            weighted: &all,
            ..OptimumOptions::default()
        };
        let found = system.optimum_with(&requests[0], &options)?;
        let ratio = found.largest[found.decisive] / over[found.decisive];
        Ok((found, ratio))
    };
    // If the given value of the other quantity is very large, one quantity alone decides.
    let alone = system.optimum(&requests[0]).expect("an optimum");
    let (first, ratio) = weighted([1.0, 1e9]).expect("an optimum");
    assert_eq!(first.decisive, 0);
    assert!((ratio / alone.amplitude - 1.0).abs() < 1e-6, "{first:?}");
    // The given values make both quotients equal at 1.2 times the best friction of the first quantity.
    let over = requests
        .each_ref()
        .map(|request| value(request, 1.2 * alone.beta));
    let (found, ratio) = weighted(over).expect("an optimum");
    let quotient = |beta: f64| {
        let each = requests
            .iter()
            .zip(over)
            .map(|(request, over)| value(request, beta) / over);
        each.fold(0.0, f64::max)
    };
    let beta = found.beta;
    assert!((quotient(beta) / ratio - 1.0).abs() < 1e-5, "{found:?}");
    for share in [0.5, 0.8, 0.9, 0.97, 1.03, 1.1, 1.3] {
        assert!(
            ratio < quotient(share * beta) * (1.0 + 1e-5),
            "{share} {found:?}"
        );
    }
    for over in [[0.0, 1.0], [1.0, f64::NAN], [f64::INFINITY, 1.0]] {
        let error = weighted(over).map(|(_, ratio)| ratio);
        assert_eq!(error, Err(OptimumError::Weight));
    }
}
