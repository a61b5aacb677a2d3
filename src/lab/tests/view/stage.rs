//! A running `lab view` on a display of its own, and what keys and mouse do there.

use eightfold_lab::cargo::Build;
use eightfold_stage::{
    DISPLAY, Process, Server, is_portable, lacks, reader::read_png, run, wait_for,
};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;
use tempfile::TempDir;

/// The window's size.
pub const SIZE: [i32; 2] = [320, 240];

/// A running `lab view` on its own X server.
pub struct View {
    pub server: Server,
    pub process: Process,
}

/// A running `lab view` of a scene file in a folder of its own.
pub struct Edit {
    pub view: View,
    pub file: PathBuf,
    pub folder: TempDir,
}

/// A scene with something to each gesture, and comments where people have them.
pub const SCENE: &str = r#"// A ball on a floor.
Scene(
    camera: (eye: (0.0, 3.0, 8.0), look_at: (0.0, 1.0, 0.0), field_of_view: 0.7), // as from a chair
    background: (0.1, 0.12, 0.2),
    ambient: (0.3, 0.3, 0.3),
    materials: {
        "blue": (colour: (0.1, 0.2, 0.9), kd: 0.8),
        "red": (colour: (0.9, 0.15, 0.1), kd: 0.8), // as the setting sun
    },
    spheres: [
        // The ball.
        (centre: (/* right */ 0.0, 1.0, 0), radius: 1.0, material: "red"), // it shines
    ],
    planes: [(centre: (0.0, 0.0, 0.0), half_x: 3.0, half_z: 3.0, material: "blue")],
    lights: [(position: (4.0, 6.0, 4.0), colour: (0.6, 0.6, 0.6))],
)
"#;

/// [`SCENE`] after M was pressed for the ball.
pub fn blue() -> String {
    SCENE.replace("1.0, material: \"red\"", "1.0, material: \"blue\"")
}

/// Where the ball of [`SCENE`] is seen, and the floor, and nothing.
pub const BALL: [i32; 2] = [160, 120];
pub const FLOOR: [i32; 2] = [90, 170];
pub const NOTHING: [i32; 2] = [20, 20];

/// The lab's program; with the portable backend if the intro of these tests has it, too.
fn lab() -> &'static Path {
    static LAB: LazyLock<PathBuf> = LazyLock::new(|| {
        if !is_portable() {
            return env!("CARGO_BIN_EXE_lab").into();
        }
        let built = Build::portable("eightfold-lab").expect("it can be built");
        built.program("lab").expect("it has the program")
    });
    &LAB
}

impl View {
    /// Starts the model scene with a pause after 2 s: time has no part in what is seen. `None` without what a display needs.
    pub fn new(options: &str) -> Option<View> {
        View::of(&format!("--scene model --time 2 {options}"))
    }

    /// Starts with a pause.
    pub fn of(options: &str) -> Option<View> {
        (!lacks(DISPLAY)).then(|| View::on(Server::start(640, 480), options))
    }

    fn on(server: Server, options: &str) -> View {
        let mut lab = Command::new(lab());
        lab.args(["view", "--size", "320x240", "--paused"]);
        lab.args(options.split_whitespace());
        let process = server.open(&mut lab, || window(&server));
        let view = View { server, process };
        view.point([9, 9]);
        view
    }

    /// Opens a scene file, and takes the hint away by a click on nothing.
    pub fn of_file(server: Server, file: &Path) -> View {
        let view = View::on(server, &format!("--scene {}", file.display()));
        view.click(1, NOTHING);
        view
    }

    pub fn title(&self) -> String {
        let id = self.id();
        let mut xprop = self.server.tool("xprop");
        let (_, text) = run(xprop.args(["-id", &id, "_NET_WM_NAME"]));
        text.split('"').nth(1).unwrap_or_default().to_owned()
    }

    /// Presses a key and waits until the title contains some words. The title is set after the frame is shown.
    #[track_caller]
    pub fn press(&self, key: &str, words: &str) {
        self.key(key);
        self.wait(words);
    }

    pub fn key(&self, key: &str) {
        self.server.xdotool(&format!("key {key}"));
    }

    pub fn wait(&self, words: &str) {
        wait_for(words, || self.title().contains(words).then_some(()));
    }

    /// Moves the pointer to a pixel of the window.
    pub fn point(&self, [x, y]: [i32; 2]) {
        let [left, top, ..] = window(&self.server).expect("a window");
        let command = format!("mousemove {} {}", left + x, top + y);
        self.server.xdotool(&command);
    }

    /// Presses a button at a pixel, long enough for one that is asked for it once a frame.
    pub fn click(&self, button: u32, at: [i32; 2]) {
        self.drag(button, &[at]);
    }

    /// Drags by a button from pixel to pixel.
    pub fn drag(&self, button: u32, way: &[[i32; 2]]) {
        self.hold(button, way);
        self.release(button);
    }

    /// Drags, and does not release the button.
    pub fn hold(&self, button: u32, way: &[[i32; 2]]) {
        self.point(way[0]);
        self.pause();
        self.server.xdotool(&format!("mousedown {button}"));
        self.pause();
        self.follow(&way[1..]);
    }

    /// Moves the pointer from pixel to pixel.
    pub fn follow(&self, way: &[[i32; 2]]) {
        for &at in way {
            self.point(at);
            self.pause();
        }
    }

