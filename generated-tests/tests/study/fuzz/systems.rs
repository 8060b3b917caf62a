//! Tests run-time systems of random scenes: by the functions that emitted scenes have, by simulations, by steady
//! states with stops, and by derivatives.

use crate::fuzz::functions::{Asked, Seen, answered, is_number, promise, question};
use crate::fuzz::{long, moving, none, once_in};
use frictiongen::kernel::Plain;
use frictiongen::study::sensitivity::Sensitive;
use frictiongen::{FrictionSystem, System};
use fuzzing::{Random, bits};

/// A scene, with the arguments of the calls.
#[derive(Debug)]
struct Question {
    text: String,
    single: bool,
    asked: Vec<Asked>,
    /// True if the test also makes the expensive calls: simulation, steady state, derivatives.
    dear: bool,
}

/// Number of calls for each scene. It is more than one, because building a scene takes longer than a call.
const QUESTIONS: usize = 16;

/// Returns a valid scene of up to four masses, whose numbers cover several decades.
fn scene(random: &mut Random) -> String {
    let masses = 1 + random.below(4);
    let size = |random: &mut Random| {
        let decades = if random.once_in(8) { 12.0 } else { 2.0 };
        format!("{:e}", 10_f64.powf((random.unit() - 0.5) * decades))
    };
    let bodies: Vec<String> = (0..masses)
        .map(|mass| format!("m{mass}: {}", size(random)))
        .collect();
    let mut springs = vec![format!("base - m0: {}", size(random))];
    for mass in 1..masses {
        springs.push(format!("m{} - m{mass}: {}", mass - 1, size(random)));
    }
    if random.once_in(3) {
        springs.push(format!("m{} - wall: {}", masses - 1, size(random)));
    }
    let rubs = random.below(masses);
    let other = random.below(masses);
    let contact = match random.below(3) {
        0 if other != rubs => format!("m{rubs} - m{other}"),
        1 => format!("m{rubs} - base"),
        _ => format!("m{rubs} - wall"),
    };
    let excitation = match random.below(2) {
        0 => "base".to_owned(),
        _ => format!("m{}", random.below(masses)),
    };
    let damping = match random.below(5) {
        0 => "none".to_owned(),
        1 => "modal(1)".to_owned(),
        2 => format!("modal({:e})", 10_f64.powf(-random.unit() * 30.0)),
        3 => format!("rayleigh({}, {})", random.unit() * 0.2, random.unit() * 0.2),
        _ => format!("modal({})", random.unit() * 3.0),
    };
    let stiction = 1.0 + random.below(3) as f64 * random.unit();
    format!(
        "struct R {{ masses: {{ {} }}, springs: {{ {} }}, contact: {contact}, excitation: {excitation}, \
         damping: {damping}, stiction: {stiction} }}",
        bodies.join(", "),
        springs.join(", "),
    )
}

fn holds<S: Plain>(question: &Question, seen: &Seen) -> Result<(), String> {
    // Some random scenes are invalid, because two springs join the same pair of nodes.
    let Ok(system) = question.text.parse::<System<S>>() else {
        seen.note("no: scene refused");
        return Ok(());
    };
    seen.note("scenes");
    for asked in &question.asked {
        answered(&system, asked, seen).map_err(|problem| format!("{asked:?}: {problem}"))?;
    }
    match question.asked.first() {
        Some(asked) if question.dear => {
            dear(&system, asked, seen).map_err(|problem| format!("{asked:?}: {problem}"))
        }
        _ => Ok(()),
    }
}

fn dear<S: Plain>(system: &System<S>, asked: &Asked, seen: &Seen) -> Result<(), String> {
    let (r, masses) = (S::constant(asked.r), system.masses());
    let Ok(at) = system.at(r) else {
        seen.note("no run and no orbit: r refused");
        return Ok(());
    };
    let beta = asked.beta(at.continuous_limit(), at.sliding_limit());
    if let Ok(mut run) = system.simulation(r, beta) {
        let most = S::pi() + S::pi();
        for _ in 0..24 {
            let length = run.advance(most).expect("a reach").length;
            promise(S::constant(0.0) <= length && length <= most, || {
                format!("a segment of {length:?}")
            })?;
            let (z, velocity) = run.run().relative();
            promise(is_number(z) && is_number(velocity), || {
                "a run of NaN".to_owned()
            })?;
        }
        seen.note("runs");
    } else {
        seen.note("no run: r or β refused");
    }
    let orbit = at.orbit(beta);
    seen.orbit(&orbit);
    if let Ok(orbit) = orbit {
        moving::orbit(&orbit, masses, S::constant(asked.tau), asked.order % 12)?;
    }
    // Derivatives exist where the functions are smooth, but not at the limits of their regimes. Their computation
    // must not panic anywhere.
    let slopes = system.sensitivities(|varied| {
        let at = varied.at(Sensitive::fixed(asked.r.into()))?;
        Ok::<_, frictiongen::OutOfDomain>(at.continuous_limit() + at.sliding_limit())
    });
    seen.note(match slopes {
        Ok(_) => "derivatives",
        Err(_) => "no derivatives",
    });
    Ok(())
}

fn fuzz(count: u64, seed: u64, often: u64) {
    let mut random = Random(seed);
    let mut number = 0_u64;
    let next = || {
        number += 1;
        let single = random.once_in(2);
        let landmarks = [0.1, 0.5, 1.0, 2.0];
        let asked = (0..QUESTIONS)
            .map(|_| {
                question(&mut random, 0, &landmarks, |random, marks| {
                    if single {
                        f64::from(bits::single(random, marks))
                    } else {
                        bits::double(random, marks)
                    }
                })
            })
            .collect();
        Question {
            text: scene(&mut random),
            single,
            asked,
            dear: once_in(often, number),
        }
    };
    let seen = Seen::default();
    let findings = fuzzing::run(count.div_ceil(QUESTIONS as u64), next, |question| {
        if question.single {
            holds::<f32>(question, &seen)
        } else {
            holds::<f64>(question, &seen)
        }
    });
    let dear = findings.count / often;
    println!(
        "random systems: {QUESTIONS} questions each, {dear} scenes asked for runs, orbits and derivatives"
    );
    none("random systems", &findings);
    let of_all = ["scenes", "limits", "motions"].map(|what| (what, 2));
    let of_dear = ["runs", "orbits", "derivatives"].map(|what| (what, 4 * often));
    seen.report(findings.count, &[of_all, of_dear].concat());
}

#[test]
fn random_systems_answer_by_numbers() {
    fuzz(800, 21, 4);
}

#[test]
#[ignore = "a million questions to random systems: minutes"]
fn a_million_questions_to_systems() {
    fuzz(long(), 22, 4);
}
