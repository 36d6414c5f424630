//! The workstation types of this installation, and which of them a workstation becomes.
//!
//! A program asks for a number; the environment ([`Environment`]) has the last word:
//!
//! | number | becomes |
//! |---|---|
//! | 0 | what `GKS_WSTYPE` names, else what the extension of the file name says, else PNG |
//! | a number of the active dialect | what the dialect means by it; metafiles and windows like 0 |
//! | a number of our own | that type |
//!
//! Where a dialect is active or `GKS_WSTYPE_FORCE` is set, `GKS_WSTYPE` replaces every type that draws. It never
//! replaces segment storage, nor can it name it.

use crate::connection::{self, Target};
use crate::dialect::{Dialect, Meaning};
use crate::environment::Environment;
use crate::options::{OptionError, Options, split_connection};
use crate::{drivers, interactive, metafile, sink};
use gks_pipeline::description::{Catalogue, Category, Description, OpenError};
use gks_pipeline::generated::numbers::{WORKSTATION_TYPES, WorkstationType, workstation_type as own};
use gks_pipeline::workstation::Backend;

/// The workstation types of this installation, chosen as the environment says.
#[derive(Debug)]
pub struct Drivers {
    environment: Environment,
    /// The names under which files have been written that the program has not asked for.
    used: Vec<String>,
}

/// What a number becomes.
#[derive(Clone, Debug)]
struct Selection {
    kind: &'static WorkstationType,
    /// The category that the program expects, where the number is one of another implementation.
    category: Option<Category>,
    /// Options that belong to the number.
    preset: &'static str,
    /// Options that belong to the choice of the user.
    options: String,
    /// The file that the user named.
    file: Option<String>,
    /// Whether the type is not the one that the program knows the number for.
    redirected: bool,
    /// Whether nobody has chosen, so that the name of the file may decide.
    open: bool,
    /// Whether it keeps its picture, unless the name of the file says that it is a metafile.
    kept: bool,
}

impl Selection {
    /// The description under the number that the program knows.
    fn describe(&self, number: i32, options: &Options) -> Result<Description, String> {
        let description = drivers::describe(self.kind, options)?;
        let category = match (self.category, description.category) {
            (Some(category), _) => category,
            // A program that leaves the type open draws, whatever becomes of it.
            (None, Category::MetafileOutput) if number == own::DEFAULT => Category::Output,
            (None, category) => category,
        };
        Ok(Description { number, category, ..description })
    }
}

/// What `GKS_WSTYPE` says.
struct Wish<'a> {
    kind: &'static WorkstationType,
    preset: &'static str,
    file: Option<&'a str>,
    options: &'a str,
}

impl Drivers {
    /// The types as an environment chooses them.
    pub fn new(environment: Environment) -> Drivers {
        Drivers { environment, used: Vec::new() }
    }

    /// The types as the environment of this process chooses them.
    pub fn from_process() -> Drivers {
        Drivers::new(Environment::from_process())
    }

    /// The environment that chooses.
    pub fn environment(&self) -> &Environment {
        &self.environment
    }

    /// The number of the type that a text names: a number of our own, a name, or an extension, alone or at
    /// the end of a file name. Options after a `?` do not matter; `default` is PNG.
    pub fn choose(text: &str) -> Option<i32> {
        let (base, _) = split_connection(text);
        by_text(base.trim()).map(|(kind, _)| kind.number)
    }

