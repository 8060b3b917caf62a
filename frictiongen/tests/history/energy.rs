//! The energy balance of a run: work of the load, less the losses by friction and damping, is the change of energy.

use crate::scenes::{BLOCK, DAMPED, system};
use frictiongen::Of;
use frictiongen::kernel::simulation::Contact;
use frictiongen::study::history::HistoryRequest;
use std::f64::consts::TAU;

#[test]
fn of_one_mass() {
    let (mut worst, mut compared) = (0.0_f64, 0);
    for (text, zeta) in [(BLOCK, 0.0), (DAMPED, 0.05)] {
        let system = system(text);
        for (r, beta) in [(0.3, 0.4), (0.5, 0.6), (0.8, 0.2), (1.4, 0.3)] {
            let request = HistoryRequest {
                cycles: 8,
                samples: 4000,
                ..HistoryRequest::new(&[Of::Contact])
            };
            let history = system.history(r, beta, &request).unwrap();
            let (x, v) = (&history.tracks[0].displacement, &history.tracks[0].velocity);
            let energy = |index: usize| 0.5 * (r * r * v[index] * v[index] + x[index] * x[index]);
            // The trapezoidal rule loses accuracy at the kinks of the velocity. Its error falls with the square of the
            // step.
            let h = TAU / f64::from(history.samples);
            let mean =
                |of: &dyn Fn(usize) -> f64, index: usize| 0.5 * h * (of(index) + of(index + 1));
            let (mut input, mut damped) = (0.0, 0.0);
            for index in 0..history.len() - 1 {
                input += mean(&|index| history.tau(index).cos() * v[index], index);
                damped += mean(&|index| 2.0 * zeta * r * v[index] * v[index], index);
            }
            // The work of friction is exact from event to event.
            let ends = history
                .events
                .iter()
                .map(|event| (event.displacements[0], event.contact));
            let last = history.len() - 1;
            let ends = std::iter::once((x[0], history.contact[0]))
                .chain(ends)
                .chain([(x[last], Contact::Stuck)]);
            let ends: Vec<(f64, Contact)> = ends.collect();
            let slid: f64 = ends
                .windows(2)
                .filter(|pair| pair[0].1 != Contact::Stuck)
                .map(|pair| (pair[1].0 - pair[0].0).abs())
                .sum();
            let balance = input - damped - beta * slid - (energy(last) - energy(0));
            worst = worst.max((balance / input).abs());
            compared += 1;
        }
    }
    println!("{compared} balances, to {worst:.1e} of the input");
    assert!(compared == 8 && worst < 1e-6);
}
