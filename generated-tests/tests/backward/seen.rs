//! The measure sees what is wrong: an answer that is off by far more than its inputs explain is above the bar,
//! whatever is displaced to explain it.

use crate::asked::{Asked, Place, answer};
use crate::measure::{Judge, Scene, first};
use frictiongen::study::System;
use frictiongen_kernel::Complex;
use frictiongen_kernel::dd::Dd;
use generated_tests::data::Data;

const BAR: f64 = 64.0;

/// At ordinary frequencies, and a thousandth beside a resonance and a sub-harmonic, where conditions are 10³.
#[test]
fn an_error_is_above_the_bar() {
    for damping in ["none", "modal(0.02)"] {
        let text = format!(
            "struct Pair {{ masses: {{ a: 1.0, b: 0.6 }}, springs: {{ base - a: 1.3, a - b: 0.7 }},
             contact: a - wall, excitation: b, damping: {damping}, stiction: 1.2 }}"
        );
        let system: System = text.parse().unwrap();
        let modal = system.modal();
        let exact = Data {
            reduced: modal.reduced(|value| Dd::from(value.to_f64())),
            contact: modal.contact,
        };
        let scene = Scene::new(exact);
        let resonance = modal.resonances[0].to_f64();
        for r in [0.9, resonance * 1.001, resonance / 3.0 * 0.999] {
            let data = &scene.exact;
            let at = data.at(Dd::from(r));
            let limit = at.continuous_limit();
            let place = Place {
                r: Dd::from(r),
                beta: limit * Dd::from(0.4),
                tau: Dd::from(0.8),
            };
            let judge = Judge::new(&scene, place, f64::EPSILON, BAR);
            let top = first(&at.mass(1, place.beta).peak());
            for (asked, found) in [
                (Asked::ContinuousLimit, first(&at.constraint_peak())),
                (Asked::WithoutSearch, None),
                (Asked::SlidingLimit, None),
                (Asked::ContactAmplitude, None),
                (Asked::ContactPhase, None),
                (Asked::Amplitude(1), top),
                (Asked::Phase(1), top),
                (Asked::Displacement(1), None),
                (Asked::Stuck(1), None),
            ] {
                let want = answer(&at, &place, asked);
                let without = at.continuous_limit_without_search();
                let error = judge.error_beside(asked, want, found, without);
                assert!(error.backward <= 1.0, "{asked:?} at r = {r}: {error:?}");
                // 10⁹ roundings, of which a condition of 10³ leaves 10⁶.
                let off = Dd::from(1.0 + 2e-7);
                let got = if asked.is_angle() {
                    Complex::new(want.re + Dd::from(2e-7), want.im)
                } else {
                    Complex::new(want.re * off, want.im * off)
                };
                let told = without * off;
                for limit in [without, told] {
                    let error = judge.error_beside(asked, got, found, limit);
                    assert!(error.backward > BAR, "{asked:?} at r = {r}: {error:?}");
                }
            }
        }
    }
}
