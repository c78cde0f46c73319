//! `lesson eval`: the checked functions for scripts.

use crate::stop::{Stop, plain};
use chapters::CURRICULUM;
use chapters::parameter::{Argument, Fault, Function, Kind, excerpt, reason};
use serde::de::{Deserialize, Deserializer, MapAccess, Visitor};
use serde_json::json;
use serde_json::value::RawValue;
use std::fmt;
use std::io::{self, BufRead, BufReader, BufWriter, Write, stdin, stdout};
use std::process::ExitCode;
use views::number::{Number, full};

/// The functions that there are.
pub fn functions() -> impl Iterator<Item = &'static Function> {
    CURRICULUM.iter().flat_map(|chapter| chapter.functions)
}

fn find(name: &str) -> Result<&'static Function, Stop> {
    let wanted = plain(name);
    functions().find(|function| plain(function.name) == wanted).ok_or_else(|| {
        let names = functions().map(|function| function.name);
        Fault::unknown(excerpt(name), name, "no such function", names).into()
    })
}

/// One call: a line `name value` for each output, with its unit as a third column for somebody who `watches`, or all of
/// them as one JSON object.
pub fn once(name: &str, given: &[(String, String)], json: bool, watches: bool) -> Result<Vec<u8>, Stop> {
    let function = find(name)?;
    let argument = |(name, text): &(String, String)| match Argument::from_text(text) {
        Ok(argument) => Ok((name.clone(), argument)),
        Err(why) => Err(malformed(function, name, &why)),
    };
    let outputs = function.call(&given.iter().map(argument).collect::<Result<Vec<_>, Fault>>()?)?;
    let mut text = Vec::new();
    if json {
        write_outputs(&mut text, &outputs).map_err(Stop::writing)?;
        return Ok(text);
    }
    for (name, value) in &outputs {
        let unit = function.outputs.iter().find(|output| watches && output.name == *name && output.unit != "1");
        let unit = unit.map_or(String::new(), |output| format!(" {}", output.unit));
        writeln!(text, "{name} {}{unit}", full(Number(*value))).map_err(Stop::writing)?;
    }
    Ok(text)
}

/// That what stands for the input `name` cannot be read, and what would be valid.
fn malformed(function: &Function, name: &str, why: &str) -> Fault {
    match function.input(name) {
        Some(input) => input.malformed(name, why),
        None => Fault::new(excerpt(name), why),
    }
}

/// The longest line that is read [byte].
const LONGEST: usize = 16 << 20;

/// What some editors put before a text in UTF-8.
const BYTE_ORDER_MARK: &[u8] = "\u{feff}".as_bytes();

/// One call for every line of standard input, in order; a bad line leaves a record of its error.
pub fn lines(name: &str) -> Result<ExitCode, Stop> {
    let function = find(name)?;
    let mut input = BufReader::with_capacity(1 << 16, stdin().lock());
    let mut output = BufWriter::with_capacity(1 << 16, stdout().lock());
    let all_good = answer(function, &mut input, &mut output)?;
    output.flush().map_err(Stop::writing)?;
    Ok(if all_good { ExitCode::SUCCESS } else { ExitCode::from(2) })
}

/// Answers `input` line by line; whether every line was good.
fn answer<R: io::Read>(function: &Function, input: &mut BufReader<R>, output: &mut impl Write) -> Result<bool, Stop> {
    let (mut line, mut number, mut blank, mut all_good) = (Vec::new(), 0_u64, 0_u64, true);
    loop {
        // Whoever waits for an answer before the next question gets it.
        if !input.buffer().contains(&b'\n') {
            output.flush().map_err(Stop::writing)?;
        }
        let read = read_line(input, &mut line).map_err(|error| Stop::at("standard input", error))?;
        let Some(whole) = read else { return Ok(all_good) };
        number += 1;
        if number == 1 && line.starts_with(BYTE_ORDER_MARK) {
            line.drain(..BYTE_ORDER_MARK.len());
        }
        if line.iter().all(u8::is_ascii_whitespace) {
            blank += 1;
            continue;
        }
        // Empty lines at the end of input are no questions; others are.
        for number in number - blank..number {
            all_good = false;
            write_error(output, number, "empty").map_err(Stop::writing)?;
        }
        blank = 0;
        let answer = if whole { parse(function, &line) } else { Err(format!("longer than {} MiB", LONGEST >> 20)) };
        let answer = answer.and_then(|given| function.call(&given).map_err(|fault| Stop::from(fault).to_string()));
        all_good &= answer.is_ok();
        match answer {
            Ok(outputs) => write_outputs(output, &outputs),
            Err(message) => write_error(output, number, &message),
        }
        .map_err(Stop::writing)?;
    }
}

