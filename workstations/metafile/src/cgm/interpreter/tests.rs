//! Records of metafiles in clear text.

use super::Interpreter;
use crate::cgm::text::decoder::TextDecoder;
use gks_geometry::Rect;
use gks_pipeline::colour::Colour;
use gks_pipeline::item::{Curve, Role, Shape};
use gks_pipeline::look::InteriorStyle;
use gks_pipeline::look_difference::State;
use gks_pipeline::record::{Record, Source};

/// What a metafile draws: each primitive in words, with the state it has.
fn drawn(text: &str) -> Vec<(String, State)> {
    let mut source = Interpreter::new(TextDecoder::new(text.as_bytes()));
    let (mut state, mut all) = (State::default(), Vec::new());
    while let Some(record) = source.next().expect("the text is sound") {
        let words = match record {
            Record::Attribute(attribute) => {
                state.set(attribute);
                continue;
            }
            Record::Primitive(Shape::Polyline(paths)) => {
                let points: Vec<String> =
                    paths.points.iter().map(|p| format!("{:.3} {:.3}", p.x, p.y)).collect();
                format!("lines {}: {}", paths.ends.len(), points.join(", "))
            }
            Record::Primitive(Shape::FillArea(rings)) => format!("area of {} rings", rings.ends.len()),
            Record::Primitive(Shape::Text(at, text)) => format!("text {:.3} {:.3} {text}", at.x(), at.y()),
            Record::Primitive(Shape::CellArray(_, cells)) => {
                let rows: Vec<&[i32]> = (0..cells.rows).map(|row| cells.row(row)).collect();
                format!("cells {rows:?}")
            }
            Record::Primitive(Shape::Polymarker(points)) => format!("{} markers", points.len()),
            Record::Primitive(Shape::Generalized(Curve::Ellipse(e), role)) => {
                let area = if role == Role::Area { "area" } else { "line" };
                let end = e.at(e.start + e.sweep);
                format!(
                    "{area} {:?} from {:.2} by {:.2} to {:.2} {:.2}",
                    e.closure,
                    e.start,
                    e.sweep,
                    end.x(),
                    end.y()
                )
            }
            Record::Primitive(Shape::Generalized(Curve::Bezier(points), _)) => {
                format!("bezier {}", points.len())
            }
            Record::WorkstationWindow(window) => format!("window {:?}", window.limits()),
            Record::ColourRepresentation(index, colour) => format!("colour {index} {:?}", colour.to_bytes()),
            Record::Clear { .. } => "clear".to_owned(),
            other => format!("{other:?}"),
        };
        all.push((words, state.clone()));
    }
    all
}

/// A picture in the unit square with real coordinates.
fn picture(descriptor: &str, body: &str) -> Vec<(String, State)> {
    let text =
        format!("BEGMF 'test'; VDCTYPE real; BEGPIC 'p'; {descriptor} BEGPICBODY; {body} ENDPIC; ENDMF;");
    drawn(&text).into_iter().filter(|(words, _)| words != "clear" && !words.starts_with("window")).collect()
}

fn words(all: &[(String, State)]) -> Vec<&str> {
    all.iter().map(|(words, _)| words.as_str()).collect()
}

#[test]
fn every_picture_begins_with_the_defaults_of_the_metafile() {
    let all = drawn(
        "BEGMF ''; VDCTYPE real; BEGMFDEFAULTS; LINETYPE 3; ENDMFDEFAULTS; \
         BEGPIC 'a'; VDCEXT 0 0 4 2; BEGPICBODY; LINETYPE 2; LINECOLR 5; LINE 0 0 4 2; ENDPIC; \
         BEGPIC 'b'; BEGPICBODY; LINE 0 0 1 1; ENDPIC; ENDMF;",
    );
    let expected = [
        "clear",
        "window [0.0, 1.0, 0.0, 0.5]",
        "lines 1: 0.000 0.000, 1.000 0.500",
        "clear",
        "window [0.0, 1.0, 0.0, 1.0]",
        "lines 1: 0.000 0.000, 1.000 1.000",
    ];
    assert_eq!(words(&all), expected);
    let look = |i: usize| (all[i].1.look.line.linetype, all[i].1.look.line.colour);
    assert_eq!((look(2), look(5)), ((2, 5), (3, 1)));
}

