//! What is written of pages.

use super::*;
use gks_geometry::{Point, Vector};
use gks_pipeline::colour::Paint;
use gks_pipeline::item::Ellipse;
use gks_pipeline::look::Join;

/// Keeps what is drained, and counts how often.
#[derive(Default)]
struct Tub(Vec<u8>, usize);

impl Drain for Tub {
    fn drain(&mut self, text: &mut Vec<u8>) -> Result<(), DeviceError> {
        self.0.append(text);
        self.1 += 1;
        Ok(())
    }
}

fn pen<'a>(width: f64, dash: &'a [f64]) -> Pen<'a> {
    let paint = Paint { colour: Colour::rgb(1.0, 0.0, 0.5), index: 1 };
    Pen { paint, width, dash, cap: Cap::Butt, join: Join::Miter }
}

fn exact() -> Route {
    Route::new(STEPS, 0.0)
}

fn written(language: Language, draw: impl FnOnce(&mut Content, &mut Tub)) -> String {
    let (mut content, mut tub) = (Content::new(language, 1 << 16), Tub::default());
    content.begin();
    draw(&mut content, &mut tub);
    content.end(&mut tub).unwrap();
    String::from_utf8(tub.0).unwrap().replace('\n', ",")
}

const BEND: [DVec2; 4] =
    [DVec2::new(1.0, 2.0), DVec2::new(1.001, 2.0), DVec2::new(3.5, 2.0), DVec2::new(3.5, -0.25)];

#[test]
fn state_is_written_when_it_changes() {
    let line = |content: &mut Content, tub: &mut Tub, pen: &Pen<'_>| {
        content.lines(&Paths::<Du>::new(&BEND, &[4]), pen, &mut exact(), tub).unwrap();
    };
    let text = written(Language::Pdf, |content, tub| {
        line(content, tub, &pen(0.5, &[]));
        line(content, tub, &pen(0.5, &[]));
        line(content, tub, &Pen { cap: Cap::Round, join: Join::Bevel, ..pen(0.5, &[3.0, 0.25]) });
        line(content, tub, &pen(0.5, &[0.0, -1.0, 0.0001]));
    });
    let path = "1 2 m,3.5 2 l,3.5 -.25 l,S,";
    let changed = "1 J,2 j,[3 .25] 0 d,";
    assert_eq!(text, format!("1 0 .5 RG,.5 w,{path}{path}{changed}{path}0 J,0 j,[] 0 d,{path}"));
}

#[test]
fn postscript_counts_in_hundredths_with_one_colour() {
    let text = written(Language::PostScript, |content, tub| {
        content.lines(&Paths::<Du>::new(&BEND, &[4]), &pen(0.595, &[1.0, 2.0]), &mut exact(), tub).unwrap();
        let colour = Colour { alpha: 0.5, ..Colour::rgb(1.0, 0.0, 0.5) };
        content.area(Paths::new(&BEND, &[4]), Rule::EvenOdd, colour, &mut exact(), tub).unwrap();
        content.area(Paths::new(&BEND, &[4]), Rule::NonZero, Colour::BLACK, &mut exact(), tub).unwrap();
    });
    let path = "100 200 m,0 -225 250 0,2 L,";
    assert_eq!(text, format!("1 0 .5 rg,59.5 w,[100 200] 0 d,{path}S,{path}f*,0 g,{path}f,"));
}

#[test]
fn clipping_comes_and_goes_with_its_state() {
    let rect = Rect::new(0.0, 10.0, 5.0, 7.5);
    let text = written(Language::Pdf, |content, tub| {
        let mut line = |content: &mut Content, width| {
            content.lines(&Paths::<Du>::new(&BEND[2..], &[2]), &pen(width, &[]), &mut exact(), tub).unwrap();
        };
        line(content, 1.0);
        content.clip(Some(&rect));
        line(content, 2.0);
        content.clip(Some(&rect));
        line(content, 2.0);
        content.clip(None);
        line(content, 1.0);
        content.clip(Some(&rect));
    });
    let path = "3.5 2 m,3.5 -.25 l,S,";
    let clip = "q,0 5 10 2.5 re,W n,";
    assert_eq!(text, format!("1 0 .5 RG,1 w,{path}{clip}2 w,{path}{path}Q,{path}{clip}Q,"));
}

