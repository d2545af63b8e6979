//! What a run used of the machine, and which machine it was.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::fs;

/// The machine that a measurement belongs to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor as it names itself.
    pub cpu_model: String,
    /// Cores that this process may use.
    pub cores: usize,
    /// Operating system and instruction set.
    pub platform: String,
}

impl Machine {
    /// Looks at the machine that this program runs on.
    pub fn here() -> Self {
        let described = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        Machine {
            cpu_model: value_of(&described, "model name").unwrap_or("unknown").to_string(),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            platform: format!("{}-{}", std::env::consts::OS, std::env::consts::ARCH),
        }
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        write!(formatter, "{}, {} cores, {}", self.cpu_model, self.cores, self.platform)
    }
}

/// The most memory that this process ever held, where the system tells (Linux).
pub fn peak_memory_bytes() -> Option<u64> {
    peak_bytes(&fs::read_to_string("/proc/self/status").ok()?)
}

/// Processor time of this process so far, over all its threads, where the system tells (Unix).
pub fn process_cpu_s() -> Option<f64> {
    #[cfg(unix)]
    {
        let spent = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
        Some(spent.tv_sec as f64 + 1e-9 * spent.tv_nsec as f64)
    }
    #[cfg(not(unix))]
    None
}

fn peak_bytes(status: &str) -> Option<u64> {
    let kibibytes: u64 = value_of(status, "VmHWM")?.strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

/// The value of the first line `key : value`.
fn value_of<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let mut pairs = text.lines().filter_map(|line| line.split_once(':'));
    pairs.find(|(name, _)| name.trim() == key).map(|(_, value)| value.trim())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_is_read_in_bytes() {
        let status = "Name:\twelder\nVmPeak:\t  9000 kB\nVmHWM:\t    2048 kB\nThreads:\t2\n";
        assert_eq!(peak_bytes(status), Some(2 * 1024 * 1024));
        assert_eq!(peak_bytes("VmHWM:\t many kB\n"), None);
        assert_eq!(peak_bytes(""), None);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_peak_grows_with_what_is_held() {
        let before = peak_memory_bytes().unwrap();
        let held = vec![1_u8; 2 * before as usize + 50_000_000];
        assert!(std::hint::black_box(&held).iter().all(|&byte| byte == 1));
        assert!(peak_memory_bytes().unwrap() > 2 * before);
    }

    #[test]
    #[cfg(unix)]
    fn processor_time_grows_with_work() {
        let before = process_cpu_s().unwrap();
        let work: f64 = (0..30_000_000).map(|index| std::hint::black_box(index as f64).sqrt()).sum();
        let spent = process_cpu_s().unwrap() - before;
        assert!(work > 0.0 && spent > 1e-3 && spent < 60.0, "{spent}");
    }

    #[test]
    fn the_first_processor_names_the_machine() {
        let described = "processor\t: 0\nmodel name\t: Some CPU @ 2.0 GHz\n\nmodel name\t: Other\n";
        assert_eq!(value_of(described, "model name"), Some("Some CPU @ 2.0 GHz"));
        assert!(Machine::here().cores >= 1);
    }
}
