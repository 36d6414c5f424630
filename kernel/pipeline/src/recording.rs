//! Primitives kept to be drawn again: what segments, segment storage and inserted segments hold.
//!
//! A recording is one list of small entries and one array for each kind of content, so that a primitive
//! costs no allocation of its own:
//!
//! | kept | bytes |
//! |---|---|
//! | a primitive | 12 |
//! | a point, a vector, the range of an arc | 16 |
//! | the end of a path | 4 |
//! | a character | 1 to 4 (UTF-8), and 8 for each text |
//! | a cell | 4, and 16 for each array |
//! | a changed look, clipping rectangle or pick identifier | 12, and the look (once) or the rectangle (32) |
//!
//! A polyline of two points so takes 48 bytes. A look, which is large, is kept once for a run of primitives
//! that look alike, and found again where a program alternates between a few.

use crate::item::{Cells, Closure, Curve, Ellipse, Item, Parallelogram, Role, Shape};
use crate::look::{ClipSector, Look};
use gks_geometry::{Map, Ndc, Paths, Point, Rect, Vector};
use glam::DVec2;

/// How many of the latest looks are searched for one that returns.
const REMEMBERED: usize = 16;

/// Primitives with their looks, clipping rectangles and pick identifiers, in the order of drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    entries: Vec<Entry>,
    points: Vec<DVec2>,
    /// The ends of paths, counted from the first point of their primitive.
    ends: Vec<u32>,
    text: String,
    cells: Vec<i32>,
    /// The length of each text in bytes, columns and rows of each cell array.
    sizes: Vec<usize>,
    looks: Vec<Look>,
    clips: Vec<Rect<Ndc>>,
    /// Number of primitives.
    count: usize,
    /// What holds for a primitive that is added.
    look: u32,
    pick: i32,
}

/// A primitive, which takes its content from the arrays in turn, or a change of what holds for those that
/// follow.
#[derive(Copy, Clone, Debug, PartialEq)]
enum Entry {
    Polyline { points: u32, paths: u32 },
    Polymarker { points: u32 },
    Text,
    FillArea { points: u32, rings: u32 },
    CellArray,
    Ellipse(Closure, Role),
    Bezier(u32, Role),
    Look(u32),
    Clip,
    Pick(i32),
}

impl Recording {
    /// A recording without primitives.
    pub fn new() -> Self {
        Recording::default()
    }

    /// Number of primitives.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there is no primitive.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Adds a primitive.
    pub fn push(&mut self, item: &Item<'_>) {
        self.push_look(item.look);
        self.push_state(item.clip, item.pick);
        self.push_shape(&item.shape);
    }

    /// Adds the image of a primitive under a map: its points, its text vectors and its pattern box. The
    /// clipping rectangle is taken as it is.
    pub fn push_mapped(&mut self, item: &Item<'_>, map: &Map<Ndc, Ndc>) {
        let mut look = item.look.clone();
        let (text, pattern) = (&mut look.text_geometry, &mut look.pattern);
        (text.height, text.width) = (map.vector(text.height), map.vector(text.width));
        (pattern.width, pattern.height) = (map.vector(pattern.width), map.vector(pattern.height));
        pattern.reference = map.point(pattern.reference);
        self.push_look(&look);
        self.push_state(item.clip, item.pick);
        let first = self.points.len();
        self.push_shape(&item.shape);
        // Which of the points added are positions and which are vectors depends on the primitive.
        let (positions, vectors) = match item.shape {
            Shape::CellArray(..) => (1, 2),
            Shape::Generalized(Curve::Ellipse(_), _) => (1, 2),
            _ => (self.points.len() - first, 0),
        };
        let (positions, rest) = self.points[first..].split_at_mut(positions);
        positions.iter_mut().for_each(|p| *p = map.0.transform_point2(*p));
        rest[..vectors].iter_mut().for_each(|v| *v = map.0.transform_vector2(*v));
    }

