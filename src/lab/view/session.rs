//! The window and its contents, from its opening to its end.

use super::controls::{Controls, Overlay};
use super::frame_viewer::{Figures, FrameViewer};
use super::legend;
use super::panel::{Corner, Panel, Row};
use super::workspace::{Gesture, Shown, Workspace};
use crate::arguments::Size;
use crate::interrupt::{self, Stopped};
use anyhow::Result;
use eightfold_tracer::glam::DVec2;
use eightfold_tracer::{MAX_HEIGHT, MAX_WIDTH};
use eightfold_window::input::{Input, Press};
use eightfold_window::screen::{Next, Screen};
use eightfold_window::window::Window;
use std::ffi::CString;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The time between updates of the title while the show plays: short enough to follow, long enough to read. Each update draws an
/// exhaustive frame.
const TITLE_EVERY: Duration = Duration::from_millis(500);

/// The window and its contents.
pub struct Session {
    window: Window,
    viewer: FrameViewer,
    controls: Controls,
    workspace: Workspace,
    /// The frame rate of the show, in frames per second.
    rate: f64,
    panels: Panels,
    /// Whether the end was asked for in vain, as there are changes that are not saved.
    is_end_asked: bool,
}

/// The panels of text over the picture.
#[derive(Default)]
struct Panels {
    has_keys: bool,
    has_colours: bool,
    /// Whether to tell how the keys are shown.
    has_hint: bool,
    told: Panel,
    keys: Panel,
    colours: Panel,
    picked: Panel,
}

/// The hint that is shown at first.
const HINT: &str = "? shows keys and mouse";

impl Session {
    pub fn new(
        mut window: Window,
        viewer: FrameViewer,
        controls: Controls,
        workspace: Workspace,
        rate: f64,
    ) -> Self {
        window.listen();
        let has_hint = workspace.editor.is_some();
        Self {
            window,
            viewer,
            controls,
            workspace,
            rate,
            panels: Panels {
                has_colours: true,
                has_hint,
                ..Panels::default()
            },
            is_end_asked: false,
        }
    }

    /// Plays until the viewer ends it.
    ///
    /// # Errors
    /// [`Stopped`] if a signal ends it.
    pub fn play(&mut self) -> Result<()> {
        let period = Duration::from_secs_f64(1.0 / self.rate);
        let mut last = Instant::now();
        let (mut counted_from, mut shown, mut fps) = (last, 0, None);
        let mut title = String::new();
        loop {
            if interrupt::is_stopped() {
                let left = self.workspace.left_behind();
                let left = left.unwrap_or_else(|| "all changes are saved".to_owned());
                return Err(Stopped(left).into());
            }
            let now = Instant::now();
            self.take_inputs();
            self.workspace.look();
            self.controls.length = f64::from(self.workspace.length()) * self.rate;
            self.controls
                .advance((now - last).as_secs_f64() * self.rate);
            last = now;
            let counted = now - counted_from;
            let is_due = counted >= TITLE_EVERY;
            // While the show is paused there is time to measure.
            let measure = is_due || self.controls.is_paused;
            let is_new = self.draw(measure);
            if let Next::End(_) = self.window.show()
                && self.may_end()
            {
                return Ok(());
            }
            if is_due {
                fps = Some(f64::from(shown) / counted.as_secs_f64());
                (counted_from, shown) = (now, 0);
            }
            shown += 1;
            // A title must not be wrong about changes that are not saved.
            let is_outdated = self.workspace.is_unsaved() != title.contains(UNSAVED);
            if is_due || is_new && measure || is_outdated {
                title = self.title(fps);
                if let Ok(title) = CString::new(title.as_str()) {
                    self.window.set_title(&title);
                }
            }
            sleep(period.saturating_sub(now.elapsed()));
        }
    }

    /// Whether it may end: if all is saved, or if the viewer has been told that it is not.
    fn may_end(&mut self) -> bool {
        if self.workspace.is_unsaved() && !self.is_end_asked {
            self.is_end_asked = true;
            let what = "There are changes that are not saved. Ctrl-S saves them, Esc again leaves.";
            self.workspace.notice = Some(what.to_owned());
            return false;
        }
        if let Some(left) = self.workspace.left_behind() {
            eprintln!("view: {left}");
        }
        true
    }

    /// Does what keys and the mouse ask for.
    fn take_inputs(&mut self) {
        let window = self.window.size();
        let size = fit(window);
        for input in self.window.inputs() {
            let shown = Shown {
                time: (self.controls.frame / self.rate) as f32,
                size,
            };
            match input {
                Input::Key(press) => {
                    self.answered();
                    self.press(press, shown);
                }
                Input::Mouse(mouse) => {
                    let gesture = Gesture::new(mouse, window, size);
                    if gesture.is_new() {
                        self.answered();
                        self.workspace.notice = None;
                    }
                    self.workspace.point(gesture, shown);
                }
            }
        }
    }

    /// Takes back what was told, which the viewer has seen.
    fn answered(&mut self) {
        self.is_end_asked = false;
        self.panels.has_hint = false;
    }

