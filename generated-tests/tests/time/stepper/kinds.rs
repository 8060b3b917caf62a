//! Compares the stepper in random scenes: all contacts and dampings, μ = 1 and above, 1 to 64 masses, both friction
//! laws and both inputs. The plain integrator is the reference for double precision, and double precision for single
//! precision.

use crate::stepper::both::Both;
use crate::stepper::independent::loads;
use crate::stepper::rig::{Kind, LINEAR, advance, begin, rig};
use frictiongen::{NoOrbit, Unsupported};
use frictiongen_kernel::stepper::Input;
use frictiongen_model::scene::{Excitation, Node, Precision, Scene};
use frictiongen_model::transient::excess_loss;
use fuzzing::Random;

/// Returns a random chain with contact and damping. With many masses the damping ratios are below 1.
fn description(random: &mut Random, masses: usize) -> String {
    let names: Vec<String> = (0..masses).map(|i| format!("m{i}")).collect();
    let mut list = Vec::new();
    for name in &names {
        list.push(format!("{name}: {:?}", random.log_uniform(0.3, 3.0)));
    }
    let mut springs = vec![format!("base - m0: {:?}", random.log_uniform(30.0, 300.0))];
    for pair in names.windows(2) {
        springs.push(format!(
            "{} - {}: {:?}",
            pair[0],
            pair[1],
            random.log_uniform(30.0, 300.0)
        ));
    }
    if random.once_in(2) {
        springs.push(format!(
            "{} - wall: {:?}",
            names[masses - 1],
            random.log_uniform(3.0, 30.0)
        ));
    }
    let rubbing = random.below(masses);
    let on_base = random.once_in(2);
    let other = match random.below(3) {
        0 => "wall".to_owned(),
        1 if on_base => "base".to_owned(),
        _ if masses > 1 => names[(rubbing + 1) % masses].clone(),
        _ => "wall".to_owned(),
    };
    let excitation = if on_base {
        "base"
    } else {
        names[random.below(masses)].as_str()
    };
    let damping = match random.below(5) {
        0 => String::new(),
        1 => format!("damping: modal({:?}),", random.power(-4.0, -0.5)),
        2 => {
            let each: Vec<String> = (0..masses)
                .map(|_| {
                    format!(
                        "{:?}",
                        random.power(-3.0, if masses > 8 { -0.1 } else { 0.3 })
                    )
                })
                .collect();
            format!("damping: modal[{}],", each.join(", "))
        }
        3 if masses > 8 => format!("damping: modal({:?}),", random.between(0.3, 0.9)),
        3 => format!("damping: modal({:?}),", random.between(0.8, 1.6)),
        _ => format!(
            "damping: rayleigh({:?}, {:?}),",
            random.unit(),
            0.02 * random.unit()
        ),
    };
    let mu = if random.once_in(3) {
        1.0
    } else {
        random.between(1.0, 2.0)
    };
    format!(
        "struct S {{ masses: {{ {} }}, springs: {{ {} }}, contact: m{rubbing} - {other}, excitation: {excitation},
         {damping} stiction: {mu:?} }}",
        list.join(", "),
        springs.join(", "),
    )
}

fn parsed(text: &str) -> Option<Scene> {
    let system: Result<frictiongen::System, _> = text.parse();
    Some(system.ok()?.scene().clone())
}

/// Numbers of scenes of each kind, and their errors.
#[derive(Debug, Default)]
struct Seen {
    scenes: u32,
    wall: u32,
    base: u32,
    masses: u32,
    moving: u32,
    events: u64,
    otherwise: u32,
    worst: f64,
    single: f64,
    /// Errors of the scenes in single precision.
    singles: Vec<f64>,
    /// Number of scenes that single precision refuses.
    lost: u32,
}

/// Returns true if the model refuses a scene for motion in time because too many modes have critical damping or more.
fn lost(scene: &Scene, precision: Precision) -> bool {
    let scene = Scene {
        precision,
        ..scene.clone()
    };
    excess_loss(&scene).is_some()
}

