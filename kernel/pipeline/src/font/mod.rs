//! Fonts and text layout.

/// A typeface whose characters are outlines.
#[derive(Debug)]
pub struct OutlineFace {
    /// The font number.
    pub number: i32,
    /// The family name, as other programs know it.
    pub family: &'static str,
    /// Whether the face is a bold one.
    pub bold: bool,
    /// Whether the face is an italic one.
    pub italic: bool,
    /// The font file (TrueType).
    pub data: &'static [u8],
    /// Font units to the em.
    pub units_per_em: u16,
}

crate::look::enumeration! {
    /// The direction in which characters follow one another.
    TextPath {
        /// Along the character base vector.
        Right = 0,
        /// Against the character base vector.
        Left = 1,
        /// Along the character up vector.
        Up = 2,
        /// Against the character up vector.
        Down = 3,
    }
}

crate::look::enumeration! {
    /// Where the text position lies in the text, horizontally.
    Horizontal {
        /// By the text path.
        Normal = 0,
        /// At the left edge.
        Left = 1,
        /// In the middle.
        Centre = 2,
        /// At the right edge.
        Right = 3,
    }
}

crate::look::enumeration! {
    /// Where the text position lies in the text, vertically.
    Vertical {
        /// By the text path.
        Normal = 0,
        /// At the top line.
        Top = 1,
        /// At the cap line.
        Cap = 2,
        /// At the half line.
        Half = 3,
        /// At the base line.
        Base = 4,
        /// At the bottom line.
        Bottom = 5,
    }
}
