//! The demonstration picture: every primitive and attribute, the same on every device.

use gks::{Gks, Result};
use gks_pipeline::colour::Colour;
use gks_pipeline::look::{Cap, Horizontal, InteriorStyle, Join, Precision, TextPath, Vertical};
use std::f64::consts::{PI, TAU};

const SANS: i32 = -21;
const SANS_BOLD: i32 = -22;
const SANS_ITALIC: i32 = -23;

/// Colour indices of the palette, from [`palette`] on.
mod ink {
    pub(super) const PAPER: i32 = 0;
    pub(super) const TEXT: i32 = 1;
    pub(super) const BLUE: i32 = 20;
    pub(super) const ORANGE: i32 = 21;
    pub(super) const GREEN: i32 = 22;
    pub(super) const RED: i32 = 23;
    pub(super) const PURPLE: i32 = 24;
    pub(super) const GREY: i32 = 25;
    pub(super) const PALE: i32 = 26;
    pub(super) const GLASS: i32 = 27;
    /// First of [`RAMP`] colours from deep blue over white to deep red.
    pub(super) const RAMP: i32 = 100;
}

/// The number of colours of the ramp.
const RAMP: i32 = 24;

/// A panel of the picture, and its transformation number.
struct Panel {
    number: i32,
    x: f64,
    y: f64,
    w: f64,
    h: f64,
}

const PANEL_COLUMNS: usize = 3;

impl Panel {
    /// The panels lie in three columns below a heading.
    fn new(index: usize) -> Self {
        let (column, row) = (index % PANEL_COLUMNS, index / PANEL_COLUMNS);
        let (w, h) = (0.302, 0.198);
        Panel {
            number: index as i32 + 1,
            x: 0.027 + column as f64 * 0.322,
            y: 0.700 - row as f64 * 0.226,
            w,
            h,
        }
    }
}

/// Draws the picture on workstation `id`, which must be the active one.
pub fn draw(gks: &mut Gks, id: i32) -> Result<()> {
    palette(gks, id)?;
    heading(gks)?;
    type Content = fn(&mut Gks) -> Result<()>;
    let panels: [(&str, [f64; 4], Content); 12] = [
        ("POLYLINE: linetypes, widths, caps, joins", [0.0, 12.0, 0.0, 8.0], polylines),
        ("POLYMARKER: types and sizes", [0.0, 12.0, 0.0, 8.0], polymarkers),
        ("FILL AREA: hollow, solid, pattern, hatch", [0.0, 12.0, 0.0, 8.0], fill_areas),
        ("CELL ARRAY", [-3.0, 3.0, -2.0, 2.0], cell_array),
        ("TEXT: precision, path, alignment", [0.0, 12.0, 0.0, 8.0], text),
        ("TEXT: stroke and outline fonts", [0.0, 12.0, 0.0, 8.0], fonts),
        ("GDP: circles, arcs, ellipses", [0.0, 12.0, 0.0, 8.0], circles),
        ("GDP: Bezier curves and splines", [0.0, 12.0, 0.0, 8.0], curves),
        ("Clipping at the viewport", [-1.0, 1.0, -0.66, 0.66], clipping),
        ("World coordinates: a plot", [0.0, 10.0, -0.5, 1.1], plot),
        ("Normalization transformations", [0.0, 1.0, 0.0, 1.0], transformations),
        ("Opacity", [0.0, 12.0, 0.0, 8.0], opacity),
    ];
    for (index, (title, window, content)) in panels.into_iter().enumerate() {
        let panel = Panel::new(index);
        frame(gks, &panel, title)?;
        let [x0, x1, y0, y1] = window;
        gks.set_window(panel.number, gks_geometry::Rect::new(x0, x1, y0, y1))?;
        let (x, y) = (panel.x, panel.y);
        gks.set_viewport(panel.number, gks_geometry::Rect::new(x, x + panel.w, y, y + panel.h))?;
        gks.select_normalization_transformation(panel.number)?;
        content(gks)?;
        reset(gks)?;
    }
    Ok(())
}

