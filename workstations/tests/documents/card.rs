//! A test card: every form of mark, at known places of an A4 page.

use gks_geometry::{Du, Paths, Point, Rect, Vector};
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::device::*;
use gks_pipeline::font::{Face, OutlineFace, face};
use gks_pipeline::item::{Closure, Curve, Ellipse, Parallelogram};
use gks_pipeline::look::{Cap, Join};
use glam::DVec2;

/// The paint of a colour.
pub(crate) fn paint(red: f32, green: f32, blue: f32) -> Paint {
    Paint { colour: Colour::rgb(red, green, blue), index: 1 }
}

/// The same with an opacity.
pub(crate) fn translucent(paint: Paint, alpha: f32) -> Paint {
    Paint { colour: Colour { alpha, ..paint.colour }, ..paint }
}

/// A solid black pen.
pub(crate) fn pen(width: f64) -> Pen<'static> {
    Pen { paint: paint(0.0, 0.0, 0.0), width, dash: &[], cap: Cap::Butt, join: Join::Miter }
}

/// The page that a test begins with.
pub(crate) fn page(number: u32) -> Page {
    Page { number, background: Colour::WHITE, colours: Vec::new() }
}

/// Draws a form without a clipping rectangle, which may not be refused.
pub(crate) fn draw(device: &mut dyn Device, form: Form<'_>) {
    clipped(device, form, None);
}

/// Draws a form, which may not be refused.
pub(crate) fn clipped(device: &mut dyn Device, form: Form<'_>, clip: Option<Rect<Du>>) {
    let mark = Mark { form, clip };
    assert_eq!(device.draw(&mark).unwrap(), Drawn::Yes, "refused: {:?}", mark.form);
}

/// One path as a set.
pub(crate) fn lines(device: &mut dyn Device, points: &[(f64, f64)], pen: Pen<'_>) {
    let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    draw(device, Form::Lines(Paths::new(&points, &[points.len() as u32]), pen));
}

/// A leaning elliptic arc.
pub(crate) fn ellipse(x: f64, y: f64, start: f64, sweep: f64, closure: Closure) -> Curve<'static, Du> {
    let (a, b) = (Vector::new(40.0, 10.0), Vector::new(-5.0, 25.0));
    Curve::Ellipse(Ellipse { centre: Point::new(x, y), a, b, start, sweep, closure })
}

/// The parallelogram with a corner and two edges.
pub(crate) fn place(origin: (f64, f64), columns: (f64, f64), rows: (f64, f64)) -> Parallelogram<Du> {
    Parallelogram { origin: origin.into(), columns: columns.into(), rows: rows.into() }
}

