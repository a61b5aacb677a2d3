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

/// Motions | the column of the key before the mistake, and the message.
const REFUSED: &str = include_str!("refused_motions.txt");

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
const VALID: &str = include_str!("valid_motions.txt");

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
