use eightfold_window::{clock::SECOND, line::Writer};

use eightfold_tracer::{
    Frame, Probes,
    scene::{Caption, List},
};

use super::{options::Options, qualities::NAMED};

/// Times are in nanoseconds.
#[derive(Default)]
pub struct Tally {
    frames: u64,
    /// From the start to the last frame, or to the end.
    time: u64,
    /// Frames in the slowest complete second.
    slowest: Option<u64>,
    second: u64,
    frames_in_second: u64,
    /// Frames in the last complete second.
    rate: u64,
    /// All probes, and recent ones, whose weight halves every second.
    probes: Probes,
    recent: Probes,
    /// The last frame's size, and the number that divided its sides.
    size: (usize, usize),
    divisor: usize,
    used: [u64; NAMED.len()],
    /// The time in `used` with sides divided by 2 and by 3.
    divided: [u64; 2],
}

impl Tally {
    pub fn frames(&self) -> u64 {
        self.frames
    }

    /// Counts a frame that was shown at `time`, drawn with its sides divided by `divisor`. `quality` is an index in [`NAMED`].
    pub fn count(
        &mut self,
        time: u64,
        size: (usize, usize),
        divisor: usize,
        quality: usize,
        probes: Probes,
    ) {
        self.frames += 1;
        self.probes += probes;
        self.recent += probes;
        self.size = size;
        self.divisor = divisor;
        self.used[quality] += time - self.time;
        if divisor > 1 {
            self.divided[divisor - 2] += time - self.time;
        }
        self.time = time;
        let second = time / SECOND;
        if second != self.second {
            // A frame longer than a second leaves a second without frames.
            let is_next = second == self.second + 1;
            let frames = if is_next { self.frames_in_second } else { 0 };
            self.slowest = Some(self.slowest.map_or(frames, |slowest| slowest.min(frames)));
            self.second = second;
            self.frames_in_second = 0;
            self.rate = frames;
            self.recent.halve();
        }
        self.frames_in_second += 1;
    }

    /// Draws frame rate, points, size, and recent accuracy with its 95 % interval onto a frame for a target of this `size`.
    pub fn write(&self, frame: &mut Frame<'_>, size: (usize, usize), points: u64) {
        let sizes = [frame.width, frame.height, size.0, size.1];
        frame.write(&[line(b" #### X $$$$ OF %%%% X &&&&", 0.09)], sizes);
        let hud = [
            line(b" #### FPS $$$$$$$ POINTS", 0.04),
            line(b"  %%.% / &&.& DB TO EXHAUSTIVE", 0.14),
        ];
        let lines = 1 + usize::from(self.recent.squares > 0);
        let [psnr, margin] = accuracy(&self.recent);
        let numbers = [self.rate, points, psnr, margin].map(|number| number as usize);
        frame.write(&hud[..lines], numbers);
    }

    pub fn end(&mut self, time: u64) {
        self.time = time;
    }

    pub fn report(&self, output: &mut Writer, threads: usize, options: &Options) {
        let mean = self.frames * 10 * SECOND / self.time.max(1);
        let worst = self.slowest.map_or(mean, |frames| frames * 10);
        output.decimal(self.frames).text(" frames in ");
        output.hundredths(hundredths(self.time)).text(" s: ");
        output.tenths(mean).text(" fps, worst second ");
        output.tenths(worst).text(" fps");
        self.report_accuracy(output, mean, options);
        let sides = [self.size.0, self.size.1];
        if self.divisor > 1 {
            let drawn = sides.map(|side| side.div_ceil(self.divisor));
            write_size(output.text(", at "), drawn).text(" of ");
        } else {
            output.text(", ");
        }
        write_size(output, sides)
            .text(", threads ")
            .decimal(threads as u64);
        output.text(", ").text(options.isa.name);
        let names = NAMED.iter().map(|&(name, _)| name);
        let times = self.used.iter().chain(&self.divided);
        for (name, &time) in names.chain(["halves", "thirds"]).zip(times) {
            if time > 0 {
                output.text(", ").text(name);
                output.text(" ").hundredths(hundredths(time)).text(" s");
            }
        }
        output.text("\n");
    }

    /// Writes the accuracy with its 95 % interval, and missed goals. `rate` is in tenths of a frame per second.
    fn report_accuracy(&self, output: &mut Writer, rate: u64, options: &Options) {
        let [psnr, margin] = accuracy(&self.probes);
        if self.probes.squares > 0 {
            output.text(", ").tenths(psnr);
            output.text(" ± ").tenths(margin).text(" dB to exhaustive");
        }
        let Options { fps, has_fps, .. } = *options;
        // The rate may be 1 % short.
        let is_slow = has_fps && rate * 10 < fps * 99;
        match options.psnr {
            Some(asked) if is_slow || psnr.saturating_add(margin) < 10 * asked => {
                output.text(", short of ").decimal(asked).text(" dB");
                if has_fps {
                    output.text(" at ").decimal(fps).text(" fps");
                }
            }
            _ => {}
        }
    }
}

fn write_size(output: &mut Writer, [width, height]: [usize; 2]) -> &mut Writer {
    output.decimal(width as u64).text("x");
    output.decimal(height as u64)
}

fn hundredths(time: u64) -> u64 {
    time / (SECOND / 100)
}

fn line<const N: usize>(letters: &[u8; N], middle: f32) -> Caption {
    Caption {
        letters: List::of(letters),
        middle,
        size: 0.03,
        brightness: 1.0,
    }
}

/// Returns the probes' PSNR and its 95 % margin in tenths of a dB.
fn accuracy(probes: &Probes) -> [u64; 2] {
    [probes.psnr(), probes.margin()].map(|decibels| (10.0 * decibels + 0.5) as u64)
}
