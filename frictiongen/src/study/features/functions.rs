//! Functions of y = 1/r whose zeros are features. They consist of V (the contact's motion without friction), H (its
//! response to a harmonic contact force) and U (its velocity at a reversal, in response to a square wave of friction).
//!
//! Every sum in this module is the thesis's sum divided by y² = 1/r², which is a factor of all its terms. Let x = √λ y
//! and d = x² − 1 + 2iζx for a mode with the squared frequency ratio λ. Let w be the contact component of the mode, and
//! p its load. Then V is y² times the sum Σ wp/d over the modes. H has the same form with w² in place of wp. Without
//! damping, U is y² times Σ w² tan(πx/2)/x.

use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::interval::{Arithmetic, Interval};
use frictiongen_model::modal::Modal;

/// Data of one mode in the sums V, H and U over the modes. V, H and U are the responses of the contact to the load, to
/// a harmonic contact force and to a square wave of friction.
#[derive(Clone, Copy, Debug)]
pub(super) struct ModeNumbers<T> {
    pub resonance: T,
    pub zeta: T,
    /// Load φᵀp of the mode, with the mode shape φ and the load vector p.
    pub load: T,
    /// Contact component φᵀw of the mode, with the contact's direction vector w.
    pub contact: T,
    /// Component φ of the mode at the requested mass, or φᵀw for the motion of the contact.
    pub shape: T,
    /// Two numbers for the load that is 90° out of phase with the motion of the base. The first number is 2ζλΓ, with
    /// the participation factor Γ and the squared frequency ratio λ of the mode. The second number is the contribution
    /// of springs to the wall. The two numbers are 0 unless damping acts on velocities relative to the moving base.
    pub quadrature: [T; 2],
}

/// The numbers of a chain and of one requested motion, in one number type.
#[derive(Clone, Debug)]
pub(super) struct ChainNumbers<T> {
    pub modes: Vec<ModeNumbers<T>>,
    /// The static displacement wᵀK̄⁻¹p − 1 of the contact relative to the base. K̄ is the stiffness matrix, p the load
    /// vector, and w the direction vector of the contact. `None` unless the contact slides on the moving base.
    pub on_base: Option<T>,
    /// Inverse effective mass m* of the contact.
    pub inverse_mass: T,
    /// ρ = k₁/k, the compliance of an elastic contact of stiffness k. `None` for a rigid contact.
    pub compliance: Option<T>,
    /// μ, the static friction force divided by the kinetic friction force.
    pub stiction: T,
    /// True if the requested motion is that of the contact, false if it is that of a mass.
    pub is_contact: bool,
    pub damped: bool,
    /// True if damping acts on velocities relative to the moving base.
    pub from_base: bool,
}

impl<T> ChainNumbers<T> {
    /// Returns the numbers of a chain for the motion of the contact, or of the mass `mass`. `to` converts each number
    /// to the number type of the result.
    pub fn of<F: Float>(modal: &Modal<F>, mass: Option<usize>, to: impl Fn(F) -> T) -> Self {
        let none = F::constant(0.0);
        let at = |list: &[F], place: usize| list.get(place).copied().unwrap_or(none);
        let mode = |index: usize| {
            let contact = at(&modal.contacts, index);
            let shape = match mass {
                None => contact,
                Some(mass) => modal
                    .shapes
                    .get(index)
                    .map_or(none, |shape| at(shape, mass)),
            };
            ModeNumbers {
                resonance: to(at(&modal.resonances, index)),
                zeta: to(at(&modal.damping_ratios, index)),
                load: to(at(&modal.loads, index)),
                contact: to(contact),
                shape: to(shape),
                quadrature: modal.quadrature(index, &to),
            }
        };
        Self {
            modes: (0..modal.resonances.len()).map(mode).collect(),
            on_base: modal.on_moving_base.then(|| to(modal.static_motion)),
            inverse_mass: to(modal.inverse_mass),
            compliance: modal.compliance.map(&to),
            stiction: to(modal.stiction),
            is_contact: mass.is_none(),
            damped: modal.is_damped(),
            from_base: modal.is_damped() && !modal.participations.is_empty(),
        }
    }
}

