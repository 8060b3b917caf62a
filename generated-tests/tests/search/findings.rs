//! Both searches against brute force, scene by scene.

use crate::plain::{Plain, largest};
use crate::random::{Lcg, random_scene};
use frictiongen::NotContinuous;
use frictiongen::study::System;
use std::f64::consts::PI;

/// The kernel's own ceiling; a search that ends on it has no guarantee any more.
pub const CEILING: u32 = 20_000;

/// What a run over many scenes found.
#[derive(Default)]
pub struct Findings {
    pub scenes: usize,
    pub searched: usize,
    pub ill: usize,
    pub masses: usize,
    pub constraint_counts: Vec<(u32, String)>,
    pub amplitude_counts: Vec<(u32, String)>,
    pub disagreements: Vec<String>,
    pub worst_beta: f64,
    pub worst_amplitude: f64,
}

pub fn compare(random: &mut Lcg, findings: &mut Findings, least: usize) {
    let text = random_scene(random);
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let r = system.resonances()[0] * random.log_uniform(0.02, 5.0);
    let share = 0.02 + 0.96 * random.unit();
    findings.scenes += 1;
    let at = system.at(r).unwrap();
    let (found, evaluations) = at.continuous_limit_counted();
    findings
        .constraint_counts
        .push((evaluations, format!("r = {r:?}\n    {text}")));

    let plain = Plain::new(&system, r, 0.0, false);
    let limit = plain.limit(&system, least);
    findings.searched += usize::from(limit.searched);
    // Rounding of the modal data and of the sums, a few hundred units of it, times the condition.
    let rounding = 500.0 * f64::EPSILON * limit.condition;
    findings.ill += usize::from(rounding > 1e-9);
    // Too large a β_lim is a missed maximum of the constraint: the stricter side.
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
        Err(NotContinuous::Unbounded) => return,
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
        findings.amplitude_counts.push((
            peak.evaluations,
            format!("m{k}, beta = {beta:?}, r = {r:?}\n    {text}"),
        ));
        // Near a resonance large terms cancel: what they lose is no error of the search.
        let rounding =
            500.0 * f64::EPSILON * limit.condition * (size + beta * friction_size) / amplitude;
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
        // The search against the very function that it searches: no excuse but rounding.
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

pub fn median(counts: &mut [(u32, String)]) -> u32 {
    counts.sort_by_key(|count| std::cmp::Reverse(count.0));
    counts[counts.len() / 2].0
}

pub fn report(findings: &mut Findings, listed: usize) {
    println!(
        "{} scenes, S decides in {}, ill-conditioned {}, {} masses; worst beta_lim error {:e}, amplitude error {:e}",
        findings.scenes,
        findings.searched,
        findings.ill,
        findings.masses,
        findings.worst_beta,
        findings.worst_amplitude
    );
    for (name, counts) in [
        ("velocity constraint", &mut findings.constraint_counts),
        ("amplitude", &mut findings.amplitude_counts),
    ] {
        let median = median(counts);
        let n = counts.len();
        let begun = counts.iter().filter(|count| count.0 > 0).count();
        println!(
            "{name}: {n} searches, median {median}, of the {begun} with any {}, 99 % below {}, 99.9 % below {}, worst {}, at the ceiling {}",
            counts[begun / 2].0,
            counts[n / 100].0,
            counts[n / 1000].0,
            counts[0].0,
            counts.iter().filter(|count| count.0 >= CEILING).count()
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
