//! Resonances of a chain with each set of its contacts stuck.

use super::scene::Joined;
use crate::study::joints::Chain;
use frictiongen_model::scene::Node;
use nalgebra::DMatrix;

/// Largest number of contacts for which the code takes every set of stuck contacts. With more contacts it takes no
/// contact, each contact alone, and all contacts.
const ALL_SETS: usize = 4;
/// Stiffness that replaces a rigid contact while it sticks, divided by the largest stiffness of the chain.
const RIGID: f64 = 1e6;

impl Joined<'_> {
    /// Returns the resonances of the chain with each set of stuck contacts, as frequency ratio r and damping ratio. The
    /// contacts outside the set have no friction. The damping ratio is NaN unless no contact sticks, or all contacts.
    pub(in crate::study) fn resonances(&self) -> Vec<[f64; 2]> {
        let chain = self.chain();
        let contacts = chain.contacts.len();
        let all = (1_u32 << contacts) - 1;
        let sets: Vec<u32> = match contacts {
            0..=ALL_SETS => (0..=all).collect(),
            _ => [0, all]
                .into_iter()
                .chain((0..contacts).map(|one| 1 << one))
                .collect(),
        };
        let of_set = |stuck: &u32| {
            let is_extreme = [0, all].contains(stuck);
            let modes = modes(chain, *stuck).into_iter();
            modes.map(move |[frequency, zeta]| {
                let zeta = if is_extreme { zeta } else { f64::NAN };
                [frequency / self.reference(), zeta]
            })
        };
        sets.iter().flat_map(of_set).collect()
    }
}

/// Returns natural frequency and damping ratio of the modes of a chain in which the contacts of a set stick. Bit i of
/// the set belongs to contact i.
fn modes(chain: &Chain, stuck: u32) -> Vec<[f64; 2]> {
    let count = chain.masses.len();
    let stiffest = chain.springs.iter().map(|spring| spring.2);
    let elastic = chain
        .contacts
        .iter()
        .filter_map(|contact| contact.stiffness);
    let stiffest = stiffest.chain(elastic).fold(0.0, f64::max);
    let contacts = chain.contacts.iter().enumerate();
    let held = contacts.filter(|(index, _)| stuck >> index & 1 == 1);
    let held = held.map(|(_, contact)| {
        let stiffness = contact.stiffness.unwrap_or(RIGID * stiffest);
        (contact.ends.0, contact.ends.1, stiffness)
    });
    let springs: Vec<_> = chain.springs.iter().copied().chain(held).collect();
    let scaled = |elements: &[(Node, Node, f64)]| {
        let mut matrix = DMatrix::zeros(count, count);
        for (from, to, value) in elements {
            let sides = [(*from, 1.0), (*to, -1.0)];
            for (a, sign_a) in sides {
                for (b, sign_b) in sides {
                    if let (Node::Mass(a), Node::Mass(b)) = (a, b)
                        && let Some(cell) = matrix.get_mut((a, b))
                    {
                        *cell += sign_a * sign_b * value;
                    }
                }
            }
        }
        matrix
    };
    let roots = |matrix: DMatrix<f64>| {
        DMatrix::from_fn(count, count, |row, column| {
            let mass = |index: usize| chain.masses.get(index).copied().unwrap_or(1.0);
            let value = matrix.get((row, column)).copied().unwrap_or_default();
            value / (mass(row) * mass(column)).sqrt()
        })
    };
    let mut damping = scaled(&chain.dashpots);
    for (row, values) in chain.damping.iter().enumerate() {
        for (column, value) in values.iter().enumerate() {
            if let Some(cell) = damping.get_mut((row, column)) {
                *cell += value;
            }
        }
    }
    let damping = roots(damping);
    let eigen = roots(scaled(&springs)).symmetric_eigen();
    let modes = eigen
        .eigenvalues
        .iter()
        .zip(eigen.eigenvectors.column_iter());
    let modes = modes
        .filter(|(square, _)| 0.0 < **square)
        .map(|(square, shape)| {
            let frequency = square.sqrt();
            let damped = (&damping * shape).dot(&shape);
            [frequency, 0.5 * damped / frequency]
        });
    modes.collect()
}

#[cfg(test)]
#[allow(clippy::expect_used, reason = "a test may fail")]
mod tests {
    use crate::study::System;

    /// Checks one mass with two elastic contacts and a dashpot: √(k/m) and c/(2√(km)), with the stiffness of each set of
    /// stuck contacts.
    #[test]
    fn each_set_of_stuck_contacts() {
        let text =
            "struct Block { masses: { block: 2 }, springs: { base - block: 50 }, excitation: block,
            contacts: { one: base - block { stiffness: 30 }, two: block - wall { stiffness: 70 } },
            dampers: { block - wall: 0.4 } }";
        let system: System = text.parse().expect("a scene");
        let found = system.joined().expect("a solver").resonances();
        for ([r, zeta], stiffness) in found.into_iter().zip([50.0_f64, 80.0, 120.0, 150.0]) {
            assert!((r - (stiffness / 50.0).sqrt()).abs() < 1e-12, "{r}");
            let expected = 0.4 / (2.0 * (2.0 * stiffness).sqrt());
            let is_extreme = [50.0, 150.0].contains(&stiffness);
            assert_eq!(is_extreme, !zeta.is_nan());
            assert!(!is_extreme || (zeta - expected).abs() < 1e-12, "{zeta}");
        }
    }
}
