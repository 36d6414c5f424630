//! What a user chooses for one workstation beside its type: size, resolution, orientation, background.
//!
//! Options are written as a list of `name=value` after a connection identifier, `out.png?size=1600x1200&dpi=300`,
//! or in the environment. `&` or `,` separates them.

use gks_metafile::cgm::encoder::Coordinates;
use gks_metafile::gksm::Coding;
use gks_pipeline::colour::Colour;
use gks_pipeline::device::Surface;
use gks_pipeline::record::item::Convention;

/// The choices, each absent where the user leaves it to the driver.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Width and height of the display surface in the device's customary unit: pixels for raster, points
    /// (1/72 inch) for SVG, PDF and PostScript, millimetres for plotters.
    pub size: Option<(f64, f64)>,
    /// Pixels per inch of a raster device.
    pub dpi: Option<f64>,
    /// The wider side horizontally (`Some(true)`) or vertically.
    pub landscape: Option<bool>,
    /// The background instead of colour index 0.
    pub background: Option<Colour>,
    /// No background at all where the format can leave it out.
    pub transparent: bool,
    /// Antialiasing of a raster device.
    pub antialias: Option<bool>,
    /// Characters as outlines instead of text.
    pub outlines: bool,
    /// The file with the script of a scripted workstation.
    pub script: Option<String>,
    /// Quality of lossy formats from 1 to 100.
    pub quality: Option<u8>,
    /// Whether a small file is worth more time.
    pub small: bool,
    /// How far points of lines that are left out may lie off, in nominal linewidths; a vector format keeps
    /// all points where this is absent.
    pub reduce: Option<f64>,
    /// How numbers are coded in a metafile of GKS that is written.
    pub coding: Option<Coding>,
    /// The version of a CGM that is written.
    pub version: Option<u8>,
    /// How coordinates are coded in a binary CGM that is written.
    pub coordinates: Option<Coordinates>,
    /// The most entries of the colour table of a CGM that is written.
    pub colours: Option<u32>,
    /// How items that authors code differently are read in a metafile of GKS, whatever its header says.
    pub items: Option<Convention>,
    /// Whether the last picture of a window stays when the workstation is closed.
    pub keep: Option<bool>,
    /// The port of a page; any free one if absent.
    pub port: Option<u16>,
    /// Whether a page is opened in a browser.
    pub open: bool,
}

/// Why an option is refused.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OptionError {
    /// There is no such option.
    #[error("there is no option \"{0}\"; the options are {NAMES}")]
    Unknown(String),
    /// The text is no `name=value`.
    #[error("option \"{0}\" has no value; write {0}=value")]
    NoValue(String),
    /// The value of the option makes no sense.
    #[error("option {name}={value}: expected {expected}")]
    Value {
        /// The name of the option.
        name: &'static str,
        /// The value given.
        value: String,
        /// What the value should be.
        expected: String,
    },
}

const NAMES: &str = "size, dpi, landscape, background, antialias, outlines, quality, small, reduce, script, coding, items, keep, port, open, \
     version, vdc, colours";

/// The sizes of display surfaces that a kind of device accepts.
#[derive(Copy, Clone, Debug, PartialEq)]
pub struct SizeLimits {
    /// The customary unit.
    pub unit: &'static str,
    /// The least length of a side.
    pub least: f64,
    /// The greatest length of a side.
    pub most: f64,
    /// The greatest area.
    pub area: f64,
}

impl SizeLimits {
    /// Raster devices: whole pixels, at most 2^28 of them, which is 1 GiB of memory.
    pub const PIXELS: SizeLimits =
        SizeLimits { unit: "pixels", least: 1.0, most: 32767.0, area: (1u32 << 28) as f64 };
    /// Pages: up to 200 inches a side, the limit of PDF (ISO 32000-1, annex C).
    pub const POINTS: SizeLimits =
        SizeLimits { unit: "points (1/72 inch)", least: 3.0, most: 14400.0, area: f64::INFINITY };
    /// Plotters: what fits on a roll.
    pub const MILLIMETRES: SizeLimits =
        SizeLimits { unit: "millimetres", least: 10.0, most: 20000.0, area: f64::INFINITY };
}

