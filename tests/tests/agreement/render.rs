//! Pictures on every device, as pixels: our own raster, and what other programs make of our files.

use crate::measure::Picture as Pixels;
use gks_pipeline::colour::{Colour, Paint};
use gks_pipeline::description::{Catalogue, Description, OpenError};
use gks_pipeline::device::{Device, DeviceError, Drawn, Fill, Form, Mark, Page, Pen, Surface};
use gks_pipeline::generated::numbers::workstation_type as own;
use gks_pipeline::look::{Cap, Join};
use gks_pipeline::workstation::Backend;
use gks_tests::drawing::{self, drivers};
use gks_tests::pictures::Picture;
use gks_tests::reader;
use gks_workstations::options::Options;
use gks_workstations::raster::{self, SharedPixels, TrueColour};
use resvg::{tiny_skia, usvg};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex};

/// Columns and rows of the pictures that are compared.
pub(crate) const SIDE: usize = 1000;

/// Pictures are drawn with this many times as many columns and rows, so that lines as wide as a pixel lie where
/// they should and not where the nearest pixels are.
const FINE: usize = 2;

/// The folder for pictures that do not agree.
pub(crate) fn folder() -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent().unwrap_or(Path::new("target"));
    drawing::folder(target, "agreement")
}

/// A device that writes files, and the program that reads them.
pub(crate) struct Plan {
    /// The name of the device.
    pub(crate) name: &'static str,
    /// Its workstation type.
    pub(crate) kind: i32,
    /// The options that make its surface a square of which a thousandth is a pixel.
    options: &'static str,
    extension: &'static str,
    /// What it can show.
    pub(crate) ability: Ability,
    /// The programs that read its files.
    pub(crate) programs: &'static [&'static str],
    read: fn(&Path) -> Result<Pixels, String>,
}

const POINTS: &str = "size=1000x1000";

/// Our raster as image files, with more pixels than are compared: then lines as thin as a pixel, which are
/// thinner where they slant, do not matter, and colour indices, which cannot be mixed, are.
pub(crate) static PNG: Plan = Plan {
    name: "png",
    kind: own::PNG,
    options: "size=3000x3000",
    extension: "png",
    ability: Ability::Full,
    programs: &[],
    read: |file| Ok(decode(file, 3 * SIDE)?.reduced(3)),
};
pub(crate) static PNG8: Plan = Plan {
    name: "png8",
    kind: own::PNG8,
    options: "size=4000x4000",
    ability: Ability::Opaque,
    read: |file| Ok(decode(file, 4 * SIDE)?.reduced(4)),
    ..PNG
};
pub(crate) static SVG: Plan = Plan {
    name: "svg",
    kind: own::SVG,
    options: POINTS,
    extension: "svg",
    ability: Ability::Full,
    programs: &[],
    read: read_svg,
};
pub(crate) static SVG_OUTLINES: Plan = Plan { name: "svg-outlines", kind: own::SVG_OUTLINES, ..SVG };
pub(crate) static PDF: Plan = Plan {
    name: "pdf",
    kind: own::PDF,
    options: POINTS,
    extension: "pdf",
    ability: Ability::Full,
    programs: &["pdftocairo"],
    read: read_pdf,
};
pub(crate) static PS: Plan = Plan {
    name: "ps",
    kind: own::PS,
    options: POINTS,
    extension: "ps",
    ability: Ability::Opaque,
    programs: &["gs"],
    read: |file| read_postscript(file, &[]),
};
pub(crate) static EPS: Plan = Plan {
    name: "eps",
    kind: own::EPS,
    extension: "eps",
    read: |file| {
        read_postscript(file, &["-dDEVICEWIDTHPOINTS=1000", "-dDEVICEHEIGHTPOINTS=1000", "-dFIXEDMEDIA"])
    },
    ..PS
};
/// A sheet of 10 inches, of which a hundredth is a pixel.
pub(crate) static HPGL: Plan = Plan {
    name: "hpgl",
    kind: own::HPGL,
    options: "size=254x254",
    extension: "plt",
    ability: Ability::Pens,
    programs: &["hp2xx"],
    read: read_hpgl,
};

