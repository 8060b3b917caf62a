//! Emits the tables of a declared step. They describe each oscillator over the step, in double-double and rounded once.

use super::dynamics::count;
use super::emission::{Emission, rounded};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{
    Channel, HeldLoad, HeldRow, HeldStep, ModeStep, Pace, Row, StepScene, fill,
};
use frictiongen_model::scene::Precision;
use frictiongen_model::stepping::Steps;
use frictiongen_model::transient::Transient;
use proc_macro2::{Literal, TokenStream};

/// Array sizes of a step table.
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
}

/// Emits the tables. Returns `None` for a step that the kernel refuses. `lower` has then reported the error.
pub(super) fn emit(
    emission: &Emission<'_>,
    scene: &StepScene<'_, Dd>,
    step: f64,
    sizes: &Sizes,
) -> Option<TokenStream> {
    match sizes.coefficients {
        1 => table::<1>(emission, scene, step, sizes),
        2 => table::<2>(emission, scene, step, sizes),
        _ => table::<4>(emission, scene, step, sizes),
    }
}

/// Bound on the rounding error of a vanishing double-double sum, as a fraction of its terms. A smaller residue is set
/// to 0, because the input's force does not act on the contact.
const ROUNDING: f64 = 1e-26;

fn table<const D: usize>(
    emission: &Emission<'_>,
    scene: &StepScene<'_, Dd>,
    step: f64,
    sizes: &Sizes,
) -> Option<TokenStream> {
    let (masses, inputs) = (sizes.modes, sizes.inputs);
    let mut modes = vec![ModeStep::<Dd, D>::zero(); masses];
    let mut held = vec![HeldStep::<Dd, D>::zero(); sizes.held];
    let mut loads = vec![Dd::ZERO; masses * inputs];
    let mut held_loads = vec![HeldLoad::zero(); sizes.held * inputs];
    let mut channels = vec![Channel::zero(); inputs];
    // The step is rounded to the scene's scalar first, because the emitted code uses that value.
    let step = Dd::from(rounded(Dd::from(step), emission.precision));
    let pace = fill(
        scene,
        step,
        (&mut modes, &mut held),
        (&mut loads, &mut held_loads, &mut channels),
    )
    .ok()?;
    for (place, channel) in channels.iter_mut().enumerate() {
        let rows = modes.iter().zip(loads.iter().skip(place).step_by(inputs));
        let terms = rows.map(|(mode, load)| (mode.contact * *load / mode.per_force).abs());
        let size = terms.fold(Dd::ZERO, |sum, term| sum + term);
        if channel.residue.abs() <= size * Dd::from(ROUNDING) {
            channel.residue = Dd::ZERO;
        }
    }
    let write = Writer(emission);
    let terms = match emission.precision {
        Precision::F64 => terms::<f64>(emission, step),
        Precision::F32 => terms::<f32>(emission, step),
    }?;
    let pace = write.pace(&pace, terms);
    let modes = modes.iter().map(|mode| write.mode(mode));
    let held = held.iter().map(|mode| write.held(mode));
    // `chunks` panics at size 0. A chain without held modes has no `held_loads`, so the list stays empty.
    let loads = loads.chunks(inputs.max(1)).map(|row| write.list(row));
    let held_loads = held_loads.chunks(inputs.max(1)).map(|row| {
        let row = row.iter().map(|load| write.load(load));
        code!([#(#row),*])
    });
    let channels = channels.iter().map(|channel| write.channel(channel));
    let (scalar, sizes) = (&emission.scalar, sizes.literals());
    Some(code! {
        /// What each oscillator does over a part of `STEP`, time s counted in parts: y′ = Ωu, u′ = −Ω(y + 2ζu) + drive, with
        /// `angle` Ω.  A row has the weights of the state (y, u) and of the drive's coefficients: `moments` give ∫ sʲy′ ds, `turns`
        /// ∫ sʲu′ ds.  The first of `moments`, with [a, a′], and `turn` or the first of `turns`, with [−b, −c], are three shears:
        /// y gains a·u, u gains −b·y − c·u and its drive, y gains a′·u and its drive.
        const STEP_TABLES: FixedTables<#scalar, #sizes> = FixedTables {
            pace: #pace,
            modes: [#(#modes),*],
            held: [#(#held),*],
            loads: [#(#loads),*],
            held_loads: [#(#held_loads),*],
            channels: [#(#channels),*],
        };
    })
}

/// Returns the number of power series terms that the scene's scalar needs.
fn terms<S: Float>(emission: &Emission<'_>, step: Dd) -> Option<u32> {
    let to = |value: Dd| S::constant(rounded(value, emission.precision));
    let Emission { scene, modal, .. } = emission;
    let transient = Transient::<S>::of(scene, modal, to);
    let steps = Steps::of(scene, modal, std::iter::empty(), to);
    let scene = steps.scene(transient.dynamics());
    let pace = frictiongen_model::stepping::pace(&scene, to(step)).ok()?;
    Some(pace.terms)
}

/// Writes double-doubles in the scene's scalar.
struct Writer<'e>(&'e Emission<'e>);

impl Writer<'_> {
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

    fn pace(&self, pace: &Pace<Dd>, terms: u32) -> TokenStream {
        let (step, span, rate) = (
            self.number(pace.step),
            self.number(pace.span),
            self.number(pace.rate),
        );
        let (receptance, drag) = (self.number(pace.receptance), self.number(pace.drag));
        let parts = Literal::u32_unsuffixed(pace.parts);
        let terms = Literal::u32_unsuffixed(terms);
        code! {
            Pace {
                step: #step,
                parts: #parts,
                span: #span,
                rate: #rate,
                terms: #terms,
                receptance: #receptance,
                drag: #drag,
            }
        }
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

    fn mode<const D: usize>(&self, mode: &ModeStep<Dd, D>) -> TokenStream {
        let numbers = [mode.angle, mode.zeta, mode.per_force, mode.contact];
        let [angle, zeta, per_force, contact] = numbers.map(|value| self.number(value));
        let turn = self.row(&mode.turn);
        let moments = mode.moments.iter().map(|row| self.row(row));
        code! {
            ModeStep {
                angle: #angle,
                zeta: #zeta,
                per_force: #per_force,
                contact: #contact,
                turn: #turn,
                moments: [#(#moments),*],
            }
        }
    }

    fn held<const D: usize>(&self, mode: &HeldStep<Dd, D>) -> TokenStream {
        let numbers = [mode.angle, mode.zeta, mode.force];
        let [angle, zeta, force] = numbers.map(|value| self.number(value));
        let from_base = self.pair(&mode.from_base);
        let moments = mode.moments.iter().map(|row| self.held_row(row));
        let turns = mode.turns.iter().map(|row| self.held_row(row));
        code! {
            HeldStep {
                angle: #angle,
                zeta: #zeta,
                force: #force,
                from_base: #from_base,
                moments: [#(#moments),*],
                turns: [#(#turns),*],
            }
        }
    }

    fn load(&self, load: &HeldLoad<Dd>) -> TokenStream {
        let (drive, reach) = (self.list(&load.drive), self.list(&load.reach));
        code!(HeldLoad { drive: #drive, reach: #reach })
    }

    fn channel(&self, channel: &Channel<Dd>) -> TokenStream {
        let (residue, lift) = (self.number(channel.residue), self.number(channel.lift));
        code!(Channel { residue: #residue, lift: #lift })
    }
}
