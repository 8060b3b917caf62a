//! Tests optima and curves of random frames. Their motions from rest stick, jump, or do not settle. The searches must
//! finish within bounded work, and an optimum must be as good as that of a refined map.
//!
//! ```sh
//! RAYON_NUM_THREADS=1 cargo test --release -p generated-tests --test study answers:: -- --ignored --nocapture --test-threads 1
//! ```

mod contacts;
pub mod frames;
mod map;

use frames::{Frame, frame};
use frictiongen::Of;
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::{
    System,
    curve::CurveRequest,
    optimum::{
        FrequencyBand, Optimum, OptimumEnd, OptimumError, OptimumKind, OptimumOptions,
        OptimumRequest,
    },
    response::SystemResponse,
    units::Load,
};
use std::time::Instant;

/// Largest accepted ratio, minus 1, of the optimum's amplitude to the best amplitude of a map, if the search
/// converged. A map of several hundred thousand samples may find a narrow valley that a scan of about 70 friction
/// ratios misses.
const ABOVE: f64 = 0.02;

/// Largest accepted ratio, minus 1, of the optimum's amplitude to the best amplitude of a map, if the bound on work
/// ended the search. The optimum is then the best friction that the search has found so far.
const ABOVE_IF_SPENT: f64 = 0.1;

/// Bound on the work of a search in the regular tests. A unit of work takes about 10 µs. Without compiler
/// optimisation the search takes a few seconds.
const WORK: usize = 150_000;

/// Result for one frame. `seconds` is processor time, so that other programs on the machine do not count.
struct Outcome {
    seconds: f64,
    /// Ratio of the found amplitude to the best amplitude of a map, minus 1.
    above: f64,
    /// Ratio of the sampled amplitude at the returned friction to the returned amplitude, minus 1.
    higher: f64,
    end: OptimumEnd,
}

/// Returns the processor time of this process in seconds. Without Linux's `/proc`, it returns the time since a fixed
/// date.
fn processor_seconds() -> f64 {
    /// Number of clock ticks in a second, which is fixed in Linux's interface.
    const TICKS: f64 = 100.0;
    let ticks = || {
        let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
        // The name of the program, in parentheses, may contain spaces.
        let (_, fields) = stat.rsplit_once(')')?;
        fields.split_whitespace().nth(11)?.parse::<f64>().ok()
    };
    ticks().map_or_else(
        || {
            let now = std::time::SystemTime::now().duration_since(std::time::UNIX_EPOCH);
            now.map_or(0.0, |now| now.as_secs_f64())
        },
        |ticks| ticks / TICKS,
    )
}

/// Finds an optimum within a bound on the work, or within the default bound.
fn within(
    system: &System,
    request: &OptimumRequest,
    work: Option<usize>,
) -> Result<Optimum, OptimumError> {
    let options = OptimumOptions {
        work,
        ..OptimumOptions::default()
    };
    system.optimum_with(request, &options)
}

/// Finds the optimum of a frame, and compares it with a map. `work` bounds the work of the search; `None` stands for
/// the default bound.
fn outcome(frame: &Frame, work: Option<usize>) -> Option<Outcome> {
    let start = processor_seconds();
    let found = within(&frame.system, &frame.request(), work);
    let seconds = processor_seconds() - start;
    let found = match found {
        Ok(found) => found,
        Err(OptimumError::Unbounded) => {
            let (beta, least) = map::least(frame);
            assert!(least.is_infinite(), "{}: {least} at β = {beta}", frame.text);
            println!(
                "{} {seconds:.2} s, no friction bounds it, nor in the map",
                frame.name
            );
            return None;
        }
        Err(error) => panic!("{} {}: {error}", frame.name, frame.text),
    };
    let [from, to] = found.bracket;
    assert!(from <= found.beta && found.beta <= to, "{}", frame.name);
    if found.amplitude == 0.0 {
        return None;
    }
    let (beta, _) = map::least(frame);
    // The friction of the map and the friction of the search are judged at the same frequencies.
    let places = map::fine_frequencies(frame);
    let [least, there] =
        [beta, found.beta].map(|beta| map::largest(frame, &places, beta, f64::INFINITY));
    let outcome = Outcome {
        seconds,
        above: found.amplitude / least - 1.0,
        higher: there / found.amplitude - 1.0,
        end: found.end,
    };
    println!(
        "{} {seconds:.2} s, β = {} (map {beta}), {} above {:.1e}, higher {:.1e}, {:?} {:?}",
        frame.name,
        found.beta,
        found.amplitude,
        outcome.above,
        outcome.higher,
        found.kind,
        found.end
    );
    Some(outcome)
}

