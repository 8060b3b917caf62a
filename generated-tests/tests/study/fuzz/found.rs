//! Regression tests of faults that the long fuzz runs found.

use crate::fuzz::text::expanded;
use frictiongen::kernel::Float;
use frictiongen::{NoOrbit, Regime, System, Unsupported};

/// Returns the scene of a text in the precision `S`.
fn system<S: Float>(text: &str) -> System<S> {
    text.parse().expect("a sound scene")
}

/// Asserts that the contact has a finite motion in 24 cycles from rest.
fn stays_finite(system: &System, r: f64, beta: f64) {
    let mut run = system.simulation(r, beta).expect("in the domain");
    for _ in 0..24 {
        run.advance(std::f64::consts::TAU).expect("a reach");
        let (z, velocity) = run.run().relative();
        assert!(z.is_finite() && velocity.is_finite(), "{z}, {velocity}");
    }
}

/// Checks that the parser refuses a group in parentheses that is no visibility. Its emission would not be valid Rust.
#[test]
fn a_visibility_that_is_none() {
    let rest =
        "struct C { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a }";
    for faulty in ["pub(m)", "pub(crate::fuzz::a)", "pub(::crate)"] {
        let text = format!("{faulty} {rest}");
        let errors = text.parse::<System>().expect_err("no visibility");
        assert!(errors.to_string().contains("a visibility is"), "{errors}");
        expanded(&text).expect("Rust all the same");
    }
    for sound in [
        "",
        "pub",
        "pub(crate)",
        "pub(self)",
        "pub(super)",
        "pub(in crate::fuzz::a)",
    ] {
        assert!(
            format!("{sound} {rest}").parse::<System>().is_ok(),
            "{sound}"
        );
    }
}

/// Checks that the parser refuses tokens that are no path of the facade. Their emission would not be valid Rust.
#[test]
fn a_facade_that_is_no_path() {
    let scene = |facade: &str| {
        format!(
            "struct C {{ masses: {{ a: 1 }}, springs: {{ base - a: 1 }}, contact: a - wall, excitation: a, \
             crate: {facade} }}"
        )
    };
    for faulty in [
        "in::frictiongen",
        "struct",
        "_",
        "_ ::frictiongen",
        "a::pub",
    ] {
        let text = scene(faulty);
        assert!(text.parse::<System>().is_err(), "{faulty}");
        expanded(&text).expect("Rust all the same");
    }
    for sound in [
        "::frictiongen",
        "crate::fuzz::facade",
        "super::renamed",
        "r#in::facade",
    ] {
        assert!(scene(sound).parse::<System>().is_ok(), "{sound}");
        expanded(&scene(sound)).expect("Rust");
    }
}

/// A scene whose second resonance lies at r = 3.2e5.
const SPREAD: &str = "struct Spread {
    masses: { a: 1.0, b: 1e-6 }, springs: { base - a: 1.0, a - b: 1e5 },
    contact: b - base, excitation: base }";

/// Checks that the square of √λ/r stays finite in `f32` at the smallest r at which the formulas are evaluated.
#[test]
fn a_high_resonance_at_a_small_ratio() {
    let system = system::<f32>(SPREAD);
    for r in [1e-45_f32, 1.6e-37, 1.5e-18, 1e-12] {
        let at = system.at(r).expect("a ratio");
        assert!(at.continuous_limit() >= 0.0, "{r}: {at:?}");
        assert!(at.continuous_limit_without_search() >= 0.0, "{r}: {at:?}");
        assert!(at.continuous_limit_per_mode() >= 0.0, "{r}: {at:?}");
    }
}

