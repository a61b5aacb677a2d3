//! The text of a scene file while it is edited: its earlier states, the file on the disk, and a copy of what is not saved.

use super::copies::Copies;
use super::disk::SceneOnDisk;
use eightfold_scene_file::SceneFile;
use std::path::{Path, PathBuf};

/// A scene file that is open.
pub struct Document {
    text: String,
    pub scene: SceneFile,
    /// Earlier texts, the last one last, and those that were undone.
    past: Vec<String>,
    future: Vec<String>,
    /// The step that the last change was a part of, if more of that may follow.
    step: Option<Step>,
    /// The state that a drag began with, until it ends or anything else changes the text.
    held: Option<Held>,
    /// Is another one after each change.
    pub version: u64,
    disk: SceneOnDisk,
    is_written: bool,
    copies: Copies,
}

/// Changes that follow each other and are undone as one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    Drag,
    /// The resizing of an object by its number.
    Resize(usize),
}

/// A text to which all of a drag is applied anew with each move, and what it says.
pub struct Held {
    pub text: String,
    pub scene: SceneFile,
}

/// News of the file on the disk.
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
        let path = Path::new(name);
        let disk = SceneOnDisk::open(path)?;
        let text = disk.seen.clone();
        Ok(Self {
            scene: SceneFile::parse(name, &text)?,
            text,
            past: Vec::new(),
            future: Vec::new(),
            step: None,
            held: None,
            version: 0,
            disk,
            is_written: false,
            copies: Copies::new(path),
        })
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    pub fn is_saved(&self) -> bool {
        self.text == self.disk.seen
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
        let goes_on = step.is_some() && step == self.step;
        let before = self.take(text, scene, step);
        if !goes_on {
            self.past.push(before);
        }
        self.future.clear();
        Ok(())
    }

    /// Goes back before the last step, or does it again. Returns false if there is none.
    pub fn undo(&mut self, again: bool) -> bool {
        let from = if again {
            &mut self.future
        } else {
            &mut self.past
        };
        let Some(text) = from.pop() else {
            return false;
        };
        let Ok(scene) = self.parse(&text) else {
            return false;
        };
        let before = self.take(text, scene, None);
        let to = if again {
            &mut self.past
        } else {
            &mut self.future
        };
        to.push(before);
        true
    }

    /// Begins a drag.
    pub fn hold(&mut self) {
        self.step = None;
        self.held = Some(Held {
            text: self.text.clone(),
            scene: self.scene.clone(),
        });
    }

    /// The state that the drag began with; `None` if something has ended it.
    pub fn held(&self) -> Option<&Held> {
        self.held.as_ref()
    }

    /// Ends a step: what follows is undone by itself.
    pub fn end_step(&mut self) {
        self.step = None;
        self.held = None;
    }

    /// Writes the file. While a question is told, the same again is the answer to it.
    ///
    /// # Errors
    /// One line: a question, or why it can't be written.
    pub fn save(&mut self, told: Option<&str>) -> Result<(), String> {
        let (copies, text) = (&mut self.copies, &self.text);
        self.disk
            .write(text, told, || copies.keep(text).map(drop))?;
        self.is_written = true;
        self.step = None;
        self.follow();
        Ok(())
    }

    /// Reads the file again if it has changed on the disk.
    pub fn look(&mut self) -> Option<News> {
        let read = self.disk.look()?;
        let (scene, text) = match read.and_then(|text| Ok((self.parse(&text)?, text))) {
            Ok(read) => read,
            Err(why) => return Some(News::Faulty(why)),
        };
        if text == self.disk.seen {
            return Some(News::Read);
        }
        let is_lost = !self.is_saved() && text != self.text;
        let news = match is_lost.then(|| self.copies.keep(&self.text)) {
            None => News::Read,
            Some(Ok(path)) => {
                self.copies.leave();
                News::ReadOver(path)
            }
            Some(Err(_)) => {
                self.disk.look_again();
                return Some(News::Faulty(NOT_READ.to_owned()));
            }
        };
        self.disk.seen.clone_from(&text);
        if text != self.text {
            let before = self.take(text, scene, None);
            self.past.push(before);
            self.future.clear();
        }
        Some(news)
    }

    /// Has the file beside it hold what is not saved, and be gone when all is saved.
    pub fn follow(&mut self) {
        if self.is_saved() {
            self.copies.discard(&self.text);
        } else {
            self.copies.follow(&self.text);
        }
    }

    /// Why what is not saved is in no file.
    pub fn copy_fault(&self) -> Option<&str> {
        self.copies.fault()
    }

    /// Tells what is left at the end; `None` if nothing was written.
    pub fn left_behind(&mut self) -> Option<String> {
        if self.is_saved() {
            let path = self.disk.path().display();
            return self.is_written.then(|| format!("wrote {path}"));
        }
        let what = "the changes that are not saved are";
        Some(match self.copies.keep(&self.text) {
            Ok(path) => format!("{what} in {}", path.display()),
            Err(why) => format!("{what} lost: {why}"),
        })
    }

    /// Reads a text in the place of this one.
    ///
    /// # Errors
    /// As [`SceneFile::parse`].
    pub fn parse(&self, text: &str) -> Result<SceneFile, String> {
        SceneFile::parse(&self.scene.name, text)
    }

    /// Takes another text, which ends any drag that it is no part of. Returns the text before.
    fn take(&mut self, text: String, scene: SceneFile, step: Option<Step>) -> String {
        self.scene = scene;
        self.step = step;
        if step != Some(Step::Drag) {
            self.held = None;
        }
        self.version += 1;
        std::mem::replace(&mut self.text, text)
    }
}

/// Why changes are not given up for what another program has written.
const NOT_READ: &str = "The file has changed. It is not read as long as the changes that are not saved cannot be kept.";
