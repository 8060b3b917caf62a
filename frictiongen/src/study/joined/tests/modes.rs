//! Tests of the damped modes, with closed forms and with the coefficients of the characteristic polynomial.

use super::{FRAME, apart, system};
use crate::Complex;
use crate::study::joined::{DampedMode, DampedModes};

const RIGID: DampedMode = DampedMode {
    frequency: 0.0,
    damping_ratio: Some(0.0),
    decay_rate: 0.0,
};

/// Returns the modes of a scene with each set of stuck contacts.
fn sets(text: &str) -> Vec<DampedModes> {
    system(text).damped_modes().expect("modes")
}

/// Asserts frequency and damping ratio of an oscillation.
fn assert_mode(mode: &DampedMode, frequency: f64, zeta: f64) {
    assert!(
        apart(mode.frequency, frequency) < 1e-13,
        "{mode:?} {frequency}"
    );
    let ratio = mode.damping_ratio.expect("an oscillation");
    assert!((ratio - zeta).abs() < 1e-13, "{mode:?} {zeta}");
    assert!((mode.decay_rate - zeta * frequency).abs() < 1e-13 * frequency);
}

/// Asserts the decay rate of a real root.
fn assert_decay(mode: &DampedMode, rate: f64, accuracy: f64) {
    assert_eq!((mode.frequency, mode.damping_ratio), (0.0, None));
    assert!(apart(mode.decay_rate, rate) < accuracy, "{mode:?} {rate}");
}

/// One mass with two elastic contacts and a dashpot: √(k/m) and c/(2√(km)), with the stiffness of each set.
#[test]
fn each_set_of_stuck_contacts() {
    let text = "struct Block { masses: { block: 2 }, springs: { base - block: 50 },
        contacts: { one: base - block { stiffness: 30 }, two: block - wall { stiffness: 70 } },
        dampers: { block - wall: 0.4 }, excitation: block }";
    let found = sets(text);
    let names: Vec<String> = found.iter().map(|set| set.stuck.join(" ")).collect();
    assert_eq!(names, ["", "one", "two", "one two"]);
    for (set, stiffness) in found.iter().zip([50.0_f64, 80.0, 120.0, 150.0]) {
        let zeta = 0.4 / (2.0 * (2.0 * stiffness).sqrt());
        assert_eq!(set.modes.len(), 1);
        assert_mode(&set.modes[0], (0.5 * stiffness).sqrt(), zeta);
    }
    let system = system(text);
    let found = system.joined().expect("a solver").resonances();
    for ([r, zeta], stiffness) in found.into_iter().zip([50.0_f64, 80.0, 120.0, 150.0]) {
        assert!((r - (stiffness / 50.0).sqrt()).abs() < 1e-12, "{r}");
        assert_eq!([50.0, 150.0].contains(&stiffness), !zeta.is_nan());
    }
}

/// A single `contact` has two sets. With more than 4 contacts the list has no contact, each contact, and all contacts.
#[test]
fn sets_of_one_and_of_five_contacts() {
    let found = sets(
        "struct Block { masses: { block: 2 }, springs: { base - block: 50 },
        contact: block - wall, stiffness: 150, damping: modal(0.02), excitation: block }",
    );
    let names: Vec<&[String]> = found.iter().map(|set| &set.stuck[..]).collect();
    assert_eq!(names, [&[][..], &["contact".to_owned()]]);
    assert_mode(&found[0].modes[0], 5.0, 0.02);
    // Modal damping is the force 2ζω₁m times the velocity. The contact doubles the frequency.
    assert_mode(&found[1].modes[0], 10.0, 0.01);
    let five: String = (1..=5)
        .map(|number| format!("c{number}: block - wall {{ stiffness: {number} }}, "))
        .collect();
    let found = sets(&format!(
        "struct Five {{ masses: {{ block: 1 }}, springs: {{ base - block: 1 }},
        contacts: {{ {five} }}, excitation: block }}"
    ));
    let frequencies: Vec<f64> = found.iter().map(|set| set.modes[0].frequency).collect();
    let sums = [1.0_f64, 2.0, 3.0, 4.0, 5.0, 6.0, 16.0];
    assert_eq!(frequencies.len(), sums.len());
    for (frequency, sum) in frequencies.iter().zip(sums) {
        assert!(apart(*frequency, sum.sqrt()) < 1e-14);
    }
}

