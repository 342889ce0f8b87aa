//! Letters for the bodies together and for their motion about points: what follows from masses, places and velocities by definition.

use std::collections::BTreeSet;

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::kinematics;
use momentous_model::Instant;
use momentous_model::Name;
use momentous_model::QuantityKind;
use momentous_problem::Worked;
use momentous_quantity::Dimension;

use super::aliases::Aliases;
use super::alphabet::mass;
use super::ground::Ground;

/// The axes along which velocities have components; one without a name where all motion is along one line.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Letters for the total mass.
const MASS: [&str; 4] = ["M", "m_tot", "m_total", "m_G"];
/// Letters for the total momentum.
const MOMENTUM: [&str; 5] = ["p", "P", "p_tot", "p_total", "p_G"];
/// Letters for the kinetic energy of all bodies.
const ENERGY: [&str; 5] = ["T", "K", "KE", "E_k", "E_kin"];
/// Letters for the reduced mass of two bodies.
const REDUCED: [&str; 3] = ["mu", "m_red", "m_r"];
/// Letters for a way that is gone along a line.
const WAY: [&str; 3] = ["s", "x", "d"];
/// Letters for angular momentum.
const ANGULAR: [&str; 2] = ["H", "L"];

/// The bodies of a scene, as far as a line may speak of them together.
struct Bodies<'a> {
    worked: Worked<'a>,
    masses: Vec<(&'a str, Expr)>,
    axes: Vec<Option<&'static str>>,
}

/// The short names of a form.
pub(crate) fn aliases(worked: Worked<'_>, ground: &Ground) -> Aliases {
    let mut together = Aliases::default();
    letters(&mut together, worked);
    Aliases::of(worked).join(together).ranked(worked, ground)
}

/// Adds the letters.
fn letters(aliases: &mut Aliases, worked: Worked<'_>) {
    let bodies = Bodies::of(worked);
    bodies.momenta_about_points(aliases);
    bodies.changes(aliases);
    bodies.accelerations(aliases);
    bodies.places(aliases);
    let total = Expr::sum(bodies.masses.iter().map(|(_, mass)| mass.clone()));
    match bodies.masses.as_slice() {
        [] => return,
        [_] => return aliases.add(MASS[0], &total),
        _ => MASS.iter().for_each(|letter| aliases.add(letter, &total)),
    }
    if let [(_, one), (_, other)] = bodies.masses.as_slice() {
        let reduced = one.clone() * other.clone() / total.clone();
        for letter in REDUCED {
            aliases.add(letter, &reduced);
        }
    }
    for instant in bodies.instants() {
        bodies.motion(aliases, instant, &total);
    }
}

impl<'a> Bodies<'a> {
    fn of(worked: Worked<'a>) -> Self {
        let model = worked.problem.model();
        let bodies = worked.problem.loaded().draft.scene.bodies.keys();
        let mass = |body: &'a String| Some((body.as_str(), mass(worked, body)?));
        let has =
            |axis: &str| model.symbols.iter().any(|(symbol, _)| model.name(symbol).component.as_deref() == Some(axis));
        let axes: Vec<Option<&str>> = AXES.into_iter().filter(|axis| has(axis)).map(Some).collect();
        let axes = if axes.is_empty() { vec![None] } else { axes };
        Self { worked, masses: bodies.filter_map(mass).collect(), axes }
    }

    fn quantity(&self, kind: QuantityKind, body: &str, instant: usize, axis: Option<&str>) -> Option<Expr> {
        let name = Name::of(kind, body).at(instant).along(axis).to_string();
        self.worked.problem.model().symbols.find(&name).map(Expr::from)
    }

    /// A quantity of each body along an axis; nothing where some body has none.
    fn each(&self, kind: &QuantityKind, instant: usize, axis: Option<&str>) -> Option<Vec<Expr>> {
        let quantity_of = |(body, _): &(&str, Expr)| self.quantity(kind.clone(), body, instant, axis);
        self.masses.iter().map(quantity_of).collect()
    }

