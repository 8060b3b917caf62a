//! Advances an oscillator to the end of a sub-interval by its constant table.

use super::dot::{dot, later, sizes};
use super::rows::{HeldStep, ModeStep};
use crate::number::scalar::Float;

impl<S: Float, const D: usize> ModeStep<S, D> {
    /// Returns the state of the mode at the end of a sub-interval, and the work that `load` does on the mode in the
    /// sub-interval. `drive` is the whole load on the mode, including the friction force.
    #[inline]
    pub(super) fn moved(&self, [y, u]: [S; 2], drive: &[S; D], load: &[S; D]) -> ([S; 2], S) {
        let mut moments = [S::constant(0.0); D];
        later(&mut moments, &self.moments, |row| row.times([y, u], drive));
        let mut next = [y, u];
        if let ([rise, ..], [row, ..]) = (&mut moments[..], &self.moments[..]) {
            let [before, after] = row.state;
            let glide = before * u;
            let turned = u + self.turn.times([y + glide, u], drive);
            *rise = dot(glide + after * turned, &row.drive, drive);
            next = [y + *rise, turned];
        }
        let work = dot(S::constant(0.0), load, &moments);
        (next, work / self.per_force)
    }

    /// Returns an upper bound on |u″| in the sub-interval, where u is the scaled velocity of the mode (y′ = Ωu).
    #[inline]
    pub(super) fn bend(&self, [y, u]: [S; 2], drive: &[S; D]) -> S {
        let rate = self.angle * (S::constant(1.0) + self.zeta + self.zeta);
        let (total, change) = sizes(drive);
        rate * rate * (y.abs() + u.abs() + total) + rate * total + change
    }
}

impl<S: Float, const D: usize> HeldStep<S, D> {
    /// Returns the displacement y and the scaled velocity u of the mode at the end of a sub-interval. Also returns the
    /// moments ∫ sʲ y′ ds and ∫ sʲ u′ ds, where s is the time since the start of the sub-interval.
    #[inline]
    pub(super) fn moved(&self, [y, u]: [S; 2], drive: &[[S; D]; 2]) -> ([S; 2], [[S; D]; 2]) {
        let mut moments = [[S::constant(0.0); D]; 2];
        for (moments, rows) in moments.iter_mut().zip([&self.moments, &self.turns]) {
            later(moments, rows, |row| row.times([y, u], drive));
        }
        let (mut next, [rises, turns]) = ([y, u], &mut moments);
        if let ([rise, ..], [turn, ..], [row, ..], [turning, ..]) = (
            &mut rises[..],
            &mut turns[..],
            &self.moments[..],
            &self.turns[..],
        ) {
            let [before, after] = row.state;
            let glide = before * u;
            *turn = turning.times([y + glide, u], drive);
            let turned = u + *turn;
            let [first, second] = &row.drive;
            let [of_y, of_u] = drive;
            *rise = dot(dot(glide + after * turned, first, of_y), second, of_u);
            next = [y + *rise, turned];
        }
        (next, moments)
    }

    /// Returns an upper bound on |y″| in the sub-interval, where y is the displacement of the mode.
    #[inline]
    pub(super) fn bend(&self, [y, u]: [S; 2], [first, second]: &[[S; D]; 2]) -> S {
        let rate = self.angle * (S::constant(1.0) + self.zeta + self.zeta);
        let ((of_y, change), (of_u, _)) = (sizes(first), sizes(second));
        let total = of_y + of_u;
        rate * rate * (y.abs() + u.abs() + total) + rate * total + change
    }
}
