//! Colours of a metafile as colour indices of a workstation.

use super::queue::Queue;
use crate::cgm::element::{Cells, Ink, Inks};
use gks_pipeline::colour::Colour;
use gks_pipeline::generated::numbers;
use std::collections::{BTreeMap, HashMap, HashSet};

/// What the colour table of the workstation holds.
///
/// It starts with the predefined colours. Entries are told when something is drawn with them, so that what one
/// picture has set does not show in the next one. A direct colour takes an index that has it, else a new one above
/// those in use; when there is none left, the oldest such indices are used again.
#[derive(Debug)]
pub(super) struct Palette {
    told: BTreeMap<u32, Colour>,
    direct: HashMap<[u8; 3], u32>,
    next: u32,
    background: Colour,
}

/// The colour that an index has on every workstation.
fn predefined(index: u32) -> Option<Colour> {
    let [red, green, blue] = *numbers::COLOURS.get(index as usize)?;
    Some(Colour::rgb(red, green, blue))
}

fn bytes(colour: Colour) -> [u8; 3] {
    let [red, green, blue, _] = colour.to_bytes();
    [red, green, blue]
}

impl Default for Palette {
    fn default() -> Self {
        Palette { told: BTreeMap::new(), direct: HashMap::new(), next: 0, background: Colour::WHITE }
    }
}

impl Palette {
    /// Forgets the direct colours of the picture before, and gives this one its background.
    pub(super) fn begin_picture(&mut self, background: Colour, queue: &mut Queue) {
        self.direct.clear();
        self.next = 0;
        self.set_background(background, queue);
    }

    /// Gives the picture another background, before anything is drawn in it.
    pub(super) fn set_background(&mut self, background: Colour, queue: &mut Queue) {
        self.background = background;
        self.tell(0, background, queue);
    }

    /// Makes an index have a colour.
    pub(super) fn tell(&mut self, index: u32, colour: Colour, queue: &mut Queue) {
        let known = self.told.get(&index).copied().or_else(|| predefined(index));
        if known != Some(colour) {
            self.told.insert(index, colour);
            queue.colour(index, colour);
        }
    }

    /// The index with which something of this colour is drawn.
    pub(super) fn index(&mut self, ink: Ink, table: &BTreeMap<u32, Colour>, queue: &mut Queue) -> u32 {
        match ink {
            // An entry 0 that a picture changes is a colour like any other; its background stays.
            Ink::Index(0) => match table.get(&0) {
                Some(&colour) if colour != self.background => self.direct(bytes(colour), table, queue),
                _ => 0,
            },
            Ink::Index(index) => match table.get(&index).copied().or_else(|| predefined(index)) {
                Some(colour) if index < numbers::MAX_COLOURS => {
                    self.tell(index, colour, queue);
                    index
                }
                Some(colour) => self.direct(bytes(colour), table, queue),
                None => 1,
            },
            Ink::Direct(colour) => self.direct(bytes(colour), table, queue),
        }
    }

    fn direct(&mut self, colour: [u8; 3], table: &BTreeMap<u32, Colour>, queue: &mut Queue) -> u32 {
        let wanted = |[red, green, blue]: [u8; 3]| {
            Colour::from((f64::from(red) / 255.0, f64::from(green) / 255.0, f64::from(blue) / 255.0))
        };
        if let Some(&index) = self.direct.get(&colour) {
            self.tell(index, wanted(colour), queue);
            return index;
        }
        let count = numbers::COLOURS.len() as u32;
        let has = |index: &u32| {
            let shown = self.told.get(index).copied().or_else(|| predefined(*index));
            !table.contains_key(index) && shown.map(bytes) == Some(colour)
        };
        let index = (1..count).find(has).unwrap_or_else(|| {
            let least = table.keys().rfind(|&&index| index < numbers::MAX_COLOURS - 1);
            let least = least.map_or(count, |&index| (index + 1).max(count));
            let index =
                if self.next < least || self.next >= numbers::MAX_COLOURS { least } else { self.next };
            self.next = index + 1;
            self.direct.retain(|_, taken| *taken != index);
            self.tell(index, wanted(colour), queue);
            index
        });
        self.direct.insert(colour, index);
        index
    }

    /// The indices of an array of colours.
    pub(super) fn cells(
        &mut self,
        cells: &Cells,
        table: &BTreeMap<u32, Colour>,
        queue: &mut Queue,
    ) -> Vec<i32> {
        match &cells.inks {
            Inks::Indices(indices) => {
                let mut map: HashMap<i32, i32> = HashMap::new();
                let mut index_of = |&index: &i32| {
                    *map.entry(index).or_insert_with(|| {
                        let ink = Ink::Index(u32::try_from(index).unwrap_or(1));
                        self.index(ink, table, queue) as i32
                    })
                };
                indices.iter().map(&mut index_of).collect()
            }
            Inks::Direct(colours) => {
                // More colours than indices are brought down to 5 bits for each component.
                let room = numbers::MAX_COLOURS as usize / 2;
                let mut distinct: HashSet<[u8; 3]> = HashSet::new();
                let many = colours.iter().any(|colour| distinct.insert(*colour) && distinct.len() > room);
                let nearest = |colour: &[u8; 3]| {
                    if many { colour.map(|c| ((u32::from(c >> 3) * 255 + 15) / 31) as u8) } else { *colour }
                };
                colours.iter().map(|colour| self.direct(nearest(colour), table, queue) as i32).collect()
            }
        }
    }
}
