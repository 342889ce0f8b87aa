//! The letters of a form: every quantity that a student can type, and short names for what mechanics has a usual letter for.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_expr::SymbolEntry;
use momentous_laws::{Law, angular, energy, force, motion};
use momentous_model::Instant;
use momentous_model::Integral;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_model::VectorName;
use momentous_problem::Worked;
use momentous_solve::Statement;

use super::ground::Ground;
use super::spelling::{self, printed};
use super::vectors::Vectors;
use super::written::Alphabet;

/// Letters of functions that are integrated, by the law that integrates them.
const FUNCTIONS: [(&Law, &str); 4] =
    [(&force::IMPULSE, "F"), (&energy::WORK, "F"), (&angular::MOMENT_IMPULSE, "M"), (&motion::DISPLACEMENT, "v")];

/// The number of members of a sequence that have names.
const MOST_MEMBERS: i64 = 12;

/// Values are the same within this share.
const SAME: f64 = 1e-12;

/// Letters under which kinetic energies are written.
const KINETIC_ENERGY: [&str; 5] = ["T", "K", "KE", "E_k", "E_kin"];

/// The letters of a form.
pub(crate) fn alphabet(worked: Worked<'_>, ground: &Ground) -> Alphabet {
    let model = worked.problem.model();
    let is_typed = |name: &str| name.starts_with(char::is_alphabetic) && !name.contains([' ', '(', '*', '/']);
    let names = model.symbols.iter().filter(|(_, entry)| is_typed(&entry.name)).map(|(symbol, _)| symbol).collect();
    let mut alphabet = Alphabet {
        symbols: model.symbols.clone(),
        names,
        short: Vec::new(),
        spelt: Vec::new(),
        others: BTreeMap::new(),
        loose: BTreeSet::new(),
        numbers: BTreeMap::new(),
        own_letters: BTreeSet::new(),
        vectors: Vectors::among(&model.symbols),
        limits: BTreeMap::new(),
        variables: variables(worked, ground),
        instants: instants(worked),
        asked: BTreeMap::new(),
    };
    asked(worked, &mut alphabet);
    functions(worked, &mut alphabet);
    magnitudes(worked, &mut alphabet);
    motions(worked, &mut alphabet);
    masses(worked, ground, &mut alphabet);
    unions(worked, &mut alphabet);
    totals(worked, &mut alphabet);
    numbered(worked, &mut alphabet);
    once(worked, &mut alphabet);
    across(worked, &mut alphabet);
    components(worked, ground, &mut alphabet);
    last_members(worked, ground, &mut alphabet);
    members(worked, ground, &mut alphabet);
    alone(worked, ground, &mut alphabet);
    alphabet.vectors = Vectors::among(&alphabet.symbols);
    alphabet
}

/// The instant of each quantity that belongs to one.
fn instants(worked: Worked<'_>) -> BTreeMap<Symbol, usize> {
    let model = worked.problem.model();
    let instant = |symbol: Symbol| match model.name(symbol).instant {
        Some(Instant::Number(instant)) => Some((symbol, instant)),
        _ => None,
    };
    model.symbols.iter().filter_map(|(symbol, _)| instant(symbol)).collect()
}

/// The letters that have no value: over which forces are integrated, as the time.
fn variables(worked: Worked<'_>, ground: &Ground) -> BTreeSet<Symbol> {
    let mut valued: BTreeSet<Symbol> = ground.equations.iter().flat_map(|stated| stated.residual.symbols()).collect();
    valued.extend(&ground.told);
    let symbols = worked.problem.model().symbols.iter().map(|(symbol, _)| symbol);
    symbols.filter(|symbol| !valued.contains(symbol)).collect()
}

/// What is asked, by the symbol that the sheet prints for it, where that is not its name: `v_{A2}` for the speed.
fn asked(worked: Worked<'_>, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    for symbol in worked.form.wanted() {
        let printed = printed(&worked.problem.math_of(symbol).latex());
        // A size may be written without its bars, where nothing else is called so.
        for spelt in BTreeSet::from([printed.as_str(), printed.trim_matches('|')]) {
            let is_name = |other: &SymbolEntry| spelling::letters(&other.name) == *spelt;
            if !spelt.is_empty() && !model.symbols.iter().any(|(_, entry)| is_name(entry)) {
                alphabet.asked.insert(spelt.to_owned(), model.symbols.entry(symbol).name.clone());
            }
        }
    }
}

