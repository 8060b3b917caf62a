//! Chooses the displacements of the inputs at which the code re-evaluates the derivatives.

use super::linear::{BETA, Linear};

/// Sequence of displacements at which the code re-evaluates the derivatives.
pub(super) struct Turning {
    /// Equations at the last displacement.
    pub linear: Linear,
    /// The last displacement of each input, in rounding units.
    to: Vec<f64>,
    /// The last displacement at which the contact moved.
    moving: Option<Vec<f64>>,
    /// Number of rounding units by which β is reduced, so that the contact moves.
    back: f64,
}

impl Turning {
    pub fn of(linear: Linear) -> Self {
        Self {
            to: vec![0.0; linear.a.first().map_or(0, Vec::len)],
            linear,
            moving: None,
            back: 0.5,
        }
    }

    pub fn next(&mut self, bar: f64) -> Option<&[f64]> {
        if let (true, Some(moving)) = (self.linear.stands, &self.moving) {
            // For β > |V|/|U| the contact does not move for any displacement of the other inputs. The next displacement
            // is halfway to the last displacement at which the contact moved.
            for (to, moving) in self.to.iter_mut().zip(moving) {
                *to = 0.5 * (*to + moving);
            }
        } else {
            let step = self.linear.step(&self.to, bar)?;
            if self.linear.stands {
                // The step leads to inputs whose exact limits equal the returned limits. At these inputs the contact
                // may not move. A larger and larger reduction of β makes it move.
                self.back = (self.back + self.back).min(bar);
                self.to[BETA] -= self.back;
            } else {
                self.moving = Some(self.to.clone());
            }
            for (to, step) in self.to.iter_mut().zip(step) {
                *to = (*to + step).clamp(-bar, bar);
            }
        }
        Some(&self.to)
    }
}