/// Checks a contact on the moving base at r = ∞, where both limits are infinite and the motion is that without
/// friction. The system must not report a large β as stick-slip.
#[test]
fn any_friction_on_a_moving_base_at_infinity() {
    let system = system::<f32>(SPREAD);
    let at = system.at(f32::INFINITY).expect("a ratio");
    for beta in [0.0, 1.0, f32::MAX] {
        assert_eq!(at.regime(beta), Ok(Regime::Continuous));
        let motion = at.motion(beta).expect("continuous");
        // The base moves, and the mass does not.
        assert_eq!(motion.contact().amplitude(), 1.0);
    }
}

/// A scene with almost no damping.
const FAINT: &str = "struct Faint {
    masses: { a: 1.0, b: 1.0 }, springs: { base - a: 1.0, a - b: 1.0 },
    contact: b - wall, excitation: a, damping: modal(1e-30) }";

/// Checks that 1/V does not overflow far above all resonances. Far above all resonances V consists only of its damping
/// term, because rounding removes the other terms.
#[test]
fn a_response_too_small_for_its_reciprocal() {
    let system = system::<f32>(FAINT);
    for r in [1.4839235e11_f32, 1e13, 1e15] {
        let at = system.at(r).expect("a ratio");
        let motion = at.motion(0.0).expect("without friction there is a motion");
        let mass = motion.mass("a").expect("a mass");
        // Without friction the loaded mass has the displacement x̄ = 1/r² at this r.
        assert!(
            (mass.amplitude() * r * r - 1.0).abs() < 1e-5,
            "{}",
            mass.amplitude()
        );
        assert!((mass.amplitude_monoharmonic() * r * r - 1.0).abs() < 1e-5);
    }
}

const STILL: &str = "struct Still {
    masses: { a: 1.0, b: 1.0 }, springs: { base - a: 1.0, a - b: 1.0 },
    contact: b - wall, excitation: a }";

/// Checks that the code computes the number of quadrature panels directly. A loop that counts up to the rate of the
/// modes would never end in `f32`.
#[test]
fn a_harmonic_far_below_the_resonances() {
    let system = system::<f32>(STILL);
    for r in [1e-9_f32, 1e-6] {
        let at = system.at(r).expect("a ratio");
        let orbit = at.orbit(10.0).expect("stuck");
        let mass = orbit.mass("a").expect("a mass");
        // The stuck mass acts against both springs, so x̄ is 1/2.
        let x = mass.harmonic(1);
        // The sum has 2^14 panels with one rounding each, so its relative error is at most 2^14 · 2^-25.
        assert!((x.re - 0.5).abs() < 2.5e-4 && x.im.abs() < 2.5e-4, "{x:?}");
        assert!(mass.harmonic(u32::MAX).re.abs() <= 1.0);
    }
}

const FAST: &str = "struct Fast {
    masses: { a: 1.0, b: 0.7 }, springs: { base - a: 1.0, a - b: 1.3 },
    contact: a - b, excitation: b, damping: modal(1.0) }";

/// Checks that a motion that underflows is zero at every instant, and that the search for its maximum ends.
#[test]
fn a_motion_that_is_all_zero() {
    let system = system::<f32>(FAST);
    let at = system.at(2.6789888e8).expect("a ratio");
    let orbit = at.orbit(at.continuous_limit() * 1.000_494_4);
    let orbit = orbit.expect("a steady state");
    // At this r the displacement x̄ is below 1/r², which is 1.4e-17.
    let amplitude = orbit.mass("a").expect("a mass").amplitude();
    assert!(amplitude < 2e-17, "{amplitude}");
}

/// Checks that the recording of a cycle from event to event ends even if r is below the rounding of 1, where the
/// cycle would need too many steps.
#[test]
fn a_cycle_of_too_many_turns() {
    let text = "struct R { masses: { a: 3.4233933483554577, b: 0.6278288469607384, c: 3.756799589337862,
        d: 3.0227642687030514 }, springs: { base - a: 0.45667147705398964, a - b: 0.4516504383832916,
        b - c: 0.2381738254712511, c - d: 0.9309229793257213 }, contact: b - wall, excitation: base,
        damping: rayleigh(0.050634208209306135, 0.09476255404592096), stiction: 2.0158022017583335 }";
    let system: System = text.parse().expect("a sound scene");
    let at = system.at(f64::EPSILON).expect("a ratio");
    let orbit = at.orbit(0.2690065403843426 * at.continuous_limit());
    assert_eq!(orbit.err(), Some(NoOrbit::Unsettled));
}

