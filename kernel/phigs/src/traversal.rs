//! Traversal: from the elements of a posted structure network to items at the waist.

use crate::store::{Composition, Element, StructureStore};
use crate::view::ViewRepresentation;
use gks_geometry::{Map3, Mc, Npc, PathBuf, Point3, Rect, Wc};
use gks_pipeline::device::DeviceError;
use gks_pipeline::item::{Item, Shape};
use gks_pipeline::look::Look;
use gks_pipeline::workstation::Workstation;
use glam::{DVec2, DVec4};
use std::collections::BTreeMap;

/// How deep structures may execute one another; a network has no cycles, so only its own depth counts.
const MAX_DEPTH: usize = 1000;

/// The traversal state list, saved around the execution of a structure.
#[derive(Clone)]
struct State {
    global: Map3<Mc, Wc>,
    local: Map3<Mc, Mc>,
    look: Look,
    view: u32,
}

/// Traverses a structure network and draws it on a workstation.
pub(crate) fn traverse(
    store: &StructureStore,
    root: i32,
    views: &BTreeMap<u32, ViewRepresentation>,
    workstation: &mut Workstation,
) -> Result<(), DeviceError> {
    let state = State { global: Map3::IDENTITY, local: Map3::IDENTITY, look: Look::default(), view: 0 };
    let mut traversal = Traversal { store, views, workstation, clip: Vec::new(), paths: PathBuf::new() };
    traversal.structure(root, state, 0)
}

struct Traversal<'a> {
    store: &'a StructureStore,
    views: &'a BTreeMap<u32, ViewRepresentation>,
    workstation: &'a mut Workstation,
    /// Scratch: a primitive in homogeneous normalized projection coordinates.
    clip: Vec<DVec4>,
    paths: PathBuf<Npc>,
}

impl Traversal<'_> {
    fn structure(&mut self, id: i32, mut state: State, depth: usize) -> Result<(), DeviceError> {
        if depth > MAX_DEPTH {
            return Ok(());
        }
        for element in self.store.elements(id) {
            match element {
                Element::Polyline3(points) => self.primitive(points, &state, false)?,
                Element::FillArea3(points) => self.primitive(points, &state, true)?,
                Element::PolylineColour(index) => state.look.line.colour = *index,
                Element::Linewidth(factor) => state.look.line.width = *factor,
                Element::InteriorStyle(style) => state.look.fill.interior = *style,
                Element::InteriorColour(index) => state.look.fill.colour = *index,
                Element::LocalTransformation3(map, composition) => {
                    state.local = match composition {
                        Composition::Replace => *map,
                        Composition::Preconcatenate => map.then(&state.local),
                        Composition::Postconcatenate => state.local.then(map),
                    };
                }
                Element::ViewIndex(index) => state.view = *index,
                Element::ExecuteStructure(child) => {
                    let mut inherited = state.clone();
                    inherited.global = state.local.then(&state.global);
                    inherited.local = Map3::IDENTITY;
                    self.structure(*child, inherited, depth + 1)?;
                }
            }
        }
        Ok(())
    }

    fn primitive(&mut self, points: &[Point3<Mc>], state: &State, area: bool) -> Result<(), DeviceError> {
        let zero = ViewRepresentation::default();
        let view = self.views.get(&state.view).or_else(|| self.views.get(&0)).unwrap_or(&zero);
        let map = state.local.then(&state.global).then(&view.orientation).then(&view.mapping);
        self.clip.clear();
        self.clip.extend(points.iter().map(|&p| map.homogeneous(p)).filter(|p| p.is_finite()));
        self.paths.clear();
        if area {
            clip_area(&mut self.clip, view);
            self.paths.add(self.clip.iter().map(|&p| projected(p)));
            self.paths.end_or_drop(3);
        } else {
            clip_lines(&self.clip, view, &mut self.paths);
        }
        if self.paths.ends.is_empty() {
            return Ok(());
        }
        let paths = self.paths.as_paths();
        let shape = if area { Shape::FillArea(paths) } else { Shape::Polyline(paths) };
        let clip = if view.clip_xy { view.clip } else { Rect::UNIT };
        self.workstation.draw(&Item { shape, look: &state.look, clip, pick: 0 })
    }
}

