//! The questions of every scene, asked of a scene with an elastic contact: limits, regime, stuck state, orbit, response.

use frictiongen::study::response::SystemResponse;
use frictiongen::{FrictionSystem, LimitsAt as _, NotContinuous, Of, Regime, System};

const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: 5.0e3,
    excitation: base, damping: modal[0.010, 0.012], stiction: 1.2, provide: [orbit, simulation] }";

/// The limit |V|/(μ|H + ρ|) and the amplitudes V_k − H_kV/(H + ρ) are those of the modes of the stuck chain, which
/// come from the roots of the secular equation.  Near zero of an amplitude its error is that of the largest amplitude.
#[test]
fn closed_forms_agree_with_the_modes_of_the_stuck_chain() {
    let mut compared = 0;
    for contact in ["upper - wall", "lower - upper", "lower - base"] {
        for damping in [
            "damping: modal[0.010, 0.012],",
            "",
            "damping: rayleigh(0.3, 1e-3),",
            "damping: modal[0.02, 0.03], damping_from: base,",
        ] {
            for stiffness in [1e-6_f64, 1.0, 1e4, 1e9] {
                let text = FRAME
                    .replace("contact: upper - wall", &format!("contact: {contact}"))
                    .replace("damping: modal[0.010, 0.012],", damping)
                    .replace("5.0e3", &format!("{:?}", 1190.0 * stiffness));
                let system: System = text.parse().expect("a scene");
                for r in [0.05, 0.6, 0.618, 1.0, 1.5, 3.0] {
                    let at = system.at(r).expect("in the domain");
                    let (limit, expected) = (at.sliding_limit(), system.stuck_limit(r));
                    let expected = expected.expect("no resonance");
                    // The modes give the force of a soft spring as a difference of numbers of the size of the chain.
                    let tolerance = 1e-11 * expected + 1e-13 * stiffness.min(1.0);
                    assert!(
                        (limit - expected).abs() < tolerance,
                        "{contact} {damping} k = {stiffness}, r = {r}: {limit} for {expected}"
                    );
                    let stuck = at.stuck().expect("no resonance");
                    let amplitudes = system.stuck_amplitudes(r).expect("no resonance");
                    let size = amplitudes
                        .iter()
                        .fold(1.0_f64, |most, one| most.max(one.norm()));
                    for (mass, expected) in amplitudes.iter().enumerate() {
                        let own = stuck.mass_at(mass).expect("a mass");
                        assert!(
                            (own - expected).norm() < 1e-11 * size,
                            "{contact} {damping} k = {stiffness}, r = {r}: {own} for {expected}"
                        );
                        compared += 1;
                    }
                }
            }
        }
    }
    assert_eq!(compared, 3 * 4 * 4 * 6 * 2);
}

/// β_lim is 0, so that a caller of the trait sees the regimes stick-slip and stuck only.
#[test]
fn limits_and_regimes_are_true() {
    fn regimes<F: FrictionSystem<Scalar = f64>>(system: &F, r: f64) -> (f64, f64, Vec<Regime>) {
        let at = system.at(r).expect("in the domain");
        let sliding = at.sliding_limit();
        let regimes = [0.0, 0.5 * sliding, sliding, 2.0 * sliding];
        let regimes = regimes.map(|beta| at.regime(beta).expect("in the domain"));
        (at.continuous_limit(), sliding, regimes.to_vec())
    }
    let system: System = FRAME.parse().expect("a scene");
    for r in [0.3, 0.9, 2.0] {
        let (continuous, sliding, found) = regimes(&system, r);
        assert_eq!(continuous, 0.0);
        use Regime::{StickSlip, Stuck};
        assert_eq!(found, [StickSlip, StickSlip, Stuck, Stuck]);
        let at = system.at(r).expect("in the domain");
        assert_eq!(at.limits().continuous, 0.0);
        assert_eq!(at.limits().sliding, sliding);
        assert_eq!(at.continuous_limit_without_search(), 0.0);
        assert_eq!(at.continuous_limit_per_mode(), 0.0);
        assert_eq!(
            system.limits_without_search(r).expect("limits"),
            at.limits()
        );
        assert!(matches!(
            at.motion(0.5 * sliding),
            Err(NotContinuous::StickSlip)
        ));
        assert!(matches!(at.motion(sliding), Err(NotContinuous::Stuck)));
        assert!(matches!(at.motion(-1.0), Err(NotContinuous::OutOfDomain)));
    }
    // The statics of two springs in a row: the upper mass moves with the base, and the contact's spring pulls it back.
    let flexibility = 1190.0 / 1190.0 + 1190.0 / 1323.0;
    let compliance = 1190.0 / 5.0e3;
    let at_rest = system.at(0.0).expect("in the domain").sliding_limit();
    assert!((at_rest * 1.2 * (flexibility + compliance) - 1.0).abs() < 1e-14);
    let far = system.at(f64::INFINITY).expect("in the domain");
    assert_eq!((far.continuous_limit(), far.sliding_limit()), (0.0, 0.0));
    // For r → ∞ a mass stays where it is, and the base moves the spring of a contact on it.
    let on_base: System = FRAME
        .replace("upper - wall", "upper - base")
        .parse()
        .expect("a scene");
    let (_, limit) = on_base.high_frequency_limits();
    assert!((limit * 1.2 * compliance - 1.0).abs() < 1e-15);
    let near = on_base.at(3e4).expect("in the domain").sliding_limit();
    assert!((near - limit).abs() < 1e-8 * limit, "{near} for {limit}");
}