/// Takes back what a panel changed.
fn reset(gks: &mut Gks) -> Result<()> {
    gks.select_normalization_transformation(0)?;
    gks.set_linetype(1)?;
    gks.set_linewidth_scale_factor(1.0)?;
    gks.set_line_cap(Cap::Butt)?;
    gks.set_line_join(Join::Miter)?;
    gks.set_marker_size_scale_factor(1.0)?;
    gks.set_character_expansion_factor(1.0)?;
    gks.set_character_spacing(0.0)?;
    gks.set_character_up_vector((0.0, 1.0))?;
    gks.set_text_path(TextPath::Right)?;
    gks.set_text_alignment(Horizontal::Normal, Vertical::Normal)
}

fn palette(gks: &mut Gks, id: i32) -> Result<()> {
    let mut set =
        |index: i32, r: f32, g: f32, b: f32| gks.set_colour_representation(id, index, Colour::rgb(r, g, b));
    set(ink::PAPER, 1.0, 1.0, 1.0)?;
    set(ink::TEXT, 0.13, 0.15, 0.18)?;
    set(ink::BLUE, 0.12, 0.40, 0.70)?;
    set(ink::ORANGE, 0.93, 0.52, 0.13)?;
    set(ink::GREEN, 0.20, 0.58, 0.36)?;
    set(ink::RED, 0.80, 0.19, 0.22)?;
    set(ink::PURPLE, 0.47, 0.30, 0.62)?;
    set(ink::GREY, 0.55, 0.58, 0.62)?;
    set(ink::PALE, 0.93, 0.94, 0.96)?;
    set(ink::GLASS, 0.12, 0.40, 0.70)?;
    for i in 0..RAMP {
        let t = 2.0 * i as f32 / (RAMP - 1) as f32 - 1.0;
        let fade = |v: f32| 1.0 - (1.0 - v) * t.abs();
        let (r, g, b) = if t < 0.0 { (0.08, 0.25, 0.55) } else { (0.70, 0.12, 0.14) };
        set(ink::RAMP + i, fade(r), fade(g), fade(b))?;
    }
    gks.set_colour_alpha(id, ink::GLASS, 0.45)
}

fn write(gks: &mut Gks, at: (f64, f64), height: f64, font: i32, colour: i32, text: &str) -> Result<()> {
    gks.set_text_font_and_precision(font, Precision::Stroke)?;
    gks.set_character_height(height)?;
    gks.set_text_colour_index(colour)?;
    gks.text(at, text)
}

fn heading(gks: &mut Gks) -> Result<()> {
    write(gks, (0.027, 0.948), 0.024, SANS_BOLD, ink::TEXT, "Graphical Kernel System")?;
    gks.set_text_alignment(Horizontal::Right, Vertical::Base)?;
    write(gks, (0.973, 0.948), 0.015, SANS_ITALIC, ink::GREY, "one program, every device")?;
    gks.set_text_alignment(Horizontal::Normal, Vertical::Normal)?;
    gks.set_polyline_colour_index(ink::BLUE)?;
    gks.set_linewidth_scale_factor(2.0)?;
    gks.polyline(&[(0.027, 0.933), (0.973, 0.933)])?;
    gks.set_linewidth_scale_factor(1.0)
}

fn frame(gks: &mut Gks, panel: &Panel, title: &str) -> Result<()> {
    let Panel { x, y, w, h, .. } = *panel;
    gks.set_polyline_colour_index(ink::GREY)?;
    gks.set_linewidth_scale_factor(0.7)?;
    gks.polyline(&[(x, y), (x + w, y), (x + w, y + h), (x, y + h), (x, y)])?;
    gks.set_linewidth_scale_factor(1.0)?;
    write(gks, (x, y + h + 0.0055), 0.0088, SANS, ink::TEXT, title)
}

fn polylines(gks: &mut Gks) -> Result<()> {
    for (i, linetype) in [1, 2, 3, 4, -1, -2].into_iter().enumerate() {
        let y = 7.3 - i as f64 * 0.62;
        gks.set_linetype(linetype)?;
        gks.set_polyline_colour_index([ink::TEXT, ink::BLUE, ink::GREEN][i % 3])?;
        gks.polyline(&[(0.5, y), (5.4, y)])?;
    }
    gks.set_linetype(1)?;
    for i in 0..6 {
        let y = 7.3 - f64::from(i) * 0.62;
        gks.set_linewidth_scale_factor([0.5, 1.0, 2.0, 4.0, 6.0, 9.0][i as usize])?;
        gks.set_polyline_colour_index(ink::ORANGE)?;
        gks.polyline(&[(6.6, y), (11.5, y)])?;
    }
    let ends = [(Cap::Butt, Join::Miter), (Cap::Round, Join::Round), (Cap::Projecting, Join::Bevel)];
    for (i, (cap, join)) in ends.into_iter().enumerate() {
        let x = 1.0 + i as f64 * 3.7;
        let corner = [(x, 0.9), (x + 1.3, 2.7), (x + 2.6, 0.9)];
        gks.set_line_cap(cap)?;
        gks.set_line_join(join)?;
        gks.set_linewidth_scale_factor(12.0)?;
        gks.set_polyline_colour_index(ink::PURPLE)?;
        gks.polyline(&corner)?;
        gks.set_linewidth_scale_factor(1.0)?;
        gks.set_polyline_colour_index(ink::PAPER)?;
        gks.polyline(&corner)?;
    }
    Ok(())
}

