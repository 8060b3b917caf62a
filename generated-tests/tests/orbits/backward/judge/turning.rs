//! Displacements at which the derivatives are evaluated again.

use super::linear::{BETA, Linear};

/// Sequence of displacements at which the derivatives are evaluated again.
pub(super) struct Turning {
    /// Equations at the last displacement.
    pub linear: Linear,
    /// The last displacement, in roundings.
    to: Vec<f64>,
    /// The last displacement at which the contact still moved.
    moving: Option<Vec<f64>>,
    /// Number of roundings of β by which the contact is released.
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
            // Beyond |V|/|U| the contact does not move for any input. The next displacement is halfway to the last one
            // at which it moved.
            for (to, moving) in self.to.iter_mut().zip(moving) {
                *to = 0.5 * (*to + moving);
            }
        } else {
            let step = self.linear.step(&self.to, bar)?;
            if self.linear.stands {
                // The step leads to where the limits equal the returned ones. Ever more roundings of β then lead back
                // to where the contact moves.
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
