//! Makes every call on the host and prints its values. The values of the targets must equal them bit for bit.
#![forbid(unsafe_code)]

use scenes::calls::{DOUBLE, INPUTS, INPUTS_SINGLE, SINGLE};
use scenes::steps::Machine;
use scenes::steps::images::report;
use scenes::steps::machines::{Visitor, visit};
use scenes::steps::script::{Tone, Weather, played};

/// Prints the final state of each stepper that it visits.
struct Ends;

impl Visitor for Ends {
    fn visit<M: Machine>(&mut self)
    where
        M::Scalar: Tone,
    {
        for (weather, name) in [(Weather::Song, "song"), (Weather::Storm, "storm")] {
            let [place, velocity, work] = played::<M>(weather).unwrap_or_default();
            println!(
                "{name} of {}: {place:016x} {velocity:016x} {work:016x}",
                M::NAME
            );
        }
    }
}

fn main() {
    match std::env::args().nth(1).as_deref() {
        Some("steps") => return visit(&mut Ends),
        Some("images") => {
            if report(&mut |line| println!("{line}")).is_err() {
                println!("WRONG: a stepper refused its input");
            }
            return;
        }
        _ => {}
    }
    for (number, call) in SINGLE.iter().enumerate() {
        for (place, input) in INPUTS_SINGLE.iter().enumerate() {
            let [a, b] = (call.run)(input);
            println!(
                "single {number} {place} {:08x} {:08x}",
                a.to_bits(),
                b.to_bits()
            );
        }
    }
    for (number, call) in DOUBLE.iter().enumerate() {
        for (place, input) in INPUTS.iter().enumerate() {
            let [a, b] = (call.run)(input);
            println!(
                "double {number} {place} {:016x} {:016x}",
                a.to_bits(),
                b.to_bits()
            );
        }
    }
}
