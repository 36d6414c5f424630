//! What a screen shows: the picture with the echoes over it, and what changed since it was shown last.

/// A part of a picture in pixels; columns from the left, rows from the top.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Area {
    /// The first column.
    pub x: u32,
    /// The first row.
    pub y: u32,
    /// The number of columns.
    pub width: u32,
    /// The number of rows.
    pub height: u32,
}

/// An opaque picture: red, green, blue and 255 for each pixel, row by row from the top.
pub struct Frame {
    width: u32,
    height: u32,
    pixels: Vec<u8>,
    /// The picture that is composed next.
    next: Vec<u8>,
    /// Whether nothing has been shown yet.
    new: bool,
}

impl Frame {
    /// A frame for a picture of `width` x `height` pixels.
    pub fn new(width: u32, height: u32) -> Frame {
        let bytes = width as usize * height as usize * 4;
        Frame { width, height, pixels: vec![255; bytes], next: vec![255; bytes], new: true }
    }

    /// Number of columns and rows.
    pub fn size(&self) -> (u32, u32) {
        (self.width, self.height)
    }

    /// Forgets what has been shown, so that the next picture is all new.
    pub fn forget(&mut self) {
        self.new = true;
    }

    /// All pixels.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// The pixels of an area, row by row.
    pub fn rows(&self, area: Area) -> impl Iterator<Item = &[u8]> {
        let width = self.width as usize * 4;
        let (from, to) = (area.x as usize * 4, (area.x + area.width) as usize * 4);
        let rows = area.y as usize..(area.y + area.height) as usize;
        rows.map(move |row| &self.pixels[row * width..][from..to])
    }

    /// The whole picture.
    pub fn whole(&self) -> Area {
        Area { x: 0, y: 0, width: self.width, height: self.height }
    }

    /// Puts `overlay` over `picture`, both premultiplied by opacity, and both over white. The answer is what
    /// changed, if anything did.
    pub fn compose(&mut self, picture: &[u8], overlay: Option<&[u8]>) -> Option<Area> {
        let bytes = self.next.len();
        if picture.len() != bytes || overlay.is_some_and(|overlay| overlay.len() != bytes) {
            return None;
        }
        self.next.copy_from_slice(picture);
        for pixel in self.next.chunks_exact_mut(4).filter(|pixel| pixel[3] != 255) {
            let rest = 255 - pixel[3];
            pixel.iter_mut().for_each(|channel| *channel = channel.saturating_add(rest));
        }
        if let Some(overlay) = overlay {
            for (below, above) in self.next.chunks_exact_mut(4).zip(overlay.chunks_exact(4)) {
                if above[3] != 0 {
                    let rest = u32::from(255 - above[3]);
                    for (below, &above) in below.iter_mut().zip(above) {
                        *below = above.saturating_add(((u32::from(*below) * rest + 127) / 255) as u8);
                    }
                }
            }
        }
        let changed = if std::mem::take(&mut self.new) { Some(self.whole()) } else { self.difference() };
        if changed.is_some() {
            std::mem::swap(&mut self.pixels, &mut self.next);
        }
        changed
    }

    /// The smallest area outside of which both pictures are the same.
    fn difference(&self) -> Option<Area> {
        let width = self.width as usize * 4;
        let rows = || self.pixels.chunks_exact(width).zip(self.next.chunks_exact(width));
        let top = rows().position(|(old, new)| old != new)?;
        let bottom = rows().rposition(|(old, new)| old != new)?;
        let (mut left, mut right) = (self.width as usize, 0);
        for (old, new) in rows().skip(top).take(bottom - top + 1) {
            let mut pixels = old.chunks_exact(4).zip(new.chunks_exact(4));
            if let Some(first) = pixels.position(|(old, new)| old != new) {
                left = left.min(first);
                let mut pixels = old.chunks_exact(4).zip(new.chunks_exact(4));
                right = right.max(pixels.rposition(|(old, new)| old != new).unwrap_or(first));
            }
        }
        let (width, height) = ((right - left + 1) as u32, (bottom - top + 1) as u32);
        Some(Area { x: left as u32, y: top as u32, width, height })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_picture_is_all_new_and_the_same_again_is_not() {
        let mut frame = Frame::new(3, 2);
        let white = vec![255; 24];
        assert_eq!(frame.compose(&white, None), Some(frame.whole()));
        assert_eq!(frame.compose(&white, None), None);
        assert_eq!(frame.compose(&white[4..], None), None, "not a picture of this size");
    }

    #[test]
    fn the_area_that_changed_is_as_small_as_can_be() {
        let mut frame = Frame::new(10, 8);
        let mut picture = vec![255; 320];
        frame.compose(&picture, None);
        for (column, row) in [(4, 2), (7, 5)] {
            picture[(row * 10 + column) * 4] = 0;
        }
        let area = Area { x: 4, y: 2, width: 4, height: 4 };
        assert_eq!(frame.compose(&picture, None), Some(area));
        let rows: Vec<&[u8]> = frame.rows(area).collect();
        assert_eq!((rows.len(), rows[0][0], rows[3][12], rows[1][0]), (4, 0, 0, 255));
    }

    #[test]
    fn an_overlay_covers_and_goes_without_a_trace() {
        let mut frame = Frame::new(2, 1);
        let picture = [200, 100, 0, 255, 0, 0, 0, 0];
        frame.compose(&picture, None);
        assert_eq!(frame.pixels(), [200, 100, 0, 255, 255, 255, 255, 255], "nothing is white");
        let half = [0, 0, 128, 128, 0, 0, 0, 0];
        assert_eq!(frame.compose(&picture, Some(&half)), Some(Area { x: 0, y: 0, width: 1, height: 1 }));
        assert_eq!(frame.pixels(), [100, 50, 128, 255, 255, 255, 255, 255]);
        frame.compose(&picture, None);
        assert_eq!(frame.pixels(), [200, 100, 0, 255, 255, 255, 255, 255]);
    }
}
