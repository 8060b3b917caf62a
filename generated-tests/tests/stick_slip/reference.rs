//! The steady states of `reference/orbits.json`.
use frictiongen::System;
use serde_json::Value;

#[test]
fn steady() {
    let scenes: Vec<Value> =
        serde_json::from_str(include_str!("../../reference/orbits.json")).expect("JSON");
    for scene in &scenes {
        let system: System = scene["description"]
            .as_str()
            .expect("text")
            .parse()
            .expect("a scene");
        for orbit in scene["orbits"].as_array().expect("orbits") {
            let (r, beta) = (
                orbit["r"].as_f64().unwrap(),
                orbit["beta"].as_f64().unwrap(),
            );
            let n = system.scene().masses.len();
            let _ = system.at(r).unwrap().orbit(beta);
            let begin = std::time::Instant::now();
            let got = system.at(r).unwrap().orbit(beta);
            let took = begin.elapsed().as_secs_f64() * 1e6;
            let Ok(got) = got else {
                println!("n {n} r {r} beta {beta} ERROR {:?}", got.err());
                continue;
            };
            let mut amp = 0.0_f64;
            let mut fund = 0.0_f64;
            for i in 0..n {
                let motion = got.mass_at(i).unwrap();
                let want = orbit["amplitude"][i].as_f64().unwrap();
                amp = amp.max((motion.amplitude() / want - 1.0).abs());
                let x = motion.harmonic(1);
                fund = fund.max(
                    (x.re - orbit["fundamental"][i][0].as_f64().unwrap())
                        .hypot(x.im - orbit["fundamental"][i][1].as_f64().unwrap())
                        / want,
                );
            }
            let z = got.contact();
            println!(
                "n {n} r {r} beta {beta}: stops {} {} sym {} {} stuck {:.1e} amp {amp:.1e} fund {fund:.1e} z {:.1e} mean {:.1e} {took:.1} us marginal {} stable {} max {:.9}",
                got.stops(),
                orbit["stops"],
                got.is_symmetric(),
                orbit["symmetric"],
                got.stuck_fraction() - orbit["stuck_fraction"].as_f64().unwrap(),
                z.amplitude() / orbit["contact_amplitude"].as_f64().unwrap() - 1.0,
                z.harmonic(0).re - orbit["contact_mean"].as_f64().unwrap(),
                got.is_marginal(),
                got.is_stable(),
                got.multipliers()
                    .iter()
                    .map(|m| m.norm())
                    .fold(0.0, f64::max)
            );
        }
    }
}
