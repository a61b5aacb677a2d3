//! The files beside a scene file that hold what is not saved in it: `room.unsaved.ron`, `room.unsaved-2.ron` and so on.
//!
//! Each belongs to the program that has made it. One that is not as it was written belongs to nobody, and is left alone.

use super::disk::part;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The time between two attempts at least: each waits for the disk.
const KEEP_EVERY: Duration = Duration::from_millis(250);

/// The copies of one that edits a scene file.
pub struct Copies {
    /// The scene file.
    of: PathBuf,
    /// The one that follows the text.
    current: Option<Kept>,
    /// Those whose text another program's has taken the place of.
    left: Vec<Kept>,
    tried: Option<Instant>,
    /// Why the text can't be kept.
    fault: Option<String>,
}

/// A file, and what was written to it.
struct Kept {
    path: PathBuf,
    text: String,
}

impl Copies {
    pub fn new(of: &Path) -> Self {
        Self {
            of: of.to_owned(),
            current: None,
            left: Vec::new(),
            tried: None,
            fault: None,
        }
    }

    pub fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Keeps a text, if the last attempt was not just now.
    pub fn follow(&mut self, text: &str) {
        let is_kept = self.current.as_ref().is_some_and(|copy| copy.text == text);
        let is_due = |tried: Instant| tried.elapsed() >= KEEP_EVERY;
        if !is_kept && self.tried.is_none_or(is_due) {
            // `fault` tells of it.
            let _ = self.keep(text);
        }
    }

    /// Has a file hold a text, on the disk. Returns its path.
    ///
    /// # Errors
    /// One line that says why it can't be written. What was kept before is kept then.
    pub fn keep(&mut self, text: &str) -> Result<PathBuf, String> {
        // What was left may have come back.
        if let Some(back) = self.left.iter().position(|copy| copy.text == text) {
            let back = self.left.swap_remove(back);
            if let Some(copy) = self.current.replace(back) {
                copy.remove();
            }
        }
        let written = self.write(text);
        self.tried = Some(Instant::now());
        self.fault = written.as_ref().err().cloned();
        if let Ok(path) = &written {
            self.current = Some(Kept {
                path: path.clone(),
                text: text.to_owned(),
            });
        }
        written
    }

    fn write(&self, text: &str) -> Result<PathBuf, String> {
        let current = self.current.as_ref().filter(|copy| copy.is_there());
        let Some(Kept { path, text: held }) = current else {
            return self.make(text);
        };
        if held != text {
            let replaced = part(&self.of, text).and_then(|part| Ok(part.persist(path)?));
            replaced.map_err(|why| cannot_write(path, &why))?;
        }
        Ok(path.clone())
    }

    /// Makes a file by a name that no other file has.
    fn make(&self, text: &str) -> Result<PathBuf, String> {
        let mut number = 1;
        let mut path = self.of.with_extension("unsaved.ron");
        let mut part = part(&self.of, text).map_err(|why| cannot_write(&path, &why))?;
        while let Err(failed) = part.persist_noclobber(&path) {
            if failed.error.kind() != ErrorKind::AlreadyExists {
                return Err(cannot_write(&path, &failed.error));
            }
            part = failed.file;
            number += 1;
            path = self.of.with_extension(format!("unsaved-{number}.ron"));
        }
        Ok(path)
    }

    /// Leaves the text that was kept last where it is: another one is to take its place, which is kept elsewhere.
    pub fn leave(&mut self) {
        self.left.extend(self.current.take());
    }

    /// Removes what is not needed any more as the scene file itself holds a text.
    pub fn discard(&mut self, text: &str) {
        let saved = self.left.extract_if(.., |copy| copy.text == text);
        for copy in saved.chain(self.current.take()) {
            copy.remove();
        }
        self.fault = None;
    }
}

fn cannot_write(path: &Path, why: &io::Error) -> String {
    format!("cannot write {}: {why}", path.display())
}

impl Kept {
    /// Whether it is as it was written.
    fn is_there(&self) -> bool {
        fs::read(&self.path).is_ok_and(|bytes| bytes == self.text.as_bytes())
    }

    fn remove(&self) {
        if self.is_there() {
            // If it is gone already, so much the better.
            let _ = fs::remove_file(&self.path);
        }
    }
}
