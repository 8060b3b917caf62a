//! A point of a curve over frequency.

use super::request::CurveRequest;
use crate::study::response::{MotionQuantity, Swing, SystemResponse};
use crate::study::units::reversed_phase;
use crate::{Complex, Of, Regime};

/// The response at one frequency ratio of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    /// Frequency ratio r = ω√(m₁/k₁) of the excitation.
    pub r: f64,
    /// Regime of the response: continuous, stick-slip or stuck.
    pub regime: Regime,
    /// Number of stops of the contact in one period of the motion.
    pub stops: usize,
    /// Number of cycles of the excitation after which the motion repeats.
    pub period: u32,
    /// True if the motion repeats. If false, the values of this point belong to the last 64 computed cycles.
    pub settled: bool,
    /// True if the steady state belongs to a continuum of steady states, or is the end of a continuum.
    pub marginal: bool,
    /// True if the motion from the requested initial state ends in this state. False if that motion does not settle,
    /// and this state is another steady state.
    pub from_rest: bool,
    /// Offset of the contact, divided by P/k₁ (by Y for base motion), as
    /// [`SystemResponse::offset`](crate::study::response::SystemResponse::offset) defines it.
    pub offset: f64,
    /// The motions that the request lists, in the order of the request.
    pub movements: Vec<Movement>,
    /// The largest friction force in a period, divided by P (by k₁Y for base motion).
    pub contact_force: f64,
    /// The energy that friction dissipates in one cycle of the excitation, divided by P²/k₁ (by k₁Y² for base motion).
    pub friction_work: f64,
}

/// One of the requested motions or spring forces, at one point of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Movement {
    /// Amplitude and phase of the motion: the largest |x̄|, and the lag of this maximum behind the excitation, in rad.
    pub swing: Swing,
    /// Half the distance between the least and the largest x̄. The refinement of a curve compares it where the place of
    /// a stuck contact jumps.
    pub(super) centred: f64,
    /// Lag of the fundamental component behind the excitation, in rad, in (−π, π]. `None` if the contact or mass does
    /// not move.
    pub fundamental_phase: Option<f64>,
    /// Largest |dx̄/dτ| and largest |d²x̄/dτ²| of the motion, present only if `CurveRequest::rates` is true.
    pub rates: Option<(f64, f64)>,
    /// Equivalent viscous damping ratio of the contact. It is present only for the motion of the contact and for
    /// spring forces, and only if `CurveRequest::rates` is true.
    pub damping: Option<f64>,
    /// The harmonics that were requested, in the order of the request.
    pub harmonics: Vec<Complex<f64>>,
}

impl CurvePoint {
    /// Creates the point of a response. Returns `None` if the response does not contain a requested motion.
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
            let velocity = response.largest(of, MotionQuantity::Velocity)?;
            Some((
                velocity,
                response.largest(of, MotionQuantity::Acceleration)?,
            ))
        };
        let harmonics = request.harmonics.iter();
        let movement = Self {
            swing: response.swing(of)?,
            centred: response.centred_amplitude(of)?,
            fundamental_phase: response.fundamental_phase(of),
            rates: if request.rates { both() } else { None },
            damping: if request.rates {
                response.largest(of, MotionQuantity::Damping)
            } else {
                None
            },
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

    /// Returns this motion of the contact with the opposite sign.
    fn turned(mut self, response: &SystemResponse<'_>) -> Self {
        self.swing.phase = response.reversed_contact_phase();
        self.fundamental_phase = self.fundamental_phase.map(reversed_phase);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
        self
    }
}
