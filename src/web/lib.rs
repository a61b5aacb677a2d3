//! The crate of the page: the show for browsers.
//!
//! Each worker, the sound and the page have an instance of this module, with one thread, so the
//! mutexes never wait. Numbers, pixels and samples need no wasm-bindgen. Names must differ from the
//! C library's, for native tests. A returned text is zero-terminated.

mod inspector;
mod share;

use eightfold::show;
use eightfold::sound::{self, Synthesizer};
use eightfold_scene_file::SceneFile;
use eightfold_tracer::presentation::{Method, Moment, Presentation};
use eightfold_tracer::{
    Counts, Frame, Governor, Level, Memory, Preset, Probes, Quality, Renderer, Worker,
};
use inspector::Inspector;
use share::{Share, rows_of};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Initially zero, so it takes no space in the module's file.
struct Workspace {
    memory: Memory,
    worker: Worker,
    moment: Moment,
    synthesizer: Synthesizer,
    samples: [[f32; 2]; SAMPLES],
}

struct State {
    quality: Quality,
    width: usize,
    height: usize,
    pixels: Vec<u32>,
    /// See [`figures`].
    figures: [f64; 7],
    governor: Option<Governor>,
    text: Vec<u8>,
    file: Option<SceneFile>,
}

impl State {
    /// Returns the address of a text, valid until the next one.
    fn store_text(&mut self, text: String) -> *const u8 {
        self.text = text.into_bytes();
        self.text.push(0);
        self.text.as_ptr()
    }
}

/// The maximum for [`play`]; browsers request this number.
const SAMPLES: usize = 128;

static WORKSPACE: Mutex<Workspace> = Mutex::new(Workspace {
    memory: Memory::new(),
    worker: Worker::new(),
    moment: Moment::ZEROED,
    synthesizer: Synthesizer::new(),
    samples: [[0.0; 2]; SAMPLES],
});

static STATE: Mutex<State> = Mutex::new(State {
    quality: Quality::DEFAULT,
    width: 0,
    height: 0,
    pixels: Vec::new(),
    figures: [0.0; 7],
    governor: None,
    text: Vec::new(),
    file: None,
});

fn workspace() -> MutexGuard<'static, Workspace> {
    WORKSPACE.lock().unwrap_or_else(PoisonError::into_inner)
}

fn state() -> MutexGuard<'static, State> {
    STATE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns JSON: the show's length and its scenes' starts in seconds, the qualities from the most
