//! Times every closed form of every scene of `trade`: `cargo bench -p generated-tests --bench functions`.
//!
//! A sample computes 64 points, so the printed items per second are points per second. A filter follows `--`, for
//! example `-- double::limits`. `scripts/trade` times other methods for the same quantities.

#[macro_use]
#[path = "../../trade/src/chains.rs"]
mod chains;
#[path = "../../trade/src/methods.rs"]
#[allow(dead_code, reason = "the tables' names are not used here")]
mod methods;
#[path = "../../trade/src/scenes.rs"]
#[allow(dead_code, reason = "descriptions are for the run-time system")]
mod scenes;
#[path = "../../trade/src/without_search.rs"]
mod without_search;

use divan::Bencher;
use divan::counter::ItemsCount;
use frictiongen::kernel::Float;
use frictiongen::{FrictionSystem, MotionAt};
use methods::{Fill, Method, Pair, filler};
use scenes::{Label, Orbit, Visitor};

const POINTS: usize = 64;
const GOLDEN: f64 = 0.618_033_988_749_894_9;

fn main() {
    divan::main();
}

fn called(label: &Label) -> String {
    format!("{}, ζ = {}", label.name, label.zeta)
}

/// Finds the scene with the name `wanted`.
struct Finder<'a> {
    wanted: &'a str,
    double: Option<Fill<f64>>,
    single: Option<Fill<f32>>,
    names: Vec<String>,
}

impl<'a> Finder<'a> {
    fn run(wanted: &'a str) -> Self {
        let mut finder = Self {
            wanted,
            double: None,
            single: None,
            names: Vec::new(),
        };
        scenes::visit(&mut finder);
        finder
    }
}

impl Visitor for Finder<'_> {
    fn scene<D, S>(
        &mut self,
        label: Label,
        double: D,
        single: S,
        orbit: Orbit<f64>,
        orbit_single: Orbit<f32>,
    ) where
        D: FrictionSystem<Scalar = f64> + 'static,
        S: FrictionSystem<Scalar = f32> + 'static,
        for<'a> D::At<'a>: MotionAt<Scalar = f64>,
        for<'a> S::At<'a>: MotionAt<Scalar = f32>,
    {
        if called(&label) == self.wanted {
            self.double = Some(filler(double, label.watched, orbit));
            self.single = Some(filler(single, label.watched, orbit_single));
        }
        self.names.push(called(&label));
    }
}

fn names() -> Vec<String> {
    Finder::run("").names
}

fn answers<S: Float + Sync>(bencher: Bencher<'_, '_>, fill: Option<Fill<S>>, method: Method) {
    let fill = fill.expect("a scene of the list");
    let ratio = |i: usize| S::constant(0.2 + 2.3 * (i as f64 * GOLDEN).fract());
    let mut points: Vec<Pair<S>> = (0..POINTS).map(|i| [ratio(i); 2]).collect();
    let mut out = points.clone();
    // β is half of the smaller limit, so that every motion is continuous.
    fill(Method::Limits, &points, &mut out);
    for (point, [continuous, sliding]) in points.iter_mut().zip(&out) {
        point[1] = continuous.min(*sliding) * S::constant(0.5);
    }
    bencher
        .counter(ItemsCount::new(POINTS))
        .bench_local(|| fill(method, divan::black_box(&points), &mut out));
}

macro_rules! functions {
    ($($precision:ident: $($name:ident = $method:ident),*;)*) => {
        $(mod $precision {
            use super::{Bencher, Finder, Method, answers, names};
            $(#[divan::bench(args = names())]
            fn $name(bencher: Bencher<'_, '_>, scene: &str) {
                answers(bencher, Finder::run(scene).$precision, Method::$method);
            })*
        })*
    };
}

functions! {
    double: limits = Limits, limits_without_search = WithoutSearch, limits_per_mode = PerMode,
        amplitude = Amplitude, monoharmonic = Monoharmonic, fundamental = Fundamental;
    single: limits = Limits, limits_without_search = WithoutSearch, limits_per_mode = PerMode,
        amplitude = Amplitude, monoharmonic = Monoharmonic, fundamental = Fundamental;
}
