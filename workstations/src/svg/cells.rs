//! Cell arrays: as rectangles where a few will do, else as images, PNG in base 64.
//!
//! Cells have sharp edges. Viewers know several words for that, and some blur images whatever they are
//! told: hence rectangles, and images with many pixels for a cell.

use super::FINE;
use super::base64::Base64;
use super::document::{Document, open_attribute, paint};
use super::path::PathData;
use crate::number::Decimal;
use gks_geometry::{Du, Rect};
use gks_pipeline::device::{DeviceError, Grid};
use gks_pipeline::item::Parallelogram;
use glam::DVec2;
use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::io::{self, Write};

/// As many rectangles are drawn at most for one array.
const RECTANGLES: usize = 512;

/// An image gets a pixel for each user unit, so that what viewers blur is no wider, until it has as many
/// columns or rows as this.
const IMAGE: u32 = 1024;

/// Draws cells.
pub(super) fn cells(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    place: &Parallelogram<Du>,
    grid: &Grid<'_>,
) -> Result<(), DeviceError> {
    let encode = |message: &str| DeviceError::Encode(message.to_owned());
    if grid.columns.checked_mul(grid.rows) != Some(grid.paints.len()) {
        return Err(encode("a cell array has not the cells that it says"));
    }
    if grid.paints.is_empty() {
        return Ok(());
    }
    if let Some(runs) = runs(grid) {
        return Ok(rectangles(document, clip, place, grid, &runs)?);
    }
    let size = |cells: usize| u32::try_from(cells).map_err(|_| encode("a cell array has too many cells"));
    let (columns, rows) = (size(grid.columns)?, size(grid.rows)?);
    let cell = (place.columns.length() / f64::from(columns)).max(place.rows.length() / f64::from(rows));
    let factor = (cell.ceil() as u32).min(IMAGE / columns.max(rows)).max(1);
    let (width, height) = (columns * factor, rows * factor);
    document.group(clip, |_| {});
    if document.is_first_image() {
        // What SVG 1.1 calls optimizeSpeed has another name in CSS; viewers that do not know it know no
        // @supports.
        document.raw("<style type=\"text/css\">@supports(image-rendering:pixelated)");
        document.raw("{image[image-rendering]{image-rendering:pixelated}}</style>\n");
    }
    document.raw(&format!("<image width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\""));
    matrix(&mut document.out, place, width.into(), height.into());
    document.raw(" image-rendering=\"optimizeSpeed\" xlink:href=\"data:image/png;base64,");
    let mut writer = Base64::new(document);
    png(&mut writer, width, height, grid, factor as usize).map_err(|error| match error {
        png::EncodingError::IoError(error) => DeviceError::Io(error),
        other => DeviceError::Encode(other.to_string()),
    })?;
    writer.finish()?;
    document.raw("\"/>\n");
    Ok(())
}

/// Appends the transformation that takes a rectangle of this size to a place.
fn matrix(out: &mut Vec<u8>, place: &Parallelogram<Du>, width: f64, height: f64) {
    open_attribute(out, "transform");
    out.extend_from_slice(b"matrix(");
    let (across, down) = (place.columns.0 / width, place.rows.0 / height);
    for value in [across.x, across.y, down.x, down.y, place.origin.x(), place.origin.y()] {
        if out.last() != Some(&b'(') {
            out.push(b' ');
        }
        FINE.write(out, value);
    }
    out.extend_from_slice(b")\"");
}

/// Neighbours in a row that have the same colour: the number of the colour in the order of first use, the
/// row, the first column, the number of columns.
type Run = (usize, usize, usize, usize);

/// The runs of a grid ordered by colour, if rectangles for them are not too many.
fn runs(grid: &Grid<'_>) -> Option<Vec<Run>> {
    let mut numbers = HashMap::new();
    let mut runs: Vec<Run> = Vec::new();
    for (row, paints) in grid.paints.chunks(grid.columns).enumerate() {
        let mut column = 0;
        for run in paints.chunk_by(|a, b| a.colour == b.colour) {
            let next = numbers.len();
            let number = *numbers.entry(run[0].colour.to_bytes()).or_insert(next);
            if runs.len() == RECTANGLES {
                return None;
            }
            runs.push((number, row, column, run.len()));
            column += run.len();
        }
    }
    runs.sort_unstable();
    Some(runs)
}