/// One mass with c above 2√(km) has two real roots, and with c = 2√(km) a double root.
#[test]
fn overdamped_and_critically_damped() {
    let block = |coefficient: f64| {
        let text = format!(
            "struct Block {{ masses: {{ block: 2 }}, springs: {{ base - block: 50 }},
            contact: block - wall, dampers: {{ base - block: {coefficient:?} }}, excitation: block }}"
        );
        let mut found = sets(&text);
        // The rigid contact holds the only mass.
        assert!(found[1].modes.is_empty());
        found.swap_remove(0).modes
    };
    for coefficient in [20.5_f64, 25.0, 4e3, 4e9] {
        let half = 0.25 * coefficient;
        let fast = half + (half * half - 25.0).sqrt();
        let modes = block(coefficient);
        assert_eq!(modes.len(), 2);
        assert_decay(&modes[0], 25.0 / fast, 1e-13);
        assert_decay(&modes[1], fast, 1e-13);
    }
    for mode in block(20.0) {
        assert_decay(&mode, 5.0, 1e-15);
    }
    assert_mode(&block(19.9)[0], 5.0, 0.995);
}

/// Two equal masses with a dashpot between them: it damps only the mode in which the masses move against each other.
#[test]
fn two_equal_masses_with_a_dashpot_between_them() {
    let pair = |coefficient: f64| {
        sets(&format!(
            "struct Pair {{ masses: {{ a: 2, b: 2 }}, springs: {{ base - a: 18, a - b: 16, b - wall: 18 }},
            contacts: {{ pads: a - b }}, dampers: {{ a - b: {coefficient:?} }}, excitation: a }}"
        ))
    };
    let found = pair(1.5);
    assert_mode(&found[0].modes[0], 3.0, 0.0);
    assert_mode(&found[0].modes[1], 5.0, 1.5 / 10.0);
    // The stuck contact joins the masses: 36 N/m for 4 kg, and no motion in the dashpot.
    assert_eq!(found[1].modes.len(), 1);
    assert_mode(&found[1].modes[0], 3.0, 0.0);
    let critical = &pair(10.0)[0].modes;
    assert_mode(&critical[0], 3.0, 0.0);
    assert_decay(&critical[1], 5.0, 1e-7);
    assert_decay(&critical[2], 5.0, 1e-7);
}

/// A rigid contact between two masses joins them, and a rigid contact to the wall holds its mass.
#[test]
fn rigid_contacts_join_masses() {
    let found = sets(
        "struct Pair { masses: { a: 3, b: 5 }, springs: { base - a: 32, a - b: 7, b - wall: 96 },
        contacts: { pads: a - b, floor: b - wall }, dampers: { base - a: 1.6 }, excitation: base }",
    );
    assert_eq!(found[1].stuck, ["pads"]);
    assert_mode(&found[1].modes[0], 4.0, 1.6 / (2.0 * 8.0 * 4.0));
    assert_eq!(found[2].stuck, ["floor"]);
    assert_mode(
        &found[2].modes[0],
        13.0_f64.sqrt(),
        1.6 / (2.0 * 39.0_f64.sqrt() * 3.0_f64.sqrt()),
    );
    assert!(found[3].modes.is_empty());
}

/// Rayleigh damping gives ζᵢ = a/(2ωᵢ) + bωᵢ/2. Three equal masses on four equal springs have ωᵢ = 2√(k/m)sin(iπ/8).
#[test]
fn three_masses_with_rayleigh_damping() {
    let found = sets(
        "struct Chain { masses: { a: 2, b: 2, c: 2 },
        springs: { base - a: 200, a - b: 200, b - c: 200, c - wall: 200 }, contact: c - wall,
        damping: rayleigh(0.3, 0.002), excitation: a }",
    );
    for (number, mode) in (1..).zip(&found[0].modes) {
        let frequency = 20.0 * (f64::from(number) * std::f64::consts::PI / 8.0).sin();
        assert_mode(mode, frequency, 0.15 / frequency + 0.001 * frequency);
    }
}

/// Rigid-body modes have the frequency 0: two masses with a spring and a dashpot, and two masses with a dashpot only.
#[test]
fn masses_without_a_support() {
    let found = sets(
        "struct Pair { masses: { a: 2, b: 3 }, springs: { a - b: 500 },
        contacts: { clutch: a - b }, dampers: { a - b: 4 }, excitation: a }",
    );
    assert_eq!(found[0].modes[0], RIGID);
    let frequency = (500.0_f64 * (1.0 / 2.0 + 1.0 / 3.0)).sqrt();
    let zeta = 4.0 * (1.0 / 2.0 + 1.0 / 3.0) / (2.0 * frequency);
    assert_mode(&found[0].modes[1], frequency, zeta);
    assert_eq!(found[1].modes, [RIGID]);
    let found = sets(
        "struct Loose { masses: { a: 2, b: 3, c: 7 }, contacts: { clutch: a - b { stiffness: 6 } },
        dampers: { a - b: 4, c - wall: 2 }, excitation: a }",
    );
    let free = &found[0].modes;
    assert_eq!(free.len(), 5);
    assert_eq!(free[..3], [RIGID; 3]);
    assert_decay(&free[3], 2.0 / 7.0, 1e-13);
    assert_decay(&free[4], 4.0 * (1.0 / 2.0 + 1.0 / 3.0), 1e-13);
}