/// The function of frequency whose zeros the search finds. Index k denotes the requested mass.
#[derive(Clone, Copy, Debug)]
pub(super) enum Target<T> {
    /// The function is V_k, the complex amplitude of mass k without friction.
    Free,
    /// The function is V, the complex amplitude of the contact without friction.
    FreeContact,
    /// The function is H_k, the response of mass k to a harmonic force in the contact.
    Receptance,
    /// The function is U_k, the velocity of mass k at a reversal, in response to a square wave of friction (6.9).
    Quadrature,
    /// The function is V U_k − 2 V_k U for mass k. The function is zero where friction does not change the monoharmonic
    /// estimate of the amplitude (6.10). V is the contact's motion without friction, and U its velocity at a reversal,
    /// in response to a square wave of friction. V_k and U_k belong to mass k.
    Estimate,
    /// The function is V_k U + (2/π) H_k V for mass k, or U + (2/π) H for the contact. The function is zero where
    /// friction does not change the amplitude of the fundamental component. V and H are the responses of the contact to
    /// the load and to a harmonic contact force. U is its velocity at a reversal, in response to a square wave of
    /// friction. V_k and H_k belong to mass k.
    Fundamental,
    /// The function is V − βμH, or |V|² − (βμ)²|H|² with damping (6.13). V is the contact's motion without friction,
    /// and H its receptance. For an elastic contact, H + ρ replaces H, where ρ is the compliance of the contact. The
    /// function is zero where β*_lim equals β.
    Sliding(T),
    /// The function is V² − β²(U² + (μm*/r²)²) for an undamped chain. V is the contact's motion without friction, U its
    /// response to a square wave of friction, and m* its inverse effective mass. The function is zero where the upper
    /// bound on β_lim that needs no search equals β.
    Continuous(T),
}

/// A pole p of one or more modes on the axis of y = 1/r. `members` lists these modes by index. Each index is paired
/// with the odd integer that x = √λ y equals at the pole, where λ is the squared frequency ratio of the mode.
#[derive(Clone, Debug)]
pub(super) struct ModalPole {
    pub y: f64,
    pub members: Vec<(usize, f64)>,
}

/// The functions over an interval of y = 1/r that contains a pole p. The data are the distance y − p, and the functions
/// of the modes with this pole, multiplied by y − p.
pub(super) struct Near<T> {
    gap: T,
    /// For each mode with this pole: 1/d and tan(πx/2)/x, both multiplied by the distance y − p. x is √λ y, with the
    /// squared frequency ratio λ of the mode, and d is x² − 1. `None` for modes without this pole.
    own: Vec<Option<[T; 2]>>,
}

/// Selects a sum over the modes: V, H, U, or a combination of these sums. V, H and U are the responses of the contact
/// to the load, to a harmonic contact force and to a square wave of friction.
#[derive(Clone, Copy)]
enum ModalSum<T> {
    V,
    H,
    FreeOf,
    HOf,
    U,
    UOf,
    /// The sum V − level·H, where V is the response of the contact to the load and H its receptance. The code takes the
    /// difference for each mode, and then adds the differences. If the difference of a mode vanishes, the sum has no
    /// pole at this mode.
    Against(T),
}

impl<T: Arithmetic> ChainNumbers<T> {
    fn sum(&self, which: ModalSum<T>, y: T, near: Option<&Near<T>>) -> [T; 2] {
        let (one, two, zero) = (T::number(1.0), T::number(2.0), T::number(0.0));
        let mut sum = [zero; 2];
        for (index, mode) in self.modes.iter().enumerate() {
            let share = match which {
                ModalSum::V => mode.contact * mode.load,
                ModalSum::H | ModalSum::U => mode.contact * mode.contact,
                ModalSum::Against(level) => mode.contact * (mode.load - level * mode.contact),
                ModalSum::FreeOf => mode.shape * mode.load,
                ModalSum::HOf | ModalSum::UOf => mode.shape * mode.contact,
            };
            let x = mode.resonance * y;
            let own = near.and_then(|near| near.own.get(index).copied().flatten());
            let friction = matches!(which, ModalSum::U | ModalSum::UOf);
            let [re, im] = match (own, friction) {
                (Some([_, tangent]), true) => [tangent, zero],
                (Some([rational, _]), false) => [rational, zero],
                (None, true) => {
                    let (sine, cosine) = (x * T::number(0.5)).sine_cosine();
                    [sine / (cosine * x), zero]
                }
                (None, false) => {
                    let re = (x - one) * (x + one);
                    if self.damped {
                        let im = two * mode.zeta * x;
                        let size = re.squared() + im.squared();
                        [re / size, -(im / size)]
                    } else {
                        [one / re, zero]
                    }
                }
            };
            if self.from_base && matches!(which, ModalSum::V | ModalSum::FreeOf) {
                let term = self.loaded(mode, (which, share), x, [re, im]);
                let outside = near.map_or(one, |near| near.gap);
                sum = [sum[0] + term[0] * outside, sum[1] + term[1] * outside];
                continue;
            }
            // For a contact on a moving base, the sum contains v − 1 = (1 − 2iζx)/d in place of v = x²/d, with d = x² −
            // 1 + 2iζx. Here v is the response of a mode, and x its natural frequency divided by the excitation
            // frequency. With v − 1 the sum has no cancellation for large r.
            let [re, im] = match (which, self.on_base.is_some()) {
                (ModalSum::V, true) => {
                    let turn = two * mode.zeta * x;
                    let weight = one / (x * x);
                    [(re + turn * im) * weight, (im - turn * re) * weight]
                }
                _ => [re, im],
            };
            let outside = match (own, near) {
                (None, Some(near)) => near.gap,
                _ => one,
            };
            sum = [sum[0] + share * re * outside, sum[1] + share * im * outside];
        }
        if let (ModalSum::V, Some(at_rest)) = (which, self.on_base) {
            let gap = near.map_or(one, |near| near.gap);
            sum[0] = sum[0] + at_rest / (y * y) * gap;
        }
        if let Some(compliance) = self.compliance {
            let own = compliance / (y * y) * near.map_or(one, |near| near.gap);
            match which {
                ModalSum::Against(level) => sum[0] = sum[0] - level * own,
                ModalSum::H => sum[0] = sum[0] + own,
                _ => {}
            }
        }
        if let (ModalSum::Against(_), Some(_)) = (which, self.on_base) {
            let gap = near.map_or(one, |near| near.gap);
            sum[0] = sum[0] - one / (y * y) * gap;
        }
        sum
    }

