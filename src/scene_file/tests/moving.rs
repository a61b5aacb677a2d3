//! Motions are valid at all times, or refused with a place.

use eightfold_scene_file::SceneFile;
use eightfold_scenes::{Random, cases};

/// Objects, and a motion of each kind of value.
const SCENE: &str = r#"Scene(
    length: 4.0,
    camera: (eye: (0.0, 1.0, 5.0)),
    materials: {"red": (kd: 0.5)},
    spheres: [(centre: (9, 9, 9), radius: 1, material: "red"), (centre: (0, 0, 0), radius: 1, material: "red")],
    blocks: [(shape: Capsule, centre: (0, 0, 0), half: (1, 2, 1), material: "red")],
    lights: [(), (spot: Some((aim: (0, -1, 0), inner_angle: 0.3, outer_angle: 0.5)))],
    motions: [
MOTIONS
    ],
)"#;

fn read(motions: &str) -> Result<SceneFile, String> {
    SceneFile::parse("a.ron", &SCENE.replace("MOTIONS", motions))
}

/// The motions | the column of the key before the mistake, and the message.
const REFUSED: &str = r#"
(of: "spheres[1].radius", between: Spline, keys: [(0, 0.001), (1, 0.001), (2, 5), (3, 0.001), (4, 0.001)]) | 51: motions[0] sets spheres[1].radius to -0.369
(of: "spheres[1].centre[1]", between: Spline, keys: [(0, 0), (1, 1e9), (2, 1e9)]) | 62: motions[0] sets spheres[1].centre to [0, 1074074100, 0] at 1.333 s; must be -1e9 to 1e9
(of: "materials[\"red\"].kd", between: Spline, keys: [(0, 0), (1, 1), (2, 1)]) | 63: motions[0] sets materials["red"].kd to 1.074074 at 1.333 s; must be 0 to 1
(of: "haze", between: Spline, repeat: true, keys: [(0, 0), (0.1, 0), (0.2, 1)]) | 52: motions[0] sets haze to -0.0
(of: "haze", keys: [(-2, 0), (-1, -1)]) | 30: motions[0] sets haze to -1 at 0 s; must be 0 to 1000
(of: "camera.eye", keys: [(0, (0, 1, 5)), (1, (0, -1, -5))]) | 27: motions[0] sets camera.eye to [0, 0, 0] at 0.5 s; camera.look_at must be different from eye
(of: "camera.eye", keys: [(0.1, (0.3, 1.1, 5.7)), (1.4, (-0.03, -0.11, -0.57))]) | 27: motions[0] sets camera.eye to
(of: "camera.eye[2]", keys: [(0, 5), (1.3, -7)]), (of: "camera.eye[1]", keys: [(0, 0)]) | 30: motions[0] sets camera.eye[2] to
(of: "camera.look_at", keys: [(0.0, (0, 1, 8)), (2.2, (0, 1, 0))]) | 31: motions[0] sets camera.look_at to [0, 1, 5] at 0.825 s; must be different from eye
(of: "camera.look_at", keys: [(0.0, (0, 1, 8)), (2.2, (0, 1, 0))]), (of: "camera.eye", repeat: true, keys: [(0, (0, 1, 4)), (0.7, (0, 1, 3))]) | at
(of: "camera.eye", keys: [(0, (0, 5, 5)), (1, (0, 5, -4))]) | 27: motions[0] sets camera.eye to [0, 5, 0.00
(of: "camera.eye", keys: [(0, (0, 5, 5)), (1, (0, 5, -4))]) | s; camera.up must be more than 0.001 radians off the line of sight
(of: "camera.eye", keys: [(0, (0, 0.001, 5)), (1, (0, 0.001, -4))]) | camera.up must be
(of: "camera.up", keys: [(0, (0.1, 1, 0)), (1.7, (-0.1, -1, 0))]) | motions[0] sets camera.up to [0, 0, 0] at 0.85 s
(of: "background", keys: [(0, (1, 1, 1)), (1, (0, 0, 0)), (2, (1, 1, 1))]), (of: "sky", keys: [(0, (0, 0, 0)), (2, (-0.5, 0, 0))]) | sets sky to [-0.25, 0, 0] at 1 s; must be -background to 1e9 - background
(of: "blocks[0].half[0]", keys: [(0, 1), (1, 2)]) | 42: motions[0] sets blocks[0].half to [2, 2, 1] at 1 s; must be equal in x and z
(of: "blocks[0].half", between: Spline, keys: [(0, (1, 2, 1)), (1, (1, 1, 1)), (2, (2, 2, 2))]) | must be equal in x and z, and no smaller in y
(of: "blocks[0].axes", keys: [(0, ((1, 0, 0), (0, 1, 0), (0, 0, 1))), (1, ((0, 1, 0), (-1, 0, 0), (0, 0, 1)))]) | must be of length 1, perpendicular
(of: "lights[1].spot.aim", keys: [(0, (0, -1, 0)), (1.3, (0, 0.7, 0))]) | 35: motions[0] sets lights[1].spot.aim to [0, 0, 0] at 0.765 s; must be longer than 0
(of: "lights[1].spot.outer_angle", keys: [(0, 0.5), (1, 0.2)]) | motions[0] sets lights[1].spot.outer_angle to 0.
(of: "lights[0].glow", keys: [(0, 3e38), (1, -3e38)]) | motions[0] sets lights[0].glow to -3000
(of: "length", keys: [(0, 1), (1, 2)]) | 23: path is "length"; must lead to a value of the scene
(of: "motions", keys: [(0, 1)]) | 24: path is "motions"; must lead to a value of the scene
(of: "haze", keys: [(0, 1), (1, NaN), (2, 1)]) | 29: value is NaN; must be finite
(of: "blocks[0].turn[0]", keys: [(0, 1), (1, inf)]) | 42: value is inf; must be finite
(of: "haze", keys: [(0, 0), (1e9, 1)]) | 29: time is 1000000000; must be -1e6 to 1e6
"#;

#[test]
fn motion_beyond_range_is_refused_at_its_key() {
    let mut wrong = String::new();
    for row in REFUSED.trim().lines() {
        let (motions, says) = row.split_once(" | ").expect("two columns");
        let fault = read(motions).map(|_| "no fault").map_or_else(|fault| fault, str::to_owned);
        if !fault.starts_with("a.ron:9:") || !fault.contains(says) {
            wrong += &format!("{motions}: {fault}\n");
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

/// Near misses.
const VALID: &str = r#"
(of: "materials[\"red\"].kd", between: Spline, keys: [(0, 1), (0.7, 1), (2, 1)])
(of: "materials[\"red\"].kd", between: Smooth, keys: [(0, 0.1), (0.7, 1), (2.3, 0)])
(of: "camera.eye", between: Spline, repeat: true, keys: [(0, (0, 1, 5)), (1, (5, 2, 0)), (2, (0, 1, -5)), (3, (-5, 3, 0)), (4, (0, 1, 5))])
(of: "camera.eye", between: Hold, keys: [(0, (0, 1, 5)), (1, (0, -1, -5)), (2, (0, 1, 5))])
(of: "camera.eye", repeat: true, keys: [(0, (0, 1, 5)), (1, (0, 1, 1)), (1.0001, (0, -1, -5)), (1.1, (0, -1, -5))])
(of: "camera.eye", keys: [(0, (0, 0.1, 5)), (1, (0.1, 0, -5))])
(of: "camera.eye", keys: [(0, (0, 1, 1e4)), (1, (0, 0, 1e-3)), (2, (0, 1, 1e4))])
(of: "camera.eye", keys: [(0, (0.1, 5, 5)), (1, (0.1, 5, -4))])
(of: "blocks[0].turn", between: Spline, keys: [(0, (1e6, 2, 1)), (1, (1, -1, 1)), (2, (9, 2, 2))])
(of: "lights[1].drawn_radius", keys: [(0, 0), (1, 1)])
(of: "lights[1].spot.aim", between: Smooth, keys: [(0, (0, -1, 0.01)), (1.3, (0, 0.7, 0))])
(of: "haze", keys: [(3, 1)]), (of: "exposure", repeat: true, keys: [(0, 1), (0.01, 1)])
"#;

#[test]
fn motion_within_range_is_read() {
    let mut random = Random::new(2008);
    for motions in VALID.trim().lines() {
        let file = read(motions).expect(motions);
        for _ in 0..2000 {
            let time = 6.0 * random.unit() as f32 - 1.0;
            assert_eq!(file.check(time), Ok(()), "{motions}");
        }
    }
}

/// A path, and the numbers of a value: a digit, scaled to its range.
const FIELDS: [(&str, usize, f32); 12] = [
    ("camera.eye", 3, 1.0),
    ("camera.look_at", 3, 1.0),
    ("camera.up", 3, 0.5),
    ("background", 3, 0.3),
    ("sky", 3, -0.1),
    ("exposure", 1, 1.0),
    ("materials[\\\"red\\\"].kd", 1, 0.1),
    ("spheres[1].radius", 1, 1.0),
    ("lights[1].spot.aim", 3, -0.5),
    ("lights[1].spot.inner_angle", 1, 0.05),
    ("lights[1].spot.outer_angle", 1, 0.2),
    ("blocks[0].half[1]", 1, 1.0),
];

fn motion(random: &mut Random) -> String {
    let (path, count, scale) = FIELDS[random.below(FIELDS.len())];
    let between = ["Linear", "Smooth", "Spline", "Spline", "Hold"][random.below(5)];
    let (mut time, mut keys) = (0.0, String::new());
    for _ in 0..2 + random.below(4) {
        let numbers: Vec<String> =
            (0..count).map(|_| (scale * random.below(10) as f32).to_string()).collect();
        keys += &format!("({time}, ({})), ", numbers.join(", "));
        time += [0.25, 0.7, 1.3][random.below(3)];
    }
    // A number has no brackets.
    let keys = match count {
        1 => keys.replace(", (", ", ").replace("))", ")"),
        _ => keys,
    };
    let repeat = random.below(2) == 0;
    format!("(of: \"{path}\", between: {between}, repeat: {repeat}, keys: [{keys}])")
}

/// Scenes of random motions that are read are valid at all times, and many are refused.
#[test]
fn random_motions_are_refused_or_valid() {
    let [mut read_count, mut refused] = [0; 2];
    for mut random in cases(200) {
        let count = 1 + random.below(3);
        let motions: Vec<String> = (0..count).map(|_| motion(&mut random)).collect();
        let motions = motions.join(", ");
        match read(&motions) {
            Ok(file) => {
                read_count += 1;
                for _ in 0..300 {
                    let time = 5.0 * random.unit() as f32;
                    assert_eq!(file.check(time), Ok(()), "{motions}");
                }
            }
            Err(fault) => {
                refused += 1;
                assert!(fault.len() <= 200, "{fault}");
            }
        }
    }
    assert!(read_count > 30 && refused > 30, "{read_count}, {refused}");
}
