//! Random scenes of 1 to 16 masses, over the whole range of r, and beside poles, sub-harmonics and limits.

use crate::asked::{Asked, Of, Place, motion};
use crate::inputs::Exact;
use crate::judge::{Answer, Judge};
use crate::questions::{Questions, first};
use crate::random::{nearness, scene};
use crate::tally::Tally;
use frictiongen::study::System;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use fuzzing::Random;
use generated_tests::data::Data;

/// In roundings of the inputs.
pub const BAR: f64 = 64.0;
const POINTS: u64 = 10;
/// One place in so many has its largest values searched in double-double as well.
const SEARCHED: u64 = 16;
/// Double-double does not search modes faster than this.
const SEARCHABLE: f64 = 1e3;
/// One place in so many has them searched by brute force.
const BY_FORCE: u64 = 8;
/// One place in so many asks for the limit per mode, whose searches are many.
const PER_MODE: u64 = 256;
/// One place in so many asks every mass.
const EVERY_MASS: u64 = 16;
/// Beyond so many roundings of r in an angle of the fastest mode nothing is known of U and S.
const SLOW: f64 = 1e-3;
/// Where so much of V is lost, nothing is known of a motion that counts from the contact's.
const LOST: f64 = 1e-2;
/// Brute force counts the instants of modes up to this many times as fast as the excitation.
const FASTEST: f64 = 60.0;

/// What a scalar's range asks of the test.
pub struct Range {
    /// r is drawn in 2^−this … 2^this.
    exponents: f64,
    /// Masses and springs spread over ten to plus and minus this.
    decades: f64,
}

pub const DOUBLE: Range = Range {
    exponents: 300.0,
    decades: 3.0,
};
/// A chain's far masses move by the r⁻²th power of every link: at f32's precision there is nothing
/// left of them beyond this.
pub const SINGLE: Range = Range {
    exponents: 20.0,
    decades: 1.0,
};

/// A scene under test, and its exact reading.
pub struct Subject<S> {
    pub seed: u64,
    pub system: System<S>,
    pub exact: Exact,
    random: Random,
}

impl<S: Float> Subject<S> {
    /// The scene of a seed; none where it is refused.
    pub fn of(seed: u64, range: &Range) -> Option<Self> {
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x5851_F42D);
        let text = scene(&mut random, range.decades);
        let system = text.parse::<System<S>>().ok()?;
        let exact = Exact::of(&text.parse::<System<Dd>>().ok()?);
        Some(Self {
            seed,
            system,
            exact,
            random,
        })
    }

    /// The next place: r anywhere, or beside a resonance or a fraction of one; β up to the limit or beside it.
    pub fn place(&mut self, range: &Range) -> (S, impl Fn(&mut Self, S) -> Place<S> + use<S>) {
        let random = &mut self.random;
        let resonances = &self.system.modal().resonances;
        let r = if random.unit() < 0.5 {
            random.between(-range.exponents, range.exponents).exp2()
        } else {
            let pole = resonances[random.below(resonances.len())].to_f64();
            let order = match random.below(3) {
                0 => 1.0,
                _ => (1 + random.below(40)) as f64,
            };
            pole / order * (1.0 + nearness(random, S::EPSILON))
        };
        let r = S::constant(r);
        (r, move |subject: &mut Self, limit: S| {
            let random = &mut subject.random;
            let share = match random.below(3) {
                0 => 1.0 - nearness(random, S::EPSILON).abs(),
                1 => random.unit(),
                _ => random.power(-12.0, 0.0),
            };
            Place {
                r,
                beta: limit * S::constant(share),
                tau: S::constant(random.between(0.0, 7.0)),
            }
        })
    }
}

/// What is told at one place, judged.
pub struct Asking<'s, S> {
    subject: &'s Subject<S>,
    point: u64,
    mass: usize,
}

