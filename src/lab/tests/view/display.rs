use eightfold_stage::{DISPLAY, Process, Server, lacks, reader::read_png, run, wait_for};
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;
use tempfile::TempDir;

pub const SIZE: [i32; 2] = [320, 240];

pub struct View {
    pub server: Server,
    pub process: Process,
    pub id: String,
    pub file: PathBuf,
    pub folder: TempDir,
}

pub const SCENE: &str = r#"Scene(
    camera: (eye: (0.0, 3.0, 8.0), look_at: (0.0, 1.0, 0.0), field_of_view: 0.7),
    background: (0.1, 0.12, 0.2),
    ambient: (0.3, 0.3, 0.3),
    materials: {
        "blue": (colour: (0.1, 0.2, 0.9), kd: 0.8),
        "red": (colour: (0.9, 0.15, 0.1), kd: 0.8),
    },
    spheres: [(centre: (0.0, 1.0, 0.0), radius: 1.0, material: "red")],
    planes: [(centre: (0.0, 0.0, 0.0), half_x: 3.0, half_z: 3.0, material: "blue")],
    lights: [(position: (4.0, 6.0, 4.0), colour: (0.6, 0.6, 0.6))],
)
"#;

impl View {
    /// `None` without display tools.
    pub fn new() -> Option<View> {
        View::of("--scene model --time 2")
    }

    pub fn of_file() -> Option<View> {
        let view = View::of("--scene FILE")?;
        view.assert_shows_file();
        Some(view)
    }

    pub fn of(options: &str) -> Option<View> {
        if lacks(DISPLAY) {
            return None;
        }
        let folder = tempfile::tempdir().expect("a folder");
        let file = folder.path().join("scene.ron");
        fs::write(&file, SCENE).expect("it is written");
        let options = options.replace("FILE", file.to_str().expect("a plain name"));
        let server = Server::start(640, 480);
        let mut lab = Command::new(env!("CARGO_BIN_EXE_lab"));
        lab.args(["view", "--size", "320x240", "--paused"]);
        lab.args(options.split_whitespace());
        let process = server.open(&mut lab, || server.geometry(&["-id", &id(&server)?]));
        let view = View { id: id(&server).expect("a window"), server, process, file, folder };
        view.point([9, 9]);
        Some(view)
    }

    pub fn title(&self) -> String {
        let mut xprop = self.server.tool("xprop");
        let (_, text) = run(xprop.args(["-id", &self.id, "_NET_WM_NAME"]));
        text.split('"').nth(1).unwrap_or_default().to_owned()
    }

    /// Waits for words in the title, which is set after the frame.
    #[track_caller]
    pub fn press(&self, key: &str, words: &str) {
        self.key(key);
        wait_for(words, || self.title().contains(words).then_some(()));
    }

    pub fn key(&self, key: &str) {
        self.server.xdotool(&format!("key {key}"));
    }

    fn point(&self, [x, y]: [i32; 2]) {
        let [left, top, ..] = self.place();
        let command = format!("mousemove {} {}", left + x, top + y);
        self.server.xdotool(&command);
        sleep(Duration::from_millis(40));
    }

    pub fn drag(&self, button: u32, pixels: &[[i32; 2]]) {
        self.point(pixels[0]);
        self.server.xdotool(&format!("mousedown {button}"));
        for &at in &pixels[1..] {
            self.point(at);
        }
        self.server.xdotool(&format!("mouseup {button}"));
    }

    #[track_caller]
    pub fn assert_shows(&self, what: &str, is_wanted: impl Fn(&[u32]) -> bool) {
        wait_for(what, || is_wanted(&self.shot()).then_some(()));
    }

    #[track_caller]
    pub fn assert_shows_file(&self) {
        let picture = rendered(&format!("--scene {}", self.file.display()));
        self.assert_shows("the file's picture", |shot| shot == picture);
    }

    pub fn write(&self, text: &str) {
        fs::write(&self.file, text).expect("it is written");
    }

    pub fn shot(&self) -> Vec<u32> {
        let [x, y, width, height] = self.place();
        assert_eq!([width, height], SIZE);
        self.server.screenshot([x, y, width, height])
    }

    pub fn place(&self) -> [i32; 4] {
        let place = self.server.geometry(&["-id", &self.id]);
        place.expect("a window")
    }
}

fn id(server: &Server) -> Option<String> {
    let found = server.xdotool("search --onlyvisible --name ^Eightfold");
    found.lines().next().map(str::to_owned)
}

pub fn bright(pixels: &[u32]) -> usize {
    let is_bright = |pixel: &&u32| pixel.to_be_bytes()[1..].iter().all(|&c| c > 180);
    pixels.iter().filter(is_bright).count()
}

pub fn rendered(options: &str) -> Vec<u32> {
    let (output, _) = run(Command::new(env!("CARGO_BIN_EXE_lab"))
        .args(["render", "--size", "320x240", "--out", "-"])
        .args(options.split_whitespace()));
    read_png(&output.stdout).1
}
