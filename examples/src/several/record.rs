//! Gives the synthetic ground motion of the example `earthquake` at another sampling rate.

#[path = "../earthquake/ground.rs"]
mod made;

pub use made::Ground as Sample;

/// Computes a synthetic ground motion with `rate` samples a second. Its first sample is at the end of the first step.
/// `peak` is the peak acceleration in m/s².
#[must_use]
pub fn ground(peak: f64, rate: u32) -> Vec<Sample> {
    let every = (made::RATE / f64::from(rate)).round().max(1.0) as usize;
    let motion = made::ground(peak);
    motion.into_iter().step_by(every).skip(1).collect()
}
