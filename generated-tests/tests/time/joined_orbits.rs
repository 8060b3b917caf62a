//! Compares emitted steady states and stuck states of scenes with several contacts with three references:
//! `joints.json`, which a plain program with matrix exponentials made, formulas, and the run-time system bit by bit.

use frictiongen::kernel::joints::{Pieces, Waveform};
use frictiongen::study::joined::JoinedAt;
use frictiongen::{NoOrbit, OutOfDomain, Regime, System};
use serde_json::Value;

scenes! {
    // Entry 1 of `joints.json`. No spring joins the chain to the base or the wall.
    struct Free {
        masses: { m1: 1.4, m2: 2.26, m3: 2.47 },
        springs: { m1 - m2: 2110.0, m2 - m3: 2710.0 },
        contacts: {
            elastic: m3 - m2 { stiffness: 9890.0, share: 39.9 },
            rigid: m3 - wall { share: 79.8 },
        },
        damping: modal[0.0263, 0.00728, 0.0192],
        excitation: m1,
        provide: [orbit],
    }
    struct Frame {
        masses: { one: 2.0, two: 1.5, three: 1.0, four: 0.8 },
        springs: { base - one: 900.0, one - two: 700.0, two - three: 650.0, three - four: 500.0 },
        contacts: {
            brace: base - one { stiffness: 4000.0 },
            pads: one - two { share: 0.6, stiction: 1.2 },
            clamp: two - three { share: 0.5 },
            hanger: four - wall { stiffness: 2500.0, share: 0.3, stiction: 1.1 },
        },
        dampers: { three - four: 1.2 },
        damping: rayleigh(0.2, 1e-3),
        excitation: four,
        provide: [stuck, orbit],
    }
    struct Bench {
        masses: { lower: 2.0, upper: 1.0 },
        springs: { base - lower: 800.0, lower - upper: 600.0 },
        contacts: { brace: base - lower { stiffness: 3000.0 }, pads: lower - upper { stiction: 1.2 } },
        dampers: { base - lower: 4.0, lower - upper: 4.0 },
        excitation: upper,
        scalar: f32,
        provide: [stuck, orbit],
    }
    struct Single {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        damping: modal[0.010, 0.012],
        excitation: base,
        provide: [orbit],
    }
    struct Dashpot {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        dampers: { base - lower: 1e-10 },
        damping: modal[0.010, 0.012],
        excitation: base,
        provide: [orbit],
    }
    // One mass with two elastic contacts and a dashpot. A formula gives its stuck state.
    struct Iwan {
        masses: { block: 2.0 },
        springs: { base - block: 800.0 },
        contacts: {
            soft: block - wall { stiffness: 300.0, share: 0.4 },
            stiff: block - base { stiffness: 500.0, stiction: 1.5 },
        },
        dampers: { block - wall: 6.0 },
        excitation: block,
        provide: [stuck],
    }
}

/// Checks a chain that no spring joins to the base or the wall. The reference follows the motion from rest.
#[test]
fn a_free_chain_has_the_steady_state_of_the_reference() {
    let text = include_str!("../../../frictiongen/src/study/joints/tests/joints.json");
    let all: Value = serde_json::from_str(text).expect("JSON");
    let scene = &all["scenes"][1];
    let number = |value: &Value| value.as_f64().expect("a number");
    let load = number(&scene["load"]);
    let r = number(&scene["omega"]) / (2110.0_f64 / 1.4).sqrt();
    let rest = (&[0.0; 3], &[0.0; 3]);
    let at = Free::at(r).expect("a frequency");
    let orbit = at.orbit_from(1.0 / load, rest).expect("a steady state");
    let expected = &scene["steady"];
    let amplitudes = expected["amplitude"].as_array().expect("amplitudes");
    let largest = amplitudes.iter().map(number).fold(0.0, f64::max);
    for (mass, want) in [orbit.m1(), orbit.m2(), orbit.m3()].iter().zip(amplitudes) {
        let differs = (mass.amplitude() * load / 2110.0 - number(want)).abs() / largest;
        assert!(differs < 1e-9, "{differs:e}");
    }
    for (index, contact) in [orbit.elastic(), orbit.rigid()].iter().enumerate() {
        assert_eq!(expected["stops"][index], contact.stops());
        let differs = contact.stuck_fraction() - number(&expected["stuck_fraction"][index]);
        assert!(differs.abs() < 1e-8, "{differs:e}");
    }
}

/// Returns true if two numbers differ by at most 1e-10 of the larger of them and `size`. Emitted code follows power
/// series, the run-time system tables. Both searches end at changes of some 1e-13 of the motion in a period.
fn close(a: f64, b: f64, size: f64) -> bool {
    (a - b).abs() <= 1e-10 * size.max(a.abs()).max(b.abs())
}

