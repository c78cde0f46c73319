//! The parameters of a step, turned and typed.

use super::event::Key;
use chapters::parameter::{Nudge, Parameter, Setting};
use chapters::text::Phrase;
use views::block::Tone;
use views::page::{Page, Row};

/// What is being set.
#[derive(Debug, Default)]
pub struct Panel {
    /// The parameter that keys go to.
    at: usize,
    /// What is being typed for it.
    typed: Option<String>,
    /// What was wrong with the last value.
    fault: Option<String>,
}

/// What a key in the panel led to.
#[derive(Debug, PartialEq)]
pub enum Turn {
    /// Nothing outside it.
    Stay,
    /// Another setting.
    Set(Setting),
    /// The panel is closed.
    Close,
}

type Entry = (&'static Parameter, String);

fn entries(setting: &Setting) -> Vec<Entry> {
    setting.entries().map(|(parameter, text, _)| (parameter, text.into_owned())).collect()
}

impl Panel {
    pub fn press(&mut self, key: Key, setting: &Setting) -> Turn {
        let entries = entries(setting);
        self.at = self.at.min(entries.len().saturating_sub(1));
        let Some((parameter, text)) = entries.get(self.at) else { return Turn::Close };
        match (key, &mut self.typed) {
            (Key::Escape, typed @ Some(_)) => *typed = None,
            (Key::Enter, Some(typed)) => {
                let typed = std::mem::take(typed);
                self.typed = None;
                return if typed.trim().is_empty() { Turn::Stay } else { self.set(setting, parameter, typed.trim()) };
            }
            (Key::Backspace, Some(typed)) => drop(typed.pop()),
            (Key::Char(letter), Some(typed)) => typed.push(letter),
            (Key::Escape | Key::Enter, None) => return Turn::Close,
            (Key::Up, _) => self.go(self.at.saturating_sub(1)),
            (Key::Down, _) => self.go((self.at + 1).min(entries.len() - 1)),
            (Key::Left { shift }, None) => return self.nudge(setting, parameter, text, false, shift),
            (Key::Right { shift }, None) => return self.nudge(setting, parameter, text, true, shift),
            (Key::PageUp, None) => return self.nudge(setting, parameter, text, true, true),
            (Key::PageDown, None) => return self.nudge(setting, parameter, text, false, true),
            (Key::Backspace, None) => {
                return parameter.default.map_or(Turn::Stay, |default| self.set(setting, parameter, default));
            }
            (Key::Char(letter), None) if letter != ' ' => {
                self.fault = None;
                self.typed = Some(letter.to_string());
            }
            _ => {}
        }
        Turn::Stay
    }

    fn go(&mut self, at: usize) {
        *self = Self { at, typed: None, fault: None };
    }

    fn nudge(&mut self, setting: &Setting, parameter: &Parameter, text: &str, up: bool, coarse: bool) -> Turn {
        match parameter.nudged(text, Nudge { up, coarse }) {
            Some(next) => self.set(setting, parameter, &next),
            None => {
                self.fault = Some(format!("no further; {}", parameter.domain()));
                Turn::Stay
            }
        }
    }

    fn set(&mut self, setting: &Setting, parameter: &Parameter, text: &str) -> Turn {
        match setting.clone().with(&[(parameter.name.to_owned(), text.to_owned())]) {
            Ok(setting) => {
                self.fault = None;
                Turn::Set(setting)
            }
            Err(fault) => {
                self.fault = Some(fault.to_string());
                Turn::Stay
            }
        }
    }

    /// The panel in at most so many rows: the parameters around the chosen one, and what it may be.
    pub fn rows(&self, setting: &Setting, width: usize, most: usize) -> Vec<Row> {
        let entries = entries(setting);
        let at = self.at.min(entries.len().saturating_sub(1));
        let mut page = Page::new(width, true);
        if let Some(fault) = &self.fault {
            page.line(2, Tone::Bad, fault);
        } else if let Some((parameter, _)) = entries.get(at) {
            page.line(2, Tone::Dim, &parameter.domain());
        }
        let below = page.into_rows();
        let room = most.saturating_sub(below.len()).max(1).min(entries.len());
        let first = at.saturating_sub(room / 2).min(entries.len() - room);
        let mut page = Page::new(width, true);
        let names = entries.iter().map(|(parameter, _)| parameter.name.len()).max().unwrap_or(0);
        for (place, (parameter, text)) in entries.iter().enumerate().skip(first).take(room) {
            let is_at = place == at;
            let value = self.typed.as_ref().filter(|_| is_at).map_or(text.clone(), |typed| format!("{typed}▏"));
            let name = format!("{:<names$}", parameter.name);
            let says = format!("  {} {}", Phrase::parse(parameter.symbol), parameter.says);
            let (sign, tone) = if is_at { ("› ", Tone::Strong) } else { ("  ", Tone::Plain) };
            let value = format!("  {value:<10}");
            page.cut(0, &[(Tone::Strong, sign), (tone, &name), (Tone::Code, &value), (Tone::Dim, &says)]);
        }
        [page.into_rows(), below].concat()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn setting() -> Setting {
        let (_, step) = chapters::steps().find(|(_, step)| step.id == "brewster").unwrap();
        Setting::defaults(step.parameters())
    }

    fn typed(panel: &mut Panel, setting: &Setting, text: &str) -> Turn {
        text.chars().for_each(|letter| assert_eq!(panel.press(Key::Char(letter), setting), Turn::Stay));
        panel.press(Key::Enter, setting)
    }

    #[test]
    fn values_are_turned_typed_and_put_back() {
        let (mut panel, start) = (Panel::default(), setting());
        let (parameter, text) = entries(&start)[0].clone();
        let Turn::Set(turned) = panel.press(Key::Right { shift: false }, &start) else { panic!("not turned") };
        assert_ne!(turned.text(parameter.name), text);
        let Turn::Set(back) = panel.press(Key::Left { shift: false }, &turned) else { panic!("not turned back") };
        assert_eq!(back, start);
        panel.press(Key::Down, &start);
        let second = entries(&start)[1].0;
        let Turn::Set(typed) = typed(&mut panel, &start, "2.4") else { panic!("not set") };
        assert_eq!(typed.text(second.name), "2.4");
        let Turn::Set(reset) = panel.press(Key::Backspace, &typed) else { panic!("not put back") };
        assert_eq!(reset, start);
        assert_eq!(panel.press(Key::Escape, &reset), Turn::Close);
    }

    #[test]
    fn what_is_out_of_its_domain_is_told_the_range() {
        let (mut panel, setting) = (Panel::default(), setting());
        assert_eq!(typed(&mut panel, &setting, "-7"), Turn::Stay);
        let text: String = panel.rows(&setting, 76, 9).iter().map(|row| row.text() + "\n").collect();
        assert!(text.contains("valid") || text.contains("to"), "{text}");
        assert!(panel.fault.is_some());
        // The next key that is right takes the message away.
        panel.press(Key::Down, &setting);
        assert!(panel.fault.is_none());
    }
}
