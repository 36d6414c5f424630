use super::check;
use crate::repository;
use crate::tables::{Error, Function, OneOrMore, Tables};

fn tables() -> Tables {
    Tables::load(&repository().join("spec")).expect("the tables can be read")
}

/// Breaks the tables and expects one of the faults found to contain `expected`.
fn expect(expected: &str, break_tables: impl FnOnce(&mut Tables)) {
    let mut tables = tables();
    break_tables(&mut tables);
    let faults = check(&tables);
    assert!(faults.iter().any(|fault| fault.contains(expected)), "expected {expected:?}, found {faults:#?}");
}

fn function<'a>(tables: &'a mut Tables, name: &str) -> &'a mut Function {
    tables.functions.iter_mut().find(|f| f.name == name).expect("the function is in the table")
}

#[test]
fn the_tables_are_sound() {
    assert_eq!(check(&tables()), Vec::<String>::new());
}

#[test]
fn all_functions_are_there() {
    let tables = tables();
    assert_eq!(tables.functions.len(), 218);
    assert_eq!(tables.functions.iter().filter(|f| f.c.is_some()).count(), 216);
    assert_eq!(tables.functions.iter().flat_map(|f| &f.fortran).count(), 220);
    assert_eq!(tables.functions.iter().filter(|f| f.id.is_some()).count(), 109);
}

#[test]
fn an_error_without_text_is_found() {
    expect("OPEN GKS: error 199 has no text", |t| function(t, "OPEN GKS").errors.push(199));
    expect("POLYLINE: error 100 has no text", |t| t.errors.retain(|e| e.number != 100));
    expect("error 5 occurs twice", |t| t.errors.push(t.errors[4].clone()));
    expect("error 1: the text is not a sentence", |t| t.errors[0].text.pop().map_or((), drop));
}

#[test]
fn a_state_error_that_does_not_fit_the_states_is_found() {
    expect("TEXT: its states call for the state error Some(5)", |t| function(t, "TEXT").errors[0] = 7);
    expect("TEXT: its states call for", |t| function(t, "TEXT").states.push("WSOP".to_owned()));
    expect("TEXT: GKSOP is not an operating state", |t| function(t, "TEXT").states[0] = "GKSOP".to_owned());
    expect("TEXT: it has no operating states", |t| function(t, "TEXT").states.clear());
    expect("INQUIRE OPERATING STATE VALUE: its states", |t| {
        function(t, "INQUIRE OPERATING STATE VALUE").states.pop();
    });
}

#[test]
fn gaps_in_a_function_are_found() {
    expect("TEXT: its level", |t| function(t, "TEXT").level = "3a".to_owned());
    expect("TEXT: a Rust method and a sample", |t| function(t, "TEXT").sample = None);
    expect("TEXT: a C function and a prototype", |t| function(t, "TEXT").prototype = None);
    expect("TEXT: it does not say whether", |t| function(t, "TEXT").confirmed = None);
    expect("TEXT: its subroutines and parameter lists differ", |t| {
        function(t, "TEXT").parameters.remove("GTXS");
    });
    expect("PACK DATA RECORD: neither the kernel nor a binding", |t| {
        function(t, "PACK DATA RECORD").fortran.clear();
    });
    expect("the Rust name is not the standard's", |t| {
        function(t, "TEXT").rust = Some("draw_text".to_owned());
    });
}

#[test]
fn duplicates_are_found() {
    expect("function TEXT occurs twice", |t| t.functions.push(t.functions[14].clone()));
    expect("C function gtext occurs twice", |t| function(t, "POLYLINE").c = Some("gtext".to_owned()));
    expect("Fortran subroutine GPL occurs twice", |t| function(t, "TEXT").fortran[1] = "GPL".to_owned());
    expect("function identifier 3 occurs twice", |t| function(t, "TEXT").id = Some(3));
    expect("identifiers leave gaps", |t| function(t, "TEXT").id = None);
    expect("C constant GST_GKCL occurs twice", |t| {
        t.enumerations.enumeration[0].values[0].c = Some("GST_GKCL".to_owned());
    });
    expect("Fortran constant GGKCL occurs twice", |t| {
        t.enumerations.enumeration[0].values[0].fortran = OneOrMore::One("GGKCL".to_owned());
    });
}

