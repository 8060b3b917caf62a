//! Tests emitted simulations and steady states with stops for arbitrary bits of r, β and τ.

use crate::fuzz::functions::{Asked, Seen, question};
use crate::fuzz::{long, moving, none};
use frictiongen::kernel::Scalar;
use fuzzing::{Random, bits};

macro_rules! scenes {
    ($($name:ident $scalar:ident $masses:literal { $($body:tt)* })*) => {
        $(::frictiongen::friction_system! {
            pub struct $name { $($body)* scalar: $scalar, provide: [limits, orbit, simulation], }
        })*

        /// The checks of the emitted scenes, one function for each scene.
        const CHECKS: &[fn(&Asked, &Seen) -> Result<(), String>] = &[$(|asked, seen| {
            let r = <$scalar as Scalar>::constant(asked.r);
            let Ok(at) = $name::at(r) else {
                seen.note("no: r refused");
                return Ok(());
            };
            let beta = asked.beta(at.continuous_limit(), at.sliding_limit());
            if let Ok(mut run) = $name::simulation(r, beta) {
                moving::run(&mut run, $masses)?;
                seen.note("runs");
            } else {
                seen.note("no run: r or β refused");
            }
            let orbit = at.orbit(beta);
            seen.orbit(&orbit);
            if let Ok(orbit) = orbit {
                let tau = <$scalar as Scalar>::constant(asked.tau);
                moving::orbit(&orbit, $masses, tau, asked.order % 12)?;
            }
            Ok(())
        }),*];
    };
}

scenes! {
    Block f64 1 {
        masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a,
    }
    BlockF32 f32 1 {
        masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a,
        stiction: 1.2,
    }
    Pair f64 2 {
        masses: { a: 1.0, b: 0.7 }, springs: { base - a: 1.0, a - b: 1.3 },
        contact: b - base, excitation: base, damping: modal[0.01, 0.02],
    }
    PairF32 f32 2 {
        masses: { a: 1.0, b: 0.7 }, springs: { base - a: 1.0, a - b: 1.3 },
        contact: a - b, excitation: b, damping: modal(1.0),
    }
}

fn fuzz(count: u64, seed: u64) {
    let mut random = Random(seed);
    let next = || {
        let scene = random.below(CHECKS.len());
        let single = scene % 2 == 1;
        let asked = question(
            &mut random,
            scene,
            &[0.5, 0.75, 1.0, 1.5],
            |random, marks| {
                if single {
                    f64::from(bits::single(random, marks))
                } else {
                    bits::double(random, marks)
                }
            },
        );
        (scene, asked)
    };
    let seen = Seen::default();
    let findings = fuzzing::run(count, next, |(scene, asked)| CHECKS[*scene](asked, &seen));
    none("emitted steady states", &findings);
    seen.report(findings.count, &[("runs", 3), ("orbits", 3)]);
}

#[test]
fn runs_and_steady_states_are_answered_by_numbers() {
    fuzz(1_000, 31);
}

#[test]
#[ignore = "a million runs and steady states: many minutes"]
fn a_million_steady_states() {
    fuzz(long(), 32);
}
