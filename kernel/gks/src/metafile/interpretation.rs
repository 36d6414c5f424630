//! Interpretation: doing what a record of a metafile stands for.

use crate::attributes::Geometry;
use crate::{DataRecord, Detectability, Error, Function, Gks, Highlighting, Result, Visibility};
use gks_geometry::{Dc, Ndc, Rect, Vector};
use gks_pipeline::generated::numbers::escape;
use gks_pipeline::item::{Curve, Shape};
use gks_pipeline::record::{Attribute, Record};

const F: Function = Function::InterpretItem;

impl Gks {
    /// Does what a record of a metafile stands for: INTERPRET ITEM for what a
    /// [`Source`](gks_pipeline::record::Source) gives.
    ///
    /// Control functions and tables go to every active workstation. Primitives are drawn where they are in
    /// NDC, with the attributes of the state list. Attributes change the state list; geometric ones are taken
    /// back to world coordinates by the current normalization transformation. A clipping rectangle holds until
    /// the clipping indicator or the current normalization transformation changes.
    ///
    /// Errors: 7, 165 (the function refuses a value, or cannot be called now), 167 (an application's own item),
    /// 303, 304.
    pub fn interpret(&mut self, record: &Record<'_>) -> Result<()> {
        self.check_state(F)?;
        let done = match *record {
            Record::Clear { always } => self.on_active(|gks, id| gks.clear_workstation(id, always)),
            Record::Update { perform } => self.on_active(|gks, id| gks.update_workstation(id, perform)),
            Record::Deferral(mode, regeneration) => {
                self.on_active(|gks, id| gks.set_deferral_state(id, mode, regeneration))
            }
            Record::Message(text) => self.on_active(|gks, id| gks.message(id, text)),
            Record::Escape(id, data) => self.interpret_escape(id, data),
            Record::Primitive(shape) => return self.interpret_primitive(shape),
            Record::Attribute(attribute) => self.interpret_attribute(attribute),
            Record::LineRepresentation(index, b) => self.on_active(|gks, id| {
                gks.set_polyline_representation(id, signed(index), b.linetype, b.width, signed(b.colour))
            }),
            Record::MarkerRepresentation(index, b) => self.on_active(|gks, id| {
                gks.set_polymarker_representation(id, signed(index), b.kind, b.size, signed(b.colour))
            }),
            Record::TextRepresentation(index, b) => self.on_active(|gks, id| {
                let (font, precision, colour) = (b.font, b.precision, signed(b.colour));
                gks.set_text_representation(
                    id,
                    signed(index),
                    font,
                    precision,
                    b.expansion,
                    b.spacing,
                    colour,
                )
            }),
            Record::FillRepresentation(index, b) => self.on_active(|gks, id| {
                gks.set_fill_area_representation(id, signed(index), b.interior, b.style, signed(b.colour))
            }),
            Record::PatternRepresentation(index, p) => self.on_active(|gks, id| {
                let (columns, rows) = (p.columns, p.rows);
                gks.set_pattern_representation_of(id, signed(index), &p.indices, columns, rows, columns)
            }),
            Record::ColourRepresentation(index, colour) => {
                self.on_active(|gks, id| gks.set_colour_representation(id, signed(index), colour))
            }
            Record::WorkstationWindow(window) => {
                self.on_active(|gks, id| gks.set_workstation_window(id, window))
            }
            Record::WorkstationViewport(viewport) => self.on_active(|gks, id| {
                let fitting = gks.fitting(id, viewport);
                gks.set_workstation_viewport(id, fitting)
            }),
            Record::User(kind, _) => {
                return Err(Error::new(167, F).because(format!("item type {kind}")));
            }
            Record::RedrawAllSegments => self.on_active(Gks::redraw_all_segments_on_workstation),
            Record::CreateSegment(name) => self.create_segment(name),
            Record::CloseSegment => self.close_segment(),
            Record::RenameSegment(old, new) => self.rename_segment(old, new),
            Record::DeleteSegment(name) => self.delete_segment(name),
            Record::SegmentTransformation(name, map) => self.set_segment_transformation(name, map.rows()),
            Record::Visibility(name, on) => {
                let visibility = if on { Visibility::Visible } else { Visibility::Invisible };
                self.set_visibility(name, visibility)
            }
            Record::Highlighting(name, on) => {
                let highlighting = if on { Highlighting::Highlighted } else { Highlighting::Normal };
                self.set_highlighting(name, highlighting)
            }
            Record::SegmentPriority(name, priority) => self.set_segment_priority(name, priority),
            Record::Detectability(name, on) => {
                let detectability = if on { Detectability::Detectable } else { Detectability::Undetectable };
                self.set_detectability(name, detectability)
            }
        };
        done.map_err(|error| of_item(&error))
    }

