//! Limits β_lim and β*_lim at every frequency ratio of a slice.

use super::at::{At, inverse_ratio};
use super::scene::Scene;
use crate::contact::regime::{self, Limits};
use crate::contact::several::{SIDE_BY_SIDE, Several};
use crate::errors::OutOfDomain;
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::mode::Kind;

impl<T: Scene> At<T> {
    /// Computes the limits β_lim and β*_lim at every frequency ratio of a slice. Writes them to two slices of the same
    /// length.
    ///
    /// # Errors
    /// [`OutOfDomain`] if the slices have different lengths. Both result slices are then unchanged. [`OutOfDomain`]
    /// also at the first NaN or negative r, where the function stops. The result slices then contain the limits for
    /// the frequency ratios before that r.
    pub fn limits_into(
        scene: T,
        rs: &[T::Scalar],
        continuous: &mut [T::Scalar],
        sliding: &mut [T::Scalar],
    ) -> Result<(), OutOfDomain> {
        regime::limits_into(rs, continuous, sliding, |r| {
            Ok(Self::new(scene.clone(), r)?.limits())
        })
    }

    /// Computes the limits β_lim and β*_lim [without search](Self::limits_without_search) at every frequency ratio of a
    /// slice. Writes them to two slices of the same length.
    ///
    /// Each limit has the same bits as in a call for a single frequency ratio. If all modes are undamped or all are
    /// lightly damped, the function computes several frequency ratios at the same time.
    ///
    /// # Errors
    /// [`OutOfDomain`] if the slices have different lengths. Both result slices are then unchanged. [`OutOfDomain`]
    /// also at the first NaN or negative r, where the function stops. The result slices then contain the limits for
    /// the frequency ratios before that r.
    pub fn limits_without_search_into(
        scene: &T,
        rs: &[T::Scalar],
        continuous: &mut [T::Scalar],
        sliding: &mut [T::Scalar],
    ) -> Result<(), OutOfDomain> {
        regime::check_rooms(rs.len(), continuous.len(), sliding.len())?;
        let numbers = scene.numbers();
        let several = scene.quadratures().is_empty();
        let kind = several.then(|| numbers.chain.kind_of_several(numbers.modes));
        let Some(kind) = kind.flatten() else {
            return Self::in_turn(scene, rs, continuous, sliding);
        };
        let is_one = numbers.chain.sliding_limit_is_one(numbers.modes);
        let mut found = Several::new();
        let (rs, rs_left) = rs.as_chunks();
        let (continuous, continuous_left) = continuous.as_chunks_mut();
        let (sliding, sliding_left) = sliding.as_chunks_mut();
        for ((rs, continuous), sliding) in rs.iter().zip(continuous).zip(sliding) {
            let ordinary = |r: &T::Scalar| T::Scalar::constant(0.0) < *r && r.is_finite();
            if rs.iter().all(ordinary) {
                Self::side_by_side(scene, kind, rs, &mut found);
                if is_one {
                    found.sliding = [T::Scalar::constant(1.0); SIDE_BY_SIDE];
                }
                (*continuous, *sliding) = (found.continuous, found.sliding);
            } else {
                Self::in_turn(scene, rs, continuous, sliding)?;
            }
        }
        Self::in_turn(scene, rs_left, continuous_left, sliding_left)
    }

    fn in_turn(
        scene: &T,
        rs: &[T::Scalar],
        continuous: &mut [T::Scalar],
        sliding: &mut [T::Scalar],
    ) -> Result<(), OutOfDomain> {
        regime::limits_into(rs, continuous, sliding, |r| {
            Self::limits_without_search(scene, r)
        })
    }

    /// Computes the limits β_lim and β*_lim at several frequency ratios at the same time. No ratio may be 0 or
    /// infinite.
    #[inline(always)]
    fn side_by_side(
        scene: &T,
        kind: Kind,
        rs: &[T::Scalar; SIDE_BY_SIDE],
        found: &mut Several<T::Scalar>,
    ) {
        let numbers = scene.numbers();
        let inverse_rs = rs.map(|r| inverse_ratio(scene, r));
        numbers
            .chain
            .several_limits(numbers.modes, kind, &inverse_rs, found);
        if numbers.absorbs {
            let limits = found.sliding.iter_mut().zip(&found.h);
            for (r, (sliding, h)) in rs.iter().zip(limits) {
                // With an absorber, β*_lim depends on the response functions of each mode, which the call for a single
                // frequency ratio computes.
                if numbers.chain.may_absorb(*h)
                    && let Ok(Limits { sliding: limit, .. }) =
                        Self::limits_without_search(scene, *r)
                {
                    *sliding = limit;
                }
            }
        }
    }
}
