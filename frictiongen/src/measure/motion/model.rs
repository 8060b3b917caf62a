//! Compares a recorded motion with the motion of a scene: residuals and their derivatives.

use crate::measure::identify::model::value;
use crate::measure::least_squares::Linearised;
use crate::measure::{Dimension, Inputs, MeasureError, Recording, Unknown};
use crate::study::sensitivity::Quantity;
use crate::study::stepper::SystemStepper;
use crate::study::{System, optimum::Tunable};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dual::Dual;
use nalgebra::{DMatrix, DVector};
use std::cell::Cell;

/// Step of a finite difference, divided by the value of the unknown. The fit uses finite differences if no exact
/// derivative exists.
const DIFFERENCE: f64 = 1e-6;
/// Starting value of a damping ratio ζ in the fit if the scene has no damping.
const SOME_DAMPING: f64 = 0.01;

/// Recorded motion of a mass.
#[derive(Debug)]
struct RecordedMotion {
    mass: usize,
    is_velocity: bool,
    /// Displacements in m, relative to the first sample, or velocities in m/s.
    values: Vec<f64>,
    /// Root mean square of the values, by which the fit divides the residuals.
    size: f64,
}

/// Numbers of simulations (runs) of the whole recording.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct RunCount {
    /// Runs without derivatives.
    pub(super) plain: usize,
    /// Runs with the exact derivative with respect to one quantity.
    pub(super) exact: usize,
    /// Derivatives by finite differences. Each of these derivatives took one of the runs without derivatives.
    pub(super) differences: usize,
}

/// A recording, and the numbers of a scene that the fit changes. The first parameter is the friction force, unless the
/// recording contains this force. The other parameters are the values of these numbers.
pub(super) struct MotionProblem<'p> {
    pub(super) system: &'p System,
    pub(super) vary: &'p [Tunable],
    /// First guess of the friction force in N. `None` if the force was recorded.
    friction: Option<f64>,
    inputs: Inputs<'p>,
    motions: Vec<RecordedMotion>,
    count: Cell<RunCount>,
    /// True if the fit takes exact derivatives where they exist. Tests set it to false, to compare with finite
    /// differences.
    exact: bool,
}