#[test]
fn direct_colours_take_indices_that_have_them_or_new_ones() {
    let all = picture("COLRMODE direct;", "LINECOLR 1 2 3; LINE 0 0 1 1; LINECOLR 255 0 0; LINE 0 0 1 0;");
    assert_eq!(all.len(), 3);
    assert!(all[0].0.starts_with("colour") && all[0].0.ends_with("[1, 2, 3, 255]"), "{}", all[0].0);
    let red = gks_pipeline::tables::Tables::predefined().paint(all[2].1.look.line.colour).colour;
    assert_eq!(red, Colour::rgb(1.0, 0.0, 0.0));
    assert!(all[1].1.look.line.colour > 30);
}

#[test]
fn edges_are_lines_around_areas() {
    let style = "INTSTYLE solid; EDGEVIS on; EDGEWIDTH 3; EDGECOLR 2;";
    let all = picture("", &format!("{style} RECT 0 0 1 1; INTSTYLE empty; CIRCLE 0.5 0.5 0.25;"));
    let expected =
        ["area of 1 rings", "lines 1: 0.000 0.000, 1.000 0.000, 1.000 1.000, 0.000 1.000, 0.000 0.000"];
    assert_eq!(words(&all)[..2], expected);
    assert_eq!((all[0].1.look.fill.interior, all[1].1.look.line.width), (InteriorStyle::Solid, 3.0));
    assert_eq!(words(&all)[2..], ["line Full from 0.00 by 6.28 to 0.75 0.50"]);
    let set = picture(
        "",
        &format!("{style} POLYGONSET 0 0 vis 1 0 invis 1 1 closevis .2 .2 vis .4 .2 vis .4 .4 closevis;"),
    );
    assert_eq!(set[0].0, "area of 2 rings");
    assert!(set[1].0.starts_with("lines 3: "), "{}", set[1].0);
}

#[test]
fn arcs_go_in_positive_direction() {
    let all =
        picture("", "ARCCTR .5 .5 0 1 1 0 .5; ARCCTRCLOSE .5 .5 1 0 0 1 .5 chord; ARC3PT 0 0 .5 .5 1 0;");
    let expected = [
        "line Open from 1.57 by 4.71 to 1.00 0.50",
        "area Chord from 0.00 by 1.57 to 0.50 1.00",
        "line Open from 3.14 by -3.14 to 1.00 0.00",
    ];
    assert_eq!(words(&all), expected);
    let ellipse = picture("", "ELLIPARC .5 .5 .9 .5 .5 .7 1 0 -1 0;");
    assert_eq!(words(&ellipse), ["line Open from 0.00 by 3.14 to 0.10 0.50"]);
}

#[test]
fn text_comes_in_parts_and_has_the_fonts_of_the_list() {
    let body =
        "TEXTFONTINDEX 2; CHARHEIGHT 0.1; CHARORI -1 0 0 2; TEXT 0 0 notfinal 'ab'; APNDTEXT final 'c';";
    let text = format!(
        "BEGMF ''; VDCTYPE real; FONTLIST 'Courier' 'Times-Bold'; BEGPIC ''; BEGPICBODY; {body} ENDPIC; ENDMF;"
    );
    let all = drawn(&text);
    let (words, state) = all.last().expect("a text");
    assert_eq!(words, "text 0.000 0.000 abc");
    assert_eq!(state.look.text.font, -26);
    let geometry = &state.look.text_geometry;
    assert!((geometry.height.x() + 0.1).abs() < 1e-12 && (geometry.width.y() - 0.2).abs() < 1e-12);
}

#[test]
fn restricted_text_shrinks() {
    let all = picture("", "CHARHEIGHT 0.1; RESTRTEXT .2 1 0 0 final 'much too long for it';");
    assert!(all[0].1.look.text_geometry.height.length() < 0.05);
}

#[test]
fn figures_are_areas() {
    let all = picture(
        "",
        "INTSTYLE solid; BEGFIGURE; LINE 0 0 1 0 1 1; LINE 1 1 0 1; NEWREGION; CIRCLE .5 .5 .1; ENDFIGURE;",
    );
    assert_eq!(words(&all), ["area of 2 rings"]);
}

#[test]
fn segments_are_copied_with_a_transformation() {
    let all = picture("", "BEGSEG 1; LINE 0 0 .5 0; ENDSEG; COPYSEG 1 0 -1 1 0 .5 .25 no; LINE 0 0 1 1;");
    let expected = [
        "lines 1: 0.000 0.000, 0.500 0.000",
        "lines 1: 0.500 0.250, 0.500 0.750",
        "lines 1: 0.000 0.000, 1.000 1.000",
    ];
    assert_eq!(words(&all), expected);
}

