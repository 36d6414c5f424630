//! Numbers of the library's own choice, and the predefined bundle, pattern and colour tables.
//!
//! Written by `gks-spec generate` from `spec/numbers.toml`; do not edit.

/// A workstation type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WorkstationType {
    /// The number given to OPEN WORKSTATION.
    pub number: i32,
    /// The name that may be given instead of the number.
    pub name: &'static str,
    /// The extension of the files it writes, without the dot; empty if it writes none.
    pub extension: &'static str,
    /// The length of its colour table.
    pub colours: u32,
    /// What it is, in a few words.
    pub meaning: &'static str,
}

/// A font.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Font {
    /// The font number.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// Whether its characters are filled outlines; they are strokes otherwise.
    pub outline: bool,
}

/// A linetype.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linetype {
    /// The linetype number.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// Drawn and blank lengths in turn, in units of the nominal linewidth; empty for a solid line.
    pub dashes: &'static [f64],
}

/// A marker type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Marker {
    /// The marker type number.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
}

/// A hatch style.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// The style index.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// The directions of its families of lines, in degrees anticlockwise from the horizontal.
    pub angles: &'static [f64],
    /// The distance between lines, in units of the nominal hatch spacing.
    pub spacing: f64,
}

/// The group of attributes that a generalized drawing primitive takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GdpAttributes {
    /// The polyline attributes.
    Polyline,
    /// The fill area attributes.
    FillArea,
}

/// A generalized drawing primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gdp {
    /// Its identifier.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// The least number of points.
    pub least: usize,
    /// The greatest number of points; 0 if there is none.
    pub most: usize,
    /// The number of points is `least` plus a multiple of this.
    pub step: usize,
    /// The attributes it takes.
    pub attributes: GdpAttributes,
}

/// A function of ESCAPE.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Escape {
    /// Its identifier.
    pub number: i32,
    /// Its name.
    pub name: &'static str,
    /// How many integers the input data record holds.
    pub integers: usize,
    /// How many reals the input data record holds.
    pub reals: usize,
    /// How many integers the output data record holds.
    pub output_integers: usize,
}

/// A predefined polyline bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolylineBundle {
    /// The linetype.
    pub linetype: i32,
    /// The linewidth scale factor.
    pub linewidth: f64,
    /// The colour index.
    pub colour: u32,
}

/// A predefined polymarker bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolymarkerBundle {
    /// The marker type.
    pub marker: i32,
    /// The marker size scale factor.
    pub size: f64,
    /// The colour index.
    pub colour: u32,
}

/// A predefined text bundle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextBundle {
    /// The font.
    pub font: i32,
    /// The precision: 0 STRING, 1 CHAR, 2 STROKE.
    pub precision: u8,
    /// The character expansion factor.
    pub expansion: f64,
    /// The character spacing.
    pub spacing: f64,
    /// The colour index.
    pub colour: u32,
}

/// A predefined fill area bundle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FillAreaBundle {
    /// The interior style: 0 HOLLOW, 1 SOLID, 2 PATTERN, 3 HATCH.
    pub interior: u8,
    /// The style index.
    pub style: i32,
    /// The colour index.
    pub colour: u32,
}

/// A predefined pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pattern {
    /// The number of columns, DX.
    pub columns: usize,
    /// The number of rows, DY.
    pub rows: usize,
    /// The colour indices, row by row, the upper row first.
    pub cells: &'static [i32],
}

/// The nominal hatch spacing, as a fraction of the shorter side of the display surface.
pub const NOMINAL_HATCH_SPACING: f64 = 0.01;

/// The nominal linewidth, as a fraction of the shorter side of the display surface.
pub const NOMINAL_LINEWIDTH: f64 = 0.001;

/// The nominal marker size, as a fraction of the shorter side of the display surface.
pub const NOMINAL_MARKER_SIZE: f64 = 0.006;

/// The greatest number of active workstations.
pub const MAX_ACTIVE_WORKSTATIONS: u32 = 32;

/// The greatest number of choice alternatives.
pub const MAX_CHOICE_ALTERNATIVES: u32 = 256;

/// The greatest number of colours.
pub const MAX_COLOURS: u32 = 65536;

/// The greatest number of fill area bundles.
pub const MAX_FILL_AREA_BUNDLES: u32 = 1024;

/// The greatest number of normalization transformations.
pub const MAX_NORMALIZATION_TRANSFORMATIONS: u32 = 255;

/// The greatest number of open workstations.
pub const MAX_OPEN_WORKSTATIONS: u32 = 32;

/// The greatest number of patterns.
pub const MAX_PATTERNS: u32 = 1024;

/// The greatest number of polyline bundles.
pub const MAX_POLYLINE_BUNDLES: u32 = 1024;

/// The greatest number of polymarker bundles.
pub const MAX_POLYMARKER_BUNDLES: u32 = 1024;

/// The greatest number of queued events.
pub const MAX_QUEUED_EVENTS: u32 = 1024;

/// The greatest number of string characters.
pub const MAX_STRING_CHARACTERS: u32 = 1024;

/// The greatest number of stroke points.
pub const MAX_STROKE_POINTS: u32 = 4096;

/// The greatest number of text bundles.
pub const MAX_TEXT_BUNDLES: u32 = 1024;

/// The greatest number of workstations of a segment.
pub const MAX_WORKSTATIONS_OF_A_SEGMENT: u32 = 32;

