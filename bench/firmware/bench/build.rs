//! Passes the linker script of the emulated board to the linker.

use std::{env, fs, path::Path};

fn main() {
    let out = env::var("OUT_DIR").expect("cargo sets it");
    let memory = include_str!("../memory.x");
    fs::write(Path::new(&out).join("memory.x"), memory).expect("the build directory is writable");
    println!("cargo:rustc-link-search={out}");
    println!("cargo:rerun-if-changed=../memory.x");
}