fn write_outputs(output: &mut impl Write, outputs: &[(&'static str, f64)]) -> io::Result<()> {
    for (at, (name, value)) in outputs.iter().enumerate() {
        output.write_all(if at == 0 { b"{\"" } else { b",\"" })?;
        output.write_all(name.as_bytes())?;
        output.write_all(b"\":")?;
        serde_json::to_writer(&mut *output, &Number(*value))?;
    }
    output.write_all(b"}\n")
}

fn write_error(output: &mut impl Write, number: u64, message: &str) -> io::Result<()> {
    writeln!(output, "{}", json!({ "error": format!("line {number}: {message}") }))
}

/// Reads a line without its end into `line`: `Some(false)` if it was too long to keep, `None` at the end of input.
fn read_line(input: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<Option<bool>> {
    line.clear();
    let (mut whole, mut any) = (true, false);
    loop {
        let chunk = match input.fill_buf() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        if chunk.is_empty() {
            return Ok(any.then_some(whole));
        }
        any = true;
        let end = chunk.iter().position(|byte| *byte == b'\n');
        let part = &chunk[..end.unwrap_or(chunk.len())];
        if line.len() + part.len() > LONGEST {
            // The rest is skipped, not held; a byte remains, so that the line does not count as empty.
            whole = false;
            line.clear();
            line.push(b'.');
        }
        if whole {
            line.extend_from_slice(part);
        }
        let used = part.len() + usize::from(end.is_some());
        input.consume(used);
        if end.is_some() {
            return Ok(Some(whole));
        }
    }
}

fn parse(function: &Function, line: &[u8]) -> Result<Vec<(String, Argument)>, String> {
    let Fields(fields) = serde_json::from_slice(line).map_err(|error| reason(&error))?;
    let mut arguments = Vec::with_capacity(fields.len());
    for (name, value) in fields {
        match Argument::from_json(value.get()) {
            Ok(argument) => arguments.push((name, argument)),
            Err(why) => return Err(malformed(function, &name, &why).to_string()),
        }
    }
    Ok(arguments)
}

/// The fields of a JSON object, each value still as text, so that what is wrong with it can be told with its name.
struct Fields<'a>(Vec<(String, &'a RawValue)>);

impl<'de> Deserialize<'de> for Fields<'de> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(FieldsReader).map(Self)
    }
}

struct FieldsReader;

impl<'de> Visitor<'de> for FieldsReader {
    type Value = Vec<(String, &'de RawValue)>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a JSON object such as {\"n_i\": 1}")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Self::Value, A::Error> {
        let mut fields = Vec::new();
        while let Some(entry) = entries.next_entry()? {
            fields.push(entry);
        }
        Ok(fields)
    }
}

/// Every function with its inputs and outputs, as one JSON document.
pub fn list_json() -> String {
    let functions: Vec<_> = functions()
        .map(|function| {
            let inputs: Vec<_> = function
                .inputs
                .iter()
                .map(|input| {
                    let domain = match input.kind {
                        Kind::Number(range) if range.is_bounded() => Some([range.min, range.max].map(Number)),
                        Kind::Count { min, max } => Some([min as f64, max as f64].map(Number)),
                        _ => None,
                    };
                    json!({
                        "name": input.name, "says": input.says, "unit": input.kind.unit(), "domain": domain,
                        "default": input.default.and_then(|text| input.parse(text).ok()).map(|value| value.argument()),
                        "kind": input.kind.name(), "symbol": input.symbol,
                        "aliases": input.names().skip(1).collect::<Vec<_>>(), "takes": input.kind.describe(),
                        "only_with": input.only_with.map(|(choice, words)| json!({ choice: words })),
                    })
                })
                .collect();
            let outputs: Vec<_> = function
                .outputs
                .iter()
                .map(|output| json!({ "name": output.name, "says": output.says, "unit": output.unit }))
                .collect();
            json!({ "name": function.name, "says": function.says, "inputs": inputs, "outputs": outputs })
        })
        .collect();
    format!("{:#}\n", json!({ "functions": functions }))
}
