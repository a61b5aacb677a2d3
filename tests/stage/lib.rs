//! The crate that supports tests of programs: the intro, X servers, tools, and readers of pictures.

pub mod allocations;
pub mod reader;
mod tools;

pub use tools::{DISPLAY, lacks, tool};

use eightfold_harness::cargo::Build;
use eightfold_harness::picture::from_rgb;
use eightfold_tracer::Preset;
use std::io::{BufRead, BufReader, Read};
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::sync::LazyLock;
use std::thread::{self, sleep};
use std::time::{Duration, Instant};
use std::{env, fs};
use tempfile::TempDir;

static BUILT: LazyLock<Build> =
    LazyLock::new(|| Build::release("eightfold").expect("it can be built"));

pub fn intro() -> PathBuf {
    BUILT.program("eightfold").expect("there is a program")
}

/// Returns the linked intro, which starts a quarter of a second faster than the packed file.
pub fn linked_intro() -> PathBuf {
    BUILT.linked("eightfold").expect("it was linked")
}

pub fn qualities() -> String {
    Preset::ALL.map(Preset::name).join(" ")
}

pub fn headless(options: &str) -> Command {
    let mut command = Command::new(linked_intro());
    command.env_remove("DISPLAY").arg("--silent");
    command.args(options.split_whitespace());
    command
}

pub fn texts(output: &Output) -> (String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (text(&output.stdout), text(&output.stderr))
}

pub fn run(command: &mut Command) -> (Output, String) {
    let output = command.output().expect("the command starts");
    let (text, _) = texts(&output);
    (output, text)
}

/// Runs a command. Returns its exit code, output and errors.
pub fn ended(command: &mut Command) -> (Option<i32>, String, String) {
    let (output, text) = run(command);
    (output.status.code(), text, texts(&output).1)
}

/// Returns the standard output of a command that ends successfully.
#[track_caller]
pub fn succeed(command: &mut Command) -> String {
    let (output, text) = run(command);
    assert!(output.status.success(), "{command:?}: {text}{}", texts(&output).1);
    text
}

/// Returns the width and the pixels of a frame that the intro writes without an error.
#[track_caller]
pub fn still(options: &str) -> (usize, Vec<u32>) {
    let (output, _) = run(&mut headless(options));
    let (_, errors) = texts(&output);
    assert!(output.status.success() && errors.is_empty(), "{options}: {errors}");
    reader::read_ppm(&output.stdout)
}

/// Waits for a value.
///
/// # Panics
/// After ten seconds.
pub fn wait_for<T>(what: &str, look: impl FnMut() -> Option<T>) -> T {
    try_for(look).unwrap_or_else(|| panic!("waited in vain for {what}"))
}

pub fn try_for<T>(mut look: impl FnMut() -> Option<T>) -> Option<T> {
    let start = Instant::now();
    while start.elapsed() < Duration::from_secs(10) {
        if let Some(value) = look() {
            return Some(value);
        }
        sleep(Duration::from_millis(10));
    }
    None
}

pub struct Process(pub Child);

impl Process {
    pub fn start(command: &mut Command) -> Process {
        let command = command.stdin(Stdio::null());
        let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
        Process(command.spawn().expect("the command starts"))
    }

