//! A scene's frequencies, masses and springs from sweeps without friction (thesis 4.3.1, 6.4.2, appendix A).

use super::MeasureError;
use super::identify::model::{Along, Direction, answer};
use super::identify::{Datum, Estimate, Observation};
use super::least_squares::{Fit, Linearised, minimise};
use super::recording::Table;
use super::statistics::{NORMAL, excess, student};
use crate::Complex;
use crate::study::scene::{Damping, Excitation};
use crate::study::units::hertz;
use crate::study::{Load, Quantity, System};
use nalgebra::{DMatrix, DVector};

/// A measured amplitude without friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SweepPoint {
    /// The driving frequency, Hz.
    pub hertz: f64,
    /// The mass, by its place.
    pub mass: usize,
    /// |X/Y|, or |X/P| in m/N.
    pub amplitude: f64,
    /// Its standard deviation; without it errors count as equal parts of the amplitudes, as in (6.16).
    pub deviation: Option<f64>,
}

/// What a sweep without friction says.
#[derive(Clone, Debug)]
pub struct SweepFit {
    /// √(k₁/m₁)/2π, Hz: r = f over this; for one storey the natural frequency (4.1).
    pub reference: Estimate,
    /// γ_i = m_i/m₁ of the masses from the second on.
    pub masses: Vec<Estimate>,
    /// κ_e = k_e/k₁ of the springs from the second on.
    pub springs: Vec<Estimate>,
    /// ζ, one for all modes, if it was asked for.
    pub damping: Option<Estimate>,
    /// The natural frequencies, Hz.
    pub natural: Vec<Estimate>,
    /// The sum of squares over the degrees of freedom, where deviations were given.
    pub misfit: Option<f64>,
    /// The root of the mean square of the relative residuals.
    pub scatter: f64,
    /// The condition of the fit.
    pub condition: f64,
    /// Measured less computed amplitude, in the order of the points.
    pub residuals: Vec<f64>,
    /// The scene with what was found; its first mass as it was.
    pub system: System,
}

/// √(k₁/m₁) in rad/s, γ and κ of two storeys from ω₀, ω₁ and ω₂ (6.17 to 6.20).
///
/// ω₀ is the antiresonance of the lower mass, ω₁ and ω₂ are the resonances.  The antiresonance of the motion relative to the
/// base, ω_z0, follows: ω_z0² = ω₁² + ω₂² − (ω₁ω₂/ω₀)², which is where 1 equals (6.15).
///
/// ```
/// let [reference, gamma, kappa] = frictiongen::measure::two_storeys(2.0_f64.sqrt(), 1.0, 2.0);
/// // k₁/m₁ = 2, k₂/m₂ = 2, k₂/m₁ = 5 − 2 − 2.
/// assert!((reference * reference - 2.0).abs() < 1e-15);
/// assert!((gamma - 0.5).abs() < 1e-15 && (kappa - 0.5).abs() < 1e-15);
/// ```
#[must_use]
pub fn two_storeys(antiresonance: f64, first: f64, second: f64) -> [f64; 3] {
    let reference = first * second / antiresonance;
    let relative = first * first + second * second - reference * reference;
    let gamma = relative / (antiresonance * antiresonance) - 1.0;
    let ratio = antiresonance / reference;
    [reference, gamma, gamma * ratio * ratio]
}

/// Frequencies of the scene that are tried as starts, over its own.
const FACTORS: [f64; 2] = [0.5, 2.0];
/// How many of them.
const TRIED: u32 = 40;
/// Ratios of masses and springs that are tried with them, over the scene's own: of two storeys, of three.
const TWO: [f64; 7] = [0.3, 0.5, 0.7, 1.0, 1.4, 2.0, 3.3];
const THREE: [f64; 3] = [0.7, 1.0, 1.4];
/// The best of them, from which a fit starts.
const STARTS: usize = 6;
/// The sum of squares over the degrees of freedom with which a fit from the scene's own values is good enough.
const GOOD: f64 = 2.0;
/// Each parameter times this is tried once more from the best fit, as long as that betters it, so many times at most.
const HOPS: [f64; 4] = [0.97, 0.99, 1.01, 1.03];
const ROUNDS: usize = 4;
const BETTER: f64 = 0.999;
/// A logarithm of amplitudes does not count more than this.
const FAR: f64 = 3.0;
/// A damping ratio to start from where the scene has none.
const SOME_DAMPING: f64 = 0.005;

