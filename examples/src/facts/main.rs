//! Prints the numbers of the thesis and the computed ones as CSV. `cargo run --release --example facts`

use frictiongen_examples::facts::{rows, table::table};

fn main() {
    print!("{}", table(&rows()));
}
