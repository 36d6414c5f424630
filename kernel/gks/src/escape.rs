//! Escapes: what this library offers beyond the standard, in the form that every language binding has.

use crate::attributes::real;
use crate::gks::device_error;
use crate::{DataRecord, Error, Function, Gks, Result};
use gks_pipeline::generated::numbers::{ESCAPES, escape};
use gks_pipeline::look::{Cap, ClipSector, Join};
use gks_pipeline::record::Record;
use gks_pipeline::tables::{NominalSize, Primitives};

const F: Function = Function::Escape;

impl Gks {
    /// ESCAPE: calls the function of this library with an identifier of [`escape`], and gives its output data
    /// record, empty for most.
    ///
    /// Errors: 8, 180 (no such function), 181 (identifier 0), 182 (data record: the wrong number of values,
    /// or a value that the function refuses), 303.
    pub fn escape(&mut self, id: i32, record: &DataRecord) -> Result<DataRecord> {
        self.check_state(F)?;
        if id == 0 {
            return Err(Error::new(181, F));
        }
        let Some(kind) = ESCAPES.iter().find(|kind| kind.number == id) else {
            return Err(Error::new(180, F).because(format!("identifier {id}")));
        };
        let (integers, reals) = (record.integers.as_slice(), record.reals.as_slice());
        if (integers.len(), reals.len(), record.strings.len()) != (kind.integers, kind.reals, 0) {
            let wanted = format!("{} integers and {} reals wanted", kind.integers, kind.reals);
            return Err(Error::new(182, F).because(wanted));
        }
        let invalid = |value: i32| Error::new(182, F).because(format!("value {value}"));
        let done = match (id, integers, reals) {
            (escape::SET_LINE_CAP, &[cap], _) => {
                self.set_line_cap(Cap::from_number(cap).ok_or_else(|| invalid(cap))?)
            }
            (escape::SET_LINE_JOIN, &[join], _) => {
                self.set_line_join(Join::from_number(join).ok_or_else(|| invalid(join))?)
            }
            (escape::SET_COLOUR_ALPHA, &[workstation, index], &[alpha]) => {
                self.set_colour_alpha(workstation, index, alpha)
            }
            (escape::SET_ANTIALIASING, &[workstation, on @ (0 | 1)], _) => {
                self.set_antialiasing(workstation, on == 1)
            }
            (escape::SET_ANTIALIASING, &[_, on], _) => Err(invalid(on)),
            (escape::INQUIRE_ANTIALIASING, &[workstation], _) => {
                let on = self.antialiasing(workstation).map_err(of_record)?;
                return Ok(DataRecord::new(&[on.into()], &[], &[]));
            }
            (escape::SET_OPACITY, &[workstation, primitives], &[opacity]) => {
                let primitives = Primitives::from_number(primitives).ok_or_else(|| invalid(primitives))?;
                self.set_opacity(workstation, primitives, opacity)
            }
            (escape::SET_NOMINAL_SIZE, &[workstation, size], &[factor]) => {
                let size = NominalSize::from_number(size).ok_or_else(|| invalid(size))?;
                self.set_nominal_size(workstation, size, factor)
            }
            (escape::SET_CLIP_SECTOR, &[on @ (0 | 1)], &[start, end]) => {
                self.set_clip_sector((on == 1).then_some(ClipSector { start, end }))
            }
            (escape::SET_CLIP_SECTOR, &[on], _) => Err(invalid(on)),
            (escape::SELECT_CLIPPING_TRANSFORMATION, &[number], _) => {
                self.select_clipping_transformation(number)
            }
            // What it says is for those who read metafiles.
            (escape::COMPOUND_PRIMITIVE, _, _) => Ok(()),
            _ => Err(Error::new(180, F).because(format!("identifier {id}"))),
        };
        done.map(|()| DataRecord::default()).map_err(of_record)
    }

    /// Turns antialiasing on or off for what is drawn on a workstation from now on; without effect where
    /// there is no choice.
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Errors: 8, 20, 25, 303.
    pub fn set_antialiasing(&mut self, id: i32, on: bool) -> Result<()> {
        self.check_state(F)?;
        let workstation = &mut self.workstation_mut(F, id)?.workstation;
        workstation.set_antialiasing(on);
        let record = DataRecord::new(&[0, on.into()], &[], &[]).pack(1)?;
        let record = Record::Escape(escape::SET_ANTIALIASING, record.as_flattened());
        workstation.control(&record).map_err(|e| device_error(F, &e))
    }

