//! Compile-failure tests of `friction_system!`: the messages of faulty descriptions, and of methods that a scene does not
//! provide.