    /// The images of all primitives under a map, clipped at another rectangle or a sector in it.
    #[must_use]
    pub fn mapped(&self, map: &Map<Ndc, Ndc>, clip: Rect<Ndc>, sector: Option<ClipSector>) -> Recording {
        let mut mapped = Recording::new();
        let mut look = Look::default();
        for item in self {
            look.clone_from(item.look);
            look.clip_sector = sector;
            mapped.push_mapped(&Item { clip, look: &look, ..item }, map);
        }
        mapped
    }

    /// Removes all primitives and keeps the memory.
    pub fn clear(&mut self) {
        self.entries.clear();
        self.points.clear();
        self.ends.clear();
        self.text.clear();
        self.cells.clear();
        self.sizes.clear();
        self.looks.clear();
        self.clips.clear();
        (self.count, self.look, self.pick) = (0, 0, 0);
    }

    /// Gives back memory that was taken for primitives to come.
    pub fn shrink(&mut self) {
        self.entries.shrink_to_fit();
        self.points.shrink_to_fit();
        self.ends.shrink_to_fit();
        self.text.shrink_to_fit();
        self.cells.shrink_to_fit();
        self.sizes.shrink_to_fit();
        self.looks.shrink_to_fit();
        self.clips.shrink_to_fit();
    }

    /// The memory that the content takes, in bytes, without room for primitives to come.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.entries[..])
            + size_of_val(&self.points[..])
            + size_of_val(&self.ends[..])
            + self.text.len()
            + size_of_val(&self.cells[..])
            + size_of_val(&self.sizes[..])
            + size_of_val(&self.looks[..])
            + size_of_val(&self.clips[..])
    }

    /// The primitives, borrowed; nothing is allocated.
    pub fn iter(&self) -> Items<'_> {
        Items {
            entries: self.entries.iter(),
            points: &self.points,
            ends: &self.ends,
            text: &self.text,
            cells: &self.cells,
            sizes: &self.sizes,
            looks: &self.looks,
            clips: &self.clips,
            look: self.looks.first(),
            clip: Rect::UNIT,
            pick: 0,
            left: self.count,
        }
    }

    fn push_look(&mut self, look: &Look) {
        if self.looks.get(self.look as usize) == Some(look) {
            return;
        }
        let from = self.looks.len().saturating_sub(REMEMBERED);
        let found = self.looks[from..].iter().rposition(|known| known == look).map(|at| from + at);
        let at = found.unwrap_or_else(|| {
            self.looks.push(look.clone());
            self.looks.len() - 1
        });
        self.look = at as u32;
        self.entries.push(Entry::Look(self.look));
    }

    fn push_state(&mut self, clip: Rect<Ndc>, pick: i32) {
        if self.clips.last() != Some(&clip) {
            self.clips.push(clip);
            self.entries.push(Entry::Clip);
        }
        if self.pick != pick {
            self.pick = pick;
            self.entries.push(Entry::Pick(pick));
        }
    }

    fn push_paths(&mut self, paths: Paths<'_, Ndc>) -> (u32, u32) {
        self.points.extend_from_slice(paths.points);
        self.ends.extend_from_slice(paths.ends);
        (paths.points.len() as u32, paths.ends.len() as u32)
    }

    fn push_shape(&mut self, shape: &Shape<'_>) {
        let entry = match *shape {
            Shape::Polyline(paths) => {
                let (points, paths) = self.push_paths(paths);
                Entry::Polyline { points, paths }
            }
            Shape::Polymarker(positions) => {
                self.points.extend_from_slice(positions);
                Entry::Polymarker { points: positions.len() as u32 }
            }
            Shape::Text(position, text) => {
                self.points.push(position.0);
                self.text.push_str(text);
                self.sizes.push(text.len());
                Entry::Text
            }
            Shape::FillArea(rings) => {
                let (points, rings) = self.push_paths(rings);
                Entry::FillArea { points, rings }
            }
            Shape::CellArray(place, cells) => {
                self.points.extend([place.origin.0, place.columns.0, place.rows.0]);
                (0..cells.rows).for_each(|row| self.cells.extend_from_slice(cells.row(row)));
                self.sizes.extend([cells.columns, cells.rows]);
                Entry::CellArray
            }
            Shape::Generalized(Curve::Ellipse(e), role) => {
                self.points.extend([e.centre.0, e.a.0, e.b.0, DVec2::new(e.start, e.sweep)]);
                Entry::Ellipse(e.closure, role)
            }
            Shape::Generalized(Curve::Bezier(points), role) => {
                self.points.extend_from_slice(points);
                Entry::Bezier(points.len() as u32, role)
            }
        };
        self.entries.push(entry);
        self.count += 1;
    }
}

