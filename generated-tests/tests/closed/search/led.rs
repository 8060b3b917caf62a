//! Tests searches that start from the results of other points of a sweep ("led" searches). They must find the same
//! maximum, whether those points are near or far.

use frictiongen::Neighbour;
use frictiongen::study::System;

/// Numbers of evaluations of led searches and of plain searches, and the largest difference of their amplitudes.
#[derive(Debug, Default)]
pub struct Led {
    /// Number of searches.
    pub searches: usize,
    /// Number of evaluations of the searches that do not use the results of other points.
    pub alone: u32,
    /// Number of evaluations of searches that start from the results of other points.
    pub led: u32,
    /// Largest difference of the amplitudes of a led and a plain search, in rounding units of the motion's terms.
    pub worst: f64,
}

impl Led {
    /// Compares the amplitude of a mass at (r, β) with and without the results at some multiples of r.
    pub fn add(
        &mut self,
        system: &System,
        (r, beta): (f64, f64),
        multiples: [f64; 3],
        mass: &str,
        terms: f64,
    ) {
        let mut neighbour = Neighbour::new();
        for multiple in multiples {
            let at = system.at(r * multiple).unwrap();
            if let Ok(motion) = at.motion(beta) {
                motion.mass(mass).unwrap().largest_near(&mut neighbour);
            }
        }
        let at = system.at(r).unwrap();
        let motion = at.motion(beta).unwrap();
        let mass = motion.mass(mass).unwrap();
        let (alone, led) = (mass.peak(), mass.largest_near(&mut neighbour));
        let frictiongen::Effort::Bounded(evaluations) = led.effort else {
            panic!("stopped before its end: r = {r}, {system:?}");
        };
        self.searches += 1;
        self.alone += alone.evaluations;
        self.led += evaluations;
        let roundings = (alone.value - led.amplitude).abs() / (terms * f64::EPSILON);
        self.worst = self.worst.max(roundings);
    }

    /// Asserts that the amplitudes of led and plain searches differ at most by the rounding of the terms at two
    /// instants.
    pub fn agreed(&self) {
        println!("{self:?}");
        assert!(self.searches > 1000);
        assert!(self.worst < 4.0, "{self:?}");
        // Half of the searches start from far away, so the saving is moderate.
        assert!(self.led < self.alone, "{self:?}");
    }
}
