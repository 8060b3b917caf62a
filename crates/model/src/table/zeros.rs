//! The contact's responses V (to the load) and H (to a contact force) as rational functions, by their zeros and poles
//! in double-double.

use crate::modal::Modal;
use crate::roots::{DrivenMode, converge, pairs};
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::Factor;
use frictiongen_kernel::{Complex, Float};

/// Relative size up to which the real or imaginary part of a zero or pole, or a coefficient, counts as zero. It is
/// far larger than the rounding error of a double-double sum, 10⁻³², and far smaller than the precision of a scene in
/// doubles.
pub(super) const NONE: f64 = 1e-20;
/// Largest relative difference of two constants (resonance or damping ratio) of modes that count as equal. Rounding in
/// double-double causes differences of this size.
pub(super) const EQUAL: f64 = 1e-24;
/// Largest relative distance of a zero of V and a zero of H that count as one common zero. V and H are the responses of
/// the contact to the load and to a contact force. A scene in doubles cannot separate zeros that are so close.
const COMMON: f64 = 1e-13;
/// Smallest modulus from which the search for zeros starts, as a multiple of the lowest resonance.
const BELOW: f64 = 0.6;
/// Largest modulus from which the search for zeros starts, as a multiple of the highest resonance. Zeros are between
/// the resonances or slightly outside.
const ABOVE: f64 = 1.4;
/// Smallest angle, in rad, between the imaginary axis and a point from which the search for zeros starts. From a
/// point on an axis, the iteration would stay on that axis.
const LEAST_ANGLE: f64 = 0.1;
/// Range of the angles, in rad, of the points from which the search for zeros starts. It begins at `LEAST_ANGLE` and
/// is divided into elevenths. Each angle is seven elevenths beyond the previous angle (modulo the range), so that
/// neighbouring points have very different angles.
const ANGLES: f64 = 0.7;

/// A zero or pole s = x + iy of a function of s = ir, in double-double. A conjugate pair is represented by the number
/// with y > 0.
#[derive(Clone, Copy, Debug)]
pub struct Zero {
    /// Real part x of the zero or pole.
    pub x: Dd,
    /// Imaginary part y of the zero or pole, not negative.
    pub y: Dd,
}

/// A rational function of s = ir, given by its zeros and poles up to a constant factor.
#[derive(Clone, Debug)]
pub(super) struct Rational {
    pub zeros: Vec<Zero>,
    pub poles: Vec<Zero>,
}

impl Zero {
    /// Returns true if the zero lies on the imaginary axis, so that the function is zero at a real r.
    pub fn is_on_axis(&self) -> bool {
        self.x.is_zero()
    }

    /// Returns the factor that this zero contributes to a function of r. If `squared` is true, the function is a
    /// squared modulus.
    pub fn factor<S: Float>(&self, squared: bool, to: &impl Fn(Dd) -> S) -> Factor<S> {
        if self.y.is_zero() {
            return Factor::Real {
                off: to(self.x * self.x),
            };
        }
        let at = to(self.y);
        let rest = to(self.y - Dd::from(at.to_f64()));
        if self.is_on_axis() && !squared {
            return Factor::Zero { at, rest };
        }
        let off = self.x * self.x;
        let least = Dd::from(4.0) * off * self.y * self.y;
        Factor::Pair {
            at,
            rest,
            off: to(off),
            least: to(least),
        }
    }

    /// Returns true if two zeros are so close that they count as one zero.
    pub fn is_near(&self, other: &Self) -> bool {
        let apart = Complex::new(self.x.abs() - other.x.abs(), self.y - other.y);
        let size = complex::modulus(Complex::new(self.x, self.y), true);
        complex::modulus(apart, true) <= size * Dd::from(COMMON)
    }
}

/// Zeros and poles of V and H, the responses of the contact to the load and to a force in the contact.
#[derive(Clone, Debug)]
pub struct Zeros {
    /// True if any mode of the chain is damped.
    pub damped: bool,
    /// Zeros of V that are not zeros of H. V and H are the responses of the contact to the load and to a contact force.
    pub excitation: Vec<Zero>,
    /// Zeros of H that are not zeros of V. V and H are the responses of the contact to the load and to a contact force.
    pub receptance: Vec<Zero>,
    /// Common zeros of V and H, the responses of the contact to the load and to a contact force.
    pub common: Vec<Zero>,
    /// Poles of V, the response of the contact to the load. The poles come from the modes that both the load and the
    /// contact drive.
    pub loaded: Vec<Zero>,
    /// Poles of H, the response of the contact to a contact force, that are not poles of the response to the load.
    pub unloaded: Vec<Zero>,
}

/// A mode of the chain in double-double, with its contributions to V and H, the contact's responses to the load and
/// to a contact force.
pub struct ContactMode {
    /// Resonance and damping ratio of the mode, and its contribution to H.
    pub driven: DrivenMode,
    /// Constant term c of the numerator of the mode in V, the response of the contact to the load.
    pub residue: Dd,
    /// Coefficient e of s = ir in the numerator of the mode in V. It is 0 unless damping acts on velocities relative to
    /// the moving base.
    pub along: Dd,
}

