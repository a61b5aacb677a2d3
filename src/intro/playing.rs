use core::time::Duration;
use eightfold::sound::Synthesizer;
use eightfold_tracer::{AccuracyGovernor, Counts, Frame, Governor, MAX_HEIGHT, MAX_WIDTH, Preset};
use eightfold_window::clock::SECOND;
use eightfold_window::cpu::Isa;
use eightfold_window::enlarge::{self, Small};
use eightfold_window::line::{self, Writer};
use eightfold_window::render_target::{self, Headless, InnerSize, Next, RenderTarget, fit};
use eightfold_window::sound::{Player, Source};
use eightfold_window::static_cell::StaticCell;
use eightfold_window::terminal::Terminal;
use eightfold_window::window::Window;

use super::SHOW_NANOSECONDS;
use super::options::{FPS, Options, SIZE};
use super::renderer::ShowRenderer;
use super::tally::Tally;

struct Music(Synthesizer);

static MUSIC: StaticCell<Music> = StaticCell::new(Music(Synthesizer::new()));

/// Pixels above which a window starts with the fastest frames. The finest frames at 3840x2160 take
/// 0.13 s.
const LARGE: usize = 1920 * 1080;

/// Pixels up to which a window's frames are never drawn smaller: these take less than a tenth of
/// the frame's time.
const SMALLEST: usize = 320 * 240;

// Targets hold the largest frame.
const _: () =
    assert!(MAX_WIDTH == render_target::MAX_WIDTH && MAX_HEIGHT == render_target::MAX_HEIGHT);

impl Source for Music {
    fn chunk(&mut self) -> &[[f32; 2]] {
        self.0.chunk()
    }
}

pub fn play(options: &Options, isa: Isa, output: &mut Writer) -> i32 {
    // Open the window first: it starts a thread, and the pool can run on fewer. Open the terminal
    // last, after all messages.
    let size = options.size.unwrap_or(SIZE);
    let inner = match options.size {
        Some((width, height)) => InnerSize::Exactly(width, height),
        None => InnerSize::AtMost(SIZE.0, SIZE.1),
    };
    let window = Window::open(c"Eightfold", inner);
    if let Err(why) = &window {
        let place = if Terminal::is_there() {
            "; playing in the terminal"
        } else {
            "; playing without a screen"
        };
        line::complain(why, place);
    }
    let mut playing = Playing {
        options,
        player: if options.is_silent { Player::silent() } else { Player::start(MUSIC.take()) },
        renderer: ShowRenderer::new(options, isa),
        small: enlarge::small(),
        is_smooth: true,
        has_hud: options.has_hud,
        tally: Tally::default(),
    };
    let code = match window {
        Ok(mut window) => {
            if options.is_fullscreen {
                window.set_fullscreen(true);
            }
            playing.on(&mut window)
        }
        Err(_) => match Terminal::open() {
            Some(mut terminal) => {
                // Repeated pixels need fewer changes of the colour, so that a slow terminal is
                // faster.
                playing.is_smooth = false;
                playing.on(&mut terminal)
            }
            None => playing.on(&mut Headless::new(size)),
        },
    };
    playing.tally.report(output, &playing.renderer, options);
    code
}

struct Playing<'a> {
    options: &'a Options,
    player: Player,
    renderer: ShowRenderer,
    small: &'static mut [u32],
    is_smooth: bool,
    has_hud: bool,
    tally: Tally,
}

impl Playing<'_> {
    fn on(&mut self, target: &mut dyn RenderTarget) -> i32 {
        let options = self.options;
        let is_default = options.is_uncapped && options.psnr.is_none();
        let kept = options.quality.or(is_default.then_some(Preset::Default));
        let length =
            options.length.unwrap_or(if options.is_looping { u64::MAX } else { SHOW_NANOSECONDS });
        let interval = SECOND / options.fps.unwrap_or(FPS);
        let mut by_rate = Governor::new(Duration::from_nanos(interval));
        // A target accuracy counts for frames of full size.
        if options.psnr.is_none() && kept.is_none() {
            by_rate = by_rate.with_smaller_frames();
        }
        let mut by_accuracy = options.psnr.map(|psnr| AccuracyGovernor::new(psnr as f32));
        let clock = self.player.clock;
        let mut due = 0;
        let mut is_large = false;
        loop {
            let start = clock.time();
            let heard = self.player.time();
            if heard >= length {
                self.tally.time = start;
                return 0;
            }
            let size = fit(target.size(), (MAX_WIDTH, MAX_HEIGHT));
            let (pixels, was_large) = (size.0 * size.1, is_large);
            is_large = pixels > LARGE;
            if is_large && !was_large {
                by_rate.select_fastest();
            }
            let quality = kept.unwrap_or_else(|| match &by_accuracy {
                Some(governor) => governor.preset(),
                None => by_rate.preset(),
            });
            let can_divide = pixels > SMALLEST || !self.is_smooth;
            let divisor = if can_divide { by_rate.divisor() } else { 1 };
            let canvas = target.canvas(size.0, size.1);
            let counts = self.draw(canvas, size, divisor, quality, heard);
            let next = target.show();
            let end = clock.time();
            match &mut by_accuracy {
                Some(governor) => governor.frame(counts.probes),
                None => by_rate.frame(Duration::from_nanos(end - start)),
            }
            self.tally.count(end, size, divisor, quality, counts.probes);
            match next {
                Next::End(code) => return code,
                Next::Toggle => self.has_hud = !self.has_hud,
                Next::GoOn => {}
            }
            if !options.is_uncapped {
                // Does not catch up after a late frame. The last frame stops at the end.
                due = u64::max(due + interval, start);
                let end = start.saturating_add(length - heard);
                clock.sleep_until(due.min(end));
            }
        }
    }

    /// Draws a frame for a canvas of this size, with sides divided by `divisor`.
    fn draw(
        &mut self,
        canvas: &mut [u32],
        size: (usize, usize),
        divisor: usize,
        quality: Preset,
        time: u64,
    ) -> Counts {
        let [width, height] = [size.0, size.1].map(|side| side.div_ceil(divisor));
        let pixels = match divisor {
            1 => &mut *canvas,
            _ => &mut *self.small,
        };
        let mut frame = Frame::new(width, height, pixels);
        let (number, quality) = (self.tally.frames, quality.quality());
        let counts = self.renderer.draw(time, number, quality, &mut frame);
        if self.has_hud {
            self.tally.write(&mut frame, size, counts.points);
        }
        if divisor > 1 {
            let small = Small {
                pixels: self.small,
                width,
                height,
                factor: divisor as u32,
                is_smooth: self.is_smooth,
            };
            small.enlarge(self.renderer.pool(), canvas, size.0);
        }
        counts
    }
}
