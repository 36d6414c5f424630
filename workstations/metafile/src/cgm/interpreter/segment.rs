//! Segments: drawn where they are defined, kept to be copied.

use super::Interpreter;
use super::context::Context;
use super::mapping::Mapping;
use crate::cgm::decoder::Decoder;
use crate::cgm::element::Element;
use crate::generated::elements::Kind;
use gks_geometry::Map;
use glam::{DAffine2, DMat2};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The most elements that segments keep, and that copying gives, in one metafile.
const MOST_ELEMENTS: usize = 1 << 20;

/// The most copies inside of copies.
const DEEPEST: usize = 16;

/// The segments of a metafile.
#[derive(Debug, Default)]
pub(super) struct Segments {
    kept: BTreeMap<i32, Arc<[Element]>>,
    open: Option<(i32, Vec<Element>)>,
    copies: Vec<Copying>,
    count: usize,
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
            (Kind::EndPicture | Kind::BeginPicture, Some(_)) => self.open = None,
            (_, Some((_, elements))) => {
                if self.count < MOST_ELEMENTS {
                    self.count += 1;
                    elements.push(element.clone());
                }
                return true;
            }
            _ => {}
        }
        false
    }
}

impl<D: Decoder> Interpreter<D> {
    pub(super) fn copy_segment(&mut self, e: &Element) {
        let mapping = self.mapping();
        let Some(elements) = e.integer(0).and_then(|name| self.segments.kept.get(&name)).cloned() else {
            self.senseless(e);
            return;
        };
        if self.segments.copies.len() >= DEEPEST {
            return;
        }
        let matrix = || {
            let rows = (e.vector(1)?, e.vector(3)?);
            let linear = DMat2::from_cols_array(&[rows.0.x, rows.1.x, rows.0.y, rows.1.y]);
            Some(DAffine2::from_mat2_translation(linear, e.vector(5)?))
        };
        if let Some(affine) = matrix() {
            let map = Map::from_affine(affine).then(&mapping.map);
            let scale = mapping.scale * affine.matrix2.determinant().abs().sqrt();
            self.mapping = Some(Mapping { map, scale, ..mapping });
        }
        let context = self.context.clone();
        self.segments.copies.push(Copying { elements, next: 0, context, mapping });
    }

    /// The next element of the segment that is being copied.
    pub(super) fn copied_element(&mut self) -> Option<Element> {
        loop {
            let copying = self.segments.copies.last_mut()?;
            if let Some(element) = copying.elements.get(copying.next)
                && self.segments.copied < MOST_ELEMENTS
            {
                copying.next += 1;
                self.segments.copied += 1;
                return Some(element.clone());
            }
            if let Some(done) = self.segments.copies.pop() {
                self.context = done.context;
                self.mapping = Some(done.mapping);
            }
        }
    }
}
