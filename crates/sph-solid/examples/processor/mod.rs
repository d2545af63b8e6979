//! What this process has cost.

/// Time of all threads of this process on processors \[s\] to a hundredth; zero where there is no /proc.
pub fn processor_seconds() -> f64 {
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // User and system time, in ticks of a hundredth; the name before them may hold blanks, but ends with a bracket.
    let fields = text.rsplit(')').next().unwrap_or_default().split_whitespace();
    fields.skip(11).take(2).filter_map(|field| field.parse::<f64>().ok()).sum::<f64>() / 100.0
}