impl<'a> IntoIterator for &'a Recording {
    type Item = Item<'a>;
    type IntoIter = Items<'a>;

    fn into_iter(self) -> Items<'a> {
        self.iter()
    }
}

/// The primitives of a [`Recording`] in the order of drawing.
#[derive(Clone, Debug)]
pub struct Items<'a> {
    entries: std::slice::Iter<'a, Entry>,
    points: &'a [DVec2],
    ends: &'a [u32],
    text: &'a str,
    cells: &'a [i32],
    sizes: &'a [usize],
    looks: &'a [Look],
    clips: &'a [Rect<Ndc>],
    look: Option<&'a Look>,
    clip: Rect<Ndc>,
    pick: i32,
    left: usize,
}

/// Takes the first `count` elements off a list, or as many as there are.
#[inline]
fn take<'a, T>(list: &mut &'a [T], count: usize) -> &'a [T] {
    let (first, rest) = list.split_at(count.min(list.len()));
    *list = rest;
    first
}

impl<'a> Items<'a> {
    fn paths(&mut self, points: u32, paths: u32) -> Paths<'a, Ndc> {
        Paths::new(take(&mut self.points, points as usize), take(&mut self.ends, paths as usize))
    }

    /// The shape of an entry that is a primitive.
    fn shape(&mut self, entry: Entry) -> Option<Shape<'a>> {
        let ndc = Point::<Ndc>::from_vec;
        let vector = Vector::<Ndc>::from_vec;
        Some(match entry {
            Entry::Polyline { points, paths } => Shape::Polyline(self.paths(points, paths)),
            Entry::Polymarker { points } => Shape::Polymarker(take(&mut self.points, points as usize)),
            Entry::Text => {
                let &[position] = take(&mut self.points, 1) else { return None };
                let &[length] = take(&mut self.sizes, 1) else { return None };
                let (text, rest) = self.text.split_at_checked(length)?;
                self.text = rest;
                Shape::Text(ndc(position), text)
            }
            Entry::FillArea { points, rings } => Shape::FillArea(self.paths(points, rings)),
            Entry::CellArray => {
                let &[origin, along, up] = take(&mut self.points, 3) else { return None };
                let &[columns, rows] = take(&mut self.sizes, 2) else { return None };
                let place = Parallelogram { origin: ndc(origin), columns: vector(along), rows: vector(up) };
                let cells = take(&mut self.cells, columns * rows);
                Shape::CellArray(place, Cells::new(cells, columns, rows, columns)?)
            }
            Entry::Ellipse(closure, role) => {
                let &[centre, a, b, range] = take(&mut self.points, 4) else { return None };
                let (centre, a, b) = (ndc(centre), vector(a), vector(b));
                let ellipse = Ellipse { centre, a, b, start: range.x, sweep: range.y, closure };
                Shape::Generalized(Curve::Ellipse(ellipse), role)
            }
            Entry::Bezier(points, role) => {
                Shape::Generalized(Curve::Bezier(take(&mut self.points, points as usize)), role)
            }
            Entry::Look(_) | Entry::Clip | Entry::Pick(_) => return None,
        })
    }
}

