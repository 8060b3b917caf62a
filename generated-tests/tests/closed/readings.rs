//! Tests one formula in three implementations: an interpreter of the recorded graph, the compiled code that was
//! printed from that graph, and the run-time system.

use frictiongen::{
    ContinuousMotion, FrictionSystem, Given, LimitsAt, MotionAt, Of, OutOfDomain, Slice, Steady,
    StuckAt, System,
};
use frictiongen_codegen::{SizeLimits, parse_text, traces};
use frictiongen_kernel::{Float, Scalar};
use generated_tests::shown;

const RATIOS: [f64; 7] = [0.0371, 0.3, 0.61, 0.97, 1.3, 2.2, 9.0];

/// Compares the limits at several points. The interpreted and the compiled limits must be equal bit for bit. The
/// limits of the run-time system may differ from them by `roundings` rounding units.
fn check<S, F>(name: &str, emitted: &F, roundings: f64)
where
    S: Float,
    F: FrictionSystem<Scalar = S>,
    for<'a> F::At<'a>: LimitsAt<Scalar = S>,
{
    let (_, text) = shown::SCENES
        .iter()
        .find(|(known, _)| *known == name)
        .expect("a scene");
    let scene = parse_text(text, &SizeLimits::MACRO)
        .expect("a valid scene")
        .scene;
    let system: System<S> = text.parse().expect("a valid scene");
    let mut compared = 0;
    for r in RATIOS {
        let r = S::constant(r);
        let interpreted =
            traces(&scene, S::constant(1.0) / r, S::constant(0.0)).expect("all inputs");
        let of = |wanted: &str| {
            interpreted
                .iter()
                .find(|(name, _)| name == wanted)
                .expect("a traced output")
                .1
        };
        let (at, run_time) = (
            emitted.at(r).expect("in the domain"),
            system.at(r).expect("in the domain"),
        );
        let pairs = [
            (
                "continuous_limit_without_search",
                at.continuous_limit_without_search(),
                run_time.continuous_limit_without_search(),
            ),
            (
                "sliding_limit",
                at.sliding_limit(),
                run_time.sliding_limit(),
            ),
        ];
        for (what, compiled, run_time) in pairs {
            same_bits(of(what), compiled, &format!("{name} {what} at r = {r:?}"));
            close(
                run_time,
                compiled,
                compiled,
                roundings,
                &format!("{name} {what} at r = {r:?}"),
            );
            compared += 2;
        }
        let (exact, run_time) = (at.continuous_limit(), run_time.continuous_limit());
        close(
            run_time,
            exact,
            exact,
            roundings,
            &format!("{name} continuous_limit at r = {r:?}"),
        );
        compared += 1;
    }
    println!("{name}: {compared} values compared, none skipped");
    assert_eq!(compared, RATIOS.len() * (2 * 2 + 1));
}

/// Compares the motions and stuck responses of all implementations.
fn check_motion<S, F>(name: &str, emitted: &F, roundings: f64)
where
    S: Float,
    F: FrictionSystem<Scalar = S>,
    for<'a> F::At<'a>: MotionAt<Scalar = S>,
{
    let (_, text) = shown::SCENES
        .iter()
        .find(|(known, _)| *known == name)
        .expect("a scene");
    let scene = parse_text(text, &SizeLimits::MACRO)
        .expect("a valid scene")
        .scene;
    let system: System<S> = text.parse().expect("a valid scene");
    let (mut compared, mut skipped) = (0, 0);
    for r in RATIOS {
        let r = S::constant(r);
        let (at, run_time) = (
            emitted.at(r).expect("in the domain"),
            system.at(r).expect("in the domain"),
        );
        let beta = at.continuous_limit().min(at.sliding_limit()) * S::constant(0.6);
        let place = format!("{name} at r = {r:?}, beta = {beta:?}");
        let motion = at.motion(beta).expect("continuous");
        let reference = run_time.motion(beta).expect("continuous");
        let interpreted = traces(&scene, S::constant(1.0) / r, beta).expect("all inputs");
        let of = |wanted: &str| {
            interpreted
                .iter()
                .find(|(name, _)| name == wanted)
                .expect("a traced output")
                .1
        };
        let contact = |steady: &dyn Steady<Scalar = S>| (steady.amplitude(), steady.phase());
        let (amplitude, phase) = motion.ask(Of::Contact, contact).expect("the contact");
        same_bits(of("amplitude"), amplitude, &format!("{place}: amplitude"));
        same_bits(of("phase"), phase, &format!("{place}: phase"));
        for mass in 0..system.masses() {
            let ask = |steady: &dyn Steady<Scalar = S>| {
                let tau = S::constant(1.3);
                let x1 = steady.harmonic(1);
                [
                    steady.amplitude(),
                    steady.displacement(tau),
                    steady.velocity(tau),
                    x1.re,
                    x1.im,
                ]
            };
            let Some(compiled) = motion.ask(Of::Mass(mass), ask) else {
                skipped += 1;
                continue;
            };
            let run_time = reference.ask(Of::Mass(mass), ask).expect("a mass");
            for (compiled_value, run_time_value) in compiled.into_iter().zip(run_time) {
                let scale = compiled[0].max(amplitude);
                close(
                    run_time_value,
                    compiled_value,
                    scale,
                    roundings,
                    &format!("{place}, mass {mass}"),
                );
            }
            compared += 1;
        }
    }
    println!("{name}: {compared} motions compared, {skipped} of masses without one skipped");
    assert_eq!(compared + skipped, RATIOS.len() * system.masses());
    // These scenes provide the motion of one mass. All remaining scenes provide the motion of every mass.
    let without = match name {
        "OneMotion" | "Five" | "Tall" => system.masses() - 1,
        _ => 0,
    };
    assert_eq!(skipped, RATIOS.len() * without, "{name}");
}