    fn instants(&self) -> BTreeSet<usize> {
        let model = self.worked.problem.model();
        let number = |symbol| match model.name(symbol).instant {
            Some(Instant::Number(number)) => Some(number),
            _ => None,
        };
        model.symbols.iter().filter_map(|(symbol, _)| number(symbol)).collect()
    }

    /// The sum of a quantity of each body times its mass.
    fn weighted(&self, quantities: &[Expr]) -> Expr {
        Expr::sum(self.masses.iter().zip(quantities).map(|((_, mass), quantity)| mass.clone() * quantity.clone()))
    }

    fn motion(&self, aliases: &mut Aliases, instant: usize, total: &Expr) {
        let add = |aliases: &mut Aliases, letter: &str, body: &str, axis: Option<&str>, term: &Expr| {
            let axis = axis.map_or_else(String::new, |axis| format!(".{axis}"));
            let index = if body.is_empty() && letter.contains('_') { "_" } else { "" };
            let name = if letter.contains('_') { format!("{letter}{index}{body}") } else { format!("{letter}_{body}") };
            for number in [instant.to_string(), String::new()] {
                aliases.add(&format!("{}{axis}", format!("{name}{number}").trim_end_matches('_')), term);
            }
        };
        let (mut squares, mut mean_squares, mut relative_squares) = (Vec::new(), Vec::new(), Vec::new());
        for axis in &self.axes {
            if let Some(places) = self.each(&QuantityKind::Position, instant, *axis) {
                let mean = self.weighted(&places) / total.clone();
                add(aliases, "r", "G", *axis, &mean);
                add(aliases, axis.unwrap_or("x"), "G", None, &mean);
            }
            let Some(velocities) = self.each(&QuantityKind::Velocity, instant, *axis) else { return };
            let momentum = self.weighted(&velocities);
            let mean = momentum.clone() / total.clone();
            for letter in MOMENTUM {
                add(aliases, letter, "", *axis, &momentum);
            }
            add(aliases, "v", "G", *axis, &mean);
            let relative: Vec<Expr> =
                velocities.iter().map(|velocity| Expr::sum([velocity.clone(), -mean.clone()])).collect();
            for ((body, _), velocity) in self.masses.iter().zip(&relative) {
                add(aliases, "v_rel_", body, *axis, velocity);
            }
            squares
                .push(self.weighted(&velocities.iter().map(|velocity| velocity.clone().powi(2)).collect::<Vec<_>>()));
            mean_squares.push(total.clone() * mean.powi(2));
            relative_squares
                .push(self.weighted(&relative.into_iter().map(|velocity| velocity.powi(2)).collect::<Vec<_>>()));
        }
        let half = |squares: Vec<Expr>| Expr::ratio(1, 2) * Expr::sum(squares);
        let [all, mean, relative] = [squares, mean_squares, relative_squares].map(half);
        for letter in ENERGY {
            add(aliases, letter, "", None, &all);
            add(aliases, letter, "G", None, &mean);
            add(aliases, &format!("{letter}_rel"), "", None, &relative);
        }
    }

    /// The changes of velocity and momentum of each body from one instant to the next.
    fn changes(&self, aliases: &mut Aliases) {
        for (body, mass) in &self.masses {
            for (instant, axis) in
                self.instants().into_iter().flat_map(|instant| self.axes.iter().map(move |axis| (instant, *axis)))
            {
                let velocity = |instant| self.quantity(QuantityKind::Velocity, body, instant, axis);
                let (Some(before), Some(after)) = (velocity(instant), velocity(instant + 1)) else { continue };
                let change = Expr::sum([after, -before]);
                let axis = axis.map_or_else(String::new, |axis| format!(".{axis}"));
                let all = if self.masses.len() == 1 {
                    vec![String::new(), format!("_{body}")]
                } else {
                    vec![format!("_{body}")]
                };
                for index in all {
                    aliases.add(&format!("Delta_v{index}{axis}"), &change);
                    aliases.add(&format!("Delta_p{index}{axis}"), &(mass.clone() * change.clone()));
                }
            }
        }
    }

