//! Warnings about descriptions that are valid, but probably differ from the author's intention.

use frictiongen_model::modal::Modal;
use frictiongen_model::scene::Damping;
use frictiongen_model::stribeck::SmoothLaw;
use frictiongen_model::validate::{MOST_MASSES, Path};

use crate::diagnostics::{Diagnostics, Problems};
use crate::lower::Located;
use crate::parse::number::hundredth;
use crate::parse_text;

/// Returns the warnings about a valid description, or `None` if there are none.
///
/// A warning marks a mode whose damping is critical or above. A damping ratio of 1 or more is probably a percentage.
///
/// ```
/// let text = "struct Block {
///     masses: { block: 1 },
///     springs: { base - block: 1 },
///     contact: block - wall,
///     excitation: block,
///     damping: modal(2),
/// }";
/// let warnings = frictiongen_syntax::warnings(text).map(|all| all.to_string());
/// assert!(warnings.is_some_and(|all| all.starts_with("6:20: ") && all.contains("`0.02`")));
/// assert!(frictiongen_syntax::warnings(&text.replace("(2)", "(0.02)")).is_none());
/// ```
#[must_use]
pub fn warnings(text: &str) -> Option<Diagnostics> {
    let mut problems = Problems::default();
    let syntax = parse_text(text, &mut problems)?;
    let located = syntax.lower(MOST_MASSES, false, &mut problems)?;
    if !problems.is_empty() {
        return None;
    }
    let mut warnings = Problems::default();
    overdamped(&located, &mut warnings);
    (!warnings.is_empty()).then(|| warnings.into_diagnostics())
}

/// Returns the smooth friction law of a description with its straight lines, or `None` if the description has no such law
/// or an error.
///
/// ```
/// let text = "struct Block {
///     masses: { block: 1 }, springs: { base - block: 1 },
///     contact: block - wall, excitation: block, stribeck: exp(1.3, 0.05),
/// }";
/// let law = frictiongen_syntax::smooth_law(text).ok_or("no law")?;
/// assert_eq!(law.points.len(), 12);
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn smooth_law(text: &str) -> Option<SmoothLaw> {
    let mut problems = Problems::default();
    let syntax = parse_text(text, &mut problems)?;
    syntax.lower(MOST_MASSES, false, &mut problems)?.law
}

/// Reports every mode whose damping ratio is 1 or more.
fn overdamped(located: &Located<'_>, warnings: &mut Problems) {
    let mut report = |index: Option<usize>, message: String| {
        warnings.report(located.place(Path::Damping(index)), message);
    };
    let meant = |ratio: f64| {
        format!(
            "a damping ratio of {ratio} is at or beyond critical damping; write `{}` if you mean {ratio} %",
            hundredth(ratio)
        )
    };
    match &located.scene.damping {
        Damping::None => {}
        Damping::Uniform(ratio) if 1.0 <= *ratio => report(Some(0), meant(*ratio)),
        Damping::Uniform(_) => {}
        Damping::Modal(ratios) => {
            for (index, ratio) in ratios.iter().enumerate() {
                if 1.0 <= *ratio {
                    report(Some(index), meant(*ratio));
                }
            }
        }
        // A scene with several contacts may have a mass that no spring holds. With Rayleigh damping this mass has a
        // natural frequency of 0 and no damping ratio.
        Damping::Rayleigh { .. } if located.scene.is_joined() => {}
        Damping::Rayleigh { .. } => {
            let ratios = Modal::of(&located.scene).damping_ratios;
            let first = ratios.iter().position(|ratio| 1.0 <= ratio.hi);
            if let Some((mode, ratio)) =
                first.and_then(|mode| Some((mode + 1, ratios.get(mode)?.hi)))
            {
                report(
                    None,
                    format!(
                        "mode {mode} has a damping ratio of {ratio:.3}, at or beyond critical damping; check the units of C = aM + bK: a is in rad/s and b in s"
                    ),
                );
            }
        }
    }
}
