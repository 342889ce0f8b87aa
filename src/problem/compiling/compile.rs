//! From a loaded file to a problem that can be drawn and solved: names become symbols, what is asked becomes plans.

use std::collections::BTreeMap;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Faults;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::Model;
use momentous_model::Reason;
use momentous_quantity::Decimal;
use momentous_quantity::Dimension;
use momentous_quantity::Unit;
use momentous_quantity::UnitSystem;
use momentous_quantity::coherent_unit;
use momentous_quantity::dimension_name;
use momentous_scene::Stage;
use momentous_solve::Condition;
use momentous_solve::Planner;
use momentous_solve::Relation;

use super::super::consequences::feedback;
use super::super::deciding::formula;
use super::super::deciding::offered;
use super::super::deciding::roots;
use super::super::language::condition::condition;
use super::super::language::declared::declared;
use super::super::language::declared::unmeasured;
use super::super::language::given::Fraction;
use super::super::language::given::Given;
use super::super::language::known::Known;
use super::super::language::known::Origin;
use super::super::language::other_values::is_positive_in_every_form;
use super::super::language::other_values::known_in;
use super::super::reading::load::Loaded;
use super::super::reading::mentions::mention_in_texts;
use super::super::reading::turning;
use super::super::reading::unsound;
use super::super::sampling::no_variant::Rejection;
use super::super::sampling::sampler::Sampler;
use super::super::sampling::stream::Streams;
use super::any;
use super::consistent::Differing;
use super::consistent::inconsistent;
use super::consistent::told_otherwise;
use super::form_draft::FormDraft;
use super::idle;
use super::planned::Built;
use super::planned::Form;
use super::planned::Problem;
use super::told;

/// A loaded problem with its names resolved, its equations written and every form planned.
///
/// # Errors
/// Every fault that can be found without drawing numbers: unknown names, dimensions that do not agree, what does not
/// follow from what is given.
pub fn compile(loaded: Loaded, secret: Option<&[u8]>) -> Result<Problem, Faults> {
    let built = build(&loaded, secret, Asked::AsWritten).and_then(|built| {
        let check = |form| told::check(&loaded, &built.model, form);
        let mut faults: Vec<Fault> = built.forms.iter().flat_map(check).collect();
        faults.extend(feedback::check(&loaded, &built.model, &built.forms));
        if faults.is_empty() { Ok(built) } else { Err(faults) }
    });
    match built {
        Ok(built) => {
            let problem = Problem::new(loaded, built);
            let faults = contradictions(&problem);
            if faults.is_empty() { Ok(problem) } else { Err(problem.loaded().locate(faults)) }
        }
        Err(faults) => Err(loaded.locate(faults)),
    }
}

/// Finds contradictions where every number is fixed: the problem has its one variant or none, and what is given may say more than
/// can be true.
fn contradictions(problem: &Problem) -> Vec<Fault> {
    let trouble = |(position, form): (usize, &Form)| {
        if form.known.iter().any(|known| known.origin.is_drawn()) {
            return None;
        }
        let mut sampler = Sampler::new(problem, position).ok()?;
        let path = form.question.path.key("ask");
        let Err(reason) = sampler.draw(0) else {
            return inconsistent(problem, form, &sampler).map(|fault| fault.at_path(path));
        };
        let code = match reason.rejection() {
            Some(several @ (Rejection::Several(_) | Rejection::GoesOtherwise { .. })) => {
                let (message, every) = match several {
                    Rejection::Several(count) => (
                        format!("the values have {count} admissible solutions"),
                        "; or ask for every one: `roots: all`",
                    ),
                    otherwise => (format!("the values have several admissible solutions: {otherwise}"), ""),
                };
                let fault = Fault::new(Code::UnderDetermined, message);
                let example = sampler
                    .between_solutions()
                    .map_or_else(|| ", under `where`".to_owned(), |between| format!(": `where: [{between}]`"));
                let help = format!("say which is meant by a condition that the other one breaks{example}{every}");
                return Some(fault.help(help).at_path(path));
            }
            Some(Rejection::Contradiction { .. }) => {
                if let Some(Differing { values, help }) = told_otherwise(problem, form, &sampler) {
                    let why = reason.rejection().map_or_else(String::new, |why| format!(": {why}"));
                    let message = format!("the values have no admissible solution{why}: {values}");
                    return Some(Fault::new(Code::OverDetermined, message).help(help).at_path(path));
                }
                Code::OverDetermined
            }
            _ => Code::Unphysical,
        };
        let is_not_real = matches!(reason.rejection(), Some(Rejection::NotReal(_)));
        let why = reason.rejection().map_or_else(String::new, |why| format!(": {why}"));
        let fault = Fault::new(code, format!("the values have no admissible solution{why}"));
        let nearest = if is_not_real { sampler.nearest_solutions() } else { None };
        let help = match nearest {
            Some(changes) => format!("there is a solution with {changes}; or give other values"),
            None => reason.help(),
        };
        Some(fault.help(help).at_path(path))
    };
    problem.forms().iter().enumerate().filter_map(trouble).collect()
}

