//! Compares sign changes of a function between samples with the zeros that a search found.

/// Relative distance below which two frequencies count as one.
const NEAR: f64 = 1e-9;

/// Finds the frequencies at which a function changes its sign without a pole, by bisection to rounding. At a zero the
/// absolute value of the function decreases towards the frequency.
pub fn sign_changes(places: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut found = Vec::new();
    for pair in places.windows(2) {
        let (mut low, mut high) = (pair[0], pair[1]);
        let (at_low, at_high) = (f(low), f(high));
        if !(at_low * at_high < 0.0) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if f(middle) * at_low > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        // At a pole the absolute value increases.
        let distance = 1e-6 * low;
        let at = |r: f64| f(r).abs();
        if at(low - 1e-3 * distance) < at(low - distance) {
            found.push(low);
        }
    }
    found
}

/// Asserts that the list `found` contains every frequency in `wanted`.
fn compare(found: &[f64], wanted: &[f64], what: &str) -> usize {
    for want in wanted {
        assert!(
            found.iter().any(|place| (place / want - 1.0).abs() < NEAR),
            "{what}: {want} is missed; found {found:?}"
        );
    }
    wanted.len()
}

/// Number of compared zeros, and number of zeros that are too close to each other for the samples.
#[derive(Default)]
pub struct Count {
    pub compared: usize,
    pub more: usize,
}

impl Count {
    pub fn add(
        &mut self,
        found: &[f64],
        wanted: &[f64],
        step: f64,
        resonances: &[f64],
        functions: &[Box<dyn Fn(f64) -> f64 + '_>],
        what: &str,
    ) {
        self.compared += compare(found, wanted, what);
        for place in found {
            // At a zero the function changes its sign. Samples at this distance do not show the change if another
            // zero or a pole is even nearer.
            let beside = 1e-7;
            let crosses = |f: &dyn Fn(f64) -> f64| {
                f(place * (1.0 - beside)) * f(place * (1.0 + beside)) < 0.0
            };
            let near = found
                .iter()
                .any(|other| other != place && (other / place - 1.0).abs() < 4.0 * beside);
            // Poles lie at the resonances and their odd subharmonics.
            let pole = resonances.iter().any(|resonance| {
                let odd = 2.0 * (0.5 * (resonance / place - 1.0)).round() + 1.0;
                (resonance / odd / place - 1.0).abs() < 4.0 * beside
            });
            assert!(
                near || pole || functions.iter().any(|f| crosses(f.as_ref())),
                "{what}: {place} is none"
            );
            if wanted.iter().any(|want| (want / place - 1.0).abs() < NEAR) {
                continue;
            }
            // The samples do not show a zero if a pole or another zero lies between the same two samples.
            self.more += 1;
            let within = |other: f64| (1.0 / other - 1.0 / place).abs() < step;
            let odd = |resonance: &f64| 2.0 * (0.5 * (resonance / place - 1.0)).round() + 1.0;
            let hidden = found.iter().any(|other| other != place && within(*other))
                || resonances
                    .iter()
                    .any(|resonance| within(resonance / odd(resonance)));
            assert!(hidden, "{what}: {place} is not among {wanted:?}");
        }
    }
}
