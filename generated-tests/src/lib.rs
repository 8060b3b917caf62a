//! Scenes whose emitted code is compiled here, compared with its snapshot, and run.
