//! Pictures of characters: upper half blocks, whose two colours are two pixels (ISO 8613-6 colours).

use std::io::Write;

/// The picture of red, green and blue of each pixel, `width` pixels a row; each line ends with `end`.
pub(super) fn encode(rgb: &[u8], width: usize, end: &str) -> Vec<u8> {
    let mut out = Vec::with_capacity(rgb.len() * 4);
    let stride = width.max(1) * 3;
    for pair in rgb.chunks(stride * 2) {
        let (upper, lower) = pair.split_at(stride.min(pair.len()));
        let mut colours = (None, None);
        for (column, above) in upper.chunks_exact(3).enumerate() {
            let below = lower.get(column * 3..column * 3 + 3);
            // Writing to memory does not fail.
            if colours.0 != Some(above) {
                let _ = write!(out, "\x1b[38;2;{};{};{}m", above[0], above[1], above[2]);
            }
            if let Some(below) = below
                && colours.1 != Some(below)
            {
                let _ = write!(out, "\x1b[48;2;{};{};{}m", below[0], below[1], below[2]);
            }
            colours = (Some(above), below);
            out.extend("\u{2580}".bytes());
        }
        out.extend(b"\x1b[0m");
        out.extend(end.bytes());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_rows_are_a_line_and_colours_are_said_once() {
        let (red, blue) = ([255, 0, 0], [0, 0, 9]);
        let rgb = [red, red, blue, red, blue, blue].concat();
        let text = String::from_utf8(encode(&rgb, 2, "\n")).unwrap();
        let red = |layer: u8| format!("\x1b[{layer}8;2;255;0;0m");
        let blue = |layer: u8| format!("\x1b[{layer}8;2;0;0;9m");
        let lines = [
            format!("{}{}\u{2580}{}\u{2580}\x1b[0m", red(3), blue(4), red(4)),
            format!("{}\u{2580}\u{2580}\x1b[0m", blue(3)),
        ];
        assert_eq!(text, format!("{}\n{}\n", lines[0], lines[1]));
    }
}
