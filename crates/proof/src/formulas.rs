//! Compares the formulas of [`stage`](crate::stage) and [`force`](crate::force) with the formulas of the kernel, in
//! double-double.

use crate::force;
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, IntervalChain, singular};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::oscillator::decay::{Damped, Decay, Instant};
use frictiongen_kernel::response::At;
use frictiongen_model::interval::Interval;
use frictiongen_model::modal::Modal;
use frictiongen_model::samples::{random, scene};

/// Contact, number of masses and damping ratio ζ of the chains that the test compares. They cover each kind of
/// damping, and undamped modes in a damped chain.
const KINDS: [(&str, usize, f64); 14] = [
    ("Wall", 1, 0.0),
    ("Base", 2, 0.0),
    ("Pair", 5, 0.0),
    ("Wall", 2, 0.02),
    ("Base", 5, 0.3),
    ("Pair", 3, 0.7),
    ("Wall", 2, 1.0),
    ("Base", 2, 1.7),
    ("Wall", 4, -0.02),
    ("Shaken", 2, 0.02),
    ("Shaken", 1, 1.7),
    ("Apart", 3, 0.3),
    ("Carried", 2, 1.0),
    ("Carried", 4, -0.02),
];
/// Largest allowed width of an interval, divided by the largest term of the sum that the interval contains.
const WIDTH: f64 = 1e-11;
/// Number of frequency ratios at which the test compares each chain.
const RATIOS: usize = 300;

/// Number of values that the test has compared, and the relative width of the widest interval.
#[derive(Default)]
struct ComparedFormulas {
    values: usize,
    widest: f64,
}

impl ComparedFormulas {
    /// Checks that an interval overlaps the kernel's value times κ, and that the interval is narrow. κ is the common
    /// factor of all functions of `ChainStage`.
    fn with(&mut self, name: &str, own: Interval, kernel: Dd, kappa: Interval, size: f64) {
        let kernel = Interval::of(kernel) * kappa;
        assert!(
            own.low <= kernel.high && kernel.low <= own.high,
            "{name}: {own:?}, the kernel's {kernel:?}"
        );
        let width = (own.high - own.low) / (own.size() + size * kappa.size());
        self.values += 1;
        self.widest = self.widest.max(width);
        assert!(width < WIDTH, "{name}: {width:e}");
    }
}

/// Compares functions of a chain at r with the kernel's values. They are the contact's sums V, U and G (section 3 of
/// `docs/derivation.md`), the velocity constraint at the start, the break-away term, and F at one instant. F is the sum
/// of the velocity constraint over the modes.
fn compare(name: &str, modal: &Modal, r: f64, t: f64, compared: &mut ComparedFormulas) {
    let chain = IntervalChain::of(modal);
    let stage = ChainStage::<2>::over(&chain, Interval::point(r), &singular(&chain, r));
    let reduced = modal.reduced(|value| value);
    let at = At::new(&reduced, Dd::from(r)).unwrap();
    let sums = at.contact_sums();
    let scale = sums.scale;
    let kappa = stage.kappa.map_or(Interval::ONE, |kappa| kappa.value());
    let modes = reduced.modes.iter().zip(at.modes());
    let driven = modes.filter(|(mode, _)| mode.in_contact);
    let terms: Vec<[Dd; 3]> = driven
        .clone()
        .map(|(mode, at)| {
            let size = at.response.re.abs() + at.response.im.abs();
            [
                mode.residue.abs() * size / scale,
                mode.contact_squared * at.u.abs() / scale,
                mode.contact_squared * (Dd::ONE + (at.g / scale).abs()),
            ]
        })
        .collect();
    let size = |which: usize| 1.0 + terms.iter().map(|term| term[which].to_f64()).sum::<f64>();
    let square = Dd::from(r) * Dd::from(r);
    let v = [sums.v.re, sums.v.im];
    for (own, kernel) in stage.excitation.iter().zip(v) {
        compared.with(name, own.value(), kernel / scale, kappa, size(0));
    }
    compared.with(
        name,
        stage.quadrature.value(),
        sums.u / scale,
        kappa,
        size(1),
    );
    let reversal = sums.reversal / scale;
    let (mass, stiction) = (reduced.chain.inverse_mass, reduced.chain.stiction);
    if reduced.chain.damped {
        compared.with(
            name,
            stage.displacement.value(),
            sums.g / scale,
            kappa,
            size(2) * square.to_f64(),
        );
        let more = size(1) + size(2);
        compared.with(name, stage.start.value(), reversal + mass, kappa, more);
        compared.with(
            name,
            stage.break_away.value(),
            reversal + mass * stiction,
            kappa,
            more,
        );
    }
    let (t, own) = (Dd::from(t), IntervalSeries::<2>::fixed(Interval::point(t)));
    let (sine, cosine) = t.sin_cos_pi();
    let instant = Instant {
        t,
        tau: t * Dd::pi(),
        sine,
        cosine,
        versine: Dd::ONE - cosine,
    };
    let (mut value, mut sizes) = (Dd::ZERO, 0.0);
    for (mode, at) in driven {
        let basis = Damped::of(mode).basis(at.x, &instant);
        let free = mode.contact_squared * (Dd::ONE + at.g / scale);
        let slope = mode.contact_squared * at.u / scale;
        value = value + free * basis.free + slope * basis.forced_slope;
        sizes += (free.abs() + slope.abs()).to_f64();
    }
    let (_, cosine) = own.sine_cosine();
    let force = force::value(&stage, &force::motions(&stage, &own), &cosine);
    compared.with(name, force.value(), value, kappa, sizes);
}

#[test]
fn agree_with_the_kernel() {
    let mut compared = ComparedFormulas::default();
    let mut state = 29;
    for (kind, count, zeta) in KINDS {
        let modal = scene(kind, count, zeta, 1.2);
        for _ in 0..RATIOS {
            let (r, t) = (0.1 + 2.9 * random(&mut state), random(&mut state));
            let name = format!("{kind}{count}, {zeta} at r = {r:?}, t = {t:?}");
            compare(&name, &modal, r, t, &mut compared);
        }
    }
    let ComparedFormulas { values, widest } = compared;
    println!("{values} values, {widest:e} wide");
    assert!(values >= RATIOS * (KINDS.len() * 4 + 6 * 3), "{values}");
}