#[test]
fn paths_that_shrink_to_a_position_are_round_dots() {
    let points = [DVec2::new(5.0, 5.0), DVec2::new(6.0, 6.0), DVec2::new(6.002, 6.0)];
    let text = written(Language::Pdf, |content, tub| {
        content.lines(&Paths::<Du>::new(&points, &[1, 3]), &pen(2.0, &[1.0]), &mut exact(), tub).unwrap();
        content.area(Paths::new(&points, &[1, 3]), Rule::EvenOdd, Colour::BLACK, &mut exact(), tub).unwrap();
    });
    assert_eq!(text, "1 0 .5 RG,2 w,1 J,5 5 m,5 5 l,6 6 m,6 6 l,S,0 g,");
}

#[test]
fn lines_that_come_back_are_closed() {
    let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::ZERO];
    let text = written(Language::Pdf, |content, tub| {
        content.lines(&Paths::<Du>::new(&square, &[4]), &pen(1.0, &[]), &mut exact(), tub).unwrap();
        let back = [DVec2::ZERO, DVec2::X, DVec2::ZERO];
        content.lines(&Paths::<Du>::new(&back, &[3]), &pen(1.0, &[]), &mut exact(), tub).unwrap();
    });
    assert_eq!(text, "1 0 .5 RG,1 w,0 0 m,1 0 l,1 1 l,h,S,0 0 m,1 0 l,0 0 l,S,");
}

#[test]
fn curves_are_cubics_and_pies_pass_through_their_centre() {
    let (a, b) = (Vector::new(2.0, 0.0), Vector::new(0.0, 1.0));
    let ellipse = Ellipse {
        centre: Point::new(10.0, 10.0),
        a,
        b,
        start: 0.0,
        sweep: std::f64::consts::FRAC_PI_2,
        closure: Closure::Pie,
    };
    let draw = |language| {
        written(language, |content, tub| {
            content.filled(&Curve::Ellipse(ellipse), Colour::BLACK, tub).unwrap();
        })
    };
    assert_eq!(draw(Language::Pdf), "0 g,12 10 m,12 10.55 11.1 11 10 11 c,10 10 l,h,f*,");
    assert_eq!(draw(Language::PostScript), "0 g,1200 1000 m,1200 1055 1110 1100 1000 1100 c,0 -100 r,h,f*,");
    let chain = [DVec2::ZERO; 4];
    let text = written(Language::Pdf, |content, tub| {
        content.stroke(&Curve::Bezier(&chain), &pen(1.0, &[]), tub).unwrap();
        content.stroke(&Curve::Bezier(&[]), &pen(1.0, &[]), tub).unwrap();
    });
    assert_eq!(text, "1 0 .5 RG,1 w,1 J,0 0 m,0 0 l,S,0 J,");
}

#[test]
fn opacity_is_a_named_state_in_pdf() {
    let (mut content, mut tub) = (Content::new(Language::Pdf, 1 << 16), Tub::default());
    content.begin();
    for alpha in [1.0, 0.5, 0.5, 1.0] {
        let colour = Colour { alpha, ..Colour::BLACK };
        content.area(Paths::new(&BEND, &[4]), Rule::NonZero, colour, &mut exact(), &mut tub).unwrap();
    }
    let names: Vec<u8> = content.opacities().iter().copied().collect();
    assert_eq!(names, [128, 255]);
    content.end(&mut tub).unwrap();
    let text = String::from_utf8(tub.0).unwrap();
    assert_eq!((text.matches("/A128 gs").count(), text.matches("/A255 gs").count()), (1, 1));
}

#[test]
fn long_paths_are_drained_on_the_way() {
    let zigzag: Vec<DVec2> = (0..50_000).map(|i| DVec2::new(f64::from(i % 500), f64::from(i % 7))).collect();
    let (mut content, mut tub) = (Content::new(Language::Pdf, 1 << 10), Tub::default());
    content.begin();
    content.lines(&Paths::<Du>::new(&zigzag, &[50_000]), &pen(1.0, &[]), &mut exact(), &mut tub).unwrap();
    assert!(tub.1 > 200, "drained {} times", tub.1);
    assert!(content.text.capacity() < 1 << 12, "{} bytes kept", content.text.capacity());
}

#[test]
fn flat_coordinate_systems_are_refused() {
    let mut content = Content::new(Language::Pdf, 1 << 16);
    assert!(!content.system(DVec2::new(1.0, 2.0), DVec2::new(2.0, 4.0), DVec2::ZERO));
    assert!(!content.system(DVec2::new(1.0, f64::NAN), DVec2::ZERO, DVec2::ZERO));
    assert!(content.text.is_empty());
    assert!(content.system(DVec2::new(12.0, 0.0), DVec2::new(0.0, 12.5), DVec2::new(1.0, f64::INFINITY)));
    assert_eq!(content.text, b"12 0 0 12.5 1 1000000000 ");
}