fn same_bits<S: Float>(interpreted: S, compiled: S, place: &str) {
    assert!(
        interpreted.to_f64().to_bits() == compiled.to_f64().to_bits(),
        "{place}: interpreted {interpreted:?}, compiled {compiled:?}"
    );
}

/// Asserts a difference of at most `roundings` rounding units times `scale`. The number of rounding units is the same
/// in both precisions. In double precision 1e-13 is 450 rounding units.
fn close<S: Float>(a: S, b: S, scale: S, roundings: f64, place: &str) {
    let bound = scale.to_f64().abs() * roundings * S::EPSILON;
    let difference = (a.to_f64() - b.to_f64()).abs();
    assert!(
        difference <= bound,
        "{place}: {a:?} against {b:?}, {difference:e} apart, bound {bound:e}"
    );
}

const ROUNDINGS: f64 = 450.0;

macro_rules! check_all {
    ($check:ident: $($scene:ident),*) => {
        $($check(stringify!($scene), &shown::$scene, ROUNDINGS);)*
    };
}

#[test]
fn limits_agree() {
    check_all!(check: SdofWall, SdofBase, SdofDamped, SdofOverdamped, PairWall, PairBase,
        PairMasses, Thesis, Five, Single, Braced, Symmetric, LimitsOnly, OneMotion, Tall);
}

#[test]
fn motions_agree() {
    check_all!(check_motion: SdofWall, SdofBase, SdofDamped, SdofOverdamped, PairWall, PairBase,
        PairMasses, Thesis, Five, Single, Braced, Symmetric, OneMotion, Tall);
}

#[test]
fn stuck_responses_agree() {
    fn stuck(
        name: &str,
        emitted: &impl for<'a> FrictionSystem<Scalar = f64, At<'a>: StuckAt>,
        _: f64,
    ) {
        let (_, text) = shown::SCENES
            .iter()
            .find(|(known, _)| *known == name)
            .expect("a scene");
        let scene = parse_text(text, &SizeLimits::MACRO)
            .expect("a valid scene")
            .scene;
        let (mut compared, mut tied) = (0, 0);
        for r in RATIOS {
            let interpreted = traces(&scene, 1.0 / r, 0.0).expect("all inputs");
            let at = emitted.at(r).expect("in the domain");
            for (index, mass) in scene.masses.iter().enumerate() {
                let compiled = at.stuck_mass(index).expect("no resonance").expect("a mass");
                for (part, compiled) in [("re", compiled.re), ("im", compiled.im)] {
                    let wanted = format!("{}.stuck.{part}", mass.name);
                    let found = interpreted.iter().find(|(name, _)| *name == wanted);
                    // The graph does not compute a mass that the stuck contact holds at its support.
                    let Some((_, value)) = found else {
                        assert_eq!(compiled, 0.0);
                        tied += 1;
                        continue;
                    };
                    // An imaginary part of 0 may have either sign, so its sign is dropped.
                    let value = value + 0.0;
                    same_bits(
                        value,
                        compiled + 0.0,
                        &format!("{name} {wanted} at r = {r}"),
                    );
                    compared += 1;
                }
            }
        }
        println!("{name}: {compared} values compared, {tied} of tied masses found to be 0");
        assert_eq!(compared + tied, RATIOS.len() * scene.masses.len() * 2);
        // A contact on the wall holds one mass while it is stuck. A contact between two masses holds none.
        let masses = usize::from(name != "PairMasses");
        assert_eq!(tied, RATIOS.len() * masses * 2, "{name}");
    }
    check_all!(stuck: PairMasses, Five, Symmetric);
}

