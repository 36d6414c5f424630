//! Text: laid out once for every device, drawn as strokes, as characters, or as outlines.
//!
//! The text frame of the layout has the character width vector as its x unit and the character height vector
//! as its y unit. Both have gone through the normalization transformation (and a segment's), so text is
//! stretched and skewed as its attributes say, on every device alike.

use crate::colour::Paint;
use crate::device::{DeviceError, Drawn, Form, Glyph, GlyphRun, Pen, Rule, StrokeCharacter, StrokeText};
use crate::font::{self, FaceGlyph, Layout, OutlineFace, PlacedGlyph, TextStyle, Verb};
use crate::look::{Cap, Join, Look, TextBundle, TextGeometry};
use crate::lower::glow;
use crate::painter::{Canvas, Painter};
use gks_algorithms::curve;
use gks_geometry::{Du, Ndc, PathBuf, Point, Rect, Vector};
use glam::DVec2;

/// The layout attributes that a look means on a workstation.
pub fn style(bundle: &TextBundle, geometry: &TextGeometry) -> TextStyle {
    TextStyle {
        font: bundle.font,
        expansion: bundle.expansion,
        spacing: bundle.spacing,
        path: geometry.path,
        horizontal: geometry.horizontal,
        vertical: geometry.vertical,
    }
}

/// The text frame in device units.
#[derive(Copy, Clone)]
struct Frame {
    origin: DVec2,
    x: DVec2,
    y: DVec2,
}

impl Frame {
    fn at(&self, p: DVec2) -> DVec2 {
        self.origin + self.x * p.x + self.y * p.y
    }
}

/// Draws a string with the text attributes of `look`.
pub(crate) fn draw(
    painter: &mut Painter,
    position: Point<Ndc>,
    text: &str,
    look: &Look,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let bundle = canvas.tables.text(look);
    let mut layout = std::mem::take(&mut painter.layout);
    font::layout(text, &style(&bundle, &look.text_geometry), &mut layout);
    let frame = Frame {
        origin: canvas.map.point(position).0,
        x: canvas.map.vector(look.text_geometry.width).0,
        y: canvas.map.vector(look.text_geometry.height).0,
    };
    let reach = frame.x.length().max(frame.y.length());
    let around = Rect::around(layout.extent.map(|p| Point::from_vec(frame.at(p)))).map(|r| r.grown(reach));
    let mut done = Ok(());
    if around.is_some_and(|r| r.meets(clip)) {
        let crossing = around.is_some_and(|r| !clip.contains_rect(&r));
        let paint = match canvas.glow {
            true => canvas.tables.paint(glow::COLOUR),
            false => canvas.tables.translucent(bundle.colour, canvas.tables.opacity.text),
        };
        done = glyphs(painter, text, &layout, frame, paint, crossing, clip, canvas);
    }
    painter.layout = layout;
    done
}

#[allow(clippy::too_many_arguments, reason = "one call, split off for the length of its body")]
fn glyphs(
    painter: &mut Painter,
    text: &str,
    layout: &Layout,
    frame: Frame,
    paint: Paint,
    crossing: bool,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let pens = canvas.surface.pen.is_some();
    strokes(painter, text, layout, frame, paint, crossing, clip, canvas)?;
    if pens {
        return Ok(());
    }
    let mut rest = &layout.glyphs[..];
    while let Some(first) = rest.first() {
        let FaceGlyph::Outline(face, _) = first.glyph else {
            rest = &rest[1..];
            continue;
        };
        let same = |g: &&PlacedGlyph| matches!(g.glyph, FaceGlyph::Outline(f, _) if std::ptr::eq(f, face));
        let (run, others) = rest.split_at(rest.iter().take_while(same).count());
        let end = others.first().map_or(text.len(), |g| g.cluster as usize);
        let shown = text.get(first.cluster as usize..end).unwrap_or(text);
        outline_run(painter, shown, face, run, layout.expansion, frame, paint, crossing, clip, canvas)?;
        rest = others;
    }
    Ok(())
}

/// Draws the glyphs of stroke fonts, and on devices with pens the substitutes of outline glyphs.
#[allow(clippy::too_many_arguments, reason = "one call, split off for the length of its body")]
fn strokes(
    painter: &mut Painter,
    text: &str,
    layout: &Layout,
    frame: Frame,
    paint: Paint,
    crossing: bool,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let width = canvas.surface.nominal_linewidth();
    let pen = match canvas.glow {
        true => glow::pen(width, canvas),
        false => Pen { paint, width, dash: &[], cap: Cap::Round, join: Join::Round },
    };
    let mut characters = std::mem::take(&mut painter.characters);
    characters.clear();
    characters.extend(layout.glyphs.iter().filter_map(|placed| match placed.glyph {
        FaceGlyph::Stroke(glyph) => {
            Some(StrokeCharacter { glyph, origin: Point::from_vec(frame.at(placed.origin)) })
        }
        FaceGlyph::Outline(..) => None,
    }));
    let (x, y) = (Vector::from_vec(frame.x * layout.expansion), Vector::from_vec(frame.y));
    let run = StrokeText { characters: &characters, x, y, pen };
    let offered = match canvas.glow || characters.is_empty() {
        true => Ok(Drawn::No),
        false => canvas.offer(Form::StrokeText(run), crossing.then_some(*clip)),
    };
    let done = match offered {
        Ok(Drawn::Yes) => Ok(()),
        Ok(Drawn::No) => {
            let mut lines = std::mem::take(&mut painter.lowered);
            lines.clear();
            run.add_to(&mut lines);
            if canvas.surface.pen.is_some() {
                substitutes(text, layout, frame, &mut lines);
            }
            let done = painter.lines(lines.as_paths(), &pen, clip, canvas);
            painter.lowered = lines;
            done
        }
        Err(error) => Err(error),
    };
    painter.characters = characters;
    done
}

