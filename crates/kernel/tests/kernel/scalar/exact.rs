//! Arguments whose results are known exactly.

use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::special::exp_m1_minus;

fn exact_points<T: Float>() {
    let number = T::constant;
    for (h, sin, cos) in [
        (0.0, 0.0, 1.0),
        (0.5, 1.0, 0.0),
        (1.0, 0.0, -1.0),
        (-0.5, -1.0, 0.0),
        (1001.5, -1.0, 0.0),
        (-7.0, 0.0, -1.0),
        (16_777_215.0, 0.0, -1.0),
        (1e30, 0.0, 1.0),
    ] {
        assert_eq!(number(h).sin_cos_pi(), (number(sin), number(cos)), "{h}");
        assert_eq!(
            number(h).sin_cos_pi_minus(number(-2.0)),
            (number(sin), number(cos)),
            "{h}"
        );
        assert_eq!(
            number(0.0).sin_cos_pi_minus(number(-h)),
            (number(sin), number(cos)),
            "{h}"
        );
    }
    assert_eq!(number(0.0).one_minus_sinc_pi(), number(0.0));
    assert_eq!(number(0.0).scaled_sinh_defect(), number(0.0));
    assert_eq!(number(f64::INFINITY).scaled_sinh_defect(), number(1.0));
    assert_eq!(number(1e30).scaled_sinh_defect(), number(1.0));
    assert_eq!(
        number(1.0).sin_pi().atan2(number(-1.0)),
        number(0.0).atan2(number(-1.0))
    );
    assert!(number(0.0).atan2(number(-1.0)) > number(3.0));
    assert_eq!(number(f64::NEG_INFINITY).exp(), number(0.0));
    assert_eq!(exp_m1_minus(number(f64::INFINITY)).to_f64(), f64::INFINITY);
    assert_eq!(number(2.0).copysign(number(-0.0)), number(-2.0));
    assert!(number(0.0).abs().to_f64().is_sign_positive());
    for bad in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
        let (sin, cos) = number(bad).sin_cos_pi();
        assert!(sin.to_f64().is_nan() && cos.to_f64().is_nan());
        for (h, d) in [(bad, 1.0), (1.0, bad)] {
            let (sin, cos) = number(h).sin_cos_pi_minus(number(d));
            assert!(sin.to_f64().is_nan() && cos.to_f64().is_nan());
        }
    }
    assert!(number(f64::NAN).scaled_sinh_defect().to_f64().is_nan());
}

#[test]
fn exact_points_of_every_type() {
    exact_points::<f64>();
    exact_points::<f32>();
    exact_points::<Dd>();
}
