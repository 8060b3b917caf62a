//! Widths of intervals, compared with the textbook's factors. Each comparison takes one fit, and a coverage where the
//! degrees of freedom are few.

use crate::force::{scale, seen};
use crate::intervals::hold;
use crate::made::{Noise, Y, rig};
use frictiongen::measure::{
    Channel, Datum, Estimate, Identified, IdentifyRequest, Observation, Recording, SweepPoint,
    Unit, Unknown,
};
use frictiongen::study::units::Load;
use frictiongen::{Complex, Of, System};

/// Student's two-sided 95 % quantile for seven degrees of freedom, and the normal one.
const STUDENT_7: f64 = 2.364_624;
const NORMAL: f64 = 1.959_964;

fn width(estimate: Estimate) -> f64 {
    estimate.to - estimate.from
}

/// Returns observations at three frequencies with noise of `true_deviation`. Their stated deviation is `deviation`.
fn observed(system: &System, true_deviation: f64, deviation: f64) -> Vec<Observation> {
    let mut noise = Noise::new(31);
    let all = [0.8, 1.2, 1.7].map(|r| {
        let mut seen = seen(system, r, 0.3, &[0], deviation);
        for datum in &mut seen.motions {
            datum.value.re += true_deviation * noise.next();
            datum.value.im += true_deviation * noise.next();
        }
        seen
    });
    all.to_vec()
}

/// Stated deviations that are ten times too small make the misfit a hundred times as large. The interval is then as
/// wide as that of right deviations times the root of the misfit.
#[test]
fn a_misfit_widens_the_interval() {
    let system = rig("damping: modal(0.02),");
    for unknowns in [vec![], vec![Unknown::Damping]] {
        let ask = |deviation: f64| -> Identified {
            let request = IdentifyRequest {
                unknowns: unknowns.clone(),
                ..IdentifyRequest::default()
            };
            let all = observed(&system, 1e-4, deviation);
            system.identify(&all, &request).unwrap()
        };
        let (right, small) = (ask(1e-4), ask(1e-5));
        let misfit = right.misfit.unwrap();
        assert!(right.is_explained() && !small.is_explained());
        assert!((small.misfit.unwrap() / misfit - 100.0).abs() < 1e-3);
        assert_eq!(right.freedom, 5 - unknowns.len());
        let ratio = width(small.friction) / width(right.friction);
        // The sum of squares is nearly quadratic over 1e-4 of the force.
        assert!(
            (ratio / misfit.sqrt() - 1.0).abs() < 1e-3,
            "{ratio}, {misfit}"
        );
        for (wide, narrow) in small.unknowns.iter().zip(&right.unknowns) {
            let ratio = width(wide.1) / width(narrow.1);
            assert!(
                (ratio / misfit.sqrt() - 1.0).abs() < 1e-3,
                "{ratio}, {misfit}"
            );
        }
        assert!(right.friction.holds(0.3 * scale(&system)));
    }
}

/// Errors of the load alone. Its amplitude is wrong by 0.3 % and its phase by 0.003 rad, which turns the third harmonic
/// by 0.009 rad. All motions share these errors, and the friction ratio also contains the amplitude.
#[test]
fn errors_of_the_load() {
    const WRONG: f64 = 0.003;
    let system = rig("damping: modal(0.02),");
    let response = system.at(0.8).unwrap().response(0.4).unwrap();
    let mut noise = Noise::new(8);
    // The contact slides all the time here, so that a thousand repeats take seconds.
    let request = IdentifyRequest {
        range: Some((0.3 * scale(&system), 0.5 * scale(&system))),
        ..IdentifyRequest::default()
    };
    let mut misfits = 0.0;
    let found: Vec<Estimate> = (0..1000)
        .map(|_| {
            let load = Y * (1.0 + WRONG * noise.next());
            let late = WRONG * noise.next();
            let motions = [1_u32, 3].map(|harmonic| {
                let exact = response.harmonic(Of::Mass(0), harmonic).unwrap();
                let turn = Complex::from_polar(Y / load, -f64::from(harmonic) * late);
                let mut value = exact * turn;
                value.re += 1e-4 * noise.next();
                value.im += 1e-4 * noise.next();
                Datum {
                    mass: 0,
                    harmonic,
                    value,
                    deviation: 1e-4,
                }
            });
            let seen = Observation {
                hertz: system.hertz(0.8),
                load: Load::Base(load),
                load_deviation: WRONG * load,
                motions: motions.to_vec(),
            };
            let found = system.identify(&[seen], &request).unwrap();
            misfits += found.misfit.unwrap() / 1000.0;
            found.friction
        })
        .collect();
    let truth = 0.4 * scale(&system);
    println!("mean misfit {misfits}");
    hold("errors of the load", truth, &found);
    // The fit has three degrees of freedom. The bound is four deviations of a mean of 1000.
    assert!(
        (misfits - 1.0).abs() < 4.0 * (2.0 / 3.0 / 1000.0_f64).sqrt(),
        "{misfits}"
    );
}