/// The same for a problem whose question was changed by [`super::super::ad_hoc`]: its text is not held to anything.
///
/// # Errors
/// Every fault that can be found without drawing numbers.
pub fn compile_ad_hoc(loaded: Loaded) -> Result<Problem, Faults> {
    match build(&loaded, None, Asked::Anew) {
        Ok(built) => Ok(Problem::new(loaded, built)),
        Err(faults) => Err(loaded.locate(faults)),
    }
}

/// How a problem is asked.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Asked {
    /// Asked as in its file.
    AsWritten,
    /// With other values or for other quantities.
    Anew,
}

fn build(loaded: &Loaded, secret: Option<&[u8]>, asked: Asked) -> Result<Built, Vec<Fault>> {
    let draft = &loaded.draft;
    let notation = draft.symbols.notation()?;
    let mut builder = Builder::of(&draft.scene, &declared(loaded), &unmeasured(loaded))?;
    let mut known = givens(loaded, &mut builder);
    for (index, relation) in draft.relations.iter().enumerate() {
        let path = Path::root().key("relations").index(index).key("equation");
        builder.relation(&relation.equation, &relation.because, &path);
    }
    let require: Vec<Condition> = draft
        .require
        .iter()
        .enumerate()
        .filter_map(|(index, text)| {
            let reason = Reason::Required(text.clone());
            condition(&mut builder, text, reason, &Path::root().key("require").index(index))
        })
        .collect();
    positive_letters(loaded, &known, &require, &mut builder);
    mention_for_checks(&draft.scene.stages, &mut builder);
    mention_in_texts(loaded, &mut builder);
    let drafts: Vec<FormDraft> =
        loaded.questions.iter().map(|question| FormDraft::read(loaded, question, &mut builder)).collect();
    let units = draft.units.system();
    if let Some(gravity) = builder.symbols().find("g")
        && loaded.given.get("g").is_none()
    {
        known.push(default_gravity(gravity, units));
    }
    words_for_directions(loaded, &drafts, &mut builder);
    let mut in_forms: Vec<Vec<Known>> =
        loaded.questions.iter().map(|question| known_in(loaded, question, &known, &mut builder)).collect();
    let drawn = assign_streams(&mut in_forms);
    let mut model = builder.finish()?;
    model.system.values = beforehand(&model, &in_forms);
    let mut faults = idle::faults(loaded, asked == Asked::Anew, (&model, &known), &drafts, &require);
    faults.extend(turning::angles_by_use(&model, &known));
    let mut forms = Vec::new();
    let mut planner = Planner::default();
    for (form, known) in drafts.into_iter().zip(in_forms) {
        match form.plan(&mut planner, (loaded, &model), known, &require) {
            Ok(form) => {
                let by_formula = any::by_formula(loaded, &model, &form);
                let (free, printed) = (any::free(loaded, &model, &form), &form.printed - &by_formula);
                forms.push(Form { printed, free, by_formula, ..form });
            }
            Err(more) => faults.extend(more),
        }
    }
    faults.extend(forms.iter().flat_map(|form| any::check(&model, form)));
    let name = |symbol| model.symbols.entry(symbol).name.clone();
    faults.extend(forms.iter().flat_map(|form| formula::check(&model.literals, form, &name)));
    faults.extend(forms.iter().flat_map(roots::check));
    faults.extend(forms.iter().flat_map(|form| offered::check(&model, form)));
    if !faults.is_empty() {
        return Err(faults);
    }
    let drawn = drawn.iter().filter_map(|position| known.get(*position)).map(|known| known.name.as_str());
    let streams = Streams::new(draft.drawn_as(), secret, drawn);
    Ok(Built { model, known, forms, streams, units, notation })
}

