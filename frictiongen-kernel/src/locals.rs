//! Names of local variables in emitted code.
//!
//! A pattern `let r` means the constant `r` where there is one.  Emitted code imports these functions,
//! which hide what the user may have called so, and which a pattern may in turn hide.

macro_rules! locals {
    ($($name:ident)*) => {
        $(#[doc(hidden)] pub fn $name() {})*

        /// All of them; what else a scene needs is emitted with it.
        #[doc(hidden)]
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];
    };
}

locals! {
    abs_im abs_im_2 abs_re abs_re_2 amplitude argument at beta break_away carrier chain
    choice choice_10 choice_11 choice_12 choice_13 choice_2 choice_3 choice_4 choice_5
    choice_6 choice_7 choice_8 choice_9 component constraint contact continuous cosine
    damped denominator detuning effort excitation fall fast_decay force frequency friction
    friction_force friction_quadrature friction_weight g g_2 g_scaled gain h h_im h_re
    half_period_decay half_turns heaviest held held_im held_re im in_contact in_phase
    in_phase_share index inverse inverse_im inverse_modulus inverse_modulus_2
    inverse_modulus_3 inverse_modulus_4 inverse_modulus_5 inverse_nearness inverse_r
    inverse_re inverse_size kept_half kept_share kind lag larger larger_2 limit load loss
    lost_share mismatch_im mismatch_re mobility mode mode_1 mode_2 mode_3 mode_4 modes
    nearness_im nearness_re negative_lost_half negative_lost_share of offset omega
    one_and_kept orbit others_h_im others_h_re others_u others_v_im others_v_re phase
    plain_detuning pole_weight product product_10 product_11 product_12 product_13 product_2
    product_3 product_4 product_5 product_6 product_7 product_8 product_9 question r ratio
    ratio_2 ratio_3 re receptance response response_im response_re responses reversal rise
    room rs rubbed_back run scalar scale share sine size sliding slow_decay slow_exponent
    slow_kept_share smaller_share smaller_share_2 spread state stuck sum sum_2 sum_3 swing
    turning_im turning_im_2 turning_re turning_re_2 u u_scaled unit_im unit_nearness_im
    unit_nearness_re unit_re unscale v_im v_re v_size value velocity_share velocity_share_2
    velocity_share_3 waves
}