    /// Sets how opaque primitives of a kind are drawn on a workstation, from 0 to 1, on top of the opacity of
    /// their colours. Segments that are drawn again have the opacity of that moment.
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Errors: 8, 20, 25, 33, 35, 36, 96 (not in 0 to
    /// 1), 303.
    pub fn set_opacity(&mut self, id: i32, primitives: Primitives, opacity: f64) -> Result<()> {
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let opacity = real(F, 96, opacity, |v| (0.0..=1.0).contains(&v))?;
        *workstation.tables_mut().opacity.of(primitives) = opacity as f32;
        let record = DataRecord::new(&[0, primitives as i32], &[opacity], &[]).pack(usize::MAX)?;
        let record = Record::Escape(escape::SET_OPACITY, record.as_flattened());
        workstation.control(&record).map_err(|e| device_error(F, &e))
    }

    /// Sets a nominal size of a workstation for what is drawn from now on, as a multiple of the one that all devices have.
    /// Segments that are drawn again have the sizes of that moment.
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Errors: 8, 20, 25, 33, 35, 36, 65, 71 or 87 (of a line, a
    /// marker or a hatch; not more than 0), 303.
    pub fn set_nominal_size(&mut self, id: i32, size: NominalSize, factor: f64) -> Result<()> {
        self.check_state(F)?;
        let workstation = self.suitable_workstation(F, id)?;
        let error = match size {
            NominalSize::Linewidth => 65,
            NominalSize::MarkerSize => 71,
            NominalSize::HatchSpacing => 87,
        };
        *workstation.tables_mut().nominal.of(size) = real(F, error, factor, |v| v > 0.0)?;
        if size != NominalSize::HatchSpacing {
            // Metafiles have these sizes in the attributes of lines and markers.
            return Ok(());
        }
        let record = DataRecord::new(&[0, size as i32], &[factor], &[]).pack(usize::MAX)?;
        let record = Record::Escape(escape::SET_NOMINAL_SIZE, record.as_flattened());
        workstation.control(&record).map_err(|e| device_error(F, &e))
    }

    /// How opaque primitives of a kind are drawn on a workstation.
    ///
    /// Beyond the standard. Errors: 7, 20, 25, 33, 35, 36.
    pub fn opacity(&self, id: i32, primitives: Primitives) -> Result<f64> {
        let workstation = &self.inquired(F, id)?.workstation;
        let mut opacity = workstation.tables().opacity;
        Ok((*opacity.of(primitives)).into())
    }

    /// Whether what is drawn on a workstation is antialiased by this library; `false` where it keeps no
    /// pixels.
    ///
    /// Beyond the standard; ESCAPE offers it to other languages. Errors: 8, 20, 25, 303.
    pub fn antialiasing(&mut self, id: i32) -> Result<bool> {
        self.check_state(F)?;
        let buffer = self.workstation_mut(F, id)?.workstation.frame_buffer();
        Ok(buffer.map_err(|e| device_error(F, &e))?.is_some_and(|buffer| buffer.antialiasing()))
    }
}

/// The error of ESCAPE for an error of the function it calls: that the data record is wrong, unless a device
/// failed.
fn of_record(error: Error) -> Error {
    match error.number {
        180..=182 | 300.. => error,
        _ => Error::new(182, F).because(error.detail.as_deref().unwrap_or(error.text())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_device::{Drawing, Event, INDEXED, PLAIN, TRUE_COLOUR, active, closed, number, open};
    use gks_pipeline::look::InteriorStyle;

    fn call(gks: &mut Gks, id: i32, integers: &[i32], reals: &[f64]) -> Result<DataRecord> {
        gks.escape(id, &DataRecord::new(integers, reals, &[]))
    }

    #[test]
    fn states_identifiers_and_records_are_checked() {
        assert_eq!(number(call(&mut closed(), 0, &[], &[])), 8);
        let (mut gks, _) = open(&[PLAIN]);
        assert_eq!(number(call(&mut gks, 0, &[], &[])), 181);
        assert_eq!([-1, 1, -1391, -3099].map(|id| number(call(&mut gks, id, &[], &[]))), [180; 4]);
        // Any record is good for what only readers of metafiles heed.
        for kind in ESCAPES.iter().filter(|kind| kind.number != escape::COMPOUND_PRIMITIVE) {
            let (integers, reals) = (vec![1; kind.integers], vec![1.0; kind.reals]);
            let output = call(&mut gks, kind.number, &integers, &reals).unwrap();
            assert_eq!(output.integers.len(), kind.output_integers, "{}", kind.name);
            assert_eq!(number(call(&mut gks, kind.number, &integers[1..], &reals)), 182);
            assert_eq!(number(call(&mut gks, kind.number, &integers, &[&reals[..], &[0.5]].concat())), 182);
            let mut record = DataRecord::new(&integers, &reals, &["string"]);
            assert_eq!(number(gks.escape(kind.number, &record)), 182);
            record.strings.clear();
            record.integers[0] = -1;
            assert_eq!(number(gks.escape(kind.number, &record)), 182);
        }
        assert_eq!(number(call(&mut gks, escape::SET_LINE_CAP, &[3], &[])), 182);
        assert_eq!(number(call(&mut gks, escape::SET_COLOUR_ALPHA, &[1, 1], &[1.5])), 182);
        assert_eq!(number(call(&mut gks, escape::SET_ANTIALIASING, &[1, 2], &[])), 182);
        assert_eq!(number(call(&mut gks, escape::INQUIRE_ANTIALIASING, &[9], &[])), 182);
        assert_eq!(number(call(&mut gks, escape::SET_OPACITY, &[1, 4], &[0.5])), 182);
        assert_eq!(number(call(&mut gks, escape::SET_OPACITY, &[1, 3], &[1.5])), 182);
        assert_eq!(number(call(&mut gks, escape::SET_NOMINAL_SIZE, &[1, 3], &[1.0])), 182);
        assert_eq!(
            [0, 1, 2].map(|n| number(call(&mut gks, escape::SET_NOMINAL_SIZE, &[1, n], &[0.0]))),
            [182; 3]
        );
    }

    #[test]
    fn the_functions_have_their_effects() {
        let (mut gks, log) = active(&[PLAIN]);
        call(&mut gks, escape::SET_LINE_CAP, &[1], &[]).unwrap();
        call(&mut gks, escape::SET_LINE_JOIN, &[2], &[]).unwrap();
        call(&mut gks, escape::SET_COLOUR_ALPHA, &[1, 1], &[0.5]).unwrap();
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        let (Drawing::Lines(_, pen), _) = log.mark() else { panic!("not a line") };
        assert_eq!((pen.cap, pen.join, pen.paint.colour.alpha), (Cap::Round, Join::Bevel, 0.5));
    }

    #[test]
    fn opacity_is_that_of_the_colour_and_of_the_kind_of_primitives() {
        let (mut gks, log) = active(&[PLAIN]);
        gks.set_opacity(1, Primitives::Lines, 0.5).unwrap();
        gks.set_colour_alpha(1, 1, 0.5).unwrap();
        gks.set_fill_area_interior_style(InteriorStyle::Solid).unwrap();
        gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
        let (Drawing::Lines(_, pen), _) = log.mark() else { panic!("not a line") };
        assert_eq!(pen.paint.colour.alpha, 0.25);
        gks.fill_area(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0)]).unwrap();
        let (Drawing::Area(_, _, paint), _) = log.mark() else { panic!("not an area") };
        assert_eq!(paint.colour.alpha, 0.5);
        let opacity = |primitives| gks.opacity(1, primitives).unwrap();
        assert_eq!((opacity(Primitives::Lines), opacity(Primitives::Areas)), (0.5, 1.0));
    }

    #[test]
    fn nominal_sizes_are_those_of_a_workstation() {
        let (mut gks, log) = active(&[PLAIN]);
        let width = |gks: &mut Gks| {
            gks.polyline(&[(0.0, 0.0), (1.0, 1.0)]).unwrap();
            let (Drawing::Lines(_, pen), _) = log.mark() else { panic!("not a line") };
            pen.width
        };
        let before = width(&mut gks);
        call(&mut gks, escape::SET_NOMINAL_SIZE, &[1, 0], &[4.0]).unwrap();
        assert_eq!(width(&mut gks), 4.0 * before);

        gks.set_fill_area_interior_style(InteriorStyle::Hatch).unwrap();
        gks.set_fill_area_style_index(-1).unwrap();
        let lines = |gks: &mut Gks| {
            gks.fill_area(&[(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)]).unwrap();
            let (Drawing::Lines(points, pen), _) = log.mark() else { panic!("not a hatch") };
            assert_eq!(pen.width, 4.0 * before);
            points.len()
        };
        let lines_before = lines(&mut gks);
        gks.set_nominal_size(1, NominalSize::HatchSpacing, 5.0).unwrap();
        let lines_after = lines(&mut gks);
        assert_eq!((lines_before, lines_after), (100, 20));
    }

    #[test]
    fn antialiasing_is_set_where_there_is_a_choice() {
        let (mut gks, _) = open(&[PLAIN, INDEXED, TRUE_COLOUR]);
        let inquired =
            |gks: &mut Gks, id| call(gks, escape::INQUIRE_ANTIALIASING, &[id], &[]).unwrap().integers;
        assert_eq!([1, 2, 3].map(|id| inquired(&mut gks, id)), [[0], [0], [1]]);
        for id in [1, 2, 3] {
            call(&mut gks, escape::SET_ANTIALIASING, &[id, 0], &[]).unwrap();
        }
        assert_eq!([1, 2, 3].map(|id| inquired(&mut gks, id)), [[0], [0], [0]]);
        call(&mut gks, escape::SET_ANTIALIASING, &[3, 1], &[]).unwrap();
        assert_eq!(inquired(&mut gks, 3), [1]);
    }

    #[test]
    fn antialiasing_can_be_set_before_the_page_begins() {
        let (mut gks, log) = open(&[TRUE_COLOUR]);
        gks.set_antialiasing(1, false).unwrap();
        assert_eq!(log.take(), []);
        gks.set_colour_representation(1, 0, (0.0, 0.0, 0.0)).unwrap();
        assert!(!gks.antialiasing(1).unwrap());
        let events = log.take();
        let [Event::Begin(page)] = &events[..] else { panic!("{events:?}") };
        assert_eq!(page.background.to_bytes(), [0, 0, 0, 255]);
    }
}
