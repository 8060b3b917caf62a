//! Runs the program `before`, which is built with the searches of an earlier commit. It measures its own time, in
//! turn with this program.

use crate::clock::Job;
use crate::methods::{Method, Pair};
use crate::scenes::Label;
use std::cell::RefCell;
use std::fmt::Write as _;
use std::io::{self, BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

/// Quantities that the program `before` computes.
pub const METHODS: [Method; 3] = [Method::Limits, Method::Amplitude, Method::Contact];

/// The running program `before`.
pub struct Before {
    child: Child,
    pipes: RefCell<(ChildStdin, BufReader<ChildStdout>)>,
}

impl Before {
    /// Starts the program `before`.
    pub fn start(program: &Path) -> io::Result<Self> {
        let mut child = Command::new(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()?;
        let (Some(input), Some(output)) = (child.stdin.take(), child.stdout.take()) else {
            return Err(io::ErrorKind::BrokenPipe.into());
        };
        Ok(Self {
            child,
            pipes: RefCell::new((input, BufReader::new(output))),
        })
    }

    fn ask(&self, request: &str) -> io::Result<f64> {
        let (input, output) = &mut *self.pipes.borrow_mut();
        writeln!(input, "{request}")?;
        input.flush()?;
        let mut line = String::new();
        output.read_line(&mut line)?;
        line.trim().parse().map_err(io::Error::other)
    }

    /// Creates one job for each quantity of the program `before`. A job computes a scene at the given points (r, β).
    pub fn jobs<'a>(&'a self, label: &Label, points: &[Pair<f64>]) -> io::Result<Vec<Job<'a>>> {
        let mut request = format!("scene {} {}", label.name, label.zeta);
        for [r, beta] in points {
            let _ = write!(request, " {r:e},{beta:e}");
        }
        if self.ask(&request)? != points.len() as f64 {
            return Err(io::Error::other("the searches before took other points"));
        }
        let job = |method| {
            let word = match method {
                Method::Limits => "limits",
                Method::Contact => "contact",
                _ => "amplitude",
            };
            Job::timed_by(points.len(), move |count, passes| {
                self.ask(&format!("pass {word} {count} {passes}"))
                    .unwrap_or(f64::NAN)
            })
        };
        Ok(METHODS.map(job).into())
    }
}

impl Drop for Before {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