/// `at.orbit` is `steady_state` to the bit, and `orbit_from` starts elsewhere.  From rest with more friction than the
/// limit the contact never slides, and the state is marginal.
#[test]
fn orbits_are_the_steady_states() {
    let system: System = FRAME.parse().expect("a scene");
    let at = system.at(0.8).expect("in the domain");
    let (own, other) = (at.orbit(0.2), system.steady_state(0.8, 0.2));
    let (own, other) = (own.expect("a state"), other.expect("a state"));
    let amplitude = |orbit: &frictiongen::study::orbit::SystemOrbit<'_>| {
        orbit.mass("lower").expect("a mass").amplitude().to_bits()
    };
    assert_eq!(amplitude(&own), amplitude(&other));
    assert!(own.stops() >= 2 && own.reversals() == 0 && !own.is_marginal());
    assert!(own.stuck_fraction() > 0.0 && own.stuck_fraction() < 1.0);
    let from = at
        .orbit_from(0.2, (&[0.5, -0.5], &[0.1, 0.0]))
        .expect("a state");
    let (a, b) = (own.mass("upper"), from.mass("upper"));
    let (a, b) = (
        a.expect("a mass").amplitude(),
        b.expect("a mass").amplitude(),
    );
    assert!((a - b).abs() < 1e-9 * a, "{a} for {b}");
    assert!(at.states(0.2).expect("states").next().is_some());
    let stuck = at.orbit(3.0 * at.sliding_limit()).expect("a state");
    assert!(stuck.never_slides() && stuck.is_marginal() && stuck.is_stable());
}

/// `response` tells the regime.  A contact that never slides moves with its spring by ρf.
#[test]
fn responses_follow_the_spring() {
    let system: System = FRAME.parse().expect("a scene");
    let (r, compliance) = (0.8, 1190.0 / 5.0e3);
    let at = system.at(r).expect("in the domain");
    let limit = at.sliding_limit();
    let slides = at.response(0.3 * limit).expect("a response");
    assert_eq!(slides.regime(), Regime::StickSlip);
    // The force reaches μβ, and friction takes energy.
    assert!((slides.contact_force() - 1.2 * 0.3 * limit).abs() < 1e-15);
    assert!(slides.friction_work() > 0.0);
    let stuck = at.response(3.0 * limit).expect("a response");
    assert_eq!(stuck.regime(), Regime::Stuck);
    assert_eq!(stuck.friction_work(), 0.0);
    let SystemResponse::Stuck(held) = &stuck else {
        panic!("{stuck:?}")
    };
    let (contact, offset) = held.motion_of(Of::Contact).expect("the contact");
    let upper = at.stuck().expect("stuck").mass("upper").expect("a mass");
    assert!((contact - upper).norm() < 1e-14 && offset == 0.0);
    assert!((contact.norm() - compliance * 1.2 * limit).abs() < 1e-14);
    let swing = stuck.swing(Of::Contact).expect("the contact");
    assert!((swing.amplitude - upper.norm()).abs() < 1e-14);
    // The motion in time has the same amplitude, because nothing slides.
    let orbit = at.orbit(3.0 * limit).expect("a state");
    let amplitude = orbit.contact().amplitude();
    assert!((amplitude - upper.norm()).abs() < 1e-12, "{amplitude}");
    let curve_free = at.response(0.0).expect("a response");
    assert!(curve_free.swing(Of::Mass(0)).is_some());
}

/// Checks the phase of the contact with its sides in both orders. The sides in the other order reverse the sign of the
/// motion, so that the phases differ by half a turn. This also holds while the contact sticks, because its spring moves.
#[test]
fn the_order_of_the_sides_turns_the_phase() {
    let frame = |contact: &str| -> System {
        let text = FRAME.replace("upper - wall", contact);
        text.parse().expect("a scene")
    };
    let frames = [frame("lower - upper"), frame("upper - lower")];
    let reversed = frames.each_ref().map(System::contact_is_reversed);
    assert_ne!(reversed[0], reversed[1]);
    let mut stuck = 0;
    for beta in [0.05, 0.2, 30.0] {
        let orbits = frames.each_ref().map(|frame| {
            let at = frame.at(0.7).expect("in the domain");
            at.orbit(beta).expect("a steady state")
        });
        stuck += usize::from(orbits[0].never_slides());
        let phase = |index: usize| match reversed[index] {
            true => orbits[index].reversed_contact_phase(),
            false => orbits[index].contact().phase(),
        };
        let turn = (phase(0) - phase(1)).abs() - std::f64::consts::PI;
        assert!(
            turn.abs() < 1e-9,
            "β = {beta}: {} and {}",
            phase(0),
            phase(1)
        );
    }
    assert_eq!(stuck, 1);
}
