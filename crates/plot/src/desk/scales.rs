//! Units of the axes of a figure: non-dimensional groups or physical units.

use crate::{Axis, Label};
use frictiongen::study::{response::MotionQuantity, scene::Excitation, units::LoadScale};
use frictiongen::{Of, System};

/// Smallest value at the lower end of a logarithmic amplitude axis, as a fraction of the value at the upper end.
const DECADES: f64 = 1e-6;
/// Margin of a logarithmic amplitude axis, as a factor. The upper end is the largest value times this factor. The lower
/// end is the smallest value divided by this factor.
const LOG_ROOM: f64 = 1.2;

/// Units in which a figure shows frequencies, frictions, displacements and times: the non-dimensional groups, or
/// physical units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// Frequency in Hz at the frequency ratio r = 1. `None` if the figure shows r.
    hertz: Option<f64>,
    /// Units of force and displacement for a given load. `None` if the figure shows non-dimensional groups.
    load: Option<LoadScale>,
    base_motion: bool,
    /// Angular frequency at the frequency ratio r = 1, in rad/s.
    reference: f64,
    /// Exponent n of the load: its amplitude is proportional to r⁻ⁿ. For a load of constant amplitude n is 0.
    fall: i32,
    /// True if the amplitudes of the figure are forces, such as those of a spring.
    force: bool,
    /// Angular frequency ω of the motion in rad/s, which converts τ to seconds. `None` if the figure shows τ = ωt.
    omega: Option<f64>,
    /// True for a logarithmic frequency axis.
    log_frequency: bool,
    /// True for logarithmic axes of amplitudes.
    log_amplitude: bool,
}

impl Scales {
    /// Creates the units of a figure in non-dimensional groups: frequency ratio r, friction ratio β and displacement
    /// x̄.
    #[must_use]
    pub fn groups(system: &System) -> Self {
        Self {
            hertz: None,
            load: None,
            omega: None,
            fall: 0,
            force: false,
            log_frequency: false,
            log_amplitude: false,
            reference: system.angular_frequency(1.0),
            base_motion: system.scene().excitation == Excitation::Base,
        }
    }

    /// Returns a copy of these units, but with frequencies in Hz.
    #[must_use]
    pub fn in_hertz(self, system: &System) -> Self {
        Self {
            hertz: Some(system.hertz(1.0)),
            ..self
        }
    }

    /// Returns a copy of these units, but with forces in N and displacements in mm, under the given load.
    #[must_use]
    pub fn under(self, load: LoadScale) -> Self {
        Self {
            load: Some(load),
            ..self
        }
    }

    /// Returns a copy of these units for a load whose amplitude is proportional to r⁻ⁿ, where n is `fall`.
    /// [`under`](Self::under) sets the amplitude at r = 1. Without this call the load has a constant amplitude (n = 0).
    #[must_use]
    pub fn falling(self, fall: i32) -> Self {
        Self { fall, ..self }
    }

    /// Converts the non-dimensional amplitude `ratio` at the frequency ratio r to the unit of the amplitude axis.
    #[must_use]
    pub fn length_at(&self, r: f64, ratio: f64) -> f64 {
        self.length(ratio * self.unit_at(r))
    }

    /// Returns the amplitude of the load at the frequency ratio r, divided by the amplitude of the load at r = 1.
    /// Returns 1 in non-dimensional groups.
    fn unit_at(&self, r: f64) -> f64 {
        match self.load {
            Some(_) => r.powi(-self.fall),
            None => 1.0,
        }
    }

    /// Returns a copy of these units, but with times in seconds. `omega` is the angular frequency of the motion in
    /// rad/s.
    #[must_use]
    pub fn at(self, omega: f64) -> Self {
        Self {
            omega: Some(omega),
            ..self
        }
    }

    /// Returns a copy of these units for the amplitudes of the motion `of`. The amplitudes of a spring and of the base
    /// shear are forces.
    #[must_use]
    pub fn showing(self, of: Of) -> Self {
        Self {
            force: of.is_force(),
            ..self
        }
    }

    /// Returns a copy of these units with other scales of the axes. If `frequency` is true, the frequency axis is
    /// logarithmic. If `amplitude` is true, the amplitude axes are logarithmic.
    #[must_use]
    pub fn with_log(self, frequency: bool, amplitude: bool) -> Self {
        Self {
            log_frequency: frequency,
            log_amplitude: amplitude,
            ..self
        }
    }