impl<'a> Iterator for Items<'a> {
    type Item = Item<'a>;

    fn next(&mut self) -> Option<Item<'a>> {
        loop {
            match *self.entries.next()? {
                Entry::Look(at) => self.look = self.looks.get(at as usize),
                Entry::Clip => self.clip = *take(&mut self.clips, 1).first()?,
                Entry::Pick(pick) => self.pick = pick,
                entry => {
                    let shape = self.shape(entry)?;
                    self.left -= 1;
                    return Some(Item { shape, look: self.look?, clip: self.clip, pick: self.pick });
                }
            }
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.left, Some(self.left))
    }
}

impl ExactSizeIterator for Items<'_> {}

#[cfg(test)]
mod tests {
    use super::*;
    use gks_geometry::PathBuf;
    use glam::dvec2;

    const CLIP: Rect<Ndc> = Rect::UNIT;

    fn paths(ends: &[usize]) -> PathBuf<Ndc> {
        let mut paths = PathBuf::new();
        for (i, &length) in ends.iter().enumerate() {
            paths.add((0..length).map(|j| dvec2(i as f64 * 0.1, j as f64 * 0.01)));
        }
        paths
    }

    /// Items of every kind, handed to `then`.
    fn every_kind(then: &mut dyn FnMut(&[Item<'_>])) {
        let (lines, rings) = (paths(&[2, 3]), paths(&[3, 5]));
        let chain = [dvec2(0.0, 0.0), dvec2(0.1, 0.0), dvec2(0.2, 0.1), dvec2(0.3, 0.3)];
        let place = Parallelogram {
            origin: Point::new(0.1, 0.2),
            columns: Vector::new(0.5, 0.1),
            rows: Vector::new(0.0, 0.4),
        };
        let indices: Vec<i32> = (0..20).collect();
        let cells = Cells::new(&indices[1..], 3, 4, 5).unwrap();
        let ellipse = Ellipse {
            centre: Point::new(0.5, 0.5),
            a: Vector::new(0.2, 0.0),
            b: Vector::new(0.1, 0.1),
            start: 0.5,
            sweep: -2.0,
            closure: Closure::Pie,
        };
        let plain = Look::default();
        let mut other = Look::default();
        other.line.width = 3.0;
        let half = Rect::new(0.0, 0.5, 0.0, 1.0);
        let item = |shape, look, clip, pick| Item { shape, look, clip, pick };
        then(&[
            item(Shape::Polyline(lines.as_paths()), &plain, CLIP, 0),
            item(Shape::Polymarker(&chain), &plain, CLIP, 7),
            item(Shape::Text(Point::new(0.3, 0.4), "Grüße"), &other, CLIP, 7),
            item(Shape::Text(Point::new(0.3, 0.5), ""), &other, half, 7),
            item(Shape::FillArea(rings.as_paths()), &plain, half, 0),
            item(Shape::CellArray(place, cells), &plain, half, 0),
            item(Shape::Generalized(Curve::Ellipse(ellipse), Role::Area), &plain, CLIP, -1),
            item(Shape::Generalized(Curve::Bezier(&chain), Role::Line), &other, CLIP, -1),
        ]);
    }

    /// What an item is, without its borrowed places: cells row by row.
    fn told(item: &Item<'_>) -> String {
        let shape = match item.shape {
            Shape::CellArray(place, cells) => {
                let rows: Vec<&[i32]> = (0..cells.rows).map(|row| cells.row(row)).collect();
                format!("{place:?} {rows:?}")
            }
            shape => format!("{shape:?}"),
        };
        format!("{shape} {:?} {:?} {}", item.look, item.clip, item.pick)
    }

    #[test]
    fn items_come_back_as_they_were() {
        every_kind(&mut |items| {
            let mut recording = Recording::new();
            items.iter().for_each(|item| recording.push(item));
            assert_eq!(recording.len(), items.len());
            assert_eq!(recording.iter().len(), items.len());
            let back: Vec<String> = recording.iter().map(|item| told(&item)).collect();
            assert_eq!(back, items.iter().map(told).collect::<Vec<_>>());
            recording.shrink();
            assert_eq!(recording.iter().count(), items.len());
        });
    }

    #[test]
    fn looks_that_alternate_are_kept_once() {
        every_kind(&mut |items| {
            let mut recording = Recording::new();
            (0..100).for_each(|_| items.iter().for_each(|item| recording.push(item)));
            assert_eq!(recording.looks.len(), 2);
            assert_eq!(recording.len(), 100 * items.len());
        });
    }

    #[test]
    fn a_map_moves_points_turns_vectors_and_keeps_the_rest() {
        // A quarter turn to the left and a shift.
        let map = Map::from_rows([[0.0, -1.0, 1.0], [1.0, 0.0, 0.5]]);
        every_kind(&mut |items| {
            let mut recording = Recording::new();
            items.iter().for_each(|item| recording.push(item));
            let clip = Rect::new(0.2, 0.3, 0.2, 0.3);
            let mapped = recording.mapped(&map, clip, None);
            let back: Vec<Item<'_>> = mapped.iter().collect();
            assert!(back.iter().all(|item| item.clip == clip));
            let picks = |items: &[Item<'_>]| items.iter().map(|item| item.pick).collect::<Vec<_>>();
            assert_eq!(picks(&back), picks(items));
            let Shape::Polyline(lines) = back[0].shape else { panic!("{:?}", back[0]) };
            assert_eq!((lines.points[1], lines.ends), (dvec2(0.99, 0.5), &[2, 5][..]));
            let Shape::CellArray(place, _) = back[5].shape else { panic!("{:?}", back[5]) };
            assert_eq!(place.origin, Point::new(0.8, 0.6));
            assert_eq!((place.columns, place.rows), (Vector::new(-0.1, 0.5), Vector::new(-0.4, 0.0)));
            let Shape::Generalized(Curve::Ellipse(e), _) = back[6].shape else { panic!("{:?}", back[6]) };
            assert_eq!((e.centre, e.b), (Point::new(0.5, 1.0), Vector::new(-0.1, 0.1)));
            assert_eq!((e.start, e.sweep, e.closure), (0.5, -2.0, Closure::Pie));
            let look = back[2].look;
            assert_eq!(look.text_geometry.height, Vector::new(-0.01, 0.0));
            assert_eq!(look.pattern.reference, Point::new(1.0, 0.5));
            assert_eq!(look.pattern.width, Vector::new(0.0, 1.0));
            assert_eq!(look.line.width, 3.0);
        });
    }

    /// The sizes that the documentation of this module states.
    #[test]
    fn a_hundred_thousand_primitives_take_the_memory_that_is_stated() {
        assert_eq!(size_of::<Entry>(), 12);
        let (line, look) = (paths(&[2]), Look::default());
        let item = Item { shape: Shape::Polyline(line.as_paths()), look: &look, clip: CLIP, pick: 1 };
        let mut recording = Recording::new();
        (0..100_000).for_each(|_| recording.push(&item));
        let once = size_of::<Look>() + size_of::<Rect<Ndc>>() + 3 * 12;
        assert_eq!(recording.bytes(), 100_000 * (12 + 2 * 16 + 4) + once);
        recording.shrink();
        assert!(recording.points.capacity() < 210_000);
        let text = Item { shape: Shape::Text(Point::new(0.0, 0.0), "ab"), ..item };
        let mut recording = Recording::new();
        (0..1000).for_each(|_| recording.push(&text));
        assert_eq!(recording.bytes(), 1000 * (12 + 16 + 8 + 2) + once);
    }
}
