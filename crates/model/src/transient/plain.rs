//! Modes of the sliding chain in double-double. The modes that the contact drives come first.

use crate::modal::Modal;
use crate::roots::DrivenMode;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;

/// Largest relative difference of two constants (resonance or damping ratio) of modes that count as equal. Rounding
/// can cause a difference of this size.
pub(super) const EQUAL: f64 = 1e-24;

/// Bound on a component of a mode that is only rounding noise, as a fraction of the largest value that the component
/// can have. The code sets such a component to zero.
const NOISE: f64 = 1e-26;

/// Constants of one mode of the sliding chain in double-double, with or without derivatives.
#[derive(Clone, Debug)]
pub(super) struct SlidingMode<T> {
    pub resonance: T,
    pub zeta: T,
    pub load: T,
    pub contact: T,
    /// Participation factor of the mode for base motion, and force on the mode from the wall springs if all masses move
    /// by 1.
    pub base: [T; 2],
    pub shape: Vec<T>,
}

/// Moves the modes that the contact drives to the front of the list. Both groups stay in ascending order, because the
/// sort is stable.
pub(super) fn sorted<T: Float>(mut modes: Vec<SlidingMode<T>>) -> Vec<SlidingMode<T>> {
    modes.sort_by_key(|mode| mode.contact.is_zero());
    modes
}

pub(super) fn in_contact<T: Float>(
    modes: &[SlidingMode<T>],
) -> impl Iterator<Item = &SlidingMode<T>> {
    modes.iter().filter(|mode| !mode.contact.is_zero())
}

/// Returns the modes that the contact drives, as [`DrivenMode`] for the search for the modes of the stuck chain.
pub(super) fn driven<T: Float>(
    modes: &[SlidingMode<T>],
    value: impl Fn(T) -> Dd,
) -> Vec<DrivenMode> {
    let driven = in_contact(modes).map(|mode| {
        let contact = value(mode.contact);
        DrivenMode {
            sigma: value(mode.resonance),
            zeta: value(mode.zeta),
            inverse_mass: contact * contact,
            along: Dd::ZERO,
        }
    });
    driven.collect()
}

pub(super) fn plain_modes<T: Float>(modal: &Modal<T>) -> Vec<SlidingMode<T>> {
    let zero = T::constant(0.0);
    let pick = |of: &[T], i: usize| of.get(i).copied().unwrap_or(zero);
    modal
        .shapes
        .iter()
        .enumerate()
        .map(|(i, shape)| SlidingMode {
            resonance: pick(&modal.resonances, i),
            zeta: pick(&modal.damping_ratios, i),
            load: pick(&modal.loads, i),
            contact: pick(&modal.contacts, i),
            base: [pick(&modal.participations, i), pick(&modal.walls, i)],
            shape: shape.clone(),
        })
        .collect()
}

/// Returns true if two modal constants (resonance or damping ratio) count as equal.
pub(super) fn close<T: Float>(a: T, b: T) -> bool {
    (a - b).abs() <= (a.abs() + b.abs()) * T::constant(EQUAL)
}

/// Rotates each group of equal modes so that the contact drives only one mode of the group. The contact then has no
/// effect on the other modes of the group.
pub(super) fn turned<T: Float>(modes: Vec<SlidingMode<T>>) -> Vec<SlidingMode<T>> {
    let mut out: Vec<SlidingMode<T>> = Vec::with_capacity(modes.len());
    for mut mode in modes {
        let zero = T::constant(0.0);
        let twin = out.iter_mut().find(|known| {
            known.contact != zero
                && mode.contact != zero
                && close(known.resonance, mode.resonance)
                && close(known.zeta, mode.zeta)
        });
        if let Some(twin) = twin {
            let length = (twin.contact * twin.contact + mode.contact * mode.contact).sqrt();
            let (c, s) = (twin.contact / length, mode.contact / length);
            let mix = |a: &mut T, b: &mut T| {
                let size = a.abs() + b.abs();
                let (first, second) = (*a * c + *b * s, *b * c - *a * s);
                let clean = |value: T| {
                    if value.abs() <= size * T::constant(NOISE) {
                        zero
                    } else {
                        value
                    }
                };
                (*a, *b) = (clean(first), clean(second));
            };
            mix(&mut twin.load, &mut mode.load);
            for (a, b) in twin.base.iter_mut().zip(&mut mode.base) {
                mix(a, b);
            }
            for (a, b) in twin.shape.iter_mut().zip(&mut mode.shape) {
                mix(a, b);
            }
            (twin.contact, mode.contact) = (length, zero);
        }
        out.push(mode);
    }
    out
}
