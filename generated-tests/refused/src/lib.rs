//! Compile-failure tests of `friction_system!`: messages for faulty descriptions, and for methods that a scene does not
//! provide.
