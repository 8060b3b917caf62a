//! A user's crate: a scene in a file, and what is asked of it.

frictiongen::friction_system!("scenes/mount.friction");

/// The machine's displacement transmissibility, whatever the regime.
///
/// # Errors
/// Why there is none.
pub fn transmissibility(r: f64, beta: f64) -> Result<f64, frictiongen::Error> {
    let at = Mount::at(r)?;
    Ok(match at.motion(beta) {
        Ok(motion) => motion.machine().amplitude(),
        Err(_) => at.orbit(beta)?.machine().amplitude(),
    })
}
