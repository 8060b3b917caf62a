//! Scans friction ratios, from zero to a friction ratio above which more friction no longer reduces the amplitude. At
//! each friction ratio, the scan computes the largest amplitude over a band, and its slope with respect to friction.

use super::amplitude::FrictionAmount;
use super::look::{BandPeak, Closely, Look, OpenBand};
use super::peaks::AmplitudeBand;

/// Number of intervals of the scan over friction. The intervals near zero friction are shorter.
const SCAN: usize = 40;
/// Number of additional friction ratios of the scan in geometric steps. The smallest of these friction ratios is
/// `LEAST` times the median of β*_lim over the band.
const GEOMETRIC: usize = 24;
/// Smallest of the friction ratios in geometric steps, divided by the median of the limit of sliding β*_lim over the
/// band.
const LEAST: f64 = 0.02;
/// Additional friction ratios of the scan, divided by the smallest friction ratio with a stuck state over the whole
/// band. With μ > 1 a motion from rest may still slide at these friction ratios, and from another initial state the
/// place of a stuck contact still depends on them.
const BEYOND: [f64; 6] = [1.05, 1.15, 1.3, 1.6, 2.5, 4.0];
/// Relative step in β of the finite difference for a peak that moves with friction.
const DIFFERENCE: f64 = 1e-6;
/// Largest number of times that the scan over friction doubles its range, if the range has no upper bound.
const LONGER: usize = 12;
/// Factor in the rule that ends a scan over friction without an upper bound. The scan ends if each of its last four
/// amplitudes rises with friction, or exceeds the best amplitude times this factor.
const FAR_ABOVE: f64 = 2.0;
/// Additional friction ratios of the scan, slightly above the friction ratio that bounds the amplitude at all
/// resonances. Each number is the relative distance from that friction ratio.
const BOUNDED: [f64; 8] = [1e-3, 0.01, 0.03, 0.06, 0.1, 0.2, 0.35, 0.5];
/// Largest relative change of a smooth amplitude, divided by the relative change of friction. The code treats a larger
/// change as a jump.
const STEEPEST: f64 = 50.0;
/// Number of rounds in which the search halves those intervals of the scan that may hide a minimum.
const CLOSER: usize = 5;
/// The search halves an interval of the scan over friction only if the smaller amplitude at its two bounds, divided by
/// the best amplitude, is at most this number.
const NEARLY: f64 = 1.2;
/// Largest number of intervals of the scan over friction that one round halves.
const MOST_CLOSER: usize = 8;
/// Largest amplitude at a friction ratio that the search evaluates completely, divided by the best amplitude so far. The
/// widest tolerance of the friction depends on all amplitudes up to 10 % above the best.
const MARGIN: f64 = 1.2;

/// The largest amplitude over the band at one friction ratio, with its slope and its peaks.
#[derive(Clone, Debug)]
pub(super) struct Scanned {
    pub beta: f64,
    /// Largest amplitude over the band. It is only a lower bound if `complete` is false.
    pub value: f64,
    /// Derivative of the largest amplitude with respect to β. It is NaN if the amplitude is unbounded.
    pub slope: f64,
    pub peaks: Vec<BandPeak>,
    pub complete: bool,
    /// True if the scan has evaluated the amplitude at all frequencies of the band.
    pub whole: bool,
}

/// Returns the friction ratio up to which the amplitude at an undamped resonance of the band is unbounded. Returns 0 if
/// the band contains no undamped resonance.
pub(super) fn unbounded_to(band: &AmplitudeBand<'_>) -> f64 {
    let (system, [from, to]) = (band.amplitude.system, band.ends());
    let modal = system.modal();
    let modes = modal.damping_ratios.iter().zip(system.resonances());
    let modes = modes.zip(system.resonance_thresholds());
    modes
        .filter(|((zeta, resonance), _)| zeta.is_zero() && from <= **resonance && **resonance <= to)
        .filter_map(|((_, resonance), threshold)| {
            Some(threshold? / band.amplitude.objective.beta(1.0, *resonance))
        })
        .fold(0.0, f64::max)
}