/// Returns the roots of λ⁴ + c₃λ³ + c₂λ² + c₁λ + c₀ by the simultaneous iteration of Durand and Kerner.
fn roots(coefficients: [f64; 4]) -> Vec<Complex<f64>> {
    let value = |at: Complex<f64>| {
        let terms = coefficients.iter();
        terms.fold(Complex::new(1.0, 0.0), |sum, c| sum * at + c)
    };
    let size = coefficients[3].powf(0.25);
    let mut roots: Vec<Complex<f64>> = (0..4)
        .map(|power| size * Complex::new(0.4, 0.9).powi(power))
        .collect();
    for _ in 0..500 {
        for index in 0..4 {
            let others = (0..4).filter(|other| *other != index);
            let product: Complex<f64> = others.map(|other| roots[index] - roots[other]).product();
            let step = value(roots[index]) / product;
            roots[index] -= step;
        }
    }
    roots
}

/// Two masses with dashpots that couple the modes, from slight to strong damping. The test solves the characteristic
/// polynomial det(λ²M + λC + K) = 0 without matrices.
#[test]
fn two_masses_with_coupled_modes() {
    let ([m, n], [k, l]) = ([2.0, 0.7], [150.0, 40.0]);
    for [c, d] in [
        [0.01, 0.0],
        [1.0, 0.3],
        [0.0, 9.0],
        [60.0, 2.0],
        [80.0, 40.0],
        [3e3, 0.01],
    ] {
        let damper = |ends: &str, value: f64| match value {
            0.0 => String::new(),
            value => format!("{ends}: {value:?},"),
        };
        let text = format!(
            "struct Pair {{ masses: {{ a: {m:?}, b: {n:?} }}, springs: {{ base - a: {k:?}, a - b: {l:?} }},
            contacts: {{ pads: a - b }}, dampers: {{ {} {} }}, excitation: base }}",
            damper("base - a", c),
            damper("a - b", d),
        );
        let wanted = roots([
            (m * d + n * (c + d)) / (m * n),
            (m * l + n * (k + l) + c * d) / (m * n),
            (c * l + k * d) / (m * n),
            k * l / (m * n),
        ]);
        let mut found: Vec<Complex<f64>> = Vec::new();
        for mode in &sets(&text)[0].modes {
            match mode.damping_ratio {
                None => found.push(Complex::new(-mode.decay_rate, 0.0)),
                Some(zeta) => {
                    let im = mode.frequency * (1.0 - zeta * zeta).sqrt();
                    found.extend([im, -im].map(|im| Complex::new(-mode.decay_rate, im)));
                }
            }
        }
        assert_eq!(found.len(), 4);
        for root in wanted {
            let near = found.iter().map(|own| (own - root).norm());
            let near = near.fold(f64::INFINITY, f64::min);
            assert!(
                near < 1e-11 * root.norm().max(1.0),
                "{c} {d}: {root} {near:e} {found:?}"
            );
        }
    }
}