/// The locator position of input devices of a workstation just opened.
pub const INPUT_LOCATOR_POSITION: f64 = 0.5;

/// The pick aperture of input devices of a workstation just opened.
pub const INPUT_PICK_APERTURE: f64 = 0.005;

/// The stroke interval of input devices of a workstation just opened.
pub const INPUT_STROKE_INTERVAL: f64 = 0.005;

/// The valuator high of input devices of a workstation just opened.
pub const INPUT_VALUATOR_HIGH: f64 = 1.0;

/// The valuator low of input devices of a workstation just opened.
pub const INPUT_VALUATOR_LOW: f64 = 0.0;

/// The valuator value of input devices of a workstation just opened.
pub const INPUT_VALUATOR_VALUE: f64 = 0.5;

/// What the buffer of a string device of a workstation just opened holds.
pub const INPUT_BUFFER_STRING: usize = 80;

/// What the buffer of a stroke device of a workstation just opened holds.
pub const INPUT_BUFFER_STROKE: usize = 512;

/// The prompt and echo types of the input classes, in their order.
pub static PROMPTS: &[&[i32]] = &[
    &[1, 2, 3, 4, 5, 6],
    &[1, 2, 3, 4],
    &[1, 2, 3],
    &[1, 2, 3, 4, 5],
    &[1, 2, 3],
    &[1],
];

/// The error number of the bindings for: level not built.
pub const ERROR_LEVEL_NOT_BUILT: i32 = -3100;

/// Workstation type numbers.
pub mod workstation_type {
    /// What the environment names, else png.
    pub const DEFAULT: i32 = 0;
    /// Workstation independent segment storage.
    pub const WISS: i32 = 1;
    /// PNG image, true colour.
    pub const PNG: i32 = 100;
    /// JPEG image.
    pub const JPEG: i32 = 101;
    /// TIFF image.
    pub const TIFF: i32 = 102;
    /// BMP image.
    pub const BMP: i32 = 103;
    /// WebP image.
    pub const WEBP: i32 = 104;
    /// GIF image of at most 256 colours.
    pub const GIF: i32 = 105;
    /// PNG image of 8-bit colour indices.
    pub const PNG8: i32 = 110;
    /// Pixels in memory only, true colour.
    pub const FRAMEBUFFER: i32 = 120;
    /// Pixels in memory only, 8-bit colour indices.
    pub const FRAMEBUFFER8: i32 = 121;
    /// Scalable vector graphics, text kept as text.
    pub const SVG: i32 = 200;
    /// Scalable vector graphics, text drawn as outlines.
    pub const SVG_OUTLINES: i32 = 201;
    /// Portable document format.
    pub const PDF: i32 = 210;
    /// PostScript.
    pub const PS: i32 = 220;
    /// Encapsulated PostScript, one page.
    pub const EPS: i32 = 221;
    /// Pen plotter, HP-GL.
    pub const HPGL: i32 = 300;
    /// Window, with pointer and keyboard.
    pub const WINDOW: i32 = 500;
    /// Page in a browser, with pointer and keyboard.
    pub const WEB: i32 = 510;
    /// Terminal, with the best graphics that it has.
    pub const TERMINAL: i32 = 520;
    /// Terminal with sixels.
    pub const SIXEL: i32 = 521;
    /// Terminal with the graphics protocol of kitty.
    pub const KITTY: i32 = 522;
    /// Terminal with half blocks in 24-bit colour.
    pub const BLOCKS: i32 = 523;
    /// PNG image, if a file is named, with input from a script.
    pub const SCRIPTED: i32 = 530;
    /// Metafile of GKS (GKSM), written.
    pub const GKSM: i32 = 2;
    /// Metafile of any format, read.
    pub const MI: i32 = 3;
    /// Computer Graphics Metafile, binary.
    pub const CGM: i32 = 400;
    /// Computer Graphics Metafile, clear text.
    pub const CGM_TEXT: i32 = 401;
    /// Computer Graphics Metafile, character encoding.
    pub const CGM_CHARACTER: i32 = 402;
    /// Computer Graphics Metafile in the records of NCAR.
    pub const NCGM: i32 = 403;
    /// Accepts everything and draws nothing.
    pub const NULL: i32 = 900;
}

