//! Compares the searches for β_lim and for an amplitude with brute force, scene by scene.

use crate::search::led::Led;
use crate::search::plain::{Plain, largest};
use crate::search::random::random_scene;
use frictiongen::NotContinuous;
use frictiongen::study::System;
use frictiongen_kernel::modal_sum::search::MAX_EVALUATIONS;
use fuzzing::Random;
use std::f64::consts::PI;

/// Results of a run over many scenes.
#[derive(Default)]
pub struct Findings {
    pub scenes: usize,
    pub searched: usize,
    pub ill: usize,
    pub masses: usize,
    /// Number of compared phases, and number of phases whose maximum occurs at two instants with equal values.
    pub phases: usize,
    pub ties: usize,
    /// Number of scenes on an undamped resonance.
    pub unbounded: usize,
    pub constraint_counts: Vec<(u32, String)>,
    pub amplitude_counts: Vec<(u32, String)>,
    pub disagreements: Vec<String>,
    pub worst_beta: f64,
    pub worst_amplitude: f64,
    pub worst_fall: f64,
    /// Results of amplitude searches that start from the results of other searches.
    pub led: Led,
}

pub fn compare(random: &mut Random, findings: &mut Findings, least: usize, most: usize) {
    let text = random_scene(random, most);
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let r = system.resonances()[0] * random.log_uniform(0.02, 5.0);
    let share = 0.02 + 0.96 * random.unit();
    findings.scenes += 1;
    let at = system.at(r).unwrap();
    let (found, evaluations) = (at.continuous_limit(), at.velocity_constraint().evaluations);
    findings
        .constraint_counts
        .push((evaluations, format!("r = {r:?}\n    {text}")));

    let plain = Plain::new(&system, r, 0.0, false);
    let limit = plain.limit(&system, least);
    findings.searched += usize::from(limit.searched);
    // The rounding error is a few hundred rounding units of the modal data and of the sums, times the condition
    // number.
    let rounding = 500.0 * f64::EPSILON * limit.condition;
    findings.ill += usize::from(rounding > 1e-9);
    // A β_lim that is too large means a missed maximum of the constraint, so the tolerance on this side is smaller.
    let error = found / limit.beta - 1.0;
    let tolerance = rounding.max(if error > 0.0 { 1e-10 } else { 1e-9 });
    if rounding <= 1e-9 {
        findings.worst_beta = findings.worst_beta.max(error.abs());
    }
    if !(error.abs() <= tolerance) {
        findings.disagreements.push(format!(
            "beta_lim = {found:?}, brute force {:?}: off by {error:e}, tolerance {tolerance:e}, \
             {evaluations} evaluations\n    r = {r:?}\n    {text}",
            limit.beta
        ));
        return;
    }

    let beta = share * found.min(at.sliding_limit());
    let motion = match at.motion(beta) {
        Ok(motion) => motion,
        Err(NotContinuous::Unbounded) => {
            findings.unbounded += 1;
            return;
        }
        Err(error) => {
            findings.disagreements.push(format!(
                "{error:?} at beta = {beta:?} below both limits\n    r = {r:?}\n    {text}"
            ));
            return;
        }
    };
    let (v, u, _, _) = plain.contact();
    let modulus = v.0.hypot(v.1);
    let phase =
        (-beta * u).atan2(((modulus - beta * u) * (modulus + beta * u)).sqrt()) - v.1.atan2(v.0);
    for k in 0..plain.modes.len() {
        let (mut response, mut friction_size) = ((0.0, 0.0), 0.0);
        for mode in &plain.modes {
            let a = mode.phi[k] * mode.p / mode.lambda;
            response = (response.0 + a * mode.v.0, response.1 + a * mode.v.1);
            friction_size += (mode.phi[k] * mode.w / mode.lambda).abs()
                * (2.0 + mode.g.abs() + (mode.u / mode.x).abs());
        }
        let size = response.0.hypot(response.1);
        let lag = phase + response.1.atan2(response.0);
        let displacement = |tau: f64| -> f64 {
            let friction: f64 = plain
                .modes
                .iter()
                .map(|m| m.phi[k] * m.w / m.lambda * m.h(tau))
                .sum();
            size * (tau + lag).cos() + beta * friction
        };
        let (tau, brute) = largest(|tau| displacement(tau).abs(), plain.points(least));
        let mass = motion.mass(&format!("m{k}")).unwrap();
        let peak = mass.peak();
        let amplitude = mass.amplitude();
        findings.masses += 1;
        let terms = limit.condition * (size + beta * friction_size);
        let led = &mut findings.led;
        for neighbours in [[0.998, 0.999, 1.001], [1.1, 0.9, 0.5]] {
            led.add(&system, (r, beta), neighbours, &format!("m{k}"), terms);
        }
        findings.amplitude_counts.push((
            peak.evaluations,
            format!("m{k}, beta = {beta:?}, r = {r:?}\n    {text}"),
        ));
        // Near a resonance large terms cancel. The lost digits are no error of the search.
        let rounding = 500.0 * f64::EPSILON * terms / amplitude;
        let error = amplitude / brute - 1.0;
        let tolerance = rounding.max(if error < 0.0 { 1e-10 } else { 1e-9 });
        if rounding <= 1e-9 {
            findings.worst_amplitude = findings.worst_amplitude.max(error.abs());
        }
        if !(error.abs() <= tolerance) {
            findings.disagreements.push(format!(
                "m{k}: amplitude = {amplitude:?}, brute force {brute:?} at tau = {tau:?}: off by \
                 {error:e}, tolerance {tolerance:e}, {} evaluations\n    beta = {beta:?}, r = {r:?}\n    {text}",
                peak.evaluations
            ));
        }
        // The phase is checked by the value and the sign of the plain motion at that instant.
        let answer = mass.phase();
        let apart = |tau: f64, value: f64| {
            let turned = if value < 0.0 { PI } else { 0.0 };
            let off = (phase + tau + turned - answer) / (2.0 * PI);
            (off - off.round()).abs() * 2.0 * PI
        };
        findings.phases += 1;
        let lag = ((answer - phase) / PI).rem_euclid(2.0);
        let (place, sign) = if lag < 1.0 {
            (lag, 1.0)
        } else {
            (lag - 1.0, -1.0)
        };
        let there = sign * displacement(place * PI);
        let fall = 1.0 - there / brute;
        // An error of √ε in the instant lowers the value at a maximum only by about ε.
        let allowed = 1e-11_f64.max(rounding);
        if rounding <= 1e-9 {
            findings.worst_fall = findings.worst_fall.max(fall);
        }
        if !(fall <= allowed) {
            findings.disagreements.push(format!(
                "m{k}: phase = {answer:?}, where the motion is less than its maximum by {fall:e}\n    \
                 beta = {beta:?}, r = {r:?}\n    {text}"
            ));
        }
        if apart(tau, displacement(tau)) > 1e-2 {
            findings.ties += 1;
        }
        // The search is compared with the very function that it searches, so only rounding is allowed.
        for i in 0..32 {
            let tau = tau
                + if i == 0 {
                    0.0
                } else {
                    f64::from(i) * PI / 32.0
                };
            let value = mass.displacement(tau).abs();
            if !(value <= amplitude * (1.0 + 1e-12)) {
                findings.disagreements.push(format!(
                    "m{k}: |displacement({tau:?})| = {value:?} above amplitude = {amplitude:?}\n    beta = {beta:?}, r = {r:?}\n    {text}"
                ));
            }
        }
    }
}

