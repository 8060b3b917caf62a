//! Computes the functions of frequency as plain sums over modes, for comparison.

use frictiongen::study::System;

/// Plain sums over modes, from frequencies and mode shapes only: V, H and U of the contact, and V, H and U of mass k.
pub struct Sums {
    pub v: f64,
    pub h: f64,
    pub u: f64,
    pub own_v: f64,
    pub own_h: f64,
    pub own_u: f64,
}

/// Values φᵀw, φᵀp and φ_k of each mode, from the mode shapes and the numbers of the scene.
pub struct Modes {
    pub resonances: Vec<f64>,
    pub contacts: Vec<f64>,
    pub loads: Vec<f64>,
    pub shapes: Vec<f64>,
    pub of_base: f64,
}

impl Modes {
    pub fn new(system: &System, mass: usize) -> Self {
        let modal = system.modal();
        let plain = |list: &[frictiongen_kernel::number::dd::Dd]| -> Vec<f64> {
            list.iter().map(|value| value.hi).collect()
        };
        Self {
            resonances: plain(&modal.resonances),
            contacts: plain(&modal.contacts),
            loads: plain(&modal.loads),
            shapes: modal.shapes.iter().map(|shape| shape[mass].hi).collect(),
            of_base: if modal.on_moving_base { 1.0 } else { 0.0 },
        }
    }

    pub fn at(&self, r: f64) -> Sums {
        let mut sums = Sums {
            v: -self.of_base,
            h: 0.0,
            u: 0.0,
            own_v: 0.0,
            own_h: 0.0,
            own_u: 0.0,
        };
        for i in 0..self.resonances.len() {
            let (root, w, p, shape) = (
                self.resonances[i],
                self.contacts[i],
                self.loads[i],
                self.shapes[i],
            );
            let lambda = root * root;
            let response = 1.0 / (lambda - r * r);
            let lag = (std::f64::consts::FRAC_PI_2 * root / r).tan() * root / r / lambda;
            sums.v += w * p * response;
            sums.h += w * w * response;
            sums.u += w * w * lag;
            sums.own_v += shape * p * response;
            sums.own_h += shape * w * response;
            sums.own_u += shape * w * lag;
        }
        sums
    }
}
