//! Times the map of `measure.py` in Rust. `measure SCENE` computes a map twice and prints the seconds of the second
//! computation. It also prints the number of stuck points, which shows that both programs computed the same map.

use frictiongen::study::map::MapRequest;
use frictiongen::{Of, Regime, System};
use std::time::Instant;

/// Returns evenly spaced numbers as `numpy.linspace` does.
fn grid(from: f64, to: f64, count: u32) -> Vec<f64> {
    let step = (to - from) / f64::from(count - 1);
    let inner = (0..count - 1).map(|place| from + f64::from(place) * step);
    inner.chain([to]).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: measure SCENE")?;
    let system: System = std::fs::read_to_string(path)?.parse()?;
    let masses = (0..system.scene().masses.len()).map(Of::Mass);
    let request = MapRequest {
        r: grid(0.2, 2.5, 200),
        beta: grid(0.01, 1.5, 200),
        of: [Of::Contact].into_iter().chain(masses).collect(),
    };
    let mut seconds = 0.0;
    let mut stuck = 0;
    for _ in 0..2 {
        let start = Instant::now();
        let map = system.map(&request, |_| true)?;
        seconds = start.elapsed().as_secs_f64();
        let regimes = map.points().filter_map(|(_, _, point)| point.as_ref().ok());
        stuck = regimes
            .filter(|point| point.pattern.regime == Regime::Stuck)
            .count();
    }
    println!("{seconds} {stuck}");
    Ok(())
}