    fn wish(&self, dialect: Dialect) -> Result<Option<Wish<'_>>, OpenError> {
        let Some(text) = self.environment.wstype.as_deref() else { return Ok(None) };
        let (base, options) = split_connection(text);
        let base = base.trim();
        let wish = |kind, preset, file| Ok(Some(Wish { kind, preset, file, options }));
        let foreign = base.parse().ok().and_then(|number| dialect.find(number));
        let named = dialect.named(base).and_then(by_number).map(|kind| (kind, false));
        match foreign.map(|foreign| foreign.meaning) {
            Some(Meaning::Own(own::WISS, _)) => Err(no_such_name(text)),
            Some(Meaning::Own(number, preset)) => wish(by_number(number).unwrap_or(default()), preset, None),
            Some(Meaning::Chosen | Meaning::Kept) => wish(default(), "", None),
            None => match named.or_else(|| by_text(base)) {
                Some((kind, is_file)) if kind.number != own::WISS => wish(kind, "", is_file.then_some(base)),
                _ => Err(no_such_name(text)),
            },
        }
    }

    fn select(&self, number: i32, dialect: Dialect, wish: Option<Wish<'_>>) -> Option<Selection> {
        let foreign = dialect.find(number);
        let category = foreign.map(|foreign| foreign.category);
        let meaning = match foreign {
            Some(foreign) => foreign.meaning,
            None if number == own::DEFAULT => Meaning::Chosen,
            None if by_number(number).is_some() => Meaning::Own(number, ""),
            // The number of an implementation we know nothing about; the user wants it replaced.
            None if self.environment.force && wish.is_some() => Meaning::Chosen,
            None => return None,
        };
        // What is kept is no business of the user until it is written.
        let wish = wish.filter(|_| meaning != Meaning::Kept);
        let forced = dialect != Dialect::Iso || self.environment.force;
        // Nothing that draws can stand in for what is stored or read.
        let fixed = |number: i32| matches!(number, own::WISS | own::MI);
        let (kind, preset) = match meaning {
            Meaning::Kept => (by_number(own::NULL)?, ""),
            Meaning::Own(number, preset) if !forced || wish.is_none() || fixed(number) => {
                (by_number(number)?, preset)
            }
            _ => wish.as_ref().map_or((default(), ""), |wish| (wish.kind, wish.preset)),
        };
        let chosen = !fixed(kind.number) && (forced || meaning == Meaning::Chosen);
        let wish = wish.filter(|_| chosen);
        Some(Selection {
            kind,
            category,
            preset,
            redirected: wish.is_some() || (meaning == Meaning::Chosen && number != own::DEFAULT),
            open: wish.is_none() && number == own::DEFAULT,
            kept: meaning == Meaning::Kept,
            options: wish.as_ref().map_or(String::new(), |wish| wish.options.to_owned()),
            file: wish.and_then(|wish| wish.file).map(str::to_owned),
        })
    }

    /// What a number and a connection become: the type, the file and the options.
    fn resolve(&self, number: i32, connection: &str) -> Result<(Selection, Target, Options), OpenError> {
        let dialect = self.environment.dialect().map_err(OpenError::CannotOpen)?;
        let wish = self.wish(dialect)?;
        let mut selection = self.select(number, dialect, wish).ok_or(OpenError::NoSuchType(number))?;
        let (name, list) = split_connection(connection);
        if selection.open {
            let named = self.environment.conid.as_deref().map_or(name, |text| split_connection(text).0);
            selection.kind = sink::extension(named).and_then(by_extension).unwrap_or(selection.kind);
        }
        if selection.kept {
            let metafile = self.environment.metafile_of(name).and_then(by_number);
            selection.kind = metafile.unwrap_or(selection.kind);
        }
        let options = self.options(&selection, &[(connection, list)])?;
        let target = self.target(&selection, name);
        Ok((selection, target, options))
    }

    /// The options for a workstation; later lists win. An error names the list that is wrong.
    fn options(&self, selection: &Selection, lists: &[(&str, &str)]) -> Result<Options, OpenError> {
        let limits = drivers::limits(selection.kind);
        let mut options = Options::default();
        let mut set = |origin: &str, list: &str| {
            let refused = |error: OptionError| OpenError::Connection(origin.to_owned(), error.to_string());
            options.set(list, limits).map_err(refused)
        };
        set("", selection.preset)?;
        if let Some(value) = &self.environment.reduce {
            set(&format!("GKS_REDUCE={value}"), &format!("reduce={value}"))?;
        }
        if let Some(list) = &self.environment.options {
            set(&format!("GKS_OPTIONS={list}"), list)?;
        }
        for (origin, list) in lists {
            set(origin, list)?;
        }
        if let Some(text) = self.environment.wstype.as_deref() {
            set(&format!("GKS_WSTYPE={text}"), &selection.options)?;
        }
        if let Some(text) = self.environment.conid.as_deref() {
            set(&format!("GKS_CONID={text}"), split_connection(text).1)?;
        }
        if let Some(script) = self.environment.script.as_ref().filter(|_| options.script.is_none()) {
            options.script = Some(script.clone());
        }
        options.outlines |= selection.kind.number == own::SVG_OUTLINES;
        Ok(options)
    }

    /// Whether the user has named a file.
    fn names_file(&self, selection: &Selection) -> bool {
        self.environment.conid.is_some() || selection.file.is_some()
    }

    /// The file that a workstation writes.
    fn target(&self, selection: &Selection, connection: &str) -> Target {
        let conid = self.environment.conid.as_deref().map(|text| split_connection(text).0);
        let extension = selection.kind.extension;
        match conid.or(selection.file.as_deref()) {
            Some(name) => Target::of_user(name),
            None if selection.redirected => {
                Target::of_redirected(connection, extension, |old| by_extension(old).is_some())
            }
            None => Target::of_program(connection, extension),
        }
    }
}

