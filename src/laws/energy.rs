//! Kinetic energy and what an impact loses of it.

use momentous_expr::Expr;

use super::Law;
use super::Sides;
use super::wrong;

/// Kinetic energy.
pub const KINETIC: Law = Law {
    id: "kinetic-energy",
    name: "the definition of kinetic energy",
    statement: "The kinetic energy of a body is half its mass times its speed squared; that of a system is the sum over its bodies. Of a body that turns about a fixed axis, it is half its moment of inertia times the square of its angular velocity.",
    signs: "Never negative, whatever the direction of motion.",
    when: "Always.",
    source: "Definition.",
    wrong: wrong::energy::KINETIC,
};

/// Potential energy of a weight.
pub const POTENTIAL: Law = Law {
    id: "potential-energy",
    name: "the definition of potential energy",
    statement: "The potential energy of a body due to its weight is its weight times its height above the origin.",
    signs: "Negative below the origin.",
    when: "The body stays so close to the ground that its weight does not change.",
    source: "Definition: the work of the weight on the way back to the origin.",
    wrong: &[],
};

/// Potential energy of a spring.
pub const SPRING: Law = Law {
    id: "energy-of-a-spring",
    name: "the definition of the potential energy of a spring",
    statement: "The potential energy of a spring is half its stiffness times the square of its deformation.",
    signs: "Never negative, whether the spring is stretched or compressed.",
    when: "The force of the spring is proportional to its deformation.",
    source: "Definition: the work of the spring on the way back to its natural length.",
    wrong: wrong::energy::SPRING,
};

/// Energy lost in a stage.
pub const LOSS: Law = Law {
    id: "energy-lost",
    name: "the balance of kinetic energy",
    statement: "The kinetic energy lost is the kinetic energy before minus the kinetic energy after.",
    signs: "A loss is positive.",
    when: "Always; in an impact without a source of energy it is never negative.",
    source: "Definition.",
    wrong: wrong::energy::LOSS,
};

/// Energy gained in a stage.
pub const GAIN: Law = Law {
    id: "energy-gained",
    name: "the balance of kinetic energy",
    statement: "The kinetic energy gained is the kinetic energy after minus the kinetic energy before.",
    signs: "A gain is positive.",
    when: "Always; in a separation something supplies it: an explosive, a spring, muscles.",
    source: "Definition.",
    wrong: wrong::separation::GAIN,
};

/// Work and kinetic energy.
pub const WORK_ENERGY: Law = Law {
    id: "work-energy",
    name: "the principle of work and energy",
    statement: "The kinetic energy at the end equals that at the start plus the work done by all forces in between.",
    signs: "A force along the motion does positive work, one against it negative work.",
    when: "Always; forces at right angles to the motion do no work.",
    source: "Newton's second law, integrated over the distance.",
    wrong: wrong::energy::WORK,
};

/// Work of a force that depends on the position.
pub const WORK: Law = Law {
    id: "work-of-a-force",
    name: "the definition of work",
    statement: "The work of a force along a line is its integral over the position: the area under its force-position curve.",
    signs: "A force along the motion does positive work, one against it negative work.",
    when: "The force is known at every position on the way.",
    source: "Definition.",
    wrong: wrong::force::WORK,
};

/// Conservation of mechanical energy.
pub const CONSERVATION: Law = Law {
    id: "conservation-of-energy",
    name: "conservation of energy",
    statement: "If only weight and springs do work, the sum of the kinetic energy and the potential energies of weight and springs stays the same.",
    signs: "Heights are positive upwards; the energy of a spring is never negative.",
    when: "No friction and no impact between the two instants.",
    source: "The principle of work and energy, for forces whose work depends on the positions alone.",
    wrong: wrong::energy::CONSERVATION,
};

/// Friction between two bodies.
pub const RUBBING: Law = Law {
    id: "work-of-friction-between-bodies",
    name: "the principle of work and energy for both bodies",
    statement: "Where two bodies rub on each other, the friction between them takes from their kinetic energy the force of friction times the distance that one slides on the other.",
    signs: "The distance is measured on the other body, not over the ground; it is positive.",
    when: "Kinetic friction of constant size acts between the bodies, and no other force does work.",
    source: "The principle of work and energy for each of them, added: the two forces are opposite, and their displacements differ by that distance.",
    wrong: wrong::energy::RUBBING,
};

/// Friction between two bodies turns kinetic energy into heat.
pub const HEAT: Law = Law {
    id: "heat-of-friction",
    name: "conservation of energy",
    statement: "The kinetic energy that two bodies lose by rubbing on each other is the force of friction times the distance that one slides on the other.",
    signs: "The distance is measured on the other body, not over the ground; both are positive.",
    when: "Kinetic friction of constant size acts between the bodies, and no other force does work.",
    source: "The principle of work and energy for both bodies together.",
    wrong: wrong::energy::HEAT,
};

/// The laws of this chapter.
pub const LAWS: &[&Law] =
    &[&KINETIC, &POTENTIAL, &SPRING, &LOSS, &GAIN, &WORK_ENERGY, &WORK, &CONSERVATION, &RUBBING, &HEAT];

/// `1/2 (m_A m_B)/(m_A + m_B) (1 - e^2) u^2`: what an impact of two free bodies that approach each other at `u` loses.
#[must_use]
pub fn lost_in_impact([first, second]: [&Expr; 2], e: &Expr, approach: &Expr) -> Expr {
    let reduced = if first == second {
        first.clone() / Expr::integer(2)
    } else {
        first.clone() * second.clone() / (first.clone() + second.clone())
    };
    let rest = Expr::one() - e.clone().powi(2);
    Expr::product([Expr::ratio(1, 2), reduced, rest, approach.clone().powi(2)])
}

/// The energy at the start and the work on the way make up the energy at the end.
#[must_use]
pub fn work_energy(start: Expr, works: impl IntoIterator<Item = Expr>, end: Expr) -> Sides {
    (Expr::sum([start].into_iter().chain(works)), end)
}

/// `k s^2 / 2`: the energy of a spring that is deformed by `s`.
#[must_use]
pub fn of_spring(stiffness: &Expr, deformation: &Expr) -> Expr {
    Expr::product([Expr::ratio(1, 2), stiffness.clone(), deformation.clone().powi(2)])
}

/// `v^2 / 2`: the kinetic energy for each unit of mass, where the mass cancels.
#[must_use]
pub fn specific_kinetic(components: &[Expr]) -> Expr {
    kinetic(&Expr::one(), components)
}

/// `m v^2 / 2`, with the square of the speed as a sum of squared components.
#[must_use]
pub fn kinetic(mass: &Expr, components: &[Expr]) -> Expr {
    let squares = Expr::sum(components.iter().map(|component| component.clone().powi(2)));
    Expr::product([Expr::ratio(1, 2), mass.clone(), squares])
}
