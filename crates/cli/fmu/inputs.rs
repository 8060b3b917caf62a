//! The inputs between two communication points.

use crate::scene::{self, DT, INPUTS, LINEAR};

/// Returns the inputs of one step of several.  The last step has the inputs that the importer has set.
pub fn between(
    last: &[f64; INPUTS],
    inputs: &[f64; INPUTS],
    index: u64,
    count: u64,
) -> [f64; INPUTS] {
    let mut sample = *inputs;
    if scene::HOLD {
        // The base moves on at its constant velocity.
        if scene::ON_BASE && index > 1 {
            sample[0] += (index - 1) as f64 * DT * inputs[1];
        }
        return sample;
    }
    if index == count {
        return sample;
    }
    let share = index as f64 / count as f64;
    let forces = if scene::ON_BASE { 2 } else { 0 };
    for (value, last) in sample.iter_mut().zip(last).take(LINEAR).skip(forces) {
        *value = last + (*value - last) * share;
    }
    if scene::ON_BASE {
        // The cubic that has the displacement and the velocity of both ends.
        let length = count as f64 * DT;
        let (from, to) = (last[1] * length, inputs[1] * length);
        let rise = inputs[0] - last[0];
        let (second, third) = (3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise);
        sample[0] = last[0] + share * (from + share * (second + share * third));
        sample[1] = (from + share * (2.0 * second + share * 3.0 * third)) / length;
    }
    sample
}
