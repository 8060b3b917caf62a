//! Energy balance of random scenes: what the load puts in is stored, or taken by dampers and contacts.

use crate::scene::{Scene, between, ground, value};
use frictiongen::kernel::joints::{Joint, Link, Phase, Run, Series, Step};
use fuzzing::Random;
use std::f64::consts::TAU;

/// A random chain of 1 to 8 masses with 1 to 4 contacts, dashpots and modal damping.  A third is free.
fn scene(random: &mut Random) -> Scene {
    let n = 1 + random.below(8);
    let free = random.below(3) == 0;
    let base_moves = !free && random.below(2) == 0;
    let base = f64::from(u8::from(base_moves));
    let on_base = |mass: usize| Link {
        base,
        ..ground(mass)
    };
    let mut scene = Scene {
        masses: (0..n).map(|_| random.between(0.5, 4.0)).collect(),
        forces: vec![0.0; n],
        omega: random.between(5.0, 60.0),
        ..Scene::default()
    };
    if !free {
        scene
            .springs
            .push((on_base(0), random.between(500.0, 4000.0)));
    }
    for i in 1..n {
        scene
            .springs
            .push((between(i - 1, i), random.between(500.0, 4000.0)));
    }
    if random.below(2) == 0 {
        let zeta: Vec<_> = (0..n).map(|_| random.between(0.001, 0.06)).collect();
        scene.damp(&zeta);
    }
    if n > 1 && random.below(2) == 0 {
        let i = 1 + random.below(n - 1);
        scene
            .dampers
            .push((between(i - 1, i), random.between(1.0, 20.0)));
    }
    if base_moves {
        scene.base = 0.01;
    } else {
        scene.forces[random.below(n)] = 20.0;
    }
    for _ in 0..=random.below(4) {
        // Contact of mass i with the ground, the base or a mass before it; at most one rigid contact for each mass i.
        let i = random.below(n);
        let link = match random.below(3) {
            0 if i > 0 => between(random.below(i), i),
            1 => on_base(i),
            _ => ground(i),
        };
        let taken = scene.joints.iter().any(|joint| joint.link.to == Some(i));
        let stiff = random.between(2000.0, 20_000.0);
        scene.joints.push(Joint {
            link,
            stiffness: (taken || random.below(2) == 0).then_some(stiff),
            stiction: if random.below(3) == 0 {
                random.between(1.0, 1.6)
            } else {
                1.0
            },
        });
        scene.levels.push(random.between(0.5, 30.0));
    }
    scene
}

/// Integral of a product of two series from 0 to `part`.
fn integral(a: &Series<f64>, b: &Series<f64>, part: f64) -> f64 {
    let mut sum = 0.0;
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            let n = i32::try_from(i + j + 1).expect("few");
            sum += a * b * part.powi(n) / f64::from(n);
        }
    }
    sum
}

/// Series of a link's relative motion.
fn relative(link: &Link<f64>, x: &[Series<f64>], base: &Series<f64>) -> Series<f64> {
    std::array::from_fn(|n| {
        let of = |end: Option<usize>| end.map_or(0.0, |mass| x[mass][n]);
        of(link.to) - of(link.from) - link.base * base[n]
    })
}

fn scaled(series: &Series<f64>, factor: f64) -> Series<f64> {
    series.map(|term| term * factor)
}

/// Kinetic energy and energy of the springs, at `u` of the series, without the springs of the contacts.
fn stored(scene: &Scene, run: &Run<'_, f64, &Scene>, u: f64) -> f64 {
    let [x, v, _] = run.series();
    let kinetic: f64 = scene
        .masses
        .iter()
        .zip(v)
        .map(|(m, v)| 0.5 * m * value(v, u).powi(2))
        .sum();
    let spring =
        |(link, k): &(Link<f64>, f64)| 0.5 * k * value(&relative(link, x, run.base()), u).powi(2);
    kinetic + scene.springs.iter().map(spring).sum::<f64>()
}

