//! Portable network graphics: with a palette where the picture has at most 256 colours.

use super::{Layout, Samples, rgb};
use gks_pipeline::device::DeviceError;
use png::{BitDepth, ColorType, DeflateCompression, Encoder, EncodingError, Filter, PixelDimensions, Unit};
use std::borrow::Cow;

/// A picture whose colours are few.
struct Palette<'a> {
    indices: Cow<'a, [u8]>,
    table: Cow<'a, [[u8; 4]]>,
}

/// What a file holds.
enum Data<'a> {
    Indexed(Palette<'a>),
    Rgb(Vec<u8>),
    Rgba(&'a [u8]),
}

/// The picture as a file.
pub(super) fn write(samples: &Samples<'_>, layout: Layout, small: bool) -> Result<Vec<u8>, DeviceError> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, layout.width, layout.height);
    encoder.set_depth(BitDepth::Eight);
    let per_metre = (1.0 / layout.pixel).round() as u32;
    encoder.set_pixel_dims(Some(PixelDimensions { xppu: per_metre, yppu: per_metre, unit: Unit::Meter }));
    let data = match samples {
        Samples::Opaque(pixels) => {
            palette(pixels, 0xff00_0000).map_or_else(|| Data::Rgb(rgb(pixels)), Data::Indexed)
        }
        Samples::Rgba(pixels) => palette(pixels, 0).map_or(Data::Rgba(pixels), Data::Indexed),
        Samples::Palette(indices, table) => {
            Data::Indexed(Palette { indices: Cow::Borrowed(indices), table: Cow::Borrowed(table) })
        }
    };
    let (colour, content) = match &data {
        Data::Indexed(Palette { indices, table }) => {
            encoder.set_palette(table.iter().flat_map(|c| [c[0], c[1], c[2]]).collect::<Vec<u8>>());
            let opaque = table.iter().rposition(|c| c[3] < 255).map_or(0, |last| last + 1);
            if opaque > 0 {
                encoder.set_trns(table[..opaque].iter().map(|c| c[3]).collect::<Vec<u8>>());
            }
            (ColorType::Indexed, &indices[..])
        }
        Data::Rgb(samples) => (ColorType::Rgb, &samples[..]),
        Data::Rgba(samples) => (ColorType::Rgba, *samples),
    };
    encoder.set_color(colour);
    let (filter, level) = match (colour, small) {
        // Neighbouring indices have nothing to do with one another.
        (ColorType::Indexed, true) => (Filter::NoFilter, DeflateCompression::Level(9)),
        (ColorType::Indexed, false) => (Filter::NoFilter, DeflateCompression::Level(1)),
        (_, true) => (Filter::Adaptive, DeflateCompression::Level(6)),
        // Trying all filters on every row takes four times as long and saves a tenth.
        (_, false) => (Filter::Paeth, DeflateCompression::FdeflateUltraFast),
    };
    encoder.set_filter(filter);
    encoder.set_deflate_compression(level);
    let failed = |error: EncodingError| match error {
        EncodingError::IoError(error) => DeviceError::Io(error),
        other => DeviceError::Encode(other.to_string()),
    };
    let mut writer = encoder.write_header().map_err(failed)?;
    writer.write_image_data(content).map_err(failed)?;
    writer.finish().map_err(failed)?;
    Ok(bytes)
}

/// The picture with a palette, in order of appearance, or none where it has more than 256 colours. The bits of
/// `set` count as set in every pixel.
fn palette(pixels: &[u8], set: u32) -> Option<Palette<'static>> {
    let pixels = pixels.as_chunks::<4>().0;
    let colour = |pixel: &[u8; 4]| u32::from_le_bytes(*pixel) | set;
    let mut known = Colours::new();
    let mut indices = vec![0; pixels.len()];
    let mut last = (0, 0);
    if let Some(first) = pixels.first() {
        last = (colour(first), known.index(colour(first))?);
    }
    let mut next = |pixel: &[u8; 4], last: &mut (u32, u8)| {
        if colour(pixel) != last.0 {
            *last = (colour(pixel), known.index(colour(pixel))?);
        }
        Some(last.1)
    };
    // Most pixels are like the one before, eight of them at once.
    let (groups, rest) = pixels.as_chunks::<8>();
    let (group_indices, rest_indices) = indices.as_chunks_mut::<8>();
    for (group, indices) in groups.iter().zip(group_indices) {
        if group.iter().fold(0, |all, pixel| all | (colour(pixel) ^ last.0)) == 0 {
            *indices = [last.1; 8];
            continue;
        }
        for (pixel, index) in group.iter().zip(indices) {
            *index = next(pixel, &mut last)?;
        }
    }
    for (pixel, index) in rest.iter().zip(rest_indices) {
        *index = next(pixel, &mut last)?;
    }
    Some(Palette { indices: indices.into(), table: known.table.into() })
}

