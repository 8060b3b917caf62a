//! Searches that others of a sweep lead: the same largest value as without them, from neighbours near and far.

use frictiongen::Neighbour;
use frictiongen::study::System;

/// What they took and gave.
#[derive(Debug, Default)]
pub struct Led {
    /// How many searches.
    pub searches: usize,
    /// Evaluations without and with what the others know, from near and from far.
    pub alone: u32,
    pub led: u32,
    /// The largest difference of the amplitudes, in roundings of the motion's terms.
    pub worst: f64,
}

impl Led {
    /// The amplitude at (r, β) after those at some multiples of r.
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

    /// Two evaluations at different instants differ by what rounding leaves of the terms there.
    pub fn agreed(&self) {
        println!("{self:?}");
        assert!(self.searches > 1000);
        assert!(self.worst < 4.0, "{self:?}");
        // Half of them come from far away.
        assert!(self.led < self.alone, "{self:?}");
    }
}
