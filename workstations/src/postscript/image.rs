//! Cell arrays as images of PostScript: deflated samples in printable characters.

use super::ascii85::Ascii85;
use super::document::Document;
use crate::deflate::Deflate;
use crate::pdf::content::Content;
use crate::pdf::image::Samples;
use gks_geometry::Du;
use gks_pipeline::device::DeviceError;
use gks_pipeline::item::Parallelogram;

/// Images of more samples are not held back together with the text of the page.
const MOST_HELD: usize = 1 << 16;

/// Digits of a palette on one line.
const COLUMNS: usize = 72;

/// Draws an image.
pub(crate) fn draw(
    place: &Parallelogram<Du>,
    samples: &mut Samples<'_>,
    content: &mut Content,
    document: &mut Document,
    deflate: &mut Deflate,
) -> Result<(), DeviceError> {
    let (columns, rows) = samples.size();
    if columns == 0 || rows == 0 {
        return Ok(());
    }
    // Fonts are written between pieces of the page, which therefore must not begin inside of samples.
    let long = columns.saturating_mul(rows) > MOST_HELD;
    if long {
        content.flush(document)?;
    }
    let before = content.text().len();
    content.text().extend_from_slice(b"q\n");
    if !content.unit_square(place) {
        content.text().truncate(before);
        return Ok(());
    }
    let text = content.text();
    text.extend_from_slice(b"cm\n");
    let decode = match samples.palette() {
        Some((colours, highest)) => {
            text.extend_from_slice(format!("[/Indexed/DeviceRGB {highest}<\n").as_bytes());
            for line in colours.as_bytes().chunks(COLUMNS) {
                text.extend_from_slice(line);
                text.push(b'\n');
            }
            text.extend_from_slice(b">]setcolorspace\n");
            "0 255"
        }
        None => {
            text.extend_from_slice(b"/DeviceRGB setcolorspace\n");
            "0 1 0 1 0 1"
        }
    };
    text.extend_from_slice(format!("{columns} {rows}[{decode}]I\n").as_bytes());
    let mut digits = Ascii85::default();
    samples.rows(|row| {
        deflate.write(row, |packed| {
            digits.write(packed, content.text());
            Ok(())
        })?;
        if long { content.relieve(document) } else { Ok(()) }
    })?;
    deflate.finish(|packed| {
        digits.write(packed, content.text());
        Ok(())
    })?;
    digits.finish(content.text());
    content.text().extend_from_slice(b"\nQ\n");
    if long { content.flush(document) } else { Ok(()) }
}
