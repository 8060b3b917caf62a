//! Tests of chains without a support, and of chains without springs.

use super::{apart, system};
use crate::answer::Event;
use crate::study::joined::{JoinedError, JoinedHistory, JoinedOrbit};
use crate::study::joints::JointError;
use std::f64::consts::TAU;

const BLOCK: &str =
    "struct Block { masses: { block: 2.0 }, contacts: { floor: block - wall }, excitation: block }";

/// Compares the motion of a block on a floor with its closed form, where θ = ωt is the phase of the load. The block
/// slides from the start with the velocity (P sin θ − Fθ)/(mω), and reverses when P sin θ = Fθ.
#[test]
fn a_block_on_a_floor() {
    let block = system(BLOCK);
    let joined = block.joined().expect("answers");
    assert_eq!(joined.at(0.5).map(|_| ()), Err(JoinedError::NoSpring));
    let (omega, load, friction) = (7.0, 10.0, 3.0);
    let at = joined.under(omega, load).expect("a load");
    let mut run = at.simulation(friction).expect("a motion");
    let events = run.advance(2.9).expect("a motion");
    let (mut low, mut high) = (1.0_f64, 3.0_f64);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if load * middle.sin() > friction * middle {
            low = middle;
        } else {
            high = middle;
        }
    }
    let kinds: Vec<Event> = events.iter().map(|event| event.event).collect();
    // When the velocity becomes 0, the load −P cos θ exceeds the static friction force. The block reverses without a
    // stop.
    assert_eq!(kinds, [Event::Reversal], "{events:?}");
    assert!(
        (events[0].tau - low).abs() < 1e-12,
        "{} {low}",
        events[0].tau
    );
    let place = |theta: f64| {
        (load * (1.0 - theta.cos()) - 0.5 * friction * theta * theta) / (2.0 * omega * omega)
    };
    let slip = run.contact_named("floor").expect("a contact").slip;
    assert!(slip > place(low) && run.contact_named("floor").expect("a contact").force == -friction);
}

/// Checks two masses with a dashpot and without a support. The centred amplitude (max − min)/2 of each mass must equal
/// the amplitude of the linear response.
#[test]
fn a_free_pair_vibrates_about_its_mean_place() {
    let pair = system(
        "struct Pair { masses: { left: 2.0, right: 3.0 }, springs: { left - right: 500.0 },
        contacts: { clutch: left - right }, dampers: { left - right: 4.0 }, excitation: left }",
    );
    let joined = pair.joined().expect("answers");
    let at = joined.at(0.7).expect("r");
    let (linear, orbit) = (
        at.linear().expect("a response"),
        at.orbit(0.0).expect("a state"),
    );
    assert!(orbit.is_marginal() && orbit.free_directions() > 0);
    for name in ["left", "right"] {
        let expected = linear.mass(name).expect("a mass").norm();
        let got = orbit.amplitude(name).expect("a mass");
        assert!(apart(got, expected) < 1e-9, "{name}: {got} {expected}");
    }
    // With friction the masses still vibrate, and the contact `clutch` dissipates energy.
    let stuck = at.stuck().expect("a state");
    let slipping = at.orbit(0.5 * stuck.limit()).expect("a state");
    assert!(slipping.contact("clutch").expect("a contact").energy() > 0.0);
    // While the clutch sticks, both masses (5 kg together) move as one body. Its amplitude is P/(5ω²), with P = k₁ =
    // 500.
    let body = 500.0 / (5.0 * at.omega() * at.omega());
    let got = stuck.mass("right").expect("a mass").norm();
    assert!(apart(got, body) < 1e-12, "{got} {body}");
}

