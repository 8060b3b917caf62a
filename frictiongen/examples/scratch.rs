use frictiongen::System;
use std::time::Instant;
fn main() {
    let wall: System =
        "struct A { masses: {m: 1}, springs: {base - m: 1}, contact: m - wall, excitation: m }"
            .parse()
            .unwrap();
    let base: System =
        "struct A { masses: {m: 1}, springs: {base - m: 1}, contact: m - base, excitation: base }"
            .parse()
            .unwrap();
    let sticky: System = "struct A { masses: {m: 1}, springs: {base - m: 1}, contact: m - base, excitation: base, stiction: 1.5 }".parse().unwrap();
    let show = |name: &str, s: &System, r: f64, b: f64| {
        let at = s.at(r).unwrap();
        let t = Instant::now();
        let o = at.orbit(b);
        let t = t.elapsed().as_secs_f64() * 1e6;
        let reg = at.regime(b);
        match o {
            Ok(o) => println!(
                "{name} r {r} b {b} {reg:?}: stops {} rev {} stuck {:.9} sym {} amp {:.13} z {:.13} mean {:.3e} closed {:?} marg {} mult {:?} {t:.0} us",
                o.stops(),
                o.reversals(),
                o.stuck_fraction(),
                o.is_symmetric(),
                o.mass("m").unwrap().amplitude(),
                o.contact().amplitude(),
                o.contact().harmonic(0).re,
                at.motion(b).map(|m| m.contact().amplitude()),
                o.is_marginal(),
                o.multipliers()
            ),
            Err(e) => println!("{name} r {r} b {b} {reg:?}: {e:?} {t:.0} us"),
        }
    };
    show("wall", &wall, 1.0 / 3.0, 0.01);
    show("wall", &wall, 0.2, 0.005);
    show("wall", &wall, 1.0 / 3.0, 0.05);
    show("base", &base, 0.5, 0.04);
    show("wall", &wall, 0.5, 0.2);
    show("wall", &wall, 0.5, 0.33);
    show("wall", &wall, 0.5, 0.34);
    show("wall", &wall, 0.25, 0.02);
    show("wall", &wall, 0.325, 0.1);
    show("wall", &wall, 0.22, 0.05);
    show("base", &base, 0.7, 0.49);
    show("base", &base, 0.7, 0.7 * 0.7);
    show("base", &base, 0.7, 0.489999999999999);
    show("wall", &wall, 0.7, 1.0);
    show("wall", &wall, 0.7, 0.999999);
    show("wall", &wall, 0.7, 0.0);
    show("wall", &wall, 1.0, 0.0);
    show("wall", &wall, 1.0, 0.5);
    show("wall", &wall, 1.0, 0.786);
    show("wall", &wall, 1.0, 0.9);
    show("wall", &wall, 0.999, 0.7);
    show("wall", &wall, 0.999999, 0.7);
    show("wall", &wall, 1.000000001, 0.78);
    show("wall", &wall, 0.9, 0.3);
    show("sticky", &sticky, 0.5, 0.04);
    show("sticky", &sticky, 0.5, 0.06);
    show("sticky", &sticky, 0.5, 0.1);
    show("sticky", &sticky, 0.501, 0.05);
    show("sticky", &sticky, 0.999, 0.5);
    show("sticky", &sticky, 0.9, 0.5);
    show("wall", &wall, 0.02, 0.5);
    show("wall", &wall, 0.01, 0.3);
    show("wall", &wall, 20.0, 0.3);
    show("wall", &wall, 1e6, 0.3);
    show("wall", &wall, 1e6, 0.6);
    show("wall", &wall, 1e-6, 0.6);
    for (r, b) in [(0.44, 0.04), (0.46, 0.04)] {
        let mut run = sticky.simulation(r, b).unwrap();
        let mut n = 0;
        while run.run().cycles() < 3000 {
            run.next();
        }
        while n < 24 {
            let s = run.next().unwrap();
            println!(
                "  {r} {b} cycle {} {:?} start {:.6} len {:.6} z {:.9}",
                run.run().cycles(),
                s.event,
                s.start,
                s.length,
                run.run().relative().0
            );
            n += 1;
        }
    }
    let mut run = wall.simulation(0.5, 0.24).unwrap();
    for c in [100, 1000, 10000] {
        let mut m = 0.0_f64;
        while run.run().cycles() < c {
            run.next();
        }
        while run.run().cycles() < c + 2 {
            let s = run.next().unwrap();
            let _ = s;
            m = m.max(run.run().relative().0.abs());
        }
        println!("wall 0.5 0.24: {c} {m:.12}");
    }
    show("wall", &wall, 0.5, 0.25);
    show("wall", &wall, 0.5, 0.27);
    show("wall", &wall, 1.0 + 1e-12, 0.78);
    // grid of fig 3.12
    for (name, s) in [("base", &base), ("sticky", &sticky), ("wall", &wall)] {
        let (mut worst, mut errors, mut marg, mut times) = (0.0_f64, 0, 0, vec![]);
        for i in 1..=125 {
            for j in 0..=100 {
                let (r, b) = (
                    0.02 * i as f64,
                    0.04 * j as f64 * if name == "wall" { 0.25 } else { 1.0 },
                );
                let t = Instant::now();
                let at = s.at(r).unwrap();
                match at.orbit(b) {
                    Ok(o) => {
                        if o.is_marginal() && b < at.sliding_limit() {
                            marg += 1;
                            if marg < 20 && b > 0.0 {
                                println!(
                                    "marginal {r} {b} sym {} stops {}",
                                    o.is_symmetric(),
                                    o.stops()
                                )
                            }
                        }
                        if let Ok(m) = at.motion(b) {
                            let e = (m.contact().amplitude() / o.contact().amplitude() - 1.0).abs();
                            if e > 1e-11 && o.is_symmetric() {
                                println!("{name} off {r} {b} {e:e} stops {}", o.stops());
                            }
                            if o.is_symmetric() {
                                worst = worst.max(e)
                            };
                            if !o.is_symmetric() {
                                println!(
                                    "{name} asym {r} {b} stops {} z {} closed {}",
                                    o.stops(),
                                    o.contact().amplitude(),
                                    m.contact().amplitude()
                                );
                            }
                        }
                    }
                    Err(e) => {
                        errors += 1;
                        if errors < 30 {
                            println!("{name} {r} {b}: {e:?}")
                        }
                    }
                }
                let t = t.elapsed().as_secs_f64() * 1e6;
                times.push(t);
                if t > 20000.0 {
                    println!("{name} {r} {b} took {t:.0} us");
                }
            }
        }
        times.sort_by(f64::total_cmp);
        println!(
            "{name}: worst {worst:e} errors {errors} marginal {marg} median {:.1} 90% {:.1} 99% {:.1} max {:.0}",
            times[times.len() / 2],
            times[times.len() * 9 / 10],
            times[times.len() * 99 / 100],
            times[times.len() - 1]
        );
    }
}
