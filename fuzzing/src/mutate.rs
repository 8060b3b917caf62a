//! Inputs made from others.

use crate::Random;

/// No input grows beyond this.
const LONGEST: usize = 16 << 10;

/// Makes inputs from a corpus and words that mean something to what is tested.
#[derive(Clone, Debug)]
pub struct Mutator {
    corpus: Vec<Vec<u8>>,
    words: Vec<Vec<u8>>,
    random: Random,
}

impl Mutator {
    /// `words` are tokens to put in; the corpus's own come in as well.
    #[must_use]
    pub fn new(corpus: Vec<Vec<u8>>, words: &[&str], seed: u64) -> Self {
        let own = corpus
            .iter()
            .flat_map(|input| tokens(input))
            .map(<[u8]>::to_vec);
        let mut words: Vec<Vec<u8>> = words
            .iter()
            .map(|word| word.as_bytes().to_vec())
            .chain(own)
            .collect();
        words.sort();
        words.dedup();
        Self {
            corpus,
            words,
            random: Random(seed),
        }
    }

    /// The next input: one of the corpus with a few changes.
    pub fn input(&mut self) -> Vec<u8> {
        let mut input = self.random.pick(&self.corpus).cloned().unwrap_or_default();
        for _ in 0..=self.random.below(6) {
            input = if self.random.once_in(3) {
                self.changed_bytes(input)
            } else {
                self.changed_tokens(&input)
            };
            input.truncate(LONGEST);
        }
        input
    }

    fn changed_bytes(&mut self, mut input: Vec<u8>) -> Vec<u8> {
        let at = self.random.below(input.len() + 1);
        match self.random.below(7) {
            0 => {
                if let Some(byte) = input.get_mut(at) {
                    *byte ^= 1 << self.random.below(8);
                }
            }
            1 => input.insert(at, self.random.bits() as u8),
            2 => {
                let letter = [
                    "é", "μ", "₁", "\u{202e}", "\u{feff}", "\0", "🙂", "\r", "\u{2028}",
                ];
                let letter = self.random.pick(&letter).copied().unwrap_or("é");
                input.splice(at..at, letter.bytes());
            }
            3 => input.truncate(at),
            4 => {
                let end = (at + self.random.below(40)).min(input.len());
                input.drain(at..end);
            }
            5 => {
                let end = (at + self.random.below(200)).min(input.len());
                let piece: Vec<u8> = input.get(at..end).unwrap_or_default().to_vec();
                input.splice(at..at, piece);
            }
            _ => {
                let other = self.random.pick(&self.corpus).cloned().unwrap_or_default();
                let from = self.random.below(other.len() + 1);
                input.truncate(at);
                input.extend(other.get(from..).unwrap_or_default());
            }
        }
        input
    }

    fn changed_tokens(&mut self, input: &[u8]) -> Vec<u8> {
        let mut tokens: Vec<Vec<u8>> = tokens(input).map(<[u8]>::to_vec).collect();
        let at = self.random.below(tokens.len() + 1);
        match self.random.below(9) {
            0 | 1 => {
                let word = self.word();
                tokens.insert(at, word);
            }
            2 | 3 => {
                let word = self.word();
                if let Some(token) = tokens.get_mut(at) {
                    *token = word;
                }
            }
            4 => {
                if at < tokens.len() {
                    tokens.remove(at);
                }
            }
            5 => {
                let other = self.random.below(tokens.len());
                if at < tokens.len() {
                    tokens.swap(at, other);
                }
            }
            6 => {
                // A stretch again, elsewhere.
                let end = (at + self.random.below(24)).min(tokens.len());
                let piece = tokens.get(at..end).unwrap_or_default().to_vec();
                let place = self.random.below(tokens.len() + 1);
                tokens.splice(place..place, piece);
            }
            7 if self.random.once_in(8) => {
                // Deep or long.
                let word = tokens.get(at).cloned().unwrap_or_else(|| b"(".to_vec());
                let times = 1 + self.random.below(4000);
                tokens.splice(at..at, std::iter::repeat_n(word, times));
            }
            _ => {
                let number = self.number();
                let digits: Vec<usize> = (0..tokens.len())
                    .filter(|at| {
                        tokens
                            .get(*at)
                            .is_some_and(|t| t.first().is_some_and(u8::is_ascii_digit))
                    })
                    .collect();
                if let Some(token) = self.random.pick(&digits).and_then(|at| tokens.get_mut(*at)) {
                    *token = number;
                }
            }
        }
        tokens.concat()
    }

    fn word(&mut self) -> Vec<u8> {
        self.random.pick(&self.words).cloned().unwrap_or_default()
    }

    fn number(&mut self) -> Vec<u8> {
        match self.random.below(4) {
            0 => format!("{:e}", f64::from_bits(self.random.bits()).abs()),
            1 => format!("1e{}", self.random.below(640) as i64 - 320),
            2 => format!("{}", self.random.below(300)),
            _ => format!("{}", self.random.unit()),
        }
        .into_bytes()
    }
}

/// Words, numbers, white space and single signs, in order and with nothing left out.
fn tokens(input: &[u8]) -> impl Iterator<Item = &[u8]> {
    input.chunk_by(|a, b| {
        let kind = |byte: &u8| match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'_' | b'.' | 128.. => 1,
            b' ' | b'\t' | b'\n' | b'\r' => 2,
            _ => 0,
        };
        kind(a) == kind(b) && kind(a) != 0
    })
}
