//! Cell arrays as images: their samples, and how PDF holds them.

use super::content::Content;
use super::document::Document;
use gks_geometry::Du;
use gks_pipeline::colour::Colour;
use gks_pipeline::device::{DeviceError, Grid};
use gks_pipeline::item::Parallelogram;
use pdf_writer::Ref;
use std::fmt::Write as _;

/// Images of at most as many samples stand in the page description itself.
const MOST_INLINE: usize = 1024;

/// Slots of a palette's hash table: four times as many as there can be colours.
const SLOTS: usize = 1024;

/// How opaque the cells of an image are, in 255ths.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(crate) enum Opacity {
    /// All alike.
    Even(u8),
    /// Not all alike; whether some cells are fully transparent.
    Varied(bool),
}

/// The cells of an array as samples: bytes of red, green and blue, or indices of at most 256 colours.
pub(crate) struct Samples<'a> {
    grid: Grid<'a>,
    palette: Option<Palette>,
    opacity: Opacity,
}

/// Colours, found by a hash table with linear probing.
struct Palette {
    colours: Vec<[u8; 3]>,
    slots: Vec<u16>,
}

impl Palette {
    fn new() -> Self {
        Palette { colours: Vec::new(), slots: vec![u16::MAX; SLOTS] }
    }

    /// The index of a colour, which is added if it is new; none if there are 256 other ones.
    fn index(&mut self, colour: [u8; 3]) -> Option<u8> {
        let [r, g, b] = colour;
        let hash = u32::from_be_bytes([0, r, g, b]).wrapping_mul(0x9e37_79b1) >> 22;
        let mut slot = hash as usize;
        loop {
            match self.slots[slot] {
                u16::MAX if self.colours.len() == 256 => return None,
                u16::MAX => {
                    let index = self.colours.len();
                    self.slots[slot] = index as u16;
                    self.colours.push(colour);
                    return Some(index as u8);
                }
                index if self.colours[usize::from(index)] == colour => return Some(index as u8),
                _ => slot = (slot + 1) % SLOTS,
            }
        }
    }
}

fn rgb(colour: Colour) -> [u8; 3] {
    let [r, g, b, _] = colour.to_bytes();
    [r, g, b]
}

impl<'a> Samples<'a> {
    /// The samples of a grid.
    pub(crate) fn new(grid: Grid<'a>) -> Self {
        let mut palette = Some(Palette::new());
        let mut last = None;
        let first = grid.paints.first().map_or(255, |paint| paint.colour.to_bytes()[3]);
        let (mut varied, mut holes) = (false, false);
        for paint in grid.paints {
            if last == Some(paint.colour) {
                continue;
            }
            last = Some(paint.colour);
            let [r, g, b, alpha] = paint.colour.to_bytes();
            varied |= alpha != first;
            holes |= alpha == 0;
            if palette.as_mut().is_some_and(|palette| palette.index([r, g, b]).is_none()) {
                palette = None;
            }
        }
        let opacity = if varied { Opacity::Varied(holes) } else { Opacity::Even(first) };
        Samples { grid, palette, opacity }
    }

    /// Number of columns and rows.
    pub(crate) fn size(&self) -> (usize, usize) {
        (self.grid.columns, self.grid.rows)
    }

    /// How opaque the cells are.
    pub(crate) fn opacity(&self) -> Opacity {
        self.opacity
    }

    /// The colours in hexadecimal digits and the highest index, if the samples are indices.
    pub(crate) fn palette(&self) -> Option<(String, usize)> {
        let colours = &self.palette.as_ref()?.colours;
        let mut digits = String::with_capacity(colours.len() * 6);
        for [r, g, b] in colours {
            let _ = write!(digits, "{r:02x}{g:02x}{b:02x}");
        }
        Some((digits, colours.len().saturating_sub(1)))
    }

    /// Calls `take` with the samples of each row, from the first one on.
    pub(crate) fn rows<E>(&mut self, mut take: impl FnMut(&[u8]) -> Result<(), E>) -> Result<(), E> {
        let mut bytes = Vec::new();
        for row in self.grid.paints.chunks_exact(self.grid.columns.max(1)).take(self.grid.rows) {
            bytes.clear();
            match &mut self.palette {
                None => bytes.extend(row.iter().flat_map(|paint| rgb(paint.colour))),
                Some(palette) => {
                    let mut last = None;
                    bytes.extend(row.iter().map(|paint| match last {
                        Some((colour, index)) if colour == paint.colour => index,
                        _ => {
                            let index = palette.index(rgb(paint.colour)).unwrap_or(0);
                            last = Some((paint.colour, index));
                            index
                        }
                    }));
                }
            }
            take(&bytes)?;
        }
        Ok(())
    }

    /// Calls `take` with the opacities of each row.
    fn opacities<E>(&self, mut take: impl FnMut(&[u8]) -> Result<(), E>) -> Result<(), E> {
        let mut bytes = Vec::new();
        for row in self.grid.paints.chunks_exact(self.grid.columns.max(1)).take(self.grid.rows) {
            bytes.clear();
            bytes.extend(row.iter().map(|paint| paint.colour.to_bytes()[3]));
            take(&bytes)?;
        }
        Ok(())
    }
}