fn polymarkers(gks: &mut Gks) -> Result<()> {
    let kinds = [1, 2, 3, 4, 5, -1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12];
    let colours = [ink::TEXT, ink::BLUE, ink::ORANGE, ink::GREEN, ink::RED, ink::PURPLE];
    gks.set_marker_size_scale_factor(2.2)?;
    for (i, kind) in kinds.into_iter().enumerate() {
        gks.set_marker_type(kind)?;
        gks.set_polymarker_colour_index(colours[i % colours.len()])?;
        gks.polymarker(&[(1.1 + (i % 6) as f64 * 1.95, 6.9 - (i / 6) as f64 * 1.5)])?;
    }
    for i in 0..9 {
        gks.set_marker_type(4)?;
        gks.set_marker_size_scale_factor(0.5 + f64::from(i) * 0.45)?;
        gks.set_polymarker_colour_index(ink::BLUE)?;
        gks.polymarker(&[(1.0 + f64::from(i) * 1.25, 1.6)])?;
    }
    Ok(())
}

fn fill_areas(gks: &mut Gks) -> Result<()> {
    let polygon = |x: f64, y: f64, r: f64, n: u32, inner: f64| -> Vec<(f64, f64)> {
        let radius = |i: u32| if i.is_multiple_of(2) { r } else { r * inner };
        (0..2 * n)
            .map(|i| {
                let t = PI / 2.0 + PI * f64::from(i) / f64::from(n);
                (x + radius(i) * t.cos(), y + radius(i) * t.sin())
            })
            .collect()
    };
    gks.set_pattern_size(0.8, 0.8)?;
    let styles = [
        (InteriorStyle::Hollow, 1, ink::TEXT),
        (InteriorStyle::Solid, 1, ink::ORANGE),
        (InteriorStyle::Pattern, 1, ink::TEXT),
        (InteriorStyle::Pattern, 3, ink::TEXT),
        (InteriorStyle::Hatch, -1, ink::BLUE),
        (InteriorStyle::Hatch, -3, ink::GREEN),
        (InteriorStyle::Hatch, -5, ink::RED),
        (InteriorStyle::Hatch, -12, ink::PURPLE),
    ];
    for (i, (style, index, colour)) in styles.into_iter().enumerate() {
        gks.set_fill_area_interior_style(style)?;
        gks.set_fill_area_style_index(index)?;
        gks.set_fill_area_colour_index(colour)?;
        let (x, y) = (1.6 + (i % 4) as f64 * 2.93, 6.0 - (i / 4) as f64 * 3.8);
        gks.fill_area(&polygon(x, y, 1.3, 3 + i as u32, 0.62))?;
    }
    Ok(())
}

fn cell_array(gks: &mut Gks) -> Result<()> {
    let (columns, rows) = (60, 40);
    let mut indices = Vec::with_capacity(columns * rows);
    for row in 0..rows {
        for column in 0..columns {
            let x = -2.9 + 5.8 * (column as f64 + 0.5) / columns as f64;
            let y = -1.9 + 3.8 * (row as f64 + 0.5) / rows as f64;
            let v = 3.2 * x * (-x * x - y * y).exp() * (1.0 + 0.3 * (3.0 * y).sin());
            let step = ((v * 0.5 + 0.5) * f64::from(RAMP)).floor();
            indices.push(ink::RAMP + (step as i32).clamp(0, RAMP - 1));
        }
    }
    gks.cell_array_of((-2.9, -1.9), (2.9, 1.9), &indices, columns, rows, columns)
}

