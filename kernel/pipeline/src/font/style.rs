//! The text attributes that layout depends on: font, expansion, spacing, path and alignment.

use crate::look::enumeration;

enumeration! {
    /// Direction in which the characters of a string follow one another.
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

enumeration! {
    /// Horizontal alignment of a string at its position.
    Horizontal {
        /// What is natural to the path: left for RIGHT, right for LEFT, centre for UP and DOWN.
        Normal = 0,
        /// Left edge of the extent.
        Left = 1,
        /// Centre of the extent.
        Centre = 2,
        /// Right edge of the extent.
        Right = 3,
    }
}

enumeration! {
    /// Vertical alignment of a string at its position.
    Vertical {
        /// What is natural to the path: the top for DOWN, the base line for the others.
        Normal = 0,
        /// Top of the uppermost character body.
        Top = 1,
        /// Cap line of the uppermost character.
        Cap = 2,
        /// Halfway between the half lines of the uppermost and the lowest character.
        Half = 3,
        /// Base line of the lowest character.
        Base = 4,
        /// Bottom of the lowest character body.
        Bottom = 5,
    }
}

/// The text attributes that layout depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextStyle {
    /// Font number; a number that is not one of [`super::numbers`] is taken as 1.
    pub font: i32,
    /// Character expansion factor: widths relative to the design of the font.
    pub expansion: f64,
    /// Space added between adjacent bodies, in character heights; negative values overlap them.
    pub spacing: f64,
    /// Text path.
    pub path: TextPath,
    /// Horizontal alignment.
    pub horizontal: Horizontal,
    /// Vertical alignment.
    pub vertical: Vertical,
}

impl Default for TextStyle {
    /// The initial values of the standard: font 1, expansion 1, spacing 0, path RIGHT, alignment NORMAL.
    fn default() -> Self {
        Self {
            font: 1,
            expansion: 1.0,
            spacing: 0.0,
            path: TextPath::Right,
            horizontal: Horizontal::Normal,
            vertical: Vertical::Normal,
        }
    }
}

impl TextStyle {
    /// The alignment with NORMAL replaced by what it means for the path.
    pub fn alignment(&self) -> (Horizontal, Vertical) {
        let horizontal = match (self.horizontal, self.path) {
            (Horizontal::Normal, TextPath::Right) => Horizontal::Left,
            (Horizontal::Normal, TextPath::Left) => Horizontal::Right,
            (Horizontal::Normal, _) => Horizontal::Centre,
            (set, _) => set,
        };
        let vertical = match (self.vertical, self.path) {
            (Vertical::Normal, TextPath::Down) => Vertical::Top,
            (Vertical::Normal, _) => Vertical::Base,
            (set, _) => set,
        };
        (horizontal, vertical)
    }
}
