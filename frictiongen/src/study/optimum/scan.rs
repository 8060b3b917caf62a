//! The largest amplitude over a band at friction ratios between none and so much that nothing slides, with its slope.

use super::amplitude::Friction;
use super::peaks::{Band, Peak};
use crate::study::system::System;

/// Friction ratios of the scan.
const SCAN: usize = 40;
/// Of a moving place a step of a difference.
const DIFFERENCE: f64 = 1e-6;
/// How often a scan without an end is made twice as long.
const LONGER: usize = 12;
/// A least that is hidden between two of the scan is looked for so often by halves,
const CLOSER: usize = 5;
/// if the lower of the two is within this share of the best.
const NEARLY: f64 = 1.2;
/// More places at most in one go.
const MOST_CLOSER: usize = 8;

/// The largest amplitude at one friction ratio.
#[derive(Clone, Debug)]
pub(super) struct Scanned {
    pub beta: f64,
    pub value: f64,
    /// Its derivative with respect to β; NaN where the amplitude is unbounded.
    pub slope: f64,
    pub peaks: Vec<Peak>,
}

/// Up to this friction ratio the amplitude at an undamped resonance of the band is unbounded; 0 where there is none.
pub(super) fn unbounded_to(system: &System, [from, to]: [f64; 2]) -> f64 {
    let modal = system.modal();
    let modes = modal.damping_ratios.iter().zip(system.resonances());
    let modes = modes.zip(system.resonance_thresholds());
    modes
        .filter(|((zeta, resonance), _)| zeta.is_zero() && from <= **resonance && **resonance <= to)
        .filter_map(|(_, threshold)| threshold)
        .fold(0.0, f64::max)
}

/// The scan.
pub(super) fn scanned(band: &Band<'_>, free_to: f64, locked_from: f64) -> Vec<Scanned> {
    let at = |beta: f64| scanned_at(band, beta);
    let mut top = if locked_from.is_finite() {
        locked_from
    } else {
        let unbounded_to = unbounded_to(band.amplitude.system, band.ends());
        (4.0 * free_to.max(1.0)).max(2.0 * unbounded_to)
    };
    let mut scan: Vec<Scanned> = (0..=SCAN)
        .map(|place| top * (place as f64 / SCAN as f64).powf(1.5))
        .chain([free_to])
        .filter(|beta| *beta < top)
        .map(at)
        .collect();
    if locked_from.is_finite() {
        let peaks = band.peaks(Friction::Locked);
        scan.push(Scanned {
            beta: top,
            value: peaks.first().map_or(f64::INFINITY, |peak| peak.value),
            slope: 0.0,
            peaks,
        });
    } else {
        // Beside a resonance of the stuck chain nothing holds the contact: until friction no longer helps.
        for _ in 0..LONGER {
            for share in [1.0, 1.25, 1.5, 1.75] {
                scan.push(at(top * share));
            }
            top *= 2.0;
            let rising = |scanned: &Scanned| 0.0 < scanned.slope;
            if scan.iter().rev().take(4).all(rising) {
                break;
            }
        }
    }
    scan.sort_by(|a, b| a.beta.total_cmp(&b.beta));
    scan.dedup_by(|a, b| a.beta == b.beta);
    scan
}

/// The same with more places where a least is hidden: where the amplitude falls from one of two neighbours, and the other is
/// higher although it falls there too; and the other way round.
pub(super) fn closer(band: &Band<'_>, mut scan: Vec<Scanned>) -> Vec<Scanned> {
    for _ in 0..CLOSER {
        let values = scan.iter().map(|scanned| scanned.value);
        let best = values
            .filter(|value| value.is_finite())
            .fold(f64::INFINITY, f64::min);
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
        if middles.is_empty() {
            break;
        }
        scan.extend(middles.into_iter().map(|beta| scanned_at(band, beta)));
        scan.sort_by(|a, b| a.beta.total_cmp(&b.beta));
    }
    scan
}

pub(super) fn scanned_at(band: &Band<'_>, beta: f64) -> Scanned {
    let peaks = band.peaks(Friction::Ratio(beta));
    with_slope(beta, peaks, |peak| rough_slope(band, beta, peak))
}

pub(super) fn with_slope(beta: f64, peaks: Vec<Peak>, slope: impl Fn(&Peak) -> f64) -> Scanned {
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
    }
}

/// The derivative of a peak's height with respect to β.
pub(super) fn slope(band: &Band<'_>, beta: f64, peak: &Peak) -> f64 {
    if let Some([along_r, along_beta]) = band.amplitude.slopes(peak.r, beta)
        && (peak.edge || is_smooth(band, beta, peak, along_r))
    {
        return along_beta;
    }
    // It moves along a jump: as it is followed.
    let h = DIFFERENCE * beta;
    let at = |beta: f64| {
        let peaks = band.followed(Friction::Ratio(beta), &[peak.r]);
        let distance = |other: &&Peak| (other.r - peak.r).abs();
        peaks
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .map_or(f64::NAN, |peak| peak.value)
    };
    (at(beta + h) - at(beta - h)) / (h + h)
}

/// Whether a maximum is one of a smooth function: beside it the tangent tells nothing.
fn is_smooth(band: &Band<'_>, beta: f64, peak: &Peak, along_r: f64) -> bool {
    if along_r.abs() * peak.r <= 1e-7 * peak.value {
        return true;
    }
    let step = 1e-6 * peak.r;
    let fall = |r: f64| peak.value - band.amplitude.at(r, Friction::Ratio(beta));
    let fallen = fall(peak.r - step).max(fall(peak.r + step));
    along_r.abs() * step <= 0.1 * fallen
}

/// The same by a difference at the peak's place.
fn rough_slope(band: &Band<'_>, beta: f64, peak: &Peak) -> f64 {
    let at = |beta: f64| band.amplitude.at(peak.r, Friction::Ratio(beta));
    if beta == 0.0 {
        let h = 1e-6;
        return (at(h) - peak.value) / h;
    }
    let h = 1e-5 * beta;
    (at(beta + h) - at(beta - h)) / (h + h)
}