/// Draws all forms but text.
pub(crate) fn card(device: &mut dyn Device) {
    let red = paint(1.0, 0.0, 0.0);
    let green = paint(0.0, 0.6, 0.0);
    let blue = paint(0.0, 0.0, 1.0);
    let zigzag = |y: f64| [(40.0, y), (100.0, y + 30.0), (120.0, y), (200.0, y)];
    for (i, (cap, join)) in
        [(Cap::Butt, Join::Miter), (Cap::Round, Join::Round), (Cap::Projecting, Join::Bevel)]
            .into_iter()
            .enumerate()
    {
        lines(device, &zigzag(780.0 - 50.0 * i as f64), Pen { cap, join, paint: blue, ..pen(8.0) });
    }
    let dash = [12.0, 4.0, 2.0, 4.0];
    lines(device, &zigzag(630.0), Pen { dash: &dash, paint: red, ..pen(3.0) });
    for i in 0..5 {
        lines(
            device,
            &[(50.0 + 30.0 * f64::from(i), 600.0)],
            Pen { paint: green, ..pen(3.0 * f64::from(i + 1)) },
        );
    }
    let star: Vec<DVec2> = (0..5)
        .map(|i| DVec2::from_angle(f64::from(i) * 2.513_274) * 45.0 + DVec2::new(300.0, 770.0))
        .collect();
    draw(device, Form::Area(Paths::new(&star, &[5]), Rule::EvenOdd, Fill::Solid(red)));
    let moved: Vec<DVec2> = star.iter().map(|p| *p + DVec2::new(100.0, 0.0)).collect();
    draw(device, Form::Area(Paths::new(&moved, &[5]), Rule::NonZero, Fill::Solid(blue)));
    let curves = [
        (1.0, -2.0, Closure::Full),
        (0.5, 4.0, Closure::Open),
        (0.5, 4.0, Closure::Chord),
        (0.5, 4.0, Closure::Pie),
    ];
    for (i, (start, sweep, closure)) in curves.into_iter().enumerate() {
        let y = 680.0 - 70.0 * i as f64;
        draw(
            device,
            Form::Stroke(
                ellipse(300.0, y, start, sweep, closure),
                Pen { dash: if i == 0 { &dash } else { &[] }, ..pen(2.0) },
            ),
        );
        draw(device, Form::Filled(ellipse(400.0, y, start, sweep, closure), green));
    }
    let chain = [
        (460.0, 480.0),
        (460.0, 560.0),
        (560.0, 560.0),
        (560.0, 480.0),
        (560.0, 400.0),
        (480.0, 400.0),
        (520.0, 540.0),
    ]
    .map(|(x, y)| DVec2::new(x, y));
    draw(device, Form::Filled(Curve::Bezier(&chain), paint(0.9, 0.8, 0.3)));
    draw(device, Form::Stroke(Curve::Bezier(&chain), Pen { paint: red, ..pen(2.0) }));
    let overlap: Vec<DVec2> = [(470.0, 730.0), (560.0, 730.0), (560.0, 810.0), (470.0, 810.0)]
        .map(|(x, y)| DVec2::new(x, y))
        .into();
    draw(device, Form::Area(Paths::new(&overlap, &[4]), Rule::EvenOdd, Fill::Solid(paint(0.2, 0.2, 0.2))));
    for (i, colour) in [red, green, blue].into_iter().enumerate() {
        let shifted: Vec<DVec2> =
            overlap.iter().map(|p| *p * 0.5 + DVec2::new(260.0, 320.0 + 30.0 * i as f64)).collect();
        draw(device, Form::Area(Paths::new(&shifted, &[4]), Rule::NonZero, Fill::Solid(colour)));
    }
    let window = Rect::new(460.0, 560.0, 600.0, 680.0);
    let wide = [(440.0, 590.0), (580.0, 690.0)];
    let points: Vec<DVec2> = wide.iter().map(|&(x, y)| DVec2::new(x, y)).collect();
    let thick = Form::Lines(Paths::new(&points, &[2]), Pen { paint: green, ..pen(40.0) });
    clipped(device, thick, Some(window));
    clipped(device, Form::Filled(ellipse(460.0, 640.0, 0.0, 0.0, Closure::Full), red), Some(window));
    lines(
        device,
        &[(460.0, 600.0), (560.0, 600.0), (560.0, 680.0), (460.0, 680.0), (460.0, 600.0)],
        pen(0.5),
    );
    cells(device);
}

/// An outline face by its font number.
pub(crate) fn outline_face(number: i32) -> &'static OutlineFace {
    let Some(Face::Outline(face)) = face(number) else { panic!("font {number} is an outline face") };
    face
}

/// Draws text from left to right; `spacing` is added to each advance, in em.
pub(crate) fn text(
    device: &mut dyn Device,
    face: &'static OutlineFace,
    text: &str,
    at: (f64, f64),
    [x, y]: [(f64, f64); 2],
    spacing: f64,
) {
    let (x, y): (Vector<Du>, Vector<Du>) = (x.into(), y.into());
    let mut origin: Point<Du> = at.into();
    let mut glyphs = Vec::new();
    for (cluster, character) in text.char_indices() {
        let id = face.glyph_id(character).unwrap_or(0);
        glyphs.push(Glyph { id, cluster: cluster as u32, origin });
        origin = origin + x * (face.advance(id) + spacing);
    }
    draw(device, Form::Text(GlyphRun { text, face, glyphs: &glyphs, x, y, paint: paint(0.1, 0.1, 0.4) }));
}