    /// Returns the frequency axis from `low` to `high`, which are in the unit of the axis.
    #[must_use]
    pub fn frequency_axis(&self, low: f64, high: f64) -> Axis {
        let label = self.frequency_label();
        match self.log_frequency {
            true => Axis::log(label, low, high),
            // If the smallest frequency is less than a fourth of the largest, a linear axis begins at 0.
            false => Axis::new(label, if low < 0.25 * high { 0.0 } else { low }, high),
        }
    }

    /// Returns an axis of amplitudes up to `high`. A linear axis begins at 0. A logarithmic axis begins just below the
    /// smallest positive value, but at most about six decades below `high`.
    #[must_use]
    pub fn amplitude_axis(
        &self,
        label: Label,
        high: f64,
        values: impl Iterator<Item = f64>,
    ) -> Axis {
        if !self.log_amplitude {
            return Axis::new(label, 0.0, high);
        }
        let positive = values.filter(|value| 0.0 < *value);
        let least = positive.fold(high, f64::min).max(DECADES * high);
        Axis::log(label, least / LOG_ROOM, high * LOG_ROOM)
    }

    /// Returns true if the figure shows forces in N and displacements in mm.
    #[must_use]
    pub fn in_newtons(&self) -> bool {
        self.load.is_some()
    }

    /// Returns true if the figure shows times in seconds.
    #[must_use]
    pub fn in_seconds(&self) -> bool {
        self.omega.is_some()
    }

    /// Converts the phase τ = ωt of the excitation to the unit of the time axis.
    #[must_use]
    pub fn time(&self, tau: f64) -> f64 {
        self.omega.map_or(tau, |omega| tau / omega)
    }

    /// Returns the label of the time axis.
    #[must_use]
    pub fn time_label(&self) -> Label {
        match self.omega {
            Some(_) => "time (s)".into(),
            None => "*τ* = *ωt*".into(),
        }
    }

    /// Converts a velocity, the derivative of x̄ with respect to τ, to the unit of the velocity axis.
    #[must_use]
    pub fn rate(&self, slope: f64) -> f64 {
        self.omega.map_or(slope, |omega| slope * omega)
    }

    /// Returns the label of a velocity axis: mm/s, or the derivative of x̄ with respect to τ.
    #[must_use]
    pub fn rate_label(&self) -> Label {
        match (self.load, self.omega) {
            (Some(_), Some(_)) => "velocity (mm/s)".into(),
            _ => "d*x̄*/d*τ*".into(),
        }
    }

    /// Converts an order to the unit of the axis of a spectrum: Hz, or the order itself. An order is a frequency
    /// divided by the frequency of the excitation.
    #[must_use]
    pub fn order(&self, order: f64) -> f64 {
        self.omega
            .map_or(order, |omega| order * omega / std::f64::consts::TAU)
    }

    /// Returns the label of the frequency axis of a spectrum.
    #[must_use]
    pub fn order_label(&self) -> Label {
        match self.omega {
            Some(_) => "frequency (Hz)".into(),
            None => "order of the excitation's frequency".into(),
        }
    }

    /// Returns the label of an axis of displacements over time.
    #[must_use]
    pub fn displacement_label(&self) -> Label {
        match (self.load, self.base_motion) {
            (Some(_), _) => "displacement (mm)".into(),
            (None, true) => "displacement over *Y*".into(),
            (None, false) => "displacement over *P*/*k*_1".into(),
        }
    }

    /// Returns the label of an axis of spring forces over time.
    #[must_use]
    pub fn force_label(&self) -> Label {
        match (self.load, self.base_motion) {
            (Some(_), _) => "force (N)".into(),
            (None, true) => "force over *k*_1*Y*".into(),
            (None, false) => "force over *P*".into(),
        }
    }

    /// Converts the frequency ratio r to the unit of the frequency axis: Hz, or the ratio itself.
    #[must_use]
    pub fn frequency(&self, r: f64) -> f64 {
        self.hertz.map_or(r, |hertz| r * hertz)
    }

    /// Returns the label of the frequency axis.
    #[must_use]
    pub fn frequency_label(&self) -> Label {
        match self.hertz {
            Some(_) => "frequency (Hz)".into(),
            None => "frequency ratio *r*".into(),
        }
    }

    /// Converts the friction ratio β to the unit of the friction axis: N, or the ratio itself.
    #[must_use]
    pub fn friction(&self, beta: f64) -> f64 {
        self.load.map_or(beta, |load| load.friction(beta))
    }

    /// Returns the label of the friction axis.
    #[must_use]
    pub fn friction_label(&self) -> Label {
        match self.load {
            Some(_) => "friction force *F* (N)".into(),
            None => "friction ratio *β*".into(),
        }
    }

