//! Which driver serves which workstation type.

use crate::connection;
use crate::hpgl::{self, Hpgl};
use crate::interactive;
use crate::metafile;
use crate::null::Null;
use crate::options::{Options, SizeLimits};
use crate::pdf::{self, Pdf};
use crate::postscript::{self, PostScript};
use crate::raster::{self, Format, Indexed, SizeError, TrueColour};
use crate::scripted::{self, Scripted};
use crate::svg::{self, Svg};
use gks_metafile::cgm::recorder::Settings;
use gks_metafile::cgm::{self, Encoding};
use gks_metafile::gksm;
use gks_pipeline::description::{Category, Description};
use gks_pipeline::device::{Device, Sink};
use gks_pipeline::generated::numbers::{WorkstationType, workstation_type as own};
use gks_pipeline::workstation::Backend;

/// What the workstations of a type are for.
pub(crate) fn category(kind: &WorkstationType) -> Category {
    match kind.number {
        own::GKSM => Category::MetafileOutput,
        number if encoding(number).is_some() => Category::MetafileOutput,
        own::MI => Category::MetafileInput,
        _ => Category::Output,
    }
}

/// How the metafiles of a type are encoded that writes CGM.
fn encoding(number: i32) -> Option<Encoding> {
    Some(match number {
        own::CGM => Encoding::Binary,
        own::CGM_TEXT => Encoding::Text,
        own::CGM_CHARACTER => Encoding::Character,
        own::NCGM => Encoding::Ncgm,
        _ => return None,
    })
}

/// What sizes of display surfaces a type accepts, and in which unit.
pub(crate) fn limits(kind: &WorkstationType) -> &'static SizeLimits {
    match kind.number {
        own::SVG | own::SVG_OUTLINES | own::PDF | own::PS | own::EPS => &SizeLimits::POINTS,
        own::HPGL => &SizeLimits::MILLIMETRES,
        _ => &SizeLimits::PIXELS,
    }
}

/// The description of a type when it is opened with these options, or why it cannot be opened with them.
pub(crate) fn describe(kind: &WorkstationType, options: &Options) -> Result<Description, String> {
    let (number, name) = (kind.number, kind.name);
    match number {
        own::PNG8 | own::FRAMEBUFFER8 => {
            raster::indexed(number, name, options).map_err(|error| error.to_string())
        }
        own::SVG | own::SVG_OUTLINES => Ok(svg::describe(number, name, options)),
        own::PDF => Ok(pdf::describe(number, name, options)),
        own::PS | own::EPS => Ok(postscript::describe(number, name, options)),
        own::PNG | own::JPEG | own::TIFF | own::BMP | own::WEBP | own::GIF | own::FRAMEBUFFER | own::NULL => {
            raster::true_colour(number, name, options).map_err(|error| error.to_string())
        }
        own::SCRIPTED => scripted::describe(number, name, options).map_err(|error| error.to_string()),
        own::HPGL => Ok(hpgl::describe(number, name, options)),
        own::WISS => {
            let storage = raster::true_colour(number, name, &Options::default());
            storage.map(|d| Description { category: Category::Wiss, ..d }).map_err(|error| error.to_string())
        }
        own::GKSM | own::MI | own::CGM | own::CGM_TEXT | own::CGM_CHARACTER | own::NCGM => {
            metafile::describe(number, name, category(kind), options).map_err(|error| error.to_string())
        }
        _ if interactive::is_interactive(kind) => interactive::describe(kind, options),
        _ => Err(unavailable(kind)),
    }
}

/// What is behind a workstation of a type; `sink` is present for the types that write files.
pub(crate) fn open(
    kind: &WorkstationType,
    options: &Options,
    sink: Option<Box<dyn Sink>>,
) -> Result<Backend, String> {
    match (kind.number, sink, encoding(kind.number)) {
        (_, Some(sink), Some(encoding)) => {
            let size = describe(kind, options)?.size();
            let version = options.version.unwrap_or(1);
            let settings = Settings { version, size, plain: false, colours: options.colours };
            Ok(Backend::Pictures(cgm::create(sink, encoding, options.coordinates, settings)))
        }
        (own::GKSM, Some(sink), _) => {
            let writer = gksm::Writer::new(sink, options.coding.unwrap_or_default());
            Ok(Backend::Recorder(Box::new(writer)))
        }
        (_, sink, _) => device(kind, options, sink).map(Backend::Device),
    }
}

fn device(
    kind: &WorkstationType,
    options: &Options,
    sink: Option<Box<dyn Sink>>,
) -> Result<Box<dyn Device>, String> {
    let format = |number| match number {
        own::PNG | own::PNG8 => Some(Format::Png),
        own::JPEG => Some(Format::Jpeg),
        own::TIFF => Some(Format::Tiff),
        own::BMP => Some(Format::Bmp),
        own::WEBP => Some(Format::Webp),
        own::GIF => Some(Format::Gif),
        _ => None,
    };
    let refused = |error: SizeError| error.to_string();
    Ok(match (kind.number, sink) {
        (own::SVG | own::SVG_OUTLINES, Some(sink)) => Box::new(Svg::new(sink, options)),
        (own::PDF, Some(sink)) => Box::new(Pdf::new(sink, options)),
        (own::PS, Some(sink)) => Box::new(PostScript::new(sink, options)),
        (own::EPS, Some(sink)) => Box::new(PostScript::encapsulated(sink, options)),
        (own::HPGL, Some(sink)) => Box::new(Hpgl::new(sink, options)),
        (own::SCRIPTED, sink) => {
            let picture = TrueColour::new(options, sink.zip(Some(Format::Png))).map_err(refused)?;
            let script = options.script.as_deref().map_or(Ok(String::new()), connection::read)?;
            let scripted = Scripted::new(picture, &script, connection::open);
            Box::new(
                scripted.map_err(|error| {
                    format!("script {}: {error}", options.script.as_deref().unwrap_or(""))
                })?,
            )
        }
        (own::NULL, None) => Box::new(Null::new(options).map_err(refused)?),
        (number @ (own::PNG8 | own::FRAMEBUFFER8), sink) => {
            Box::new(Indexed::new(options, sink.zip(format(number))).map_err(refused)?)
        }
        (number, sink) if number == own::FRAMEBUFFER || format(number).is_some() => {
            Box::new(TrueColour::new(options, sink.zip(format(number))).map_err(refused)?)
        }
        _ => return Err(unavailable(kind)),
    })
}

fn unavailable(kind: &WorkstationType) -> String {
    format!("workstation type {} is not available", kind.name)
}
