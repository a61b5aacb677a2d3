use crate::arguments::processors;
use std::fs;

pub fn mean(numbers: &[f64]) -> Option<f64> {
    (!numbers.is_empty()).then(|| numbers.iter().sum::<f64>() / numbers.len() as f64)
}

/// Averages the middle two of an even number.
pub fn median(times: &[f64]) -> f64 {
    let times = sorted(times);
    let middle = times.len() / 2;
    if times.len().is_multiple_of(2) {
        0.5 * (times[middle - 1] + times[middle])
    } else {
        times[middle]
    }
}

/// Returns the smallest time that `percent` % of the times do not exceed.
pub fn percentile(times: &[f64], percent: usize) -> f64 {
    sorted(times)[(times.len() * percent).div_ceil(100) - 1]
}

fn sorted(times: &[f64]) -> Vec<f64> {
    let mut times = times.to_vec();
    times.sort_by(f64::total_cmp);
    times
}

pub fn machine() -> String {
    let info = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let models = info.lines().filter(|line| line.starts_with("model name"));
    let model = models.filter_map(|line| line.split_once(": ")).next();
    let model = model.map_or("unknown processor", |(_, model)| model);
    format!("{model}, {} processors", processors())
}
