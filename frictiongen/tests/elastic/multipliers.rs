//! Floquet multipliers against differences of motions that come closer to the steady state.

use frictiongen::System;
use std::f64::consts::TAU;

const BLOCK: &str = "struct Block { masses: { block: 3.25 }, springs: { base - block: 2730 },
    contact: block - wall, stiffness: 16000, excitation: block, damping: modal(0.0256), provide: [orbit, simulation] }";

/// Two deviations from the steady state, one cycle later, give the matrix by which a cycle changes deviations of
/// displacement and velocity.  After a slip the force of the spring follows from displacement and velocity, so that one
/// of the three multipliers is 0. The matrix has the remaining two multipliers.
#[test]
fn multipliers_are_those_of_differences() {
    let system: System = BLOCK.parse().expect("a scene");
    for (r, beta) in [(0.8, 0.53), (0.6, 0.3), (1.4, 0.2)] {
        let at = system.at(r).expect("in the domain");
        let orbit = at.orbit(beta).expect("a steady state");
        assert!(
            orbit.stops() == 2 && orbit.period() == 1,
            "{}",
            orbit.stops()
        );
        let motion = orbit.mass("block").expect("a mass");
        let section = -orbit.origin();
        let fixed = [motion.displacement(section), motion.velocity(section)];
        // Pairs of deviations before and after a cycle, from several starts, as long as they are small but not rounding.
        let mut pairs = Vec::new();
        for start in [[0.7, 0.2], [-0.4, 0.9], [0.1, -1.0], [0.9, 0.9]] {
            let state = (&start[..1], &start[1..]);
            let mut run = system.simulation_from(r, beta, state).expect("a run");
            let mut before: Option<[f64; 2]> = None;
            for _ in 0..400 {
                let mut left = TAU;
                while left > 0.0 {
                    left -= run.advance(left).expect("a segment").length;
                }
                let moment = run.mass("block").expect("a mass");
                let now = [
                    moment.displacement() - fixed[0],
                    moment.velocity() - fixed[1],
                ];
                let size = |pair: &[f64; 2]| pair[0].hypot(pair[1]);
                if let Some(before) =
                    before.filter(|before| size(before) < 1e-5 && 1e-8 < size(before))
                {
                    let scale = size(&before);
                    pairs.push((before.map(|one| one / scale), now.map(|one| one / scale)));
                }
                before = Some(now);
            }
        }
        assert!(4 <= pairs.len(), "{}", pairs.len());
        // Least squares for the two rows of the matrix.
        type Pair = ([f64; 2], [f64; 2]);
        let sum = |f: &dyn Fn(&Pair) -> f64| pairs.iter().map(f).sum::<f64>();
        let (xx, xy, yy) = (
            sum(&|(d, _)| d[0] * d[0]),
            sum(&|(d, _)| d[0] * d[1]),
            sum(&|(d, _)| d[1] * d[1]),
        );
        let determinant = xx * yy - xy * xy;
        assert!(
            1e-3 < determinant,
            "the deviations have one direction: {determinant}"
        );
        let row = |i: usize| {
            let (x, y) = (sum(&|(d, e)| d[0] * e[i]), sum(&|(d, e)| d[1] * e[i]));
            [
                (yy * x - xy * y) / determinant,
                (xx * y - xy * x) / determinant,
            ]
        };
        let [a, b] = [row(0), row(1)];
        let (trace, product) = (a[0] + b[1], a[0] * b[1] - a[1] * b[0]);
        let mut own = orbit.multipliers().to_vec();
        own.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
        let [first, second, third] = own[..] else {
            panic!("{own:?}")
        };
        println!(
            "r = {r}: trace {trace} for {}, product {product} for {}",
            first + second,
            first * second
        );
        // The deviations are at most 1e-5, and the error of the differences is of their size.
        assert!((trace - (first + second).re).abs() < 1e-4);
        assert!((product - (first * second).re).abs() < 1e-4);
        assert!(third.norm() < 1e-12);
    }
}