/// Checks that the contribution of a mode does not become 0/0. The contact moves this mode by 1e-18 of the motion of
/// the other modes. While the contact is stuck, no digit of a double-double shows a motion of this mode.
#[test]
fn a_mode_that_the_contact_hardly_touches() {
    let text = "struct R { masses: { a: 0.35, b: 2.4e5, c: 1.6, d: 0.19 },
        springs: { base - a: 4.3, a - b: 7.7e5, b - c: 0.76, c - d: 1.1 }, contact: d - base,
        excitation: c, damping: modal(2.14), stiction: 1.98 }";
    let system: System = text.parse().expect("a sound scene");
    let sliding = system.at(119.3).expect("a ratio").sliding_limit();
    stays_finite(&system, 119.3, 0.8 * sliding);
}

const CARRIED: &str = "struct Carried {
    masses: { a: 8e-5, b: 0.52, c: 0.1 }, springs: { base - a: 1.2, a - b: 3.6, b - c: 3.9 },
    contact: c - base, excitation: base, damping: modal(1) }";

/// Checks a very large β on a moving base. Both limits grow as r², so β can be so large that multiplication by a
/// scale would overflow.
#[test]
fn a_friction_ratio_as_large_as_it_gets() {
    let system = system::<f32>(CARRIED);
    let at = system.at(2.8e37).expect("a ratio");
    let motion = at.motion(0.03 * at.continuous_limit()).expect("continuous");
    let mass = motion.mass("b").expect("a mass");
    for amplitude in [mass.amplitude(), mass.amplitude_monoharmonic()] {
        assert!(amplitude.is_finite(), "{amplitude}");
    }
}

const SHAKEN: &str = "struct Shaken {
    masses: { a: 1.0, b: 0.7 }, springs: { base - a: 1.0, a - b: 1.3 },
    contact: b - base, excitation: base, damping: modal[0.01, 0.02] }";

/// Checks that the load of a stuck mode on a moving base is not computed by way of r³, which overflows.
#[test]
fn a_base_that_shakes_faster_than_a_cube_can_hold() {
    let r = 1e116;
    let system = system::<f64>(SHAKEN);
    let beta = system.at(r).expect("a ratio").continuous_limit();
    stays_finite(&system, r, beta);
}

const CREEPING: &str = "struct Creeping {
    masses: { a: 1.0, b: 0.7 }, springs: { base - a: 1.0, a - b: 1.3 },
    contact: a - b, excitation: b, damping: modal(1) }";

/// Checks that without friction the multipliers do not become 0/0. Without friction nothing jumps at a reversal,
/// however slowly the contact passes it.
#[test]
fn multipliers_without_friction() {
    let system = system::<f32>(CREEPING);
    let at = system.at(5.124_947e-4).expect("a ratio");
    let orbit = at.orbit(0.0).expect("a steady state");
    for multiplier in orbit.multipliers() {
        assert!(multiplier.re.is_finite() && multiplier.im.is_finite());
    }
}

/// Checks that no contribution consists of rounding only. The contact moves one mode by 1e-27. In double precision
/// this mode is also a mode of the stuck chain, but not in the last digits of a double-double.
#[test]
fn a_mode_whose_share_is_all_rounding() {
    let text = "struct R { masses: { a: 2.4462350119996397, b: 7.35905547834189, c: 1.8784094014138872,
        d: 0.3618976964314165 }, springs: { base - a: 0.16197076457801876, a - b: 144438.29095783064,
        b - c: 7.507119145768243e-5, c - d: 6.781542474873392 }, contact: d - wall, excitation: b,
        damping: modal(1), stiction: 1.694914197041189 }";
    let system: System = text.parse().expect("a sound scene");
    stays_finite(&system, 0.370_744, 1.0 / 60.0);
}

