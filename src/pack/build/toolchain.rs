use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{at, variable};
use crate::Error;

pub const TARGET: &str = "x86_64-unknown-linux-gnu";

pub struct Toolchain {
    pub rustc: OsString,
    pub linker: String,
}

impl Toolchain {
    pub fn find() -> Result<Toolchain, Error> {
        let target = variable("TARGET")?;
        if target != TARGET {
            return Err(format!("target is {target}; must be {TARGET}").into());
        }
        let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
        let output = Command::new(&rustc).args(["--print", "sysroot"]).output();
        let output = at(&rustc, output)?;
        let sysroot = PathBuf::from(String::from_utf8(output.stdout)?.trim());
        let own = sysroot.join("lib/rustlib").join(variable("HOST")?).join("bin/gcc-ld/ld.lld");
        let own = own.to_str().filter(|_| own.exists());
        let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
        let linker = linker(&flags, env::var("RUSTC_LINKER").ok(), own)?;
        Ok(Toolchain { rustc, linker })
    }

    pub fn base(&self) -> &'static str {
        if self.linker.ends_with("lld") || self.linker.ends_with("mold") {
            "--image-base"
        } else {
            "-Ttext-segment"
        }
    }
}

/// Returns the linker, from the user's flags for rustc, cargo's C compiler, and rustc's own linker.
fn linker(flags: &str, compiler: Option<String>, own: Option<&str>) -> Result<String, Error> {
    let last = |option: &str| {
        let (_, value) = flags.rsplit_once(option)?;
        value.split(['\x1f', ' ']).next().map(String::from)
    };
    let flavor = last("linker-flavor=").filter(|flavor| flavor.ends_with("ld"));
    let compiler = flavor.or(last("linker=")).or(compiler).unwrap_or("cc".into());
    let name = Path::new(&compiler).file_stem().unwrap_or_default().to_string_lossy();
    if name.ends_with("ld") {
        return Err(format!("linker is {compiler}; must be a C compiler").into());
    }
    if let Some(path) = last("--ld-path") {
        return Err(format!("linker option is --ld-path{path}; must be -fuse-ld").into());
    }
    let is_without = ["linker-features=-lld", "link-self-contained=-linker"]
        .iter()
        .any(|flag| flags.contains(flag));
    let own = own.filter(|_| !is_without).unwrap_or("ld");
    Ok(match last("-fuse-ld=") {
        Some(path) if path.contains('/') => path,
        Some(name) => format!("ld.{name}"),
        None => own.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::linker;

    fn chosen(flags: &str) -> Option<String> {
        linker(&flags.replace(' ', "\x1f"), None, Some("own")).ok()
    }

    #[test]
    fn linker_matches_flags() {
        for row in "= own
            -Ctarget-cpu=native --cfg linker = own
            -Clinker-features=-lld = ld
            -C linker-features=-lld -C link-arg=-fuse-ld=gold = ld.gold
            -Clink-arg=-fuse-ld=gold --codegen link-arg=-fuse-ld=mold = ld.mold
            -Clinker=/usr/bin/clang-19 -Clink-arg=-fuse-ld=/opt/mold = /opt/mold
            -Clinker-flavor=gnu-lld-cc = own"
            .lines()
        {
            let (flags, expected) = row.trim().rsplit_once("= ").expect("two columns");
            let flags = flags.trim();
            assert_eq!(chosen(flags).as_deref(), Some(expected), "{flags}");
        }
    }

    #[test]
    fn linker_without_c_compiler_is_refused() {
        for flags in
            "-Clinker=rust-lld -Clinker=/usr/bin/ld.lld -Clinker-flavor=ld.lld -Clinker=mold \
                      -Clink-arg=--ld-path=/opt/mold"
                .split(' ')
        {
            assert_eq!(chosen(flags), None, "{flags}");
        }
        assert!(linker("", Some("rust-lld".into()), None).is_err());
        assert!(linker("-Clinker=gcc", Some("rust-lld".into()), None).is_ok());
    }
}
