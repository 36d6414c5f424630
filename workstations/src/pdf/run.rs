//! How the characters of a run follow one another, for formats whose readers advance by the width of each.

use gks_pipeline::device::GlyphRun;
use glam::DVec2;

/// How far a character may be off, in points, before it is placed anew.
const TOLERANCE: f64 = 0.005;

/// The parts of an em in which gaps are counted.
pub(crate) const GAPS: f64 = 10_000.0;

/// What a reader does next to show a run.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) enum Step {
    /// Starts a line of characters at a position in device units.
    Line(DVec2),
    /// Moves along the base line, by ten-thousandths of an em.
    Gap(i64),
    /// Shows the character with this position in the run and advances by its width.
    Show(usize),
}

/// The steps that show a run; none where its characters are flat.
///
/// A character that follows its predecessor on the base line, however far, stays on the line; any other starts
/// one. Gaps are measured from where the reader is, so that their rounding does not add up.
pub(crate) fn steps(run: &GlyphRun<'_>, mut take: impl FnMut(Step)) {
    let (x, y) = (run.x.0, run.y.0);
    let det = x.perp_dot(y);
    if det == 0.0 || !det.is_finite() {
        return;
    }
    // Distances along and across the base line, in em, are allowed what the tolerance is in points.
    let along = TOLERANCE / x.length();
    let across = TOLERANCE / y.length();
    let mut line: Option<(DVec2, f64)> = None;
    for (i, glyph) in run.glyphs.iter().enumerate() {
        let origin = glyph.origin.0;
        if !origin.is_finite() {
            continue;
        }
        let follows = line.and_then(|(start, reached)| {
            let d = origin - start;
            let (u, v) = (d.perp_dot(y) / det, x.perp_dot(d) / det);
            (v.abs() <= across).then_some((start, reached, u - reached))
        });
        let (start, mut reached) = match follows {
            Some((start, reached, gap)) if gap.abs() <= along => (start, reached),
            Some((start, reached, gap)) if gap.abs() < 1e4 => {
                let counts = (gap * GAPS).round();
                take(Step::Gap(counts as i64));
                (start, reached + counts / GAPS)
            }
            _ => {
                take(Step::Line(origin));
                (origin, 0.0)
            }
        };
        take(Step::Show(i));
        reached += run.face.advance(glyph.id);
        line = Some((start, reached));
    }
}

/// The characters of the text that a glyph of a run shows; none for a glyph that shows a character together
/// with its predecessor.
pub(crate) fn shown<'a>(run: &GlyphRun<'a>, index: usize) -> &'a str {
    let cluster = |i: usize| run.glyphs.get(i).map(|glyph| glyph.cluster as usize);
    let Some(start) = cluster(index) else { return "" };
    if index > 0 && cluster(index - 1) == Some(start) {
        return "";
    }
    let later = run.glyphs[index..].iter().map(|glyph| glyph.cluster as usize).find(|&at| at != start);
    run.text.get(start..later.unwrap_or(run.text.len())).unwrap_or("")
}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::{Point, Vector};
    use gks_pipeline::colour::{Colour, Paint};
    use gks_pipeline::device::Glyph;
    use gks_pipeline::font::{Face, OutlineFace, face};

    fn sans() -> &'static OutlineFace {
        let Some(Face::Outline(face)) = face(-21) else { panic!("font -21 is an outline face") };
        face
    }

    /// The steps of a run of text whose characters are placed by `at` from their natural position in em.
    fn of(text: &str, x: DVec2, y: DVec2, at: impl Fn(usize, f64) -> DVec2) -> Vec<Step> {
        let face = sans();
        let mut natural = 0.0;
        let glyphs: Vec<Glyph> = text
            .char_indices()
            .map(|(i, c)| {
                let id = face.glyph_id(c).unwrap();
                let p = at(i, natural);
                natural += face.advance(id);
                let origin = Point::from_vec(DVec2::new(100.0, 200.0) + x * p.x + y * p.y);
                Glyph { id, cluster: i as u32, origin }
            })
            .collect();
        let paint = Paint { colour: Colour::BLACK, index: 1 };
        let (x, y) = (Vector::from_vec(x), Vector::from_vec(y));
        let mut all = Vec::new();
        steps(&GlyphRun { text, face, glyphs: &glyphs, x, y, paint }, |step| all.push(step));
        all
    }

    const ORIGIN: Step = Step::Line(DVec2::new(100.0, 200.0));

    #[test]
    fn natural_text_needs_no_gaps_even_where_it_leans() {
        let expected = [&[ORIGIN][..], &(0..9).map(Step::Show).collect::<Vec<_>>()].concat();
        let natural = |_, u| DVec2::new(u, 0.0);
        assert_eq!(of("Minor axe", DVec2::new(12.0, 0.0), DVec2::new(0.0, 12.0), natural), expected);
        assert_eq!(of("Minor axe", DVec2::new(-3.0, 8.0), DVec2::new(-20.0, 1.0), natural), expected);
        assert_eq!(of("Minor axe", DVec2::new(3.0, 6.0), DVec2::new(1.0, 2.0), natural), []);
        assert_eq!(of("Minor axe", DVec2::NAN, DVec2::Y, natural), []);
    }

    #[test]
    fn gaps_do_not_add_up() {
        let spaced = |i: usize, u: f64| DVec2::new(u + 0.123_456_78 * i as f64, 0.0);
        let all = of(&"x".repeat(1000), DVec2::new(50.0, 0.0), DVec2::new(0.0, 50.0), spaced);
        let sum: i64 = all.iter().map(|step| if let Step::Gap(gap) = step { *gap } else { 0 }).sum();
        assert!((sum as f64 / GAPS - 0.123_456_78 * 999.0).abs() < 1.5 / GAPS, "{sum}");
        assert_eq!(all.iter().filter(|step| matches!(step, Step::Line(_))).count(), 1);
    }

    #[test]
    fn characters_below_one_another_are_lines() {
        let down = |i: usize, _| DVec2::new(0.0, -1.5 * i as f64);
        let all = of("ab", DVec2::new(10.0, 0.0), DVec2::new(0.0, 10.0), down);
        assert_eq!(all, [ORIGIN, Step::Show(0), Step::Line(DVec2::new(100.0, 185.0)), Step::Show(1)]);
    }

    #[test]
    fn glyphs_know_their_characters() {
        let paint = Paint { colour: Colour::BLACK, index: 1 };
        let glyph = |cluster| Glyph { id: 3, cluster, origin: Point::new(0.0, 0.0) };
        let glyphs = [glyph(0), glyph(2), glyph(2), glyph(5), glyph(90)];
        let (x, y) = (Vector::new(1.0, 0.0), Vector::new(0.0, 1.0));
        let run = GlyphRun { text: "äfiñ", face: sans(), glyphs: &glyphs, x, y, paint };
        let all: Vec<&str> = (0..6).map(|i| shown(&run, i)).collect();
        assert_eq!(all, ["ä", "", "", "", "", ""]);
        let glyphs = [glyph(0), glyph(2), glyph(2), glyph(4)];
        let run = GlyphRun { glyphs: &glyphs, ..run };
        let all: Vec<&str> = (0..4).map(|i| shown(&run, i)).collect();
        assert_eq!(all, ["ä", "fi", "", "ñ"]);
    }
}
