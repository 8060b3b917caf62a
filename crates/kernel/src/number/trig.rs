//! Sine and cosine of angles in half-turns, in `f64` ([`double`]) and `f32` ([`single`]).
//!
//! The argument h is an angle in half-turns (π rad), so that `sin_pi(h)` is sin(πh). The functions subtract a multiple
//! of 1/2 from h without rounding, before they multiply by π. The results therefore have full relative accuracy next to
//! every zero. If the mathematical value is 0 or ±1, the result is exact. The functions use only `+`, `-` and `*`, so
//! that every host returns the same bits. The coefficients of the minimax polynomials come from `tools/coefficients.py`.

/// Evaluates a polynomial in u by Estrin's scheme. The coefficient of the lowest power comes first. The scheme sums
/// independent pairs of coefficients, which a processor can compute at the same time. In Horner's scheme each step
/// waits for the previous step.
macro_rules! polynomial {
    (@pairs $u:ident, $square:ident, $last:expr $(,)?) => { $last };
    (@pairs $u:ident, $square:ident, $first:expr, $second:expr $(,)?) => {
        ($first + $u * $second)
    };
    (@pairs $u:ident, $square:ident, $first:expr, $second:expr, $($rest:expr),+ $(,)?) => {
        (($first + $u * $second)
            + $square * $crate::number::trig::polynomial!(@pairs $u, $square, $($rest),+))
    };
    ($u:ident, $last:expr $(,)?) => { $last };
    ($u:ident, $first:expr, $second:expr $(,)?) => { $first + $u * $second };
    ($u:ident, $first:expr, $second:expr, $($rest:expr),+ $(,)?) => {{
        let square = $u * $u;
        ($first + $u * $second) + square * $crate::number::trig::polynomial!(@pairs $u, square, $($rest),+)
    }};
}
pub(crate) use polynomial;