impl<'p> MotionProblem<'p> {
    pub(super) fn new(
        system: &'p System,
        recording: &'p Recording,
        (friction, vary): (Option<f64>, &'p [Tunable]),
        exact: bool,
    ) -> Result<Self, MeasureError> {
        let scene = system.scene();
        let place = |name: &str| scene.masses.iter().position(|mass| mass.name == name);
        let (mut motions, mut others) = (Vec::new(), Vec::new());
        for channel in recording.channels() {
            let is_velocity = match (place(&channel.name), channel.unit.dimension()) {
                (Some(_), Dimension::Displacement) => false,
                (Some(_), Dimension::Velocity) => true,
                _ => {
                    others.push(channel);
                    continue;
                }
            };
            let scale = channel.unit.scale();
            let first = channel.samples.first().copied().unwrap_or(0.0);
            let zero = if is_velocity { 0.0 } else { first };
            let values = channel.samples.iter().map(|value| (value - zero) * scale);
            let values: Vec<f64> = values.collect();
            let squares: f64 = values.iter().map(|value| value * value).sum();
            let size = (squares / values.len() as f64).sqrt();
            if !(0.0 < size) {
                return Err(MeasureError::Constant(channel.name.clone()));
            }
            motions.push(RecordedMotion {
                mass: place(&channel.name).unwrap_or(0),
                is_velocity,
                values,
                size,
            });
        }
        if motions.is_empty() {
            return Err(MeasureError::NoMass);
        }
        recording.even_rate()?;
        let inputs = Inputs::of_channels((recording, &others), system, friction)?;
        if friction.is_none() && vary.is_empty() {
            return Err(MeasureError::Asked(
                "the friction force is recorded, so that the fit has no unknown; name a number of the description, as in --vary mu",
            ));
        }
        Ok(Self {
            system,
            vary,
            friction,
            inputs,
            motions,
            count: Cell::default(),
            exact,
        })
    }

    pub(super) fn count(&self) -> RunCount {
        self.count.get()
    }

    /// Returns the number of measured values that the fit compares. The first sample has no information, because the
    /// motion starts at rest relative to the base.
    pub(super) fn data(&self) -> usize {
        self.motions.len() * self.inputs.len().saturating_sub(1)
    }

    /// Returns true if the first parameter is the friction force.
    pub(super) fn fits_friction(&self) -> bool {
        self.friction.is_some()
    }

    /// Returns the starting point of the fit: the first guess of the friction force, and the values of the scene.
    pub(super) fn start(&self) -> Option<Vec<f64>> {
        let values = self.vary.iter().map(|tunable| {
            let value = match tunable {
                Tunable::Quantity(quantity) => value(self.system, Unknown::Quantity(*quantity)),
                Tunable::DampingRatios => value(self.system, Unknown::Damping),
                Tunable::Joined(_) => None,
            };
            let value = value.unwrap_or(0.0);
            let is_ratio = matches!(
                tunable,
                Tunable::DampingRatios | Tunable::Quantity(Quantity::DampingRatio(_))
            );
            if is_ratio && value == 0.0 {
                SOME_DAMPING
            } else {
                value
            }
        });
        let start: Vec<f64> = self.friction.into_iter().chain(values).collect();
        self.system_at(&start).map(|_| start)
    }

    /// Returns the scene with the given values of the fit's parameters, or `None` if the scene is then invalid.
    pub(super) fn system_at(&self, parameters: &[f64]) -> Option<System> {
        let (_, values) = self.divided(parameters)?;
        let mut system = self.system.clone();
        for (tunable, value) in self.vary.iter().zip(values) {
            system = system.with_value(*tunable, *value).ok()?;
        }
        Some(system)
    }

    /// Splits the parameters into the friction force, if the fit changes it, and the values of the scene's numbers.
    fn divided<'v>(&self, parameters: &'v [f64]) -> Option<(Option<f64>, &'v [f64])> {
        if self.friction.is_none() {
            return Some((None, parameters));
        }
        let (friction, values) = parameters.split_first()?;
        Some((Some(*friction), values))
    }

    pub(super) fn residuals(&self, parameters: &[f64]) -> Option<DVector<f64>> {
        let system = self.system_at(parameters)?;
        let (friction, _) = self.divided(parameters)?;
        let (x, v) = self.inputs.initial_state(&system);
        let mut stepper = system.stepper_from(self.inputs.dt(), (&x, &v)).ok()?;
        let computed = self.follow(&mut stepper, |value| value, friction)?;
        self.add(|count| count.plain += 1);
        let measured = (1..self.inputs.len()).flat_map(|sample| {
            let motions = self.motions.iter();
            motions.map(move |motion| (motion.values.get(sample).copied(), motion.size))
        });
        let pairs = measured.zip(computed);
        let residuals = pairs.map(|((value, size), computed)| Some((value? - computed) / size));
        Some(DVector::from_vec(residuals.collect::<Option<_>>()?))
    }

    /// Returns the computed motions at all samples after the first. For each sample in turn, the list has the motions
    /// of all recorded masses.
    fn follow<S: Float>(
        &self,
        stepper: &mut SystemStepper<'_, S>,
        number: impl Fn(f64) -> S,
        friction: Option<S>,
    ) -> Option<Vec<S>> {
        let input = |sample: usize| {
            let input = self.inputs.at(sample).map(&number);
            match friction {
                Some(friction) => input.friction(friction),
                None => input,
            }
        };
        stepper.begin(input(0)).ok()?;
        let mut all = Vec::with_capacity(self.data());
        for sample in 1..self.inputs.len() {
            stepper.advance(input(sample)).ok()?;
            all.extend(self.motions.iter().map(|motion| {
                let now = stepper.mass_at(motion.mass);
                if motion.is_velocity {
                    now.velocity()
                } else {
                    now.displacement()
                }
            }));
        }
        Some(all)
    }