impl Plan {
    /// The picture as the device writes it and the program reads it.
    pub(crate) fn render(&self, picture: &Picture) -> Result<Pixels, String> {
        let file = folder().join(format!("{}-{}.{}", picture.name, self.name, self.extension));
        let connection = format!("{}?{}", file.display(), self.options);
        picture.draw(Box::new(drivers()), &connection, self.kind)?;
        (self.read)(&file)
    }
}

static FONTS: LazyLock<Arc<usvg::fontdb::Database>> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../kernel/pipeline/data/outline");
    let mut fonts = usvg::fontdb::Database::new();
    for entry in fs::read_dir(folder).expect("the font data").flatten() {
        if entry.path().extension().is_some_and(|extension| extension == "ttf") {
            fonts.load_font_data(fs::read(entry.path()).expect("a font file"));
        }
    }
    Arc::new(fonts)
});

fn read_svg(file: &Path) -> Result<Pixels, String> {
    draw_svg(&fs::read(file).map_err(|error| error.to_string())?)
}

fn draw_svg(text: &[u8]) -> Result<Pixels, String> {
    let options = usvg::Options { fontdb: FONTS.clone(), ..usvg::Options::default() };
    let tree = usvg::Tree::from_data(text, &options).map_err(|error| error.to_string())?;
    let side = FINE * SIDE;
    let mut canvas = tiny_skia::Pixmap::new(side as u32, side as u32).ok_or("no canvas")?;
    canvas.fill(tiny_skia::Color::WHITE);
    let (width, height) = (tree.size().width(), tree.size().height());
    if (width - height).abs() > 0.01 {
        return Err(format!("the picture has {width} x {height} pixels"));
    }
    let scale = side as f32 / width;
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut canvas.as_mut());
    let pixels = canvas.data().chunks_exact(4).map(|p| [p[0], p[1], p[2]]).collect();
    Ok(Pixels { side, pixels }.reduced(FINE))
}

fn read_pdf(file: &Path) -> Result<Pixels, String> {
    let stem = file.with_extension("page");
    let stem = stem.to_string_lossy();
    reader::run(60, "pdftocairo", &["-r", "144", "-png", "-singlefile", &file.to_string_lossy(), &stem])?;
    Ok(decode(Path::new(&format!("{stem}.png")), FINE * SIDE)?.reduced(FINE))
}

fn read_postscript(file: &Path, more: &[&str]) -> Result<Pixels, String> {
    let image =
        file.with_extension(format!("{}.png", file.extension().unwrap_or_default().to_string_lossy()));
    let output = format!("-sOutputFile={}", image.display());
    let file = file.to_string_lossy();
    let mut arguments = vec!["-q", "-dNOPAUSE", "-dBATCH", "-dSAFER", "-sDEVICE=png16m", "-r144"];
    arguments.extend(["-dTextAlphaBits=4", "-dGraphicsAlphaBits=4", "-dGridFitTT=0", &output]);
    arguments.extend(more);
    arguments.push(&file);
    reader::run(60, "gs", &arguments)?;
    Ok(decode(&image, FINE * SIDE)?.reduced(FINE))
}

