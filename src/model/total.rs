//! Totals of bodies at an instant, as terms: momentum, kinetic energy, angular momentum.

use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_laws::angular;
use momentous_laws::energy;
use momentous_scene::Axis;
use momentous_scene::Stage;
use momentous_scene::stage::Partners;

use super::Builder;
use super::Name;
use super::QuantityKind;

impl Builder<'_> {
    /// The momentum of bodies at an instant along the axis of that position.
    pub fn total_momentum(&mut self, bodies: &[String], instant: usize, position: usize) -> Option<Expr> {
        let (axis, _) = *self.axes.get(position)?;
        let terms = self.movers_of(bodies, instant).into_iter();
        Some(Expr::sum(
            terms
                .map(|(body, mover)| self.mass_at(&body, instant) * self.velocity(&mover, instant, axis))
                .collect::<Vec<_>>(),
        ))
    }

    /// The kinetic energy of bodies just before a stage (0) or just after it (1), in the components in which the stage changes
    /// their velocities.
    pub fn total_kinetic(&mut self, bodies: &[String], stage: usize, side: usize) -> Expr {
        let instant = stage + 1 + side;
        let terms = self.movers_of(bodies, instant).into_iter();
        Expr::sum(terms.map(|(body, mover)| self.kinetic_around(&body, &mover, stage, instant)).collect::<Vec<_>>())
    }

    fn kinetic_around(&mut self, body: &str, mover: &str, stage: usize, instant: usize) -> Expr {
        let turns = self.scene.bodies.get(body).is_some_and(|body| body.inertia.is_some());
        if self.axes.is_empty() || turns {
            return self.kinetic_term(body, instant);
        }
        let mass = self.mass_at(body, instant);
        let frame = self.frames.get(stage).cloned().flatten().filter(|frame| !frame.normal.turn.is_zero());
        if let Some(frame) = frame
            && self.is_changed_in(body, stage)
        {
            let split = self.split(mover, instant, stage, &frame);
            return energy::kinetic(&mass, &split.across.into_iter().chain([split.along]).collect::<Vec<_>>());
        }
        let velocities = self.velocities(mover, instant);
        energy::kinetic(&mass, &velocities)
    }

    /// The angular momentum of bodies about a fixed point or the centre of mass, in one plane or along each axis of space; `None`
    /// where the scene does not tell it for these bodies.
    pub fn total_moment(&mut self, bodies: &[String], about: &str, stage: usize, side: usize) -> Option<Vec<Expr>> {
        let instant = stage + side;
        let movers = self.movers_of(bodies, instant);
        match self.axes.len() {
            0 => {
                let terms = movers.iter().map(|(body, mover)| {
                    let (radius, velocity) = self.polar_state(mover, about, instant);
                    Expr::product([self.mass_at(body, instant), radius, velocity])
                });
                Some(vec![Expr::sum(terms.collect::<Vec<_>>())])
            }
            1 => {
                let scene = self.scene;
                let Some(Stage::Strike(strike)) = scene.stages.get(stage) else {
                    let alive = self.timeline.alive(instant);
                    let all = alive.into_iter().all(|living| movers.iter().any(|(body, _)| body == living));
                    let symbol: Symbol = self
                        .symbols
                        .find(&Name::of(QuantityKind::AngularMomentum, about).at(instant).to_string())
                        .filter(|_| all)?;
                    return Some(vec![symbol.into()]);
                };
                if strike.about != about {
                    return None;
                }
                let path = momentous_fault::Path::root();
                let mut terms = Vec::new();
                for (body, _) in movers {
                    if strike.rotor.as_deref() == Some(body.as_str()) {
                        let centre = self.point(about);
                        let turn = self.turn_of_arm(&centre, instant);
                        terms.extend(self.momentum_of_rotor(Some(&body), &turn));
                        continue;
                    }
                    let distance = if body == strike.body { &strike.at } else { strike.carries.get(&body)? };
                    let distance = self.read(distance, momentous_quantity::Dimension::LENGTH, "", &path);
                    terms.push(Expr::product([
                        self.mass_at(&body, instant),
                        distance,
                        self.transverse(&body, instant),
                    ]));
                }
                Some(vec![Expr::sum(terms)])
            }
            count => {
                let mut whole = vec![Expr::zero(); if count == 2 { 1 } else { count }];
                for (body, mover) in movers {
                    let mass = self.mass_at(&body, instant);
                    let (arm, velocity) = (self.arm(&mover, instant, about)?, self.velocities(&mover, instant));
                    for (sum, moment) in whole.iter_mut().zip(angular::moments(&arm, &velocity)) {
                        *sum = sum.clone() + mass.clone() * moment;
                    }
                }
                Some(whole)
            }
        }
    }

    /// How fast two bodies, or a body and a surface, move apart just after an impact: along its line where that is given, else
    /// along every axis.
    pub fn parting_velocity(&mut self, stage: usize) -> Vec<Expr> {
        let Some(Stage::Impact(impact)) = self.scene.stages.get(stage) else { return Vec::new() };
        let instant = stage + 2;
        let frame = self.frames.get(stage).cloned().flatten();
        match (impact.partners(), frame) {
            (Some(Partners::Bodies(..)), _) if impact.becomes.is_some() => Vec::new(),
            (Some(Partners::Bodies(first, second)), Some(frame)) => {
                let [one, other] = [first, second].map(|body| self.split(body, instant, stage, &frame).along);
                vec![other - one]
            }
            (Some(Partners::Bodies(first, second)), None) => {
                let axes: Vec<Axis> = self.axes.iter().map(|(axis, _)| *axis).collect();
                let apart = |axis| self.velocity(second, instant, axis) - self.velocity(first, instant, axis);
                axes.into_iter().map(apart).collect()
            }
            (Some(Partners::Surface(body, surface)), Some(frame)) => {
                let along = self.split(body, instant, stage, &frame).along;
                vec![along - self.velocity_of_surface(surface)]
            }
            _ => Vec::new(),
        }
    }

    /// The kinetic energy of those who take part in an impact, before and after; at a surface that moves, as it is seen from
    /// there.
    pub fn energies_of_impact(&mut self, stage: usize) -> Option<[Expr; 2]> {
        let Some(Stage::Impact(impact)) = self.scene.stages.get(stage) else { return None };
        match impact.partners()? {
            Partners::Bodies(first, second) => {
                let bodies = [first, second].map(str::to_owned);
                Some([0, 1].map(|side| self.total_kinetic(&bodies, stage, side)))
            }
            Partners::Surface(body, surface) => {
                let frame = self.frames.get(stage).cloned().flatten()?;
                let (mass, moves) = (self.mass_at(body, stage + 1), self.velocity_of_surface(surface));
                Some([0, 1].map(|side| {
                    let split = self.split(body, stage + 1 + side, stage, &frame);
                    let seen_along = split.along - moves.clone();
                    energy::kinetic(&mass, &split.across.into_iter().chain([seen_along]).collect::<Vec<_>>())
                }))
            }
        }
    }

    /// Whether a body, alone or as a part of another, takes part in a stage.
    #[must_use]
    pub fn is_changed_in(&self, body: &str, stage: usize) -> bool {
        let changed = |body: &str| self.timeline.since(body, stage + 2).is_none_or(|since| since == stage + 2);
        self.movers_of(&[body.to_owned()], stage + 2).iter().any(|(_, mover)| changed(mover))
    }

    fn velocity_of_surface(&mut self, surface: &str) -> Expr {
        let velocity = self.scene.surfaces.get(surface).and_then(|entry| entry.velocity.clone());
        let path = momentous_fault::Path::root().key("scene").key("surfaces").key(surface).key("velocity");
        velocity.map_or_else(Expr::zero, |term| self.read(&term, momentous_quantity::Dimension::VELOCITY, "", &path))
    }

    /// The bodies to be weighed at an instant, each with the body whose velocity it has: itself, what it is part of, or its own
    /// parts.
    fn movers_of(&self, bodies: &[String], instant: usize) -> Vec<(String, String)> {
        let alive = self.timeline.alive(instant);
        let mut all = Vec::new();
        for body in bodies {
            let members = self.scene.members(body);
            let holds = |whole: &&&str| members.iter().all(|member| self.scene.members(whole).contains(member));
            if alive.contains(&body.as_str()) {
                all.push((body.clone(), body.clone()));
            } else if let Some(whole) = alive.iter().find(holds) {
                all.push((body.clone(), (*whole).to_owned()));
            } else if let [_, ..] = self.scene.division_of(body)[..] {
                let parts = self.scene.division_of(body).into_iter().filter(|part| part != body);
                let parts: Vec<String> = parts.map(str::to_owned).collect();
                all.extend(self.movers_of(&parts, instant));
            } else if members.len() > 1 {
                let parts: Vec<String> = members.into_iter().map(str::to_owned).collect();
                all.extend(self.movers_of(&parts, instant));
            } else {
                // A part before its whole comes apart.
                let whole = alive.iter().find(|living| self.scene.division_of(living).contains(&body.as_str()));
                all.extend(whole.map(|whole| (body.clone(), (*whole).to_owned())));
            }
        }
        all
    }
}
