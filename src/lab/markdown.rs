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

/// A column of a table: its title, and what a row says in it.
pub type Column<R> = (&'static str, fn(&R) -> String);

/// A table with a line for each row, in columns that line up as plain text too.
pub fn table<'a, R: 'a>(
    columns: &[Column<R>],
    rows: impl IntoIterator<Item = &'a R> + Clone,
) -> String {
    let columns: Vec<Vec<String>> = columns
        .iter()
        .map(|(title, cell)| {
            let cells = rows.clone().into_iter().map(cell);
            let cells: Vec<String> = [(*title).to_owned()].into_iter().chain(cells).collect();
            let width = cells.iter().map(|cell| cell.chars().count()).max();
            let width = width.unwrap_or(0).max(2);
            let mut cells: Vec<String> =
                cells.iter().map(|cell| format!("{cell:>width$}")).collect();
            cells.insert(1, format!("{}:", "-".repeat(width - 1)));
            cells
        })
        .collect();
    let lines = columns.first().map_or(0, Vec::len);
    let line = |i: usize| {
        let cells: Vec<&str> = columns.iter().map(|cells| cells[i].as_str()).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    (0..lines).map(line).collect()
}
