//! Emits the self-check: checksums of all constants, and known answers with the code that compares answers with them.

use super::checksum;
use super::emission::{Checked, Emission, EmittedCode, Wanted, rounded};
use super::fields::fields;
use crate::known::{AnswersRequest, KnownAnswers, MotionKind, POINTS, TAU, known};
use crate::units::domain;
use frictiongen_kernel::emitted::check;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::scene::Precision;
use proc_macro2::{Literal, TokenStream};

/// Allowed error of an answer of the exact formulas, in rounding units (machine epsilon of the scene's scalar type).
/// At the frequency ratios of the known answers, a change of r by 32 rounding units changes an answer by at most an
/// eighth of this error.
const ROUNDINGS: f64 = 4096.0;
/// Largest allowed error of an answer, in rounding units. The self-check allows more than `ROUNDINGS` only if some
/// part of the scene's range of r has no tried frequency ratio at which all answers are independent of rounding.
const WIDEST: f64 = 16.0 * ROUNDINGS;
/// Range of the frequency ratios of the known answers, as two factors. The range runs from the first factor times the
/// lowest resonance to the second factor times the highest resonance.
const BAND: (f64, f64) = (0.2, 1.5);

/// Emits the function `self_check` and its known answers. `constants` lists all other emitted constants, whose
/// checksums `self_check` compares.
pub(super) fn emit(
    emission: &Emission<'_>,
    wanted: &Wanted<'_>,
    constants: &[&Checked],
) -> EmittedCode {
    let scalar = &emission.scalar;
    let at_frequency = emission.scene.needs_frequency();
    let (allowed, all) = if at_frequency {
        answers(emission, wanted)
    } else {
        (Allowed::default(), Vec::new())
    };
    let (tables, own) = known_answers(emission, wanted, &all);
    let tolerance = (!all.is_empty()).then(|| {
        let tolerance = rounded(Dd::from(allowed.error()), emission.precision);
        Checked::new("TOLERANCE", code!(&Self::TOLERANCE), &tolerance)
    });
    let sums = constants.iter().copied().chain(&own).chain(&tolerance);
    let sums: TokenStream = sums
        .map(|Checked { name, numbers, sum }| {
            let sum = hexadecimal(*sum);
            code!(check::compare::<#scalar>(#name, #numbers, #sum)?;)
        })
        .collect();
    let compared = (!all.is_empty()).then(|| compared(emission, wanted, &allowed));
    let calls = compared.is_some().then(
        || code!(::core::hint::black_box(&Self::KNOWN).iter().try_for_each(Self::check_answers)?;),
    );
    let about = about(&all, wanted);
    let work = work(wanted, all.len());
    let associated = code! {
        #(#[doc = #about])*
        ///
        #[doc = #work]
        ///
        /// # Errors
        /// The first constant or method that is wrong.
        pub fn self_check() -> Result<(), check::Fault> {
            #sums
            #calls
            Ok(())
        }

        #compared
    };
    EmittedCode {
        associated,
        tables,
        ..EmittedCode::default()
    }
}

fn hexadecimal(sum: u32) -> TokenStream {
    let text = format!("0x{:04x}_{:04x}", sum >> 16, sum & 0xffff);
    text.parse().unwrap_or_default()
}

/// The error that the self-check allows for an answer of the emitted code.
#[derive(Clone, Copy, Debug, Default)]
struct Allowed {
    /// Allowed error of the tables. It is 0 for a scene without tables.
    accuracy: f64,
    /// Allowed error in addition to `accuracy`, in rounding units.
    roundings: f64,
    /// The rounding unit of the scene's scalar type.
    epsilon: f64,
}

impl Allowed {
    fn error(&self) -> f64 {
        self.accuracy + self.roundings * self.epsilon
    }
}

/// Returns the error that the self-check allows, and the known answers with which the emitted code compares its
/// answers.
fn answers(emission: &Emission<'_>, wanted: &Wanted<'_>) -> (Allowed, Vec<KnownAnswers>) {
    use crate::lower::SceneTables;
    let scene = emission.scene;
    let (epsilon, largest) = match emission.precision {
        Precision::F64 => (f64::EPSILON, f64::MAX),
        Precision::F32 => (f64::from(f32::EPSILON), f64::from(f32::MAX)),
    };
    let tables = emission.description.tables.as_ref();
    let (accuracy, [r, beta]) = match tables {
        Some(SceneTables::Double(tables)) => (tables.request.accuracy, domain(scene, tables)),
        Some(SceneTables::Single(tables)) => (tables.request.accuracy, domain(scene, tables)),
        None => {
            let resonances = emission.modal.resonances.iter();
            let resonances: Vec<f64> = resonances.map(|own| own.hi).collect();
            let lowest = resonances.iter().copied().fold(f64::INFINITY, f64::min);
            let highest = resonances.iter().copied().fold(0.0, f64::max);
            (0.0, [(BAND.0 * lowest, BAND.1 * highest), (0.0, largest)])
        }
    };
    let mut allowed = Allowed {
        accuracy,
        roundings: ROUNDINGS,
        epsilon,
    };
    let question = AnswersRequest {
        precision: emission.precision,
        r,
        beta,
        tolerance: allowed.error(),
        widest: accuracy + WIDEST * epsilon,
        motion: wanted.motion.is_some(),
        stuck: wanted.stuck,
    };
    let all = known(&emission.modal, &question);
    let needed = all.iter().map(KnownAnswers::needs).fold(0.0, f64::max);
    while allowed.error() < needed {
        allowed.roundings *= 2.0;
    }
    (allowed, all)
}

/// Emits the known answers as a constant, with its checksum.
fn known_answers(
    emission: &Emission<'_>,
    wanted: &Wanted<'_>,
    all: &[KnownAnswers],
) -> (TokenStream, Option<Checked>) {
    if all.is_empty() {
        return (TokenStream::new(), None);
    }
    let scalar = &emission.scalar;
    let rows = all.iter().enumerate();
    let rows: Vec<TokenStream> = rows
        .map(|(place, known)| row(emission, wanted, known, place == 0))
        .collect();
    let list = code!([#(#rows),*]);
    let checksum = checksum::about(&list);
    let [masses, forces] = sizes(emission, wanted);
    let count = Literal::usize_unsuffixed(all.len());
    let tables = code! {
        /// Answers of the exact formulas, computed in arithmetic of 32 digits, which `self_check` compares with its own.
        ///
        #[doc = #checksum]
        const KNOWN: [check::Known<#scalar, #masses, #forces>; #count] = #list;
    };
    let mut sum = 0;
    for known in all {
        for number in numbers(emission, wanted, known) {
            sum = check::with(sum, number);
        }
    }
    let numbers = code!(&Self::KNOWN);
    let checked = Checked::of_sum("KNOWN", numbers, sum);
    (tables, Some(checked))
}

/// Returns the number of masses whose motion is in a known answer, and the number of stuck responses in it.
fn sizes(emission: &Emission<'_>, wanted: &Wanted<'_>) -> [Literal; 2] {
    let masses = wanted.motion.as_ref().map_or(0, Vec::len);
    let forces = if wanted.stuck {
        emission.scene.masses.len() + 1
    } else {
        0
    };
    [masses, forces].map(Literal::usize_unsuffixed)
}

/// Returns the known displacement and velocity of each mass whose motion the scene provides.
fn moving(wanted: &Wanted<'_>, known: &KnownAnswers) -> Vec<[f64; 2]> {
    let motion = known.motion.iter().flat_map(|motion| &motion.masses);
    let all: Vec<[f64; 2]> = motion.copied().collect();
    let masses = wanted.motion.iter().flatten();
    masses
        .filter_map(|(mass, _)| all.get(*mass).copied())
        .collect()
}

/// Returns the numbers of a known answer as values of the scene's scalar type, in the order in which the kernel lists
/// them.
fn numbers(emission: &Emission<'_>, wanted: &Wanted<'_>, known: &KnownAnswers) -> Vec<f64> {
    let mut numbers = vec![known.r, known.continuous, known.sliding];
    if let Some(motion) = &known.motion {
        numbers.push(motion.beta);
        numbers.extend(motion.contact);
        numbers.extend(moving(wanted, known).as_flattened());
    }
    numbers.extend(known.stuck.as_flattened());
    let round = |value: f64| super::emission::rounded(Dd::from(value), emission.precision);
    numbers.into_iter().map(round).collect()
}

fn row(
    emission: &Emission<'_>,
    wanted: &Wanted<'_>,
    known: &KnownAnswers,
    first: bool,
) -> TokenStream {
    let facade = emission.facade;
    let pairs = |pairs: &[[f64; 2]]| {
        let pairs = pairs.iter().map(|pair| emission.list(*pair));
        code!([#(#pairs),*])
    };
    let motion = known.motion.as_ref().map(|motion| {
        let error = code!(#facade::NotContinuous);
        let error = match motion.outcome {
            MotionKind::Continuous => code!(None),
            MotionKind::StickSlip => code!(Some(#error::StickSlip)),
            MotionKind::Stuck => code!(Some(#error::Stuck)),
        };
        let fields = fields(
            first,
            &[
                ("beta", emission.literal(motion.beta), "friction ratio β"),
                ("error", error, "why there is no continuous motion"),
                (
                    "contact",
                    emission.list(motion.contact),
                    "amplitude and phase of the contact, 0 without continuous motion",
                ),
                (
                    "masses",
                    pairs(&moving(wanted, known)),
                    "displacement and velocity of each mass at τ = 1, a radian after a maximum of the contact's motion",
                ),
            ],
        );
        code!(Some(check::KnownMotion { #fields }))
    });
    let motion = motion.unwrap_or_else(|| code!(None));
    let fields = fields(
        first,
        &[
            ("r", emission.literal(known.r), "frequency ratio r"),
            (
                "limits",
                emission.list([known.continuous, known.sliding]),
                "β_lim and β*_lim",
            ),
            ("motion", motion, "the motion at one friction ratio"),
            (
                "stuck",
                pairs(&known.stuck),
                "real and imaginary part of each mass and of the contact's force while the contact is stuck",
            ),
        ],
    );
    code!(check::Known { #fields })
}

/// Emits the allowed error, and the function that compares the answers at one frequency ratio with the known answers.
fn compared(emission: &Emission<'_>, wanted: &Wanted<'_>, allowed: &Allowed) -> TokenStream {
    let scalar = &emission.scalar;
    let names = &emission.description.mass_names;
    let tau = emission.literal(TAU);
    let motion = wanted.motion.as_ref().map(|masses| {
        let masses = masses.iter().enumerate().map(|(place, (_, name))| {
            let place = Literal::usize_unsuffixed(place);
            let text = name.to_string();
            code! {
                let mass = motion.#name();
                let own = [mass.displacement(#tau), mass.velocity(#tau)];
                known.mass(#place, #text, own, Self::TOLERANCE)?;
            }
        });
        code! {
            if let Some(known) = &known.motion {
                let motion = known.found(at.motion(known.beta))?;
                if let Some(motion) = motion {
                    let largest = motion.contact().largest();
                    known.contact([largest.amplitude, largest.phase], Self::TOLERANCE)?;
                    #(#masses)*
                }
            }
        }
    });
    let stuck = wanted.stuck.then(|| {
        let masses = names.iter().enumerate().map(|(place, name)| {
            let place = Literal::usize_unsuffixed(place);
            let text = name.to_string();
            code!(known.stuck(#place, #text, stuck.#name(), Self::TOLERANCE)?;)
        });
        let force = Literal::usize_unsuffixed(names.len());
        code! {
            let stuck = at.stuck().or(Err(check::Fault::Answer("stuck")))?;
            #(#masses)*
            known.stuck(#force, "contact_force", stuck.contact_force(), Self::TOLERANCE)?;
        }
    });
    let [masses, forces] = sizes(emission, wanted);
    let accuracy = if emission.is_tabled() {
        "the declared accuracy, and "
    } else {
        ""
    };
    let about = format!(
        " Largest error of an answer: {accuracy}{} roundings (`EPSILON`) of the arithmetic, of r and of β.  It serves all answers, also those of higher accuracy.",
        allowed.roundings
    );
    let tolerance = emission.literal(allowed.error());
    code! {
        #[doc = #about]
        const TOLERANCE: #scalar = #tolerance;

        /// Compares the answers at one frequency ratio with known ones.
        fn check_answers(
            known: &check::Known<#scalar, #masses, #forces>,
        ) -> Result<(), check::Fault> {
            let at = Self::at(known.r).or(Err(check::Fault::Answer("at")))?;
            known.limits(at.limits(), Self::TOLERANCE)?;
            #motion
            #stuck
            Ok(())
        }
    }
}

fn about(all: &[KnownAnswers], wanted: &Wanted<'_>) -> Vec<String> {
    let mut about = vec![
        " Compares the checksums of the constants with those that the generator wrote, for example at power-up.  These checksums are of the bits; CRC-32 in comments is of the text.".to_owned(),
    ];
    if all.is_empty() {
        about.push(" It does not run the motion in time.".to_owned());
        return about;
    }
    let mut kinds = vec!["limits"];
    if wanted.motion.is_some() {
        kinds.push("motion");
    }
    if wanted.stuck {
        kinds.push("stuck response");
    }
    let fewer = if all.len() < POINTS {
        "  At other frequency ratios an answer depends on roundings of r."
    } else {
        ""
    };
    about.push(format!(
        " Then it compares answers ({}) at {} frequency ratios with those of arithmetic of 32 digits, a motion only where it is continuous.{fewer}",
        kinds.join(", "),
        all.len()
    ));
    if wanted.orbit || wanted.simulation || wanted.stepper {
        about.push(" It does not run steady states with stops, nor the motion in time.".to_owned());
    }
    about
}

/// Returns the documentation line with the worst-case work of the self-check.
fn work(wanted: &Wanted<'_>, answers: usize) -> String {
    let mut work =
        " Worst case: four integer operations for each half of a constant's number".to_owned();
    if answers > 0 {
        work += &format!(", and {answers} times one call each of `at` and `limits`");
        if let Some(masses) = &wanted.motion {
            work += &format!(
                ", `motion`, `largest` of the contact, displacement and velocity of {} mass{}",
                masses.len(),
                if masses.len() == 1 { "" } else { "es" }
            );
        }
        if wanted.stuck {
            work += ", and `stuck` with each mass and `contact_force`";
        }
    }
    work + ".  It needs no memory but the stack."
}
