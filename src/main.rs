//! The intro: plays the show in a window, in a terminal, or unseen.

#![no_main]
#![deny(unsafe_code)]

mod options;
mod parts;

use core::{mem::ManuallyDrop, num::NonZero};

use eightfold::scene::Scene;
use eightfold::sound::Synthesizer;
use eightfold::{Band, Governor, MAX_HEIGHT, MAX_WIDTH, Memory, Quality, Worker, render, show};
use eightfold_window::{
    arguments::Arguments,
    clock::{Clock, SECOND},
    cpu::{self, Isa},
    fixed::Fixed,
    line::{self, Line},
    pool::{self, Pool},
    screen::{Next, Screen, Unseen},
    sound::{Player, Source},
    terminal::Terminal,
    window::{NoWindow, Window},
};
use options::{
    FULLSCREEN, LOOP, MAX_THREADS, Options, QUALITY, SECONDS, SILENT, SIZE, THREADS, UNCAPPED,
    names,
};

/// Nanoseconds of the show.
const LENGTH: u64 = (show::grid::LENGTH as f64 * SECOND as f64) as u64;

static STATE: Fixed<State> = Fixed::new(State {
    options: Options::NONE,
    tally: Tally::NONE,
    scene: Scene::ZEROED,
    memory: Memory::new(),
    workers: [const { Worker::new() }; _],
});
static MUSIC: Fixed<Music> = Fixed::new(Music(Synthesizer::new()));

/// All that is zero to begin with, what is small first.
#[repr(C)]
struct State {
    options: Options,
    tally: Tally,
    scene: Scene,
    memory: Memory,
    workers: [Worker; MAX_THREADS],
}

/// The soundtrack.
struct Music(Synthesizer);

impl Source for Music {
    fn block(&mut self) -> &[[f32; 2]] {
        self.0.block()
    }
}

eightfold_window::main!(run);

/// The whole program. Returns its exit code.
fn run(arguments: Arguments) -> i32 {
    let state = STATE.take();
    if let Some(code) = state.options.read(arguments) {
        return code;
    }
    let options = &state.options;
    // Not dropped: its threads end with the process.
    let mut intro = ManuallyDrop::new(Intro {
        isa: cpu::best(),
        pool: Pool::new(
            options
                .get(THREADS)
                .map_or_else(pool::processors, |count| count.get() as usize)
                .min(MAX_THREADS),
        ),
        governor: Governor::new(options.fps().get()),
        state,
    });
    let code = intro.run();
    if intro.report() || code != 0 { code } else { 1 }
}

/// What plays the show, and how it goes.
struct Intro {
    isa: Isa,
    pool: Pool,
    governor: Governor,
    state: &'static mut State,
}

impl Intro {
    /// Plays on the best screen there is. Returns the exit code.
    fn run(&mut self) -> i32 {
        let options = &self.state.options;
        let size = options.get(SIZE).map_or(1024 << 32 | 768, NonZero::get);
        let (width, height) = ((size >> 32) as usize, size as u32 as usize);
        let why = match Window::open(c"Eightfold", width, height) {
            Ok(mut window) => {
                if options.get(FULLSCREEN).is_some() {
                    window.set_fullscreen(true);
                }
                return self.play(&mut window);
            }
            Err(NoWindow::NoLibrary) => "libX11 is not installed",
            Err(NoWindow::NoDisplay) => "no X display",
        };
        let in_terminal = line::terminal(line::OUTPUT);
        let place: &[u8] = if in_terminal {
            b"in the terminal"
        } else {
            b"unseen"
        };
        line::complain(
            "eightfold: \u{3}; playing \u{3}\n",
            &[why.as_bytes(), place],
        );
        if in_terminal {
            self.play(&mut Terminal::open())
        } else {
            self.play(&mut Unseen::new(width, height))
        }
    }

    /// Plays until the show or the viewer ends it. Returns the exit code.
    fn play(&mut self, screen: &mut dyn Screen) -> i32 {
        let options = &self.state.options;
        let mut player = match options.get(SILENT) {
            None => Player::start(c"default", MUSIC.take()),
            _ => Player::silent(),
        };
        let clock = Clock::start();
        let length = match (options.get(SECONDS), options.get(LOOP)) {
            (Some(length), _) => length.get(),
            (None, Some(_)) => u64::MAX,
            (None, None) => LENGTH,
        };
        let pause = match options.get(UNCAPPED) {
            Some(_) => 0,
            None => SECOND / options.fps(),
        };
        let mut due = 0;
        loop {
            let time = clock.time();
            let heard = player.time();
            if heard >= length {
                self.state.tally.time = time;
                return 0;
            }
            let rung = match self.state.options.get(QUALITY) {
                Some(quality) => quality.get() as usize - 1,
                None => self.governor.rung(),
            };
            let quality = &Quality::on(rung);
            self.draw(heard, screen, quality);
            let next = screen.show();
            let shown = clock.time();
            self.governor.frame(shown - time);
            self.state.tally.count(shown, rung);
            if let Next::End(code) = next {
                return code;
            }
            // After a late frame the next ones don't hurry.
            due = u64::max(due + pause, time);
            if pause > 0 {
                clock.sleep_until(due);
            }
        }
    }

