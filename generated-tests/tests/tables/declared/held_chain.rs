//! Solves the equations of motion of a chain with its contact stuck in double-double. The equations follow from
//! masses and springs. They use the modes only for the damping.

use frictiongen::System;
use frictiongen::study::scene::{Excitation, Node, Scene};
use frictiongen_kernel::Complex;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;

/// Matrices Γ, K and C, and vectors p and w.
pub struct HeldChain {
    masses: Vec<Dd>,
    stiffness: Vec<Vec<Dd>>,
    damping: Vec<Vec<Dd>>,
    load: Vec<Dd>,
    contact: Vec<Dd>,
    /// Coefficient of the base motion in the contact's relative motion.
    carried: Dd,
}

impl HeldChain {
    pub fn of(system: &System<f64>) -> Self {
        let scene: &Scene = system.scene();
        let count = scene.masses.len();
        let zero = Dd::ZERO;
        let (first, unit) = (scene.masses[0].value, scene.springs[0].stiffness);
        let masses: Vec<Dd> = scene
            .masses
            .iter()
            .map(|mass| Dd::from(mass.value) / Dd::from(first))
            .collect();
        let mut stiffness = vec![vec![zero; count]; count];
        let mut load = vec![zero; count];
        for spring in &scene.springs {
            let k = Dd::from(spring.stiffness) / Dd::from(unit);
            let ends = [spring.from, spring.to];
            for (own, other) in [(ends[0], ends[1]), (ends[1], ends[0])] {
                let Node::Mass(own) = own else { continue };
                stiffness[own][own] = stiffness[own][own] + k;
                match other {
                    Node::Mass(other) => stiffness[own][other] = stiffness[own][other] - k,
                    Node::Base if scene.excitation == Excitation::Base => load[own] = load[own] + k,
                    _ => {}
                }
            }
        }
        if let Excitation::Force(mass) = scene.excitation {
            load[mass] = Dd::ONE;
        }
        let mut contact = vec![zero; count];
        let mut carried = zero;
        match (scene.contact.from, scene.contact.to) {
            (Node::Mass(a), Node::Mass(b)) => {
                contact[a.min(b)] = -Dd::ONE;
                contact[a.max(b)] = Dd::ONE;
            }
            (Node::Mass(own), other) | (other, Node::Mass(own)) => {
                contact[own] = Dd::ONE;
                if other == Node::Base && scene.excitation == Excitation::Base {
                    carried = Dd::ONE;
                }
            }
            _ => panic!("a contact without a mass"),
        }
        // The damping matrix is C = Σ 2ζσ Γφ(Γφ)ᵀ.
        let modal = system.modal();
        let mut damping = vec![vec![zero; count]; count];
        for (mode, shape) in modal.shapes.iter().enumerate() {
            let rate = Dd::from(2.0) * modal.damping_ratios[mode] * modal.resonances[mode];
            for row in 0..count {
                for column in 0..count {
                    let both = masses[row] * shape[row] * masses[column] * shape[column];
                    damping[row][column] = damping[row][column] + rate * both;
                }
            }
        }
        Self {
            masses,
            stiffness,
            damping,
            load,
            contact,
            carried,
        }
    }

    /// Returns the complex amplitudes of all masses at r, then the complex amplitude of the contact force.
    pub fn responses(&self, r: f64) -> Vec<Complex<Dd>> {
        let r = Dd::from(r);
        let count = self.masses.len();
        let real = complex::real::<Dd>;
        // `rows` is the matrix [K − r²Γ + irC, w; wᵀ, 0], with its right-hand side as the last column.
        let mut rows: Vec<Vec<Complex<Dd>>> = Vec::new();
        for row in 0..count {
            let mut own: Vec<Complex<Dd>> = (0..count)
                .map(|column| {
                    let k = self.stiffness[row][column];
                    Complex::new(k, r * self.damping[row][column])
                })
                .collect();
            own[row].re = own[row].re - r * r * self.masses[row];
            own.push(real(self.contact[row]));
            own.push(real(self.load[row]));
            rows.push(own);
        }
        let mut border: Vec<Complex<Dd>> = self.contact.iter().map(|w| real(*w)).collect();
        border.push(real(Dd::ZERO));
        border.push(real(self.carried));
        rows.push(border);
        solved(rows)
    }
}

/// Solves a system of linear equations by Gaussian elimination with pivoting. The last column is the right-hand side.
fn solved(mut rows: Vec<Vec<Complex<Dd>>>) -> Vec<Complex<Dd>> {
    let count = rows.len();
    let size = |a: &Complex<Dd>| a.re.to_f64().hypot(a.im.to_f64());
    for column in 0..count {
        let pivot = (column..count)
            .max_by(|a, b| size(&rows[*a][column]).total_cmp(&size(&rows[*b][column])))
            .expect("a row");
        rows.swap(column, pivot);
        let inverse = complex::reciprocal(rows[column][column], true);
        let pivot = rows[column].clone();
        for (place, row) in rows.iter_mut().enumerate() {
            if place == column {
                continue;
            }
            let factor = complex::mul(row[column], inverse, true);
            for at in column..=count {
                let less = complex::mul(factor, pivot[at], true);
                row[at] = Complex::new(row[at].re - less.re, row[at].im - less.im);
            }
        }
    }
    let own = rows.iter().enumerate();
    own.map(|(place, row)| complex::mul(row[count], complex::reciprocal(row[place], true), true))
        .collect()
}
