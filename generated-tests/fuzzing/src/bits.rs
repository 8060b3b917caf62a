//! Random floating-point numbers, among which special values and rounding cases are frequent.

use crate::Random;

/// Returns a random double-precision number. It may be a special value, a number near one of `landmarks`, a number of
/// any size, or any bit pattern.
pub fn double(random: &mut Random, landmarks: &[f64]) -> f64 {
    match random.below(8) {
        0 => f64::from_bits(random.bits()),
        1 => {
            let special = [
                0.0,
                -0.0,
                f64::INFINITY,
                f64::NEG_INFINITY,
                f64::NAN,
                f64::MIN_POSITIVE,
                f64::from_bits(1),
                f64::MAX,
                f64::EPSILON,
                1.0,
                -1.0,
            ];
            random.pick(&special).copied().unwrap_or(0.0)
        }
        2 => 10_f64.powf(random.unit() * 616.0 - 308.0),
        3 | 4 => 10_f64.powf(random.unit() * 8.0 - 4.0),
        5 => {
            // The number is a landmark, or a landmark divided by a small whole number, a few roundings off.
            let landmark = random.pick(landmarks).copied().unwrap_or(1.0);
            let fraction = landmark / (1 + random.below(9)) as f64;
            let away = random.below(9) as i64 - 4;
            f64::from_bits((fraction.to_bits() as i64).wrapping_add(away) as u64)
        }
        6 => {
            let landmark = random.pick(landmarks).copied().unwrap_or(1.0);
            landmark * (1.0 + 10_f64.powf(-16.0 * random.unit()))
        }
        _ => random.unit() * 4.0,
    }
}

/// Returns a random single-precision number. It may be a number near one of `landmarks`, a number of any size, or any
/// bit pattern.
pub fn single(random: &mut Random, landmarks: &[f64]) -> f32 {
    match random.below(8) {
        0 | 1 => f32::from_bits(random.bits() as u32),
        2 => 10_f32.powf(random.unit() as f32 * 83.0 - 45.0),
        _ => {
            let near = double(random, landmarks) as f32;
            let away = random.below(5) as i32 - 2;
            f32::from_bits((near.to_bits() as i32).wrapping_add(away) as u32)
        }
    }
}