fn all(sizes: &[usize], rounds: usize, steps: u32) -> Seen {
    let mut random = Random(77);
    let mut seen = Seen::default();
    for round in 0..rounds {
        let text = description(&mut random, sizes[round % sizes.len()]);
        let scene = parsed(&text).unwrap_or_else(|| panic!("{text}"));
        let law: &[[f64; 2]] = match random.below(3) {
            0 => &[[0.05, 0.7], [0.2, 0.8]],
            _ => &[],
        };
        let input = if random.once_in(2) {
            Input::Hold
        } else {
            Input::Linear
        };
        let kind = Kind { input, law };
        let omega = (scene.springs[0].stiffness / scene.masses[0].value).sqrt();
        let dt = random.log_uniform(0.02, 1.0) / omega;
        let single_too = !lost(&scene, Precision::F32);
        seen.lost += u32::from(!single_too);
        if lost(&scene, Precision::F64) {
            continue;
        }
        let mut next = loads(&scene, round as u64, dt);
        let start = next();
        let mut both = Both::new(&scene, kind, dt, &start);
        both.plain.metered = false;
        let mut single = rig::<f32>(&scene, kind, dt);
        begin(&mut single, &start);
        let mut apart = 0.0_f64;
        for _ in 0..steps {
            let load = next();
            both.advance(&load);
            if !single_too {
                continue;
            }
            advance(&mut single, &load);
            for mass in 0..scene.masses.len() {
                let [narrow, wide] = [
                    f64::from(single.mass(mass).displacement()),
                    both.rig.mass(mass).displacement(),
                ];
                apart = apart.max((narrow - wide).abs());
            }
        }
        let ends = [scene.contact.from, scene.contact.to];
        seen.scenes += 1;
        seen.wall += u32::from(ends.contains(&Node::Wall));
        seen.base += u32::from(ends.contains(&Node::Base));
        seen.masses += u32::from(ends.iter().all(|end| matches!(end, Node::Mass(_))));
        seen.moving += u32::from(scene.excitation == Excitation::Base);
        seen.events += both.events;
        seen.otherwise += both.otherwise;
        let (error, apart) = (both.error(), apart / both.size[0]);
        if !(error < seen.worst) {
            println!(
                "{error:.1e}, single {apart:.1e}, {} events: {text}",
                both.events
            );
        }
        seen.worst = generated_tests::larger(seen.worst, error);
        seen.single = generated_tests::larger(seen.single, apart);
        if single_too {
            seen.singles.push(apart);
        }
        assert_eq!(both.rig.exceeded(), 0, "{text}");
    }
    println!("{seen:?}");
    seen
}

fn check(seen: &Seen, bar: f64) {
    let kinds = [seen.wall, seen.base, seen.masses, seen.moving];
    assert!(kinds.iter().all(|count| *count > 1), "{kinds:?}");
    assert!(seen.events > 100 && seen.otherwise == 0);
    assert!(seen.worst < bar, "{:e}", seen.worst);
    // The rounding unit of single precision is 5e8 times as large. In one scene of ten it may miss an event that is
    // barely reached.
    assert!(seen.single < 5e-3, "{:e}", seen.single);
    let mut singles = seen.singles.clone();
    singles.sort_by(f64::total_cmp);
    let most = singles[singles.len() * 9 / 10];
    println!("nine of ten in single precision: {most:.1e}");
    assert!(most < 2e-5, "{most:e}");
}

/// Checks that with damping ratios below 1 the modes of the chain with a stuck contact keep their digits, whatever
/// the number of masses. With damping ratios above 1, pairs of real roots cost up to six digits with 8 masses.
#[test]
fn scenes_at_random() {
    check(&all(&[1, 2, 3, 5, 8], 40, 300), 1e-8);
    check(&all(&[16, 33, 64], 9, 40), 1e-12);
}

#[test]
#[ignore = "minutes"]
fn more_scenes_at_random() {
    check(&all(&[1, 2, 3, 5, 8], 1000, 1000), 1e-8);
    check(&all(&[16, 33, 64], 60, 300), 1e-12);
}

/// Checks scenes of many masses whose modes are all critically damped. The poles of the chain with a stuck contact
/// are then close together between double roots. All functions for motion in time must refuse a scene that would lose
/// half of its digits, with the same error. An accepted scene must keep its digits.
#[test]
fn critical_damping_of_many_masses() {
    let mut refused = Vec::new();
    for n in [8, 16, 32, 64] {
        let masses: Vec<String> = (0..n)
            .map(|i| format!("m{i}: {:?}", 1.0 + 0.3 * f64::from(i * 7 % 5)))
            .collect();
        let mut springs = vec!["base - m0: 100".to_owned()];
        for i in 1..n {
            springs.push(format!("m{} - m{i}: {}", i - 1, 100 - 10 * (i * 3 % 4)));
        }
        let text = format!(
            "struct S {{ masses: {{ {} }}, springs: {{ {} }}, contact: m{} - wall, excitation: m0, damping: modal(1) }}",
            masses.join(", "),
            springs.join(", "),
            n / 2
        );
        let scene = parsed(&text).expect("a scene");
        let dt = 0.02;
        if lost(&scene, Precision::F64) {
            let system = frictiongen::System::try_from(scene).expect("a system");
            let refused_as = Some(Unsupported::CriticalDamping.into());
            assert_eq!(system.stepper(dt).err(), refused_as);
            assert_eq!(system.simulation(0.5, 0.1).err(), refused_as);
            let at = system.at(0.5).expect("within the domain");
            let between = 0.5 * (at.continuous_limit() + at.sliding_limit());
            assert_eq!(
                at.orbit(between).err(),
                refused_as.map(NoOrbit::OutOfDomain)
            );
            refused.push(n);
            continue;
        }
        let mut next = loads(&scene, 3, dt);
        let mut both = Both::new(&scene, LINEAR, dt, &next());
        for _ in 0..60 {
            both.advance(&next());
        }
        println!("{n}: {:.1e}", both.error());
        assert!(both.error() < 1e-8, "{n}: {:e}", both.error());
    }
    assert_eq!(refused, [32, 64]);
}
