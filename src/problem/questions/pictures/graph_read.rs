//! Reading a choice between graphs.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_model::Builder;
use momentous_model::Effect;
use momentous_model::QuantityKind;
use momentous_scene::Axis;
use momentous_scene::Force;
use momentous_scene::Plane;
use momentous_scene::Scene;
use momentous_scene::Senses;
use momentous_scene::Stage;
use momentous_scene::Strength;
use momentous_scene::stage::During;
use momentous_scene::stage::Push;
use momentous_solve::Statement;

use super::super::super::language::ask::Choose;
use super::graph::Course;
use super::graph::Graph;
use super::graph::Plotted;
use super::graph::Stretch;

/// The reader of the subject of a graph.
struct Reader<'r, 'b> {
    builder: &'r mut Builder<'b>,
    plotted: Plotted,
    body: &'r str,
    /// The axis along which it is counted, by its position.
    position: usize,
}

/// How a stage moves bodies.
enum Moves<'a> {
    /// At once.
    Suddenly,
    /// All of them evenly.
    Evenly,
    /// These, by forces that are known at each moment.
    These(Vec<&'a str>),
}

/// A graph of a quantity of a body against time, over these stages.
pub(crate) fn read(
    ask: &Choose,
    (plotted, stages): (Plotted, &[usize]),
    builder: &mut Builder<'_>,
    path: &Path,
) -> Option<Graph> {
    let scene = builder.scene();
    let read = body(ask, builder, path).and_then(|body| Ok((body, axis(ask, scene, path)?)));
    let read = read.and_then(|(body, (position, axis, senses))| {
        let reader = Reader { builder: &mut *builder, plotted, body: &body, position };
        reader.graph(stages, axis, &senses).map_err(|fault| fault.at_path(path.key("pictures")))
    });
    read.map_err(|fault| builder.fault(fault)).ok()
}

/// The body that is meant.
fn body(ask: &Choose, builder: &Builder<'_>, path: &Path) -> Result<String, Fault> {
    let all: Vec<&str> = builder.bodies().collect();
    match (&ask.of, &all[..]) {
        (Some(name), _) if all.contains(&name.as_str()) => Ok(name.clone()),
        (Some(name), _) => {
            let fault = Fault::new(Code::UnknownName, format!("there is no body `{name}`"));
            Err(fault.help(format!("the bodies are: {}", all.join(", "))).at_path(path.key("of")))
        }
        (None, [only]) => Ok((*only).to_owned()),
        (None, _) => {
            let fault = Fault::new(Code::MissingKey, "the question does not say of which body the graphs are");
            let help = format!("add `of:` with one of these: {}", all.join(", "));
            Err(fault.help(help).at_path(path.key("pictures")))
        }
    }
}

/// The axis that is meant, and its place among those of the scene.
fn axis(ask: &Choose, scene: &Scene, path: &Path) -> Result<(usize, Axis, Senses), Fault> {
    let axes = scene.axes.rectangular();
    let letters: Vec<&str> = axes.iter().map(|(axis, _)| axis.letter()).collect();
    let position = match ask.along {
        Some(asked) => axes.iter().position(|(axis, _)| *axis == asked),
        None => (axes.len() == 1).then_some(0),
    };
    let found_axis = position.and_then(|place| axes.get(place).map(|(axis, senses)| (place, *axis, senses.clone())));
    found_axis.ok_or_else(|| match (ask.along, &letters[..]) {
        (_, []) => {
            let fault = Fault::new(Code::Value, "graphs against time need rectangular axes");
            fault
                .help("write the axes with their directions: `axes: { x: to the right }`")
                .at_path(path.key("pictures"))
        }
        (Some(asked), _) => {
            let fault = Fault::new(Code::UnknownName, format!("the scene has no axis `{}`", asked.letter()));
            fault.help(format!("the axes are: {}", letters.join(", "))).at_path(path.key("along"))
        }
        (None, _) => {
            let fault = Fault::new(Code::MissingKey, "the question does not say along which axis the graphs are");
            let help = format!("add `along:` with one of these: {}", letters.join(", "));
            fault.help(help).at_path(path.key("pictures"))
        }
    })
}

fn on_slope(scene: &Scene, stage: usize) -> bool {
    let stage = scene.stages.get(stage);
    matches!(stage, Some(Stage::Slide(slide)) if slide.incline.is_some())
        || matches!(stage, Some(Stage::Push(push)) if push.incline.is_some())
}

