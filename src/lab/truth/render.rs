//! Draws the truth of a scene: on all threads, with a bar, and such that it can be interrupted.

use super::effects::Effects;
use super::estimate::Estimate;
use super::film::{Film, Sampling, Subject};
use super::photons::Caustics;
use super::world::World;
use super::{REPLICATIONS, state};
use crate::arguments::{Part, Size};
use crate::interrupt::{self, Stopped};
use crate::progress;
use crate::sampler::Sequence;
use anyhow::Result;
use eightfold_tracer::scene::Scene;
use rayon::ThreadPool;
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// How long a picture is drawn at most until the film is saved: that much is lost if the machine fails.
const SAVED_EVERY: Duration = Duration::from_secs(60);

/// A picture to draw.
#[derive(Clone, Copy)]
pub struct Picture<'a> {
    pub scene: &'a Scene,
    pub size: Size,
    pub effects: Effects,
    pub sampling: Sampling,
}

impl Picture<'_> {
    /// A line that describes it: equal lines mean equal samples, however many.
    fn made(&self) -> String {
        let scene = self.scene;
        let sampling = self.sampling;
        let sequence = match sampling.sequence {
            Sequence::Sobol => "sobol",
            Sequence::Random => "random",
        };
        format!(
            "eightfold {}: {scene:?}, {}, {:?}, {sequence} {}, antialiased: {}",
            env!("CARGO_PKG_VERSION"),
            self.size,
            self.effects,
            sampling.seed,
            sampling.is_antialiased,
        )
    }

    /// Draws it in one go.
    pub fn draw(&self, pool: &ThreadPool) -> Vec<Estimate> {
        let mut film = Film::new(self.size, Part::WHOLE);
        pool.install(|| {
            let subject = self.subject();
            for count in 1..=self.sampling.count {
                film.expose(&subject, count, &|| {});
            }
        });
        film.estimates()
    }

    /// Draws it, or a part of its rows, with a bar. Ctrl-C leaves what is drawn so far beside a file `out`, and the next call goes on from there. With
    /// `is_kept` a finished picture is left there, too, until [`forget`] deletes it: one of several, which are not all finished, or a part.
    ///
    /// # Errors
    /// [`Stopped`] after Ctrl-C, or if the unfinished picture cannot be written, or is damaged.
    pub fn draw_resumably(
        &self,
        pool: &ThreadPool,
        out: &Path,
        part: Option<Part>,
        is_kept: bool,
    ) -> Result<Film> {
        let name = state::beside(out, part);
        let made = self.made();
        let count = self.sampling.count;
        let empty = Film::new(self.size, part.unwrap_or(Part::WHOLE));
        let loaded = state::load(&name, &made, &empty, count)?;
        let was_begun = loaded.is_some();
        let mut film = loaded.unwrap_or(empty);
        let begun = film.count();
        if was_begun && begun < count {
            let samples = begun * REPLICATIONS;
            eprintln!("{}: goes on behind {samples} samples", name.display());
        }
        let bar = progress::bar(film.own_rows().count() * count);
        let there = film.own_rows().map(|row| row.count as u64);
        bar.inc(there.sum());
        // The estimate of the time left must not count samples that were there already.
        bar.reset_eta();

        let subject = pool.install(|| self.subject());
        let mut saved = Instant::now();
        for next in begun + 1..=count {
            pool.install(|| film.expose(&subject, next, &|| bar.inc(1)));
            if interrupt::is_stopped() && film.count() < count {
                bar.finish_and_clear();
                state::save(&name, &made, &film)?;
                let line = format!(
                    "{} has what is drawn, and the same command goes on",
                    name.display()
                );
                return Err(Stopped(line).into());
            }
            if saved.elapsed() > SAVED_EVERY && next < count {
                state::save(&name, &made, &film)?;
                saved = Instant::now();
            }
        }
        bar.finish_and_clear();
        if is_kept && begun < count {
            state::save(&name, &made, &film)?;
        }
        Ok(film)
    }

    /// What its samples are taken of, found on the threads of the pool that it is called in.
    pub fn subject(&self) -> Subject {
        let Size { width, height } = self.size;
        let world = World::new(self.scene, width, height, self.effects.falloff);
        Subject {
            caustics: Caustics::new(&world, self.effects.caustics),
            world,
            effects: self.effects,
            sampling: self.sampling,
        }
    }
}

/// Deletes what an interrupted run left, once the picture itself is written.
pub fn forget(out: &Path) {
    // There is none unless it was interrupted.
    let _ = fs::remove_file(state::beside(out, None));
}