macro_rules! half_turns {
    (
        $(#[$doc:meta])*
        $module:ident: $float:ident as $bits:ident,
        to_halves: $to_halves:expr, to_fours: $to_fours:expr,
        exact: $exact:expr, even: $even:expr, near: $near:expr,
        leading: $leading:expr,
        pi: $pi:expr, half_pi_squared: $half_pi_squared:expr,
        sin: [$($sin:expr),+ $(,)?], cos: [$($cos:expr),+ $(,)?] $(,)?
    ) => {
        $(#[$doc])*
        pub mod $module {
            /// π as a sum of two terms. The first term has so few bits that its product with a number of [`LEADING`]
            /// bits is exact.
            const PI: [$float; 2] = $pi;
            const HALF_PI_SQUARED: $float = $half_pi_squared;
            /// Mask that keeps the leading third of a significand and clears the other bits.
            const LEADING: $bits = $leading;
            /// Large constant. Adding it to a smaller number rounds the sum to a multiple of 1/2. The lowest bits of
            /// the sum then contain the number of halves.
            const TO_HALVES: $float = $to_halves;
            /// Large constant. Adding it to a smaller number rounds the sum to a multiple of 4.
            const TO_FOURS: $float = $to_fours;

            /// Returns x with all bits after the leading third of its significand cleared.
            #[inline(always)]
            pub(crate) fn leading(x: $float) -> $float {
                $float::from_bits(x.to_bits() & LEADING)
            }

            /// Returns h minus the nearest multiple of 4, without rounding. The result is NaN if h is infinite or NaN.
            #[cold]
            fn wrapped(h: $float) -> $float {
                // Every floating-point number whose size is at least `$even` is an even integer. For these numbers the
                // result h * 0.0 is 0. For an infinite h or NaN it is NaN.
                if h.abs() < $even { h - ((h + TO_FOURS) - TO_FOURS) } else { h * 0.0 }
            }

            /// Returns the integer q for which q/2 is nearest to h, and the exact remainder h − q/2. h is an angle in
            /// half-turns (π rad). Only the two lowest bits of q are correct, because a sine or cosine needs only q
            /// modulo 4. |h| must be below the macro's parameter `exact`.
            #[inline(always)]
            fn reduced(h: $float) -> ($bits, $float) {
                let shifted = h + TO_HALVES;
                (shifted.to_bits(), h - (shifted - TO_HALVES))
            }

            /// Returns the integer q for which q/2 is nearest to h, and the exact remainder h − q/2. Unlike
            /// [`reduced`], this function accepts h of any size.
            #[inline(always)]
            pub(crate) fn reduced_any(h: $float) -> ($bits, $float) {
                reduced(if h.abs() < $exact { h } else { wrapped(h) })
            }

            /// Returns sin πr and cos πr for |r| ≤ 1/4, each as a leading term and a small correction.
            ///
            /// The leading term of the sine is the product of the leading bits of π and of r, which has no rounding
            /// error. The code computes the cosine as 1 minus a number of about 0.3 at most, so that rounding errors
            /// of this number have little effect.
            #[inline(always)]
            fn kernel(r: $float) -> ([$float; 2], [$float; 2]) {
                let u = r * r;
                let high = leading(r);
                let low = r - high;
                let sin = high * PI[0];
                let sin_rest = low * PI[0] + r * PI[1];
                let drop = u * HALF_PI_SQUARED;
                let cos = 1.0 - drop;
                let cos_rest = (1.0 - cos) - drop;
                (
                    [sin, sin_rest + r * u * $crate::number::trig::polynomial!(u, $($sin),+)],
                    [cos, cos_rest + u * u * $crate::number::trig::polynomial!(u, $($cos),+)],
                )
            }

            /// Returns sin(α + qπ/2) and cos(α + qπ/2), from `sin` = sin α and `cos` = cos α. The function does not
            /// branch.
            #[inline(always)]
            fn turned(q: $bits, sin: $float, cos: $float) -> ($float, $float) {
                const SIGN: u32 = $bits::BITS - 2;
                let (s, c) = (sin.to_bits(), cos.to_bits());
                let exchange = (s ^ c) & (q & 1).wrapping_neg();
                let s = s ^ exchange ^ ((q & 2) << SIGN);
                let c = c ^ exchange ^ ((q.wrapping_add(1) & 2) << SIGN);
                ($float::from_bits(s), $float::from_bits(c))
            }

            /// Returns (sin πh, cos πh), where h is an angle in half-turns (π rad).
            ///
            /// Each result is within 1.1 units in the last place for every finite h. If the mathematical value is 0 or
            /// ±1, the result is exact. Large floating-point numbers h are even integers, for which the result is (0,
            /// 1). For an infinite h or NaN the result is NaN.
            ///
            /// ```
            #[doc = concat!("use frictiongen_kernel::number::trig::", stringify!($module), "::sin_cos_pi;")]
            ///
            /// assert_eq!(sin_cos_pi(0.5), (1.0, 0.0));
            /// assert_eq!(sin_cos_pi(-3.0), (0.0, -1.0));
            /// ```
            #[inline]
            #[must_use]
            pub fn sin_cos_pi(h: $float) -> ($float, $float) {
                let (q, r) = reduced_any(h);
                let (sin, cos) = kernel(r);
                turned(q, sin[0] + sin[1], cos[0] + cos[1])
            }

            /// Returns (sin π(h − d), cos π(h − d)), where h and d are angles in half-turns (π rad).
            ///
            /// The function never rounds the difference h − d. It reduces h first, subtracts d, and corrects for the
            /// digits that the subtraction loses. Each result is within 1.2 units in the last place, even if h − d is
            /// next to a zero. An exact zero is returned as 0. The result is NaN if h or d is infinite or NaN.
            ///
            /// ```
            #[doc = concat!(
                "use frictiongen_kernel::number::trig::", stringify!($module),
                "::{sin_pi, sin_cos_pi_minus};"
            )]
            ///
            /// // 1000.5 - 1e-20 would be 1000.5, with the cosine 0.
            /// assert_eq!(sin_cos_pi_minus(1000.5, 1e-20), (1.0, sin_pi(1e-20)));
            /// ```
            #[inline]
            #[must_use]
            pub fn sin_cos_pi_minus(h: $float, d: $float) -> ($float, $float) {
                // For a larger |d|, the subtraction in `less` would lose so many digits that their square matters.
                let d = if d.abs() < $near { d } else { wrapped(d) };
                less(reduced_any(h), d)
            }

            /// Returns (sin π(h − d), cos π(h − d)). The argument (q, r) is h in the form that [`reduced`] returns: the
            /// number of halves and the remainder. |d| must be below the macro's parameter `near`.
            #[inline(always)]
            fn less((q, r): ($bits, $float), d: $float) -> ($float, $float) {
                let difference = r - d;
                let subtracted = difference - r;
                let lost = (r - (difference - subtracted)) - (d + subtracted);
                // `lost` contains the digits that rounding removed from r − d. The first-order term of the addition
                // theorem restores the effect of these digits.
                let angle = lost * core::$float::consts::PI;
                let (p, rest) = reduced(difference);
                let (sin, cos) = kernel(rest);
                let (s, c) = (sin[0] + sin[1], cos[0] + cos[1]);
                let (s, c) = (sin[0] + (sin[1] + angle * c), cos[0] + (cos[1] - angle * s));
                turned(q.wrapping_add(p), s, c)
            }

            /// Subtracts a multiple of 4 from each number that is too large for [`reduced`]. A number that is not too
            /// large does not change.
            #[inline(always)]
            fn near_of<const N: usize>(mut h: [$float; N]) -> [$float; N] {
                // The code has one branch for all numbers of the array, instead of one branch for each number. The
                // compiler can then use packed instructions.
                if !h.iter().fold(true, |all, h| all & (h.abs() < $exact)) {
                    for h in &mut h {
                        if !(h.abs() < $exact) {
                            *h = wrapped(*h);
                        }
                    }
                }
                h
            }

            /// Evaluates [`sin_cos_pi`] for each number of an array. Returns the array of sines, then the array of
            /// cosines.
            #[inline(always)]
            pub(crate) fn sin_cos_pi_of<const N: usize>(h: [$float; N]) -> [[$float; N]; 2] {
                // All branches are before the loop, so that the compiler uses packed instructions for the loop.
                let h = near_of(h);
                let (mut sines, mut cosines) = (h, h);
                for ((s, c), h) in sines.iter_mut().zip(&mut cosines).zip(h) {
                    let (q, r) = reduced(h);
                    let (sin, cos) = kernel(r);
                    (*s, *c) = turned(q, sin[0] + sin[1], cos[0] + cos[1]);
                }
                [sines, cosines]
            }

            /// Evaluates [`sin_cos_pi_minus`] for each pair (h, d) of two arrays. Returns the array of sines, then the
            /// array of cosines.
            #[inline(always)]
            pub(crate) fn sin_cos_pi_minus_of<const N: usize>(
                h: [$float; N],
                d: [$float; N],
            ) -> [[$float; N]; 2] {
                let near = |d: $float| if d.abs() < $near { d } else { wrapped(d) };
                let (reduced, near) = (h.map(reduced_any), d.map(near));
                let (mut sines, mut cosines) = (h, h);
                let places = sines.iter_mut().zip(&mut cosines);
                for ((s, c), (h, d)) in places.zip(reduced.into_iter().zip(near)) {
                    (*s, *c) = less(h, d);
                }
                [sines, cosines]
            }

            /// Returns sin πh, where h is an angle in half-turns (π rad). The error is at most 1.1 units in the last
            /// place.
            /// ```
            #[doc = concat!("use frictiongen_kernel::number::trig::", stringify!($module), "::sin_pi;")]
            ///
            /// assert_eq!(sin_pi(-1.5), 1.0);
            /// assert_eq!(sin_pi(1e9), 0.0);
            /// ```
            #[inline]
            #[must_use]
            pub fn sin_pi(h: $float) -> $float {
                sin_cos_pi(h).0
            }
        }
    };
}

