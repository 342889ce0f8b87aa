//! The table `stages.txt`: how random scenes are drawn.

use std::collections::BTreeMap;

/// All rows.
pub struct Table {
    /// Each kind of value with its unit and the numbers that it may have.
    values: BTreeMap<String, (String, Vec<String>)>,
    /// Each name that scenes use, with its kind of value.
    names: BTreeMap<String, String>,
    /// The units of what is asked: how a name begins, and the unit.
    units: Vec<(String, String)>,
    /// The kinds of stage.
    pub stages: Vec<Kind>,
}

/// A kind of stage.
pub struct Kind {
    /// Its key in a problem file.
    pub name: String,
    /// Each key with the ways to write it. Behind a hyphen stands which of several selections of ways it is: `until-rest`.
    pub keys: BTreeMap<String, Vec<String>>,
    /// The sets of keys that belong together.
    pub shapes: Vec<Shape>,
    /// The names that it may make known.
    pub finds: Vec<String>,
    /// Whether what can be asked of every scene is asked of it: not where all bodies begin and end at rest.
    pub asks_generally: bool,
}

/// Keys that belong together.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The axes in which it stands.
    pub axes: Vec<String>,
    /// The keys that it needs.
    pub needed: Vec<String>,
    /// The keys that it may have.
    pub further: Vec<String>,
    /// What is given at its ends: names, each with its kind of value.
    pub given: Vec<(String, String)>,
    /// Further words: `bare`, where no velocities are given; `positions`; `tied`, where only the first body's velocity is; `guided`.
    pub words: Vec<String>,
}

impl Table {
    /// The table as it stands.
    pub fn read() -> Self {
        let mut table = Self { values: BTreeMap::new(), names: BTreeMap::new(), units: Vec::new(), stages: Vec::new() };
        for line in include_str!("stages.txt").lines() {
            let line = line.trim_start();
            let Some((word, rest)) = line.split_once(' ').filter(|_| !line.starts_with('#')) else { continue };
            match word {
                "value" => {
                    let (name, rest) = rest.split_once(": ").unwrap();
                    let (unit, numbers) = rest.split_once(';').unwrap();
                    let numbers = numbers.split_whitespace().map(str::to_owned).collect();
                    table.values.insert(name.to_owned(), (unit.trim().to_owned(), numbers));
                }
                "name" => {
                    let pairs = rest.split_whitespace().map(pair);
                    table.names.extend(pairs);
                }
                "unit" => {
                    let (name, unit) = rest.split_once(": ").unwrap();
                    table.units.push((name.to_owned(), unit.to_owned()));
                }
                "stage" => table.stages.push(Kind {
                    name: rest.to_owned(),
                    keys: BTreeMap::new(),
                    shapes: Vec::new(),
                    finds: Vec::new(),
                    asks_generally: true,
                }),
                _ => table.stages.last_mut().unwrap().add(word, rest),
            }
        }
        table
    }

    /// The kind of stage of that name.
    pub fn kind(&self, name: &str) -> &Kind {
        self.stages.iter().find(|kind| kind.name == name).unwrap()
    }

    /// The kind of value of a name that scenes use.
    pub fn kind_of(&self, name: &str) -> Option<&str> {
        self.names.get(name).map(String::as_str)
    }

    /// The numbers of a kind of value, and their unit.
    pub fn values(&self, kind: &str) -> (&str, &[String]) {
        let (unit, numbers) = self.values.get(kind).unwrap_or_else(|| panic!("no row `value {kind}`"));
        (unit, numbers)
    }

    /// The unit in which a quantity is asked for.
    pub fn unit(&self, name: &str) -> &str {
        self.unit_of(name).unwrap_or_else(|| panic!("no row `unit` for {name}"))
    }

    /// The unit of a quantity, where the table has a row for it.
    pub fn unit_of(&self, name: &str) -> Option<&str> {
        if let Some(kind) = self.kind_of(name) {
            return Some(self.values(kind).0);
        }
        let fits = |row: &str| row.strip_suffix('!').map_or_else(|| name.starts_with(row), |whole| name == whole);
        self.units.iter().find(|(row, _)| fits(row)).map(|(_, unit)| unit.as_str())
    }
}

impl Kind {
    fn add(&mut self, word: &str, rest: &str) {
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        match word {
            "key" => {
                let (name, ways) = rest.split_once(": ").unwrap();
                self.keys.insert(name.to_owned(), ways.split(" | ").map(|way| way.trim().to_owned()).collect());
            }
            "shape" => {
                let (axes, rest) = rest.split_once(':').unwrap();
                let mut fields = rest.split('|');
                let needed = words(fields.next().unwrap());
                let further = fields.next().map(words).unwrap_or_default();
                let rest: Vec<String> = fields.flat_map(words).collect();
                let (given, words): (Vec<String>, Vec<String>) = rest.into_iter().partition(|word| word.contains('='));
                let given = given.iter().map(|text| pair(text)).collect();
                let axes = axes.split(',').map(str::to_owned).collect();
                self.shapes.push(Shape { axes, needed, further, given, words });
            }
            "find:" => self.finds = words(rest),
            "asks:" => self.asks_generally = false,
            _ => panic!("a row begins with {word}"),
        }
    }
}

fn pair(text: &str) -> (String, String) {
    let (name, kind) = text.split_once('=').unwrap();
    (name.to_owned(), kind.to_owned())
}

/// The key of a problem file behind a key of the table.
pub fn plain(key: &str) -> &str {
    key.split('-').next().unwrap_or(key)
}
