//! A chain as owned data, its load, and a run over it.

use frictiongen::kernel::joints::{
    Chain, Drive, Joint, JointState, Link, Phase, Room, Run, Series, Step, TERMS, Trouble, harmonic,
};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use std::f64::consts::PI;

/// A chain under a harmonic load.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    pub masses: Vec<f64>,
    pub springs: Vec<(Link<f64>, f64)>,
    pub dampers: Vec<(Link<f64>, f64)>,
    pub damping: Vec<f64>,
    pub joints: Vec<Joint<f64>>,
    /// Level of each contact.
    pub levels: Vec<f64>,
    /// Amplitude of the force on each mass, and of the base.
    pub forces: Vec<f64>,
    pub base: f64,
    pub omega: f64,
}

impl Drive<f64> for &Scene {
    fn base(&self, t: f64, span: f64, series: &mut Series<f64>) {
        harmonic(self.base, self.omega * t / PI, self.omega * span, series);
    }
    fn force(&self, mass: usize, t: f64, span: f64, series: &mut Series<f64>) {
        harmonic(
            self.forces[mass],
            self.omega * t / PI,
            self.omega * span,
            series,
        );
    }
    fn level(&self, joint: usize, _: f64, _: f64, series: &mut Series<f64>) {
        series[0] = self.levels[joint];
    }
    fn rate(&self) -> f64 {
        self.omega
    }
}

impl Scene {
    pub fn chain(&self) -> Chain<'_, f64> {
        Chain {
            masses: &self.masses,
            springs: &self.springs,
            dampers: &self.dampers,
            damping: &self.damping,
            joints: &self.joints,
        }
    }
    /// Writes the damping matrix of damping ratios of the modes, in rising order of frequency.
    pub fn damp(&mut self, zeta: &[f64]) {
        let n = self.masses.len();
        let roots: Vec<_> = self.masses.iter().map(|m| m.sqrt()).collect();
        let mut scaled = DMatrix::zeros(n, n);
        for (link, k) in &self.springs {
            let w = direction(link, n);
            let w = DVector::from_fn(n, |i, _| w[i] / roots[i]);
            scaled += *k * &w * w.transpose();
        }
        let modes = SymmetricEigen::new(scaled);
        let mut order: Vec<_> = (0..n).collect();
        order.sort_by(|&a, &b| modes.eigenvalues[a].total_cmp(&modes.eigenvalues[b]));
        self.damping = vec![0.0; n * n];
        for (&mode, zeta) in order.iter().zip(zeta) {
            let factor = 2.0 * zeta * modes.eigenvalues[mode].max(0.0).sqrt();
            let shape = modes.eigenvectors.column(mode);
            for i in 0..n {
                for j in 0..n {
                    self.damping[i * n + j] += factor * roots[i] * shape[i] * roots[j] * shape[j];
                }
            }
        }
    }
    /// Follows the motion from rest until `until`, and shows each step, before its event and after it.
    pub fn follow(
        &self,
        until: f64,
        see: impl FnMut(&Run<'_, f64, &Scene>, Step<f64>, bool),
    ) -> Result<(), Trouble> {
        let rest = vec![0.0; self.masses.len()];
        follow(&self.chain(), self, (&rest, &rest), until, see)
    }
}

/// Returns w of a link.
pub fn direction(link: &Link<f64>, n: usize) -> Vec<f64> {
    let mut w = vec![0.0; n];
    if let Some(mass) = link.to {
        w[mass] = 1.0;
    }
    if let Some(mass) = link.from {
        w[mass] = -1.0;
    }
    w
}

pub fn ground(mass: usize) -> Link<f64> {
    Link {
        from: None,
        to: Some(mass),
        base: 0.0,
    }
}

pub fn between(from: usize, to: usize) -> Link<f64> {
    Link {
        from: Some(from),
        to: Some(to),
        base: 0.0,
    }
}

/// Follows a chain.  `see` gets each step twice, with false before its event and with true after it.
pub fn follow<D: Drive<f64>>(
    chain: &Chain<'_, f64>,
    drive: D,
    start: (&[f64], &[f64]),
    until: f64,
    mut see: impl FnMut(&Run<'_, f64, D>, Step<f64>, bool),
) -> Result<(), Trouble> {
    let (n, m) = (chain.masses.len(), chain.joints.len());
    let mut numbers = vec![0.0; 3 * n];
    let mut series = vec![[0.0; TERMS]; 3 * n + 2 * m];
    let mut states = vec![JointState::default(); m];
    let room = Room::of(n, &mut numbers, &mut series, &mut states).expect("memory");
    let mut run = Run::start(*chain, drive, room, 0.0, start)?;
    while run.time() < until {
        let step = run.step(until)?;
        see(&run, step, false);
        run.pass()?;
        see(&run, step, true);
    }
    Ok(())
}

/// Returns the phases as the signs of the reference: 1, −1, or 0 for a contact that sticks.
pub fn signs(states: &[JointState<f64>]) -> Vec<i64> {
    states
        .iter()
        .map(|state| state.phase.sign().into())
        .collect()
}

/// Returns the phases.
pub fn phases(states: &[JointState<f64>]) -> Vec<Phase> {
    states.iter().map(|state| state.phase).collect()
}

/// Returns the value of a series at `u`.
pub fn value(series: &Series<f64>, u: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, term| sum * u + term)
}

#[test]
fn the_stated_memory_is_the_memory_of_a_run() {
    let (n, m) = (5, 3);
    let numbers = vec![0.0f64; 3 * n];
    let series = vec![[0.0f64; TERMS]; 3 * n + 2 * m];
    let states = vec![JointState::<f64>::default(); m];
    let bytes = size_of_val(&*numbers) + size_of_val(&*series) + size_of_val(&*states);
    assert_eq!(Room::<f64>::bytes(n, m), bytes);
    let (mut numbers, mut series, mut states) = (numbers, series, states);
    assert!(Room::of(n, &mut numbers, &mut series, &mut states).is_some());
    assert!(Room::of(n, &mut numbers[1..], &mut series, &mut states).is_none());
    assert!(Room::of(n, &mut numbers, &mut series[1..], &mut states).is_none());
}