/// Checks that `limits_without_search` gives the same bits as the limits by `at`, in emitted code and at run time.
#[test]
fn limits_without_search_are_those_of_at() {
    fn by_at<F: FrictionSystem>(system: &F, r: F::Scalar) -> [u64; 2] {
        let at = system.at(r).expect("in the domain");
        [at.continuous_limit_without_search(), at.sliding_limit()]
            .map(|limit| limit.to_f64().to_bits())
    }
    fn at_once<F: FrictionSystem>(system: &F, r: F::Scalar) -> [u64; 2] {
        let limits = system.limits_without_search(r).expect("in the domain");
        [limits.continuous, limits.sliding].map(|limit| limit.to_f64().to_bits())
    }
    fn compared<F: FrictionSystem>(name: &str, system: &F) -> usize {
        let mut ratios = vec![0.0, f64::INFINITY, f64::MAX, f64::MIN_POSITIVE, 5e-324];
        ratios.extend((-320..=308).map(|exponent| 10.0_f64.powi(exponent)));
        ratios.extend((1..=2000).map(|step| 0.0017 * f64::from(step)));
        for resonance in system.resonances() {
            for n in 1..=5 {
                let r = resonance.to_f64() / f64::from(n);
                ratios.extend([r, r.next_up(), r.next_down(), r * (1.0 + 1e-7)]);
            }
        }
        for r in &ratios {
            let r = F::Scalar::constant(*r);
            assert_eq!(at_once(system, r), by_at(system, r), "{name} at r = {r:?}");
        }
        for r in [f64::NAN, -1.0, f64::NEG_INFINITY, -1e-30] {
            let r = F::Scalar::constant(r);
            let told = system.limits_without_search(r);
            assert!(told.is_err() && system.at(r).is_err(), "{name}");
        }
        let ratios: Vec<_> = ratios.into_iter().map(F::Scalar::constant).collect();
        sliced(name, system, &ratios);
        ratios.len()
    }
    /// Compares slices that begin and end at every position within a group of elements that is evaluated together.
    fn sliced<F: FrictionSystem>(name: &str, system: &F, ratios: &[F::Scalar]) {
        let none = F::Scalar::constant(-1.0);
        for (from, left) in (0..9).zip([0, 5, 3, 1, 4, 8, 2, 7, 6]) {
            let rs = &ratios[from..ratios.len() - left];
            let (mut continuous, mut sliding) = (vec![none; rs.len()], vec![none; rs.len()]);
            let done = system.limits_without_search_into(rs, &mut continuous, &mut sliding);
            assert_eq!(done, Ok(()), "{name}");
            for ((r, continuous), sliding) in rs.iter().zip(continuous).zip(sliding) {
                let found = [continuous, sliding].map(|limit| limit.to_f64().to_bits());
                assert_eq!(found, at_once(system, *r), "{name} at r = {r:?} of a slice");
            }
        }
        // The first invalid r ends the evaluation of the slice. The results of the elements before it are filled in.
        for at in 0..19 {
            let mut rs = ratios[700..720].to_vec();
            rs[at] = F::Scalar::constant(f64::NAN);
            let (mut continuous, mut sliding) = ([none; 20], [none; 20]);
            let done = system.limits_without_search_into(&rs, &mut continuous, &mut sliding);
            assert_eq!(
                done,
                Err(OutOfDomain::FrequencyRatio(Given::NotANumber)),
                "{name}"
            );
            let filled = continuous
                .iter()
                .zip(&sliding)
                .take_while(|(c, s)| **c != none && **s != none);
            assert_eq!(filled.count(), at, "{name}");
            assert!(
                continuous[at..].iter().all(|limit| *limit == none),
                "{name}"
            );
        }
        let mut short = [none; 4];
        for (length, slice) in [(4, Slice::Continuous), (5, Slice::Sliding)] {
            let mut other = vec![none; length];
            let done = system.limits_without_search_into(&ratios[..5], &mut other, &mut short);
            assert_eq!(done, Err(OutOfDomain::Length(slice)), "{name}");
            assert!(
                other.iter().chain(&short).all(|limit| *limit == none),
                "{name}"
            );
        }
    }
    fn check<F: FrictionSystem>(name: &str, emitted: &F, _: f64) {
        let known = shown::SCENES.iter().find(|(known, _)| *known == name);
        let (_, text) = known.expect("a scene");
        let system: System<F::Scalar> = text.parse().expect("a valid scene");
        let count = compared(name, emitted) + compared(name, &system);
        println!("{name}: limits at {count} places compared, none skipped");
        assert!(count > 2 * 2600);
    }
    check_all!(check: SdofWall, SdofBase, SdofDamped, SdofOverdamped, PairWall, PairBase,
        PairMasses, Thesis, Five, Single, Braced, Symmetric, LimitsOnly, OneMotion, Tall, Stopping);
}

/// Checks that the limits of a slice equal those of single calls bit for bit.
#[test]
fn slices_are_single_points() {
    let (mut continuous, mut sliding) = ([0.0; 7], [0.0; 7]);
    shown::Thesis::limits_into(&RATIOS, &mut continuous, &mut sliding).expect("in the domain");
    let mut compared = 0;
    for ((r, continuous), sliding) in RATIOS.into_iter().zip(continuous).zip(sliding) {
        let at = shown::Thesis::at(r).expect("in the domain");
        same_bits(continuous, at.continuous_limit(), "a slice");
        same_bits(sliding, at.sliding_limit(), "a slice");
        compared += 2;
    }
    println!("{compared} values compared, none skipped");
    assert_eq!(compared, RATIOS.len() * 2);
    assert!(shown::Thesis::limits_into(&[1.0, f64::NAN], &mut [0.0; 2], &mut [0.0; 2]).is_err());
}
