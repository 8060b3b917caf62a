//! Tests code with inputs that are changed at random, but are the same in every run. The changes affect bytes,
//! characters and tokens of a corpus. A check gets each input. It must not panic, take long, or report a problem.

pub mod bits;
mod mutate;
mod random;

pub use mutate::Mutator;
pub use random::Random;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Largest allowed time for the check of one input. It is long enough for a slow machine without optimisation, while
/// other tests run.
const LONGEST: Duration = Duration::from_secs(20);
/// Number of problems after which a run ends.
const ENOUGH: usize = 5;

/// Returns the files of a folder of the corpus, in the order of their names.
///
/// # Errors
/// Errors of the file system.
pub fn corpus(folder: &str) -> std::io::Result<Vec<Vec<u8>>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("corpus")
        .join(folder);
    let mut paths = std::fs::read_dir(folder)?
        .map(|entry| entry.map(|entry| entry.path()))
        .collect::<Result<Vec<PathBuf>, _>>()?;
    paths.sort();
    paths.into_iter().map(std::fs::read).collect()
}

/// The result of [`run`]: how many inputs were checked, and which problems were found.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// Number of inputs that were checked.
    pub count: u64,
    /// The problems that were found, each with its input.
    pub findings: Vec<String>,
}

/// Gives `count` inputs to a check and collects the problems. If the environment variable SECONDS_EACH is set, the
/// run ends after this number of seconds. If SHOW is set, every input is printed before its check. If a check hangs,
/// the last printed input is its cause.
pub fn run<I: std::fmt::Debug>(
    count: u64,
    mut next: impl FnMut() -> I,
    check: impl Fn(&I) -> Result<(), String>,
) -> Outcome {
    let mut findings = Vec::new();
    let seconds = std::env::var("SECONDS_EACH").ok();
    let longest = seconds.and_then(|seconds| seconds.parse().ok());
    let shown = std::env::var_os("SHOW").is_some();
    let (start, mut given) = (Instant::now(), 0);
    for number in 0..count {
        if longest.is_some_and(|longest| start.elapsed() >= Duration::from_secs(longest)) {
            break;
        }
        let input = next();
        given = number + 1;
        if shown {
            eprintln!("{input:?}");
        }
        let begin = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| check(&input)));
        let problem = match outcome {
            Err(_) => Some("panicked".to_owned()),
            Ok(Err(problem)) => Some(problem),
            Ok(Ok(())) if begin.elapsed() > LONGEST => Some(format!("took {:?}", begin.elapsed())),
            Ok(Ok(())) => None,
        };
        if let Some(problem) = problem {
            findings.push(format!("input {number}, {input:?}: {problem}"));
            if findings.len() == ENOUGH {
                break;
            }
        }
    }
    Outcome {
        count: given,
        findings,
    }
}

/// Returns the largest memory that this process has used so far, in bytes. Returns `None` if the system does not
/// report it. Linux reports it.
#[must_use]
pub fn most_memory() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kibibytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes << 10)
}
