//! Checks the energy balance: the work of the load equals the energy that contacts, dashpots and damping dissipate.

use super::{FRAME, system};
use crate::study::joints::Series;
use frictiongen_model::scene::Node;

/// Returns points and weights of Gaussian integration with 20 points on [0, 1]. Newton's method finds the roots of
/// Legendre's polynomial.
fn gauss() -> Vec<(f64, f64)> {
    let count = 20;
    let nodes = (0..count).map(|index| {
        let mut x = (std::f64::consts::PI * (index as f64 + 0.75) / (count as f64 + 0.5)).cos();
        let mut slope = 1.0;
        for _ in 0..50 {
            let (mut before, mut value) = (1.0, x);
            for order in 1..count {
                let order = order as f64;
                let next = ((2.0 * order + 1.0) * x * value - order * before) / (order + 1.0);
                (before, value) = (value, next);
            }
            slope = count as f64 * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    });
    nodes.collect()
}

/// Checks the energy balance of various scenes: with a moving base, a force, dashpots, and rigid and elastic contacts.
#[test]
fn energies_of_contacts_are_the_work_of_the_load_without_damping() {
    let forced = FRAME.replace("excitation: base", "excitation: upper");
    let rayleigh = forced.replace("modal(0.01)", "rayleigh(0.2, 1e-4)");
    let undamped = forced.replace("damping: modal(0.01),", "");
    let mut seen = 0;
    for text in [FRAME.to_owned(), forced, rayleigh, undamped] {
        let system = system(&text);
        let joined = system.joined().expect("answers");
        for (r, beta) in [(0.6, 0.3), (1.4, 0.2)] {
            let at = joined.at(r).expect("r");
            let orbit = at.orbit(beta).expect("a steady state");
            let chain = at.chain(beta).expect("a chain");
            let masses = chain.masses.len();
            let (mut input, mut lost) = (0.0, 0.0);
            let mut motion = orbit.motion().expect("a motion");
            let length = orbit.period() as f64 * std::f64::consts::TAU / at.omega();
            let model = motion.model().clone();
            let gauss = gauss();
            let watch = &mut |series: &Series, end: f64, _: &crate::study::joints::State| {
                for (place, weight) in &gauss {
                    let fraction = place * end;
                    let share = weight * end * series.length;
                    let (x, v) = series.motion(&model, fraction);
                    let (y, w) = series.base(fraction);
                    let of = |node: Node, values: &[f64], base: f64| match node {
                        Node::Mass(mass) => values[mass],
                        Node::Base => base,
                        Node::Wall => 0.0,
                    };
                    let time = series.start + fraction * series.length;
                    input += share * model.load_power(time, &v);
                    // The base does work by the forces of its springs, dashpots and contacts.
                    for (from, to, k) in &chain.springs {
                        if [*from, *to].contains(&Node::Base) {
                            let pull = k * (of(*from, &x, y) - of(*to, &x, y)).abs();
                            let sign = if *from == Node::Base {
                                of(*from, &x, y) - of(*to, &x, y)
                            } else {
                                of(*to, &x, y) - of(*from, &x, y)
                            };
                            input += share * pull * sign.signum() * w;
                        }
                    }
                    for (index, contact) in chain.contacts.iter().enumerate() {
                        if [contact.ends.0, contact.ends.1].contains(&Node::Base) {
                            input -= share * series.force(index, fraction) * w;
                        }
                    }
                    for (from, to, c) in &chain.dashpots {
                        lost += share * c * (of(*from, &v, w) - of(*to, &v, w)).powi(2);
                    }
                    for (row, speed) in chain.damping.iter().zip(&v) {
                        let force: f64 = row.iter().zip(&v).map(|(c, v)| c * v).sum();
                        lost += share * speed * force;
                    }
                }
            };
            for cycle in 0..orbit.period() {
                let until = (cycle + 1) as f64 * length / orbit.period() as f64;
                motion.run(until, watch).expect("a motion");
            }
            let taken: f64 = orbit.contacts().map(|contact| contact.energy()).sum();
            let unit = at.units().energy();
            let (input, lost) = (input / unit, lost / unit);
            let size = input.abs().max(lost);
            assert!(taken > 1e-3 * size, "{taken} {size}");
            let miss = (input - lost - taken).abs() / size;
            assert!(
                miss < 1e-10,
                "r {r}: {input} - {lost} is not {taken}: {miss:.1e}"
            );
            assert_eq!(masses, 2);
            seen += 1;
        }
    }
    assert_eq!(seen, 8);
}
