//! What programs compute: values, chosen roots, dead branches, regimes.

use momentous::expr::Symbol;
use momentous::quantity::Rational;
use momentous::solve::{Audit, Bounded, Cause, Exact, Outcome, Plan, Precise, Program, Relation, Tree, TreeWorkspace};
use momentous::solve::{Verify, Workspace, Workspaces, audit};

use crate::world::World;

/// A decimal or a fraction, exactly.
pub fn exact(text: &str) -> Exact {
    let (number, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, decimals) = number.split_once('.').unwrap_or((number, ""));
    let digits: Rational = format!("{whole}{decimals}").parse().expect("digits");
    let power = exponent.parse::<isize>().expect("an exponent") - isize::try_from(decimals.len()).expect("short");
    (digits * Rational::from(10).pow(power)).into()
}

/// A plan for some wanted symbols, compiled; everything that can be verified is.
pub struct Solver {
    pub world: World,
    pub program: Program,
    pub plan: Plan,
    inputs: Vec<Exact>,
    workspaces: Workspaces,
}

impl Solver {
    /// `givens` are written `name=value`.
    pub fn new(mut world: World, givens: &str, wanted: &str) -> Self {
        let (known, inputs): (Vec<Symbol>, Vec<Exact>) = givens
            .split_whitespace()
            .map(|given| given.split_once('=').expect("name=value"))
            .map(|(name, value)| (world.symbol(name), exact(value)))
            .unzip();
        let wanted = world.symbols(wanted);
        let set = known.iter().copied().collect();
        let plan = momentous::solve::plan(&world.system, &set, &wanted).expect("a plan");
        let audit: Audit = audit(&world.system, &set, &plan);
        let program = Program::compile(&world.system, &audit, &known, &wanted, Verify::All).expect("it compiles");
        Self { world, program, plan: audit.plan, inputs, workspaces: Workspaces::default() }
    }

    pub fn solve(&mut self) -> Outcome<'_, Bounded> {
        self.program.solve(&self.inputs, &mut self.workspaces)
    }

    pub fn value(&mut self, name: &str) -> Bounded {
        let symbol = self.world.symbol(name);
        let outcome = self.program.solve(&self.inputs, &mut self.workspaces);
        assert_eq!(outcome.survivors(), 1, "{:?}", outcome.dead());
        *outcome.value(symbol).expect("a value")
    }

    /// The true value to fifty digits.
    pub fn digits(&mut self, name: &str) -> String {
        let symbol = self.world.symbol(name);
        let mut workspace = Workspace::<Precise>::default();
        let outcome = self.program.run_exact(&self.inputs, &mut workspace);
        outcome.value(symbol).and_then(|value| value.decimal(50)).expect("a value")
    }
}

#[track_caller]
pub fn near(found: Bounded, expected: f64) {
    let slack = found.error + expected.abs() * 1e-13;
    assert!((found.value - expected).abs() <= slack, "{found:?} is not {expected}");
    assert!(found.error <= 1e-10 * expected.abs().max(1e-3), "{found:?} is loose");
}

#[test]
fn two_carts() {
    let mut solver = Solver::new(World::impact(), "m_A=3 m_B=2 v_A1=3 v_B1=-2 e=0.7", "v_A2 v_B2 T_1 T_2 T_lost J_A");
    for (name, value) in [("v_A2", -0.4), ("v_B2", 3.1), ("T_1", 17.5), ("T_2", 9.85), ("T_lost", 7.65), ("J_A", -10.2)]
    {
        near(solver.value(name), value);
    }
}

#[test]
fn restitution_from_the_energy_lost_is_not_negative() {
    let mut solver = Solver::new(World::impact(), "m_A=3 m_B=2 v_A1=3 v_B1=-2 T_lost=9.6", "e");
    near(solver.value("e"), 0.6);
    let e = solver.world.symbol("e");
    let plan = solver.plan.clone();
    let outcome = solver.solve();
    let [death] = outcome.dead() else { panic!("{:?}", outcome.dead()) };
    let step = &plan.steps[death.step.expect("a step")];
    let place = step.unknowns.iter().position(|symbol| *symbol == e);
    match place {
        Some(place) => {
            assert_eq!(death.cause, Cause::Condition(0));
            near(outcome.values_at_death(death)[place], -0.6);
        }
        None => assert_eq!(death.cause, Cause::Condition(2), "the bodies pass through each other"),
    }
    assert!(!outcome.choices_at_death(death).is_empty());
}

#[test]
fn nothing_is_lost_exactly() {
    let mut solver = Solver::new(World::impact(), "m_A=0.3 m_B=0.7 v_A1=1.1 v_B1=-2.3 e=1", "T_lost");
    assert_eq!(solver.value("T_lost"), Bounded::exactly(0.0));
}

#[test]
fn a_ball_at_rest_stays_exactly_zero() {
    // m_A v_A1 = m_B v_A1 e: the first body stops dead.
    let mut solver = Solver::new(World::impact(), "m_A=0.7 m_B=1 v_A1=1.3 v_B1=0 e=0.7", "v_A2");
    assert_eq!(solver.value("v_A2"), Bounded::exactly(0.0));
}

