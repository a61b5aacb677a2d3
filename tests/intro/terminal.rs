//! Without a display the intro plays in a terminal (tmux), and restores it at the end.

use eightfold_stage::{linked_intro, needs, run, succeed, tool, try_for, wait_for};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::thread::sleep;
use std::time::Duration;
use std::{env, fs, process};

struct Terminal {
    socket: PathBuf,
    /// Process ids of the shell and of tmux.
    shell: String,
    reader: String,
}

impl Terminal {
    /// Starts the intro, and waits for a picture. At the end the terminal shows the exit code and
    /// whether its mode was restored.
    fn play(columns: usize, rows: usize, options: &str) -> Terminal {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let name = format!("eightfold-{}-{}", process::id(), COUNT.fetch_add(1, Relaxed));
        let mut terminal = Terminal {
            socket: env::temp_dir().join(name),
            shell: String::new(),
            reader: String::new(),
        };
        let script = format!(
            "unset DISPLAY COLORTERM STY; export LC_ALL=C.UTF-8 ALSA_CONFIG_PATH=/dev/null; stty sane; before=$(stty -g); {} {options}; code=$?; \
             [ \"$before\" = \"$(stty -g)\" ] && echo mode restored; echo code $code; sleep 60",
            linked_intro().display()
        );
        let (x, y) = (columns.to_string(), rows.to_string());
        let size = ["-x", &x, "-y", &y];
        terminal.tmux(&[&["new-session", "-d"], &size[..], &["sh", "-c", &script]].concat());
        terminal.shell = terminal.value("pane_pid");
        terminal.reader = terminal.value("pid");
        terminal.wait_for_picture(columns, rows);
        terminal
    }

    fn tmux(&self, words: &[&str]) -> String {
        let mut tmux = tool("tmux");
        tmux.args(["-f", "/dev/null", "-u", "-S"]);
        succeed(tmux.arg(&self.socket).args(words))
    }

    fn value(&self, name: &str) -> String {
        let text = self.tmux(&["display", "-p", &format!("#{{{name}}}")]);
        text.trim().to_owned()
    }

    fn text(&self) -> String {
        self.tmux(&["capture-pane", "-p", "-e"])
    }

    fn wait_for_picture(&self, columns: usize, rows: usize) {
        wait_for("a picture", || {
            let text = self.text();
            let full = |line: &str| line.matches('\u{2580}').count() == columns;
            (text.lines().filter(|line| full(line)).count() == rows).then_some(())
        });
    }

    fn ended(&self, code: i32) -> String {
        let text = wait_for("the end", || {
            let text = self.text();
            text.contains("code ").then_some(text)
        });
        assert!(text.contains(&format!("code {code}")), "{text}");
        assert!(text.contains("mode restored"), "{text}");
        text
    }

    fn wait_for_end(&self, code: i32) {
        let text = self.ended(code);
        let fallback = "X display is missing; playing in the terminal";
        assert!(text.contains(fallback), "{text}");
        assert!(text.contains("; playing silently"), "not wiped out: {text}");
        assert!(text.contains("frames in"), "the report: {text}");
        let flags = ["alternate_on", "cursor_flag", "wrap_flag"].map(|flag| self.value(flag));
        assert_eq!(flags, ["0", "1", "1"]);
    }

    fn signal(&self, name: &str) {
        let mut pkill = tool("pkill");
        run(pkill.args(["--signal", name, "-P", &self.shell, "eightfold"]));
    }

    /// Sends a signal to tmux, which reads the output unless stopped.
    fn signal_reader(&self, name: &str) {
        sh(&format!("kill -{name} {}", self.reader));
    }
}

fn sh(command: &str) {
    succeed(process::Command::new("sh").args(["-c", command]));
}

impl Drop for Terminal {
    fn drop(&mut self) {
        let mut tmux = tool("tmux");
        run(tmux.arg("-S").arg(&self.socket).arg("kill-server"));
        let _ = fs::remove_file(&self.socket);
    }
}

fn script(intro_in_shell: &str) -> process::Command {
    let mut script = tool("script");
    script.args(["-qec", intro_in_shell, "/dev/null"]);
    for name in ["DISPLAY", "COLORTERM", "STY", "TMUX"] {
        script.env_remove(name);
    }
    script.env("TERM", "xterm").env("LC_ALL", "C.UTF-8");
    script.stdin(process::Stdio::null());
    script
}

#[test]
fn terminal_of_any_size_shows_moving_pictures() {
    needs!(&["tmux", "pkill"]);
    let terminal = Terminal::play(80, 24, "");
    let before = terminal.text();
    assert!(before.contains("\x1b[38;2;"), "24-bit colours: {before:?}");
    wait_for("another frame", || (terminal.text() != before).then_some(()));
    for (columns, rows) in [(37, 11), (2, 1), (200, 50)] {
        let (width, height) = (columns.to_string(), rows.to_string());
        terminal.tmux(&["resize-window", "-x", &width, "-y", &height]);
        terminal.wait_for_picture(columns, rows);
    }
    terminal.tmux(&["send-keys", "Escape"]);
    terminal.wait_for_end(0);
}

/// Variables, the bits of a colour, and whether there are half blocks. ssh and sudo drop `STY`.
const TERMINALS: &str = include_str!("terminals.txt");