    /// Calls a function for every active workstation; the first error is reported.
    fn on_active(&mut self, mut call: impl FnMut(&mut Gks, i32) -> Result<()>) -> Result<()> {
        let active = self.workstations.iter().filter(|(_, open)| open.active);
        let ids: Vec<i32> = active.map(|(&id, _)| id).collect();
        let mut done = Ok(());
        for id in ids {
            done = done.and(call(self, id));
        }
        done
    }

    /// A workstation viewport, made smaller in proportion if the display surface is smaller than the one that it
    /// was meant for.
    fn fitting(&self, id: i32, viewport: Rect<Dc>) -> Rect<Dc> {
        let Some(open) = self.workstations.get(&id) else { return viewport };
        let (width, height) = open.workstation.description().size();
        let [xmin, xmax, ymin, ymax] = viewport.limits();
        let scale = (width / xmax).min(height / ymax);
        // Limits that are beyond the edge by rounding only are taken to it by the function.
        if scale > 1.0 - 1e-6 || !scale.is_finite() {
            return viewport;
        }
        Rect::new(xmin * scale, xmax * scale, ymin * scale, ymax * scale)
    }

    /// Escapes of ours that name a workstation are for every active one.
    fn interpret_escape(&mut self, id: i32, data: &[u8]) -> Result<()> {
        let record = DataRecord::unpack_bytes(data).unwrap_or_default();
        match id {
            escape::SET_COLOUR_ALPHA
            | escape::SET_ANTIALIASING
            | escape::SET_OPACITY
            | escape::SET_NOMINAL_SIZE
                if !record.integers.is_empty() =>
            {
                self.on_active(|gks, workstation| {
                    let mut record = record.clone();
                    record.integers[0] = workstation;
                    gks.escape(id, &record).map(drop)
                })
            }
            _ => self.escape(id, &record).map(drop),
        }
    }

    fn interpret_primitive(&mut self, shape: Shape<'_>) -> Result<()> {
        if !is_drawable(&shape) {
            return Err(Error::new(165, F).because("a coordinate that is not finite, or too few points"));
        }
        self.map_geometry();
        self.output(F, shape)
    }

    fn interpret_attribute(&mut self, attribute: Attribute) -> Result<()> {
        match attribute {
            Attribute::LineIndex(v) => self.set_polyline_index(signed(v)),
            Attribute::Linetype(v) => self.set_linetype(v),
            Attribute::LineWidth(v) => self.set_linewidth_scale_factor(v),
            Attribute::LineColour(v) => self.set_polyline_colour_index(signed(v)),
            Attribute::MarkerIndex(v) => self.set_polymarker_index(signed(v)),
            Attribute::MarkerType(v) => self.set_marker_type(v),
            Attribute::MarkerSize(v) => self.set_marker_size_scale_factor(v),
            Attribute::MarkerColour(v) => self.set_polymarker_colour_index(signed(v)),
            Attribute::TextIndex(v) => self.set_text_index(signed(v)),
            Attribute::TextFont(font, precision) => self.set_text_font_and_precision(font, precision),
            Attribute::CharacterExpansion(v) => self.set_character_expansion_factor(v),
            Attribute::CharacterSpacing(v) => self.set_character_spacing(v),
            Attribute::TextColour(v) => self.set_text_colour_index(signed(v)),
            Attribute::TextPath(v) => self.set_text_path(v),
            Attribute::TextAlignment(horizontal, vertical) => self.set_text_alignment(horizontal, vertical),
            Attribute::FillIndex(v) => self.set_fill_area_index(signed(v)),
            Attribute::InteriorStyle(v) => self.set_fill_area_interior_style(v),
            Attribute::FillStyle(v) => self.set_fill_area_style_index(v),
            Attribute::FillColour(v) => self.set_fill_area_colour_index(signed(v)),
            Attribute::AspectSourceFlags(flags) => self.set_aspect_source_flags(flags),
            Attribute::Cap(cap) => self.set_line_cap(cap),
            Attribute::Join(join) => self.set_line_join(join),
            Attribute::ClipSector(sector) => {
                self.look.clip_sector = sector;
                Ok(())
            }
            Attribute::PickIdentifier(v) => {
                self.pick = v;
                Ok(())
            }
            Attribute::ClippingRectangle(rect) if rect.is_proper() => {
                self.normalization.clip = rect;
                Ok(())
            }
            Attribute::ClippingRectangle(rect) => {
                Err(Error::new(165, F).because(format!("limits {:?}", rect.limits())))
            }
            Attribute::CharacterVectors(..)
            | Attribute::PatternVectors(..)
            | Attribute::PatternReference(_) => self.interpret_geometry(attribute),
        }
    }