/// The workstation types.
pub static WORKSTATION_TYPES: &[WorkstationType] = &[
    WorkstationType { number: 0, name: "default", extension: "", colours: 65536, meaning: "what the environment names, else png" },
    WorkstationType { number: 1, name: "wiss", extension: "", colours: 65536, meaning: "workstation independent segment storage" },
    WorkstationType { number: 100, name: "png", extension: "png", colours: 65536, meaning: "PNG image, true colour" },
    WorkstationType { number: 101, name: "jpeg", extension: "jpg", colours: 65536, meaning: "JPEG image" },
    WorkstationType { number: 102, name: "tiff", extension: "tif", colours: 65536, meaning: "TIFF image" },
    WorkstationType { number: 103, name: "bmp", extension: "bmp", colours: 65536, meaning: "BMP image" },
    WorkstationType { number: 104, name: "webp", extension: "webp", colours: 65536, meaning: "WebP image" },
    WorkstationType { number: 105, name: "gif", extension: "gif", colours: 65536, meaning: "GIF image of at most 256 colours" },
    WorkstationType { number: 110, name: "png8", extension: "png", colours: 256, meaning: "PNG image of 8-bit colour indices" },
    WorkstationType { number: 120, name: "framebuffer", extension: "", colours: 65536, meaning: "pixels in memory only, true colour" },
    WorkstationType { number: 121, name: "framebuffer8", extension: "", colours: 256, meaning: "pixels in memory only, 8-bit colour indices" },
    WorkstationType { number: 200, name: "svg", extension: "svg", colours: 65536, meaning: "scalable vector graphics, text kept as text" },
    WorkstationType { number: 201, name: "svg-outlines", extension: "svg", colours: 65536, meaning: "scalable vector graphics, text drawn as outlines" },
    WorkstationType { number: 210, name: "pdf", extension: "pdf", colours: 65536, meaning: "portable document format" },
    WorkstationType { number: 220, name: "ps", extension: "ps", colours: 65536, meaning: "PostScript" },
    WorkstationType { number: 221, name: "eps", extension: "eps", colours: 65536, meaning: "encapsulated PostScript, one page" },
    WorkstationType { number: 300, name: "hpgl", extension: "plt", colours: 65536, meaning: "pen plotter, HP-GL" },
    WorkstationType { number: 500, name: "window", extension: "", colours: 65536, meaning: "window, with pointer and keyboard" },
    WorkstationType { number: 510, name: "web", extension: "", colours: 65536, meaning: "page in a browser, with pointer and keyboard" },
    WorkstationType { number: 520, name: "terminal", extension: "", colours: 65536, meaning: "terminal, with the best graphics that it has" },
    WorkstationType { number: 521, name: "sixel", extension: "", colours: 65536, meaning: "terminal with sixels" },
    WorkstationType { number: 522, name: "kitty", extension: "", colours: 65536, meaning: "terminal with the graphics protocol of kitty" },
    WorkstationType { number: 523, name: "blocks", extension: "", colours: 65536, meaning: "terminal with half blocks in 24-bit colour" },
    WorkstationType { number: 530, name: "scripted", extension: "png", colours: 65536, meaning: "PNG image, if a file is named, with input from a script" },
    WorkstationType { number: 2, name: "gksm", extension: "gksm", colours: 65536, meaning: "metafile of GKS (GKSM), written" },
    WorkstationType { number: 3, name: "mi", extension: "", colours: 65536, meaning: "metafile of any format, read" },
    WorkstationType { number: 400, name: "cgm", extension: "cgm", colours: 65536, meaning: "Computer Graphics Metafile, binary" },
    WorkstationType { number: 401, name: "cgm-text", extension: "cgmt", colours: 65536, meaning: "Computer Graphics Metafile, clear text" },
    WorkstationType { number: 402, name: "cgm-character", extension: "cgmc", colours: 65536, meaning: "Computer Graphics Metafile, character encoding" },
    WorkstationType { number: 403, name: "ncgm", extension: "ncgm", colours: 65536, meaning: "Computer Graphics Metafile in the records of NCAR" },
    WorkstationType { number: 900, name: "null", extension: "", colours: 65536, meaning: "accepts everything and draws nothing" },
];

/// The fonts.
pub static FONTS: &[Font] = &[
    Font { number: 1, name: "monospaced simplex", outline: false },
    Font { number: -2, name: "cartographic roman", outline: false },
    Font { number: -3, name: "cartographic greek", outline: false },
    Font { number: -4, name: "simplex roman", outline: false },
    Font { number: -5, name: "simplex greek", outline: false },
    Font { number: -6, name: "simplex script", outline: false },
    Font { number: -7, name: "complex roman", outline: false },
    Font { number: -8, name: "complex greek", outline: false },
    Font { number: -9, name: "complex script", outline: false },
    Font { number: -10, name: "complex italic", outline: false },
    Font { number: -11, name: "complex cyrillic", outline: false },
    Font { number: -12, name: "duplex roman", outline: false },
    Font { number: -13, name: "triplex roman", outline: false },
    Font { number: -14, name: "triplex italic", outline: false },
    Font { number: -15, name: "gothic german", outline: false },
    Font { number: -16, name: "gothic english", outline: false },
    Font { number: -17, name: "gothic italian", outline: false },
    Font { number: -18, name: "mathematical symbols", outline: false },
    Font { number: -19, name: "symbol set 1", outline: false },
    Font { number: -20, name: "symbol set 2", outline: false },
    Font { number: -21, name: "sans", outline: true },
    Font { number: -22, name: "sans bold", outline: true },
    Font { number: -23, name: "sans italic", outline: true },
    Font { number: -24, name: "sans bold italic", outline: true },
    Font { number: -25, name: "serif", outline: true },
    Font { number: -26, name: "serif bold", outline: true },
    Font { number: -27, name: "serif italic", outline: true },
    Font { number: -28, name: "serif bold italic", outline: true },
    Font { number: -29, name: "mono", outline: true },
    Font { number: -30, name: "mono bold", outline: true },
    Font { number: -31, name: "mono italic", outline: true },
    Font { number: -32, name: "mono bold italic", outline: true },
    Font { number: -33, name: "mathematics", outline: true },
    Font { number: -34, name: "symbols", outline: true },
];

