//! Tests emitted functions for arbitrary bits of r, β, τ and n.

use crate::fuzz::{long, none};
use frictiongen::kernel::Float;
use frictiongen::{
    ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, NoOrbit, NotContinuous, Of, Regime,
    Steady, StuckAt,
};
use fuzzing::{Random, bits};
use generated_tests::scenes::{Visitor, visit};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Scenes with more kinds of damping, on every contact. The scenes of `reference/closed_form.json` have light and
/// heavy damping.
mod beside {
    macro_rules! both {
        ($($double:ident $single:ident { $($body:tt)* })*) => {
            $(::frictiongen::friction_system! {
                pub struct $double { $($body)* provide: [limits, motion, stuck], }
            }
            ::frictiongen::friction_system! {
                pub struct $single { $($body)* provide: [limits, motion, stuck], scalar: f32, }
            })*
            pub fn visit(visitor: &mut impl super::Visitor) {
                $(visitor.see(stringify!($double), $double);
                visitor.see(stringify!($single), $single);)*
            }
        };
    }
    both! {
        Critical CriticalF32 {
            masses: { a: 1.0, b: 0.7 }, springs: { base - a: 1.0, a - b: 1.3 },
            contact: b - wall, excitation: base, damping: modal(1.0),
        }
        Mixed MixedF32 {
            masses: { a: 1.0, b: 0.7, c: 2.0 }, springs: { base - a: 1.0, a - b: 1.3, b - c: 0.5 },
            contact: a - c, excitation: b, damping: modal[0.0, 1.0, 3.0], stiction: 1.4,
        }
        Over OverF32 {
            masses: { a: 1.0 }, springs: { base - a: 1.0 },
            contact: a - base, excitation: base, damping: modal(20.0),
        }
        Faint FaintF32 {
            masses: { a: 1.0, b: 1.0 }, springs: { base - a: 1.0, a - b: 1.0 },
            contact: b - wall, excitation: a, damping: modal(1e-30),
        }
        Spread SpreadF32 {
            masses: { a: 1.0, b: 1e-6 }, springs: { base - a: 1.0, a - b: 1e5 },
            contact: b - base, excitation: base,
        }
    }
}

/// Arguments with which the test calls the functions of a scene.
#[derive(Debug)]
pub struct Asked {
    scene: usize,
    pub r: f64,
    beta: f64,
    /// Selects the limit of which `beta` is a multiple: true for β_lim, false for β*_lim. `None` if `beta` is the
    /// ratio itself.
    of_limit: Option<bool>,
    pub tau: f64,
    mass: usize,
    pub order: u32,
}

impl Asked {
    /// Returns the friction ratio β, from the limits β_lim (`continuous`) and β*_lim (`sliding`) of the scene.
    pub fn beta<S: Float>(&self, continuous: S, sliding: S) -> S {
        match self.of_limit {
            Some(true) => continuous * S::constant(self.beta),
            Some(false) => sliding * S::constant(self.beta),
            None => S::constant(self.beta),
        }
    }
}