/// Adds the strokes that a pen draws in the place of outline glyphs.
fn substitutes(text: &str, layout: &Layout, frame: Frame, lines: &mut PathBuf<Du>) {
    for placed in &layout.glyphs {
        let FaceGlyph::Outline(face, _) = placed.glyph else { continue };
        let character = text.get(placed.cluster as usize..).and_then(|t| t.chars().next());
        let Some(glyph) = character.and_then(|c| face.pen_substitute().glyph(c)) else { continue };
        // The substitute takes the room of the character that it stands for.
        let fits = glyph.advance > 0.0;
        let widening = if fits { placed.advance / glyph.advance } else { layout.expansion };
        for stroke in glyph.strokes() {
            lines.add(stroke.iter().map(|p| frame.at(placed.origin + DVec2::new(p.x * widening, p.y))));
        }
    }
}

#[allow(clippy::too_many_arguments, reason = "one call, split off for the length of its body")]
fn outline_run(
    painter: &mut Painter,
    text: &str,
    face: &'static OutlineFace,
    placed: &[PlacedGlyph],
    expansion: f64,
    frame: Frame,
    paint: Paint,
    crossing: bool,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let first = placed.first().map_or(0, |g| g.cluster);
    let x = frame.x * (face.em() * expansion);
    let y = frame.y * face.em();
    let mut glyphs = std::mem::take(&mut painter.glyphs);
    glyphs.clear();
    glyphs.extend(placed.iter().filter_map(|g| match g.glyph {
        FaceGlyph::Outline(_, id) => {
            let origin = Point::from_vec(frame.at(g.origin));
            Some(Glyph { id, cluster: g.cluster.saturating_sub(first), origin })
        }
        FaceGlyph::Stroke(_) => None,
    }));
    let (x, y) = (Vector::from_vec(x), Vector::from_vec(y));
    let run = GlyphRun { text, face, glyphs: &glyphs, x, y, paint };
    let offered = match canvas.glow {
        true => Ok(Drawn::No),
        false => canvas.offer(Form::Text(run.clone()), crossing.then_some(*clip)),
    };
    let done = match offered {
        Ok(Drawn::Yes) => Ok(()),
        Ok(Drawn::No) => outlines(painter, &run, clip, canvas),
        Err(error) => Err(error),
    };
    painter.glyphs = glyphs;
    done
}

/// The points of outlines that are held; characters that have more are drawn by several areas.
const HELD: usize = 1 << 18;

/// Draws characters as areas.
fn outlines(
    painter: &mut Painter,
    run: &GlyphRun<'_>,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    let tolerance = canvas.tolerance();
    // The band of highlighting is seen as far as it is wide.
    let seen = clip.grown(if canvas.glow { glow::pen(0.0, canvas).width } else { 0.0 });
    let seen = (seen.min.0, seen.max.0);
    let mut rings = PathBuf::<Du>::new();
    let mut rest = run.glyphs;
    while let Some((glyph, others)) = rest.split_first() {
        rest = others;
        let at = |p: DVec2| glyph.origin.0 + run.x.0 * p.x + run.y.0 * p.y;
        let mut last = DVec2::ZERO;
        for verb in &run.face.outline(glyph.id).verbs {
            match *verb {
                Verb::Move(p) => {
                    rings.end_or_drop(3);
                    last = at(p);
                    rings.push(last);
                }
                Verb::Line(p) => {
                    last = at(p);
                    rings.push(last);
                }
                Verb::Quad(c, p) => {
                    curve::quadratic_within(seen, [last, at(c), at(p)], tolerance, &mut rings.points);
                    last = at(p);
                }
                Verb::Cubic(c, d, p) => {
                    let curve = [last, at(c), at(d), at(p)];
                    curve::cubic_within(seen, curve, tolerance, &mut rings.points);
                    last = at(p);
                }
                Verb::Close => rings.end_or_drop(3),
            }
        }
        rings.end_or_drop(3);
        if rings.points.len() > HELD && !rest.is_empty() {
            fill(painter, &rings, run.paint, clip, canvas)?;
            rings = PathBuf::new();
        }
    }
    fill(painter, &rings, run.paint, clip, canvas)
}

/// Fills outlines of characters, or draws a band along them.
fn fill(
    painter: &mut Painter,
    rings: &PathBuf<Du>,
    paint: Paint,
    clip: &Rect<Du>,
    canvas: &mut Canvas<'_>,
) -> Result<(), DeviceError> {
    if canvas.glow {
        let mut band = PathBuf::<Du>::new();
        for ring in rings.as_paths().iter() {
            band.add(ring.iter().chain(ring.first()).copied());
        }
        let pen = glow::pen(0.0, canvas);
        return painter.lines(band.as_paths(), &pen, clip, canvas);
    }
    painter.solid(rings.as_paths(), Rule::NonZero, paint, clip, canvas)
}