/// Returns the modes that the contact drives.
pub fn contact_modes(modal: &Modal) -> Vec<ContactMode> {
    let modes = modal.resonances.iter().zip(&modal.damping_ratios);
    let drives = modal.loads.iter().zip(&modal.contacts);
    // The list of participations is empty unless damping acts on velocities relative to the moving base.
    let participations = modal.participations.iter().copied();
    let participations = participations.chain(std::iter::repeat(Dd::ZERO));
    let mut contact_modes: Vec<ContactMode> = Vec::new();
    for (((sigma, zeta), (load, contact)), participation) in modes.zip(drives).zip(participations) {
        if contact.is_zero() {
            continue;
        }
        let (inverse_mass, residue) = (*contact * *contact, *load * *contact);
        let along = Dd::from(2.0) * *zeta * *sigma * participation * *contact;
        // Equal modes have the same denominator, so that the code adds their contributions to the responses of the
        // contact.
        if let Some(last) = contact_modes.last_mut()
            && (*sigma - last.driven.sigma).abs() <= *sigma * Dd::from(EQUAL)
            && (*zeta - last.driven.zeta).abs() <= *zeta * Dd::from(EQUAL)
        {
            last.driven.inverse_mass = last.driven.inverse_mass + inverse_mass;
            last.residue = last.residue + residue;
            last.along = last.along + along;
            continue;
        }
        contact_modes.push(ContactMode {
            driven: DrivenMode {
                sigma: *sigma,
                zeta: *zeta,
                inverse_mass,
                along: Dd::ZERO,
            },
            residue,
            along,
        });
    }
    contact_modes
}

impl Zeros {
    /// Returns the zeros and poles of the contact's responses to the load and to a contact force. Returns `None` if the
    /// zeros cannot be separated. The tables then use the exact sums over the modes.
    pub fn of(modal: &Modal) -> Option<Self> {
        let contact_modes = contact_modes(modal);
        let damped = modal.is_damped();
        let direct = Dd::from(if modal.on_moving_base { -1.0 } else { 0.0 });
        let (mut loaded, mut unloaded) = (Vec::new(), Vec::new());
        for mode in &contact_modes {
            let poles = poles(&mode.driven);
            if mode.residue.is_zero() && mode.along.is_zero() {
                unloaded.extend(poles);
            } else {
                loaded.extend(poles);
            }
        }
        let driven: Vec<DrivenMode> = contact_modes.iter().map(|mode| mode.driven).collect();
        let mut receptance = Vec::new();
        for pair in pairs(&driven, Dd::ZERO) {
            let mode = DrivenMode {
                sigma: pair.omega,
                zeta: pair.zeta,
                inverse_mass: Dd::ONE,
                along: Dd::ZERO,
            };
            receptance.extend(poles(&mode));
        }
        let excitation: Vec<DrivenMode> = contact_modes
            .iter()
            .filter(|mode| !(mode.residue.is_zero() && mode.along.is_zero()))
            .map(|mode| DrivenMode {
                inverse_mass: mode.residue,
                along: mode.along,
                ..mode.driven
            })
            .collect();
        // At r = 0 a moving base may carry the contact along without relative motion. V then has a zero at s = 0. It is
        // double if no damping acts on the common motion of the chain with the base.
        let at_rest = modal.on_moving_base && modal.static_motion.is_zero();
        let known = match at_rest {
            false => 0,
            true if slopes_at_rest(&excitation) => 1,
            true => 2,
        };
        let mut excitation = zeros(&excitation, direct, damped, known)?;
        let mut common = Vec::new();
        excitation.retain(|zero| {
            let place = receptance.iter().position(|other| other.is_near(zero));
            if let Some(place) = place {
                common.push(receptance.swap_remove(place));
            }
            place.is_none()
        });
        Some(Self {
            damped,
            excitation,
            receptance,
            common,
            loaded,
            unloaded,
        })
    }
}

/// Returns the poles of a mode: one pole that represents a conjugate pair, or two real poles of an overdamped mode.
pub(super) fn poles(mode: &DrivenMode) -> Vec<Zero> {
    let (one, zero) = (Dd::ONE, Dd::ZERO);
    let q = ((one - mode.zeta) * (one + mode.zeta)).abs().sqrt();
    if mode.zeta < one {
        let x = -(mode.zeta * mode.sigma);
        return vec![Zero {
            x,
            y: q * mode.sigma,
        }];
    }
    let far = mode.zeta + q;
    [far, one / far]
        .map(|rate| Zero {
            x: -(rate * mode.sigma),
            y: zero,
        })
        .to_vec()
}

