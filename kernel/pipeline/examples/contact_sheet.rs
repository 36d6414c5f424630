//! Writes a contact sheet of the faces as SVG: `contact_sheet [FILE] [FONT NUMBER]...`.
//!
//! Without font numbers all faces are shown. Standard output is used without a file name.

use gks_pipeline::font::{FaceGlyph, Layout, TextStyle, Verb, face, layout, numbers};
use std::fmt::Write as _;

const LINES: [&str; 9] = [
    "ABCDEFGHIJKLMNOPQRSTUVWXYZ 0123456789",
    "abcdefghijklmnopqrstuvwxyz AVAToWe fiffl",
    "!\"#$%&'()*+,-./ :;<=>?@ [\\]^_` {|}~",
    "¡¢£¤¥¦§¨©ª«¬®¯°±²³´µ¶·¸¹º»¼½¾¿×÷",
    "ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÐÑÒÓÔÕÖØÙÚÛÜÝÞß",
    "àáâãäåæçèéêëìíîïðñòóôõöøùúûüýþÿ",
    "ĄąĆćĈĐđĎďĢģĦħĪĲĳĶķĹĽľŁłŃŊŋŐŒœŘřŠşȚŤťŪůŴŶŻžſe\u{301}q\u{308}I\u{302}",
    "ΑΒΓΔΘΛΞΠΣΦΨΩ αβγδεζηθικλμνξοπρσςτυφχψω Άέ БЖЯ бжяёїєґ",
    "€“”„…–—•™′‰ ±≤≥≠≈∞∂∑∏√∫∇→←↑↓∴♂♀♠♥♦♣★☃😀",
];

fn main() -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next();
    let chosen: Vec<i32> = arguments.filter_map(|number| number.parse().ok()).collect();
    let chosen = if chosen.is_empty() { numbers() } else { &chosen };
    let size = if chosen.len() == 1 { 32.0 } else { 16.0 };
    let line_height = 2.1 * size;
    let block = line_height * (LINES.len() as f64 + 0.8);
    let mut svg = String::new();
    let mut out = Layout::default();
    for (place, &number) in chosen.iter().enumerate() {
        let Some(face) = face(number) else { continue };
        let top = place as f64 * block;
        let _ = writeln!(
            svg,
            r##"<text x="4" y="{}" font-size="11" fill="#c00">{number} {}</text>"##,
            top + 12.0,
            face.name()
        );
        for (line, text) in LINES.iter().enumerate() {
            layout(text, &TextStyle { font: number, ..TextStyle::default() }, &mut out);
            let (x0, y0) = (20.0, top + line_height * (line as f64 + 1.3));
            let [low, _, high, _] = out.extent.map(|corner| (x0 + size * corner.x, y0 - size * corner.y));
            let _ =
                writeln!(svg, r##"<path d="M{},{y0}H{}" stroke="#ddf" stroke-width=".5"/>"##, low.0, high.0);
            let (mut lines, mut areas) = (String::new(), String::new());
            for placed in &out.glyphs {
                let at = |x: f64, y: f64| {
                    format!(
                        "{:.2},{:.2}",
                        x0 + size * (placed.origin.x + out.expansion * x),
                        y0 - size * (placed.origin.y + y)
                    )
                };
                match placed.glyph {
                    FaceGlyph::Stroke(glyph) => {
                        for stroke in glyph.strokes() {
                            for (index, point) in stroke.iter().enumerate() {
                                let _ = write!(
                                    lines,
                                    "{}{} ",
                                    if index == 0 { 'M' } else { 'L' },
                                    at(point.x, point.y)
                                );
                            }
                        }
                    }
                    FaceGlyph::Outline(face, glyph) => {
                        let em = face.em();
                        for verb in &face.outline(glyph).verbs {
                            let _ = match *verb {
                                Verb::Move(p) => write!(areas, "M{} ", at(p.x * em, p.y * em)),
                                Verb::Line(p) => write!(areas, "L{} ", at(p.x * em, p.y * em)),
                                Verb::Quad(c, p) => {
                                    write!(areas, "Q{} {} ", at(c.x * em, c.y * em), at(p.x * em, p.y * em))
                                }
                                Verb::Cubic(a, b, p) => write!(
                                    areas,
                                    "C{} {} {} ",
                                    at(a.x * em, a.y * em),
                                    at(b.x * em, b.y * em),
                                    at(p.x * em, p.y * em)
                                ),
                                Verb::Close => write!(areas, "Z "),
                            };
                        }
                    }
                }
            }
            if !lines.is_empty() {
                let _ = writeln!(
                    svg,
                    r#"<path d="{lines}" fill="none" stroke="black" stroke-width=".8" stroke-linecap="round" stroke-linejoin="round"/>"#
                );
            }
            if !areas.is_empty() {
                let _ = writeln!(svg, r#"<path d="{areas}"/>"#);
            }
        }
    }
    let height = block * chosen.len() as f64;
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{height}\"><rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{svg}</svg>\n",
        60.0 * size
    );
    match file {
        Some(file) => std::fs::write(file, svg),
        None => {
            print!("{svg}");
            Ok(())
        }
    }
}