#[test]
fn terminal_and_locale_select_colours_and_letters() {
    needs!(&["script"]);
    for line in TERMINALS.trim().lines() {
        let (variables, expected) = line.trim().split_once(" | ").expect("two parts");
        let text = played(variables, SCREEN, "--fps 10 --seconds 0.3");
        let bits = match ["[48;2;", "[48;5;"].map(|code| text.contains(code)) {
            [true, false] => 24,
            [false, true] => 8,
            [false, false] => 0,
            _ => panic!("{variables}: both"),
        };
        let is_ascii = text.is_ascii();
        let letters = if is_ascii { "ASCII" } else { "UTF-8" };
        assert_eq!(format!("{bits} {letters}"), expected, "{variables}");
        assert_eq!(text.contains('\u{2580}'), !is_ascii, "{variables}");
        let (_, first) = text.split_once("\x1b[1;1H").expect("a picture");
        let kinds = ".:-=+*#%@".chars().filter(|&letter| {
            // Not in the codes of colours or positions.
            first.contains(&String::from_iter([letter; 2]))
        });
        assert_eq!(kinds.count() > 2, bits == 0, "{variables}: letters by brightness");
    }
}

#[test]
fn report_has_the_letters_of_the_locale() {
    needs!(&["script"]);
    for (variables, sign) in [("LC_ALL=C", " +- "), ("LC_ALL=C.UTF-8", " ± ")] {
        // A busy machine draws its first measured frame late.
        let texts = ["2", "8", "32"].into_iter();
        let mut texts = texts
            .map(|seconds| played(variables, SCREEN, &format!("--fps 10 --seconds {seconds}")));
        let text = texts.find(|text| text.contains(" dB to ")).expect("an accuracy");
        let (_, report) = text.split_once(" frames in ").expect("a report");
        assert!(report.contains(sign), "{variables}: {report}");
    }
}

const SCREEN: &str = "cols 60 rows 20";

fn played(variables: &str, size: &str, options: &str) -> String {
    let play = format!("stty {size}; {} --silent {options}", linked_intro().display());
    let pairs = variables.split(' ').map(|word| word.split_once('='));
    succeed(script(&play).envs(pairs.map(|pair| pair.expect("a value"))))
}

#[test]
fn terminal_wider_than_any_frame_shows_a_part() {
    needs!(&["script"]);
    let text = played("TERM=xterm", "cols 65535 rows 2", "--seconds 0.5");
    assert!(text.contains("3840x4"), "{text}");
    assert!(text.contains('\u{2580}'), "a picture");
}

#[test]
fn terminal_without_colours_gets_no_picture() {
    needs!(&["script"]);
    let text = played("TERM=dumb", SCREEN, "--seconds 0.2 --size 64x48");
    assert!(text.contains("playing without a screen"), "{text}");
    assert!(!text.contains('\x1b'), "{text}");
}

#[test]
fn only_escape_q_and_control_c_end_the_intro() {
    needs!(&["tmux", "pkill"]);
    // Keys come from the terminal even if standard input is another file.
    for (key, input) in [("Escape", ""), ("q", ""), ("C-c", "< /dev/null")] {
        let terminal = Terminal::play(60, 20, input);
        terminal.tmux(&["send-keys", "Up", "F5", "x", "Home", "C-z", "C-s"]);
        sleep(Duration::from_millis(300));
        terminal.tmux(&["send-keys", "M-x"]);
        sleep(Duration::from_millis(300));
        terminal.wait_for_picture(60, 20);
        terminal.tmux(&["send-keys", key]);
        terminal.wait_for_end(0);
        assert!(!terminal.text().contains('\u{2580}'), "no picture is left");
    }
}

/// A crash prints no report.
#[test]
fn end_or_signal_restores_the_terminal() {
    needs!(&["tmux", "pkill"]);
    Terminal::play(60, 20, "--seconds 1").wait_for_end(0);
    for (name, number) in [("TERM", 15), ("HUP", 1), ("INT", 2), ("RTMIN+30", 64)] {
        let terminal = Terminal::play(60, 20, "");
        terminal.signal(name);
        terminal.wait_for_end(128 + number);
    }
    let terminal = Terminal::play(60, 20, "");
    terminal.signal("SEGV");
    terminal.ended(128 + 11);
    assert_eq!(terminal.value("alternate_on"), "0");
}

#[test]
fn continued_process_restores_the_picture() {
    needs!(&["tmux", "pkill"]);
    let terminal = Terminal::play(60, 20, "");
    let tty = terminal.value("pane_tty");
    // Without a reader, the intro waits in the middle of a frame.
    terminal.signal_reader("STOP");
    sleep(Duration::from_millis(500));
    terminal.signal("STOP");
    terminal.signal_reader("CONT");
    sh(&format!("stty -F {tty} sane; printf '\\033[?1049l' > {tty}"));
    terminal.signal("CONT");
    wait_for("the alternate screen", || (terminal.value("alternate_on") == "1").then_some(()));
    terminal.wait_for_picture(60, 20);
    terminal.tmux(&["send-keys", "Escape"]);
    terminal.wait_for_end(0);
}

#[test]
#[ignore = "it waits"]
fn unread_terminal_does_not_delay_the_end() {
    needs!(&["tmux", "pkill", "pgrep"]);
    for (options, signal) in [("", Some("TERM")), ("--seconds 4", None)] {
        let terminal = Terminal::play(200, 50, options);
        let intro = run(tool("pgrep").args(["-P", &terminal.shell, "eightfold"])).1;
        let intro = PathBuf::from("/proc").join(intro.trim());
        terminal.signal_reader("STOP");
        sleep(Duration::from_secs(2));
        if let Some(name) = signal {
            terminal.signal(name);
        }
        let ended = try_for(|| (!intro.exists()).then_some(()));
        terminal.signal_reader("CONT");
        assert_eq!(ended, Some(()), "{options} {signal:?}");
    }
}
