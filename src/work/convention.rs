//! Lines that say which direction counts as positive.

use super::judge::Judge;

impl Judge<'_> {
    /// Takes a line such as `take left as positive`; whether it was one.
    pub(crate) fn turn(&mut self, text: &str) -> bool {
        let words = text.to_lowercase();
        let is_convention = words.contains("positive") && !words.contains(['=', '<', '>']);
        if !is_convention {
            return false;
        }
        let model = self.worked.problem.model();
        let (mut turned, mut is_said) = (Vec::new(), false);
        for (symbol, _) in model.symbols.iter() {
            let Some(senses) = self.worked.problem.senses(symbol) else { continue };
            let names = |phrase: &str| {
                let last = phrase.rfind(' ').map_or(phrase, |space| &phrase[space + 1..]);
                let last = last.trim_end_matches("wards").trim_end_matches("ward");
                words
                    .split(|sign: char| !sign.is_alphanumeric())
                    .any(|word| word.trim_end_matches("wards").trim_end_matches("ward") == last)
            };
            is_said |= names(&senses.positive) || names(&senses.negative);
            if names(&senses.negative) && !names(&senses.positive) {
                turned.push(symbol);
            }
        }
        if is_said {
            self.turned = turned;
        }
        is_said
    }
}