impl SweepPoint {
    /// Those of a table: `frequency_Hz`, then for each mass `NAME.transmissibility` and, if it is there, `NAME.deviation`.
    /// Other columns are passed over, and so are empty cells.
    ///
    /// # Errors
    /// [`MeasureError`]: a cell that is no number, no frequencies, a mass that the scene does not have, or none.
    pub fn read(text: &str, system: &System) -> Result<Vec<Self>, MeasureError> {
        let table = Table::read(text)?;
        let named = |name: &str| table.names.iter().position(|other| other == name);
        let wrong = |what: String| MeasureError::Sweep { line: 1, what };
        let frequency = named("frequency_Hz")
            .ok_or_else(|| wrong("there is no column `frequency_Hz`".to_owned()))?;
        let mut columns = Vec::new();
        for (place, name) in table.names.iter().enumerate() {
            let Some(mass) = name.strip_suffix(".transmissibility") else {
                continue;
            };
            let known = &system.scene().masses;
            let index = known.iter().position(|other| other.name == mass);
            let index = index.ok_or_else(|| MeasureError::NoSuchPlace {
                channel: mass.to_owned(),
                known: known.iter().map(|mass| mass.name.clone()).collect(),
            })?;
            columns.push((index, place, named(&format!("{mass}.deviation"))));
        }
        if columns.is_empty() {
            return Err(wrong(
                "there is no column `NAME.transmissibility` of a mass".to_owned(),
            ));
        }
        let mut points = Vec::new();
        for (row, line) in table.rows.iter().zip(&table.lines) {
            let cell = |place: usize| row.get(place).copied().flatten();
            for (mass, place, deviation) in &columns {
                let (Some(hertz), Some(amplitude)) = (cell(frequency), cell(*place)) else {
                    continue;
                };
                let deviation = deviation.and_then(cell);
                let fits = 0.0 < hertz
                    && 0.0 < amplitude
                    && deviation.is_none_or(|deviation| 0.0 < deviation);
                if !fits {
                    return Err(MeasureError::Sweep {
                        line: *line,
                        what: "frequencies, transmissibilities and deviations are above 0"
                            .to_owned(),
                    });
                }
                points.push(Self {
                    hertz,
                    mass: *mass,
                    amplitude,
                    deviation,
                });
            }
        }
        Ok(points)
    }
}

/// A sweep beside a scene: parameters are a factor on the frequencies, γ₂ …, κ₂ …, and perhaps ζ.
struct Sweep<'a> {
    system: &'a System,
    points: &'a [SweepPoint],
    seen: Vec<Observation>,
    damping: bool,
}

