//! Computes the response of a scene at the frequency and load of an observation, and its derivatives with respect to
//! each unknown.

use super::observation::Observation;
use super::request::Unknown;
use crate::study::scene::{Damping, Scene};
use crate::study::units::angular_frequency;
use crate::study::{
    System,
    response::SystemResponse,
    sensitivity::{Quantity, Sensitive, Varied},
    units::Load,
};
use crate::{Complex, Of, Regime};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// The computed response of a scene to the load of an observation.
pub(super) struct ComputedResponse {
    pub(super) r: f64,
    pub(super) beta: f64,
    pub(super) regime: Regime,
    /// Computed motions divided by the amplitude of the load, in the order of the observation's motions.
    pub(super) values: Vec<Complex<f64>>,
}

/// Returns the factor that converts a non-dimensional displacement x̄ to a displacement divided by the amplitude of
/// the load. The result is x/Y for base motion, and x/P in m/N for a force.
fn over_load(system: &System, load: Load) -> f64 {
    if load.is_base_motion() {
        1.0
    } else {
        1.0 / system.scene().first_stiffness()
    }
}

/// Returns the friction force in N that corresponds to the friction ratio β = 1.
pub(super) fn force_scale(system: &System, load: Load) -> f64 {
    if load.is_base_motion() {
        system.scene().first_stiffness() * load.amplitude()
    } else {
        load.amplitude()
    }
}

/// Returns the scene's response at a friction force in N, or `None` if the scene has no steady response at this force.
pub(super) fn answer(
    system: &System,
    seen: &Observation,
    friction: f64,
) -> Option<ComputedResponse> {
    let r = system.frequency_ratio_at_hertz(seen.hertz);
    let beta = friction / force_scale(system, seen.load);
    let at = system.at(r).ok()?;
    let response = at.response(beta).ok()?;
    let scale = over_load(system, seen.load);
    let values = seen.motions.iter().map(|datum| {
        let value = response.harmonic(Of::Mass(datum.mass), datum.harmonic)? * scale;
        (value.re.is_finite() && value.im.is_finite()).then_some(value)
    });
    Some(ComputedResponse {
        r,
        beta,
        regime: response.regime(),
        values: values.collect::<Option<_>>()?,
    })
}

/// Upper bound of the scanned friction forces, as a multiple of the largest β*_lim at r = 0, at the resonances and at
/// r → ∞. The scan needs this bound because at an antiresonance of the contact no finite force makes it stick.
const FAR: f64 = 20.0;

/// Returns two friction forces in N. The first is the smallest force at which the contact is stuck, and the second is
/// the upper bound of the scan. The two forces are equal, unless the first force exceeds the bound that [`FAR`] gives.
pub(super) fn sticks_from(system: &System, seen: &Observation) -> Option<(f64, f64)> {
    let r = system.frequency_ratio_at_hertz(seen.hertz);
    let limit = system.at(r).ok()?.sliding_limit();
    let slow = system.at(0.0).ok()?.sliding_limit();
    let others = system.resonance_thresholds().into_iter().flatten();
    let others = others.chain([slow, system.high_frequency_limits().1]);
    let usual = others.filter(|beta| beta.is_finite()).fold(0.0, f64::max);
    let scale = force_scale(system, seen.load);
    let sought = if 0.0 < usual {
        limit.min(FAR * usual)
    } else {
        limit
    };
    let sought = sought * scale;
    sought.is_finite().then_some((limit * scale, sought))
}

/// Returns the value that an unknown of the fit has in a scene.
pub(in crate::measure) fn value(system: &System, unknown: Unknown) -> Option<f64> {
    let scene = system.scene();
    Some(match unknown {
        Unknown::Stiction => scene.stiction,
        Unknown::Frequencies => 1.0,
        Unknown::Damping => match &scene.damping {
            Damping::None => 0.0,
            Damping::Uniform(ratio) => *ratio,
            Damping::Modal(ratios) => ratios.iter().sum::<f64>() / ratios.len().max(1) as f64,
            Damping::Rayleigh { .. } => return None,
        },
        Unknown::Quantity(quantity) => match (quantity, &scene.damping) {
            (Quantity::Mass(place), _) => scene.masses.get(place)?.value,
            (Quantity::Stiffness(place), _) => scene.springs.get(place)?.stiffness,
            (Quantity::Stiction, _) => scene.stiction,
            (Quantity::ContactStiffness, _) => scene.stiffness?,
            (Quantity::MassDamping, Damping::Rayleigh { mass, .. }) => *mass,
            (Quantity::StiffnessDamping, Damping::Rayleigh { stiffness, .. }) => *stiffness,
            (Quantity::DampingRatio(mode), Damping::Modal(ratios)) => *ratios.get(mode)?,
            (Quantity::DampingRatio(mode), Damping::Uniform(ratio)) => {
                (mode < scene.masses.len()).then_some(*ratio)?
            }
            _ => return None,
        },
    })
}

