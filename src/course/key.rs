//! Keys by which records are known.

use std::cmp::Ordering;
use std::fmt;
use std::fmt::Write;
use std::hash::{Hash, Hasher};
use std::marker::PhantomData;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The random bytes of a key: two of them agree once in 10^19 pairs.
const BYTES: usize = 16;

/// A random name of a record of one kind. It says nothing of what it stands for, so it may stand in an address, in a log, or beside an
/// answer whose author is forgotten.
///
/// ```
/// use momentous_course::{Course, Key};
/// let key: Key<Course> = Key::new([7; 16]);
/// assert_eq!(key.to_string(), "07070707070707070707070707070707");
/// assert_eq!(key.to_string().parse(), Ok(key));
/// assert!("07".parse::<Key<Course>>().is_err());
/// ```
pub struct Key<Of> {
    bytes: [u8; BYTES],
    of: PhantomData<fn() -> Of>,
}

impl<Of> Key<Of> {
    /// The key with these bytes, which are drawn at random.
    #[must_use]
    pub fn new(bytes: [u8; BYTES]) -> Self {
        Self { bytes, of: PhantomData }
    }
}

/// A text that is no key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a key has 32 hexadecimal digits")]
pub struct NoKey;

impl<Of> FromStr for Key<Of> {
    type Err = NoKey;

    fn from_str(text: &str) -> Result<Self, NoKey> {
        if text.len() != 2 * BYTES || !text.bytes().all(|digit| matches!(digit, b'0'..=b'9' | b'a'..=b'f')) {
            return Err(NoKey);
        }
        let number = u128::from_str_radix(text, 16).map_err(|_| NoKey)?;
        Ok(Self::new(number.to_be_bytes()))
    }
}

impl<Of> fmt::Display for Key<Of> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = self.bytes.iter().fold(String::with_capacity(2 * BYTES), |mut digits, byte| {
            // Writing to a string cannot fail.
            let _ = write!(digits, "{byte:02x}");
            digits
        });
        out.pad(&digits)
    }
}

impl<Of> fmt::Debug for Key<Of> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "Key({self})")
    }
}

// Written out, because a key can be copied and compared whatever it is the key of.
impl<Of> Clone for Key<Of> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Of> Copy for Key<Of> {}

impl<Of> PartialEq for Key<Of> {
    fn eq(&self, other: &Self) -> bool {
        self.bytes == other.bytes
    }
}

impl<Of> Eq for Key<Of> {}

impl<Of> PartialOrd for Key<Of> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<Of> Ord for Key<Of> {
    fn cmp(&self, other: &Self) -> Ordering {
        self.bytes.cmp(&other.bytes)
    }
}

impl<Of> Hash for Key<Of> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.bytes.hash(state);
    }
}

impl<Of> Serialize for Key<Of> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, Of> Deserialize<'de> for Key<Of> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        text.parse().map_err(serde::de::Error::custom)
    }
}