#[test]
fn a_plastic_impact_is_decided() {
    let mut solver = Solver::new(World::impact(), "m_A=0.1 m_B=0.3 v_A1=0.7 v_B1=-0.9 e=0", "v_A2 v_B2");
    let outcome = solver.solve();
    assert!(outcome.is_decided());
    near(solver.value("v_A2"), -0.5);
    near(solver.value("v_B2"), -0.5);
}

#[test]
fn the_energy_lost_at_nearly_equal_speeds_keeps_its_digits() {
    let mut solver = Solver::new(World::impact(), "m_A=3 m_B=2 v_A1=1000.001 v_B1=1000 e=0.7", "T_lost");
    near(solver.value("T_lost"), 0.6 * (1.0 - 0.49) * 1e-6);
}

#[test]
fn the_earth_as_a_wall() {
    let mut solver = Solver::new(World::impact(), "m_A=0.25 m_B=5.97e24 v_A1=4 v_B1=0 e=0.75", "v_A2 v_B2 T_lost");
    near(solver.value("v_A2"), -3.0);
    let recoil = solver.value("v_B2");
    assert!((recoil.value - 0.25 * 7.0 / 5.97e24).abs() <= 1e-12 * recoil.value);
    assert!(recoil.error <= 1e-11 * recoil.value);
    near(solver.value("T_lost"), 0.5 * 0.25 * 16.0 * (1.0 - 0.5625));
}

#[test]
fn the_small_root_keeps_its_digits() {
    let mut world = World::new(&["0 = h + v*t - 1/2*g*t^2"]);
    world.condition("t", Relation::AtLeast, "0");
    let mut solver = Solver::new(world, "h=1e-12 v=-3 g=9.81", "t");
    let t = solver.value("t");
    assert!((t.value - 3.333_333_333_333_333e-13).abs() < 1e-24, "{t:?}");
    assert!(t.error < 1e-11 * t.value, "{t:?}");
    let outcome = solver.solve();
    assert_eq!(outcome.dead().len(), 1);
    assert!(!outcome.is_exact_replay(), "the stable form needs no exact replay");
}

#[test]
fn a_double_root_counts_once() {
    let world = World::new(&["x^2 - 2*a*x + a^2 = 0*b"]);
    let mut solver = Solver::new(world, "a=0.1", "x");
    let outcome = solver.solve();
    assert_eq!(outcome.survivors(), 1);
    near(solver.value("x"), 0.1);
}

#[test]
fn two_true_roots_are_ambiguous_and_none_is_none() {
    let world = || World::new(&["x^2 + x = c"]);
    assert_eq!(Solver::new(world(), "c=2", "x").solve().survivors(), 2);
    let mut none = Solver::new(world(), "c=-2", "x");
    let outcome = none.solve();
    assert_eq!(outcome.survivors(), 0);
    assert!(outcome.dead().iter().all(|death| death.cause == Cause::NotReal));
    assert_eq!(outcome.dead().len(), 2);
}

#[test]
fn a_ballistic_pendulum_backward() {
    let mut world = World::new(&["1/2*(m + M)*V^2 = (m + M)*g*h", "m*v = (m + M)*V"]);
    world.positive("V v");
    let mut solver = Solver::new(world, "m=0.01 M=1.99 g=9.81 h=0.05", "v");
    near(solver.value("v"), 200.0 * (2.0_f64 * 9.81 * 0.05).sqrt());
}

#[test]
fn polar_values() {
    let mut world = World::new(&["m*v*cos(theta) = p_x", "m*v*sin(theta) = p_y"]);
    world.positive("v");
    let mut solver = Solver::new(world, "m=2 p_x=-6 p_y=8", "theta v");
    near(solver.value("v"), 5.0);
    near(solver.value("theta"), libm::atan2(8.0, -6.0));
}

#[test]
fn an_oblique_polar_pair() {
    let world = World::new(&["v*cos(t) + v*sin(t) = a", "v*cos(t) - 2*v*sin(t) = b"]);
    let mut solver = Solver::new(world, "a=3 b=-3", "v t");
    near(solver.value("v"), 5.0_f64.sqrt());
    near(solver.value("t"), libm::atan2(2.0, 1.0));
}

#[test]
fn bounces_are_counted() {
    let mut world = World::new(&["h_n = h*e^(2*n)"]);
    world.first_integer("n", 0, "h*e^(2*n)", Relation::Less, "h_min");
    let mut solver = Solver::new(world, "h=4 e=0.75 h_min=0.01", "h_n n");
    assert_eq!(solver.value("n"), Bounded::exactly(11.0));
    // At equality the strict condition does not hold yet.
    let mut world = World::default();
    world.first_integer("n", 0, "h*e^(2*n)", Relation::Less, "h_min");
    let mut solver = Solver::new(world, "h=0.4 e=0.5 h_min=0.025", "n");
    assert_eq!(solver.value("n"), Bounded::exactly(3.0));
}

