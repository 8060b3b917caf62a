//! Generates random scenes, which are the same on every machine.

use fuzzing::Random;
use std::fmt::Write as _;

/// Returns a random relative distance of either sign, whose modulus is between `epsilon` (the rounding unit) and
/// 10⁻¹.
pub fn nearness(random: &mut Random, epsilon: f64) -> f64 {
    let distance = random.power(epsilon.log10(), -1.0);
    if random.unit() < 0.5 {
        distance
    } else {
        -distance
    }
}

/// Returns the description of a chain whose masses and springs are spread between 10^−`decades` and 10^`decades` at
/// most.
pub fn scene(random: &mut Random, decades: f64) -> String {
    let n = 1 + random.below(16);
    let mut text = String::from("struct Random { masses: { ");
    let spread = decades * random.unit();
    for i in 0..n {
        write!(text, "m{i}: {:e}, ", random.power(-spread, spread)).unwrap();
    }
    text.push_str("}, springs: { ");
    let mut springs = vec![(String::from("base"), 0)];
    springs.extend((1..n).map(|i| (format!("m{}", i - 1), i)));
    if random.unit() < 0.3 {
        springs.push((String::from("wall"), random.below(n)));
    }
    for (from, to) in springs {
        write!(
            text,
            "{from} - m{to}: {:e}, ",
            random.power(-spread, spread)
        )
        .unwrap();
    }
    text.push_str("}, contact: ");
    let j = random.below(n);
    match random.below(if n > 1 { 3 } else { 2 }) {
        0 => write!(text, "m{j} - wall, ").unwrap(),
        1 => write!(text, "m{j} - base, ").unwrap(),
        _ => write!(text, "m{j} - m{}, ", (j + 1 + random.below(n - 1)) % n).unwrap(),
    }
    if random.unit() < 0.4 {
        text.push_str("excitation: base, ");
    } else {
        write!(text, "excitation: m{}, ", random.below(n)).unwrap();
    }
    match random.below(5) {
        0 | 1 => {}
        2 => write!(text, "damping: modal({:e}), ", random.power(-18.0, 1.0)).unwrap(),
        3 => {
            text.push_str("damping: modal[");
            for _ in 0..n {
                let zeta = match random.below(8) {
                    0 => 0.0,
                    1 => 1.0,
                    2 => 1.0 + nearness(random, 1e-15),
                    _ => random.power(-9.0, 1.0),
                };
                write!(text, "{zeta:e}, ").unwrap();
            }
            text.push_str("], ");
        }
        _ => {
            let (a, b) = (random.power(-4.0, 0.0), random.power(-4.0, 0.0));
            write!(text, "damping: rayleigh({a:e}, {b:e}), ").unwrap();
        }
    }
    if random.unit() < 0.5 {
        write!(text, "stiction: {}, ", 1.0 + random.unit()).unwrap();
    }
    text.push('}');
    text
}
