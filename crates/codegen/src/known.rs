//! Known answers of a scene: reference results that are computed in double-double. The self-check of emitted code
//! compares its own results with the known answers.

use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::response::At;
use frictiongen_model::modal::Modal;
use frictiongen_model::reduced::Reduced;
use frictiongen_model::scene::Precision;

/// Number of frequency ratios with known answers.
pub const POINTS: usize = 10;
/// Number of frequency ratios that the code tries in each of [`POINTS`] equal parts of the range of r, for a scene with
/// one mode. With more modes the number is smaller, because a try takes longer.
const TRIED: u32 = 40;
/// Smallest number of frequency ratios that the code tries in each of [`POINTS`] equal parts of the range of r.
const TRIED_AT_LEAST: u32 = 5;
/// Distance from one tried frequency ratio to the next, as a fraction of a part of the range of r. This fraction is the
/// golden section, which spreads the tries evenly over the part.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Phase τ, in rad, of the known displacement and velocity of each mass.
pub const TAU: f64 = 1.0;
/// The code changes r by this number of rounding units to test whether the answers depend on rounding.
const DISPLACED: f64 = 32.0;
/// Fraction of the allowed error. An answer depends on rounding if it changes by more than this fraction when r
/// changes by [`DISPLACED`] rounding units.
const SENSITIVE: f64 = 1.0 / 8.0;
/// Smallest relative distance of β from β_lim and from β*_lim. At this distance no rounding changes the regime.
const APART: f64 = 0.05;
/// Largest modulus of a phase in the known answers, in rad. Rounding could change a phase near π to one near −π.
const WRAPS: f64 = 3.0;

/// Request for known answers of a scene: the ranges, the tolerance and the kinds of answers.
#[derive(Clone, Copy, Debug)]
pub struct AnswersRequest {
    /// Precision in which r and β are given.
    pub precision: Precision,
    /// Range of the frequency ratios r of the answers.
    pub r: (f64, f64),
    /// Range of the friction ratios β of the answers.
    pub beta: (f64, f64),
    /// Allowed relative error of an answer of the emitted code.
    pub tolerance: f64,
    /// Largest relative error that the code may allow instead of `tolerance`. A part of the range of r may need it,
    /// because every answer in the part depends on rounding.
    pub widest: f64,
    /// True if the answers contain the motion at one friction ratio.
    pub motion: bool,
    /// True if the answers contain the responses while the contact is stuck.
    pub stuck: bool,
}

/// The kind of motion at a friction ratio.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionKind {
    /// The contact slides all the time.
    Continuous,
    /// The contact alternately sticks and slides.
    StickSlip,
    /// The contact is stuck all the time.
    Stuck,
}

/// Known answers at one frequency ratio.
#[derive(Clone, Debug)]
pub struct KnownAnswers {
    /// The frequency ratio r of the answers.
    pub r: f64,
    /// β_lim, the limit of continuous motion.
    pub continuous: f64,
    /// β*_lim, the limit of sliding.
    pub sliding: f64,
    /// The motion at one friction ratio, if the request includes it.
    pub motion: Option<MotionAnswers>,
    /// Real and imaginary part of the response of each mass while the contact is stuck, then of the force that keeps
    /// the contact stuck. The list is empty if these responses are not requested.
    pub stuck: Vec<[f64; 2]>,
    /// Largest change of an answer if r changes by 32 rounding units, divided by the size of this answer.
    pub change: f64,
}

impl KnownAnswers {
    /// Returns the smallest allowed error for which these answers do not depend on rounding. It is `change` divided by
    /// the fraction `SENSITIVE`.
    #[must_use]
    pub fn needs(&self) -> f64 {
        self.change / SENSITIVE
    }
}

/// Known answers at one friction ratio.
#[derive(Clone, Debug)]
pub struct MotionAnswers {
    /// The friction ratio β of the answers.
    pub beta: f64,
    /// Kind of the motion at this friction ratio.
    pub outcome: MotionKind,
    /// Amplitude and phase (rad) of the contact. Both numbers are 0 if the contact does not slide all the time.
    pub contact: [f64; 2],
    /// Displacement and velocity of each mass at τ = [`TAU`]. The two numbers are 0 if the contact does not slide all
    /// the time.
    pub masses: Vec<[f64; 2]>,
}

