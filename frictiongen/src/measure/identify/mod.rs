//! The friction force from a response (thesis 4.5, 6.4.2), with what else is not known.

mod data;
mod explained;
mod friction;
mod model;
mod several;

use super::statistics::excess;
use super::{MeasureError, Measured};
use crate::study::scene::Excitation;
use crate::study::{Load, Quantity, System};
use crate::{Complex, Regime};

/// What was measured at one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// The driving frequency, Hz.
    pub hertz: f64,
    /// The load with its measured amplitude.
    pub load: Load,
    /// The standard deviation of that amplitude.
    pub load_deviation: f64,
    /// The motions.
    pub motions: Vec<Datum>,
}

/// A harmonic of a mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Datum {
    /// The mass, by its place.
    pub mass: usize,
    /// n.
    pub harmonic: u32,
    /// X_n over the amplitude of the load (m/m or m/N), with τ = 0 at a maximum of the load.
    pub value: Complex<f64>,
    /// The standard deviation of its real part, and of its imaginary one, as far as the mass's own channel has it.
    pub deviation: f64,
}

impl Observation {
    /// Of the steady part of a recording: the fundamental of each mass, and the odd harmonics up to `harmonics`.
    #[must_use]
    pub fn of(measured: &Measured, system: &System, harmonics: u32) -> Self {
        let amplitude = measured.drive_amplitude();
        let load = match system.scene().excitation {
            Excitation::Base => Load::Base(amplitude),
            Excitation::Force(_) => Load::Force(amplitude),
        };
        let orders = (1..=harmonics.max(1)).step_by(2);
        let motions = orders.flat_map(|harmonic| {
            measured.masses.iter().filter_map(move |(mass, tone)| {
                Some(Datum {
                    mass: *mass,
                    harmonic,
                    value: measured.harmonic(*mass, harmonic)?,
                    deviation: tone.deviation / amplitude,
                })
            })
        });
        Self {
            hertz: measured.hertz,
            load,
            load_deviation: measured.drive.deviation,
            motions: motions.collect(),
        }
    }
}

/// What of a motion is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Using {
    /// Amplitude and phase.
    #[default]
    Complex,
    /// The amplitude alone.
    Amplitude,
    /// The phase alone, of motions of a likely size.
    Phase,
    /// The phase alone, of motions whose size was not measured: of [`Datum::value`] only the direction counts.
    PhaseAlone,
}

impl Using {
    /// Whether phases are compared, and nothing else.
    pub(super) fn is_phase(self) -> bool {
        matches!(self, Self::Phase | Self::PhaseAlone)
    }
}

/// What is looked for beside the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unknown {
    /// μ, which shows where the contact stops.
    Stiction,
    /// A factor on all natural frequencies; masses stay.
    Frequencies,
    /// One damping ratio for all modes.
    Damping,
    /// A number of the description.
    Quantity(Quantity),
}

impl Unknown {
    /// Its symbol, with the names of the description.
    #[must_use]
    pub fn symbol(&self, system: &System) -> String {
        match self {
            Self::Stiction => "mu".to_owned(),
            Self::Frequencies => "frequency factor".to_owned(),
            Self::Damping => "zeta".to_owned(),
            Self::Quantity(quantity) => {
                let point = crate::study::OperatingPoint::Groups { r: 1.0, beta: 0.0 };
                crate::study::Parameter::Quantity(*quantity).symbol(system.scene(), &point)
            }
        }
    }
}

/// What is asked of measurements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IdentifyRequest {
    /// What of each motion is compared.
    pub using: Using,
    /// What is looked for beside the friction force.
    pub unknowns: Vec<Unknown>,
    /// Between which friction forces, N; up to where the contact is stuck at every frequency if this is none.
    pub range: Option<(f64, f64)>,
}

/// A number with its interval of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The best one.
    pub value: f64,
    /// From here.
    pub from: f64,
    /// To here; infinite where every larger one fits as well.
    pub to: f64,
}

impl Estimate {
    /// Whether a number lies within.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        self.from <= value && value <= self.to
    }
}

/// Whether a measurement tells the friction force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// It does.
    Told,
    /// Several forces give this response: see [`Identified::levels`].
    SeveralLevels,
    /// The contact is stuck: any force from the lower end of the interval on gives this response.
    Stuck,
    /// It does not: the response hardly changes with friction there, as at an invariant point, or friction is too small
    /// to stand out of the noise.
    NotTold,
    /// Of amplitudes without phases: friction all but holds the contact, or a unit is wrong by 1000 or a million, as a motion
    /// that many times as large is explained as well.
    AllButStuck,
}