#[test]
fn what_is_awaited_is_checked() {
    expect("TEXT: level 0a awaits something", |t| function(t, "TEXT").awaits = Some("letters".to_owned()));
    expect("CREATE SEGMENT: it awaits something and calls errors", |t| {
        function(t, "CREATE SEGMENT").awaits = Some("segments".to_owned());
        function(t, "CREATE SEGMENT").unreachable.insert("120".to_owned(), "why not".to_owned());
    });
    expect("PACK DATA RECORD: it awaits something and has no", |t| {
        function(t, "PACK DATA RECORD").awaits = Some("records".to_owned());
    });
}

#[test]
fn an_unreachable_error_needs_a_reason_and_a_place() {
    expect("TEXT: error 77 is called unreachable and not listed", |t| {
        function(t, "TEXT").unreachable.insert("77".to_owned(), "why not".to_owned());
    });
    expect("TEXT: error 101 is unreachable without a reason", |t| {
        function(t, "TEXT").unreachable.insert("101".to_owned(), String::new());
    });
}

#[test]
fn an_error_number_is_provoked_or_explained() {
    let error = |t: &mut Tables, number: i32, change: fn(&mut Error)| {
        change(t.errors.iter_mut().find(|e| e.number == number).expect("the number is in the table"));
    };
    expect("error 43: it is neither provoked nor explained", |t| error(t, 43, |e| e.never = None));
    expect("error 43: it is never met, without a reason", |t| {
        error(t, 43, |e| e.never = Some(String::new()));
    });
    expect("error 100: it is met in more than one way", |t| {
        error(t, 100, |e| e.never = Some("why not".to_owned()));
    });
    expect("error -101: it is met in more than one way", |t| {
        error(t, -101, |e| e.provoked_by = Some("tests/run".to_owned()));
    });
    expect("error 302: the test that is said to provoke it does not name it", |t| {
        error(t, 302, |e| e.provoked_by = Some("tests/programs/f/lists.f".to_owned()));
    });
    expect("error 83: it is neither", |t| t.errors.iter_mut().for_each(|e| e.never = None));
    expect("error category implementation: XGKS: it has no reason", |t| {
        t.error_categories[0].never.clear();
    });
}

#[test]
fn samples_are_read() {
    let sample = |text: &'static str| {
        move |t: &mut Tables| function(t, "SET TEXT PATH").sample = Some(text.to_owned())
    };
    expect("TextPath::Sideways", sample("TextPath::Sideways"));
    expect("Path::Right", sample("Path::Right"));
    expect("an unmatched ]", sample("(1.0, 2.0]"));
    expect("the sample is not closed", sample("&[(1.0, 2.0)"));
    expect("the sample is not closed", sample("1, \"text"));
    expect("MESSAGE: the sample does not begin with a workstation", |t| {
        function(t, "MESSAGE").sample = Some("\"message\"".to_owned());
    });
    expect("TEXT: the error of the sample is not listed", |t| function(t, "TEXT").sample_error = Some(1));
}