/// A letter for a quantity that may be anything is positive where the file requires so, or where something positive is given by it alone.
fn positive_letters(loaded: &Loaded, known: &[Known], require: &[Condition], builder: &mut Builder<'_>) {
    for letter in known.iter().filter(|known| matches!(known.origin, Origin::Any)) {
        let is_required = require.iter().any(|condition| {
            condition.left == letter.symbol.into()
                && condition.relation == Relation::Greater
                && builder.is_nothing(&condition.right)
        });
        let is_given = |(name, given): (&str, &Given)| {
            let is_own = matches!(given, Given::Expression(text) if text.trim() == letter.name);
            is_own && builder.symbols().find(name).is_some_and(|symbol| builder.is_positive(symbol))
        };
        if is_required || loaded.given.iter().any(is_given) {
            builder.assume_positive(&letter.name, letter.symbol);
        }
    }
}

/// Gives a random stream to each given that some form draws; the positions of these givens.
fn assign_streams(in_forms: &mut [Vec<Known>]) -> Vec<usize> {
    let count = in_forms.first().map_or(0, Vec::len);
    let is_drawn = |position: &usize| {
        in_forms.iter().any(|known| known.get(*position).is_some_and(|known| known.origin.is_drawn()))
    };
    let drawn: Vec<usize> = (0..count).filter(is_drawn).collect();
    for known in in_forms.iter_mut() {
        for (stream, position) in drawn.iter().enumerate() {
            if let Some(known) = known.get_mut(*position) {
                known.stream = Some(stream);
            }
        }
    }
    drawn
}

/// The values that are the same in every variant of every form.
fn beforehand(model: &Model, in_forms: &[Vec<Known>]) -> BTreeMap<Symbol, Expr> {
    let written = model
        .literals
        .iter()
        .map(|(symbol, quantity)| (*symbol, Some(Expr::measured(&quantity.value, &quantity.unit))));
    let mut values: BTreeMap<Symbol, Option<Expr>> = written.collect();
    for known in in_forms.iter().flatten() {
        let value = match &known.origin {
            Origin::Fixed(value) => Some(Expr::measured(value, &known.unit)),
            Origin::Drawn(_) | Origin::Any => None,
        };
        values
            .entry(known.symbol)
            .and_modify(|known| *known = known.take().filter(|known| value.as_ref() == Some(known)))
            .or_insert(value);
    }
    values.into_iter().filter_map(|(symbol, value)| Some((symbol, value?))).collect()
}

/// A word in the place of a direction is the name of an angle only if the file says more of it.
fn words_for_directions(loaded: &Loaded, drafts: &[FormDraft], builder: &mut Builder<'_>) {
    let words: Vec<(String, Path)> = builder.words().to_vec();
    for (word, path) in words {
        let symbol = builder.symbols().find(&word);
        let is_said = loaded.given.get(&word).is_some()
            || loaded.draft.relations.iter().any(|relation| relation.equation.contains(&word))
            || drafts.iter().any(|form| symbol.is_some_and(|symbol| form.speaks_of(symbol)));
        if !is_said {
            let fault = builder.no_direction(&word).at_path(path);
            builder.fault(fault);
        }
    }
}