const TINY: &str = "struct Tiny {
    masses: { a: 3.7e4, b: 2.7, c: 2.5e-6 }, springs: { base - a: 0.35, a - b: 0.15, b - c: 1.4 },
    contact: c - base, excitation: base, damping: rayleigh(0.0023, 0.16) }";

/// Checks a light mass on a moving base, where V grows as r². The product of V and the inverse effective mass must
/// stay finite in `f32`.
#[test]
fn a_light_mass_on_a_fast_base() {
    let system = system::<f32>(TINY);
    let at = system.at(8.5e36).expect("a ratio");
    let motion = at.motion(4.4e-12).expect("continuous");
    let mass = motion.mass("c").expect("a mass");
    let (exact, estimate) = (mass.amplitude(), mass.amplitude_monoharmonic());
    assert!(0.0 < exact && exact <= estimate, "{exact} {estimate}");
}

/// Checks that the friction force from which the contact sticks is not infinite.
#[test]
fn friction_that_overflows() {
    let most = f64::MAX;
    assert!(system::<f64>(SHAKEN).simulation(0.5, most).is_ok());
    let text = "struct R { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall,
        excitation: base, stiction: 2 }";
    let system = system::<f64>(text);
    assert!(system.simulation(0.5, most).is_err());
    assert!(system.simulation(0.5, most / 4.0).is_ok());
}

/// Checks a mode whose phase changes significantly by rounding, so that two searches may differ. The system must not
/// return a regime of stick-slip and a continuous motion for the same point.
#[test]
fn a_sweep_too_slow_for_two_searches() {
    let text = "struct R { masses: { a: 4.774003736351606, b: 3.6965901884292873,
        c: 0.8106351209296832 }, springs: { base - a: 0.22183498329861595,
        a - b: 182301.42005847045, b - c: 1.2420023925764312 }, contact: c - b, excitation: b,
        damping: modal(1.3333195107448167e-14), stiction: 2.7203322719229726 }";
    let system: System<f32> = text.parse().expect("a sound scene");
    let at = system.at(5.737_087e-4).expect("a ratio");
    let beta = 1.027 * at.continuous_limit();
    assert_eq!(at.regime(beta), Ok(Regime::StickSlip));
    assert!(at.motion(beta).is_err());
}

/// Checks that the decays of two different modes are not treated as one pair. Their contributions would be nearly
/// dependent, and in `f32` the stuck contact would move. Here two overdamped modes of the stuck chain are so close
/// that `f32` loses a sixth of a motion, so the system refuses the scene.
#[test]
fn decays_of_two_modes() {
    let text = "struct R { masses: { a: 5.967731750865764, b: 0.30315412918747936,
        c: 1.0809933843637292, d: 0.11418774165390717 }, springs: { base - a: 14210.9929505642,
        a - b: 5.860394190591326, b - c: 0.182431950610341, c - d: 0.15523094275287846,
        d - wall: 2976.711845219491 }, contact: c - d, excitation: base,
        damping: rayleigh(0.1778467665420973, 0.09091268639795028), stiction: 1 }";
    let narrow: System<f32> = text.parse().expect("a sound scene");
    let refused = narrow.simulation(0.5, 0.1).err();
    assert_eq!(refused, Some(Unsupported::CriticalDamping.into()));
    let system: System = text.parse().expect("a sound scene");
    let mut run = system.simulation(0.5, 0.1).expect("in the domain");
    for _ in 0..8 {
        run.advance(core::f64::consts::TAU).expect("a reach");
        let (z, _) = run.run().relative();
        assert!(z.abs() < 1e-14, "{z}");
    }
}
