//! The discrete transform of a steady run, compared with the exact harmonics.

use crate::scenes::{BETWEEN, DAMPED, FRAME, SHAKEN, all, system};
use frictiongen::study::history::HistoryRequest;
use frictiongen::{Of, Regime};

/// The acceleration jumps at events, so harmonics fall with the third power of their order. Aliasing onto the orders up
/// to a quarter of the samples falls with the third power of the number of samples.
#[test]
fn harmonics_to_the_third_power_of_the_step() {
    let scenes: [(&str, &[(f64, f64)]); 4] = [
        (DAMPED, &[(0.3, 0.4), (0.8, 0.2), (2.0, 0.1)]),
        (SHAKEN, &[(0.6, 0.3), (1.1, 0.4)]),
        (BETWEEN, &[(0.4, 0.3), (0.9, 0.1), (1.6, 0.2)]),
        (FRAME, &[(0.3, 0.4), (0.5, 0.5), (0.9, 0.1)]),
    ];
    let counts = [100_u32, 200, 400, 800];
    let (mut worst, mut compared) = ([0.0_f64; 4], 0);
    for (text, points) in scenes {
        let system = system(text);
        for (r, beta) in points {
            let response = system.at(*r).unwrap().response(*beta).unwrap();
            assert_ne!(response.regime(), Regime::Stuck);
            assert_eq!(response.period(), 1);
            for (samples, worst) in counts.into_iter().zip(&mut worst) {
                let request = HistoryRequest {
                    skip: 600,
                    cycles: 3,
                    samples,
                    ..HistoryRequest::new(&all(&system))
                };
                let run = system.history(*r, *beta, &request).unwrap();
                for of in all(&system) {
                    let amplitude = response.swing(of).unwrap().amplitude;
                    let exact = response.spectrum(of, 25).unwrap();
                    let found = run.spectrum(of).unwrap();
                    assert_eq!(found.lines.len(), 3 * samples as usize / 2 + 1);
                    for (index, line) in found.lines.iter().take(3 * 25).enumerate() {
                        // Between the harmonics the spectrum is zero.
                        let (size, error) = if index % 3 == 0 {
                            let exact = &exact.lines[index / 3];
                            assert_eq!(exact.order, line.order);
                            (exact.amplitude(), (exact.component - line.component).norm())
                        } else {
                            (0.0, line.amplitude())
                        };
                        assert!(size <= 1.3 * amplitude);
                        *worst = worst.max(error / amplitude);
                        compared += 1;
                    }
                }
            }
        }
    }
    let shown = worst.map(|worst| format!("{worst:.1e}")).join(", ");
    println!("{compared} lines; errors over the amplitude for {counts:?} samples: {shown}");
    assert!(compared > 8000);
    for (samples, worst) in counts.into_iter().zip(worst) {
        assert!(
            worst < 12.0 * f64::from(samples).powi(-3),
            "{samples}: {worst}"
        );
    }
}

/// With a period of three cycles, every order that is a multiple of 1/3 has its exact component.
#[test]
fn subharmonics() {
    let system = system(
        "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall,
         excitation: block, stiction: 2 }",
    );
    let response = system.at(0.352).unwrap().response(0.1563).unwrap();
    let motions = [Of::Mass(0), Of::Contact];
    let history = response.history(&motions, 400).unwrap();
    for of in motions {
        let exact = response.spectrum(of, 30).unwrap();
        assert_eq!(exact.lines.len(), 91);
        let found = history.spectrum(of).unwrap();
        let (mut worst, mut between) = (0.0_f64, 0);
        for (exact, found) in exact.lines.iter().zip(&found.lines) {
            assert_eq!(exact.order, found.order);
            worst = worst.max((exact.component - found.component).norm());
            between += usize::from(exact.order.fract() != 0.0 && exact.amplitude() > 1e-3);
        }
        println!(
            "{of:?}: {} lines to {worst:.1e}, {between} between the harmonics above 1e-3",
            exact.lines.len()
        );
        assert!(worst < 1e-6 && between > 3, "{of:?}");
    }
}

/// The mean square of the samples equals that of the spectrum (Parseval).
#[test]
fn mean_squares() {
    let system = system(SHAKEN);
    let history = system
        .history(0.6, 0.3, &HistoryRequest::new(&all(&system)))
        .unwrap();
    for track in &history.tracks {
        let spectrum = history.spectrum(track.of).unwrap();
        let last = spectrum.lines.len() - 1;
        let squares = spectrum.lines.iter().enumerate().map(|(index, line)| {
            let share = if index == 0 || index == last {
                1.0
            } else {
                0.5
            };
            share * line.amplitude() * line.amplitude()
        });
        let squares: f64 = squares.sum();
        assert!((squares.sqrt() / track.rms() - 1.0).abs() < 1e-12);
        assert!(track.rms() < track.largest() && track.largest() < 5.0);
    }
}

/// With a stuck contact, the spectrum of each mass has one line.
#[test]
fn of_what_is_stuck() {
    let system = system(FRAME);
    let response = system.at(0.7).unwrap().response(9.0).unwrap();
    let history = response.history(&[Of::Mass(0), Of::Contact], 40).unwrap();
    let spectrum = history.spectrum(Of::Mass(0)).unwrap();
    let amplitude = response.swing(Of::Mass(0)).unwrap().amplitude;
    for (index, line) in spectrum.lines.iter().enumerate() {
        let expected = if index == 1 { amplitude } else { 0.0 };
        assert!((line.amplitude() - expected).abs() < 1e-14);
    }
    let still = history.spectrum(Of::Contact).unwrap();
    assert!(still.lines.iter().all(|line| line.amplitude() == 0.0));
    assert!(history.spectrum(Of::Mass(1)).is_none());
    assert!(response.spectrum(Of::Mass(2), 3).is_none());
}
