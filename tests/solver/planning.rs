//! Which equations a plan takes, and what it says where there is none.

use std::f64::consts::FRAC_PI_2;

use momentous::expr::{Expr, equal};
use momentous::solve::{Closed, Move, Plan, Reason, Relation, Tactic, audit};

use crate::world::World;

fn equations(plan: &Plan) -> Vec<Vec<usize>> {
    plan.steps.iter().map(|step| step.equations.clone()).collect()
}

fn formula(plan: &Plan, step: usize, root: usize, value: usize) -> Expr {
    match &plan.steps[step].roots[root].values[value].1 {
        Closed::Formula(formula) => formula.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn conservation_and_restitution_give_the_velocities() {
    let mut world = World::impact();
    let plan = world.plan("m_A m_B v_A1 v_B1 e", "v_A2").expect("a plan");
    assert_eq!(equations(&plan), [[3, 4]]);
    assert_eq!(plan.steps[0].tactic, Tactic::Linear);
    let taught = world.expr("(m_A*v_A1 + m_B*v_B1 - m_B*e*(v_A1 - v_B1))/(m_A + m_B)");
    assert!(equal(&formula(&plan, 0, 0, 0), &taught), "{:?}", formula(&plan, 0, 0, 0));
    let moves = &plan.steps[0].moves;
    assert!(matches!(moves[0], Move::Combine { equation: 3, times: 4, .. }), "{moves:?}");
    assert_eq!(moves.len(), 3);
}

#[test]
fn the_impulse_comes_from_one_body_once_its_velocity_is_known() {
    let mut world = World::impact();
    let plan = world.plan("m_A m_B v_A1 v_B1 e", "J_A").expect("a plan");
    assert_eq!(equations(&plan), [vec![3, 4], vec![0]]);
}

#[test]
fn restitution_backward_from_the_energy_lost_has_two_roots() {
    let mut world = World::impact();
    let plan = world.plan("m_A m_B v_A1 v_B1 T_lost", "e").expect("a plan");
    assert_eq!(plan.steps.last().map(|step| step.unknowns.len()), Some(1));
    let torn = plan.steps.iter().find(|step| step.tactic == Tactic::Tear).expect("a torn block");
    assert_eq!(torn.roots.len(), 2);
}

#[test]
fn an_isolated_unknown_is_written_as_on_paper() {
    let mut world = World::new(&["m*v_2 = m*v_1 + J"]);
    let plan = world.plan("m v_1 J", "v_2").expect("a plan");
    let taught = world.expr("v_1 + J/m");
    assert_eq!(formula(&plan, 0, 0, 0), taught);
}

#[test]
fn a_speed_takes_the_positive_root_only() {
    let mut world = World::new(&["1/2*M*V^2 = M*g*h", "m*v = (m + M)*V"]);
    world.positive("V");
    let plan = world.plan("m M g h", "v").expect("a plan");
    assert_eq!(equations(&plan), [[0], [1]]);
    assert_eq!(plan.steps[0].roots.len(), 1);
}

/// The momenta of two bodies at the angles a and b have the components p and q.
fn crossing(angles: [Expr; 2]) -> (World, Plan) {
    let mut world = World::new(&["m*v_A*cos(a) + m*v_B*cos(b) = p", "m*v_A*sin(a) + m*v_B*sin(b) = q"]);
    world.system.values = world.symbols("a b").into_iter().zip(angles).collect();
    let plan = world.plan("m p q a b", "v_A v_B").expect("a plan");
    (world, plan)
}

#[test]
fn nothing_is_divided_by_what_is_zero_at_the_values_known_beforehand() {
    let turned = |quarters: i32| Expr::Pi * Expr::ratio(quarters.into(), 2);
    // In quarters of a turn; by hand, with m = 2, p = 6 and q = 10.
    for (a, b, speeds) in [(1, 2, [5.0, -3.0]), (1, 0, [5.0, 3.0]), (0, 1, [3.0, 5.0]), (2, 3, [-3.0, -5.0])] {
        let (mut world, plan) = crossing([turned(a), turned(b)]);
        let names = world.symbols("m v_A a v_B b p q");
        let mut values = [2.0, f64::NAN, 0.0, f64::NAN, 0.0, 6.0, 10.0];
        (values[2], values[4]) = (f64::from(a) * FRAC_PI_2, f64::from(b) * FRAC_PI_2);
        for (place, speed) in speeds.into_iter().enumerate() {
            let (unknown, Closed::Formula(formula)) = &plan.steps[0].roots[0].values[place] else { panic!("{plan:?}") };
            let at = |symbol| names.iter().position(|listed| *listed == symbol).map_or(f64::NAN, |place| values[place]);
            let found = formula.evaluate(&at);
            assert!((found - speed).abs() < 1e-9, "{a} {b}: {formula:?} = {found}");
            values[names.iter().position(|listed| listed == unknown).unwrap()] = found;
        }
    }
}

#[test]
fn values_known_beforehand_change_nothing_where_no_divisor_is_zero() {
    let plans = [Expr::integer(7), Expr::ratio(1, 2)].map(|angle| crossing([angle, Expr::ratio(1, 3)]).1);
    let [plain, valued] = plans.map(|plan| format!("{:?}", plan.steps));
    assert_eq!(plain, valued);
    assert!(!plain.contains("Vanish"), "{plain}");
}

#[test]
fn irrelevant_definitions_are_not_taken() {
    let mut world = World::impact();
    for index in 0..60 {
        world.equation(&format!("x_{index} = v_A2*{index} + x_{} + v_B2", index + 1));
        world.equation(&format!("y_{index} = v_A2^2 + v_B1*y_{}", index + 1));
    }
    let plan = world.plan("m_A m_B v_A1 v_B1 e x_60 y_60", "v_B2").expect("a plan");
    assert_eq!(equations(&plan), [[3, 4]]);
}

#[test]
fn an_underdetermined_system_names_what_would_do() {
    let mut world = World::impact();
    let stuck = world.plan("m_A m_B v_A1 v_B1", "v_A2").expect_err("e is missing");
    let wanted = world.symbols("v_A2");
    let Reason::Underdetermined { wanted: lost, enough } = stuck.reason else { panic!("{:?}", stuck.reason) };
    assert_eq!(lost, wanted);
    for name in ["e", "J_A", "v_B2", "T_lost"] {
        let symbol = world.symbol(name);
        assert!(enough.contains(&vec![symbol]), "{name} would do");
    }
    let c = world.symbol("v_c");
    assert!(!enough.contains(&vec![c]));
}

#[test]
fn a_symbol_of_no_equation_is_underdetermined() {
    let mut world = World::impact();
    let stuck = world.plan("m_A", "nowhere").expect_err("it stands nowhere");
    assert!(matches!(stuck.reason, Reason::Underdetermined { .. }));
}

#[test]
fn dependent_equations_do_not_determine() {
    let mut world = World::impact();
    // Structurally, the three equations of momentum would give three unknowns; they say the same twice.
    let stuck = world.plan("m_A m_B v_A1 v_B1", "J_A").expect_err("the impact's restitution is not given");
    assert!(matches!(stuck.reason, Reason::Underdetermined { .. }), "{:?}", stuck.reason);
}

#[test]
fn no_tactic_names_the_block() {
    let mut world = World::new(&["sin(x) + y^3 = a", "x*exp(y) + cos(y) = b"]);
    let stuck = world.plan("a b", "x").expect_err("no tactic");
    assert!(matches!(stuck.reason, Reason::NoTactic { ref equations, .. } if *equations == [0, 1]), "{stuck:?}");
}

#[test]
fn a_contradiction_is_told() {
    let mut world = World::new(&["x - x = 1"]);
    let stuck = world.plan("", "x").expect_err("0 = 1");
    assert!(matches!(stuck.reason, Reason::Contradiction { ref equations } if *equations == [0]), "{stuck:?}");
}

#[test]
fn another_subset_is_taken_where_a_block_cannot_be_closed() {
    let mut world = World::new(&["sin(x) + y^3 = a", "x*exp(y) + cos(y) = b", "5: x = 2*c", "5: y = x + c"]);
    let plan = world.plan("a b c", "y").expect("a plan");
    assert_eq!(equations(&plan), [[2], [0]]);
}

#[test]
fn redundant_givens_are_checks() {
    let mut world = World::impact();
    let known = world.set("m_A m_B v_A1 v_B1 e");
    let plan = world.plan("m_A m_B v_A1 v_B1 e", "v_A2").expect("a plan");
    let audit = audit(&world.system, &known, &plan);
    assert_eq!(audit.answer_steps, 1);
    let used: Vec<usize> = audit.plan.steps.iter().flat_map(|step| step.equations.clone()).collect();
    assert_eq!(used.len() + audit.checks.len(), world.system.equations.len());
    assert_eq!(audit.checks.len(), 1, "momentum of each body and Newton's third law are one more than needed");
}

#[test]
fn polar_components_give_magnitude_and_angle() {
    let mut world = World::new(&["m*v*cos(theta) = p_x", "m*v*sin(theta) = p_y"]);
    world.positive("v");
    let plan = world.plan("m p_x p_y", "theta v").expect("a plan");
    assert_eq!(plan.steps[0].tactic, Tactic::Polar);
}

/// Every root of a step, put into an equation with these values: what the sides differ by.
fn residuals(world: &mut World, plan: &Plan, equation: &str, values: &[(&str, f64)]) -> Vec<f64> {
    let (left, right) = equation.split_once('=').expect("two sides");
    let difference = world.expr(left) - world.expr(right);
    let known: Vec<_> = values.iter().map(|(name, value)| (world.symbol(name), *value)).collect();
    let step = &plan.steps[0];
    let of_root = |root: usize| {
        let mut all = known.clone();
        for value in 0..step.unknowns.len() {
            let at = |symbol| all.iter().find(|(listed, _)| *listed == symbol).map_or(f64::NAN, |(_, value)| *value);
            let found = formula(plan, 0, root, value).evaluate(&at);
            all.push((step.unknowns[value], found));
        }
        let at = |symbol| all.iter().find(|(listed, _)| *listed == symbol).map_or(f64::NAN, |(_, value)| *value);
        difference.evaluate(&at)
    };
    (0..step.roots.len()).map(of_root).collect()
}

#[test]
fn sine_and_cosine_of_one_angle_give_its_tangent() {
    let equation = "v*cos(beta) - 2*u*sin(beta) = w*cos(beta)";
    let mut world = World::new(&[equation]);
    let plan = world.plan("u v w", "beta").expect("a plan");
    assert_eq!(plan.steps[0].tactic, Tactic::Tangent);
    let left = residuals(&mut world, &plan, equation, &[("u", 2.0), ("v", 1.0), ("w", 4.0)]);
    assert!(left.len() == 2 && left.iter().all(|left| left.abs() < 1e-12), "{left:?}");
    // With a part that is neither, there is no tangent.
    let mut other = World::new(&["v*cos(beta) - u*sin(beta) = w"]);
    assert!(!other.plan("u v w", "beta").is_ok_and(|plan| plan.steps[0].tactic == Tactic::Tangent));
}

#[test]
fn a_quadratic_equation_in_a_square_has_both_squares() {
    let equation = "a*t^4 - b*t^2 + c = 0";
    let values = [("a", 1.0), ("b", 5.0), ("c", 4.0)];
    let mut world = World::new(&[equation]);
    world.positive("t");
    let plan = world.plan("a b c", "t").expect("a plan");
    assert_eq!(plan.steps[0].tactic, Tactic::Quadratic);
    let left = residuals(&mut world, &plan, equation, &values);
    assert!(left.len() == 2 && left.iter().all(|left| left.abs() < 1e-12), "{left:?}");
    // Of either sign, each square has two roots.
    let mut either = World::new(&[equation]);
    let plan = either.plan("a b c", "t").expect("a plan");
    let left = residuals(&mut either, &plan, equation, &values);
    assert!(left.len() == 4 && left.iter().all(|left| left.abs() < 1e-12), "{left:?}");
}

#[test]
fn counts_stand_alone() {
    let mut world = World::new(&["h_n = h*e^(2*n)"]);
    world.first_integer("n", 1, "h*e^(2*n)", Relation::Less, "h_min");
    let plan = world.plan("h e h_min", "h_n").expect("a plan");
    assert_eq!(plan.steps[0].tactic, Tactic::Count);
    assert_eq!(equations(&plan), [[1], [0]]);
}

#[test]
fn what_has_no_formula_is_bracketed() {
    let mut world = World::new(&["t + exp(t) = a"]);
    let plan = world.plan("a", "t").expect("a plan");
    assert_eq!(plan.steps[0].tactic, Tactic::BracketedRoot);
}

#[test]
fn many_bodies_whose_momenta_say_the_same_twice_are_told_fast() {
    let mut world = World::default();
    let mut known = String::from("e_0");
    for body in 0..8 {
        let next = body + 1;
        world.equation(&format!("m_{body}*v_{body} = m_{body}*u_{body} + J_{body} - J_{next}"));
        world.equation(&format!(
            "2: m_{body}*v_{body} + m_{next}*v_{next} = m_{body}*u_{body} + m_{next}*u_{next} + J_{body} - J_{}",
            next + 1
        ));
        world.equation(&format!("T_{body} = 1/2*m_{body}*v_{body}^2"));
        known = format!("{known} m_{body} u_{body}");
    }
    known.push_str(" m_8 u_8");
    let stuck = world.plan(&known, "v_3 J_4").expect_err("no restitution");
    assert!(matches!(stuck.reason, Reason::Underdetermined { .. }), "{:?}", stuck.reason);
}

#[test]
fn a_hostile_file_ends_in_time() {
    for size in [8, 24] {
        dense(size);
    }
}

fn dense(size: usize) {
    let names: Vec<String> = (0..size).map(|index| format!("x_{index}")).collect();
    let mut world = World::default();
    for row in 0..size {
        let terms: Vec<String> =
            names.iter().enumerate().map(|(column, name)| format!("a_{row}_{column}*{name}")).collect();
        world.equation(&format!("{} = b_{row}", terms.join(" + ")));
    }
    let coefficients = (0..size * size).map(|place| format!("a_{}_{}", place / size, place % size));
    let known = coefficients.chain((0..size).map(|row| format!("b_{row}"))).collect::<Vec<_>>().join(" ");
    let stuck = world.plan(&known, "x_3").expect_err("too much for paper");
    assert!(matches!(stuck.reason, Reason::NoTactic { .. }), "{:?}", stuck.reason);
}

/// Whether the rows, each a set of columns, can each be given a column of its own.
fn matched(rows: &[u32], taken: u32) -> bool {
    let Some((first, others)) = rows.split_first() else { return true };
    (0..32).any(|column| first & !taken & (1 << column) != 0 && matched(others, taken | 1 << column))
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig { cases: 48, failure_persistence: None, ..Default::default() })]

    /// No set of equations that determines the wanted unknown is cheaper than the one that is taken.
    #[test]
    fn plans_are_cheapest(rows in proptest::collection::vec((1_u32..64, 1_u32..4), 2..8)) {
        let mut world = World::default();
        let mut known = String::from("b");
        for (place, (columns, cost)) in rows.iter().enumerate() {
            let columns = (0..6).filter(|column| columns & (1 << column) != 0);
            let terms: Vec<String> = columns.map(|column| format!("a_{place}_{column}*x_{column}")).collect();
            world.equation(&format!("{cost}: {} = b", terms.join(" + ")));
            known = (0..6).fold(known, |known, column| format!("{known} a_{place}_{column}"));
        }
        let sets = (1_u32..1 << rows.len()).filter_map(|set| {
            let chosen = rows.iter().enumerate().filter(|(place, _)| set & (1 << place) != 0);
            let (columns, costs): (Vec<u32>, Vec<u32>) = chosen.map(|(_, row)| *row).unzip();
            let all = columns.iter().fold(0, |all, columns| all | columns);
            let square = all & 1 != 0 && all.count_ones() as usize == columns.len();
            (square && matched(&columns, 0)).then(|| costs.iter().sum::<u32>())
        });
        let cheapest = sets.min();
        let plan = world.plan(&known, "x_0");
        let cost = |plan: Plan| equations(&plan).concat().into_iter().map(|place| rows[place].1).sum::<u32>();
        proptest::prop_assert_eq!(plan.ok().map(cost), cheapest);
    }

    /// The same where equations with few numbers in them say much the same again, so that counting unknowns is not enough.
    #[test]
    fn plans_are_cheapest_where_equations_follow_from_others(
        rows in proptest::collection::vec((proptest::array::uniform5(0_i32..3), 1_u32..4), 2..9),
    ) {
        let rows: Vec<_> = rows.into_iter().filter(|(factors, _)| factors.iter().any(|factor| *factor != 0)).collect();
        let mut world = World::default();
        for (factors, cost) in &rows {
            let written = factors.iter().enumerate().filter(|(_, factor)| **factor != 0);
            let terms: Vec<String> = written.map(|(column, factor)| format!("{factor}*x_{column}")).collect();
            let value = factors.iter().zip([2, 3, 5, 7, 11]).map(|(factor, value)| factor * value).sum::<i32>();
            world.equation(&format!("{cost}: {} = {value}", terms.join(" + ")));
        }
        let sets = (1_u32..1 << rows.len()).filter_map(|set| {
            let chosen: Vec<_> = (0..rows.len()).filter(|place| set & (1 << place) != 0).map(|place| &rows[place]).collect();
            let columns: Vec<usize> = (0..5).filter(|column| chosen.iter().any(|(factors, _)| factors[*column] != 0)).collect();
            let square = columns.first() == Some(&0) && columns.len() == chosen.len();
            let matrix = nalgebra::DMatrix::from_fn(chosen.len(), columns.len(), |row, column| {
                f64::from(chosen[row].0[columns[column]])
            });
            (square && matrix.rank(1e-9) == chosen.len()).then(|| chosen.iter().map(|(_, cost)| cost).sum::<u32>())
        });
        let cheapest = sets.min();
        let plan = world.plan("", "x_0");
        let cost = |plan: Plan| equations(&plan).concat().into_iter().map(|place| rows[place].1).sum::<u32>();
        proptest::prop_assert_eq!(plan.ok().map(cost), cheapest);
    }
}

#[test]
fn an_unknown_under_a_negative_power_is_found() {
    let mut world = World::new(&["v_1*r_1^(-1) = v_2*r_2^(-1)"]);
    let plan = world.plan("v_1 r_1 v_2", "r_2").expect("a plan");
    let taught = world.expr("r_1*v_2/v_1");
    assert!(equal(&formula(&plan, 0, 0, 0), &taught), "{:?}", formula(&plan, 0, 0, 0));
}
