//! The types of parameters of elements (ISO/IEC 8632-1, abstract data types).

/// The type of a parameter, which each encoding codes in its own way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// A signed integer, at integer precision.
    Integer,
    /// A signed index, at index precision.
    Index,
    /// A name, at name precision.
    Name,
    /// One of the words, counted from 0.
    Enumeration(&'static [&'static str]),
    /// A real number, at real precision.
    Real,
    /// A real number that the binary encoding always writes in floating point.
    Metric,
    /// A coordinate or a distance in virtual device coordinates.
    Coordinate,
    /// Two coordinates.
    Point,
    /// A string.
    Text,
    /// A data record.
    Data,
    /// A colour index, whatever the colour selection mode is.
    ColourIndex,
    /// A direct colour, whatever the colour selection mode is.
    DirectColour,
    /// A colour of the kind that the colour selection mode says.
    Colour,
    /// One component of a colour, not scaled.
    Component,
    /// A coordinate of a device viewport: real, or integer in the units of a device.
    Viewport,
    /// A line width: a factor or a distance, as the line width specification mode says.
    LineWidth,
    /// A marker size: a factor or a distance, as the marker size specification mode says.
    MarkerSize,
    /// An edge width: a factor or a distance, as the edge width specification mode says.
    EdgeWidth,
    /// A size of an interior style: a factor or a distance, as the interior style specification mode says.
    StyleSize,
    /// The parameters of a precision, which are different in each encoding.
    Precision,
    /// The elements that occur in the metafile.
    ElementList,
    /// Numbers of columns and rows, local colour precision, and the colours of an array of cells.
    Cells,
    /// The same of a pattern.
    Pattern,
    /// A number of points and the points.
    CountedPoints,
    /// Order, number of points, points, knots and range of a B-spline.
    Spline,
    /// The same with weights.
    RationalSpline,
    /// The bits of a tile.
    Bits,
    /// What is not interpreted.
    Raw,
    /// A list of such groups, up to the end of the element.
    Repeat(&'static [Parameter]),
}
