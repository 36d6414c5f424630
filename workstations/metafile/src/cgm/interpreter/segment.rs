//! Segments: drawn where they are defined, kept to be copied.

use super::Interpreter;
use super::context::Context;
use super::mapping::Mapping;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::{Element, Value};
use crate::generated::elements::Kind;
use gks_geometry::{Ndc, Rect};
use glam::{DAffine2, DMat2};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The most elements that segments keep, and that copying gives, in one metafile; 256 cells count like one when copied.
const MOST_ELEMENTS: usize = 1 << 20;

/// The most cells in elements that segments keep: 8 MiB of them, which a copy holds three times.
const MOST_CELLS: usize = 1 << 21;

/// The most copies inside of copies.
const DEEPEST: usize = 16;

/// The segments of a metafile.
#[derive(Debug, Default)]
pub(super) struct Segments {
    kept: BTreeMap<i32, Arc<[Element]>>,
    open: Option<(i32, Vec<Element>)>,
    copies: Vec<Copying>,
    transformations: BTreeMap<i32, DAffine2>,
    /// The mapping outside of the open segment, if that has a transformation.
    outside: Option<Mapping>,
    count: usize,
    /// The cells in the elements that are kept.
    cells: usize,
    copied: usize,
}

/// A segment that is being copied.
#[derive(Debug)]
struct Copying {
    elements: Arc<[Element]>,
    next: usize,
    /// What holds again afterwards.
    context: Context,
    mapping: Mapping,
    /// What it is clipped to where it is copied to.
    clip: Rect<Ndc>,
}

impl Segments {
    /// Keeps an element of the segment that is open; whether there is one.
    pub(super) fn collects(&mut self, element: &Element) -> bool {
        if !self.copies.is_empty() {
            return false;
        }
        match (element.kind, &mut self.open) {
            (Kind::BeginSegment, _) => self.open = element.integer(0).map(|name| (name, Vec::new())),
            (Kind::EndSegment, Some(_)) => {
                if let Some((name, elements)) = self.open.take() {
                    self.kept.insert(name, elements.into());
                }
            }
            (Kind::EndPicture | Kind::BeginPicture, Some(_)) => (self.open, self.outside) = (None, None),
            (_, Some((_, elements))) => {
                let cells = self.cells + cells(element);
                if self.count < MOST_ELEMENTS && cells <= MOST_CELLS {
                    (self.count, self.cells) = (self.count + 1, cells);
                    elements.push(element.clone());
                }
                return true;
            }
            _ => {}
        }
        false
    }

    /// The mapping outside of the open segment, if it is another one, while nothing is copied.
    pub(super) fn place(&self) -> Option<Mapping> {
        self.outside.filter(|_| self.copies.is_empty())
    }

    /// What a copy is clipped to, if something is being copied.
    pub(super) fn clip(&self) -> Option<Rect<Ndc>> {
        self.copies.last().map(|copying| copying.clip)
    }
}

/// The cells in an element.
fn cells(element: &Element) -> usize {
    let count = |value: &Value| if let Value::Cells(cells) = value { cells.inks.len() } else { 0 };
    element.values.iter().map(count).sum()
}

/// The transformation whose parameters begin at a place.
fn transformation(e: &Element, place: usize) -> Option<DAffine2> {
    let rows = (e.vector(place)?, e.vector(place + 2)?);
    let linear = DMat2::from_cols_array(&[rows.0.x, rows.1.x, rows.0.y, rows.1.y]);
    Some(DAffine2::from_mat2_translation(linear, e.vector(place + 4)?))
}

impl<D: Decoder> Interpreter<D> {
    /// Gives a segment a transformation, with which it is drawn if it is open, and copied if the copy asks for it.
    pub(super) fn transform_segment(&mut self, e: &Element) {
        let (Some(name), Some(transformation)) = (e.integer(0), transformation(e, 1)) else {
            self.senseless(e);
            return;
        };
        self.segments.transformations.insert(name, transformation);
        self.begin_segment();
    }

    /// Draws what follows with the transformation of the open segment.
    pub(super) fn begin_segment(&mut self) {
        let Segments { open, transformations, outside, copies, .. } = &mut self.segments;
        let Some((name, _)) = open else { return };
        if let (Some(transformation), Some(mapping), true) =
            (transformations.get(name), self.mapping, copies.is_empty())
        {
            self.mapping = Some(outside.get_or_insert(mapping).after(*transformation));
        }
    }

    /// Draws what follows without the transformation of the segment that was open.
    pub(super) fn end_segment(&mut self) {
        if let Some(mapping) = self.segments.outside.take() {
            self.mapping = Some(mapping);
        }
    }

    pub(super) fn copy_segment(&mut self, e: &Element) {
        let mapping = self.mapping();
        let name = e.integer(0);
        let Some(elements) = name.and_then(|name| self.segments.kept.get(&name)).cloned() else {
            self.senseless(e);
            return;
        };
        // A copy of which nothing is to be seen is none.
        let Some(clip) = self.clip() else { return };
        if self.segments.copies.len() >= DEEPEST {
            return;
        }
        let mut copied = mapping;
        if let Some(transformation) = transformation(e, 1) {
            copied = copied.after(transformation);
        }
        if e.integer(7) == Some(1)
            && let Some(transformation) = name.and_then(|name| self.segments.transformations.get(&name))
        {
            copied = copied.after(*transformation);
        }
        self.mapping = Some(copied);
        let context = self.context.clone();
        self.context.clip = None;
        self.segments.copies.push(Copying { elements, next: 0, context, mapping, clip });
    }

    /// The next element of the segment that is being copied.
    pub(super) fn copied_element(&mut self) -> Option<Element> {
        loop {
            let copying = self.segments.copies.last_mut()?;
            if let Some(element) = copying.elements.get(copying.next)
                && self.segments.copied < MOST_ELEMENTS
            {
                copying.next += 1;
                // Cells take time to draw.
                self.segments.copied += 1 + cells(element) / 256;
                return Some(element.clone());
            }
            if let Some(done) = self.segments.copies.pop() {
                self.context = done.context;
                self.mapping = Some(done.mapping);
            }
        }
    }
}
