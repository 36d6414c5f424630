//! Lines and areas as path elements.

use super::COORDINATE;
use super::document::{Document, attribute, open_attribute, paint};
use super::path::PathData;
use gks_geometry::{Du, Paths, Rect};
use gks_pipeline::colour::Paint;
use gks_pipeline::device::{Pen, Rule};
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;
use std::io;

/// Draws lines, with all paths in one element and all dots in another, as wide as the pen and square unless its
/// ends are round. A line that ends where it started has a corner there.
pub(super) fn lines(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    paths: Paths<'_, Du>,
    pen: &Pen<'_>,
) -> io::Result<()> {
    let is_dot = |path: &[DVec2]| path.iter().all(|point| *point == path[0]);
    let has_lines = paths.iter().any(|path| !is_dot(path));
    let has_dots = paths.iter().any(|path| !path.is_empty() && is_dot(path));
    if !has_lines && !has_dots {
        return Ok(());
    }
    document.group(clip, |out| stroke(out, pen));
    if has_lines {
        document.raw("<path d=\"");
        let mut data = PathData::new(document, COORDINATE);
        for path in paths.iter().filter(|path| !is_dot(path)) {
            let closed = path.len() > 3 && path.first() == path.last();
            let last = if closed { path.len() - 1 } else { path.len() };
            data.move_to(path[0])?;
            let mut moved = false;
            for &point in &path[1..last] {
                moved |= data.line_to(point)?;
            }
            match (moved, closed) {
                (false, _) => data.stay(),
                (true, true) => data.close(),
                (true, false) => {}
            }
        }
        document.raw("\"/>\n");
    }
    if has_dots {
        document.raw("<path");
        if pen.cap == Cap::Butt {
            document.raw(" stroke-linecap=\"square\"");
        }
        if !pen.dash.is_empty() {
            document.raw(" stroke-dasharray=\"none\"");
        }
        document.raw(" d=\"");
        let mut data = PathData::new(document, COORDINATE);
        for path in paths.iter().filter(|path| !path.is_empty() && is_dot(path)) {
            data.move_to(path[0])?;
            data.stay();
        }
        document.raw("\"/>\n");
    }
    Ok(())
}

/// Draws the area inside of rings.
pub(super) fn area(
    document: &mut Document,
    clip: Option<&Rect<Du>>,
    paths: Paths<'_, Du>,
    rule: Rule,
    fill: &Paint,
) -> io::Result<()> {
    if !paths.iter().any(|ring| ring.len() > 2) {
        return Ok(());
    }
    document.group(clip, |out| {
        paint(out, "fill", fill.colour);
        if rule == Rule::NonZero {
            out.extend_from_slice(b" fill-rule=\"nonzero\"");
        } else if fill.colour.alpha >= 1.0 && paths.iter().nth(1).is_none() {
            // Viewers antialias every area by itself: what is below would show between neighbours. The cells of
            // a pattern are many rings, which may run along one another with nothing between them.
            paint(out, "stroke", fill.colour);
            out.extend_from_slice(b" stroke-width=\".5\"");
        }
    });
    document.raw("<path d=\"");
    let mut data = PathData::new(document, COORDINATE);
    for ring in paths.iter().filter(|ring| ring.len() > 2) {
        let last = if ring.first() == ring.last() { ring.len() - 1 } else { ring.len() };
        data.move_to(ring[0])?;
        for &point in &ring[1..last] {
            data.line_to(point)?;
        }
        data.close();
    }
    document.raw("\"/>\n");
    Ok(())
}

/// Appends the attributes of lines that differ from the initial ones.
pub(super) fn stroke(out: &mut Vec<u8>, pen: &Pen<'_>) {
    paint(out, "stroke", pen.paint.colour);
    let width = pen.width.max(1.0 / COORDINATE.scale());
    if width != 1.0 {
        attribute(out, "stroke-width", width);
    }
    if !pen.dash.is_empty() {
        open_attribute(out, "stroke-dasharray");
        for (i, &length) in pen.dash.iter().enumerate() {
            if i > 0 {
                out.push(b' ');
            }
            COORDINATE.write(out, length);
        }
        out.push(b'"');
    }
    match pen.cap {
        Cap::Butt => {}
        Cap::Round => out.extend_from_slice(b" stroke-linecap=\"round\""),
        Cap::Projecting => out.extend_from_slice(b" stroke-linecap=\"square\""),
    }
    match pen.join {
        Join::Miter => {}
        Join::Round => out.extend_from_slice(b" stroke-linejoin=\"round\""),
        Join::Bevel => out.extend_from_slice(b" stroke-linejoin=\"bevel\""),
    }
}