/// Returns true if the sum Σ (c_i + e_i s)/(s² + 2ζ_iσ_i s + λ_i) over the modes has a derivative at s = 0 that is
/// larger than its rounding error.
fn slopes_at_rest(modes: &[DrivenMode]) -> bool {
    let two = Dd::from(2.0);
    let (mut slope, mut sizes) = (Dd::ZERO, Dd::ZERO);
    for mode in modes {
        let lambda = mode.sigma * mode.sigma;
        let terms = [
            mode.along / lambda,
            -(two * mode.zeta * mode.sigma * mode.inverse_mass / (lambda * lambda)),
        ];
        for term in terms {
            (slope, sizes) = (slope + term, sizes + term.abs());
        }
    }
    slope.abs() > sizes * Dd::from(NONE)
}

/// Returns the zeros of the rational function `direct` + Σ (c_i + e_i s)/(s² + 2ζ_iσ_i s + λ_i) over the modes. The list
/// contains one zero of each conjugate pair. The first `known` zeros are at s = 0.
fn zeros(modes: &[DrivenMode], direct: Dd, damped: bool, known: usize) -> Option<Vec<Zero>> {
    let degree = degree(modes, direct)?;
    let mut roots = vec![complex::real(Dd::ZERO); known];
    let sigmas = modes.iter().map(|mode| mode.sigma.to_f64());
    roots.extend(guesses(sigmas, degree.checked_sub(known)?));
    converge(modes, direct, &mut roots, known);
    classified(roots, known, damped)
}

/// Converts roots to zeros. The result has one zero of each conjugate pair. Returns `None` if the roots do not form
/// pairs, or if a root is not a number.
pub(super) fn classified(roots: Vec<Complex<Dd>>, known: usize, damped: bool) -> Option<Vec<Zero>> {
    let degree = roots.len();
    let tiny = Dd::from(NONE);
    let mut zeros = Vec::new();
    let mut found = known;
    // Without damping, one zero at s = 0 stands for the double zero.
    let (x, y) = (Dd::ZERO, Dd::ZERO);
    let at_rest = if damped { known } else { known.min(1) };
    zeros.resize(at_rest, Zero { x, y });
    for root in roots.into_iter().skip(known) {
        let size = complex::modulus(root, true);
        if !size.is_finite() {
            return None;
        }
        let none = |part: Dd| part.abs() <= size * tiny;
        let (x, y) = (root.re, root.im);
        let (x, y) = (
            if none(x) { Dd::ZERO } else { x },
            if none(y) { Dd::ZERO } else { y },
        );
        let (stands, for_roots) = if damped {
            (!(y < Dd::ZERO), if y.is_zero() { 1 } else { 2 })
        } else if x.is_zero() || y.is_zero() {
            (!(x + y < Dd::ZERO), 2)
        } else {
            (!(x < Dd::ZERO) && !(y < Dd::ZERO), 4)
        };
        if stands {
            zeros.push(Zero { x, y });
            found += for_roots;
        }
    }
    (found == degree).then_some(zeros)
}

/// Returns the number of zeros of the rational function `direct` + Σ (c_i + e_i s)/(s² + 2ζ_iσ_i s + λ_i) over the
/// modes. The number follows from the expansion of the function in powers of 1/s. It depends on the first power whose
/// coefficient is larger than its rounding error.
fn degree(modes: &[DrivenMode], direct: Dd) -> Option<usize> {
    let most = 2 * modes.len();
    if !direct.is_zero() {
        return Some(most);
    }
    let two = Dd::from(2.0);
    let mut powers: Vec<[Dd; 2]> = modes.iter().map(|_| [Dd::ZERO, Dd::ONE]).collect();
    for lost in 1..=most {
        let (mut sum, mut sizes) = (Dd::ZERO, Dd::ZERO);
        for (mode, [before, power]) in modes.iter().zip(&mut powers) {
            for term in [mode.inverse_mass * *before, mode.along * *power] {
                (sum, sizes) = (sum + term, sizes + term.abs());
            }
            let rate = two * mode.zeta * mode.sigma;
            let next = -(rate * *power) - mode.sigma * mode.sigma * *before;
            (*before, *power) = (*power, next);
        }
        if sum.abs() > sizes * Dd::from(NONE) {
            return Some(most - lost);
        }
    }
    None
}

/// Returns `count` points from which the search for zeros starts, unevenly spread near the imaginary axis. Their
/// moduli span the range of the resonances, and a little more on both sides.
pub(super) fn guesses(sigmas: impl Iterator<Item = f64>, count: usize) -> Vec<Complex<Dd>> {
    let ends = (f64::INFINITY, 0.0_f64);
    let (low, high) = sigmas.fold(ends, |(low, high), sigma| (low.min(sigma), high.max(sigma)));
    let (low, high) = (BELOW * low, ABOVE * high);
    (0..count)
        .map(|index| {
            let share = (index as f64 + 0.5) / count as f64;
            let size = low * (high / low).powf(share);
            let angle = LEAST_ANGLE + ANGLES * ((index * 7 % 11) as f64 / 11.0);
            let (re, im) = (size * angle.sin(), size * angle.cos());
            let (re, im) = match index % 4 {
                0 => (-re, im),
                1 => (-re, -im * 1.01),
                2 => (re, im * 0.99),
                _ => (re * 1.02, -im),
            };
            Complex::new(Dd::from(re), Dd::from(im))
        })
        .collect()
}
