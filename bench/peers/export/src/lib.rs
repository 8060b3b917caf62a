//! Random numbers of the runs that `scripts/export` repeats in C and in FMUs.

/// Random numbers from a xorshift generator (Marsaglia 2003). `drive.h` has the same in C.
pub struct Random(u64);

impl Random {
    /// Starts the generator with the state that all runs have.
    #[must_use]
    #[allow(clippy::new_without_default, reason = "a run has one start")]
    pub fn new() -> Self {
        Self(88_172_645_463_325_252)
    }

    /// Returns a number between -1 and 1 with 24 bits, which both scalars represent exactly.
    pub fn signed(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f64 / 8_388_608.0 - 1.0
    }
}
