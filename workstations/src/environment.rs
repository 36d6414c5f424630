//! What the environment of a process says about workstations.

use crate::dialect::Dialect;
use crate::options::split_connection;

/// The environment of a process as far as it concerns workstations, as it was written: it is read and
/// checked when a workstation is opened.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Environment {
    /// `GKS_WSTYPE`: the workstation type that type 0 means: a number, a name, or the name of a file whose
    /// extension decides and to which the picture is written. Options may follow a `?`.
    pub wstype: Option<String>,
    /// `GKS_WSTYPE_FORCE`: whether `wstype` also replaces the types that a program names itself.
    pub force: bool,
    /// `GKS_CONID`: the connection that replaces those of the program.
    pub conid: Option<String>,
    /// `GKS_OPTIONS`: options for all workstations.
    pub options: Option<String>,
    /// `GKS_SCRIPT`: the file with the script of scripted workstations.
    pub script: Option<String>,
    /// `GKS_REDUCE`: how far points that vector formats leave out of lines may lie off, in nominal linewidths.
    pub reduce: Option<String>,
    /// `GKS_DIALECT`: whose workstation type numbers programs use.
    pub dialect: Option<String>,
}

impl Environment {
    /// The environment of this process. A variable without text counts as not set.
    pub fn from_process() -> Environment {
        Environment::from_variables(|name| std::env::var_os(name).map(|v| v.to_string_lossy().into_owned()))
    }

    /// The environment in which `value` gives the values of variables.
    pub fn from_variables(value: impl Fn(&str) -> Option<String>) -> Environment {
        let variable = |name| value(name).map(|v| v.trim().to_owned()).filter(|v| !v.is_empty());
        Environment {
            wstype: variable("GKS_WSTYPE"),
            force: !matches!(
                variable("GKS_WSTYPE_FORCE").as_deref(),
                None | Some("0" | "no" | "off" | "false")
            ),
            conid: variable("GKS_CONID"),
            options: variable("GKS_OPTIONS"),
            script: variable("GKS_SCRIPT"),
            reduce: variable("GKS_REDUCE"),
            dialect: variable("GKS_DIALECT"),
        }
    }

    /// The type of the metafile that a program writes by a connection, where it could also have been a picture; none for
    /// a picture, and where the user has chosen what is written.
    pub fn metafile_of(&self, connection: &str) -> Option<i32> {
        let (name, _) = split_connection(connection);
        let dialect = self.dialect().ok().filter(|_| self.wstype.is_none());
        dialect.and_then(|dialect| dialect.metafile_of(name))
    }

    /// The dialect named, or a message that says what can be named.
    pub fn dialect(&self) -> Result<Dialect, String> {
        let Some(name) = self.dialect.as_deref() else { return Ok(Dialect::Iso) };
        Dialect::from_name(name)
            .ok_or_else(|| format!("GKS_DIALECT={name}: the dialects are iso, ncar, xgks and gr"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variables_are_read_and_empty_ones_are_not_set() {
        let value = |name: &str| match name {
            "GKS_WSTYPE" => Some(" svg ".to_owned()),
            "GKS_WSTYPE_FORCE" => Some("1".to_owned()),
            "GKS_CONID" => Some(String::new()),
            "GKS_OPTIONS" => Some("dpi=300".to_owned()),
            "GKS_SCRIPT" => Some("a.script".to_owned()),
            "GKS_REDUCE" => Some("0.25".to_owned()),
            "GKS_DIALECT" => Some("NCAR".to_owned()),
            _ => None,
        };
        let environment = Environment::from_variables(value);
        let expected = Environment {
            wstype: Some("svg".to_owned()),
            force: true,
            conid: None,
            options: Some("dpi=300".to_owned()),
            script: Some("a.script".to_owned()),
            reduce: Some("0.25".to_owned()),
            dialect: Some("NCAR".to_owned()),
        };
        assert_eq!(environment, expected);
        assert_eq!(environment.dialect(), Ok(Dialect::Ncar));
        assert_eq!(Environment::from_variables(|_| None), Environment::default());
        let zero = |name: &str| (name == "GKS_WSTYPE_FORCE").then(|| "0".to_owned());
        assert!(!Environment::from_variables(zero).force);
    }

    #[test]
    fn an_unknown_dialect_is_named() {
        let environment = Environment { dialect: Some("cgi".to_owned()), ..Environment::default() };
        let said = environment.dialect().unwrap_err();
        assert_eq!(said, "GKS_DIALECT=cgi: the dialects are iso, ncar, xgks and gr");
    }
}
