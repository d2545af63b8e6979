//! The command line of `welder`.
fn main() {}