/// The slots of the hash table of colours, by linear probing.
const SLOTS: usize = 1024;

/// Colours in the order of their first appearance.
struct Colours {
    table: Vec<[u8; 4]>,
    /// A colour and its index plus 1; 0 where the slot is empty.
    slots: [(u32, u16); SLOTS],
}

impl Colours {
    fn new() -> Colours {
        Colours { table: Vec::new(), slots: [(0, 0); SLOTS] }
    }

    /// The index of a colour, which is a new one unless it is known; none where 256 are known.
    fn index(&mut self, colour: u32) -> Option<u8> {
        let mut slot = colour.wrapping_mul(0x9e37_79b1) as usize >> 22;
        while self.slots[slot].1 != 0 && self.slots[slot].0 != colour {
            slot = (slot + 1) % SLOTS;
        }
        if self.slots[slot].1 == 0 {
            if self.table.len() == 256 {
                return None;
            }
            self.table.push(colour.to_le_bytes());
            self.slots[slot] = (colour, self.table.len() as u16);
        }
        Some((self.slots[slot].1 - 1) as u8)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYOUT: Layout = Layout { width: 64, height: 16, pixel: 0.0002 };

    /// The colour type of a file and its pixels, expanded.
    fn read(bytes: &[u8]) -> (ColorType, Vec<u8>) {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::ALPHA);
        let mut reader = decoder.read_info().unwrap();
        let colour = reader.info().color_type;
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        (colour, pixels)
    }

    /// A picture of as many colours, with an opacity that counts for nothing or not.
    fn picture(colours: usize) -> Vec<u8> {
        (0..64 * 16).flat_map(|i| ((i % colours) as u32 * 0x0001_8103 + 0x1000).to_le_bytes()).collect()
    }

    #[test]
    fn pictures_of_few_colours_have_a_palette_and_are_the_same() {
        for small in [false, true] {
            for (colours, expected) in
                [(1, true), (2, true), (255, true), (256, true), (257, false), (1024, false)]
            {
                let pixels = picture(colours);
                let (colour, back) = read(&write(&Samples::Rgba(pixels.clone()), LAYOUT, small).unwrap());
                assert_eq!((colour == ColorType::Indexed, &back), (expected, &pixels), "{colours} colours");
                let (colour, back) = read(&write(&Samples::Opaque(&pixels), LAYOUT, small).unwrap());
                let opaque = pixels.chunks(4).flat_map(|p| [p[0], p[1], p[2], 255]);
                assert_eq!(
                    (colour == ColorType::Indexed, back),
                    (expected, opaque.collect()),
                    "{colours} colours"
                );
            }
        }
    }

    #[test]
    fn small_files_are_smaller() {
        let waves = |i: u32| [(i % 64 * 4) as u8, (i / 64 * 16) as u8, ((i % 64) * (i / 64) / 4) as u8, 255];
        let pixels: Vec<u8> = (0..64 * 16).flat_map(waves).collect();
        let size = |small| write(&Samples::Opaque(&pixels), LAYOUT, small).unwrap().len();
        assert!(size(true) < size(false), "{} {}", size(true), size(false));
    }
}
