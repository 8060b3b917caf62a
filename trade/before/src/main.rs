//! Measures the time of limits and amplitudes, computed with the searches of an earlier commit. The program `trade`
//! starts this program, and alternates its measurements with its own.
//!
//! Reads requests line by line, and answers each request with one line:
//!
//! ```text
//! scene NAME ZETA R,BETA R,BETA …    how many points there are
//! pass limits COUNT PASSES           the seconds of as many passes over the first points
//! pass amplitude COUNT PASSES
//! pass contact COUNT PASSES
//! ```

#[macro_use]
#[path = "../../src/chains.rs"]
mod chains;
#[allow(dead_code)]
#[path = "../../src/methods.rs"]
mod methods;
#[allow(dead_code)]
#[path = "../../src/scenes.rs"]
mod scenes;
mod without_search;

use frictiongen::{FrictionSystem, MotionAt};
use methods::{Fill, Method, Pair, filler};
use scenes::{Label, Orbit, Visitor};
use std::io::Write;
use std::time::Instant;

type Failure = Box<dyn std::error::Error>;

/// All scenes in double precision, each with the function that computes its quantities.
struct Scenes(Vec<(Label, Fill<f64>)>);

impl Visitor for Scenes {
    fn scene<D, S>(&mut self, label: Label, double: D, _: S, _: Orbit<f64>, _: Orbit<f32>)
    where
        D: FrictionSystem<Scalar = f64> + 'static,
        S: FrictionSystem<Scalar = f32> + 'static,
        for<'a> D::At<'a>: MotionAt<Scalar = f64>,
        for<'a> S::At<'a>: MotionAt<Scalar = f32>,
    {
        self.0.push((label, filler(double, label.watched, None)));
    }
}

fn pair(text: &str) -> Result<Pair<f64>, Failure> {
    let (r, beta) = text.split_once(',').ok_or("R,BETA")?;
    Ok([r.parse()?, beta.parse()?])
}

/// The scene that is being timed, with the points at which it is called.
struct Chosen<'a> {
    fill: &'a Fill<f64>,
    points: Vec<Pair<f64>>,
    out: Vec<Pair<f64>>,
}

impl<'a> Chosen<'a> {
    fn new(scenes: &'a Scenes, name: &str, zeta: &str, points: &[&str]) -> Result<Self, Failure> {
        let zeta: f64 = zeta.parse()?;
        let wanted = |(label, _): &&(Label, _)| label.name == name && label.zeta == zeta;
        let (_, fill) = scenes.0.iter().find(wanted).ok_or("no such scene")?;
        let points: Vec<_> = points.iter().map(|p| pair(p)).collect::<Result<_, _>>()?;
        Ok(Self {
            fill,
            out: vec![[0.0; 2]; points.len()],
            points,
        })
    }

    fn pass(&mut self, method: Method, count: usize, passes: usize) -> Result<f64, Failure> {
        let points = self.points.get(..count).ok_or("more than there are")?;
        let out = self.out.get_mut(..count).ok_or("more than there are")?;
        let start = Instant::now();
        for _ in 0..passes {
            (self.fill)(method, points, out);
        }
        Ok(start.elapsed().as_secs_f64())
    }
}

fn main() -> Result<(), Failure> {
    let mut scenes = Scenes(Vec::new());
    scenes::visit(&mut scenes);
    let mut chosen = None;
    for line in std::io::stdin().lines() {
        let line = line?;
        let words: Vec<&str> = line.split(' ').collect();
        let answer = match words.as_slice() {
            ["scene", name, zeta, points @ ..] => {
                let scene = chosen.insert(Chosen::new(&scenes, name, zeta, points)?);
                scene.points.len().to_string()
            }
            ["pass", method, count, passes] => {
                let method = match *method {
                    "limits" => Method::Limits,
                    "amplitude" => Method::Amplitude,
                    "contact" => Method::Contact,
                    _ => return Err("limits, amplitude or contact".into()),
                };
                let scene = chosen.as_mut().ok_or("a scene first")?;
                let seconds = scene.pass(method, count.parse()?, passes.parse()?)?;
                format!("{seconds:e}")
            }
            _ => return Err(format!("not understood: {line}").into()),
        };
        let mut output = std::io::stdout().lock();
        writeln!(output, "{answer}")?;
        output.flush()?;
    }
    Ok(())
}
