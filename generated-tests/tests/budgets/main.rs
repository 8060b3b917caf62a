mod big;
mod blocks;
mod cases;
mod draw;
mod elementary;
mod measure;
mod modes;

#[test]
#[ignore]
fn trial() {
    use std::time::Instant;
    let n: u64 = std::env::var("POINTS").ok().and_then(|n| n.parse().ok()).unwrap_or(20000);
    for case in cases::all() {
        let mut s = draw::Source(7);
        let clock = Instant::now();
        let mut worst = [(0.0, [frictiongen_kernel::dd::Dd::ZERO; 3]); 5];
        let n = if case.scalar == "Dd" { n / 20 } else { n };
        for _ in 0..n {
            let a = (case.draw)(&case.domain, &mut s);
            for (w, e) in worst.iter_mut().zip((case.error)(&a)) {
                if e > w.0 { *w = (e, a); }
            }
        }
        let us = clock.elapsed().as_secs_f64() / n as f64 * 1e6;
        for (f, w) in case.fields.iter().zip(worst) {
            println!("{:3} {} {f}: {:.3} at {:e} {:e} {:e}  ({us:.2} us)", case.scalar, case.function, w.0, w.1[0].hi, w.1[1].hi, w.1[2].hi);
        }
    }
}
