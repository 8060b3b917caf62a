//! Writes random frames as files, which `scripts/answer-times` reads.

#[path = "../tests/study/answers/frames.rs"]
#[allow(dead_code, reason = "the tests use all of it")]
mod frames;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let mut next = || {
        arguments
            .next()
            .ok_or("usage: frames DIRECTORY MASSES COUNT")
    };
    let (directory, masses, count) = (next()?, next()?.parse()?, next()?.parse()?);
    for index in 0..count {
        let frame = frames::frame(masses, index);
        let [from, to] = frame.band;
        let path = format!("{directory}/{masses}-{index}.friction");
        std::fs::write(&path, &frame.text)?;
        // The curve is computed at β = 0.3 times the median of β*_lim, where every regime occurs.
        let mut limits: Vec<f64> = (0..=90)
            .filter_map(|i| {
                frame
                    .system
                    .at(from + (to - from) * f64::from(i) / 90.0)
                    .ok()
            })
            .map(|at| at.sliding_limit())
            .collect();
        limits.sort_by(f64::total_cmp);
        let beta = 0.3 * limits.get(limits.len() / 2).ok_or("a limit")?;
        println!("{path} m{} {from} {to} {beta}", frame.mass);
    }
    Ok(())
}
