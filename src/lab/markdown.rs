pub fn percent(fraction: f64) -> String {
    format!("{:.1} %", 100.0 * fraction)
}

/// Formats `digits` decimals, or a dash for unknown or infinite numbers, such as the PSNR of equal pictures.
pub fn known(number: impl Into<Option<f64>>, digits: usize) -> String {
    match number.into().filter(|number| number.is_finite()) {
        Some(number) => format!("{number:.digits$}"),
        None => "-".to_owned(),
    }
}

pub type Column<R> = (&'static str, fn(&R) -> String);

/// Aligns columns in plain text, too.
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