    pub fn release(&self, button: u32) {
        self.server.xdotool(&format!("mouseup {button}"));
        self.pause();
    }

    /// Waits for some frames: for many where the pointer is asked for once a frame instead of being heard.
    fn pause(&self) {
        let milliseconds = if is_portable() { 120 } else { 40 };
        std::thread::sleep(std::time::Duration::from_millis(milliseconds));
    }

    /// Waits until the window shows the given picture.
    #[track_caller]
    pub fn assert_shows(&self, what: &str, is_wanted: impl Fn(&[u32]) -> bool) {
        wait_for(what, || is_wanted(&self.shot()).then_some(()));
    }

    /// Returns what the window shows once it has been the same for some frames.
    pub fn settled_shot(&self) -> Vec<u32> {
        wait_for("the same picture again", || {
            let shot = self.shot();
            self.pause();
            (shot == self.shot()).then_some(shot)
        })
    }

    pub fn shot(&self) -> Vec<u32> {
        let [x, y, width, height] = window(&self.server).expect("a window");
        assert_eq!([width, height], SIZE);
        self.server.screenshot([x, y, width, height])
    }

    pub fn id(&self) -> String {
        id(&self.server).expect("a window")
    }
}

impl Edit {
    /// Starts with [`SCENE`], or another text, and waits until it is seen. `None` without what a display needs.
    pub fn new(text: &str) -> Option<Edit> {
        Edit::on(Server::start, "scene.ron", text)
    }

    /// The same on a server of some kind, in a file of a given name.
    pub fn on(server: fn(usize, usize) -> Server, name: &str, text: &str) -> Option<Edit> {
        if lacks(DISPLAY) {
            return None;
        }
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join(name);
        fs::write(&file, text).expect("it is written");
        let view = View::of_file(server(640, 480), &file);
        let edit = Edit { view, file, folder };
        edit.assert_shows_file();
        Some(edit)
    }

    /// Starts with [`SCENE`], and changes it to [`blue`], which is not saved.
    pub fn changed() -> Option<Edit> {
        let edit = Edit::new(SCENE)?;
        edit.change();
        Some(edit)
    }

    /// Changes [`SCENE`] to [`blue`], and waits until that is kept.
    pub fn change(&self) {
        self.view.click(1, BALL);
        self.view.press("m", "not saved");
        wait_for("the file of what is not saved", || {
            self.unsaved().exists().then_some(())
        });
    }

    pub fn text(&self) -> String {
        read(&self.file)
    }

    /// Has another program write the file, and waits until what was not saved is read over.
    #[track_caller]
    pub fn read_over(&self, text: &str) {
        fs::write(&self.file, text).expect("it is written");
        self.wait_until_saved();
    }

    /// Waits until the title tells of no changes.
    #[track_caller]
    pub fn wait_until_saved(&self) {
        wait_for("it to be saved", || {
            (!self.view.title().contains("not saved")).then_some(())
        });
    }

    /// The file of what is not saved.
    pub fn unsaved(&self) -> PathBuf {
        self.file.with_extension("unsaved.ron")
    }

    /// Saves, and waits until all is saved. Returns the file's text.
    #[track_caller]
    pub fn save(&self) -> String {
        self.view.wait("not saved");
        self.view.key("ctrl+s");
        self.wait_until_saved();
        assert!(!self.unsaved().exists());
        self.text()
    }

    /// Waits until the window shows what the file says, and nothing is picked.
    #[track_caller]
    pub fn assert_shows_file(&self) {
        let picture = self.picture();
        self.view
            .assert_shows("the file's picture", |shot| shot == picture);
    }

    /// The picture of the file, as `lab render` draws it.
    pub fn picture(&self) -> Vec<u32> {
        rendered(&format!("--scene {}", self.file.display()))
    }

    /// Picks nothing, and asserts that the window shows what the file says.
    #[track_caller]
    pub fn assert_unpicked_shows_file(&self) {
        self.view.click(1, NOTHING);
        self.assert_shows_file();
    }
}

/// The window's id, for X tools.
fn id(server: &Server) -> Option<String> {
    let found = server.xdotool("search --onlyvisible --name ^Eightfold");
    found.lines().next().map(str::to_owned)
}

pub fn window(server: &Server) -> Option<[i32; 4]> {
    server.geometry(&["-id", &id(server)?])
}

/// Whether a pixel is as bright as letters are.
pub fn is_bright(pixel: u32) -> bool {
    pixel.to_be_bytes()[1..]
        .iter()
        .all(|&channel| channel > 180)
}

/// The number of bright pixels in the upper half, where words are told.
pub fn letters(shot: &[u32]) -> usize {
    let upper = shot[..shot.len() / 2].iter();
    upper.filter(|&&pixel| is_bright(pixel)).count()
}

/// The text of a file.
#[track_caller]
pub fn read(file: &Path) -> String {
    fs::read_to_string(file).expect("it is there")
}

/// The picture that `lab render` draws.
pub fn rendered(options: &str) -> Vec<u32> {
    let (output, _) = run(Command::new(env!("CARGO_BIN_EXE_lab"))
        .args(["render", "--size", "320x240", "--out", "-"])
        .args(options.split_whitespace()));
    read_png(&output.stdout).1
}
