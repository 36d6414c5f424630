//! The kernel as a value.

use crate::store::{Composition, Element, StructureStore};
use crate::traversal::traverse;
use crate::view::ViewRepresentation;
use crate::{Error, Result};
use gks_geometry::{Map3, Mc, Point3};
use gks_pipeline::colour::Colour;
use gks_pipeline::description::{Catalogue, OpenError};
use gks_pipeline::device::DeviceError;
use gks_pipeline::look::InteriorStyle;
use gks_pipeline::record::Record;
use gks_pipeline::tables::Tables;
use gks_pipeline::workstation::Workstation;
use std::collections::BTreeMap;

/// A PHIGS: a structure store and open workstations.
pub struct Phigs {
    catalogue: Box<dyn Catalogue>,
    store: StructureStore,
    workstations: BTreeMap<i32, OpenWorkstation>,
}

struct OpenWorkstation {
    workstation: Workstation,
    views: BTreeMap<u32, ViewRepresentation>,
    /// Posted roots with their priorities.
    posted: Vec<(i32, f64)>,
    /// Whether the display shows the structures as they are.
    correct: bool,
}

impl Phigs {
    /// OPEN PHIGS: a kernel without structures that opens workstations through `catalogue`.
    pub fn open(catalogue: Box<dyn Catalogue>) -> Self {
        Phigs { catalogue, store: StructureStore::default(), workstations: BTreeMap::new() }
    }

    /// OPEN WORKSTATION. Errors: 52 (no such type), 53 (identifier in use), 55 (cannot be opened).
    pub fn open_workstation(&mut self, id: i32, connection: &str, kind: i32) -> Result<()> {
        const F: &str = "OPEN WORKSTATION";
        if self.workstations.contains_key(&id) {
            return Err(Error::new(53, F, format!("workstation {id} is open")));
        }
        let (device, description) = self.catalogue.open(kind, connection).map_err(|e| match e {
            OpenError::NoSuchType(_) => Error::new(52, F, e.to_string()),
            OpenError::Connection(..) | OpenError::CannotOpen(_) => Error::new(55, F, e.to_string()),
        })?;
        let open = OpenWorkstation {
            workstation: Workstation::new(device, description, Tables::predefined()),
            views: BTreeMap::from([(0, ViewRepresentation::default())]),
            posted: Vec::new(),
            correct: true,
        };
        self.workstations.insert(id, open);
        Ok(())
    }

    /// CLOSE WORKSTATION: updates the picture and completes it. Errors: 54 (not open), 304 (writing failed).
    pub fn close_workstation(&mut self, id: i32) -> Result<()> {
        const F: &str = "CLOSE WORKSTATION";
        let updated = self.update_workstation(id);
        let open = self.workstations.remove(&id).ok_or_else(|| not_open(F, id))?;
        let closed = open.workstation.close().map_err(|e| failed(F, &e));
        updated.and(closed)
    }

    /// SET COLOUR REPRESENTATION. Errors: 54 (not open).
    pub fn set_colour_representation(&mut self, id: i32, index: u32, colour: Colour) -> Result<()> {
        const F: &str = "SET COLOUR REPRESENTATION";
        let open = self.workstation(F, id)?;
        open.correct = false;
        open.workstation.represent(&Record::ColourRepresentation(index, colour)).map_err(|e| failed(F, &e))
    }

    /// SET VIEW REPRESENTATION 3. Errors: 54 (not open), 115 (view 0 cannot be changed), 153 (clipping limits).
    pub fn set_view_representation3(
        &mut self,
        id: i32,
        view: u32,
        representation: ViewRepresentation,
    ) -> Result<()> {
        const F: &str = "SET VIEW REPRESENTATION 3";
        let open = self.workstation(F, id)?;
        if view < 1 {
            return Err(Error::new(115, F, format!("view index {view}")));
        }
        let (back, front) = representation.depth;
        if !representation.clip.is_proper() || back.max(front) != front {
            return Err(Error::new(153, F, "view clipping limits"));
        }
        open.views.insert(view, representation);
        open.correct = false;
        Ok(())
    }

    /// OPEN STRUCTURE: elements are added to its end from now on. Error: 6 (a structure is open).
    pub fn open_structure(&mut self, id: i32) -> Result<()> {
        if self.store.is_open() {
            return Err(Error::new(6, "OPEN STRUCTURE", "another structure is open"));
        }
        self.store.open(id);
        Ok(())
    }

    /// CLOSE STRUCTURE. Error: 5 (none is open).
    pub fn close_structure(&mut self) -> Result<()> {
        self.check_open("CLOSE STRUCTURE")?;
        self.store.close();
        Ok(())
    }

    /// POLYLINE 3. Error: 5 (no structure is open).
    pub fn polyline3(&mut self, points: &[Point3<Mc>]) -> Result<()> {
        self.append("POLYLINE 3", Element::Polyline3(points.to_vec()))
    }

