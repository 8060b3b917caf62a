//! Tests of chains without a support, and of chains without springs.

use super::{apart, system};
use crate::answer::Event;
use crate::study::joined::JoinedError;

const BLOCK: &str =
    "struct Block { masses: { block: 2.0 }, contacts: { floor: block - wall }, excitation: block }";

/// Compares the motion of a block on a floor with its closed form, where θ = ωt is the phase of the load. The block
/// starts at once with the velocity (P sin θ − Fθ)/(mω), and stops when P sin θ = Fθ.
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

/// Checks two masses with a dashpot and without a support. Half of the distance between the extremes of a mass must
/// equal the amplitude of the linear response.
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
    assert!(
        slipping
            .contact_named("clutch")
            .expect("a contact")
            .energy()
            > 0.0
    );
    // While the clutch sticks, both masses move as one body with the amplitude P/(5 ω²), where P = k₁.
    let body = 500.0 / (5.0 * at.omega() * at.omega());
    let got = stuck.mass("right").expect("a mass").norm();
    assert!(apart(got, body) < 1e-12, "{got} {body}");
}

/// Checks that the natural frequencies of a free chain of two masses are exactly 0 and √(k(1/m + 1/n)).
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

/// Checks that each steady state of a scene with μ > 1 repeats after its period.
#[test]
fn states_repeat() {
    let frame = system(super::FRAME);
    let at = frame.joined().expect("answers").at(0.6).expect("r");
    let states = at.states(0.4).expect("states");
    assert!(!states.is_empty());
    for orbit in &states {
        let mut run = orbit.simulation().expect("a motion");
        let (before, _) = run.state();
        run.advance(std::f64::consts::TAU * orbit.period() as f64)
            .expect("a motion");
        for (a, b) in before.iter().zip(run.state().0) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
    }
}

/// Checks the samples of a period. The first and the last sample must be equal, and the events must be those of the
/// contacts.
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
        let contact = orbit.contact_named(name).expect("a contact");
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
