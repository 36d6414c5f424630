//! Where on paper programs of NCAR Graphics want their pictures.
//!
//! NCAR's drivers for PostScript and PDF put the unit square of NDC on letter paper, in the middle unless the program
//! says where. Here pictures are as large as the paper that the user chooses; a program that says where gets what it says.

use gks::Gks;
use gks_workstations::environment::Environment;

/// The length of a point, 1/72 inch, in metres.
const POINT: f64 = 0.0254 / 72.0;

/// Width and height of letter paper in points.
const LETTER: [f64; 2] = [612.0, 792.0];

/// What a program has said about the paper of the workstations that it opens next, in points.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Paper {
    /// The lower left and the upper right corner of the unit square: x, y, x, y on the upright paper, also where the picture
    /// lies on its side.
    pub(crate) square: Option<[f64; 4]>,
    /// Width and height, upright.
    pub(crate) size: [Option<f64>; 2],
}

/// Whether a workstation type of NCAR Graphics draws on paper.
fn draws_on_paper(kind: i32) -> bool {
    matches!(kind, 11 | 12 | 20..=31 | 40 | 42 | 45)
}

/// Whether a workstation type on paper has the upper edge of its picture at the right edge of the upright paper.
fn is_landscape(kind: i32) -> bool {
    matches!(kind, 12 | 26..=31)
}

impl Paper {
    /// What the program has said if it holds for a workstation type; what the user has chosen goes first.
    pub(crate) fn of(self, kind: i32, environment: &Environment) -> Option<Paper> {
        let options = environment.options.as_deref().unwrap_or_default();
        let is_chosen = environment.wstype.is_some()
            || options.split(['&', ',']).any(|option| option.trim().starts_with("size="));
        Some(self).filter(|paper| *paper != Paper::default() && draws_on_paper(kind) && !is_chosen)
    }

    /// Width and height of the upright paper.
    fn sides(self) -> [f64; 2] {
        [0, 1].map(|i| self.size[i].unwrap_or(LETTER[i]))
    }

    /// The connection for a file, which chooses the paper.
    pub(crate) fn connection(self, name: &str) -> String {
        let [width, height] = self.sides();
        let separator = if name.contains('?') { '&' } else { '?' };
        format!("{name}{separator}size={width}x{height}")
    }

    /// Puts the unit square of a workstation that has been opened where the program wants it, which may be partly beside the
    /// paper. It stays a square: it is as large as fits into the lower left corner of the place.
    pub(crate) fn place(self, gks: &mut Gks, workstation: i32, kind: i32) -> gks::Result<()> {
        let Some(mut square) = self.square else { return Ok(()) };
        if is_landscape(kind) {
            let ([x0, y0, x1, y1], [_, height]) = (square, self.sides());
            square = [height - y1, x0, height - y0, x1];
        }
        let [left, bottom, right, top] = square;
        let side = (right - left).min(top - bottom);
        let [_, width, _, height] =
            gks.inquire_workstation_transformation(workstation)?.requested.viewport.limits();
        let edge = |at: f64, most: f64| (at * POINT).clamp(0.0, most);
        let (x, y) = (
            [left, left + side].map(|at| edge(at, width)),
            [bottom, bottom + side].map(|at| edge(at, height)),
        );
        if side <= 0.0 || x[0] >= x[1] || y[0] >= y[1] {
            return Ok(());
        }
        let part = |at: f64, from: f64| ((at / POINT - from) / side).clamp(0.0, 1.0);
        let (u, v) = (x.map(|at| part(at, left)), y.map(|at| part(at, bottom)));
        gks.set_workstation_window(workstation, (u[0], u[1], v[0], v[1]))?;
        gks.set_workstation_viewport(workstation, (x[0], x[1], y[0], y[1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn paper(square: Option<[f64; 4]>, width: Option<f64>) -> Paper {
        Paper { square, size: [width, None] }
    }

    #[test]
    fn only_what_a_program_says_of_types_on_paper_holds_and_the_user_goes_first() {
        let environment = |name: &str, value: &str| {
            Environment::from_variables(|variable| (variable == name).then(|| value.to_owned()))
        };
        let said = paper(Some([36.0, 126.0, 576.0, 666.0]), None);
        let none = environment("", "");
        assert_eq!([11, 26, 42].map(|kind| said.of(kind, &none)), [Some(said); 3]);
        assert_eq!([1, 3, 8, 41, 47].map(|kind| said.of(kind, &none)), [None; 5]);
        assert_eq!(Paper::default().of(20, &none), None);
        assert_eq!(said.of(20, &environment("GKS_WSTYPE", "pdf")), None);
        assert_eq!(said.of(20, &environment("GKS_OPTIONS", "size=800x800")), None);
        assert_eq!(said.of(20, &environment("GKS_OPTIONS", "dpi=300, size=800x800")), None);
        assert_eq!(said.of(20, &environment("GKS_OPTIONS", "script=size")), Some(said));
        assert_eq!(said.connection("a.ps"), "a.ps?size=612x792");
        assert_eq!(paper(None, Some(300.0)).connection("a.pdf?dpi=1"), "a.pdf?dpi=1&size=300x792");
    }

    #[test]
    fn the_square_is_where_the_program_wants_it_and_cut_by_the_edge_of_the_paper() {
        let placed = |square, kind| {
            let drivers = gks_workstations::catalogue::Drivers::new(Environment::default());
            let mut gks = Gks::new(Box::new(drivers));
            gks.open_gks().unwrap();
            let size = if is_landscape(kind) { "size=792x612" } else { "size=612x792" };
            gks.open_workstation(1, &format!("/dev/null?{size}"), 200).unwrap();
            paper(Some(square), None).place(&mut gks, 1, kind).unwrap();
            let placed = gks.inquire_workstation_transformation(1).unwrap().requested;
            let points = placed.viewport.limits().map(|at| (at / POINT).round());
            (placed.window.limits().map(|at| (at * 800.0).round()), points)
        };
        let usual = placed([36.0, 126.0, 576.0, 666.0], 20);
        assert_eq!(usual, ([0.0, 800.0, 0.0, 800.0], [36.0, 576.0, 126.0, 666.0]));
        let wide = [-90.0, -15.0, 710.0, 785.0];
        assert_eq!(placed(wide, 20), ([90.0, 702.0, 15.0, 800.0], [0.0, 612.0, 0.0, 785.0]));
        assert_eq!(placed(wide, 26), ([0.0, 785.0, 90.0, 702.0], [7.0, 792.0, 0.0, 612.0]));
        // No square, and one beside the paper: all of the paper is used, as if nothing had been said.
        let whole = placed([0.0, 0.0, 0.0, 100.0], 20);
        assert_eq!(whole, ([0.0, 800.0, 0.0, 800.0], [0.0, 612.0, 0.0, 792.0]));
        assert_eq!(placed([700.0, 0.0, 900.0, 200.0], 20), whole);
    }
}
