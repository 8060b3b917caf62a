//! Tests images of a stepper's state: a run continues from an image bit for bit, and every changed image is refused.

use frictiongen::{OutOfDomain, StepLoad, Stepping, Steps, System};
use frictiongen_kernel::{Float, Scalar};
use fuzzing::Random;
use generated_tests::shown;

/// Returns the bits of all numbers that a stepper reports.
fn bits<T: Stepping>(stepper: &T, masses: usize) -> Vec<u64> {
    let (contact, work) = (stepper.contact(), stepper.work());
    let mut numbers = vec![contact.displacement(), contact.velocity(), contact.force()];
    numbers.extend([work.load, work.friction, work.damping, work.stored]);
    for mass in 0..masses {
        let now = stepper.mass(mass);
        numbers.extend([now.displacement(), now.velocity()]);
    }
    let mut bits: Vec<u64> = numbers.iter().map(|number| number.bits()).collect();
    bits.extend([
        stepper.steps(),
        stepper.exceeded(),
        contact.contact() as u64,
    ]);
    bits
}

/// Random inputs of a scene, with which the contact stops and slips.
#[derive(Clone)]
struct Inputs {
    random: Random,
    base: [f64; 2],
    forces: Vec<(usize, f64)>,
    friction: f64,
}

impl Inputs {
    fn step<T: Stepping>(&mut self, stepper: &mut T) -> u32 {
        let mut number = |size: f64| T::Scalar::constant(size * self.random.signed());
        let base = self.base.map(&mut number);
        let forces: Vec<_> = self
            .forces
            .iter()
            .map(|(mass, size)| (*mass, number(*size)))
            .collect();
        let friction = T::Scalar::constant(self.friction) + number(0.9 * self.friction);
        let load = StepLoad {
            base,
            forces: &forces,
            friction,
        };
        stepper.step(&load).expect("a sound load").events
    }
}

/// Runs a stepper, and continues it from images at several steps. `image` makes an image, and `of` restores it.
fn continues<T: Stepping>(
    mut stepper: T,
    mut inputs: Inputs,
    masses: usize,
    (image, of): (
        impl Fn(&T) -> Vec<u8>,
        impl Fn(&[u8]) -> Result<T, OutOfDomain>,
    ),
) {
    let (mut events, mut states) = (0, [0; 2]);
    for step in 0..400 {
        events += inputs.step(&mut stepper);
        states[usize::from(stepper.contact().is_sticking())] += 1;
        if step % 57 == 0 {
            let bytes = image(&stepper);
            let mut again = of(&bytes).expect("its own image");
            assert_eq!(bits(&again, masses), bits(&stepper, masses));
            assert_eq!(image(&again), bytes, "an image of the restored state");
            let mut inputs = inputs.clone();
            let mut twin = of(&bytes).expect("the same image");
            for _ in 0..50 {
                inputs.clone().step(&mut twin);
                inputs.step(&mut again);
                assert_eq!(bits(&again, masses), bits(&twin, masses));
            }
            // The original stepper takes the same steps, so that its next image must agree.
        }
    }
    assert!(
        events > 20 && states.iter().all(|count| *count > 10),
        "{events} {states:?}"
    );
    let mut last = of(&image(&stepper)).expect("its own image");
    for _ in 0..200 {
        let mut same = inputs.clone();
        same.step(&mut last);
        inputs.step(&mut stepper);
        assert_eq!(bits(&last, masses), bits(&stepper, masses));
    }
}

fn shaken() -> Inputs {
    Inputs {
        random: Random(5),
        base: [0.02, 20.0],
        forces: Vec::new(),
        friction: 3.0,
    }
}

fn image_of(stepper: &<System as Steps>::Stepper<'_>) -> Vec<u8> {
    stepper.image()
}

#[test]
fn a_run_continues_with_the_same_bits() {
    let shaken = shaken();
    continues(
        shown::Shaken::stepper(1e-3).expect("a step"),
        shaken.clone(),
        2,
        (
            |of: &shown::ShakenStepper| of.image().to_vec(),
            shown::Shaken::stepper_from_image,
        ),
    );
    // The step of this stepper differs from the declared step. The image contains the step.
    continues(
        shown::Shaken::stepper(1.3e-3).expect("a step"),
        shaken.clone(),
        2,
        (
            |of: &shown::ShakenStepper| of.image().to_vec(),
            shown::Shaken::stepper_from_image,
        ),
    );
    let pushed = Inputs {
        base: [0.0; 2],
        forces: vec![(0, 8.0)],
        friction: 4.0,
        ..shaken.clone()
    };
    continues(
        shown::Pushed::stepper(0.05).expect("a step"),
        pushed,
        1,
        (
            |of: &shown::PushedStepper| of.image().to_vec(),
            shown::Pushed::stepper_from_image,
        ),
    );
    let sprung = Inputs {
        base: [0.02, 20.0],
        friction: 1.0,
        ..shaken.clone()
    };
    continues(
        shown::Sprung::stepper(1e-3).expect("a step"),
        sprung,
        2,
        (
            |of: &shown::SprungStepper| of.image().to_vec(),
            shown::Sprung::stepper_from_image,
        ),
    );
    let known = shown::SCENES
        .iter()
        .find(|(name, _)| *name == "Shaken")
        .expect("a scene");
    let system: System = known.1.parse().expect("a valid scene");
    continues(
        system.stepper(1e-3).expect("a step"),
        shaken,
        2,
        (image_of, |bytes: &[u8]| system.stepper_from_image(bytes)),
    );
}

