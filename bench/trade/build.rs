//! Compiles the programs in C that the measurement compares with. Without a C compiler the measurement runs without
//! them and says so.

use std::path::PathBuf;
use std::process::Command;

const MASSES: [&str; 4] = ["1", "2", "5", "10"];

fn main() {
    println!("cargo::rustc-check-cfg=cfg(with_c)");
    for path in [
        "c/thesis.c",
        "../peers/stepper.c",
        "../peers/time_stepping.c",
    ] {
        println!("cargo::rerun-if-changed={path}");
    }
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets it"));
    let tool = cc::Build::new().opt_level(3).try_get_compiler();
    let Ok(tool) = tool.map(|tool| tool.path().to_owned()) else {
        return;
    };
    let program = |name: &str| {
        let to = out.join(name);
        let from = format!("../peers/{name}.c");
        let built = Command::new(&tool)
            .args(["-O3", &from, "-lm", "-o"])
            .arg(&to)
            .status();
        built.is_ok_and(|status| status.success()).then_some(to)
    };
    let (Some(stepper), Some(stepping)) = (program("stepper"), program("time_stepping")) else {
        println!("cargo::warning=no C compiler that works: the peers in C are left out");
        return;
    };
    for masses in MASSES {
        cc::Build::new()
            .file("c/thesis.c")
            .opt_level(3)
            .debug(false)
            .define("MASSES", masses)
            .compile(&format!("thesis{masses}"));
    }
    println!("cargo::rustc-link-lib=m");
    println!("cargo::rustc-env=STEPPER={}", stepper.display());
    println!("cargo::rustc-env=TIME_STEPPING={}", stepping.display());
    println!("cargo::rustc-cfg=with_c");
}