    /// The acceleration of each body in a stage in which it is constant, so that the mean velocity is half the sum of the first and the last.
    fn accelerations(&self, aliases: &mut Aliases) {
        let model = self.worked.problem.model();
        let leaf = self.worked.leaf();
        for equation in &leaf.system.equations {
            let instance =
                model.instances.get(equation.tag).filter(|instance| instance.law.id == kinematics::MEAN_VELOCITY.id);
            let Some(stage) = instance.and_then(|instance| instance.stage) else { continue };
            let symbols = equation.symbols();
            let is_duration = |symbol: &&Symbol| model.symbols.entry(**symbol).dimension == Dimension::TIME;
            let Some(duration) = symbols.iter().find(is_duration) else { continue };
            let is_velocity = |symbol: &Symbol| model.name(*symbol).kind == QuantityKind::Velocity;
            let mut velocities: Vec<(usize, Symbol)> = symbols
                .iter()
                .copied()
                .filter(is_velocity)
                .filter_map(|symbol| match model.name(symbol).instant {
                    Some(Instant::Number(instant)) => Some((instant, symbol)),
                    _ => None,
                })
                .collect();
            velocities.sort_unstable();
            let change = match velocities.as_slice() {
                [(_, first), (_, last)] => Expr::sum([(*last).into(), -Expr::from(*first)]),
                // The other one is zero.
                [(instant, only)] if *instant == stage + 1 => -Expr::from(*only),
                [(_, only)] => Expr::from(*only),
                _ => continue,
            };
            let name = model.name(velocities[0].1);
            let axis = name.component.as_ref().map_or_else(String::new, |axis| format!(".{axis}"));
            for index in [String::new(), format!("_{}", name.subject)] {
                aliases.add(&format!("a{index}{axis}"), &(change.clone() / Expr::from(*duration)));
            }
        }
    }

    /// The place of a body that starts at zero as the way that it goes.
    fn places(&self, aliases: &mut Aliases) {
        let model = self.worked.problem.model();
        for symbol in self.worked.form.wanted().filter(|symbol| model.name(*symbol).kind == QuantityKind::Position) {
            let name = model.name(symbol);
            let Some(Instant::Number(instant)) = name.instant else { continue };
            let before =
                instant.checked_sub(1).and_then(|before| model.symbols.find(&name.clone().at(before).to_string()));
            let start = before.and_then(|before| self.worked.variant.given(before));
            if name.component.is_none() && start.is_some_and(|(start, _)| start.is_zero()) {
                for letter in WAY {
                    aliases.add(letter, &symbol.into());
                }
            }
        }
    }

    /// The angular momentum of each body about the only point of the scene, where it is the origin, in a plane.
    fn momenta_about_points(&self, aliases: &mut Aliases) {
        let points = &self.worked.problem.loaded().draft.scene.points;
        let mut points = points.iter();
        let (Some((point, place)), None) = (points.next(), points.next()) else { return };
        if place.at.axes().next().is_some() || self.axes != [Some("x"), Some("y")] {
            return;
        }
        for instant in self.instants() {
            for (body, mass) in &self.masses {
                let coordinate = |kind, axis| self.quantity(kind, body, instant, Some(axis));
                let [x, y] = ["x", "y"].map(|axis| coordinate(QuantityKind::Position, axis));
                let [v_x, v_y] = ["x", "y"].map(|axis| coordinate(QuantityKind::Velocity, axis));
                let (Some(x), Some(y), Some(v_x), Some(v_y)) = (x, y, v_x, v_y) else { continue };
                let momentum = mass.clone() * Expr::sum([x * v_y, -(y * v_x)]);
                for letter in ANGULAR {
                    for name in [format!("{letter}_{body}"), format!("{letter}_{point}{body}")] {
                        aliases.add(&format!("{name}{instant}"), &momentum);
                        aliases.add(&name, &momentum);
                    }
                }
            }
        }
    }
}
