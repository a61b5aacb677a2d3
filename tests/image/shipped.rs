use crate::cpu::{self, Isa};
use crate::drawn::{draw, shown};
use eightfold_stage::{linked_intro, reader::read_ppm};
use eightfold_tracer::Preset;
use eightfold_tracer::scene::Moment;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use std::process::Command;

#[derive(Clone, Copy)]
pub struct Still {
    /// In milliseconds.
    pub time: u32,
    pub quality: Preset,
    pub width: usize,
    pub height: usize,
}

impl Still {
    pub fn new(time: u32, quality: Preset, width: usize, height: usize) -> Self {
        Self { time, quality, width, height }
    }

    pub fn scene(&self) -> Moment {
        shown((f64::from(self.time) / 1000.0) as f32)
    }

    pub fn shipped(&self, isa: Isa, threads: usize) -> Vec<u32> {
        let (seconds, milliseconds) = (self.time / 1000, self.time % 1000);
        let output = Command::new(linked_intro())
            .args(["--still", &format!("{seconds}.{milliseconds:03}")])
            .args(["--size", &format!("{}x{}", self.width, self.height)])
            .args(["--quality", self.quality.name(), "--isa", isa.name])
            .args(["--threads", &threads.to_string()])
            .output()
            .expect("the intro starts");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && errors.is_empty(), "{errors}");
        let (width, pixels) = read_ppm(&output.stdout);
        assert_eq!((width, pixels.len()), (self.width, self.width * self.height));
        pixels
    }

    pub fn drawn(&self, isa: Isa) -> Vec<u32> {
        let quality = self.quality.quality();
        draw(isa, 2, &self.scene(), quality, self.width, self.height).pixels
    }

    fn assert_same(&self) {
        let several = cpu::shipped().map(|isa| (isa, 3));
        for (isa, threads) in several.chain([(cpu::best(), 1)]) {
            let what = format!(
                "{} ms, {}x{}, {} by {}, {threads} threads",
                self.time, self.width, self.height, self.quality, isa.name
            );
            assert!(self.shipped(isa, threads) == self.drawn(isa), "{what}");
        }
    }
}

/// Times in milliseconds, two or more in each scene except the method's, without captions and coarse squares, which the oracle does
/// not draw.
pub const TIMES: [u32; 18] = [
    2_300, 5_500, 13_300, 18_700, 21_500, 41_300, 45_200, 54_700, 57_400, 62_500, 69_900, 78_300,
    83_600, 90_700, 94_300, 102_800, 112_000, 113_500,
];

#[test]
#[ignore = "the intro is started many times"]
fn shipped_bits_match_by_every_quality() {
    for (i, quality) in Preset::ALL.into_iter().enumerate() {
        for time in [TIMES[i], TIMES[i + 7]] {
            Still::new(time, quality, 331, 217).assert_same();
        }
    }
}

#[test]
fn shipped_bits_match_at_every_size() {
    for (width, height) in [(1, 1), (7, 3), (1, 100), (MAX_WIDTH, 9), (9, MAX_HEIGHT)] {
        Still::new(17_300, Preset::Exhaustive, width, height).assert_same();
    }
    let quality = "default".parse().expect("a quality");
    let largest = Still::new(33_500, quality, MAX_WIDTH, MAX_HEIGHT);
    let isa = cpu::best();
    assert!(largest.shipped(isa, 2) == largest.drawn(isa));
}
