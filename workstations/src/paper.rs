//! Paper: the display surface of document formats, measured in points, and its background.

use crate::options::Options;
use gks_pipeline::colour::Colour;
use gks_pipeline::description::{
    Category, Classification, DeferralMode, Description, DynamicModifications, RegenerationMode,
    SegmentModifications,
};
use gks_pipeline::device::{Page, Surface};

/// The length of a point, 1/72 inch, in metres.
const POINT: f64 = 0.0254 / 72.0;

/// Width and height of A4 paper in points.
const A4: (f64, f64) = (595.28, 841.89);

/// The smallest and largest side in points; the largest is what readers of PDF are known to accept.
const SIDES: std::ops::RangeInclusive<f64> = 1.0..=14_400.0;

/// How finely positions are written, in points.
const RESOLUTION: f64 = 0.01;

/// The display surface that the options choose: A4 upright unless they say otherwise, also where the size
/// they give is none.
pub(crate) fn surface(options: &Options) -> Surface {
    let given = options.size.filter(|(width, height)| SIDES.contains(width) && SIDES.contains(height));
    let (mut width, mut height) = given.unwrap_or(A4);
    if options.landscape.is_some_and(|landscape| landscape != (width > height)) {
        (width, height) = (height, width);
    }
    let rounded = |side: f64| (side * 100.0).round() / 100.0;
    Surface {
        width: rounded(width),
        height: rounded(height),
        unit: POINT,
        y_down: false,
        resolution: RESOLUTION,
        pen: None,
    }
}

/// The description of a workstation that draws documents.
pub(crate) fn description(number: i32, name: &'static str, options: &Options) -> Description {
    let surface = surface(options);
    let steps = |side: f64| (side / surface.resolution).round() as u32;
    let raster = (steps(surface.width), steps(surface.height));
    Description {
        number,
        name,
        category: Category::Output,
        classification: Classification::Vector,
        raster,
        surface,
        colours: 0,
        dynamic: DynamicModifications::REDRAWN,
        deferral: DeferralMode::Asti,
        regeneration: RegenerationMode::Suppressed,
        segments: SegmentModifications::REDRAWN,
        input: [0; 6],
    }
}

/// The colour to fill the page with before anything is drawn: white paper is left bare unless the options
/// ask for white.
pub(crate) fn background(options: &Options, page: &Page) -> Option<Colour> {
    if options.transparent {
        return None;
    }
    let bare = |colour: &Colour| colour.to_bytes()[..3] == [255; 3] || colour.to_bytes()[3] == 0;
    options.background.or_else(|| Some(page.background).filter(|colour| !bare(colour)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(options: &Options) -> (f64, f64) {
        let surface = surface(options);
        (surface.width, surface.height)
    }

    #[test]
    fn paper_is_upright_a4_unless_options_say_otherwise() {
        let options = Options::default();
        assert_eq!(size(&options), A4);
        assert_eq!(size(&Options { landscape: Some(true), ..options.clone() }), (A4.1, A4.0));
        assert_eq!(size(&Options { landscape: Some(false), ..options.clone() }), A4);
        let wide = Options { size: Some((400.0, 300.0)), ..options.clone() };
        assert_eq!(size(&wide), (400.0, 300.0));
        assert_eq!(size(&Options { landscape: Some(false), ..wide }), (300.0, 400.0));
        for senseless in [(0.0, 10.0), (f64::NAN, 10.0), (1e9, 10.0), (-5.0, 5.0)] {
            assert_eq!(size(&Options { size: Some(senseless), ..options.clone() }), A4);
        }
    }

    #[test]
    fn white_paper_is_left_bare() {
        let page = |background| Page { number: 1, background, colours: Vec::new() };
        let options = Options::default();
        let blue = Colour::rgb(0.0, 0.0, 1.0);
        assert_eq!(background(&options, &page(Colour::WHITE)), None);
        assert_eq!(background(&options, &page(Colour { alpha: 0.0, ..blue })), None);
        assert_eq!(background(&options, &page(blue)), Some(blue));
        let white = Options { background: Some(Colour::WHITE), ..options.clone() };
        assert_eq!(background(&white, &page(blue)), Some(Colour::WHITE));
        assert_eq!(background(&Options { transparent: true, ..white }, &page(blue)), None);
    }
}