/// The linetypes.
pub static LINETYPES: &[Linetype] = &[
    Linetype { number: 1, name: "solid", dashes: &[] },
    Linetype { number: 2, name: "dashed", dashes: &[12.0, 8.0] },
    Linetype { number: 3, name: "dotted", dashes: &[2.0, 6.0] },
    Linetype { number: 4, name: "dash-dot", dashes: &[12.0, 6.0, 2.0, 6.0] },
    Linetype { number: -1, name: "dash-dot-dot", dashes: &[12.0, 6.0, 2.0, 6.0, 2.0, 6.0] },
    Linetype { number: -2, name: "long dash", dashes: &[24.0, 8.0] },
    Linetype { number: -3, name: "short dash", dashes: &[6.0, 6.0] },
    Linetype { number: -4, name: "dash-dot-dot-dot", dashes: &[12.0, 6.0, 2.0, 6.0, 2.0, 6.0, 2.0, 6.0] },
    Linetype { number: -5, name: "sparse dot", dashes: &[2.0, 14.0] },
    Linetype { number: -6, name: "long dash short dash", dashes: &[24.0, 8.0, 6.0, 8.0] },
];

/// Marker type numbers.
pub mod marker {
    /// Dot.
    pub const DOT: i32 = 1;
    /// Plus.
    pub const PLUS: i32 = 2;
    /// Asterisk.
    pub const ASTERISK: i32 = 3;
    /// Circle.
    pub const CIRCLE: i32 = 4;
    /// Diagonal cross.
    pub const DIAGONAL_CROSS: i32 = 5;
    /// Square.
    pub const SQUARE: i32 = -1;
    /// Filled square.
    pub const FILLED_SQUARE: i32 = -2;
    /// Triangle up.
    pub const TRIANGLE_UP: i32 = -3;
    /// Filled triangle up.
    pub const FILLED_TRIANGLE_UP: i32 = -4;
    /// Triangle down.
    pub const TRIANGLE_DOWN: i32 = -5;
    /// Filled triangle down.
    pub const FILLED_TRIANGLE_DOWN: i32 = -6;
    /// Diamond.
    pub const DIAMOND: i32 = -7;
    /// Filled diamond.
    pub const FILLED_DIAMOND: i32 = -8;
    /// Filled circle.
    pub const FILLED_CIRCLE: i32 = -9;
    /// Star.
    pub const STAR: i32 = -10;
    /// Filled star.
    pub const FILLED_STAR: i32 = -11;
    /// Hexagon.
    pub const HEXAGON: i32 = -12;
}

/// The marker types.
pub static MARKERS: &[Marker] = &[
    Marker { number: 1, name: "dot" },
    Marker { number: 2, name: "plus" },
    Marker { number: 3, name: "asterisk" },
    Marker { number: 4, name: "circle" },
    Marker { number: 5, name: "diagonal cross" },
    Marker { number: -1, name: "square" },
    Marker { number: -2, name: "filled square" },
    Marker { number: -3, name: "triangle up" },
    Marker { number: -4, name: "filled triangle up" },
    Marker { number: -5, name: "triangle down" },
    Marker { number: -6, name: "filled triangle down" },
    Marker { number: -7, name: "diamond" },
    Marker { number: -8, name: "filled diamond" },
    Marker { number: -9, name: "filled circle" },
    Marker { number: -10, name: "star" },
    Marker { number: -11, name: "filled star" },
    Marker { number: -12, name: "hexagon" },
];

/// The hatch styles, the positive indices after the negative ones.
pub static HATCHES: &[Hatch] = &[
    Hatch { number: -1, name: "horizontal", angles: &[0.0], spacing: 1.0 },
    Hatch { number: -2, name: "vertical", angles: &[90.0], spacing: 1.0 },
    Hatch { number: -3, name: "45 degrees up", angles: &[45.0], spacing: 1.0 },
    Hatch { number: -4, name: "45 degrees down", angles: &[135.0], spacing: 1.0 },
    Hatch { number: -5, name: "horizontal and vertical cross", angles: &[0.0, 90.0], spacing: 1.0 },
    Hatch { number: -6, name: "diagonal cross", angles: &[45.0, 135.0], spacing: 1.0 },
    Hatch { number: -7, name: "dense horizontal", angles: &[0.0], spacing: 0.5 },
    Hatch { number: -8, name: "dense vertical", angles: &[90.0], spacing: 0.5 },
    Hatch { number: -9, name: "dense 45 degrees up", angles: &[45.0], spacing: 0.5 },
    Hatch { number: -10, name: "dense 45 degrees down", angles: &[135.0], spacing: 0.5 },
    Hatch { number: -11, name: "dense horizontal and vertical cross", angles: &[0.0, 90.0], spacing: 0.5 },
    Hatch { number: -12, name: "dense diagonal cross", angles: &[45.0, 135.0], spacing: 0.5 },
    Hatch { number: 1, name: "horizontal", angles: &[0.0], spacing: 1.0 },
    Hatch { number: 2, name: "vertical", angles: &[90.0], spacing: 1.0 },
    Hatch { number: 3, name: "45 degrees up", angles: &[45.0], spacing: 1.0 },
    Hatch { number: 4, name: "45 degrees down", angles: &[135.0], spacing: 1.0 },
    Hatch { number: 5, name: "horizontal and vertical cross", angles: &[0.0, 90.0], spacing: 1.0 },
    Hatch { number: 6, name: "diagonal cross", angles: &[45.0, 135.0], spacing: 1.0 },
];