impl Options {
    /// The choices in a list of options, checked against the limits of a device.
    pub fn parse(list: &str, limits: &SizeLimits) -> Result<Options, OptionError> {
        let mut options = Options::default();
        options.set(list, limits)?;
        Ok(options)
    }

    /// Replaces choices by those in a list of options; what the list does not name stays.
    pub fn set(&mut self, list: &str, limits: &SizeLimits) -> Result<(), OptionError> {
        for option in list.split(['&', ',']).map(str::trim).filter(|option| !option.is_empty()) {
            let (name, value) =
                option.split_once('=').ok_or_else(|| OptionError::NoValue(option.to_owned()))?;
            self.set_one(name.trim(), value.trim(), limits)?;
        }
        Ok(())
    }

    fn set_one(&mut self, name: &str, value: &str, limits: &SizeLimits) -> Result<(), OptionError> {
        match name {
            "size" => self.size = Some(size(value, limits)?),
            "dpi" => self.dpi = Some(number("dpi", value, 1.0, 10_000.0)?),
            "landscape" => self.landscape = Some(switch("landscape", value)?),
            "background" => {
                self.background = background(value)?;
                self.transparent = self.background.is_none();
            }
            "antialias" => self.antialias = Some(switch("antialias", value)?),
            "outlines" => self.outlines = switch("outlines", value)?,
            "script" => self.script = Some(value.to_owned()),
            "quality" => {
                let quality: Option<u8> = value.parse().ok().filter(|q| (1..=100).contains(q));
                self.quality =
                    Some(quality.ok_or_else(|| refused("quality", value, "a whole number from 1 to 100"))?);
            }
            "small" => self.small = switch("small", value)?,
            "reduce" => self.reduce = Some(number("reduce", value, 0.0, 100.0)?),
            "version" => {
                self.version = Some(match value {
                    "1" => 1,
                    "3" => 3,
                    _ => return Err(refused("version", value, "1 or 3")),
                });
            }
            "vdc" => {
                self.coordinates = Some(match value {
                    "integer16" => Coordinates::Integer16,
                    "integer" => Coordinates::Integer32,
                    "real" => Coordinates::Real,
                    _ => return Err(refused("vdc", value, "integer16, integer or real")),
                });
            }
            "colours" => {
                let colours = value.parse().ok().filter(|colours| (2..=65536).contains(colours));
                self.colours =
                    Some(colours.ok_or_else(|| refused("colours", value, "a whole number from 2 to 65536"))?);
            }
            "coding" => {
                self.coding = Some(match value {
                    "binary" => Coding::Binary,
                    "formatted" => Coding::Formatted,
                    _ => return Err(refused("coding", value, "binary or formatted")),
                });
            }
            "items" => {
                self.items = Some(match value {
                    "ral" => Convention::Ral,
                    "xgks" => Convention::Xgks,
                    _ => return Err(refused("items", value, "ral or xgks")),
                });
            }
            "keep" => self.keep = Some(switch("keep", value)?),
            "port" => {
                let port = value.parse().map_err(|_| refused("port", value, "a number from 0 to 65535"))?;
                self.port = Some(port);
            }
            "open" => self.open = switch("open", value)?,
            _ => return Err(OptionError::Unknown(name.to_owned())),
        }
        Ok(())
    }

    /// How far points of lines that are left out may lie off on a surface, in its units.
    pub fn tolerance(&self, surface: &Surface) -> f64 {
        self.reduce.unwrap_or(0.0) * surface.nominal_linewidth()
    }

    /// Width and height of the display surface: the size chosen or else the default, turned as chosen.
    pub fn size_or(&self, default: (f64, f64)) -> (f64, f64) {
        let (width, height) = self.size.unwrap_or(default);
        match self.landscape {
            Some(landscape) if (width > height) != landscape => (height, width),
            _ => (width, height),
        }
    }
}

/// A connection identifier without its options, and the list of options after the first `?`.
pub fn split_connection(connection: &str) -> (&str, &str) {
    connection.split_once('?').unwrap_or((connection, ""))
}

fn refused(name: &'static str, value: &str, expected: impl Into<String>) -> OptionError {
    OptionError::Value { name, value: value.to_owned(), expected: expected.into() }
}

