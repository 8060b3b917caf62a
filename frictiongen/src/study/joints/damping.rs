//! The damping matrix of a chain from damping ratios, or from Rayleigh's two factors.

use super::{Chain, JointError};
use frictiongen_kernel::joints::{add, at};
use nalgebra::{DMatrix, SymmetricEigen};

/// Squared natural frequencies below this share of the largest belong to motions without deformation.
const RIGID: f64 = 1e-13;

impl Chain {
    /// Gives each mode of the chain without joints its damping ratio, in the order of natural frequencies. A motion
    /// without deformation has its entry too, without effect.
    ///
    /// # Errors
    ///
    /// Those of [`Chain::model`], and [`JointError::Number`] if there is not one ratio for each mode.
    pub fn damp_modes(&mut self, ratios: &[f64]) -> Result<(), JointError> {
        let stiffness = self.stiffness()?;
        let count = self.masses.len();
        if ratios.len() != count || ratios.iter().any(|ratio| !(*ratio >= 0.0)) {
            return Err(JointError::Number("a damping ratio"));
        }
        let roots: Vec<f64> = self.masses.iter().map(|mass| mass.sqrt()).collect();
        let entry = |i: usize, j: usize| {
            let entry = stiffness.get(i).map_or(0.0, |row| at(row, j));
            entry / (at(&roots, i) * at(&roots, j))
        };
        let modes = SymmetricEigen::new(DMatrix::from_fn(count, count, entry));
        let mut order: Vec<usize> = (0..count).collect();
        let squared = |mode: &usize| modes.eigenvalues.get(*mode).copied().unwrap_or(0.0);
        order.sort_by(|a, b| squared(a).total_cmp(&squared(b)));
        let most = order.last().map_or(0.0, squared);
        let mut damping = vec![vec![0.0; count]; count];
        for (mode, ratio) in order.iter().zip(ratios) {
            let squared = squared(mode);
            if squared <= RIGID * most {
                continue;
            }
            let shape = modes.eigenvectors.column(*mode);
            let shape: Vec<f64> = shape.iter().zip(&roots).map(|(u, root)| u * root).collect();
            for (row, left) in damping.iter_mut().zip(&shape) {
                for (column, right) in shape.iter().enumerate() {
                    add(row, column, 2.0 * ratio * squared.sqrt() * left * right);
                }
            }
        }
        self.damping = damping;
        Ok(())
    }

    /// Sets the damping matrix to aM + bK.
    ///
    /// # Errors
    ///
    /// Those of [`Chain::model`].
    pub fn damp_by_rayleigh(&mut self, mass: f64, stiffness: f64) -> Result<(), JointError> {
        let mut damping = self.stiffness()?;
        for (index, (row, own)) in damping.iter_mut().zip(&self.masses).enumerate() {
            for entry in row.iter_mut() {
                *entry *= stiffness;
            }
            add(row, index, mass * own);
        }
        self.damping = damping;
        Ok(())
    }

    /// Returns the stiffness matrix of the springs, by rows.
    fn stiffness(&self) -> Result<Vec<Vec<f64>>, JointError> {
        let springs = Chain {
            masses: self.masses.clone(),
            springs: self.springs.clone(),
            ..Chain::default()
        };
        let model = springs.model()?;
        let nodes = self.masses.len() + 2;
        let rest = vec![0.0; nodes];
        let columns = (0..self.masses.len()).map(|column| {
            let mut unit = rest.clone();
            add(&mut unit, column, -1.0);
            let mut forces = model.forces(&unit, &rest, |_| 0.0, None);
            forces.truncate(self.masses.len());
            forces
        });
        // The matrix is symmetric: its columns are its rows.
        Ok(columns.collect())
    }
}
