//! Short names that may mean several quantities: a line may mean whichever of them it holds with.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_model::Instant;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_problem::Worked;

use super::ground::Ground;
use super::spelling::letters;
use super::written::Alphabet;

/// A short name means no more quantities.
const MOST: usize = 6;

/// Other letters for quantities of a kind, by the letter that the problem has.
const LETTERS: [(&str, &[&str]); 14] = [
    ("T", &["K", "KE", "E", "E_k", "E_kin"]),
    ("T_rel", &["K_rel", "KE_rel", "E_rel"]),
    ("H", &["L"]),
    ("V", &["U", "PE", "E_p", "E_pot"]),
    ("flow", &["rate_m", "q", "m_rate"]),
    ("p_rate", &["rate_p"]),
    ("H_rate", &["rate_H", "rate_L"]),
    ("a", &["rate_v"]),
    ("areal_rate", &["rate_A"]),
    ("tension", &["T", "S", "F_T"]),
    ("dt", &["Delta_t", "t", "T"]),
    ("path", &["s", "d"]),
    ("I", &["J"]),
    ("angle", &["theta", "phi"]),
];

/// The letter that stands for nothing but an impulse.
const IMPULSE: &str = "J";

/// Greek letters and signs as they stand in the names of quantities.
const GREEK: [(&str, &str); 12] = [
    ("ω", "omega"),
    ("θ", "theta"),
    ("ϑ", "theta"),
    ("φ", "phi"),
    ("ϕ", "phi"),
    ("λ", "lambda"),
    ("μ", "mu"),
    ("ρ", "rho"),
    ("τ", "tau"),
    ("Δ", "Delta"),
    ("\\", " "),
    ("\u{20d7}", ""),
];

/// A short name, with what it may mean: what is likeliest stands first.
#[derive(Debug)]
struct Alias {
    name: String,
    terms: Vec<Expr>,
    /// The number of them that are told, asked or used for the answers.
    likely: usize,
    /// Whether the only one of these is asked.
    is_asked: bool,
}

impl Alias {
    /// Whether it is often used for something else: a letter alone, and one of several meanings.
    fn is_loose(&self) -> bool {
        let is_usual = self.likely == 1 && (self.is_asked || self.name == IMPULSE);
        letters(&self.name).chars().count() == 1 && !is_usual || self.terms.len() > 1 && self.likely != 1
    }
}

/// Short names by their letters alone.
#[derive(Debug, Default)]
pub(crate) struct Aliases(BTreeMap<String, Alias>);

impl Aliases {
    /// The quantities of a form under shorter names.
    pub(crate) fn of(worked: Worked<'_>) -> Self {
        let mut aliases = Self::default();
        aliases.of_quantities(worked);
        aliases.with_primes(worked);
        aliases
    }

    /// Takes in others, where the names are new.
    pub(crate) fn join(mut self, others: Self) -> Self {
        for (letters, alias) in others.0 {
            self.0.entry(letters).or_insert(alias);
        }
        self
    }

    /// The same, with what is told, asked or used for the answers before the rest.
    pub(crate) fn ranked(mut self, worked: Worked<'_>, ground: &Ground) -> Self {
        let mut likely: BTreeSet<Symbol> = ground.used_symbols();
        let wanted: BTreeSet<Symbol> = worked.form.wanted().collect();
        likely.extend(ground.told.iter().chain(&wanted));
        let is_unlikely = |term: &Expr| !term.symbols().iter().all(|symbol| likely.contains(symbol));
        for alias in self.0.values_mut() {
            alias.terms.sort_by_key(is_unlikely);
            alias.likely = alias.terms.iter().filter(|term| !is_unlikely(term)).count();
            alias.is_asked =
                alias.terms.first().is_some_and(|term| wanted.iter().any(|symbol| *term == (*symbol).into()));
            alias.terms.truncate(MOST);
        }
        self
    }

    /// Adds a meaning of a name.
    pub(crate) fn add(&mut self, name: &str, term: &Expr) {
        let alias = self.0.entry(letters(name)).or_insert_with(|| Alias {
            name: name.to_owned(),
            terms: Vec::new(),
            likely: 0,
            is_asked: false,
        });
        if !alias.terms.contains(term) {
            alias.terms.push(term.clone());
        }
    }

    /// Every quantity under its name without what may tell nothing apart: its instant, its body, its stage.
    fn of_quantities(&mut self, worked: Worked<'_>) {
        let model = worked.problem.model();
        for (symbol, entry) in model.symbols.iter() {
            if !entry.name.starts_with(char::is_alphabetic) || entry.name.contains([' ', '(']) {
                continue;
            }
            let name = model.name(symbol);
            let is_whole = name.component.as_deref() == Some("theta") && {
                let radial = name.clone().along(Some("r")).to_string();
                model.symbols.find(&radial).is_none()
            };
            // A velocity at right angles to the radius is the whole one.
            let whole = is_whole.then(|| name.clone().along(None));
            for name in std::iter::once(name).chain(&whole).flat_map(shortened) {
                let usual = name.kind.spelling().into_owned();
                let others = LETTERS.iter().filter(|(letter, _)| *letter == usual).flat_map(|(_, others)| *others);
                for letter in std::iter::once(usual.as_str()).chain(others.copied()) {
                    for spelling in spellings(&name, letter) {
                        self.add(&spelling, &symbol.into());
                    }
                }
            }
        }
    }