/// Everything that a system tells at one place, or why nothing is asked.
pub fn told<'e, S: Float>(
    asking: &Asking<'e, S>,
    place: &Place<S>,
    exact: impl Fn(S) -> Dd + Copy,
    tally: &mut Tally,
) -> Option<(Judge<'e>, Vec<Answer>)> {
    let Asking {
        subject,
        point,
        mass,
    } = *asking;
    let system = &subject.system;
    let masses = system.scene().masses.len();
    let number = subject.seed.wrapping_add(point);
    let resonances = &system.modal().resonances;
    let fastest = resonances.last().map_or(1.0, |value| value.to_f64()) / place.r.to_f64();
    let searched = number.is_multiple_of(SEARCHED) && fastest < SEARCHABLE;
    let judge = Judge::new(&subject.exact, place.read(exact), S::EPSILON, BAR);
    let at = system.at(place.r).expect("a ratio in the domain");
    let mut questions = Questions::new(&judge, exact, searched, masses);
    if questions.is_reached() {
        questions.sliding(&at);
    } else {
        tally.skip("limits of a contact that the load does not reach");
    }
    let every: Vec<usize> = (0..masses).collect();
    let asked = if number.is_multiple_of(EVERY_MASS) {
        every
    } else {
        vec![mass]
    };
    if !questions.stuck(&at, &asked, masses) {
        tally.skip("a resonance of the stuck chain");
    }
    // In so slow a sweep every angle is below the rounding of r: U and S may be anything.
    let zero = S::constant(0.0);
    let (continuous, without) = (at.continuous_limit(), at.continuous_limit_without_search());
    let nearly = S::constant(1.0 + BAR * S::EPSILON);
    let sane = zero <= continuous && continuous <= without * nearly;
    assert!(
        sane,
        "{continuous:?} above {without:?} at {place:?}, seed {}",
        subject.seed
    );
    if fastest * S::EPSILON > SLOW {
        tally.skip("angles below the rounding of r");
    } else {
        let found = rounded_data(system).at(place.r).velocity_constraint();
        if questions.is_reached() {
            questions.limits(&at, first(&found), number.is_multiple_of(PER_MODE));
        }
        match at.motion(place.beta) {
            // Only rounding is left of V.
            _ if questions.faint() * S::EPSILON > LOST => {
                tally.skip("a contact that the load does not reach to rounding");
            }
            Ok(motion) => {
                questions.contact(&motion, place.tau);
                let reduced = system.modal();
                // The mass that rubs on the wall moves as the contact does.
                let rubs =
                    |mass: &usize| !reduced.on_moving_base && reduced.contact == (*mass, None);
                let asked: Vec<usize> = asked.into_iter().filter(|mass| !rubs(mass)).collect();
                questions.masses(&motion, &asked, masses, place.tau);
            }
            Err(error) => tally.skip(refused(error)),
        }
        let forced = number.is_multiple_of(BY_FORCE);
        if forced && fastest < FASTEST {
            by_force(&judge, &mut questions.told, fastest, place);
        } else if forced {
            tally.skip("brute force among fast modes");
        }
    }
    for _ in 0..questions.given_up {
        tally.skip("a search for an amplitude that gave up");
    }
    for _ in 0..questions.unreached {
        tally.skip("a mass that the load does not reach while the contact is stuck");
    }
    let told = questions.told;
    Some((judge, told))
}

fn refused(error: frictiongen::NotContinuous) -> &'static str {
    use frictiongen::NotContinuous;
    match error {
        NotContinuous::StickSlip => "not continuous: stick-slip",
        NotContinuous::Stuck => "not continuous: stuck",
        NotContinuous::Unbounded => "not continuous: unbounded",
        _ => "not continuous: out of the domain",
    }
}

fn rounded_data<S: Float>(system: &System<S>) -> Data<S> {
    let rounded = |value: Dd| S::constant(value.hi) + S::constant(value.lo);
    Data {
        reduced: system.modal().reduced(rounded),
    }
}

/// Looks for larger values at instants all over the half period, and has answers judged by those: in double precision
/// first, then closer in double-double.  The code under test searches with the same bounds in double-double: what it has
/// found itself must be the largest.
fn by_force<S: Float>(judge: &Judge<'_>, told: &mut [Answer], fastest: f64, place: &Place<S>) {
    let instants = 64 + (12.0 * fastest) as u32;
    let largest = |rough: &dyn Fn(f64) -> f64, of: &dyn Fn(Dd) -> Dd| {
        let step = std::f64::consts::PI / f64::from(instants);
        let instant = |i: u32| step * (f64::from(i) - 0.5);
        let all = (1..=instants).map(|i| (rough(instant(i)), instant(i)));
        let higher = |best: (f64, f64), one: (f64, f64)| if best.0 < one.0 { one } else { best };
        let mut about = Dd::from(all.fold((0.0, 0.0), higher).1);
        let mut value = of(about);
        // Closer about the highest, by halves of the step.
        let mut width = Dd::from(step);
        for _ in 0..24 {
            width = width * Dd::from(0.5);
            for tau in [about - width, about + width] {
                if Dd::from(0.0) < tau && tau < Dd::PI {
                    let there = of(tau);
                    if value < there {
                        (value, about) = (there, tau);
                    }
                }
            }
        }
        (value, about)
    };
    let plain = judge.data().read(|value| value.to_f64());
    let rough = plain.at(judge.place().r.to_f64());
    let beta = judge.place().beta.to_f64();
    let of_mass = |mass: usize| {
        let (exact, rough) = (
            motion(judge.at(), Of::Mass(mass), judge.place().beta),
            motion(&rough, Of::Mass(mass), beta),
        );
        let found = largest(&|tau| rough.displacement(tau).abs(), &|tau| {
            exact.displacement(tau).abs()
        });
        (exact, found)
    };
    let room = Dd::from(BAR * S::EPSILON);
    for answer in told {
        let asked = answer.watched.asked;
        let (known, size, (found, tau)) = match asked {
            Asked::ContinuousLimit => {
                let inverse = Dd::from(1.0) / judge.exact(&[answer.watched])[0].re;
                let by = |tau| Dd::from(1.0) / judge.at().continuous_limit_by(tau);
                let roughly = |tau| 1.0 / rough.continuous_limit_by(tau);
                (inverse, inverse, largest(&roughly, &by))
            }
            Asked::Amplitude(Of::Mass(mass)) => {
                let known = judge.exact(&[answer.watched])[0].re;
                (known, answer.size, of_mass(mass).1)
            }
            Asked::Height(mass) => {
                let (motion, found) = of_mass(mass);
                let instant = answer.watched.instant.unwrap_or(Dd::from(0.0));
                (motion.displacement(instant).abs(), answer.size, found)
            }
            _ => continue,
        };
        if found > known + size * room {
            assert!(
                !answer.searched,
                "{asked:?} at {place:?}: {found:?} is larger than {known:?}"
            );
            answer.watched.instant = Some(tau);
        }
    }
}

