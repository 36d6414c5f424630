//! Representations: the entries of the bundle, pattern and colour tables of a workstation.

use crate::attributes::{NOT_A_NUMBER, index, nonzero, real};
use crate::gks::device_error;
use crate::{Error, Function, Gks, Result};
use gks_pipeline::colour::Colour;
use gks_pipeline::generated::numbers;
use gks_pipeline::item::Cells;
use gks_pipeline::look::{FillBundle, InteriorStyle, LineBundle, MarkerBundle, Precision, TextBundle};
use gks_pipeline::record::Record;
use gks_pipeline::tables::Pattern;
use gks_pipeline::workstation::Workstation;

impl Gks {
    /// SET POLYLINE REPRESENTATION: what a polyline index means on a workstation.
    ///
    /// The linewidth is a multiple of the nominal linewidth. Errors: 7, 20, 25, 33, 35, 36, 60 (index),
    /// 63 (linetype 0), 64 (no such linetype), 65 (negative linewidth), 93 (colour index).
    pub fn set_polyline_representation(
        &mut self,
        id: i32,
        line_index: i32,
        linetype: i32,
        linewidth: f64,
        colour: i32,
    ) -> Result<()> {
        const F: Function = Function::SetPolylineRepresentation;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let line_index = entry(F, 60, line_index, numbers::MAX_POLYLINE_BUNDLES)?;
        nonzero(F, 63, linetype)?;
        available(F, 64, linetype, numbers::LINETYPES.iter().map(|l| l.number))?;
        let width = real(F, 65, linewidth, |v| v >= 0.0)?;
        let colour = colour_index(F, workstation, colour)?;
        represent(
            F,
            workstation,
            &Record::LineRepresentation(line_index, LineBundle { linetype, width, colour }),
        )
    }

    /// SET POLYMARKER REPRESENTATION: what a polymarker index means on a workstation.
    ///
    /// The size is a multiple of the nominal marker size. Errors: 7, 20, 25, 33, 35, 36, 66 (index),
    /// 69 (marker type 0), 70 (no such marker type), 71 (negative size), 93 (colour index).
    pub fn set_polymarker_representation(
        &mut self,
        id: i32,
        marker_index: i32,
        kind: i32,
        size: f64,
        colour: i32,
    ) -> Result<()> {
        const F: Function = Function::SetPolymarkerRepresentation;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let marker_index = entry(F, 66, marker_index, numbers::MAX_POLYMARKER_BUNDLES)?;
        nonzero(F, 69, kind)?;
        available(F, 70, kind, numbers::MARKERS.iter().map(|m| m.number))?;
        let size = real(F, 71, size, |v| v >= 0.0)?;
        let colour = colour_index(F, workstation, colour)?;
        let bundle = MarkerBundle { kind, size, colour };
        represent(F, workstation, &Record::MarkerRepresentation(marker_index, bundle))
    }

    /// SET TEXT REPRESENTATION: what a text index means on a workstation.
    ///
    /// Every font is available in every precision. The spacing is in character heights. Errors: 7, 20, 25,
    /// 33, 35, 36, 72 (index), 75 (font 0), 76 (no such font), 77 (expansion factor not positive), 93
    /// (colour index), 308 (spacing not a number).
    #[allow(clippy::too_many_arguments, reason = "the parameters of the standard")]
    pub fn set_text_representation(
        &mut self,
        id: i32,
        text_index: i32,
        font: i32,
        precision: Precision,
        expansion: f64,
        spacing: f64,
        colour: i32,
    ) -> Result<()> {
        const F: Function = Function::SetTextRepresentation;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let text_index = entry(F, 72, text_index, numbers::MAX_TEXT_BUNDLES)?;
        nonzero(F, 75, font)?;
        available(F, 76, font, numbers::FONTS.iter().map(|f| f.number))?;
        let expansion = real(F, 77, expansion, |v| v > 0.0)?;
        let colour = colour_index(F, workstation, colour)?;
        let spacing = real(F, NOT_A_NUMBER, spacing, |_| true)?;
        let bundle = TextBundle { font, precision, expansion, spacing, colour };
        represent(F, workstation, &Record::TextRepresentation(text_index, bundle))
    }

