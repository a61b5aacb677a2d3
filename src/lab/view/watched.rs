use crate::scenes;
use eightfold_scene_file::SceneFile;
use std::path::Path;

pub struct Watched {
    pub scene: SceneFile,
    /// The last text, or a read error; `None` before the first look.
    text: Option<Result<String, String>>,
    /// A mistake that was read once: the file may be half written.
    suspect: Option<String>,
    pub mistake: Option<String>,
}

impl Watched {
    pub fn new(scene: SceneFile) -> Self {
        Self { scene, text: None, suspect: None, mistake: None }
    }

    /// Returns whether the scene has changed. Modification times are too coarse for two quick writes.
    pub fn look(&mut self) -> bool {
        let name = &self.scene.name;
        let text = scenes::text(Path::new(name));
        if self.text.as_ref() == Some(&text) {
            if self.suspect.is_some() {
                self.mistake = self.suspect.take();
            }
            return false;
        }
        let read = text.as_ref().map_err(String::clone);
        let read = read.and_then(|text| SceneFile::parse(name, text));
        self.text = Some(text);
        match read {
            Ok(scene) => {
                self.scene = scene;
                (self.suspect, self.mistake) = (None, None);
                true
            }
            Err(mistake) => {
                self.suspect = Some(mistake);
                false
            }
        }
    }
}
