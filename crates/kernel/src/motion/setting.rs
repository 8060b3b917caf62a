//! A *setting*: a scene at one frequency ratio and one friction ratio. All segments of a motion use the same setting.

use super::contact::{ContactChain, Law};
use super::dynamics::Dynamics;
use super::oscillator::Part;
use crate::contact::regime::{check_beta, check_ratio};
use crate::contact::sums::Chain;
use crate::errors::{Given, OutOfDomain, Slice};
use crate::number::scalar::Float;

/// A scene at one frequency ratio and one friction ratio.
#[derive(Clone, Copy, Debug)]
pub struct MotionSetting<'a, S, K = Chain<S>> {
    pub(crate) dynamics: Dynamics<'a, S, K>,
    /// Frequency ratio r, within the range in which the code can evaluate the formulas.
    pub(crate) r: S,
    /// Friction ratio β = F/P of the motion.
    pub(crate) beta: S,
    /// Coefficient s of the base motion in the relative displacement z̄ of the contact: 1 if the contact rubs on the
    /// moving base, otherwise 0.
    pub(crate) base: S,
    /// wᵀΓ⁻¹p + s r²: the load on the stuck contact at a maximum of the excitation, times the inverse effective mass
    /// m*. w is the direction vector of the contact, Γ is the mass matrix divided by m₁, p is the load vector, and s is
    /// the field `base`.
    pub(crate) load: S,
    /// Load on the stuck contact in quadrature (90° out of phase) with the base's motion, times the inverse effective
    /// mass m*. The load contains the term −`quadrature`·sin τ_e. `quadrature` is 0 unless damping acts relative to
    /// the moving base.
    pub(crate) quadrature: S,
    /// Displacement of the contact per unit of steady contact force: wᵀK̄⁻¹w = Σ c_i/λ_i with c_i = (φ_iᵀw)², plus the
    /// compliance of an elastic contact. K̄ is the stiffness matrix divided by k₁, and w is the direction vector of
    /// the contact. φ_i is a mode shape, and λ_i its squared frequency ratio.
    pub(crate) receptance: S,
    /// Σ 2ζ_i c_i/σ_i divided by `receptance`, with c_i = (φ_iᵀw)². φ_i is a mode shape, σ_i its natural frequency as a
    /// frequency ratio, and w the direction vector of the contact. `drag` is the damping force per unit of velocity of
    /// the stuck contact, times the inverse effective mass m*.
    pub(crate) drag: S,
}

impl<'a, S: Copy, K> MotionSetting<'a, S, K> {
    /// Returns this setting with other constants of the chain.
    pub(crate) fn with<J>(&self, chain: J) -> MotionSetting<'a, S, J> {
        MotionSetting {
            dynamics: self.dynamics.with(chain),
            r: self.r,
            beta: self.beta,
            base: self.base,
            load: self.load,
            quadrature: self.quadrature,
            receptance: self.receptance,
            drag: self.drag,
        }
    }
}

impl<'a, S: Float, K: ContactChain<S>> MotionSetting<'a, S, K> {
    /// Creates a setting, which is a scene at the frequency ratio r and the friction ratio β. Writes the oscillators
    /// to `parts`: first one for each mode of the chain, and then one for each mode of the stuck chain (the chain with
    /// its contact stuck).
    ///
    /// # Errors
    /// [`OutOfDomain`] if r is NaN, negative, zero or infinite, or so near to 0 or ∞ that the formulas would overflow
    /// or underflow. [`OutOfDomain`] also if β or μβ is NaN, negative or infinite, or if `parts` has the wrong length.
    pub fn new(
        dynamics: Dynamics<'a, S, K>,
        r: S,
        beta: S,
        parts: &mut [Part<S>],
    ) -> Result<Self, OutOfDomain> {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        if parts.len() != dynamics.oscillators() {
            return Err(OutOfDomain::Length(Slice::Oscillators));
        }
        let r = check_ratio(r)?;
        let (low, high) = S::inverse_ratio_range();
        let inverse = one / r;
        if !(low < inverse && inverse < high) {
            return Err(OutOfDomain::FrequencyRatioInTime(Given::of(r)));
        }
        let beta = check_beta(beta)?;
        check_beta(dynamics.chain.law(beta).grip())?;
        let base = if dynamics.chain().on_moving_base.is_some() {
            one
        } else {
            zero
        };
        let compliance = dynamics.chain.compliance();
        let mut receptance = dynamics.receptance();
        // For a rigid contact the compiler removes this branch. Without the branch, the compiler would keep an addition
        // of 0.
        if !compliance.is_zero() {
            receptance = receptance + compliance;
        }
        let (mut load, mut drag) = (base * r * r, zero);
        for mode in dynamics.driven() {
            load = load + mode.residue;
            drag = drag + (mode.zeta + mode.zeta) * mode.contact_squared / mode.resonance;
        }
        let quadratures = dynamics.driven().iter().zip(dynamics.quadratures());
        let quadrature = quadratures.fold(zero, |sum, (mode, [load, _])| {
            sum + mode.contact * (*load * (r / mode.resonance))
        });
        let setting = Self {
            dynamics,
            r,
            beta,
            base,
            load,
            quadrature,
            receptance,
            drag: drag / receptance,
        };
        setting.fill(parts);
        Ok(setting)
    }

