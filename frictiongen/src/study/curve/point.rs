//! A point of a curve.

use super::request::CurveRequest;
use crate::study::response::{Size, Swing, SystemResponse};
use crate::study::units::reversed_phase;
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
    /// Whether it is one of a continuum of steady states.
    pub marginal: bool,
    /// Whether motion from rest ends in it; false for another state, where motion from rest does not settle.
    pub from_rest: bool,
    /// The middle of the contact's motion, over P/k₁, for base motion over Y.
    pub offset: f64,
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
    /// Half the distance between the least and the largest x̄, over P/k₁, for base motion over Y: the amplitude of a motion
    /// off its centre about its own middle.
    pub centred: f64,
    /// The lag of the fundamental component behind the excitation, rad, in (−π, π]; none for what does not move.
    pub fundamental_phase: Option<f64>,
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
        request: &CurveRequest,
    ) -> Option<Self> {
        let movements = request.of.iter();
        let movements = movements
            .map(|of| Movement::of(response, *of, request))
            .collect::<Option<_>>()?;
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
            marginal: response.is_marginal(),
            from_rest: response.is_from_rest(),
            offset: response.offset(),
            movements,
            contact_force: response.contact_force(),
            friction_work: response.friction_work(),
        })
    }
}

impl Movement {
    fn of(response: &SystemResponse<'_>, of: Of, request: &CurveRequest) -> Option<Self> {
        let both = || {
            let velocity = response.largest(of, Size::Velocity)?;
            Some((velocity, response.largest(of, Size::Acceleration)?))
        };
        let harmonics = request.harmonics.iter();
        let movement = Self {
            swing: response.swing(of)?,
            centred: response.centred_amplitude(of)?,
            fundamental_phase: response.fundamental_phase(of),
            rates: if request.rates { both() } else { None },
            harmonics: harmonics
                .map(|n| response.harmonic(of, *n))
                .collect::<Option<_>>()?,
        };
        let turned = request.turned && of == Of::Contact;
        Some(if turned {
            movement.turned(response)
        } else {
            movement
        })
    }

    /// The contact's motion with the opposite sign.
    fn turned(mut self, response: &SystemResponse<'_>) -> Self {
        self.swing.phase = response.reversed_contact_phase();
        self.fundamental_phase = self.fundamental_phase.map(reversed_phase);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
        self
    }
}
