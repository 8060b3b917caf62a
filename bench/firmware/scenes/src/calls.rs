//! The calls that are measured and compared: one list for each scalar.

use crate::{Five, Pair, PairDouble, Sdof, joined, least, stopping, tabled};
use frictiongen::kernel::Scalar;
use frictiongen::watch::{Watch, friction_ratio, transmissibility};
use frictiongen::{Complex, Error};

/// Arguments of a call: the frequency ratio r, the friction ratio β and the phase τ.
#[derive(Clone, Copy, Debug)]
pub struct Input<S> {
    /// Frequency ratio r.
    pub r: S,
    /// Friction ratio β.
    pub beta: S,
    /// Phase τ = ωt of the excitation.
    pub tau: S,
}

/// A call that is measured. It returns two numbers, or −1 twice if the solver returned an error.
pub struct Call<S> {
    /// Name of the scene.
    pub scene: &'static str,
    /// Name of the quantity that the call computes.
    pub question: &'static str,
    /// Function that makes the call.
    pub run: fn(&Input<S>) -> [S; 2],
}

impl<S> Call<S> {
    /// Returns true if the scene computes its quantities from tables.
    pub fn is_tabled(&self) -> bool {
        self.scene.ends_with("to 1e-4")
    }
}

/// The inputs with which every call is made. They give continuous motion below, between and above the resonances.
pub const INPUTS: [Input<f64>; 4] = [
    Input {
        r: 0.9,
        beta: 0.05,
        tau: 1.0,
    },
    Input {
        r: 0.37,
        beta: 0.01,
        tau: 2.5,
    },
    Input {
        r: 2.75,
        beta: 0.02,
        tau: 6.0,
    },
    Input {
        r: 1.3,
        beta: 0.375,
        tau: 0.0,
    },
];

/// The inputs of [`INPUTS`] in single precision.
pub const INPUTS_SINGLE: [Input<f32>; 4] = {
    let mut inputs = [Input {
        r: 0.0,
        beta: 0.0,
        tau: 0.0,
    }; 4];
    let mut index = 0;
    while index < inputs.len() {
        let Input { r, beta, tau } = INPUTS[index];
        inputs[index] = Input {
            r: r as f32,
            beta: beta as f32,
            tau: tau as f32,
        };
        index += 1;
    }
    inputs
};

/// Defines each call as a function of its own. Each can then be linked alone and be proved free of panics.
macro_rules! calls {
    ($scalar:ident $list:ident $count:literal: $($name:ident $scene:literal $question:literal
        |$input:ident| $body:expr;)*) => {
        $(
            #[doc = concat!($scene, ": ", $question, ".")]
            #[inline(never)]
            #[cfg_attr(feature = "prove", no_panic::no_panic)]
            pub fn $name($input: &Input<$scalar>) -> [$scalar; 2] {
                // The closure is necessary so that its body can use `?`.
                let call = || -> Result<[$scalar; 2], Error> { Ok($body) };
                call().unwrap_or([-1.0, -1.0])
            }
        )*
        /// All calls whose scenes have this scalar type.
        pub const $list: [Call<$scalar>; $count] = [
            $(Call { scene: $scene, question: $question, run: $name },)*
        ];
    };
}

/// A complex amplitude of zero.
const NOTHING: Complex<f32> = Complex { re: 0.0, im: 0.0 };

/// Factor by which the friction of [`INPUTS`] grows so that the contact stops in each cycle.
const STOPPING: f32 = 10.0;

