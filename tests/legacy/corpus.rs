//! Reports on the corpus: how each program ends on the original GKS of NCAR Graphics and on ours, and how alike
//! the frames are.
//!
//! Arguments: the folder of the runs (`PROGRAM/original` and `PROGRAM/ours`, each with the file `status` and
//! frames `page.*.png`), the file with the differences that are explained, the names of the programs.

use gks_tests::likeness::{Likeness, is_blank, likeness, open};
use image::RgbImage;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread;

/// What frames of ours and of the original must keep to: other outlines of characters, other linewidths.
const STRAY: f64 = 0.03;
const TONE: f64 = 15.0;

/// How a program ended.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum End {
    /// It was not run.
    Missing,
    /// It ran out of time.
    Timeout,
    /// A signal ended it.
    Signal(i32),
    /// By itself, with a status.
    Status(i32),
}

impl End {
    fn read(folder: &Path) -> End {
        let text = std::fs::read_to_string(folder.join("status")).unwrap_or_default();
        match text.trim().parse() {
            // `timeout` gave up, or the processor time ran out.
            Ok(124 | 152) => End::Timeout,
            // Those that end no program are statuses: SIGCHLD, SIGCONT, SIGSTOP to SIGTTOU, SIGURG and SIGWINCH.
            Ok(status @ (145..=151 | 156)) => End::Status(status),
            Ok(status @ 129..=159) => End::Signal(status - 128),
            Ok(status) => End::Status(status),
            Err(_) => End::Missing,
        }
    }

    /// Whether two ends are the same. The status of most programs in C is what happens to be in a register.
    fn is_like(self, other: End, in_c: bool) -> bool {
        match (self, other) {
            (End::Status(_), End::Status(_)) if in_c => true,
            _ => self == other && self != End::Missing,
        }
    }
}

/// What was found out about a program.
struct Row {
    name: String,
    ends: [End; 2],
    frames: [usize; 2],
    alike: usize,
    worst: Likeness,
    /// The numbers of the frames that differ.
    different: Vec<usize>,
}

/// The number of a workstation and of a page in `page.1.png`, `page.2-2.png` or `page.2.1.png`.
fn order(path: &Path, ours: bool) -> (u32, u32) {
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let mut numbers = stem.split(['.', '-']).filter_map(|n| n.parse().ok());
    let (first, second) = (numbers.next().unwrap_or(0), numbers.next());
    match (ours, second) {
        // Ours have the page before the workstation, and the first workstation has no number.
        (true, workstation) => (workstation.unwrap_or(1), first),
        (false, page) => (first, page.unwrap_or(0)),
    }
}

/// The frames of a run on which something is drawn.
fn frames(folder: &Path, ours: bool) -> Vec<RgbImage> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut files: Vec<PathBuf> = entries.filter(|p| p.extension().is_some_and(|e| e == "png")).collect();
    files.sort_by_key(|path| order(path, ours));
    files.iter().filter_map(|path| open(path)).filter(|picture| !is_blank(picture)).collect()
}

fn judge(runs: &Path, name: &str) -> Row {
    let folders = ["original", "ours"].map(|which| runs.join(name).join(which));
    let ends = [End::read(&folders[0]), End::read(&folders[1])];
    let (original, ours) = (frames(&folders[0], false), frames(&folders[1], true));
    let mut row = Row {
        name: name.to_owned(),
        ends,
        frames: [original.len(), ours.len()],
        alike: 0,
        worst: Likeness { stray: 0.0, tone: 0.0 },
        different: Vec::new(),
    };
    for (i, (a, b)) in original.iter().zip(&ours).enumerate() {
        let found = likeness(a, b);
        if found.stray <= STRAY && found.tone <= TONE {
            row.alike += 1;
        } else {
            row.different.push(i + 1);
        }
        row.worst.stray = row.worst.stray.max(found.stray);
        row.worst.tone = row.worst.tone.max(found.tone);
    }
    row
}

/// The explanations of a file: each line has the name of a program, then the reason.
fn explanations(path: &str) -> BTreeMap<String, String> {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let pairs = lines.filter_map(|line| line.split_once(' '));
    pairs.map(|(name, why)| (name.to_owned(), why.trim().to_owned())).collect()
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let (Some(runs), Some(explained)) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: corpus RUNS EXPLANATIONS PROGRAM...");
        return ExitCode::FAILURE;
    };
    let (runs, explained) = (PathBuf::from(runs), explanations(&explained));
    let names: Vec<String> = arguments.collect();
    let workers = thread::available_parallelism().map_or(1, |n| n.get().min(2));
    let share = names.len().div_ceil(workers).max(1);
    let judged = &|names: &[String]| names.iter().map(|name| judge(&runs, name)).collect::<Vec<_>>();
    let rows: Vec<Row> = thread::scope(|scope| {
        let parts: Vec<_> = names.chunks(share).map(|part| scope.spawn(move || judged(part))).collect();
        parts.into_iter().flat_map(|part| part.join().unwrap_or_default()).collect()
    });
    let (mut ended, mut all, mut both, mut alike, mut excused) = (0, 0, 0, 0, 0);
    println!("{:<12} {:<24} {:>9}  {:>8} {:>6}  verdict", "program", "ends", "frames", "stray", "tone");
    for row in &rows {
        let same_end = row.ends[0].is_like(row.ends[1], row.name.starts_with("c_"));
        let count = row.frames[0].max(row.frames[1]);
        let why = explained.get(&row.name);
        ended += usize::from(same_end);
        all += count;
        both += row.frames[0].min(row.frames[1]);
        alike += row.alike;
        excused += if why.is_some() { count - row.alike } else { 0 };
        let verdict = match why {
            _ if same_end && row.alike == count => "ok".to_owned(),
            Some(why) => format!("explained: {why}"),
            None if !same_end => "ENDS OTHERWISE".to_owned(),
            None if row.frames[0] != row.frames[1] => "OTHER NUMBER OF FRAMES".to_owned(),
            None => format!("DIFFERS in {:?}", row.different),
        };
        let ends = format!("{:?} {:?}", row.ends[0], row.ends[1]);
        let frames = format!("{}/{}", row.frames[0], row.frames[1]);
        let Likeness { stray, tone } = row.worst;
        println!("{:<12} {ends:<24} {frames:>9}  {:>6.2} % {tone:>6.1}  {verdict}", row.name, stray * 100.0);
    }
    println!("\n{ended} of {} programs end as on the original", rows.len());
    let share = 100.0 * alike as f64 / both.max(1) as f64;
    println!("{alike} of {both} frames that both have drawn agree: {share:.1} %");
    println!("{excused} of {} others are explained, frames that only one has drawn among them", all - alike);
    let good = ended * 478 >= rows.len() * 470 && alike * 100 >= both * 95 && alike + excused == all;
    if good { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
