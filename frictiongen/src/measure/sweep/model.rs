//! Compares the measured amplitudes of a sweep with those of a scene: residuals and their derivatives.

use super::SweepPoint;
use crate::Complex;
use crate::measure::least_squares::Linearised;
use crate::study::scene::Damping;
use crate::study::units::angular_frequency;
use crate::study::{System, sensitivity::Quantity};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_kernel::{Float, Scalar};
use frictiongen_model::modal::Modal;
use nalgebra::{DMatrix, DVector};

/// Upper bound on the difference of the logarithms of a measured and a computed amplitude. The fit replaces a larger
/// difference by this bound, so that no single point dominates.
const FAR: f64 = 3.0;
/// Starting value of the damping ratio ζ in the fit.
const SOME_DAMPING: f64 = 0.005;

/// A sweep and the scene to fit. The parameters are a factor on all frequencies, then the mass ratios γ₂, …, then the
/// stiffness ratios κ₂, …, and optionally the damping ratio ζ.
pub(super) struct Sweep<'a> {
    pub(super) system: &'a System,
    pub(super) points: &'a [SweepPoint],
    pub(super) damping: bool,
}

impl<'a> Sweep<'a> {
    pub(super) fn new(system: &'a System, points: &'a [SweepPoint], damping: bool) -> Self {
        Self {
            system,
            points,
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

    /// Returns the scene with the given values of the fit's parameters. Returns `None` if the scene is then invalid.
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

    /// Returns the quantities of the scene description that a parameter of the fit changes, each with its factor. The
    /// caller treats the first parameter (index 0) separately, because this parameter changes only r.
    pub(super) fn directions(&self, index: usize, system: &System) -> Vec<(Quantity, f64)> {
        let masses = self.masses();
        let scene = system.scene();
        if index < masses {
            return vec![(Quantity::Mass(index), self.mass(0))];
        }
        let spring = index + 1 - masses;
        if spring < scene.springs.len() {
            let first = scene.first_stiffness();
            return vec![(Quantity::Stiffness(spring), first)];
        }
        (0..masses)
            .map(|mode| (Quantity::DampingRatio(mode), 1.0))
            .collect()
    }

    /// Returns the complex amplitude of the measured mass at each point of the sweep. The call multiplies all natural
    /// frequencies of the scene by `factor`. Returns `None` if a point lies on a resonance without damping.
    pub(super) fn values(&self, system: &System, factor: f64) -> Option<Vec<Complex<f64>>> {
        let values = self.points.iter().map(|point| {
            let r = ratio(system, point) / factor;
            let [re, im] = free(system.modal(), point.mass, r, |value| value.to_f64())?;
            (re.is_finite() && im.is_finite()).then_some(Complex::new(re, im))
        });
        values.collect()
    }

    /// Returns the number by which the fit divides the residual of a point. It is the standard deviation of the point
    /// if this is known, and otherwise the amplitude of the point.
    fn weight(point: &SweepPoint) -> f64 {
        point.deviation.unwrap_or(point.amplitude)
    }

    pub(super) fn residuals(
        &self,
        parameters: &[f64],
        form: AmplitudeScale,
    ) -> Option<DVector<f64>> {
        Some(self.compared(&self.values(&self.at(parameters)?, 1.0)?, form))
    }

    /// Returns the residuals of all points. A residual is the measured minus the computed amplitude, or the difference
    /// of the logarithms of the two amplitudes, as `form` says.
    pub(super) fn compared(&self, values: &[Complex<f64>], form: AmplitudeScale) -> DVector<f64> {
        let residuals = self
            .points
            .iter()
            .zip(values)
            .map(|(point, value)| match form {
                AmplitudeScale::Plain => (point.amplitude - value.norm()) / Self::weight(point),
                AmplitudeScale::Log => (point.amplitude / value.norm()).ln().clamp(-FAR, FAR),
            });
        DVector::from_iterator(self.points.len(), residuals)
    }

    pub(super) fn linearise(&self, parameters: &[f64], form: AmplitudeScale) -> Option<Linearised> {
        let system = self.at(parameters)?;
        let values = self.values(&system, 1.0)?;
        let residuals = self.compared(&values, form);
        let mut jacobian = DMatrix::zeros(residuals.len(), parameters.len());
        for (index, parameter) in parameters.iter().enumerate() {
            let along = if index == 0 {
                vec![(system.modal().fixed(), 1.0)]
            } else {
                let directions = self.directions(index, &system);
                let along = directions.into_iter().map(|(quantity, scale)| {
                    Some((system.modal().along(system.scene(), quantity)?, scale))
                });
                along.collect::<Option<Vec<_>>>()?
            };
            for (row, (point, value)) in self.points.iter().zip(&values).enumerate() {
                let r = ratio(&system, point);
                // The first parameter multiplies the frequencies of the scene. If it increases, the frequency ratio r
                // decreases.
                let slope = if index == 0 { -r / parameter } else { 0.0 };
                let r = Dual { value: r, slope };
                let far = residuals
                    .get(row)
                    .is_some_and(|residual| FAR <= residual.abs());
                for (modal, scale) in &along {
                    let [re, im] = free(modal, point.mass, r, plain)?;
                    let size = value.norm();
                    let change = scale * (value.re * re.slope + value.im * im.slope) / size;
                    *jacobian.get_mut((row, index))? -= match form {
                        AmplitudeScale::Plain => change / Self::weight(point),
                        AmplitudeScale::Log if far => 0.0,
                        AmplitudeScale::Log => change / size,
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

/// The form in which the fit compares amplitudes: the amplitudes themselves, or their logarithms.
#[derive(Clone, Copy)]
pub(super) enum AmplitudeScale {
    Plain,
    Log,
}

/// Returns the frequency ratio r of a measured point in a scene.
fn ratio(system: &System, point: &SweepPoint) -> f64 {
    system.frequency_ratio(angular_frequency(point.hertz))
}

/// Rounds a dual number to double precision, which suffices for the steps of a fit.
fn plain(number: Dual<Dd>) -> Dual<f64> {
    Dual {
        value: number.value.to_f64(),
        slope: number.slope.to_f64(),
    }
}

/// Returns X/Y of a mass without friction, as real and imaginary part. The result is the modal sum Σ φ φᵀp/(λ − r² +
/// 2iζ√λ r). φ is the component of the mass in a mode, φᵀp the load on the mode, and √λ the resonance of the mode.
fn free<F: Float, T: Scalar>(
    modal: &Modal<F>,
    mass: usize,
    r: T,
    to: impl Fn(F) -> T,
) -> Option<[T; 2]> {
    let zero = T::constant(0.0);
    let modes = modal.resonances.iter().zip(&modal.damping_ratios);
    let modes = modes.zip(modal.loads.iter().zip(&modal.shapes));
    let mut sum = [zero, zero];
    for ((resonance, zeta), (load, shape)) in modes {
        let share = to(*shape.get(mass)?) * to(*load);
        let (resonance, zeta) = (to(*resonance), to(*zeta));
        let gap = (resonance - r) * (resonance + r);
        let loss = (zeta + zeta) * resonance * r;
        let square = gap * gap + loss * loss;
        sum = [
            sum[0] + share * gap / square,
            sum[1] - share * loss / square,
        ];
    }
    Some(sum)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may fail")]
mod tests {
    use super::{free, plain};
    use crate::Of;
    use crate::study::{
        System,
        sensitivity::{Quantity, Sensitive},
    };
    use frictiongen_kernel::number::dual::Dual;

    /// Compares the modal sum and its derivatives with the fundamental of the continuous motion at zero friction.
    #[test]
    fn the_motion_without_friction() {
        let system: System = "struct Frame {
            masses: { lower: 3.27, upper: 3.25 },
            springs: { base - lower: 1190.0, lower - upper: 1323.0 },
            contact: lower - wall, excitation: base, damping: modal[0.01, 0.03],
        }"
        .parse()
        .unwrap();
        let along = system.along(Quantity::Mass(1)).unwrap();
        for r in [0.2, 0.61, 1.3, 1.62, 4.0] {
            for mass in 0..2 {
                let [re, im] = free(system.modal(), mass, r, |value| value.to_f64()).unwrap();
                let at = system.at(r).unwrap();
                let response = at.response(0.0).unwrap();
                let exact = response.harmonic(Of::Mass(mass), 1).unwrap();
                // The tolerance allows one rounding for each of a dozen operations.
                let near = 1e-13 * exact.norm();
                assert!((re - exact.re).abs() < near && (im - exact.im).abs() < near);
                let fixed = Dual {
                    value: r,
                    slope: 0.0,
                };
                let [re, im] = free(along.modal(), mass, fixed, plain).unwrap();
                let zero = Sensitive::fixed(0.0.into());
                let motion = along.at(Sensitive::fixed(r.into())).unwrap();
                let exact = motion.motion(zero).unwrap();
                let exact = exact.mass_at(mass).unwrap().harmonic(1);
                let near = 1e-12 * exact.re.slope.to_f64().hypot(exact.im.slope.to_f64());
                assert!((re.slope - exact.re.slope.to_f64()).abs() <= near);
                assert!((im.slope - exact.im.slope.to_f64()).abs() <= near);
            }
        }
    }
}
