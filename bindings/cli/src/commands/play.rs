//! `gks play`: a metafile on a device.

use super::Failure;
use gks::Gks;
use gks_metafile::{ReadOptions, open_source};
use gks_pipeline::record::{Record, Skipped, Source, SourceError};
use gks_workstations::catalogue::Drivers;
use std::fs::File;
use std::io::{self, IsTerminal, Read};
use std::ops::RangeInclusive;
use std::path::Path;
use std::process::ExitCode;
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// What is played, and where.
pub struct Play {
    /// The metafile; `-` is the standard input.
    pub file: String,
    /// The name, the number or the extension of the workstation type.
    pub on: Option<String>,
    /// The file to write.
    pub out: Option<String>,
    /// The pages to play.
    pub pages: Pages,
    /// How items are read that authors code differently.
    pub options: ReadOptions,
}

/// A range of pages, counted from 1: `3`, `2-5`, `2-` or `-5`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pages(RangeInclusive<u64>);

impl Default for Pages {
    /// All pages.
    fn default() -> Self {
        Pages(1..=u64::MAX)
    }
}

impl FromStr for Pages {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str, otherwise| match text {
            "" => Some(otherwise),
            _ => text.parse().ok().filter(|&page: &u64| page > 0),
        };
        let (first, last) = text.split_once('-').unwrap_or((text, text));
        match (number(first, 1), number(last, u64::MAX)) {
            (Some(first), Some(last)) if first <= last && !text.is_empty() && text != "-" => {
                Ok(Pages(first..=last))
            }
            _ => Err(format!("\"{text}\" is no range of pages; write 3, 2-5, 2- or -5")),
        }
    }
}

/// Plays a metafile. What can be read is drawn; if not all can, the exit code tells.
pub fn run(play: &Play) -> Result<ExitCode, Failure> {
    let wanted = play.on.as_deref().or(play.out.as_deref()).unwrap_or("png");
    let kind = Drivers::choose(wanted).ok_or_else(|| format!("no workstation type {wanted}"))?;
    let said = |error: &dyn std::fmt::Display| format!("{}: {error}", play.file);
    let (bytes, progress) = open(&play.file)?;
    let mut source = open_source(bytes, &play.options).map_err(|error| said(&error))?.source;
    let mut gks = Gks::open(Box::new(Drivers::from_process()));
    gks.open_workstation(1, &connection(play, kind), kind)?;
    gks.activate_workstation(1)?;
    let mut player =
        Player { gks, pages: &play.pages, page: 1, drawn: false, faults: Faults::default(), progress };
    let ended = player.play(&mut *source);
    let Player { mut gks, page, drawn, faults, .. } = player;
    gks.deactivate_workstation(1)?;
    gks.close_workstation(1)?;
    gks.close_gks()?;
    ended.map_err(|error| said(&error))?;
    warn(&play.file, &source.skipped());
    let pages = if drawn { page } else { page - 1 };
    if pages < *play.pages.0.start() && *play.pages.0.start() > 1 {
        return Err(said(&format!("there are only {pages} pages")).into());
    }
    faults.report(&play.file);
    Ok(if faults.count == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Playing, as far as it has come.
struct Player<'a> {
    gks: Gks,
    pages: &'a Pages,
    /// The page that is played, from 1.
    page: u64,
    /// Whether there is a primitive on it.
    drawn: bool,
    faults: Faults,
    progress: Progress,
}

impl Player<'_> {
    fn play(&mut self, source: &mut dyn Source) -> Result<(), SourceError> {
        while self.page <= *self.pages.0.end() {
            self.progress.show();
            match source.next() {
                Ok(None) => break,
                Ok(Some(record)) => self.record(&record),
                Err(error @ SourceError::Io(_)) => {
                    self.progress.end();
                    return Err(error);
                }
                Err(error) => self.faults.add(error.to_string()),
            }
        }
        self.progress.end();
        Ok(())
    }

    fn record(&mut self, record: &Record<'_>) {
        let wanted = self.pages.0.contains(&self.page);
        let played = match record {
            Record::User(..) => return,
            Record::Clear { .. } => {
                let shown = wanted && self.drawn;
                self.page += u64::from(self.drawn);
                self.drawn = false;
                shown
            }
            Record::Primitive(_) => {
                self.drawn = true;
                wanted
            }
            Record::Message(text) => {
                if wanted {
                    eprintln!("{text}");
                }
                return;
            }
            // Segments end with their page; attributes and tables last.
            Record::RedrawAllSegments
            | Record::Update { .. }
            | Record::CreateSegment(_)
            | Record::CloseSegment
            | Record::RenameSegment(..)
            | Record::DeleteSegment(_)
            | Record::SegmentTransformation(..)
            | Record::Visibility(..)
            | Record::Highlighting(..)
            | Record::SegmentPriority(..)
            | Record::Detectability(..) => wanted,
            _ => true,
        };
        if played && let Err(error) = self.gks.interpret(record) {
            self.faults.add(error.to_string());
        }
    }
}