/// Draws an image; the objects that hold it stand between content streams of the page. Images that are not
/// in the page description itself are added to `images`.
pub(crate) fn draw(
    place: &Parallelogram<Du>,
    grid: Grid<'_>,
    content: &mut Content,
    document: &mut Document,
    images: &mut Vec<Ref>,
) -> Result<(), DeviceError> {
    let mut samples = Samples::new(grid);
    let (columns, rows) = samples.size();
    let varied = match samples.opacity() {
        Opacity::Even(0) => return Ok(()),
        Opacity::Even(opacity) => {
            content.opacity(opacity);
            false
        }
        Opacity::Varied(_) => {
            content.opacity(255);
            true
        }
    };
    let before = content.text().len();
    content.text().extend_from_slice(b"q\n");
    if columns == 0 || rows == 0 || !content.unit_square(place) {
        content.text().truncate(before);
        return Ok(());
    }
    content.text().extend_from_slice(b"cm\n");
    if !varied && columns.saturating_mul(rows) <= MOST_INLINE {
        return inline(&mut samples, content);
    }
    content.flush(document)?;
    document.end_stream()?;
    let mut entries = format!("/Type/XObject/Subtype/Image/Width {columns}/Height {rows}/BitsPerComponent 8");
    let mask = if varied {
        let id = document.reserve()?;
        document.begin_stream(id, &format!("{entries}/ColorSpace/DeviceGray"))?;
        samples.opacities(|row| document.write_stream(row))?;
        document.end_stream()?;
        Some(id)
    } else {
        None
    };
    entries.push_str(&match samples.palette() {
        Some((colours, highest)) => format!("/ColorSpace[/Indexed/DeviceRGB {highest}<{colours}>]"),
        None => "/ColorSpace/DeviceRGB".to_owned(),
    });
    if let Some(mask) = mask {
        let _ = write!(entries, "/SMask {} 0 R", mask.get());
    }
    let id = document.reserve()?;
    document.begin_stream(id, &entries)?;
    samples.rows(|row| document.write_stream(row))?;
    document.end_stream()?;
    images.push(id);
    content.text().extend_from_slice(format!("/I{} Do\nQ\n", id.get()).as_bytes());
    Ok(())
}

/// Writes an image into the page description. Hexadecimal digits have an end that cannot be mistaken, and
/// deflating takes away what they cost.
fn inline(samples: &mut Samples<'_>, content: &mut Content) -> Result<(), DeviceError> {
    let (columns, rows) = samples.size();
    let colours = match samples.palette() {
        Some((colours, highest)) => format!("[/I/RGB {highest}<{colours}>]"),
        None => "/RGB".to_owned(),
    };
    let mut image = format!("BI/W {columns}/H {rows}/BPC 8/CS{colours}/F/AHx\nID ");
    samples
        .rows(|row| row.iter().try_for_each(|byte| write!(image, "{byte:02x}")))
        .map_err(|_| DeviceError::Encode("an image could not be written".into()))?;
    image.push_str(">\nEI\nQ\n");
    content.text().extend_from_slice(image.as_bytes());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_pipeline::colour::Paint;

    fn paints(colours: impl IntoIterator<Item = [u8; 4]>) -> Vec<Paint> {
        let part = |byte: u8| f32::from(byte) / 255.0;
        let colour =
            |[r, g, b, a]: [u8; 4]| Colour { alpha: part(a), ..Colour::rgb(part(r), part(g), part(b)) };
        colours.into_iter().map(|bytes| Paint { colour: colour(bytes), index: 0 }).collect()
    }

    fn bytes(samples: &mut Samples<'_>) -> Vec<u8> {
        let mut all = Vec::new();
        samples
            .rows(|row| {
                all.extend_from_slice(row);
                Ok::<(), ()>(())
            })
            .unwrap();
        all
    }

    #[test]
    fn up_to_256_colours_are_indexed() {
        let few = paints((0..512).map(|i| [(i % 256) as u8, 7, (i % 256) as u8, 255]));
        let mut samples = Samples::new(Grid { paints: &few, columns: 32, rows: 16 });
        let (colours, highest) = samples.palette().unwrap();
        assert_eq!((colours.len(), highest), (256 * 6, 255));
        assert_eq!(bytes(&mut samples), (0..512).map(|i| (i % 256) as u8).collect::<Vec<u8>>());
        let many = paints((0..257).map(|i| [(i % 256) as u8, (i / 256) as u8, 9, 255]));
        let mut samples = Samples::new(Grid { paints: &many, columns: 257, rows: 1 });
        assert!(samples.palette().is_none());
        assert_eq!(bytes(&mut samples)[..6], [0, 0, 9, 1, 0, 9]);
    }

    #[test]
    fn opacity_is_even_or_varied() {
        let of = |alphas: &[u8]| {
            let paints = paints(alphas.iter().map(|&a| [1, 2, 3, a]));
            Samples::new(Grid { paints: &paints, columns: paints.len(), rows: 1 }).opacity()
        };
        assert_eq!(of(&[255, 255]), Opacity::Even(255));
        assert_eq!(of(&[128, 128]), Opacity::Even(128));
        assert_eq!(of(&[128, 255]), Opacity::Varied(false));
        assert_eq!(of(&[255, 0]), Opacity::Varied(true));
    }
}
