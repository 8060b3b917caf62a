//! Chains whose numbers have derivatives with respect to one parameter of the scene or of the operating point.

use super::parameter::{JoinedParameter, JoinedPoint};
use crate::study::joints::{Heap, Model, Wave};
use crate::study::sensitivity::{OperatingPoint, Quantity, Sensitive};
use crate::study::system::System;
use crate::study::units::angular_frequency;
use crate::study::varied::rounded;
use frictiongen_kernel::Scalar;
use frictiongen_kernel::joints::{self, Contact, Stop};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::joined::{at_rest, damping_rows};
use frictiongen_model::scene::Excitation;

/// A number with its derivative with respect to the parameter.
pub(super) type Number = Dual<f64>;

/// A chain with its load, whose numbers have derivatives with respect to one parameter.
pub(super) struct VariedChain {
    pub(super) model: joints::Model<Number, Heap>,
    /// Angular frequency of the load.
    pub(super) omega: Number,
    /// Unit of the forces in the results. The unit of displacement is 1.
    pub(super) force: Number,
}

/// Angular frequency and amplitude of the load, common friction force and unit of force at an operating point.
struct PointNumbers {
    omega: Number,
    amplitude: Number,
    friction: Number,
    force: Number,
}

impl JoinedPoint {
    /// Returns the chain of this operating point with derivatives with respect to a parameter. `system` has the scene of
    /// this operating point, and `plain` is the same chain without derivatives.
    pub(super) fn varied(
        &self,
        system: &System,
        plain: &Model,
        parameter: JoinedParameter,
    ) -> VariedChain {
        let own = |of: JoinedParameter, value: f64| match of == parameter {
            true => Number::variable(value),
            false => Number::fixed(value),
        };
        let point = self.numbers(&own);
        let wave = |wave: &Wave| match wave.amplitude != 0.0 && wave.omega != 0.0 {
            true => joints::Wave::harmonic(point.amplitude, point.omega),
            false => fixed_wave(wave),
        };
        let links = |links: &[(usize, usize, f64)], of: fn(usize) -> JoinedParameter| {
            let links = links.iter().enumerate();
            let varied = links.map(|(index, &(plus, minus, value))| {
                let value = own(of(index), value);
                (plus, minus, value)
            });
            varied.collect()
        };
        let masses = plain.masses.iter().enumerate();
        let loads = plain.loads.iter();
        let model = joints::Model {
            size: plain.size,
            masses: masses
                .map(|(index, mass)| own(JoinedParameter::Quantity(Quantity::Mass(index)), *mass))
                .collect(),
            springs: links(&plain.springs, |index| {
                JoinedParameter::Quantity(Quantity::Stiffness(index))
            }),
            dashpots: links(&plain.dashpots, JoinedParameter::Dashpot),
            damping: self.damping(system, plain, parameter).into(),
            damping_from_base: plain.damping_from_base,
            contacts: self.contacts(plain, (parameter, point.friction)).collect(),
            law: plain
                .law
                .iter()
                .map(|point| point.map(Number::fixed))
                .collect(),
            loads: loads.map(|(mass, load)| (*mass, wave(load))).collect(),
            base: wave(&plain.base.wave).into(),
            stretch: Number::fixed(plain.stretch),
        };
        VariedChain {
            model,
            omega: point.omega,
            force: point.force,
        }
    }