/// Each letter for a function that the scene integrates, `F(t)`, and the limits of the integrals over a variable.
fn functions(worked: Worked<'_>, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let mut by_letter: BTreeMap<&str, Vec<&Integral>> = BTreeMap::new();
    for instance in &model.instances {
        let letter = FUNCTIONS.iter().find(|(law, _)| *law == instance.law).map(|(_, letter)| *letter);
        if let (Some(letter), Some(integral)) = (letter, &instance.integral) {
            by_letter.entry(letter).or_default().push(integral);
        }
    }
    for (letter, integrals) in &by_letter {
        let [first, others @ ..] = integrals.as_slice() else { continue };
        // Against the axis, a letter may as well be the size of the force.
        let is_along =
            !matches!(&first.integrand, Expr::Product(factors) if factors.first() == Some(&Expr::integer(-1)));
        let is_one = others.iter().all(|integral| integral.integrand == first.integrand);
        if !is_along || !is_one || model.symbols.find(letter).is_some() {
            continue;
        }
        let variable = &model.symbols.entry(first.variable).name;
        alphabet.shorten(letter, first.integrand.clone());
        alphabet.spelt.push((format!("{letter}({variable})"), (*letter).to_owned()));
    }
    let all = || by_letter.values().flatten();
    for integral in all() {
        let limits = [integral.low.clone(), integral.high.clone()];
        let alike = |other: &&&Integral| other.low == integral.low && other.high == integral.high;
        if all().filter(|other| other.variable == integral.variable).all(|other| alike(&other)) {
            alphabet.limits.insert(model.symbols.entry(integral.variable).name.clone(), limits);
        }
    }
}

/// The size of a vector: `magnitude(H_O1)`, `|H_O1|`.
fn magnitudes(worked: Worked<'_>, alphabet: &mut Alphabet) {
    for (symbol, entry) in worked.problem.model().symbols.iter() {
        let Some(VectorName::Magnitude(vector)) = VectorName::parse(&entry.name).filter(|_| entry.name.ends_with(')'))
        else {
            continue;
        };
        let name = format!("magnitude_{vector}");
        alphabet.shorten(&name, symbol.into());
        alphabet.spelt.extend([entry.name.clone(), format!("|{vector}|")].map(|text| (text, name.clone())));
    }
}

/// Momentum, kinetic energy and the change of velocity and momentum of each body with a mass and velocities.
fn motions(worked: Worked<'_>, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let named = || model.symbols.iter().map(|(symbol, _)| (symbol, model.name(symbol)));
    // By body and component, the velocities at each instant.
    let mut motions: BTreeMap<(&str, Option<&str>), BTreeMap<usize, Expr>> = BTreeMap::new();
    for (symbol, name) in named().filter(|(_, name)| name.kind == QuantityKind::Velocity && name.stage.is_none()) {
        if let Some(Instant::Number(instant)) = name.instant {
            motions.entry((&name.subject, name.component.as_deref())).or_default().insert(instant, symbol.into());
        }
    }
    let mut energies: BTreeMap<(&str, usize), Vec<Expr>> = BTreeMap::new();
    for ((body, component), velocities) in &motions {
        let Some(mass) = mass(worked, body) else { continue };
        let part = component.map_or_else(String::new, |component| format!(".{component}"));
        for (instant, velocity) in velocities {
            alphabet.shorten(&format!("p_{body}{instant}{part}"), mass.clone() * velocity.clone());
            energies.entry((body, *instant)).or_default().push(velocity.clone().powi(2));
        }
        if let [first, last] = velocities.values().collect::<Vec<_>>().as_slice() {
            let change = Expr::sum([(*last).clone(), -(*first).clone()]);
            for name in [format!("v_{body}'{part}"), format!("v'_{body}{part}")] {
                alphabet.shorten(&name, (*last).clone());
            }
            alphabet.shorten(&format!("u_{body}{part}"), (*first).clone());
            alphabet.shorten(&format!("Delta_v_{body}{part}"), change.clone());
            alphabet.shorten(&format!("Delta_p_{body}{part}"), mass.clone() * change.clone());
            alphabet.shorten(&format!("J_{body}{part}"), mass * change);
        }
    }
    for ((body, instant), squares) in energies {
        let Some(mass) = mass(worked, body) else { continue };
        let energy = Expr::ratio(1, 2) * mass * Expr::sum(squares);
        for letter in KINETIC_ENERGY {
            alphabet.shorten(&format!("{letter}_{body}{instant}"), energy.clone());
        }
    }
}

