use eightfold_window::clock::SECOND;
use eightfold_window::line::{self, Writer};
use eightfold_window::terminal::Terminal;

use eightfold_tracer::{Frame, Preset, Probes, presentation::Caption};

use super::{options::Options, renderer::ShowRenderer};

/// Times are in nanoseconds.
#[derive(Default)]
pub struct Tally {
    pub frames: u64,
    /// From the start to the last frame, or to the end.
    pub time: u64,
    /// Frames in the slowest complete second.
    slowest: Option<u64>,
    second: u64,
    frames_in_second: u64,
    rate: u64,
    /// All probes, and recent ones, whose weight halves every second.
    probes: Probes,
    recent: Probes,
    /// The last frame's size, and its divisor.
    size: (usize, usize),
    divisor: usize,
    used: [u64; Preset::ALL.len()],
    /// The time in `used` with sides divided by 2 and by 3.
    divided: [u64; 2],
}

impl Tally {
    /// Counts a frame that was shown at `time`, drawn with its sides divided by `divisor`.
    pub fn count(
        &mut self,
        time: u64,
        size: (usize, usize),
        divisor: usize,
        quality: Preset,
        probes: Probes,
    ) {
        self.frames += 1;
        self.probes += probes;
        self.recent += probes;
        self.size = size;
        self.divisor = divisor;
        self.used[quality.index()] += time - self.time;
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

    /// Draws frame rate, points, size and recent accuracy onto a frame for a target of this `size`.
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

    pub fn report(&self, output: &mut Writer, renderer: &ShowRenderer, options: &Options) {
        let mean = self.frames * 10 * SECOND / self.time.max(1);
        let worst = self.slowest.map_or(mean, |frames| frames * 10);
        output.format(
            "# frames in % s: $ fps, worst second $ fps",
            &[self.frames, hundredths(self.time), mean, worst],
        );
        self.report_accuracy(output, options);
        let [width, height] = [self.size.0, self.size.1];
        let drawn = [width, height].map(|side| side.div_ceil(self.divisor.max(1)));
        let numbers = [drawn[0], drawn[1], width, height, renderer.threads()];
        let numbers = numbers.map(|number| number as u64);
        if self.divisor > 1 {
            output.format(", at #x# of #x#, threads #, ", &numbers);
        } else {
            output.format(", #x#, threads #, ", &numbers[2..]);
        }
        output.text(renderer.isa.name);
        let names = Preset::ALL.iter().map(|preset| preset.name());
        let times = self.used.iter().chain(&self.divided);
        for (name, &time) in names.chain(["halves", "thirds"]).zip(times) {
            if time > 0 {
                output.text(", ").text(name);
                output.format(" % s", &[hundredths(time)]);
            }
        }
        output.text("\n");
    }

    fn report_accuracy(&self, output: &mut Writer, options: &Options) {
        let [psnr, margin] = accuracy(&self.probes);
        if self.probes.squares > 0 {
            let is_latin = line::is_terminal(line::OUTPUT) && !Terminal::is_utf8();
            let text =
                if is_latin { ", $ +- $ dB to exhaustive" } else { ", $ ± $ dB to exhaustive" };
            output.format(text, &[psnr, margin]);
        }
        if let Some(asked) = options.psnr
            && psnr.saturating_add(margin) < 10 * asked
        {
            output.format(", short of # dB", &[asked]);
        }
    }
}

fn hundredths(time: u64) -> u64 {
    time / (SECOND / 100)
}

#[inline(never)]
fn line(letters: &[u8], middle: f32) -> Caption {
    Caption { letters: letters.iter().copied().collect(), middle, size: 0.03, brightness: 1.0 }
}

/// Returns the probes' PSNR and its 95 % margin in tenths of a dB.
fn accuracy(probes: &Probes) -> [u64; 2] {
    [probes.psnr(), probes.margin()].map(|decibels| (10.0 * decibels + 0.5) as u64)
}
