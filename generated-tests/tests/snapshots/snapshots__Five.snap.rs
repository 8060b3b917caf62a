/// Five masses, damped: sums over modes are calls, the frequency stage is straight lines.
///
/// Emitted by frictiongen 0.1.0 from scene b9320e7b53704e7d.
#[::core::prelude::v1::derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::Eq,
    ::core::cmp::PartialEq,
    ::core::default::Default,
    ::core::hash::Hash
)]
pub struct Five;
/// [`Five`] at one frequency ratio: limits, regime, and the way to motions.
#[allow(deprecated, non_camel_case_types)]
pub struct FiveAt(::frictiongen::kernel::response::At<Five>);
/// The exact continuous motion of [`Five`] at one frequency and one friction ratio.
#[allow(deprecated, non_camel_case_types)]
pub struct FiveMotion(::frictiongen::kernel::response::Continuous<Five>);
/// The response of [`Five`] at one frequency ratio while its contact is stuck.
#[allow(deprecated, non_camel_case_types)]
pub struct FiveStuck(::frictiongen::kernel::response::Stuck<Five>);
#[automatically_derived]
#[allow(
    deprecated,
    non_snake_case,
    non_camel_case_types,
    unused_imports,
    unused_qualifications,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    clippy::restriction
)]
const _: () = {
    use ::frictiongen::kernel::emitted::*;
    impl Five {
        /// ω_i, the natural frequencies, rad/s in the units given, ascending.
        pub const NATURAL_FREQUENCIES: [f64; 5] = [
            0.2846296765465703,
            0.8308300260037729,
            1.3097214678905702,
            1.6825070656623624,
            1.9189859472289947,
        ];
        /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
        pub const RESONANCES: [f64; 5] = [
            0.2846296765465703,
            0.8308300260037729,
            1.3097214678905702,
            1.6825070656623624,
            1.9189859472289947,
        ];
        /// φ, [mode][mass], with φᵀΓφ = 1; of each mode the first component that counts is positive.
        pub const MODE_SHAPES: [[f64; 5]; 5] = [
            [
                0.16989112404918136,
                0.32601867960931696,
                0.4557341406552499,
                0.5485287319805897,
                0.5968847876668415,
            ],
            [
                0.4557341406552499,
                0.5968847876668415,
                0.32601867960931696,
                -0.16989112404918136,
                -0.5485287319805897,
            ],
            [
                0.5968847876668415,
                0.16989112404918136,
                -0.5485287319805897,
                -0.32601867960931696,
                0.4557341406552499,
            ],
            [
                0.5485287319805897,
                -0.4557341406552499,
                -0.16989112404918136,
                0.5968847876668415,
                -0.32601867960931696,
            ],
            [
                0.32601867960931696,
                -0.5485287319805897,
                0.5968847876668415,
                -0.4557341406552499,
                0.16989112404918136,
            ],
        ];
        /// The modes that the load or the contact drives.
        const MODES: [Mode<f64>; 5] = [
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.2846296765465703,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.16989112404918136,
                contact: 0.16989112404918136,
                residue: 0.028862994030694332,
                inverse_mass: 0.028862994030694332,
                static_residue: 0.35627144974809044,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 0.8308300260037729,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.4557341406552499,
                contact: 0.4557341406552499,
                residue: 0.20769360695877911,
                inverse_mass: 0.20769360695877911,
                static_residue: 0.30088376980823367,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.3097214678905702,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.5968847876668415,
                contact: 0.5968847876668415,
                residue: 0.35627144974809044,
                inverse_mass: 0.35627144974809044,
                static_residue: 0.20769360695877911,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.6825070656623624,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.5485287319805897,
                contact: 0.5485287319805897,
                residue: 0.30088376980823367,
                inverse_mass: 0.30088376980823367,
                static_residue: 0.10628817945420246,
            },
            Mode {
                kind: Kind::Light,
                in_contact: true,
                resonance: 1.9189859472289947,
                zeta: 0.01,
                q: 0.9999499987499375,
                q_defect: 5.000125006250391e-5,
                load: 0.32601867960931696,
                contact: 0.32601867960931696,
                residue: 0.10628817945420246,
                inverse_mass: 0.10628817945420246,
                static_residue: 0.028862994030694332,
            },
        ];
        const CHAIN: Chain<f64> = Chain {
            damped: true,
            on_moving_base: None,
            inverse_mass: 1.0,
            stiction: 1.0,
        };
        const NUMBERS: Numbers<'static, f64> = Numbers {
            modes: &Self::MODES,
            chain: Self::CHAIN,
            ends: Ends {
                sliding_at_rest: 1.0,
                continuous_at_infinity: 0.5370292721463151,
                sliding_at_infinity: 1.0,
            },
            rubbing: Some(0),
            absorbs: false,
            unbounded: &[],
            invisible: &[],
        };
        /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
        #[inline]
        #[must_use]
        pub const fn frequency_ratio(omega: f64) -> f64 {
            omega
        }
        /// A friction force F and a load amplitude P, for base motion k₁Y, as friction ratio β = F/P.
        #[inline]
        #[must_use]
        pub const fn friction_ratio(friction: f64, load: f64) -> f64 {
            friction / load
        }
        /// The scene at the frequency ratio r = ω√(m₁/k₁).
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn at(r: f64) -> Result<FiveAt, OutOfDomain> {
            At::new(Self, r).map(From::from)
        }
        /// Both limits without search: β_lim with S replaced by its limit for τ → 0 (5.64), an upper bound, and
        /// β*_lim (6.11, 6.27, 6.33).  Where nothing else is asked of r, this is the shortest way.
        ///
        /// # Errors
        /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
        #[inline]
        pub fn limits_without_search(r: f64) -> Result<Limits<f64>, OutOfDomain> {
            At::limits_without_search(&Self, r)
        }
        /// Both limits over a slice of frequency ratios, into slices of the same length.
        ///
        /// # Errors
        /// `OutOfDomain` for a slice of another length, which changes nothing, and at the first NaN or negative r.
        pub fn limits_into(
            rs: &[f64],
            continuous: &mut [f64],
            sliding: &mut [f64],
        ) -> Result<(), OutOfDomain> {
            At::limits_into(Self, rs, continuous, sliding)
        }
    }
    ::frictiongen::emitted_system!(Five, FiveAt, f64, ["m1", "m2", "m3", "m4", "m5"]);
    ::frictiongen::kernel::wraps!(FiveAt, At of Five, Copy);
    impl Scene for Five {
        type Scalar = f64;
        type Decay = Damped<f64>;
        type Modes = [ModeAt<f64>; 5];
        type Waves = [Wave<f64, Damped<f64>>; 5];
        #[inline]
        fn numbers(&self) -> Numbers<'static, f64> {
            Self::NUMBERS
        }
        /// φ of a mass, by modes.
        #[inline]
        fn shape(&self, mass: usize) -> Option<&[f64]> {
            match mass {
                0 => {
                    Some(
                        &[
                            0.16989112404918136,
                            0.4557341406552499,
                            0.5968847876668415,
                            0.5485287319805897,
                            0.32601867960931696,
                        ],
                    )
                }
                1 => {
                    Some(
                        &[
                            0.32601867960931696,
                            0.5968847876668415,
                            0.16989112404918136,
                            -0.4557341406552499,
                            -0.5485287319805897,
                        ],
                    )
                }
                2 => {
                    Some(
                        &[
                            0.4557341406552499,
                            0.32601867960931696,
                            -0.5485287319805897,
                            -0.16989112404918136,
                            0.5968847876668415,
                        ],
                    )
                }
                3 => {
                    Some(
                        &[
                            0.5485287319805897,
                            -0.16989112404918136,
                            -0.32601867960931696,
                            0.5968847876668415,
                            -0.4557341406552499,
                        ],
                    )
                }
                4 => {
                    Some(
                        &[
                            0.5968847876668415,
                            -0.5485287319805897,
                            0.4557341406552499,
                            -0.32601867960931696,
                            0.16989112404918136,
                        ],
                    )
                }
                _ => None,
            }
        }
        #[inline]
        fn moves(&self, mass: usize) -> bool {
            match mass {
                4 => true,
                _ => false,
            }
        }
        #[inline]
        fn inverse_ratio_range(&self) -> (f64, f64) {
            (3.8725919148493183e-121, 2.5822498780869086e120)
        }
        #[inline]
        fn idle(&self) -> Self::Waves {
            Self::MODES.map(|mode| Wave::idle(&mode))
        }
        /// The response and damping functions V, U, G, H of the contact (3.11, 5.20, 5.34, 5.37, 7.11, 7.12), each
        /// times r²E with the scale E that keeps them finite on a resonance, and each mode's part in them.
        ///
        /// Operations: 404: 245 ×, 75 +, 35 ÷, 25 sign, 5 exp_m1, 5 one_minus_sinc_pi, 5 scaled_sinh_defect, 5 sin_cos_pi, 4 compare.
        #[inline]
        fn frequency_stage(&self, inverse_r: f64) -> (ContactAt<f64>, [ModeAt<f64>; 5]) {
            let mode_1 = {
                let frequency = 0.2846296765465703 * inverse_r;
                let detuning = (frequency - 1.0) * (frequency + 1.0);
                let loss = 0.02 * frequency;
                let size = Scalar::abs(detuning) + loss;
                let decay_exponent = 0.031415926535897934 * frequency;
                let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
                let half_decay_factor = 1.0 + half_decay_minus_one;
                let decay_complement = -(half_decay_minus_one
                    * (1.0 + half_decay_factor));
                let decay_factor = half_decay_factor * half_decay_factor;
                let half_turns = 0.9999499987499375 * frequency;
                let (sine, cosine) = Scalar::sin_cos_pi_minus(
                    frequency * 0.5,
                    frequency * 2.5000625031251956e-5,
                );
                let one_plus_factor = 1.0 + decay_factor;
                let nearness_re = one_plus_factor * cosine;
                let nearness_im = decay_complement * sine;
                let inverse_nearness = 1.0
                    / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
                let unit_nearness_re = nearness_re * inverse_nearness;
                let unit_nearness_im = nearness_im * inverse_nearness;
                let pole_weight = size * inverse_nearness
                    / (unit_nearness_re * unit_nearness_re
                        + unit_nearness_im * unit_nearness_im);
                let swing = 4.00020001500125 * sine * decay_factor
                    * (cosine * inverse_nearness) * pole_weight;
                let u = swing / frequency;
                let g = (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight;
                let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                    * pole_weight + 0.01 * swing;
                ModeResponse {
                    x: frequency,
                    denominator: Complex { re: detuning, im: loss },
                    size,
                    u,
                    g,
                    reversal,
                }
            };
            let mode_2 = {
                let frequency = 0.8308300260037729 * inverse_r;
                let detuning = (frequency - 1.0) * (frequency + 1.0);
                let loss = 0.02 * frequency;
                let size = Scalar::abs(detuning) + loss;
                let decay_exponent = 0.031415926535897934 * frequency;
                let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
                let half_decay_factor = 1.0 + half_decay_minus_one;
                let decay_complement = -(half_decay_minus_one
                    * (1.0 + half_decay_factor));
                let decay_factor = half_decay_factor * half_decay_factor;
                let half_turns = 0.9999499987499375 * frequency;
                let (sine, cosine) = Scalar::sin_cos_pi_minus(
                    frequency * 0.5,
                    frequency * 2.5000625031251956e-5,
                );
                let one_plus_factor = 1.0 + decay_factor;
                let nearness_re = one_plus_factor * cosine;
                let nearness_im = decay_complement * sine;
                let inverse_nearness = 1.0
                    / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
                let unit_nearness_re = nearness_re * inverse_nearness;
                let unit_nearness_im = nearness_im * inverse_nearness;
                let pole_weight = size * inverse_nearness
                    / (unit_nearness_re * unit_nearness_re
                        + unit_nearness_im * unit_nearness_im);
                let swing = 4.00020001500125 * sine * decay_factor
                    * (cosine * inverse_nearness) * pole_weight;
                let u = swing / frequency;
                let g = (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight;
                let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                    * pole_weight + 0.01 * swing;
                ModeResponse {
                    x: frequency,
                    denominator: Complex { re: detuning, im: loss },
                    size,
                    u,
                    g,
                    reversal,
                }
            };
            let mode_3 = {
                let frequency = 1.3097214678905702 * inverse_r;
                let detuning = (frequency - 1.0) * (frequency + 1.0);
                let loss = 0.02 * frequency;
                let size = Scalar::abs(detuning) + loss;
                let decay_exponent = 0.031415926535897934 * frequency;
                let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
                let half_decay_factor = 1.0 + half_decay_minus_one;
                let decay_complement = -(half_decay_minus_one
                    * (1.0 + half_decay_factor));
                let decay_factor = half_decay_factor * half_decay_factor;
                let half_turns = 0.9999499987499375 * frequency;
                let (sine, cosine) = Scalar::sin_cos_pi_minus(
                    frequency * 0.5,
                    frequency * 2.5000625031251956e-5,
                );
                let one_plus_factor = 1.0 + decay_factor;
                let nearness_re = one_plus_factor * cosine;
                let nearness_im = decay_complement * sine;
                let inverse_nearness = 1.0
                    / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
                let unit_nearness_re = nearness_re * inverse_nearness;
                let unit_nearness_im = nearness_im * inverse_nearness;
                let pole_weight = size * inverse_nearness
                    / (unit_nearness_re * unit_nearness_re
                        + unit_nearness_im * unit_nearness_im);
                let swing = 4.00020001500125 * sine * decay_factor
                    * (cosine * inverse_nearness) * pole_weight;
                let u = swing / frequency;
                let g = (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight;
                let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                    * pole_weight + 0.01 * swing;
                ModeResponse {
                    x: frequency,
                    denominator: Complex { re: detuning, im: loss },
                    size,
                    u,
                    g,
                    reversal,
                }
            };
            let mode_4 = {
                let frequency = 1.6825070656623624 * inverse_r;
                let detuning = (frequency - 1.0) * (frequency + 1.0);
                let loss = 0.02 * frequency;
                let size = Scalar::abs(detuning) + loss;
                let decay_exponent = 0.031415926535897934 * frequency;
                let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
                let half_decay_factor = 1.0 + half_decay_minus_one;
                let decay_complement = -(half_decay_minus_one
                    * (1.0 + half_decay_factor));
                let decay_factor = half_decay_factor * half_decay_factor;
                let half_turns = 0.9999499987499375 * frequency;
                let (sine, cosine) = Scalar::sin_cos_pi_minus(
                    frequency * 0.5,
                    frequency * 2.5000625031251956e-5,
                );
                let one_plus_factor = 1.0 + decay_factor;
                let nearness_re = one_plus_factor * cosine;
                let nearness_im = decay_complement * sine;
                let inverse_nearness = 1.0
                    / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
                let unit_nearness_re = nearness_re * inverse_nearness;
                let unit_nearness_im = nearness_im * inverse_nearness;
                let pole_weight = size * inverse_nearness
                    / (unit_nearness_re * unit_nearness_re
                        + unit_nearness_im * unit_nearness_im);
                let swing = 4.00020001500125 * sine * decay_factor
                    * (cosine * inverse_nearness) * pole_weight;
                let u = swing / frequency;
                let g = (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight;
                let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                    * pole_weight + 0.01 * swing;
                ModeResponse {
                    x: frequency,
                    denominator: Complex { re: detuning, im: loss },
                    size,
                    u,
                    g,
                    reversal,
                }
            };
            let mode_5 = {
                let frequency = 1.9189859472289947 * inverse_r;
                let detuning = (frequency - 1.0) * (frequency + 1.0);
                let loss = 0.02 * frequency;
                let size = Scalar::abs(detuning) + loss;
                let decay_exponent = 0.031415926535897934 * frequency;
                let half_decay_minus_one = Scalar::exp_m1(decay_exponent * -0.5);
                let half_decay_factor = 1.0 + half_decay_minus_one;
                let decay_complement = -(half_decay_minus_one
                    * (1.0 + half_decay_factor));
                let decay_factor = half_decay_factor * half_decay_factor;
                let half_turns = 0.9999499987499375 * frequency;
                let (sine, cosine) = Scalar::sin_cos_pi_minus(
                    frequency * 0.5,
                    frequency * 2.5000625031251956e-5,
                );
                let one_plus_factor = 1.0 + decay_factor;
                let nearness_re = one_plus_factor * cosine;
                let nearness_im = decay_complement * sine;
                let inverse_nearness = 1.0
                    / (Scalar::abs(nearness_re) + Scalar::abs(nearness_im));
                let unit_nearness_re = nearness_re * inverse_nearness;
                let unit_nearness_im = nearness_im * inverse_nearness;
                let pole_weight = size * inverse_nearness
                    / (unit_nearness_re * unit_nearness_re
                        + unit_nearness_im * unit_nearness_im);
                let swing = 4.00020001500125 * sine * decay_factor
                    * (cosine * inverse_nearness) * pole_weight;
                let u = swing / frequency;
                let g = (Scalar::scaled_sinh_defect(decay_exponent)
                    + 2.0 * decay_factor * decay_exponent
                        * Scalar::one_minus_sinc_pi(half_turns)) * inverse_nearness
                    * pole_weight;
                let reversal = one_plus_factor * (decay_complement * inverse_nearness)
                    * pole_weight + 0.01 * swing;
                ModeResponse {
                    x: frequency,
                    denominator: Complex { re: detuning, im: loss },
                    size,
                    u,
                    g,
                    reversal,
                }
            };
            let scale = Scalar::min(
                Scalar::min(
                    Scalar::min(Scalar::min(mode_1.size, mode_2.size), mode_3.size),
                    mode_4.size,
                ),
                mode_5.size,
            );
            let modes = [
                Self::CHAIN.at_scale(&mode_1, scale),
                Self::CHAIN.at_scale(&mode_2, scale),
                Self::CHAIN.at_scale(&mode_3, scale),
                Self::CHAIN.at_scale(&mode_4, scale),
                Self::CHAIN.at_scale(&mode_5, scale),
            ];
            let [at_1, at_2, at_3, at_4, at_5] = &modes;
            let v_re = at_1.response.re * 0.028862994030694332
                + at_2.response.re * 0.20769360695877911
                + at_3.response.re * 0.35627144974809044
                + at_4.response.re * 0.30088376980823367
                + at_5.response.re * 0.10628817945420246;
            let v_im = at_1.response.im * 0.028862994030694332
                + at_2.response.im * 0.20769360695877911
                + at_3.response.im * 0.35627144974809044
                + at_4.response.im * 0.30088376980823367
                + at_5.response.im * 0.10628817945420246;
            let u = 0.028862994030694332 * at_1.u + 0.20769360695877911 * at_2.u
                + 0.35627144974809044 * at_3.u + 0.30088376980823367 * at_4.u
                + 0.10628817945420246 * at_5.u;
            let g = 0.028862994030694332 * (at_1.g / (at_1.x * at_1.x))
                + 0.20769360695877911 * (at_2.g / (at_2.x * at_2.x))
                + 0.35627144974809044 * (at_3.g / (at_3.x * at_3.x))
                + 0.30088376980823367 * (at_4.g / (at_4.x * at_4.x))
                + 0.10628817945420246 * (at_5.g / (at_5.x * at_5.x));
            let reversal = 0.028862994030694332
                * (mode_1.reversal * (scale / mode_1.size))
                + 0.20769360695877911 * (mode_2.reversal * (scale / mode_2.size))
                + 0.35627144974809044 * (mode_3.reversal * (scale / mode_3.size))
                + 0.30088376980823367 * (mode_4.reversal * (scale / mode_4.size))
                + 0.10628817945420246 * (mode_5.reversal * (scale / mode_5.size));
            let contact = ContactAt {
                scale,
                v: Complex { re: v_re, im: v_im },
                u,
                g,
                reversal,
                h: Complex { re: v_re, im: v_im },
            };
            (contact, modes)
        }
        /// r²E(H_c + μm*/r²), what the contact force needs for break-away at a reversal (5.63, 7.47).
        #[inline]
        fn break_away(&self, contact: &ContactAt<f64>) -> f64 {
            contact.reversal + contact.scale
        }
        /// β_lim = |V|/√(U² + max(S, H_c + μm*/r²)²) (5.65, 5.80, 5.96, 7.49); `constraint` is r²E times that
        /// maximum.
        #[inline]
        fn continuous_limit(&self, contact: &ContactAt<f64>, constraint: f64) -> f64 {
            let excitation = Scalar::hypot(contact.v.re, contact.v.im);
            excitation / Scalar::sqrt(contact.u * contact.u + constraint * constraint)
        }
        /// β*_lim = |V|/(μ|H|) (6.11, 6.27, 6.33).
        #[inline]
        fn sliding_limit(&self, contact: &ContactAt<f64>) -> f64 {
            let excitation = Scalar::hypot(contact.v.re, contact.v.im);
            let receptance = Scalar::hypot(contact.h.re, contact.h.im);
            excitation / receptance
        }
        /// Both limits (5.64; 6.11, 6.27, 6.33), without what only a motion needs, and the real part of H.
        ///
        /// Operations: 343: 202 ×, 68 +, 32 ÷, 25 sign, 5 exp_m1, 5 sin_cos_pi, 4 compare, 1 hypot, 1 √.
        #[inline]
        fn limits_without_search(&self, inverse_r: f64) -> (Limits<f64>, f64) {
            let mode_1_frequency = 0.2846296765465703 * inverse_r;
            let mode_1_detuning = (mode_1_frequency - 1.0) * (mode_1_frequency + 1.0);
            let mode_1_loss = 0.02 * mode_1_frequency;
            let mode_1_size = Scalar::abs(mode_1_detuning) + mode_1_loss;
            let mode_1_decay_exponent = 0.031415926535897934 * mode_1_frequency;
            let mode_1_half_decay_minus_one = Scalar::exp_m1(
                mode_1_decay_exponent * -0.5,
            );
            let mode_1_half_decay_factor = 1.0 + mode_1_half_decay_minus_one;
            let mode_1_decay_complement = -(mode_1_half_decay_minus_one
                * (1.0 + mode_1_half_decay_factor));
            let mode_1_decay_factor = mode_1_half_decay_factor
                * mode_1_half_decay_factor;
            let (mode_1_sine, mode_1_cosine) = Scalar::sin_cos_pi_minus(
                mode_1_frequency * 0.5,
                mode_1_frequency * 2.5000625031251956e-5,
            );
            let mode_1_one_plus_factor = 1.0 + mode_1_decay_factor;
            let mode_1_nearness_re = mode_1_one_plus_factor * mode_1_cosine;
            let mode_1_nearness_im = mode_1_decay_complement * mode_1_sine;
            let mode_1_inverse_nearness = 1.0
                / (Scalar::abs(mode_1_nearness_re) + Scalar::abs(mode_1_nearness_im));
            let mode_1_unit_nearness_re = mode_1_nearness_re * mode_1_inverse_nearness;
            let mode_1_unit_nearness_im = mode_1_nearness_im * mode_1_inverse_nearness;
            let mode_1_pole_weight = mode_1_size * mode_1_inverse_nearness
                / (mode_1_unit_nearness_re * mode_1_unit_nearness_re
                    + mode_1_unit_nearness_im * mode_1_unit_nearness_im);
            let mode_1_swing = 4.00020001500125 * mode_1_sine * mode_1_decay_factor
                * (mode_1_cosine * mode_1_inverse_nearness) * mode_1_pole_weight;
            let mode_1_u = mode_1_swing / mode_1_frequency;
            let mode_1_reversal = mode_1_one_plus_factor
                * (mode_1_decay_complement * mode_1_inverse_nearness)
                * mode_1_pole_weight + 0.01 * mode_1_swing;
            let mode_2_frequency = 0.8308300260037729 * inverse_r;
            let mode_2_detuning = (mode_2_frequency - 1.0) * (mode_2_frequency + 1.0);
            let mode_2_loss = 0.02 * mode_2_frequency;
            let mode_2_size = Scalar::abs(mode_2_detuning) + mode_2_loss;
            let mode_2_decay_exponent = 0.031415926535897934 * mode_2_frequency;
            let mode_2_half_decay_minus_one = Scalar::exp_m1(
                mode_2_decay_exponent * -0.5,
            );
            let mode_2_half_decay_factor = 1.0 + mode_2_half_decay_minus_one;
            let mode_2_decay_complement = -(mode_2_half_decay_minus_one
                * (1.0 + mode_2_half_decay_factor));
            let mode_2_decay_factor = mode_2_half_decay_factor
                * mode_2_half_decay_factor;
            let (mode_2_sine, mode_2_cosine) = Scalar::sin_cos_pi_minus(
                mode_2_frequency * 0.5,
                mode_2_frequency * 2.5000625031251956e-5,
            );
            let mode_2_one_plus_factor = 1.0 + mode_2_decay_factor;
            let mode_2_nearness_re = mode_2_one_plus_factor * mode_2_cosine;
            let mode_2_nearness_im = mode_2_decay_complement * mode_2_sine;
            let mode_2_inverse_nearness = 1.0
                / (Scalar::abs(mode_2_nearness_re) + Scalar::abs(mode_2_nearness_im));
            let mode_2_unit_nearness_re = mode_2_nearness_re * mode_2_inverse_nearness;
            let mode_2_unit_nearness_im = mode_2_nearness_im * mode_2_inverse_nearness;
            let mode_2_pole_weight = mode_2_size * mode_2_inverse_nearness
                / (mode_2_unit_nearness_re * mode_2_unit_nearness_re
                    + mode_2_unit_nearness_im * mode_2_unit_nearness_im);
            let mode_2_swing = 4.00020001500125 * mode_2_sine * mode_2_decay_factor
                * (mode_2_cosine * mode_2_inverse_nearness) * mode_2_pole_weight;
            let mode_2_u = mode_2_swing / mode_2_frequency;
            let mode_2_reversal = mode_2_one_plus_factor
                * (mode_2_decay_complement * mode_2_inverse_nearness)
                * mode_2_pole_weight + 0.01 * mode_2_swing;
            let mode_3_frequency = 1.3097214678905702 * inverse_r;
            let mode_3_detuning = (mode_3_frequency - 1.0) * (mode_3_frequency + 1.0);
            let mode_3_loss = 0.02 * mode_3_frequency;
            let mode_3_size = Scalar::abs(mode_3_detuning) + mode_3_loss;
            let mode_3_decay_exponent = 0.031415926535897934 * mode_3_frequency;
            let mode_3_half_decay_minus_one = Scalar::exp_m1(
                mode_3_decay_exponent * -0.5,
            );
            let mode_3_half_decay_factor = 1.0 + mode_3_half_decay_minus_one;
            let mode_3_decay_complement = -(mode_3_half_decay_minus_one
                * (1.0 + mode_3_half_decay_factor));
            let mode_3_decay_factor = mode_3_half_decay_factor
                * mode_3_half_decay_factor;
            let (mode_3_sine, mode_3_cosine) = Scalar::sin_cos_pi_minus(
                mode_3_frequency * 0.5,
                mode_3_frequency * 2.5000625031251956e-5,
            );
            let mode_3_one_plus_factor = 1.0 + mode_3_decay_factor;
            let mode_3_nearness_re = mode_3_one_plus_factor * mode_3_cosine;
            let mode_3_nearness_im = mode_3_decay_complement * mode_3_sine;
            let mode_3_inverse_nearness = 1.0
                / (Scalar::abs(mode_3_nearness_re) + Scalar::abs(mode_3_nearness_im));
            let mode_3_unit_nearness_re = mode_3_nearness_re * mode_3_inverse_nearness;
            let mode_3_unit_nearness_im = mode_3_nearness_im * mode_3_inverse_nearness;
            let mode_3_pole_weight = mode_3_size * mode_3_inverse_nearness
                / (mode_3_unit_nearness_re * mode_3_unit_nearness_re
                    + mode_3_unit_nearness_im * mode_3_unit_nearness_im);
            let mode_3_swing = 4.00020001500125 * mode_3_sine * mode_3_decay_factor
                * (mode_3_cosine * mode_3_inverse_nearness) * mode_3_pole_weight;
            let mode_3_u = mode_3_swing / mode_3_frequency;
            let mode_3_reversal = mode_3_one_plus_factor
                * (mode_3_decay_complement * mode_3_inverse_nearness)
                * mode_3_pole_weight + 0.01 * mode_3_swing;
            let mode_4_frequency = 1.6825070656623624 * inverse_r;
            let mode_4_detuning = (mode_4_frequency - 1.0) * (mode_4_frequency + 1.0);
            let mode_4_loss = 0.02 * mode_4_frequency;
            let mode_4_size = Scalar::abs(mode_4_detuning) + mode_4_loss;
            let mode_4_decay_exponent = 0.031415926535897934 * mode_4_frequency;
            let mode_4_half_decay_minus_one = Scalar::exp_m1(
                mode_4_decay_exponent * -0.5,
            );
            let mode_4_half_decay_factor = 1.0 + mode_4_half_decay_minus_one;
            let mode_4_decay_complement = -(mode_4_half_decay_minus_one
                * (1.0 + mode_4_half_decay_factor));
            let mode_4_decay_factor = mode_4_half_decay_factor
                * mode_4_half_decay_factor;
            let (mode_4_sine, mode_4_cosine) = Scalar::sin_cos_pi_minus(
                mode_4_frequency * 0.5,
                mode_4_frequency * 2.5000625031251956e-5,
            );
            let mode_4_one_plus_factor = 1.0 + mode_4_decay_factor;
            let mode_4_nearness_re = mode_4_one_plus_factor * mode_4_cosine;
            let mode_4_nearness_im = mode_4_decay_complement * mode_4_sine;
            let mode_4_inverse_nearness = 1.0
                / (Scalar::abs(mode_4_nearness_re) + Scalar::abs(mode_4_nearness_im));
            let mode_4_unit_nearness_re = mode_4_nearness_re * mode_4_inverse_nearness;
            let mode_4_unit_nearness_im = mode_4_nearness_im * mode_4_inverse_nearness;
            let mode_4_pole_weight = mode_4_size * mode_4_inverse_nearness
                / (mode_4_unit_nearness_re * mode_4_unit_nearness_re
                    + mode_4_unit_nearness_im * mode_4_unit_nearness_im);
            let mode_4_swing = 4.00020001500125 * mode_4_sine * mode_4_decay_factor
                * (mode_4_cosine * mode_4_inverse_nearness) * mode_4_pole_weight;
            let mode_4_u = mode_4_swing / mode_4_frequency;
            let mode_4_reversal = mode_4_one_plus_factor
                * (mode_4_decay_complement * mode_4_inverse_nearness)
                * mode_4_pole_weight + 0.01 * mode_4_swing;
            let mode_5_frequency = 1.9189859472289947 * inverse_r;
            let mode_5_detuning = (mode_5_frequency - 1.0) * (mode_5_frequency + 1.0);
            let mode_5_loss = 0.02 * mode_5_frequency;
            let mode_5_size = Scalar::abs(mode_5_detuning) + mode_5_loss;
            let mode_5_decay_exponent = 0.031415926535897934 * mode_5_frequency;
            let mode_5_half_decay_minus_one = Scalar::exp_m1(
                mode_5_decay_exponent * -0.5,
            );
            let mode_5_half_decay_factor = 1.0 + mode_5_half_decay_minus_one;
            let mode_5_decay_complement = -(mode_5_half_decay_minus_one
                * (1.0 + mode_5_half_decay_factor));
            let mode_5_decay_factor = mode_5_half_decay_factor
                * mode_5_half_decay_factor;
            let (mode_5_sine, mode_5_cosine) = Scalar::sin_cos_pi_minus(
                mode_5_frequency * 0.5,
                mode_5_frequency * 2.5000625031251956e-5,
            );
            let mode_5_one_plus_factor = 1.0 + mode_5_decay_factor;
            let mode_5_nearness_re = mode_5_one_plus_factor * mode_5_cosine;
            let mode_5_nearness_im = mode_5_decay_complement * mode_5_sine;
            let mode_5_inverse_nearness = 1.0
                / (Scalar::abs(mode_5_nearness_re) + Scalar::abs(mode_5_nearness_im));
            let mode_5_unit_nearness_re = mode_5_nearness_re * mode_5_inverse_nearness;
            let mode_5_unit_nearness_im = mode_5_nearness_im * mode_5_inverse_nearness;
            let mode_5_pole_weight = mode_5_size * mode_5_inverse_nearness
                / (mode_5_unit_nearness_re * mode_5_unit_nearness_re
                    + mode_5_unit_nearness_im * mode_5_unit_nearness_im);
            let mode_5_swing = 4.00020001500125 * mode_5_sine * mode_5_decay_factor
                * (mode_5_cosine * mode_5_inverse_nearness) * mode_5_pole_weight;
            let mode_5_u = mode_5_swing / mode_5_frequency;
            let mode_5_reversal = mode_5_one_plus_factor
                * (mode_5_decay_complement * mode_5_inverse_nearness)
                * mode_5_pole_weight + 0.01 * mode_5_swing;
            let scale = Scalar::min(
                Scalar::min(
                    Scalar::min(Scalar::min(mode_1_size, mode_2_size), mode_3_size),
                    mode_4_size,
                ),
                mode_5_size,
            );
            let mode_1_inverse_size = 1.0 / mode_1_size;
            let mode_1_unit_re = mode_1_detuning * mode_1_inverse_size;
            let mode_1_unit_im = mode_1_loss * mode_1_inverse_size;
            let mode_1_inverse_modulus = 1.0
                / (mode_1_unit_re * mode_1_unit_re + mode_1_unit_im * mode_1_unit_im);
            let mode_1_share = scale * mode_1_inverse_size;
            let mode_1_response_re = mode_1_unit_re * mode_1_inverse_modulus
                * mode_1_share;
            let mode_1_response_im = -(mode_1_unit_im * mode_1_inverse_modulus)
                * mode_1_share;
            let mode_1_u_scaled = mode_1_u * mode_1_share;
            let mode_2_inverse_size = 1.0 / mode_2_size;
            let mode_2_unit_re = mode_2_detuning * mode_2_inverse_size;
            let mode_2_unit_im = mode_2_loss * mode_2_inverse_size;
            let mode_2_inverse_modulus = 1.0
                / (mode_2_unit_re * mode_2_unit_re + mode_2_unit_im * mode_2_unit_im);
            let mode_2_share = scale * mode_2_inverse_size;
            let mode_2_response_re = mode_2_unit_re * mode_2_inverse_modulus
                * mode_2_share;
            let mode_2_response_im = -(mode_2_unit_im * mode_2_inverse_modulus)
                * mode_2_share;
            let mode_2_u_scaled = mode_2_u * mode_2_share;
            let mode_3_inverse_size = 1.0 / mode_3_size;
            let mode_3_unit_re = mode_3_detuning * mode_3_inverse_size;
            let mode_3_unit_im = mode_3_loss * mode_3_inverse_size;
            let mode_3_inverse_modulus = 1.0
                / (mode_3_unit_re * mode_3_unit_re + mode_3_unit_im * mode_3_unit_im);
            let mode_3_share = scale * mode_3_inverse_size;
            let mode_3_response_re = mode_3_unit_re * mode_3_inverse_modulus
                * mode_3_share;
            let mode_3_response_im = -(mode_3_unit_im * mode_3_inverse_modulus)
                * mode_3_share;
            let mode_3_u_scaled = mode_3_u * mode_3_share;
            let mode_4_inverse_size = 1.0 / mode_4_size;
            let mode_4_unit_re = mode_4_detuning * mode_4_inverse_size;
            let mode_4_unit_im = mode_4_loss * mode_4_inverse_size;
            let mode_4_inverse_modulus = 1.0
                / (mode_4_unit_re * mode_4_unit_re + mode_4_unit_im * mode_4_unit_im);
            let mode_4_share = scale * mode_4_inverse_size;
            let mode_4_response_re = mode_4_unit_re * mode_4_inverse_modulus
                * mode_4_share;
            let mode_4_response_im = -(mode_4_unit_im * mode_4_inverse_modulus)
                * mode_4_share;
            let mode_4_u_scaled = mode_4_u * mode_4_share;
            let mode_5_inverse_size = 1.0 / mode_5_size;
            let mode_5_unit_re = mode_5_detuning * mode_5_inverse_size;
            let mode_5_unit_im = mode_5_loss * mode_5_inverse_size;
            let mode_5_inverse_modulus = 1.0
                / (mode_5_unit_re * mode_5_unit_re + mode_5_unit_im * mode_5_unit_im);
            let mode_5_share = scale * mode_5_inverse_size;
            let mode_5_response_re = mode_5_unit_re * mode_5_inverse_modulus
                * mode_5_share;
            let mode_5_response_im = -(mode_5_unit_im * mode_5_inverse_modulus)
                * mode_5_share;
            let mode_5_u_scaled = mode_5_u * mode_5_share;
            let v_re = mode_1_response_re * 0.028862994030694332
                + mode_2_response_re * 0.20769360695877911
                + mode_3_response_re * 0.35627144974809044
                + mode_4_response_re * 0.30088376980823367
                + mode_5_response_re * 0.10628817945420246;
            let v_im = mode_1_response_im * 0.028862994030694332
                + mode_2_response_im * 0.20769360695877911
                + mode_3_response_im * 0.35627144974809044
                + mode_4_response_im * 0.30088376980823367
                + mode_5_response_im * 0.10628817945420246;
            let u = 0.028862994030694332 * mode_1_u_scaled
                + 0.20769360695877911 * mode_2_u_scaled
                + 0.35627144974809044 * mode_3_u_scaled
                + 0.30088376980823367 * mode_4_u_scaled
                + 0.10628817945420246 * mode_5_u_scaled;
            let reversal = 0.028862994030694332
                * (mode_1_reversal * (scale / mode_1_size))
                + 0.20769360695877911 * (mode_2_reversal * (scale / mode_2_size))
                + 0.35627144974809044 * (mode_3_reversal * (scale / mode_3_size))
                + 0.30088376980823367 * (mode_4_reversal * (scale / mode_4_size))
                + 0.10628817945420246 * (mode_5_reversal * (scale / mode_5_size));
            let sum = reversal + scale;
            let excitation = Scalar::hypot(v_re, v_im);
            (
                Limits {
                    continuous: excitation / Scalar::sqrt(u * u + sum * sum),
                    sliding: excitation / excitation,
                },
                v_re,
            )
        }
    }
    ::frictiongen::kernel::not_provided!(FiveAt : orbit);
    ::frictiongen::kernel::not_provided!(Five : simulation);
    ::frictiongen::kernel::left_out!(FiveMotion : m1, m2, m3, m4);
    impl ProvidesMotion for Five {
        type Motion = FiveMotion;
    }
    ::frictiongen::kernel::wraps!(FiveMotion, Continuous of Five, Copy);
    impl FiveMotion {
        /// The motion of mass `m5` (5.50 and its exact form, 7.29).
        #[must_use]
        pub fn m5(&self) -> MotionOf<Five> {
            self.mass(4)
        }
    }
    impl ProvidesStuck for Five {
        type Stuck = FiveStuck;
    }
    ::frictiongen::kernel::wraps!(FiveStuck, Stuck of Five, Copy);
    impl FiveStuck {
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m1` (6.11, 6.27, 6.33).
        ///
        /// The contact ties it to its support.
        #[must_use]
        pub fn m1(&self) -> Complex<f64> {
            self.mass(0)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m2` (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m2(&self) -> Complex<f64> {
            self.mass(1)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m3` (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m3(&self) -> Complex<f64> {
            self.mass(2)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m4` (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m4(&self) -> Complex<f64> {
            self.mass(3)
        }
        /// x̄* = V_k − H_kV/H, the complex amplitude of mass `m5` (6.11, 6.27, 6.33).
        #[must_use]
        pub fn m5(&self) -> Complex<f64> {
            self.mass(4)
        }
    }
};