/// Returns the known answers at up to [`POINTS`] frequency ratios, in ascending order.
///
/// The function divides the range into equal parts, and takes one frequency ratio of each part. It takes the first
/// frequency ratio at which no answer depends on rounding. If an answer depends on rounding at every frequency ratio of
/// the part, it takes the frequency ratio at which the answers depend least on rounding. If the allowed error would
/// then exceed [`AnswersRequest::widest`], the part has no known answer.
#[must_use]
pub fn known(modal: &Modal, question: &AnswersRequest) -> Vec<KnownAnswers> {
    let exact = modal.reduced(|value| value);
    let (low, high) = question.r;
    let modes = u32::try_from(exact.modes.len().max(1)).unwrap_or(TRIED);
    let tries = (TRIED / modes).max(TRIED_AT_LEAST);
    let part = |place: usize| {
        let mut best: Option<KnownAnswers> = None;
        for tried in 0..tries {
            let share = (0.5 + f64::from(tried) * GOLDEN).fract();
            #[allow(clippy::cast_precision_loss, reason = "at most `POINTS`")]
            let share = (place as f64 + share) / POINTS as f64;
            let r = question.rounded(low + (high - low) * share);
            let Some(found) = answers(&exact, question, r, place) else {
                continue;
            };
            if found.needs() <= question.tolerance {
                return Some(found);
            }
            if best.as_ref().is_none_or(|best| found.change < best.change) {
                best = Some(found);
            }
        }
        best.filter(|best| best.needs() <= question.widest)
    };
    (0..POINTS).filter_map(part).collect()
}

impl AnswersRequest {
    #[allow(clippy::cast_possible_truncation, reason = "the scalar is f32")]
    fn rounded(&self, value: f64) -> f64 {
        match self.precision {
            Precision::F64 => value,
            Precision::F32 => f64::from(value as f32),
        }
    }

    fn epsilon(&self) -> f64 {
        match self.precision {
            Precision::F64 => f64::EPSILON,
            Precision::F32 => f64::from(f32::EPSILON),
        }
    }
}

/// Returns the answers at the frequency ratio r, with their change if r grows by [`DISPLACED`] rounding units. Returns
/// `None` if an answer at r or at the changed r is missing. `place` is the number of the part of the range of r.
fn answers(
    exact: &Reduced<Dd>,
    question: &AnswersRequest,
    r: f64,
    place: usize,
) -> Option<KnownAnswers> {
    let at = At::new(exact, Dd::from(r)).ok()?;
    let limits = limits(&at)?;
    let beta = question.motion.then(|| beta(question, limits, place));
    let masses = exact.shapes.len() / exact.modes.len().max(1);
    let mut here = answer(&at, question, (r, limits), (beta, masses))?;
    let displaced = r * (1.0 + DISPLACED * question.epsilon());
    let at = At::new(exact, Dd::from(displaced)).ok()?;
    let ratios = (displaced, self::limits(&at)?);
    let there = answer(&at, question, ratios, (beta, masses))?;
    let numbers = |known: &KnownAnswers| {
        let motion = known.motion.iter().flat_map(|motion| {
            let [amplitude, phase] = motion.contact;
            let mut all = vec![(amplitude, amplitude), (phase, 1.0)];
            all.extend(motion.masses.iter().flat_map(|[x, v]| {
                let size = x.hypot(*v);
                [(*x, size), (*v, size)]
            }));
            all
        });
        let stuck = known.stuck.iter().flat_map(|[re, im]| {
            let size = re.hypot(*im);
            [(*re, size), (*im, size)]
        });
        let limits = [known.continuous, known.sliding].map(|limit| (limit, limit));
        limits
            .into_iter()
            .chain(motion)
            .chain(stuck)
            .collect::<Vec<_>>()
    };
    let pairs = numbers(&here).into_iter().zip(numbers(&there));
    let changes = pairs.map(|((one, size), (other, _))| match (one - other).abs() {
        0.0 => 0.0,
        change => change / size,
    });
    here.change = changes.fold(0.0, f64::max);
    here.change.is_finite().then_some(here)
}