/// The product of all roots is det K/det M, and their sum is −tr M⁻¹C. A fixed chain has det K = Πk Σ(1/k) for springs
/// in a row between two supports.
#[test]
fn product_and_sum_of_all_roots() {
    for count in [3_usize, 12, 40] {
        let number = |index: usize, base: f64| base * (1.0 + 0.9 * ((7 * index) as f64).sin());
        let name = |index: usize| match index {
            0 => "base".to_owned(),
            index if index > count => "wall".to_owned(),
            index => format!("m{index}"),
        };
        let list =
            |of: &dyn Fn(usize) -> String, last: usize| (1..=last).map(of).collect::<String>();
        let masses = list(&|i| format!("m{i}: {:?}, ", number(i, 2.0)), count);
        let between = |i: usize| format!("{} - {}", name(i - 1), name(i));
        let springs = list(
            &|i| format!("{}: {:?}, ", between(i), number(2 * i, 300.0)),
            count + 1,
        );
        let dashpots = list(
            &|i| format!("{}: {:?}, ", between(i), number(3 * i, 1.5)),
            count + 1,
        );
        let found = sets(&format!(
            "struct Chain {{ masses: {{ {masses} }}, springs: {{ {springs} }}, dampers: {{ {dashpots} }},
            contacts: {{ pads: m1 - wall }}, excitation: base }}"
        ));
        let stiffness = |i: usize| number(2 * i, 300.0);
        let compliance: f64 = (1..=count + 1).map(|i| 1.0 / stiffness(i)).sum();
        let wanted = (1..=count + 1).map(|i| stiffness(i).ln()).sum::<f64>() + compliance.ln()
            - (1..=count).map(|i| number(i, 2.0).ln()).sum::<f64>();
        let modes = &found[0].modes;
        let product: f64 = modes
            .iter()
            .map(|mode| match mode.damping_ratio {
                None => mode.decay_rate.ln(),
                Some(_) => 2.0 * mode.frequency.ln(),
            })
            .sum();
        assert!((product - wanted).abs() < 1e-11, "{product} {wanted}");
        let sum: f64 = modes
            .iter()
            .map(|mode| match mode.damping_ratio {
                None => mode.decay_rate,
                Some(_) => 2.0 * mode.decay_rate,
            })
            .sum();
        let trace: f64 = (1..=count)
            .map(|i| (number(3 * i, 1.5) + number(3 * i + 3, 1.5)) / number(i, 2.0))
            .sum();
        assert!(apart(sum, trace) < 1e-12, "{sum} {trace}");
    }
}

/// Without damping, the frequencies of both extreme sets are those of the modal analysis in double-double. The springs
/// differ by a factor of 10⁸.
#[test]
fn undamped_frequencies_of_stiff_and_soft_springs() {
    let found = sets("struct Chain { masses: { a: 1, b: 3, c: 0.2 }, springs: { base - a: 1, a - b: 1e8, b - c: 3 },
        contacts: { one: c - wall { stiffness: 1e4 } }, excitation: a }");
    for (set, spring) in found.iter().zip(["", ", c - wall: 1e4"]) {
        let exact = system(&format!(
            "struct Chain {{ masses: {{ a: 1, b: 3, c: 0.2 }}, springs: {{ base - a: 1, a - b: 1e8, b - c: 3{spring} }},
            contact: a - wall, excitation: a }}"
        ));
        for (mode, frequency) in set.modes.iter().zip(exact.natural_frequencies()) {
            assert!(
                apart(mode.frequency, frequency) < 1e-11,
                "{mode:?} {frequency}"
            );
        }
    }
}

/// A stuck contact joins two masses, and the spring between them has no effect. The frequencies are those of the joined
/// chain in double-double.
#[test]
fn frequencies_of_a_joined_chain() {
    let masses = "m0: 1.9, m1: 0.62, m2: 0.15, m3: 1.2, m4: 6.7, m5: 0.59, m6: 5.97";
    let chain = |masses: &str, springs: &str, contact: &str| {
        format!(
            "struct Chain {{ masses: {{ {masses} }}, springs: {{ base - m0: 3460, m0 - m1: 9.2, m1 - m2: 5500,
            m2 - m3: 1966, {springs} }}, {contact}, excitation: base }}"
        )
    };
    let found = sets(&chain(
        &format!("{masses}, m7: 2.5"),
        "m3 - m4: 6718, m4 - m5: 6966, m5 - m6: 262, m6 - m7: 169",
        "contacts: { pads: m3 - m4, floor: m7 - wall { stiffness: 37 } }",
    ));
    let exact = system(&chain(
        &format!("{}, m7: 2.5", masses.replace("m3: 1.2, m4: 6.7", "m3: 7.9")),
        "m3 - m5: 6966, m5 - m6: 262, m6 - m7: 169, m7 - wall: 37",
        "contact: m0 - wall",
    ));
    assert_eq!(found[3].modes.len(), 7);
    for (mode, frequency) in found[3].modes.iter().zip(exact.natural_frequencies()) {
        assert!(
            apart(mode.frequency, frequency) < 1e-13,
            "{mode:?} {frequency}"
        );
    }
}

/// The list of the frame has every set, and modal damping adds to the dashpot.
#[test]
fn the_frame_has_four_sets() {
    let found = sets(FRAME);
    let names: Vec<String> = found.iter().map(|set| set.stuck.join(" ")).collect();
    assert_eq!(names, ["", "brace", "pads", "brace pads"]);
    let free = system(FRAME);
    let ratios = found[0].modes.iter().map(|mode| mode.damping_ratio);
    assert!(ratios.flatten().all(|zeta| zeta > 0.01));
    for (mode, frequency) in found[0].modes.iter().zip(free.natural_frequencies()) {
        assert!(apart(mode.frequency, frequency) < 1e-3);
    }
}
