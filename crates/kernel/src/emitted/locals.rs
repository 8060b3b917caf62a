//! Names of local variables in emitted code.
//!
//! In Rust, the pattern of `let r = …` refers to a constant `r` if a constant of this name is in scope. The statement
//! then does not compile. A user may have a constant with the name of a local variable of emitted code. Emitted code
//! therefore imports the functions of this module. The functions hide the user's constants, and a pattern may hide a
//! function.

macro_rules! locals {
    ($($name:ident)*) => {
        $(#[doc(hidden)] pub fn $name() {})*

        /// Names of the functions in this module. They are the names of local variables in emitted code. For any other
        /// name that a scene needs, the generator emits a function together with the scene.
        #[doc(hidden)]
        pub const NAMES: &[&str] = &[$(stringify!($name)),*];
    };
}

locals! {
    absorbs acceleration always_continuous amplitude angle argument at at_1 at_2 at_3 at_4 at_5 at_6
    at_7 at_8 at_9 at_10 at_11 at_12 at_13 at_14 at_15 at_16 base beta beta_in_range break_away
    buckets by_contact by_load chain channels choice choice_2 choice_3 coefficients constants_1
    constants_2 constants_3 constants_4 constants_5 constants_6 constants_7 constants_8 constants_9
    constants_10 constants_11 constants_12 constants_13 constants_14 constants_15 constants_16
    constraint contact contact_squared continuous continuous_at_infinity cosine damped decay_complement
    decay_exponent decay_factor decay_minus_one denominator density detuning difference displacement
    drag drive driven_im driven_re dt dynamics ends error exact_beyond fall fall_per_force fast_decay
    force forced forces frequency friction friction_quadrature friction_weight from from_base
    fundamental g g_2 g_scaled g_sum gain h h_im h_re half_decay_factor half_decay_minus_one
    half_turns halvings harmonic held held_back_im held_back_re held_loads im in_contact in_phase
    in_phase_over_v index input inverse inverse_im inverse_mass inverse_modulus inverse_nearness
    inverse_norm inverse_r inverse_re inverse_size invisible kind known lag largest last law least lift limits lines load
    loads loss low magnitude mass masses mismatch_im mismatch_re mode mode_1 mode_2 mode_3 mode_4 mode_5
    mode_6 mode_7 mode_8 mode_9 mode_10 mode_11 mode_12 mode_13 mode_14 mode_15 mode_16 modes
    modulus_h modulus_v moments motion nearness_im nearness_re never_stuck numerator numerator_im
    numerator_re of off omega on_base on_moving_base one_plus_factor orbit origin own pace
    participations parts per_force phase pieces plain_cosine plain_detuning pole_weight product
    product_2 product_3 product_4 product_5 product_6 product_7 product_8 product_9 product_10
    product_11 product_12 product_13 product_14 product_15 product_16 product_17 product_18
    product_19 product_20 q q_defect question r r_squared rate ratio ratio_2 ratio_3 re reach
    receptance residue resonance response response_im response_re responses rest reversal rise root
    root_in_range rs rubbed_back rubbing run scale scale_over_size shape_1 shape_2 shapes simulation
    sine size sliding sliding_at_infinity sliding_at_rest slow_decay slow_decay_factor slow_exponent
    span spread squared start state static_residue step stiction stiffness stuck sum sum_2 sum_3
    support tables terms turn turning_im turning_re turns u u_in_range u_in_range_2 u_in_sum
    u_others u_scaled u_times_r unbounded unit_im unit_nearness_im unit_nearness_re unit_re units
    unscale unscale_in_range v v_im v_in_range_im v_in_range_re v_others_im v_others_re v_re v_size
    v_term_im v_term_re value value_2 velocity waves weights x zeta
}
