//! Generates random scenes, which are the same on every machine.

use fuzzing::Random;
use std::fmt::Write as _;

/// Returns a random description of at most `most` masses. Masses and stiffnesses spread over a decade.
pub fn random_scene(random: &mut Random, most: usize) -> String {
    let n = 1 + random.below(most);
    let mut text = String::from("struct Random { masses: { ");
    for i in 0..n {
        write!(text, "m{i}: {}, ", random.log_uniform(1.0, 10.0)).unwrap();
    }
    text.push_str("}, springs: { ");
    // Every scene is a chain from the base. Some scenes also have a wall spring and loops.
    let mut springs = vec![(String::from("base"), 0)];
    springs.extend((1..n).map(|i| (format!("m{}", i - 1), i)));
    if random.unit() < 0.5 {
        springs.push((String::from("wall"), random.below(n)));
    }
    for _ in 0..random.below(3) {
        let (a, b) = (random.below(n), random.below(n));
        // Neighbours in the chain are already joined, and a pair may be joined only once.
        if a + 1 < b && !springs.contains(&(format!("m{a}"), b)) {
            springs.push((format!("m{a}"), b));
        }
    }
    for (from, to) in springs {
        write!(text, "{from} - m{to}: {}, ", random.log_uniform(1.0, 10.0)).unwrap();
    }
    text.push_str("}, contact: ");
    let j = random.below(n);
    match random.below(if n > 1 { 3 } else { 2 }) {
        0 => write!(text, "m{j} - wall, ").unwrap(),
        1 => write!(text, "m{j} - base, ").unwrap(),
        _ => write!(text, "m{j} - m{}, ", (j + 1 + random.below(n - 1)) % n).unwrap(),
    }
    if random.unit() < 0.5 {
        text.push_str("excitation: base, ");
    } else {
        write!(text, "excitation: m{}, ", random.below(n)).unwrap();
    }
    match random.below(4) {
        0 | 1 => {}
        2 if random.unit() < 0.5 => {
            write!(text, "damping: modal({}), ", random.log_uniform(1e-3, 0.5)).unwrap();
        }
        2 => {
            text.push_str("damping: modal[");
            for _ in 0..n {
                write!(text, "{}, ", random.log_uniform(1e-3, 0.5)).unwrap();
            }
            text.push_str("], ");
        }
        // This damping can make the fast modes overdamped.
        _ => {
            let (a, b) = (random.log_uniform(1e-3, 0.3), random.log_uniform(1e-3, 0.3));
            write!(text, "damping: rayleigh({a}, {b}), ").unwrap();
        }
    }
    if random.unit() < 0.5 {
        write!(text, "stiction: {}, ", 1.0 + random.unit()).unwrap();
    }
    text.push('}');
    text
}
