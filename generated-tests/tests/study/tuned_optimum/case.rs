//! Defines chains, each with the number of the description that the tests vary.

use frictiongen::study::response::MotionQuantity;
use frictiongen::study::{
    System,
    optimum::{FrequencyBand, Optimum, OptimumOptions, OptimumRequest, Tuning},
    units::Load,
};

/// A chain with one varied number.
pub struct Case {
    /// Description of the chain, with `#` in place of the number.
    pub text: &'static str,
    /// First mass and first spring. `None` stands for the mass or spring that varies.
    pub first: [Option<f64>; 2],
    pub base: bool,
    pub of: &'static str,
    pub name: &'static str,
    pub interval: [f64; 2],
    /// Frequency band in rad/s.
    pub band: [f64; 2],
    pub load: f64,
}

/// An absorber mass that rubs on the main mass. The contact alone damps the resonances.
pub const ABSORBER: Case = Case {
    text: "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: 1.0, a - b: # }, contact: a - b, excitation: a }",
    first: [Some(1.0), Some(1.0)],
    base: false,
    of: "a",
    name: "k a - b",
    interval: [0.05, 0.15],
    band: [0.5, 1.6],
    load: 1.0,
};
/// The absorber with its first spring varied. All non-dimensional groups refer to the first spring.
pub const FIRST_SPRING: Case = Case {
    text: "struct Absorber { masses: { a: 1.0, b: 0.1 },
        springs: { base - a: #, a - b: 0.085 }, contact: a - b, excitation: a }",
    first: [Some(1.0), None],
    name: "k base - a",
    interval: [0.6, 1.2],
    ..ABSORBER
};
/// The absorber in a band whose bounds are next to the resonances. Without friction, the amplitudes at both bounds
/// are equal for one value of the mass.
pub const SHARP: Case = Case {
    text: "struct Absorber { masses: { a: 1.0, b: # },
        springs: { base - a: 1.0, a - b: 0.085 }, contact: a - b, excitation: a }",
    name: "m b",
    interval: [0.06, 0.16],
    band: [0.83, 1.0],
    ..ABSORBER
};
/// One mass that rubs on its moving base and has a spring to a wall.
pub const BLOCK: Case = Case {
    text: "struct Block { masses: { block: 1 }, springs: { base - block: #, block - wall: 1 },
        contact: block - base, excitation: base, damping: modal(0.05) }",
    first: [Some(1.0), None],
    base: true,
    of: "block",
    name: "k base - block",
    interval: [0.1, 3.0],
    band: [0.3, 3.5],
    load: 0.01,
};

impl Case {
    pub fn system(&self, value: f64) -> System {
        let text = self.text.replace('#', &format!("{value:?}"));
        text.parse().expect("a valid scene")
    }

    pub fn tuned(&self, described: f64) -> Optimum {
        let system = self.system(described);
        let hertz = self.band.map(|omega| omega / std::f64::consts::TAU);
        let request = OptimumRequest {
            of: system.motion_named(self.of).expect("a motion"),
            size: MotionQuantity::Displacement,
            band: FrequencyBand::Hertz(hertz[0], hertz[1]),
            load: Some(self.load()),
        };
        let vary = [Tuning {
            of: system.tunable_named(self.name).expect("a number"),
            from: self.interval[0],
            to: self.interval[1],
        }];
        let options = OptimumOptions {
            vary: &vary,
            ..OptimumOptions::default()
        };
        system.optimum_with(&request, &options).expect("an optimum")
    }

    pub fn load(&self) -> Load {
        if self.base {
            Load::Base(self.load)
        } else {
            Load::Force(self.load)
        }
    }

    /// Returns the best friction in N, and the largest amplitude at this friction in m.
    pub fn physical(&self, described: f64, optimum: &Optimum) -> [f64; 2] {
        let scale = self
            .system(described)
            .load_scale(self.load())
            .expect("a load");
        [
            scale.friction(optimum.beta),
            scale.displacement(optimum.amplitude),
        ]
    }
}