    /// Returns the waiting time, the exit code (`None` after a signal), standard output and
    /// standard error.
    pub fn end(mut self) -> (Duration, Option<i32>, String, String) {
        let start = Instant::now();
        let status =
            wait_for("the end of a process", || self.0.try_wait().expect("it can be waited for"));
        let time = start.elapsed();
        let [mut output, mut errors] = [String::new(), String::new()];
        let pipes = (self.0.stdout.take(), self.0.stderr.take());
        if let (Some(mut out), Some(mut err)) = pipes {
            out.read_to_string(&mut output).expect("text");
            err.read_to_string(&mut errors).expect("text");
        }
        (time, status.code(), output, errors)
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

pub struct Server {
    pub process: Process,
    pub display: String,
    manager: Option<Process>,
    /// The window manager's settings, which it reads late.
    settings: Option<TempDir>,
}

impl Server {
    pub fn start(width: usize, height: usize) -> Server {
        Server::start_with(width, height, &[])
    }

    pub fn start_with(width: usize, height: usize, arguments: &[&str]) -> Server {
        let mut command = tool("Xvfb");
        let screen = format!("{width}x{height}x24");
        let mut process = Process::start(
            command
                .args(["-displayfd", "1", "-screen", "0", &screen])
                .args(["-nolisten", "tcp", "-noreset"])
                .args(arguments),
        );
        let mut number = String::new();
        let output = process.0.stdout.take().expect("a pipe");
        BufReader::new(output).read_line(&mut number).expect("Xvfb writes its display's number");
        assert!(!number.trim().is_empty(), "Xvfb does not start");
        Server { process, display: format!(":{}", number.trim()), manager: None, settings: None }
    }

    pub fn start_managed(width: usize, height: usize) -> Server {
        let mut server = Server::start(width, height);
        let mut openbox = tool("openbox");
        openbox.env("DISPLAY", &server.display);
        server.manager = Some(Process::start(&mut openbox));
        // Until its event loop runs, openbox ignores requests, so this one is repeated, and does
        // not place windows.
        server.wait_for_text("xdotool", "set_num_desktops 1 get_num_desktops", "1\n");
        server
    }

    pub fn start_with_twm(width: usize, height: usize) -> Server {
        let mut server = Server::start(width, height);
        let folder = tempfile::tempdir().expect("a folder");
        let settings = folder.path().join("twmrc");
        fs::write(&settings, "RandomPlacement\nNoGrabServer\n").expect("it is written");
        // In other languages twm prints a warning per missing font, more than a pipe holds.
        let mut twm = server.tool("twm");
        let twm = twm.env("LC_ALL", "C").arg("-f").arg(&settings);
        server.manager = Some(Process::start(twm));
        server.settings = Some(folder);
        server.wait_for_text("xwininfo", "-root -events", "SubstructureRedirect");
        server
    }

    fn wait_for_text(&self, tool: &str, words: &str, text: &str) {
        wait_for(&format!("{text:?} from {tool} {words}"), || {
            let (_, written) = run(self.tool(tool).args(words.split(' ')));
            written.contains(text).then_some(())
        });
    }

    pub fn tool(&self, name: &str) -> Command {
        let mut command = tool(name);
        command.env("DISPLAY", &self.display);
        command
    }

    pub fn xdotool(&self, words: &str) -> String {
        let mut xdotool = self.tool("xdotool");
        run(xdotool.args(words.split(' '))).1
    }

    pub fn play(&self, options: &str) -> Process {
        wait_for("the last window to close", || self.window().is_none().then_some(()));
        let mut command = Command::new(linked_intro());
        // Cheap frames leave the processors to other tests.
        let cheap = ["--silent", "--quality", "thesis", "--fps", "20"];
        command.args(cheap).args(options.split_whitespace());
        let intro = self.open(&mut command, || self.window());
        // openbox focuses new windows. twm, which has settings, does not.
        if self.manager.is_some() && self.settings.is_none() {
            self.wait_for_text("xdotool", "getwindowfocus getwindowname", "Eightfold\n");
        }
        intro
    }

    pub fn open(&self, command: &mut Command, window: impl Fn() -> Option<[i32; 4]>) -> Process {
        command.env("DISPLAY", &self.display);
        let mut program = Process::start(command);
        // In about one of a hundred runs no window appears, for an unknown reason.
        if try_for(&window).is_none() {
            let ended = program.0.try_wait().expect("a status");
            assert!(ended.is_none(), "the program ended without a window: {ended:?}");
            eprintln!("no window within 10 s: the program is started again");
            drop(program);
            program = Process::start(command);
            wait_for("the window", window);
        }
        program
    }

    /// Returns position and size without the frame; `None` until the window is visible.
    pub fn window(&self) -> Option<[i32; 4]> {
        self.geometry(&["-name", "Eightfold"])
    }

    /// Returns position and size of a window; `which` are arguments of xwininfo.
    pub fn geometry(&self, which: &[&str]) -> Option<[i32; 4]> {
        let mut xwininfo = self.tool("xwininfo");
        let (_, text) = run(xwininfo.args(which));
        let number = |label: &str| {
            let (_, rest) = text.split_once(label)?;
            rest.split_whitespace().next()?.parse().ok()
        };
        text.contains("IsViewable").then_some(())?;
        let labels = ["Absolute upper-left X:", "Absolute upper-left Y:", "Width:", "Height:"];
        let [x, y, width, height] = labels.map(number);
        Some([x?, y?, width?, height?])
    }

    pub fn wait_for_window(&self, wanted: [i32; 4]) {
        let found = try_for(|| self.window().filter(|&window| window == wanted));
        assert!(found.is_some(), "{:?}, not {wanted:?}", self.window());
        sleep(Duration::from_millis(200));
    }

    pub fn screenshot(&self, area: [i32; 4]) -> Vec<u32> {
        screenshot(&self.display, area)
    }

    /// Returns the window's contents by its own colour table.
    pub fn window_screenshot(&self) -> Vec<u32> {
        import(&self.display, &["-window", "Eightfold"])
    }
}

pub fn screenshot(display: &str, [x, y, width, height]: [i32; 4]) -> Vec<u32> {
    let part = format!("{width}x{height}+{x}+{y}");
    let pixels = import(display, &["-window", "root", "-crop", &part, "+repage"]);
    assert_eq!(pixels.len(), (width * height) as usize, "a whole picture");
    pixels
}

fn import(display: &str, arguments: &[&str]) -> Vec<u32> {
    let mut import = tool("import");
    let import = import.env("DISPLAY", display).args(arguments);
    from_rgb(&run(import.args(["-depth", "8", "rgb:-"])).0.stdout)
}

/// Runs `work` on several servers, given by their arguments. The test program starts itself with
/// another `DISPLAY`: changing the environment of a running program is unsafe.
pub fn on_displays(servers: &[&[&str]], work: fn()) {
    const INSIDE: &str = "EIGHTFOLD_TEST_INSIDE";
    if env::var_os(INSIDE).is_some() {
        return work();
    }
    needs!(DISPLAY);
    let test = thread::current().name().expect("a test").to_owned();
    for arguments in servers {
        let server = Server::start_with(1280, 1024, arguments);
        println!("a server with {arguments:?}");
        let mut inside = Command::new(env::current_exe().expect("this program"));
        inside.args([&test, "--exact", "--nocapture"]);
        succeed(inside.env("DISPLAY", &server.display).env(INSIDE, "1"));
    }
}
