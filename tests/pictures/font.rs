//! Fonts.

use gks::{Gks, Result};
use gks_pipeline::generated::numbers::{FONTS, Font};
use gks_pipeline::look::Precision;

fn table(gks: &mut Gks, fonts: &[&Font], columns: usize, text: &str) -> Result<()> {
    let rows = fonts.len().div_ceil(columns);
    for (i, font) in fonts.iter().enumerate() {
        let (column, row) = (i / rows, i % rows);
        gks.set_text_font_and_precision(font.number, Precision::Stroke)?;
        let x = 0.03 + 0.96 * column as f64 / columns as f64;
        let y = 0.94 - 0.94 * row as f64 / rows as f64;
        gks.text((x, y), text)?;
    }
    Ok(())
}

/// Every stroke font.
pub fn strokes(gks: &mut Gks, _ws: i32) -> Result<()> {
    let fonts: Vec<&Font> = FONTS.iter().filter(|font| !font.outline).collect();
    gks.set_character_height(0.03)?;
    table(gks, &fonts, 2, "Quick fox 1984")
}

/// Every outline font.
pub fn outlines(gks: &mut Gks, _ws: i32) -> Result<()> {
    let fonts: Vec<&Font> = FONTS.iter().filter(|font| font.outline).collect();
    gks.set_character_height(0.035)?;
    table(gks, &fonts, 2, "Quick fox 1984")
}

/// Scripts other than Latin, letters with marks, ligatures, symbols.
pub fn scripts(gks: &mut Gks, _ws: i32) -> Result<()> {
    gks.set_character_height(0.04)?;
    let lines = [
        (-21, "Größe, naïve, Ångström, œuvre"),
        (-25, "Ελληνικά: αβγδε ΩΨΦ"),
        (-22, "Кириллица: жщъыэюя"),
        (-21, "e\u{301}a\u{308}o\u{302} combined"),
        (-34, "العربية سلام"),
        (-34, "עברית שלום"),
        (-33, "∫ f(x) dx ≤ ∑ √n ± ∞"),
        (-34, "★ ☂ ♞ ✈ ♫ → ⇒ ■ ●"),
        (-27, "office, fluff, WAVE To. Ty"),
        (-4, "Stroke: Größe naïve ½ ±"),
    ];
    for (i, (font, text)) in lines.into_iter().enumerate() {
        gks.set_text_font_and_precision(font, Precision::Stroke)?;
        gks.text((0.04, 0.92 - 0.095 * i as f64), text)?;
    }
    Ok(())
}