    /// SET FILL AREA REPRESENTATION: what a fill area index means on a workstation.
    ///
    /// The style index counts only for the interior styles PATTERN and HATCH. Errors: 7, 20, 25, 33, 35, 36,
    /// 80 (index), 85 (PATTERN: pattern index), 86 (HATCH: no such hatch style), 93 (colour index).
    pub fn set_fill_area_representation(
        &mut self,
        id: i32,
        fill_index: i32,
        interior: InteriorStyle,
        style: i32,
        colour: i32,
    ) -> Result<()> {
        const F: Function = Function::SetFillAreaRepresentation;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let fill_index = entry(F, 80, fill_index, numbers::MAX_FILL_AREA_BUNDLES)?;
        match interior {
            InteriorStyle::Hollow | InteriorStyle::Solid => {}
            InteriorStyle::Pattern => {
                entry(F, 85, style, numbers::MAX_PATTERNS)?;
            }
            InteriorStyle::Hatch => available(F, 86, style, numbers::HATCHES.iter().map(|h| h.number))?,
        }
        let colour = colour_index(F, workstation, colour)?;
        let bundle = FillBundle { interior, style, colour };
        represent(F, workstation, &Record::FillRepresentation(fill_index, bundle))
    }

    /// SET PATTERN REPRESENTATION: the cells of a pattern on a workstation, the upper row first.
    ///
    /// Errors: 7, 20, 25, 33, 35, 36, 85 (pattern index), 93 (a colour index).
    pub fn set_pattern_representation(
        &mut self,
        id: i32,
        pattern_index: i32,
        cells: &Cells<'_>,
    ) -> Result<()> {
        self.pattern_representation(id, pattern_index, || Ok(*cells))
    }

    /// SET PATTERN REPRESENTATION from an array as bindings have it: `columns` x `rows` cells, rows `stride`
    /// indices apart.
    ///
    /// Errors: 7, 20, 25, 33, 35, 36, 85 (pattern index), 91 (a dimension is not positive, or the array too
    /// small), 93 (a colour index).
    pub fn set_pattern_representation_of(
        &mut self,
        id: i32,
        pattern_index: i32,
        indices: &[i32],
        columns: usize,
        rows: usize,
        stride: usize,
    ) -> Result<()> {
        const F: Function = Function::SetPatternRepresentation;
        self.pattern_representation(id, pattern_index, || {
            Cells::new(indices, columns, rows, stride)
                .ok_or_else(|| Error::new(91, F).because(format!("{columns} x {rows} cells")))
        })
    }

    fn pattern_representation<'c>(
        &mut self,
        id: i32,
        pattern_index: i32,
        cells: impl FnOnce() -> Result<Cells<'c>>,
    ) -> Result<()> {
        const F: Function = Function::SetPatternRepresentation;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let pattern_index = entry(F, 85, pattern_index, numbers::MAX_PATTERNS)?;
        let cells = cells()?;
        let mut indices = Vec::with_capacity(cells.columns * cells.rows);
        for row in 0..cells.rows {
            for &index in cells.row(row) {
                colour_index(F, workstation, index)?;
                indices.push(index);
            }
        }
        let pattern = Pattern { columns: cells.columns, rows: cells.rows, indices };
        represent(F, workstation, &Record::PatternRepresentation(pattern_index, &pattern))
    }

    /// SET COLOUR REPRESENTATION: what a colour index means on a workstation; index 0 is the background.
    ///
    /// A colour without opacity of its own is opaque again, whatever [`Gks::set_colour_alpha`] set before.
    /// Errors: 7, 20, 25, 33, 35, 36, 93 (index), 96 (a component not in 0 to 1), 303.
    pub fn set_colour_representation(
        &mut self,
        id: i32,
        index: i32,
        colour: impl Into<Colour>,
    ) -> Result<()> {
        const F: Function = Function::SetColourRepresentation;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let index = colour_index(F, workstation, index)?;
        let colour: Colour = colour.into();
        if !colour.is_valid() {
            return Err(Error::new(96, F).because(format!("{colour:?}")));
        }
        represent(F, workstation, &Record::ColourRepresentation(index, colour))
    }

    /// Sets the opacity of a colour index on a workstation, from 0, which leaves what is below, to 1.
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Errors: 8, 20, 25, 93 (index), 94 (the index
    /// has no representation), 96 (not in 0 to 1), 303.
    pub fn set_colour_alpha(&mut self, id: i32, index: i32, alpha: f64) -> Result<()> {
        const F: Function = Function::Escape;
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let index = colour_index(F, workstation, index)?;
        let Some(colour) = workstation.tables().colours.get(index) else {
            return Err(Error::new(94, F).because(format!("colour index {index}")));
        };
        let alpha = real(F, 96, alpha, |v| (0.0..=1.0).contains(&v))? as f32;
        represent(F, workstation, &Record::ColourRepresentation(index, Colour { alpha, ..colour }))
    }
}

