//! Collects all answers of a scene at r and β, each with its name.

use frictiongen::study::SystemAt;
use frictiongen_kernel::modal_sum::wave::Wave;
use frictiongen_kernel::oscillator::decay::Damped;
use frictiongen_kernel::response::motion::Motion;
use frictiongen_kernel::{Complex, Float};
use generated_tests::data::{Data, DataMotion};

/// Names and values of the answers, in the order in which they are asked.
pub type Answers<S> = Vec<(String, S)>;

/// Returns true if an answer is a phase, which may jump by a whole turn.
pub fn is_phase(name: &str) -> bool {
    name.ends_with("phase")
}

fn complex<S: Float>(all: &mut Answers<S>, name: String, value: Complex<S>) {
    all.push((format!("{name} re"), value.re));
    all.push((format!("{name} im"), value.im));
}

fn steady<S: Float, W: AsRef<[Wave<S, Damped<S>>]>>(
    all: &mut Answers<S>,
    name: &str,
    motion: &Motion<S, Damped<S>, W>,
) {
    let [early, late] = [0.7, 2.6].map(S::constant);
    for (question, value) in [
        ("amplitude", motion.amplitude()),
        ("phase", motion.phase()),
        ("estimate", motion.amplitude_monoharmonic()),
        ("displacement", motion.displacement(early)),
        ("velocity", motion.velocity(late)),
    ] {
        all.push((format!("{name} {question}"), value));
    }
    for n in [1, 3] {
        complex(all, format!("{name} harmonic {n}"), motion.harmonic(n));
    }
}

/// Returns the answers of a system through its public interface.
pub fn of_system<S: Float>(at: &SystemAt<'_, S>, masses: usize, beta: S) -> Answers<S> {
    let mut all = vec![
        (String::from("continuous limit"), at.continuous_limit()),
        (
            String::from("without search"),
            at.continuous_limit_without_search(),
        ),
        (String::from("per mode"), at.continuous_limit_per_mode()),
        (String::from("sliding limit"), at.sliding_limit()),
        (
            String::from("margin"),
            at.margin(beta).expect("in the domain"),
        ),
    ];
    let motion = at.motion(beta).expect("continuous");
    let stuck = at.stuck().expect("no resonance of the stuck chain");
    steady(&mut all, "contact", &motion.contact());
    for mass in 0..masses {
        let of = motion.mass_at(mass).expect("a mass");
        steady(&mut all, &format!("mass {mass}"), &of);
        let of = stuck.mass_at(mass).expect("a mass");
        complex(&mut all, format!("mass {mass} stuck"), of);
    }
    all
}

/// Returns the answers that follow from modal data, which need not belong to a scene.
pub fn of_data<S: Float>(data: &Data<S>, r: S, beta: S) -> Answers<S> {
    let at = data.at(r);
    let mut all = vec![
        (String::from("continuous limit"), at.continuous_limit()),
        (
            String::from("without search"),
            at.continuous_limit_without_search(),
        ),
        (String::from("sliding limit"), at.sliding_limit()),
    ];
    let contact: DataMotion<S> = at.contact(beta);
    steady(&mut all, "contact", &contact);
    for mass in 0..data.reduced.shapes.len() / data.reduced.modes.len() {
        steady(&mut all, &format!("mass {mass}"), &at.mass(mass, beta));
        complex(
            &mut all,
            format!("mass {mass} stuck"),
            at.stuck_amplitude(mass),
        );
    }
    all
}
