//! What happens to the reader, whichever library saw it.

use super::work::Finished;

/// A key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// A letter, a digit, a sign, a space.
    Char(char),
    /// Enter.
    Enter,
    /// Escape.
    Escape,
    /// Backspace.
    Backspace,
    /// The tabulator.
    Tab,
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Arrow to the left, with shift or without.
    Left { shift: bool },
    /// Arrow to the right, with shift or without.
    Right { shift: bool },
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
    /// Home.
    Home,
    /// End.
    End,
    /// Ctrl-C or Ctrl-D.
    Interrupt,
}

/// Something that happened.
#[derive(Debug)]
pub enum Event {
    /// A key was pressed.
    Key(Key),
    /// The wheel was turned, by so many notches downwards.
    Wheel(isize),
    /// The terminal has so many columns and rows.
    Resize(usize, usize),
    /// Some work is done, or part of it.
    Done(Finished),
    /// Nobody can press keys any more.
    Gone,
}