impl Catalogue for Drivers {
    fn types(&self) -> Vec<i32> {
        let dialect = self.environment.dialect().unwrap_or_default();
        let foreign = dialect.table().iter().flat_map(|foreign| foreign.first..=foreign.last);
        let mut types: Vec<i32> = foreign.chain(WORKSTATION_TYPES.iter().map(|kind| kind.number)).collect();
        types.retain(|&number| self.describe(number).is_some());
        types.sort_unstable();
        types.dedup();
        types
    }

    /// The description of a type. What is wrong in the environment is left to `open`, which can say it.
    fn describe(&self, number: i32) -> Option<Description> {
        let dialect = self.environment.dialect().unwrap_or_default();
        let selection = self.select(number, dialect, self.wish(dialect).ok().flatten())?;
        let options = self.options(&selection, &[]).unwrap_or_default();
        selection.describe(number, &options).ok()
    }

    fn open(&mut self, number: i32, connection: &str) -> Result<(Backend, Description), OpenError> {
        let (selection, target, options) = self.resolve(number, connection)?;
        let refused = |message| OpenError::Connection(connection.to_owned(), message);
        let description = selection.describe(number, &options).map_err(refused)?;
        match selection.kind.number {
            own::WISS => return Ok((Backend::Storage, description)),
            own::MI => {
                let (name, _) = split_connection(connection);
                let source = metafile::open(name, &options).map_err(OpenError::CannotOpen)?;
                return Ok((Backend::Source(source), description));
            }
            _ => {}
        }
        if interactive::is_interactive(selection.kind) {
            let named = self.environment.conid.as_deref().unwrap_or(connection);
            let device = interactive::open(selection.kind, &options, split_connection(named).0.trim());
            let device = device.map_err(OpenError::CannotOpen)?;
            return Ok((Backend::Device(device), description));
        }
        // What is there for its input writes a picture only where somebody has asked for one.
        let unasked =
            target.invented && selection.kind.number == own::SCRIPTED && !self.names_file(&selection);
        if selection.kind.extension.is_empty() || unasked {
            let backend = drivers::open(selection.kind, &options, None).map_err(refused)?;
            return Ok((backend, description));
        }
        let invented = target.invented && (selection.redirected || self.environment.conid.is_some());
        let name = if invented { target.unused(&self.used) } else { target.name };
        let sink = connection::open(&name).map_err(|error| OpenError::CannotOpen(error.to_string()))?;
        let backend = drivers::open(selection.kind, &options, Some(sink)).map_err(refused)?;
        if invented {
            self.used.push(name);
        }
        Ok((backend, description))
    }
}

/// The type that nobody has to choose.
fn default() -> &'static WorkstationType {
    by_number(own::PNG).unwrap_or(&WORKSTATION_TYPES[0])
}

fn by_number(number: i32) -> Option<&'static WorkstationType> {
    WORKSTATION_TYPES.iter().find(|kind| kind.number == number && number != own::DEFAULT)
}

fn by_extension(extension: &str) -> Option<&'static WorkstationType> {
    let is = |name: &str| name.eq_ignore_ascii_case(extension);
    let files = || WORKSTATION_TYPES.iter().filter(|kind| !kind.extension.is_empty());
    files().find(|kind| is(kind.extension)).or_else(|| files().find(|kind| is(kind.name)))
}

/// The type that a text names, and whether the text is the name of a file.
fn by_text(text: &str) -> Option<(&'static WorkstationType, bool)> {
    if let Ok(number) = text.parse() {
        let kind = if number == own::DEFAULT { Some(default()) } else { by_number(number) };
        return kind.map(|kind| (kind, false));
    }
    let named = WORKSTATION_TYPES.iter().find(|kind| kind.name.eq_ignore_ascii_case(text));
    match named {
        Some(kind) if kind.number == own::DEFAULT => Some((default(), false)),
        Some(kind) => Some((kind, false)),
        None => by_extension(text)
            .map(|kind| (kind, false))
            .or_else(|| sink::extension(text).and_then(by_extension).map(|kind| (kind, true))),
    }
}

fn no_such_name(text: &str) -> OpenError {
    let drawing = WORKSTATION_TYPES.iter().filter(|kind| kind.number != own::WISS);
    let names: Vec<&str> = drawing.map(|kind| kind.name).collect();
    let names = names.join(", ");
    OpenError::CannotOpen(format!("GKS_WSTYPE={text}: no such workstation type; the types are {names}"))
}

#[cfg(test)]
mod tests;