/// Checks the natural frequencies of a chain of two masses m and n without a support. They must be exactly 0, and
/// √(k(1/m + 1/n)) with the stiffness k of the spring between the masses.
#[test]
fn natural_frequencies_of_a_free_chain() {
    let pair = system(
        "struct Pair { masses: { left: 2.0, right: 3.0 }, springs: { left - right: 500.0 },
        contacts: { clutch: left - right }, excitation: left, damping: rayleigh(0.1, 0.0) }",
    );
    let found = pair.natural_frequencies();
    assert_eq!(found[0], 0.0);
    assert!(apart(found[1], (500.0_f64 * (1.0 / 2.0 + 1.0 / 3.0)).sqrt()) < 1e-14);
    assert!(system(BLOCK).natural_frequencies() == [0.0]);
}

/// Checks that the motion from each steady state of a scene with μ > 1 repeats after the period of this state.
#[test]
fn states_repeat() {
    let frame = system(super::FRAME);
    let at = frame.joined().expect("answers").at(0.6).expect("r");
    let states = at.states(0.4).expect("states");
    assert!(!states.is_empty());
    for orbit in &states {
        let mut run = orbit.simulation().expect("a motion");
        let (before, _) = run.state();
        run.advance(TAU * orbit.period() as f64).expect("a motion");
        for (a, b) in before.iter().zip(run.state().0) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
}

/// Checks a chain in which nothing damps one mode. Both contacts act on the middle mass, which rests in the antisymmetric
/// mode. The motion from rest vibrates in this mode for ever, and is not periodic. The motion from the response without
/// this vibration is. At the frequency of the mode no steady state exists, and the search gives the reason.
#[test]
fn no_steady_state_has_a_reason() {
    let chain = system(
        "struct Chain { masses: { a: 1, b: 1, c: 1 }, springs: { base - a: 1, a - b: 3, b - c: 3, c - wall: 1 },
        contacts: { left: b - wall { stiffness: 2 }, right: b - base { stiffness: 3 } }, excitation: a }",
    );
    let joined = chain.joined().expect("answers");
    let unsettled = Some(JoinedError::Engine(JointError::NotSteady));
    let at = joined.at(0.73).expect("r");
    assert_eq!(at.orbit(0.3).err(), unsettled);
    let states = at.states(0.3).expect("a state");
    let neutral = |orbit: &JoinedOrbit<'_>| !orbit.is_stable() && !orbit.is_unstable();
    assert!(states.len() == 1 && states.iter().all(neutral));
    let at = joined.at(2.0).expect("r");
    assert_eq!(at.states(0.3).err(), unsettled);
}

/// Checks that a path (samples with two more samples at each event) has the corners of the hysteresis loops. The area
/// of a polygon through the samples must be the dissipated energy, although each cycle has only 16 equal intervals.
#[test]
fn a_path_has_the_corners() {
    let frame = system(super::FRAME);
    let at = frame.joined().expect("answers").at(0.6).expect("r");
    let orbit = at.orbit(0.4).expect("a state");
    let mut run = orbit.simulation().expect("a motion");
    let plain = run
        .clone()
        .history(0, orbit.period() as u32, 16)
        .expect("a motion");
    let path = run.path(0, orbit.period() as u32, 16).expect("a motion");
    assert_eq!(path.events, plain.events);
    assert_eq!(path.taus.len(), plain.taus.len() + 2 * path.events.len());
    assert!(path.taus.windows(2).all(|pair| pair[0] <= pair[1]));
    let energy = |history: &JoinedHistory, index: usize| -> f64 {
        let points = history
            .contacts
            .iter()
            .map(|all| (all[index].displacement, all[index].force));
        let points: Vec<(f64, f64)> = points.collect();
        let sides = points.windows(2);
        sides
            .map(|pair| 0.5 * (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1))
            .sum()
    };
    for (index, name) in ["brace", "pads"].into_iter().enumerate() {
        let exact = orbit.contact(name).expect("a contact").energy();
        let (cut, whole) = (energy(&plain, index), energy(&path, index));
        // Between events, the force is a straight line over the displacement. The samples of a path are 1e-9 rad before
        // and after each event.
        assert!(
            (whole - exact).abs() < 1e-7 * exact,
            "{name}: {whole} {exact}"
        );
        assert!((cut - exact).abs() > 1e-4 * exact, "{name}: {cut} {exact}");
    }
    for (sample, pair) in path.contacts.windows(2).enumerate() {
        for (index, (before, after)) in pair[0].iter().zip(&pair[1]).enumerate() {
            let events = path.events.iter().filter(|event| event.contact == index);
            let mut between = events.filter(|event| {
                path.taus[sample] <= event.tau && event.tau <= path.taus[sample + 1]
            });
            let changes = before.is_sticking != after.is_sticking;
            assert!(!changes || between.next().is_some(), "sample {sample}");
        }
    }
}

