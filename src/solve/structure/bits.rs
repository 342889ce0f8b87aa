//! A small set of indexes.

/// The number of words that stand in the set itself.
const NEAR: usize = 2;

/// A set of indexes below a capacity that is fixed when it is made. The search makes very many of them, so the words of the
/// usual capacity stand in the set itself, and only those of a larger one are allocated.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Bits {
    near: [u64; NEAR],
    /// `None` where the capacity needs no more.
    far: Option<Box<[u64]>>,
}

impl Bits {
    /// The empty set, for indexes below `capacity`.
    pub(crate) fn empty(capacity: usize) -> Self {
        let beyond = capacity.div_ceil(64).saturating_sub(NEAR);
        Self { near: [0; NEAR], far: (beyond > 0).then(|| vec![0; beyond].into()) }
    }

    /// The set whose words are made of those of both.
    #[inline]
    fn zip(&mut self, other: &Self, word: impl Fn(u64, u64) -> u64) {
        self.near.iter_mut().zip(&other.near).for_each(|(bits, other)| *bits = word(*bits, *other));
        if let (Some(far), Some(other)) = (&mut self.far, &other.far) {
            far.iter_mut().zip(other).for_each(|(bits, other)| *bits = word(*bits, *other));
        }
    }

    /// Whether some word of this set and that of the other pass the test.
    #[inline]
    fn any(&self, other: &Self, test: impl Fn(u64, u64) -> bool) -> bool {
        let pass = |(bits, other): (&u64, &u64)| test(*bits, *other);
        let far = || self.far.iter().flatten().zip(other.far.iter().flatten()).any(pass);
        self.near.iter().zip(&other.near).any(pass) || self.far.is_some() && far()
    }

    fn word_mut(&mut self, place: usize) -> Option<&mut u64> {
        if place < NEAR { self.near.get_mut(place) } else { self.far.as_mut()?.get_mut(place - NEAR) }
    }

    #[inline]
    fn word(&self, place: usize) -> Option<u64> {
        if place < NEAR { self.near.get(place) } else { self.far.as_ref()?.get(place - NEAR) }.copied()
    }

    /// The set of these indexes, each below `capacity`.
    pub(crate) fn of(capacity: usize, indexes: impl IntoIterator<Item = usize>) -> Self {
        let mut set = Self::empty(capacity);
        for index in indexes {
            set.insert(index);
        }
        set
    }

    /// Puts an index in; one that is beyond the capacity is ignored.
    pub(crate) fn insert(&mut self, index: usize) {
        if let Some(word) = self.word_mut(index / 64) {
            *word |= 1 << (index % 64);
        }
    }

    /// Whether the index is in the set.
    pub(crate) fn contains(&self, index: usize) -> bool {
        self.word(index / 64).is_some_and(|word| word & (1 << (index % 64)) != 0)
    }

    /// The indexes, ascending.
    #[inline]
    pub(crate) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        let (mut place, mut rest) = (0, self.near[0]);
        std::iter::from_fn(move || {
            while rest == 0 {
                place += 1;
                rest = self.word(place)?;
            }
            let bit = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            Some(place * 64 + bit)
        })
    }

    /// Everything of the other set is put in.
    #[inline]
    pub(crate) fn join(&mut self, other: &Self) {
        self.zip(other, |bits, other| bits | other);
    }

    /// Everything of the other set is taken out.
    #[inline]
    pub(crate) fn subtract(&mut self, other: &Self) {
        self.zip(other, |bits, other| bits & !other);
    }

    /// Everything that is not in the other set is taken out.
    #[inline]
    pub(crate) fn keep(&mut self, other: &Self) {
        self.zip(other, |bits, other| bits & other);
    }

    /// Whether the sets share an index.
    #[inline]
    pub(crate) fn meets(&self, other: &Self) -> bool {
        self.any(other, |bits, other| bits & other != 0)
    }

    /// Whether everything of the other set is in this one.
    #[inline]
    pub(crate) fn covers(&self, other: &Self) -> bool {
        !self.any(other, |bits, other| other & !bits != 0)
    }

    /// Whether nothing is in the set.
    pub(crate) fn is_empty(&self) -> bool {
        self.near == [0; NEAR] && self.far.iter().flatten().all(|word| *word == 0)
    }

    /// The number of indexes that are in the set.
    pub(crate) fn len(&self) -> usize {
        let count = |words: &[u64]| words.iter().map(|word| word.count_ones() as usize).sum::<usize>();
        count(&self.near) + self.far.as_deref().map_or(0, count)
    }
}
