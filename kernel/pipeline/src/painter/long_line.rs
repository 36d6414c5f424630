//! Long lines, whose points are not held but for those that a clipping rectangle leaves.

use super::{Canvas, Painter, Visibility, must, visibility};
use crate::device::{DeviceError, Drawn, Form, Pen};
use crate::look::Look;
use crate::lower::dashed::{dashes, is_solid};
use gks_algorithms as algorithms;
use gks_geometry::{Du, LongLine, Ndc, Paths, Rect};

impl Painter {
    /// Offers a long line as such, or not at all; a polyline is the same line.
    pub(crate) fn long_line(
        &mut self,
        line: &LongLine<'_, Ndc>,
        look: &Look,
        clip: &Rect<Ndc>,
        canvas: &mut Canvas<'_>,
    ) -> Result<Drawn, DeviceError> {
        let Some(clip) = clip.intersection(&canvas.window) else { return Ok(Drawn::Yes) };
        let clip = canvas.clip_map.rect(&clip);
        let line = line.mapped(&canvas.map);
        let Some(bounds) = line.bounds() else { return Ok(Drawn::Yes) };
        let crossing = match visibility(&bounds, &clip) {
            Visibility::Hidden => return Ok(Drawn::Yes),
            Visibility::Whole => None,
            Visibility::Crossing => Some(clip),
        };
        self.with_pen(look, canvas, |painter, pen, canvas| {
            let drawn = canvas.offer(Form::LongLine(line, *pen), crossing)?;
            let pens = canvas.surface.pen.is_some();
            match crossing {
                _ if drawn == Drawn::Yes || pens => Ok(drawn),
                _ if !pen.dash.is_empty() => painter.dashed_long_line(&line, pen, &clip, canvas),
                Some(clip) => painter.clipped_long_line(&line, pen, &clip, canvas),
                None => Ok(Drawn::No),
            }
        })
    }

    /// Draws of a dashed long line what is inside of `clip`, the dashes of which alone are held.
    fn dashed_long_line(
        &mut self,
        line: &LongLine<'_, Du>,
        pen: &Pen<'_>,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<Drawn, DeviceError> {
        let around = clip.grown(pen.width);
        let solid = Pen { dash: &[], ..*pen };
        if is_solid(line, pen.dash, &around) {
            return self.clipped_long_line(line, &solid, clip, canvas);
        }
        let (mut some, mut pieces) = (std::mem::take(&mut self.lowered), std::mem::take(&mut self.pieces));
        pieces.clear();
        dashes(line, pen.dash, &around, &mut some, |dashes| pieces.add_all(dashes));
        let done = self.lines(pieces.as_paths(), &solid, clip, canvas);
        (self.lowered, self.pieces) = (some, pieces);
        done.map(|()| Drawn::Yes)
    }

    /// Draws of a long line what is inside of `clip`, which alone is held.
    fn clipped_long_line(
        &mut self,
        line: &LongLine<'_, Du>,
        pen: &Pen<'_>,
        clip: &Rect<Du>,
        canvas: &mut Canvas<'_>,
    ) -> Result<Drawn, DeviceError> {
        let mut clipped = std::mem::take(&mut self.clipped);
        let mut held = std::mem::take(&mut self.pieces);
        let path = &mut held.points;
        let mut last = None;
        clipped.clear();
        line.pieces_near(clip, |piece| {
            // A piece goes on where the one before it ended.
            path.clear();
            path.extend(last.filter(|_| !piece.starts));
            path.extend_from_slice(piece.points);
            last = piece.points.last().copied();
            let bounds = Paths::<Du>::new(path, &[]).bounds();
            if bounds.is_none_or(|bounds| !bounds.meets(clip)) {
                return Ok::<_, DeviceError>(());
            }
            let (points, ends) = (&mut clipped.points, &mut clipped.ends);
            let (before, count) = (points.len(), ends.len());
            let goes_on = !piece.starts && points.last() == path.first();
            algorithms::clip::polyline((clip.min.0, clip.max.0), path, points, ends);
            if goes_on && ends.len() > count && points.get(before) == points.get(before.wrapping_sub(1)) {
                points.remove(before);
                ends.remove(count - 1);
                ends[count - 1..].iter_mut().for_each(|end| *end -= 1);
            }
            Ok(())
        })?;
        let done = match clipped.ends.is_empty() {
            true => Ok(()),
            false => must(canvas.offer(Form::Lines(clipped.as_paths(), *pen), None)),
        };
        (self.clipped, self.pieces) = (clipped, held);
        done.map(|()| Drawn::Yes)
    }
}
