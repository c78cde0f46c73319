//! Memory: how much of it there is.

use crate::stop::Stop;
use std::fs;
use std::path::Path;

/// Refuses what needs more bytes than can be had; `what` is told, and what would be `valid`.
pub fn suffices(what: &str, needed: u64, valid: &str) -> Result<(), Stop> {
    fits(what, needed, available(), valid)
}

fn fits(what: &str, needed: u64, available: Option<u64>, valid: &str) -> Result<(), Stop> {
    match available.filter(|available| *available < needed) {
        None => Ok(()),
        Some(available) => {
            let why = format!("takes up to {needed} bytes of memory, and {available} can be had; valid: {valid}");
            Err(Stop::at(what, why))
        }
    }
}

/// What can still be had [B]: of the machine and of the groups that this process is in, as far as the system tells.
fn available() -> Option<u64> {
    let machine = fs::read_to_string("/proc/meminfo").ok();
    let machine = machine.and_then(|text| value(&text, "MemAvailable:")).map(|kibibytes| kibibytes << 10);
    let groups = fs::read_to_string("/proc/self/cgroup").unwrap_or_default();
    machine.into_iter().chain(groups.lines().filter_map(of_group)).min()
}

/// The files of a group: where they are, the limit, what is used, and under which key how much of that can be freed.
type Files = (&'static str, &'static str, &'static str, &'static str);

const FIRST: Files = ("/sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_cache");
const SECOND: Files = ("/sys/fs/cgroup", "memory.max", "memory.current", "file");

/// What is left [B] in a group, of a line of `/proc/self/cgroup`, and in those around it.
fn of_group(line: &str) -> Option<u64> {
    let (controllers, group) = line.split_once(':')?.1.split_once(':')?;
    let (root, limit, used, freed) = match controllers {
        "" => SECOND,
        some if some.split(',').any(|one| one == "memory") => FIRST,
        _ => return None,
    };
    let of = |group: &Path| {
        let folder = Path::new(root).join(group.strip_prefix("/").unwrap_or(group));
        let [limit, used, stat] = [limit, used, "memory.stat"].map(|file| fs::read_to_string(folder.join(file)));
        left(&limit.ok()?, &used.ok()?, value(&stat.unwrap_or_default(), freed))
    };
    Path::new(group).ancestors().filter_map(of).min()
}

/// What a limit leaves [B] beside what is used, of which some can be freed; None of no limit.
fn left(limit: &str, used: &str, freed: Option<u64>) -> Option<u64> {
    let number = |text: &str| text.trim().parse::<u64>().ok();
    let used = number(used)?.saturating_sub(freed.unwrap_or(0));
    Some(number(limit)?.saturating_sub(used))
}

/// The number after a key at the beginning of a line.
fn value(text: &str, key: &str) -> Option<u64> {
    let rest =
        text.lines().find_map(|line| line.strip_prefix(key).filter(|rest| rest.starts_with(char::is_whitespace)));
    rest?.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_systems_say_is_read() {
        let text = "MemTotal:  24684084 kB\nMemAvailable:   22951312 kB\nfile_mapped 3\nfile 17\n";
        assert_eq!(
            (value(text, "MemAvailable:"), value(text, "file"), value(text, "Mem")),
            (Some(22_951_312), Some(17), None)
        );
        assert_eq!(left("1000\n", "300\n", Some(100)), Some(800));
        assert_eq!(left("1000", "3000", None), Some(0));
        assert_eq!(left("max", "300", None), None);
    }

    #[test]
    fn more_than_there_is_is_refused_with_both_numbers() {
        assert!(fits("it", 100, Some(100), "less").is_ok() && fits("it", u64::MAX, None, "less").is_ok());
        let refused = fits("it", 101, Some(100), "less").unwrap_err().to_string();
        assert_eq!(refused, "it: takes up to 101 bytes of memory, and 100 can be had; valid: less");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn this_machine_has_some() {
        assert!(available().is_some_and(|bytes| bytes > 0));
    }
}
