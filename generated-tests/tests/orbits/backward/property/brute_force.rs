//! Searches for maxima of a motion by its values at many instants of the half period.

use super::BAR;
use crate::backward::asked::{Asked, Of, Place, motion};
use crate::backward::judge::{Answer, Judge};
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;

/// Largest ratio of a natural frequency to the excitation frequency at which the brute-force search is short enough.
pub(super) const FASTEST: f64 = 60.0;

/// Searches for values larger than the returned maxima, at many instants of the half period. Judges the answers by
/// the values that it finds.
///
/// The search runs in double precision first, and then on a finer grid in double-double. If the library's method has
/// also searched for the maximum in double-double, that maximum must be the largest value.
pub(super) fn by_force<S: Float>(
    judge: &Judge<'_>,
    told: &mut [Answer],
    fastest: f64,
    place: &Place<S>,
) {
    let instants = 64 + (12.0 * fastest) as u32;
    let largest = |rough: &dyn Fn(f64) -> f64, of: &dyn Fn(Dd) -> Dd| {
        let step = std::f64::consts::PI / f64::from(instants);
        let instant = |i: u32| step * (f64::from(i) - 0.5);
        let all = (1..=instants).map(|i| (rough(instant(i)), instant(i)));
        let higher = |best: (f64, f64), one: (f64, f64)| if best.0 < one.0 { one } else { best };
        let mut about = Dd::from(all.fold((0.0, 0.0), higher).1);
        let mut value = of(about);
        // The search then approaches the maximum, with steps that are halved each time.
        let mut width = Dd::from(step);
        for _ in 0..24 {
            width = width * Dd::from(0.5);
            for tau in [about - width, about + width] {
                if Dd::from(0.0) < tau && tau < Dd::PI {
                    let there = of(tau);
                    if value < there {
                        (value, about) = (there, tau);
                    }
                }
            }
        }
        (value, about)
    };
    let plain = judge.data().read(|value| value.to_f64());
    let rough = plain.at(judge.place().r.to_f64());
    let beta = judge.place().beta.to_f64();
    let of_mass = |mass: usize| {
        let (exact, rough) = (
            motion(judge.at(), Of::Mass(mass), judge.place().beta),
            motion(&rough, Of::Mass(mass), beta),
        );
        let found = largest(&|tau| rough.displacement(tau).abs(), &|tau| {
            exact.displacement(tau).abs()
        });
        (exact, found)
    };
    let room = Dd::from(BAR * S::EPSILON);
    for answer in told {
        let asked = answer.watched.asked;
        let (known, size, (found, tau)) = match asked {
            Asked::ContinuousLimit => {
                let inverse = Dd::from(1.0) / judge.exact(&[answer.watched])[0].re;
                let by = |tau| Dd::from(1.0) / judge.at().continuous_limit_by(tau);
                let roughly = |tau| 1.0 / rough.continuous_limit_by(tau);
                (inverse, inverse, largest(&roughly, &by))
            }
            Asked::Amplitude(Of::Mass(mass)) => {
                let known = judge.exact(&[answer.watched])[0].re;
                (known, answer.size, of_mass(mass).1)
            }
            Asked::Height(mass) => {
                let (motion, found) = of_mass(mass);
                let instant = answer.watched.instant.unwrap_or(Dd::from(0.0));
                (motion.displacement(instant).abs(), answer.size, found)
            }
            _ => continue,
        };
        if found > known + size * room {
            assert!(
                !answer.searched,
                "{asked:?} at {place:?}: {found:?} is larger than {known:?}"
            );
            answer.watched.instant = Some(tau);
        }
    }
}
