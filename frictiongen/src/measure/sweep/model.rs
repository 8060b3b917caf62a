//! A sweep beside a scene with other parameters: amplitudes, and how they move.

use super::SweepPoint;
use crate::Complex;
use crate::measure::identify::model::{Along, Direction, answer};
use crate::measure::identify::{Datum, Observation};
use crate::measure::least_squares::Linearised;
use crate::study::scene::Damping;
use crate::study::{Load, Quantity, System};
use nalgebra::{DMatrix, DVector};

/// A logarithm of amplitudes does not count more than this.
const FAR: f64 = 3.0;
/// A damping ratio to start from where the scene has none.
const SOME_DAMPING: f64 = 0.005;

/// A sweep beside a scene: parameters are a factor on the frequencies, γ₂ …, κ₂ …, and perhaps ζ.
pub(super) struct Sweep<'a> {
    pub(super) system: &'a System,
    pub(super) points: &'a [SweepPoint],
    seen: Vec<Observation>,
    pub(super) damping: bool,
}

impl<'a> Sweep<'a> {
    pub(super) fn new(system: &'a System, points: &'a [SweepPoint], damping: bool) -> Self {
        Self {
            system,
            points,
            seen: points.iter().map(observation).collect(),
            damping,
        }
    }

    pub(super) fn masses(&self) -> usize {
        self.system.scene().masses.len()
    }

    pub(super) fn start(&self) -> Vec<f64> {
        let scene = self.system.scene();
        let (m, k) = (self.mass(0), self.spring(0));
        let masses = scene.masses.iter().skip(1).map(|mass| mass.value / m);
        let springs = scene
            .springs
            .iter()
            .skip(1)
            .map(|spring| spring.stiffness / k);
        let damping = self.damping.then_some(SOME_DAMPING);
        std::iter::once(1.0)
            .chain(masses)
            .chain(springs)
            .chain(damping)
            .collect()
    }

    fn mass(&self, place: usize) -> f64 {
        self.system
            .scene()
            .masses
            .get(place)
            .map_or(1.0, |mass| mass.value)
    }

    fn spring(&self, place: usize) -> f64 {
        self.system
            .scene()
            .springs
            .get(place)
            .map_or(1.0, |spring| spring.stiffness)
    }

    /// The scene of these parameters.
    pub(super) fn at(&self, parameters: &[f64]) -> Option<System> {
        let mut scene = self.system.scene().clone();
        let factor = *parameters.first()?;
        let (m, k) = (self.mass(0), self.spring(0) * factor * factor);
        let mut rest = parameters.iter().skip(1);
        for mass in scene.masses.iter_mut().skip(1) {
            mass.value = rest.next()? * m;
        }
        for (place, spring) in scene.springs.iter_mut().enumerate() {
            spring.stiffness = if place == 0 { k } else { rest.next()? * k };
        }
        if self.damping {
            scene.damping = Damping::Uniform(*rest.next()?);
        }
        System::try_from(scene).ok()
    }

    /// The directions of a parameter, with what each is multiplied by; in the scene of these parameters.
    fn directions(
        &self,
        parameters: &[f64],
        index: usize,
        system: &System,
    ) -> Vec<(Direction, f64)> {
        let masses = self.masses();
        let springs = system.scene().springs.len();
        let scene = system.scene();
        if index == 0 {
            let factor = parameters.first().copied().unwrap_or(1.0);
            return vec![(Direction::Frequencies, 1.0 / factor)];
        }
        if index < masses {
            return vec![(Direction::Quantity(Quantity::Mass(index)), self.mass(0))];
        }
        let spring = index + 1 - masses;
        if spring < springs {
            let first = scene.springs.first().map_or(1.0, |spring| spring.stiffness);
            return vec![(Direction::Quantity(Quantity::Stiffness(spring)), first)];
        }
        (0..masses)
            .map(|mode| (Direction::Quantity(Quantity::DampingRatio(mode)), 1.0))
            .collect()
    }

    /// The amplitudes of a scene, with what they are made of.
    pub(super) fn values(&self, system: &System) -> Option<Vec<Complex<f64>>> {
        let answers = self
            .seen
            .iter()
            .map(|seen| answer(system, seen, 0.0)?.values.first().copied());
        answers.collect()
    }

    /// What a residual is divided by.
    fn weight(point: &SweepPoint) -> f64 {
        point.deviation.unwrap_or(point.amplitude)
    }

    pub(super) fn residuals(&self, parameters: &[f64], form: Form) -> Option<DVector<f64>> {
        let values = self.values(&self.at(parameters)?)?;
        let residuals = self
            .points
            .iter()
            .zip(values)
            .map(|(point, value)| match form {
                Form::Plain => (point.amplitude - value.norm()) / Self::weight(point),
                Form::Log => (point.amplitude / value.norm()).ln().clamp(-FAR, FAR),
            });
        Some(DVector::from_iterator(self.points.len(), residuals))
    }

    pub(super) fn linearise(&self, parameters: &[f64], form: Form) -> Option<Linearised> {
        let residuals = self.residuals(parameters, form)?;
        let system = self.at(parameters)?;
        let values = self.values(&system)?;
        let mut jacobian = DMatrix::zeros(residuals.len(), parameters.len());
        for index in 0..parameters.len() {
            for (direction, scale) in self.directions(parameters, index, &system) {
                let along = Along::new(&system, direction)?;
                for (row, (point, seen)) in self.points.iter().zip(&self.seen).enumerate() {
                    let (value, slope) = (*values.get(row)?, *along.slopes(seen, 0.0)?.first()?);
                    let size = value.norm();
                    let change = scale * (value.re * slope.re + value.im * slope.im) / size;
                    let far = residuals
                        .get(row)
                        .is_some_and(|residual| FAR <= residual.abs());
                    *jacobian.get_mut((row, index))? -= match form {
                        Form::Plain => change / Self::weight(point),
                        Form::Log if far => 0.0,
                        Form::Log => change / size,
                    };
                }
            }
        }
        Some(Linearised {
            residuals,
            jacobian,
        })
    }
}

/// How amplitudes are compared.
#[derive(Clone, Copy)]
pub(super) enum Form {
    Plain,
    Log,
}

fn observation(point: &SweepPoint) -> Observation {
    Observation {
        hertz: point.hertz,
        load: Load::Base(1.0),
        load_deviation: 0.0,
        motions: vec![Datum {
            mass: point.mass,
            harmonic: 1,
            value: Complex::new(point.amplitude, 0.0),
            deviation: 1.0,
        }],
    }
}