/// Draws text: upright, leaning, stretched, spaced, in several fonts, and cut by a clipping rectangle.
pub(crate) fn texts(device: &mut dyn Device) {
    let upright = |size: f64| [(size, 0.0), (0.0, size)];
    let (sans, serif, mono) = (outline_face(-21), outline_face(-26), outline_face(-29));
    text(device, sans, "Grüße, Ångström! (100 % \\ fine)", (40.0, 220.0), upright(20.0), 0.0);
    text(device, serif, "Bold serif & stretched", (40.0, 190.0), [(24.0, 0.0), (0.0, 12.0)], 0.0);
    text(device, mono, "Letters apart", (40.0, 160.0), upright(12.0), 0.25);
    text(device, sans, "Leaning upwards", (420.0, 60.0), [(14.0, 10.0), (-4.0, 16.0)], 0.0);
    text(device, sans, "Πυθαγόρας", (40.0, 130.0), upright(16.0), 0.0);
    let window = Rect::new(40.0, 120.0, 95.0, 115.0);
    let id = sans.glyph_id('M').unwrap();
    let origin = Point::new(110.0, 95.0);
    let (x, y) = (Vector::new(40.0, 0.0), Vector::new(0.0, 40.0));
    let glyphs = [Glyph { id, cluster: 0, origin }];
    let run = GlyphRun { text: "M", face: sans, glyphs: &glyphs, x, y, paint: paint(1.0, 0.0, 0.0) };
    clipped(device, Form::Text(run), Some(window));
}

/// Draws cell arrays: few cells, many cells of few colours, many cells of many colours, upside down and leaning.
fn cells(device: &mut dyn Device) {
    let six = [
        paint(1.0, 0.0, 0.0),
        paint(0.0, 1.0, 0.0),
        paint(0.0, 0.0, 1.0),
        paint(0.0, 0.0, 0.0),
        paint(1.0, 1.0, 0.0),
        paint(0.5, 0.5, 0.5),
    ];
    let grid = Grid { paints: &six, columns: 3, rows: 2 };
    draw(device, Form::Cells(place((40.0, 560.0), (120.0, 0.0), (0.0, -60.0)), grid));
    draw(device, Form::Cells(place((60.0, 400.0), (90.0, 40.0), (-20.0, 60.0)), grid));
    let rings: Vec<Paint> = (0..60 * 60)
        .map(|i| {
            let (x, y) = (f64::from(i % 60) - 30.0, f64::from(i / 60) - 30.0);
            six[(x.hypot(y) / 6.0) as usize % 6]
        })
        .collect();
    draw(
        device,
        Form::Cells(
            place((40.0, 380.0), (120.0, 0.0), (0.0, -120.0)),
            Grid { paints: &rings, columns: 60, rows: 60 },
        ),
    );
    let ramp: Vec<Paint> =
        (0..64 * 64).map(|i| paint((i % 64) as f32 / 63.0, (i / 64) as f32 / 63.0, 0.5)).collect();
    draw(
        device,
        Form::Cells(
            place((200.0, 380.0), (120.0, 0.0), (0.0, -120.0)),
            Grid { paints: &ramp, columns: 64, rows: 64 },
        ),
    );
}

