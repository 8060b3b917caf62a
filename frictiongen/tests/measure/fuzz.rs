//! Broken files give an error or a recording of finite numbers, never a panic.

use crate::made::rig;
use frictiongen::measure::{Channel, CsvRequest, Measured, Recording, SweepPoint, Unit};
use fuzzing::Mutator;
use std::f64::consts::TAU;

const WORDS: &[&str] = &[
    "NaN",
    "inf",
    "-1",
    "1e308",
    "-1e-308",
    "time_s",
    "base_mm",
    "plate",
    ",",
    ";",
    "\t",
    "\n",
    "#",
    "\"",
    "0",
    "58",
    "    -1",
    "    58",
    "1.00000E+00",
    "E+",
    "D-02",
    "(mm)",
    "frequency_Hz",
    "plate.transmissibility",
    "plate.deviation",
];

#[test]
fn broken_files() {
    let wave = |lag: f64| {
        (0..90)
            .map(|i| (TAU * 0.1 * f64::from(i) - lag).cos())
            .collect()
    };
    let channel = |name: &str, samples| Channel {
        name: name.into(),
        unit: Unit::MILLIMETRE,
        samples,
    };
    let channels = vec![channel("base", wave(0.0)), channel("plate", wave(0.5))];
    let recording = Recording::new(40.0, channels).unwrap();
    let sweep =
        "frequency_Hz,plate.transmissibility,plate.deviation\n1,1.1,0.01\n2,1.7,0.02\n5,0.6,0.01\n";
    let corpus = [recording.to_csv(), recording.to_uff58(), sweep.to_owned()];
    let corpus = corpus.into_iter().map(String::into_bytes).collect();
    let mut files = Mutator::new(corpus, WORDS, 22);
    let system = rig("");
    let (read, measured) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    let outcome = fuzzing::run(
        3000,
        || String::from_utf8_lossy(&files.input()).into_owned(),
        |text| {
            let request = CsvRequest::default();
            for found in [
                Recording::from_csv(text, &request),
                Recording::from_uff58(text, &request),
            ] {
                let Ok(recording) = found else { continue };
                read.set(read.get() + 1);
                let mut all = recording
                    .channels()
                    .iter()
                    .flat_map(|channel| &channel.samples);
                if !(recording.rate().is_finite() && all.all(|value| value.is_finite())) {
                    return Err("a recording that is not finite".to_owned());
                }
                if let Ok(found) = Measured::of(&recording, system.scene()) {
                    measured.set(measured.get() + 1);
                    let finite = |value: f64| value.is_finite();
                    if !(finite(found.hertz)
                        && found
                            .transmissibility(0)
                            .is_none_or(|t| finite(t.amplitude())))
                    {
                        return Err(format!("a measurement that is not finite: {found:?}"));
                    }
                }
            }
            let points = SweepPoint::read(text, &system).unwrap_or_default();
            let finite = points
                .iter()
                .all(|point| point.hertz.is_finite() && point.amplitude.is_finite());
            if finite {
                Ok(())
            } else {
                Err("a sweep that is not finite".to_owned())
            }
        },
    );
    assert!(outcome.findings.is_empty(), "{:#?}", outcome.findings);
    assert!(
        10 < read.get() && 3 < measured.get(),
        "{} read, {} measured",
        read.get(),
        measured.get()
    );
}
