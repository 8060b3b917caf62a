//! What the thesis prints and what comes out, as Markdown.  `cargo run --release --example facts`

use frictiongen_examples::facts::{page::page, rows};

fn main() {
    print!("{}", page(&rows()));
}
