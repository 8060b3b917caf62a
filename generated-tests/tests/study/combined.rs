//! Relative displacements, spring forces and the base shear, against the motions of the masses and Newton's law.

use crate::answers::frames::frame;
use frictiongen::study::response::{MotionQuantity, SystemResponse};
use frictiongen::study::scene::{Node, Spring};
use frictiongen::{Of, System};
use std::f64::consts::TAU;

/// A combination, with its coefficients of the masses and of the base.
type Terms = (Of, Vec<(usize, f64)>, f64);

/// All combinations of a system, each with its coefficients of the masses and of the base.
fn combinations(system: &System) -> Vec<Terms> {
    let scene = system.scene();
    let masses = scene.masses.len();
    let first = scene.springs[0].stiffness;
    let mut all = Vec::new();
    for a in 0..masses {
        all.push((Of::FromBase(a), vec![(a, 1.0)], -1.0));
        for b in (0..masses).filter(|b| *b != a) {
            all.push((Of::Relative(a, b), vec![(a, 1.0), (b, -1.0)], 0.0));
        }
    }
    let force = |spring: &Spring| {
        let mut terms = (Vec::new(), 0.0);
        for (node, sign) in [(spring.to, 1.0), (spring.from, -1.0)] {
            match node {
                Node::Mass(index) => terms.0.push((index, sign * spring.stiffness / first)),
                Node::Base => terms.1 += sign * spring.stiffness / first,
                Node::Wall => {}
            }
        }
        terms
    };
    let mut shear = (Vec::new(), 0.0);
    for (index, spring) in scene.springs.iter().enumerate() {
        let (terms, base) = force(spring);
        if base != 0.0 {
            // The shear counts the displacement of the mass positive, in whatever order the spring is written.
            let sign = if spring.from == Node::Base { 1.0 } else { -1.0 };
            shear
                .0
                .extend(terms.iter().map(|(mass, factor)| (*mass, sign * factor)));
            shear.1 += sign * base;
        }
        all.push((Of::Spring(index), terms, base));
    }
    all.push((Of::Shear, shear.0, shear.1));
    all
}

/// Number of samples of a cycle.
const SAMPLES: u32 = 400;

/// Compares every combination with sums of the masses' motions, in every regime.
#[test]
fn sums_of_masses_in_every_regime() {
    let mut seen = [0; 3];
    for (masses, index) in [(1, 1), (2, 4), (2, 3), (3, 5), (3, 8), (4, 6), (5, 7)] {
        let frame = frame(masses, index);
        let system = &frame.system;
        let moves = f64::from(u8::from(
            system.scene().excitation == frictiongen::study::scene::Excitation::Base,
        ));
        let masses: Vec<Of> = (0..masses).map(Of::Mass).collect();
        for share in [0.2, 0.8, 1.3] {
            for place in [0.15, 0.4, 0.75] {
                let r = frame.band[0] + place * (frame.band[1] - frame.band[0]);
                let at = system.at(r).expect("in the domain");
                let beta = share * at.sliding_limit();
                let Ok(response) = at.response(beta) else {
                    continue;
                };
                let Ok(known) = response.history(&masses, SAMPLES) else {
                    continue;
                };
                seen[match response {
                    SystemResponse::Continuous(_) => 0,
                    SystemResponse::StickSlip(_) => 1,
                    SystemResponse::Stuck(_) => 2,
                }] += 1;
                for (of, terms, base) in combinations(system) {
                    let label = format!("{} {of:?} r = {r}, β = {beta}", frame.text);
                    compare(&response, &known, (of, &terms, base * moves), &label);
                }
            }
        }
    }
    println!("continuous, stick-slip, stuck: {seen:?}");
    assert!(seen.iter().all(|count| *count > 3), "{seen:?}");
}

fn compare(
    response: &SystemResponse<'_>,
    known: &frictiongen::study::history::History,
    (of, terms, base): (Of, &[(usize, f64)], f64),
    label: &str,
) {
    let own = response.history(&[of], SAMPLES).expect("a history");
    let track = &own.tracks[0];
    let mut largest = 0.0_f64;
    let mut size = base.abs();
    for index in 0..known.len() {
        let tau = known.tau(index);
        let (mut x, mut v) = (base * tau.cos(), -base * tau.sin());
        for (mass, factor) in terms {
            x += factor * known.tracks[*mass].displacement[index];
            v += factor * known.tracks[*mass].velocity[index];
            size = size.max((factor * known.tracks[*mass].displacement[index]).abs());
        }
        // The sums cancel, so that an error is compared with their largest term.
        let error = (track.displacement[index] - x).abs();
        assert!(
            error <= 1e-11 * size.max(1.0),
            "{label}: {x}, off by {error}"
        );
        let error = (track.velocity[index] - v).abs();
        assert!(
            error <= 1e-10 * size.max(1.0),
            "{label}: velocity {v}, off by {error}"
        );
        largest = largest.max(x.abs());
    }
    let swing = response.swing(of).expect("a motion");
    let accelerations = response
        .largest(of, MotionQuantity::Acceleration)
        .expect("a motion");
    // Between two samples a motion exceeds them by at most a parabola of half a step. A stuck chain's acceleration is
    // that of its centred motion.
    let step = 0.5 * TAU / f64::from(SAMPLES);
    let above = 0.5 * accelerations * step * step;
    assert!(
        largest - 1e-11 * size.max(1.0) <= swing.amplitude
            && swing.amplitude <= largest + above + 1e-11 * size.max(1.0),
        "{label}: amplitude {} beside {largest}",
        swing.amplitude
    );
    let cycles = u64::from(known.cycles);
    for n in [1, 3] {
        let mut sum = frictiongen::Complex::new(if n == 1 { base } else { 0.0 }, 0.0);
        for (mass, factor) in terms {
            let harmonic = response.harmonic(Of::Mass(*mass), n).expect("a mass");
            sum += harmonic * *factor;
        }
        let own = response.harmonic(of, n).expect("a motion");
        let error = (own - sum).norm();
        assert!(
            error <= 1e-10 * size.max(1.0),
            "{label}: X_{n}, off by {error}, {cycles} cycles"
        );
    }
}

