use frictiongen::System;
use frictiongen::kernel::simulation::Event;
use std::time::Instant;
struct Rng(u64);
impl Rng {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let count: usize = args[1].parse().unwrap();
    let seed: u64 = args[2].parse().unwrap();
    let nfix: usize = args.get(3).map_or(0, |a| a.parse().unwrap());
    let mufix: f64 = args.get(4).map_or(0.0, |a| a.parse().unwrap());
    let mut g = Rng(seed * 7919 + 12345);
    for _ in 0..20 {
        g.next();
    }
    let (mut ok, mut bad, mut noconv, mut errs) =
        (0, 0, 0, std::collections::BTreeMap::<String, usize>::new());
    let mut times = vec![];
    for case in 0..count {
        let n = if nfix > 0 {
            nfix
        } else {
            1 + (g.next() * 4.0) as usize
        };
        let mut masses = String::new();
        let mut springs = String::new();
        for i in 0..n {
            masses += &format!(
                "m{}: {}, ",
                i,
                if i == 0 { 1.0 } else { 0.3 + 2.0 * g.next() }
            );
            springs += &format!(
                "{} - m{}: {}, ",
                if i == 0 {
                    "base".to_string()
                } else {
                    format!("m{}", i - 1)
                },
                i,
                if i == 0 { 1.0 } else { 0.3 + 2.5 * g.next() }
            );
        }
        let exc = if g.next() < 0.5 {
            "base".to_string()
        } else {
            format!("m{}", (g.next() * n as f64) as usize)
        };
        let k = g.next();
        let c = (g.next() * n as f64) as usize;
        let contact = if k < 0.4 {
            format!("m{c} - wall")
        } else if k < 0.75 || n == 1 {
            format!("m{c} - base")
        } else {
            format!("m{} - m{}", c.min(n - 2), c.min(n - 2) + 1)
        };
        let damping = if n == 1 && g.next() < 0.5 {
            "none".into()
        } else {
            let z: Vec<String> = (0..n)
                .map(|_| format!("{}", 0.003 * 60.0_f64.powf(g.next())))
                .collect();
            format!("modal[{}]", z.join(", "))
        };
        let mu = if mufix > 0.0 {
            mufix
        } else {
            [1.0, 1.0, 1.2, 1.5, 2.0][(g.next() * 5.0) as usize]
        };
        let text = format!(
            "struct A {{ masses: {{ {masses} }}, springs: {{ {springs} }}, contact: {contact}, excitation: {exc}, damping: {damping}, stiction: {mu} }}"
        );
        let Ok(s) = text.parse::<System>() else {
            continue;
        };
        let r = (0.06_f64.ln() + g.next() * (2.5_f64 / 0.06).ln()).exp();
        let at = s.at(r).unwrap();
        let (c, sl) = (at.continuous_limit(), at.sliding_limit());
        let mut beta = if c < sl {
            c + (sl - c) * g.next()
        } else {
            sl * g.next()
        };
        if g.next() < 0.2 {
            beta = sl * g.next();
        }
        if args.len() > 5 {
            eprintln!("{case} r {r} b {beta} {text}");
        }
        let _ = at.orbit(beta);
        let t = Instant::now();
        let o = at.orbit(beta);
        times.push(t.elapsed().as_secs_f64() * 1e6);
        let mut run = s.simulation(r, beta).unwrap();
        let mut guard = 0;
        let mut cycle = |run: &mut frictiongen::study::SystemSimulation<'_>, n: u64| {
            let (mut m, mut low, mut stops) = (f64::MIN, f64::MAX, 0);
            let from = run.run().cycles();
            while run.run().cycles() < from + n {
                let s = run.next().unwrap();
                guard += 1;
                if guard > 3000000 {
                    break;
                }
                let z = run.run().relative().0;
                m = m.max(z);
                low = low.min(z);
                if s.event == Some(Event::Stop) {
                    stops += 1;
                }
            }
            (m, low, stops)
        };
        let a = cycle(&mut run, 1000);
        let _ = a;
        let a = cycle(&mut run, 1);
        let b = cycle(&mut run, 1);
        let conv = (a.0 - b.0).abs() + (a.1 - b.1).abs() <= 1e-10 * (a.0.abs() + a.1.abs());
        match o {
            Ok(o) => {
                let amp = b.0.abs().max(b.1.abs());
                let e = (o.contact().amplitude() / amp - 1.0).abs();
                let mult = o.multipliers().iter().map(|m| m.norm()).fold(0.0, f64::max);
                if !conv {
                    noconv += 1;
                    if noconv < 20 {
                        println!(
                            "NOCONV {case} n {n} mu {mu} r {r} b {beta}: orbit {} sim {:?} {:?} stops {} rev {} mult {mult} marg {}",
                            o.contact().amplitude(),
                            a,
                            b,
                            o.stops(),
                            o.reversals(),
                            o.is_marginal()
                        );
                    }
                } else if e > 1e-8 || o.stops() as i64 != b.2 as i64 && !o.is_marginal() {
                    bad += 1;
                    if bad < 20 {
                        println!(
                            "BAD {case} n {n} mu {mu} r {r} b {beta} e {e:.1e}: orbit {} sim {amp} stops {} {} mult {mult} sym {} marg {} regime {:?}\n   {text}",
                            o.contact().amplitude(),
                            o.stops(),
                            b.2,
                            o.is_symmetric(),
                            o.is_marginal(),
                            at.regime(beta)
                        );
                    }
                } else {
                    ok += 1;
                }
            }
            Err(e) => {
                if conv {
                    bad += 1;
                    println!(
                        "ERRCONV {case} n {n} mu {mu} r {r} b {beta} {e:?} sim {a:?} {b:?} {text}"
                    );
                }
                *errs.entry(format!("{e:?} conv {conv}")).or_default() += 1;
            }
        }
    }
    times.sort_by(f64::total_cmp);
    println!(
        "ok {ok} bad {bad} noconv {noconv} errs {errs:?} median {:.1} 90% {:.1} 99% {:.1} max {:.0}",
        times[times.len() / 2],
        times[times.len() * 9 / 10],
        times[times.len() * 99 / 100],
        times[times.len() - 1]
    );
}