/// Identifiers of generalized drawing primitives; the points of each, in order.
pub mod gdp {
    /// Start, a point on the arc, end.
    pub const CIRCULAR_ARC: i32 = -1;
    /// Start, a point on the arc, end.
    pub const CIRCULAR_CHORD: i32 = -2;
    /// Start, a point on the arc, end.
    pub const CIRCULAR_PIE: i32 = -3;
    /// A point on the edge, centre.
    pub const CIRCLE: i32 = -4;
    /// Centre, the ends of two conjugate semi-axes.
    pub const ELLIPSE: i32 = -5;
    /// Centre, the ends of two conjugate semi-axes, a point on the ray through the start, one on the ray through the end; from start to end in the sense from the first axis to the second.
    pub const ELLIPTIC_ARC: i32 = -6;
    /// As for the elliptic arc.
    pub const ELLIPTIC_CHORD: i32 = -7;
    /// As for the elliptic arc.
    pub const ELLIPTIC_PIE: i32 = -8;
    /// First end point, then two control points and an end point for every cubic piece.
    pub const BEZIER_CHAIN: i32 = -9;
    /// The points that the natural cubic spline passes through.
    pub const SPLINE: i32 = -10;
    /// The points that the closed cubic spline passes through.
    pub const CLOSED_SPLINE: i32 = -11;
}

/// The generalized drawing primitives.
pub static GDPS: &[Gdp] = &[
    Gdp { number: -1, name: "circular arc", least: 3, most: 3, step: 1, attributes: GdpAttributes::Polyline },
    Gdp { number: -2, name: "circular chord", least: 3, most: 3, step: 1, attributes: GdpAttributes::FillArea },
    Gdp { number: -3, name: "circular pie", least: 3, most: 3, step: 1, attributes: GdpAttributes::FillArea },
    Gdp { number: -4, name: "circle", least: 2, most: 2, step: 1, attributes: GdpAttributes::FillArea },
    Gdp { number: -5, name: "ellipse", least: 3, most: 3, step: 1, attributes: GdpAttributes::FillArea },
    Gdp { number: -6, name: "elliptic arc", least: 5, most: 5, step: 1, attributes: GdpAttributes::Polyline },
    Gdp { number: -7, name: "elliptic chord", least: 5, most: 5, step: 1, attributes: GdpAttributes::FillArea },
    Gdp { number: -8, name: "elliptic pie", least: 5, most: 5, step: 1, attributes: GdpAttributes::FillArea },
    Gdp { number: -9, name: "bezier chain", least: 4, most: 0, step: 3, attributes: GdpAttributes::Polyline },
    Gdp { number: -10, name: "spline", least: 2, most: 0, step: 1, attributes: GdpAttributes::Polyline },
    Gdp { number: -11, name: "closed spline", least: 3, most: 0, step: 1, attributes: GdpAttributes::FillArea },
];

/// Identifiers of escape functions.
pub mod escape {
    /// Set line cap; data record: integers (cap: 0 butt, 1 round, 2 projecting).
    pub const SET_LINE_CAP: i32 = -3001;
    /// Set line join; data record: integers (join: 0 miter, 1 round, 2 bevel).
    pub const SET_LINE_JOIN: i32 = -3002;
    /// Set colour alpha; data record: integers (workstation identifier; colour index), reals (alpha, 0 transparent to 1 opaque).
    pub const SET_COLOUR_ALPHA: i32 = -3003;
    /// Set antialiasing; data record: integers (workstation identifier; antialiasing: 0 off, 1 on).
    pub const SET_ANTIALIASING: i32 = -3004;
    /// Inquire antialiasing; data record: integers (workstation identifier), integers out (antialiasing: 0 off, 1 on).
    pub const INQUIRE_ANTIALIASING: i32 = -3005;
    /// Compound primitive; data record: integers (number of polylines or fill areas that follow and are one primitive).
    pub const COMPOUND_PRIMITIVE: i32 = -3006;
    /// Set opacity; data record: integers (workstation identifier; primitives: 0 lines, 1 markers, 2 text, 3 areas and cells), reals (opacity, 0 transparent to 1 opaque, on top of that of colours).
    pub const SET_OPACITY: i32 = -3007;
    /// Set nominal size; data record: integers (workstation identifier; size: 0 linewidth, 1 marker size, 2 hatch spacing), reals (the size as a multiple of the one that all devices have).
    pub const SET_NOMINAL_SIZE: i32 = -3008;
    /// Set clip sector; data record: integers (what clips: 0 the clipping rectangle, 1 a sector of the ellipse in it), reals (parameter of the ellipse in degrees where the sector begins; where it ends, counterclockwise).
    pub const SET_CLIP_SECTOR: i32 = -3009;
    /// Select clipping transformation; data record: integers (normalization transformation whose viewport clips; 0 the current one, if the clipping indicator says so).
    pub const SELECT_CLIPPING_TRANSFORMATION: i32 = -3010;
}