/// Newton's law for the whole chain: the base shear is the load minus the inertia of all masses. The chain has no
/// damping, no spring to a wall, and its contact is between two masses.
#[test]
fn the_base_shear_carries_the_load() {
    for load in ["base", "top"] {
        let system: System = format!(
            "struct Chain {{ masses: {{ low: 2, mid: 1.5, top: 1 }}, contact: low - mid, excitation: {load},
             springs: {{ base - low: 900, low - mid: 1300, base - mid: 200, mid - top: 500 }} }}"
        )
        .parse()
        .expect("a scene");
        let scene = system.scene();
        let mut seen = 0;
        for r in [0.3, 0.9, 1.7] {
            let at = system.at(r).expect("in the domain");
            for share in [0.3, 0.7, 0.9] {
                let Ok(orbit) = at.orbit(share * at.sliding_limit()) else {
                    continue;
                };
                seen += 1;
                for index in 0..50 {
                    let tau = 0.1257 * f64::from(index);
                    let shear = orbit
                        .ask_of(Of::Shear, |motion| motion.displacement(tau))
                        .expect("springs at the base");
                    // m_k ẍ_k over P is (m_k/m₁) r² d²x̄_k/dτ², and the load is cos τ_e.
                    let mut rest = if load == "base" {
                        0.0
                    } else {
                        (tau + orbit.origin()).cos()
                    };
                    for (mass, known) in scene.masses.iter().enumerate() {
                        let gamma = known.value / scene.masses[0].value;
                        rest -= gamma
                            * r
                            * r
                            * orbit
                                .mass(mass_name(&system, mass))
                                .expect("a mass")
                                .acceleration(tau);
                    }
                    assert!(
                        (shear - rest).abs() < 1e-9 * shear.abs().max(1.0),
                        "{load}, r = {r}, {share}: {shear} beside {rest}"
                    );
                }
            }
        }
        assert!(seen > 3, "{seen}");
    }
}

fn mass_name(system: &System, mass: usize) -> &str {
    &system.scene().masses[mass].name
}

/// A stiff spring keeps the digits of its elongation, although both ends move almost alike.
#[test]
fn a_stiff_spring_keeps_its_digits() {
    let chain = |stiffness: f64| -> System {
        format!(
            "struct Chain {{ masses: {{ a: 1, b: 1 }}, springs: {{ base - a: 1, a - b: {stiffness:e} }},
             contact: a - wall, excitation: b, damping: modal(0.05) }}"
        )
        .parse()
        .expect("a scene")
    };
    // With a rigid spring both masses are one of mass 2. The force in the spring is then m ẍ of b minus the load.
    let stiff = chain(1e13);
    let single: System =
        "struct One { masses: { a: 2 }, springs: { base - a: 1 }, contact: a - wall, excitation: a,
        damping: modal(0.05) }"
            .parse()
            .expect("a scene");
    // The frequency ratio of the single mass refers to m₁ = 2.
    let (r, beta) = (0.4, 0.02);
    let one = single.at(r * 2.0_f64.sqrt()).expect("in the domain");
    let motion = one.motion(beta).expect("continuous");
    let x1 = motion.mass("a").expect("a mass").harmonic(1);
    let at = stiff.at(r).expect("in the domain");
    let force = at.motion(beta).expect("continuous");
    let force = force
        .motion_of(Of::Spring(1))
        .expect("a spring")
        .harmonic(1);
    // Elongation counts b − a: k(x_b − x_a) = P cos τ − m ẍ_b = (1 + r² X₁), without the damping of the rigid mode on
    // b, which is half of that on both.
    let damping = frictiongen::Complex::new(0.0, 2.0 * 0.05 * r / 2.0_f64.sqrt()) * x1;
    let wanted = frictiongen::Complex::new(1.0, 0.0) + x1 * (r * r) - damping;
    // The damping of the stiff mode adds some 1e-8. Components rounded to f64 would leave three digits.
    assert!((force - wanted).norm() < 1e-6, "{force} beside {wanted}");
}
