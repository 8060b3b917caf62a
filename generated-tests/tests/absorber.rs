//! Masses beyond the contact as absorbers: V and H vanish together at their own frequencies.

use frictiongen::{Regime, System, friction_system};

friction_system! {
    pub struct Three {
        masses: { m1: 1, m2: 1, m3: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1 },
        contact: m2 - wall,
        excitation: m1,
        provide: [limits, stuck],
    }
}

const TEXT: &str = "struct Three { masses: { m1: 1, m2: 1, m3: 1 },
    springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1 }, contact: m2 - wall, excitation: m1 }";

/// With the contact held, m1 is between two unit springs: limit and amplitude are 1/|2 − r²|, also
/// at r = 1, where m3 on its spring resonates, and at every distance from it.
#[test]
fn limit_and_amplitude_at_the_absorbers_frequency() {
    let system: System = TEXT.parse().expect("a valid scene");
    let mut ratios = vec![1.0, 1.0_f64.next_up(), 1.0_f64.next_down()];
    for exponent in 1..=15 {
        ratios.extend([
            1.0 - 10.0_f64.powi(-exponent),
            1.0 + 3.0 * 10.0_f64.powi(-exponent),
        ]);
    }
    for r in ratios {
        let exact = 1.0 / (2.0 - r * r);
        let emitted = Three::at(r).expect("in the domain");
        let run_time = system.at(r).expect("in the domain");
        let amplitudes = [
            emitted.stuck().expect("no resonance").m1().re,
            run_time
                .stuck()
                .expect("no resonance")
                .mass("m1")
                .expect("a mass")
                .re,
        ];
        for value in [emitted.sliding_limit(), run_time.sliding_limit()]
            .into_iter()
            .chain(amplitudes)
        {
            let error = (value.abs() / exact.abs() - 1.0).abs();
            // The quotient loses 1e-16 over the distance, the series its fourth power.
            assert!(
                error < 1e-11,
                "r = {r:e}: {value} against {exact}, off by {error:e}"
            );
        }
    }
    assert_eq!(
        Three::at(1.0).expect("in the domain").regime(2.0),
        Ok(Regime::Stuck)
    );
}

/// Five unit masses, contact in the middle: the golden ratio's reciprocal is the frequency of the
/// two beyond it.
#[test]
fn two_masses_beyond_the_contact() {
    let system: System = "struct Five { masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
        springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
        contact: m3 - wall, excitation: m1 }"
        .parse()
        .expect("a valid scene");
    let r = 0.618_033_988_749_894_9;
    let at = system.at(r).expect("in the domain");
    let (a, b) = (2.0 - r * r, 1.0);
    // m1 and m2 between the base and the held m3: x₂ = F on unit springs.
    let exact = (b / (a * a - b)).abs();
    assert!(
        (at.sliding_limit() / exact - 1.0).abs() < 1e-11,
        "{} {exact}",
        at.sliding_limit()
    );
}
