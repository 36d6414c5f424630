//! Image files: a picture becomes PNG, JPEG, TIFF, BMP, WebP or GIF.

mod png;

use super::describe::Layout;
use crate::options::Options;
use gks_pipeline::device::{DeviceError, Sink};
use image::codecs::bmp::BmpEncoder;
use image::codecs::gif::GifEncoder;
use image::codecs::jpeg::{JpegEncoder, PixelDensity, PixelDensityUnit};
use image::codecs::tiff::TiffEncoder;
use image::codecs::webp::WebPEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};
use std::io::Cursor;

/// A format of image files.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Portable network graphics: lossless, with resolution and opacity.
    Png,
    /// JPEG: lossy, with resolution.
    Jpeg,
    /// TIFF, not compressed, with opacity.
    Tiff,
    /// Windows bitmap, not compressed, with opacity.
    Bmp,
    /// WebP: lossless, with opacity.
    Webp,
    /// GIF: at most 256 colours, the nearest ones where there are more; pixels are opaque or not there.
    Gif,
}

impl Format {
    /// The largest width and height that the format can hold.
    pub(super) fn longest_side(self) -> u32 {
        match self {
            Format::Webp => 16383,
            Format::Gif => 65535,
            _ => u32::MAX,
        }
    }
}

/// The samples of a picture, row by row from the top, without padding.
pub(super) enum Samples<'a> {
    /// Red, green, blue and a byte that counts for nothing: the picture is opaque.
    Opaque(&'a [u8]),
    /// Red, green, blue and opacity, not premultiplied.
    Rgba(Vec<u8>),
    /// Indices into a table of red, green, blue and opacity.
    Palette(&'a [u8], &'a [[u8; 4]]),
}

/// What an encoder takes pains over.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Care {
    /// The quality of JPEG, from 1 to 100.
    pub(super) quality: u8,
    /// Whether PNG is to be small rather than written fast.
    pub(super) small: bool,
}

impl Care {
    /// What options ask for.
    pub(super) fn of(options: &Options) -> Self {
        Care { quality: options.quality.unwrap_or(90), small: options.small }
    }
}

/// Writes a picture as one document.
pub(super) fn write(
    samples: Samples<'_>,
    layout: Layout,
    format: Format,
    care: Care,
    sink: &mut dyn Sink,
) -> Result<(), DeviceError> {
    let bytes = match format {
        Format::Png => png::write(&samples, layout, care.small)?,
        _ => image(samples.without_palette(format), layout, format, care.quality)?,
    };
    sink.open()?;
    sink.write(&bytes)?;
    sink.finish()?;
    Ok(())
}

impl Samples<'_> {
    /// The same picture as the formats want it that know no palette, and JPEG no opacity.
    fn without_palette(self, format: Format) -> (Vec<u8>, ExtendedColorType) {
        let rgba = match self {
            Samples::Opaque(pixels) => return (rgb(pixels), ExtendedColorType::Rgb8),
            Samples::Rgba(rgba) => rgba,
            Samples::Palette(indices, table) => {
                let colour = |&i: &u8| table.get(usize::from(i)).copied().unwrap_or([0, 0, 0, 255]);
                if table.iter().all(|c| c[3] == 255) {
                    let rgb =
                        indices.iter().flat_map(|i| <[u8; 3]>::try_from(&colour(i)[..3]).unwrap_or_default());
                    return (rgb.collect(), ExtendedColorType::Rgb8);
                }
                indices.iter().flat_map(colour).collect()
            }
        };
        if format != Format::Jpeg {
            return (rgba, ExtendedColorType::Rgba8);
        }
        let on_white = |c: u8, alpha: u8| {
            let sum = u32::from(c) * u32::from(alpha) + 255 * (255 - u32::from(alpha));
            ((sum + 127) / 255) as u8
        };
        let rgb = rgba.chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]].map(|c| on_white(c, p[3])));
        (rgb.collect(), ExtendedColorType::Rgb8)
    }
}

