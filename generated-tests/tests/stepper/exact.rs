//! The stepper in double precision against itself in double-double.

use crate::independent::loads;
use crate::rig::{LINEAR, Load, advance, begin, rig, scene};
use crate::scenes::{BASE, ONE, PAIR, TEN, WALL, sticky};
use frictiongen_kernel::number::dd::Dd;

/// The largest difference over the largest displacement, and how many events.
fn off(text: &str, steps: u32, friction: f64) -> (f64, u64) {
    let scene = scene(text);
    let omega = (scene.springs[0].stiffness / scene.masses[0].value).sqrt();
    let dt = 0.3 / omega;
    let mut next = loads(&scene, 5, dt);
    let mut load = move || {
        let load = next();
        Load {
            friction: friction * load.friction,
            ..load
        }
    };
    let mut narrow = rig::<f64>(&scene, LINEAR, dt);
    let mut wide = rig::<Dd>(&scene, LINEAR, dt);
    let start = load();
    begin(&mut narrow, &start);
    begin(&mut wide, &start);
    let (mut apart, mut size, mut events) = (0.0_f64, 0.0_f64, 0);
    for _ in 0..steps {
        let load = load();
        let stepped = advance(&mut narrow, &load);
        advance(&mut wide, &load);
        events += u64::from(stepped.events);
        for mass in 0..scene.masses.len() {
            let want = wide.mass(mass).displacement();
            let found = Dd::from(narrow.mass(mass).displacement());
            apart = apart.max((found - want).to_f64().abs());
            size = size.max(want.to_f64().abs());
        }
    }
    println!(
        "{}, μ = {}, F {friction} times: {steps} steps, {events} events, {:.1e}",
        scene.name,
        scene.stiction,
        apart / size
    );
    (apart / size, events)
}

/// The held chain has no event, but for a stop at the start where the base moves already.  Nothing but damping forgets there: without it the rounding of a frequency,
/// 1e-16 of the angle passed, is what is left (`ONE` does not move at all while it is held).
#[test]
fn without_events() {
    for text in [WALL, BASE, PAIR, TEN] {
        let (error, events) = off(text, 4000, 1e4);
        assert!(events <= 1 && error < 1e-13, "{text}: {error:e}");
    }
}

/// With μ = 1 two motions never part, whatever events they have; with μ > 1 a break-away that comes later by a rounding
/// leaves the contact with another force meanwhile, and a stop forgets it.
#[test]
fn with_events() {
    for text in [WALL, BASE, PAIR, ONE, TEN] {
        for mu in [1.0, 1.3] {
            let (error, events) = off(&sticky(text, mu), 3000, 1.0);
            assert!(events > 200 && error < 1e-13, "{text}: {error:e}, {events}");
        }
    }
}

/// 10⁵ steps, more than 10⁴ events.
#[test]
#[ignore = "a minute"]
fn long() {
    for text in [WALL, BASE, PAIR, TEN] {
        let (error, events) = off(text, 100_000, 1e4);
        assert!(events <= 1 && error < 1e-12, "{text}: {error:e}");
    }
    for text in [WALL, BASE, PAIR, ONE, TEN] {
        for mu in [1.0, 1.3] {
            let (error, events) = off(&sticky(text, mu), 100_000, 1.0);
            assert!(
                events > 5_000 && error < 1e-12,
                "{text}: {error:e}, {events}"
            );
        }
    }
}