/// Checks one frame. At the friction from which the contact can stick over the whole band, motions from rest slide on in
/// ranges narrower than 0.1 % of r near r = 1.4995.
#[test]
fn optimum_of_one_frame() {
    let frame = frame(2, 4);
    let outcome = outcome(&frame, Some(WORK)).expect("an optimum and a map");
    let most = if outcome.end == OptimumEnd::WorkSpent {
        ABOVE_IF_SPENT
    } else {
        ABOVE
    };
    assert!(outcome.above < most, "{}: {}", frame.text, outcome.above);
    assert!(outcome.higher < most, "{}: {}", frame.text, outcome.higher);
}

/// Checks a frame at a resonance of its stuck chain that the load does not drive and that nothing damps. If the contact
/// sticks, no mass moves.
#[test]
fn a_resonance_that_nothing_drives_bounds_nothing() {
    let frame = frame(6, 0);
    let found = frame.system.optimum(&frame.request()).expect("an optimum");
    assert_eq!((found.amplitude, found.kind), (0.0, OptimumKind::Trivial));
    // The contact is loaded only by the force k₁Y of the spring to the base.
    let stuck = 1.0 / frame.system.scene().stiction;
    assert!((found.beta / stuck - 1.0).abs() < 1e-3, "{}", found.beta);
}

/// Checks a frame of two masses whose optimum is hard to find. A map finds 13.8 mm near 75 N.
#[test]
fn a_frame_on_which_the_search_gave_up() {
    let text = "struct Two { masses: { a: 12, b: 5 }, springs: { wall - a: 3.2e4, a - b: 1.1e4 }, contact: a - b,
        excitation: a, damping: rayleigh(0.4, 1e-5), stiction: 1.25 }";
    let system: System = text.parse().expect("a valid scene");
    let load = Load::Force(100.0);
    let request = OptimumRequest {
        of: Of::Mass(1),
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Hertz(4.0, 12.0),
        load: Some(load),
    };
    let found = within(&system, &request, Some(100_000)).expect("the best so far at least");
    let scale = system.load_scale(load).expect("a force");
    let (force, millimetres) = (
        scale.friction(found.beta),
        1e3 * scale.length() * found.amplitude,
    );
    println!("{force} N, {millimetres} mm, {:?}", found.end);
    // With the default work the search finds 14.25 mm at 68.5 N. A curve shows 14.2 mm at 68.5 N, and more at 65 N and
    // at 70 N. With the work of this test the result is within 3 % of 14.25 mm.
    assert!(millimetres < 1.03 * 14.25, "{force} N: {millimetres} mm");
    // An unfinished search has verified no interval of friction.
    assert_eq!(
        found.tolerances.is_empty(),
        found.end == OptimumEnd::WorkSpent
    );
    let [from, to] = found.bracket;
    assert!(from <= found.beta && found.beta <= to);
}

