//! A program's version information for Windows: a resource `VS_VERSIONINFO` in a tree of its own.

pub struct Version {
    pub name: String,
    pub number: String,
}

/// The resource's type, its number, and its language (US English).
const PATH: [u32; 3] = [16, 1, 0x409];

/// The size of a resource table with one entry, and of a data entry.
const TABLE: usize = 16 + 8;
const ENTRY: usize = 16;

impl Version {
    pub fn to_resources(&self, address: u32) -> Vec<u8> {
        let info = self.to_info();
        let mut bytes = Vec::new();
        for (level, number) in PATH.into_iter().enumerate() {
            bytes.extend([0; 14]);
            bytes.extend(1_u16.to_le_bytes());
            bytes.extend(number.to_le_bytes());
            let next = (TABLE * (level + 1)) as u32;
            // The highest bit marks a subtable.
            let is_last = level + 1 == PATH.len();
            let flag = if is_last { 0 } else { 1 << 31 };
            bytes.extend((next | flag).to_le_bytes());
        }
        let start = (bytes.len() + ENTRY) as u32;
        for number in [address + start, info.len() as u32, 0, 0] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend(info);
        bytes
    }

    fn to_info(&self) -> Vec<u8> {
        let mut parts = self.number.split('.').map(|part| part.parse().unwrap_or(0));
        let mut part = || parts.next().unwrap_or(0_u32);
        let (high, low) = (part() << 16 | part(), part() << 16);
        // VS_FIXEDFILEINFO: signature, its version, file version, product version, mask of valid flags, flags, Windows NT, program,
        // subtype, date.
        #[rustfmt::skip]
        let fixed = [0xfeef_04bd, 0x1_0000, high, low, high, low, 63, 0, 0x4_0004, 1, 0, 0, 0];
        let strings = [
            ("FileDescription", &self.name),
            ("FileVersion", &self.number),
            ("ProductName", &self.name),
        ];
        let strings: Vec<_> = strings
            .into_iter()
            .map(|(key, value)| {
                let text = to_utf16(value);
                node(key, true, text.len() / 2, text, &[])
            })
            .collect();
        let table = node("040904b0", true, 0, Vec::new(), &strings);
        let translation = [0x409_u16, 1200].map(u16::to_le_bytes).concat();
        let translation = node("Translation", false, 4, translation, &[]);
        let children = [
            node("StringFileInfo", true, 0, Vec::new(), &[table]),
            node("VarFileInfo", true, 0, Vec::new(), &[translation]),
        ];
        let fixed = fixed.map(u32::to_le_bytes).concat();
        node("VS_VERSION_INFO", false, fixed.len(), fixed, &children)
    }
}

fn to_utf16(text: &str) -> Vec<u8> {
    let units = text.encode_utf16().chain([0]);
    units.flat_map(u16::to_le_bytes).collect()
}

/// Returns a node: three 16-bit fields, a name, a value and child nodes, each aligned to 4 bytes.
fn node(name: &str, is_text: bool, length: usize, value: Vec<u8>, children: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = vec![0; 6];
    bytes.extend(to_utf16(name));
    for part in [&value].into_iter().chain(children) {
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        bytes.extend(part);
    }
    let head = [bytes.len() as u16, length as u16, is_text.into()].map(u16::to_le_bytes);
    bytes[..6].copy_from_slice(head.as_flattened());
    bytes
}
