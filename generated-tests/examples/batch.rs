//! Compares two ways to compute limits without search: one call for each r, and one call for a slice. Limits without
//! search are closed formulas, which use the velocity constraint at the reversal in place of its largest value. The
//! program prints the nanoseconds for each r, and the speed-up by the slice.
//!
//!     cargo run --release -p generated-tests --features tools --example batch
//!     RUSTFLAGS="-C target-cpu=native" cargo run --release -p generated-tests --features tools --example batch

use frictiongen::{FrictionSystem, System};
use std::hint::black_box;
use std::time::Instant;

const POINTS: usize = 128;
const ROUNDS: usize = 400;
const CALLS: u32 = 20;

macro_rules! scenes {
    ($($name:ident { $($body:tt)* })*) => {
        $(::frictiongen::friction_system! { struct $name { $($body)* provide: [limits] } })*
        fn main() {
            println!("| scene | emitted | slice | times | `System` | slice | times |\n|---|---|---|---|---|---|---|");
            $({
                let system: System = stringify!(struct $name { $($body)* provide: [limits] })
                    .parse()
                    .expect("a valid scene");
                let [emitted, system] = [times(&$name), times(&system)];
                println!("| {} | {} | {} |", stringify!($name), row(emitted), row(system));
            })*
        }
    };
}

scenes! {
    OneUndamped {
        masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: base,
    }
    OneDamped {
        masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: base, damping: modal(0.02),
    }
    TwoUndamped {
        masses: { a: 1, b: 1 }, springs: { base - a: 1, a - b: 1 }, contact: b - wall, excitation: base,
    }
    TwoDamped {
        masses: { a: 1, b: 1 }, springs: { base - a: 1, a - b: 1 }, contact: b - wall, excitation: base,
        damping: modal(0.02),
    }
    FiveUndamped {
        masses: { a: 1, b: 1, c: 1, d: 1, e: 1 }, springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1 },
        contact: e - wall, excitation: base,
    }
    FiveDamped {
        masses: { a: 1, b: 1, c: 1, d: 1, e: 1 }, springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1 },
        contact: e - wall, excitation: base, damping: modal(0.02),
    }
    TenUndamped {
        masses: { a: 1, b: 1, c: 1, d: 1, e: 1, f: 1, g: 1, h: 1, i: 1, j: 1 },
        springs: {
            base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1, e - f: 1, f - g: 1, g - h: 1, h - i: 1, i - j: 1,
        },
        contact: j - wall, excitation: base,
    }
    TenDamped {
        masses: { a: 1, b: 1, c: 1, d: 1, e: 1, f: 1, g: 1, h: 1, i: 1, j: 1 },
        springs: {
            base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1, e - f: 1, f - g: 1, g - h: 1, h - i: 1, i - j: 1,
        },
        contact: j - wall, excitation: base, damping: modal(0.02),
    }
}

/// Returns the nanoseconds for each r, by single calls and by one call for a slice, each as the minimum of all
/// rounds.
fn times<F: FrictionSystem<Scalar = f64>>(system: &F) -> [f64; 2] {
    // The golden section spreads the frequencies evenly over 0.2 to 2.5, in an order that a processor cannot predict.
    let spread = |index: usize| (index as f64 * 0.618_033_988_749_894_9).fract();
    let rs: Vec<f64> = (1..=POINTS)
        .map(|index| 0.2 + 2.3 * spread(index))
        .collect();
    let (mut continuous, mut sliding) = (vec![0.0; POINTS], vec![0.0; POINTS]);
    let mut least = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        let clock = Instant::now();
        for _ in 0..CALLS {
            let rooms = continuous.iter_mut().zip(&mut sliding);
            for (r, (continuous, sliding)) in black_box(&rs).iter().zip(rooms) {
                let limits = system.limits_without_search(*r).expect("in the domain");
                (*continuous, *sliding) = (limits.continuous, limits.sliding);
            }
            black_box((&continuous, &sliding));
        }
        least[0] = least[0].min(clock.elapsed().as_secs_f64());
        let clock = Instant::now();
        for _ in 0..CALLS {
            system
                .limits_without_search_into(black_box(&rs), &mut continuous, &mut sliding)
                .expect("in the domain");
            black_box((&continuous, &sliding));
        }
        least[1] = least[1].min(clock.elapsed().as_secs_f64());
    }
    least.map(|seconds| seconds * 1e9 / (f64::from(CALLS) * POINTS as f64))
}

fn row([single, slice]: [f64; 2]) -> String {
    format!("{single:.1} | {slice:.1} | {:.2}", single / slice)
}
