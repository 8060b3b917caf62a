//! Transformation between the modes of the chain and the modes of the chain with its contact stuck (stuck chain).

use super::law::ContactChain;
use crate::motion::dynamics::{Dynamics, HeldMode, lift};
use crate::number::complex::Complex;
use crate::number::scalar::Float;

impl<S: Float, K: ContactChain<S>> Dynamics<'_, S, K> {
    /// Computes the displacement y and the scaled velocity u of the stuck chain's modes from the same numbers of the
    /// chain's modes. `z` is the displacement of the contact, and `rate` its derivative with respect to the time
    /// t√(k₁/m₁). The function first subtracts the static displacements that `z` causes from y, and the velocities that
    /// `rate` causes from u.
    pub(crate) fn project<'s>(
        &self,
        receptance: S,
        states: impl Iterator<Item = [S; 2]> + Clone,
        (z, rate): (S, S),
        stuck_modes: impl Iterator<Item = (&'s mut S, &'s mut S)>,
    ) {
        let two = S::constant(2.0);
        for ((to_y, to_u), (mode, participations)) in stuck_modes.zip(self.held_modes()) {
            let (mut first, mut second) = (S::constant(0.0), S::constant(0.0));
            let driven = self.driven().iter().zip(states.clone());
            for ((driven, [y, u]), [g, h]) in driven.zip(participations) {
                let sigma = driven.resonance;
                let lift = lift(driven, receptance);
                let y = y - lift * z;
                let v = sigma * u - lift * rate + two * driven.zeta * sigma * y;
                first = first + *g * v - mode.frequency * *h * y;
                second = second + *h * v + mode.frequency * (*g - two * mode.zeta * *h) * y;
            }
            (*to_y, *to_u) = mode.state(first, second);
        }
    }

    /// Computes the excitation of a mode of the stuck chain, multiplied by r. The first result is the complex amplitude
    /// of the term that the excitation adds to the mode's velocity. The second result is the complex amplitude of the
    /// force on the mode. `base` is the coefficient s of the base motion in the relative displacement z̄: 1 if the
    /// contact rubs on the moving base, otherwise 0.
    pub(crate) fn stuck_drive(
        &self,
        (mode, participations): (&HeldMode<S>, &[[S; 2]]),
        (base, r): (S, S),
        receptance: S,
    ) -> [Complex<S>; 2] {
        let (zero, two) = (S::constant(0.0), S::constant(2.0));
        // The stuck contact moves with the base. The inertia and damping of this motion reduce the load on each mode.
        let mut sums = [Complex::new(zero, zero); 2];
        let modes = self.driven().iter().zip(participations).enumerate();
        for (index, (driven, participation)) in modes {
            let load = self.load(index, r);
            let lift = base * lift(driven, receptance);
            let re = load.re + lift * r * r;
            let im = load.im - lift * two * driven.zeta * driven.resonance * r;
            for (sum, participation) in sums.iter_mut().zip(participation) {
                *sum = Complex::new(sum.re + *participation * re, sum.im + *participation * im);
            }
        }
        let [first, second] = sums;
        let (re_y, re_u) = mode.state(first.re, second.re);
        let (im_y, im_u) = mode.state(first.im, second.im);
        [Complex::new(re_y, im_y), Complex::new(re_u, im_u)]
    }

    /// Computes the states of the chain's modes from those of the chain with its contact stuck. A state is the
    /// displacement y and the scaled velocity u of a mode. `lifted` contains the displacement of the contact and its
    /// derivative with respect to the time t√(k₁/m₁).
    pub(crate) fn release<'s>(
        &self,
        receptance: S,
        stuck_modes: impl Iterator<Item = [S; 2]> + Clone,
        lifted: (S, S),
        states: impl Iterator<Item = (&'s mut S, &'s mut S)>,
    ) {
        for (index, (y, u)) in (0..self.in_contact()).zip(states) {
            [*y, *u] = self.released(receptance, stuck_modes.clone(), lifted, index);
        }
    }

    /// Computes the state of one mode that the contact drives. [`release`](Self::release) calls this function for each
    /// mode that the contact drives.
    pub(crate) fn released(
        &self,
        receptance: S,
        stuck_modes: impl Iterator<Item = [S; 2]>,
        (z, rate): (S, S),
        index: usize,
    ) -> [S; 2] {
        let two = S::constant(2.0);
        let Some(mode) = self.modes.get(index) else {
            return [S::constant(0.0); 2];
        };
        let lift = lift(mode, receptance);
        let (mut sum_y, mut sum_u) = (lift * z, lift * rate);
        let participations = self.participations.iter().skip(index);
        let participations = participations.step_by(self.in_contact().max(1));
        for (([y, u], of), [g, h]) in stuck_modes.zip(self.held).zip(participations) {
            sum_y = sum_y + *g * y + *h * u;
            let slope = (*g - two * of.zeta * *h) * u - *h * y;
            sum_u = sum_u + of.frequency * slope;
        }
        [sum_y, sum_u / mode.resonance]
    }
}

