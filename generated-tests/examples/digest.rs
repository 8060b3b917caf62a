//! Prints a digest of a million results, to show that a change of the code changes none of the results.
//!
//!     cargo run --release -p generated-tests --features tools --example digest [-- --keep FILE | --against FILE]
//!
//! The digest has a row for each scene, implementation and kind of result, with the number of values and a hash of
//! their bits. `--keep` writes the values to a file. `--against` compares the values with those of a file. It prints
//! how many values differ, and the largest relative and absolute difference.

use frictiongen::{
    Complex, ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, Of, OrbitAt, Periodic, Run,
    Simulates, Steady, SteadyState, StuckAt, System,
};
use frictiongen_kernel::Float;
use fuzzing::Random;
use std::collections::BTreeMap;
use std::process::ExitCode;

mod scenes {
    macro_rules! scenes {
        ($(struct $name:ident { $($body:tt)* })*) => {
            $(::frictiongen::friction_system! { pub struct $name { $($body)* } })*
            pub const TEXTS: &[(&str, &str)] = &[$((stringify!($name), stringify!(struct $name { $($body)* }))),*];
        };
    }
    scenes! {
        struct Three {
            masses: { m1: 1.0, m2: 2.0, m3: 0.7 },
            springs: { base - m1: 1.0, m1 - m2: 0.4, m2 - m3: 1.5 },
            contact: m2 - wall,
            excitation: base,
            damping: modal[0.01, 0.02, 0.03],
            stiction: 1.5,
            provide: [limits, motion, stuck, orbit, simulation],
        }
        struct Ten {
            masses: { a: 1, b: 1.1, c: 0.9, d: 1, e: 1.3, f: 0.7, g: 1, h: 1, i: 1.2, j: 0.8 },
            springs: {
                base - a: 1, a - b: 1, b - c: 0.8, c - d: 1, d - e: 1.2, e - f: 1, f - g: 1, g - h: 1.1, h - i: 1,
                i - j: 0.9,
            },
            contact: c - d,
            excitation: a,
            damping: modal(0.02),
            provide: [limits, motion, stuck, orbit, simulation],
        }
        struct Rubbed {
            masses: { lower: 1.0, upper: 0.9 },
            springs: { base - lower: 1.0, lower - upper: 1.1 },
            contact: lower - base,
            excitation: base,
            damping: modal[1.4, 0.5],
            scalar: f32,
            provide: [limits, motion, stuck, orbit, simulation],
        }
        struct Plain {
            masses: { block: 1.0 },
            springs: { base - block: 1.0 },
            contact: block - wall,
            excitation: block,
            scalar: f32,
            provide: [limits, motion, stuck, orbit, simulation],
        }
        struct Absorber {
            masses: { first: 1.0, second: 1.0, third: 0.5 },
            springs: { base - first: 1.0, first - second: 1.0, second - third: 0.3 },
            contact: second - wall,
            excitation: first,
            provide: [limits, motion, stuck, orbit, simulation],
        }
    }
}

/// The values of each row of the digest, by the name of the row.
type Rows = BTreeMap<String, Vec<f64>>;

/// Draws a frequency ratio from 0.02 to 20.
fn ratio(points: &mut Random) -> f64 {
    0.02 * 1000_f64.powf(points.unit())
}

struct Digest<'a> {
    rows: &'a mut Rows,
    of: String,
}

impl Digest<'_> {
    fn row(&mut self, kind: &str) -> &mut Vec<f64> {
        self.rows.entry(format!("{} {kind}", self.of)).or_default()
    }
}

fn add<S: Float>(row: &mut Vec<f64>, values: impl IntoIterator<Item = S>) {
    row.extend(values.into_iter().map(Float::to_f64));
}

fn parts<S: Float>(value: Complex<S>) -> [S; 2] {
    [value.re, value.im]
}

fn limits<S: Float, F: FrictionSystem<Scalar = S>>(digest: &mut Digest<'_>, system: &F) {
    let mut points = Random(1);
    for _ in 0..2500 {
        let at = system
            .at(S::constant(ratio(&mut points)))
            .expect("in the domain");
        add(
            digest.row("limits"),
            [
                at.continuous_limit(),
                at.continuous_limit_without_search(),
                at.continuous_limit_per_mode(),
                at.sliding_limit(),
                at.margin(S::constant(points.unit()))
                    .expect("in the domain"),
            ],
        );
    }
}

