//! Checks steady states of chains without damping, at frictions above the limit of the stuck state (no contact slides).
//! While all contacts stick, the free vibration of such a chain never decays.

use super::system;
use crate::study::joined::JoinedError;
use crate::study::joints::JointError;
use crate::{Regime, System};
use fuzzing::Random;

/// Returns the description of a chain of 2 to 4 masses without damping. The chain has 1 to 4 contacts, rigid or
/// elastic.
fn description(random: &mut Random) -> String {
    let masses = 2 + random.below(3);
    let values = (0..masses).map(|mass| format!("m{mass}: {:.4}", random.between(0.5, 3.0)));
    let values: Vec<String> = values.collect();
    let springs = (0..masses).map(|mass| {
        let lower = match mass {
            0 => "base".to_owned(),
            _ => format!("m{}", mass - 1),
        };
        format!("{lower} - m{mass}: {:.1}", random.between(500.0, 4000.0))
    });
    let springs: Vec<String> = springs.collect();
    let mut places: Vec<usize> = (0..2 * masses).collect();
    let mut contacts = Vec::new();
    for contact in 0..1 + random.below(4) {
        let place = places.remove(random.below(places.len()));
        let mass = place / 2;
        let ends = match (place % 2, mass) {
            (0, _) => format!("m{mass} - wall"),
            (_, 0) => "m0 - base".to_owned(),
            _ => format!("m{mass} - m{}", mass - 1),
        };
        let mut law = format!("share: {:.3}", random.between(0.3, 2.0));
        if random.once_in(3) {
            law += &format!(", stiction: {:.3}", random.between(1.0, 1.5));
        }
        // Rigid contacts must not form a loop. Therefore only the first contact of a scene may be a rigid contact with
        // the wall.
        if contact > 0 && place.is_multiple_of(2) || random.once_in(2) {
            law += &format!(", stiffness: {:.1}", random.between(2e3, 2e4));
        }
        contacts.push(format!("c{contact}: {ends} {{ {law} }}"));
    }
    let excited = match random.once_in(3) {
        true => "base".to_owned(),
        false => format!("m{}", random.below(masses)),
    };
    let [values, springs, contacts] = [values, springs, contacts].map(|parts| parts.join(", "));
    format!(
        "struct Chain {{ masses: {{ {values} }}, springs: {{ {springs} }}, contacts: {{ {contacts} }}, \
         excitation: {excited} }}"
    )
}

/// Checks the steady state at a friction above the limit of the stuck state: no contact may slide. Returns false if the
/// motion from rest does not settle, and otherwise true.
fn check(text: &str, system: &System, (r, factor): (f64, f64)) -> bool {
    let joined = system.joined().expect("answers");
    let at = joined.at(r).expect("a frequency");
    let stuck = at.stuck().expect("a stuck state");
    let orbit = match at.orbit(factor * stuck.limit()) {
        Ok(orbit) => orbit,
        Err(JoinedError::Engine(JointError::NotSteady)) => return false,
        Err(error) => panic!("{text}: {r:?} {factor:?} {} {error}", stuck.limit()),
    };
    assert_eq!(orbit.period(), 1, "{text}");
    assert!(orbit.is_marginal(), "{text}");
    assert_eq!(orbit.regime(), Regime::Stuck, "{text}");
    // Slip before the steady state may have left constant forces. These forces change only the mean of the motion.
    let amplitudes = orbit.centred_amplitudes();
    let largest = amplitudes.iter().copied().fold(0.0, f64::max);
    for (mass, amplitude) in system.scene().masses.iter().zip(&amplitudes) {
        let expected = stuck.mass(&mass.name).expect("a mass").norm();
        let differs = (amplitude - expected).abs();
        // The shooting method ends at a residual of 1e-11 of the largest displacement.
        assert!(differs <= 1e-10 * largest, "{text}: {amplitude} {expected}");
    }
    true
}

/// Checks random scenes. Returns the number of scenes whose motion from rest settles, and the number of scenes whose
/// motion does not settle.
fn check_random(count: usize) -> (usize, usize) {
    let mut random = Random(46);
    let (mut settled, mut unsettled) = (0, 0);
    while settled + unsettled < count {
        let text = description(&mut random);
        // In some of these scenes rigid contacts form a loop. Such a scene is an error.
        let Ok(system) = text.parse::<System>() else {
            continue;
        };
        let point = (random.between(0.2, 2.0), random.between(1.02, 3.0));
        if check(&text, &system, point) {
            settled += 1;
        } else {
            unsettled += 1;
        }
    }
    println!("{settled} scenes settle, {unsettled} do not");
    (settled, unsettled)
}

/// Checks a chain whose free vibration nearly repeats after 21 cycles. This vibration must not lengthen the period.
#[test]
fn a_free_vibration_does_not_lengthen_the_period() {
    let text = "struct Chain {
        masses: { m0: 1.2619, m1: 2.5155, m2: 1.9391 },
        springs: { base - m0: 2781.6, m0 - m1: 2672.8, m1 - m2: 2205.0 },
        contacts: {
            c0: m2 - m1 { share: 1.117 },
            c1: m0 - base { share: 0.611, stiction: 1.490 },
            c2: m2 - wall { share: 0.378, stiffness: 12920.5 },
            c3: m1 - m0 { share: 1.858, stiction: 1.366, stiffness: 13934.3 },
        },
        excitation: base,
    }";
    assert!(check(
        text,
        &system(text),
        (0.46082993357862856, 2.912329671203408)
    ));
}

/// Checks a chain with an elastic contact that slides only once. Afterwards the force in this contact reaches the
/// friction force once in every cycle, without sliding. In the steady state the contact must stick.
#[test]
fn a_contact_that_only_reaches_its_limit_sticks() {
    let text = "struct Chain {
        masses: { m0: 0.9003, m1: 0.8839 },
        springs: { base - m0: 1894.8, m0 - m1: 1838.6 },
        contacts: {
            c0: m0 - wall { share: 0.601, stiffness: 3133.9 },
            c1: m0 - base { share: 1.572 },
            c2: m1 - m0 { share: 1.296 },
            c3: m1 - wall { share: 0.978, stiffness: 7553.7 },
        },
        excitation: base,
    }";
    assert!(check(
        text,
        &system(text),
        (0.878052898275568, 1.553985834373147)
    ));
}

/// Checks a chain with an elastic contact. A step of Newton's method changes the state of the chain while the contact
/// slides. The relative velocity of the contact then has the opposite sign of its force.
#[test]
fn a_contact_with_the_opposite_velocity_sticks() {
    let text = "struct Chain {
        masses: { m0: 1.4195, m1: 0.7766, m2: 1.1827, m3: 0.6518 },
        springs: { base - m0: 2305.6, m0 - m1: 2511.7, m1 - m2: 1317.4, m2 - m3: 1109.2 },
        contacts: {
            c0: m0 - base { share: 1.430 },
            c1: m1 - wall { share: 0.986, stiffness: 6251.5 },
            c2: m2 - m1 { share: 1.763 },
        },
        excitation: base,
    }";
    assert!(check(
        text,
        &system(text),
        (0.8927434556242801, 1.0316973376905607)
    ));
}

#[test]
fn random_scenes_stick() {
    let (settled, _) = check_random(8);
    assert!(settled >= 4, "{settled}");
}

/// Repeats `random_scenes_stick` with more random scenes.
#[test]
#[ignore = "minutes"]
fn random_scenes_stick_long() {
    let (settled, unsettled) = check_random(200);
    assert!(settled > 3 * unsettled, "{settled} {unsettled}");
}