/// Draws runs of cells as rectangles, one path for each colour, in coordinates that count cells.
fn rectangles(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    place: &Parallelogram<Du>,
    grid: &Grid<'_>,
    runs: &[Run],
) -> io::Result<()> {
    document.group(clip, |out| {
        matrix(out, place, grid.columns as f64, grid.rows as f64);
        out.extend_from_slice(b" shape-rendering=\"crispEdges\"");
    });
    for alike in runs.chunk_by(|a, b| a.0 == b.0) {
        let (_, row, column, _) = alike[0];
        document.raw("<path");
        paint(&mut document.out, "fill", grid.paints[row * grid.columns + column].colour);
        document.raw(" d=\"");
        let mut data = PathData::new(document, Decimal::new(0));
        for &(_, row, column, length) in alike {
            let (corner, size) = (DVec2::new(column as f64, row as f64), DVec2::new(length as f64, 1.0));
            data.move_to(corner)?;
            data.line_to(corner + DVec2::new(size.x, 0.0))?;
            data.line_to(corner + size)?;
            data.line_to(corner + DVec2::new(0.0, size.y))?;
            data.close();
        }
        document.raw("\"/>\n");
    }
    Ok(())
}

/// The distinct colours of a grid in the order in which they occur, if there are no more than 256.
fn palette(grid: &Grid<'_>) -> Option<HashMap<[u8; 4], u8>> {
    let mut palette = HashMap::new();
    for paint in grid.paints {
        let next = palette.len();
        if let Entry::Vacant(entry) = palette.entry(paint.colour.to_bytes()) {
            entry.insert(u8::try_from(next).ok()?);
        }
    }
    Some(palette)
}

