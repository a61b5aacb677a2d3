//! Names that fields had in earlier versions, which scene files may still say.

use serde::{Deserialize, Deserializer};

/// The struct, the path that its items have in a file, its field's earlier name, and the name it has now.
const RENAMED: [(&str, &str, &str, &str); 4] = [
    ("Light", "lights", "radius", "drawn_radius"),
    ("Light", "lights", "size", "diameter"),
    ("Spot", "spot", "bright", "cos_inner"),
    ("Spot", "spot", "dark", "cos_outer"),
];

/// The name that a struct's field has now.
pub fn field(kind: &str, name: String) -> String {
    let mut all = RENAMED.iter();
    let renamed = all.find(|(of, _, before, _)| (*of, *before) == (kind, &name));
    renamed.map_or(name, |(.., now)| (*now).to_owned())
}

/// The path that a value at a path has now.
pub fn path(path: String) -> String {
    let Some((of, name)) = path.rsplit_once('.') else {
        return path;
    };
    let of_name = of
        .rsplit('.')
        .next()
        .and_then(|name| name.split('[').next());
    let mut all = RENAMED.iter();
    match all.find(|(_, list, before, _)| Some(*list) == of_name && *before == name) {
        Some((.., now)) => format!("{of}.{now}"),
        None => path,
    }
}

/// Reads a path.
pub fn read_path<'de, D: Deserializer<'de>>(from: D) -> Result<String, D::Error> {
    String::deserialize(from).map(path)
}

#[cfg(test)]
mod tests {
    use crate::SceneFile;

    const BEFORE: &str = r#"Scene(
    lights: [(position: (0.0, 9.0, 0.0), radius: 0.5, size: 1.0, spot: (aim: (0.0, -1.0, 0.0), bright: 0.9, dark: 0.8))],
    motions: [
        (of: "lights[0].size", keys: [(0.0, 1.0), (1.0, 2.0)]),
        (of: "lights[0].spot.dark", keys: [(0.0, 0.8), (1.0, 0.7)]),
    ],
)"#;

    #[test]
    fn a_file_of_an_earlier_version_is_read() {
        let now = BEFORE
            .replace("radius", "drawn_radius")
            .replace("size", "diameter")
            .replace("bright", "cos_inner")
            .replace("dark", "cos_outer");
        let read = |text: &str| SceneFile::parse("lamps.ron", text).expect("a scene");
        assert_eq!(read(BEFORE), read(&now));
        let twice = BEFORE.replace("size:", "diameter: 1.0, size:");
        SceneFile::parse("lamps.ron", &twice).expect_err("it says the diameter twice");
    }
}
