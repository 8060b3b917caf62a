//! Random scenes, the same on every machine.

use std::fmt::Write as _;

/// Knuth's 64-bit linear congruential generator: the same scenes on every machine.
pub struct Lcg(pub u64);

impl Lcg {
    pub fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }
    pub fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }
}

/// A random description of at most so many masses; masses and springs spread over a decade.
pub fn random_scene(random: &mut Lcg, most: usize) -> String {
    let n = 1 + random.below(most);
    let mut text = String::from("struct Random { masses: { ");
    for i in 0..n {
        write!(text, "m{i}: {}, ", random.log_uniform(1.0, 10.0)).unwrap();
    }
    text.push_str("}, springs: { ");
    // A chain from the base; then, on some scenes, a wall and loops.
    let mut springs = vec![(String::from("base"), 0)];
    springs.extend((1..n).map(|i| (format!("m{}", i - 1), i)));
    if random.unit() < 0.5 {
        springs.push((String::from("wall"), random.below(n)));
    }
    for _ in 0..random.below(3) {
        let (a, b) = (random.below(n), random.below(n));
        // A chain's own neighbours are joined already, and a pair may be named only once.
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
        // Up to overdamped in the fast modes.
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
