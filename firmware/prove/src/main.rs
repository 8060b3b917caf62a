//! Links only if no call can panic.

use scenes::calls::{DOUBLE, INPUTS, INPUTS_SINGLE, SINGLE};
use std::hint::black_box;

fn main() {
    for call in &SINGLE {
        black_box((call.run)(black_box(&INPUTS_SINGLE[0])));
    }
    for call in &DOUBLE {
        black_box((call.run)(black_box(&INPUTS[0])));
    }
    println!("{} functions cannot panic", SINGLE.len() + DOUBLE.len());
}
