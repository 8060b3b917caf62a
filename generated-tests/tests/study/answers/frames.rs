//! Generates random frames of one to six masses with μ from 1 to 2, and with all kinds of contact, damping and
//! excitation.

use frictiongen::study::response::MotionQuantity;
use frictiongen::study::{
    System,
    optimum::{FrequencyBand, OptimumRequest},
};
use fuzzing::Random;

/// A random frame, reproducible from its seed.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Name of the frame, which a failed test prints.
    pub name: String,
    /// Description of the frame.
    pub text: String,
    /// System of the frame.
    pub system: System,
    /// Index of the mass whose amplitude is optimised.
    pub mass: usize,
    /// Range of r from 0.3 times the lowest resonance to 1.5 times the highest, as `report` chooses it.
    pub band: [f64; 2],
}

impl Frame {
    /// Returns the request for the optimum.
    pub fn request(&self) -> OptimumRequest {
        OptimumRequest {
            of: frictiongen::Of::Mass(self.mass),
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Ratio(self.band[0], self.band[1]),
            load: None,
        }
    }
}

/// Returns the frame with number `index` among those with `masses` masses. Contact, damping and excitation alternate
/// with the number. All other values are random.
pub fn frame(masses: usize, index: usize) -> Frame {
    let mut random = Random((masses * 100_003 + index * 7919 + 17) as u64);
    for _ in 0..8 {
        random.bits();
    }
    let values: Vec<String> = (0..masses)
        .map(|mass| format!("m{mass}: {:.4}", random.log_uniform(1.0, 10.0)))
        .collect();
    let mut springs = vec![format!("base - m0: {:.2}", random.log_uniform(1e3, 1e4))];
    for mass in 1..masses {
        springs.push(format!(
            "m{} - m{mass}: {:.2}",
            mass - 1,
            random.log_uniform(1e3, 1e4)
        ));
    }
    if random.once_in(3) {
        springs.push(format!(
            "m{} - wall: {:.2}",
            masses - 1,
            random.log_uniform(1e3, 1e4)
        ));
    }
    let kind = index % if masses > 1 { 3 } else { 2 };
    let contact = match kind {
        0 => format!("m{} - wall", random.below(masses)),
        1 => format!("m{} - base", random.below(masses)),
        _ => {
            let a = random.below(masses);
            let b = (a + 1 + random.below(masses - 1)) % masses;
            format!("m{a} - m{b}")
        }
    };
    let damping = match (index / 3) % 3 {
        0 => String::new(),
        1 => format!("damping: modal({:.4}),", random.log_uniform(0.002, 0.05)),
        _ => format!(
            "damping: rayleigh({:.4}, {:.3e}),",
            random.log_uniform(0.1, 1.0),
            random.log_uniform(1e-5, 3e-4)
        ),
    };
    let excitation = if random.once_in(2) {
        "base".to_owned()
    } else {
        format!("m{}", random.below(masses))
    };
    let stiction = random.between(1.0, 2.0);
    let text = format!(
        "struct Frame {{ masses: {{ {} }}, springs: {{ {} }}, contact: {contact}, excitation: {excitation}, {damping} \
         stiction: {stiction:.3} }}",
        values.join(", "),
        springs.join(", ")
    );
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{text}: {error}"));
    let resonances = system.resonances();
    let mut mass = random.below(masses);
    // For a mass that rubs on a wall the optimum is trivial, because the contact sticks. The amplitude of another mass
    // is optimised.
    if contact == format!("m{mass} - wall") {
        mass = (mass + 1) % masses;
    }
    let band = [0.3 * resonances[0], 1.5 * resonances[masses - 1]];
    Frame {
        name: format!("{masses}/{index}"),
        mass,
        text,
        system,
        band,
    }
}
