//! Force in a rigid contact within a step, while the contact sticks.

use super::drive::derived;
use super::interval::StepInterval;
use super::law::StepContact;
use crate::contact::sums::Chain;
use crate::number::scalar::Float;

impl<S: Float> StepContact<S> for Chain<S> {
    #[inline]
    fn stuck_force_terms<const D: usize>(interval: &StepInterval<'_, '_, S, D, Self>) -> [S; 4] {
        rigid_terms(interval)
    }
}

/// Returns the force that keeps a rigid contact stuck in a sub-interval, as a polynomial. The result does not contain
/// the contribution of the stuck chain's modes.
#[inline]
pub(super) fn rigid_terms<S: Float, const D: usize, K: StepContact<S>>(
    interval: &StepInterval<'_, '_, S, D, K>,
) -> [S; 4] {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let pace = &interval.table.pace;
    let mass = one / interval.scene.dynamics.chain().inverse_mass;
    let mut sum = [zero; 4];
    for (channel, drive) in interval.table.channels.iter().zip(&*interval.store.drive) {
        for (sum, term) in sum.iter_mut().zip(drive) {
            *sum = *sum + channel.acceleration * *term;
        }
    }
    for term in &mut sum {
        *term = *term * mass;
    }
    sum[0] = sum[0] - interval.status.stuck_at / pace.receptance;
    if interval.scene.rubs_on_base() {
        let velocity = derived(interval.base);
        let acceleration = derived(velocity);
        let inverse = one / pace.span;
        let of_place = one / pace.receptance;
        let of_velocity = pace.drag * inverse * mass;
        let of_acceleration = inverse * inverse * mass;
        let motions = interval.base.iter().zip(velocity).zip(acceleration);
        for (sum, ((place, velocity), acceleration)) in sum.iter_mut().zip(motions) {
            *sum =
                *sum - *place * of_place - of_velocity * velocity - of_acceleration * acceleration;
        }
    }
    sum
}
