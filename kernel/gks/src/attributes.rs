//! Output attributes that belong to no workstation.

use crate::{Error, Function, Gks, Result};
use gks_geometry::{Point, Vector, Wc};
use gks_pipeline::look::{
    AspectSourceFlags, Cap, Horizontal, InteriorStyle, Join, Precision, TextPath, Vertical,
};

/// The geometric attributes, in world coordinates.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Geometry {
    pub(crate) character_height: f64,
    /// As the application gave it; its length has no meaning.
    pub(crate) character_up: Vector<Wc>,
    pub(crate) character_width: f64,
    pub(crate) character_base: Vector<Wc>,
    pub(crate) pattern_width: Vector<Wc>,
    pub(crate) pattern_height: Vector<Wc>,
    pub(crate) pattern_reference: Point<Wc>,
}

impl Default for Geometry {
    fn default() -> Self {
        Geometry {
            character_height: 0.01,
            character_up: Vector::new(0.0, 1.0),
            character_width: 0.01,
            character_base: Vector::new(1.0, 0.0),
            pattern_width: Vector::new(1.0, 0.0),
            pattern_height: Vector::new(0.0, 1.0),
            pattern_reference: Point::new(0.0, 0.0),
        }
    }
}

impl Geometry {
    /// The vector from base line to cap line.
    pub(crate) fn height(&self) -> Vector<Wc> {
        Vector::from_vec(self.character_up.0.normalize_or_zero() * self.character_height)
    }

    /// The vector along the base line, as long as the character width.
    pub(crate) fn width(&self) -> Vector<Wc> {
        Vector::from_vec(self.character_base.0.normalize_or_zero() * self.character_width)
    }
}

/// Checks an index that counts from 1.
pub(crate) fn index(function: Function, error: i32, value: i32) -> Result<u32> {
    match u32::try_from(value) {
        Ok(i) if i >= 1 => Ok(i),
        _ => Err(Error::new(error, function).because(format!("index {value}"))),
    }
}

fn colour(function: Function, value: i32) -> Result<u32> {
    u32::try_from(value).map_err(|_| Error::new(92, function).because(format!("colour index {value}")))
}

pub(crate) fn nonzero(function: Function, error: i32, value: i32) -> Result<i32> {
    if value == 0 { Err(Error::new(error, function)) } else { Ok(value) }
}

/// Checks a number that has to be finite and fulfil `good`.
pub(crate) fn real(function: Function, error: i32, value: f64, good: impl Fn(f64) -> bool) -> Result<f64> {
    if value.is_finite() && good(value) {
        Ok(value)
    } else {
        Err(Error::new(error, function).because(format!("value {value}")))
    }
}

/// The error for a number that is not finite where the standard lists no error of its own: arithmetic error.
pub(crate) const NOT_A_NUMBER: i32 = 308;