#[test]
fn segments_that_copy_themselves_come_to_an_end() {
    let inner = "COPYSEG 1 1 0 0 1 0 0 no; ".repeat(4);
    let all = picture("", &format!("BEGSEG 1; LINE 0 0 .5 0; {inner} ENDSEG; COPYSEG 1 1 0 0 1 0 0 no;"));
    assert!(all.len() > 10);
}

#[test]
fn clipping_follows_rectangle_and_indicator() {
    let all = picture("", "CLIPRECT .1 .2 .3 .4; LINE 0 0 1 1; CLIP off; LINE 0 0 1 1;");
    assert_eq!(all[0].1.clip, Rect::new(0.1, 0.3, 0.2, 0.4));
    assert_eq!(all[1].1.clip, Rect::UNIT);
}

#[test]
fn cells_keep_their_indices() {
    let all = picture("", "CELLARRAY 0 1 1 0 1 1 2 2 0 1 2 3 4;");
    assert_eq!(words(&all), ["cells [[1, 2], [3, 4]]"]);
}

#[test]
fn line_types_of_the_metafile_are_drawn_dash_by_dash() {
    let descriptor = "LINEWIDTHMODE abs; LINEEDGETYPEDEF -20 .4 3 1; LINEWIDTHMODE scaled;";
    let lines = "LINE 0 0 1 0; LINETYPEINITOFFSET .75; LINE 0 0 1 0;";
    let all = picture(descriptor, &format!("LINETYPE -20; {lines}"));
    let expected = [
        "lines 3: 0.000 0.000, 0.300 0.000, 0.400 0.000, 0.700 0.000, 0.800 0.000, 1.000 0.000",
        "lines 3: 0.100 0.000, 0.400 0.000, 0.500 0.000, 0.800 0.000, 0.900 0.000, 1.000 0.000",
    ];
    assert_eq!(words(&all), expected);
    assert_eq!(all[0].1.look.line.linetype, 1);
}

#[test]
fn dashes_begin_anew_at_corners_where_it_is_said() {
    let descriptor = "LINEWIDTHMODE abs; LINEEDGETYPEDEF -20 .8 1 1;";
    let all = picture(descriptor, "LINETYPE -20; LINETYPECONT 3; LINE 0 0 .6 0 .6 .6;");
    assert_eq!(words(&all), ["lines 2: 0.000 0.000, 0.400 0.000, 0.600 0.000, 0.600 0.400"]);
    let all = picture(descriptor, "LINETYPE -20; LINETYPECONT 2; LINE 0 0 .6 0 .6 .6;");
    assert_eq!(words(&all), ["lines 2: 0.000 0.000, 0.400 0.000, 0.600 0.200, 0.600 0.600"]);
    // A linetype of the standard remains one unless it is drawn in another way than ours.
    let all = picture("", "LINETYPE 2; LINE 0 0 1 0; LINETYPEINITOFFSET .5; LINE 0 0 1 0;");
    assert_eq!((all[0].1.look.line.linetype, all[1].1.look.line.linetype), (2, 1));
}

#[test]
fn a_line_type_defined_like_one_of_ours_is_ours() {
    let all = picture("LINEEDGETYPEDEF -2 32 24 8;", "LINETYPE -2; LINE 0 0 1 0;");
    assert_eq!(words(&all), ["lines 1: 0.000 0.000, 1.000 0.000"]);
    assert_eq!(all[0].1.look.line.linetype, -2);
}

#[test]
fn the_auxiliary_colour_is_between_dashes_and_lines_of_hatches() {
    let style = "AUXCOLR 3; LINECOLR 2; FILLCOLR 2; INTSTYLE hatch; LINETYPE 2;";
    let all = picture("", &format!("{style} TRANSPARENCY off; LINE 0 0 1 0; RECT 0 0 1 1;"));
    let lines: Vec<_> = all[..2].iter().map(|(_, s)| (s.look.line.linetype, s.look.line.colour)).collect();
    assert_eq!(lines, [(1, 3), (2, 2)]);
    let areas: Vec<_> = all[2..].iter().map(|(_, s)| (s.look.fill.interior, s.look.fill.colour)).collect();
    assert_eq!(areas, [(InteriorStyle::Solid, 3), (InteriorStyle::Hatch, 2)]);
    let all = picture(
        "",
        &format!("{style} LINE 0 0 1 0; RECT 0 0 1 1; TRANSPARENCY off; LINETYPE 1; LINE 0 0 1 0;"),
    );
    assert_eq!(all.len(), 3);
}

