//! The table of costs as comma-separated values.

use std::io::Write;

use crate::simulate::least::Cost;

use super::super::failure::Failure;

/// The table with a line of headings, three figures to a number: no measured time has more.
pub(super) fn write(costs: &[Cost], out: &mut Vec<u8>) -> Result<(), Failure> {
    writeln!(out, "class,method,setting,seconds,error,work")?;
    for cost in costs {
        let setting = cost.setting.map(|setting| format!("{setting:.2e}")).unwrap_or_default();
        let (class, method) = (cost.class.name(), cost.method.name());
        // An error is rounded up: a table must not promise more than was measured.
        writeln!(out, "{class},{method},{setting},{:.2e},{:.2e},{}", cost.seconds, cost.error * 1.005, cost.work)?;
    }
    Ok(())
}