fn text(gks: &mut Gks) -> Result<()> {
    gks.set_text_alignment(Horizontal::Left, Vertical::Base)?;
    for (i, precision) in [Precision::String, Precision::Char, Precision::Stroke].into_iter().enumerate() {
        gks.set_text_font_and_precision(SANS, precision)?;
        gks.set_text_colour_index(ink::TEXT)?;
        gks.set_character_height(0.45)?;
        gks.text((0.5, 7.1 - i as f64 * 0.75), ["STRING", "CHAR", "STROKE"][i])?;
    }
    write(gks, (0.5, 4.7), 0.45, 1, ink::BLUE, "monospaced")?;
    gks.set_character_expansion_factor(1.6)?;
    write(gks, (0.5, 3.8), 0.45, SANS, ink::GREEN, "wide")?;
    gks.set_character_expansion_factor(0.6)?;
    write(gks, (3.0, 3.8), 0.45, SANS, ink::GREEN, "narrow")?;
    gks.set_character_expansion_factor(1.0)?;
    gks.set_character_spacing(0.5)?;
    write(gks, (0.5, 2.9), 0.45, SANS, ink::ORANGE, "spaced")?;
    gks.set_character_spacing(0.0)?;
    gks.set_text_alignment(Horizontal::Normal, Vertical::Normal)?;
    for (path, at, text) in [
        (TextPath::Down, (5.6, 7.3), "DOWN"),
        (TextPath::Up, (6.4, 4.5), "UP"),
        (TextPath::Left, (11.5, 7.0), "TFEL"),
    ] {
        gks.set_text_path(path)?;
        write(gks, at, 0.45, SANS_BOLD, ink::PURPLE, text)?;
    }
    gks.set_text_path(TextPath::Right)?;
    gks.set_text_alignment(Horizontal::Left, Vertical::Half)?;
    for i in 0..9 {
        let t = PI * (f64::from(i) / 8.0 - 0.5);
        gks.set_character_up_vector((-t.sin(), t.cos()))?;
        write(gks, (8.2 + 1.0 * t.cos(), 3.6 + 1.0 * t.sin()), 0.32, SANS, ink::TEXT, "rotated")?;
    }
    gks.set_character_up_vector((0.0, 1.0))?;
    gks.set_marker_type(2)?;
    gks.set_polymarker_colour_index(ink::RED)?;
    let columns = [Horizontal::Left, Horizontal::Centre, Horizontal::Right];
    for (i, horizontal) in columns.into_iter().enumerate() {
        gks.set_text_alignment(horizontal, Vertical::Base)?;
        let at = (1.2 + i as f64 * 2.6, 0.8);
        write(gks, at, 0.45, SANS, ink::TEXT, "align")?;
        gks.polymarker(&[at])?;
    }
    Ok(())
}

fn fonts(gks: &mut Gks) -> Result<()> {
    gks.set_text_alignment(Horizontal::Left, Vertical::Base)?;
    let strokes = [
        (-4, "Simplex Roman"),
        (-12, "Duplex Roman"),
        (-7, "Complex Roman"),
        (-10, "Complex Italic"),
        (-13, "Triplex Roman"),
        (-6, "Simplex Script"),
        (-16, "Gothic English"),
        (-8, "Ellhnika"),
    ];
    for (i, (font, text)) in strokes.into_iter().enumerate() {
        write(gks, (0.4, 7.2 - i as f64 * 0.93), 0.43, font, ink::BLUE, text)?;
    }
    let outlines = [
        (-21, "Sans Åé ß"),
        (-22, "Sans Bold"),
        (-25, "Serif Ωλπ"),
        (-27, "Serif Italic"),
        (-29, "Mono 0123"),
        (-33, "∫ f(x) ∂x ≤ ∞"),
        (-34, "★ ☂ ♞ ✈ ♫"),
        (-26, "Serif Bold Жд"),
    ];
    for (i, (font, text)) in outlines.into_iter().enumerate() {
        write(gks, (6.9, 7.2 - i as f64 * 0.93), 0.43, font, ink::TEXT, text)?;
    }
    Ok(())
}

