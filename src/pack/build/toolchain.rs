use std::{
    env,
    ffi::OsString,
    path::{Path, PathBuf},
    process::Command,
};

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
    // Options for code generation are `-Cname=value`, `-C name=value`, and the same with `--codegen`.
    let flags =
        flags.replace("--codegen=", "-C").replace("--codegen\x1f", "-C").replace("-C\x1f", "-C");
    let options = flags.split('\x1f');
    let (mut compiler, mut chosen, mut own) = (compiler, None, own);
    for (name, value) in options.filter_map(|option| option.strip_prefix("-C")?.split_once('=')) {
        match name {
            "linker" => compiler = Some(value.into()),
            "linker-flavor" if value != "gcc" && !value.ends_with("-cc") => {
                compiler = Some("ld".into())
            }
            "linker-features" if value.split(',').any(|feature| feature == "-lld") => own = None,
            "link-self-contained" if value.split(',').any(|part| part == "-linker") => own = None,
            "link-arg" | "link-args" => {
                for word in value.split(' ') {
                    if word.starts_with("--ld-path") {
                        return Err(format!("linker option is {word}; must be -fuse-ld").into());
                    }
                    chosen = word.strip_prefix("-fuse-ld=").or(chosen);
                }
            }
            _ => {}
        }
    }
    let compiler = compiler.unwrap_or("cc".into());
    let name = Path::new(&compiler).file_stem().unwrap_or_default().to_string_lossy();
    if name.ends_with("ld") || name.ends_with("ld.lld") || name == "mold" {
        return Err(format!("linker is {compiler}; must be a C compiler").into());
    }
    Ok(match (chosen, own) {
        (Some(path), _) if path.contains('/') => path.into(),
        (Some(name), _) => format!("ld.{name}"),
        (None, Some(own)) => own.into(),
        (None, None) => "ld".into(),
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
        let refused =
            "-Clinker=rust-lld|-Clinker=/usr/bin/ld.lld|-C linker-flavor=ld.lld|-Clinker=mold";
        for flags in refused.split('|') {
            assert_eq!(chosen(flags), None, "{flags}");
        }
        assert!(linker("", Some("rust-lld".into()), None).is_err());
        assert!(linker("-Clinker=gcc", Some("rust-lld".into()), None).is_ok());
    }
}
