use super::controls::{Controls, FPS, KEYS};
use super::frame_viewer::FrameViewer;
use super::panel::Panel;
use super::subject::{Subject, ron};
use crate::output;
use anyhow::{Result, ensure};
use eightfold_harness::Size;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::input::{Input, Press};
use eightfold_window::render_target::{Next, RenderTarget, fit};
use eightfold_window::window::Window;
use std::ffi::CString;
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Short enough to follow, long enough to read.
const TITLE_EVERY: Duration = Duration::from_millis(500);

pub struct Session {
    window: Window,
    viewer: FrameViewer,
    controls: Controls,
    subject: Subject,
    has_keys: bool,
    panel: Panel,
}

impl Session {
    pub fn new(
        mut window: Window,
        viewer: FrameViewer,
        controls: Controls,
        subject: Subject,
    ) -> Self {
        window.listen();
        Self { window, viewer, controls, subject, has_keys: false, panel: Panel::default() }
    }

    /// Fails if the window is lost, or standard output is closed.
    pub fn play(&mut self) -> Result<()> {
        let mut last = Instant::now();
        let (mut counted_from, mut frames, mut fps) = (last, 0, None);
        loop {
            let now = Instant::now();
            self.take_inputs()?;
            self.subject.reload();
            self.controls.length = f64::from(self.subject.length()) * FPS;
            self.controls.advance((now - last).as_secs_f64() * FPS);
            last = now;
            let is_new = self.draw();
            if let Next::End(code) = self.window.show() {
                ensure!(code == 0, "window is lost");
                return Ok(());
            }
            frames += 1;
            let counted = now - counted_from;
            let is_due = counted >= TITLE_EVERY;
            if is_due {
                fps = Some(f64::from(frames) / counted.as_secs_f64());
                (counted_from, frames) = (now, 0);
            }
            if let Some(fps) = fps
                && (is_due || is_new && self.controls.is_paused)
            {
                self.window.set_title(&CString::new(self.title(fps))?);
            }
            sleep(Duration::from_secs_f64(1.0 / FPS).saturating_sub(now.elapsed()));
        }
    }

    fn take_inputs(&mut self) -> Result<()> {
        let size = self.window.size();
        for input in self.window.inputs() {
            let time = self.controls.time();
            match input {
                Input::Mouse(mouse) => self.subject.point(mouse, time, size),
                Input::Key(Press::Help) => self.has_keys = !self.has_keys,
                Input::Key(Press::Character('v')) => self.subject.reset_camera(),
                Input::Key(Press::Character('c')) => {
                    let text = ron(&self.subject.at(time).scene.camera);
                    output::write(Path::new("-"), text.as_bytes())?;
                }
                Input::Key(press) => self.controls.press(press),
            }
        }
        Ok(())
    }

    fn draw(&mut self) -> bool {
        let (width, height) = fit(self.window.size(), (MAX_WIDTH, MAX_HEIGHT));
        let size = Size::new(width, height);
        let is_new = self.viewer.draw(&self.controls, &self.subject, size);
        let canvas = self.window.canvas(size.width, size.height);
        canvas.copy_from_slice(&self.viewer.picture);
        let row = |(key, words): (&str, &str)| (key.to_owned(), words.to_owned());
        let mistake = self.subject.mistake().map(|mistake| row(("", mistake)));
        let keys = KEYS.map(row).into_iter().filter(|_| self.has_keys);
        self.panel.show(mistake.into_iter().chain(keys).collect(), canvas, size.width);
        is_new
    }

    fn title(&self, fps: f64) -> String {
        let (controls, figures) = (&self.controls, &self.viewer.figures);
        let state = if controls.is_paused { ", paused" } else { "" };
        let error = match figures.psnr {
            None => String::new(),
            Some((f64::INFINITY, _)) => ", exact".to_owned(),
            Some((psnr, margin)) => format!(", {psnr:.1} ± {margin:.1} dB to exhaustive"),
        };
        format!(
            "Eightfold: {}, {} at {:.2} s{state}; {fps:.0} fps, {:.2} ms a frame, {:.1} % traced{error}",
            controls.quality,
            controls.overlay.name(),
            controls.time(),
            figures.time.as_secs_f64() * 1e3,
            figures.points * 1e2,
        )
    }
}