    fn press(&mut self, press: Press, shown: Shown) {
        if self.workspace.press(press, shown) {
            return;
        }
        self.workspace.notice = None;
        match press {
            Press::Help => {
                self.panels.has_keys = !self.panels.has_keys;
                if self.panels.has_keys {
                    eprintln!("{}", legend::text());
                }
            }
            Press::Character('l') => self.panels.has_colours = !self.panels.has_colours,
            _ => self.controls.press(press),
        }
    }

    /// Draws the frame into the window, and what there is to tell over it. Returns true if the frame is not the same as before.
    fn draw(&mut self, measure: bool) -> bool {
        let size = fit(self.window.size());
        let time = (self.controls.frame / self.rate) as f32;
        let workspace = &self.workspace;
        let is_new = self.viewer.draw(
            &self.controls,
            workspace.version(),
            || workspace.scene(time),
            size,
            measure,
        );
        let canvas = self.window.canvas(size.width, size.height);
        canvas.copy_from_slice(&self.viewer.picture);
        let overlay = self.controls.overlay;
        self.panels.show(workspace, overlay, time, canvas, size);
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
        let unsaved = if self.workspace.is_unsaved() {
            UNSAVED
        } else {
            ""
        };
        let fps = fps.map_or("-".to_owned(), |fps| format!("{fps:.0}"));
        let error = if psnr.is_finite() {
            format!("{psnr:.1} dB")
        } else {
            "exact".to_owned()
        };
        format!(
            "Eightfold: {quality}, {} at {seconds:.2} s{state}{unsaved}; {fps} fps, {:.2} ms a frame, {:.1} % traced, {error}",
            overlay.name(),
            time.as_secs_f64() * 1e3,
            points * 1e2,
        )
    }
}

/// The words of the title for changes that are not saved.
const UNSAVED: &str = ", not saved";

impl Panels {
    /// Writes over the picture what there is to tell.
    fn show(
        &mut self,
        workspace: &Workspace,
        overlay: Overlay,
        time: f32,
        picture: &mut [u32],
        size: Size,
    ) {
        let line = |words: &str| Row {
            words: words.to_owned(),
            ..Row::default()
        };
        let mut told: Vec<Row> = Vec::new();
        if self.has_hint {
            told.push(line(HINT));
        }
        told.extend(workspace.fault.as_deref().map(line));
        let editor = workspace.editor.as_ref();
        let unkept = editor.and_then(|editor| editor.document.copy_fault());
        told.extend(unkept.map(|why| line(&format!("What is not saved is not kept: {why}"))));
        told.extend(workspace.notice.as_deref().map(line));
        let picked = editor.and_then(|editor| {
            let scene = workspace.scene(time);
            let picked = editor.picked?;
            let view = super::camera::View::of(&scene.camera, size);
            if let Some(frame) = picked.frame(&scene, &view) {
                draw_frame(frame, picture, size);
            }
            picked.words(&editor.document.scene, &scene)
        });
        let picked: Vec<Row> = picked.as_deref().map(line).into_iter().collect();
        self.picked.show(&picked, Corner::LowerLeft, picture, size);
        if self.has_colours {
            let rows = legend::colours(overlay);
            self.colours.show(&rows, Corner::LowerRight, picture, size);
        }
        if self.has_keys {
            let rows = legend::keys(editor.is_some());
            self.keys.show(&rows, Corner::UpperLeft, picture, size);
        }
        self.told.show(&told, Corner::UpperLeft, picture, size);
    }
}

/// Draws the corners of a rectangle, a quarter of a side each, in white on black.
fn draw_frame([from, to]: [DVec2; 2], picture: &mut [u32], size: Size) {
    let mut dot = |x: f64, y: f64, colour: u32| {
        let (x, y) = (x.floor(), y.floor());
        if x >= 0.0 && y >= 0.0 && x < size.width as f64 && y < size.height as f64 {
            picture[y as usize * size.width + x as usize] = colour;
        }
    };
    for (grown, colour) in [(3.0, 0), (2.0, 0x00ff_ffff)] {
        let (from, to) = (from - grown, to + grown);
        let reach = ((to - from) * 0.25).min(DVec2::splat(40.0));
        for (x, inwards) in [(from.x, 1.0), (to.x, -1.0)] {
            for (y, down) in [(from.y, 1.0), (to.y, -1.0)] {
                for step in 0..reach.x as i32 {
                    dot(x + inwards * f64::from(step), y, colour);
                }
                for step in 0..reach.y as i32 {
                    dot(x, y + down * f64::from(step), colour);
                }
            }
        }
    }
}

/// The size of the picture for a window: the same, or the largest supported size of the same aspect ratio.
fn fit((width, height): (usize, usize)) -> Size {
    let across = MAX_WIDTH as f64 / width as f64;
    let down = MAX_HEIGHT as f64 / height as f64;
    let scale = across.min(down).min(1.0);
    let side = |side: usize, most| ((side as f64 * scale).round() as usize).clamp(1, most);
    Size::new(side(width, MAX_WIDTH), side(height, MAX_HEIGHT))
}
