//! A point of a curve.

use crate::study::response::{Size, Swing, SystemResponse};
use crate::{Complex, Of, Regime};

/// The response at one frequency ratio.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    /// r.
    pub r: f64,
    /// The regime.
    pub regime: Regime,
    /// How often the contact stops in a period.
    pub stops: usize,
    /// After how many cycles of the excitation the motion repeats.
    pub period: u32,
    /// Whether it repeats; otherwise the values are of its last 64 cycles.
    pub settled: bool,
    /// The motions asked for, in their order.
    pub movements: Vec<Movement>,
    /// The largest friction force over P, for base motion over k₁Y.
    pub contact_force: f64,
    /// The work that friction takes out of a cycle, over P²/k₁, for base motion over k₁Y².
    pub friction_work: f64,
}

/// How the contact or a mass moves.
#[derive(Clone, Debug, PartialEq)]
pub struct Movement {
    /// Amplitude and phase.
    pub swing: Swing,
    /// The largest |dx̄/dτ| and |d²x̄/dτ²|, if they were asked for.
    pub rates: Option<(f64, f64)>,
    /// The harmonics asked for, in their order.
    pub harmonics: Vec<Complex<f64>>,
}

impl CurvePoint {
    /// What a response says; none where it lacks what is asked.
    pub(super) fn of(
        r: f64,
        response: &SystemResponse<'_>,
        of: &[Of],
        harmonics: &[u32],
        rates: bool,
    ) -> Option<Self> {
        let movement = |of: &Of| {
            let all = harmonics.iter();
            let both = || {
                let velocity = response.largest(*of, Size::Velocity)?;
                Some((velocity, response.largest(*of, Size::Acceleration)?))
            };
            Some(Movement {
                swing: response.swing(*of)?,
                rates: if rates { both() } else { None },
                harmonics: all
                    .map(|n| response.harmonic(*of, *n))
                    .collect::<Option<_>>()?,
            })
        };
        let (stops, period) = match response {
            SystemResponse::StickSlip(orbit) => (orbit.stops(), orbit.period()),
            _ => (0, 1),
        };
        Some(Self {
            r,
            regime: response.regime(),
            stops,
            period,
            settled: response.is_settled(),
            movements: of.iter().map(movement).collect::<Option<_>>()?,
            contact_force: response.contact_force(),
            friction_work: response.friction_work(),
        })
    }
}
