//! Sixel graphics as terminals of Digital show them: DEC STD 070, "Video Systems Reference Manual", 1991,
//! chapter 9: bands of six rows, in each of them one line for each colour, six pixels a character.

use super::median_cut::Palette;
use std::io::Write;

/// The most colours, which every terminal with sixels has.
const COLOURS: usize = 256;

/// The image of red, green and blue of each pixel, `width` pixels a row.
pub(super) fn encode(rgb: &[u8], width: usize) -> Vec<u8> {
    let pixels = rgb.chunks_exact(3).map(|pixel| [pixel[0], pixel[1], pixel[2]]);
    let palette = Palette::new(pixels.clone(), COLOURS);
    let indices: Vec<u8> = pixels.map(|pixel| palette.index(pixel)).collect();
    let height = indices.len() / width.max(1);
    let mut out = Vec::with_capacity(indices.len() / 2);
    // Pixels without colour keep what is there; square pixels; the size.
    out.extend(format!("\x1bP0;1;0q\"1;1;{width};{height}").bytes());
    for (number, colour) in palette.colours.iter().enumerate() {
        let [red, green, blue] = colour.map(|channel| (u32::from(channel) * 100 + 127) / 255);
        out.extend(format!("#{number};2;{red};{green};{blue}").bytes());
    }
    let mut lines = vec![Vec::new(); palette.colours.len()];
    for band in indices.chunks(width.max(1) * 6) {
        self::band(band, width.max(1), &mut lines, &mut out);
    }
    out.extend(b"\x1b\\");
    out
}

/// Writes a band; `lines` is room for the sixels of each colour, and empty.
fn band(band: &[u8], width: usize, lines: &mut [Vec<u8>], out: &mut Vec<u8>) {
    let mut used = Vec::new();
    for (row, indices) in band.chunks_exact(width).enumerate() {
        for (column, &index) in indices.iter().enumerate() {
            let line = &mut lines[usize::from(index)];
            if line.is_empty() {
                line.resize(width, 0);
                used.push(index);
            }
            line[column] |= 1 << row;
        }
    }
    for (at, &index) in used.iter().enumerate() {
        if at > 0 {
            out.push(b'$');
        }
        out.extend(format!("#{index}").bytes());
        runs(&lines[usize::from(index)], out);
        lines[usize::from(index)].clear();
    }
    out.push(b'-');
}

/// Writes sixels, those that repeat more than three times as a count; what is empty at the end is left out.
fn runs(line: &[u8], out: &mut Vec<u8>) {
    let end = line.iter().rposition(|&sixel| sixel != 0).map_or(0, |last| last + 1);
    for run in line[..end].chunk_by(|a, b| a == b) {
        let character = run[0] + b'?';
        if run.len() > 3 {
            // Writing to memory does not fail.
            let _ = write!(out, "!{}", run.len());
            out.push(character);
        } else {
            out.extend(std::iter::repeat_n(character, run.len()));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_colours_and_runs() {
        let (red, white) = ([255, 0, 0], [255; 3]);
        // Seven rows: one band of six and one of a single row; the left pixel of the first row is red.
        let mut rgb = [white; 5 * 7].concat();
        rgb[..3].copy_from_slice(&red);
        let text = String::from_utf8(encode(&rgb, 5)).unwrap();
        assert_eq!(text, "\x1bP0;1;0q\"1;1;5;7#0;2;100;0;0#1;2;100;100;100#0@$#1}!4~-#1!5@-\x1b\\");
    }

    #[test]
    fn an_image_without_pixels_is_one() {
        assert_eq!(encode(&[], 0), b"\x1bP0;1;0q\"1;1;0;0\x1b\\");
    }
}