/// Returns the smallest amplitude of all scanned friction ratios with a complete evaluation, or infinity if there is
/// none.
pub(super) fn best(scan: &[Scanned]) -> f64 {
    let complete = scan.iter().filter(|scanned| scanned.complete);
    complete.fold(f64::INFINITY, |best, scanned| best.min(scanned.value))
}

/// Computes the scan: the largest amplitude over the band at a list of friction ratios. The list begins at 0. The list
/// ends at a friction ratio above which more friction no longer reduces the amplitude.
pub(super) fn scanned(band: &AmplitudeBand<'_>, free_to: f64, locked_from: f64) -> Vec<Scanned> {
    let unbounded_to = unbounded_to(band);
    let mut top = if locked_from.is_finite() {
        locked_from
    } else {
        (4.0 * free_to.max(1.0)).max(2.0 * unbounded_to)
    };
    let mut scan = Vec::new();
    let low = (LEAST * band.middle_limit()).min(0.5 * top);
    let geometric = (0..GEOMETRIC).map(|place| {
        let share = place as f64 / GEOMETRIC as f64;
        low * (top / low).powf(share)
    });
    let betas = (0..=SCAN)
        .map(|place| top * (place as f64 / SCAN as f64).powf(1.5))
        .chain(geometric)
        .chain(BOUNDED.map(|share| unbounded_to * (1.0 + share)))
        .chain([free_to])
        .filter(|beta| *beta < top);
    add(band, &mut scan, betas);
    if !locked_from.is_finite() {
        // The band contains a resonance of the chain with its contact stuck, at which no friction keeps the contact
        // stuck. The scan then ends at a friction ratio above which more friction no longer reduces the amplitude.
        for _ in 0..LONGER {
            let more = [1.0, 1.25, 1.5, 1.75].map(|share| top * share);
            add(band, &mut scan, more.into_iter());
            top *= 2.0;
            let least = best(&scan);
            let rising =
                |scanned: &Scanned| 0.0 < scanned.slope || FAR_ABOVE * least < scanned.value;
            if scan.iter().rev().take(4).all(rising) || band.amplitude.is_spent() {
                break;
            }
        }
    } else if band.amplitude.locks() {
        let peaks = band.peaks(FrictionAmount::Locked);
        scan.push(Scanned {
            beta: top,
            value: peaks.first().map_or(f64::INFINITY, |peak| peak.value),
            slope: 0.0,
            peaks,
            complete: true,
            whole: true,
        });
    } else {
        let beyond = BEYOND.map(|share| top * share);
        add(band, &mut scan, [top].into_iter().chain(beyond));
    }
    scan
}

/// Adds friction ratios to the scan, beginning with the smallest expected amplitude. Once a small amplitude is known,
/// closed forms alone suffice to reject most of the remaining friction ratios.
pub(super) fn add(
    band: &AmplitudeBand<'_>,
    scan: &mut Vec<Scanned>,
    betas: impl Iterator<Item = f64>,
) {
    let opened = betas.map(|beta| (beta, band.open(FrictionAmount::Ratio(beta))));
    let mut opened: Vec<(f64, OpenBand)> = opened.collect();
    opened.sort_by(|(_, a), (_, b)| a.expected.total_cmp(&b.expected));
    for (beta, open) in opened {
        if band.amplitude.is_spent() {
            break;
        }
        let look = band.look(open, MARGIN * best(scan), Closely::First);
        if !band.amplitude.is_spent() {
            scan.push(with_slope(beta, look, |peak| rough_slope(band, beta, peak)));
        }
    }
    scan.sort_by(|a, b| a.beta.total_cmp(&b.beta));
    scan.dedup_by(|a, b| a.beta == b.beta);
}