impl Sweep<'_> {
    fn masses(&self) -> usize {
        self.system.scene().masses.len()
    }

    fn start(&self) -> Vec<f64> {
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
    fn at(&self, parameters: &[f64]) -> Option<System> {
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
    fn values(&self, system: &System) -> Option<Vec<Complex<f64>>> {
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

    fn residuals(&self, parameters: &[f64], form: Form) -> Option<DVector<f64>> {
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

    fn linearise(&self, parameters: &[f64], form: Form) -> Option<Linearised> {
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

    /// Places from which a fit may start, the best first.
    fn starts(&self) -> Vec<Vec<f64>> {
        let own = self.start();
        let [low, high] = FACTORS;
        let factors = (0..=TRIED).map(|i| low * (high / low).powf(f64::from(i) / f64::from(TRIED)));
        let ratios = own.len() - 1 - usize::from(self.damping);
        let each: &[f64] = match ratios {
            0..=2 => &TWO,
            3..=4 => &THREE,
            _ => &[1.0],
        };
        let mut tried: Vec<Vec<f64>> = factors
            .map(|factor| {
                std::iter::once(factor)
                    .chain(own.iter().skip(1).copied())
                    .collect()
            })
            .collect();
        for place in 1..=ratios {
            let others = tried.iter().flat_map(|start| {
                each.iter().map(move |ratio| {
                    let mut start = start.clone();
                    if let Some(value) = start.get_mut(place) {
                        *value *= ratio;
                    }
                    start
                })
            });
            tried = others.collect();
        }
        let mut judged: Vec<(f64, Vec<f64>)> = tried
            .into_iter()
            .filter_map(|start| Some((self.residuals(&start, Form::Log)?.norm_squared(), start)))
            .collect();
        judged.sort_by(|a, b| a.0.total_cmp(&b.0));
        judged
            .into_iter()
            .take(STARTS)
            .map(|(_, start)| start)
            .collect()
    }

    fn fit(&self) -> Result<Fit, MeasureError> {
        let bounds = |start: &[f64]| -> Vec<(f64, f64)> {
            let last = start.len() - 1;
            let bound = |(index, value): (usize, &f64)| {
                if self.damping && index == last {
                    (0.0, 1.0)
                } else {
                    (0.1 * value, 10.0 * value)
                }
            };
            start.iter().enumerate().map(bound).collect()
        };
        let run = |start: &[f64], form: Form| {
            minimise(
                start,
                &bounds(start),
                |at| self.residuals(at, form),
                |at| self.linearise(at, form),
            )
        };
        // Amplitudes have poles, along which a sum of squares has no slope that leads anywhere; their logarithms have.
        let from = |start: &[f64]| {
            let rough = run(start, Form::Log)?;
            run(&rough.parameters, Form::Plain).filter(|fit| fit.settled)
        };
        let own = from(&self.start());
        let freedom = self.points.len() - self.start().len();
        let weighed = self.points.iter().all(|point| point.deviation.is_some());
        let good = |fit: &Fit| weighed && 0 < freedom && fit.squares < GOOD * freedom as f64;
        if own.as_ref().is_some_and(good) {
            return own.ok_or(MeasureError::NoFit);
        }
        let starts = self.starts();
        let fits = starts.iter().filter_map(|start| from(start)).chain(own);
        let best = fits
            .min_by(|a, b| a.squares.total_cmp(&b.squares))
            .ok_or(MeasureError::NoFit)?;
        // An amplitude has no sign: a resonance on the wrong side of a point is a minimum of its own, next to the right one.
        let mut best = best;
        for _ in 0..ROUNDS {
            let places = 0..best.parameters.len();
            let hops = places.flat_map(|place| HOPS.map(|hop| (place, hop)));
            let found = hops.filter_map(|(place, hop)| {
                let mut start = best.parameters.clone();
                *start.get_mut(place)? *= hop;
                run(&start, Form::Plain).filter(|fit| fit.settled)
            });
            let found = found.min_by(|a, b| a.squares.total_cmp(&b.squares));
            match found.filter(|fit| fit.squares < BETTER * best.squares) {
                Some(fit) => best = fit,
                None => break,
            }
        }
        Ok(best)
    }
}

/// How amplitudes are compared.
#[derive(Clone, Copy)]
enum Form {
    Plain,
    Log,
}

impl System {
    /// The scene's frequencies, mass and stiffness ratios from a sweep without friction, by least squares of the amplitudes.
    ///
    /// One storey: f_n (4.1).  Two: r₁/ω, γ and κ, as (6.15) to (6.20) have them.  More alike.  The description says what
    /// is connected to what and where to start from; its first mass stays.  Without `damping` the scene keeps its own.
    ///
    /// ```
    /// use frictiongen::measure::SweepPoint;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let plate: frictiongen::System = "struct Plate {
    ///     masses: { plate: 1.0 }, springs: { base - plate: 300.0 }, contact: plate - wall, excitation: base,
    /// }"
    /// .parse()?;
    /// let point = |hertz: f64| SweepPoint {
    ///     hertz,
    ///     mass: 0,
    ///     amplitude: 1.0 / (1.0 - (hertz / 3.086).powi(2)).abs(),
    ///     deviation: Some(1e-3),
    /// };
    /// let found = plate.fit_sweep(&[1.0, 2.0, 2.8, 3.5, 5.0].map(point), false)?;
    /// assert!((found.reference.value - 3.086).abs() < 1e-9 && found.reference.holds(3.086));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`MeasureError`]: fewer points than unknowns, a scene driven by a force, and a fit that does not settle or leaves
    /// half of the motion unexplained.
    pub fn fit_sweep(
        &self,
        points: &[SweepPoint],
        damping: bool,
    ) -> Result<SweepFit, MeasureError> {
        let scene = self.scene();
        if scene.excitation != Excitation::Base {
            return Err(MeasureError::Asked(
                "a sweep tells parameters of a scene that is driven by its base: a force would ask for the masses themselves",
            ));
        }
        let sweep = Sweep {
            system: self,
            points,
            seen: points.iter().map(observation).collect(),
            damping,
        };
        let unknowns = sweep.start().len();
        if points.len() < unknowns {
            return Err(MeasureError::TooFewData {
                data: points.len(),
                unknowns,
            });
        }
        let fit = sweep.fit()?;
        judged(&sweep, &fit)
    }
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

/// The part of the amplitudes that may be unexplained.
const GROSS: f64 = 0.5;
/// The step of a difference, of a parameter.
const DIFFERENCE: f64 = 1e-6;

fn judged(sweep: &Sweep<'_>, fit: &Fit) -> Result<SweepFit, MeasureError> {
    let system = sweep.at(&fit.parameters).ok_or(MeasureError::NoFit)?;
    let values = sweep.values(&system).ok_or(MeasureError::NoFit)?;
    let pairs = sweep.points.iter().zip(&values);
    let residuals: Vec<f64> = pairs
        .map(|(point, value)| point.amplitude - value.norm())
        .collect();
    let relative = sweep.points.iter().zip(&residuals);
    let relative = relative.map(|(point, residual)| (residual / point.amplitude).powi(2));
    let scatter = (relative.sum::<f64>() / residuals.len() as f64).sqrt();
    if GROSS < scatter
        && let Some((point, value)) = sweep.points.iter().zip(&values).max_by(|a, b| {
            let off = |(point, value): &(&SweepPoint, &Complex<f64>)| {
                (1.0 - value.norm() / point.amplitude).abs()
            };
            off(a).total_cmp(&off(b))
        })
    {
        let mass = sweep.system.scene().masses.get(point.mass);
        return Err(MeasureError::NotExplained {
            mass: mass.map_or_else(String::new, |mass| mass.name.clone()),
            measured: point.amplitude,
            nearest: value.norm(),
        });
    }
    let freedom = residuals.len() - fit.parameters.len();
    let weighed = sweep.points.iter().all(|point| point.deviation.is_some());
    let reduced = (freedom > 0).then(|| fit.squares / freedom as f64);
    let reach = if weighed {
        NORMAL * excess(reduced, freedom).sqrt()
    } else {
        reduced.map_or(f64::INFINITY, |reduced| student(freedom) * reduced.sqrt())
    };
    // The interval of what moves with the parameters as this gradient says.
    let interval = |value: f64, gradient: &DVector<f64>| {
        let variance = fit
            .covariance
            .as_ref()
            .map(|covariance| gradient.dot(&(covariance * gradient)));
        let reach = variance.map_or(f64::INFINITY, |variance| reach * variance.sqrt());
        Estimate {
            value,
            from: (value - reach).max(0.0),
            to: value + reach,
        }
    };
    let own = |index: usize| {
        let mut gradient = DVector::zeros(fit.parameters.len());
        if let Some(entry) = gradient.get_mut(index) {
            *entry = 1.0;
        }
        interval(
            fit.parameters.get(index).copied().unwrap_or(f64::NAN),
            &gradient,
        )
    };
    let (masses, last) = (sweep.masses(), fit.parameters.len() - 1);
    let springs = system.scene().springs.len();
    let factor = own(0);
    let unit = hertz(sweep.system.angular_frequency(1.0));
    let natural = system.natural_frequencies();
    let natural: Vec<Estimate> = natural
        .iter()
        .enumerate()
        .filter_map(|(mode, omega)| {
            Some(interval(
                hertz(*omega),
                &gradient(sweep, fit, mode, *omega)?,
            ))
        })
        .collect();
    Ok(SweepFit {
        reference: Estimate {
            value: factor.value * unit,
            from: factor.from * unit,
            to: factor.to * unit,
        },
        masses: (1..masses).map(own).collect(),
        springs: (1..springs)
            .map(|spring| own(masses + spring - 1))
            .collect(),
        damping: sweep.damping.then(|| own(last)),
        natural,
        misfit: reduced.filter(|_| weighed),
        scatter,
        condition: fit.condition,
        residuals,
        system,
    })
}

/// How a natural frequency in Hz moves with the parameters.
fn gradient(sweep: &Sweep<'_>, fit: &Fit, mode: usize, omega: f64) -> Option<DVector<f64>> {
    let slopes = fit.parameters.iter().enumerate().map(|(index, value)| {
        let step = DIFFERENCE * value.abs().max(DIFFERENCE);
        let mut moved = fit.parameters.clone();
        *moved.get_mut(index)? += step;
        let there = *sweep.at(&moved)?.natural_frequencies().get(mode)?;
        Some(hertz(there - omega) / step)
    });
    Some(DVector::from_vec(slopes.collect::<Option<Vec<f64>>>()?))
}