/// The escape functions.
pub static ESCAPES: &[Escape] = &[
    Escape { number: -3001, name: "set line cap", integers: 1, reals: 0, output_integers: 0 },
    Escape { number: -3002, name: "set line join", integers: 1, reals: 0, output_integers: 0 },
    Escape { number: -3003, name: "set colour alpha", integers: 2, reals: 1, output_integers: 0 },
    Escape { number: -3004, name: "set antialiasing", integers: 2, reals: 0, output_integers: 0 },
    Escape { number: -3005, name: "inquire antialiasing", integers: 1, reals: 0, output_integers: 1 },
    Escape { number: -3006, name: "compound primitive", integers: 1, reals: 0, output_integers: 0 },
    Escape { number: -3007, name: "set opacity", integers: 2, reals: 1, output_integers: 0 },
    Escape { number: -3008, name: "set nominal size", integers: 2, reals: 1, output_integers: 0 },
    Escape { number: -3009, name: "set clip sector", integers: 1, reals: 2, output_integers: 0 },
    Escape { number: -3010, name: "select clipping transformation", integers: 1, reals: 0, output_integers: 0 },
];

/// The predefined polyline bundles 1, 2, ....
pub static POLYLINE_BUNDLES: &[PolylineBundle] = &[
    PolylineBundle { linetype: 1, linewidth: 1.0, colour: 1 },
    PolylineBundle { linetype: 2, linewidth: 1.0, colour: 1 },
    PolylineBundle { linetype: 3, linewidth: 1.0, colour: 1 },
    PolylineBundle { linetype: 4, linewidth: 1.0, colour: 1 },
    PolylineBundle { linetype: 1, linewidth: 3.0, colour: 1 },
];

/// The predefined polymarker bundles 1, 2, ....
pub static POLYMARKER_BUNDLES: &[PolymarkerBundle] = &[
    PolymarkerBundle { marker: 3, size: 1.0, colour: 1 },
    PolymarkerBundle { marker: 2, size: 1.0, colour: 1 },
    PolymarkerBundle { marker: 4, size: 1.0, colour: 1 },
    PolymarkerBundle { marker: 5, size: 1.0, colour: 1 },
    PolymarkerBundle { marker: 1, size: 1.0, colour: 1 },
];

/// The predefined text bundles 1, 2, ....
pub static TEXT_BUNDLES: &[TextBundle] = &[
    TextBundle { font: 1, precision: 2, expansion: 1.0, spacing: 0.0, colour: 1 },
    TextBundle { font: -7, precision: 2, expansion: 1.0, spacing: 0.0, colour: 1 },
    TextBundle { font: -21, precision: 2, expansion: 1.0, spacing: 0.0, colour: 1 },
    TextBundle { font: -25, precision: 2, expansion: 1.0, spacing: 0.0, colour: 1 },
    TextBundle { font: -12, precision: 2, expansion: 1.0, spacing: 0.0, colour: 1 },
    TextBundle { font: -10, precision: 2, expansion: 1.0, spacing: 0.0, colour: 1 },
];

/// The predefined fill area bundles 1, 2, ....
pub static FILL_AREA_BUNDLES: &[FillAreaBundle] = &[
    FillAreaBundle { interior: 0, style: 1, colour: 1 },
    FillAreaBundle { interior: 1, style: 1, colour: 1 },
    FillAreaBundle { interior: 2, style: 1, colour: 1 },
    FillAreaBundle { interior: 3, style: -1, colour: 1 },
    FillAreaBundle { interior: 3, style: -5, colour: 1 },
];

/// The predefined patterns 1, 2, ....
pub static PATTERNS: &[Pattern] = &[
    Pattern { columns: 4, rows: 4, cells: &[1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 1] },
    Pattern { columns: 4, rows: 4, cells: &[1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1] },
    Pattern { columns: 4, rows: 4, cells: &[1, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1, 0] },
    Pattern { columns: 4, rows: 4, cells: &[0, 1, 1, 1, 1, 1, 0, 1, 0, 1, 1, 1, 1, 1, 0, 1] },
    Pattern { columns: 4, rows: 4, cells: &[1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0] },
    Pattern { columns: 4, rows: 4, cells: &[1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0] },
    Pattern { columns: 4, rows: 4, cells: &[0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0] },
    Pattern { columns: 8, rows: 8, cells: &[1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0] },
    Pattern { columns: 8, rows: 8, cells: &[1, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0] },
    Pattern { columns: 8, rows: 8, cells: &[0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0] },
];

/// Indices of the named predefined colours.
pub mod colour {
    /// White.
    pub const WHITE: i32 = 0;
    /// Black.
    pub const BLACK: i32 = 1;
    /// Red.
    pub const RED: i32 = 2;
    /// Green.
    pub const GREEN: i32 = 3;
    /// Blue.
    pub const BLUE: i32 = 4;
    /// Cyan.
    pub const CYAN: i32 = 5;
    /// Magenta.
    pub const MAGENTA: i32 = 6;
    /// Yellow.
    pub const YELLOW: i32 = 7;
    /// Grey.
    pub const GREY: i32 = 8;
    /// Dark red.
    pub const DARK_RED: i32 = 9;
    /// Dark green.
    pub const DARK_GREEN: i32 = 10;
    /// Dark blue.
    pub const DARK_BLUE: i32 = 11;
    /// Teal.
    pub const TEAL: i32 = 12;
    /// Purple.
    pub const PURPLE: i32 = 13;
    /// Brown.
    pub const BROWN: i32 = 14;
    /// Orange.
    pub const ORANGE: i32 = 15;
}