    pub(super) fn linearise(&self, parameters: &[f64]) -> Option<Linearised> {
        let residuals = self.residuals(parameters)?;
        let mut jacobian = DMatrix::zeros(residuals.len(), parameters.len());
        for index in 0..parameters.len() {
            let column = match self.exact(parameters, index) {
                Some(column) => column,
                None => self.difference(parameters, &residuals, index)?,
            };
            jacobian.set_column(index, &column);
        }
        Some(Linearised {
            residuals,
            jacobian,
        })
    }

    /// Returns the derivatives of the residuals with respect to one parameter, by dual numbers. Returns `None` if a
    /// stop, break-away or reversal is about to appear or vanish, because the derivatives are then unreliable.
    fn exact(&self, parameters: &[f64], index: usize) -> Option<DVector<f64>> {
        if !self.exact {
            return None;
        }
        let system = self.system_at(parameters)?;
        let (friction, _) = self.divided(parameters)?;
        let place = index.checked_sub(usize::from(self.fits_friction()));
        let quantities = match place {
            Some(place) => self.vary.get(place)?.quantities(system.scene()),
            None => Vec::new(),
        };
        let varied: Vec<_> = match place {
            Some(_) => {
                let along = quantities.iter().map(|quantity| system.along(*quantity));
                along.collect::<Option<_>>()?
            }
            None => vec![system.unvaried()],
        };
        let friction = friction.map(|force| match place {
            None => Dual::variable(force),
            Some(_) => Dual::fixed(force),
        });
        let mut column = DVector::<f64>::zeros(self.data());
        for varied in &varied {
            let steps = varied.rounded_steps()?;
            let state = self.inputs.initial_state(&system);
            let mut stepper = steps.stepper(self.inputs.dt(), state)?;
            let computed = self.follow(&mut stepper, Dual::fixed, friction)?;
            self.add(|count| count.exact += 1);
            if stepper.grazed() {
                return None;
            }
            let sizes = self.motions.iter().map(|motion| motion.size).cycle();
            for ((entry, computed), size) in column.iter_mut().zip(computed).zip(sizes) {
                *entry -= computed.slope / size;
            }
        }
        column
            .iter()
            .all(|entry| entry.is_finite())
            .then_some(column)
    }

    /// Returns the derivatives of the residuals with respect to one parameter, by finite differences.
    fn difference(
        &self,
        parameters: &[f64],
        here: &DVector<f64>,
        index: usize,
    ) -> Option<DVector<f64>> {
        let step = DIFFERENCE * parameters.get(index)?.abs().max(DIFFERENCE);
        let mut moved = parameters.to_vec();
        // The step increases the value, because the value may be at its lower bound.
        *moved.get_mut(index)? += step;
        let there = self.residuals(&moved)?;
        self.add(|count| count.differences += 1);
        Some((there - here) / step)
    }

    fn add(&self, change: impl Fn(&mut RunCount)) {
        let mut count = self.count.get();
        change(&mut count);
        self.count.set(count);
    }

    /// Returns the lower and the upper bound of each parameter.
    pub(super) fn bounds(&self, start: &[f64]) -> Vec<(f64, f64)> {
        let friction = self.friction.map(|_| (0.0, f64::MAX));
        let own = start.iter().skip(usize::from(self.fits_friction()));
        let numbers = self.vary.iter().zip(own);
        let numbers = numbers.map(|(tunable, value)| match tunable {
            Tunable::DampingRatios | Tunable::Quantity(Quantity::DampingRatio(_)) => (0.0, 0.99),
            Tunable::Quantity(Quantity::Stiction) => (1.0, 10.0),
            Tunable::Quantity(Quantity::MassDamping | Quantity::StiffnessDamping) => {
                (0.0, f64::MAX)
            }
            Tunable::Quantity(Quantity::ContactStiffness) => (0.02 * value, 50.0 * value),
            Tunable::Quantity(_) | Tunable::Joined(_) => (0.2 * value, 5.0 * value),
        });
        friction.into_iter().chain(numbers).collect()
    }
}
