//! The terminal graphics protocol of kitty: PNG images in base 64, in pieces of at most 4096 characters.

use data_encoding::BASE64;
use std::io;

/// The most characters of a piece.
const PIECE: usize = 4096;

/// The image of red, green and blue of each pixel. Its number tells the terminal what it replaces.
pub(super) fn encode(rgb: &[u8], width: u32, height: u32, number: u32) -> io::Result<Vec<u8>> {
    let mut image = Vec::new();
    let mut encoder = png::Encoder::new(&mut image, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rgb)?;
    writer.finish()?;
    let text = BASE64.encode(&image);
    let mut out = Vec::with_capacity(text.len() + text.len() / 100 + 64);
    let mut pieces = text.as_bytes().chunks(PIECE).peekable();
    let mut first = true;
    while let Some(piece) = pieces.next() {
        let more = u8::from(pieces.peek().is_some());
        // Shown at once, without an answer.
        let control = if first {
            format!("\x1b_Ga=T,f=100,q=2,i={number},m={more};")
        } else {
            format!("\x1b_Gm={more};")
        };
        first = false;
        out.extend(control.bytes());
        out.extend(piece);
        out.extend(b"\x1b\\");
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_put_together_are_the_image() {
        let mut random = 1u32;
        let rgb: Vec<u8> = std::iter::repeat_with(|| {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 24) as u8
        })
        .take(60 * 50 * 3)
        .collect();
        let text = String::from_utf8(encode(&rgb, 60, 50, 7).unwrap()).unwrap();
        let pieces: Vec<&str> = text.split_terminator("\x1b\\").collect();
        assert!(pieces.len() > 2 && pieces[0].starts_with("\x1b_Ga=T,f=100,q=2,i=7,m=1;"));
        let (last, others) = pieces.split_last().unwrap();
        assert!(last.starts_with("\x1b_Gm=0;") && others[1..].iter().all(|p| p.starts_with("\x1b_Gm=1;")));
        assert!(pieces.iter().all(|piece| piece.split_once(';').unwrap().1.len() <= PIECE));
        let text: String = pieces.iter().map(|piece| piece.split_once(';').unwrap().1).collect();
        let image = BASE64.decode(text.as_bytes()).unwrap();
        let mut reader = png::Decoder::new(io::Cursor::new(image)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, rgb);
    }

    #[test]
    fn a_small_image_is_one_piece() {
        let text = String::from_utf8(encode(&[1, 2, 3], 1, 1, 1).unwrap()).unwrap();
        assert_eq!(text.matches("\x1b_G").count(), 1);
        assert!(text.contains(",m=0;") && text.ends_with("\x1b\\"));
    }
}
