//! Workstations as programs of XGKS open them.
//!
//! A workstation of XGKS is a window, or a metafile whose format the name of its file says: a picture (GIF,
//! PostScript) as well as GKSM and CGM, which are written as the program draws. Pictures are kept and written when the program closes the
//! workstation, clears it, or saves a frame in between, in the format of the file or in the one that the user
//! chose by `GKS_WSTYPE`.

use crate::Instance;
use gks_workstations::catalogue::Drivers;
use std::fs;

/// The type of metafiles that are written in the numbering of XGKS.
const METAFILE_OUTPUT: i32 = 2;

/// A picture that is kept by a workstation.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptPicture {
    /// The name of its file.
    name: String,
    /// Width and height in pixels, where the program has asked for any.
    size: Option<(u32, u32)>,
    /// How many pages have been written.
    pages: u32,
}

impl KeptPicture {
    /// A picture for the file of a name; one whose extension says no format is PNG, and says so.
    fn new(name: &str) -> Self {
        let file = name.rsplit('/').next().unwrap_or(name);
        let has_format = file.contains('.') && Drivers::choose(name).is_some();
        let as_it_is = is_unnamed(file) || has_format;
        let name = if as_it_is { name.to_owned() } else { format!("{name}.png") };
        KeptPicture { name, size: None, pages: 0 }
    }

    /// Whether the file is to be written at all: one without a name but for the extension only takes frames.
    fn is_named(&self) -> bool {
        let file = self.name.rsplit('/').next().unwrap_or(&self.name);
        !is_unnamed(file)
    }

    /// The connection for a file: its name, with the size as an option.
    fn connection(&self, name: &str) -> String {
        match self.size {
            Some((width, height)) if !name.contains('?') => format!("{name}?size={width}x{height}"),
            _ => name.to_owned(),
        }
    }

    /// The name of the file of the page that comes next: `.2`, `.3` before the extension after the first.
    fn page(&self) -> String {
        match (self.pages, self.name.rsplit_once('.')) {
            (0, _) => self.name.clone(),
            (n, Some((stem, extension))) if !extension.contains('/') => {
                format!("{stem}.{}.{extension}", n + 1)
            }
            (n, _) => format!("{}.{}", self.name, n + 1),
        }
    }
}

impl Instance {
    /// OPEN WORKSTATION, of a type of XGKS.
    ///
    /// Errors: those of [`gks::Gks::open_workstation`].
    pub(crate) fn open_xgks_workstation(&mut self, id: i32, connection: &str, kind: i32) -> gks::Result<()> {
        self.gks.open_workstation(id, connection, kind)?;
        if kind == METAFILE_OUTPUT && self.environment.metafile_of(connection).is_none() {
            // Fortran programs open the file first; nothing shall be left of it if it is not written.
            if fs::metadata(connection).is_ok_and(|file| file.is_file() && file.len() == 0) {
                let _ = fs::remove_file(connection);
            }
            self.gks.keep_picture(id)?;
            self.pictures.insert(id, KeptPicture::new(connection));
        }
        Ok(())
    }

    /// CLOSE WORKSTATION, with what the dialect does about it.
    ///
    /// Errors: those of [`gks::Gks::close_workstation`].
    pub fn close_workstation(&mut self, id: i32) -> gks::Result<()> {
        let written = match self.gks.inquire_workstation_state(id) {
            Ok(active) if !active => self.write_page(id),
            _ => Ok(()),
        };
        self.gks.close_workstation(id)?;
        self.pictures.remove(&id);
        written
    }

    /// CLEAR WORKSTATION, with what the dialect does about it.
    ///
    /// Errors: those of [`gks::Gks::clear_workstation`].
    pub fn clear_workstation(&mut self, id: i32, always: bool) -> gks::Result<()> {
        let written = self.write_page(id);
        self.gks.clear_workstation(id, always)?;
        written
    }

    /// Writes the picture of a workstation that keeps one and is not empty.
    fn write_page(&mut self, id: i32) -> gks::Result<()> {
        let Some(picture) = self.pictures.get_mut(&id).filter(|picture| picture.is_named()) else {
            return Ok(());
        };
        if self.gks.inquire_workstation_deferral_and_update_states(id).is_ok_and(|states| states.empty) {
            return Ok(());
        }
        let connection = picture.connection(&picture.page());
        picture.pages += 1;
        self.gks.copy_picture(id, &connection, 0)
    }

    /// Writes all pictures that are kept, before everything is closed in an emergency.
    pub fn write_pictures(&mut self) {
        let ids: Vec<i32> = self.pictures.keys().copied().collect();
        for id in ids {
            // There is nobody left to hear of failures.
            let _ = self.write_page(id);
        }
        self.pictures.clear();
    }

    /// Saves the picture of a workstation as it is now in a file. Whether the workstation keeps one; the error
    /// is that of writing it.
    ///
    /// Without a background the places where nothing is drawn stay transparent.
    pub fn save_frame(&mut self, id: i32, name: &str, background: bool) -> gks::Result<bool> {
        let Some(picture) = self.pictures.get(&id) else { return Ok(false) };
        let mut connection = picture.connection(name);
        if !background {
            connection.push(if connection.contains('?') { '&' } else { '?' });
            connection.push_str("background=none");
        }
        self.gks.copy_picture(id, &connection, 0)?;
        Ok(true)
    }

    /// Sets the size in pixels that the picture of a workstation is written with.
    pub fn resize_picture(&mut self, id: i32, width: u32, height: u32) {
        if let Some(picture) = self.pictures.get_mut(&id) {
            picture.size = (width > 0 && height > 0).then_some((width, height));
        }
    }

    /// Whether a workstation keeps a picture.
    pub fn keeps_picture(&self, id: i32) -> bool {
        self.pictures.contains_key(&id)
    }
}

/// Whether a file has no name, or none but an extension.
fn is_unnamed(file: &str) -> bool {
    file.is_empty() || file.strip_prefix('.').is_some_and(|rest| !rest.contains('.'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_an_extension_is_none() {
        let is_named = |name| KeptPicture::new(name).is_named();
        assert!(is_named("a.gif") && is_named("a") && is_named("/x.y/a.ps"));
        assert_eq!(KeptPicture::new("/x.y/plot").name, "/x.y/plot.png");
        assert!(!is_named("") && !is_named(".gif") && !is_named("/home/me/.gif"));
    }

    #[test]
    fn pages_and_sizes_are_in_the_connection() {
        let mut picture = KeptPicture::new("d.x/plot.gif");
        assert_eq!(picture.connection(&picture.page()), "d.x/plot.gif");
        picture.pages = 1;
        picture.size = Some((768, 662));
        assert_eq!(picture.connection(&picture.page()), "d.x/plot.2.gif?size=768x662");
        assert_eq!(picture.connection("a.png?dpi=72"), "a.png?dpi=72");
        "d.x/plot".clone_into(&mut picture.name);
        assert_eq!(picture.page(), "d.x/plot.2");
    }
}