fn number(name: &'static str, value: &str, least: f64, most: f64) -> Result<f64, OptionError> {
    let number = value.parse().ok().filter(|number| (least..=most).contains(number));
    number.ok_or_else(|| refused(name, value, format!("a number from {least} to {most}")))
}

fn switch(name: &'static str, value: &str) -> Result<bool, OptionError> {
    match value {
        "1" | "on" | "yes" | "true" => Ok(true),
        "0" | "off" | "no" | "false" => Ok(false),
        _ => Err(refused(name, value, "1 or 0")),
    }
}

fn size(value: &str, limits: &SizeLimits) -> Result<(f64, f64), OptionError> {
    let SizeLimits { unit, least, most, area } = *limits;
    let side = |text: &str| text.parse().ok().filter(|side: &f64| (least..=most).contains(side));
    let sides = value.split_once('x').and_then(|(width, height)| Some((side(width)?, side(height)?)));
    let expected = || format!("WIDTHxHEIGHT in {unit}, each from {least} to {most}");
    let (width, height) = sides.ok_or_else(|| refused("size", value, expected()))?;
    if area.is_finite() {
        if width.fract() != 0.0 || height.fract() != 0.0 {
            return Err(refused("size", value, format!("whole {unit}")));
        }
        if width * height > area {
            return Err(refused("size", value, format!("at most {area} {unit} in all")));
        }
    }
    Ok((width, height))
}

