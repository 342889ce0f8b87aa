//! Words of `momentous check` on simulations: of each form, and of all.

use std::io::Write;

use crate::bank::Audit;
use crate::bank::FormAudit;
use crate::witness::Simulated;

use super::failure::Failure;
use super::output::Output;

/// Writes how a form was simulated, how closely that agrees, and which answers it would find out if they were wrong.
pub(super) fn write_form(output: &mut Output, simulated: &Simulated) -> Result<(), Failure> {
    if simulated.compared == 0 {
        return Ok(());
    }
    let Simulated { seeds, ways, compared, apart, bound, witnessed, unseen, .. } = simulated;
    let how = match &ways[..] {
        [] => format!("nothing needed simulating: {seeds} seeds by formulas of its own"),
        ways => format!("simulated: {seeds} seeds by {}", ways.join(", ")),
    };
    writeln!(output, "    {how}; {compared} comparisons, at most {apart:.0e} apart, and no bound above {bound:.0e}")?;
    if !witnessed.is_empty() {
        writeln!(output, "    a 0.1 % error would be detected in: {}", witnessed.join(", "))?;
    }
    if !unseen.is_empty() {
        writeln!(output, "    not detected: {}", unseen.join(", "))?;
    }
    Ok(())
}

/// Writes the share of the forms with an answer that no simulation witnesses, each with its reason.
pub(super) fn write_share(output: &mut Output, audits: &[Audit], simulated: u64) -> Result<(), Failure> {
    let all: Vec<(&Audit, &FormAudit)> =
        audits.iter().flat_map(|audit| audit.forms.iter().map(move |form| (audit, form))).collect();
    if all.is_empty() {
        return Ok(());
    }
    let idle: Vec<_> = all.iter().filter(|(_, form)| !form.simulation.is_whole()).collect();
    #[allow(clippy::cast_precision_loss)] // counts of forms are far below 2^53
    let share = 100.0 * idle.len() as f64 / all.len() as f64;
    writeln!(
        output,
        "simulated on the first {simulated} seeds; nothing to simulate for an answer in {share:.1} % of the forms"
    )?;
    for (audit, form) in idle {
        let name = form.form.as_deref().map_or_else(String::new, |name| format!(", {name}"));
        let what = if form.simulation.unseen.is_empty() {
            "its answers".to_owned()
        } else {
            form.simulation.unseen.join(", ")
        };
        let why = form.simulation.nothing.unwrap_or("nothing was drawn");
        writeln!(output, "  {}{name}: {what}: {why}", audit.problem.as_deref().unwrap_or(&audit.file))?;
    }
    Ok(())
}
