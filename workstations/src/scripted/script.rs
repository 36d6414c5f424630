//! Scripts: what an operator does, written down beforehand.

use gks_pipeline::input::InputClass;
use std::time::Duration;

/// What the operator does to one logical input device.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Act {
    pub(super) class: InputClass,
    pub(super) device: i32,
    pub(super) entry: Entry,
}

/// What is entered with a device; positions as the script has them.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Entry {
    Locator((f64, f64)),
    Stroke(Vec<(f64, f64)>),
    Valuator(f64),
    Choice(Option<i32>),
    Pick(Option<(f64, f64)>),
    String(String),
}

/// A step of a script.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Step {
    /// Devices that one trigger fires for, in order.
    Enter(Vec<Act>),
    /// The operator refuses to answer.
    Break,
    /// Nothing happens for a time.
    Wait(Duration),
    /// The picture is written to a file.
    Snapshot(String),
}

/// The steps of a script, each with the number of its line.
pub(super) type Steps = Vec<(usize, Step)>;

/// Reads a script. An error names the line that makes no sense.
pub(super) fn parse(text: &str) -> Result<Steps, String> {
    let mut steps = Steps::new();
    let mut together: Option<(usize, Vec<Act>)> = None;
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        let wrong = |message: String| format!("line {number}: {message}");
        let step = match (word, &mut together) {
            ("end", Some(_)) => {
                let acts = together.take();
                steps.extend(acts.map(|(begin, acts)| (begin, Step::Enter(acts))));
                continue;
            }
            ("together", None) => {
                together = Some((number, Vec::new()));
                continue;
            }
            (_, Some((_, acts))) => {
                acts.push(act(word, rest).map_err(wrong)?);
                continue;
            }
            ("break", None) => Step::Break,
            ("wait", None) => Step::Wait(seconds(rest).map_err(wrong)?),
            ("snapshot", None) if rest.trim().is_empty() => {
                return Err(wrong("snapshot has no file".to_owned()));
            }
            ("snapshot", None) => Step::Snapshot(rest.trim().to_owned()),
            (_, None) => Step::Enter(vec![act(word, rest).map_err(wrong)?]),
        };
        steps.push((number, step));
    }
    match together {
        Some((begin, _)) => Err(format!("line {begin}: together has no end")),
        None => Ok(steps),
    }
}

fn act(word: &str, rest: &str) -> Result<Act, String> {
    let class = match word {
        "locator" => InputClass::Locator,
        "stroke" => InputClass::Stroke,
        "valuator" => InputClass::Valuator,
        "choice" => InputClass::Choice,
        "pick" => InputClass::Pick,
        "string" => InputClass::String,
        _ => return Err(format!("\"{word}\" means nothing")),
    };
    let rest = rest.trim_start();
    let (device, value) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
    let device = device.parse().map_err(|_| format!("\"{device}\" is no device number"))?;
    let words: Vec<&str> = value.split_whitespace().collect();
    let entry = match (class, words.as_slice()) {
        (InputClass::Locator, [x, y]) => Entry::Locator((number(x)?, number(y)?)),
        (InputClass::Stroke, coordinates) if coordinates.len() % 2 == 0 => {
            let points = coordinates.as_chunks::<2>().0.iter();
            Entry::Stroke(points.map(|[x, y]| Ok((number(x)?, number(y)?))).collect::<Result<_, String>>()?)
        }
        (InputClass::Valuator, [value]) => Entry::Valuator(number(value)?),
        (InputClass::Choice, ["none"]) => Entry::Choice(None),
        (InputClass::Choice, [choice]) => {
            Entry::Choice(Some(choice.parse().map_err(|_| format!("\"{choice}\" is no alternative"))?))
        }
        (InputClass::Pick, ["none"]) => Entry::Pick(None),
        (InputClass::Pick, [x, y]) => Entry::Pick(Some((number(x)?, number(y)?))),
        // Blanks inside and at the end belong to the string.
        (InputClass::String, _) => Entry::String(value.to_owned()),
        _ => return Err(format!("\"{value}\" is nothing to enter with a {word}")),
    };
    Ok(Act { class, device, entry })
}

fn number(word: &str) -> Result<f64, String> {
    let number = word.parse().ok().filter(|number: &f64| number.is_finite());
    number.ok_or_else(|| format!("\"{word}\" is no number"))
}

fn seconds(text: &str) -> Result<Duration, String> {
    let time = Duration::try_from_secs_f64(number(text.trim())?);
    time.map_err(|_| format!("\"{}\" is no time in seconds", text.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_is_understood() {
        let text = "# a comment\n\nlocator 1 0.3 0.4\n stroke 2 0 0 1 1\nvaluator 1 -0.5\nchoice 1 3\nchoice 1 none\n\
                    pick 1 0.5 0.25\npick 1 none\nstring 1 two  words\nstring 2\nbreak\nwait 0.25\nsnapshot a b.png";
        let act = |class, device, entry| Step::Enter(vec![Act { class, device, entry }]);
        let steps: Vec<Step> = parse(text).unwrap().into_iter().map(|(_, step)| step).collect();
        let expected = [
            act(InputClass::Locator, 1, Entry::Locator((0.3, 0.4))),
            act(InputClass::Stroke, 2, Entry::Stroke(vec![(0.0, 0.0), (1.0, 1.0)])),
            act(InputClass::Valuator, 1, Entry::Valuator(-0.5)),
            act(InputClass::Choice, 1, Entry::Choice(Some(3))),
            act(InputClass::Choice, 1, Entry::Choice(None)),
            act(InputClass::Pick, 1, Entry::Pick(Some((0.5, 0.25)))),
            act(InputClass::Pick, 1, Entry::Pick(None)),
            act(InputClass::String, 1, Entry::String("two  words".to_owned())),
            act(InputClass::String, 2, Entry::String(String::new())),
            Step::Break,
            Step::Wait(Duration::from_millis(250)),
            Step::Snapshot("a b.png".to_owned()),
        ];
        assert_eq!(steps, expected);
    }

    #[test]
    fn simultaneous_entries_are_one_step_of_the_line_where_they_begin() {
        let steps = parse("break\ntogether\n  choice 1 2\n  valuator 1 0\nend\n").unwrap();
        let [(1, Step::Break), (2, Step::Enter(acts))] = steps.as_slice() else { panic!("{steps:?}") };
        assert_eq!(acts.len(), 2);
    }

    #[test]
    fn what_makes_no_sense_is_named_by_its_line() {
        for (text, said) in [
            ("\nclick 1 1", "line 2: \"click\" means nothing"),
            ("locator one 1 1", "line 1: \"one\" is no device number"),
            ("locator 1 1", "line 1: \"1\" is nothing to enter with a locator"),
            ("stroke 1 1 2 3", "line 1: \"1 2 3\" is nothing to enter with a stroke"),
            ("locator 1 1 nan", "line 1: \"nan\" is no number"),
            ("choice 1 x", "line 1: \"x\" is no alternative"),
            ("wait -1", "line 1: \"-1\" is no time in seconds"),
            ("snapshot ", "line 1: snapshot has no file"),
            ("together\nbreak", "line 2: \"break\" means nothing"),
            ("break\ntogether\nchoice 1 1", "line 2: together has no end"),
            ("end", "line 1: \"end\" means nothing"),
        ] {
            assert_eq!(parse(text), Err(said.to_owned()), "{text}");
        }
    }
}