/// Returns the CRC-32 by polynomial division of the whole message, independently of the kernel's method.
fn checksum(bytes: &[u8]) -> [u8; 4] {
    let message = bytes.iter().map(|byte| byte.reverse_bits()).chain([0; 4]);
    let bits: Vec<bool> = message
        .flat_map(|byte| (0..8).rev().map(move |bit| byte >> bit & 1 == 1))
        .collect();
    let mut bits: Vec<bool> = bits
        .iter()
        .enumerate()
        .map(|(at, bit)| bit ^ (at < 32))
        .collect();
    let whole = bits.len() - 32;
    for at in 0..whole {
        if bits[at] {
            bits[at] = false;
            for (offset, divides) in
                (0..32).map(|bit| (bit + 1, 0x04c1_1db7_u32 >> (31 - bit) & 1 == 1))
            {
                bits[at + offset] ^= divides;
            }
        }
    }
    let sum = bits[whole..]
        .iter()
        .fold(0_u32, |sum, bit| sum << 1 | u32::from(*bit));
    (!sum.reverse_bits()).to_le_bytes()
}

#[test]
fn every_changed_image_is_refused() {
    assert_eq!(
        u32::from_le_bytes(checksum(b"123456789")),
        0xcbf4_3926,
        "the published check value"
    );
    let mut stepper = shown::Shaken::stepper(1e-3).expect("a step");
    let mut inputs = shaken();
    for _ in 0..100 {
        inputs.step(&mut stepper);
    }
    let image = stepper.image();
    assert_eq!(image.len(), shown::ShakenStepper::IMAGE);
    let (body, sum) = image.split_at(image.len() - 4);
    assert_eq!(checksum(body), sum);
    let mut other = shown::Shaken::stepper(1e-3).expect("a step");
    inputs.step(&mut other);
    let before = (bits(&other, 2), other.image());
    let mut refused = |bytes: &[u8]| {
        let error = other.restore_image(bytes).expect_err("a changed image");
        assert_eq!(
            (bits(&other, 2), other.image()),
            before,
            "the stepper keeps its state"
        );
        assert_eq!(
            shown::Shaken::stepper_from_image(bytes).map(|_| ()),
            Err(error)
        );
        error
    };
    for bit in 0..8 * image.len() {
        let mut changed = image;
        changed[bit / 8] ^= 1 << (bit % 8);
        assert_eq!(refused(&changed), OutOfDomain::ImageDamaged, "bit {bit}");
    }
    for length in 0..image.len() {
        assert_eq!(
            refused(&image[..length]),
            OutOfDomain::ImageDamaged,
            "{length} bytes"
        );
    }
    assert_eq!(
        refused(&[&image[..], &[0]].concat()),
        OutOfDomain::ImageDamaged
    );
    // Each of these changes has a valid checksum: version, scalar type, hash, contact, a flag, and a number that is
    // not finite.
    let mut sealed = |at: usize, bytes: &[u8]| {
        let mut changed = body.to_vec();
        changed[at..at + bytes.len()].copy_from_slice(bytes);
        let sum = checksum(&changed);
        refused(&[changed, sum.to_vec()].concat())
    };
    assert_eq!(sealed(2, &[2]), OutOfDomain::ImageVersion);
    assert_eq!(sealed(3, &[4]), OutOfDomain::Saved);
    assert_eq!(sealed(4, &[0; 8]), OutOfDomain::Saved);
    assert_eq!(sealed(32, &[3]), OutOfDomain::ImageDamaged);
    assert_eq!(sealed(33, &[2]), OutOfDomain::ImageDamaged);
    assert_eq!(sealed(28, &[9]), OutOfDomain::ImageDamaged);
    assert_eq!(
        sealed(44, &f64::NAN.to_le_bytes()),
        OutOfDomain::ImageDamaged
    );
    assert_eq!(
        sealed(body.len() - 8, &f64::INFINITY.to_le_bytes()),
        OutOfDomain::ImageDamaged
    );
}

#[test]
fn an_image_of_another_stepper_is_refused() {
    let image = shown::Shaken::stepper(1e-3).expect("a step").image();
    let mut other = shown::Shaken::stepper(2e-3).expect("a step");
    assert_eq!(
        other.restore_image(&image),
        Err(OutOfDomain::Saved),
        "another step"
    );
    assert_eq!(
        shown::Sprung::stepper_from_image(&image).map(|_| ()),
        Err(OutOfDomain::Saved)
    );
    assert_eq!(
        shown::Pushed::stepper_from_image(&image).map(|_| ()),
        Err(OutOfDomain::Saved)
    );
    // The stepper of a run-time system has a force on every mass.
    let known = shown::SCENES
        .iter()
        .find(|(name, _)| *name == "Shaken")
        .expect("a scene");
    let system: System = known.1.parse().expect("a valid scene");
    assert_eq!(
        system.stepper_from_image(&image).map(|_| ()),
        Err(OutOfDomain::Saved)
    );
}
