//! Names that an author chose for something, and that the scene itself makes for something else.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;

use super::Builder;
use super::Name;
use super::QuantityKind;

/// The words for the time that runs within a stage.
const RUNNING: &str = "the time";

impl Builder<'_> {
    /// The time that runs within a stage.
    pub(super) fn running_time(&mut self) -> Symbol {
        self.symbol(Name::of(QuantityKind::Time, ""), RUNNING)
    }

    /// Notes that the author named a quantity at a place of the scene.
    pub(super) fn named_at(&mut self, symbol: Symbol, path: &Path) {
        self.named.entry(symbol).or_insert_with(|| path.clone());
    }

    /// A fault where what is fixed has the name of the time that runs.
    pub(super) fn not_the_running_time(&mut self, symbol: Symbol, path: &Path) {
        if self.name(symbol).kind == QuantityKind::Time && self.symbols.entry(symbol).meaning == RUNNING {
            self.named_at(symbol, path);
            self.collision(symbol, "the running time of a stage", "a fixed time");
        }
    }

    /// A fault where the scene makes a quantity under a name that the author gave to another.
    pub(super) fn made_by_the_scene(&mut self, symbol: Symbol, meaning: &str) {
        let known = self.symbols.entry(symbol).meaning.clone();
        if self.named.contains_key(&symbol) && !known.is_empty() && known != meaning {
            self.collision(symbol, meaning, &known);
        }
    }

    fn collision(&mut self, symbol: Symbol, meaning: &str, other: &str) {
        let name = self.symbols.entry(symbol).name.clone();
        let given = || Path::root().key("given").name(name.as_str());
        let path =
            if self.given.contains(&name) { given() } else { self.named.get(&symbol).cloned().unwrap_or_default() };
        let message = format!("`{name}` stands for {meaning}; it cannot stand for {other} as well");
        let fault = Fault::new(Code::Duplicate, message).help("choose another name").at_path(path);
        if !self.faults.contains(&fault) {
            self.faults.push(fault);
        }
    }

    /// The time from the start to an instant as a sum of durations, where those of all stages before it are used.
    pub(super) fn time_until(&self, instant: usize) -> Option<Expr> {
        let lasting = self.lasting.iter().zip(&self.scene.stages).take(instant.checked_sub(1)?);
        let durations = lasting.filter(|(_, stage)| stage.takes_time()).map(|(duration, _)| duration.clone());
        Some(Expr::sum(durations.collect::<Option<Vec<_>>>()?))
    }

    /// Looks at the names `t_1`, `t_2`, ... that are given or stand in the scene: each is the time at its instant, or it is a
    /// fault.
    pub(super) fn times_of_instants(&mut self) {
        for instant in 1..=self.timeline.last() {
            let Some(symbol) = self.symbols.find(&Name::of(QuantityKind::Time, "").at(instant).to_string()) else {
                continue;
            };
            let Some(time) = self.time_until(instant) else { continue };
            // One that nobody named was made as the time at its instant.
            let is_own = !self.named.contains_key(&symbol) && !self.given.contains(&self.symbols.entry(symbol).name);
            if is_own || time.simplify() == Expr::from(symbol) {
                continue;
            }
            if instant > 1 && !self.speaks_of(symbol) {
                self.clock(instant);
                continue;
            }
            let time = format!("the time {}, measured from the start", self.when(instant));
            let known = self.symbols.entry(symbol).meaning.clone();
            self.collision(symbol, &time, if known.is_empty() { "another time" } else { &known });
        }
    }

    /// Whether a stage has put a quantity into an equation.
    fn speaks_of(&self, symbol: Symbol) -> bool {
        let stated = self.choices.iter().flatten().flat_map(|way| &way.equations);
        self.system.equations.iter().chain(stated).any(|equation| equation.symbols().contains(&symbol))
    }
}
