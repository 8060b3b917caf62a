//! Stribeck's law in emitted code of scenes with several contacts.

use frictiongen::OutOfDomain;
use frictiongen::study::joined::JoinedInput;
use std::f64::consts::TAU;

scenes! {
    struct Ribs {
        masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 1500.0, lower - upper: 1200.0 },
        contacts: {
            brace: base - lower { stiffness: 4.0e3, share: 1.5 },
            pads: lower - upper { stiction: 1.1 },
            guide: upper - wall { share: 0.4 },
        },
        damping: modal(0.02),
        excitation: upper,
        friction: stribeck(0.05: 0.7, 0.3: 0.5, 0.9: 0.8),
        provide: [simulation, stepper],
    }
    struct Ribs32 {
        masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 1500.0, lower - upper: 1200.0 },
        contacts: {
            brace: base - lower { stiffness: 4.0e3, share: 1.5 },
            pads: lower - upper { stiction: 1.1 },
            guide: upper - wall { share: 0.4 },
        },
        damping: modal(0.02),
        excitation: upper,
        scalar: f32,
        friction: stribeck(0.05: 0.7, 0.3: 0.5, 0.9: 0.8),
        provide: [stepper],
    }
}

/// Compares emitted simulations, which have non-dimensional groups, with the run-time system in the units of the scene.
#[test]
fn simulations_follow_the_system() {
    let system = system("Ribs");
    let joined = system.joined().expect("answers");
    let (mut events, mut worst) = (0, 0.0_f64);
    for (r, beta, load) in [(0.4, 0.3, 40.0), (0.9, 0.1, 25.0), (1.3, 0.6, 60.0)] {
        let omega = r * (1500.0_f64 / 2.0).sqrt();
        let mut emitted = Ribs::simulation_under(r, beta, load).expect("a simulation");
        let at = joined.under(omega, load).expect("a load");
        let mut run = at.simulation(beta * load).expect("a simulation");
        let length = load / 1500.0;
        for _ in 0..60 {
            events += emitted.advance(0.7).expect("a part");
            run.advance(0.7).expect("a part");
            for (now, name) in [(emitted.lower(), "lower"), (emitted.upper(), "upper")] {
                let (x, v) = run.mass(name).expect("a mass");
                worst = worst.max((now.displacement() - x / length).abs());
                worst = worst.max((now.velocity() - v / length / omega).abs());
            }
            for (now, name) in [(emitted.pads(), "pads"), (emitted.guide(), "guide")] {
                let want = run.contact_named(name).expect("a contact");
                worst = worst.max((now.force() - want.force / load).abs());
                assert_eq!(now.is_sticking(), want.is_sticking, "{name}");
            }
        }
    }
    println!("{events} events, {worst:.1e}");
    assert!(events > 100, "{events}");
    // Displacements have the size 1 to 10. Each event multiplies rounding errors.
    assert!(worst < 1e-11, "{worst:e}");
}

/// Checks that emitted steppers give the bits of the run-time system, and that `f32` follows for half a second.
#[test]
fn steppers_follow_the_system() {
    let system = system("Ribs");
    let joined = system.joined().expect("answers");
    let mut emitted = Ribs::stepper(2e-3).expect("a stepper");
    let mut single = Ribs32::stepper(2e-3).expect("a stepper");
    let mut run = joined.stepper(2e-3).expect("a stepper");
    let (mut events, mut off, mut size) = (0, 0.0_f64, 0.0_f64);
    for step in 0..2000_u16 {
        let force = 40.0 * (f64::from(step) * 0.05).sin();
        let friction = RibsFriction {
            brace: 9.0,
            pads: 6.0,
            guide: if step % 500 < 250 { 3.0 } else { 0.0 },
        };
        let count = emitted
            .advance(RibsInput { force, friction })
            .expect("a step")
            .events;
        let frictions = [
            ("brace", friction.brace),
            ("pads", friction.pads),
            ("guide", friction.guide),
        ];
        let sampled = JoinedInput {
            forces: &[("upper", force)],
            frictions: &frictions,
            ..JoinedInput::default()
        };
        assert_eq!(
            count as usize,
            run.advance(sampled).expect("a step"),
            "{step}"
        );
        events += count;
        let upper = (emitted.upper().displacement(), emitted.upper().velocity());
        assert_eq!(upper, run.mass("upper").expect("a mass"), "{step}");
        if step < 250 {
            let input = Ribs32Input {
                force: force as f32,
                friction: Ribs32Friction {
                    brace: 9.0,
                    pads: 6.0,
                    guide: 3.0,
                },
            };
            single.advance(input).expect("a step");
            off = off.max((f64::from(single.upper().displacement()) - upper.0).abs());
            size = size.max(upper.0.abs());
        }
    }
    println!(
        "{events} events; f32: {:.1e} of the displacement",
        off / size
    );
    assert!(events > 60, "{events}");
    // The run has 250 steps, each with several rounding errors of 6e-8, and a law that lets deviations grow.
    assert!(off < 1e-4 * size, "{off} {size}");
}

/// Checks that a motion in time and the steady state give the same energies, and that they include the law.
#[test]
fn energies_include_the_law() {
    let system = system("Ribs");
    let joined = system.joined().expect("answers");
    let at = joined.under(20.0, 60.0).expect("a load");
    let orbit = at.orbit(12.0).expect("an orbit");
    let mut run = orbit.simulation().expect("a motion");
    let cycles = f64::from(u32::try_from(orbit.period()).expect("few"));
    run.advance(cycles * TAU).expect("a motion");
    for (found, want) in run.contacts().iter().zip(orbit.contacts()) {
        let (energy, slip) = (want.energy(), want.slip());
        println!(
            "{:.9} {energy:.9}, {:.9} {slip:.9}",
            found.energy, found.slip
        );
        assert!((found.energy - energy).abs() < 1e-9 * energy.max(1e-3));
        assert!((found.slip - slip).abs() < 1e-9 * slip.max(1e-3));
    }
    // The kinetic friction of the pads falls below F = 12 N in most of their motion.
    let pads = orbit.contact_named("pads").expect("a contact");
    assert!(pads.energy() < 0.97 * 12.0 * pads.slip());
}

#[test]
fn bad_loads_are_refused() {
    for load in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-320] {
        let refused = Ribs::simulation_under(0.9, 0.3, load);
        assert!(
            matches!(refused, Err(OutOfDomain::LoadAmplitude(_))),
            "{load}: {refused:?}"
        );
    }
}
