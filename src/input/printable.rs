//! Text from a file made safe for a terminal.

use std::borrow::Cow;

/// `text` with everything escaped that would steer a terminal, break a line or turn the direction of reading.
///
/// # Example
/// ```
/// use raytree::input::printable;
/// assert_eq!(printable("glass ball"), "glass ball");
/// assert_eq!(printable("red\u{1b}[31m"), "red\\u{1b}[31m");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.chars().any(steers) {
        return Cow::Borrowed(text);
    }
    let escaped = text.chars().map(|c| if steers(c) { c.escape_unicode().to_string() } else { c.to_string() });
    Cow::Owned(escaped.collect())
}

fn steers(c: char) -> bool {
    let reading = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || reading || c == '\u{feff}'
}