/// Compares the course of a motion with that of the run-time system, which stores its pieces. `size` is that of the
/// displacements.
fn same_course<P: Pieces<f64>>(
    got: &Waveform<f64, P>,
    want: &frictiongen::study::joined::Waveform,
    size: f64,
) {
    for (got, want) in [
        (got.amplitude(), want.amplitude()),
        (got.middle(), want.middle()),
        (got.displacement(1.3), want.displacement(1.3)),
        (got.displacement(-40.0), want.displacement(-40.0)),
        (got.largest_velocity(), want.largest_velocity()),
        (got.velocity(2.1), want.velocity(2.1)),
    ] {
        assert!((got - want).abs() <= 1e-9 * size, "{got} {want}");
    }
    for n in [0, 1, 2, 3, 9] {
        let apart = (got.harmonic(n) - want.harmonic(n)).norm();
        assert!(apart <= 1e-10 * size, "harmonic {n}: {apart}");
    }
}

/// Checks motions of one contact against the solver for one contact. A very small dashpot makes the generator use the
/// solver for several contacts.
#[test]
fn motions_of_one_contact_are_those_of_its_own_solver() {
    let mut regimes = Vec::new();
    for (r, beta) in [(0.9, 0.3), (0.9, 0.6), (0.3, 0.4), (0.05, 0.1), (2.0, 0.05)] {
        let at = Single::at(r).expect("a frequency");
        let want = at.orbit(beta).expect("a steady state");
        let at = Dashpot::at(r).expect("a frequency");
        let got = at.orbit(beta).expect("a steady state");
        // The solver for one contact counts phases from a maximum of the contact's motion.
        let origin = want.origin();
        for (got, want) in [
            (got.contact().motion(), want.contact()),
            (got.lower().motion(), want.lower()),
            (got.upper().motion(), want.upper()),
        ] {
            let size = want.amplitude().max(1e-3);
            assert!((got.amplitude() - want.amplitude()).abs() <= 1e-9 * size);
            // At a flat maximum, a change of the motion by 1e-11 moves the instant of its maximum by 1e-6.
            let turn = (got.phase() - want.phase()).abs();
            let turn = turn.min(std::f64::consts::TAU - turn);
            assert!(turn < 1e-5 || want.amplitude() < 1e-9, "{r} {beta}: {turn}");
            for n in [0, 1, 2, 3, 5] {
                let apart = (got.harmonic(n) - want.harmonic(n)).norm();
                assert!(apart <= 1e-9 * size, "{r} {beta}, harmonic {n}: {apart}");
            }
            for tau in [-5.0, 0.4, 1.9, 11.0] {
                let apart = got.displacement(tau) - want.displacement(tau - origin);
                assert!(apart.abs() <= 1e-9 * size, "{r} {beta}, {tau}: {apart}");
            }
        }
        regimes.push(got.regime());
    }
    assert!(regimes.contains(&Regime::StickSlip) && regimes.contains(&Regime::Continuous));
}

/// Compares an emitted steady state with that of the run-time system.
fn same(orbit: &FrameOrbit, at: &JoinedAt<'_>, beta: f64) {
    let expected = at.orbit(beta).expect("a steady state");
    assert_eq!(orbit.period(), expected.period());
    let multipliers = orbit.multipliers().iter().zip(expected.multipliers());
    for (got, want) in multipliers {
        // The eigenvalues of a matrix that is not symmetric may have more rounding errors than its entries.
        assert!((got.norm() - want.norm()).abs() < 1e-7, "{got} {want}");
    }
    assert_eq!(orbit.multipliers().len(), expected.multipliers().len());
    assert_eq!(orbit.regime(), expected.regime());
    assert_eq!(orbit.is_marginal(), expected.is_marginal());
    assert_eq!(orbit.free_directions(), expected.free_directions());
    let symmetric = expected.is_symmetric().expect("half a period");
    assert_eq!(orbit.is_symmetric(), symmetric);
    let masses = [orbit.one(), orbit.two(), orbit.three(), orbit.four()];
    let amplitudes = expected.amplitudes();
    let size = amplitudes.iter().copied().fold(0.0, f64::max);
    let (x, v) = expected.state();
    let wanted = [
        (masses.map(|mass| mass.amplitude()), amplitudes.to_vec()),
        (
            masses.map(|mass| mass.centred_amplitude()),
            expected.centred_amplitudes().to_vec(),
        ),
        (masses.map(|mass| mass.state().0), x),
        (masses.map(|mass| mass.state().1), v),
    ];
    for (got, want) in wanted {
        let mut pairs = got.iter().zip(&want);
        assert!(
            pairs.all(|(got, want)| close(*got, *want, size)),
            "{got:?} {want:?}"
        );
    }
    let contacts = [
        (orbit.brace(), "brace"),
        (orbit.pads(), "pads"),
        (orbit.clamp(), "clamp"),
        (orbit.hanger(), "hanger"),
    ];
    let marginal = expected.marginal_contacts();
    for (mass, name) in masses.iter().zip(["one", "two", "three", "four"]) {
        same_course(&mass.motion(), &expected.mass(name).expect("a mass"), size);
    }
    for (got, name) in contacts {
        let want = expected.contact(name).expect("a contact");
        let course = want.motion().expect("a course");
        same_course(&got.motion(), &course, size);
        assert_eq!(
            (got.stops(), got.reversals(), got.regime()),
            (want.stops(), want.reversals(), want.regime())
        );
        for (got, want, size) in [
            (got.stuck_fraction(), want.stuck_fraction(), 1.0),
            (got.slip(), want.slip(), size),
            (got.displacement(), want.displacement(), size),
            (got.force(), want.force(), beta),
            (got.energy(), want.energy(), beta * size),
        ] {
            assert!(close(got, want, size), "{name}: {got} {want}");
        }
        assert_eq!(got.is_marginal(), marginal.iter().any(|own| own == name));
    }
}

