//! Tests the data and the pictures of `frictiongen curve` and `frictiongen map`.

#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{BLOCK, FRAME, cells, failure, output, texts};
use std::collections::BTreeSet;
use std::path::PathBuf;

fn lines(arguments: &[&str]) -> Vec<Vec<String>> {
    let (command, rest) = arguments.split_first().unwrap();
    let text = output("", &[&[*command, FRAME][..], rest].concat());
    let row = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(row).collect()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap()
}

/// Creates a folder for this test.
fn folder(name: &str) -> PathBuf {
    let folder =
        std::env::temp_dir().join(format!("frictiongen-curve-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

/// Checks that points of a curve equal those of `response`, in units and in groups.
#[test]
fn points_are_responses() {
    let of = ["--of", "upper", "--of", "contact"];
    let curve = [
        "curve",
        "--hz",
        "1.2:6",
        "--friction",
        "1.5",
        "--base",
        "0.002",
        "--csv",
    ];
    let curve = lines(&[&curve[..], &of].concat());
    let names = &curve[0];
    let place = |name: &str| names.iter().position(|found| found == name).unwrap();
    let (hz, phase) = (place("frequency_Hz"), place("upper.phase_deg"));
    assert!(curve.len() > 150);
    let mut regimes: Vec<String> = Vec::new();
    for row in curve.iter().skip(1).step_by(9) {
        let arguments = [
            "response",
            "--hz",
            &row[hz],
            "--friction",
            "1.5",
            "--base",
            "0.002",
            "--csv",
        ];
        let response = lines(&arguments);
        let there = |name: &str| {
            let place = response[0].iter().position(|found| found == name).unwrap();
            response[1][place].clone()
        };
        assert_eq!(there("regime"), row[place("regime")], "{row:?}");
        let size = "upper.amplitude_m";
        let amplitude = number(&there(size));
        assert!(
            (amplitude - number(&row[place(size)])).abs() < 1e-9 * amplitude.max(1e-6),
            "{row:?}"
        );
        assert_eq!(row[phase].is_empty(), there("upper.phase_deg").is_empty());
        if amplitude > 1e-9 && !row[phase].is_empty() {
            let lag = number(&there("upper.phase_deg")) - number(&row[phase]);
            assert!(
                lag.abs() < 1e-6 || (lag.abs() - 360.0).abs() < 1e-6,
                "{row:?}"
            );
        }
        regimes.push(row[place("regime")].clone());
    }
    for regime in ["continuous", "stick-slip", "stuck"] {
        assert!(regimes.iter().any(|found| found == regime), "{regime}");
    }
}

/// Checks that under a load the power of friction, in watts, is its work in a cycle times the frequency.
#[test]
fn power_is_work_times_frequency() {
    let physical = lines(&[
        "curve",
        "--hz",
        "1.9:2.1",
        "--friction",
        "1",
        "--base",
        "0.002",
        "--csv",
    ]);
    let groups = lines(&[
        "curve",
        "--hz",
        "1.9:2.1",
        "--beta",
        "0.42016806722689076",
        "--csv",
    ]);
    let place =
        |rows: &[Vec<String>], name: &str| rows[0].iter().position(|found| found == name).unwrap();
    let (power, work) = (
        place(&physical, "friction_power_W"),
        place(&groups, "friction_work"),
    );
    let (hz, force) = (
        place(&physical, "frequency_Hz"),
        place(&physical, "contact_force_N"),
    );
    for (one, other) in physical.iter().zip(&groups).skip(1) {
        // The unit of work is k₁Y² = 1190 N/m · (0.002 m)².
        let expected = number(&other[work]) * 1190.0 * 4e-6 * number(&one[hz]);
        assert!((number(&one[power]) - expected).abs() < 1e-12 + 1e-9 * expected);
        assert!((number(&one[force]) - 1.0).abs() < 1e-12);
    }
}

/// Checks the additional lines of a CSV: units in the second line, and comments that pandas skips.
#[test]
fn units_and_comments_in_csv() {
    let asked = ["limits", FRAME, "--hz", "1,2", "--base", "0.002", "--csv"];
    let plain = output("", &asked);
    let with = output("", &[&asked[..], &["--unit-row", "--comments"]].concat());
    let comments: Vec<&str> = with
        .lines()
        .take_while(|line| line.starts_with("# "))
        .collect();
    assert!(
        comments
            .iter()
            .any(|line| line.contains("Y = 2.00000e-3 m")),
        "{comments:?}"
    );
    let rest: Vec<&str> = with.lines().skip(comments.len()).collect();
    let mut lines = plain.lines();
    assert_eq!(rest[0], lines.next().unwrap());
    assert!(
        rest[1].starts_with("Hz,,") && rest[1].contains(",N"),
        "{}",
        rest[1]
    );
    assert_eq!(rest[1].split(',').count(), rest[0].split(',').count());
    assert_eq!(rest[2..], lines.collect::<Vec<_>>());
    for option in ["--unit-row", "--comments"] {
        let message = format!(
            "frictiongen: {option} applies only to CSV; give --csv, or a file whose name ends in .csv"
        );
        assert_eq!(failure(BLOCK, &["limits", "--r", "1", option]), [message]);
    }
}

/// Checks that the rows of a map are the grid, and that its boundaries lead from each cell to the next.
#[test]
fn maps_and_their_boundaries() {
    let grid = ["--r", "0.2:0.2:2", "--beta", "0.1:0.1:1"];
    let map = lines(&[&["map", "--csv", "--of", "upper"][..], &grid].concat());
    assert_eq!(map.len(), 101);
    assert_eq!(
        map[0].join(","),
        "r,beta,regime,region,period,stops,reversals,stuck_fraction,offset,marginal,from_rest,\
         upper.amplitude"
    );
    let boundaries = lines(&[&["map", "--csv", "--boundaries", "4"][..], &grid].concat());
    assert_eq!(boundaries[0].join(","), "r,beta,width,below,above");
    let (mut followed, mut whole) = (0, 0);
    for column in map[1..].chunk_by(|a, b| a[0] == b[0]) {
        for pair in column.windows(2) {
            let [low, high] = [0, 1].map(|side: usize| number(&pair[side][1]));
            let between = boundaries[1..].iter().filter(|boundary| {
                let beta = number(&boundary[1]);
                boundary[0] == pair[0][0] && low <= beta && beta < high
            });
            let (mut region, mut here) = (pair[0][3].clone(), 0);
            for boundary in between {
                assert_eq!(boundary[3], region, "{boundary:?}");
                region = boundary[4].clone();
                here += 1;
            }
            // Where periods appear and disappear many times, the search follows only the lowest boundaries.
            assert!(region == pair[1][3] || 6 < here, "{region}: {pair:?}");
            whole += usize::from(0 < here && region == pair[1][3]);
            followed += here;
        }
    }
    assert_eq!(followed, boundaries.len() - 1);
    assert!(whole > 10, "{whole}");
}

/// Checks that the extension of the file name sets the format. A picture of either format is valid, and the same when
/// it is drawn twice.
#[test]
fn pictures() {
    let folder = folder("pictures");
    let scene = FRAME;
    let commands: [&[&str]; 4] = [
        &["curve", scene, "--r", "0.3:2", "--beta", "0.1,0.5"],
        &[
            "map",
            scene,
            "--r",
            "0.2:0.2:2",
            "--beta",
            "0:0.1:1",
            "--boundaries",
            "2",
        ],
        &[
            "map",
            scene,
            "--r",
            "0.2:0.2:2",
            "--beta",
            "0:0.1:1",
            "--shade",
            "amplitude",
            "--of",
            "lower",
        ],
        &[
            "time",
            scene,
            "--r",
            "0.5",
            "--beta",
            "0.3",
            "--steady",
            "--spectrum",
        ],
    ];
    for (index, command) in commands.iter().enumerate() {
        let mut seen: Vec<Vec<u8>> = Vec::new();
        let names = ["one.svg", "two.svg", "one.PNG"];
        let drawn = if cfg!(feature = "png") { 3 } else { 2 };
        for name in &names[..drawn] {
            let path = folder.join(format!("{index}-{name}"));
            let arguments = [command, &["-o", path.to_str().unwrap()][..]].concat();
            assert_eq!(output("", &arguments), "");
            seen.push(std::fs::read(path).unwrap());
        }
        assert_eq!(seen[0], seen[1], "{command:?}");
        assert!(
            seen[0].starts_with(b"<svg") && seen[0].ends_with(b"</svg>\n"),
            "{command:?}"
        );
        assert!(!String::from_utf8_lossy(&seen[0]).contains("NaN"));
        let png = seen
            .get(2)
            .is_none_or(|png| png.starts_with(b"\x89PNG\r\n\x1a\n"));
        assert!(png, "{command:?}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

/// Runs the command, sends Ctrl-C after some milliseconds, and returns the error output. The exit status must be 2.
#[cfg(target_os = "linux")]
fn interrupted(arguments: &[&str], milliseconds: u64) -> String {
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_frictiongen"));
    command
        .args(arguments)
        .stdin(std::process::Stdio::null())
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::piped());
    let run = command.spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(milliseconds));
    let pressed = std::process::Command::new("kill")
        .args(["-INT", &run.id().to_string()])
        .status()
        .unwrap();
    assert!(pressed.success());
    let output = run.wait_with_output().unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{told}");
    told
}

/// Checks that Ctrl-C in the middle of a map keeps whole columns, and that the command reports their number.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_map_is_kept() {
    let folder = folder("interrupted");
    let (scene, out) = (folder.join("slow.friction"), folder.join("map.csv"));
    // The scene has four masses with little damping, so a column takes long.
    let slow = "struct Slow { masses: { a: 1, b: 1, c: 1, d: 1 }, springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1 },
                contact: b - wall, excitation: d, damping: modal(0.004), stiction: 1.2 }";
    std::fs::write(&scene, slow).unwrap();
    let arguments = [
        "map",
        scene.to_str().unwrap(),
        "--r",
        "0.2:0.001:2",
        "--beta",
        "0.01:0.01:1",
        "-o",
        out.to_str().unwrap(),
    ];
    let told = interrupted(&arguments, 3000);
    let words = told
        .strip_prefix("frictiongen: stopped: ")
        .expect("that it was stopped");
    let done: usize = words.split(' ').next().unwrap().parse().unwrap();
    assert!(
        words.ends_with("of 1801 frequencies are done and written\n"),
        "{told}"
    );
    let written = std::fs::read_to_string(out).unwrap();
    assert_eq!(written.lines().count(), 1 + 100 * done);
    assert!(written.ends_with('\n'));
    std::fs::remove_dir_all(folder).unwrap();
}

/// Checks that Ctrl-C in the middle of many curves keeps those that are complete, and that the command reports their
/// number.
#[cfg(target_os = "linux")]
#[test]
fn interrupted_curves_are_kept() {
    let folder = folder("interrupted-curves");
    let (scene, out) = (folder.join("block.friction"), folder.join("curves.csv"));
    std::fs::write(&scene, BLOCK).unwrap();
    let arguments = [
        "curve",
        scene.to_str().unwrap(),
        "--r",
        "0.5:1.5",
        "--beta",
        "0.01:0.00002:0.9",
        "-o",
        out.to_str().unwrap(),
    ];
    let told = interrupted(&arguments, 1500);
    let words = told
        .strip_prefix("frictiongen: stopped: ")
        .expect("that it was stopped");
    let done: usize = words.split(' ').next().unwrap().parse().unwrap();
    assert!(
        words.ends_with("of 44501 curves are done and written\n"),
        "{told}"
    );
    let written = std::fs::read_to_string(out).unwrap();
    let frictions: BTreeSet<&str> = texts(&written, "beta").into_iter().collect();
    assert!(0 < done && frictions.len() == done, "{done}");
    std::fs::remove_dir_all(folder).unwrap();
}

/// Checks that a picture has the load below it, and decades along a logarithmic axis.
#[test]
fn logarithmic_pictures_under_a_load() {
    let folder = folder("logarithmic");
    let draw = |log: &[&str]| {
        let path = folder.join("curve.svg");
        let path = path.to_str().unwrap();
        let asked = [
            "curve",
            FRAME,
            "--hz",
            "0.5:7",
            "--friction",
            "0.4",
            "--of",
            "upper",
        ];
        let load = ["--base", "0.001", "-o", path];
        output("", &[&asked[..], &load, log].concat());
        std::fs::read_to_string(path).unwrap()
    };
    let (plain, log) = (draw(&[]), draw(&["--log", "y"]));
    std::fs::remove_dir_all(&folder).unwrap();
    let words = |svg: &str| -> Vec<String> {
        let pieces = svg.split('<').filter_map(|tag| tag.split_once('>'));
        let texts = pieces.map(|(_, text)| text.trim().to_owned());
        texts.filter(|text| !text.is_empty()).collect()
    };
    for svg in [&plain, &log] {
        let words = words(svg).concat();
        assert!(words.contains("Y = 0.001 m, k1 Y = 1.19 N"), "{words}");
    }
    // The amplitude of the upper floor spans four decades, from 0.002 to 20 mm.
    let decades = |svg: &str| words(svg).iter().filter(|text| *text == "10").count();
    assert!(
        decades(&plain) <= 1 && 4 <= decades(&log),
        "{:?}",
        words(&log)
    );
}

/// Checks two sweeps in one table. The stuck block begins to slide on its base at r² = μβ − |offset|, where the offset
/// is that of the stuck contact from its centre.
#[test]
fn sweeps_up_and_down() {
    let block = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - base, excitation: base, stiction: 2 }";
    let asked = [
        "curve",
        "--r",
        "1.01:1.75",
        "--beta",
        "0.85",
        "--from",
        "up,down",
        "--csv",
    ];
    let text = output(block, &asked);
    let cells = cells(&text);
    let place = |name: &str| cells[0].iter().position(|found| *found == name).unwrap();
    let [from, r, regime, offset] = ["from", "r", "regime", "offset"].map(place);
    let rows = |way: &'static str, what: &'static str| {
        let rows = cells.iter().skip(1);
        rows.filter(move |row| row[from] == way && row[regime] == what)
    };
    let number = |text: &str| text.parse::<f64>().unwrap();
    let last = rows("up", "stuck").next_back().unwrap();
    let departure = (1.7 - number(last[offset]).abs()).sqrt();
    assert!((number(last[r]) - departure).abs() < 2e-7);
    let first = rows("down", "continuous").next().unwrap();
    assert!(number(first[r]) < departure - 0.1);
    // A single sweep has no column for its direction.
    let text = output(
        block,
        &["curve", "--r", "1.01:1.75", "--beta", "0.85", "--csv"],
    );
    assert!(
        !text
            .lines()
            .next()
            .unwrap()
            .split(',')
            .any(|name| name == "from")
    );
}

/// Checks that Ctrl-C in the middle of a search keeps the best friction so far, and that the command says so.
#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_search_is_kept() {
    let folder = folder("interrupted-search");
    let scene = folder.join("four.friction");
    // In a build for tests the whole search takes more than ten seconds.
    let four =
        "struct Four { masses: { a: 1, b: 1, c: 1, d: 1 }, contact: d - wall, excitation: base,
                springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1 }, damping: modal(0.02) }";
    std::fs::write(&scene, four).unwrap();
    let scene = scene.to_str().unwrap();
    let arguments = [
        "optimum", scene, "--of", "d", "--r", "0.1:2", "--vary", "k2=1:2",
    ];
    // On a busy machine the first friction takes longer.
    let early = "frictiongen: the search was stopped before it found a valid friction\n";
    let mut told = interrupted(&arguments, 2000);
    for delay in [6000, 15_000, 45_000] {
        if told == early {
            told = interrupted(&arguments, delay);
        }
    }
    assert_eq!(
        told,
        "frictiongen: stopped: the search did not end, and the friction is the best so far\n"
    );
    std::fs::remove_dir_all(folder).unwrap();
}
