use super::*;
use crate::sink::tests::Directory;

fn environment(variables: &[(&str, &str)]) -> Environment {
    let find = |name: &str| variables.iter().find(|(n, _)| *n == name).map(|(_, v)| (*v).to_owned());
    Environment::from_variables(find)
}

/// The type that a number and a connection become, the file written, and the options.
fn opened(variables: &[(&str, &str)], number: i32, connection: &str) -> Result<String, OpenError> {
    let drivers = Drivers::new(environment(variables));
    let (selection, target, _) = drivers.resolve(number, connection)?;
    let file = if selection.kind.extension.is_empty() { String::new() } else { target.name };
    Ok(format!("{} {file}", selection.kind.name))
}

fn becomes(variables: &[(&str, &str)], number: i32, connection: &str) -> String {
    opened(variables, number, connection).unwrap_or_else(|error| error.to_string())
}

#[test]
fn types_are_chosen_by_number_name_and_extension() {
    let name = |text: &str| Drivers::choose(text).and_then(by_number).map_or("", |kind| kind.name);
    for kind in WORKSTATION_TYPES.iter().skip(1) {
        assert_eq!(name(kind.name), kind.name);
        assert_eq!(name(&kind.number.to_string()), kind.name);
    }
    assert_eq!(name("svg"), "svg");
    assert_eq!(name("out.pdf"), "pdf");
    assert_eq!(name("a.dir/OUT.JPG?quality=3"), "jpeg");
    assert_eq!(name("x.jpeg"), "jpeg");
    assert_eq!(name("tif"), "tiff");
    assert_eq!(name("plot.hpgl"), "hpgl");
    assert_eq!(name("plot.plt"), "hpgl");
    assert_eq!(name("default"), "png");
    assert_eq!(name("0"), "png");
    for unknown in ["", "7", "-1", "out", "out.doc", "out.null", "svg.", ".svg"] {
        assert_eq!(Drivers::choose(unknown), None, "{unknown}");
    }
}

#[test]
fn type_0_is_what_the_user_chose() {
    assert_eq!(becomes(&[], 0, ""), "png gks.png");
    assert_eq!(becomes(&[], 0, "3"), "png gks.3.png");
    assert_eq!(becomes(&[], 0, "out"), "png out");
    assert_eq!(becomes(&[], 0, "out.svg"), "svg out.svg");
    assert_eq!(becomes(&[("GKS_CONID", "out.svg")], 0, "7"), "svg out.svg");
    assert_eq!(becomes(&[("GKS_WSTYPE", "210")], 0, "7"), "pdf gks.7.pdf");
    assert_eq!(becomes(&[("GKS_WSTYPE", "eps")], 0, "out.png"), "eps out.eps");
    assert_eq!(becomes(&[("GKS_WSTYPE", "0")], 0, "out.png"), "png out.png");
    assert_eq!(becomes(&[("GKS_WSTYPE", "a/b.svg")], 0, "out.png"), "svg a/b.svg");
    assert_eq!(becomes(&[("GKS_WSTYPE", "a/b.svg"), ("GKS_CONID", "c")], 0, "out.png"), "svg c");
    assert_eq!(becomes(&[("GKS_WSTYPE", "null")], 0, "out.png"), "null ");
}

#[test]
fn other_types_give_way_when_forced() {
    let svg = ("GKS_WSTYPE", "svg");
    let force = ("GKS_WSTYPE_FORCE", "1");
    assert_eq!(becomes(&[svg], 210, "out.pdf"), "pdf out.pdf");
    assert_eq!(becomes(&[svg, force], 210, "out.pdf"), "svg out.svg");
    assert_eq!(becomes(&[svg, force], 4, ":0"), "svg gks.svg");
    assert_eq!(becomes(&[force], 210, "out.pdf"), "pdf out.pdf");
    assert_eq!(becomes(&[force], 4, ""), "no workstation type 4");
    assert_eq!(becomes(&[svg], 4, ""), "no workstation type 4");
    assert_eq!(becomes(&[("GKS_CONID", "x")], 210, "out.pdf"), "pdf x");
}

#[test]
fn segment_storage_is_neither_replaced_nor_chosen() {
    let (svg, force) = (("GKS_WSTYPE", "svg"), ("GKS_WSTYPE_FORCE", "1"));
    assert_eq!(becomes(&[svg, force], own::WISS, "out.pdf"), "wiss ");
    assert!(
        becomes(&[("GKS_WSTYPE", "wiss")], 0, "").starts_with("GKS_WSTYPE=wiss: no such workstation type")
    );
    let mut drivers = Drivers::new(environment(&[svg, force]));
    let (backend, description) = drivers.open(own::WISS, "out.pdf").unwrap();
    assert!(matches!(backend, Backend::Storage));
    assert_eq!((description.category, description.number), (Category::Wiss, own::WISS));
}

