//! Tests arguments outside the domain, arguments at the bounds of the domain, and friction ratios at the limits of
//! the regimes.

use frictiongen::study::{System, SystemInput};
use frictiongen::{Error, Given, NotContinuous, OutOfDomain, Regime};
use generated_tests::shown::{
    PairMasses, PairWall, SdofBase, SdofDamped, SdofWall, Single, Thesis,
};

#[test]
fn ratios_that_are_none() {
    let mut compared = 0;
    for r in [f64::NAN, -1.0, -0.1, f64::NEG_INFINITY] {
        assert_eq!(
            SdofWall::at(r).err(),
            Some(OutOfDomain::FrequencyRatio(Given::of(r)))
        );
        compared += 1;
    }
    assert!(Single::at(f32::NAN).is_err());
    let system: System = generated_tests::shown::SCENES[0]
        .1
        .parse()
        .expect("a valid scene");
    assert!(system.at(f64::NAN).is_err());
    let at = SdofWall::at(1.3).expect("in the domain");
    for beta in [f64::NAN, -0.1, f64::INFINITY] {
        assert_eq!(
            at.regime(beta),
            Err(OutOfDomain::FrictionRatio(Given::of(beta)))
        );
        assert_eq!(
            at.margin(beta),
            Err(OutOfDomain::FrictionRatio(Given::of(beta)))
        );
        assert_eq!(at.motion(beta).err(), Some(NotContinuous::OutOfDomain));
        compared += 3;
    }
    println!("{compared} refusals compared, none skipped");
    assert_eq!(compared, 4 + 3 * 3);
    let error: Error = SdofWall::at(f64::NAN).expect_err("NaN").into();
    assert_eq!(
        error.to_string(),
        "the frequency ratio r is NaN; it must be a number, not negative"
    );
    assert_eq!(
        OutOfDomain::FrictionRatio(Given::Negative).to_string(),
        "the friction ratio beta is negative; it must be a finite number, not negative"
    );
}

/// Checks that the message about a number of the right sign does not complain about its sign.
#[test]
fn numbers_of_the_right_sign_that_are_out_of_range() {
    let system: System<f32> =
        "struct Block { masses: { block: 1.0 }, springs: { base - block: 1e5 },
        contact: block - wall, excitation: block }"
            .parse()
            .expect("a scene");
    // 8.2 s are 2600 rad of the fastest oscillator.
    let long = system.stepper(8.2).map(|_| ());
    let long = long.expect_err("too long").to_string();
    assert!(
        long.starts_with("the step dt is too long or too short; it must be"),
        "{long}"
    );
    let mut stepper = system.stepper(1e-3).expect("a step");
    for (input, words) in [
        (
            SystemInput::force(-1e30),
            "a force is too large; it must be",
        ),
        (
            SystemInput::force(1.0).friction(1e30),
            "the friction force F is too large; it must be",
        ),
        (
            SystemInput::force(1.0).friction(-1.0),
            "the friction force F is negative; it must be",
        ),
    ] {
        let told = stepper.advance(input).expect_err(words).to_string();
        assert!(told.starts_with(words), "{told}");
    }
}

#[test]
fn a_motion_says_which_regime_it_is_instead() {
    // At r = 0.3 the limits are β_lim = 0.05 and β*_lim = 1.
    let at = SdofWall::at(0.3).expect("in the domain");
    assert_eq!(at.motion(0.5).err(), Some(NotContinuous::StickSlip));
    assert_eq!(at.motion(1.0).err(), Some(NotContinuous::Stuck));
    assert_eq!(at.regime(0.01), Ok(Regime::Continuous));
    assert!(at.motion(0.01).is_ok());
    // The tested β lie one rounding below and one rounding above each limit.
    let (continuous, sliding) = (at.continuous_limit(), at.sliding_limit());
    assert!(at.motion(continuous.next_down()).is_ok());
    assert_eq!(at.motion(continuous).err(), Some(NotContinuous::StickSlip));
    assert_eq!(at.regime(continuous.next_down()), Ok(Regime::Continuous));
    assert_eq!(at.regime(continuous), Ok(Regime::StickSlip));
    assert_eq!(at.regime(sliding.next_down()), Ok(Regime::StickSlip));
    assert_eq!(at.regime(sliding), Ok(Regime::Stuck));
    assert!(at.margin(continuous * 0.5).expect("in the domain") < 0.0);
    assert!(at.margin(continuous * 1.5).expect("in the domain") > 0.0);
}