/// Work of the load, and work that dampers and contacts take, over a step.
fn works(scene: &Scene, run: &Run<'_, f64, &Scene>, step: Step<f64>) -> [f64; 2] {
    let [x, v, forces] = run.series();
    let base = run.base();
    let angle = std::f64::consts::PI;
    let span = step.span;
    let (mut put, mut taken) = (0.0, 0.0);
    let rates: Series<f64> =
        std::array::from_fn(|n| base.get(n + 1).map_or(0.0, |c| c * (n as f64 + 1.0) / span));
    let integral = |a: &Series<f64>, b: &Series<f64>| span * integral(a, b, step.part);
    for (v, amplitude) in v.iter().zip(&scene.forces) {
        let mut force = [0.0; frictiongen::kernel::joints::TERMS];
        frictiongen::kernel::joints::harmonic(
            *amplitude,
            scene.omega * step.from / angle,
            scene.omega * span,
            &mut force,
        );
        put += integral(&force, v);
    }
    for (link, k) in &scene.springs {
        put -= integral(&scaled(&relative(link, x, base), k * link.base), &rates);
    }
    for (link, c) in &scene.dampers {
        let z = relative(link, v, &rates);
        taken += c * integral(&z, &z);
    }
    let n = v.len();
    for (index, c) in scene.damping.iter().enumerate() {
        taken += c * integral(&v[index / n], &v[index % n]);
    }
    for (joint, force) in scene.joints.iter().zip(forces) {
        put -= integral(&scaled(force, joint.link.base), &rates);
        taken += integral(force, &relative(&joint.link, v, &rates));
    }
    [put, taken]
}

/// Returns the largest defect of the balance over a scene's run, over the work done so far, and the number of events.
fn balance(scene: &Scene) -> (f64, usize) {
    let (mut put, mut taken, mut size) = (0.0f64, 0.0f64, 0.0f64);
    let (mut worst, mut events, mut first) = (0.0f64, 0, None);
    let end = 5.0 * TAU / scene.omega;
    let followed = scene.follow(end, |run, step, passed| {
        if passed {
            events += usize::from(step.event);
            return;
        }
        let start = *first.get_or_insert_with(|| stored(scene, run, 0.0));
        let [put_now, taken_now] = works(scene, run, step);
        put += put_now;
        taken += taken_now;
        // Of the work of an elastic contact, what it did while stuck is in its spring.
        let [_, v, forces] = run.series();
        let span = step.span;
        let rates: Series<f64> = std::array::from_fn(|n| {
            run.base()
                .get(n + 1)
                .map_or(0.0, |c| c * (n as f64 + 1.0) / span)
        });
        for (((joint, state), level), force) in scene
            .joints
            .iter()
            .zip(run.joints())
            .zip(&scene.levels)
            .zip(forces)
        {
            let Some(k) = joint.stiffness else {
                if state.phase == Phase::Stuck {
                    // A stuck rigid contact takes nothing.
                    let z = relative(&joint.link, v, &rates);
                    let work = span * integral(force, &z, step.part);
                    assert!(work.abs() < 1e-12 * (1.0 + size), "{work:e}");
                }
                continue;
            };
            if state.phase == Phase::Stuck {
                // Energy of the spring where the contact slides.
                let full = 0.5 * level * level / k;
                let work = span * integral(force, &relative(&joint.link, v, &rates), step.part);
                let [from, to] =
                    [value(force, 0.0), value(force, step.part)].map(|f| 0.5 * f * f / k);
                assert!(
                    (to - from - work).abs() < 1e-11 * (size + full),
                    "{to} {from} {work}"
                );
            }
        }
        let now = stored(scene, run, step.part);
        size = size.max(now).max(taken).max(put.abs());
        worst = worst.max((now - start + taken - put).abs());
    });
    followed.unwrap_or_else(|trouble| panic!("{trouble:?}: {scene:?}"));
    // Over the largest energy or work of the run, which is 0 where the load moves nothing.
    (worst / size.max(f64::MIN_POSITIVE), events)
}

fn balances(seed: u64, scenes: u32) {
    let mut random = Random(seed);
    let mut events = 0;
    for index in 0..scenes {
        let scene = scene(&mut random);
        let (defect, found) = balance(&scene);
        events += found;
        assert!(
            defect < 1e-11,
            "seed {seed}, scene {index}: {defect:e}, {scene:?}"
        );
    }
    assert!(
        events > 5 * usize::try_from(scenes).expect("few"),
        "{events} events"
    );
}

#[test]
fn energy_is_balanced() {
    balances(30, 40);
}

#[test]
#[ignore = "slow: 10,000 scenes"]
fn energy_of_many_scenes_is_balanced() {
    for part in 0..10 {
        balances(30 + part, 1000);
    }
}
