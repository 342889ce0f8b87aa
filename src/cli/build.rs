//! Puts the engine for browsers into the program, where `MOMENTOUS_ENGINE` says where `src/browser/build` left it.

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), String> {
    println!("cargo::rustc-check-cfg=cfg(engine_for_browsers)");
    println!("cargo::rerun-if-env-changed=MOMENTOUS_ENGINE");
    let named = env::var_os("MOMENTOUS_ENGINE").filter(|name| !name.is_empty());
    let Some(module) = named.map(PathBuf::from) else { return Ok(()) };
    println!("cargo::rerun-if-changed={}", module.display());
    let folder = env::var_os("OUT_DIR").ok_or("cargo sets OUT_DIR")?;
    fs::copy(&module, Path::new(&folder).join("engine.wasm.gz"))
        .map_err(|error| format!("MOMENTOUS_ENGINE={}: {error}; `src/browser/build` makes it", module.display()))?;
    println!("cargo::rustc-cfg=engine_for_browsers");
    Ok(())
}
