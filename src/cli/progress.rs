//! A bar that shows how far the work is, on a terminal only.

use std::io::IsTerminal;

use indicatif::ProgressBar;
use indicatif::ProgressStyle;

/// A bar for so many pieces of work, gone when it is dropped. It does not show while results scroll over the same terminal.
pub(super) fn bar(pieces: u64, results_scroll: bool) -> ProgressBar {
    if pieces < 2 || !std::io::stderr().is_terminal() || (results_scroll && std::io::stdout().is_terminal()) {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {human_pos} of {human_len}, {eta} left");
    ProgressBar::new(pieces).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