/// Checks a frame with a narrow frequency range of stick-slip motion. At 2146 N motion from rest reaches a stick-slip
/// state between 2.13 Hz and 2.146 Hz, with 5.69 mm at 2.143 Hz. A search that misses this range takes 2146 N for the
/// best friction, with 5.08 mm.
#[test]
fn a_narrow_range_of_stick_slip_counts() {
    let tower: System = "struct Tower {
        masses: { first: 1500, second: 1500, roof: 1500 },
        springs: { base - first: 1.2e6, first - second: 1.2e6, second - roof: 1.2e6 },
        contact: first - second, excitation: base, damping: modal(0.02), stiction: 1.2,
    }"
    .parse()
    .expect("a scene");
    let of = Of::Mass(2);
    let request = OptimumRequest {
        of,
        size: MotionQuantity::Displacement,
        band: FrequencyBand::Hertz(2.0, 2.4),
        load: Some(Load::Base(1e-3)),
    };
    let found = within(&tower, &request, Some(200_000)).expect("an optimum");
    let ends = [2.0, 2.4].map(|hertz| tower.frequency_ratio_at_hertz(hertz));
    let request = CurveRequest {
        widest: Some(0.0003),
        ..CurveRequest::new(ends[0], ends[1], &[of])
    };
    let curve = tower.curve(&request, found.beta).expect("a curve");
    let points = curve.pieces.iter().flat_map(|piece| &piece.points);
    let largest = points.map(|point| point.movements[0].swing.amplitude);
    let largest = largest.fold(0.0, f64::max);
    println!(
        "{} at β = {}, on a curve {largest}",
        found.amplitude, found.beta
    );
    assert!(largest < 1.01 * found.amplitude);
    assert!(found.amplitude < 5.5, "{}", found.amplitude);
}

/// Checks 200 frames of one to six masses. The test prints every frame, the frame with the slowest search, and the
/// number of frames whose optimum is more than 2 % above that of the map.
#[test]
#[ignore = "200 optima, each with a map: some hours"]
fn optima_of_two_hundred_frames() {
    let (mut slowest, mut above, mut spent) = ((0.0, String::new()), 0, 0);
    let mut compared = 0_usize;
    // The environment variable FRAMES selects some of the frames, for example FRAMES=120..200.
    let part = std::env::var("FRAMES").unwrap_or_else(|_| "0..200".to_owned());
    let ends: Vec<usize> = part
        .split("..")
        .filter_map(|end| end.parse().ok())
        .collect();
    let [first, end] = ends[..] else {
        panic!("FRAMES={part}")
    };
    for number in first..end {
        let frame = frame(1 + number % 6, number / 6);
        let Some(outcome) = outcome(&frame, None) else {
            continue;
        };
        compared += 1;
        above += usize::from(ABOVE < outcome.above);
        spent += u32::from(outcome.end == OptimumEnd::WorkSpent);
        if slowest.0 < outcome.seconds {
            slowest = (outcome.seconds, frame.text.clone());
        }
    }
    println!(
        "{compared} compared, {above} above the map by more than {ABOVE}, {spent} ended by the bound on work; slowest {:.1} s: {}",
        slowest.0, slowest.1
    );
    assert!(slowest.0 < 60.0 && end - first < 2 * compared);
    assert!(above * 20 < compared, "{above} of {compared}");
}

/// Checks the time for curves of frames of five masses at three friction ratios. Nearly all curves take at most 5 s
/// on one core.
#[test]
#[ignore = "36 curves: a minute or two"]
fn curves_of_five_masses() {
    let (mut slowest, mut above) = ((0.0, String::new()), 0);
    for index in 0..12 {
        let frame = frame(5, index);
        let mut limits: Vec<f64> = map::frequencies(&frame)
            .iter()
            .filter_map(|r| Some(frame.system.at(*r).ok()?.sliding_limit()))
            .collect();
        limits.sort_by(f64::total_cmp);
        for share in [0.1, 0.3, 0.7] {
            let [from, to] = frame.band;
            let request = CurveRequest::new(from, to, &[Of::Mass(frame.mass)]);
            let start = Instant::now();
            let curve = frame
                .system
                .curve(&request, share * limits[limits.len() / 2]);
            let (seconds, curve) = (start.elapsed().as_secs_f64(), curve.expect("a curve"));
            let points: usize = curve.pieces.iter().map(|piece| piece.points.len()).sum();
            println!(
                "{} {share} {seconds:.2} s, {points} points, refined {}",
                frame.name, curve.refined
            );
            above += u32::from(5.0 < seconds);
            if slowest.0 < seconds {
                slowest = (seconds, frame.text.clone());
            }
        }
    }
    println!(
        "{above} above 5 s; slowest {:.2} s: {}",
        slowest.0, slowest.1
    );
    // In the slowest chain the contact hardly moves the slowest mode. The motion does not settle at 340 of its
    // frequencies.
    assert!(slowest.0 < 10.0 && above * 10 < 36, "{above} above 5 s");
}