    /// Returns the term of a mode in V or V_k, the responses of the contact or of mass k to the load. The term includes
    /// the load that is 90° out of phase with the base. `response` is 1/(x² − 1 + 2iζx).
    fn loaded(
        &self,
        mode: &ModeNumbers<T>,
        (which, share): (ModalSum<T>, T),
        x: T,
        response: [T; 2],
    ) -> [T; 2] {
        let ([re, im], [quadrature, wall]) = (response, mode.quadrature);
        let (one, two) = (T::number(1.0), T::number(2.0));
        let [in_phase, out_of_phase] = match (which, self.on_base.is_some()) {
            (ModalSum::V, true) => {
                let y = x / mode.resonance;
                [
                    share * (one / (x * x)),
                    -(two * mode.zeta * x * wall / (y * y)),
                ]
            }
            (ModalSum::V, false) => [share, mode.contact * quadrature / x],
            _ => [share, mode.shape * quadrature / x],
        };
        [
            in_phase * re - out_of_phase * im,
            in_phase * im + out_of_phase * re,
        ]
    }

    /// Returns the target function at y = 1/r. With `near`, the function is multiplied by a power of y − p, which
    /// removes the pole p. The exponent is the number of factors of the function that have this pole.
    pub fn value(&self, target: Target<T>, y: T, near: Option<&Near<T>>) -> T {
        let sum = |which| self.sum(which, y, near);
        let real = |which| sum(which)[0];
        let two_over_pi = || T::number(2.0) / T::pi();
        match target {
            Target::Free if self.is_contact => real(ModalSum::V),
            Target::Free => real(ModalSum::FreeOf),
            Target::FreeContact => real(ModalSum::V),
            Target::Receptance => real(ModalSum::HOf),
            Target::Quadrature => real(ModalSum::UOf),
            Target::Estimate => {
                let crossed = real(ModalSum::FreeOf) * real(ModalSum::U);
                real(ModalSum::V) * real(ModalSum::UOf) - (crossed + crossed)
            }
            Target::Fundamental if self.is_contact => {
                real(ModalSum::U) + two_over_pi() * real(ModalSum::H)
            }
            Target::Fundamental => {
                real(ModalSum::FreeOf) * real(ModalSum::U)
                    + two_over_pi() * real(ModalSum::HOf) * real(ModalSum::V)
            }
            Target::Sliding(beta) => {
                let level = beta * self.stiction;
                if self.damped {
                    let ([v, turned], [h, lost]) = (sum(ModalSum::V), sum(ModalSum::H));
                    v.squared() + turned.squared()
                        - level.squared() * (h.squared() + lost.squared())
                } else {
                    real(ModalSum::Against(level))
                }
            }
            Target::Continuous(beta) => {
                let gap = near.map_or(T::number(1.0), |near| near.gap);
                let start = self.stiction * self.inverse_mass * gap;
                let limit = real(ModalSum::U).squared() + start.squared();
                real(ModalSum::V).squared() - beta.squared() * limit
            }
        }
    }
}