/// Number of checks of each kind, and number of omitted checks with the reason.
#[derive(Default)]
pub struct Seen(RefCell<BTreeMap<&'static str, u64>>);

impl Seen {
    pub fn note(&self, what: &'static str) {
        *self.0.borrow_mut().entry(what).or_insert(0) += 1;
    }

    /// Counts a steady state, or the reason why it does not exist.
    pub fn orbit<O>(&self, orbit: &Result<O, NoOrbit>) {
        self.note(match orbit {
            Ok(_) => "orbits",
            Err(NoOrbit::OutOfDomain(_)) => "no orbit: r or β refused",
            Err(NoOrbit::TooManyEvents) => "no orbit: too many events",
            Err(NoOrbit::Unbounded) => "no orbit: unbounded",
            Err(NoOrbit::Undamped(_)) => "no orbit: undamped",
            Err(NoOrbit::Unstable) => "no orbit: unstable",
            Err(_) => "no orbit: unsettled",
        });
    }

    /// Prints the counts. Each item of `needed` must occur at least once in this number of inputs.
    pub fn report(&self, count: u64, needed: &[(&str, u64)]) {
        let seen = self.0.borrow();
        println!("of {count} inputs: {seen:?}");
        for (what, often) in needed {
            let found = seen.get(what).copied().unwrap_or(0);
            assert!(found * often >= count, "{what}: {found} of {count} inputs");
        }
    }
}

/// A scene whose scalar type is not yet chosen.
type Scene = (
    &'static str,
    Vec<f64>,
    bool,
    Box<dyn Fn(&Asked, &Seen) -> Result<(), String>>,
);

struct Scenes(Vec<Scene>);

impl Visitor for Scenes {
    fn see<F>(&mut self, name: &'static str, system: F)
    where
        F: FrictionSystem + 'static,
        for<'a> F::At<'a>: MotionAt<Scalar = F::Scalar> + StuckAt<Scalar = F::Scalar>,
    {
        let resonances = system.resonances().iter().map(|r| r.to_f64()).collect();
        let single = F::Scalar::EPSILON > 1e-10;
        let check = move |asked: &Asked, seen: &Seen| {
            answered(&system, asked, seen).map_err(|problem| format!("{name}: {problem}"))
        };
        self.0.push((name, resonances, single, Box::new(check)));
    }
}

/// Returns `true` unless the value is NaN.
pub fn is_number<S: Float>(value: S) -> bool {
    !value.to_f64().is_nan()
}

pub fn promise(holds: bool, what: impl FnOnce() -> String) -> Result<(), String> {
    if holds { Ok(()) } else { Err(what()) }
}

pub fn answered<F: FrictionSystem>(system: &F, asked: &Asked, seen: &Seen) -> Result<(), String>
where
    for<'a> F::At<'a>: MotionAt<Scalar = F::Scalar> + StuckAt<Scalar = F::Scalar>,
{
    let c = <F::Scalar as frictiongen::kernel::Scalar>::constant;
    let (zero, r) = (c(0.0), c(asked.r));
    let at = match system.at(r) {
        Ok(at) => at,
        Err(_) => {
            seen.note("no: r refused");
            return promise(!(zero <= r), || "refused a ratio".to_owned());
        }
    };
    promise(zero <= r, || "took what is no ratio".to_owned())?;
    let (continuous, sliding) = (at.continuous_limit(), at.sliding_limit());
    let (without, per_mode) = (
        at.continuous_limit_without_search(),
        at.continuous_limit_per_mode(),
    );
    for limit in [continuous, sliding, without, per_mode] {
        promise(zero <= limit, || {
            format!("limits {continuous:?} {sliding:?} {without:?} {per_mode:?}")
        })?;
    }
    promise(continuous <= without, || {
        format!("{continuous:?} is above {without:?}")
    })?;
    seen.note("limits");
    let beta = asked.beta(continuous, sliding);
    let may = zero <= beta && beta.is_finite();
    match (at.regime(beta), at.margin(beta)) {
        (Ok(regime), Ok(margin)) => {
            promise(may, || format!("took β = {beta:?}"))?;
            promise(margin >= c(-1.0), || {
                format!("margin {margin:?} at β = {beta:?}")
            })?;
            promise(!(margin < zero) || regime == Regime::Continuous, || {
                format!("margin {margin:?}, {regime:?} at β = {beta:?}")
            })?;
            let instead = at.motion(beta).err();
            let agree = match instead {
                None | Some(NotContinuous::Unbounded) => {
                    matches!(regime, Regime::Continuous | Regime::Bistable)
                }
                Some(NotContinuous::StickSlip) => regime == Regime::StickSlip,
                Some(NotContinuous::Stuck) => regime == Regime::Stuck,
                Some(_) => false,
            };
            promise(agree, || {
                format!(
                    "{regime:?} but {instead:?} at β = {beta:?}, limits {continuous:?} {sliding:?}"
                )
            })?;
            seen.note(match instead {
                None => "motions",
                Some(NotContinuous::Unbounded) => "no motion: unbounded",
                Some(NotContinuous::StickSlip) => "no motion: stick-slip",
                Some(_) => "no motion: stuck",
            });
        }
        (Err(_), Err(_)) => {
            seen.note("no motion: β refused");
            promise(!may, || format!("refused β = {beta:?}"))?;
        }
        _ => return Err(format!("regime and margin disagree on β = {beta:?}")),
    }
    if let Ok(motion) = at.motion(beta) {
        for of in [Of::Contact, Of::Mass(asked.mass % system.masses())] {
            motion
                .ask(of, |motion| moves(motion, asked, seen))
                .ok_or("no such motion")?
                .map_err(|problem| format!("{of:?} at β = {beta:?}: {problem}"))?;
        }
    }
    if let Ok(stuck) = at.stuck_mass(asked.mass % system.masses()) {
        let held = stuck.ok_or("no such mass")?;
        promise(is_number(held.re) && is_number(held.im), || {
            format!("stuck {held:?}")
        })?;
        seen.note("stuck responses");
    } else {
        seen.note("no stuck response");
    }
    Ok(())
}

fn moves<S: Float>(
    motion: &dyn Steady<Scalar = S>,
    asked: &Asked,
    seen: &Seen,
) -> Result<(), String> {
    let zero = S::constant(0.0);
    let (amplitude, estimate) = (motion.amplitude(), motion.amplitude_monoharmonic());
    promise(zero <= amplitude, || format!("amplitude {amplitude:?}"))?;
    promise(zero <= estimate, || format!("estimate {estimate:?}"))?;
    let phase = motion.phase();
    promise(-S::pi() < phase && phase <= S::pi(), || {
        format!("phase {phase:?}")
    })?;
    let harmonic = motion.harmonic(asked.order);
    promise(is_number(harmonic.re) && is_number(harmonic.im), || {
        format!("harmonic {harmonic:?}")
    })?;
    let tau = S::constant(asked.tau);
    if tau.is_finite() {
        let (x, v) = (motion.displacement(tau), motion.velocity(tau));
        promise(is_number(x) && is_number(v), || {
            format!("displacement {x:?}, velocity {v:?}")
        })?;
        seen.note("instants");
    } else {
        seen.note("no instant: τ infinite");
    }
    Ok(())
}

/// Returns random arguments for the functions of a scene. `number` returns random numbers, of which many are near
/// special values.
pub fn question(
    random: &mut Random,
    scene: usize,
    resonances: &[f64],
    number: impl Fn(&mut Random, &[f64]) -> f64,
) -> Asked {
    let r = number(random, resonances);
    let mut beta = number(random, &[0.1, 1.0]);
    let tau = number(random, &[std::f64::consts::PI]);
    let of_limit = (!random.once_in(3)).then(|| random.once_in(2));
    if of_limit.is_some() {
        beta = if random.once_in(2) {
            bits::double(random, &[1.0])
        } else {
            random.unit()
        };
    }
    let order = if random.once_in(4) {
        random.bits() as u32
    } else {
        random.below(12) as u32
    };
    Asked {
        scene,
        r,
        beta,
        of_limit,
        tau,
        mass: random.below(64),
        order,
    }
}

fn fuzz(count: u64, seed: u64) {
    let mut scenes = Scenes(Vec::new());
    visit(&mut scenes);
    beside::visit(&mut scenes);
    let scenes = scenes.0;
    let mut random = Random(seed);
    let next = || {
        let scene = random.below(scenes.len());
        let (_, resonances, single, _) = &scenes[scene];
        let single = *single;
        question(&mut random, scene, resonances, |random, landmarks| {
            if single {
                f64::from(bits::single(random, landmarks))
            } else {
                bits::double(random, landmarks)
            }
        })
    };
    let seen = Seen::default();
    let findings = fuzzing::run(count, next, |asked| scenes[asked.scene].3(asked, &seen));
    none("functions", &findings);
    let needed = ["limits", "motions", "stuck responses", "instants"];
    seen.report(findings.count, &needed.map(|what| (what, 4)));
}

#[test]
fn numbers_are_answered_by_numbers() {
    fuzz(2_000, 5);
}

#[test]
#[ignore = "a million points: minutes"]
fn a_million_points() {
    fuzz(long(), 6);
}