    fn fill(&self, parts: &mut [Part<S>]) {
        let (modes, stuck_modes) = self.split(parts);
        for (index, (part, mode)) in modes.iter_mut().zip(self.dynamics.modes).enumerate() {
            *part = Part::from_mode(mode, self.dynamics.load(index, self.r), self.r);
        }
        for (part, (mode, participations)) in stuck_modes.iter_mut().zip(self.dynamics.held_modes())
        {
            let drive = self.dynamics.stuck_drive(
                (mode, participations),
                (self.base, self.r),
                self.receptance,
            );
            *part = Part::from_stuck_mode(mode, self.r, drive);
        }
    }

    /// Multiplies the load by `load`, and the friction and the state of the oscillators by `factor`. All equations of
    /// the motion are linear in these three.
    pub(crate) fn scale(&mut self, parts: &mut [Part<S>], factor: S, load: S) {
        self.beta = self.beta * factor;
        self.base = self.base * load;
        self.load = self.load * load;
        self.quadrature = self.quadrature * load;
        for part in parts {
            part.scale(factor, load);
        }
    }

    /// Splits `parts` into two slices: the oscillators of the chain's modes, and the oscillators of the modes of the
    /// chain with its contact stuck.
    pub(crate) fn split<'p>(
        &self,
        parts: &'p mut [Part<S>],
    ) -> (&'p mut [Part<S>], &'p mut [Part<S>]) {
        let modes = self.dynamics.modes.len().min(parts.len());
        let (modes, rest) = parts.split_at_mut(modes);
        let stuck = self.dynamics.held.len().min(rest.len());
        (modes, rest.split_at_mut(stuck).0)
    }

    /// Returns an error unless the state has a finite displacement and a finite velocity for each mass.
    pub(crate) fn check_state(&self, (x, v): (&[S], &[S])) -> Result<(), OutOfDomain> {
        // The number of masses equals the number of modes.
        let masses = self.dynamics.modes.len();
        let sound =
            |values: &[S]| values.len() == masses && values.iter().all(|value| value.is_finite());
        if sound(x) && sound(v) {
            Ok(())
        } else {
            Err(OutOfDomain::State)
        }
    }

    /// Sets the state of the modes from displacements and velocities of the masses.
    pub(crate) fn load_state(&self, displacements: &[S], velocities: &[S], parts: &mut [Part<S>]) {
        let masses = displacements.len().max(1);
        let weights = self.dynamics.weights.chunks(masses).take(masses);
        for (part, weights) in parts.iter_mut().zip(weights) {
            let product = |values: &[S]| {
                let terms = weights.iter().zip(values);
                terms.fold(S::constant(0.0), |sum, (weight, value)| {
                    sum + *weight * *value
                })
            };
            part.y = product(displacements);
            part.u = product(velocities) / part.x;
        }
    }

    /// Returns the relative displacement z̄ of the contact, from the oscillators of the modes.
    pub(crate) fn relative(&self, parts: &[Part<S>], (_, cosine): (S, S)) -> S {
        let modes = self.dynamics.driven().iter().zip(parts);
        modes.fold(-(self.base * cosine), |sum, (mode, part)| {
            sum + mode.contact * part.y
        })
    }

    /// Returns the relative velocity z̄′ of the contact, and the sum of the absolute values of its terms.
    pub(crate) fn relative_velocity(&self, parts: &[Part<S>], (sine, _): (S, S)) -> (S, S) {
        let own = self.base * sine;
        let modes = self.dynamics.driven().iter().zip(parts);
        modes.fold((own, own.abs()), |(sum, size), (mode, part)| {
            let term = mode.contact * part.x * part.u;
            (sum + term, size + term.abs())
        })
    }

    /// Returns the contact force, divided by P, that would keep the relative velocity constant.
    pub(crate) fn holding(&self, parts: &[Part<S>], (sine, cosine): (S, S)) -> S {
        let two = S::constant(2.0);
        let mut load = self.load * cosine;
        if !self.quadrature.vanishes() {
            load = load - self.quadrature * sine;
        }
        let modes = self.dynamics.driven().iter().zip(parts);
        let sum = modes.fold(load, |sum, (mode, part)| {
            let lambda = mode.resonance * mode.resonance;
            sum - mode.contact * lambda * (part.y + two * mode.zeta * part.u)
        });
        sum / self.dynamics.chain().inverse_mass
    }

    /// Returns the relative acceleration z̄″. `excess` is the force that would keep the relative velocity constant,
    /// minus the contact force.
    pub(crate) fn acceleration(&self, excess: S) -> S {
        self.dynamics.chain().inverse_mass * excess / (self.r * self.r)
    }
}
