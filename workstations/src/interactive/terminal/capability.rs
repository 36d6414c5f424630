//! What graphics a terminal shows: told by the environment, or else by the terminal itself.

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::termios::{LocalModes, OptionalActions, SpecialCodeIndex, tcgetattr, tcsetattr};
use std::fs::File;
use std::io::{Read, Write};
use std::time::{Duration, Instant};

/// How a terminal shows pictures.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Graphics {
    /// The protocol of kitty.
    Kitty,
    /// Sixels.
    Sixel,
    /// Half blocks in 24-bit colour.
    Blocks,
}

/// How long a terminal may take to answer.
const PATIENCE: Duration = Duration::from_millis(400);

/// What the environment says, if it says anything.
pub(super) fn from_environment(variable: impl Fn(&str) -> Option<String>) -> Option<Graphics> {
    let term = variable("TERM").unwrap_or_default();
    let program = variable("TERM_PROGRAM").unwrap_or_default().to_ascii_lowercase();
    if variable("KITTY_WINDOW_ID").is_some()
        || term.contains("kitty")
        || term.contains("ghostty")
        || matches!(program.as_str(), "ghostty" | "wezterm")
    {
        return Some(Graphics::Kitty);
    }
    if matches!(term.as_str(), "mlterm" | "yaft-256color" | "foot" | "foot-extra") || term.contains("sixel") {
        return Some(Graphics::Sixel);
    }
    matches!(term.as_str(), "" | "dumb" | "linux").then_some(Graphics::Blocks)
}

/// What the terminal itself says.
pub(super) fn ask(terminal: &mut File) -> Graphics {
    let Ok(saved) = tcgetattr(&*terminal) else { return Graphics::Blocks };
    let mut silent = saved.clone();
    silent.local_modes.remove(LocalModes::ICANON | LocalModes::ECHO);
    silent.special_codes[SpecialCodeIndex::VMIN] = 0;
    silent.special_codes[SpecialCodeIndex::VTIME] = 0;
    if tcsetattr(&*terminal, OptionalActions::Now, &silent).is_err() {
        return Graphics::Blocks;
    }
    let said = converse(terminal);
    // What was changed is put back whatever was answered.
    let _ = tcsetattr(&*terminal, OptionalActions::Now, &saved);
    understand(&said)
}

/// Asks whether an image of one pixel would be shown, and for the attributes, which every terminal answers.
fn converse(terminal: &mut File) -> Vec<u8> {
    let mut said = Vec::new();
    if terminal.write_all(b"\x1b_Gi=31,s=1,v=1,a=q,t=d,f=24;AAAA\x1b\\\x1b[c").is_err() {
        return said;
    }
    let end = Instant::now() + PATIENCE;
    let mut buffer = [0; 256];
    while !is_complete(&said) && said.len() < 4096 {
        let rest = end.saturating_duration_since(Instant::now());
        let Ok(rest) = Timespec::try_from(rest) else { break };
        match poll(&mut [PollFd::new(&*terminal, PollFlags::IN)], Some(&rest)) {
            Ok(ready) if ready > 0 => {}
            _ => break,
        }
        match terminal.read(&mut buffer) {
            Ok(count) if count > 0 => said.extend(&buffer[..count]),
            _ => break,
        }
    }
    said
}

/// The attributes of the terminal in what it said: `ESC [ ? numbers c`.
fn attributes(said: &[u8]) -> Option<&str> {
    let start = said.windows(3).position(|part| part == b"\x1b[?")? + 3;
    let length = said[start..].iter().position(|&byte| byte == b'c')?;
    std::str::from_utf8(&said[start..start + length]).ok()
}

fn is_complete(said: &[u8]) -> bool {
    attributes(said).is_some()
}

fn understand(said: &[u8]) -> Graphics {
    if said.windows(8).any(|part| part == b"_Gi=31;O") {
        Graphics::Kitty
    } else if attributes(said).is_some_and(|numbers| numbers.split(';').any(|number| number == "4")) {
        Graphics::Sixel
    } else {
        Graphics::Blocks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn environment(pairs: &[(&str, &str)]) -> Option<Graphics> {
        from_environment(|name| pairs.iter().find(|(n, _)| *n == name).map(|(_, v)| (*v).to_owned()))
    }

    #[test]
    fn the_environment_tells_known_terminals() {
        assert_eq!(environment(&[("TERM", "xterm-kitty")]), Some(Graphics::Kitty));
        assert_eq!(environment(&[("TERM", "xterm"), ("KITTY_WINDOW_ID", "1")]), Some(Graphics::Kitty));
        assert_eq!(environment(&[("TERM", "xterm"), ("TERM_PROGRAM", "WezTerm")]), Some(Graphics::Kitty));
        assert_eq!(environment(&[("TERM", "foot")]), Some(Graphics::Sixel));
        assert_eq!(environment(&[("TERM", "linux")]), Some(Graphics::Blocks));
        assert_eq!(environment(&[]), Some(Graphics::Blocks));
        assert_eq!(environment(&[("TERM", "xterm-256color")]), None);
    }

    #[test]
    fn terminals_tell_themselves() {
        assert_eq!(understand(b"\x1b_Gi=31;OK\x1b\\\x1b[?62;c"), Graphics::Kitty);
        assert_eq!(understand(b"\x1b[?62;4;22c"), Graphics::Sixel);
        assert_eq!(understand(b"\x1b_Gi=31;EINVAL:no\x1b\\\x1b[?64;1;4c"), Graphics::Sixel);
        assert_eq!(understand(b"\x1b[?1;2c"), Graphics::Blocks);
        assert_eq!(understand(b"\x1b[?64;14;40c"), Graphics::Blocks);
        assert_eq!(understand(b"\x1b[?64;1;4"), Graphics::Blocks);
        assert_eq!(understand(b"garbage"), Graphics::Blocks);
    }
}
