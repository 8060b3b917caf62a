//! Mistakes of somebody who sizes a damper. Each gets one line that says what is wrong and what to write instead.
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
/// description, `FORCED` for the description with a force on the upper floor, and `SEVERAL` for the description with its
/// contact in the field `contacts`. `RECORD` is a file with the text of the field `record`.
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
            "response FORCED --hz 2 --friction 0.4 --force 1kN",
            &["--force `1kN`", "write `1000`"],
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

/// Questions that a scene with `contacts`, or a periodic load, cannot answer.
fn of_several() -> Vec<Mistake> {
    vec![
        mistake(
            "optimum SEVERAL --hz 1:3 --base 2m/s2 --of zeta_eq",
            &["`zeta_eq` is best where it is large"],
        ),
        mistake(
            "time SEVERAL POINT --spectrum",
            &[
                "--spectrum has no answer for a scene with several `contacts`, `dampers` or `friction: stribeck`; leave it out",
            ],
        ),
        mistake(
            "periodic FORCED --harmonics 1:2 --hz 1:0.5:3 --friction 1",
            &["--hz `1:0.5:3`: one frequency above 0 is needed"],
        ),
        in_record(
            "periodic FRAME RECORD --friction 1",
            b"time_s,base_m_s\n0,1\n0.1,1\n0.2,1\n",
            &[
                "the mean velocity of the base is 1,",
                "compute the motion of a belt in time (`drive`), or subtract the mean",
            ],
        ),
    ]
}

/// Names of columns, numbers of samples, and numbers that a column cannot have.
fn of_columns() -> Vec<Mistake> {
    let drive = "drive FRAME RECORD --friction 1";
    vec![
        in_record(
            drive,
            b"time,base_mm\n0,0\n0.01,1\n",
            &["the channel `time` has no unit", "(`time_s`)"],
        ),
        in_record(
            drive,
            b"t,base_mm\n0,0\n0.01,1\n",
            &["the channel `t` has no unit", "(`t_s`)"],
        ),
        in_record(
            "drive FORCED RECORD --friction 1",
            b"time_s,force_lbf\n0,0\n0.01,1\n",
            &[
                "if `lbf` is its unit, convert the numbers to N and write `force_N`",
                "the units are m, cm",
            ],
        ),
        in_record(
            drive,
            b"time_s,base_yd/s2\n0,0\n0.01,1\n",
            &[
                "convert the numbers from yd/s2 to m/s2 and write `base_m/s2`",
                "the units are m, cm",
            ],
        ),
        in_record(
            "drive FORCED RECORD --friction 1",
            b"time_s,force_N,lower_mm\n0,0,0\n0.01,1,1\n",
            &[
                "the channel `lower` is in mm, but here it must be the force on the mass",
                "leave the recorded motion of a mass out",
            ],
        ),
        in_record(
            drive,
            b"time_s,base_mm\n",
            &["too short: no samples, but 2 are needed"],
        ),
        in_record(
            drive,
            b"time_s,base_mm\n0,1\n",
            &["too short: 1 sample, but 2 are needed"],
        ),
        in_record(
            "identify FRAME RECORD",
            b"time_s,base_mm,upper_mm\n",
            &["too short: no samples, but 16 are needed"],
        ),
        in_record(
            "drive FORCED RECORD --friction 1",
            b"time_s,force_N\n0,0\n0.01,1e200\n",
            &["a force is too large; it must be finite, and its square"],
        ),
        in_record(
            "drive FRAME RECORD --friction 1",
            b"time_s,base_m\n0,0\n0.01,1e200\n",
            &["the displacement or velocity of the base is too large"],
        ),
    ]
}

/// Records in another format or unit.
fn of_records() -> Vec<Mistake> {
    vec![
        in_record(
            "drive FRAME RECORD --friction 1",
            b"time_s,base_kN\n0,0\n0.01,1\n",
            &[
                "the channel `base` is in kN, but here it must be a motion",
                "such as mm, m/s or g",
            ],
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
fn each_mistake_has_one_line() {
    let place = |name: &str| {
        let name = format!("frictiongen-mistakes-{}-{name}", process::id());
        std::env::temp_dir().join(name).to_str().unwrap().to_owned()
    };
    let (forced, record) = (place("forced.friction"), place("record"));
    let several = place("several.friction");
    let frame = fs::read_to_string(FRAME).unwrap();
    fs::write(
        &forced,
        frame.replace("excitation: base", "excitation: upper"),
    )
    .unwrap();
    let contacts = "contacts: { pads: upper - wall { stiction: 1.2, share: 0.5 } }";
    let frame = frame.replace("contact: upper - wall", contacts);
    fs::write(&several, frame.replace("    stiction: 1.2,\n", "")).unwrap();
    let all = [of_scenes(), of_records(), of_several(), of_columns()];
    for mistake in all.into_iter().flatten() {
        fs::write(&record, mistake.record).unwrap();
        let words = mistake.command.split(' ').map(|word| match word {
            "FRAME" => FRAME,
            "FORCED" => &forced,
            "SEVERAL" => &several,
            "RECORD" => &record,
            word => word,
        });
        let lines = failure("", &words.collect::<Vec<_>>());
        assert_eq!(lines.len(), 1, "{}: {lines:?}", mistake.command);
        for told in mistake.told {
            assert!(lines[0].contains(told), "{}: {lines:?}", mistake.command);
        }
    }
    for file in [forced, several, record] {
        fs::remove_file(file).unwrap();
    }
}