    /// Returns the numbers of the operating point with derivatives. `own` gives the derivative 1 to the value of the
    /// parameter.
    fn numbers(&self, own: &impl Fn(JoinedParameter, f64) -> Number) -> PointNumbers {
        let quantity = |quantity, value| own(JoinedParameter::Quantity(quantity), value);
        match self.point {
            OperatingPoint::Groups { r, beta } => {
                let mass = self.scene.masses.first().map_or(1.0, |mass| mass.value);
                let mass = quantity(Quantity::Mass(0), mass);
                let stiffness = quantity(Quantity::Stiffness(0), self.scene.first_stiffness());
                PointNumbers {
                    omega: own(JoinedParameter::Frequency, r) * (stiffness / mass).sqrt(),
                    amplitude: match self.scene.excitation {
                        Excitation::Force(_) => stiffness,
                        Excitation::Base => Number::fixed(1.0),
                    },
                    friction: own(JoinedParameter::Friction, beta) * stiffness,
                    force: stiffness,
                }
            }
            OperatingPoint::Physical {
                hertz,
                friction,
                load,
            } => {
                let omega = angular_frequency(own(JoinedParameter::Frequency, hertz));
                let load = load.map(|amplitude| own(JoinedParameter::Load, amplitude));
                PointNumbers {
                    omega,
                    amplitude: load.at(omega).amplitude(),
                    friction: own(JoinedParameter::Friction, friction),
                    force: Number::fixed(1.0),
                }
            }
        }
    }

    /// Returns the contacts and stops of the chain with derivatives. `friction` is the common friction force.
    fn contacts<'p>(
        &self,
        plain: &'p Model,
        (parameter, friction): (JoinedParameter, Number),
    ) -> impl Iterator<Item = Contact<Number>> + use<'p> {
        let own = move |of: JoinedParameter, value: f64| match of == parameter {
            true => Number::variable(value),
            false => Number::fixed(value),
        };
        let laws: Vec<_> = self.scene.named_contacts();
        let contacts = plain.contacts.iter().enumerate();
        contacts.map(move |(index, contact)| {
            let law = laws.get(index).map(|contact| &contact.law);
            let share = law.map(|law| own(JoinedParameter::Share(index), law.share));
            let level = share.map_or(Number::fixed(0.0), |share| friction * share);
            // The chain may have another sign and unit of the speed.
            let given = law.map_or(0.0, |law| law.speed);
            let speed = match given == 0.0 {
                true => Number::fixed(contact.speed),
                false => {
                    let unit = Number::fixed(contact.speed / given);
                    own(JoinedParameter::Speed(index), given) * unit
                }
            };
            Contact {
                plus: contact.plus,
                minus: contact.minus,
                level: joints::Wave::constant(level),
                stiction: own(JoinedParameter::Stiction(index), contact.stiction),
                stiffness: contact
                    .stiffness
                    .map(|stiffness| own(JoinedParameter::ContactStiffness(index), stiffness)),
                speed,
                stop: contact.stop.map(|stop| Stop {
                    side: Number::fixed(stop.side),
                    gap: Number::fixed(stop.gap),
                    damping: Number::fixed(stop.damping),
                    restitution: Number::fixed(stop.restitution),
                }),
            }
        })
    }

    /// Returns the damping matrix with derivatives, row after row.
    fn damping(&self, system: &System, plain: &Model, parameter: JoinedParameter) -> Vec<Number> {
        let fixed = || plain.damping.iter().copied().map(Number::fixed).collect();
        let JoinedParameter::Quantity(own) = parameter else {
            return fixed();
        };
        let Some(modal) = system.modal().along(&self.scene, own) else {
            return fixed();
        };
        let modal = at_rest(&self.scene, modal);
        let rows = damping_rows(&self.scene, &modal, |of, value| {
            let value = Dd::from(value);
            match of == own {
                true => Sensitive::variable(value),
                false => Sensitive::fixed(value),
            }
        });
        rows.into_iter().flatten().map(rounded).collect()
    }
}

/// Returns a function of time whose numbers have the derivative 0.
fn fixed_wave(wave: &Wave) -> joints::Wave<Number> {
    joints::Wave {
        constant: Number::fixed(wave.constant),
        slope: Number::fixed(wave.slope),
        amplitude: Number::fixed(wave.amplitude),
        omega: Number::fixed(wave.omega),
        phase: Number::fixed(wave.phase),
    }
}
