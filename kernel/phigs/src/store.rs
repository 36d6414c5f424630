//! The centralized structure store.

use gks_geometry::{Map3, Mc, Point3};
use gks_pipeline::look::InteriorStyle;
use std::collections::{BTreeMap, BTreeSet};

/// How a new local modelling transformation combines with the one before.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Composition {
    /// The new one acts on points first.
    Preconcatenate,
    /// The new one acts on points last.
    Postconcatenate,
    /// The new one takes the place of the old one.
    Replace,
}

/// A structure element.
#[derive(Clone, Debug, PartialEq)]
pub enum Element {
    /// POLYLINE 3: lines through points.
    Polyline3(Vec<Point3<Mc>>),
    /// FILL AREA 3: a plane polygon.
    FillArea3(Vec<Point3<Mc>>),
    /// SET POLYLINE COLOUR INDEX.
    PolylineColour(u32),
    /// SET LINEWIDTH SCALE FACTOR.
    Linewidth(f64),
    /// SET INTERIOR STYLE.
    InteriorStyle(InteriorStyle),
    /// SET INTERIOR COLOUR INDEX.
    InteriorColour(u32),
    /// SET LOCAL TRANSFORMATION 3.
    LocalTransformation3(Map3<Mc, Mc>, Composition),
    /// SET VIEW INDEX.
    ViewIndex(u32),
    /// EXECUTE STRUCTURE.
    ExecuteStructure(i32),
}

/// All structures by structure identifier.
#[derive(Clone, Debug, Default)]
pub(crate) struct StructureStore {
    structures: BTreeMap<i32, Vec<Element>>,
    open: Option<i32>,
}

impl StructureStore {
    pub(crate) fn open(&mut self, id: i32) {
        self.structures.entry(id).or_default();
        self.open = Some(id);
    }

    pub(crate) fn close(&mut self) {
        self.open = None;
    }

    pub(crate) fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Adds an element at the end of the open structure; a structure that is executed exists from then on.
    pub(crate) fn append(&mut self, element: Element) {
        if let Element::ExecuteStructure(id) = element {
            self.structures.entry(id).or_default();
        }
        if let Some(structure) = self.open.and_then(|id| self.structures.get_mut(&id)) {
            structure.push(element);
        }
    }

    pub(crate) fn create(&mut self, id: i32) {
        self.structures.entry(id).or_default();
    }

    pub(crate) fn elements(&self, id: i32) -> &[Element] {
        self.structures.get(&id).map_or(&[], Vec::as_slice)
    }

    /// Whether executing `id` would reach `target`: structure networks have no cycles.
    pub(crate) fn reaches(&self, id: i32, target: i32) -> bool {
        let mut seen = BTreeSet::new();
        let mut next = vec![id];
        while let Some(id) = next.pop() {
            if id == target {
                return true;
            }
            if seen.insert(id) {
                next.extend(self.elements(id).iter().filter_map(|element| match element {
                    Element::ExecuteStructure(child) => Some(*child),
                    _ => None,
                }));
            }
        }
        false
    }

    /// The structure that is open.
    pub(crate) fn open_structure(&self) -> Option<i32> {
        self.open
    }
}