fn projected(p: DVec4) -> DVec2 {
    DVec2::new(p.x / p.w, p.y / p.w)
}

/// The half spaces that clip in depth, before the division by w: a point is inside where the value is not
/// negative. What lies behind the eye (w not positive) is always outside.
fn half_spaces(view: &ViewRepresentation) -> [Option<DVec4>; 3] {
    let (back, front) = view.depth;
    [
        Some(DVec4::new(0.0, 0.0, 0.0, 1.0)),
        view.clip_back.then_some(DVec4::new(0.0, 0.0, 1.0, -back)),
        view.clip_front.then_some(DVec4::new(0.0, 0.0, -1.0, front)),
    ]
}

/// The least w that counts as in front of the eye.
const LEAST_W: f64 = 1e-9;

fn distance(plane: DVec4, p: DVec4) -> f64 {
    if plane.truncate() == glam::DVec3::ZERO { p.w - LEAST_W } else { plane.dot(p) }
}

/// Clips a polygon against the half spaces (I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping",
/// CACM 17(1), 1974, in homogeneous coordinates).
fn clip_area(polygon: &mut Vec<DVec4>, view: &ViewRepresentation) {
    for plane in half_spaces(view).into_iter().flatten() {
        let old = std::mem::take(polygon);
        for (i, &b) in old.iter().enumerate() {
            let a = old[(i + old.len() - 1) % old.len()];
            let (da, db) = (distance(plane, a), distance(plane, b));
            if (da < 0.0) != (db < 0.0) {
                polygon.push(a + (b - a) * (da / (da - db)));
            }
            if db >= 0.0 {
                polygon.push(b);
            }
        }
    }
}

/// Clips each segment against the half spaces (Y. Liang, B. A. Barsky, "A New Concept and Method for Line
/// Clipping", ACM TOG 3(1), 1984, in homogeneous coordinates) and projects what remains.
fn clip_lines(points: &[DVec4], view: &ViewRepresentation, out: &mut PathBuf<Npc>) {
    for pair in points.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let (mut from, mut to) = (0.0f64, 1.0f64);
        for plane in half_spaces(view).into_iter().flatten() {
            let (da, db) = (distance(plane, a), distance(plane, b));
            if da < 0.0 && db < 0.0 {
                from = f64::INFINITY;
            } else if da < 0.0 {
                from = from.max(da / (da - db));
            } else if db < 0.0 {
                to = to.min(da / (da - db));
            }
        }
        if from > to {
            out.end_or_drop(2);
            continue;
        }
        if from > 0.0 || out.points.len() == out.start() {
            out.end_or_drop(2);
            out.push(projected(a + (b - a) * from));
        }
        out.push(projected(if to < 1.0 { a + (b - a) * to } else { b }));
        if to < 1.0 {
            out.end_or_drop(2);
        }
    }
    out.end_or_drop(2);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_at_the_front_plane_and_go_on_behind_it() {
        let view = ViewRepresentation::default();
        let at = |x: f64, z: f64| DVec4::new(x, 0.5, z, 1.0);
        let mut out = PathBuf::new();
        clip_lines(&[at(0.0, 0.5), at(0.2, 1.5), at(0.4, 0.5), at(0.6, 0.5)], &view, &mut out);
        let xs: Vec<Vec<f64>> = out.as_paths().iter().map(|p| p.iter().map(|v| v.x).collect()).collect();
        assert_eq!(xs.len(), 2);
        assert!((xs[0][1] - 0.1).abs() < 1e-12 && (xs[1][0] - 0.3).abs() < 1e-12);
        assert_eq!(xs[1].len(), 3);
    }

    #[test]
    fn areas_behind_the_eye_vanish() {
        let mut polygon = vec![DVec4::new(0.0, 0.0, 0.0, -1.0); 4];
        clip_area(&mut polygon, &ViewRepresentation::default());
        assert!(polygon.is_empty());
    }
}