/// Returns a friction ratio for the known answer with the index `place`, within the range of `question`. Two of three
/// known answers have a friction ratio below β_lim. The third is usually above β_lim and β*_lim, and sometimes between
/// these limits.
fn beta(question: &AnswersRequest, [continuous, sliding]: [f64; 2], place: usize) -> f64 {
    let wanted = match place % 3 {
        0 => 0.5 * continuous,
        1 => 0.8 * continuous,
        _ if continuous * (1.0 + 4.0 * APART) < sliding && place.is_multiple_of(2) => {
            0.5 * (continuous + sliding)
        }
        _ => 1.5 * continuous.max(sliding),
    };
    let (least, most) = question.beta;
    question.rounded(wanted).clamp(least, most)
}

/// Returns β_lim and β*_lim at a frequency, or `None` if β_lim or β*_lim is 0 or infinite.
fn limits(at: &At<&Reduced<Dd>>) -> Option<[f64; 2]> {
    let limits = at.limits();
    let both = [limits.continuous, limits.sliding].map(Float::to_f64);
    both.iter()
        .all(|limit| limit.is_finite() && 0.0 < *limit)
        .then_some(both)
}

/// Returns the answers at r and β. `continuous` is β_lim at r, and `sliding` is β*_lim at r. Returns `None` if no
/// answer exists, or if β is close to a limit.
fn answer(
    at: &At<&Reduced<Dd>>,
    question: &AnswersRequest,
    (r, [continuous, sliding]): (f64, [f64; 2]),
    (beta, masses): (Option<f64>, usize),
) -> Option<KnownAnswers> {
    let mut stuck = Vec::new();
    if question.stuck {
        let response = at.stuck().ok()?;
        let parts = (0..masses).map(|mass| response.mass(mass));
        let parts = parts.chain([response.contact_force()]);
        stuck = parts
            .map(|value| [value.re.to_f64(), value.im.to_f64()])
            .collect();
        // A response that should be exactly 0 contains the rounding errors of double-double.
        let largest = stuck
            .iter()
            .flatten()
            .fold(0.0_f64, |most, part| most.max(part.abs()));
        for part in stuck.iter_mut().flatten() {
            if part.abs() < 1e-20 * largest {
                *part = 0.0;
            }
        }
    }
    let motion = match beta {
        None => None,
        Some(beta) => Some(motion(at, beta, [continuous, sliding], masses)?),
    };
    Some(KnownAnswers {
        r,
        continuous,
        sliding,
        motion,
        stuck,
        change: 0.0,
    })
}

fn motion(
    at: &At<&Reduced<Dd>>,
    beta: f64,
    [continuous, sliding]: [f64; 2],
    masses: usize,
) -> Option<MotionAnswers> {
    let near = |limit: f64| (beta / limit - 1.0).abs() < APART;
    if near(continuous) || near(sliding) {
        return None;
    }
    let mut known = MotionAnswers {
        beta,
        outcome: if beta < continuous {
            MotionKind::Continuous
        } else if beta < sliding {
            MotionKind::StickSlip
        } else {
            MotionKind::Stuck
        },
        contact: [0.0; 2],
        masses: vec![[0.0; 2]; masses],
    };
    if known.outcome == MotionKind::Continuous {
        let motion = at.motion(Dd::from(beta)).ok()?;
        let largest = motion.contact().largest();
        known.contact = [largest.amplitude, largest.phase].map(Float::to_f64);
        if WRAPS < known.contact.last()?.abs() {
            return None;
        }
        let tau = Dd::from(TAU);
        known.masses = (0..masses)
            .map(|mass| {
                let mass = motion.mass(mass);
                [mass.displacement(tau), mass.velocity(tau)].map(Float::to_f64)
            })
            .collect();
    }
    Some(known)
}