/// Sets an unknown of the fit to a value in a scene.
fn set(scene: &mut Scene, unknown: Unknown, value: f64) -> Option<()> {
    let count = scene.masses.len();
    match unknown {
        Unknown::Stiction | Unknown::Quantity(Quantity::Stiction) => scene.stiction = value,
        Unknown::Frequencies => {
            for spring in &mut scene.springs {
                spring.stiffness *= value * value;
            }
        }
        Unknown::Damping => scene.damping = Damping::Uniform(value),
        Unknown::Quantity(quantity) => match (quantity, &mut scene.damping) {
            (Quantity::Mass(place), _) => scene.masses.get_mut(place)?.value = value,
            (Quantity::Stiffness(place), _) => scene.springs.get_mut(place)?.stiffness = value,
            (Quantity::ContactStiffness, _) => *scene.stiffness.as_mut()? = value,
            (Quantity::MassDamping, Damping::Rayleigh { mass, .. }) => *mass = value,
            (Quantity::StiffnessDamping, Damping::Rayleigh { stiffness, .. }) => *stiffness = value,
            (Quantity::DampingRatio(mode), damping) => {
                if let Damping::Uniform(ratio) = damping {
                    *damping = Damping::Modal(vec![*ratio; count]);
                }
                let Damping::Modal(ratios) = damping else {
                    return None;
                };
                *ratios.get_mut(mode)? = value;
            }
            _ => return None,
        },
    }
    Some(())
}

/// Returns the scene with other values of the fit's unknowns. Returns `None` if the scene is then invalid.
pub(super) fn changed(system: &System, unknowns: &[Unknown], values: &[f64]) -> Option<System> {
    let mut scene = system.scene().clone();
    for (unknown, value) in unknowns.iter().zip(values) {
        set(&mut scene, *unknown, *value)?;
    }
    System::try_from(scene).ok()
}

/// The variable with respect to which a derivative is taken.
#[derive(Clone, Copy)]
pub(super) enum Direction {
    /// Derivative with respect to the friction force, in N.
    Friction,
    /// Derivative with respect to a common factor on all natural frequencies, at the value 1 of the factor.
    Frequencies,
    /// Derivative with respect to one number of the scene, such as the stiffness of the contact.
    Quantity(Quantity),
}

/// A scene whose results contain the derivative with respect to one variable.
pub(super) struct Along<'s> {
    system: &'s System,
    direction: Direction,
    varied: Varied,
}

impl<'s> Along<'s> {
    pub(super) fn new(system: &'s System, direction: Direction) -> Option<Self> {
        let varied = match direction {
            Direction::Quantity(quantity) => system.along(quantity)?,
            _ => system.unvaried(),
        };
        Some(Self {
            system,
            direction,
            varied,
        })
    }

    /// Returns the derivatives of the computed motions that [`answer`] returns, or `None` if no derivative exists.
    pub(super) fn slopes(&self, seen: &Observation, friction: f64) -> Option<Vec<Complex<f64>>> {
        let number = |value: f64, own: bool| -> Sensitive {
            let value = Dd::from(value);
            if own {
                Dual::variable(value)
            } else {
                Dual::fixed(value)
            }
        };
        let factor = number(1.0, matches!(self.direction, Direction::Frequencies));
        let own = matches!(self.direction, Direction::Quantity(Quantity::Stiffness(0)));
        let stiffness = number(self.system.scene().first_stiffness(), own) * factor * factor;
        let friction_dual = number(friction, matches!(self.direction, Direction::Friction));
        let amplitude = number(seen.load.amplitude(), false);
        let (force, scale) = if seen.load.is_base_motion() {
            (stiffness * amplitude, number(1.0, false))
        } else {
            (amplitude, number(1.0, false) / stiffness)
        };
        let omega = angular_frequency(number(seen.hertz, false));
        let (r, beta) = (
            self.varied.frequency_ratio(omega) / factor,
            friction_dual / force,
        );
        let at = self.system.at(r.value.to_f64()).ok()?;
        let response = at.response(beta.value.to_f64()).ok()?;
        let values = self.harmonics(&response, r, beta, seen)?;
        let slope = |value: Complex<Sensitive>| {
            let [re, im] = [value.re * scale, value.im * scale].map(|part| part.slope.to_f64());
            (re.is_finite() && im.is_finite()).then_some(Complex::new(re, im))
        };
        values.into_iter().map(slope).collect()
    }

    fn harmonics(
        &self,
        response: &SystemResponse<'_>,
        r: Sensitive,
        beta: Sensitive,
        seen: &Observation,
    ) -> Option<Vec<Complex<Sensitive>>> {
        let data = seen.motions.iter();
        match response {
            SystemResponse::Continuous(_) => {
                let motion = self.varied.at(r).ok()?.motion(beta).ok()?;
                data.map(|datum| Some(motion.mass_at(datum.mass)?.harmonic(datum.harmonic)))
                    .collect()
            }
            SystemResponse::StickSlip(orbit) => {
                let orbit = self.varied.orbit_along(orbit, r, beta).ok()?;
                data.map(|datum| Some(orbit.mass_at(datum.mass)?.harmonic(datum.harmonic)))
                    .collect()
            }
            SystemResponse::Stuck(_) => {
                let stuck = self.varied.at(r).ok()?.stuck().ok()?;
                let zero = Dual::fixed(Dd::from(0.0));
                data.map(|datum| match datum.harmonic {
                    1 => stuck.mass_at(datum.mass),
                    _ => Some(Complex::new(zero, zero)),
                })
                .collect()
            }
        }
    }
}
