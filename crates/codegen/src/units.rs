//! Constants that convert between ratios and units, and the ranges of the ratios.

use frictiongen_kernel::Float;
use frictiongen_model::modal::Modal;
use frictiongen_model::rounded;
use frictiongen_model::scene::Scene;
use frictiongen_model::table::Tables;

/// Constants that convert between ratios and units, rounded to a scalar type.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitConstants {
    /// k₁, the stiffness of the first spring, in N/m if springs are in N/m.
    pub k1: f64,
    /// The two nodes of the first spring.
    pub spring: String,
    /// m₁, the first mass, in kg if masses are in kg.
    pub m1: f64,
    /// Name of the first mass of the scene.
    pub mass: String,
    /// √(k₁/m₁), the divisor of angular frequencies, in rad/s.
    pub reference: f64,
    /// Natural frequencies ω_i/(2π) in Hz, ascending.
    pub hertz: Vec<f64>,
    /// Frequency ratios r of the undamped resonances, ascending.
    pub resonances: Vec<f64>,
}

impl UnitConstants {
    /// Returns the constants of a scene, rounded to the scalar type `S`.
    #[must_use]
    pub fn of<S: Float>(scene: &Scene) -> Self {
        let modal = Modal::of(scene);
        let round = |value: f64| S::constant(value).to_f64();
        let spring = scene.springs.first();
        let mass = scene.masses.first();
        let ends = spring.map(|spring| {
            format!(
                "{} - {}",
                scene.node_name(spring.from),
                scene.node_name(spring.to)
            )
        });
        let hertz = modal.natural_frequencies().into_iter();
        let hertz = hertz.map(|omega| round(omega.to_f64() / core::f64::consts::TAU));
        Self {
            k1: round(scene.first_stiffness()),
            spring: ends.unwrap_or_default(),
            m1: round(mass.map_or(1.0, |mass| mass.value)),
            mass: mass.map(|mass| mass.name.clone()).unwrap_or_default(),
            reference: rounded::<S>(modal.reference).to_f64(),
            hertz: hertz.collect(),
            resonances: modal
                .resonances
                .iter()
                .map(|value| round(value.to_f64()))
                .collect(),
        }
    }
}

/// Returns the declared ranges of r and of β, as numbers of the file's scalar type.
pub(crate) fn domain<S: Float>(scene: &Scene, tables: &Tables<S>) -> [(f64, f64); 2] {
    let round = |value: f64| S::constant(value).to_f64();
    let (low, high) = tables.request.r;
    let largest = if S::EPSILON > f64::EPSILON {
        f64::from(f32::MAX)
    } else {
        f64::MAX
    };
    let declared = scene.declared.range;
    let (least, most) = declared.map_or((0.0, largest), |range| range.beta);
    // The domain excludes an infinite friction ratio, so the largest finite number replaces infinity.
    [
        (round(low), round(high)),
        (round(least), round(most.min(largest))),
    ]
}