/// Sorts the numbers of evaluations, largest first. Returns the number that a fraction `share` of the searches
/// exceeds.
pub fn quantile(counts: &mut [(u32, String)], share: f64) -> u32 {
    counts.sort_by_key(|count| std::cmp::Reverse(count.0));
    counts[(counts.len() as f64 * share) as usize].0
}

/// Asserts upper bounds on the median, the 99 % quantile and the maximum of the numbers of evaluations.
pub fn within(name: &str, counts: &mut [(u32, String)], (median, most, worst): (u32, u32, u32)) {
    let found = [0.5, 0.01, 0.0].map(|share| quantile(counts, share));
    assert!(
        found[0] <= median && found[1] <= most && found[2] <= worst,
        "{name}: {found:?} evaluations; the worst {}",
        counts[0].1
    );
    assert!(found[2] < MAX_EVALUATIONS);
}

pub fn report(findings: &mut Findings, listed: usize) {
    println!(
        "{} scenes, S decides in {}, {} unbounded, ill-conditioned {}, {} masses, {} phases of which {} with an equal; \
         worst beta_lim error {:e}, amplitude error {:e}, fall at a phase {:e}",
        findings.scenes,
        findings.searched,
        findings.unbounded,
        findings.ill,
        findings.masses,
        findings.phases,
        findings.ties,
        findings.worst_beta,
        findings.worst_amplitude,
        findings.worst_fall
    );
    for (name, counts) in [
        ("velocity constraint", &mut findings.constraint_counts),
        ("amplitude", &mut findings.amplitude_counts),
    ] {
        let [median, most, nearly_all, worst] =
            [0.5, 0.01, 0.001, 0.0].map(|share| quantile(counts, share));
        let begun = counts.iter().filter(|count| count.0 > 0).count();
        println!(
            "{name}: {} searches, median {median}, of the {begun} with any {}, 99 % below {most}, 99.9 % below {nearly_all}, worst {worst}, at the ceiling {}",
            counts.len(),
            counts[begun / 2].0,
            counts
                .iter()
                .filter(|count| count.0 >= MAX_EVALUATIONS - 32)
                .count()
        );
        for (count, scene) in counts.iter().take(listed) {
            println!("  {count} evaluations: {scene}");
        }
    }
    println!("{} disagreements", findings.disagreements.len());
    for text in findings.disagreements.iter().take(20) {
        println!("  {text}");
    }
}
