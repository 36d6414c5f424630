//! Text layout: characters of a string placed by path, alignment, spacing and expansion (ISO 7942, 4.4.5).

use glam::DVec2;

use super::outline::OutlineFace;
use super::shape::{Shaper, is_mark};
use super::stroke::{StrokeFace, StrokeGlyph, default_face};
use super::style::{Horizontal, TextPath, TextStyle, Vertical};
use super::{Face, Metrics, is_invisible};

/// A glyph of either kind of face.
#[derive(Clone, Copy, Debug)]
pub enum FaceGlyph {
    /// Pen strokes, in character heights.
    Stroke(&'static StrokeGlyph),
    /// A glyph of an outline face, in em of [`OutlineFace::em`] character heights.
    Outline(&'static OutlineFace, u16),
}

/// A glyph in its place in the text frame.
#[derive(Clone, Copy, Debug)]
pub struct PlacedGlyph {
    /// The glyph.
    pub glyph: FaceGlyph,
    /// Byte offset in the text of the character that the glyph shows, or of the first one if it shows several.
    pub cluster: u32,
    /// Place of the glyph's origin.
    pub origin: DVec2,
    /// Advance width, expanded.
    pub advance: f64,
}

/// A string laid out, in the text frame.
///
/// The frame has the text position as its origin and character heights as its unit, x along the character base
/// vector, y along the character up vector. The expansion factor is contained in all x values; what is left for the
/// reader of a glyph is to multiply the x values of the glyph itself by [`Layout::expansion`].
#[derive(Debug)]
pub struct Layout {
    /// The glyphs in the order of the text.
    pub glyphs: Vec<PlacedGlyph>,
    /// Factor for the x values inside glyphs.
    pub expansion: f64,
    /// Corners of the text extent rectangle: lower left, lower right, upper right, upper left.
    pub extent: [DVec2; 4],
    /// Where to place a string that is to follow this one with the same attributes.
    pub concatenation: DVec2,
    cells: Vec<Cell>,
    shaper: Shaper,
}

/// One character body with its marks: glyphs placed relative to the left end of its base line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// Index of the first glyph; the last one ends where the next cell begins.
    pub(super) first: usize,
    /// Width of the body, expanded.
    pub(super) width: f64,
}

impl Default for Layout {
    fn default() -> Self {
        Self {
            glyphs: Vec::new(),
            expansion: 1.0,
            extent: [DVec2::ZERO; 4],
            concatenation: DVec2::ZERO,
            cells: Vec::new(),
            shaper: Shaper::default(),
        }
    }
}

/// Lays out a string, reusing the buffers of `out`.
///
/// Control characters and other invisible ones have no body and leave no gap. Combining marks go with the character
/// before them. With an outline face, path RIGHT or LEFT and spacing 0, neighbours are kerned; otherwise every
/// character stands for itself. Characters follow the path in the order of the string, whatever their script: text
/// that is written from right to left wants path LEFT.
pub fn layout(text: &str, style: &TextStyle, out: &mut Layout) {
    out.glyphs.clear();
    out.cells.clear();
    out.expansion = style.expansion;
    let metrics = match super::face(style.font).unwrap_or_else(|| Face::Stroke(default_face())) {
        Face::Stroke(face) => {
            out.stroke_cells(text, face);
            face.metrics()
        }
        Face::Outline(face) => {
            let kerned = matches!(style.path, TextPath::Right | TextPath::Left) && style.spacing == 0.0;
            let reversed = style.path == TextPath::Left;
            out.shaper.cells(
                text,
                face,
                kerned.then_some(reversed),
                style.expansion,
                &mut out.glyphs,
                &mut out.cells,
            );
            face.metrics()
        }
    };
    out.place(style, metrics);
}

impl Layout {
    /// One cell for every character of a stroke face, marks put on the letters before them.
    fn stroke_cells(&mut self, text: &str, face: &'static StrokeFace) {
        let mut letter: Option<&'static StrokeGlyph> = None;
        for (cluster, character) in characters(text) {
            let Some(glyph) = face.glyph(character) else { continue };
            if let Some(base) = letter.filter(|_| is_mark(character)) {
                let origin = face.mark_origin(base, character) * DVec2::new(self.expansion, 1.0);
                self.glyphs.push(PlacedGlyph {
                    glyph: FaceGlyph::Stroke(glyph),
                    cluster,
                    origin,
                    advance: 0.0,
                });
                continue;
            }
            letter = Some(glyph);
            let advance = glyph.advance * self.expansion;
            self.cells.push(Cell { first: self.glyphs.len(), width: advance });
            self.glyphs.push(PlacedGlyph {
                glyph: FaceGlyph::Stroke(glyph),
                cluster,
                origin: DVec2::ZERO,
                advance,
            });
        }
    }