#[test]
fn long_counts_and_counts_without_end() {
    let mut world = World::default();
    world.first_integer("n", 1, "q^n", Relation::Less, "1/1000");
    let mut solver = Solver::new(world, "q=0.99999", "n");
    assert_eq!(solver.value("n"), Bounded::exactly(690_773.0));
    let mut world = World::default();
    world.first_integer("n", 1, "q*n", Relation::Less, "0");
    assert_eq!(Solver::new(world, "q=1", "n").solve().survivors(), 0);
}

#[test]
fn bracketed_roots_have_true_bounds() {
    let mut solver = Solver::new(World::new(&["t + exp(t) = a"]), "a=3", "t");
    let t = solver.value("t");
    // W-function reference: 3 - W(exp 3).
    near(t, 0.792_059_968_430_677_9);
    assert!(t.error < 1e-13, "{t:?}");
    assert!(solver.digits("t").starts_with("0.7920599684306770"), "{}", solver.digits("t"));
    let mut none = Solver::new(World::new(&["exp(t) + t^2 = a"]), "a=-1", "t");
    assert_eq!(none.solve().survivors(), 0);
}

#[test]
fn a_pole_is_no_root() {
    let mut solver = Solver::new(World::new(&["tan(t) - t*a = 0*t^2"]), "a=1", "t");
    let symbol = solver.world.symbol("t");
    let outcome = solver.solve();
    assert_eq!(outcome.survivors(), 2);
    near(*outcome.value(symbol).unwrap(), 4.493_409_457_909_064);
    near(*outcome.value_in(1, symbol).unwrap(), 7.725_251_836_937_707);
}

#[test]
fn redundant_givens_choose_among_roots_or_contradict() {
    let world = || World::new(&["v^2 = 2*a*s", "v = a*t"]);
    let mut solver = Solver::new(world(), "a=2 s=9 t=3", "v");
    near(solver.value("v"), 6.0);
    let mut wrong = Solver::new(world(), "a=2 s=9 t=3.1 v=6", "");
    let outcome = wrong.solve();
    assert_eq!(outcome.survivors(), 0);
    assert_eq!(outcome.dead()[0].cause, Cause::Equation(1));
}

#[test]
fn a_root_of_the_wrong_sign_is_no_solution() {
    let mut solver = Solver::new(World::new(&["sqrt(x) = c"]), "c=-2", "x");
    assert!(matches!(solver.solve().dead()[0].cause, Cause::Equation(0)));
}

#[test]
fn angles_are_exact_multiples_of_pi() {
    let mut world = World::new(&["x = v*cos(2*a) - v/2"]);
    let known = world.set("v a");
    let (inputs, wanted) = (world.symbols("v a"), world.symbols("x"));
    let plan = momentous::solve::plan(&world.system, &known, &wanted).expect("a plan");
    let audit = audit(&world.system, &known, &plan);
    let program = Program::compile(&world.system, &audit, &inputs, &wanted, Verify::All).expect("it compiles");
    let thirty_degrees = Exact { rational: Rational::ONE / Rational::from(6), pi_power: 1 };
    let mut workspaces = Workspaces::default();
    let outcome = program.solve(&[exact("0.7"), thirty_degrees], &mut workspaces);
    let x = outcome.value(wanted[0]).expect("a value");
    assert!(x.value.abs() <= x.error && x.error < 1e-70, "{x:?}");
}

#[test]
fn regimes_are_tried_in_order() {
    let leaf = |slides: bool| {
        let mut world = World::new(&[if slides { "a = (F - mu*m*g)/m" } else { "a = 0*F" }]);
        world.condition("F - mu*m*g", if slides { Relation::Greater } else { Relation::AtMost }, "0");
        let (inputs, wanted) = (world.symbols("F mu m g"), world.symbols("a"));
        let known = inputs.iter().copied().collect();
        let plan = momentous::solve::plan(&world.system, &known, &wanted).expect("a plan");
        let audit = audit(&world.system, &known, &plan);
        (Program::compile(&world.system, &audit, &inputs, &wanted, Verify::All).expect("it compiles"), wanted[0])
    };
    let ((slides, a), (stays, b)) = (leaf(true), leaf(false));
    let tree = Tree { leaves: vec![slides, stays] };
    let mut workspace = TreeWorkspace::default();
    let inputs = |force: &str| [force, "0.3", "2", "10"].map(exact);
    assert_eq!(tree.solve(&inputs("8"), &mut workspace), Some(0));
    near(*tree.outcome(0, &workspace).and_then(|outcome| outcome.value(a)).expect("a value"), 1.0);
    assert!(tree.outcome(1, &workspace).is_none());
    // Exactly at the limit of static friction it stays, whatever floating point makes of 0.3.
    assert_eq!(tree.solve(&inputs("6"), &mut workspace), Some(1));
    let why = tree.outcome(0, &workspace).expect("it was tried");
    assert_eq!((why.dead()[0].step, why.dead()[0].cause), (None, Cause::Condition(0)));
    assert_eq!(tree.outcome(1, &workspace).and_then(|outcome| outcome.value(b)).map(|value| value.value), Some(0.0));
}
