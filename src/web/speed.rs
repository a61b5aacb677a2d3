//! Draws frames of the model scene for `speed.mjs`. A line of input has a quality's index and
//! seconds, a line of output the processor time in milliseconds.

use cpu_time::ThreadTime;
use eightfold_tracer::Frame;
use eightfold_web::{draw, resize, set_model, set_quality};
use std::io::{BufRead, Error, Write, stdin, stdout};
use std::process::exit;

fn main() {
    run().unwrap_or_else(|error| {
        eprintln!("speed: {error}");
        exit(1)
    });
}

fn run() -> Result<(), Error> {
    let (width, height) = (1024, 768);
    resize(width, height);
    for line in stdin().lock().lines() {
        let line = line?;
        let order = line
            .split_once(' ')
            .and_then(|(place, time)| Some((place.parse().ok()?, time.parse().ok()?)));
        let message = || format!("line is '{line}'; must be QUALITY SECONDS");
        let (place, time) = order.ok_or_else(|| Error::other(message()))?;
        let start = ThreadTime::now();
        set_model(time);
        if !set_quality(place, false) {
            return Err(Error::other(message()));
        }
        let (mut pass, mut passes) = (0, 1);
        while pass < passes {
            passes = draw(0, height, pass, 0.0, Frame::PROBES, pass as u32);
            pass += 1;
        }
        writeln!(stdout(), "{}", start.elapsed().as_secs_f64() * 1e3)?;
        stdout().flush()?;
    }
    Ok(())
}
