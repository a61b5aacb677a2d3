//! The text of a scene file while it is edited: its earlier states, the file on the disk, and a copy of what is not saved.

use crate::output;
use crate::scene_file::SceneFile;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// How often the file is looked at.
const LOOK_EVERY: Duration = Duration::from_millis(100);

/// A scene file that is open.
pub struct Document {
    name: PathBuf,
    text: String,
    pub scene: SceneFile,
    /// Earlier texts, the last one last, and those that were undone.
    past: Vec<String>,
    future: Vec<String>,
    /// What the last change was a part of, if more of that may follow.
    step: Option<Step>,
    /// Is another one after each change.
    pub version: u64,
    /// What the file held when it was last read or written.
    saved: String,
    disk: Disk,
    unsaved: Unsaved,
}

/// Changes that follow each other and are undone as one, each with the number of the object and of the gesture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    Drag(usize),
    Resize(usize),
}

/// The file as it was when it was last looked at.
struct Disk {
    looked: Instant,
    stamp: Option<(SystemTime, u64)>,
}

/// The file beside it that holds the text as long as it is not saved.
struct Unsaved {
    path: PathBuf,
    /// What it holds; `None` if it is not there.
    text: Option<String>,
}

/// What became of the file on the disk.
pub enum News {
    /// It was read again.
    Read,
    /// It was read again, in the place of changes that are not saved. They are in a file.
    ReadOver(PathBuf),
    /// It can't be read, in words.
    Faulty(String),
}

impl Document {
    /// Opens a scene file.
    ///
    /// # Errors
    /// As [`SceneFile::read`].
    pub fn open(name: &str) -> Result<Self, String> {
        let stamp = stamp(Path::new(name));
        let text = read(Path::new(name))?;
        let scene = SceneFile::parse(name, &text)?;
        let path = Path::new(name);
        Ok(Self {
            name: path.to_owned(),
            saved: text.clone(),
            text,
            scene,
            past: Vec::new(),
            future: Vec::new(),
            step: None,
            version: 0,
            disk: Disk {
                looked: Instant::now(),
                stamp,
            },
            unsaved: Unsaved {
                path: unsaved_path(path),
                text: None,
            },
        })
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    pub fn is_saved(&self) -> bool {
        self.text == self.saved
    }

    /// Where the changes that are not saved are.
    pub fn unsaved_path(&self) -> &Path {
        &self.unsaved.path
    }

    /// Takes another text. Those of one step are undone as one.
    ///
    /// # Errors
    /// If the text is no scene: the line that [`SceneFile::parse`] says. Then all is as before.
    pub fn change(&mut self, text: String, step: Option<Step>) -> Result<(), String> {
        if text == self.text {
            return Ok(());
        }
        let scene = self.parse(&text)?;
        let before = std::mem::replace(&mut self.text, text);
        if step.is_none() || step != self.step {
            self.past.push(before);
        }
        self.future.clear();
        self.step = step;
        self.take(scene);
        Ok(())
    }

    /// Goes back before the last step, or does it again. Returns false if there is none.
    pub fn undo(&mut self, again: bool) -> bool {
        let (from, to) = match again {
            false => (&mut self.past, &mut self.future),
            true => (&mut self.future, &mut self.past),
        };
        let Some(text) = from.pop() else {
            return false;
        };
        to.push(std::mem::replace(&mut self.text, text));
        self.step = None;
        if let Ok(scene) = self.parse(&self.text) {
            self.take(scene);
        }
        true
    }

    /// Ends a step: what follows is undone by itself.
    pub fn end_step(&mut self) {
        self.step = None;
    }

    /// Whether another program has written the file since it was read.
    pub fn is_written_by_others(&self) -> bool {
        fs::read_to_string(&self.name).is_ok_and(|text| text != self.saved)
    }

    /// Writes the file.
    ///
    /// # Errors
    /// One line that says why it can't be written.
    pub fn save(&mut self) -> Result<(), String> {
        output::write(&self.name, self.text.as_bytes()).map_err(|error| format!("{error:#}"))?;
        self.saved.clone_from(&self.text);
        self.disk.stamp = stamp(&self.name);
        self.step = None;
        self.keep_unsaved()
    }

    /// Reads the file again if it has changed on the disk.
    pub fn look(&mut self) -> Option<News> {
        if self.disk.looked.elapsed() < LOOK_EVERY {
            return None;
        }
        self.disk.looked = Instant::now();
        let now = stamp(&self.name);
        if now == self.disk.stamp {
            return None;
        }
        self.disk.stamp = now;
        let read = read(&self.name).and_then(|text| Ok((self.parse(&text)?, text)));
        let (scene, text) = match read {
            Ok(read) => read,
            Err(why) => return Some(News::Faulty(why)),
        };
        let was_saved = self.is_saved();
        self.saved.clone_from(&text);
        if text != self.text {
            self.past.push(std::mem::replace(&mut self.text, text));
            self.future.clear();
            self.step = None;
            self.take(scene);
        }
        Some(match was_saved {
            true => News::Read,
            false => News::ReadOver(self.unsaved.path.clone()),
        })
    }

    /// Has the file beside it hold what is not saved, and be gone when all is saved.
    ///
    /// # Errors
    /// One line that says why it can't be written.
    pub fn keep_unsaved(&mut self) -> Result<(), String> {
        if self.is_saved() {
            if self.unsaved.text.take().is_some() {
                // If it is gone already, so much the better.
                let _ = fs::remove_file(&self.unsaved.path);
            }
        } else if self.unsaved.text.as_ref() != Some(&self.text) {
            self.unsaved.text = Some(self.text.clone());
            let path = &self.unsaved.path;
            fs::write(path, &self.text)
                .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
        }
        Ok(())
    }

    /// What a text says in the place of this one.
    ///
    /// # Errors
    /// As [`SceneFile::parse`].
    pub fn parse(&self, text: &str) -> Result<SceneFile, String> {
        SceneFile::parse(&self.name.to_string_lossy(), text)
    }

    fn take(&mut self, scene: SceneFile) {
        self.scene = scene;
        self.version += 1;
    }
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// When a file was written, and its length: it is not read again as long as these are the same.
fn stamp(path: &Path) -> Option<(SystemTime, u64)> {
    let file = fs::metadata(path).ok()?;
    Some((file.modified().ok()?, file.len()))
}

/// A name beside a file that no other file has: `room.unsaved.ron`, `room.unsaved-2.ron` and so on.
fn unsaved_path(path: &Path) -> PathBuf {
    let numbers = std::iter::once(String::new()).chain((2..).map(|number| format!("-{number}")));
    numbers
        .map(|number| path.with_extension(format!("unsaved{number}.ron")))
        .find(|path| !path.exists())
        .unwrap_or_default()
}
