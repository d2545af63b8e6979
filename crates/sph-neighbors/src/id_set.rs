//! A set of particles that gives them back in ascending order.

/// Bits of a word.
const WORD: usize = u64::BITS as usize;

/// Numbers below a limit, one bit each, with a bit above each word that holds any. A row of a hundred neighbours is ascending
/// after one visit of each, at a quarter of the cost of a sort.
#[derive(Clone, Debug)]
pub(crate) struct IdSet {
    words: Vec<u64>,
    /// Bit w says that `words[w]` is not empty.
    filled: Vec<u64>,
}

impl IdSet {
    /// An empty set of numbers below `limit`.
    pub fn new(limit: usize) -> Self {
        let words = limit.div_ceil(WORD);
        Self { words: vec![0; words], filled: vec![0; words.div_ceil(WORD)] }
    }

    /// Appends the numbers, which are all different, to `ascending` without `but`. The set is empty before and after.
    pub fn sort_into(&mut self, numbers: &[u32], but: u32, ascending: &mut Vec<u32>) {
        let (mut low, mut high) = (self.filled.len(), 0);
        for &number in numbers {
            let word = number as usize / WORD;
            self.words[word] |= 1 << (number as usize % WORD);
            let above = word / WORD;
            self.filled[above] |= 1 << (word % WORD);
            (low, high) = (low.min(above), high.max(above + 1));
        }
        let start = ascending.len();
        ascending.resize(start + numbers.len(), 0);
        let mut place = start;
        for above in low..high {
            for word in bits(std::mem::take(&mut self.filled[above])) {
                let word = above * WORD + word;
                for bit in bits(std::mem::take(&mut self.words[word])) {
                    let number = (word * WORD + bit) as u32;
                    ascending[place] = number;
                    place += usize::from(number != but);
                }
            }
        }
        ascending.truncate(place);
    }
}

/// The places of the bits that are set, ascending.
#[inline]
fn bits(mut word: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = word.trailing_zeros() as usize;
        word &= word.wrapping_sub(1);
        (bit < WORD).then_some(bit)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn numbers_come_back_in_order_without_the_one(numbers in prop::collection::hash_set(0..20_000_u32, 0..200), but in 0..20_000_u32) {
            let mut set = IdSet::new(20_000);
            let numbers: Vec<u32> = numbers.into_iter().collect();
            let but = numbers.first().copied().unwrap_or(but);
            let mut expected: Vec<u32> = numbers.iter().copied().filter(|&number| number != but).collect();
            expected.sort_unstable();
            for _ in 0..2 {
                let mut found = vec![7];
                set.sort_into(&numbers, but, &mut found);
                prop_assert_eq!(&found[1..], expected.as_slice());
            }
        }
    }

    #[test]
    fn the_first_and_the_last_number_fit() {
        for limit in [1, 64, 65, 4096, 4097] {
            let last = limit as u32 - 1;
            let mut found = Vec::new();
            IdSet::new(limit).sort_into(&[last], u32::MAX, &mut found);
            IdSet::new(limit).sort_into(&[0], last, &mut found);
            assert_eq!(found, if limit == 1 { vec![0] } else { vec![last, 0] });
        }
    }
}
