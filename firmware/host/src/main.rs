//! Every call on the host: what the targets' values are compared with, bit for bit.
#![forbid(unsafe_code)]

use scenes::calls::{DOUBLE, INPUTS, INPUTS_SINGLE, SINGLE};

fn main() {
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