/// Every given with its symbol. An expression of other givens becomes a stated relation, and so needs no value here.
fn givens(loaded: &Loaded, builder: &mut Builder<'_>) -> Vec<Known> {
    let mut known = Vec::new();
    for (name, given) in loaded.given.iter() {
        let path = Path::root().key("given").key(name);
        let place = Path::root().key("given").name(name);
        let mut add = |builder: &mut Builder<'_>, name: &str, origin: Origin, unit: &Unit| {
            let Some(symbol) = builder.mention(name).or_else(|| builder.unmeasured_symbol(name)) else {
                let fault = match given {
                    Given::Any(None) => builder.unknown(name).help(format!("give its unit: `{name}: any kg`")),
                    _ => builder.unknown(name),
                };
                builder.fault(fault.at_path(place.clone()));
                return;
            };
            let dimension = builder.symbols().entry(symbol).dimension;
            if dimension != unit.dimension() && !matches!(given, Given::Any(None)) {
                let [expected, found] = [dimension, unit.dimension()].map(dimension_name);
                let message = format!("`{name}` is {expected}, but its unit is one of {found}");
                let meaning = &builder.symbols().entry(symbol).meaning;
                let help = if meaning.is_empty() {
                    "change the unit".to_owned()
                } else {
                    format!("`{name}` stands for {meaning}: change the unit, or choose another name")
                };
                builder.fault(Fault::new(Code::Dimension, message).help(help).at_path(path.clone()));
            }
            let unclear = turning::unclear(&builder.name(symbol).kind, name, &origin, unit);
            if let Some(fault) = unclear.or_else(|| unsound::value(builder, name, symbol, &origin)) {
                builder.fault(fault.at_path(path.clone()));
            }
            if origin.is_positive() && is_positive_in_every_form(loaded, name) {
                builder.assume_positive(name, symbol);
            }
            let earlier = known.iter().find(|earlier: &&Known| earlier.symbol == symbol && earlier.name != name);
            if let Some(Known { name: earlier, .. }) = earlier {
                let message = format!("`{name}` is `{earlier}`, which is given already: nothing changes it in between");
                let help = format!(
                    "remove one of them, or add the stage that changes it; `{name}` and `{earlier}` are one quantity"
                );
                builder.fault(Fault::new(Code::Duplicate, message).help(help).at_path(place.clone()));
            }
            known.push(Known { name: name.to_owned(), symbol, unit: unit.clone(), origin, stream: None });
        };
        match given {
            Given::Any(unit) => add(builder, name, Origin::Any, &unit.clone().unwrap_or_default()),
            Given::Drawn { domain, unit } => add(builder, name, Origin::Drawn(domain.clone()), unit),
            Given::Literal(literal) => match &literal.components[..] {
                [only] => add(builder, name, Origin::Fixed(only.clone()), &literal.unit),
                components => {
                    for (value, axis) in components.iter().zip(["x", "y", "z"]) {
                        add(builder, &format!("{name}.{axis}"), Origin::Fixed(value.clone()), &literal.unit);
                    }
                }
            },
            Given::Expression(text) => {
                // `10/3 kg` is a third of ten kilograms where that is what the quantity is measured in.
                let expected = builder.mention(name).map(|symbol| builder.symbols().entry(symbol).dimension);
                let fraction = Fraction::read(text.trim())
                    .filter(|read| expected.is_none_or(|expected| expected == read.unit.dimension()));
                if let Some(exact) = fraction.as_ref().and_then(Fraction::decimal)
                    && let (Some(_), Some(fraction)) = (expected, &fraction)
                {
                    add(builder, name, Origin::Fixed(exact), &fraction.unit);
                    continue;
                }
                let text = &fraction.map_or_else(|| text.clone(), |fraction| fraction.expression());
                if let Some(symbol) = builder.mention(name)
                    && builder.name(symbol).kind.is_angle()
                {
                    let term = builder.term(text, &path);
                    builder.needs_unit(&term, &path);
                }
                if builder.mention(name).is_none() {
                    if !builder.may_be_chosen(name) {
                        let fault = builder.unknown(name);
                        builder.fault(fault.at_path(place.clone()));
                        continue;
                    }
                    let meaning = "the value given for it";
                    builder.declare(name, text, meaning, &path);
                }
                builder.relation(&format!("{name} = {text}"), "", &path);
            }
        }
    }
    unsound::circles(loaded, builder);
    known
}

/// The acceleration of free fall where a file does not give it: 9.81 m/s^2, or 32.2 ft/s^2.
fn default_gravity(symbol: Symbol, system: UnitSystem) -> Known {
    let (digits, decimals) = match system {
        UnitSystem::Si => (981, 2),
        UnitSystem::Us => (322, 1),
    };
    let origin = Origin::Fixed(Decimal::from_scaled(digits, decimals));
    Known { name: "g".into(), symbol, unit: coherent_unit(Dimension::ACCELERATION, system), origin, stream: None }
}

/// The energies around every impact, so that the audit can judge it.
fn mention_for_checks(stages: &[Stage], builder: &mut Builder<'_>) {
    for (index, stage) in stages.iter().enumerate() {
        if matches!(stage, Stage::Impact(_)) {
            builder.mention(&format!("T_lost[{}]", index + 1));
        }
    }
}
