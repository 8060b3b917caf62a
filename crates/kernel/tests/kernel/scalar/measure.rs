//! The error of a result, and the largest of many errors.

use frictiongen_kernel::number::dd::Dd;

/// got − want without the subtraction of [`Dd`], which is itself under test.
pub fn difference(got: Dd, want: Dd) -> f64 {
    (got.hi - want.hi) + (got.lo - want.lo)
}

/// One unit in the last place of the nearest number of `bits` bits, whose exponents start at `least`.
fn place(value: f64, bits: i32, least: i32) -> f64 {
    let exponent = ((value.abs().to_bits() >> 52) as i32 - 1023).max(least);
    2.0_f64.powi(exponent - bits + 1)
}

/// The error of an `f64` in units in the last place.
pub fn error(got: f64, want: Dd) -> f64 {
    if got == want.hi && want.lo == 0.0 {
        return 0.0;
    }
    difference(Dd::from(got), want).abs() / place(want.hi, 53, -1022)
}

pub fn error_f32(got: f32, want: Dd) -> f64 {
    if f64::from(got) == want.hi && want.lo == 0.0 {
        return 0.0;
    }
    difference(Dd::from(f64::from(got)), want).abs() / place(want.hi, 24, -126)
}

/// The largest error of a function, and the arguments at which it occurs.
#[derive(Default)]
pub struct Worst {
    pub error: f64,
    at: String,
    points: usize,
}

impl Worst {
    pub fn see(&mut self, error: f64, at: impl FnOnce() -> String) {
        self.points += 1;
        // A NaN counts as the largest error.
        if error.is_nan() || error > self.error {
            self.error = if error.is_nan() { f64::INFINITY } else { error };
            self.at = at();
        }
    }

    pub fn check(&self, what: &str, budget: f64, points: usize) {
        println!(
            "{what}: {:.4e} of {budget} at {} ({} points)",
            self.error, self.at, self.points
        );
        assert!(self.points >= points, "{what}: only {} points", self.points);
        assert!(
            self.error <= budget,
            "{what}: {} exceeds {budget} at {}",
            self.error,
            self.at
        );
    }
}