#[test]
fn steady_states_are_those_of_the_system() {
    let system = system("Frame");
    let joined = system.joined().expect("answers");
    let mut regimes = Vec::new();
    for (r, beta) in [(0.4, 0.3), (0.9, 0.1), (1.3, 0.6), (0.7, 8.0)] {
        let orbit = Frame::at(r).expect("a frequency").orbit(beta);
        let orbit = orbit.expect("a steady state");
        same(&orbit, &joined.at(r).expect("a frequency"), beta);
        regimes.push(orbit.regime());
    }
    assert!(regimes.contains(&Regime::StickSlip) && regimes.contains(&Regime::Stuck));
    // A motion that starts from the state of a steady state must return to this steady state.
    let at = Frame::at(0.4).expect("a frequency");
    let orbit = at.orbit(0.3).expect("a steady state");
    let masses = [orbit.one(), orbit.two(), orbit.three(), orbit.four()];
    let (x, v) = (masses.map(|m| m.state().0), masses.map(|m| m.state().1));
    let again = at.orbit_from(0.3, (&x, &v)).expect("a steady state");
    let differs = again.four().amplitude() / orbit.four().amplitude() - 1.0;
    // A contact that keeps its force or its displacement may keep another force or displacement after the new start.
    let bound = if orbit.is_marginal() { 0.1 } else { 1e-9 };
    assert!(differs.abs() < bound, "{differs}");
}

#[test]
fn stuck_states_have_the_bits_of_the_system() {
    let system = system("Frame");
    let joined = system.joined().expect("answers");
    for r in [0.1, 0.5, 1.1, 3.0] {
        let stuck = Frame::at(r).expect("a frequency").stuck();
        let stuck = stuck.expect("a stuck state");
        let expected = joined.at(r).expect("a frequency").stuck();
        let expected = expected.expect("a stuck state");
        assert_eq!(stuck.limit(), expected.limit());
        assert_eq!(stuck.first(), expected.first());
        assert_eq!(stuck.one(), expected.mass("one").expect("a mass"));
        assert_eq!(stuck.four(), expected.mass("four").expect("a mass"));
        assert_eq!(stuck.clamp(), expected.force("clamp").expect("a contact"));
        assert_eq!(stuck.hanger(), expected.force("hanger").expect("a contact"));
    }
}

/// Checks the stuck state of one mass against X̄ = k₁/(k − mω² + icω), where k is the sum of all stiffnesses.
#[test]
fn the_stuck_state_of_one_mass_is_a_formula() {
    for r in [0.2, 0.9, 1.4, 2.5] {
        let stuck = Iwan::at(r).expect("a frequency").stuck();
        let stuck = stuck.expect("a stuck state");
        let omega = r * (800.0_f64 / 2.0).sqrt();
        let (re, im) = (1600.0 - 2.0 * omega * omega, 6.0 * omega);
        let size = re * re + im * im;
        let (re, im) = (800.0 * re / size, -800.0 * im / size);
        let largest = re.hypot(im);
        assert!((stuck.block().re - re).abs() < 1e-14 * largest, "{r}");
        assert!((stuck.block().im - im).abs() < 1e-14 * largest, "{r}");
        let soft = 300.0 / 800.0 * largest;
        assert!((stuck.soft() - soft).abs() < 1e-14 * soft, "{r}");
        // The soft contact needs the friction 0.375/0.4 of |X̄|, and the stiff one 0.625/1.5 of |X̄|.
        assert_eq!(stuck.first(), "soft");
        assert!((stuck.limit() - soft / 0.4).abs() < 1e-13 * soft, "{r}");
    }
}

