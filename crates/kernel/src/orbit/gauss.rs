//! Nodes and weights of Gaussian quadrature, for the harmonics of a motion between two events.

/// Positive nodes on [−1, 1] of the Gaussian rule with sixteen points, each with its weight. The remaining eight nodes
/// are the negatives of these eight nodes.
pub(super) const SIXTEEN: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_58),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_79),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_1),
];

/// Largest change of the integrand's phase within one panel of the quadrature, in rad. The quadrature error is then
/// below 1e-25.
pub(super) const PANEL: f64 = 8.0;
