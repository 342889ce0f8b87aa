//! Fenced code blocks of a Markdown file.

/// A fenced block.
pub struct Block {
    /// The word after the fence.
    pub language: String,
    /// The line of the file at which the fence opens, from 1.
    pub line: usize,
    /// What stands between the fences, each line with its end.
    pub text: String,
}

/// The fenced blocks of a Markdown text, in order.
pub fn blocks(markdown: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for (line, written) in (1..).zip(markdown.lines()) {
        match (written.strip_prefix("```"), &mut open) {
            (Some(language), None) => {
                open = Some(Block { language: language.trim().to_owned(), line, text: String::new() });
            }
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (None, Some(block)) => {
                block.text.push_str(written);
                block.text.push('\n');
            }
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a fence is not closed");
    blocks
}