/// The predefined colours 0, 1, ...: red, green, blue from 0 to 1.
pub static COLOURS: &[[f32; 3]] = &[
    [1.0, 1.0, 1.0],
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.0, 1.0, 1.0],
    [1.0, 0.0, 1.0],
    [1.0, 1.0, 0.0],
    [0.5, 0.5, 0.5],
    [0.6, 0.0, 0.0],
    [0.0, 0.45, 0.0],
    [0.0, 0.0, 0.55],
    [0.0, 0.5, 0.5],
    [0.5, 0.0, 0.5],
    [0.5, 0.35, 0.1],
    [1.0, 0.5, 0.0],
    [0.0, 0.0, 0.0],
    [0.0, 0.0, 0.2],
    [0.0, 0.0, 0.4],
    [0.0, 0.0, 0.6],
    [0.0, 0.0, 0.8],
    [0.0, 0.0, 1.0],
    [0.0, 0.2, 0.0],
    [0.0, 0.2, 0.2],
    [0.0, 0.2, 0.4],
    [0.0, 0.2, 0.6],
    [0.0, 0.2, 0.8],
    [0.0, 0.2, 1.0],
    [0.0, 0.4, 0.0],
    [0.0, 0.4, 0.2],
    [0.0, 0.4, 0.4],
    [0.0, 0.4, 0.6],
    [0.0, 0.4, 0.8],
    [0.0, 0.4, 1.0],
    [0.0, 0.6, 0.0],
    [0.0, 0.6, 0.2],
    [0.0, 0.6, 0.4],
    [0.0, 0.6, 0.6],
    [0.0, 0.6, 0.8],
    [0.0, 0.6, 1.0],
    [0.0, 0.8, 0.0],
    [0.0, 0.8, 0.2],
    [0.0, 0.8, 0.4],
    [0.0, 0.8, 0.6],
    [0.0, 0.8, 0.8],
    [0.0, 0.8, 1.0],
    [0.0, 1.0, 0.0],
    [0.0, 1.0, 0.2],
    [0.0, 1.0, 0.4],
    [0.0, 1.0, 0.6],
    [0.0, 1.0, 0.8],
    [0.0, 1.0, 1.0],
    [0.2, 0.0, 0.0],
    [0.2, 0.0, 0.2],
    [0.2, 0.0, 0.4],
    [0.2, 0.0, 0.6],
    [0.2, 0.0, 0.8],
    [0.2, 0.0, 1.0],
    [0.2, 0.2, 0.0],
    [0.2, 0.2, 0.2],
    [0.2, 0.2, 0.4],
    [0.2, 0.2, 0.6],
    [0.2, 0.2, 0.8],
    [0.2, 0.2, 1.0],
    [0.2, 0.4, 0.0],
    [0.2, 0.4, 0.2],
    [0.2, 0.4, 0.4],
    [0.2, 0.4, 0.6],
    [0.2, 0.4, 0.8],
    [0.2, 0.4, 1.0],
    [0.2, 0.6, 0.0],
    [0.2, 0.6, 0.2],
    [0.2, 0.6, 0.4],
    [0.2, 0.6, 0.6],
    [0.2, 0.6, 0.8],
    [0.2, 0.6, 1.0],
    [0.2, 0.8, 0.0],
    [0.2, 0.8, 0.2],
    [0.2, 0.8, 0.4],
    [0.2, 0.8, 0.6],
    [0.2, 0.8, 0.8],
    [0.2, 0.8, 1.0],
    [0.2, 1.0, 0.0],
    [0.2, 1.0, 0.2],
    [0.2, 1.0, 0.4],
    [0.2, 1.0, 0.6],
    [0.2, 1.0, 0.8],
    [0.2, 1.0, 1.0],
    [0.4, 0.0, 0.0],
    [0.4, 0.0, 0.2],
    [0.4, 0.0, 0.4],
    [0.4, 0.0, 0.6],
    [0.4, 0.0, 0.8],
    [0.4, 0.0, 1.0],
    [0.4, 0.2, 0.0],
    [0.4, 0.2, 0.2],
    [0.4, 0.2, 0.4],
    [0.4, 0.2, 0.6],
    [0.4, 0.2, 0.8],
    [0.4, 0.2, 1.0],
    [0.4, 0.4, 0.0],
    [0.4, 0.4, 0.2],
    [0.4, 0.4, 0.4],
    [0.4, 0.4, 0.6],
    [0.4, 0.4, 0.8],
    [0.4, 0.4, 1.0],
    [0.4, 0.6, 0.0],
    [0.4, 0.6, 0.2],
    [0.4, 0.6, 0.4],
    [0.4, 0.6, 0.6],
    [0.4, 0.6, 0.8],
    [0.4, 0.6, 1.0],
    [0.4, 0.8, 0.0],
    [0.4, 0.8, 0.2],
    [0.4, 0.8, 0.4],
    [0.4, 0.8, 0.6],
    [0.4, 0.8, 0.8],
    [0.4, 0.8, 1.0],
    [0.4, 1.0, 0.0],
    [0.4, 1.0, 0.2],
    [0.4, 1.0, 0.4],
    [0.4, 1.0, 0.6],
    [0.4, 1.0, 0.8],
    [0.4, 1.0, 1.0],
    [0.6, 0.0, 0.0],
    [0.6, 0.0, 0.2],
    [0.6, 0.0, 0.4],
    [0.6, 0.0, 0.6],
    [0.6, 0.0, 0.8],
    [0.6, 0.0, 1.0],
    [0.6, 0.2, 0.0],
    [0.6, 0.2, 0.2],
    [0.6, 0.2, 0.4],
    [0.6, 0.2, 0.6],
    [0.6, 0.2, 0.8],
    [0.6, 0.2, 1.0],
    [0.6, 0.4, 0.0],
    [0.6, 0.4, 0.2],
    [0.6, 0.4, 0.4],
    [0.6, 0.4, 0.6],
    [0.6, 0.4, 0.8],
    [0.6, 0.4, 1.0],
    [0.6, 0.6, 0.0],
    [0.6, 0.6, 0.2],
    [0.6, 0.6, 0.4],
    [0.6, 0.6, 0.6],
    [0.6, 0.6, 0.8],
    [0.6, 0.6, 1.0],
    [0.6, 0.8, 0.0],
    [0.6, 0.8, 0.2],
    [0.6, 0.8, 0.4],
    [0.6, 0.8, 0.6],
    [0.6, 0.8, 0.8],
    [0.6, 0.8, 1.0],
    [0.6, 1.0, 0.0],
    [0.6, 1.0, 0.2],
    [0.6, 1.0, 0.4],
    [0.6, 1.0, 0.6],
    [0.6, 1.0, 0.8],
    [0.6, 1.0, 1.0],
    [0.8, 0.0, 0.0],
    [0.8, 0.0, 0.2],
    [0.8, 0.0, 0.4],
    [0.8, 0.0, 0.6],
    [0.8, 0.0, 0.8],
    [0.8, 0.0, 1.0],
    [0.8, 0.2, 0.0],
    [0.8, 0.2, 0.2],
    [0.8, 0.2, 0.4],
    [0.8, 0.2, 0.6],
    [0.8, 0.2, 0.8],
    [0.8, 0.2, 1.0],
    [0.8, 0.4, 0.0],
    [0.8, 0.4, 0.2],
    [0.8, 0.4, 0.4],
    [0.8, 0.4, 0.6],
    [0.8, 0.4, 0.8],
    [0.8, 0.4, 1.0],
    [0.8, 0.6, 0.0],
    [0.8, 0.6, 0.2],
    [0.8, 0.6, 0.4],
    [0.8, 0.6, 0.6],
    [0.8, 0.6, 0.8],
    [0.8, 0.6, 1.0],
    [0.8, 0.8, 0.0],
    [0.8, 0.8, 0.2],
    [0.8, 0.8, 0.4],
    [0.8, 0.8, 0.6],
    [0.8, 0.8, 0.8],
    [0.8, 0.8, 1.0],
    [0.8, 1.0, 0.0],
    [0.8, 1.0, 0.2],
    [0.8, 1.0, 0.4],
    [0.8, 1.0, 0.6],
    [0.8, 1.0, 0.8],
    [0.8, 1.0, 1.0],
    [1.0, 0.0, 0.0],
    [1.0, 0.0, 0.2],
    [1.0, 0.0, 0.4],
    [1.0, 0.0, 0.6],
    [1.0, 0.0, 0.8],
    [1.0, 0.0, 1.0],
    [1.0, 0.2, 0.0],
    [1.0, 0.2, 0.2],
    [1.0, 0.2, 0.4],
    [1.0, 0.2, 0.6],
    [1.0, 0.2, 0.8],
    [1.0, 0.2, 1.0],
    [1.0, 0.4, 0.0],
    [1.0, 0.4, 0.2],
    [1.0, 0.4, 0.4],
    [1.0, 0.4, 0.6],
    [1.0, 0.4, 0.8],
    [1.0, 0.4, 1.0],
    [1.0, 0.6, 0.0],
    [1.0, 0.6, 0.2],
    [1.0, 0.6, 0.4],
    [1.0, 0.6, 0.6],
    [1.0, 0.6, 0.8],
    [1.0, 0.6, 1.0],
    [1.0, 0.8, 0.0],
    [1.0, 0.8, 0.2],
    [1.0, 0.8, 0.4],
    [1.0, 0.8, 0.6],
    [1.0, 0.8, 0.8],
    [1.0, 0.8, 1.0],
    [1.0, 1.0, 0.0],
    [1.0, 1.0, 0.2],
    [1.0, 1.0, 0.4],
    [1.0, 1.0, 0.6],
    [1.0, 1.0, 0.8],
    [1.0, 1.0, 1.0],
    [0.04, 0.04, 0.04],
    [0.08, 0.08, 0.08],
    [0.12, 0.12, 0.12],
    [0.16, 0.16, 0.16],
    [0.2, 0.2, 0.2],
    [0.24, 0.24, 0.24],
    [0.28, 0.28, 0.28],
    [0.32, 0.32, 0.32],
    [0.36, 0.36, 0.36],
    [0.4, 0.4, 0.4],
    [0.44, 0.44, 0.44],
    [0.48, 0.48, 0.48],
    [0.52, 0.52, 0.52],
    [0.56, 0.56, 0.56],
    [0.6, 0.6, 0.6],
    [0.64, 0.64, 0.64],
    [0.68, 0.68, 0.68],
    [0.72, 0.72, 0.72],
    [0.76, 0.76, 0.76],
    [0.8, 0.8, 0.8],
    [0.84, 0.84, 0.84],
    [0.88, 0.88, 0.88],
    [0.92, 0.92, 0.92],
    [0.96, 0.96, 0.96],
];
