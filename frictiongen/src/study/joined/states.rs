//! Finds steady states at one frequency and one friction, stable and unstable.

use super::at::JoinedAt;
use super::error::JoinedError;
use super::orbit::{FoundBy, JoinedOrbit};
use crate::study::joints::{Chain, JointError, Motion, mirror_image, steady_states_near};

/// Factors on the states of the two linear responses (no contact slides, no friction). The product of each state and
/// each factor is an initial state of the search.
const FACTORS: [f64; 3] = [1.0, -1.0, 3.0];
/// Number of initial states that are spread over all directions.
const SPREAD: usize = 8;
/// Largest displacement in a spread initial state, divided by the largest amplitude of the states known before.
const REACH: f64 = 2.0;
/// Largest difference of two states that are treated as the same, divided by the largest amplitude.
const SAME: f64 = 1e-6;

impl<'a> JoinedAt<'a> {
    /// Returns every steady state that the search finds at one common friction, stable or not.
    ///
    /// The search follows the motions from rest, from the state in which no contact slides, from the response without
    /// friction, from multiples of these two, and from 8 states that are spread over all directions. If several steady
    /// states may exist (μ > 1, friction that depends on the speed, or stops), it also applies Newton's method to all
    /// these states and to the steady states that it has found, for motions of one and two cycles and for symmetric
    /// ones, and adds the mirror image of each asymmetric state. [`JoinedOrbit::found_by`] says which of these found a
    /// state. States of longer periods are found only where a motion leads to them.
    ///
    /// The first entry is the steady state from rest, if the motion from rest settles. The list has at least one entry.
    ///
    /// ```
    /// use frictiongen::System;
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { m: 1 }, springs: { base - m: 1 }, contact: m - base, excitation: base, stiction: 1.5,
    /// }".parse()?;
    /// let joined = block.joined()?;
    /// let states = joined.at(0.55)?.states(0.1)?;
    /// // An asymmetric state, its mirror image, and an unstable symmetric state.
    /// let stable = states.iter().filter(|orbit| orbit.is_stable());
    /// assert_eq!((states.len(), stable.count()), (3, 2));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`JoinedError::OutOfDomain`] for a friction that is negative or not finite. [`JoinedError::Engine`] if no initial
    /// state leads to a steady state: the reason why the motion from rest does not.
    pub fn states(&self, friction: f64) -> Result<Vec<JoinedOrbit<'a>>, JoinedError> {
        let mut search = StatesSearch {
            chain: self.chain(friction)?,
            at: self,
            friction,
            found: Vec::new(),
            guesses: Vec::new(),
            reason: None,
        };
        search.keep(self.orbit(friction), FoundBy::Rest)?;
        let stuck = self.stuck().map(|stuck| stuck.state(self.omega()));
        let linear = self.linear().map(|linear| linear.state(self.omega()));
        for (found, state) in [(FoundBy::Stuck, stuck), (FoundBy::Linear, linear)] {
            for factor in FACTORS {
                if let Ok((x, v)) = &state {
                    let [x, v] = [x, v].map(|all| all.iter().map(|x| factor * x).collect());
                    search.follow((x, v), found)?;
                }
            }
        }
        if search.may_find_several() {
            search.spread()?;
            search.newton()?;
            search.mirror();
        }
        match search.reason {
            Some(error) if search.found.is_empty() => Err(error.into()),
            _ => Ok(search.found),
        }
    }
}

/// A search for the steady states at one frequency and one friction.
struct StatesSearch<'s, 'a> {
    at: &'s JoinedAt<'a>,
    chain: Chain,
    friction: f64,
    found: Vec<JoinedOrbit<'a>>,
    /// Displacements and velocities from which the search has followed motions.
    guesses: Vec<(Vec<f64>, Vec<f64>)>,
    /// Reason why the motion from the first initial state has not settled.
    reason: Option<JointError>,
}