impl<S: Float, K: ContactChain<S>> Dynamics<'_, S, K> {
    /// Returns the largest relative change of a state that rounding causes if the contact sticks and is immediately
    /// released. In the tested states two modes move, but the contact does not.
    ///
    /// If the modes of the chain with its contact stuck are well separated, the change is of the order of rounding. If
    /// many modes are at or beyond critical damping, their frequencies are close together. The contributions of the
    /// modes then nearly cancel, and the change is larger.
    ///
    /// `states` has room for the modes that the contact drives, and `stuck_modes` for the modes of the chain with its
    /// contact stuck.
    pub fn held_loss(&self, states: &mut [[S; 2]], stuck_modes: &mut [[S; 2]]) -> S {
        let zero = S::constant(0.0);
        let (receptance, still) = (self.receptance(), (zero, zero));
        let driven = self.driven();
        // Each tested state combines two modes: the mode that the contact drives most, and one other mode. In this
        // combination the contact does not move.
        let most = driven
            .iter()
            .enumerate()
            .fold((0, zero), |(at, most), (index, mode)| {
                let size = mode.contact.abs();
                if most < size {
                    (index, size)
                } else {
                    (at, most)
                }
            });
        let (balance, weight) = most;
        let mut worst = zero;
        for (index, mode) in driven
            .iter()
            .enumerate()
            .filter(|(index, _)| *index != balance)
        {
            for velocity in [false, true] {
                let rate = |of: usize| {
                    let resonance = driven.get(of).map_or(zero, |mode| mode.resonance);
                    if velocity {
                        mode.resonance / resonance
                    } else {
                        S::constant(1.0)
                    }
                };
                let state = |of: usize| {
                    let size = if of == index {
                        weight
                    } else if of == balance {
                        -(mode.contact * rate(of))
                    } else {
                        zero
                    };
                    if velocity { [zero, size] } else { [size, zero] }
                };
                let signed = driven.get(balance).map_or(zero, |mode| mode.contact);
                let sign = S::constant(1.0).copysign(signed);
                let start = |of: usize| {
                    state(of).map(|part| if of == balance { part * sign } else { part })
                };
                self.project(
                    receptance,
                    (0..driven.len()).map(start),
                    still,
                    stuck_modes.iter_mut().map(|[y, u]| (y, u)),
                );
                let parts = stuck_modes.iter().copied();
                let back = states.iter_mut().map(|[y, u]| (y, u));
                self.release(receptance, parts, still, back);
                for (of, state) in states.iter().enumerate() {
                    let [y, u] = start(of);
                    for change in [state[0] - y, state[1] - u] {
                        let change = change.abs() / weight;
                        // NaN counts as the largest change, and no later change replaces it.
                        if worst.is_finite() && !(change <= worst) {
                            worst = change;
                        }
                    }
                }
            }
        }
        worst
    }
}
