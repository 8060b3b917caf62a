//! Twenty mistakes of somebody who sizes a damper. Each gets one line that says what is wrong and what to write instead.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, failure};
use std::{fs, process};

/// A record of the base in mm.
const RECORD: &str = "time_s,base_mm\n0,0\n0.01,1\n0.02,0\n";

/// Frequency, friction and load of the frame.
const POINT: &str = "--hz 2 --friction 0.4 --base 0.001";

/// A mistake: the words of the command, and parts of the line that the command prints. `FRAME` stands for the
/// description, and `FORCED` for the description with a force on the upper floor. `RECORD` is a file with the text of
/// the field `record`.
struct Mistake {
    command: String,
    record: &'static [u8],
    told: &'static [&'static str],
}

fn mistake(command: &str, told: &'static [&'static str]) -> Mistake {
    in_record(command, RECORD.as_bytes(), told)
}

fn in_record(command: &str, record: &'static [u8], told: &'static [&'static str]) -> Mistake {
    Mistake {
        command: command.replace("POINT", POINT),
        record,
        told,
    }
}

/// Quantities, units and options that do not fit the scene.
fn of_scenes() -> Vec<Mistake> {
    vec![
        mistake(
            "response FRAME POINT --of roof-base",
            &["there is no mass `roof`", "the masses are lower, upper"],
        ),
        mistake(
            "response FRAME POINT --of accel(roof)",
            &["there is no mass `roof`", "the masses are lower, upper"],
        ),
        mistake(
            "curve FRAME --hz 1:2 --friction 0.4 --base 0.001 --of upper-upper",
            &[
                "`upper` does not move relative to itself",
                "write two different masses",
            ],
        ),
        mistake(
            "response FRAME POINT --of spring(base-upper)",
            &[
                "there is no spring",
                "the springs are spring(base-lower), spring(lower-upper)",
            ],
        ),
        mistake(
            "response FRAME POINT --of torque(upper)",
            &[
                "there is no quantity `torque(…)`",
                "write the name of a mass",
            ],
        ),
        mistake(
            "time FRAME POINT --of accel(upper)",
            &[
                "has displacements and forces of springs only",
                "`curve`, `response`, `orbit` and `optimum`",
            ],
        ),
        mistake(
            "response FORCED POINT",
            &["driven by a force on `upper`", "given by --force"],
        ),
        mistake(
            "response FRAME --hz 2 --friction 0.4 --force 1",
            &["driven by its base", "given by --base"],
        ),
        mistake(
            "response FRAME --hz 2 --friction 0.4 --base 1mm",
            &["--base `1mm`", "write `0.001`"],
        ),
        mistake(
            "curve FRAME --hz 7:0.5 --friction 0.4 --base 0.001",
            &[
                "a range goes from its lower end to its upper one",
                "write 0.5:7",
            ],
        ),
        mistake(
            "curve FRAME --hz 1:2 --friction 0.4 --base 0.001 --log xy",
            &["only a picture has axes", "-o curve.svg"],
        ),
    ]
}

/// Records in another format or unit.
fn of_records() -> Vec<Mistake> {
    vec![
        in_record(
            "drive FRAME RECORD --friction 1",
            b"time_s,base_kN\n0,0\n0.01,1\n",
            &["the channel `base` cannot be in kN", "such as mm, m/s or g"],
        ),
        mistake(
            "drive FRAME RECORD --friction 1 --channel base=2:kPa",
            &["`kPa` is not a known unit", "the units are m, cm, mm"],
        ),
        in_record(
            "drive FRAME RECORD --friction 1",
            b"*COSMOS V1.20 FORMAT\nStation 1\n1 2 3\n",
            &["line 2: ", "the formats of a recording are CSV", "PEER AT2"],
        ),
        in_record(
            "drive FRAME RECORD --friction 1",
            b"\x00\xff\xfe",
            &["it is not text", "CSV, columns of numbers, PEER AT2"],
        ),
        in_record(
            "drive FRAME RECORD --friction 1 --channel base=1:g",
            b"0.1\n0.2\n0.1\n",
            &["the sampling rate is unknown", "--rate"],
        ),
        mistake(
            "drive FRAME RECORD --friction 0,8",
            &["--friction `0,8`", "write `0.8`"],
        ),
        mistake(
            "drive FRAME RECORD --spectrum 5",
            &["--spectrum `5`", "a damping ratio from 0 to below 1"],
        ),
        mistake(
            "drive FORCED RECORD --spectrum 0.05",
            &["belongs to a moving base", "write `excitation: base`"],
        ),
        mistake(
            "drive FRAME RECORD RECORD --friction 1",
            &["give only one recording"],
        ),
    ]
}

#[test]
fn twenty_mistakes() {
    let place = |name: &str| {
        let name = format!("frictiongen-mistakes-{}-{name}", process::id());
        std::env::temp_dir().join(name).to_str().unwrap().to_owned()
    };
    let (forced, record) = (place("forced.friction"), place("record"));
    let frame = fs::read_to_string(FRAME).unwrap();
    fs::write(
        &forced,
        frame.replace("excitation: base", "excitation: upper"),
    )
    .unwrap();
    let all: Vec<Mistake> = of_scenes().into_iter().chain(of_records()).collect();
    assert_eq!(all.len(), 20);
    for mistake in all {
        fs::write(&record, mistake.record).unwrap();
        let words = mistake.command.split(' ').map(|word| match word {
            "FRAME" => FRAME,
            "FORCED" => &forced,
            "RECORD" => &record,
            word => word,
        });
        let lines = failure("", &words.collect::<Vec<_>>());
        assert_eq!(lines.len(), 1, "{}: {lines:?}", mistake.command);
        for told in mistake.told {
            assert!(lines[0].contains(told), "{}: {lines:?}", mistake.command);
        }
    }
    for file in [forced, record] {
        fs::remove_file(file).unwrap();
    }
}
