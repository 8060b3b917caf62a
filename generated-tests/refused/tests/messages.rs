//! Tests that the compiler reports each faulty description at its token, with the recorded text.
//!
//! `messages/*.rs` are generated from the cases in generated-tests/tests/messages. After a change run
//! `TRYBUILD=overwrite cargo test -p refused-scenes --test messages`.

#[test]
fn every_message_on_its_token() {
    trybuild::TestCases::new().compile_fail("tests/messages/*.rs");
}