    /// FILL AREA 3. Error: 5 (no structure is open).
    pub fn fill_area3(&mut self, points: &[Point3<Mc>]) -> Result<()> {
        self.append("FILL AREA 3", Element::FillArea3(points.to_vec()))
    }

    /// SET POLYLINE COLOUR INDEX. Error: 5 (no structure is open).
    pub fn set_polyline_colour_index(&mut self, index: u32) -> Result<()> {
        self.append("SET POLYLINE COLOUR INDEX", Element::PolylineColour(index))
    }

    /// SET LINEWIDTH SCALE FACTOR. Error: 5 (no structure is open).
    pub fn set_linewidth_scale_factor(&mut self, factor: f64) -> Result<()> {
        self.append("SET LINEWIDTH SCALE FACTOR", Element::Linewidth(factor))
    }

    /// SET INTERIOR STYLE. Error: 5 (no structure is open).
    pub fn set_interior_style(&mut self, style: InteriorStyle) -> Result<()> {
        self.append("SET INTERIOR STYLE", Element::InteriorStyle(style))
    }

    /// SET INTERIOR COLOUR INDEX. Error: 5 (no structure is open).
    pub fn set_interior_colour_index(&mut self, index: u32) -> Result<()> {
        self.append("SET INTERIOR COLOUR INDEX", Element::InteriorColour(index))
    }

    /// SET VIEW INDEX. Error: 5 (no structure is open).
    pub fn set_view_index(&mut self, view: u32) -> Result<()> {
        self.append("SET VIEW INDEX", Element::ViewIndex(view))
    }

    /// SET LOCAL TRANSFORMATION 3. Error: 5 (no structure is open).
    pub fn set_local_transformation3(&mut self, map: Map3<Mc, Mc>, composition: Composition) -> Result<()> {
        self.append("SET LOCAL TRANSFORMATION 3", Element::LocalTransformation3(map, composition))
    }

    /// EXECUTE STRUCTURE: the elements of another structure as if they stood here.
    ///
    /// Errors: 5 (no structure is open), 201 (the structure would execute itself).
    pub fn execute_structure(&mut self, id: i32) -> Result<()> {
        const F: &str = "EXECUTE STRUCTURE";
        if self.store.open_structure().is_some_and(|open| self.store.reaches(id, open)) {
            return Err(Error::new(201, F, format!("structure {id} executes the open structure")));
        }
        self.append(F, Element::ExecuteStructure(id))
    }

    /// POST STRUCTURE: shows a structure network on a workstation; the higher priority is drawn last.
    ///
    /// Errors: 54 (not open), 208 (priority outside of 0 to 1).
    pub fn post_structure(&mut self, id: i32, structure: i32, priority: f64) -> Result<()> {
        const F: &str = "POST STRUCTURE";
        if !(0.0..=1.0).contains(&priority) {
            return Err(Error::new(208, F, format!("priority {priority}")));
        }
        let open = self.workstation(F, id)?;
        open.posted.retain(|(posted, _)| *posted != structure);
        open.posted.push((structure, priority));
        open.posted.sort_by(|a, b| a.1.total_cmp(&b.1));
        open.correct = false;
        self.store.create(structure);
        Ok(())
    }

    /// UPDATE WORKSTATION: draws the posted structures anew if the display does not show them as they are.
    ///
    /// Errors: 54 (not open), 304 (writing failed).
    pub fn update_workstation(&mut self, id: i32) -> Result<()> {
        const F: &str = "UPDATE WORKSTATION";
        let Phigs { store, workstations, .. } = self;
        let open = workstations.get_mut(&id).ok_or_else(|| not_open(F, id))?;
        if open.correct {
            return Ok(());
        }
        open.workstation.clear(false).map_err(|e| failed(F, &e))?;
        for &(root, _) in &open.posted {
            traverse(store, root, &open.views, &mut open.workstation).map_err(|e| failed(F, &e))?;
        }
        open.correct = true;
        Ok(())
    }

    fn check_open(&self, function: &'static str) -> Result<()> {
        if self.store.is_open() { Ok(()) } else { Err(Error::new(5, function, "no structure is open")) }
    }

    fn append(&mut self, function: &'static str, element: Element) -> Result<()> {
        self.check_open(function)?;
        self.store.append(element);
        for open in self.workstations.values_mut() {
            open.correct &= open.posted.is_empty();
        }
        Ok(())
    }

    fn workstation(&mut self, function: &'static str, id: i32) -> Result<&mut OpenWorkstation> {
        self.workstations.get_mut(&id).ok_or_else(|| not_open(function, id))
    }
}

fn not_open(function: &'static str, id: i32) -> Error {
    Error::new(54, function, format!("workstation {id} is not open"))
}

fn failed(function: &'static str, error: &DeviceError) -> Error {
    Error::new(304, function, error.to_string())
}