    /// Draws the frame of a time.
    fn draw(&mut self, time: u64, screen: &mut dyn Screen, quality: &Quality) {
        let (width, height) = fit(screen.size());
        self.state.tally.size = (width, height);
        let seconds = (time % LENGTH) as f32 / SECOND as f32;
        show::at(seconds, &mut self.state.scene);
        let threads = self.pool.threads();
        render(
            self.isa.level,
            &self.state.scene,
            quality,
            width,
            height,
            &mut self.state.memory,
            self.state.workers.get_mut(..threads).unwrap_or_default(),
            screen.canvas(width, height),
            |workers: &mut [Worker], bands: &mut [Band<'_>], job| {
                self.pool.run(workers, bands, job);
            },
        );
    }

    /// Says in one line on standard output how it went. False if that can't be written.
    fn report(&self) -> bool {
        let Tally {
            frames,
            time,
            slowest,
            size,
            ..
        } = self.state.tally;
        // In tenths, like what is written.
        let mean = frames * 10 * SECOND / time.max(1);
        let worst = if slowest == 0 { mean } else { !slowest * 10 };
        let mut report = Line::to(line::OUTPUT);
        report.form(
            "\0 frames in \u{2} s: \u{1} fps, worst second \u{1} fps, \0x\0, threads \0, \u{3}",
            &[
                frames,
                time / (SECOND / 100),
                mean,
                worst,
                size.0 as u64,
                size.1 as u64,
                self.pool.threads() as u64,
            ],
            &[self.isa.name.as_bytes()],
        );
        for (name, &time) in names().zip(&self.state.tally.rungs) {
            if time > 0 {
                let time = time / (SECOND / 100);
                report.form(", \u{3} \u{2} s", &[time], &[name]);
            }
        }
        line::printed(report.form("\n", &[], &[]).flush())
    }
}

/// Counts of a run.
struct Tally {
    frames: u64,
    /// Nanoseconds from the start to the last frame, or to the end.
    time: u64,
    /// The bits of the number of frames in the slowest second that is over, turned round; 0 if none is.
    slowest: u64,
    /// The second that is running, and the frames in it so far.
    second: (u64, u64),
    /// Width and height of the last frame.
    size: (usize, usize),
    /// Nanoseconds that each rung of the ladder was used.
    rungs: [u64; Quality::LADDER.len()],
}

impl Tally {
    const NONE: Tally = Tally {
        frames: 0,
        time: 0,
        slowest: 0,
        second: (0, 0),
        size: (0, 0),
        rungs: [0; _],
    };

    /// Counts a frame that was shown at a time, on a rung of the ladder.
    fn count(&mut self, time: u64, rung: usize) {
        self.frames += 1;
        if let Some(used) = self.rungs.get_mut(rung) {
            *used += time - self.time;
        }
        self.time = time;
        let (second, frames) = self.second;
        let now = time / SECOND;
        if now == second {
            self.second.1 += 1;
        } else {
            // A frame that took longer than a second leaves a second without any.
            let frames = if now == second + 1 { frames } else { 0 };
            self.slowest = self.slowest.max(!frames);
            self.second = (now, 1);
        }
    }
}

/// The size of a picture for a screen: the screen's own, or the largest of its shape.
fn fit((width, height): (usize, usize)) -> (usize, usize) {
    if width <= MAX_WIDTH && height <= MAX_HEIGHT {
        (width, height)
    } else if width * MAX_HEIGHT > height * MAX_WIDTH {
        (MAX_WIDTH, part(height * MAX_WIDTH, width))
    } else {
        (part(width * MAX_HEIGHT, height), MAX_HEIGHT)
    }
}

/// A quotient, at least 1.
#[inline(never)]
fn part(whole: usize, parts: usize) -> usize {
    whole.checked_div(parts).unwrap_or(1).max(1)
}