#[test]
fn hatch_styles_of_the_metafile_are_lines() {
    let descriptor = "HATCHSTYLEDEF -20 parallel 1 0 0 1 .5 2 3 1 1 2;";
    let all =
        picture(descriptor, "INTSTYLE hatch; HATCHINDEX -20; FILLCOLR 2; FILLREFPT 0 .1; RECT 0 0 .8 1;");
    let expected = [
        "lines 2: 0.000 0.100, 0.800 0.100, 0.000 0.600, 0.800 0.600",
        "lines 2: 0.000 0.475, 0.800 0.475, 0.000 0.975, 0.800 0.975",
    ];
    assert_eq!(words(&all), expected);
    let looks: Vec<_> = all.iter().map(|(_, s)| (s.look.line.linetype, s.look.line.colour)).collect();
    assert_eq!(looks, [(1, 2), (2, 2)]);
    let crossed = "HATCHSTYLEDEF -20 crosshatch 1 0 0 1 .4 1 1 1;";
    let all = picture(crossed, "INTSTYLE hatch; HATCHINDEX -20; FILLREFPT .1 .1; CIRCLE .5 .5 .5;");
    assert!(all.len() == 2 && all.iter().all(|(words, _)| words.starts_with("lines 3:")), "{all:?}");
}

#[test]
fn figures_have_edges_between_their_lines_only_where_they_are_connected() {
    let edges = |body: &str| {
        let all = picture("", &format!("INTSTYLE empty; EDGEVIS on; BEGFIGURE; {body} ENDFIGURE;"));
        words(&all).iter().map(|words| words.split(':').next().unwrap_or("").to_owned()).collect::<Vec<_>>()
    };
    let (first, second) = ("LINE 0 0 1 0;", "LINE 1 1 0 1;");
    assert_eq!(edges(&format!("{first} {second}")), ["lines 2"]);
    assert_eq!(edges(&format!("{first} CONNEDGE; {second}")), ["lines 3"]);
    assert_eq!(edges(&format!("{first} CONNEDGE; {second} CONNEDGE;")), ["lines 4"]);
    assert_eq!(edges(&format!("{first} CONNEDGE; NEWREGION; {second}")), ["lines 3"]);
}

#[test]
fn segments_have_transformations() {
    let moved = "SEGTRAN 1 1 0 0 1 .25 0;";
    let all = picture(
        "",
        &format!(
            "CLIPRECT 0 0 .5 .5; BEGSEG 1; {moved} LINE 0 0 .5 0; ENDSEG; CLIP off; LINE 0 0 .5 0; \
             COPYSEG 1 1 0 0 1 0 .5 no; COPYSEG 1 1 0 0 1 0 .5 yes; LINE 0 0 1 0;"
        ),
    );
    let expected = [
        "lines 1: 0.250 0.000, 0.750 0.000",
        "lines 1: 0.000 0.000, 0.500 0.000",
        "lines 1: 0.000 0.500, 0.500 0.500",
        "lines 1: 0.250 0.500, 0.750 0.500",
        "lines 1: 0.000 0.000, 1.000 0.000",
    ];
    assert_eq!(words(&all), expected);
    assert_eq!((all[0].1.clip, all[1].1.clip), (Rect::new(0.0, 0.5, 0.0, 0.5), Rect::UNIT));
    // Said before the segment begins, it holds as well.
    let all = picture("", &format!("{moved} BEGSEG 1; LINE 0 0 .5 0; ENDSEG; LINE 0 0 .5 0;"));
    assert_eq!(words(&all), expected[..2]);
}

#[test]
fn copies_are_clipped_by_both_rectangles_or_by_the_one_outside() {
    let segment = "BEGSEG 1; CLIPRECT 0 0 .5 1; LINE 0 0 1 1; ENDSEG; CLIPRECT .4 .4 1 1;";
    let clips = |inheritance: &str| {
        let all = picture("", &format!("{segment} {inheritance} COPYSEG 1 1 0 0 1 .25 0 no; LINE 0 0 1 1;"));
        [all[1].1.clip, all[2].1.clip]
    };
    let outside = Rect::new(0.4, 1.0, 0.4, 1.0);
    let both = Rect::new(0.4, 0.75, 0.4, 1.0);
    assert_eq!(clips(""), [both, outside]);
    assert_eq!(clips("CLIPINH inters;"), [both, outside]);
    assert_eq!(clips("CLIPINH stlist;"), [outside, outside]);
}
