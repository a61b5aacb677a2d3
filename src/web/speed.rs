//! Draws frames of the model scene as `speed.mjs` asks for them, by the same functions as the page, compiled for this machine. A line of
//! input is the place of a quality and a time in seconds, a line of output the milliseconds that the frame took of a processor.

use eightfold_web::{draw, resize, set_model, set_quality};
use std::io::{BufRead, Error, Write, stdin, stdout};

/// The nanoseconds that this process has had a processor, as Linux counts them.
fn processor_time() -> Result<f64, Error> {
    let text = std::fs::read_to_string("/proc/self/schedstat")?;
    let first = text.split_whitespace().next().unwrap_or_default();
    first.parse().map_err(Error::other)
}

fn main() -> Result<(), Error> {
    let (width, height) = (1024, 768);
    resize(width, height);
    for line in stdin().lock().lines() {
        let line = line?;
        let (place, time) = line.split_once(' ').unwrap_or_default();
        let before = processor_time()?;
        set_model(time.parse().map_err(Error::other)?);
        set_quality(place.parse().map_err(Error::other)?, false);
        let (mut pass, mut passes) = (0, 1);
        while pass < passes {
            passes = draw(0, height, pass, 0.0, pass as u32);
            pass += 1;
        }
        writeln!(stdout(), "{}", (processor_time()? - before) / 1e6)?;
        stdout().flush()?;
    }
    Ok(())
}
