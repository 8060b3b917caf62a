//! The response of a mode exactly on its resonance, and the range of 1/r in which a chain is evaluated.

use frictiongen_kernel::Float;
use frictiongen_kernel::contact::regime::inverse_ratio_range;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};

fn undamped<S: Float>(resonance: S) -> Mode<S> {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    Mode {
        kind: Kind::Undamped,
        in_contact: true,
        resonance,
        zeta: zero,
        q: one,
        q_defect: zero,
        load: one,
        contact: one,
        residue: one,
        contact_squared: one,
        static_residue: one,
    }
}

/// On the pole that v and u share, the ratio u over v continues its values on both sides.  With v = x²/(x² − 1) and u =
/// x·tan(πx/2), u over v tends to −4/π from both sides.
#[test]
fn an_exact_resonance_continues_its_neighbours() {
    fn ratio<S: Float>(resonance: S, inverse_r: S) -> S {
        let at = undamped(resonance).response(inverse_r, 0);
        // `u` is scaled by `size`, and the response is 1 over `denominator`.
        at.u * at.denominator.re / at.size
    }
    let pole = -4.0 / std::f64::consts::PI;
    let mut compared = 0;
    for resonance in [1.0, 0.5, 4.0, 1024.0] {
        let exact = ratio(resonance, 1.0 / resonance);
        assert!((exact - pole).abs() < 1e-15, "{resonance}: {exact}");
        let single = ratio(resonance as f32, 1.0 / resonance as f32);
        assert!(
            (f64::from(single) - pole).abs() < 1e-6,
            "{resonance}: {single}"
        );
        let wide = ratio(Dd::from(resonance), Dd::from(1.0 / resonance)).to_f64();
        assert!((wide - pole).abs() < 1e-15, "{resonance}: {wide}");
        for beside in [1e-9, -1e-9] {
            let near = ratio(resonance, (1.0 + beside) / resonance);
            // The tolerance covers the first order in the distance, and the rounding of x over the distance.
            assert!((exact - near).abs() < 1e-6, "{resonance}: {exact} {near}");
            compared += 1;
        }
        compared += 3;
    }
    assert_eq!(compared, 20);
}

/// At both bounds of the range no square of √λ/r vanishes, overflows or loses digits, whatever the resonances.  r²
/// times such a square stays in range too.  Chains of ordinary resonances have the scalar's whole range.
fn range_is_safe<S: Float>(smallest: f64, powers: &[i32]) {
    let mut compared = 0;
    let normal = |value: S, what: &str, powers: &[i32]| {
        assert!(
            value.is_finite() && value.to_f64() >= smallest,
            "{what} of {powers:?}: {value:?}"
        );
    };
    for low in powers {
        for high in powers.iter().filter(|high| *high >= low) {
            let resonances = [2.0_f64.powi(*low), 2.0_f64.powi(*high)];
            let (from, to) = inverse_ratio_range(resonances.iter().map(|r| S::constant(*r)));
            for end in [from, to] {
                let r = S::constant(1.0) / end;
                normal(r * r, "r²", &[*low, *high]);
                for resonance in resonances {
                    let x = S::constant(resonance) * end;
                    normal(x * x, "x²", &[*low, *high]);
                    normal(S::constant(1.0) / (x * x), "1/x²", &[*low, *high]);
                    compared += 1;
                }
            }
        }
    }
    println!("{compared} ends");
    assert!(compared > 200);
    let ordinary = inverse_ratio_range([0.01, 1.0, 100.0].iter().map(|r| S::constant(*r)));
    assert_eq!(ordinary, S::inverse_ratio_range());
}

#[test]
fn squares_stay_in_range() {
    range_is_safe::<f64>(
        f64::MIN_POSITIVE,
        &[-100, -50, -20, -11, -10, -9, 0, 9, 10, 11, 20, 50, 100],
    );
    range_is_safe::<f32>(
        f32::MIN_POSITIVE.into(),
        &[
            -20, -18, -15, -12, -11, -10, -9, 0, 9, 10, 11, 12, 15, 18, 20,
        ],
    );
}