#[test]
fn without_friction_there_is_always_a_motion() {
    let mut compared = 0;
    for r in [0.3, 0.9, 1.7] {
        let motion = SdofWall::at(r)
            .expect("in the domain")
            .motion(0.0)
            .expect("continuous");
        let linear = (1.0 / (1.0 - r * r)).abs();
        assert!((motion.block().amplitude() / linear - 1.0).abs() < 1e-14);
        assert!((motion.block().harmonic(3).re).abs() < 1e-15);
        compared += 2;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 3 * 2);
}

/// Checks the regimes on an undamped resonance. The motion is bounded from the friction ratio π/4·|φᵀp/φᵀw| on; with
/// less friction it is unbounded.
#[test]
fn on_a_resonance() {
    let at = SdofWall::at(SdofWall::RESONANCES[0]).expect("in the domain");
    assert!((at.continuous_limit() - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
    assert_eq!(at.motion(0.5).err(), Some(NotContinuous::Unbounded));
    assert_eq!(at.motion(0.9).err(), Some(NotContinuous::StickSlip));
    // The thresholds of the thesis's three masses are the friction ratios 0.436, 1.765 and 0.630.
    let mut compared = 0;
    assert_eq!(Thesis::RESONANCES.len(), 3);
    for (r, threshold) in Thesis::RESONANCES
        .into_iter()
        .zip([0.435_863, 1.764_77, 0.629_84])
    {
        let at = Thesis::at(r).expect("in the domain");
        let text = generated_tests::shown::SCENES
            .iter()
            .find(|scene| scene.0 == "Thesis")
            .expect("it")
            .1;
        let system: System = text.parse().expect("a valid scene");
        let exact = system.resonance_thresholds();
        assert!(
            exact
                .iter()
                .flatten()
                .any(|exact| (exact - threshold).abs() < 1e-5)
        );
        assert!(at.continuous_limit() <= threshold + 1e-5);
        compared += 2;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, 3 * 2);
    // With damping the motion is bounded.
    let at = SdofDamped::at(SdofDamped::RESONANCES[0]).expect("in the domain");
    assert!(at.motion(0.1).expect("continuous").block().amplitude() < 10.0);
}

#[test]
fn the_ends_of_the_range() {
    let at = SdofWall::at(0.0).expect("in the domain");
    assert_eq!((at.continuous_limit(), at.sliding_limit()), (0.0, 1.0));
    assert_eq!(at.regime(0.5), Ok(Regime::StickSlip));
    let at = SdofWall::at(f64::INFINITY).expect("in the domain");
    // The expected value of β_lim is 2/√(4 + π²).
    assert!((at.continuous_limit() - 0.537_029_272_146_315_1).abs() < 1e-15);
    assert_eq!(at.sliding_limit(), 1.0);
    let at = SdofBase::at(f64::INFINITY).expect("in the domain");
    assert_eq!(
        (at.continuous_limit(), at.sliding_limit()),
        (f64::INFINITY, f64::INFINITY)
    );
    let at = SdofBase::at(0.0).expect("in the domain");
    assert_eq!((at.continuous_limit(), at.sliding_limit()), (0.0, 0.0));
    assert_eq!(at.regime(0.1), Ok(Regime::Stuck));
    // The limits at frequency ratios near a bound of the domain approach the limits at the bound, in both precisions.
    let far = PairMasses::at(f64::INFINITY)
        .expect("in the domain")
        .continuous_limit();
    let near = PairMasses::at(1e6)
        .expect("in the domain")
        .continuous_limit();
    assert!((near / far - 1.0).abs() < 1e-11);
    let far = Single::at(f32::INFINITY).expect("in the domain");
    assert_eq!((far.continuous_limit(), far.sliding_limit()), (0.0, 0.0));
    let mut compared = 0;
    for r in [1e-300, 1e-30, 1e30, 1e200] {
        let at = PairWall::at(r).expect("in the domain");
        assert!(
            at.continuous_limit() >= 0.0 && at.sliding_limit() >= 0.0,
            "r = {r}"
        );
        compared += 2;
    }
    println!("{compared} limits looked at, none skipped");
    assert_eq!(compared, 4 * 2);
}
