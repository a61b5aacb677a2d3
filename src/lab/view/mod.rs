//! `lab view`: plays the show in a window, in which keys select time, quality and overlay.

mod controls;
mod frame_viewer;

use crate::arguments::{self, NamedQuality, Size};
use crate::rate::Rate;
use crate::scenes::{self, SceneName};
use anyhow::{Result, anyhow};
use clap::Args;
use controls::{Controls, KEYS, Overlay};
use eightfold::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::cpu::{self, Isa};
use eightfold_window::input::Input;
use eightfold_window::screen::{Next, Screen};
use eightfold_window::window::Window;
use frame_viewer::{Figures, FrameViewer};
use std::ffi::CString;
use std::thread::{available_parallelism, sleep};
use std::time::{Duration, Instant};

/// Plays the show in a window, with time and quality under control, and shows what frames are made of
///
/// Drawing over a frame what it was made of takes longer than drawing it; the time in the title is that of the frame
/// alone.
#[derive(Args)]
#[command(after_help = format!("Keys:\n{KEYS}"))]
pub struct Arguments {
    #[arg(long, value_name = "NAME", default_value_t = SceneName::Show, help = scenes::takes())]
    scene: SceneName,
    /// Width and height of the window in pixels
    #[arg(long, value_name = "WxH", default_value = "1024x768")]
    size: Size,
    /// How frames are refined at first: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// Where to begin, in seconds
    #[arg(long, value_name = "SECONDS", default_value = "0", value_parser = from_start, allow_negative_numbers = true)]
    time: f32,
    /// Begins with a pause
    #[arg(long)]
    paused: bool,
    /// Frames a second of the show, a whole number or a fraction such as 30000/1001; as many are shown at most
    #[arg(
        long,
        value_name = "RATE",
        default_value = "60",
        allow_negative_numbers = true
    )]
    fps: Rate,
    /// Threads that share the work [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = arguments::threads)]
    threads: Option<usize>,
    /// Instruction set [default: the best of this machine]
    #[arg(long, value_name = "NAME", value_parser = arguments::instruction_set)]
    isa: Option<Isa>,
}

/// The time between updates of the title while the show plays: short enough to follow, long enough to read. Each update draws an
/// exhaustive frame.
const TITLE_EVERY: Duration = Duration::from_millis(500);

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let Size { width, height } = arguments.size;
    let mut window = Window::open(c"Eightfold", width, height)
        .map_err(|why| anyhow!("view needs a window: {why}"))?;
    window.listen();
    eprintln!("view: the key ? lists the keys");
    let threads = arguments
        .threads
        .unwrap_or_else(|| available_parallelism().map_or(1, usize::from));
    let rate = arguments.fps.hertz();
    let isa = arguments.isa.unwrap_or_else(cpu::best);
    let length = f64::from(arguments.scene.length()) * rate;
    let controls = Controls {
        frame: f64::from(arguments.time) * rate % length,
        length,
        is_paused: arguments.paused,
        quality: arguments.quality,
        overlay: Overlay::None,
    };
    View {
        window,
        viewer: FrameViewer::new(threads, isa, arguments.scene, rate),
        controls,
        rate,
    }
    .play();
    Ok(())
}

/// The window and its contents.
struct View {
    window: Window,
    viewer: FrameViewer,
    controls: Controls,
    /// The frame rate of the show, in frames per second.
    rate: f64,
}

impl View {
    fn play(&mut self) {
        let period = Duration::from_secs_f64(1.0 / self.rate);
        let mut last = Instant::now();
        let (mut counted_from, mut shown, mut fps) = (last, 0, None);
        loop {
            let now = Instant::now();
            self.take_presses();
            self.controls
                .advance((now - last).as_secs_f64() * self.rate);
            last = now;
            let counted = now - counted_from;
            let is_due = counted >= TITLE_EVERY;
            // While the show is paused there is time to measure.
            let measure = is_due || self.controls.is_paused;
            let is_new = self.draw(measure);
            if let Next::End(_) = self.window.show() {
                return;
            }
            if is_due {
                fps = Some(f64::from(shown) / counted.as_secs_f64());
                (counted_from, shown) = (now, 0);
            }
            shown += 1;
            if (is_due || is_new && measure)
                && let Ok(title) = CString::new(self.title(fps))
            {
                self.window.set_title(&title);
            }
            sleep(period.saturating_sub(now.elapsed()));
        }
    }

    /// Applies the pressed keys.
    fn take_presses(&mut self) {
        for input in self.window.inputs() {
            if let Input::Key(press) = input
                && self.controls.press(press)
            {
                eprintln!("{KEYS}");
            }
        }
    }

    /// Draws the frame into the window. Returns true if it is not the same as before.
    fn draw(&mut self, measure: bool) -> bool {
        let size = fit(self.window.size());
        let is_new = self.viewer.draw(&self.controls, size, measure);
        let canvas = self.window.canvas(size.width, size.height);
        canvas.copy_from_slice(&self.viewer.picture);
        is_new
    }

    /// The title: what is shown, how fast it is drawn, and its error.
    fn title(&self, fps: Option<f64>) -> String {
        let Controls {
            frame,
            quality,
            overlay,
            is_paused,
            ..
        } = self.controls;
        let Figures { time, points, psnr } = self.viewer.figures;
        let seconds = frame / self.rate;
        let state = if is_paused { ", paused" } else { "" };
        let fps = fps.map_or("-".to_owned(), |fps| format!("{fps:.0}"));
        let error = if psnr.is_finite() {
            format!("{psnr:.1} dB")
        } else {
            "exact".to_owned()
        };
        format!(
            "Eightfold: {quality}, {} at {seconds:.2} s{state}; {fps} fps, {:.2} ms a frame, {:.1} % traced, {error}",
            overlay.name(),
            time.as_secs_f64() * 1e3,
            points * 1e2,
        )
    }
}

/// The size of the picture for a window: the same, or the largest supported size of the same aspect ratio.
fn fit((width, height): (usize, usize)) -> Size {
    let across = MAX_WIDTH as f64 / width as f64;
    let down = MAX_HEIGHT as f64 / height as f64;
    let scale = across.min(down).min(1.0);
    let side = |side: usize, most| ((side as f64 * scale).round() as usize).clamp(1, most);
    Size {
        width: side(width, MAX_WIDTH),
        height: side(height, MAX_HEIGHT),
    }
}

/// Parses a time in the show.
fn from_start(text: &str) -> Result<f32, String> {
    let seconds = arguments::seconds(text).ok();
    seconds
        .filter(|&seconds| seconds >= 0.0)
        .ok_or_else(|| "takes seconds from 0 on, such as 2.5".to_owned())
}