/// The colours of the eight pens: what hp2xx makes of `-c 12345671`.
const PENS: [[f32; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [0.0, 0.0, 0.0],
];

/// The width of pens, of their lines on paper, and the side of the sheet, in millimetres. Lines a pen width
/// apart must leave no seams that only tell how smoothly a program draws.
const PEN: f64 = 0.3;
const INK: f64 = 0.4;
const SHEET: f64 = 254.0;

/// hp2xx says which lines a plotter draws; as an image it would draw them on a coarse grid.
fn read_hpgl(file: &Path) -> Result<Pixels, String> {
    let lines = file.with_extension("plt.svg");
    let mut arguments = vec!["-q", "-m", "svg", "-t", "-p", "11111111", "-c", "12345671"];
    arguments.extend(["-x", "0", "-X", "10160", "-y", "0", "-Y", "10160", "-f"]);
    let (name, file) = (lines.to_string_lossy(), file.to_string_lossy());
    arguments.extend([&*name, &*file]);
    reader::run(20, "hp2xx", &arguments)?;
    let text = fs::read_to_string(&lines).map_err(|error| error.to_string())?;
    let _ = fs::remove_file(&lines);
    // The view box is the sheet in points.
    let width = INK / 25.4 * 72.0;
    let round = format!("stroke-width:{width};stroke-linecap:round;stroke-linejoin:round");
    draw_svg(text.replace("stroke-width:0.100mm", &round).as_bytes())
}

/// The pixels of an image file, which is removed.
fn decode(file: &Path, side: usize) -> Result<Pixels, String> {
    let image = image::open(file).map_err(|error| format!("{}: {error}", file.display()))?.into_rgb8();
    let _ = fs::remove_file(file);
    if (image.width() as usize, image.height() as usize) != (side, side) {
        return Err(format!("{}: {} x {} pixels, not {side}", file.display(), image.width(), image.height()));
    }
    Ok(Pixels { side, pixels: image.pixels().map(|p| p.0).collect() })
}

/// Writes a picture as an image file.
pub(crate) fn save(picture: &Pixels, file: &Path) {
    let bytes = picture.pixels.iter().flatten().copied().collect();
    let side = picture.side as u32;
    let image = image::RgbImage::from_raw(side, side, bytes).expect("three bytes for each pixel");
    image.save(file).expect("the target folder can be written");
}

/// What our own frame buffer shows, for comparison with devices that can do less.
#[derive(Copy, Clone, Debug, PartialEq)]
pub(crate) enum Ability {
    /// All.
    Full,
    /// What is not fully transparent is opaque.
    Opaque,
    /// Solid lines with a pen, in the colours of eight pens.
    Pens,
}

/// The picture in our own frame buffer.
pub(crate) fn raster(picture: &Picture, ability: Ability) -> Result<Pixels, String> {
    let pixels = Arc::new(Mutex::new(None));
    let catalogue = Memory { ability, pixels: Arc::clone(&pixels) };
    picture.draw(Box::new(catalogue), "", own::FRAMEBUFFER)?;
    let drawn: SharedPixels = pixels.lock().map_err(|e| e.to_string())?.take().ok_or("nothing opened")?;
    let rgb = |data: &[u8]| data.chunks_exact(4).map(|p| [p[0], p[1], p[2]]).collect();
    Ok(Pixels { side: FINE * SIDE, pixels: drawn.read(rgb) }.reduced(FINE))
}

/// A catalogue with one frame buffer, whose pixels it keeps.
struct Memory {
    ability: Ability,
    pixels: Arc<Mutex<Option<SharedPixels>>>,
}

fn options() -> Options {
    let side = (FINE * SIDE) as f64;
    Options { size: Some((side, side)), ..Options::default() }
}

impl Catalogue for Memory {
    fn types(&self) -> Vec<i32> {
        vec![own::WISS, own::FRAMEBUFFER]
    }

    fn describe(&self, number: i32) -> Option<Description> {
        if number == own::WISS {
            return drivers().describe(number);
        }
        let mut description = raster::true_colour(number, "framebuffer", &options()).ok()?;
        if self.ability == Ability::Pens {
            let side = description.surface.width;
            let (pen, resolution) = (Some(PEN / SHEET * side), side / 10160.0);
            description.surface = Surface { pen, resolution, ..description.surface };
        }
        (number == own::FRAMEBUFFER).then_some(description)
    }

    fn open(&mut self, number: i32, _: &str) -> Result<(Backend, Description), OpenError> {
        let description = self.describe(number).ok_or(OpenError::NoSuchType(number))?;
        if number == own::WISS {
            return Ok((Backend::Storage, description));
        }
        let refused = |error: &dyn std::error::Error| OpenError::CannotOpen(error.to_string());
        let device = TrueColour::new(&options(), None).map_err(|error| refused(&error))?;
        *self.pixels.lock().map_err(|error| refused(&error))? = Some(device.shared());
        let surface = description.surface.clone();
        let limited = Limited { ability: self.ability, surface, inner: device };
        Ok((Backend::Device(Box::new(limited)), description))
    }
}

/// A frame buffer that refuses or changes what a device of less ability would.
struct Limited {
    ability: Ability,
    surface: Surface,
    inner: TrueColour,
}

impl Limited {
    /// Draws as a plotter does.
    fn plot(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let (Form::Lines(paths, pen), None) = (&mark.form, &mark.clip) else { return Ok(Drawn::No) };
        if !pen.dash.is_empty() {
            return Ok(Drawn::No);
        }
        let Some(number) = pen.paint.index.checked_sub(1).filter(|_| pen.paint.colour.alpha > 0.0) else {
            return Ok(Drawn::Yes);
        };
        let [red, green, blue] = PENS[number as usize % PENS.len()];
        let paint = Paint { colour: Colour::rgb(red, green, blue), ..pen.paint };
        let width = INK / SHEET * self.surface.width;
        let pen = Pen { width, paint, cap: Cap::Round, join: Join::Round, ..*pen };
        self.inner.draw(&Mark { form: Form::Lines(*paths, pen), clip: None })
    }

    /// Draws in opaque colours.
    fn opaque(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        let one = |paint: &Paint| {
            let alpha = if paint.colour.alpha > 0.0 { 1.0 } else { 0.0 };
            Paint { colour: Colour { alpha, ..paint.colour }, ..*paint }
        };
        let paints: Vec<Paint> = match &mark.form {
            Form::Area(_, _, Fill::Pattern(_, grid)) | Form::Cells(_, grid) => {
                grid.paints.iter().map(one).collect()
            }
            _ => Vec::new(),
        };
        let mut mark = mark.clone();
        match &mut mark.form {
            Form::Lines(_, pen) | Form::LongLine(_, pen) | Form::Stroke(_, pen) => {
                pen.paint = one(&pen.paint);
            }
            Form::Area(_, _, Fill::Solid(paint)) | Form::Filled(_, paint) => *paint = one(paint),
            Form::Area(_, _, Fill::Pattern(_, grid)) | Form::Cells(_, grid) => grid.paints = &paints,
            Form::Markers(_, style) => style.paint = one(&style.paint),
            Form::Text(run) => run.paint = one(&run.paint),
            Form::StrokeText(text) => text.pen.paint = one(&text.pen.paint),
            // They come again as cells with paints.
            Form::IndexedCells(..) => return Ok(Drawn::No),
        }
        self.inner.draw(&mark)
    }
}

impl Device for Limited {
    fn surface(&self) -> &Surface {
        &self.surface
    }

    fn begin(&mut self, page: &Page) -> Result<(), DeviceError> {
        self.inner.begin(page)
    }

    fn erase(&mut self, page: &Page) -> Result<Drawn, DeviceError> {
        self.inner.erase(page)
    }

    fn draw(&mut self, mark: &Mark<'_>) -> Result<Drawn, DeviceError> {
        match self.ability {
            Ability::Full => self.inner.draw(mark),
            Ability::Opaque => self.opaque(mark),
            Ability::Pens => self.plot(mark),
        }
    }

    fn end(&mut self) -> Result<(), DeviceError> {
        self.inner.end()
    }

    fn close(&mut self) -> Result<(), DeviceError> {
        self.inner.close()
    }
}
