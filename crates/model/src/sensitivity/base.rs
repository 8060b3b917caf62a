//! Derivatives of the load that damping relative to the moving base puts on each mode.

use super::{RelativeChange, dual, set};
use crate::modal::Modal;
use crate::scene::{Node, Scene};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

impl RelativeChange {
    /// Sets the derivatives of the participation factors φᵀΓ1 for base motion, and of the forces φᵀK_w1 on the modes
    /// from the springs to the wall. Both lists are empty unless damping acts on velocities relative to the base.
    pub(super) fn project_base(
        &self,
        scene: &Scene,
        (gamma, kappa): (&[Dd], &[Dd]),
        turned: &[bool],
        along: &mut Modal<Dual<Dd>>,
    ) {
        let zero = Dual::constant(0.0);
        let inertia = gamma.iter().zip(&self.masses);
        let inertia: Vec<_> = inertia
            .map(|(gamma, change)| dual(*gamma, *gamma * *change))
            .collect();
        let mut walls = vec![zero; gamma.len()];
        for ((spring, kappa), change) in scene.springs.iter().zip(kappa).zip(&self.springs) {
            if let (Node::Wall, Node::Mass(mass)) | (Node::Mass(mass), Node::Wall) =
                (spring.from, spring.to)
                && let Some(wall) = walls.get_mut(mass)
            {
                *wall = *wall + dual(*kappa, *kappa * *change);
            }
        }
        let projections = along.participations.iter_mut().zip(&mut along.walls);
        for (((participation, wall), shape), turned) in projections.zip(&along.shapes).zip(turned) {
            for (projection, on) in [(participation, &inertia), (wall, &walls)] {
                set(projection, shape, on, *turned);
            }
        }
    }
}