    /// The velocities after, of a body that has two, with a prime.
    fn with_primes(&mut self, worked: Worked<'_>) {
        let model = worked.problem.model();
        for (symbol, _) in model.symbols.iter() {
            let name = model.name(symbol);
            let has = |instant| model.symbols.find(&name.clone().at(instant).to_string()).is_some();
            if name.kind != QuantityKind::Velocity || name.instant != Some(Instant::Number(2)) || has(3) {
                continue;
            }
            for timed in [Name { subject: String::new(), ..name.clone() }, name.clone()] {
                let timeless = Name { instant: None, ..timed };
                for spelling in spellings(&timeless, "v") {
                    self.add(&format!("{spelling}'"), &symbol.into());
                }
            }
        }
    }

    /// Puts the short names that stand in a text into an alphabet.
    pub(crate) fn learn(&self, text: &str, alphabet: &mut Alphabet) {
        let text = GREEK.iter().fold(text.to_owned(), |text, (sign, name)| text.replace(sign, name));
        let is_of_name = |sign: char| sign.is_alphanumeric() || matches!(sign, '_' | '.' | '{' | '}' | '\'');
        for word in text.split(|sign: char| !is_of_name(sign)) {
            let word: String = word.chars().filter(|sign| !matches!(sign, '{' | '}')).collect();
            let word = word.trim_start_matches(|sign: char| sign.is_ascii_digit() || sign == '.');
            let primes: String = word.chars().filter(|sign| *sign == '\'').collect();
            let key = letters(word).replace('\'', "") + &primes;
            if key == primes {
                continue;
            }
            // The letter of a body may be written small: `va`.
            let capital = if self.0.contains_key(&key) { None } else { self.with_capital(&key) };
            if let Some(alias) = &capital {
                alphabet.name(word, &alias.terms, alias.is_loose());
                continue;
            }
            let components = ["", "x", "y", "z"].map(|axis| format!("{key}{axis}"));
            for (place, key) in components.iter().enumerate() {
                let alias = self.0.get(key).filter(|alias| place == 0 || alias.name.contains('.'));
                if let Some(alias) = alias {
                    // A prime may stand anywhere in a name, which is read as it is written.
                    let name = if primes.is_empty() { &alias.name } else { word };
                    let product = (place == 0).then(|| alphabet.product(word)).flatten();
                    let terms: Vec<Expr> = alias.terms.iter().cloned().chain(product).collect();
                    alphabet.name(name, &terms, alias.is_loose());
                }
            }
        }
    }

    /// The name that is written with a small letter for a body: `va2` for `v_A2`.
    fn with_capital(&self, key: &str) -> Option<&Alias> {
        let (place, body) = key.char_indices().skip(1).find(|(_, sign)| sign.is_alphabetic())?;
        let is_one = body.is_ascii_lowercase() && !key[place + 1..].contains(char::is_alphabetic);
        let capital = || format!("{}{}{}", &key[..place], body.to_ascii_uppercase(), &key[place + 1..]);
        is_one.then(|| self.0.get(&capital())).flatten()
    }

    /// Whether there is such a name.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.0.contains_key(&letters(name))
    }
}

/// A name and the shorter ones that it may have.
fn shortened(name: &Name) -> Vec<Name> {
    let whole = [name.clone(), Name { stage: None, ..name.clone() }];
    let timeless = whole.iter().map(|name| Name { instant: None, ..name.clone() });
    let mut names: Vec<Name> = whole.iter().cloned().chain(timeless).collect();
    let nobodys = names.iter().map(|name| Name { subject: String::new(), ..name.clone() });
    names.extend(nobodys.collect::<Vec<_>>());
    let mut kept: Vec<Name> = Vec::new();
    for name in names {
        if !kept.contains(&name) && name.stage.is_none() {
            kept.push(name);
        }
    }
    kept
}

/// The spellings of a name with a letter: `v_A1.x`, `v_Ax1`, `v_A1x`; a position also as `x_A1`.
fn spellings(name: &Name, letter: &str) -> Vec<String> {
    let instant = match &name.instant {
        Some(Instant::Number(number)) => number.to_string(),
        Some(Instant::Named(named)) => format!("_{named}"),
        None => String::new(),
    };
    let body = &name.subject;
    let index = |index: String, letter: &str| {
        if index.is_empty() { letter.to_owned() } else { format!("{letter}_{index}") }
    };
    let plain = index(format!("{body}{instant}"), letter);
    let Some(axis) = &name.component else { return vec![plain] };
    let mut spellings = vec![
        format!("{plain}.{axis}"),
        index(format!("{body}{axis}{instant}"), letter),
        index(format!("{axis}{body}{instant}"), letter),
        index(format!("{body}{instant}{axis}"), letter),
    ];
    if name.kind == QuantityKind::Position {
        spellings.push(index(format!("{body}{instant}"), axis));
    }
    spellings
}
