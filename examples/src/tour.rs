//! Leads from a description to regimes, responses and emitted code, and to the steady state that motion from rest
//! reaches. `cargo run --release --example tour`

use frictiongen::{Error, Regime, System, friction_system};
use std::error::Error as StdError;
use std::hint::black_box;
use std::time::Instant;

/// Passes one description to the macro and to a run-time system, and keeps it as a text to print.
macro_rules! both {
    ($(#[doc = $doc:literal])* pub struct $name:ident $fields:tt) => {
        friction_system! { $(#[doc = $doc])* pub struct $name $fields }
        const TEXT: &str = stringify!(pub struct $name $fields);
    };
}

both! {
    /// Two-storey shear frame; a brass disc rubs on the upper floor.
    pub struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [limits, motion, stuck, orbit],
    }
}

const PICTURE: &str = "
      wall                         Two floors on springs; the base moves by Y cos ωt,
      ─┬──                         a disc rubs on the upper floor.
       ▒ friction F, μF
    ┌──┴──┐
    │upper│ 3.25 kg                r = ω√(m₁/k₁)   frequency ratio
    └──┬──┘                        β = F/(k₁Y)     friction ratio
       ⌇ 1323 N/m                  x̄ = x/Y         displacement transmissibility
    ┌──┴──┐
    │lower│ 3.27 kg
    └──┬──┘
       ⌇ 1190 N/m
    ───┴─── base, Y cos ωt
";

fn main() -> Result<(), Box<dyn StdError>> {
    println!("{PICTURE}");
    let [f1, f2] = Frame::NATURAL_FREQUENCIES.map(|omega| omega / std::f64::consts::TAU);
    println!(
        "natural frequencies {f1:.3} Hz and {f2:.3} Hz, at r = {:.4?}\n",
        Frame::RESONANCES
    );
    regimes()?;
    responses()?;
    emitted()?;
    check()
}

/// Prints the boundaries of the three regimes over the frequency ratio.
fn regimes() -> Result<(), Error> {
    println!("Regimes: the closed form exists below β_lim, a stuck state from β*_lim on");
    println!("{:>6} {:>12} {:>12}   at β = 0.3", "r", "β_lim", "β*_lim");
    for r in [0.2, 0.4, 0.628, 0.9, 1.2, 1.684, 2.2] {
        let at = Frame::at(r)?;
        let regime = match at.regime(0.3)? {
            Regime::Continuous => "continuous",
            Regime::StickSlip => "stick-slip",
            Regime::Stuck => "stuck",
            Regime::Bistable => "sliding or stuck",
            _ => "another regime",
        };
        println!(
            "{r:6} {:12.6} {:12.6}   {regime}",
            at.continuous_limit(),
            at.sliding_limit()
        );
    }
    println!();
    Ok(())
}

/// Prints exact amplitudes and lags, with the estimate from one harmonic.
fn responses() -> Result<(), Error> {
    println!("Response at β = 0.1: amplitude x̄ (its estimate from one harmonic) and lag");
    for r in [0.628, 0.9, 1.684] {
        let motion = Frame::at(r)?.motion(0.1)?;
        let (lower, upper) = (motion.lower(), motion.upper());
        println!(
            "r = {r:<5}  lower {:9.5} ({:9.5}) {:+.3} rad   upper {:9.5} ({:9.5}) {:+.3} rad",
            lower.amplitude(),
            lower.amplitude_monoharmonic(),
            lower.phase(),
            upper.amplitude(),
            upper.amplitude_monoharmonic(),
            upper.phase(),
        );
    }
    let stuck = Frame::at(0.9)?.stuck()?.lower();
    println!(
        "with the contact stuck, r = 0.9: lower {:.5}\n",
        stuck.re.hypot(stuck.im)
    );
    Ok(())
}

/// Prints an excerpt of the emitted Rust, and compares results of the emitted code with those of the run-time system.
fn emitted() -> Result<(), Box<dyn StdError>> {
    let limits = frictiongen_codegen::SizeLimits::MACRO;
    let source = frictiongen_codegen::pretty(&frictiongen_codegen::parse_text(TEXT, &limits)?)?;
    let lines: Vec<&str> = source.lines().collect();
    let start = lines
        .iter()
        .position(|line| line.contains("pub fn sliding_limit"))
        .unwrap_or(0);
    println!("Emitted: {} lines of Rust, among them", lines.len());
    for line in lines.iter().skip(start.saturating_sub(4)).take(26) {
        println!("  │ {line}");
    }
    let system: System = TEXT.parse()?;
    let (run_time, compiled) = (
        system.at(0.9)?.continuous_limit(),
        Frame::at(0.9)?.continuous_limit(),
    );
    println!("\nβ_lim(0.9): emitted {compiled}, at run time from the same text {run_time}\n");
    Ok(())
}

/// Compares the closed form with the steady state that motion from rest reaches, and prints the time that both take.
fn check() -> Result<(), Box<dyn StdError>> {
    let (r, beta) = (0.9, 0.3);
    let clock = Instant::now();
    let at = Frame::at(r)?;
    let orbit = at.orbit(beta)?;
    let reached = [orbit.lower().amplitude(), orbit.upper().amplitude()];
    let slow = clock.elapsed();
    let repeats = 10_000;
    let clock = Instant::now();
    let mut exact = [0.0; 2];
    for _ in 0..repeats {
        let motion = Frame::at(black_box(r))?.motion(black_box(beta))?;
        exact = [motion.lower().amplitude(), motion.upper().amplitude()];
        black_box(exact);
    }
    let fast = clock.elapsed() / repeats;
    println!("Check at r = {r}, β = {beta}, by the motion from rest until it repeats");
    let mut worst = 0.0_f64;
    for (name, exact, reached) in [
        ("lower", exact[0], reached[0]),
        ("upper", exact[1], reached[1]),
    ] {
        let apart = (exact - reached).abs();
        println!("  {name}: exact {exact:.9}  reached {reached:.9}  apart {apart:.1e}");
        worst = worst.max(apart);
    }
    println!("  exact {fast:.2?}, from rest {slow:.2?}");
    if worst > 1e-6 {
        return Err(format!("the closed form and the motion from rest differ by {worst:e}").into());
    }
    Ok(())
}
