//! The numbers of an emitted file that its checksum of the units reads.

use super::Source;
use crate::units::{UnitConstants, domain};
use frictiongen_kernel::Float;

/// Returns the constants of an emitted file, in the order of their checksum. The constants of [`UnitConstants`] come
/// first, then the bounds of the ranges of r and β.
pub(super) fn unit_numbers<S: Float>(source: &Source<'_, S>) -> Vec<f64> {
    let constants = UnitConstants::of::<S>(source.scene);
    let mut all = vec![constants.k1, constants.m1, constants.reference];
    all.extend(constants.hertz);
    all.extend(constants.resonances);
    let [r, beta] = domain(source.scene, source.tables);
    all.extend([r.0, r.1]);
    if source.tables.moves() {
        all.extend([beta.0, beta.1]);
    }
    all
}
