//! The compiler reports each faulty description on its token, with the recorded text.
//!
//! `messages/*.rs` come from the cases of generated-tests/tests/messages.  After a change:
//! `TRYBUILD=overwrite cargo test -p refused-scenes --test messages`.

#[test]
fn every_message_on_its_token() {
    trybuild::TestCases::new().compile_fail("tests/messages/*.rs");
}
