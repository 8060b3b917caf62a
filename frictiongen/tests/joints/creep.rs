//! Contacts that stick do not creep, beside others that slide, on a free chain too.

use crate::scene::{Scene, between, ground};
use frictiongen::kernel::joints::{Joint, Phase};
use std::f64::consts::TAU;

/// Four masses in a row, joined by contacts alone.  A force of amplitude 10 on mass 4 makes the contact 3–4 slide, whose
/// level of 3 reaches the others.  Free, the contacts 1–2 and 2–3 hold 1/3 and 2/3 of it at 0.2 and 0.3 of their grip.
/// With mass 1 on the wall each contact holds all of it, at 0.95, 0.3 and 0.2 of its grip.
fn scene(free: bool) -> Scene {
    let level = 3.0;
    let mut scene = Scene {
        masses: vec![1.0; 4],
        joints: [0, 1, 2]
            .map(|i| Joint {
                link: between(i, i + 1),
                stiffness: None,
                stiction: 1.0,
            })
            .to_vec(),
        levels: vec![level / 3.0 / 0.2, 2.0 * level / 3.0 / 0.3, level],
        forces: vec![0.0, 0.0, 0.0, 10.0],
        omega: 7.0,
        ..Scene::default()
    };
    if !free {
        // Mass 1 on the wall: the contact holds the level of the sliding contact.
        scene.joints.insert(
            0,
            Joint {
                link: ground(0),
                stiffness: None,
                stiction: 1.0,
            },
        );
        scene.levels = [0.95, 0.3, 0.2].map(|part| level / part).to_vec();
        scene.levels.push(level);
    }
    scene
}

fn creeps(steps: u32, free: bool) {
    let scene = scene(free);
    let n = scene.joints.len() - 1;
    let mut count = 0;
    let mut events = 0;
    // About 20 steps a cycle.
    let end = f64::from(steps) / 20.0 * TAU / scene.omega;
    let followed = scene.follow(end, |run, step, _| {
        count += 1;
        events += usize::from(step.event);
        let (x, v) = (run.displacements(), run.velocities());
        for state in &run.joints()[..n] {
            assert_eq!(state.phase, Phase::Stuck);
            assert_eq!(state.place.to_bits(), 0.0f64.to_bits());
        }
        // Exactly equal positions and velocities, in every bit.
        for mass in 1..3 {
            assert_eq!(x[mass].to_bits(), x[0].to_bits(), "at {}", step.to);
            assert_eq!(v[mass].to_bits(), v[0].to_bits(), "at {}", step.to);
        }
        if !free {
            assert_eq!((x[0], v[0]), (0.0, 0.0));
        }
    });
    followed.expect("a run");
    assert!(
        count > steps / 4 && events > usize::try_from(steps / 20).expect("few"),
        "{count} steps, {events} events"
    );
}

#[test]
fn stuck_contacts_do_not_creep() {
    creeps(20_000, false);
    creeps(20_000, true);
}

#[test]
#[ignore = "slow: a million steps"]
fn stuck_contacts_do_not_creep_in_a_million_steps() {
    creeps(1_000_000, false);
    creeps(1_000_000, true);
}
