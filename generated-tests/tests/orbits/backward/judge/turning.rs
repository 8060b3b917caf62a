//! Displacements at which the derivatives are taken anew.

use super::linear::{BETA, Linear};

/// Displacements at which the derivatives are taken anew, one after the other.
pub(super) struct Turning {
    /// The equations at the displacement found last.
    pub linear: Linear,
    /// It, in roundings.
    to: Vec<f64>,
    /// The last one before the contact stood still.
    moving: Option<Vec<f64>>,
    /// By how many roundings of β the contact is set free.
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
            // Beyond |V|/|U| the contact stands still whatever moves: halfway to where it did not.
            for (to, moving) in self.to.iter_mut().zip(moving) {
                *to = 0.5 * (*to + moving);
            }
        } else {
            let step = self.linear.step(&self.to, bar)?;
            if self.linear.stands {
                // To where the limits are as they were told, and back by more and more of β.
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
