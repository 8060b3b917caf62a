//! The initial state from which motions to a steady state start.

use super::system::System;
use frictiongen_kernel::Float;

/// Displacements and velocities of all masses at a maximum of the excitation, from which a motion starts.
///
/// Several steady states may exist at one frequency and one friction. By default the answer is the steady state that
/// the motion from rest reaches: every mass is at x = 0 without velocity, and a moving base is at Y. If the contact
/// never slides in this state, the contact may rest at any place within an interval. The answer is then the state in the
/// middle of the interval, without a constant force in the contact. Amplitudes, forces, energies, optima and pictures
/// belong to this state. The offset of the contact says where the motion from rest leaves it.
///
/// A system that [starts from](System::starting_from) an initial state answers with the state that is reached from
/// there. A contact that never slides then stays where the motion leaves it.
///
/// ```
/// use frictiongen::study::InitialState;
/// use frictiongen::{Of, System};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let block: System = "struct Block {
///     masses: { block: 1 },
///     springs: { base - block: 1 },
///     contact: block - base,
///     excitation: base,
/// }"
/// .parse()?;
/// let amplitude = |system: &System| -> Result<_, Box<dyn std::error::Error>> {
///     let response = system.at(0.5)?.response(2.0)?;
///     Ok((response.swing(Of::Mass(0)).ok_or("no mass")?.amplitude, response.offset()))
/// };
/// // The block moves with the base. From rest, it keeps its initial distance −Y from the base.
/// assert_eq!(amplitude(&block)?, (1.0, -1.0));
/// assert_eq!(amplitude(&block.starting_from(InitialState::rest(1)))?, (2.0, -1.0));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct InitialState {
    displacements: Vec<f64>,
    velocities: Vec<f64>,
    /// Frequency ratio r of the groups, and exponent n of the load, whose amplitude is proportional to r⁻ⁿ. `None` if
    /// the groups are the same at every frequency ratio.
    units: Option<(f64, i32)>,
}

impl InitialState {
    /// Returns the state of rest for a number of masses: every mass is at x = 0 without velocity.
    #[must_use]
    pub fn rest(masses: usize) -> Self {
        Self::groups((vec![0.0; masses], vec![0.0; masses]))
    }

    /// Returns an initial state of non-dimensional groups: x̄ and dx̄/dτ of every mass. The groups are the same at every
    /// frequency.
    #[must_use]
    pub fn groups((displacements, velocities): (Vec<f64>, Vec<f64>)) -> Self {
        Self {
            displacements,
            velocities,
            units: None,
        }
    }

    /// Returns an initial state with the same displacements and velocities in m and m/s at every frequency. The groups
    /// x̄ and dx̄/dτ are those at the frequency ratio r. The amplitude of the load is proportional to r⁻ⁿ with n = `fall`.
    #[must_use]
    pub fn at_ratio(groups: (Vec<f64>, Vec<f64>), r: f64, fall: i32) -> Self {
        Self {
            units: Some((r, fall)),
            ..Self::groups(groups)
        }
    }

    /// Returns x̄ and dx̄/dτ of every mass at the frequency ratio r.
    #[must_use]
    pub fn at<S: Float>(&self, r: S) -> (Vec<S>, Vec<S>) {
        let (length, rate) = self.units.map_or((1.0, 1.0), |(own, fall)| {
            let ratio = r.to_f64() / own;
            (ratio.powi(fall), ratio.powi(fall - 1))
        });
        let scaled = |values: &[f64], factor: f64| {
            let values = values.iter();
            values.map(|value| S::constant(value * factor)).collect()
        };
        (
            scaled(&self.displacements, length),
            scaled(&self.velocities, rate),
        )
    }

    /// Returns the same state for a scene whose groups have other units: the new unit of displacement divided by the
    /// present one, and the new unit of frequency divided by the present one.
    pub(super) fn in_units(&self, length: f64, frequency: f64) -> Self {
        let rate = match self.units {
            Some(_) => length * frequency,
            None => length,
        };
        let all = |values: &[f64], unit: f64| values.iter().map(|value| value / unit).collect();
        Self {
            displacements: all(&self.displacements, length),
            velocities: all(&self.velocities, rate),
            units: self.units,
        }
    }
}

impl<S> System<S> {
    /// Returns this system with an initial state. Its orbits, states, responses, curves, maps and optima are those that
    /// the motion from this state reaches ([`InitialState`]). In the continuous regime with μ = 1, no answer depends on
    /// the initial state.
    ///
    /// Each solver checks the state. It fails unless the state has one finite displacement and one finite velocity for
    /// each mass.
    #[must_use]
    pub fn starting_from(mut self, start: InitialState) -> Self {
        self.start = Some(start);
        self
    }
}
