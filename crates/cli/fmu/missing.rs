//! The functions of FMI 3.0 that this FMU does not provide.

use crate::fmi3::answer;
use crate::instance::{Instance, Refusal};

/// Defines functions that the FMU does not provide, with the types of their arguments.
macro_rules! missing {
    ($($name:ident($($kind:ty),*);)*) => {$(
        #[unsafe(no_mangle)]
        pub extern "C" fn $name(instance: Option<&mut Instance>, $(_: $kind),*) -> i32 {
            answer(instance, |_| Err(Refusal::missing(stringify!($name))))
        }
    )*};
}

type Read<T> = *const T;
type Write<T> = *mut T;

missing! {
    fmi3GetBinary(Read<u32>, usize, Write<usize>, Write<Read<u8>>, usize);
    fmi3SetBinary(Read<u32>, usize, Read<usize>, Read<Read<u8>>, usize);
    fmi3GetClock(Read<u32>, usize, Write<bool>);
    fmi3SetClock(Read<u32>, usize, Read<bool>);
    fmi3GetNumberOfVariableDependencies(u32, Write<usize>);
    fmi3GetVariableDependencies(u32, Write<usize>, Write<u32>, Write<usize>, Write<i32>, usize);
    fmi3GetDirectionalDerivative(Read<u32>, usize, Read<u32>, usize, Read<f64>, usize, Write<f64>, usize);
    fmi3GetAdjointDerivative(Read<u32>, usize, Read<u32>, usize, Read<f64>, usize, Write<f64>, usize);
    fmi3EnterConfigurationMode();
    fmi3ExitConfigurationMode();
    fmi3GetIntervalDecimal(Read<u32>, usize, Write<f64>, Write<i32>);
    fmi3GetIntervalFraction(Read<u32>, usize, Write<u64>, Write<u64>, Write<i32>);
    fmi3GetShiftDecimal(Read<u32>, usize, Write<f64>);
    fmi3GetShiftFraction(Read<u32>, usize, Write<u64>, Write<u64>);
    fmi3SetIntervalDecimal(Read<u32>, usize, Read<f64>);
    fmi3SetIntervalFraction(Read<u32>, usize, Read<u64>, Read<u64>);
    fmi3SetShiftDecimal(Read<u32>, usize, Read<f64>);
    fmi3SetShiftFraction(Read<u32>, usize, Read<u64>, Read<u64>);
    fmi3EvaluateDiscreteStates();
    fmi3UpdateDiscreteStates(Write<bool>, Write<bool>, Write<bool>, Write<bool>, Write<bool>, Write<f64>);
    fmi3EnterEventMode();
    fmi3EnterStepMode();
    fmi3EnterContinuousTimeMode();
    fmi3CompletedIntegratorStep(bool, Write<bool>, Write<bool>);
    fmi3SetTime(f64);
    fmi3SetContinuousStates(Read<f64>, usize);
    fmi3GetContinuousStateDerivatives(Write<f64>, usize);
    fmi3GetEventIndicators(Write<f64>, usize);
    fmi3GetContinuousStates(Write<f64>, usize);
    fmi3GetNominalsOfContinuousStates(Write<f64>, usize);
    fmi3GetNumberOfEventIndicators(Write<usize>);
    fmi3GetNumberOfContinuousStates(Write<usize>);
    fmi3GetOutputDerivatives(Read<u32>, usize, Read<i32>, Write<f64>, usize);
    fmi3ActivateModelPartition(u32, f64);
}
