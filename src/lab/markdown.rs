//! Cells of Markdown tables.

/// A fraction in percent.
pub fn percent(fraction: f64) -> String {
    format!("{:.1} %", 100.0 * fraction)
}

/// A PSNR in decibels, or a dash if it is infinite since nothing differs.
pub fn decibels(psnr: f64) -> String {
    if psnr.is_finite() {
        format!("{psnr:.1} dB")
    } else {
        dash()
    }
}

/// A number with so many digits, or a dash if it was not measured.
pub fn known(number: Option<f64>, digits: usize) -> String {
    number.map_or_else(dash, |number| format!("{number:.digits$}"))
}

/// The dash that stands for no number.
pub fn dash() -> String {
    "-".to_owned()
}