impl Verdict {
    /// In a word or two.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Told => "told",
            Self::SeveralLevels => "several levels",
            Self::Stuck => "stuck",
            Self::NotTold => "not told",
            Self::AllButStuck => "all but stuck",
        }
    }
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Told => "the measurement tells the friction force",
            Self::SeveralLevels => "several friction forces give this response; another frequency, or amplitude and phase together, would tell which",
            Self::Stuck => "the contact is stuck: this tells only the least force that holds it",
            Self::NotTold => "the measurement cannot tell the friction force: the response hardly changes with it here, beside the noise; measure at another frequency or another mass",
            Self::AllButStuck => "the motion is so small that friction all but holds the contact, or a unit is wrong by 1000 or a million: amplitudes alone do not tell which, and phases would",
        })
    }
}

/// One observation as the answer has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// β = F/P, for base motion F/(k₁Y).
    pub beta: f64,
    /// r.
    pub r: f64,
    /// The regime.
    pub regime: Regime,
    /// What the scene does, in the order of the observation's motions.
    pub model: Vec<Complex<f64>>,
}

/// What measurements say.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The friction force F, N.
    pub friction: Estimate,
    /// All forces that explain the measurements as well, with their intervals, ascending; one where it is told.
    pub levels: Vec<Estimate>,
    /// Whether it is told.
    pub verdict: Verdict,
    /// What else was asked, in the order of the request; an infinite interval where it is not told.
    pub unknowns: Vec<(Unknown, Estimate)>,
    /// The sum of squares of the residuals over their deviations, over the degrees of freedom; none where there are none.
    /// Above 1 by more than chance the scene does not explain the measurement, and the intervals are that much wider.
    pub misfit: Option<f64>,
    /// The degrees of freedom: data less unknowns.
    pub freedom: usize,
    /// By how much a relative error of the data may be multiplied, at most, between parameters: the condition of the fit.
    pub condition: f64,
    /// Each observation beside the scene's answer.
    pub explained: Vec<Explained>,
    /// The scene with what was found.
    pub system: System,
}

impl Identified {
    /// Whether what is left is no more than noise, as far as chance can tell.
    #[must_use]
    pub fn is_explained(&self) -> bool {
        excess(self.misfit, self.freedom) == 1.0
    }

    /// Residuals of an observation: measured less computed, over the load.
    #[must_use]
    pub fn residuals(&self, observations: &[Observation], index: usize) -> Vec<Complex<f64>> {
        let (Some(seen), Some(explained)) = (observations.get(index), self.explained.get(index))
        else {
            return Vec::new();
        };
        let pairs = seen.motions.iter().zip(&explained.model);
        pairs.map(|(datum, model)| datum.value - model).collect()
    }
}

impl System {
    /// The friction force that explains measurements, in any regime, with its interval.
    ///
    /// With the friction force alone the sum of squares is looked through over the whole range and the interval is where it
    /// rises by less than χ² allows: two forces with the same response are both found, and a flat one is seen.  With more
    /// unknowns a damped Gauss–Newton follows, with exact sensitivities, and the intervals are those of its covariance.
    ///
    /// The fundamental of one mass gives β directly where the contact slides all the time: |X₁ − V| = 4β|H|/π.  The
    /// two-amplitude method at resonance (Liang and Feeny, J. Vib. Acoust. 126 (2004) 118) is this with observations at two
    /// loads and [`Unknown::Damping`].
    ///
    /// ```
    /// use frictiongen::measure::{Datum, IdentifyRequest, Observation, Verdict};
    /// use frictiongen::study::Load;
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let plate: System = "struct Plate {
    ///     masses: { plate: 2.0 }, springs: { base - plate: 752.0 }, contact: plate - wall, excitation: base,
    /// }"
    /// .parse()?;
    /// // What a base motion of 1.75 mm at 4 Hz makes of it with F = 0.5 N.
    /// let load = Load::Base(1.75e-3);
    /// let at = plate.at(plate.frequency_ratio_at_hertz(4.0))?;
    /// let response = at.response(plate.load_scale(load)?.friction_ratio(0.5))?;
    /// let value = response.harmonic(Of::Mass(0), 1).ok_or("no motion")?;
    /// let datum = Datum { mass: 0, harmonic: 1, value, deviation: 1e-3 };
    /// let seen = Observation { hertz: 4.0, load, load_deviation: 1e-6, motions: vec![datum] };
    /// let found = plate.identify(&[seen], &IdentifyRequest::default())?;
    /// assert_eq!(found.verdict, Verdict::Told);
    /// assert!((found.friction.value - 0.5).abs() < 1e-6 && found.friction.holds(0.5));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`MeasureError`]: no observation, a load that does not fit, fewer data than unknowns, a motion that no friction
    /// explains or that is 1000 times too large, and a fit that does not settle.
    pub fn identify(
        &self,
        observations: &[Observation],
        request: &IdentifyRequest,
    ) -> Result<Identified, MeasureError> {
        let problem = friction::Problem::new(self, observations, request)?;
        let alone = problem.friction()?;
        if request.unknowns.is_empty() {
            alone.checked(&problem)?;
            return alone.answer(&problem);
        }
        several::fit(&problem, &alone, &request.unknowns)
    }
}
