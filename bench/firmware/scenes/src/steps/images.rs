//! Images of steppers. An image is the state of a stepper as bytes. After a loss of power, a stepper continues from
//! it.

use super::script::{FRICTION, STEPS, Song, Weather};
use core::fmt::Arguments;
use frictiongen::OutOfDomain;

/// A function that prints a line of the report. The line has no end-of-line character.
pub type Say<'a> = &'a mut dyn FnMut(Arguments<'_>);

macro_rules! chain {
    ($module:ident $stiffness:literal $scalar:ident $($more:tt)*) => {
        #[allow(dead_code, reason = "some scenes only refuse")]
        mod $module {
            frictiongen::friction_system! {
                /// Two masses in a row on a moving base, where the second mass rubs.
                pub struct Chain {
                    masses: { m1: 3.25, m2: 3.25 },
                    springs: { base - m1: $stiffness, m1 - m2: 1323.0 },
                    contact: m2 - base,
                    excitation: base,
                    damping: modal(0.02),
                    scalar: $scalar,
                    provide: [stepper],
                    step: 1e-3,
                    $($more)*
                }
            }
        }
    };
}

chain! { rigid 1323.0 f32 }
chain! { elastic 1323.0 f32 stiffness: 20000.0, }
chain! { law 1323.0 f32 friction: stribeck(0.01: 0.9, 0.1: 0.8), }
chain! { other 1324.0 f32 }
chain! { double 1323.0 f64 }

/// Returns the CRC-32 (IEEE 802.3) of an image without its last four bytes, which contain this checksum.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}

/// Returns an image in which the byte at `place` is replaced and the checksum is correct again.
fn with<const N: usize>(image: &[u8; N], place: usize, byte: u8) -> [u8; N] {
    let mut changed = *image;
    changed[place] = byte;
    let (body, sum) = changed.split_at_mut(N - 4);
    sum.copy_from_slice(&crc(body).to_le_bytes());
    changed
}

/// Runs one scene under the load `Song`. At half time the stepper is saved as an image. Reports whether a stepper
/// from this image ends with the same bits as the original.
macro_rules! song {
    ($module:ident, $say:ident) => {{
        use $module::{Chain, ChainInput};
        let mut song = Song::<f32>::new();
        let mut stepper = Chain::stepper(Chain::STEP)?;
        let mut sample = || {
            let [displacement, velocity] = song.next(true, Weather::Song);
            ChainInput {
                displacement,
                velocity,
                friction: FRICTION as f32,
            }
        };
        for _ in 0..STEPS / 2 {
            stepper.advance(sample())?;
        }
        let image = stepper.image();
        // Only the bytes remain after a loss of power.
        let mut again = Chain::stepper_from_image(&image)?;
        let mut same = again.image() == image;
        for _ in 0..STEPS / 2 {
            let sample = sample();
            same &= again.advance(sample)? == stepper.advance(sample)?;
        }
        same &= again.image() == stepper.image();
        $say(format_args!(
            "image of {}: {} bytes, CRC {:08x}, at the end {:08x}: {}",
            stringify!($module),
            image.len(),
            crc(&image[..image.len() - 4]),
            crc(&again.image()[..image.len() - 4]),
            if same {
                "the same bits"
            } else {
                "WRONG: other bits"
            }
        ));
        (stepper, image)
    }};
}

/// Reports whether a stepper refuses an image with the expected error and keeps its state.
macro_rules! refused {
    ($say:ident, $what:literal, $stepper:expr, $image:expr, $reason:pat) => {{
        let before = $stepper.image();
        let answer = $stepper.restore_image($image);
        let right = matches!(answer, Err($reason)) && $stepper.image() == before;
        let verdict = if right {
            "refused"
        } else {
            "WRONG: accepted, or refused for another reason"
        };
        $say(format_args!("image of {}: {}", $what, verdict));
    }};
}

/// Reports whether the images of three scenes work. A line with `WRONG` shows a fault.
pub fn report(say: Say<'_>) -> Result<(), OutOfDomain> {
    song!(elastic, say);
    song!(law, say);
    let (mut stepper, image) = song!(rigid, say);
    let mut other = other::Chain::stepper(other::Chain::STEP)?;
    refused!(say, "another scene", other, &image, OutOfDomain::Saved);
    let mut slower = rigid::Chain::stepper(2e-3)?;
    refused!(say, "another step", slower, &image, OutOfDomain::Saved);
    let double = double::Chain::stepper(1e-3)?.image();
    refused!(say, "another scalar", stepper, &double, OutOfDomain::Saved);
    let version = with(&image, 2, image[2].wrapping_add(1));
    refused!(
        say,
        "another version",
        stepper,
        &version,
        OutOfDomain::ImageVersion
    );
    let shorter = &image[..image.len() - 1];
    refused!(
        say,
        "another length",
        stepper,
        shorter,
        OutOfDomain::ImageDamaged
    );
    let (before, mut found) = (stepper.image(), 0);
    for bit in 0..8 * image.len() {
        let mut changed = image;
        changed[bit / 8] ^= 1 << (bit % 8);
        found += usize::from(matches!(
            stepper.restore_image(&changed),
            Err(OutOfDomain::ImageDamaged)
        ));
    }
    let right = found == 8 * image.len() && stepper.image() == before;
    let verdict = if right { "refused" } else { "WRONG: accepted" };
    say(format_args!(
        "image with one of {found} bits changed: {verdict}"
    ));
    // The stepper has the state at the end of the load. It must still accept the correct image of half time.
    stepper.restore_image(&image)?;
    let right = stepper.image() == image;
    let verdict = if right {
        "restored"
    } else {
        "WRONG: another state"
    };
    say(format_args!("image after all refusals: {verdict}"));
    Ok(())
}