/// Adds the middle of each interval of the scan that may hide a minimum. An interval may hide a minimum if the
/// amplitude falls with friction at both bounds but is larger at the upper bound. It may also hide a minimum if the
/// amplitude rises at both bounds but is larger at the lower bound.
pub(super) fn closer(band: &AmplitudeBand<'_>, scan: &mut Vec<Scanned>) {
    for _ in 0..CLOSER {
        let best = best(scan);
        let hides = |below: &Scanned, above: &Scanned| {
            let (falls, rises) = (below.slope < 0.0, 0.0 <= above.slope);
            let hidden = (falls && !rises && below.value < above.value)
                || (rises && !falls && above.value < below.value);
            hidden && below.value.min(above.value) <= NEARLY * best && below.value.is_finite()
        };
        let middles: Vec<f64> = scan
            .windows(2)
            .filter_map(|pair| match pair {
                [below, above] if hides(below, above) => Some(0.5 * (below.beta + above.beta)),
                _ => None,
            })
            .take(MOST_CLOSER)
            .collect();
        if middles.is_empty() || band.amplitude.is_spent() {
            break;
        }
        add(band, scan, middles.into_iter());
    }
}

/// Evaluates the band at one friction ratio and returns the largest amplitude. The evaluation ends early if an
/// amplitude exceeds `cutoff`.
pub(super) fn scanned_at(band: &AmplitudeBand<'_>, beta: f64, cutoff: f64) -> Scanned {
    let open = band.open(FrictionAmount::Ratio(beta));
    let look = band.look(open, cutoff, Closely::First);
    with_slope(beta, look, |peak| rough_slope(band, beta, peak))
}

pub(super) fn with_slope(beta: f64, look: Look, slope: impl Fn(&BandPeak) -> f64) -> Scanned {
    let Look { peaks, complete } = look;
    let value = peaks.first().map_or(f64::NAN, |peak| peak.value);
    let slope = peaks
        .first()
        .filter(|peak| peak.value.is_finite())
        .map_or(f64::NAN, slope);
    Scanned {
        beta,
        value,
        slope,
        peaks,
        complete,
        whole: false,
    }
}

/// Returns the derivative of a peak's amplitude with respect to β, at the friction ratio `beta`.
pub(super) fn slope(band: &AmplitudeBand<'_>, beta: f64, peak: &BandPeak) -> f64 {
    if let Some([along_r, along_beta]) = band.amplitude.slopes(peak.r, beta)
        && (peak.edge || is_smooth(band, beta, peak, along_r))
    {
        return along_beta;
    }
    // The peak lies on a jump of the amplitude over frequency, and moves with the jump. A finite difference therefore
    // follows the peak.
    let h = DIFFERENCE * beta;
    let at = |beta: f64| {
        let peaks = band.followed(FrictionAmount::Ratio(beta), &[peak.r], f64::INFINITY);
        let distance = |other: &&BandPeak| (other.r - peak.r).abs();
        peaks
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .map_or(f64::NAN, |peak| peak.value)
    };
    (at(beta + h) - at(beta - h)) / (h + h)
}

/// Returns true if the amplitude is a smooth function of frequency at a maximum. At a kink, derivatives do not describe
/// the change of the peak.
fn is_smooth(band: &AmplitudeBand<'_>, beta: f64, peak: &BandPeak, along_r: f64) -> bool {
    if along_r.abs() * peak.r <= 1e-7 * peak.value {
        return true;
    }
    let step = 1e-6 * peak.r;
    let fall = |r: f64| peak.value - band.amplitude.at(r, FrictionAmount::Ratio(beta));
    let fallen = fall(peak.r - step).max(fall(peak.r + step));
    along_r.abs() * step <= 0.1 * fallen
}

/// Returns the derivative of the amplitude with respect to β, as a finite difference at the peak's frequency. Returns
/// NaN across a jump.
fn rough_slope(band: &AmplitudeBand<'_>, beta: f64, peak: &BandPeak) -> f64 {
    let at = |beta: f64| band.amplitude.at(peak.r, FrictionAmount::Ratio(beta));
    if beta == 0.0 {
        let h = 1e-6;
        return (at(h) - peak.value) / h;
    }
    let h = 1e-5 * beta;
    let slope = (at(beta + h) - at(beta - h)) / (h + h);
    if slope.abs() * beta <= STEEPEST * peak.value {
        slope
    } else {
        f64::NAN
    }
}
