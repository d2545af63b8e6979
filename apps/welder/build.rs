//! Hands the flags of the build to the program, which writes them beside what it measures.

use std::process::Command;

fn main() {
    let of = |name: &str| std::env::var(name).unwrap_or_default();
    let answer = Command::new(of("RUSTC")).arg("--version").output();
    let answer =
        answer.map_or_else(|_| String::new(), |told| String::from_utf8_lossy(&told.stdout).into_owned());
    // "rustc 1.89.0": what follows holds the date of the compiler.
    let compiler: Vec<&str> = answer.split_whitespace().take(2).collect();
    println!(
        "cargo:rustc-env=WELDER_BUILD={}, profile {}, opt-level {}, rustflags \"{}\"",
        compiler.join(" "),
        of("PROFILE"),
        of("OPT_LEVEL"),
        of("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ")
    );
}
