//! Prints the numbers of the thesis and the computed ones as Markdown. `cargo run --release --example facts`

use frictiongen_examples::facts::{page::page, rows};

fn main() {
    print!("{}", page(&rows()));
}
