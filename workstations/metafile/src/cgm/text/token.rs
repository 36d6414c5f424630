//! The words, numbers and strings of clear text (ISO/IEC 8632-4, 5).

use gks_pipeline::record::SourceError;
use std::io::{ErrorKind, Read};

/// A piece of text between separators.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    /// Letters, digits and signs.
    Word(String),
    /// What stood between quotes.
    Text(Vec<u8>),
}

/// The longest word.
const LONGEST_WORD: usize = 1 << 12;

/// Octets one by one, with one to look ahead.
pub(super) struct Characters<R> {
    input: R,
    buffer: Vec<u8>,
    at: usize,
    offset: u64,
}

impl<R: Read> Characters<R> {
    pub(super) fn new(input: R) -> Self {
        Characters { input, buffer: Vec::new(), at: 0, offset: 0 }
    }

    pub(super) fn peek(&mut self) -> Result<Option<u8>, SourceError> {
        while self.at >= self.buffer.len() {
            self.offset += self.buffer.len() as u64;
            self.buffer.resize(1 << 14, 0);
            self.at = 0;
            match self.input.read(&mut self.buffer) {
                Ok(count) => {
                    self.buffer.truncate(count);
                    if count == 0 {
                        return Ok(None);
                    }
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => self.buffer.clear(),
                Err(error) => {
                    self.buffer.clear();
                    return Err(error.into());
                }
            }
        }
        Ok(self.buffer.get(self.at).copied())
    }

    pub(super) fn next(&mut self) -> Result<Option<u8>, SourceError> {
        let byte = self.peek()?;
        self.at += usize::from(byte.is_some());
        Ok(byte)
    }

    /// The tokens up to the end of an element; none at the end of the text.
    pub(super) fn element(&mut self) -> Result<Option<Vec<Token>>, SourceError> {
        let mut tokens = Vec::new();
        let mut word = String::new();
        loop {
            let Some(byte) = self.next()? else {
                end(&mut word, &mut tokens);
                return Ok((!tokens.is_empty()).then_some(tokens));
            };
            match byte {
                b';' | b'/' => {
                    end(&mut word, &mut tokens);
                    return Ok(Some(tokens));
                }
                b'%' => while !matches!(self.next()?, None | Some(b'%')) {},
                b'\'' | b'"' => {
                    end(&mut word, &mut tokens);
                    tokens.push(Token::Text(self.string(byte)?));
                }
                // They separate where numbers follow one another.
                b'(' | b')' | b',' | b' ' | b'\t' | b'\r' | b'\n' | 0 => end(&mut word, &mut tokens),
                // They are as good as nothing.
                b'_' | b'$' => {}
                _ if word.len() < LONGEST_WORD => word.push(char::from(byte).to_ascii_lowercase()),
                _ => {}
            }
        }
    }

    /// The characters up to the closing quote; a doubled quote stands for itself.
    fn string(&mut self, quote: u8) -> Result<Vec<u8>, SourceError> {
        let mut text = Vec::new();
        while let Some(byte) = self.next()? {
            if byte == quote {
                if self.peek()? != Some(quote) {
                    break;
                }
                self.next()?;
            }
            text.push(byte);
        }
        Ok(text)
    }
}

fn end(word: &mut String, tokens: &mut Vec<Token>) {
    if !word.is_empty() {
        tokens.push(Token::Word(std::mem::take(word)));
    }
}

/// An integer: decimal, or with a base of 2 to 16 before a `#`.
pub(super) fn integer(word: &str) -> Option<i64> {
    let (negative, digits) = match word.strip_prefix('-') {
        Some(digits) => (true, digits),
        None => (false, word.strip_prefix('+').unwrap_or(word)),
    };
    let magnitude = match digits.split_once('#') {
        Some((base, digits)) => {
            let base = base.parse().ok().filter(|base| (2..=16).contains(base))?;
            i64::from_str_radix(digits, base).ok()?
        }
        None => digits.parse().ok()?,
    };
    Some(if negative { -magnitude } else { magnitude })
}

/// A real number: decimal with or without point and exponent, or an integer.
pub(super) fn real(word: &str) -> Option<f64> {
    let plain = || word.parse().ok().filter(|x: &f64| x.is_finite());
    integer(word).map(|n| n as f64).or_else(plain)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_fall_into_tokens() {
        let text = b"% note ; % Line_Colr 1, (2.5,-3)\n 'it''s'; x";
        let mut characters = Characters::new(&text[..]);
        let word = |text: &str| Token::Word(text.to_owned());
        let first = vec![word("linecolr"), word("1"), word("2.5"), word("-3"), Token::Text(b"it's".to_vec())];
        assert_eq!(characters.element().unwrap(), Some(first));
        assert_eq!(characters.element().unwrap(), Some(vec![word("x")]));
        assert_eq!(characters.element().unwrap(), None);
    }

    #[test]
    fn numbers_in_any_base() {
        assert_eq!((integer("-16#7f"), integer("2#101"), integer("+12")), (Some(-127), Some(5), Some(12)));
        assert_eq!((integer("17#1"), integer("1.5"), integer("")), (None, None, None));
        assert_eq!((real("-.5e1"), real("8#10"), real("nan")), (Some(-5.0), Some(8.0), None));
    }
}