/// A force whose graph the sheet prints cannot be asked for.
fn not_on_the_sheet(scene: &Scene, stages: &[usize]) -> Result<(), Fault> {
    let is_graph = |force: &Force| matches!(force, Force::Pull(pull) if matches!(pull.value, Strength::Graph(_)));
    let shows = |push: &Push| push.forces.iter().any(is_graph);
    let is_shown = |stage: &usize| matches!(scene.stages.get(*stage), Some(Stage::Push(push)) if shows(push));
    if stages.iter().any(is_shown) {
        let fault = Fault::new(Code::Value, "the sheet shows the graph of the force, which is what is asked for");
        return Err(fault.help("ask for the momentum or the velocity against time, or give the force as a term in `t`"));
    }
    Ok(())
}

/// How a stage moves bodies, where their velocities are known at each moment.
fn moves(stage: &Stage) -> Option<Moves<'_>> {
    match stage {
        Stage::Impact(_) | Stage::Blow(_) | Stage::Separate(_) => Some(Moves::Suddenly),
        Stage::Drift(_) => Some(Moves::Evenly),
        Stage::Push(push) => {
            // A body at rest may stay so for a while.
            let may_rest = push
                .forces
                .iter()
                .any(|force| matches!(force, Force::Friction(force) if force.friction.at_rest.is_some()));
            (push.resistance.is_none() && push.mass_change().is_none() && !may_rest)
                .then(|| Moves::These(push.pushed().collect()))
        }
        Stage::Slide(slide) => (!slide.is_ramp()).then(|| Moves::These(vec![&slide.body])),
        Stage::Fall(fall) => Some(Moves::These(vec![&fall.body])),
        Stage::Flight(flight) => flight.is_free().then(|| Moves::These(flight.flying().collect())),
        Stage::Motion(motion) => {
            (!matches!(motion.during, Some(During::Between(_)))).then(|| Moves::These(vec![&motion.body]))
        }
        Stage::Spring(_)
        | Stage::Swing(_)
        | Stage::Taut(_)
        | Stage::Connected(_)
        | Stage::Tow(_)
        | Stage::Rotate(_)
        | Stage::Moment(_)
        | Stage::Strike(_)
        | Stage::Conical(_)
        | Stage::Bowl(_)
        | Stage::Interact(_)
        | Stage::Central(_)
        | Stage::Bounces(_)
        | Stage::Stream(_)
        | Stage::Thrust(_)
        | Stage::SlideOff(_)
        | Stage::Walk(_) => None,
    }
}

/// Which sense of an axis is positive, as a sentence.
fn positive(senses: &Senses) -> String {
    let mut words = senses.positive.chars();
    let first = words.next().map(|letter| letter.to_uppercase().collect::<String>()).unwrap_or_default();
    format!("{first}{} is positive.", words.as_str())
}

impl Reader<'_, '_> {
    fn graph(mut self, stages: &[usize], axis: Axis, senses: &Senses) -> Result<Graph, Fault> {
        let scene = self.builder.scene();
        let stretches = stages.iter().map(|stage| self.stretch(*stage)).collect::<Result<Vec<Stretch>, Fault>>()?;
        if self.plotted == Plotted::Force {
            not_on_the_sheet(scene, stages)?;
        }
        let ends =
            [stretches.first(), stretches.last()].map(|stretch| stretch.filter(|stretch| stretch.course.is_none()));
        let falls = scene.plane == Plane::Vertical && senses.rise().is_some();
        if let (Some(stretch), true) =
            (ends.into_iter().flatten().next(), falls || stages.iter().any(|index| on_slope(scene, *index)))
        {
            let phrase = &stretch.phrase;
            let message =
                format!("weight changes the velocity before or after {phrase}, and no stage says for how long");
            return Err(Fault::new(Code::Value, message).help("add the flight before it and the flight after it"));
        }
        Ok(Graph {
            plotted: self.plotted,
            body: self.body.to_owned(),
            along: (scene.axes.rectangular().len() > 1).then_some(axis),
            positive: positive(senses),
            idle: ends.map(|stretch| stretch.is_some()),
            stretches,
        })
    }