/// The colour, or none for `none`.
fn background(value: &str) -> Result<Option<Colour>, OptionError> {
    match value {
        "none" => return Ok(None),
        "white" => return Ok(Some(Colour::WHITE)),
        "black" => return Ok(Some(Colour::BLACK)),
        _ => {}
    }
    let digits = value.strip_prefix('#').unwrap_or(value).as_bytes();
    let digit = |at: usize| char::from(digits[at]).to_digit(16).map(|digit| digit as f32);
    let colour = match digits.len() {
        3 => (0..3).map(|i| Some(digit(i)? / 15.0)).collect::<Option<Vec<_>>>(),
        6 => (0..3).map(|i| Some((digit(2 * i)? * 16.0 + digit(2 * i + 1)?) / 255.0)).collect(),
        _ => None,
    };
    match colour.as_deref() {
        Some(&[red, green, blue]) => Ok(Some(Colour::rgb(red, green, blue))),
        _ => Err(refused("background", value, "white, black, none or #rrggbb")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(list: &str) -> Result<Options, OptionError> {
        Options::parse(list, &SizeLimits::PIXELS)
    }

    fn message(list: &str) -> String {
        parse(list).unwrap_err().to_string()
    }

    #[test]
    fn all_options_are_read() {
        let list = "size=1600x1200&dpi=300&landscape=1&background=#ff8000&antialias=0&outlines=1&quality=90&small=1&reduce=0.25&\
                    script=in/a.script&coding=formatted&items=xgks&keep=1&port=8080&open=1&\
                    version=3&vdc=real&colours=128";
        let expected = Options {
            size: Some((1600.0, 1200.0)),
            dpi: Some(300.0),
            landscape: Some(true),
            background: Some(Colour::rgb(1.0, 128.0 / 255.0, 0.0)),
            transparent: false,
            antialias: Some(false),
            outlines: true,
            script: Some("in/a.script".to_owned()),
            quality: Some(90),
            small: true,
            reduce: Some(0.25),
            coding: Some(Coding::Formatted),
            version: Some(3),
            coordinates: Some(Coordinates::Real),
            colours: Some(128),
            items: Some(Convention::Xgks),
            keep: Some(true),
            port: Some(8080),
            open: true,
        };
        assert_eq!(parse(list), Ok(expected.clone()));
        assert_eq!(parse(&list.replace('&', " , ")), Ok(expected));
        assert_eq!(parse(""), Ok(Options::default()));
        assert_eq!(parse("&"), Ok(Options::default()));
    }

    #[test]
    fn later_lists_win_and_leave_the_rest() {
        let mut options = parse("background=none&dpi=100&outlines=on").unwrap();
        assert!(options.transparent && options.background.is_none());
        options.set("background=white&outlines=off", &SizeLimits::PIXELS).unwrap();
        let expected = Options { background: Some(Colour::WHITE), dpi: Some(100.0), ..Options::default() };
        assert_eq!(options, expected);
    }

    #[test]
    fn backgrounds_are_names_or_hexadecimal() {
        let colour = |list: &str| parse(list).unwrap().background.map(Colour::to_bytes);
        assert_eq!(colour("background=#f80"), Some([255, 136, 0, 255]));
        assert_eq!(colour("background=0a0B0c"), Some([10, 11, 12, 255]));
        assert_eq!(colour("background=black"), Some([0, 0, 0, 255]));
        for wrong in ["", "#", "#12345", "#gg0000", "#+f+f+f", "red", "\u{e4}\u{e4}\u{e4}"] {
            let said = message(&format!("background={wrong}"));
            assert_eq!(said, format!("option background={wrong}: expected white, black, none or #rrggbb"));
        }
    }

    #[test]
    fn messages_name_the_option_the_value_and_what_is_expected() {
        assert_eq!(
            message("colour=red"),
            "there is no option \"colour\"; the options are size, dpi, landscape, background, antialias, \
             outlines, quality, small, reduce, script, coding, items, keep, \
             port, open, version, vdc, colours"
        );
        assert_eq!(message("dpi"), "option \"dpi\" has no value; write dpi=value");
        assert_eq!(message("dpi=0.5"), "option dpi=0.5: expected a number from 1 to 10000");
        assert_eq!(message("dpi=NaN"), "option dpi=NaN: expected a number from 1 to 10000");
        assert_eq!(message("landscape=maybe"), "option landscape=maybe: expected 1 or 0");
        assert_eq!(message("quality=101"), "option quality=101: expected a whole number from 1 to 100");
        assert_eq!(message("version=2"), "option version=2: expected 1 or 3");
        assert_eq!(message("vdc=float"), "option vdc=float: expected integer16, integer or real");
        assert_eq!(message("coding=text"), "option coding=text: expected binary or formatted");
        assert_eq!(message("items=gks"), "option items=gks: expected ral or xgks");
        assert_eq!(message("port=65536"), "option port=65536: expected a number from 0 to 65535");
        assert_eq!(message("quality=0"), "option quality=0: expected a whole number from 1 to 100");
        let sides = "expected WIDTHxHEIGHT in pixels, each from 1 to 32767";
        for wrong in ["100", "100x", "x", "0x10", "1e9x10", "infxinf", "NaNx1", "-5x5", "5x5x5"] {
            assert_eq!(message(&format!("size={wrong}")), format!("option size={wrong}: {sides}"));
        }
        assert_eq!(message("size=10.5x10"), "option size=10.5x10: expected whole pixels");
        assert_eq!(
            message("size=32767x32767"),
            "option size=32767x32767: expected at most 268435456 pixels in all"
        );
    }

    #[test]
    fn limits_depend_on_the_device() {
        assert!(Options::parse("size=297.5x210", &SizeLimits::MILLIMETRES).is_ok());
        assert!(Options::parse("size=5x5", &SizeLimits::MILLIMETRES).is_err());
        assert!(Options::parse("size=14400x14400", &SizeLimits::POINTS).is_ok());
        assert!(Options::parse("size=14401x100", &SizeLimits::POINTS).is_err());
    }

    #[test]
    fn orientation_turns_the_surface() {
        let size = |list: &str| parse(list).unwrap().size_or((210.0, 297.0));
        assert_eq!(size(""), (210.0, 297.0));
        assert_eq!(size("landscape=1"), (297.0, 210.0));
        assert_eq!(size("landscape=0"), (210.0, 297.0));
        assert_eq!(size("landscape=1&size=400x300"), (400.0, 300.0));
        assert_eq!(size("landscape=0&size=400x300"), (300.0, 400.0));
        assert_eq!(size("landscape=0&size=300x300"), (300.0, 300.0));
    }

    #[test]
    fn a_connection_ends_at_the_question_mark() {
        assert_eq!(split_connection("out.png?dpi=300"), ("out.png", "dpi=300"));
        assert_eq!(split_connection("out.png"), ("out.png", ""));
    }
}
