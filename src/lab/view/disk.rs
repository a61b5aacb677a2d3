//! A scene file on the disk: what it held when it was last seen, and how another text takes its place.

use eightfold_scene_file as scene_file;
use std::fs::{self, File, Metadata, Permissions};
use std::io::{self, Write};
use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};
use tempfile::NamedTempFile;

/// How often the file is looked at.
const LOOK_EVERY: Duration = Duration::from_millis(100);

/// A scene file, and what it held when it was last read or written.
pub struct SceneOnDisk {
    path: PathBuf,
    pub seen: String,
    looked: Instant,
    /// As it was when it was last looked at; `None` if it has to be read again in any case.
    stamp: Option<Stamp>,
    /// The contents that were there when the user was asked whether to write over it.
    asked: Option<Found>,
}

/// When a file was written, its length and its number: it is not read again as long as these are the same. `None` without a file.
type Stamp = Option<(SystemTime, u64, u64)>;

/// The contents at the path of a scene file.
#[derive(PartialEq)]
enum Found {
    Nothing,
    File {
        /// `None` if it can't be read.
        bytes: Option<Vec<u8>>,
        is_protected: bool,
    },
}

impl SceneOnDisk {
    /// Reads a scene file.
    ///
    /// # Errors
    /// As [`scene_file::text`].
    pub fn open(path: &Path) -> Result<Self, String> {
        Ok(Self {
            path: path.to_owned(),
            stamp: Some(stamp(path)),
            seen: scene_file::text(path)?,
            looked: Instant::now(),
            asked: None,
        })
    }

    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Reads the file if something has happened to it, from time to time.
    pub fn look(&mut self) -> Option<Result<String, String>> {
        if self.looked.elapsed() < LOOK_EVERY {
            return None;
        }
        self.looked = Instant::now();
        let now = Some(stamp(&self.path));
        if now == self.stamp {
            return None;
        }
        self.stamp = now;
        Some(scene_file::text(&self.path))
    }

    /// Has the next look read the file.
    pub fn look_again(&mut self) {
        self.stamp = None;
    }

    /// Has the file hold a text. If that would lose something, it asks first: the same again while the question is told writes over
    /// what was there when it was asked, and over nothing else. A file that can't be replaced by another one that is its like is
    /// written in place, after `keep`.
    ///
    /// # Errors
    /// One line: the question, or why it can't be written.
    pub fn write(
        &mut self,
        text: &str,
        told: Option<&str>,
        keep: impl FnOnce() -> Result<(), String>,
    ) -> Result<(), String> {
        let cannot = |why: io::Error| format!("cannot write {}: {why}", self.path.display());
        let found = Found::at(&self.path).map_err(cannot)?;
        let question = found.question(&self.seen, text);
        let is_answered = told == question.as_deref() && self.asked.as_ref() == Some(&found);
        if let Some(question) = question.filter(|_| !is_answered) {
            self.asked = Some(found);
            return Err(question);
        }
        if !found.holds(text) {
            // A symbolic link stays: the file that it points to is written.
            let path = fs::canonicalize(&self.path).unwrap_or_else(|_| self.path.clone());
            let part = part(&path, text).map_err(cannot)?;
            if is_like(&part, &path).map_err(cannot)? {
                part.persist(&path).map_err(|error| cannot(error.error))?;
                // The copy goes after this: the new name has to be on the disk first, where folders can be synchronised.
                let _ = path.parent().map(|folder| File::open(folder)?.sync_all());
            } else {
                keep()?;
                write_in_place(&path, text).map_err(cannot)?;
            }
        }
        text.clone_into(&mut self.seen);
        self.asked = None;
        self.look_again();
        Ok(())
    }
}

impl Found {
    fn at(path: &Path) -> io::Result<Self> {
        let there = match fs::metadata(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::Nothing),
            there => there?,
        };
        if !there.is_file() {
            return Err(io::Error::other(scene_file::NO_FILE));
        }
        let is_denied = |error: io::Error| error.kind() == io::ErrorKind::PermissionDenied;
        let opened = File::options().write(true).open(path);
        Ok(Self::File {
            bytes: fs::read(path).ok(),
            // Root may write everything.
            is_protected: there.permissions().readonly() || opened.is_err_and(is_denied),
        })
    }

    fn holds(&self, text: &str) -> bool {
        matches!(self, Self::File { bytes: Some(bytes), .. } if bytes == text.as_bytes())
    }

    /// The question to ask before a text is written over it, if it held another one when it was last seen.
    fn question(&self, seen: &str, text: &str) -> Option<String> {
        let Self::File { is_protected, .. } = self else {
            return None;
        };
        if self.holds(text) {
            return None;
        }
        let foreign = "Another program has written the file, and this would be lost. ";
        let protected = "The file is write-protected. ";
        let reasons = [(!self.holds(seen), foreign), (*is_protected, protected)];
        let reasons = reasons.into_iter().filter(|(is_so, _)| *is_so);
        let reasons: String = reasons.map(|(_, words)| words).collect();
        (!reasons.is_empty()).then(|| reasons + "Ctrl-S again writes over it.")
    }
}

/// A temporary file beside a scene file that holds a text, on the disk, and with its owner and mode as far as that is allowed.
pub fn part(path: &Path, text: &str) -> io::Result<NamedTempFile> {
    let folder = match path.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let there = fs::metadata(path).ok();
    let mode = if there.is_some() { 0o600 } else { 0o666 };
    let mut part = tempfile::Builder::new()
        .prefix(".lab-")
        .suffix(".part")
        .permissions(Permissions::from_mode(mode))
        .tempfile_in(folder)
        // Without its name, which nobody knows.
        .map_err(|error| io::Error::from(error.kind()))?;
    let file = part.as_file_mut();
    if let Some(there) = there {
        // `is_like` tells whether it was allowed.
        let _ = fchown(&*file, Some(there.uid()), Some(there.gid()));
        let _ = file.set_permissions(there.permissions());
    }
    file.write_all(text.as_bytes())?;
    file.sync_all()?;
    Ok(part)
}

/// Whether a file can take the place of another one, and nothing but the text is another then.
fn is_like(part: &NamedTempFile, path: &Path) -> io::Result<bool> {
    let of = |file: Metadata| (file.nlink(), file.uid(), file.gid(), file.mode());
    match fs::metadata(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(true),
        there => Ok(of(there?) == of(part.as_file().metadata()?)),
    }
}

/// Writes a file that stays the same one: one that has other names, or belongs to somebody else.
fn write_in_place(path: &Path, text: &str) -> io::Result<()> {
    let mut file = File::options().write(true).open(path)?;
    file.write_all(text.as_bytes())?;
    file.set_len(text.len() as u64)?;
    file.sync_all()
}

fn stamp(path: &Path) -> Stamp {
    let file = fs::metadata(path).ok()?;
    Some((file.modified().ok()?, file.len(), file.ino()))
}