/// Checks the limit: above it the motion from rest reaches a state in which no contact slides. Below it the named
/// contact slides.
#[test]
fn the_limit_separates_steady_states() {
    for r in [0.3, 0.8] {
        let at = Frame::at(r).expect("a frequency");
        let stuck = at.stuck().expect("a stuck state");
        // The motion from rest overshoots, so only friction well above the limit excludes a slip on the way.
        let above = at.orbit(3.0 * stuck.limit()).expect("a steady state");
        assert_eq!(above.regime(), Regime::Stuck);
        let amplitude = stuck.four().re.hypot(stuck.four().im);
        let differs = above.four().amplitude() / amplitude - 1.0;
        assert!(differs.abs() < 1e-9, "{r}: {differs}");
        let below = at.orbit(0.7 * stuck.limit()).expect("a steady state");
        assert_ne!(below.regime(), Regime::Stuck, "{r}");
    }
}

#[test]
fn single_precision_follows_double_precision() {
    let text = "struct Bench { masses: { lower: 2.0, upper: 1.0 },
        springs: { base - lower: 800.0, lower - upper: 600.0 },
        contacts: { brace: base - lower { stiffness: 3000.0 }, pads: lower - upper { stiction: 1.2 } },
        dampers: { base - lower: 4.0, lower - upper: 4.0 }, excitation: upper, provide: [stuck, orbit] }";
    let double: System = text.parse().expect("a valid scene");
    let joined = double.joined().expect("answers");
    for (r, beta) in [(0.55_f32, 0.3_f32), (0.8, 0.5), (1.2, 0.2), (0.6, 4.0)] {
        let at = Bench::at(r).expect("a frequency");
        let exact = joined.at(f64::from(r)).expect("a frequency");
        let (stuck, want) = (at.stuck(), exact.stuck());
        let (stuck, want) = (stuck.expect("a state"), want.expect("a state"));
        let differs = f64::from(stuck.limit()) / want.limit() - 1.0;
        // The stuck state solves four linear equations in `f32`, with several tens of rounding errors of 6e-8.
        assert!(differs.abs() < 1e-5, "{r} {beta}: {differs}");
        assert_eq!(stuck.first(), want.first());
        let orbit = at.orbit(beta).expect("a steady state");
        let want = exact.orbit(f64::from(beta)).expect("a steady state");
        let differs =
            f64::from(orbit.upper().amplitude()) / want.amplitude("upper").expect("a mass") - 1.0;
        println!(
            "f32 at {r}, {beta}: {differs:.1e}, residual {:.1e}",
            orbit.residual()
        );
        // A period has about fifty intervals between events, each with several tens of rounding errors of 6e-8.
        assert!(differs.abs() < 1e-4, "{r} {beta}: {differs}");
        assert_eq!(orbit.period(), want.period());
        assert_eq!(
            orbit.pads().stops(),
            want.contact("pads").expect("a contact").stops()
        );
        assert_eq!(orbit.regime(), want.regime());
    }
}

#[test]
fn bad_inputs_are_refused() {
    for r in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let refused = Frame::at(r);
        assert!(
            matches!(refused, Err(OutOfDomain::FrequencyRatioInTime(_))),
            "{r}"
        );
    }
    let at = Frame::at(0.5).expect("a frequency");
    for beta in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = at.orbit(beta);
        let refused = matches!(
            refused,
            Err(NoOrbit::OutOfDomain(OutOfDomain::FrictionRatio(_)))
        );
        assert!(refused, "{beta}");
    }
    let refused = at.orbit_from(0.1, (&[f64::NAN; 4], &[0.0; 4]));
    assert!(matches!(
        refused,
        Err(NoOrbit::OutOfDomain(OutOfDomain::State))
    ));
}

/// Checks that the memory in bytes is that of docs/data/joints-memory.csv.
#[test]
fn sizes_are_those_of_the_documentation() {
    let sizes = [
        ("Bench, f32, at one frequency", size_of::<BenchAt>()),
        ("Bench, f32, stuck state", size_of::<BenchStuck>()),
        ("Bench, f32, steady state", size_of::<BenchOrbit>()),
        ("Frame, at one frequency", size_of::<FrameAt>()),
        ("Frame, stuck state", size_of::<FrameStuck>()),
        ("Frame, steady state", size_of::<FrameOrbit>()),
    ];
    let table = include_str!("../../../docs/data/joints-memory.csv");
    let rows = sizes.map(|(what, size)| format!("\"{what}\",{size}\n"));
    let rows = rows.concat();
    assert!(
        table.contains(&rows),
        "docs/data/joints-memory.csv needs these rows:\n{rows}"
    );
}
