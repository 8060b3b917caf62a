//! Steady states, the stuck state, and multipliers.

use frictiongen::System;
use frictiongen::study::scene::Spring;

const FRAME: &str = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: 5.0e3,
    excitation: base, damping: modal[0.010, 0.012], stiction: 1.2, provide: [orbit, simulation] }";

/// Without damping the stuck chain is a chain with one more spring.  The amplitudes of that chain come from its own modal
/// analysis.
#[test]
fn the_stuck_chain_has_one_more_spring() {
    let mut compared = 0;
    for stiffness in [1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9] {
        let text = FRAME
            .replace("damping: modal[0.010, 0.012],", "")
            .replace("5.0e3", &format!("{:?}", 1190.0 * stiffness));
        let system: System = text.parse().expect("a scene");
        let mut scene = system.scene().clone();
        scene.stiffness = None;
        scene.springs.push(Spring {
            from: scene.contact.from,
            to: scene.contact.to,
            stiffness: 1190.0 * stiffness,
        });
        scene.provide = vec![frictiongen::study::scene::Provide::Limits];
        let sprung = System::<f64>::try_from(scene).expect("a scene");
        for r in [0.3, 0.8, 1.4, 2.2] {
            let shapes = sprung.mode_shapes();
            let amplitudes = system.stuck_amplitudes(r).expect("no resonance");
            for (mass, own) in amplitudes.iter().enumerate() {
                // The base moves the first mass through the first spring, with the load 1.
                let modes = shapes.iter().zip(sprung.resonances());
                let expected: f64 = modes
                    .map(|(shape, sigma)| shape[mass] * shape[0] / (sigma * sigma - r * r))
                    .sum();
                let error = (own.re - expected).abs() / expected.abs().max(1e-3);
                assert!(
                    error < 1e-12 && own.im == 0.0,
                    "k = {stiffness}, r = {r}, mass {mass}: {error:e}"
                );
                compared += 1;
            }
            // The spring's force is its stiffness times the displacement.
            let force = system.stuck_limit(r).expect("no resonance") * 1.2;
            let spring = stiffness * amplitudes[1].re.abs();
            // The displacement of a stiff spring is a small difference of the modes.
            let tolerance = 1e-12 * force + 1e-15 * stiffness;
            assert!((force - spring).abs() < tolerance, "{force} for {spring}");
        }
    }
    assert_eq!(compared, 48);
}

/// From its limit on an elastic contact never slides, and the state is marginal.  Just below, it slides.
#[test]
fn the_limit_separates_stuck_from_sliding() {
    let system: System = FRAME.parse().expect("a scene");
    for r in [0.4, 0.9, 1.7] {
        let limit = system.stuck_limit(r).expect("no resonance");
        let above = system.steady_state(r, 3.0 * limit).expect("a steady state");
        assert!(above.never_slides() && above.is_marginal() && above.is_stable());
        assert_eq!(
            (above.multipliers().len(), above.stuck_fraction()),
            (5, 1.0)
        );
        assert_eq!(above.multipliers()[0].re, 1.0);
        let amplitudes = system.stuck_amplitudes(r).expect("no resonance");
        for (mass, amplitude) in amplitudes.iter().enumerate() {
            let swing = above
                .mass(["lower", "upper"][mass])
                .expect("a mass")
                .amplitude();
            assert!(
                (swing - amplitude.norm()).abs() < 1e-12 * swing.max(1e-3),
                "{swing} for {amplitude}"
            );
        }
        let below = system.steady_state(r, 0.9 * limit).expect("a steady state");
        assert!(!below.never_slides() && below.stops() >= 2 && !below.is_marginal());
    }
}

/// A motion near a steady state comes closer by the largest multiplier in every cycle.
#[test]
fn motions_approach_as_the_multipliers_say() {
    let system: System = FRAME.replace("1.2", "1.0").parse().expect("a scene");
    let (r, beta) = (0.8, 0.2);
    let orbit = system.steady_state(r, beta).expect("a steady state");
    assert!(orbit.stops() >= 2);
    let largest = orbit
        .multipliers()
        .iter()
        .map(|value| value.norm())
        .fold(0.0, f64::max);
    let at_maximum = |name: &str| {
        let motion = orbit.mass(name).expect("a mass");
        [
            motion.displacement(-orbit.origin()),
            motion.velocity(-orbit.origin()),
        ]
    };
    let fixed = [at_maximum("lower"), at_maximum("upper")].concat();
    let mut run = system.simulation(r, beta).expect("a run");
    let distance = |run: &frictiongen::study::simulation::SystemSimulation<'_>| {
        let moments = ["lower", "upper"].map(|name| run.mass(name).expect("a mass"));
        let own = moments
            .iter()
            .flat_map(|moment| [moment.displacement(), moment.velocity()]);
        own.zip(&fixed)
            .fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
    };
    let mut far = Vec::new();
    let mut passed = 0.0;
    for cycle in 1..=80 {
        let end = std::f64::consts::TAU * f64::from(cycle);
        while passed < end {
            passed += run.advance(end - passed).expect("a segment").length;
        }
        far.push(distance(&run));
    }
    assert!(far[79] < 0.1 * far[0], "{far:?}");
    // Over many cycles two modes beat, so that the mean rate counts.
    let rate = (far[79] / far[39]).powf(1.0 / 40.0);
    println!("rate {rate}, largest multiplier {largest}");
    assert!((rate - largest).abs() < 0.02, "{rate} for {largest}");
}
