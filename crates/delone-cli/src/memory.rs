//! How much memory the process has used.

/// Returns the largest resident set of this process so far, in bytes; `None` where unknown.
///
/// On Linux this is `VmHWM` of `/proc/self/status`. `getrusage` is not asked there: its maximum
/// survives `exec`, so a program started by a large parent would report the parent's size.
#[cfg(target_os = "linux")]
pub fn peak_rss_bytes() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes * 1024)
}

/// Returns the largest resident set of this process so far, in bytes; `None` where unknown.
#[cfg(all(unix, not(target_os = "linux")))]
pub fn peak_rss_bytes() -> Option<u64> {
    let mut usage = std::mem::MaybeUninit::<libc::rusage>::zeroed();
    // SAFETY: `usage` is valid for writes, and all-zero bytes are a valid `rusage`.
    let usage = unsafe {
        (libc::getrusage(libc::RUSAGE_SELF, usage.as_mut_ptr()) == 0).then(|| usage.assume_init())
    }?;
    let maximum = u64::try_from(usage.ru_maxrss).ok()?;
    // Apple counts bytes, everybody else kibibytes.
    let unit = if cfg!(target_vendor = "apple") {
        1
    } else {
        1024
    };
    Some(maximum * unit)
}

/// Returns the largest resident set of this process so far, in bytes; `None` where unknown.
#[cfg(not(unix))]
pub fn peak_rss_bytes() -> Option<u64> {
    None
}
