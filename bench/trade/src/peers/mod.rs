//! Other programs that compute the same quantities, for comparison.

pub mod balance;
#[cfg(with_c)]
pub mod by_hand;
#[cfg(with_c)]
pub mod stepper;
pub mod textbook;

use crate::scenes::Label;
use frictiongen::System;

/// Modal data of a scene, in the form that the compared programs read.
#[derive(Clone, Debug)]
pub struct Modal {
    /// Natural frequency ratios √λ of the modes.
    pub root: Vec<f64>,
    /// Residues of the modes, from the load to the relative motion in the contact.
    pub load: Vec<f64>,
    /// Residues of the modes, from friction to the relative motion in the contact.
    pub friction: Vec<f64>,
    /// Residues of the modes, from the load to the observed mass.
    pub far_load: Vec<f64>,
    /// Residues of the modes, from friction to the observed mass.
    pub far_friction: Vec<f64>,
    /// Squares (φᵀw)² of the mode shapes φ in the direction w of the contact.
    pub share: Vec<f64>,
    /// Coefficient of the base's motion in the relative motion of the contact.
    pub base: f64,
    /// Inverse wᵀΓ⁻¹w of the effective mass of the contact, with its direction w.
    pub inverse_mass: f64,
    /// Damping ratio of every mode.
    pub zeta: f64,
}

/// Returns the load vector of a scene, the direction vector w of its contact, and the coefficient of the base's
/// motion in the contact.
pub fn vectors(label: &Label) -> (Vec<f64>, Vec<f64>, f64) {
    let n = label.masses;
    let unit = |i: usize| -> Vec<f64> { (0..n).map(|k| f64::from(u8::from(k == i))).collect() };
    let contact = &label.name[..4];
    match contact {
        "Wall" => (unit(0), unit(n - 1), 0.0),
        "Base" => (unit(0), unit(0), 1.0),
        _ => {
            let mut direction = unit(1);
            direction[0] = -1.0;
            (unit(n - 1), direction, 0.0)
        }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Modal {
    /// Computes the modal data of a scene.
    pub fn of(label: &Label, system: &System) -> Self {
        let (load, contact, base) = vectors(label);
        let root = system.resonances().to_vec();
        let shapes = system.mode_shapes();
        let by_mode = |f: &dyn Fn(f64, &[f64]) -> f64| -> Vec<f64> {
            root.iter()
                .zip(&shapes)
                .map(|(w, shape)| f(w * w, shape))
                .collect()
        };
        let far = |shape: &[f64]| shape[label.watched];
        Self {
            load: by_mode(&|l, s| dot(s, &contact) * dot(s, &load) / l),
            friction: by_mode(&|l, s| dot(s, &contact).powi(2) / l),
            far_load: by_mode(&|l, s| far(s) * dot(s, &load) / l),
            far_friction: by_mode(&|l, s| far(s) * dot(s, &contact) / l),
            share: by_mode(&|_, s| dot(s, &contact).powi(2)),
            base,
            inverse_mass: dot(&contact, &contact),
            zeta: label.zeta,
            root,
        }
    }
}
