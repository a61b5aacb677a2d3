//! Names of functions, as a reader wants them.

/// What the names of older mangling have for signs that linkers don't take.
const SIGNS: [(&str, &str); 9] = [
    ("$LT$", "<"),
    ("$GT$", ">"),
    ("$LP$", "("),
    ("$RP$", ")"),
    ("$RF$", "&"),
    ("$BP$", "*"),
    ("$SP$", "@"),
    ("$C$", ","),
    ("..", "::"),
];

/// A name without the hash at its end, and with its signs.
pub fn readable(name: &str) -> String {
    let name = match name.rsplit_once("::h") {
        Some((name, hash)) if is_hash(hash) => name,
        _ => name,
    };
    if !name.contains('$') {
        return name.to_owned();
    }
    let mut readable = name.replace("::_$", "::$");
    if let Some(rest) = name.strip_prefix("_$") {
        readable = format!("${rest}").replace("::_$", "::$");
    }
    for (code, sign) in SIGNS {
        readable = readable.replace(code, sign);
    }
    signs_by_number(&readable)
}

fn is_hash(text: &str) -> bool {
    text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Resolves `$u20$` and the like, which are signs by their number.
fn signs_by_number(name: &str) -> String {
    let mut readable = String::new();
    let mut rest = name;
    while let Some((before, after)) = rest.split_once("$u") {
        let sign = after.split_once('$').and_then(|(code, after)| {
            let sign = char::from_u32(u32::from_str_radix(code, 16).ok()?)?;
            Some((sign, after))
        });
        readable += before;
        (readable, rest) = match sign {
            Some((sign, after)) => (readable + sign.encode_utf8(&mut [0; 4]), after),
            None => (readable + "$u", after),
        };
    }
    readable + rest
}

#[cfg(test)]
mod tests {
    use super::readable;

    #[test]
    fn names_are_readable() {
        for (name, wanted) in [
            ("a::b::h0123456789abcdef", "a::b"),
            ("a::b::h0", "a::b::h0"),
            (
                "<&u16 as core::fmt::Debug>::fmt",
                "<&u16 as core::fmt::Debug>::fmt",
            ),
            (
                "_$LT$w..a..B$u20$as$u20$core..iter..Iterator$GT$::next::h0123456789abcdef",
                "<w::a::B as core::iter::Iterator>::next",
            ),
            (
                "core::array::_$LT$impl$u20$$u5b$T$u3b$$u20$N$u5d$$GT$::try_map",
                "core::array::<impl [T; N]>::try_map",
            ),
            (
                "alloc::vec::Vec$LT$T$C$A$GT$::reserve",
                "alloc::vec::Vec<T,A>::reserve",
            ),
        ] {
            assert_eq!(readable(name), wanted);
        }
    }
}