/// Changes an entry of a table. Error: 303.
fn represent(function: Function, workstation: &mut Workstation, record: &Record<'_>) -> Result<()> {
    workstation.represent(record).map_err(|e| device_error(function, &e))
}

/// Checks an index of a table whose entries count from 1 to `most`.
fn entry(function: Function, error: i32, value: i32, most: u32) -> Result<u32> {
    index(function, error, value).and_then(|i| {
        if i <= most { Ok(i) } else { Err(Error::new(error, function).because(format!("index {i}"))) }
    })
}

/// Checks that a type or style is among those that this library has.
fn available(
    function: Function,
    error: i32,
    value: i32,
    mut numbers: impl Iterator<Item = i32>,
) -> Result<()> {
    if numbers.any(|n| n == value) {
        Ok(())
    } else {
        Err(Error::new(error, function).because(format!("number {value}")))
    }
}

/// Checks a colour index against the length of the colour table of a workstation. Error: 93.
fn colour_index(function: Function, workstation: &Workstation, value: i32) -> Result<u32> {
    let length = workstation.description().colour_table_length();
    u32::try_from(value)
        .ok()
        .filter(|&i| i < length)
        .ok_or_else(|| Error::new(93, function).because(format!("colour index {value}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{CATEGORIES, Drawing, INDEXED, PLAIN, active, closed, number, open};
    use gks_pipeline::description::Category;
    use gks_pipeline::look::AspectSourceFlags;

    const LINE: [(f64, f64); 2] = [(0.0, 0.0), (1.0, 1.0)];

    /// All functions of this file with valid arguments for workstation `id`.
    fn all(gks: &mut Gks, id: i32) -> [Result<()>; 7] {
        let cells = Cells::new(&[0, 1], 2, 1, 2).unwrap();
        [
            gks.set_polyline_representation(id, 1, 1, 1.0, 1),
            gks.set_polymarker_representation(id, 1, 1, 1.0, 1),
            gks.set_text_representation(id, 1, 1, Precision::Stroke, 1.0, 0.0, 1),
            gks.set_fill_area_representation(id, 1, InteriorStyle::Solid, 1, 1),
            gks.set_pattern_representation(id, 1, &cells),
            gks.set_pattern_representation_of(id, 1, &[0, 1], 1, 2, 1),
            gks.set_colour_representation(id, 1, (0.0, 0.5, 1.0)),
        ]
    }

    #[test]
    fn states_identifiers_and_categories_are_checked_in_this_order() {
        assert!(all(&mut closed(), -1).map(number).iter().all(|&n| n == 7));
        let (mut gks, _) = open(&[]);
        assert!(all(&mut gks, -1).map(number).iter().all(|&n| n == 7));
        assert_eq!(number(gks.set_colour_alpha(-1, 1, 0.5)), 20);
        let kinds = [Category::MetafileInput, Category::Input, Category::Wiss, Category::MetafileOutput];
        let (mut gks, _) = open(&kinds.map(|category| CATEGORIES + category as i32));
        assert!(all(&mut gks, 0).map(number).iter().all(|&n| n == 20));
        assert!(all(&mut gks, 9).map(number).iter().all(|&n| n == 25));
        for (id, error) in [(1, 33), (2, 35), (3, 36)] {
            assert!(all(&mut gks, id).map(number).iter().all(|&n| n == error));
        }
        assert!(all(&mut gks, 4).iter().all(Result::is_ok));
    }

    #[test]
    fn bundles_with_wrong_values_are_refused_and_change_nothing() {
        let (mut gks, _) = open(&[PLAIN]);
        let before = gks.workstations[&1].workstation.tables().clone();
        let line = |gks: &mut Gks, i, t, w, c| number(gks.set_polyline_representation(1, i, t, w, c));
        assert_eq!([0, -1, 1025].map(|i| line(&mut gks, i, 0, -1.0, -1)), [60; 3]);
        assert_eq!(line(&mut gks, 1, 0, -1.0, -1), 63);
        assert_eq!([5, -7, -9999].map(|t| line(&mut gks, 1, t, -1.0, -1)), [64; 3]);
        assert_eq!([-0.5, f64::NAN].map(|w| line(&mut gks, 1, 1, w, -1)), [65; 2]);
        assert_eq!([-1, 65_536].map(|c| line(&mut gks, 1, 1, 1.0, c)), [93; 2]);
        let marker = |gks: &mut Gks, i, t, s, c| number(gks.set_polymarker_representation(1, i, t, s, c));
        assert_eq!(marker(&mut gks, 0, 0, -1.0, -1), 66);
        assert_eq!(marker(&mut gks, 1, 0, -1.0, -1), 69);
        assert_eq!(marker(&mut gks, 1, 6, -1.0, -1), 70);
        assert_eq!(marker(&mut gks, 1, -12, -1.0, -1), 71);
        assert_eq!(marker(&mut gks, 1, 3, 0.0, -1), 93);
        let text = |gks: &mut Gks, i, f, e, s, c| {
            number(gks.set_text_representation(1, i, f, Precision::Char, e, s, c))
        };
        assert_eq!(text(&mut gks, 0, 0, 0.0, f64::NAN, -1), 72);
        assert_eq!(text(&mut gks, 1, 0, 0.0, f64::NAN, -1), 75);
        assert_eq!([2, -1, -35].map(|f| text(&mut gks, 1, f, 0.0, f64::NAN, -1)), [76; 3]);
        assert_eq!(text(&mut gks, 1, -34, 0.0, f64::NAN, -1), 77);
        assert_eq!(text(&mut gks, 1, 1, 1.0, f64::NAN, -1), 93);
        assert_eq!(text(&mut gks, 1, 1, 1.0, f64::NAN, 1), 308);
        let fill = |gks: &mut Gks, i, s, x, c| number(gks.set_fill_area_representation(1, i, s, x, c));
        assert_eq!(fill(&mut gks, 0, InteriorStyle::Pattern, 0, -1), 80);
        assert_eq!([0, -1, 1025].map(|s| fill(&mut gks, 1, InteriorStyle::Pattern, s, -1)), [85; 3]);
        assert_eq!([0, 7, -13].map(|s| fill(&mut gks, 1, InteriorStyle::Hatch, s, -1)), [86; 3]);
        assert_eq!(fill(&mut gks, 1, InteriorStyle::Hollow, 0, -1), 93);
        assert_eq!(*gks.workstations[&1].workstation.tables(), before);
    }

    #[test]
    fn patterns_and_colours_with_wrong_values_are_refused() {
        let (mut gks, _) = open(&[PLAIN, INDEXED]);
        let before = gks.workstations[&1].workstation.tables().clone();
        let pattern = |gks: &mut Gks, i, c: &[i32], x, y, stride| {
            number(gks.set_pattern_representation_of(1, i, c, x, y, stride))
        };
        assert_eq!(pattern(&mut gks, 0, &[-1], 0, 0, 0), 85);
        assert_eq!(pattern(&mut gks, 1, &[-1], 0, 1, 1), 91);
        assert_eq!(pattern(&mut gks, 1, &[-1], 1, 2, 1), 91);
        assert_eq!(pattern(&mut gks, 1, &[-1], usize::MAX, usize::MAX, usize::MAX), 91);
        assert_eq!(pattern(&mut gks, 1, &[1, -1], 2, 1, 2), 93);
        for components in [(1.5, 0.0, 0.0), (0.0, -0.1, 0.0), (0.0, 0.0, f64::NAN)] {
            assert_eq!(number(gks.set_colour_representation(1, -1, components)), 93);
            assert_eq!(number(gks.set_colour_representation(1, 1, components)), 96);
        }
        assert_eq!(number(gks.set_colour_representation(2, 256, (0.0, 0.0, 0.0))), 93);
        assert_eq!(number(gks.set_colour_alpha(1, -1, 2.0)), 93);
        assert_eq!(number(gks.set_colour_alpha(1, 60_000, 2.0)), 94);
        assert_eq!([2.0, -0.1, f64::NAN].map(|a| number(gks.set_colour_alpha(1, 1, a))), [96; 3]);
        assert_eq!(*gks.workstations[&1].workstation.tables(), before);
        gks.set_colour_representation(1, 65_535, (0.0, 0.0, 0.0)).unwrap();
        gks.set_colour_representation(2, 255, (0.0, 0.0, 0.0)).unwrap();
    }

    #[test]
    fn each_workstation_draws_by_its_own_representation() {
        let (mut gks, log) = active(&[PLAIN, PLAIN]);
        gks.set_aspect_source_flags(AspectSourceFlags::BUNDLED).unwrap();
        gks.set_polyline_index(7).unwrap();
        gks.set_polyline_representation(1, 7, 2, 3.0, 5).unwrap();
        gks.polyline(&LINE).unwrap();
        let marks = log.marks();
        let [(Drawing::Lines(_, first), None), (Drawing::Lines(_, second), None)] = &marks[..] else {
            panic!("{marks:?}")
        };
        assert_eq!((first.paint.index, first.width, first.dash.len()), (5, 3.0, 2));
        // Index 7 has no representation on the second workstation, which takes index 1 instead.
        assert_eq!((second.paint.index, second.width, second.dash.len()), (1, 1.0, 0));
    }

    #[test]
    fn markers_and_areas_follow_their_representations() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_aspect_source_flags(AspectSourceFlags::BUNDLED).unwrap();
        gks.set_polymarker_representation(1, 1, -9, 2.0, 4).unwrap();
        gks.polymarker(&[(0.5, 0.5)]).unwrap();
        let (Drawing::Markers(_, style), None) = log.mark() else { panic!("no markers") };
        assert_eq!((style.kind, style.size, style.paint.index), (-9, 12.0, 4));
        gks.set_fill_area_representation(1, 1, InteriorStyle::Pattern, 9, 3).unwrap();
        gks.set_pattern_representation_of(1, 9, &[1, 2, 9, 3, 4, 9], 2, 2, 3).unwrap();
        gks.fill_area(&[(0.2, 0.2), (0.8, 0.2), (0.5, 0.8)]).unwrap();
        let (Drawing::Patterned(rings, _, table), None) = log.mark() else { panic!("no pattern") };
        assert_eq!((rings[0].len(), table.columns, &table.indices[..]), (3, 2, &[1, 2, 3, 4][..]));
        gks.set_fill_area_representation(1, 1, InteriorStyle::Solid, 0, 3).unwrap();
        gks.fill_area(&[(0.2, 0.2), (0.8, 0.2), (0.5, 0.8)]).unwrap();
        let (Drawing::Area(_, _, paint), None) = log.mark() else { panic!("no area") };
        assert_eq!(paint.index, 3);
    }

    #[test]
    fn colours_and_their_opacity_arrive() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_colour_representation(1, 1, (0.25, 0.5, 0.75)).unwrap();
        gks.set_colour_alpha(1, 1, 0.5).unwrap();
        gks.polyline(&LINE).unwrap();
        let (Drawing::Lines(_, pen), _) = log.mark() else { panic!("no line") };
        assert_eq!(pen.paint.colour, Colour { red: 0.25, green: 0.5, blue: 0.75, alpha: 0.5 });
        gks.set_colour_representation(1, 1, (1.0, 0.0, 0.0)).unwrap();
        gks.polyline(&LINE).unwrap();
        let (Drawing::Lines(_, pen), _) = log.mark() else { panic!("no line") };
        assert_eq!(pen.paint.colour, Colour::rgb(1.0, 0.0, 0.0));
    }
}