/// accurate on, the default quality, the probes per frame, and the sampling rate.
#[unsafe(no_mangle)]
pub extern "C" fn about() -> *const u8 {
    let scenes = show::NAMES.iter().zip(show::CUTS).map(|(name, bar)| {
        let start = bar as f32 * show::tempo::BAR;
        format!(r#"{{"name":"{name}","start":{start}}}"#)
    });
    let scenes: Vec<_> = scenes.collect();
    // The last one, `thesis`, is not offered.
    let names = &Preset::ALL.map(Preset::name)[..Preset::Thesis.index()];
    let text = format!(
        r#"{{"length":{},"scenes":[{}],"qualities":["{}"],"default":{},"probes":{},"rate":{}}}"#,
        show::LENGTH,
        scenes.join(","),
        names.join("\",\""),
        Preset::Default.index(),
        Frame::PROBES,
        sound::RATE,
    );
    state().store_text(text)
}

/// Sets the next frames' size. Returns the address of their pixels, a word each, valid until the
/// size changes.
#[unsafe(no_mangle)]
pub extern "C" fn resize(width: usize, height: usize) -> *mut u32 {
    let mut state = state();
    (state.width, state.height) = (width, height);
    state.pixels.clear();
    state.pixels.resize(width * height, 0);
    state.pixels.as_mut_ptr()
}

/// Sets the scene to the show's at a time in seconds; a resting picture has no transition.
#[unsafe(no_mangle)]
pub extern "C" fn set_show(time: f32, is_resting: bool) {
    let moment = &mut workspace().moment;
    if is_resting {
        show::without_transition(time, moment);
    } else {
        show::at(time, moment);
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn set_model(time: f32) {
    let Moment { scene, presentation } = &mut workspace().moment;
    show::model(time, scene);
    *presentation = Presentation::PLAIN;
}

/// Returns the address of space for a UTF-8 text.
#[unsafe(no_mangle)]
pub extern "C" fn room(bytes: usize) -> *mut u8 {
    let mut state = state();
    state.text = vec![0; bytes];
    state.text.as_mut_ptr()
}

/// Parses the text in [`room`] as a scene file. Returns the error, or an empty text.
#[unsafe(no_mangle)]
pub extern "C" fn read_file() -> *const u8 {
    let mut state = state();
    let text = String::from_utf8_lossy(&state.text).into_owned();
    let message = match SceneFile::parse("scene", &text) {
        Ok(file) => {
            state.file = Some(file);
            String::new()
        }
        Err(message) => message,
    };
    state.store_text(message)
}

/// Returns the length of the scene file in seconds; 0 without one.
#[unsafe(no_mangle)]
pub extern "C" fn length() -> f32 {
    state().file.as_ref().map_or(0.0, |file| file.length)
}

#[unsafe(no_mangle)]
pub extern "C" fn set_file(time: f32) {
    if let Some(file) = &state().file {
        workspace().moment = file.at(time % file.length);
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn set_method(points: f32, squares: f32, picture: f32, coarse: f32) {
    let presentation = &mut workspace().moment.presentation;
    presentation.method = Method { points, squares, picture, coarse, ..Method::PLAIN };
    presentation.captions.clear();
}

/// Sets the quality by its index in [`about`]; `is_reference` selects the reference of its error.
/// Returns whether that index exists.
#[unsafe(no_mangle)]
pub extern "C" fn set_quality(place: usize, is_reference: bool) -> bool {
    let quality = Preset::ALL.get(place).map(|preset| preset.quality());
    if let Some(quality) = quality {
        state().quality = if is_reference { quality.reference() } else { *quality };
    }
    quality.is_some()
}

/// Draws the bands that begin in rows `from..to` in one pass of the frame, see `share`. `before` is
/// the number of points in all workers' previous passes. The seed selects the probed pixels.
/// Returns the frame's number of passes.
#[unsafe(no_mangle)]
pub extern "C" fn draw(
    from: usize,
    to: usize,
    pass: usize,
    before: f64,
    probes: u16,
    seed: u32,
) -> usize {
    let (space, state) = (&mut *workspace(), &mut *state());
    let Moment { scene, presentation } = &space.moment;
    let mut done = Counts::NONE;
    done.points = before as u64;
    let rows = rows_of(presentation, from..to, state.height);
    let mut share = Share::new(&mut space.worker, rows, pass, done);
    let mut renderer = Renderer::narrow(Level::baseline(), &mut space.memory);
    let frame = Frame::new(state.width, state.height, &mut state.pixels);
    let frame = frame.with_probes(probes, seed).with_presentation(presentation);
    renderer.render_valid(scene, &state.quality, frame, &mut share);
    let counts = share.counts;
    state.figures = [
        share.drawn[0] as f64,
        share.drawn[1] as f64,
        counts.points as f64,
        (counts.rays + counts.shadow_rays) as f64,
        counts.probes.pixels as f64,
        counts.probes.squares as f64,
        counts.probes.fourths as f64,
    ];
    share.passes
}

/// Returns seven numbers about the last [`draw`]: its first row, and the row after its last
/// (smaller if it drew none); points, rays, and probed pixels; the sums of their squared errors and
/// of those values' squares.
#[unsafe(no_mangle)]
pub extern "C" fn figures() -> *const f64 {
    state().figures.as_ptr()
}

/// Returns the PSNR in dB from the probes' sums, see [`Probes::psnr`].
#[unsafe(no_mangle)]
pub extern "C" fn psnr(pixels: f64, squares: f64, fourths: f64) -> f32 {
    probes(pixels, squares, fourths).psnr()
}

/// Returns the half width in dB of the PSNR's interval for `all` pixels, see
/// [`Probes::margin_at_rest`].
#[unsafe(no_mangle)]
pub extern "C" fn margin(pixels: f64, squares: f64, fourths: f64, all: f64) -> f32 {
    probes(pixels, squares, fourths).margin_at_rest(all as u64)
}

fn probes(pixels: f64, squares: f64, fourths: f64) -> Probes {
    let mut probes = Probes::NONE;
    [probes.pixels, probes.squares, probes.fourths] =
        [pixels, squares, fourths].map(|sum| sum as u64);
    probes
}

/// Draws the bands that begin in rows `from..to`. Returns JSON about the squares with the pixel (x,
/// y), and the points around it.
#[unsafe(no_mangle)]
pub extern "C" fn inspect(from: usize, to: usize, x: usize, y: usize) -> *const u8 {
    let (space, state) = (&mut *workspace(), &mut *state());
    let inspector = Inspector::new(x, y);
    let Moment { scene, presentation } = &space.moment;
    let frame = Frame::new(state.width, state.height, &mut state.pixels);
    let frame = frame.with_presentation(presentation);
    let mut share = Share::new(&mut space.worker, from..to, 0, Counts::NONE);
    let mut renderer = Renderer::narrow(Level::baseline(), &mut space.memory);
    let _ = renderer.render_observed(scene, &state.quality, frame, &mut share, &inspector);
    state.store_text(inspector.json())
}

/// Converts rows to a canvas' RGBA bytes. Draw them again before the next call.
#[unsafe(no_mangle)]
pub extern "C" fn colour(from: usize, to: usize) {
    let state = &mut *state();
    for pixel in &mut state.pixels[from * state.width..to * state.width] {
        *pixel = pixel.swap_bytes() >> 8 | 0xff00_0000;
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn restart_sound() {
    workspace().synthesizer.seek(0);
}

/// Returns the address of at most `SAMPLES` next samples, left and right alternating. The song
/// repeats.
#[unsafe(no_mangle)]
pub extern "C" fn play(count: usize) -> *const f32 {
    let space = &mut *workspace();
    space.synthesizer.play(&mut space.samples[..count]);
    space.samples.as_flattened().as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn govern(frames_per_second: u32) {
    let budget = Duration::from_secs(1) / frames_per_second.max(1);
    state().governor = Some(Governor::new(budget));
}

/// Passes a frame's time in nanoseconds to the governor. Returns the index of the next frame's
/// quality.
#[unsafe(no_mangle)]
pub extern "C" fn governed(nanoseconds: f64) -> usize {
    let mut state = state();
    let budget = Duration::from_secs(1) / 60;
    let governor = state.governor.get_or_insert_with(|| Governor::new(budget));
    governor.frame(Duration::from_nanos(nanoseconds as u64));
    governor.preset().index()
}

#[cfg(test)]
#[test]
fn quality_beyond_the_last_is_ignored() {
    assert!(set_quality(Preset::Fastest.index(), false));
    assert!(!set_quality(Preset::ALL.len(), false));
    assert_eq!(&state().quality, Preset::Fastest.quality());
}
