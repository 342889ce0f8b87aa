//! One function over many items, on every core where the feature `parallel` allows it.

/// The results of a function for each item, in the order of the items.
#[cfg(feature = "parallel")]
pub(super) fn each<T: Send, R: Send>(items: Vec<T>, function: impl Fn(T) -> R + Send + Sync) -> Vec<R> {
    use rayon::prelude::*;
    items.into_par_iter().map(function).collect()
}

/// Returns the results of the function for each item, in the order of the items.
#[cfg(not(feature = "parallel"))]
pub(super) fn each<T, R>(items: Vec<T>, function: impl Fn(T) -> R) -> Vec<R> {
    items.into_iter().map(function).collect()
}
