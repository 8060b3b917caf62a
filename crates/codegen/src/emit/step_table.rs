//! Emits the tables of a declared step. With these tables each oscillator advances over a part of the step. Each number
//! is computed in double-double and rounded once.

use super::checksum;
use super::dynamics::count;
use super::emission::{Emission, rounded, sum_of_rounded};
use super::fields::fields;
use frictiongen_kernel::Float;
use frictiongen_kernel::motion::AnyContact;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{
    Channel, HeldLoad, HeldRow, HeldStep, ModeStep, Pace, Row, StepScene, fill,
};
use frictiongen_model::scene::Precision;
use frictiongen_model::stepping::StepperSettings;
use frictiongen_model::transient::Transient;
use proc_macro2::{Literal, TokenStream};

/// Lengths of the arrays of a stepper's tables.
pub(super) struct Sizes {
    pub coefficients: usize,
    pub modes: usize,
    pub held: usize,
    pub inputs: usize,
}

impl Sizes {
    /// Emits the sizes as arguments of the kernel's types.
    pub fn literals(&self) -> TokenStream {
        let sizes = [self.coefficients, self.modes, self.held, self.inputs];
        let [coefficients, modes, held, inputs] = sizes.map(count);
        code!(#coefficients, #modes, #held, #inputs)
    }

    /// Returns the sentence of the emitted documentation that explains the sizes in the type of the stepper.
    pub fn about(&self) -> String {
        let counted = |number: usize, of: &str| {
            let plural = if number == 1 { "" } else { "s" };
            format!("{number} {of}{plural}")
        };
        format!(
            "The numbers in its type: {} of an input over a part, {}, {} with the contact stuck, {}.",
            counted(self.coefficients, "coefficient"),
            counted(self.modes, "mode"),
            counted(self.held, "mode"),
            counted(self.inputs, "input"),
        )
    }
}

/// Emits the tables, and returns them with their checksum. Returns `None` for a step that the kernel refuses, because
/// `lower` has already reported that error.
pub(super) fn emit(
    emission: &Emission<'_>,
    scene: &StepScene<'_, Dd, AnyContact<Dd>>,
    step: f64,
    sizes: &Sizes,
) -> Option<(TokenStream, u32)> {
    match sizes.coefficients {
        1 => table::<1>(emission, scene, step, sizes),
        2 => table::<2>(emission, scene, step, sizes),
        _ => table::<4>(emission, scene, step, sizes),
    }
}

/// Relative bound at or below which a result of double-double arithmetic counts as 0. A weight counts as 0 if it is
/// below this bound times the largest weight of its row. The acceleration that an input gives the contact counts as 0
/// if it is below this bound times the sum of the moduli of its terms.
const ROUNDING: f64 = 1e-26;

fn table<const D: usize>(
    emission: &Emission<'_>,
    scene: &StepScene<'_, Dd, AnyContact<Dd>>,
    step: f64,
    sizes: &Sizes,
) -> Option<(TokenStream, u32)> {
    let (masses, inputs) = (sizes.modes, sizes.inputs);
    let mut modes = vec![ModeStep::<Dd, D>::zero(); masses];
    let mut held = vec![HeldStep::<Dd, D>::zero(); sizes.held];
    let mut loads = vec![Dd::ZERO; masses * inputs];
    let mut held_loads = vec![HeldLoad::zero(); sizes.held * inputs];
    let mut channels = vec![Channel::zero(); inputs];
    // The step is first rounded to the scene's scalar, because the emitted code uses the rounded value.
    let step = Dd::from(rounded(Dd::from(step), emission.precision));
    let pace = fill(
        scene,
        step,
        (&mut modes, &mut held),
        (&mut loads, &mut held_loads, &mut channels),
    )
    .ok()?;
    for (place, channel) in channels.iter_mut().enumerate() {
        let rows = || modes.iter().zip(loads.iter().skip(place).step_by(inputs));
        let terms = rows().map(|(mode, load)| (mode.contact * *load / mode.per_force).abs());
        let size = terms.fold(Dd::ZERO, |sum, term| sum + term);
        if channel.acceleration.abs() <= size * Dd::from(ROUNDING) {
            channel.acceleration = Dd::ZERO;
        }
        let size = rows().fold(Dd::ZERO, |sum, (mode, load)| {
            sum + (*load / mode.per_force).abs()
        });
        let fastest = modes.iter().map(|mode| mode.per_force.abs());
        let fastest = fastest.fold(Dd::ZERO, |a, b| if a < b { b } else { a });
        for load in held_loads.iter_mut().skip(place).step_by(inputs) {
            zero_noise(&mut load.reach, size);
            zero_noise(&mut load.drive, size * fastest);
        }
    }
    modes.iter_mut().for_each(without_noise_of_mode);
    held.iter_mut().for_each(without_noise_of_held);
    let write = DdWriter(emission);
    let terms = match emission.precision {
        Precision::F64 => terms::<f64>(emission, step),
        Precision::F32 => terms::<f32>(emission, step),
    }?;
    let pace = Pace { terms, ..pace };
    let of_oscillators = (&pace, (modes.as_slice(), held.as_slice()));
    let of_inputs = (
        loads.as_slice(),
        (held_loads.as_slice(), channels.as_slice()),
    );
    let sum = sum_of_rounded(&(of_oscillators, of_inputs), emission.precision);
    let pace = write.pace(&pace);
    let modes = modes.iter().enumerate();
    let modes = modes.map(|(index, mode)| write.mode(mode, index == 0));
    let held = held.iter().enumerate();
    let held = held.map(|(index, mode)| write.held(mode, index == 0));
    // The size must not be 0, because `chunks` would panic. A chain without held modes has no `held_loads`, so the list
    // is empty in any case.
    let loads = loads.chunks(inputs.max(1)).map(|row| write.list(row));
    let mut first = true;
    let held_loads = held_loads.chunks(inputs.max(1)).map(|row| {
        let row = row.iter().map(|load| {
            let first = std::mem::replace(&mut first, false);
            write.load(load, first)
        });
        let row: Vec<TokenStream> = row.collect();
        code!([#(#row),*])
    });
    let channels = channels.iter().enumerate();
    let channels = channels.map(|(index, channel)| write.channel(channel, index == 0));
    let (scalar, sizes) = (&emission.scalar, sizes.literals());
    let numbers = fields(
        true,
        &[
            ("pace", pace, "how the step is divided into parts"),
            ("modes", code!([#(#modes),*]), "the modes of the chain"),
            (
                "held",
                code!([#(#held),*]),
                "the modes of the chain with its contact stuck",
            ),
            (
                "loads",
                code!([#(#loads),*]),
                "rate of u of each mode divided by the input, for each input",
            ),
            (
                "held_loads",
                code!([#(#held_loads),*]),
                "the same for each mode of the chain with its contact stuck",
            ),
            (
                "channels",
                code!([#(#channels),*]),
                "coupling of each input to the contact",
            ),
        ],
    );
    let checksum = checksum::about(&numbers);
    let tables = code! {
        /// Advance of each oscillator over a part of `STEP`, with the time s from 0 to 1: y′ = Ωu, u′ = −Ω(y + 2ζu) + drive.
        /// σ = √λ is the frequency ratio of the mode's resonance.  The drive is a polynomial in s.
        ///
        /// A `Row` has the weights of y and u (`state`) and of the coefficients of the drive (`drive`).  y and u are those at the
        /// start of the part, except in a shear, where they are the present ones.
        /// In a `HeldRow` the first list of `drive` belongs to a drive of y, the second to a drive of u.
        /// Three shears advance y and u: y gains a·u, then u gains −b·y − c·u and a drive, then y gains a′·u and a drive.  `turn`
        /// or the first of `turns` has the state weights [−b, −c], the first of `moments` has [a, a′].
        ///
        /// These numbers are 0: the first weight for a drive of u in the first of `moments`, because a constant drive moves y only
        /// through u; `from_base` of a contact that does not rub on the moving base; and `held_loads` of an input that acts on a
        /// mass that a stuck contact holds at a support.
        ///
        /// Computed in double-double and rounded once: each number is exact to half a unit of its last place.  Numbers below
        /// 1e-26 of their largest terms are 0.
        #[doc = #checksum]
        const STEP_TABLES: FixedTables<#scalar, #sizes> = FixedTables { #numbers };
    };
    Some((tables, sum))
}

fn without_noise_of_mode<const D: usize>(mode: &mut ModeStep<Dd, D>) {
    for row in mode.moments.iter_mut().chain([&mut mode.turn]) {
        without_noise(row.state.iter_mut().chain(&mut row.drive));
    }
}

fn without_noise_of_held<const D: usize>(mode: &mut HeldStep<Dd, D>) {
    for row in mode.moments.iter_mut().chain(&mut mode.turns) {
        without_noise(row.state.iter_mut().chain(row.drive.as_flattened_mut()));
    }
}

/// Sets weights of a row to 0 if they consist only of rounding errors. Otherwise every change of the scene would change
/// these errors in the emitted tables.
fn without_noise<'w>(row: impl Iterator<Item = &'w mut Dd>) {
    let row: Vec<&mut Dd> = row.collect();
    let largest = row.iter().map(|weight| weight.abs());
    let largest = largest.fold(Dd::ZERO, |a, b| if a < b { b } else { a });
    for weight in row {
        if weight.abs() <= largest * Dd::from(ROUNDING) {
            *weight = Dd::ZERO;
        }
    }
}

/// Sets numbers to 0 if they consist only of rounding errors of terms of the given size.
fn zero_noise(numbers: &mut [Dd], size: Dd) {
    for number in numbers {
        if number.abs() <= size * Dd::from(ROUNDING) {
            *number = Dd::ZERO;
        }
    }
}

/// Returns the number of power series terms that the stepper needs in the scene's scalar type.
fn terms<S: Float>(emission: &Emission<'_>, step: Dd) -> Option<u32> {
    let to = |value: Dd| S::constant(rounded(value, emission.precision));
    let Emission { scene, modal, .. } = emission;
    let transient = Transient::<S>::of(scene, modal, to);
    let steps = StepperSettings::of(scene, modal, std::iter::empty(), to);
    let scene = steps.scene(transient.contact_dynamics());
    let pace = frictiongen_model::stepping::pace(&scene, to(step)).ok()?;
    Some(pace.terms)
}

/// Writes double-double numbers in the scene's scalar type.
struct DdWriter<'e>(&'e Emission<'e>);

impl DdWriter<'_> {
    fn number(&self, value: Dd) -> TokenStream {
        self.0.literal(rounded(value, self.0.precision))
    }

    fn list(&self, values: &[Dd]) -> TokenStream {
        let values = values.iter().map(|value| self.number(*value));
        code!([#(#values),*])
    }

    fn pair(&self, values: &[[Dd; 2]; 2]) -> TokenStream {
        let values = values.iter().map(|values| self.list(values));
        code!([#(#values),*])
    }

    fn pace(&self, pace: &Pace<Dd>) -> TokenStream {
        let (step, span, rate) = (
            self.number(pace.step),
            self.number(pace.span),
            self.number(pace.rate),
        );
        let (receptance, drag) = (self.number(pace.receptance), self.number(pace.drag));
        let parts = Literal::u32_unsuffixed(pace.parts);
        let terms = Literal::u32_unsuffixed(pace.terms);
        let fields = fields(
            true,
            &[
                ("step", step, "the step, s"),
                ("parts", code!(#parts), "number of parts of the step"),
                ("span", span, "length of a part in the time t√(k₁/m₁)"),
                (
                    "rate",
                    rate,
                    "largest angle of an oscillator in a part, with its damping, rad",
                ),
                (
                    "terms",
                    code!(#terms),
                    "terms of a power series over a part",
                ),
                (
                    "receptance",
                    receptance,
                    "wᵀ(K/k₁)⁻¹w, displacement of the contact per unit of steady force",
                ),
                (
                    "drag",
                    drag,
                    "damping force per unit of velocity of the contact, (Σ 2ζ(φᵀw)²/σ)/receptance",
                ),
            ],
        );
        code!(Pace { #fields })
    }

    fn row<const D: usize>(&self, row: &Row<Dd, D>) -> TokenStream {
        let (state, drive) = (self.list(&row.state), self.list(&row.drive));
        code!(Row { state: #state, drive: #drive })
    }

    fn held_row<const D: usize>(&self, row: &HeldRow<Dd, D>) -> TokenStream {
        let state = self.list(&row.state);
        let drive = row.drive.iter().map(|drive| self.list(drive));
        code!(HeldRow { state: #state, drive: [#(#drive),*] })
    }

    fn mode<const D: usize>(&self, mode: &ModeStep<Dd, D>, first: bool) -> TokenStream {
        let numbers = [mode.angle, mode.zeta, mode.per_force, mode.contact];
        let [angle, zeta, per_force, contact] = numbers.map(|value| self.number(value));
        let turn = self.row(&mode.turn);
        let moments = mode.moments.iter().map(|row| self.row(row));
        let fields = fields(
            first,
            &[
                (
                    "angle",
                    angle,
                    "Ω, angle of the undamped mode in a part, rad",
                ),
                ("zeta", zeta, "ζ, the modal damping ratio"),
                (
                    "per_force",
                    per_force,
                    "Ω/σ², rate of u per unit of modal force",
                ),
                (
                    "contact",
                    contact,
                    "φᵀw, displacement of the contact per unit of the mode",
                ),
                ("turn", turn, "shear of u"),
                (
                    "moments",
                    code!([#(#moments),*]),
                    "the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds",
                ),
            ],
        );
        code!(ModeStep { #fields })
    }

    fn held<const D: usize>(&self, mode: &HeldStep<Dd, D>, first: bool) -> TokenStream {
        let numbers = [mode.angle, mode.zeta, mode.force];
        let [angle, zeta, force] = numbers.map(|value| self.number(value));
        let from_base = self.pair(&mode.from_base);
        let moments = mode.moments.iter().map(|row| self.held_row(row));
        let turns = mode.turns.iter().map(|row| self.held_row(row));
        let fields = fields(
            first,
            &[
                (
                    "angle",
                    angle,
                    "Ω, angle of the oscillator in a part, rad: |s| of its root s, times `span`",
                ),
                ("zeta", zeta, "ζ = −Re s/|s|"),
                (
                    "force",
                    force,
                    "force of the chain on the contact, with its damping force, at y = −1",
                ),
                (
                    "from_base",
                    from_base,
                    "rates of y and u per unit velocity and acceleration of a base to which the contact sticks",
                ),
                (
                    "moments",
                    code!([#(#moments),*]),
                    "the first row: both shears of y; row j > 0: weights of ∫ sʲy′ ds",
                ),
                (
                    "turns",
                    code!([#(#turns),*]),
                    "the first row: shear of u; row j > 0: weights of ∫ sʲu′ ds",
                ),
            ],
        );
        code!(HeldStep { #fields })
    }

    fn load(&self, load: &HeldLoad<Dd>, first: bool) -> TokenStream {
        let (drive, reach) = (self.list(&load.drive), self.list(&load.reach));
        let fields = fields(
            first,
            &[
                ("drive", drive, "rates of y and u per unit of the input"),
                (
                    "reach",
                    reach,
                    "displacement where the input acts per unit of y and of u",
                ),
            ],
        );
        code!(HeldLoad { #fields })
    }

    fn channel(&self, channel: &Channel<Dd>, first: bool) -> TokenStream {
        let (acceleration, lift) = (self.number(channel.acceleration), self.number(channel.lift));
        let fields = fields(
            first,
            &[
                (
                    "acceleration",
                    acceleration,
                    "wᵀΓ⁻¹p, acceleration of the contact per unit of the input",
                ),
                (
                    "lift",
                    lift,
                    "displacement where the input acts per unit of displacement of the stuck contact",
                ),
            ],
        );
        code!(Channel { #fields })
    }
}
