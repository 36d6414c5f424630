//! What executables, libraries and objects (ELF) say about themselves: what they need and what they offer.

use crate::commands::Failure;
use object::read::archive::ArchiveFile;
use object::read::elf::{Dyn, FileHeader, ProgramHeader, SectionTable, Sym};
use object::{Endianness, FileKind, elf};
use std::collections::BTreeSet;
use std::path::Path;

/// The kind of a file.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A program that the dynamic linker completes.
    Dynamic,
    /// A program that is complete.
    Static,
    /// A shared library.
    Library,
    /// What a compiler has made of a source file.
    Object,
    /// A static library: a collection of objects.
    Archive,
}

/// What a file says about itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binary {
    /// The kind of the file.
    pub kind: Kind,
    /// The names of the shared libraries that it needs.
    pub needed: Vec<String>,
    /// Where it has them looked for, before everything that the environment says (RPATH).
    pub rpath: Vec<String>,
    /// Where it has them looked for, after what the environment says (RUNPATH).
    pub runpath: Vec<String>,
    /// The symbols that it needs from others.
    pub wanted: BTreeSet<String>,
    /// The symbols that it offers to others.
    pub offered: BTreeSet<String>,
    /// Those of them that are variables. A program has a copy of its own of a variable of a library.
    pub variables: BTreeSet<String>,
}

impl Kind {
    /// What a file of the kind is.
    pub fn describe(self) -> &'static str {
        match self {
            Kind::Dynamic => "a program",
            Kind::Static => "a statically linked program",
            Kind::Library => "a shared library",
            Kind::Object => "an object",
            Kind::Archive => "a static library",
        }
    }
}

impl Binary {
    /// Reads a file. What is no ELF file, nor an archive of such, is an error.
    pub fn read(path: &Path) -> Result<Binary, Failure> {
        let data = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        if data.starts_with(b"#!") {
            let advice = "look at the program that it runs, or name the GKS that it is for with --dialect";
            return Err(format!("{}: a script; {advice}", path.display()).into());
        }
        Binary::parse(&data).map_err(|error| format!("{}: {error}", path.display()).into())
    }

    /// Reads the contents of a file.
    pub fn parse(data: &[u8]) -> Result<Binary, Failure> {
        match FileKind::parse(data).map_err(|_| "neither a program, a library nor an object")? {
            FileKind::Elf32 => parse::<elf::FileHeader32<Endianness>>(data),
            FileKind::Elf64 => parse::<elf::FileHeader64<Endianness>>(data),
            FileKind::Archive => parse_archive(data),
            other => Err(format!("a file of the kind {other:?}, not of ELF").into()),
        }
    }

    fn new(kind: Kind) -> Binary {
        let (needed, rpath, runpath) = (Vec::new(), Vec::new(), Vec::new());
        let [wanted, offered, variables] = Default::default();
        Binary { kind, needed, rpath, runpath, wanted, offered, variables }
    }
}

fn parse_archive(data: &[u8]) -> Result<Binary, Failure> {
    let mut binary = Binary::new(Kind::Archive);
    for member in ArchiveFile::parse(data)?.members() {
        // Members that are no objects belong to compilers.
        if let Ok(object) = Binary::parse(member?.data(data)?) {
            binary.wanted.extend(object.wanted);
            binary.offered.extend(object.offered);
        }
    }
    binary.wanted.retain(|symbol| !binary.offered.contains(symbol));
    Ok(binary)
}

fn parse<Elf: FileHeader<Endian = Endianness>>(data: &[u8]) -> Result<Binary, Failure> {
    let header = Elf::parse(data)?;
    let endian = header.endian()?;
    let interpreted =
        header.program_headers(endian, data)?.iter().any(|segment| segment.p_type(endian) == elf::PT_INTERP);
    let kind = match header.e_type(endian) {
        elf::ET_REL => Kind::Object,
        _ if interpreted => Kind::Dynamic,
        elf::ET_DYN => Kind::Library,
        _ => Kind::Static,
    };
    let sections = header.sections(endian, data)?;
    let mut binary = Binary::new(kind);
    read_dynamic(&mut binary, endian, data, &sections)?;
    let table = if matches!(kind, Kind::Dynamic | Kind::Library) { elf::SHT_DYNSYM } else { elf::SHT_SYMTAB };
    let symbols = sections.symbols(endian, data, table)?;
    for symbol in symbols.iter() {
        let Ok(name) = symbol.name(endian, symbols.strings()) else { continue };
        let name = String::from_utf8_lossy(name);
        if name.is_empty() || symbol.st_bind() == elf::STB_LOCAL {
            continue;
        }
        if symbol.is_undefined(endian) {
            binary.wanted.insert(name.into_owned());
        } else {
            if symbol.st_type() == elf::STT_OBJECT {
                binary.variables.insert(name.clone().into_owned());
            }
            binary.offered.insert(name.into_owned());
        }
    }
    Ok(binary)
}

fn read_dynamic<Elf: FileHeader<Endian = Endianness>>(
    binary: &mut Binary,
    endian: Endianness,
    data: &[u8],
    sections: &SectionTable<'_, Elf>,
) -> Result<(), Failure> {
    let Some((entries, link)) = sections.dynamic(endian, data)? else { return Ok(()) };
    let strings = sections.strings(endian, data, link)?;
    for entry in entries {
        let Some(tag) = entry.tag32(endian) else { continue };
        let text = || entry.string(endian, strings).map(|text| String::from_utf8_lossy(text).into_owned());
        let folders = |text: String| text.split(':').map(str::to_owned).collect::<Vec<_>>();
        match tag {
            elf::DT_NEEDED => binary.needed.push(text()?),
            elf::DT_RPATH => binary.rpath = folders(text()?),
            elf::DT_RUNPATH => binary.runpath = folders(text()?),
            _ => {}
        }
    }
    // The dynamic linker does not look at RPATH where there is a RUNPATH.
    if !binary.runpath.is_empty() {
        binary.rpath.clear();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn this_test_is_a_program_that_needs_libraries() {
        let this =
            Binary::read(&std::env::current_exe().expect("the test has a file")).expect("it can be read");
        assert_eq!(this.kind, Kind::Dynamic);
        assert!(this.needed.iter().any(|name| name.starts_with("libc.so")), "{:?}", this.needed);
        assert!(this.wanted.iter().any(|name| name == "write"), "{:?}", this.wanted);
    }

    #[test]
    fn what_is_no_program_is_refused() {
        for data in [&b""[..], b"#!/bin/sh\n", b"\x7fELF\x02\x01\x01", b"!<arch>\n garbage"] {
            let said = Binary::parse(data);
            assert!(said.is_err() || said.is_ok_and(|binary| binary.wanted.is_empty()));
        }
    }
}