/// Writes a grid as PNG with `factor` x `factor` pixels for each cell: with a palette where that is possible,
/// else in true colour.
fn png(
    out: &mut impl Write,
    width: u32,
    height: u32,
    grid: &Grid<'_>,
    factor: usize,
) -> Result<(), png::EncodingError> {
    let is_opaque = grid.paints.iter().all(|paint| paint.colour.to_bytes()[3] == 255);
    let palette = palette(grid);
    let mut encoder = png::Encoder::new(out, width, height);
    let mut depth = 8;
    if let Some(palette) = &palette {
        let mut colours: Vec<_> = palette.iter().map(|(&colour, &index)| (index, colour)).collect();
        colours.sort_unstable();
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_palette(colours.iter().flat_map(|(_, [r, g, b, _])| [*r, *g, *b]).collect::<Vec<u8>>());
        if !is_opaque {
            encoder.set_trns(colours.iter().map(|(_, [_, _, _, alpha])| *alpha).collect::<Vec<u8>>());
        }
        (depth, _) = match colours.len() {
            0..=2 => (1, encoder.set_depth(png::BitDepth::One)),
            3..=4 => (2, encoder.set_depth(png::BitDepth::Two)),
            5..=16 => (4, encoder.set_depth(png::BitDepth::Four)),
            _ => (8, encoder.set_depth(png::BitDepth::Eight)),
        };
        encoder.set_filter(png::Filter::NoFilter);
    } else {
        encoder.set_color(if is_opaque { png::ColorType::Rgb } else { png::ColorType::Rgba });
        encoder.set_filter(png::Filter::Adaptive);
    }
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer()?;
    let mut line = Vec::new();
    for row in grid.paints.chunks(grid.columns) {
        line.clear();
        let colours = row.iter().flat_map(|paint| std::iter::repeat_n(paint.colour.to_bytes(), factor));
        match &palette {
            Some(palette) => {
                line.resize((grid.columns * factor * depth).div_ceil(8), 0);
                for (i, colour) in colours.enumerate() {
                    let bit = i * depth;
                    line[bit / 8] |= palette[&colour] << (8 - depth - bit % 8);
                }
            }
            None if is_opaque => line.extend(colours.flat_map(|[r, g, b, _]| [r, g, b])),
            None => line.extend(colours.flatten()),
        }
        for _ in 0..factor {
            stream.write_all(&line)?;
        }
    }
    stream.finish()?;
    writer.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::tests::{body, draw};
    use gks_geometry::{Point, Vector};
    use gks_pipeline::colour::{Colour, Paint};
    use gks_pipeline::device::{Device, Form, Mark};

    fn paint(red: f32, green: f32, blue: f32, alpha: f32) -> Paint {
        Paint { colour: Colour { red, green, blue, alpha }, index: 1 }
    }

    fn place(columns: (f64, f64), rows: (f64, f64)) -> Parallelogram<Du> {
        Parallelogram { origin: Point::new(10.0, 20.0), columns: columns.into(), rows: rows.into() }
    }

    /// The image in a document: width, height, and its pixels as bytes of red, green, blue and alpha.
    fn image(text: &str) -> (u32, u32, Vec<[u8; 4]>) {
        let start = text.find("base64,").unwrap() + "base64,".len();
        let coded = &text[start..start + text[start..].find('"').unwrap()];
        let digit = |c: char| "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/".find(c);
        let digits: Vec<u32> = coded.chars().map_while(digit).map(|digit| digit as u32).collect();
        let bytes: Vec<u8> = digits
            .chunks(4)
            .flat_map(|group| {
                let bits = group.iter().enumerate().fold(0, |bits, (i, digit)| bits | digit << (18 - 6 * i));
                bits.to_be_bytes()[1..group.len()].to_vec()
            })
            .collect();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::ALPHA);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!(info.color_type, png::ColorType::Rgba);
        (info.width, info.height, pixels.chunks(4).map(|p| p.try_into().unwrap()).collect())
    }

    #[test]
    fn few_cells_are_rectangles() {
        let (red, clear) = (paint(1.0, 0.0, 0.0, 1.0), paint(0.0, 0.0, 1.0, 0.2));
        let paints = [red, red, clear, clear, red, red];
        let grid = Grid { paints: &paints, columns: 3, rows: 2 };
        let text = body(|svg| draw(svg, Form::Cells(place((30.0, 3.0), (-4.0, 50.0)), grid), None));
        assert_eq!(
            text,
            "<g transform=\"matrix(10 1 -2 25 10 20)\" shape-rendering=\"crispEdges\">\n\
            <path fill=\"#f00\" d=\"m0 0h2v1h-2zm1 1h2v1h-2z\"/>\n\
            <path fill=\"#00f\" fill-opacity=\".2\" d=\"m2 0h1v1h-1zm-2 1h1v1h-1z\"/>\n</g>\n"
        );
    }

    #[test]
    fn many_cells_are_an_image() {
        let shades = |count: usize, alpha: f32| {
            move |i: usize| {
                paint((i * 7 % count) as f32 / 255.0, (i * 7 % count / 256) as f32 / 255.0, 0.5, alpha)
            }
        };
        for (colours, alpha) in [(2, 1.0), (3, 1.0), (16, 0.4), (17, 1.0), (256, 1.0), (257, 1.0), (900, 0.6)]
        {
            let paints: Vec<Paint> = (0..41 * 23).map(shades(colours, alpha)).collect();
            let grid = Grid { paints: &paints, columns: 41, rows: 23 };
            let draw_cells = |svg: &mut crate::svg::Svg| {
                draw(svg, Form::Cells(place((82.0, 0.0), (0.0, 50.0)), grid), None);
            };
            let text = body(draw_cells);
            assert!(text.contains(
                "<image width=\"123\" height=\"69\" preserveAspectRatio=\"none\" \
                transform=\"matrix(.66667 0 0 .72464 10 20)\" image-rendering=\"optimizeSpeed\" xlink:href="
            ));
            assert!(text.starts_with("<style type=\"text/css\">@supports"));
            assert_eq!(body(|svg| (0..3).for_each(|_| draw_cells(svg))).matches("<style").count(), 1);
            let (width, height, pixels) = image(&text);
            assert_eq!((width, height), (123, 69));
            for (i, pixel) in pixels.iter().enumerate() {
                let (column, row) = (i % 123 / 3, i / 123 / 3);
                assert_eq!(
                    *pixel,
                    paints[row * 41 + column].colour.to_bytes(),
                    "{colours} colours, pixel {i}"
                );
            }
        }
    }

    #[test]
    fn the_image_is_no_larger_than_its_place_needs() {
        let paints: Vec<Paint> = (0..300 * 4).map(|i| paint((i % 2) as f32, 0.0, 0.0, 1.0)).collect();
        let size = |columns: Vector<Du>| {
            let place = Parallelogram { columns, ..place((0.0, 0.0), (0.0, 0.5)) };
            let grid = Grid { paints: &paints, columns: 300, rows: 4 };
            let (width, height, _) = image(&body(|svg| draw(svg, Form::Cells(place, grid), None)));
            (width, height)
        };
        assert_eq!(size(Vector::new(30.0, 0.0)), (300, 4));
        assert_eq!(size(Vector::new(0.0, 450.0)), (600, 8));
        assert_eq!(size(Vector::new(1e9, 0.0)), (900, 12));
        assert_eq!(size(Vector::new(f64::NAN, 0.0)), (300, 4));
    }

    #[test]
    fn wrong_counts_are_errors() {
        body(|svg| {
            for (columns, rows) in [(2, 2), (usize::MAX, usize::MAX), (0, 4)] {
                let grid = Grid { paints: &[paint(0.0, 0.0, 0.0, 1.0)], columns, rows };
                let form = Form::Cells(place((1.0, 0.0), (0.0, 1.0)), grid);
                assert!(svg.draw(&Mark { form, clip: None }).is_err());
            }
            draw(
                svg,
                Form::Cells(place((1.0, 0.0), (0.0, 1.0)), Grid { paints: &[], columns: 0, rows: 0 }),
                None,
            );
        });
    }
}