/// What was wrong with a metafile.
#[derive(Default)]
pub(super) struct Faults {
    first: Vec<String>,
    count: u64,
}

impl Faults {
    /// The most faults that are told one by one.
    const MOST: usize = 5;

    pub(super) fn add(&mut self, fault: String) {
        self.count += 1;
        if self.first.len() < Self::MOST && !self.first.contains(&fault) {
            self.first.push(fault);
        }
    }

    /// Whether nothing was wrong.
    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Tells the user.
    pub(super) fn report(&self, file: &str) {
        for fault in &self.first {
            eprintln!("gks: {file}: {fault}");
        }
        let more = self.count - self.first.len() as u64;
        if more > 0 {
            eprintln!("gks: {file}: {more} more faults");
        }
    }
}

/// Tells what has been skipped; none of it is a fault.
pub(super) fn warn(file: &str, skipped: &Skipped) {
    if skipped.is_empty() {
        return;
    }
    let all: Vec<String> = skipped.iter().map(|(name, count)| format!("{count} x {name}")).collect();
    eprintln!("gks: {file}: skipped: {}", all.join(", "));
}

/// The bytes of a file, or of the standard input for `-`, and how far they have been read.
pub(super) fn open(name: &str) -> Result<(Box<dyn Read + Send>, Progress), Failure> {
    let read = Arc::new(AtomicU64::new(0));
    let (reader, size): (Box<dyn Read + Send>, _) = if name == "-" {
        (Box::new(io::stdin()), 0)
    } else {
        let said = |error: io::Error| format!("{name}: {error}");
        let file = File::open(name).map_err(said)?;
        let size = file.metadata().map_err(said)?.len();
        (Box::new(file), size)
    };
    let counted = Counted { reader, read: Arc::clone(&read) };
    Ok((Box::new(counted), Progress { read, size, next: Instant::now() + Progress::PERIOD, shown: false }))
}

/// A reader whose bytes are counted.
struct Counted {
    reader: Box<dyn Read + Send>,
    read: Arc<AtomicU64>,
}

impl Read for Counted {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.reader.read(buffer)?;
        self.read.fetch_add(count as u64, Ordering::Relaxed);
        Ok(count)
    }
}

/// How far a metafile has been read, shown on a terminal where it takes long.
pub(super) struct Progress {
    read: Arc<AtomicU64>,
    size: u64,
    next: Instant,
    shown: bool,
}

impl Progress {
    const PERIOD: Duration = Duration::from_millis(500);

    /// Shows the progress if it is time to.
    pub(super) fn show(&mut self) {
        if Instant::now() < self.next {
            return;
        }
        self.next = Instant::now() + Self::PERIOD;
        if !io::stderr().is_terminal() {
            return;
        }
        let read = self.read.load(Ordering::Relaxed);
        match (read * 100).checked_div(self.size) {
            Some(percent) => eprint!("\r{percent:3} %"),
            None => eprint!("\r{} MB", read >> 20),
        }
        self.shown = true;
    }

    /// Takes away what is shown.
    pub(super) fn end(&mut self) {
        if std::mem::take(&mut self.shown) {
            eprint!("\r            \r");
        }
    }
}

/// Where the picture goes: to the file asked for, or to one named like the metafile, with the extension of the
/// type.
fn connection(play: &Play, kind: i32) -> String {
    if let Some(out) = &play.out {
        return out.clone();
    }
    let stem = Path::new(&play.file).file_stem().filter(|_| play.file != "-");
    let stem = stem.map_or("gks".into(), |stem| stem.to_string_lossy());
    match super::extension(kind) {
        "" => stem.into_owned(),
        extension => format!("{stem}.{extension}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_are_ranges() {
        let pages = |text: &str| text.parse::<Pages>().map(|pages| pages.0);
        assert_eq!(pages("3"), Ok(3..=3));
        assert_eq!(pages("2-5"), Ok(2..=5));
        assert_eq!(pages("2-"), Ok(2..=u64::MAX));
        assert_eq!(pages("-5"), Ok(1..=5));
        for wrong in ["", "-", "0", "5-2", "a", "1-b", "1-2-3"] {
            assert!(pages(wrong).is_err(), "{wrong}");
        }
    }
}
