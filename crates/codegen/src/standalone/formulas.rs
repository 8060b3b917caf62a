//! Collects all formulas of a file, with the constants in them.

use super::constants::{ConstantForm, FileConstants};
use super::products::quotient;
use super::stuck::StuckExpressions;
use super::{Language, NumberFormat, Source};
use frictiongen_kernel::Float;

/// The formulas of a file in one language.
pub(super) struct Formulas {
    pub numbers: NumberFormat,
    /// The constants that the formulas name.
    pub constants: FileConstants,
    /// The expression for β*_lim, the limit of sliding.
    pub sliding: String,
    /// Expression for |V|, or for V of an undamped chain. `None` if V is not a product.
    pub excitation: Option<String>,
    /// The responses while the contact is stuck.
    pub stuck: Option<StuckExpressions>,
    /// Expressions for the start of the first bucket, and for the number of buckets per unit of r. Buckets are equal
    /// intervals of r, by which the code finds a piece of the tables.
    pub index: [String; 2],
    /// Expressions for the undamped resonances that the load drives.
    pub unbounded: Vec<String>,
}

impl Formulas {
    /// Returns the formulas. Returns `None` if β*_lim is not stored as a product.
    pub fn of<S: Float>(source: &Source<'_, S>, language: Language) -> Option<Self> {
        let Source { scene, tables, .. } = source;
        let numbers = NumberFormat::of::<S>(language);
        let root = match language {
            Language::C => format!("sqrt{}", numbers.letter()),
            Language::Rust => format!("{}::sqrt", numbers.real),
        };
        let absolute = match language {
            Language::C => format!("fabs{}", numbers.letter()),
            Language::Rust => format!("{}::abs", numbers.real),
        };
        let mut constants = FileConstants::new(numbers);
        let of = tables.sliding.as_ref()?;
        let sliding = if of.numerator.is_empty() && of.denominator.is_empty() {
            // If β*_lim is constant, it is the modulus of the gain.
            let limit = [of.gain.to_f64().abs()];
            constants.add(
                "SLIDING_LIMIT",
                ConstantForm::Number,
                &limit,
                "beta*_lim, which does not depend on r",
            )
        } else {
            let sliding = quotient(&mut constants, "SLIDING", of, &root);
            format!("{absolute}({sliding})")
        };
        let excitation = tables.excitation.as_ref();
        let excitation = excitation.map(|of| quotient(&mut constants, "EXCITATION", of, &root));
        let held = tables.held.as_ref();
        let stuck = held.map(|held| StuckExpressions::of(&mut constants, scene, held));
        let index = [
            (
                "INDEX_LOW",
                tables.index.low,
                "smallest r of the first bucket",
            ),
            (
                "INDEX_DENSITY",
                tables.index.density,
                "number of buckets per unit of r",
            ),
        ];
        let index = index.map(|(name, value, about)| {
            constants.add(name, ConstantForm::Number, &[value.to_f64()], about)
        });
        let unbounded = if tables.moves() {
            tables.unbounded.as_slice()
        } else {
            &[]
        };
        let unbounded = unbounded.iter().enumerate().map(|(place, own)| {
            let name = format!("RESONANCE_{}", place + 1);
            let about = "r of an undamped resonance that the load drives";
            constants.add(name, ConstantForm::Number, &[own.to_f64()], about)
        });
        let unbounded = unbounded.collect();
        Some(Self {
            numbers,
            constants,
            sliding,
            excitation,
            stuck,
            index,
            unbounded,
        })
    }

    /// Returns true if a formula calls this operation.
    pub fn calls(&self, operation: &str) -> bool {
        let call = format!("{operation}(");
        let stuck = self.stuck.iter().flat_map(StuckExpressions::texts);
        let excitation = self.excitation.as_deref().into_iter();
        let mut texts = stuck.chain(excitation).chain([self.sliding.as_str()]);
        texts.any(|text| text.contains(&call))
    }

    /// Returns true if the file compares r with a resonance.
    pub fn compares(&self) -> bool {
        let stuck = self.stuck.as_ref();
        !self.unbounded.is_empty() || stuck.is_some_and(|stuck| !stuck.resonances.is_empty())
    }

    /// Returns the condition that r equals a resonance of the list. Returns `None` if the list is empty.
    pub fn on(resonances: &[String]) -> Option<String> {
        let on = resonances.iter().map(|own| format!("is_at(r, {own})"));
        let on: Vec<String> = on.collect();
        (!on.is_empty()).then(|| on.join(" || "))
    }
}