#[test]
fn dialects_have_numbers_of_their_own() {
    let ncar = ("GKS_DIALECT", "ncar");
    assert_eq!(becomes(&[ncar], 1, "gmeta"), "ncgm gmeta");
    assert_eq!(becomes(&[ncar], 8, ""), "png gks.png");
    assert_eq!(becomes(&[ncar], 12, "2"), "pdf gks.2.pdf");
    assert_eq!(becomes(&[ncar], 21, "2"), "eps gks.2.eps");
    assert_eq!(becomes(&[ncar], 42, "x.pdf"), "pdf x.pdf");
    assert_eq!(becomes(&[ncar], 200, "x.svg"), "svg x.svg");
    assert_eq!(becomes(&[ncar], 3, ""), "wiss ");
    assert_eq!(becomes(&[ncar], 4, ""), "no workstation type 4");
    let svg = ("GKS_WSTYPE", "svg");
    assert_eq!(becomes(&[ncar, svg], 1, "gmeta"), "svg gmeta.svg");
    assert_eq!(becomes(&[ncar, svg], 12, "2"), "svg gks.2.svg");
    assert_eq!(becomes(&[ncar, svg], 3, ""), "wiss ");
    assert_eq!(becomes(&[ncar, ("GKS_WSTYPE", "20")], 1, "2"), "ps gks.2.ps");
    assert_eq!(becomes(&[ncar, ("GKS_WSTYPE", "1")], 8, "2"), "ncgm gks.2.ncgm");
    assert_eq!(becomes(&[("GKS_DIALECT", "gr")], 101, "2"), "pdf gks.2.pdf");
    assert_eq!(becomes(&[("GKS_DIALECT", "gr")], 110, "2"), "png8 gks.2.png");
    assert_eq!(becomes(&[("GKS_DIALECT", "gr")], 130, "a.gif"), "gif a.gif");
    assert_eq!(becomes(&[("GKS_DIALECT", "gr"), ("GKS_WSTYPE", "cairojpg")], 411, ""), "jpeg gks.jpg");
    assert_eq!(becomes(&[("GKS_DIALECT", "gr"), ("GKS_WSTYPE", "nul")], 140, "a.png"), "null ");
    assert!(becomes(&[("GKS_WSTYPE", "nul")], 0, "").contains("no such workstation type"));
}

#[test]
fn later_options_win() {
    let variables = [
        ("GKS_DIALECT", "ncar"),
        ("GKS_OPTIONS", "dpi=100&quality=10&antialias=0&landscape=0"),
        ("GKS_WSTYPE", "26?quality=30"),
        ("GKS_CONID", "x.ps?antialias=1"),
    ];
    let drivers = Drivers::new(environment(&variables));
    let (selection, _, options) = drivers.resolve(1, "y?quality=20&dpi=200").unwrap();
    let expected = Options {
        dpi: Some(200.0),
        quality: Some(30),
        antialias: Some(true),
        landscape: Some(false),
        ..Options::default()
    };
    assert_eq!((selection.kind.name, options), ("ps", expected));
    let landscape = Drivers::new(environment(&[("GKS_DIALECT", "ncar")])).resolve(26, "").unwrap().2;
    assert_eq!(landscape.landscape, Some(true));
    assert!(Drivers::new(Environment::default()).resolve(own::SVG_OUTLINES, "").unwrap().2.outlines);
}

#[test]
fn errors_say_what_is_wrong_and_where() {
    let said = |variables: &[(&str, &str)], connection: &str| becomes(variables, 200, connection);
    assert_eq!(
        said(&[], "a.svg?size=0x5"),
        "connection \"a.svg?size=0x5\": option size=0x5: expected WIDTHxHEIGHT in points (1/72 inch), each \
         from 3 to 14400"
    );
    assert_eq!(
        said(&[("GKS_OPTIONS", "dpi=x")], "a.svg"),
        "connection \"GKS_OPTIONS=dpi=x\": option dpi=x: expected a number from 1 to 10000"
    );
    assert_eq!(
        said(&[("GKS_CONID", "b?dpi")], "a.svg"),
        "connection \"GKS_CONID=b?dpi\": option \"dpi\" has no value; write dpi=value"
    );
    assert_eq!(said(&[("GKS_DIALECT", "x")], ""), "GKS_DIALECT=x: the dialects are iso, ncar, xgks and gr");
    assert_eq!(
        said(&[("GKS_WSTYPE", "tga")], ""),
        "GKS_WSTYPE=tga: no such workstation type; the types are default, png, jpeg, tiff, bmp, webp, gif, png8, \
         framebuffer, framebuffer8, svg, svg-outlines, pdf, ps, eps, hpgl, window, web, terminal, sixel, \
         kitty, blocks, scripted, gksm, mi, cgm, cgm-text, cgm-character, ncgm, null"
    );
    assert!(said(&[("GKS_WSTYPE", "3"), ("GKS_DIALECT", "ncar")], "").starts_with("GKS_WSTYPE=3: no such"));
    let mut drivers = Drivers::new(Environment::default());
    let error = drivers.open(200, "/no/such/dir/a.svg").err().unwrap();
    assert!(matches!(&error, OpenError::CannotOpen(text) if text.starts_with("/no/such/dir/a.svg: ")));
    assert!(matches!(drivers.open(99, ""), Err(OpenError::NoSuchType(99))));
}