    /// Returns the text for a friction ratio in the legend: for example `β = 0.3`, or the friction force in N.
    #[must_use]
    pub fn friction_name(&self, beta: f64) -> Label {
        self.swept_name(beta, "")
    }

    /// Returns the legend name of a friction ratio, followed by the text `what`, such as `, swept up`.
    #[must_use]
    pub fn swept_name(&self, beta: f64, what: &str) -> Label {
        let value = short(self.friction(beta));
        match self.load {
            Some(_) => format!("*F* = {value} N{what}").into(),
            None => format!("*β* = {value}{what}").into(),
        }
    }

    /// Returns the legend name of a limit: F_lim in newtons, or β_lim as a ratio. `mark` follows the symbol, and
    /// `what` explains the limit.
    #[must_use]
    pub(super) fn limit_name(&self, mark: &str, what: &str) -> Label {
        let symbol = if self.load.is_some() { "F" } else { "β" };
        format!("*{symbol}*_lim{mark}, {what}").into()
    }

    /// Converts the non-dimensional displacement or force `ratio` to the unit of its axis. With a load this unit is mm
    /// or N. Without a load the function returns `ratio` unchanged.
    #[must_use]
    pub fn length(&self, ratio: f64) -> f64 {
        if self.force {
            return self.friction(ratio);
        }
        self.load
            .map_or(ratio, |load| load.displacement(ratio) * 1e3)
    }

    /// Converts the value `ratio` of a [`MotionQuantity`] at the frequency ratio r to the unit of its axis. In
    /// non-dimensional groups the function returns `ratio` unchanged.
    #[must_use]
    pub fn rate_at(&self, size: MotionQuantity, r: f64, ratio: f64) -> f64 {
        let Some(load) = self.load else {
            return ratio;
        };
        let omega = r * self.reference;
        let value = ratio * self.unit_at(r);
        let displacement = load.displacement(value);
        match size {
            MotionQuantity::Displacement => displacement * 1e3,
            MotionQuantity::Velocity => displacement * omega * 1e3,
            MotionQuantity::Acceleration => displacement * omega * omega,
            MotionQuantity::Force => load.friction(value),
            MotionQuantity::Energy => load.displacement(load.friction(value)) * self.unit_at(r),
            MotionQuantity::Damping => ratio,
        }
    }

    /// Returns the label of an axis for the values of a [`MotionQuantity`], such as largest velocities.
    #[must_use]
    pub fn size_label(&self, size: MotionQuantity) -> Label {
        match (size, self.load) {
            (MotionQuantity::Displacement, _) => self.length_label(),
            (MotionQuantity::Velocity, Some(_)) => "velocity amplitude (mm/s)".into(),
            (MotionQuantity::Velocity, None) => "amplitude of d*x̄*/d*τ*".into(),
            (MotionQuantity::Acceleration, Some(_)) => "acceleration amplitude (m/s²)".into(),
            (MotionQuantity::Acceleration, None) => "amplitude of d²*x̄*/d*τ*²".into(),
            (MotionQuantity::Force, Some(_)) => "force of the contact (N)".into(),
            (MotionQuantity::Force, None) if self.base_motion => {
                "force of the contact over *k*_1*Y*".into()
            }
            (MotionQuantity::Force, None) => "force of the contact over *P*".into(),
            (MotionQuantity::Damping, _) => "equivalent damping ratio *ζ*_eq".into(),
            (MotionQuantity::Energy, Some(_)) => "energy in a cycle (J)".into(),
            (MotionQuantity::Energy, None) if self.base_motion => {
                "energy in a cycle over *k*_1*Y*²".into()
            }
            (MotionQuantity::Energy, None) => "energy in a cycle over *P*²/*k*_1".into(),
        }
    }

    /// Returns the label of an amplitude axis.
    #[must_use]
    pub fn length_label(&self) -> Label {
        self.length_text().into()
    }

    /// Returns the label of an amplitude axis as text in the markup of [`Label`].
    pub(super) fn length_text(&self) -> &'static str {
        match (self.load, self.base_motion, self.force) {
            (Some(_), _, false) => "amplitude (mm)",
            (None, true, false) => "amplitude over *Y*",
            (None, false, false) => "amplitude over *P*/*k*_1",
            (Some(_), _, true) => "force amplitude (N)",
            (None, true, true) => "force amplitude over *k*_1*Y*",
            (None, false, true) => "force amplitude over *P*",
        }
    }
}

/// Formats a number for a legend, with four digits and without trailing zeros.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let decimals = (3.0 - value.abs().log10().floor()).clamp(0.0, 12.0) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}
