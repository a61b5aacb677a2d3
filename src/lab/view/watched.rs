//! A scene file that is read again whenever it is written.

use crate::scenes;
use eightfold_scene_file::SceneFile;
use std::path::Path;

/// A scene file, and the last good scene in it.
pub struct Watched {
    pub scene: SceneFile,
    /// The text at the last look, or why it could not be read; `None` before the first look.
    text: Option<Result<String, String>>,
    /// A mistake that was found in this text by the last look only. A text that is half written has gone by the next one.
    suspect: Option<String>,
    /// The mistake in the file.
    pub fault: Option<String>,
}

impl Watched {
    pub fn new(scene: SceneFile) -> Self {
        Self {
            scene,
            text: None,
            suspect: None,
            fault: None,
        }
    }

    /// Reads the file, and returns whether it gives another scene. The whole text is compared: times of files are too coarse for two
    /// writes in a row, and a file that replaces another one may be older.
    pub fn look(&mut self) -> bool {
        let name = &self.scene.name;
        let text = scenes::text(Path::new(name));
        if self.text.as_ref() == Some(&text) {
            if self.suspect.is_some() {
                self.fault = self.suspect.take();
            }
            return false;
        }
        let read = text.as_ref().map_err(String::clone);
        let read = read.and_then(|text| SceneFile::parse(name, text));
        self.text = Some(text);
        match read {
            Ok(scene) => {
                self.scene = scene;
                (self.suspect, self.fault) = (None, None);
                true
            }
            Err(mistake) => {
                self.suspect = Some(mistake);
                false
            }
        }
    }
}