/// A letter alone, where it can mean one quantity only.
fn alone(worked: Worked<'_>, ground: &Ground, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let letter = |symbol: Symbol| {
        let name = model.symbols.entry(symbol).name.as_str();
        name.find(['_', '.', '[', '@']).map_or(name, |end| &name[..end])
    };
    let wanted: Vec<Symbol> = worked.form.wanted().collect();
    let used = ground.used_symbols();
    let open: Vec<Symbol> = used.iter().copied().filter(|symbol| !ground.told.contains(symbol)).collect();
    for symbol in &wanted {
        let written = letter(*symbol);
        // Of what is told, only what belongs to no body is written with the letter alone.
        let told = ground.told.iter().filter(|told| model.name(**told).subject.is_empty());
        let others =
            wanted.iter().chain(&open).chain(told).filter(|other| *other != symbol && letter(**other) == written);
        if others.count() == 0 && written.chars().count() == 1 && written != "e" {
            alphabet.shorten(written, (*symbol).into());
        }
    }
}

/// The lost energy under other letters.
fn totals(worked: Worked<'_>, alphabet: &mut Alphabet) {
    if let Some(lost) = worked.problem.model().symbols.find("T_lost") {
        for letter in KINETIC_ENERGY.iter().skip(1).chain(&["E"]) {
            alphabet.shorten(&format!("{letter}_lost"), lost.into());
        }
    }
}

/// Two bodies by number, with u before and a prime after: `m1 u1 + m2 u2`, `v_A'`.
fn numbered(worked: Worked<'_>, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let bodies: Vec<&String> = worked.problem.loaded().draft.scene.bodies.keys().collect();
    for (place, body) in bodies.iter().enumerate() {
        let velocity = |instant: usize| model.symbols.find(&format!("v_{body}{instant}")).map(Expr::from);
        if let Some(mass) = mass(worked, body) {
            alphabet.shorten(&format!("m_{}", place + 1), mass);
        }
        for number in [(*body).clone(), (place + 1).to_string()] {
            if let Some(before) = velocity(1) {
                alphabet.shorten(&format!("u_{number}"), before);
            }
            if let (Some(after), None) = (velocity(2), velocity(3)) {
                alphabet.shorten(&format!("v_{number}'"), after);
            }
        }
    }
}

/// Names without what tells nothing apart: of quantities of one instant only their number, `v_G`, and of one body only its letter, `r_1`.
fn once(worked: Worked<'_>, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let shorter: [fn(&Name) -> Name; 2] =
        [|name| Name { instant: None, ..name.clone() }, |name| Name { subject: String::new(), ..name.clone() }];
    for shorter in shorter {
        for (symbol, _) in model.symbols.iter() {
            let name = model.name(symbol);
            if name.subject.is_empty() || name.instant.is_none() {
                continue;
            }
            let short = shorter(name);
            let alike = model.symbols.iter().filter(|(other, _)| shorter(model.name(*other)) == short);
            if alike.count() == 1 {
                alphabet.shorten(&short.to_string(), symbol.into());
            }
        }
    }
}

/// Components with the axis in the index: `v_Ax1`, and where they tell nothing apart without body or instant, `v_y1`, `v_x`.
fn components(worked: Worked<'_>, ground: &Ground, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let mut spellings: BTreeMap<String, Vec<Symbol>> = BTreeMap::new();
    for (symbol, entry) in model.symbols.iter() {
        let name = model.name(symbol);
        let (Some(axis), Some(Instant::Number(instant)), None) = (&name.component, &name.instant, &name.stage) else {
            continue;
        };
        let Some((letter, _)) = entry.name.split_once('_') else { continue };
        let body = &name.subject;
        for index in [format!("{body}{axis}{instant}"), format!("{axis}{instant}"), format!("{instant}{axis}")] {
            spellings.entry(format!("{letter}_{index}")).or_default().push(symbol);
        }
        if !ground.told.contains(&symbol) {
            spellings.entry(format!("{letter}_{axis}")).or_default().push(symbol);
        }
    }
    for (name, symbols) in spellings {
        if let [only] = symbols.as_slice() {
            alphabet.shorten(&name, (*only).into());
        }
    }
}