impl<'a> StatesSearch<'_, 'a> {
    /// Adds a steady state, unless the search knows it.
    fn keep(
        &mut self,
        orbit: Result<JoinedOrbit<'a>, JoinedError>,
        found: FoundBy,
    ) -> Result<(), JoinedError> {
        match orbit {
            Ok(orbit) => self.add(orbit, found),
            // The motion from this initial state does not settle. The first initial state is rest.
            Err(JoinedError::Engine(error)) => {
                self.reason.get_or_insert(error);
            }
            Err(error) => return Err(error),
        }
        Ok(())
    }

    fn add(&mut self, orbit: JoinedOrbit<'a>, found: FoundBy) {
        if !self.found.iter().any(|known| same(known, &orbit)) {
            self.found.push(orbit.with_found(found));
        }
    }

    /// Follows the motion from a state to a steady state.
    fn follow(&mut self, state: (Vec<f64>, Vec<f64>), found: FoundBy) -> Result<(), JoinedError> {
        let start = (state.0.as_slice(), state.1.as_slice());
        let orbit = self.at.orbit_reached_from(self.friction, start);
        self.guesses.push(state);
        self.keep(orbit, found)
    }

    /// Returns true unless all motions approach each other.
    fn may_find_several(&self) -> bool {
        let chain = &self.chain;
        let mut contacts = chain.contacts.iter();
        !chain.stops.is_empty()
            || !chain.law.is_empty()
            || contacts.any(|contact| contact.stiction > 1.0)
    }

    fn largest(&self) -> f64 {
        let amplitudes = self
            .found
            .iter()
            .flat_map(JoinedOrbit::largest_displacements);
        let guesses = self
            .guesses
            .iter()
            .flat_map(|(x, _)| x.iter().map(|x| x.abs()));
        amplitudes.chain(guesses).fold(0.0, f64::max)
    }

    /// Follows the motions from states that are spread evenly over all directions.
    fn spread(&mut self) -> Result<(), JoinedError> {
        let masses = self.chain.masses.len();
        let reach = REACH * self.largest();
        let units = self.at.units();
        let rate = self.at.omega() * units.length / units.speed;
        for point in 1..=SPREAD {
            // Multiples of the square roots of numbers without common factors, modulo 1 (Kronecker's sequence).
            let coordinate = |index: usize| {
                let number = (index + 1) as f64 + std::f64::consts::FRAC_1_SQRT_2;
                reach * (2.0 * (point as f64 * number.sqrt()).fract() - 1.0)
            };
            let x = (0..masses).map(coordinate).collect();
            let v = (masses..2 * masses).map(|index| rate * coordinate(index));
            self.follow((x, v.collect()), FoundBy::Spread)?;
        }
        Ok(())
    }

    /// Applies Newton's method to all states that are known.
    fn newton(&mut self) -> Result<(), JoinedError> {
        let size = self.largest() * self.at.units().length;
        if !(size > 0.0) {
            return Ok(());
        }
        let mut starts: Vec<Motion> = Vec::new();
        for orbit in &self.found {
            starts.push(orbit.motion()?);
        }
        for (x, v) in &self.guesses {
            starts.push(self.at.started(&self.chain, Some((x, v)))?);
        }
        for start in &starts {
            for steady in steady_states_near(start, self.at.omega(), size) {
                let orbit = self.at.settled(steady, self.chain.clone());
                self.add(orbit, FoundBy::Newton);
            }
        }
        Ok(())
    }

    /// Adds the mirror image of every asymmetric state.
    fn mirror(&mut self) {
        for orbit in self.found.clone() {
            if let Some(image) = mirror_image(&self.chain, self.at.omega(), orbit.steady()) {
                let image = self.at.settled(image, self.chain.clone());
                self.add(image, FoundBy::Mirror);
            }
        }
    }
}

/// Returns true if two steady states are the same motion, which may begin some cycles later. Two states of a continuum
/// of steady states count as the same if their amplitudes agree.
fn same(one: &JoinedOrbit<'_>, other: &JoinedOrbit<'_>) -> bool {
    let (a, b) = (one.centred_amplitudes(), other.centred_amplitudes());
    let all = a.iter().chain(&b).copied();
    let size = all.fold(f64::MIN_POSITIVE, f64::max);
    let near = |a: &[f64], b: &[f64], size: f64| {
        let mut pairs = a.iter().zip(b);
        pairs.all(|(a, b)| (a - b).abs() <= SAME * size)
    };
    let stops = |orbit: &JoinedOrbit<'_>| -> Vec<usize> {
        orbit.contacts().map(|contact| contact.stops()).collect()
    };
    if one.period() != other.period() || stops(one) != stops(other) || !near(&a, &b, size) {
        return false;
    }
    if one.is_marginal() || other.is_marginal() {
        return true;
    }
    let (x, v) = other.state();
    let Ok(mut motion) = one.motion() else {
        return false;
    };
    let (_, omega, units) = one.setting();
    let cycle = std::f64::consts::TAU / omega;
    (1..=one.period()).any(|cycles| {
        let reached = motion.run(cycle * cycles as f64, &mut |_, _, _| {}).is_ok();
        let state = motion.state();
        let moved: Vec<f64> = state.x.iter().map(|x| x / units.length).collect();
        let speeds: Vec<f64> = state.v.iter().map(|v| v / units.speed).collect();
        reached
            && near(&moved, &x, size)
            && near(&speeds, &v, size * omega * units.length / units.speed)
    })
}
