use super::*;
use std::sync::atomic::{AtomicU32, Ordering};

/// A directory that is removed at the end of the test.
pub(crate) struct Directory(PathBuf);

impl Directory {
    pub(crate) fn new() -> Directory {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let name = format!("gks-sink-{}-{}", process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let path = std::env::temp_dir().join(name);
        fs::create_dir_all(&path).unwrap();
        Directory(path)
    }

    pub(crate) fn name(&self, file: &str) -> String {
        self.0.join(file).to_str().unwrap().to_owned()
    }

    pub(crate) fn files(&self) -> Vec<String> {
        let names = fs::read_dir(&self.0).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn write_document(sink: &mut dyn Sink, text: &str) {
    sink.open().unwrap();
    sink.write(text.as_bytes()).unwrap();
    sink.finish().unwrap();
}

#[test]
fn documents_are_numbered_before_the_extension_or_where_the_name_says() {
    let names = |name: &str| [1, 2, 13].map(|n| document_name(name, n));
    assert_eq!(names("a/out.png"), ["a/out.png", "a/out.2.png", "a/out.13.png"]);
    assert_eq!(names("a.b/out"), ["a.b/out", "a.b/out.2", "a.b/out.13"]);
    assert_eq!(names("a/.out"), ["a/.out", "a/.out.2", "a/.out.13"]);
    assert_eq!(names("p%d.svg"), ["p1.svg", "p2.svg", "p13.svg"]);
    assert_eq!(names("100%/p%03d"), ["100%/p001", "100%/p002", "100%/p013"]);
    assert_eq!(names("50%.png"), ["50%.png", "50%.2.png", "50%.13.png"]);
}

#[test]
fn a_file_appears_when_it_is_finished_and_not_before() {
    let directory = Directory::new();
    let mut sink = FileSink::create(&directory.name("out.txt")).unwrap();
    sink.open().unwrap();
    sink.write(b"one").unwrap();
    assert!(!directory.files().contains(&"out.txt".to_owned()));
    sink.finish().unwrap();
    assert_eq!(directory.files(), ["out.txt"]);
    write_document(&mut sink, "two");
    write_document(&mut sink, "three");
    assert_eq!(directory.files(), ["out.2.txt", "out.3.txt", "out.txt"]);
    assert_eq!(fs::read_to_string(directory.name("out.txt")).unwrap(), "one");
    assert_eq!(fs::read_to_string(directory.name("out.3.txt")).unwrap(), "three");
}

#[test]
fn nothing_is_left_of_an_unfinished_document() {
    let directory = Directory::new();
    fs::write(directory.name("old"), "old").unwrap();
    drop(FileSink::create(&directory.name("never-opened")).unwrap());
    let mut sink = FileSink::create(&directory.name("old")).unwrap();
    sink.open().unwrap();
    sink.write(b"half").unwrap();
    drop(sink);
    assert_eq!(directory.files(), ["old"]);
    assert_eq!(fs::read_to_string(directory.name("old")).unwrap(), "old");
}

#[test]
fn opening_again_abandons_an_unfinished_document() {
    let directory = Directory::new();
    let mut sink = FileSink::create(&directory.name("p")).unwrap();
    sink.open().unwrap();
    sink.write(b"half").unwrap();
    write_document(&mut sink, "two");
    drop(sink);
    assert_eq!(directory.files(), ["p.2"]);
}

#[test]
fn unwritable_names_fail_at_once_and_are_named() {
    let directory = Directory::new();
    let error = |name: &str| FileSink::create(name).unwrap_err();
    let missing = error(&directory.name("no/such/out.png"));
    assert_eq!(missing.kind(), io::ErrorKind::NotFound);
    assert!(missing.to_string().contains("no/such/out.png"), "{missing}");
    assert_eq!(error(directory.0.to_str().unwrap()).kind(), io::ErrorKind::IsADirectory);
    assert_eq!(error(&directory.name("new/")).kind(), io::ErrorKind::IsADirectory);
    assert_eq!(error("").kind(), io::ErrorKind::InvalidInput);
    assert_eq!(error(&directory.name("..")).kind(), io::ErrorKind::IsADirectory);
    error(&directory.name(&"x".repeat(300)));
    error(&directory.name("a\0b"));
    assert!(directory.files().is_empty());
}

#[test]
fn writing_without_a_document_is_an_error() {
    let directory = Directory::new();
    let (memory, _) = MemorySink::new();
    let file = FileSink::create(&directory.name("x")).unwrap();
    let sinks: [Box<dyn Sink>; 2] = [Box::new(memory), Box::new(file)];
    for mut sink in sinks {
        assert!(sink.write(b"x").is_err());
        assert!(sink.finish().is_err());
        write_document(&mut *sink, "x");
        assert!(sink.write(b"x").is_err());
    }
}

#[cfg(unix)]
#[test]
fn links_and_permissions_survive() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let directory = Directory::new();
    let (target, link) = (directory.name("target"), directory.name("link"));
    fs::write(&target, "old").unwrap();
    fs::set_permissions(&target, fs::Permissions::from_mode(0o600)).unwrap();
    symlink(&target, &link).unwrap();
    write_document(&mut FileSink::create(&link).unwrap(), "new");
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::read_to_string(&target).unwrap(), "new");
    assert_eq!(fs::metadata(&target).unwrap().permissions().mode() & 0o777, 0o600);
}

#[test]
fn a_full_disk_is_reported() {
    if !Path::new("/dev/full").exists() {
        return;
    }
    let mut sink = FileSink::create("/dev/full").unwrap();
    sink.open().unwrap();
    let written = sink.write(&vec![0; 3 * BUFFER]).and_then(|()| sink.finish());
    let error = written.unwrap_err();
    assert_eq!(error.kind(), io::ErrorKind::StorageFull);
    assert!(error.to_string().starts_with("/dev/full: "), "{error}");
}

#[test]
fn devices_are_written_directly() {
    if !Path::new("/dev/null").exists() {
        return;
    }
    let mut sink = FileSink::create("/dev/null").unwrap();
    write_document(&mut sink, "one");
    write_document(&mut sink, "two");
    drop(sink);
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn memory_holds_completed_documents_only() {
    let (mut sink, documents) = MemorySink::new();
    write_document(&mut sink, "one");
    sink.open().unwrap();
    sink.write(b"half").unwrap();
    assert_eq!((documents.len(), documents.text(0).as_deref()), (1, Some("one")));
    assert_eq!(documents.take(), [b"one"]);
    assert!(documents.is_empty() && documents.get(0).is_none());
}

#[test]
fn a_document_is_taken_back_before_it_is_complete() {
    let directory = Directory::new();
    let name = directory.name("out.txt");
    let mut file = FileSink::create(&name).unwrap();
    assert!(!file.restart().unwrap(), "there is no document");
    let (mut memory, documents) = MemorySink::new();
    for sink in [&mut file as &mut dyn Sink, &mut memory] {
        sink.open().unwrap();
        sink.write(&[b'x'; 100_000]).unwrap();
        assert!(sink.restart().unwrap());
        sink.write(b"short").unwrap();
        sink.finish().unwrap();
    }
    assert_eq!(fs::read(&name).unwrap(), b"short");
    assert_eq!(documents.take(), [b"short"]);
    assert_eq!(directory.files(), ["out.txt"]);
    assert!(!StdoutSink::new().restart().unwrap());
}