#[test]
fn what_is_wrong_in_the_environment_does_not_hide_the_types() {
    let right = Drivers::new(Environment::default());
    let variables = [("GKS_WSTYPE", "x"), ("GKS_OPTIONS", "x"), ("GKS_DIALECT", "x"), ("GKS_CONID", "a?x")];
    let wrong = Drivers::new(environment(&variables));
    assert_eq!(wrong.types(), right.types());
    assert_eq!(wrong.describe(0), right.describe(0));
}

#[test]
fn further_redirected_workstations_get_names_of_their_own() {
    let directory = Directory::new();
    let conid = directory.name("out.svg");
    let mut drivers = Drivers::new(environment(&[("GKS_CONID", conid.as_str()), ("GKS_OPTIONS", "dpi=9")]));
    for _ in 0..3 {
        let (mut backend, _) = drivers.open(own::SVG, "1").unwrap();
        draw_nothing(&mut backend);
    }
    assert_eq!(directory.files(), ["out-2.svg", "out-3.svg", "out.svg"]);
    let mut drivers = Drivers::new(Environment::default());
    for _ in 0..2 {
        let (mut backend, _) = drivers.open(own::SVG, &directory.name("same.svg")).unwrap();
        draw_nothing(&mut backend);
    }
    assert_eq!(directory.files().len(), 4);
}

#[test]
fn limits_of_formats_are_reported() {
    let mut drivers = Drivers::new(Environment::default());
    let said = drivers.open(own::WEBP, "x.webp?size=20000x10").err().unwrap().to_string();
    assert!(said.starts_with("connection \"x.webp?size=20000x10\": 20000 x 10 pixels: "), "{said}");
    assert!(!std::path::Path::new("x.webp").exists());
}

fn draw_nothing(backend: &mut Backend) {
    let Backend::Device(device) = backend else { return };
    let background = gks_pipeline::colour::Colour::WHITE;
    let page = gks_pipeline::device::Page { number: 1, background, colours: Vec::new() };
    device.begin(&page).unwrap();
    device.end().unwrap();
    device.close().unwrap();
}

#[test]
fn descriptions_are_those_of_the_devices() {
    let directory = Directory::new();
    let lists = ["", "landscape=1", "size=400x300&landscape=0&dpi=96"];
    for list in lists {
        let options = [("GKS_OPTIONS", list), ("GKS_DIALECT", "ncar")];
        let mut drivers = Drivers::new(environment(&options));
        // A window needs a display, which is not everywhere; it is tested where there is one.
        for number in drivers.types().into_iter().filter(|&number| number != own::WINDOW) {
            let described = drivers.describe(number).unwrap();
            let (mut backend, description) = drivers.open(number, &directory.name("x")).unwrap();
            assert_eq!(described, description);
            if let Backend::Device(device) = &backend {
                assert_eq!(&described.surface, device.surface(), "{number} {list}");
            }
            assert_eq!(described.number, number);
            if let Some(kind) = by_number(number) {
                assert_eq!(described.colour_table_length(), kind.colours, "{number}");
            }
            let raster = described.raster;
            assert!(raster.0 > 0 && raster.1 > 0 && described.size().0 > 0.0, "{number}");
            if list.contains("landscape=0") && matches!(backend, Backend::Device(_)) {
                assert!(described.size().0 < described.size().1, "{number} {list}");
            }
            draw_nothing(&mut backend);
        }
    }
}

#[test]
fn categories_are_those_that_programs_expect() {
    let ncar = Drivers::new(environment(&[("GKS_DIALECT", "ncar"), ("GKS_WSTYPE", "svg")]));
    let category = |number| ncar.describe(number).map(|description| description.category);
    assert_eq!(category(1), Some(Category::MetafileOutput));
    assert_eq!(category(8), Some(Category::OutIn));
    assert_eq!(category(11), Some(Category::Output));
    assert_eq!(category(0), Some(Category::Output));
    assert_eq!(category(3), Some(Category::Wiss));
    assert!(ncar.types().starts_with(&[0, 1, 2, 3, 7, 8, 10, 11, 12, 20, 21]));
}

#[test]
fn every_type_of_the_table_is_served() {
    let mut numbers: Vec<i32> = WORKSTATION_TYPES.iter().map(|kind| kind.number).collect();
    numbers.sort_unstable();
    assert_eq!(Drivers::new(Environment::default()).types(), numbers);
}