    /// Puts the cells one after another along the path and everything in its place by the alignment.
    fn place(&mut self, style: &TextStyle, metrics: Metrics) {
        self.extent = [DVec2::ZERO; 4];
        self.concatenation = DVec2::ZERO;
        if self.cells.is_empty() {
            return;
        }
        let gap = style.spacing;
        let step = metrics.body() + gap;
        let mut pen = DVec2::ZERO;
        // Extent of the bodies: x range, and base lines of the lowest and the uppermost character.
        let (mut left, mut right, mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64, 0.0_f64);
        for index in 0..self.cells.len() {
            let Cell { first, width } = self.cells[index];
            let end = self.cells.get(index + 1).map_or(self.glyphs.len(), |next| next.first);
            let start = match style.path {
                TextPath::Right => pen,
                TextPath::Left => pen - DVec2::new(width, 0.0),
                TextPath::Up | TextPath::Down => pen - DVec2::new(width / 2.0, 0.0),
            };
            for glyph in &mut self.glyphs[first..end] {
                glyph.origin += start;
            }
            left = left.min(start.x);
            right = right.max(start.x + width);
            low = low.min(start.y);
            high = high.max(start.y);
            match style.path {
                TextPath::Right => pen.x += width + gap,
                TextPath::Left => pen.x -= width + gap,
                TextPath::Up => pen.y += step,
                TextPath::Down => pen.y -= step,
            }
        }
        let (bottom, top) = (low + metrics.bottom, high + metrics.top);
        let (horizontal, vertical) = style.alignment();
        let anchor = DVec2::new(
            match horizontal {
                Horizontal::Left => left,
                Horizontal::Right => right,
                _ => (left + right) / 2.0,
            },
            match vertical {
                Vertical::Top => top,
                Vertical::Cap => high + metrics.cap,
                Vertical::Half => (low + high) / 2.0 + metrics.half,
                Vertical::Bottom => bottom,
                _ => low + metrics.base,
            },
        );
        for glyph in &mut self.glyphs {
            glyph.origin -= anchor;
        }
        let corner = |x: f64, y: f64| DVec2::new(x, y) - anchor;
        self.extent = [corner(left, bottom), corner(right, bottom), corner(right, top), corner(left, top)];
        self.concatenation = match style.path {
            TextPath::Right | TextPath::Left => match horizontal {
                Horizontal::Left => DVec2::new(right - anchor.x + gap, 0.0),
                Horizontal::Right => DVec2::new(left - anchor.x - gap, 0.0),
                _ => DVec2::ZERO,
            },
            TextPath::Up | TextPath::Down => match vertical {
                Vertical::Top | Vertical::Cap => DVec2::new(0.0, bottom - anchor.y - gap),
                Vertical::Half => DVec2::ZERO,
                _ => DVec2::new(0.0, top - anchor.y + gap),
            },
        };
    }
}

/// The characters of a text that have a body or are marks, with their byte offsets.
pub(super) fn characters(text: &str) -> impl Iterator<Item = (u32, char)> {
    text.char_indices()
        .filter(|&(_, character)| !is_invisible(character))
        .map_while(|(offset, character)| Some((u32::try_from(offset).ok()?, character)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOP: f64 = 4.0 / 3.0;
    const BOTTOM: f64 = -1.0 / 3.0;

    fn laid(text: &str, style: TextStyle) -> Layout {
        let mut out = Layout::default();
        layout(text, &style, &mut out);
        out
    }

    fn assert_near(actual: DVec2, expected: (f64, f64), what: &str) {
        assert!(actual.abs_diff_eq(DVec2::from(expected), 1e-12), "{what}: {actual} is not {expected:?}");
    }

    /// Left, right, bottom, top of the extent.
    fn assert_extent(out: &Layout, [left, right, bottom, top]: [f64; 4], what: &str) {
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top)];
        for (actual, expected) in out.extent.into_iter().zip(corners) {
            assert_near(actual, expected, what);
        }
    }

    fn style(path: TextPath, horizontal: Horizontal, vertical: Vertical) -> TextStyle {
        TextStyle { path, horizontal, vertical, ..TextStyle::default() }
    }

    const HORIZONTALS: [Horizontal; 4] =
        [Horizontal::Normal, Horizontal::Left, Horizontal::Centre, Horizontal::Right];
    const VERTICALS: [Vertical; 6] =
        [Vertical::Normal, Vertical::Top, Vertical::Cap, Vertical::Half, Vertical::Base, Vertical::Bottom];

    /// Three characters of font 1, expansion 2, spacing 1/2: bodies 2 wide, 5/3 high.
    #[test]
    fn every_alignment_of_a_horizontal_path_puts_the_box_where_the_standard_says() {
        // Three bodies of 2 and two gaps of 1/2: 7.
        let lefts = |path| match path {
            TextPath::Right => [0.0, 0.0, -3.5, -7.0],
            _ => [-7.0, 0.0, -3.5, -7.0],
        };
        let bases = [0.0, -TOP, -1.0, -0.5, 0.0, -BOTTOM];
        for path in [TextPath::Right, TextPath::Left] {
            for (horizontal, left) in HORIZONTALS.into_iter().zip(lefts(path)) {
                for (vertical, base) in VERTICALS.into_iter().zip(bases) {
                    let what = format!("{path:?} {horizontal:?} {vertical:?}");
                    let style =
                        TextStyle { expansion: 2.0, spacing: 0.5, ..style(path, horizontal, vertical) };
                    let out = laid("abc", style);
                    assert_extent(&out, [left, left + 7.0, base + BOTTOM, base + TOP], &what);
                    for (index, glyph) in (0_u32..).zip(&out.glyphs) {
                        let place = f64::from(if path == TextPath::Right { index } else { 2 - index });
                        assert_eq!(glyph.cluster, index);
                        assert_eq!(glyph.advance, 2.0);
                        assert_near(glyph.origin, (left + 2.5 * place, base), &what);
                    }
                }
            }
        }
    }

    #[test]
    fn every_alignment_of_a_vertical_path_puts_the_box_where_the_standard_says() {
        // Two steps of a body of 5/3 and a gap of 1/2 between the first and the last base line.
        let rise = 2.0 * (5.0 / 3.0 + 0.5);
        for path in [TextPath::Up, TextPath::Down] {
            // Base line of the lowest character.
            let normal = if path == TextPath::Up { 0.0 } else { -rise - TOP };
            let lowest = [normal, -rise - TOP, -rise - 1.0, -rise / 2.0 - 0.5, 0.0, -BOTTOM];
            for (horizontal, centre) in HORIZONTALS.into_iter().zip([0.0, 1.0, 0.0, -1.0]) {
                for (vertical, base) in VERTICALS.into_iter().zip(lowest) {
                    let what = format!("{path:?} {horizontal:?} {vertical:?}");
                    let style =
                        TextStyle { expansion: 2.0, spacing: 0.5, ..style(path, horizontal, vertical) };
                    let out = laid("abc", style);
                    assert_extent(
                        &out,
                        [centre - 1.0, centre + 1.0, base + BOTTOM, base + rise + TOP],
                        &what,
                    );
                    for (index, glyph) in (0_u32..).zip(&out.glyphs) {
                        let place = f64::from(if path == TextPath::Up { index } else { 2 - index });
                        assert_near(glyph.origin, (centre - 1.0, base + place * rise / 2.0), &what);
                    }
                }
            }
        }
    }

    #[test]
    fn concatenation_points_follow_the_resolved_alignment() {
        // "ab" with a gap of 1/2: 2.5 wide when horizontal, 23/6 high when vertical.
        let height = 2.0 * 5.0 / 3.0 + 0.5;
        let horizontal = [
            (TextPath::Right, Horizontal::Normal, 3.0),
            (TextPath::Right, Horizontal::Left, 3.0),
            (TextPath::Right, Horizontal::Centre, 0.0),
            (TextPath::Right, Horizontal::Right, -3.0),
            (TextPath::Left, Horizontal::Normal, -3.0),
            (TextPath::Left, Horizontal::Left, 3.0),
            (TextPath::Left, Horizontal::Centre, 0.0),
            (TextPath::Left, Horizontal::Right, -3.0),
        ];
        for (path, align, x) in horizontal {
            for vertical in VERTICALS {
                let out = laid("ab", TextStyle { spacing: 0.5, ..style(path, align, vertical) });
                assert_near(out.concatenation, (x, 0.0), &format!("{path:?} {align:?} {vertical:?}"));
            }
        }
        let vertical = [
            (TextPath::Up, Vertical::Normal, height + BOTTOM + 0.5),
            (TextPath::Down, Vertical::Normal, -height - 0.5),
            (TextPath::Up, Vertical::Top, -height - 0.5),
            (TextPath::Down, Vertical::Cap, -height + TOP - 1.0 - 0.5),
            (TextPath::Up, Vertical::Half, 0.0),
            (TextPath::Down, Vertical::Base, height + BOTTOM + 0.5),
            (TextPath::Down, Vertical::Bottom, height + 0.5),
        ];
        for (path, align, y) in vertical {
            for horizontal in HORIZONTALS {
                let out = laid("ab", TextStyle { spacing: 0.5, ..style(path, horizontal, align) });
                assert_near(out.concatenation, (0.0, y), &format!("{path:?} {horizontal:?} {align:?}"));
            }
        }
    }

    #[test]
    fn a_string_split_at_the_concatenation_point_lies_as_the_whole_one() {
        for font in [1, -4, -13, -29] {
            for path in [TextPath::Right, TextPath::Left] {
                let style = TextStyle { font, spacing: 0.25, path, ..TextStyle::default() };
                let (whole, first, second) = (laid("abcd", style), laid("ab", style), laid("cd", style));
                let moved = second.glyphs.iter().map(|glyph| glyph.origin + first.concatenation);
                for (origin, expected) in moved.zip(&whole.glyphs[2..]) {
                    assert!(origin.abs_diff_eq(expected.origin, 1e-12), "font {font} {path:?}");
                }
            }
        }
    }

    #[test]
    fn the_widest_body_sets_the_width_of_a_column() {
        let style = TextStyle { font: -4, ..style(TextPath::Down, Horizontal::Left, Vertical::Normal) };
        let out = laid("iMi", style);
        // M is 24 units wide and i 8.
        assert_extent(&out, [0.0, 24.0 / 21.0, -5.0, 0.0], "iMi");
        assert_near(out.glyphs[0].origin, (8.0 / 21.0, -TOP), "i is centred on M");
    }

    #[test]
    fn text_without_bodies_has_no_extent() {
        for font in [1, -21] {
            for text in ["", "\n\t\u{7}\u{200d}\u{feff}"] {
                let mut out = laid("something before", TextStyle { font, ..TextStyle::default() });
                layout(text, &TextStyle { font, spacing: 1.0, ..TextStyle::default() }, &mut out);
                assert!(out.glyphs.is_empty());
                assert_eq!(out.extent, [DVec2::ZERO; 4]);
                assert_eq!(out.concatenation, DVec2::ZERO);
            }
            let style = TextStyle { font, spacing: 1.0, ..TextStyle::default() };
            assert_eq!(laid("a\nb", style).extent, laid("ab", style).extent);
        }
    }

    #[test]
    fn overlapping_spacing_keeps_every_body_inside_the_extent() {
        let out = laid("abc", TextStyle { spacing: -3.0, ..TextStyle::default() });
        assert_extent(&out, [0.0, 5.0, BOTTOM, TOP], "bodies at 0, -2 and -4");
    }

    #[test]
    fn an_unknown_font_is_font_1() {
        for font in [0, 7, -1, -99] {
            let out = laid("text", TextStyle { font, ..TextStyle::default() });
            assert_extent(&out, [0.0, 4.0, BOTTOM, TOP], "font 1");
        }
    }

    fn width(text: &str, style: TextStyle) -> f64 {
        let out = laid(text, style);
        out.extent[1].x - out.extent[0].x
    }

    #[test]
    fn neighbours_are_kerned_along_the_base_line_unless_spaced() {
        let sans = TextStyle { font: -21, ..TextStyle::default() };
        let alone = width("A", sans) + width("V", sans);
        for (path, kerned) in
            [(TextPath::Right, true), (TextPath::Left, true), (TextPath::Up, false), (TextPath::Down, false)]
        {
            let style = TextStyle { path, ..sans };
            if kerned {
                assert!(width("AV", style) < alone - 0.05, "{path:?}");
            } else {
                assert_eq!(width("AV", style), width("A", sans).max(width("V", sans)), "{path:?}");
            }
        }
        assert!((width("AV", TextStyle { spacing: 0.5, ..sans }) - alone - 0.5).abs() < 1e-12);
        // LEFT shows the same line as RIGHT does for the reversed string.
        let (left, right) =
            (laid("LTAVoe", TextStyle { path: TextPath::Left, ..sans }), laid("eoVATL", sans));
        let shift = left.extent[0].x - right.extent[0].x;
        for (from_left, from_right) in left.glyphs.iter().zip(right.glyphs.iter().rev()) {
            assert!((from_left.origin.x - shift - from_right.origin.x).abs() < 1e-9);
        }
        assert_eq!(left.glyphs.iter().map(|glyph| glyph.cluster).collect::<Vec<_>>(), [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn expansion_stretches_outlines_and_kerning() {
        let sans = TextStyle { font: -21, ..TextStyle::default() };
        let wide = TextStyle { expansion: 1.5, ..sans };
        assert!((width("AVATAR", wide) - 1.5 * width("AVATAR", sans)).abs() < 1e-9);
        assert_eq!(laid("A", wide).expansion, 1.5);
    }

    #[test]
    fn a_mark_shares_the_body_of_its_letter() {
        for font in [1, -4, -14, -21, -25, -34] {
            for path in [TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down] {
                for spacing in [0.0, 0.5] {
                    let style = TextStyle { font, path, spacing, ..TextStyle::default() };
                    let what = format!("font {font} {path:?} {spacing}");
                    let (plain, marked) = (laid("xqy", style), laid("xq\u{307}\u{323}y", style));
                    for (corner, expected) in marked.extent.into_iter().zip(plain.extent) {
                        assert!(corner.abs_diff_eq(expected, 1e-9), "{what}: {corner} is not {expected}");
                    }
                    let clusters: Vec<u32> = marked.glyphs.iter().map(|glyph| glyph.cluster).collect();
                    assert!(
                        clusters.is_sorted() && clusters[0] == 0 && clusters[clusters.len() - 1] == 6,
                        "{what}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_mark_stands_above_the_middle_of_its_letter() {
        let style = TextStyle { font: -4, ..TextStyle::default() };
        for (text, composed) in [("A\u{301}", "Á"), ("o\u{308}", "ö"), ("c\u{327}", "ç")] {
            let (out, whole) = (laid(text, style), laid(composed, style));
            let bounds = |placed: &PlacedGlyph| match placed.glyph {
                FaceGlyph::Stroke(glyph) => glyph.bounds.map(|corner| corner + placed.origin),
                FaceGlyph::Outline(..) => panic!("font -4 is strokes"),
            };
            let ([low, high], [low2, high2]) = (bounds(&out.glyphs[0]), bounds(&out.glyphs[1]));
            let [whole_low, whole_high] = bounds(&whole.glyphs[0]);
            assert!(low.min(low2).abs_diff_eq(whole_low, 1e-9), "{text}");
            assert!(high.max(high2).abs_diff_eq(whole_high, 1e-9), "{text}");
        }
    }

    #[test]
    fn text_laid_out_again_finds_its_buffers() {
        let mut out = Layout::default();
        for font in [1, -13, -21] {
            let style = TextStyle { font, ..TextStyle::default() };
            layout("Twenty characters ok", &style, &mut out);
            let before = (out.glyphs.as_ptr(), out.cells.as_ptr(), out.glyphs.capacity());
            for _ in 0..3 {
                layout("and these are others", &style, &mut out);
                assert_eq!(before, (out.glyphs.as_ptr(), out.cells.as_ptr(), out.glyphs.capacity()));
            }
        }
    }

    #[test]
    fn text_of_any_script_is_laid_out_in_the_order_of_the_string() {
        let mut out = Layout::default();
        let mut text = String::new();
        let mut codes = (0..0x3_0000_u32).step_by(7);
        let paths = [TextPath::Right, TextPath::Left, TextPath::Up, TextPath::Down];
        loop {
            text.clear();
            text.extend(codes.by_ref().take(61).filter_map(char::from_u32));
            if text.is_empty() {
                break;
            }
            for font in [1, -19, -21, -34] {
                for path in paths {
                    let style = TextStyle { font, path, ..TextStyle::default() };
                    layout(&text, &style, &mut out);
                    let clusters: Vec<u32> = out.glyphs.iter().map(|glyph| glyph.cluster).collect();
                    assert!(clusters.is_sorted(), "font {font} {path:?} {text:?} {clusters:?}");
                    for glyph in &out.glyphs {
                        assert!(text.is_char_boundary(glyph.cluster as usize));
                        assert!(glyph.origin.is_finite() && glyph.advance.is_finite());
                    }
                    assert!(out.extent.iter().all(|corner| corner.is_finite()));
                }
            }
        }
    }

    #[test]
    fn arabic_is_joined_on_the_path_it_is_written_along() {
        let style = TextStyle { font: -34, path: TextPath::Left, ..TextStyle::default() };
        let glyphs = |text| -> Vec<u16> {
            let numbers = laid(text, style).glyphs.into_iter().map(|placed| match placed.glyph {
                FaceGlyph::Outline(_, number) => number,
                FaceGlyph::Stroke(_) => panic!("font -34 is outlines"),
            });
            numbers.collect()
        };
        // Seen between seen and seen is the medial form, which a lone seen is not.
        let [alone, joined] = [glyphs("\u{633}"), glyphs("\u{633}\u{633}\u{633}")];
        assert_eq!(joined.len(), 3);
        assert!(joined.iter().all(|&form| form != alone[0]));
        assert!(joined[0] != joined[1] && joined[1] != joined[2] && joined[0] != joined[2]);
        // A Latin word beside Hebrew does not turn the line around.
        let out = laid("ab\u{5d3}\u{5da}", TextStyle { font: -21, ..style });
        assert!(out.glyphs.is_sorted_by(|a, b| a.cluster < b.cluster && a.origin.x > b.origin.x));
    }
}