macro_rules! setters {
    ($($(#[$doc:meta])* $name:ident($value:ident: $type:ty) $function:ident
        => $($field:ident).+ = $checked:expr;)+) => {
        impl Gks { $(
            $(#[$doc])*
            #[inline]
            pub fn $name(&mut self, $value: $type) -> Result<()> {
                const F: Function = Function::$function;
                self.check_state(F)?;
                self.$($field).+ = $checked(F, $value)?;
                Ok(())
            }
        )+ }
    };
}

setters! {
    /// SET POLYLINE INDEX. Errors: 8, 60 (index below 1).
    set_polyline_index(value: i32) SetPolylineIndex => look.line_index = |f, v| index(f, 60, v);
    /// SET LINETYPE: 1 solid, 2 dashed, 3 dotted, 4 dash-dotted; negative values are private. Errors: 8, 63 (0).
    set_linetype(value: i32) SetLinetype => look.line.linetype = |f, v| nonzero(f, 63, v);
    /// SET LINEWIDTH SCALE FACTOR, a multiple of the nominal linewidth. Errors: 8, 65 (negative).
    set_linewidth_scale_factor(value: f64) SetLinewidthScaleFactor
        => look.line.width = |f, v| real(f, 65, v, |v| v >= 0.0);
    /// SET POLYLINE COLOUR INDEX. Errors: 8, 92 (negative).
    set_polyline_colour_index(value: i32) SetPolylineColourIndex => look.line.colour = colour;
    /// SET POLYMARKER INDEX. Errors: 8, 66 (index below 1).
    set_polymarker_index(value: i32) SetPolymarkerIndex => look.marker_index = |f, v| index(f, 66, v);
    /// SET MARKER TYPE: 1 dot, 2 plus, 3 asterisk, 4 circle, 5 cross; negative values are private. Errors: 8, 69 (0).
    set_marker_type(value: i32) SetMarkerType => look.marker.kind = |f, v| nonzero(f, 69, v);
    /// SET MARKER SIZE SCALE FACTOR, a multiple of the nominal marker size. Errors: 8, 71 (negative).
    set_marker_size_scale_factor(value: f64) SetMarkerSizeScaleFactor
        => look.marker.size = |f, v| real(f, 71, v, |v| v >= 0.0);
    /// SET POLYMARKER COLOUR INDEX. Errors: 8, 92 (negative).
    set_polymarker_colour_index(value: i32) SetPolymarkerColourIndex => look.marker.colour = colour;
    /// SET TEXT INDEX. Errors: 8, 72 (index below 1).
    set_text_index(value: i32) SetTextIndex => look.text_index = |f, v| index(f, 72, v);
    /// SET CHARACTER EXPANSION FACTOR: width of characters relative to their design. Errors: 8, 77 (not positive).
    set_character_expansion_factor(value: f64) SetCharacterExpansionFactor
        => look.text.expansion = |f, v| real(f, 77, v, |v| v > 0.0);
    /// SET CHARACTER SPACING: extra space between characters, in character heights. Errors: 8, 308 (not a number).
    set_character_spacing(value: f64) SetCharacterSpacing
        => look.text.spacing = |f, v| real(f, NOT_A_NUMBER, v, |_| true);
    /// SET TEXT COLOUR INDEX. Errors: 8, 92 (negative).
    set_text_colour_index(value: i32) SetTextColourIndex => look.text.colour = colour;
    /// SET TEXT PATH. Error: 8.
    set_text_path(value: TextPath) SetTextPath => look.text_geometry.path = |_, v| Ok::<_, Error>(v);
    /// SET FILL AREA INDEX. Errors: 8, 80 (index below 1).
    set_fill_area_index(value: i32) SetFillAreaIndex => look.fill_index = |f, v| index(f, 80, v);
    /// SET FILL AREA INTERIOR STYLE. Error: 8.
    set_fill_area_interior_style(value: InteriorStyle) SetFillAreaInteriorStyle
        => look.fill.interior = |_, v| Ok::<_, Error>(v);
    /// SET FILL AREA STYLE INDEX: a pattern index or a hatch style. Errors: 8, 84 (0).
    set_fill_area_style_index(value: i32) SetFillAreaStyleIndex => look.fill.style = |f, v| nonzero(f, 84, v);
    /// SET FILL AREA COLOUR INDEX. Errors: 8, 92 (negative).
    set_fill_area_colour_index(value: i32) SetFillAreaColourIndex => look.fill.colour = colour;
    /// SET ASPECT SOURCE FLAGS. Error: 8.
    set_aspect_source_flags(value: AspectSourceFlags) SetAspectSourceFlags
        => look.sources = |_, v| Ok::<_, Error>(v);
}

impl Gks {
    /// SET TEXT FONT AND PRECISION. Errors: 8, 75 (font 0).
    pub fn set_text_font_and_precision(&mut self, font: i32, precision: Precision) -> Result<()> {
        const F: Function = Function::SetTextFontAndPrecision;
        self.check_state(F)?;
        self.look.text.font = nonzero(F, 75, font)?;
        self.look.text.precision = precision;
        Ok(())
    }

    /// SET CHARACTER HEIGHT, from base line to cap line in world coordinates. It sets the character width
    /// too. Errors: 8, 78 (not positive).
    pub fn set_character_height(&mut self, height: f64) -> Result<()> {
        const F: Function = Function::SetCharacterHeight;
        self.check_state(F)?;
        let height = real(F, 78, height, |v| v > 0.0)?;
        self.change_geometry(|g| (g.character_height, g.character_width) = (height, height));
        Ok(())
    }

    /// SET CHARACTER UP VECTOR: the direction from base line to cap line in world coordinates; its length
    /// has no meaning. It sets the character base vector, at a right angle clockwise. Errors: 8, 79 (zero).
    pub fn set_character_up_vector(&mut self, up: impl Into<Vector<Wc>>) -> Result<()> {
        const F: Function = Function::SetCharacterUpVector;
        self.check_state(F)?;
        let up: Vector<Wc> = up.into();
        if !up.0.is_finite() || up.0 == glam::DVec2::ZERO {
            return Err(Error::new(79, F).because(format!("vector ({}, {})", up.x(), up.y())));
        }
        let base = Vector::new(up.y(), -up.x());
        self.change_geometry(|g| (g.character_up, g.character_base) = (up, base));
        Ok(())
    }

    /// SET TEXT ALIGNMENT. Error: 8.
    pub fn set_text_alignment(&mut self, horizontal: Horizontal, vertical: Vertical) -> Result<()> {
        self.check_state(Function::SetTextAlignment)?;
        self.look.text_geometry.horizontal = horizontal;
        self.look.text_geometry.vertical = vertical;
        Ok(())
    }

    /// SET PATTERN SIZE, in world coordinates. Errors: 8, 87 (not positive).
    pub fn set_pattern_size(&mut self, width: f64, height: f64) -> Result<()> {
        const F: Function = Function::SetPatternSize;
        self.check_state(F)?;
        let width = real(F, 87, width, |v| v > 0.0)?;
        let height = real(F, 87, height, |v| v > 0.0)?;
        let (width, height) = (Vector::new(width, 0.0), Vector::new(0.0, height));
        self.change_geometry(|g| (g.pattern_width, g.pattern_height) = (width, height));
        Ok(())
    }

    /// SET PATTERN REFERENCE POINT: the lower left corner of one copy of the pattern, in world coordinates.
    /// Errors: 8, 308 (not a number).
    pub fn set_pattern_reference_point(&mut self, point: impl Into<Point<Wc>>) -> Result<()> {
        const F: Function = Function::SetPatternReferencePoint;
        self.check_state(F)?;
        let point: Point<Wc> = point.into();
        if !point.is_finite() {
            return Err(Error::new(NOT_A_NUMBER, F));
        }
        self.change_geometry(|g| g.pattern_reference = point);
        Ok(())
    }

    /// Sets how polylines end. Beyond the standard; ESCAPE offers it to other languages. Error: 8.
    pub fn set_line_cap(&mut self, cap: Cap) -> Result<()> {
        self.check_state(Function::Escape)?;
        self.look.cap = cap;
        Ok(())
    }

    /// Sets how polylines turn corners. Beyond the standard; ESCAPE offers it to other languages. Error: 8.
    pub fn set_line_join(&mut self, join: Join) -> Result<()> {
        self.check_state(Function::Escape)?;
        self.look.join = join;
        Ok(())
    }

    /// Changes geometric attributes. Programs set them again and again to what they are, which costs nothing later.
    fn change_geometry(&mut self, change: impl FnOnce(&mut Geometry)) {
        let before = self.geometry.clone();
        change(&mut self.geometry);
        self.geometry_stale |= self.geometry != before;
    }

    /// Takes the geometric attributes to NDC by the current normalization transformation.
    pub(crate) fn map_geometry(&mut self) {
        if !self.geometry_stale {
            return;
        }
        let (map, g) = (&self.normalization.map, &self.geometry);
        self.look.text_geometry.height = map.vector(g.height());
        self.look.text_geometry.width = map.vector(g.width());
        self.look.pattern.width = map.vector(g.pattern_width);
        self.look.pattern.height = map.vector(g.pattern_height);
        self.look.pattern.reference = map.point(g.pattern_reference);
        self.geometry_stale = false;
    }
}
