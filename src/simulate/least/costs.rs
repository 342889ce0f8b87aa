//! Costs of each method at each setting, and its accuracy: a committed table, remade by a command, so that no choice depends on
//! what a machine is doing at the moment.

use std::sync::OnceLock;

use crate::methods::MethodKind;

use super::class::Class;

/// The committed table.
const TABLE: &str = include_str!("costs.csv");

/// A row: a method at a setting, over all reference tasks of a class.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// The class.
    pub class: Class,
    /// The method.
    pub method: MethodKind,
    /// A tolerance, or a step as a part of the run; nothing where the method has no setting.
    pub setting: Option<f64>,
    /// The longest time of a solve among the tasks, in s.
    pub seconds: f64,
    /// The greatest relative error.
    pub error: f64,
    /// The work of the greatest of the tasks at that setting, counted in bodies, contacts and steps.
    pub work: f64,
}

/// The committed table, in which a row that cannot be read is left out; a test shows that there is none.
pub fn costs() -> &'static [Cost] {
    static COSTS: OnceLock<Vec<Cost>> = OnceLock::new();
    COSTS.get_or_init(|| TABLE.lines().skip(1).filter_map(read).collect())
}

fn read(line: &str) -> Option<Cost> {
    let [class, method, setting, seconds, error, work] = line.split(',').collect::<Vec<_>>().try_into().ok()?;
    let setting: Option<f64> = if setting.is_empty() { None } else { Some(setting.parse().ok()?) };
    Some(Cost {
        class: Class::ALL.into_iter().find(|known| known.name() == class)?,
        method: MethodKind::ALL.iter().copied().find(|kind| kind.name() == method)?,
        setting,
        seconds: seconds.parse().ok()?,
        error: error.parse().ok()?,
        work: work.parse().ok()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_of_the_table_is_read() {
        assert_eq!(costs().len(), TABLE.lines().count() - 1);
        for class in Class::ALL.into_iter().filter(|class| *class != Class::LawRequired) {
            assert!(costs().iter().any(|cost| cost.class == class), "{}", class.name());
        }
    }
}
