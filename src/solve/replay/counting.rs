//! The first integer for which a condition holds.

/// How far counting goes.
const BUDGET: i64 = 10_000_000;

/// Integers that are tried one by one, before the condition is taken to hold for ever once it holds.
const ONE_BY_ONE: i64 = 64;

/// Counts up from `from`. The first few integers are tried one by one; beyond them the condition is taken to be
/// monotone, and the place where it begins to hold is found by doubling strides and halving. The condition has then
/// been tried at the result, where it holds, and just below it, where it does not.
/// `None` where it does not hold within ten million steps.
pub(super) fn first_integer(from: i64, mut holds: impl FnMut(i64) -> bool) -> Option<i64> {
    let last = from.checked_add(BUDGET)?;
    let near = from.checked_add(ONE_BY_ONE)?;
    if let Some(integer) = (from..near).find(|candidate| holds(*candidate)) {
        return Some(integer);
    }
    let mut fails = near - 1;
    let mut stride = ONE_BY_ONE;
    let mut holding = loop {
        let candidate = fails.saturating_add(stride).min(last);
        if holds(candidate) {
            break candidate;
        }
        if candidate == last {
            return None;
        }
        fails = candidate;
        stride *= 2;
    };
    while holding - fails > 1 {
        let middle = fails + (holding - fails) / 2;
        if holds(middle) { holding = middle } else { fails = middle }
    }
    Some(holding)
}

#[cfg(test)]
mod tests {
    use super::first_integer;

    #[test]
    fn the_boundary_is_found_exactly() {
        for target in [-3_i64, 0, 1, 63, 64, 65, 1000, 999_983, 9_999_990] {
            assert_eq!(first_integer(-5, |n| n >= target), Some(target.max(-5)));
        }
        assert_eq!(first_integer(0, |_| false), None);
    }
}