calls! { f32 SINGLE 44:
    sdof_without_search "SDOF f32" "limits without search" |at| {
        let limits = Sdof::limits_without_search(at.r)?;
        [limits.continuous, limits.sliding]
    };
    sdof_limits "SDOF f32" "limits" |at| {
        let at = Sdof::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    sdof_contact "SDOF f32" "motion of the contact: amplitude, phase" |at| {
        let at_r = Sdof::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.contact().amplitude(), motion.contact().phase()]
    };
    sdof_displacement "SDOF f32" "motion of a mass: displacement, velocity" |at| {
        let at_r = Sdof::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.mass_1().displacement(at.tau), motion.mass_1().velocity(at.tau)]
    };
    sdof_stuck "SDOF f32" "stuck response" |at| {
        let stuck = Sdof::at(at.r)?.stuck()?.mass_1();
        [stuck.re, stuck.im]
    };
    least_without_search "2DOF f32, [limits]" "limits without search" |at| {
        let limits = least::limits::Pair::limits_without_search(at.r)?;
        [limits.continuous, limits.sliding]
    };
    least_limits "2DOF f32, [limits]" "limits" |at| {
        let at = least::limits::Pair::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    least_motion "2DOF f32, [motion(upper)]" "motion of a mass: displacement, velocity" |at| {
        let at_r = least::motion::Pair::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.upper().displacement(at.tau), motion.upper().velocity(at.tau)]
    };
    pair_limits "2DOF f32" "limits" |at| {
        let at = Pair::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    pair_contact "2DOF f32" "motion of the contact: amplitude, phase" |at| {
        let at_r = Pair::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.contact().amplitude(), motion.contact().phase()]
    };
    pair_displacement "2DOF f32" "motion of a mass: displacement, velocity" |at| {
        let at_r = Pair::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.lower().displacement(at.tau), motion.lower().velocity(at.tau)]
    };
    pair_amplitude "2DOF f32" "motion of a mass: amplitude, phase" |at| {
        let at_r = Pair::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.lower().amplitude(), motion.lower().phase()]
    };
    pair_harmonic "2DOF f32" "motion of a mass: third harmonic" |at| {
        let at_r = Pair::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        let harmonic = motion.lower().harmonic(3);
        [harmonic.re, harmonic.im]
    };
    pair_stuck "2DOF f32" "stuck response" |at| {
        let stuck = Pair::at(at.r)?.stuck()?.lower();
        [stuck.re, stuck.im]
    };
    stopping_sdof "SDOF f32, [orbit]" "steady state: amplitude of the contact, stuck fraction" |at| {
        let at_r = stopping::Sdof::at(at.r)?;
        let orbit = at_r.orbit(at.beta * STOPPING)?;
        [orbit.contact().amplitude(), orbit.stuck_fraction()]
    };
    stopping_pair "2DOF f32, [orbit]" "steady state: amplitude of the contact, stuck fraction" |at| {
        let at_r = stopping::Pair::at(at.r)?;
        let orbit = at_r.orbit(at.beta * STOPPING)?;
        [orbit.contact().amplitude(), orbit.stuck_fraction()]
    };
    stopping_five "5DOF damped f32, [orbit]" "steady state: amplitude of the contact, stuck fraction" |at| {
        let at_r = stopping::Five::at(at.r)?;
        let orbit = at_r.orbit(at.beta * STOPPING)?;
        [orbit.contact().amplitude(), orbit.stuck_fraction()]
    };
    five_without_search "5DOF damped f32" "limits without search" |at| {
        let limits = Five::limits_without_search(at.r)?;
        [limits.continuous, limits.sliding]
    };
    five_limits "5DOF damped f32" "limits" |at| {
        let at = Five::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    five_contact "5DOF damped f32" "motion of the contact: amplitude, phase" |at| {
        let at_r = Five::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.contact().amplitude(), motion.contact().phase()]
    };
    five_displacement "5DOF damped f32" "motion of a mass: displacement, velocity" |at| {
        let at_r = Five::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.upper().displacement(at.tau), motion.upper().velocity(at.tau)]
    };
    five_amplitude "5DOF damped f32" "motion of a mass: amplitude, phase" |at| {
        let at_r = Five::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.upper().amplitude(), motion.upper().phase()]
    };
    five_stuck "5DOF damped f32" "stuck response" |at| {
        let stuck = Five::at(at.r)?.stuck()?.upper();
        [stuck.re, stuck.im]
    };
    tabled_continuous "2DOF f32, [limits] to 1e-4" "continuous limit" |at| {
        [tabled::limits::Pair::at(at.r)?.continuous_limit(), 0.0]
    };
    tabled_limits "2DOF f32, [limits] to 1e-4" "limits" |at| {
        let at = tabled::limits::Pair::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    tabled_five_continuous "5DOF damped f32, [limits] to 1e-4" "continuous limit" |at| {
        [tabled::limits::Five::at(at.r)?.continuous_limit(), 0.0]
    };
    tabled_five_limits "5DOF damped f32, [limits] to 1e-4" "limits" |at| {
        let at = tabled::limits::Five::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    typical_one "1 damped mass f32, [limits] to 1e-4" "limits" |at| {
        let at = tabled::typical::One::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    typical_two "2 masses on their base f32, [limits] to 1e-4" "limits" |at| {
        let at = tabled::typical::Two::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    typical_five "5 damped masses, two rub f32, [limits] to 1e-4" "limits" |at| {
        let at = tabled::typical::Five::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    typical_ten "10 damped masses f32, [limits] to 1e-4" "limits" |at| {
        let at = tabled::typical::Ten::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    tabled_five_contact "5DOF damped f32 to 1e-4" "motion of the contact: amplitude" |at| {
        [tabled::motion::Five::at(at.r)?.motion(at.beta)?.contact().amplitude(), 0.0]
    };
    tabled_stuck "2DOF f32, [stuck] to 1e-4" "stuck response" |at| {
        let stuck = tabled::stuck::Pair::at(at.r)?.stuck()?.lower();
        [stuck.re, stuck.im]
    };
    tabled_five_stuck "5DOF damped f32, [stuck] to 1e-4" "stuck response" |at| {
        let stuck = tabled::stuck::Five::at(at.r)?.stuck()?.upper();
        [stuck.re, stuck.im]
    };
    watched_samples "none" "128 samples through a watch of 64" |at| {
        let Some(mut watch) = Watch::<f32, 64>::new(3) else {
            return Ok([-1.0, -1.0]);
        };
        for index in 0..128_u8 {
            watch.push(at.beta * f32::from(index % 7) - at.r);
        }
        let found = watch.fundamental().unwrap_or(NOTHING);
        [found.re, found.im]
    };
    watched_friction "2DOF f32" "friction from 64 watched samples of base and mass" |at| {
        let at_r = Pair::at(at.r)?;
        let fundamental = |beta| Ok::<_, Error>(at_r.motion(beta)?.lower().harmonic(1));
        let (Some(mut base), Some(mut mass)) = (Watch::<f32, 64>::new(3), Watch::<f32, 64>::new(3)) else {
            return Ok([-1.0, -1.0]);
        };
        let moves = fundamental(at.beta)?;
        for index in 0..64_u8 {
            // The 64 samples cover three cycles, as samples of a sensor would.
            let (sin, cos) = Scalar::sin_cos_pi(f32::from(index) * (6.0 / 64.0));
            base.push(cos);
            mass.push(moves.re * cos - moves.im * sin);
        }
        let sums = (mass.fundamental().unwrap_or(NOTHING), base.fundamental().unwrap_or(NOTHING));
        let found = transmissibility(sums.0, sums.1).unwrap_or(NOTHING);
        let beta = friction_ratio(found, fundamental(0.0)?, fundamental(0.01)?, 0.01);
        [beta.unwrap_or(-1.0), at_r.continuous_limit_without_search()]
    };
    elastic_sdof "SDOF f32, elastic contact, [orbit]" "steady state: amplitude of the contact, stuck fraction" |at| {
        let at_r = stopping::SdofElastic::at(at.r)?;
        let orbit = at_r.orbit(at.beta * STOPPING)?;
        [orbit.contact().amplitude(), orbit.stuck_fraction()]
    };
    elastic_five "5DOF damped f32, elastic contact, [orbit]" "steady state: amplitude of the contact, stuck fraction" |at| {
        let at_r = stopping::FiveElastic::at(at.r)?;
        let orbit = at_r.orbit(at.beta * STOPPING)?;
        [orbit.contact().amplitude(), orbit.stuck_fraction()]
    };
    elastic_stuck "SDOF f32, elastic contact, [stuck]" "stuck response" |at| {
        let stuck = stopping::SdofElastic::at(at.r)?.stuck()?.mass_1();
        [stuck.re, stuck.im]
    };
    joined_stuck "2DOF damped f32, two contacts" "friction from which no contact slides" |at| {
        let (limit, _) = joined::stuck_from(at.r).unwrap_or((-1.0, ""));
        [limit, 0.0]
    };
    joined_orbit "2DOF damped f32, two contacts" "steady state: amplitude of a mass, energy in a contact" |at| {
        let (amplitude, energy) = joined::settle(at.r, at.beta * STOPPING).unwrap_or((-1.0, -1.0));
        [amplitude, energy]
    };
    single_sdof "SDOF f32, one contact and a dashpot" "steady state: amplitude of the contact, stuck fraction" |at| {
        let orbit = joined::single::Sdof::at(at.r)?.orbit(at.beta * STOPPING)?;
        [orbit.contact().displacement(), orbit.contact().stuck_fraction()]
    };
    single_pair "2DOF f32, one contact and a dashpot" "steady state: amplitude of the contact, stuck fraction" |at| {
        let orbit = joined::single::Pair::at(at.r)?.orbit(at.beta * STOPPING)?;
        [orbit.contact().displacement(), orbit.contact().stuck_fraction()]
    };
    single_five "5DOF damped f32, one contact and a dashpot" "steady state: amplitude of the contact, stuck fraction" |at| {
        let orbit = joined::single::Five::at(at.r)?.orbit(at.beta * STOPPING)?;
        [orbit.contact().displacement(), orbit.contact().stuck_fraction()]
    };
}

calls! { f64 DOUBLE 6:
    double_without_search "2DOF f64" "limits without search" |at| {
        let limits = PairDouble::limits_without_search(at.r)?;
        [limits.continuous, limits.sliding]
    };
    double_limits "2DOF f64" "limits" |at| {
        let at = PairDouble::at(at.r)?;
        [at.continuous_limit(), at.sliding_limit()]
    };
    double_contact "2DOF f64" "motion of the contact: amplitude, phase" |at| {
        let at_r = PairDouble::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.contact().amplitude(), motion.contact().phase()]
    };
    double_displacement "2DOF f64" "motion of a mass: displacement, velocity" |at| {
        let at_r = PairDouble::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.lower().displacement(at.tau), motion.lower().velocity(at.tau)]
    };
    double_amplitude "2DOF f64" "motion of a mass: amplitude, phase" |at| {
        let at_r = PairDouble::at(at.r)?;
        let motion = at_r.motion(at.beta)?;
        [motion.lower().amplitude(), motion.lower().phase()]
    };
    double_stuck "2DOF f64" "stuck response" |at| {
        let stuck = PairDouble::at(at.r)?.stuck()?.lower();
        [stuck.re, stuck.im]
    };
}