/// Members of a sequence of which the last is asked, `h_1` and `h_2` beside `h_n`: their law with another count.
fn members(worked: Worked<'_>, ground: &Ground, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    for equation in &ground.system.equations {
        let Statement::Equal { left: Expr::Symbol(last), right } = &equation.statement else { continue };
        let Some((letter, count)) = model.symbols.entry(*last).name.split_once('_') else { continue };
        let Some(count) = model.symbols.find(count).filter(|symbol| right.contains(*symbol)) else { continue };
        // What belongs to the last member says nothing of another.
        let suffix = format!("_{}", model.symbols.entry(count).name);
        if right.symbols().iter().any(|symbol| model.symbols.entry(*symbol).name.ends_with(&suffix)) {
            continue;
        }
        let number = worked.variant.given(count).map(|(number, _)| number.to_string());
        for member in (1..=MOST_MEMBERS).filter(|member| number.as_ref() != Some(&member.to_string())) {
            let term = right.substitute(&|symbol| (symbol == count).then(|| Expr::integer(member)));
            alphabet.name(&format!("{letter}_{member}"), &[term], false);
        }
    }
}

/// The last members of sequences, where their number is on the sheet: `h_3` is what is asked as `h_n`.
fn last_members(worked: Worked<'_>, ground: &Ground, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    for (symbol, entry) in model.symbols.iter() {
        let Some((letter, count)) = entry.name.split_once('_') else { continue };
        let count = model.symbols.find(count).filter(|count| ground.told.contains(count));
        if let Some((number, _)) = count.and_then(|count| worked.variant.given(count)) {
            alphabet.name(&format!("{letter}_{number}"), &[symbol.into()], false);
        }
    }
}

/// The mass of what has come together, under its letter: `m_C` for `m_A + m_B`.
fn unions(worked: Worked<'_>, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let scene = &worked.problem.loaded().draft.scene;
    let subjects: BTreeSet<&str> =
        model.symbols.iter().map(|(symbol, _)| model.name(symbol).subject.as_str()).collect();
    for union in subjects.into_iter().filter(|subject| scene.members(subject).len() > 1) {
        let masses = scene.members(union).into_iter().map(|part| model.symbols.find(&format!("m_{part}")));
        if let Some(masses) = masses.collect::<Option<Vec<_>>>() {
            alphabet.shorten(&format!("m_{union}"), Expr::sum(masses.into_iter().map(Expr::from)));
        }
    }
}

/// The transverse component of a vector in polar coordinates as `v_A2.t`.
fn across(worked: Worked<'_>, alphabet: &mut Alphabet) {
    for (symbol, entry) in worked.problem.model().symbols.iter() {
        if let Some(vector) = entry.name.strip_suffix(".theta") {
            alphabet.shorten(&format!("{vector}.t"), symbol.into());
        }
    }
}

/// The mass of a body, where it has a name.
pub(crate) fn mass(worked: Worked<'_>, body: &str) -> Option<Expr> {
    let entry = worked.problem.loaded().draft.scene.bodies.get(body)?;
    let name = entry.mass.as_ref().map_or_else(|| format!("m_{body}"), |term| term.0.trim().to_owned());
    worked.problem.model().symbols.find(&name).map(Expr::from)
}

/// The mass of each body under its letter, one letter for masses that are the same in every variant, and for the only normal force.
fn masses(worked: Worked<'_>, ground: &Ground, alphabet: &mut Alphabet) {
    let model = worked.problem.model();
    let bodies: Vec<&String> = worked.problem.loaded().draft.scene.bodies.keys().collect();
    let masses: Vec<(&String, Expr)> = bodies.iter().filter_map(|body| Some((*body, mass(worked, body)?))).collect();
    let is_same = |one: &Expr, other: &Expr| {
        let mut values = ground.places().map(|place| {
            let value = |symbol: Symbol| place.value(symbol).map_or(f64::NAN, |number| number.value);
            [one, other].map(|side| side.evaluate(&value))
        });
        values.all(|[one, other]| (one - other).abs() <= SAME * one.abs())
    };
    if let Some((_, first)) = masses.first()
        && masses.len() == bodies.len()
        && masses.iter().skip(1).all(|(_, other)| is_same(first, other))
    {
        alphabet.shorten("m", first.clone());
    }
    for (body, mass) in masses {
        alphabet.shorten(&format!("m_{body}"), mass);
    }
    let normal: Vec<Symbol> =
        model.symbols.iter().filter(|(_, entry)| entry.name.starts_with("N_")).map(|(symbol, _)| symbol).collect();
    if let [only] = normal.as_slice() {
        alphabet.shorten("F_N", (*only).into());
        alphabet.shorten("N", (*only).into());
    }
}
