//! A user's crate with a scene in a file, and a function that evaluates the scene.

frictiongen::friction_system!("scenes/mount.friction");

/// Returns the machine's displacement transmissibility, in any regime.
///
/// # Errors
/// Returns the reason why there is no transmissibility.
pub fn transmissibility(r: f64, beta: f64) -> Result<f64, frictiongen::Error> {
    let at = Mount::at(r)?;
    Ok(match at.motion(beta) {
        Ok(motion) => motion.machine().amplitude(),
        Err(_) => at.orbit(beta)?.machine().amplitude(),
    })
}
