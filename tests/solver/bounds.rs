//! Every bound is true: compared with 77 digits, over many givens.

use momentous::quantity::Rational;
use momentous::solve::{Bounded, Exact, Precise, Program, Real, Relation, Verify, Workspace, Workspaces, audit};
use proptest::prelude::*;

use crate::world::World;

/// The world's plan for `wanted` from `known`, with all its equations tested.
fn program(world: &mut World, known: &str, wanted: &str) -> (Program, Vec<momentous::expr::Symbol>) {
    let (inputs, wanted) = (world.symbols(known), world.symbols(wanted));
    let set = inputs.iter().copied().collect();
    let plan = momentous::solve::plan(&world.system, &set, &wanted).expect("a plan");
    let audit = audit(&world.system, &set, &plan);
    (Program::compile(&world.system, &audit, &inputs, &wanted, Verify::All).expect("it compiles"), wanted)
}

/// Whether a bound covers the precise value: the difference, computed with 77 digits, is not beyond it.
fn covers(bounded: &Bounded, precise: &Precise) -> bool {
    let distance = precise.sub(&Precise::point(bounded.value)).apply(momentous::expr::Function::Abs);
    bounded.error == f64::INFINITY
        || !matches!(distance.sub(&Precise::point(bounded.error)).sign(), momentous::solve::Sign::Positive)
}

/// Replays in both arithmetics; every value of the floating-point replay must cover the precise one.
fn check(program: &Program, wanted: &[momentous::expr::Symbol], inputs: &[Exact]) -> Result<(), TestCaseError> {
    let (mut fast, mut precise) = (Workspace::default(), Workspace::default());
    let rounded: Vec<Bounded> = inputs.iter().map(Bounded::from_exact).collect();
    let fast = program.run(&rounded, &mut fast);
    let precise = program.run_exact(inputs, &mut precise);
    if fast.is_decided() {
        prop_assert_eq!(fast.survivors(), precise.survivors());
    }
    let mut workspaces = Workspaces::default();
    let solved = program.solve(inputs, &mut workspaces);
    for symbol in wanted {
        let (Some(value), Some(truth)) = (fast.value(*symbol), precise.value(*symbol)) else { continue };
        if fast.choices() == precise.choices() {
            prop_assert!(covers(value, truth), "{:?} is not {:?}", value, truth.decimal(45));
        }
        if let Some(value) = solved.value(*symbol) {
            prop_assert!(covers(value, truth), "{:?} is not {:?}", value, truth.decimal(45));
            // What is nothing is nothing in fifty decimals.
            prop_assert!(value.error <= 1e-11 * value.value.abs() || value.value.abs() < 1e-50, "{:?}", value);
        }
    }
    Ok(())
}

/// A decimal of few digits, over many orders of magnitude.
fn decimal() -> impl Strategy<Value = Exact> {
    (-9999_i64..=9999, -8_i32..=8).prop_map(|(digits, power)| {
        let power = Rational::from(10).pow(isize::try_from(power).expect("small"));
        (Rational::from(digits) * power).into()
    })
}

fn positive() -> impl Strategy<Value = Exact> {
    decimal().prop_filter_map("zero", |value| {
        let size = if value.rational < Rational::ZERO { -value.rational } else { value.rational };
        (!size.is_zero()).then(|| size.into())
    })
}

/// A fraction between 0 and 1.
fn share() -> impl Strategy<Value = Exact> {
    (0_i64..=1000).prop_map(|share| (Rational::from(share) / Rational::from(1000)).into())
}

/// An angle in whole degrees.
fn angle() -> impl Strategy<Value = Exact> {
    (-180_i64..=180).prop_map(|degrees| Exact { rational: Rational::from(degrees) / Rational::from(180), pi_power: 1 })
}

#[test]
fn of_the_simplest_numbers() {
    let mut world = World::new(&["z = ln(v) + v^(1/3) + exp(ln(v)) + acos(cos(b)) + asin(sin(b))"]);
    let (program, wanted) = program(&mut world, "v b", "z");
    for v in [1, 8] {
        let [v, b] = [v, 0].map(|value| Exact { rational: Rational::from(value), pi_power: 0 });
        check(&program, &wanted, &[v, b]).unwrap();
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn of_an_impact(m_a in positive(), m_b in positive(), v_a in decimal(), v_b in decimal(), e in share()) {
        let mut world = World::impact();
        let (program, wanted) = program(&mut world, "m_A m_B v_A1 v_B1 e", "v_A2 v_B2 J_A T_1 T_2 T_lost");
        check(&program, &wanted, &[m_a, m_b, v_a, v_b, e])?;
    }

    #[test]
    fn of_nearly_equal_speeds(m_a in positive(), m_b in positive(), v in decimal(), e in share()) {
        let mut world = World::impact();
        let (program, wanted) = program(&mut world, "m_A m_B v_A1 v_B1 e", "v_A2 T_lost");
        let faster = Exact::from(v.rational.clone() + Rational::ONE / Rational::from(1_000_000_000_i64));
        check(&program, &wanted, &[m_a, m_b, faster, v, e])?;
    }

    #[test]
    fn of_an_impact_backward(m_a in positive(), m_b in positive(), v_a in decimal(), v_b in decimal(), lost in positive()) {
        let mut world = World::impact();
        let (program, wanted) = program(&mut world, "m_A m_B v_A1 v_B1 T_lost", "e v_A2");
        check(&program, &wanted, &[m_a, m_b, v_a, v_b, lost])?;
    }

    #[test]
    fn of_angles(v in positive(), a in angle(), b in angle(), m in positive()) {
        let mut world = World::new(&[
            "p_x = m*v*cos(a) - m*v*sin(b)", "p_y = m*v*sin(a) + m*v*tan(b/3)",
            "w*cos(c) = p_x", "w*sin(c) = p_y",
            "z = asin(sin(a)) + acos(cos(b)) + exp(-v/m)*ln(v) + v^(1/3)",
        ]);
        world.positive("w");
        let (program, wanted) = program(&mut world, "v a b m", "p_x p_y z w c");
        check(&program, &wanted, &[v, a, b, m])?;
    }

    #[test]
    fn of_a_fall(h in decimal(), v in decimal(), g in positive()) {
        let mut world = World::new(&["0 = h + v*t - 1/2*g*t^2"]);
        world.condition("t", Relation::AtLeast, "0");
        let (program, wanted) = program(&mut world, "h v g", "t");
        check(&program, &wanted, &[h, v, g])?;
    }

}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn of_an_equation_without_formula(a in share(), b in positive()) {
        let mut world = World::new(&["t + a*sin(t) = b"]);
        let (program, wanted) = program(&mut world, "a b", "t");
        check(&program, &wanted, &[a, b])?;
    }
}
