use super::{on_screen, servers};
use eightfold_stage::{DISPLAY, Server, needs, run, succeed};
use std::{process::Command, thread::sleep, time::Duration};

#[test]
fn closed_window_ends_the_intro() {
    needs!(DISPLAY);
    let server = on_screen(Server::start_managed);
    // Close by a message of the window manager, then by force.
    for (tool, words) in
        [("wmctrl", "-c Eightfold"), ("xdotool", "search --name Eightfold windowclose")]
    {
        let intro = server.play("--size 64x48 --seconds 60");
        sleep(Duration::from_millis(300));
        run(server.tool(tool).args(words.split(' ')));
        let (time, code, output, errors) = intro.end();
        assert_eq!(code, Some(0), "{tool}: {output}{errors}");
        assert_eq!(errors, "");
        assert_eq!(output.lines().count(), 1, "{tool}: {output}");
        assert!(time < Duration::from_secs(2), "{tool}: {time:?}");
    }
}

#[test]
fn lost_server_is_reported() {
    needs!(DISPLAY);
    for (manager, mut server) in servers() {
        let intro = server.play("--size 64x48 --seconds 60");
        sleep(Duration::from_millis(300));
        server.process.0.kill().expect("it runs");
        let (_, code, output, errors) = intro.end();
        assert_eq!(code, Some(1), "{manager}: {output}{errors}");
        assert_eq!(errors, "eightfold: X display is lost\n");
    }
}

#[test]
fn stopped_process_pauses_the_show() {
    needs!(DISPLAY);
    const STOP: f64 = 2.0;
    let server = Server::start(320, 240);
    let intro = server.play("--size 64x48 --seconds 3");
    let tell = |signal: &str| {
        succeed(Command::new("sh").arg("-c").arg(format!("kill -{signal} {}", intro.0.id())));
    };
    tell("STOP");
    sleep(Duration::from_secs_f64(STOP));
    tell("CONT");
    let (_, code, output, errors) = intro.end();
    assert_eq!(code, Some(0), "{errors}");
    let (_, time) = output.split_once(" in ").expect("a report");
    let time: f64 = time.split(' ').next().expect("a time").parse().expect("a number");
    assert!(time >= 3.0 + STOP, "{output}");
}