    fn stretch(&mut self, stage: usize) -> Result<Stretch, Fault> {
        let phrase = self.builder.phrase_of(stage);
        let moving = self.builder.scene().stages.get(stage).and_then(moves).ok_or_else(|| self.unknown(&phrase))?;
        let [before, after] = [stage + 1, stage + 2].map(|instant| self.builder.moves_with(self.body, instant));
        let name = self.builder.name_of(self.body);
        let (Some(before), Some(after)) = (before, after) else {
            let fault = Fault::new(Code::Value, format!("{name} is not there both before and after {phrase}"));
            return Err(fault.help("name a stage before which and after which it is there: `stage:`"));
        };
        let ends = [(&before, stage + 1), (&after, stage + 2)].map(|(whole, instant)| self.state(whole, instant));
        let [Some(first), Some(last)] = ends else { return Err(self.unknown(&phrase)) };
        let course = match moving {
            Moves::Suddenly if self.plotted == Plotted::Force => {
                let fault = Fault::new(Code::Value, format!("nothing says how the force changes during {phrase}"));
                return Err(fault.help("name a stage that lasts: `stage:`"));
            }
            Moves::Suddenly => None,
            Moves::These(bodies) if !bodies.contains(&before.as_str()) => {
                let fault = Fault::new(Code::Value, format!("{phrase} does not say how {name} moves meanwhile"));
                return Err(fault.help(format!("name a stage that moves {name}: `stage:`")));
            }
            Moves::These(_) | Moves::Evenly => {
                Some(self.course(stage, &before, &first).ok_or_else(|| self.unknown(&phrase))?)
            }
        };
        let ends = if self.plotted == Plotted::Force { [Expr::zero(), Expr::zero()] } else { [first, last] };
        Ok(Stretch { stage, phrase, ends, course })
    }

    fn unknown(&self, phrase: &str) -> Fault {
        let message = format!("{} is not known at each moment of {phrase}", self.plotted.noun());
        let help = "graphs can be asked for sudden stages and for these, where forces depend on the time at most: push, slide, fall, flight, drift, motion";
        Fault::new(Code::Value, message).help(help)
    }

    /// The state that changes, as the body has it at an instant.
    fn state(&mut self, whole: &str, instant: usize) -> Option<Expr> {
        match self.plotted {
            Plotted::Velocity => self.builder.velocities_of(whole, instant).get(self.position).cloned(),
            Plotted::Momentum => self.builder.momentum_with(self.body, whole, instant).get(self.position).cloned(),
            Plotted::Force => Some(Expr::zero()),
        }
    }

    /// How a body with that state at the start moves on in a stage; none where that is not known at each moment.
    fn course(&mut self, stage: usize, whole: &str, first: &Expr) -> Option<Course> {
        let clock = self.builder.symbols().find("t");
        let during = self.builder.span_of(stage)?;
        let here =
            self.builder.influences().iter().filter(|influence| influence.stage == stage && influence.on == whole);
        let forces = here.map(|influence| match influence.along(self.position) {
            Effect::Of(force) => Some(force.clone()),
            Effect::Open => None,
        });
        let forces = forces.collect::<Option<Vec<Expr>>>()?;
        let factor = match self.plotted {
            Plotted::Velocity => self.builder.mass_of(whole, stage + 1).powi(-1),
            Plotted::Momentum if whole != self.body => {
                let [share, all] = [self.body, whole].map(|body| self.builder.mass_of(body, stage + 1));
                share / all
            }
            Plotted::Momentum | Plotted::Force => Expr::one(),
        };
        let written_out = |force: Expr| force.substitute(&|symbol| self.pressing(symbol));
        let parts = forces.into_iter().map(|force| (written_out(force) * factor.clone()).simplify());
        let rate = Expr::sum(parts).simplify();
        let is_place = |symbol: &Symbol| matches!(self.builder.name(*symbol).kind, QuantityKind::Coordinate(_));
        if rate.symbols().iter().chain(&first.symbols()).any(is_place) {
            return None;
        }
        let clock = clock.filter(|clock| rate.contains(*clock));
        let gained = match clock {
            Some(clock) => Some(rate.definite(clock, &during[0], &clock.into())?),
            None => None,
        };
        let mut breaks = Vec::new();
        breaks_of(&rate, &mut breaks);
        Some(Course { clock, during, rate, gained, breaks })
    }

    /// The term of a normal force, so that a mass that cancels need not be known.
    fn pressing(&self, symbol: Symbol) -> Option<Expr> {
        if self.builder.name(symbol).kind != QuantityKind::NormalForce {
            return None;
        }
        self.builder.system().equations.iter().find_map(|equation| match &equation.statement {
            Statement::Equal { left, right } if *left == Expr::from(symbol) => Some(right.clone()),
            _ => None,
        })
    }
}

/// The ends of the pieces of a term.
fn breaks_of(term: &Expr, breaks: &mut Vec<Expr>) {
    match term {
        Expr::Sum(parts) | Expr::Product(parts) => parts.iter().for_each(|part| breaks_of(part, breaks)),
        Expr::Piecewise(piecewise) => breaks.extend(piecewise.pieces.iter().filter_map(|(until, _)| until.clone())),
        _ => {}
    }
}