    /// Takes a geometric attribute over, in NDC as it is and in world coordinates as far as they go.
    fn interpret_geometry(&mut self, attribute: Attribute) -> Result<()> {
        let usable = |v: &Vector<Ndc>| v.0.is_finite() && v.0 != glam::DVec2::ZERO;
        let good = match &attribute {
            Attribute::CharacterVectors(a, b) | Attribute::PatternVectors(a, b) => usable(a) && usable(b),
            Attribute::PatternReference(p) => p.is_finite(),
            _ => true,
        };
        let inverse = self.normalization.map.inverse().filter(|_| good);
        let Some(back) = inverse else {
            return Err(Error::new(165, F).because("vectors that are not finite or have no length"));
        };
        // What is in NDC already must not lose its last bits on the way there and back.
        self.map_geometry();
        let Geometry { character_height, character_up, character_width, character_base, .. } =
            &mut self.geometry;
        match attribute {
            Attribute::CharacterVectors(height, width) => {
                let (up, base) = (back.vector(height), back.vector(width));
                (*character_height, *character_width) = (up.length(), base.length());
                (*character_up, *character_base) = (up, base);
                self.look.text_geometry.height = height;
                self.look.text_geometry.width = width;
            }
            Attribute::PatternVectors(width, height) => {
                self.geometry.pattern_width = back.vector(width);
                self.geometry.pattern_height = back.vector(height);
                self.look.pattern.width = width;
                self.look.pattern.height = height;
            }
            Attribute::PatternReference(point) => {
                self.geometry.pattern_reference = back.point(point);
                self.look.pattern.reference = point;
            }
            _ => {}
        }
        Ok(())
    }
}

fn signed(value: u32) -> i32 {
    i32::try_from(value).unwrap_or(i32::MAX)
}

/// The error of INTERPRET ITEM for one of the function that an item stands for: the content of the item is
/// wrong, unless a device failed.
fn of_item(error: &Error) -> Error {
    let number = if error.number >= 300 { error.number } else { 165 };
    let detail = error.detail.as_deref().unwrap_or(error.text());
    Error::new(number, F).because(detail.to_owned())
}

/// Whether what is below the waist can draw a shape: enough points, all finite.
fn is_drawable(shape: &Shape<'_>) -> bool {
    let finite = |points: &[glam::DVec2]| points.iter().all(|p| p.is_finite());
    match shape {
        Shape::Polyline(paths) | Shape::FillArea(paths) => !paths.is_empty() && finite(paths.points),
        Shape::Polymarker(positions) => !positions.is_empty() && finite(positions),
        Shape::Text(at, _) => at.is_finite(),
        Shape::CellArray(place, _) => finite(&[place.origin.0, place.columns.0, place.rows.0]),
        Shape::Generalized(Curve::Bezier(control), _) => {
            control.len() >= 4 && control.len() % 3 == 1 && finite(control)
        }
        Shape::Generalized(Curve::Ellipse(e), _) => {
            finite(&[e.centre.0, e.a.0, e.b.0]) && e.start.is_finite() && e.sweep.is_finite()
        }
    }
}