/// One scene at its places.
fn check<S: Float>(seed: u64, range: &Range, exact: impl Fn(S) -> Dd + Copy, tally: &mut Tally) {
    let Some(mut subject) = Subject::<S>::of(seed, range) else {
        tally.skip("a scene that is refused");
        return;
    };
    tally.scenes += 1;
    for point in 0..POINTS {
        let (r, at_limit) = subject.place(range);
        let at = subject.system.at(r).expect("a ratio in the domain");
        let limit = at.continuous_limit().min(at.sliding_limit());
        let place = at_limit(&mut subject, limit);
        let masses = subject.system.scene().masses.len();
        let mass = subject.random.below(masses);
        let asking = Asking {
            subject: &subject,
            point,
            mass,
        };
        let Some((judge, told)) = told(&asking, &place, exact, tally) else {
            continue;
        };
        let verdict = judge.verdict(&told);
        tally.note(&told, &verdict, BAR, || format!("seed {seed}: {place:?}"));
    }
}

fn run<S: Float>(scenes: &[u64], range: &Range, exact: impl Fn(S) -> Dd + Copy + Sync) -> Tally {
    let half = |parity: usize| {
        let mut tally = Tally::default();
        for seed in scenes.iter().skip(parity).step_by(2) {
            check(*seed, range, exact, &mut tally);
        }
        tally
    };
    std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        let mut tally = half(0);
        tally.join(other.join().expect("no panic"));
        tally
    })
}

/// The kinds of answers of a run of some length.
const KINDS: usize = 17;
/// What a run may have of each, as shares of its places.
struct Shares {
    /// Above the bar: stuck responses that are differences of larger free ones, and conditions about the largest at
    /// which all answers must agree.
    above: f64,
    /// Without a displacement in common, all of them with a condition above 100.
    disagreeing: f64,
    /// Wrong altogether: where the contact's force is known to no digit, in double-double neither, and where r within a
    /// rounding of a resonance decides whether the contact moves.
    wrong: f64,
}
/// Of a hundred places one is more than of thousands.
const FEW: Shares = Shares {
    above: 0.0,
    disagreeing: 0.04,
    wrong: 0.0,
};
const MANY: Shares = Shares {
    above: 0.01,
    disagreeing: 0.02,
    wrong: 1e-3,
};

/// What a run has to keep.
fn report(title: &str, tally: &Tally, most: &Shares) {
    tally.print(title);
    // The limit per mode is asked for at few places.
    assert!(KINDS - 1 <= tally.counts().count(), "a kind is missing");
    let [above, disagreeing, wrong] = tally.shares();
    assert!(
        wrong <= most.wrong,
        "{wrong} of all places are wrong altogether"
    );
    assert!(
        above <= most.above,
        "{above} of all places are above the bar"
    );
    assert!(
        disagreeing <= most.disagreeing,
        "{disagreeing} of all places disagree"
    );
}

fn double(scenes: std::ops::Range<u64>, most: &Shares) {
    let scenes: Vec<u64> = scenes.collect();
    report("f64", &run::<f64>(&scenes, &DOUBLE, Dd::from), most);
}

fn single(scenes: std::ops::Range<u64>, most: &Shares) {
    let exact = |value: f32| Dd::from(f64::from(value));
    let scenes: Vec<u64> = scenes.collect();
    report("f32", &run::<f32>(&scenes, &SINGLE, exact), most);
}

#[test]
fn double_precision() {
    double(0..12, &FEW);
}

#[test]
fn single_precision() {
    single(0..12, &FEW);
}

/// The scenes of SCENES: a number of them, or `from..to`.
pub fn asked() -> std::ops::Range<u64> {
    let text = std::env::var("SCENES").unwrap_or_else(|_| "10000".to_owned());
    let (from, to) = text.split_once("..").unwrap_or(("0", &text));
    let number = |text: &str| text.parse().expect("SCENES=100 or SCENES=100..200");
    number(from)..number(to)
}

/// `SCENES=100000 cargo test --release -p generated-tests --test backward long_double -- --ignored
/// --nocapture`
#[test]
#[ignore = "takes long; the scenes are SCENES"]
fn long_double() {
    double(asked(), &MANY);
}

/// The same in single precision.
#[test]
#[ignore = "takes long; the scenes are SCENES"]
fn long_single() {
    single(asked(), &MANY);
}
