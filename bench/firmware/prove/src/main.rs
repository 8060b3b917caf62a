//! A program that links only if no call can panic.

use scenes::calls::{DOUBLE, INPUTS, INPUTS_SINGLE, SINGLE};
use scenes::joined;
use scenes::steps::Machine;
use scenes::steps::machines::{Visitor, visit};
use scenes::steps::script::Tone;
use std::hint::black_box;

/// Creates and advances the stepper of each machine that it visits.
struct Steps(usize);

impl Visitor for Steps {
    fn visit<M: Machine>(&mut self)
    where
        M::Scalar: Tone,
    {
        let mut machine = black_box(M::start());
        if let Some(machine) = &mut machine {
            let load = [M::Scalar::of(1.0), M::Scalar::of(0.5)];
            self.0 += usize::from(machine.set_budget(black_box(1)).is_some());
            black_box(machine.advance(black_box(load), black_box(M::Scalar::of(0.1))));
            machine.read_each();
            self.0 += usize::from(machine.read_all().is_some());
        }
        self.0 += 3 + usize::from(M::start_declared().is_some());
    }
}

fn main() {
    let mut steps = Steps(0);
    visit(&mut steps);
    for call in &SINGLE {
        black_box((call.run)(black_box(&INPUTS_SINGLE[0])));
    }
    for call in &DOUBLE {
        black_box((call.run)(black_box(&INPUTS[0])));
    }
    if let Some(run) = &mut black_box(joined::start()) {
        black_box(joined::advance(run, black_box(1.0), black_box([0.2, 0.1])));
    }
    black_box(joined::simulate(
        black_box(0.9),
        black_box(0.1),
        black_box(1.0),
    ));
    black_box(joined::stuck_from(black_box(0.9)));
    black_box(joined::settle(black_box(0.9), black_box(0.1)));
    steps.0 += 5;
    println!(
        "{} functions cannot panic",
        SINGLE.len() + DOUBLE.len() + steps.0
    );
}