/// The red, green and blue samples of an opaque picture.
fn rgb(pixels: &[u8]) -> Vec<u8> {
    let mut rgb = Vec::with_capacity(pixels.len() / 4 * 3);
    for pixel in pixels.as_chunks::<4>().0 {
        rgb.extend_from_slice(&pixel[..3]);
    }
    rgb
}

fn image(
    (data, colour): (Vec<u8>, ExtendedColorType),
    layout: Layout,
    format: Format,
    quality: u8,
) -> Result<Vec<u8>, DeviceError> {
    let mut bytes = Vec::new();
    let (width, height) = (layout.width, layout.height);
    let done = match format {
        Format::Jpeg => {
            let mut encoder = JpegEncoder::new_with_quality(&mut bytes, quality.clamp(1, 100));
            let density = (0.0254 / layout.pixel).round().clamp(1.0, 65535.0) as u16;
            encoder.set_pixel_density(PixelDensity {
                density: (density, density),
                unit: PixelDensityUnit::Inches,
            });
            encoder.write_image(&data, width, height, colour)
        }
        Format::Tiff => TiffEncoder::new(Cursor::new(&mut bytes)).write_image(&data, width, height, colour),
        Format::Bmp => BmpEncoder::new(&mut bytes).write_image(&data, width, height, colour),
        Format::Webp => WebPEncoder::new_lossless(&mut bytes).write_image(&data, width, height, colour),
        Format::Gif => GifEncoder::new(&mut bytes).encode(&data, width, height, colour),
        Format::Png => return Err(DeviceError::Encode("PNG is written without the image codecs".into())),
    };
    done.map_err(|error| match error {
        ImageError::IoError(error) => DeviceError::Io(error),
        other => DeviceError::Encode(other.to_string()),
    })?;
    Ok(bytes)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use image::{DynamicImage, ImageFormat};
    use std::io;
    use std::sync::{Arc, Mutex};

    /// Documents in memory.
    #[derive(Clone, Default)]
    pub(in crate::raster) struct MemorySink(pub(in crate::raster) Arc<Mutex<Vec<Vec<u8>>>>);

    impl Sink for MemorySink {
        fn open(&mut self) -> io::Result<()> {
            self.0.lock().unwrap().push(Vec::new());
            Ok(())
        }

        fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
            self.0.lock().unwrap().last_mut().unwrap().extend_from_slice(bytes);
            Ok(())
        }

        fn finish(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    /// Fails after `0` calls.
    struct FailingSink(u32);

    impl FailingSink {
        fn call(&mut self) -> io::Result<()> {
            self.0 = self.0.checked_sub(1).ok_or(io::ErrorKind::StorageFull)?;
            Ok(())
        }
    }

    impl Sink for FailingSink {
        fn open(&mut self) -> io::Result<()> {
            self.call()
        }

        fn write(&mut self, _: &[u8]) -> io::Result<()> {
            self.call()
        }

        fn finish(&mut self) -> io::Result<()> {
            self.call()
        }
    }

    const LAYOUT: Layout = Layout { width: 16, height: 8, pixel: 0.0254 / 300.0 };
    const FINE: Care = Care { quality: 95, small: false };
    const FORMATS: [(Format, ImageFormat); 6] = [
        (Format::Png, ImageFormat::Png),
        (Format::Jpeg, ImageFormat::Jpeg),
        (Format::Tiff, ImageFormat::Tiff),
        (Format::Bmp, ImageFormat::Bmp),
        (Format::Webp, ImageFormat::WebP),
        (Format::Gif, ImageFormat::Gif),
    ];

    /// Blue with the left half of the given colour.
    fn halves(left: &[u8], right: &[u8]) -> Vec<u8> {
        (0..16 * 8).flat_map(|i| if i % 16 < 8 { left.to_vec() } else { right.to_vec() }).collect()
    }

    fn written(samples: Samples<'_>, format: Format) -> Vec<u8> {
        let mut sink = MemorySink::default();
        write(samples, LAYOUT, format, FINE, &mut sink).unwrap();
        let documents = sink.0.lock().unwrap();
        assert_eq!(documents.len(), 1);
        documents[0].clone()
    }

    fn read(bytes: &[u8], format: ImageFormat) -> DynamicImage {
        let picture = image::load_from_memory_with_format(bytes, format).unwrap();
        assert_eq!((picture.width(), picture.height()), (16, 8));
        picture
    }

    fn resembles(picture: &DynamicImage, column: u32, row: u32, expected: [u8; 4]) -> bool {
        picture.to_rgba8().get_pixel(column, row).0.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 4)
    }

    #[test]
    fn every_format_reads_back() {
        for (format, other) in FORMATS {
            let picture =
                read(&written(Samples::Opaque(&halves(&[250, 20, 30, 0], &[0, 0, 255, 0])), format), other);
            // What the reader of GIF returns has opacity always.
            assert!(format == Format::Gif || !picture.color().has_alpha(), "{format:?}");
            assert!(resembles(&picture, 2, 3, [250, 20, 30, 255]), "{format:?}");
            assert!(resembles(&picture, 13, 7, [0, 0, 255, 255]), "{format:?}");
        }
    }

    #[test]
    fn opacity_is_kept_or_shown_on_white() {
        for (format, other) in FORMATS {
            let picture =
                read(&written(Samples::Rgba(halves(&[0, 0, 0, 0], &[255, 0, 0, 128])), format), other);
            let (left, right) = match format {
                Format::Jpeg => ([255; 4], [255, 127, 127, 255]),
                Format::Gif => ([0; 4], [255, 0, 0, 255]),
                _ => ([0; 4], [255, 0, 0, 128]),
            };
            assert!(resembles(&picture, 2, 3, left), "{format:?} {:?}", picture.to_rgba8().get_pixel(2, 3));
            assert!(resembles(&picture, 13, 3, right), "{format:?}");
        }
    }

    #[test]
    fn a_palette_is_kept_or_resolved() {
        let table = [[0, 0, 0, 255], [200, 100, 50, 255], [9, 9, 9, 255]];
        let indices = halves(&[1], &[0]);
        for (format, other) in FORMATS {
            let bytes = written(Samples::Palette(&indices, &table), format);
            assert!(resembles(&read(&bytes, other), 2, 3, [200, 100, 50, 255]), "{format:?}");
            if format == Format::Png {
                let info = ::png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap().info().clone();
                assert_eq!(info.color_type, ::png::ColorType::Indexed);
                assert_eq!((info.palette.unwrap().len(), info.trns), (9, None));
            }
        }
        let see_through = [[7, 8, 9, 0], [200, 100, 50, 255]];
        let picture = read(&written(Samples::Palette(&indices, &see_through), Format::Png), ImageFormat::Png);
        assert!(resembles(&picture, 13, 3, [7, 8, 9, 0]) && resembles(&picture, 2, 3, [200, 100, 50, 255]));
    }

    #[test]
    fn the_resolution_is_in_the_file() {
        let bytes = written(Samples::Opaque(&halves(&[1, 2, 3, 0], &[4, 5, 6, 0])), Format::Png);
        let reader = ::png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        let density = reader.info().pixel_dims.unwrap();
        assert_eq!((density.xppu, density.yppu, density.unit), (11811, 11811, ::png::Unit::Meter));
        let jpeg = written(Samples::Opaque(&halves(&[1, 2, 3, 0], &[4, 5, 6, 0])), Format::Jpeg);
        assert_eq!(jpeg[6..18], *b"JFIF\0\x01\x02\x01\x01\x2c\x01\x2c", "300 pixels per inch");
    }

    #[test]
    fn a_sink_that_fails_is_an_error() {
        let pixels = halves(&[1, 2, 3, 0], &[4, 5, 6, 0]);
        for calls in 0..3 {
            let samples = Samples::Opaque(&pixels);
            let result = write(samples, LAYOUT, Format::Png, FINE, &mut FailingSink(calls));
            assert!(matches!(result, Err(DeviceError::Io(_))), "{calls}");
        }
        let samples = Samples::Opaque(&pixels);
        assert!(write(samples, LAYOUT, Format::Png, FINE, &mut FailingSink(3)).is_ok());
    }
}