fn motions<S, F>(digest: &mut Digest<'_>, system: &F)
where
    S: Float,
    F: FrictionSystem<Scalar = S>,
    for<'a> F::At<'a>: MotionAt<Scalar = S>,
{
    let mut points = Random(2);
    for _ in 0..500 {
        let at = system
            .at(S::constant(ratio(&mut points)))
            .expect("in the domain");
        let beta = at.continuous_limit().min(at.sliding_limit()) * S::constant(points.unit());
        let Ok(motion) = at.motion(beta) else {
            digest.row("no motion").push(beta.to_f64());
            continue;
        };
        let tau = S::constant(7.0 * points.unit());
        let ask = |steady: &dyn Steady<Scalar = S>| {
            let ([a, b], [c, d]) = (parts(steady.harmonic(1)), parts(steady.harmonic(3)));
            let largest = steady.largest();
            [
                steady.amplitude(),
                steady.amplitude_monoharmonic(),
                steady.phase(),
                steady.displacement(tau),
                steady.velocity(tau),
                largest.amplitude,
                largest.phase,
                a,
                b,
                c,
                d,
            ]
        };
        for of in std::iter::once(Of::Contact).chain((0..system.masses()).map(Of::Mass)) {
            if let Some(values) = motion.ask(of, ask) {
                add(digest.row("motions"), values);
            }
        }
    }
}

fn stuck<S, F>(digest: &mut Digest<'_>, system: &F)
where
    S: Float,
    F: FrictionSystem<Scalar = S>,
    for<'a> F::At<'a>: StuckAt<Scalar = S>,
{
    let mut points = Random(3);
    for _ in 0..2000 {
        let at = system
            .at(S::constant(ratio(&mut points)))
            .expect("in the domain");
        for mass in 0..system.masses() {
            let value = at.stuck_mass(mass).expect("no resonance").expect("a mass");
            // The sign of a zero has no meaning here, so it is removed.
            add(
                digest.row("stuck"),
                parts(value).map(|part| part + S::constant(0.0)),
            );
        }
    }
}

fn orbits<S, F>(digest: &mut Digest<'_>, system: &F)
where
    S: Float,
    F: FrictionSystem<Scalar = S>,
    for<'a> F::At<'a>: OrbitAt<Scalar = S>,
{
    let mut points = Random(4);
    for _ in 0..400 {
        let r = 0.1 + 2.4 * points.unit();
        let at = system.at(S::constant(r)).expect("in the domain");
        let beta = at.sliding_limit() * S::constant(1.1 * points.unit());
        let Ok(orbit) = at.orbit_or_last_cycles(beta) else {
            digest.row("no orbit").push(beta.to_f64());
            continue;
        };
        let row = digest.row("orbits");
        row.extend([
            orbit.stops() as f64,
            orbit.reversals() as f64,
            f64::from(orbit.period()),
        ]);
        add(row, [orbit.stuck_fraction()]);
        // The order of the eigenvalues has no meaning, so they are sorted.
        let mut multipliers: Vec<_> = orbit.multipliers().iter().copied().map(parts).collect();
        multipliers.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
        add(row, multipliers.into_iter().flatten());
        for of in std::iter::once(Of::Contact).chain((0..system.masses()).map(Of::Mass)) {
            let ask = |motion: &dyn Periodic<Scalar = S>| {
                let [a, b] = parts(motion.harmonic(3));
                let tau = S::constant(4.1);
                [
                    motion.amplitude(),
                    motion.phase(),
                    motion.displacement(tau),
                    motion.velocity(tau),
                    a,
                    b,
                ]
            };
            add(
                digest.row("orbits"),
                orbit.ask(of, ask).into_iter().flatten(),
            );
        }
    }
}

fn runs<S, F>(digest: &mut Digest<'_>, system: &F)
where
    S: Float,
    F: Simulates<Scalar = S>,
{
    let mut points = Random(5);
    for _ in 0..20 {
        let (r, beta) = (0.1 + 2.4 * points.unit(), points.unit());
        let mut run = system
            .simulation(S::constant(r), S::constant(beta))
            .expect("in the domain");
        for _ in 0..100 {
            let segment = run.advance(S::constant(1.7)).expect("in the domain");
            let row = digest.row("runs");
            add(
                row,
                [
                    segment.length,
                    run.phase(),
                    run.relative().0,
                    run.relative().1,
                    run.friction(),
                ],
            );
            for mass in 0..system.masses() {
                let moment = run.moment(mass);
                add(row, [moment.displacement(), moment.velocity()]);
            }
        }
    }
}

fn main() -> ExitCode {
    let mut rows = Rows::new();
    macro_rules! scene {
        ($from:ident::$name:ident, $list:expr, $scalar:ty, $($kind:ident)*) => {
            let text = $list.iter().find(|(name, _)| *name == stringify!($name)).expect("a scene").1;
            let system: System<$scalar> = text.parse().expect("a scene");
            let name = concat!(stringify!($name), " ", stringify!($scalar));
            $($kind(&mut Digest { rows: &mut rows, of: format!("{name} emitted") }, &$from::$name);)*
            $($kind(&mut Digest { rows: &mut rows, of: format!("{name} run time") }, &system);)*
        };
    }
    macro_rules! shown {
        ($($name:ident: $scalar:ty, $($kind:ident)*;)*) => {
            use generated_tests::shown;
            $(scene!(shown::$name, shown::SCENES, $scalar, $($kind)*);)*
        };
    }
    macro_rules! own {
        ($($name:ident: $scalar:ty;)*) => {
            $(scene!(scenes::$name, scenes::TEXTS, $scalar, limits motions stuck orbits runs);)*
        };
    }
    shown! {
        SdofWall: f64, limits motions;
        SdofBase: f64, limits motions;
        SdofDamped: f64, limits motions;
        SdofOverdamped: f64, limits motions;
        PairWall: f64, limits motions;
        PairBase: f64, limits motions;
        PairMasses: f64, limits motions stuck;
        Thesis: f64, limits motions;
        Five: f64, limits motions stuck;
        Tall: f64, limits motions;
        Single: f32, limits motions;
        Braced: f64, limits motions;
        Symmetric: f64, limits motions stuck;
        LimitsOnly: f32, limits;
        OneMotion: f64, limits motions;
        Stopping: f64, limits orbits runs;
    }
    own! {
        Three: f64;
        Ten: f64;
        Rubbed: f32;
        Plain: f32;
        Absorber: f64;
    }
    report(&rows)
}

fn report(rows: &Rows) -> ExitCode {
    let mut total = 0;
    for (name, values) in rows {
        println!("{name:40} {:8} {:016x}", values.len(), hash(values));
        total += values.len();
    }
    let all = rows.values().flatten().copied().collect::<Vec<_>>();
    println!("{:40} {total:8} {:016x}", "all", hash(&all));
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments
        .iter()
        .map(String::as_str)
        .collect::<Vec<_>>()
        .as_slice()
    {
        [] => ExitCode::SUCCESS,
        ["--keep", path] => {
            let bytes: Vec<u8> = all.iter().flat_map(|value| value.to_le_bytes()).collect();
            std::fs::write(path, bytes).expect("a file that can be written");
            ExitCode::SUCCESS
        }
        ["--against", path] => {
            let bytes = std::fs::read(path).expect("values that were kept");
            let kept: Vec<f64> = bytes
                .as_chunks()
                .0
                .iter()
                .map(|bytes| f64::from_le_bytes(*bytes))
                .collect();
            against(rows, &kept)
        }
        _ => {
            eprintln!("usage: digest [--keep FILE | --against FILE]");
            ExitCode::from(2)
        }
    }
}

fn against(rows: &Rows, kept: &[f64]) -> ExitCode {
    let count: usize = rows.values().map(Vec::len).sum();
    if count != kept.len() {
        println!(
            "{count} values now, {} were kept: other questions",
            kept.len()
        );
        return ExitCode::FAILURE;
    }
    let (mut kept, mut differ) = (kept.iter(), 0);
    for (name, values) in rows {
        let pairs: Vec<(f64, f64)> = values.iter().copied().zip(kept.by_ref().copied()).collect();
        let other: Vec<_> = pairs
            .iter()
            .filter(|(a, b)| a.to_bits() != b.to_bits())
            .collect();
        differ += other.len();
        let by = |(a, b): &&(f64, f64)| (a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE);
        let most = other.iter().map(by).fold(0.0, generated_tests::larger);
        let apart = |(a, b): &&(f64, f64)| (a - b).abs();
        let apart = other.iter().map(apart).fold(0.0, generated_tests::larger);
        if !other.is_empty() {
            println!(
                "{name}: {} of {} differ, at most by {most:.1e} of the larger and by {apart:.1e}",
                other.len(),
                pairs.len()
            );
        }
    }
    println!("{differ} of {count} values differ");
    if differ == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

/// Returns the FNV-1a hash of the bits of all values.
fn hash(values: &[f64]) -> u64 {
    values
        .iter()
        .flat_map(|value| value.to_bits().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
}
