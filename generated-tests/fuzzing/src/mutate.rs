//! Makes new inputs by random changes of the inputs in a corpus.

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Largest length of an input in bytes. Longer inputs are cut off.
const LONGEST: usize = 16 << 10;

/// The parts of an input, in order: words, numbers, white space and single signs. Together they are the whole input.
type Tokens = Vec<Vec<u8>>;

/// Source of inputs, made from a corpus and from words that are meaningful to the tested code.
#[derive(Debug)]
pub struct Mutator {
    inputs: BoxedStrategy<Vec<u8>>,
    runner: TestRunner,
}

impl Mutator {
    /// Creates a source of inputs. It inserts the tokens `words` and the tokens of the corpus. Two sources with equal
    /// seeds give equal inputs.
    #[must_use]
    pub fn new(corpus: Vec<Vec<u8>>, words: &[&str], seed: u64) -> Self {
        let corpus: Vec<Tokens> = corpus.iter().map(|input| tokens(input)).collect();
        let mut words: Tokens = words
            .iter()
            .map(|word| word.as_bytes().to_vec())
            .chain(corpus.iter().flatten().cloned())
            .collect();
        words.sort();
        words.dedup();
        let mut bytes = [0; 32];
        for (byte, of_seed) in bytes.iter_mut().zip(seed.to_le_bytes()) {
            *byte = of_seed;
        }
        let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
        Self {
            inputs: mutated(corpus, words).boxed(),
            runner: TestRunner::new_with_rng(Config::default(), rng),
        }
    }

    /// Returns the next input: an input of the corpus with a few random changes.
    pub fn input(&mut self) -> Vec<u8> {
        let tree = self.inputs.new_tree(&mut self.runner);
        tree.map(|tree| tree.current()).unwrap_or_default()
    }
}

/// Returns a strategy for inputs of the corpus with changes. A change replaces a run of tokens, which is often empty,
/// by other tokens.
fn mutated(corpus: Vec<Tokens>, words: Tokens) -> impl Strategy<Value = Vec<u8>> {
    let number = prop_oneof![
        any::<f64>().prop_map(|number| format!("{number:e}")),
        (-320..320).prop_map(|exponent: i32| format!("1e{exponent}")),
        (0..300).prop_map(|whole: i32| whole.to_string()),
        (0.0..1.0).prop_map(|share: f64| share.to_string()),
    ];
    let token = prop_oneof![
        9 => select(words.clone()),
        2 => number.prop_map(String::into_bytes),
        1 => any::<char>().prop_map(|letter| letter.to_string().into_bytes()),
        1 => any::<u8>().prop_map(|byte| vec![byte]),
    ];
    let elsewhere = (select(corpus.clone()), any::<Index>(), 0..24_usize);
    let stretch = elsewhere.prop_map(|(input, at, length)| {
        let at = at.index(input.len() + 1);
        input.into_iter().skip(at).take(length).collect::<Tokens>()
    });
    let deep = (select(words), 1..4000_usize).prop_map(|(word, times)| vec![word; times]);
    let piece = prop_oneof![40 => vec(token, 0..3), 10 => stretch, 1 => deep];
    let length = prop_oneof![6 => 0..3_usize, 1 => 0..24_usize];
    let changes = vec((any::<Index>(), length, piece), 1..7);
    (select(corpus), changes).prop_map(|(mut input, changes)| {
        for (at, length, piece) in changes {
            let at = at.index(input.len() + 1);
            let end = (at + length).min(input.len());
            input.splice(at..end, piece);
        }
        let mut bytes = input.concat();
        bytes.truncate(LONGEST);
        bytes
    })
}

fn tokens(input: &[u8]) -> Tokens {
    let pieces = input.chunk_by(|a, b| {
        let kind = |byte: &u8| match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'_' | b'.' | 128.. => 1,
            b' ' | b'\t' | b'\n' | b'\r' => 2,
            _ => 0,
        };
        kind(a) == kind(b) && kind(a) != 0
    });
    pieces.map(<[u8]>::to_vec).collect()
}
