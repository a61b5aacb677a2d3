//! The built intro draws the bits of the library. Their module's name sorts early, since the build
//! takes longest.

use crate::cpu::{self, Isa};
use crate::drawn::{draw, show_at};
use crate::golden::{assert_golden, assert_golden_by_all};
use eightfold_stage::still;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_tracer::{Preset, presentation::Moment};

/// `time` is in milliseconds.
#[derive(Debug)]
struct Still {
    time: u32,
    quality: Preset,
    size: [usize; 2],
}

impl Still {
    fn scene(&self) -> Moment {
        show_at((f64::from(self.time) / 1000.0) as f32)
    }

    fn shipped(&self, isa: Isa, threads: usize) -> Vec<u32> {
        let (seconds, [width, height]) = (f64::from(self.time) / 1000.0, self.size);
        let (isa, quality) = (isa.name, self.quality);
        let frame = format!("--still {seconds:.3} --size {width}x{height}");
        let (read, pixels) =
            still(&format!("{frame} --quality {quality} --isa {isa} --threads {threads}"));
        assert_eq!([read, pixels.len()], [width, width * height]);
        pixels
    }

    fn assert_same(&self, several: impl Iterator<Item = Isa>) {
        for (isa, threads) in several.map(|isa| (isa, 3)).chain([(cpu::best(), 1)]) {
            let quality = self.quality.quality();
            let drawn = draw(isa, 2, &self.scene(), quality, self.size[0], self.size[1]).pixels;
            let is_same = self.shipped(isa, threads) == drawn;
            assert!(is_same, "{self:?} by {}, {threads} threads", isa.name);
        }
    }
}

/// Times in milliseconds, two or more in each scene except the method's. The oracle draws neither
/// captions nor coarse squares.
pub const TIMES: [u32; 18] = [
    2_300, 5_500, 13_300, 18_700, 21_500, 41_300, 46_400, 54_700, 57_400, 62_500, 69_900, 78_300,
    83_600, 90_700, 94_300, 102_800, 112_000, 113_500,
];

#[test]
#[ignore = "the intro is started many times"]
fn shipped_bits_match_by_every_quality() {
    for (i, quality) in Preset::ALL.into_iter().enumerate() {
        for time in [TIMES[i], TIMES[i + 7]] {
            Still { time, quality, size: [331, 217] }.assert_same(cpu::shipped());
        }
    }
}

#[test]
fn shipped_bits_match_at_every_size() {
    let quality = Preset::Exhaustive;
    for size in [[1, 1], [7, 3], [1, 100], [MAX_WIDTH, 9], [9, MAX_HEIGHT]] {
        Still { time: 17_300, quality, size }.assert_same(cpu::shipped());
    }
    let size = [MAX_WIDTH, MAX_HEIGHT];
    Still { time: 33_500, quality: Preset::Default, size }.assert_same(std::iter::empty());
}

#[test]
fn show_matches_golden_pictures() {
    // Times in milliseconds that show every scene and every position of a caption.
    for (name, time, quality) in [
        ("eclipse", 9_000, Preset::Exhaustive),
        ("still-life", 18_000, Preset::Exhaustive),
        ("method", 34_000, Preset::Thesis),
        ("city", 47_000, Preset::Exhaustive),
        ("chimes", 60_300, Preset::Exhaustive),
        ("bubbles", 76_500, Preset::Exhaustive),
        ("planet", 86_000, Preset::Exhaustive),
        ("coarse", 92_300, Preset::Thesis),
        ("kaleidoscope", 100_400, Preset::Exhaustive),
        ("finale", 110_000, Preset::Exhaustive),
        ("end", 115_550, Preset::Exhaustive),
    ] {
        let still = Still { time, quality, size: [320, 180] };
        let name = format!("show-{name}");
        assert_golden_by_all(&name, &still.scene(), quality.quality(), [320, 180]);
        let shipped = cpu::shipped().map(|isa| (isa.name, still.shipped(isa, 2)));
        assert_golden(&name, 320, &shipped.collect::<Vec<_>>());
    }
}
