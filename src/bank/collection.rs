//! A collection of problem files: those of the current folder, or those that are built in.

use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Source;
use momentous_fault::did_you_mean;

/// Path and text of every problem of this program's own bank.
const BUILT_IN: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/built_in_bank.rs"));

/// Problem files with their identities, in the order of these.
///
/// ```
/// use momentous_bank::Bank;
/// let bank = Bank::built_in();
/// assert!(bank.find("impact/two-carts").is_ok());
/// let faults = bank.find("impact/two-cart").unwrap_err();
/// assert_eq!(faults.list[0].help.as_deref(), Some("did you mean `impact/two-carts`?"));
/// ```
#[derive(Clone, Debug)]
pub struct Bank {
    pub(super) problems: Vec<(String, Source)>,
    is_built_in: bool,
}

impl Bank {
    /// The bank that is built into the program.
    #[must_use]
    pub fn built_in() -> Self {
        let sources = BUILT_IN.iter().map(|(path, text)| Source::new(path, text)).collect();
        Self { is_built_in: true, ..Self::of(sources) }
    }

    /// The bank of these files.
    #[must_use]
    pub fn of(sources: Vec<Source>) -> Self {
        let named = |source: Source| (declared_id(&source).unwrap_or_else(|| source.name.to_string()), source);
        let mut problems: Vec<(String, Source)> = sources.into_iter().map(named).collect();
        problems.sort_by(|left, right| (&left.0, &left.1.name).cmp(&(&right.0, &right.1.name)));
        Self { problems, is_built_in: false }
    }

    /// Whether it is the one that is built in.
    #[must_use]
    pub fn is_built_in(&self) -> bool {
        self.is_built_in
    }

    /// The identities, in order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.problems.iter().map(|(id, _)| id.as_str())
    }

    /// The identity that a problem has now which had this one before it was renamed.
    #[must_use]
    pub fn renamed(&self, before: &str) -> Option<&str> {
        let was = |source: &Source| declared(source, "was:").is_some_and(|was| was == before);
        self.problems.iter().find(|(_, source)| was(source)).map(|(id, _)| id.as_str())
    }

    /// The topics: what stands before the first slash of the identities, each once, in order.
    #[must_use]
    pub fn topics(&self) -> Vec<&str> {
        let mut topics: Vec<&str> = self.ids().map(topic_of).collect();
        topics.dedup();
        topics
    }

    /// The files, in the order of their identities.
    pub fn sources(&self) -> impl Iterator<Item = &Source> {
        self.problems.iter().map(|(_, source)| source)
    }

    /// The files of one topic, in the order of their identities.
    ///
    /// # Errors
    /// Where no problem is of that topic.
    pub fn topic(&self, topic: &str) -> Result<Vec<&Source>, Faults> {
        let sources: Vec<&Source> =
            self.problems.iter().filter(|(id, _)| topic_of(id) == topic).map(|(_, source)| source).collect();
        if sources.is_empty() {
            let topics = self.topics();
            let near = did_you_mean(topic, topics.iter().copied());
            let help = near.map_or_else(|| format!("topics are {}", topics.join(", ")), meant);
            return Err(unknown(topic, format!("no problem has the topic `{topic}`"), help));
        }
        Ok(sources)
    }

    /// The file of the problem with that identity.
    ///
    /// # Errors
    /// Where there is none; the nearest known identity is named.
    pub fn find(&self, id: &str) -> Result<&Source, Faults> {
        let entry = self.problems.iter().find(|(known, _)| known == id);
        entry.map(|(_, source)| source).ok_or_else(|| {
            let same_name = || self.ids().find(|known| name_of(known) == name_of(id));
            let near = did_you_mean(id, self.ids()).or_else(same_name);
            let help = || "`momentous list` shows every problem; a file is named by its path".to_owned();
            let help = near.map_or_else(help, meant);
            unknown(id, format!("there is no problem `{id}`"), help)
        })
    }
}

fn unknown(name: &str, message: String, help: String) -> Faults {
    Faults { source: Source::new(name, ""), list: vec![Fault::new(Code::UnknownName, message).help(help)] }
}

fn meant(name: &str) -> String {
    format!("did you mean `{name}`?")
}

/// The topic: the part before the first slash of an identity.
pub(super) fn topic_of(id: &str) -> &str {
    id.split('/').next().unwrap_or(id)
}

/// The name: the part behind the last slash of an identity.
fn name_of(id: &str) -> &str {
    id.rsplit('/').next().unwrap_or(id)
}

/// The identity that a file says it has, found without reading the rest of it: a bank may hold hundreds of files, and
/// most commands need one.
fn declared_id(source: &Source) -> Option<String> {
    declared(source, "id:")
}

/// The value of a key at the top of a file.
fn declared(source: &Source, key: &str) -> Option<String> {
    let value = source.text.lines().find_map(|line| line.strip_prefix(key))?;
    let value = value.split(" #").next().unwrap_or(value).trim().trim_matches(['"', '\'']);
    (!value.is_empty()).then(|| value.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_identity_is_found_without_reading_the_file() {
        let id = |text: &str| declared_id(&Source::new("a.yaml", text));
        assert_eq!(id("# id: not this\nid: impact/a # nor this\n").as_deref(), Some("impact/a"));
        assert_eq!(id("title: A\nid: \"b\"\n").as_deref(), Some("b"));
        assert_eq!(id("title: A\n  id: c\n"), None);
    }

    #[test]
    fn every_built_in_problem_is_found_by_its_identity_and_by_its_topic() {
        let bank = Bank::built_in();
        assert!(bank.ids().count() >= 14);
        for topic in bank.topics() {
            for source in bank.topic(topic).unwrap() {
                let id = declared_id(source).unwrap();
                assert_eq!(bank.find(&id).unwrap(), source);
            }
        }
    }

    #[test]
    fn a_name_that_means_nothing_is_told_with_the_nearest() {
        let bank = Bank::built_in();
        let help = |name: &str| bank.find(name).unwrap_err().list[0].help.clone().unwrap();
        assert_eq!(help("two-carts"), "did you mean `impact/two-carts`?");
        assert_eq!(help("zzz"), "`momentous list` shows every problem; a file is named by its path");
        assert_eq!(bank.topic("impakt").unwrap_err().list[0].help.as_deref(), Some("did you mean `impact`?"));
    }
}