impl ChainNumbers<Interval> {
    /// Returns the distance y − p over an interval of y, and the functions of the modes with the pole p, multiplied by
    /// this distance. Returns `None` if the interval is too wide for finite bounds.
    pub fn near(&self, y: Interval, pole: &ModalPole) -> Option<Near<Interval>> {
        let two_over_pi = Interval::rounded(std::f64::consts::FRAC_2_PI);
        let half_pi = Interval::rounded(std::f64::consts::FRAC_PI_2);
        let one = Interval::point(1.0);
        let mut own = vec![None; self.modes.len()];
        for (index, odd) in &pole.members {
            let mode = self.modes.get(*index)?;
            let x = mode.resonance * y;
            let z = half_pi * (x - Interval::point(*odd));
            if !(z.high < 1.0 && -1.0 < z.low) {
                return None;
            }
            let tangent = -(two_over_pi * z.cotangent_times() / (mode.resonance * x));
            let rational = if *odd == 1.0 {
                one / (mode.resonance * (x + one))
            } else {
                (y - Interval::rounded(pole.y)) / ((x - one) * (x + one))
            };
            *own.get_mut(*index)? = Some([rational, tangent]);
        }
        Some(Near {
            gap: y - Interval::rounded(pole.y),
            own,
        })
    }
}

/// Largest relative distance at which two poles of different modes are treated as one pole.
const SAME: f64 = 4e-15;

impl Target<Dd> {
    /// Returns two flags for a mode. The first flag is true if the target has a pole at x = 1. The second flag is true
    /// if the target has poles at x = 3, 5, …. x is √λ y, with the squared frequency ratio λ of the mode.
    fn poles_of(&self, numbers: &ChainNumbers<Dd>, mode: &ModeNumbers<Dd>) -> [bool; 2] {
        let drives = |a: Dd, b: Dd| !(a.is_zero() || b.is_zero());
        let undamped = mode.zeta.is_zero();
        let v = undamped && drives(mode.contact, mode.load);
        let h = undamped && !mode.contact.is_zero();
        let free = undamped && drives(mode.shape, mode.load);
        let of = undamped && drives(mode.shape, mode.contact);
        match self {
            Self::Free if numbers.is_contact => [v, false],
            Self::Free => [free, false],
            Self::FreeContact => [v, false],
            Self::Receptance => [of, false],
            Self::Quadrature => [of, of],
            Self::Fundamental if numbers.is_contact => [h, h],
            Self::Estimate | Self::Fundamental => [free || h, h],
            Self::Sliding(_) => [h, false],
            Self::Continuous(_) => [h, h],
        }
    }

    /// Returns true if the target function is 0 at every frequency.
    pub fn vanishes(&self, numbers: &ChainNumbers<Dd>) -> bool {
        let none =
            |share: fn(&ModeNumbers<Dd>) -> Dd| numbers.modes.iter().all(|m| share(m).is_zero());
        match self {
            Self::Free if !numbers.is_contact => {
                none(|mode| mode.shape * mode.load) && none(|mode| mode.shape * mode.quadrature[0])
            }
            Self::Free | Self::FreeContact => {
                none(|mode| mode.contact * mode.load)
                    && none(|mode| mode.contact * mode.quadrature[0])
                    && numbers.on_base.is_none_or(|rest| rest.is_zero())
            }
            Self::Receptance | Self::Quadrature | Self::Estimate => {
                none(|mode| mode.shape * mode.contact)
            }
            _ => none(|mode| mode.contact),
        }
    }

    /// Returns the poles of the target function between two values of y, in ascending order. Returns `None` if there
    /// are more than `most` poles.
    pub fn poles(
        &self,
        numbers: &ChainNumbers<Dd>,
        [low, high]: [f64; 2],
        most: usize,
    ) -> Option<Vec<ModalPole>> {
        let mut all: Vec<(f64, usize, f64)> = Vec::new();
        for (index, mode) in numbers.modes.iter().enumerate() {
            let [first, others] = self.poles_of(numbers, mode);
            let at = |odd: f64| (Dd::from(odd) / mode.resonance).to_f64();
            if first && low <= at(1.0) && at(1.0) <= high {
                all.push((at(1.0), index, 1.0));
            }
            if !others {
                continue;
            }
            let x = low * mode.resonance.to_f64();
            let mut odd = (2.0 * (0.5 * (x - 1.0)).floor() - 1.0).max(3.0);
            while at(odd) <= high {
                if low <= at(odd) {
                    all.push((at(odd), index, odd));
                }
                if most < all.len() {
                    return None;
                }
                odd += 2.0;
            }
        }
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut poles: Vec<ModalPole> = Vec::new();
        for (y, index, odd) in all {
            match poles.last_mut() {
                Some(last) if (y - last.y).abs() <= SAME * y => last.members.push((index, odd)),
                _ => poles.push(ModalPole {
                    y,
                    members: vec![(index, odd)],
                }),
            }
        }
        Some(poles)
    }
}