/// Checks that a response is reported as from rest only if motion from rest has a steady state. Without damping and
/// with μ > 1, motion from rest may not settle. The response then has the closed form or the stuck state, and reports
/// this.
#[test]
fn another_state_is_not_called_one_from_rest() {
    let (mut from_rest, mut others) = (0, [0; 3]);
    for (masses, index) in [(2, 0), (3, 1), (4, 2), (3, 3)] {
        let frame = frame(masses, index);
        let [from, to] = frame.band;
        for place in 0..40 {
            let r = from + (to - from) * (f64::from(place) + 0.37) / 40.0;
            let at = frame.system.at(r).expect("in the domain");
            let limit = at.sliding_limit();
            for share in [0.1, 0.4, 0.8, 1.2] {
                let beta = share * limit;
                let Ok(response) = at.response(beta) else {
                    continue;
                };
                if response.is_settled() && response.is_from_rest() {
                    assert!(at.orbit(beta).is_ok(), "{} r = {r}, β = {beta}", frame.text);
                    from_rest += 1;
                } else if response.is_settled() {
                    let kind = match response {
                        SystemResponse::Continuous(_) => 0,
                        SystemResponse::StickSlip(_) => 1,
                        SystemResponse::Stuck(_) => 2,
                    };
                    others[kind] += 1;
                }
            }
        }
    }
    println!("{from_rest} from rest, others {others:?}");
    assert!(
        from_rest > 300 && others[0] > 2 && others[2] > 2,
        "{others:?}"
    );
}

/// Checks a response at a friction ratio just above β_lim on an undamped resonance. Newton's method finds states with
/// amplitudes of 10¹⁴ at this resonance. Compared with these amplitudes, friction and load are below rounding. The
/// response must be about as large as at neighbouring frequencies.
#[test]
fn a_resonance_just_bounded_has_no_enormous_state() {
    let frame = frame(5, 18);
    let r = frame.system.resonances()[3];
    let beta = 60.255_712_978_055_68;
    let [there, near] = [r, r * (1.0 + 1e-9)].map(|r| map::amplitude(&frame, r, beta));
    assert!(2.0 < there && there < 1.5 * near, "{there}, {near} beside");
}

/// Checks that a curve reports if a bound on work stopped its refinement. With enough work it reaches the requested
/// accuracy.
#[test]
fn a_bound_on_the_work_of_a_curve_is_told() {
    let system = frame(2, 4).system;
    let mut request = CurveRequest::new(0.3, 2.0, &[Of::Mass(0)]);
    let whole = system.curve(&request, 0.3).expect("a curve");
    request.work = 0;
    let coarse = system.curve(&request, 0.3).expect("a curve");
    let points = |curve: &frictiongen::study::curve::Curve| -> usize {
        curve.pieces.iter().map(|piece| piece.points.len()).sum()
    };
    assert!(whole.refined && !coarse.refined);
    assert!(points(&coarse) < points(&whole));
    // A bound that stops the refinement later is reported too. A refined curve has all its points.
    let mut partial = 0;
    loop {
        request.work = 2 * request.work + 1;
        let curve = system.curve(&request, 0.3).expect("a curve");
        if curve.refined {
            assert_eq!(points(&curve), points(&whole), "work {}", request.work);
            break;
        }
        partial += usize::from(points(&coarse) < points(&curve));
    }
    assert!(partial > 0);
}
