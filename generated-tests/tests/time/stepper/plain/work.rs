//! Computes the work over a piece of motion without events, by quadrature of the powers.

use super::zeros::{slope, value};
use super::{Plain, Series};

impl Plain {
    /// Adds the work of a piece of length `at`, by Gauss's rule with eight points.
    pub(super) fn collect(&mut self, series: &Series, base: &[f64], loads: &[Vec<f64>], at: f64) {
        const POINTS: [[f64; 2]; 4] = [
            [0.183_434_642_495_649_8, 0.362_683_783_378_362],
            [0.525_532_409_916_329, 0.313_706_645_877_887_3],
            [0.796_666_477_413_626_7, 0.222_381_034_453_374_5],
            [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
        ];
        if at <= 0.0 || !self.metered {
            return;
        }
        for [place, weight] in POINTS {
            for side in [-1.0, 1.0] {
                let t = 0.5 * at * (1.0 + side * place);
                let (_, v) = Self::at(series, t);
                let weight = 0.5 * at * weight;
                let y = value(base, t);
                let rate = value(&slope(base), t);
                let force = value(&series.force, t);
                let relative = self.chain.w.dot(&v) - self.chain.s * rate;
                for (i, load) in loads.iter().enumerate() {
                    let load = value(load, t) + self.chain.to_base[i] * y;
                    self.work.load += weight * load * v[i];
                }
                self.work.friction += weight * force * relative;
                let moved = &v - &self.chain.carried * rate;
                self.work.damping += weight * (&self.chain.c * &moved).dot(&moved);
                self.work.carried += weight * self.chain.s * force * rate;
            }
        }
    }
}