half_turns! {
    /// Sine and cosine of angles in half-turns (π rad), in `f64`.
    double: f64 as u64,
    to_halves: 6_755_399_441_055_744.0 / 2.0, to_fours: 6_755_399_441_055_744.0 * 4.0,
    exact: 1_125_899_906_842_624.0, even: 9_007_199_254_740_992.0, near: 1_048_576.0,
    leading: !0xf_ffff_ffff,
    pi: [3.1415926535846666, 5.126688303189038e-12],
    half_pi_squared: 4.934802200544679,
    sin: [
        -5.167712780049959,
        2.5501640398739,
        -0.5992645289668816,
        0.082145869870122,
        -0.00737003000375459,
        0.0004615714412287862,
    ],
    cos: [
        4.058712126416761,
        -1.3352627688530614,
        0.2353306302376655,
        -0.025806886654452167,
        0.0019294765373059936,
        -0.00010361369842729192,
    ],
}

half_turns! {
    /// Sine and cosine of angles in half-turns (π rad), in `f32`. No step uses `f64`.
    single: f32 as u32,
    to_halves: 12_582_912.0 / 2.0, to_fours: 12_582_912.0 * 4.0,
    exact: 2_097_152.0, even: 16_777_216.0, near: 64.0,
    leading: !0xffff,
    pi: [3.1416016, -8.90891e-06],
    half_pi_squared: 4.934802,
    sin: [-5.167709, 2.5498047, -0.58941096],
    cos: [4.05871, -1.3351114, 0.23183197],
}
