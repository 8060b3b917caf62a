//! Tests that emitted runs equal those of a run-time system to the last bit.

use frictiongen::kernel::simulation::Segment;
use frictiongen::kernel::{Float, Scalar};
use frictiongen::{Given, OutOfDomain, Run, SimulatesUnder, System};

/// A segment, and the bits of the numbers at its end.
type Passed<S> = (Segment<S>, [u64; 5]);

/// Returns a hundred segments of a run, each with the state of the contact and of a mass at its end.
fn said<F: SimulatesUnder>(
    system: &F,
    [r, beta, amplitude]: [F::Scalar; 3],
    mass: usize,
) -> Result<Vec<Passed<F::Scalar>>, OutOfDomain> {
    let mut run = system.simulation_under(r, beta, amplitude)?;
    let mut all = Vec::new();
    for _ in 0..100 {
        let segment = run.advance(F::Scalar::constant(6.0))?;
        let ((z, rate), moment) = (run.relative(), run.moment(mass));
        let numbers = [
            z,
            rate,
            run.friction(),
            moment.displacement(),
            moment.velocity(),
        ];
        all.push((segment, numbers.map(|number| number.to_f64().to_bits())));
    }
    Ok(all)
}

macro_rules! same {
    ($test:ident, $scalar:ty, ($($points:expr),*), ($x:expr, $v:expr), struct $name:ident { $($body:tt)* }) => {
        #[allow(dead_code, reason = "the frame's stepper is emitted beside its run")]
        mod $test {
            frictiongen::friction_system! {
                pub struct $name { $($body)* }
            }
        }

        #[test]
        fn $test() {
            let text = stringify!(struct $name { $($body)* });
            let system: System<$scalar> = text.parse().expect("a scene");
            let last = system.scene().masses.len() - 1;
            let mut events = 0;
            for point in [$($points),*] {
                let found = said(&$test::$name, point, last).expect("a run");
                let want = said(&system, point, last).expect("a run");
                assert_eq!(found, want, "{point:?}");
                events += want.iter().filter(|(segment, _)| segment.event.is_some()).count();
                let [r, beta, amplitude] = point;
                let found = $test::$name::simulation_under_from(r, beta, amplitude, (&$x, &$v));
                let want = system.simulation_under_from(r, beta, amplitude, (&$x, &$v));
                let (mut found, mut want) = (found.expect("a run"), want.expect("a run"));
                let found: Vec<_> = found.by_ref().take(50).collect();
                assert_eq!(found, want.by_ref().take(50).collect::<Vec<_>>(), "{point:?}");
            }
            println!("{events} events");
            assert!(100 < events);
            let refused = |amplitude| said(&$test::$name, [1.0, 0.3, amplitude], 0).expect_err("none");
            for amplitude in [0.0, -1.0, <$scalar>::NAN, <$scalar>::INFINITY] {
                assert_eq!(refused(amplitude), OutOfDomain::LoadAmplitude(Given::of(amplitude)));
            }
            let refused = |r, beta| said(&$test::$name, [r, beta, 1.0], 0).expect_err("none");
            assert_eq!(refused(<$scalar>::NAN, 0.3), OutOfDomain::FrequencyRatio(Given::NotANumber));
            assert_eq!(refused(0.0, 0.3), OutOfDomain::FrequencyRatioInTime(Given::Zero));
            assert_eq!(refused(1.0, -0.3), OutOfDomain::FrictionRatio(Given::Negative));
        }
    };
}

same!(
    block, f64, ([0.3, 0.3, 10.0], [1.0, 0.5, 30.0], [1.7, 0.2, 8.0]), ([0.2], [-0.3]),
    struct Block {
        masses: { block: 2.0 },
        springs: { base - block: 800.0 },
        contact: block - wall,
        excitation: block,
        stiction: 1.2,
        friction: stribeck(0.02: 0.7, 0.1: 0.55),
        provide: [simulation],
    }
);
same!(
    frame, f64, ([0.3, 0.1, 0.02], [0.8, 0.2, 0.01], [1.7, 0.3, 0.05]), ([0.2, 0.1, -0.3], [0.0, 0.0, 0.4]),
    struct Frame {
        masses: { a: 1.0, b: 2.0, c: 0.5 },
        springs: { base - a: 100.0, a - b: 90.0, b - c: 40.0 },
        contact: c - base,
        excitation: base,
        damping: modal(0.02),
        stiction: 1.4,
        friction: stribeck(0.01: 0.8, 0.05: 1.1),
        provide: [simulation, stepper],
    }
);
same!(
    pair, f32, ([0.3, 0.1, 10.0], [0.5, 0.2, 4.0], [0.9, 0.15, 5.0]), ([0.2, 0.1], [0.1, 0.4]),
    struct Pair {
        masses: { string: 0.1, bow: 0.4 },
        springs: { base - string: 400.0, string - wall: 100.0, bow - wall: 30.0 },
        contact: string - bow,
        excitation: bow,
        damping: modal(0.02),
        stiction: 1.2,
        friction: stribeck(0.05: 0.6, 0.5: 0.3),
        scalar: f32,
        provide: [simulation],
    }
);