fn circles(gks: &mut Gks) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_fill_area_colour_index(ink::PALE)?;
    gks.circle((2.2, 5.8), (3.8, 5.8))?;
    gks.set_fill_area_interior_style(InteriorStyle::Hollow)?;
    gks.set_fill_area_colour_index(ink::BLUE)?;
    gks.circle((2.2, 5.8), (3.8, 5.8))?;
    gks.set_fill_area_interior_style(InteriorStyle::Hatch)?;
    gks.set_fill_area_style_index(-3)?;
    gks.circle((2.2, 5.8), (3.1, 5.8))?;
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    let (cx, cy, r) = (6.2, 5.6, 1.7);
    let mut from = 0.25;
    for (share, colour) in [(0.42, ink::BLUE), (0.25, ink::ORANGE), (0.2, ink::GREEN), (0.13, ink::RED)] {
        let at = |t: f64| (cx + r * (TAU * t).cos(), cy + r * (TAU * t).sin());
        gks.set_fill_area_colour_index(colour)?;
        gks.pie(at(from), at(from + share / 2.0), at(from + share))?;
        from += share;
    }
    gks.set_fill_area_colour_index(ink::PURPLE)?;
    gks.chord((8.9, 5.0), (10.2, 7.1), (11.5, 5.0))?;
    gks.set_fill_area_colour_index(ink::ORANGE)?;
    gks.ellipse((3.0, 1.9), (5.0, 2.9), (2.4, 2.9))?;
    for i in 0..5 {
        let r = 0.5 + f64::from(i) * 0.3;
        gks.set_polyline_colour_index(ink::GREEN)?;
        gks.set_linewidth_scale_factor(1.0 + f64::from(i) * 0.5)?;
        gks.arc((8.5 - r, 1.0), (8.5, 1.0 + r), (8.5 + r, 1.0))?;
    }
    Ok(())
}

fn curves(gks: &mut Gks) -> Result<()> {
    let control = [(0.7, 4.9), (1.6, 7.6), (4.4, 3.9), (5.5, 7.3)];
    gks.set_linetype(3)?;
    gks.set_polyline_colour_index(ink::GREY)?;
    gks.polyline(&control)?;
    gks.set_linetype(1)?;
    gks.set_linewidth_scale_factor(2.5)?;
    gks.set_polyline_colour_index(ink::BLUE)?;
    gks.bezier(&control)?;
    let through = [(6.6, 4.9), (7.5, 6.9), (8.6, 5.0), (9.6, 7.0), (10.6, 5.6), (11.4, 6.9)];
    gks.set_polyline_colour_index(ink::GREEN)?;
    gks.spline(&through, false)?;
    gks.set_marker_type(-9)?;
    gks.set_polymarker_colour_index(ink::TEXT)?;
    gks.polymarker(&through)?;
    gks.polymarker(&control)?;
    let ring: Vec<(f64, f64)> = (0..10)
        .map(|i| {
            let t = TAU * f64::from(i) / 10.0;
            let r = if i % 2 == 0 { 1.5 } else { 1.0 };
            (6.0 + 3.0 * r * t.cos(), 2.1 + r * t.sin())
        })
        .collect();
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_fill_area_colour_index(ink::PALE)?;
    gks.spline(&ring, true)?;
    gks.set_fill_area_interior_style(InteriorStyle::Hollow)?;
    gks.set_fill_area_colour_index(ink::PURPLE)?;
    gks.spline(&ring, true)
}

fn clipping(gks: &mut Gks) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    for i in 0..18 {
        let (a, b) = (TAU * f64::from(i) / 18.0, TAU * (f64::from(i) + 0.5) / 18.0);
        gks.set_fill_area_colour_index(ink::RAMP + (i % 9) * 2 + 3)?;
        gks.fill_area(&[(0.0, 0.0), (2.0 * a.cos(), 2.0 * a.sin()), (2.0 * b.cos(), 2.0 * b.sin())])?;
    }
    gks.set_polyline_colour_index(ink::TEXT)?;
    for i in 1..9 {
        let r = f64::from(i) * 0.17;
        let ring: Vec<(f64, f64)> =
            (0..=90).map(|k| TAU * f64::from(k) / 90.0).map(|t| (r * t.cos(), r * t.sin())).collect();
        gks.polyline(&ring)?;
    }
    gks.set_text_alignment(Horizontal::Centre, Vertical::Half)?;
    write(gks, (0.0, 0.0), 0.30, SANS_BOLD, ink::TEXT, "CLIPPED TEXT")
}