/// Checks the samples of one period of a steady state. The first and the last sample must be equal. The stops, the
/// largest force and the slip of each contact must be those of the steady state.
#[test]
fn a_period_sample_by_sample() {
    let frame = system(super::FRAME);
    let at = frame.joined().expect("answers").at(0.6).expect("r");
    let orbit = at.orbit(0.4).expect("a state");
    let mut run = orbit.simulation().expect("a motion");
    let history = run.history(0, orbit.period() as u32, 40).expect("a motion");
    assert_eq!(history.taus.len(), 40 * orbit.period() + 1);
    let (first, last) = (&history.states[0], history.states.last().expect("a sample"));
    for (a, b) in first.0.iter().zip(&last.0) {
        assert!((a - b).abs() < 1e-9, "{a} {b}");
    }
    for (index, name) in ["brace", "pads"].into_iter().enumerate() {
        let contact = orbit.contact(name).expect("a contact");
        let events = history.events.iter().filter(|event| event.contact == index);
        let stops = events.filter(|event| event.event == Event::Stop).count();
        assert_eq!(stops, contact.stops(), "{name}");
        let force = history.contacts.iter().map(|all| all[index].force.abs());
        let force = force.fold(0.0, f64::max);
        assert!(
            force <= contact.force() * (1.0 + 1e-9),
            "{force} {}",
            contact.force()
        );
        let slip = history.contacts.last().expect("a sample")[index].slip;
        assert!(
            (slip - contact.slip()).abs() < 1e-8,
            "{slip} {}",
            contact.slip()
        );
    }
}

/// A rigid and an elastic contact hold the same mass. When both stick and the rigid one breaks away, the elastic one is
/// at its limit without velocity and without acceleration. It must not slip and stop again at this instant. A program
/// with 80 000 explicit steps in a cycle gave the amplitudes.
#[test]
fn an_elastic_contact_beside_a_rigid_one() {
    let chain = system(
        "struct Chain { masses: { a: 1, b: 1, c: 1 }, springs: { a - b: 1, b - c: 1 },
        contacts: { rigid: b - wall, elastic: b - base { stiffness: 2 } }, excitation: a }",
    );
    let joined = chain.joined().expect("answers");
    let at = joined.at(0.5).expect("a frequency");
    let mut run = at.simulation(0.3).expect("a motion");
    run.advance(150.0 * TAU).expect("a motion");
    let (mut events, mut ends) = (0, [[f64::INFINITY, f64::NEG_INFINITY]; 3]);
    for _ in 0..4000 {
        events += run.advance(TAU / 4000.0).expect("a motion").len();
        for ([least, most], mass) in ends.iter_mut().zip(["a", "b", "c"]) {
            let (place, _) = run.mass(mass).expect("a mass");
            (*least, *most) = (least.min(place), most.max(place));
        }
    }
    // In half a cycle both stop, the rigid contact breaks away, and then the elastic one.
    assert_eq!(events, 8);
    for ([least, most], amplitude) in ends.into_iter().zip([1.497_878, 1.439_195, 2.363_016]) {
        let told = (most - least) / 2.0;
        assert!((told - amplitude).abs() < 5e-6, "{told} {amplitude}");
    }
}
