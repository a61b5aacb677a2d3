//! The linker's map of the intro, as lld writes it.
//!
//! Numbers in hexadecimal, addresses twice, size, alignment; then at three depths a section of the program, a part of an
//! object file, and a symbol in there.

/// Something in the program's file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    pub name: String,
    /// The crate that was compiled to it; empty for a section.
    pub of: String,
    pub bytes: u64,
}

/// What is in the program's file.
#[derive(Default)]
pub struct Map {
    pub sections: Vec<Part>,
    /// As the linker names them; together they are the section of code, without what aligns them.
    pub functions: Vec<Part>,
}

/// Where names begin in a line, and how much deeper each depth is.
const NAMES: usize = 49;
const DEPTH: usize = 8;

/// Sections that are not in the file: zeros, and what is left out.
const ELSEWHERE: [&str; 2] = [".bss", ".unsaid"];

impl Map {
    /// Reads a map.
    pub fn parse(text: &str) -> Self {
        let mut map = Self::default();
        let mut is_code = false;
        // Bytes of the part that is read, as long as no symbol has a share of them.
        let mut part: Option<Part> = None;
        for line in text.lines().filter_map(Line::parse) {
            let Line {
                bytes, depth, name, ..
            } = line;
            if depth < 2 {
                map.functions.extend(part.take());
            }
            let named = |name: &str, of: &str| Part {
                name: name.to_owned(),
                of: of.to_owned(),
                bytes,
            };
            match depth {
                0 => {
                    is_code = name == ".text";
                    if line.is_placed && is_section(name) {
                        map.sections.push(named(name, ""));
                    }
                }
                // Its section's name, for want of a symbol.
                1 if is_code && bytes > 0 => {
                    let (object, section) = name.rsplit_once(":(").unwrap_or((name, name));
                    part = Some(named(section.trim_end_matches(')'), crate_of(object)));
                }
                // The first of some names of one function, or of a piece of assembly.
                2 if bytes > 0 => {
                    if let Some(part) = &mut part
                        && part.name.starts_with('.')
                    {
                        name.clone_into(&mut part.name);
                    }
                }
                _ => {}
            }
        }
        map.functions.extend(part);
        map
    }
}

/// Whether it is a section of the file, and no assignment such as `. = 0x400000`.
fn is_section(name: &str) -> bool {
    name.starts_with('.') && !name.contains(' ') && !ELSEWHERE.contains(&name)
}

/// The crate of an object file: `libNAME-HASH.rlib(...)` in a library, `NAME-HASH...o` by itself.
fn crate_of(object: &str) -> &str {
    let (path, is_library) = match object.split_once(".rlib(") {
        Some((library, _)) => (library, true),
        None => (object, false),
    };
    let file = path.rsplit('/').next().unwrap_or(path);
    let name = file.split(['-', '.']).next().unwrap_or(file);
    if is_library {
        name.strip_prefix("lib").unwrap_or(name)
    } else {
        name
    }
}

/// A line of a map.
struct Line<'a> {
    /// Whether it has an address.
    is_placed: bool,
    bytes: u64,
    /// 0: a section, 1: a part, 2: a symbol.
    depth: usize,
    name: &'a str,
}

impl<'a> Line<'a> {
    fn parse(line: &'a str) -> Option<Self> {
        let (numbers, name) = line.split_at_checked(NAMES)?;
        let mut numbers = numbers.split_whitespace();
        let (address, size) = (numbers.next()?, numbers.nth(1)?);
        let depth = (name.len() - name.trim_start().len()) / DEPTH;
        Some(Self {
            is_placed: address != "0",
            bytes: u64::from_str_radix(size, 16).ok()?,
            depth,
            name: name.trim(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Map, Part};

    const MAP: &str = "\
             VMA              LMA     Size Align Out     In      Symbol
          100000           100000      5c8     8 .unsaid
          100000           100000       b6     1         <internal>:(.rodata.str1.1)
          1005c8           1005c8   2ffa38     1 . = 0x400000
          400000           400000      23c     1 .head
          400000           400000      23c     1         x.o:(.head)
          401820           401820      1b0    16 .text
          401820           401820       c7     1         /a/b-c/x-0123.x.4567-cgu.0.rcgu.o:(.text._start)
          401820           401820        0     1                 _start
          40186f           40186f        0     1                 dlsym
          4018f0           4018f0       20    16         /a/b-c/libd_e-0123.rlib(d_e-0123.o):(.text._ZN1x1yE)
          4018f0           4018f0       20     1                 x::y::h0123456789abcdef
          4018f0           4018f0       20     1                 x::z::h0123456789abcdef
          40ccbd           40ccbd        0     1 file_size = . - 0x400000
          40d000           40d000  6f22270     8 .bss
          40d000           40d000       a0     1         x.o:(.bss.c_slots)
               0                0       2c     1 .shstrtab
";

    fn part(name: &str, of: &str, bytes: u64) -> Part {
        Part {
            name: name.to_owned(),
            of: of.to_owned(),
            bytes,
        }
    }

    #[test]
    fn what_is_in_the_file_counts_once() {
        let map = Map::parse(MAP);
        assert_eq!(
            map.sections,
            [part(".head", "", 0x23c), part(".text", "", 0x1b0)]
        );
        let start = part(".text._start", "x", 0xc7);
        let function = part("x::y::h0123456789abcdef", "d_e", 0x20);
        assert_eq!(map.functions, [start, function]);
    }

    #[test]
    fn what_is_no_map_has_nothing_in_it() {
        let map =
            Map::parse("no map\n\nat all, although this line is long enough to have a name in it");
        assert!(map.sections.is_empty() && map.functions.is_empty());
    }
}