#[test]
fn parameters_are_checked() {
    let broken = |change: fn(&mut crate::tables::Parameter)| {
        move |t: &mut Tables| {
            let list = function(t, "CELL ARRAY").parameters.get_mut("GCA").expect("CELL ARRAY is GCA");
            change(list.last_mut().expect("GCA has parameters"));
        }
    };
    expect("GCA: COLIA has the unknown type X", broken(|p| p.kind = "X".to_owned()));
    expect("GCA: COLIA has the unknown direction up", broken(|p| p.direction = "up".to_owned()));
    expect("GCA: COLIA has the unknown dimension LEN", broken(|p| p.dimension = Some("LEN".to_owned())));
    expect("GCA: COLIA has the unknown enumeration hue", broken(|p| p.enumeration = Some("hue".to_owned())));
    expect("GCA: COLIA has no meaning", broken(|p| p.meaning.clear()));
    expect(
        "CELL ARRAY: its parameters call for the Fortran errors [2001]",
        broken(|p| p.direction = "out".to_owned()),
    );
    expect("its parameters call for the Fortran errors [2000]", |t| {
        function(t, "SET TEXT PATH").fortran_errors.clear();
    });
}

#[test]
fn unknown_c_types_are_found() {
    expect("gtext: unknown type Gpnt", |t| {
        function(t, "TEXT").prototype =
            Some("void gtext(const Gpnt *text_pos, const char *char_string)".to_owned());
    });
    expect("gtext: real is not a type", |t| {
        function(t, "TEXT").prototype = Some("void gtext(real *text_pos)".to_owned());
    });
    expect("gtext: the prototype is not one of it", |t| {
        function(t, "TEXT").prototype = Some("void gtxt(const Gpoint *text_pos)".to_owned());
    });
    expect("Grect: unknown type Gpoint", |t| t.types.structure.retain(|s| s.name != "Gpoint"));
    expect("C type Gpoint occurs twice", |t| t.types.structure[0].name = "Gpoint".to_owned());
}

#[test]
fn the_state_lists_are_checked() {
    let broken = |change: fn(&mut crate::tables::Entry)| {
        move |t: &mut Tables| {
            let list = t.states.table.iter_mut().find(|table| table.name == "GKS state list");
            let entry = list.and_then(|list| list.entries.iter_mut().find(|e| e.name == "text path"));
            change(entry.expect("the GKS state list has the text path"));
        }
    };
    expect("text path: the initial value is not", broken(|e| e.initial = Some("Sideways".to_owned())));
    expect("text path: unknown enumeration", broken(|e| e.enumeration = Some("path".to_owned())));
    expect("text path: unknown type", broken(|e| (e.kind, e.enumeration) = (Some("path".to_owned()), None)));
    expect("text path: set by the unknown function", broken(|e| e.set_by.push("SET PATH".to_owned())));
    expect("text path: returned by the unknown inquiry", broken(|e| e.inquiry.push("GQPATH".to_owned())));
    expect("text path: unknown workstation category", broken(|e| e.categories.push("Printer".to_owned())));
}

#[test]
fn the_numbers_are_checked() {
    expect("workstation type 100 occurs twice", |t| t.numbers.workstation_type[3].number = 100);
    expect("workstation type wiss: 599 is reserved for interactive", |t| {
        t.numbers.workstation_type[1].number = 599;
    });
    expect("linetype dashed: dashes and gaps", |t| t.numbers.linetype[1].dashes.push(3.0));
    expect("hatch style horizontal: the lines", |t| t.numbers.hatch[0].angles[0] = 180.0);
    expect("pattern checkerboard: not a rectangle", |t| t.numbers.pattern[0].rows[1].push('1'));
    expect("polyline bundle 2: it uses", |t| t.numbers.polyline_bundle[1].linetype = 9);
    expect("text bundle 3: it uses", |t| t.numbers.text_bundle[2].font = -99);
    expect("fill area bundle 4: it uses", |t| t.numbers.fill_area_bundle[3].style = -13);
    expect("do not follow one another", |t| t.numbers.colour_cube.first = 17);
    expect("colour grey: it cannot be told", |t| t.numbers.colour[8].rgb = [1.0, 0.0, 0.0]);
    expect("predefined_text_bundles: 5", |t| t.numbers.text_bundle.truncate(5));
    expect("level not built: error -3101", |t| t.numbers.binding_error[0].number = -3101);
}