/// A sweep without stated deviations uses Student's factor and its own scatter. A sweep with deviations uses the normal
/// factor. There are 10 points and 3 parameters.
#[test]
fn few_points_have_students_factor() {
    let text =
        "struct Storeys { masses: { m1: 3, m2: 2.9 }, springs: { base - m1: 1010, m1 - m2: 1130 },
        contact: m1 - wall, excitation: base }";
    let truth: System = text.parse().unwrap();
    let mut noise = Noise::new(44);
    let frequencies = [0.6, 1.1, 1.5, 2.1, 2.6, 3.4, 4.0, 5.0, 5.6, 6.4];
    let points = frequencies.map(|hertz| {
        let at = truth.at(truth.frequency_ratio_at_hertz(hertz)).unwrap();
        let response = at.response(0.0).unwrap();
        let exact = response.harmonic(frictiongen::Of::Mass(0), 1).unwrap();
        (hertz, exact.norm() * (1.0 + 1e-3 * noise.next()))
    });
    let fit = |known: bool| {
        let points = points.map(|(hertz, amplitude)| SweepPoint {
            hertz,
            mass: 0,
            amplitude,
            deviation: known.then_some(1e-3 * amplitude),
        });
        truth.fit_sweep(&points, false).unwrap()
    };
    let (known, open) = (fit(true), fit(false));
    let misfit = known.misfit.unwrap();
    assert!(known.freedom == 7 && known.is_explained(), "{misfit}");
    let expected = STUDENT_7 / NORMAL * misfit.sqrt();
    for (wide, narrow) in [
        (open.reference, known.reference),
        (open.masses[0], known.masses[0]),
        (open.springs[0], known.springs[0]),
        (open.natural[1], known.natural[1]),
    ] {
        let ratio = width(wide) / width(narrow);
        // Both results come from the same fit, which ends within 1e-10. The constants have seven digits.
        assert!(
            (ratio / expected - 1.0).abs() < 1e-5,
            "{ratio} for {expected}"
        );
    }
}

/// An axis with twelve windows for four unknowns, so that each degree of freedom counts.
#[test]
fn twelve_windows() {
    const RATE: f64 = 1000.0;
    const LENGTH: usize = 50;
    let truth = [95.0, 200.0, 20.0, -3.0];
    let [mass, viscous, coulomb, offset] = truth;
    let (mut positions, mut pushes) = (Vec::new(), Vec::new());
    for window in 0..12_u32 {
        let side = if window % 2 == 0 { 1.0 } else { -1.0 };
        let (start, rise) = (
            0.1 + 0.02 * f64::from(window),
            1.5 * f64::from(window % 5) - 2.0,
        );
        for sample in 0..LENGTH {
            let t = (sample as f64 + 0.5) / RATE;
            let speed = side * (start + rise * t);
            positions.push(side * (start * t + 0.5 * rise * t * t));
            pushes.push(mass * side * rise + viscous * speed + coulomb * side + offset);
        }
    }
    let mut noise = Noise::new(12);
    let mut found: [Vec<Estimate>; 4] = Default::default();
    for _ in 0..1000 {
        let mut forces = pushes.clone();
        noise.add(&mut forces, 0.5);
        let channel = |name: &str, unit: Unit, samples| Channel {
            name: name.into(),
            unit,
            samples,
        };
        let channels = vec![
            channel("axis", Unit::METRE, positions.clone()),
            channel("force", Unit::NEWTON, forces),
        ];
        let recording = Recording::new(RATE, channels).unwrap();
        let answer = recording.regression("axis", 0.05).unwrap();
        let each = [answer.mass, answer.viscous, answer.coulomb, answer.offset];
        for (all, one) in found.iter_mut().zip(each) {
            all.push(one);
        }
    }
    for ((name, truth), found) in ["M", "F_v", "F_c", "offset"].iter().zip(truth).zip(&found) {
        hold(name, truth, found);
    }
}