/// Offers markers and an area with a pattern, which must be refused.
pub(crate) fn refusals(device: &mut dyn Device) {
    let style = MarkerStyle { kind: 3, size: 5.0, width: 1.0, paint: paint(0.0, 0.0, 0.0) };
    let points = [DVec2::ZERO, DVec2::X, DVec2::Y];
    let cells = [paint(1.0, 0.0, 0.0)];
    let grid = Grid { paints: &cells, columns: 1, rows: 1 };
    let fill = Fill::Pattern(place((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), grid);
    for form in [Form::Markers(&points, style), Form::Area(Paths::new(&points, &[3]), Rule::EvenOdd, fill)] {
        assert_eq!(device.draw(&Mark { form, clip: None }).unwrap(), Drawn::No);
    }
}

/// A picture: number of columns, number of rows, red, green and blue.
pub(crate) type Picture = (usize, usize, Vec<u8>);

/// The colour at a position in points from the lower left corner of a picture with one pixel a point.
pub(crate) fn pixel(picture: &Picture, x: usize, y: usize) -> [u8; 3] {
    let (columns, rows, bytes) = picture;
    let at = ((rows - 1 - y) * columns + x) * 3;
    [bytes[at], bytes[at + 1], bytes[at + 2]]
}

/// Whether two colours differ by no more than rounding of colours and positions.
pub(crate) fn near(a: [u8; 3], b: [u8; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 6)
}

/// Looks at places of a picture of the card, with one pixel a point, that no rounding of edges reaches.
pub(crate) fn probe(picture: &Picture) {
    assert!(
        (595..=596).contains(&picture.0) && (841..=842).contains(&picture.1),
        "{} x {}",
        picture.0,
        picture.1
    );
    let (white, black) = ([255; 3], [0; 3]);
    let (red, green, blue) = ([255, 0, 0], [0, 153, 0], [0, 0, 255]);
    let cases = [
        ("line", 160, 780, blue),
        ("butt end", 202, 780, white),
        ("round end", 202, 730, blue),
        ("projecting end", 202, 680, blue),
        ("corner of a projecting end", 203, 683, blue),
        ("dot", 165, 600, green),
        ("inside of the star by even-odd", 300, 770, white),
        ("point of the star", 330, 770, red),
        ("inside of the star by non-zero", 400, 770, blue),
        ("full ellipse", 400, 680, green),
        ("beside the arc", 425, 600, white),
        ("arc", 375, 605, green),
        ("pie", 380, 475, green),
        ("outside of the pie", 420, 455, white),
        ("first in paint order", 480, 800, [51; 3]),
        ("last in paint order", 520, 770, blue),
        ("clipped line", 540, 660, green),
        ("outside of the clipping rectangle", 540, 690, white),
        ("clipped ellipse", 470, 640, red),
        ("area of Bezier curves", 540, 480, [230, 204, 77]),
        ("first cell", 60, 545, red),
        ("second cell", 100, 545, [0, 255, 0]),
        ("fourth cell", 60, 515, black),
        ("first cell of the leaning array", 65, 420, red),
        ("last cell of the leaning array", 125, 480, [128; 3]),
        ("middle of the rings", 101, 319, red),
        ("ramp, first cell", 201, 378, [0, 0, 128]),
        ("ramp, last cell", 318, 262, [255, 255, 128]),
        ("paper", 500, 100, white),
    ];
    for (what, x, y, colour) in cases {
        assert!(near(pixel(picture, x, y), colour), "{what} at {x}, {y}: {:?}", pixel(picture, x, y));
    }
}

/// The lines of text on the card that other programs should find.
pub(crate) const LINES: [&str; 5] = [
    "Grüße, Ångström! (100 % \\ fine)",
    "Bold serif & stretched",
    "Letters apart",
    "Leaning upwards",
    "Πυθαγόρας",
];

/// Looks at places where the text must have left ink, and at some where it must not.
pub(crate) fn probe_text(picture: &Picture) {
    let ink = |left: usize, right: usize, bottom: usize, top: usize| {
        let places = (bottom..top).flat_map(|y| (left..right).map(move |x| (x, y)));
        places.filter(|&(x, y)| pixel(picture, x, y).iter().any(|part| *part < 200)).count()
    };
    let cases = [
        ("upright text", [40, 310, 220, 240], 700..3000),
        ("above it", [40, 310, 242, 260], 0..1),
        ("stretched text", [40, 330, 190, 200], 500..3000),
        ("text apart", [40, 170, 158, 172], 100..1500),
        ("leaning text", [425, 540, 60, 160], 250..4000),
        ("Greek text", [40, 130, 128, 145], 150..1500),
        ("inside of the clipping rectangle", [110, 120, 96, 115], 20..150),
        ("outside of the clipping rectangle", [121, 160, 90, 125], 0..1),
        ("above the clipping rectangle", [105, 160, 116, 127], 0..1),
    ];
    for (what, [left, right, bottom, top], expected) in cases {
        let count = ink(left, right, bottom, top);
        assert!(expected.contains(&count), "{what}: {count} dark pixels");
    }
}
