//! Looks for sequences of calls in which every subroutine succeeds, and writes them into the corpus: what a fuzzer
//! starts from.
//!
//! A sequence is found call by call. The arguments of a call are drawn until it succeeds; when that takes too long, the
//! sequence begins anew, since a call before may have done something else than what is needed. Sequences that are there
//! already and still succeed are kept.

use gks_fuzz::calls::{run_and_tell, subroutines};
use std::ops::ControlFlow;
use std::path::Path;

/// How often the arguments of a call are drawn.
const TRIES: usize = 300;

/// How often a sequence is begun.
const BEGINNINGS: usize = 60;

/// What makes a segment that can be stored and shown.
const SEGMENT: [&str; 3] = ["GCRSG", "GPL", "GCLSG"];

/// Calls that have to come before a subroutine can succeed, and what the operator does, as a script is drawn: how many
/// steps, and the steps.
fn conditions(name: &str) -> (Vec<&'static str>, Vec<u8>) {
    let event = |mode, step: u8| (vec![mode, "GWAIT"], vec![2, step, step]);
    match name {
        "GRENSG" | "GDSG" | "GDSGWK" | "GASGWK" | "GCSGWK" | "GINSG" | "GSSGT" | "GSVIS" | "GSHLIT"
        | "GSSGP" | "GSDTEC" | "GQSGA" | "GQASWK" | "GQSGUS" | "GQSGWK" => (SEGMENT.to_vec(), Vec::new()),
        "GCLSG" | "GQOPSG" => (vec!["GCRSG"], Vec::new()),
        "GCLKS" => (vec!["GECLKS", "GOPKS"], Vec::new()),
        "GOPKS" => (vec!["GECLKS"], Vec::new()),
        "GUREC" | "GESC" => (vec!["GPREC"], Vec::new()),
        "GIITM" => (vec!["GGTITM", "GRDITM"], Vec::new()),
        "GSMLC" => (vec!["GSLCM"], Vec::new()),
        "GSMSK" => (vec!["GSSKM"], Vec::new()),
        "GSMVL" => (vec!["GSVLM"], Vec::new()),
        "GSMCH" => (vec!["GSCHM"], Vec::new()),
        "GSMPK" => (vec!["GSPKM"], Vec::new()),
        "GSMST" | "GSMSTS" => (vec!["GSSTM"], Vec::new()),
        "GGTLC" => event("GSLCM", 0),
        "GGTSK" => event("GSSKM", 2),
        "GGTVL" => event("GSVLM", 3),
        "GGTCH" => event("GSCHM", 5),
        "GGTPK" => event("GSPKM", 8),
        "GGTST" | "GGTSTS" => event("GSSTM", 11),
        // More events of the valuator than the queue holds, while the locator is waited for.
        "GQIQOV" => {
            let mut script = vec![255];
            script.resize(1 + usize::from(255 % 32_u8), 3);
            (vec!["GSVLM", "GRQLC"], script)
        }
        _ => (Vec::new(), Vec::new()),
    }
}

/// Bytes that look random, and are 0 often.
struct Bytes(u64);

impl Bytes {
    fn draw(&mut self) -> u8 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let bits = (self.0 >> 32) as u32;
        if bits & 0x300 == 0 { 0 } else { bits as u8 }
    }
}

/// The bytes that some calls take, if the last of them succeeds.
fn taken(input: &[u8], calls: usize) -> Option<usize> {
    let (mut made, mut taken) = (0, None);
    run_and_tell(input, |call| {
        made += 1;
        if made < calls {
            return ControlFlow::Continue(());
        }
        taken = call.good.then(|| input.len() - call.left);
        ControlFlow::Break(())
    });
    taken
}

/// Whether a subroutine succeeds in a sequence.
fn succeeds(input: &[u8], name: &str) -> bool {
    let mut found = false;
    run_and_tell(input, |call| {
        found |= call.good && call.name == name;
        ControlFlow::Continue(())
    });
    found
}

/// A sequence at the end of which a subroutine succeeds.
fn sequence(name: &str, bytes: &mut Bytes) -> Option<Vec<u8>> {
    let names: Vec<&str> = subroutines().collect();
    let (mut calls, script) = conditions(name);
    calls.push(names.iter().find(|known| **known == name)?);
    for beginning in 0..BEGINNINGS {
        // All workstations are open; those that can be are active, or some.
        let mut input = vec![0, if beginning % 2 == 0 { 0 } else { bytes.draw() % 64 }];
        input.extend(if script.is_empty() { &[0][..] } else { &script });
        let found = calls.iter().enumerate().all(|(i, call)| {
            let start = input.len();
            let number = names.iter().position(|known| known == call).unwrap_or(0);
            (0..TRIES).any(|_| {
                input.truncate(start);
                input.push(number as u8);
                input.extend((0..60).map(|_| bytes.draw()));
                let length = taken(&input, i + 1);
                length.inspect(|&length| input.truncate(length)).is_some()
            })
        });
        if found {
            return Some(input);
        }
    }
    None
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/calls");
    std::fs::create_dir_all(&folder)?;
    let mut bytes = Bytes(1);
    for name in subroutines() {
        let path = folder.join(name.to_lowercase());
        if std::fs::read(&path).is_ok_and(|input| succeeds(&input, name)) {
            continue;
        }
        match sequence(name, &mut bytes) {
            Some(input) => std::fs::write(path, input)?,
            None => eprintln!("{name}: no sequence found"),
        }
    }
    Ok(())
}
