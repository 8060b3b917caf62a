//! Draws samples of everything that a figure can contain, into the folder of the first argument: `cargo run --example
//! sampler`. Each figure is written for a page and for a telephone, as SVG and, with the feature `png`, as PNG.
//!
//! Each kind of figure has a file: `responses`, `maps`, `times`, and `systems`, which also has the sketches of the
//! other figures.

mod maps;
mod responses;
mod systems;
mod times;

use frictiongen_plot::{Figure, Point};
use std::error::Error;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(std::env::temp_dir, PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    for (name, figure) in [
        ("responses", responses::responses()),
        ("maps", maps::maps()),
        ("times", times::times()),
        ("systems", systems::systems()),
    ] {
        write(&folder, name, &figure)?;
        write(&folder, &format!("{name}-narrow"), &figure.narrow())?;
    }
    println!("{}", folder.display());
    Ok(())
}

#[cfg(feature = "png")]
fn write(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    std::fs::write(folder.join(format!("{name}.png")), figure.png(2.0)?)?;
    std::fs::write(folder.join(format!("{name}.svg")), figure.svg())?;
    Ok(())
}

#[cfg(not(feature = "png"))]
fn write(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    std::fs::write(folder.join(format!("{name}.svg")), figure.svg())?;
    Ok(())
}

/// Returns the points of a curve.
fn curve(from: f64, to: f64, count: u32, function: impl Fn(f64) -> f64) -> Vec<Point> {
    (0..=count)
        .map(|i| from + (to - from) * f64::from(i) / f64::from(count))
        .map(|x| (x, function(x)))
        .collect()
}

/// Returns amplitude and lag of a damped mass.
fn damped(r: f64, zeta: f64) -> (f64, f64) {
    let (real, imaginary) = (1.0 - r * r, 2.0 * zeta * r);
    (
        1.0 / real.hypot(imaginary),
        imaginary.atan2(real).to_degrees(),
    )
}