fn plot(gks: &mut Gks) -> Result<()> {
    gks.set_polyline_colour_index(ink::GREY)?;
    gks.set_linewidth_scale_factor(0.7)?;
    for i in 0..=4 {
        let y = f64::from(i) * 0.25;
        gks.set_linetype(if i == 0 { 1 } else { 3 })?;
        gks.polyline(&[(0.6, y), (9.8, y)])?;
    }
    gks.set_linetype(1)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Top)?;
    for i in 0..=9 {
        let x = 0.6 + f64::from(i);
        gks.polyline(&[(x, 0.0), (x, -0.04)])?;
        // Text in a window that is not square is stretched with it: here it is three times as tall as wide.
        gks.set_character_expansion_factor(4.2)?;
        write(gks, (x, -0.08), 0.055, SANS, ink::TEXT, &i.to_string())?;
    }
    gks.set_linewidth_scale_factor(2.0)?;
    let wave = |x: f64| (-(x - 0.6) * 0.28).exp() * (2.6 * (x - 0.6)).cos().abs();
    let curve: Vec<(f64, f64)> =
        (0..=400).map(|i| 0.6 + 9.2 * f64::from(i) / 400.0).map(|x| (x, wave(x))).collect();
    gks.set_polyline_colour_index(ink::BLUE)?;
    gks.polyline(&curve)?;
    gks.set_marker_type(-9)?;
    gks.set_polymarker_colour_index(ink::ORANGE)?;
    let samples: Vec<(f64, f64)> = curve.iter().copied().step_by(20).collect();
    gks.polymarker(&samples)
}

fn transformations(gks: &mut Gks) -> Result<()> {
    let house = [(0.2, 0.1), (0.8, 0.1), (0.8, 0.6), (0.5, 0.9), (0.2, 0.6)];
    let panel = Panel::new(10);
    let places = [
        (0.02, 0.05, 0.28, 0.90, ink::BLUE),
        (0.33, 0.05, 0.64, 0.38, ink::GREEN),
        (0.33, 0.50, 0.30, 0.45, ink::ORANGE),
        (0.67, 0.50, 0.30, 0.45, ink::RED),
    ];
    for (i, (x, y, w, h, colour)) in places.into_iter().enumerate() {
        let number = 20 + i as i32;
        let (x, y) = (panel.x + x * panel.w, panel.y + y * panel.h);
        gks.set_viewport(number, gks_geometry::Rect::new(x, x + w * panel.w, y, y + h * panel.h))?;
        // The last one shows a part of the house, enlarged.
        let (low, high) = if i == 3 { (0.25, 0.75) } else { (0.0, 1.0) };
        gks.set_window(number, gks_geometry::Rect::new(low, high, low, high))?;
        gks.select_normalization_transformation(number)?;
        gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
        gks.set_fill_area_colour_index(ink::PALE)?;
        gks.fill_area(&[(low, low), (high, low), (high, high), (low, high)])?;
        gks.set_fill_area_colour_index(colour)?;
        gks.fill_area(&house)?;
        gks.set_fill_area_colour_index(ink::PAPER)?;
        gks.circle((0.5, 0.55), (0.6, 0.55))?;
        gks.set_text_alignment(Horizontal::Centre, Vertical::Base)?;
        write(gks, (0.5, 0.29), 0.12, SANS_BOLD, ink::PAPER, "GKS")?;
    }
    Ok(())
}

fn opacity(gks: &mut Gks) -> Result<()> {
    gks.set_fill_area_interior_style(InteriorStyle::Solid)?;
    gks.set_text_alignment(Horizontal::Centre, Vertical::Half)?;
    write(gks, (6.0, 4.0), 1.6, SANS_BOLD, ink::ORANGE, "GLASS")?;
    gks.set_fill_area_colour_index(ink::GLASS)?;
    gks.circle((4.6, 4.0), (7.2, 4.0))?;
    gks.circle((7.4, 4.0), (10.0, 4.0))?;
    gks.set_polyline_colour_index(ink::GLASS)?;
    gks.set_linewidth_scale_factor(14.0)?;
    gks.set_line_join(Join::Round)?;
    let zigzag: Vec<(f64, f64)> =
        (0..12).map(|i| (0.7 + f64::from(i) * 0.97, if i % 2 == 0 { 1.0 } else { 6.9 })).collect();
    gks.polyline(&zigzag)
}
