//! A body that moves one way all through a stage: its speed along its motion at both ends.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::energy;
use momentous_laws::kinematics;
use momentous_laws::separation;
use momentous_scene::Term;
use momentous_solve::Relation;

use super::Builder;
use super::Name;
use super::Opposing;
use super::QuantityKind;
use super::Reason;
use super::builder::SECOND_COST;

/// The speeds of a body along its motion, and which way that is.
pub(super) struct Speeds {
    /// At the start.
    pub before: Expr,
    /// At the end: zero where the body comes to rest.
    pub after: Expr,
    /// Half the squares of both: the kinetic energies for each unit of mass.
    pub energies: [Expr; 2],
    /// Whether the body moves along the only axis (1) or against it (-1).
    pub sign: i64,
}

impl Builder<'_> {
    /// The way of a body during a stage. Along one axis its direction is stated; in a plane its speed is all that is needed.
    pub(super) fn one_way(
        &mut self,
        index: usize,
        body: &str,
        direction: Option<&Term>,
        stops: bool,
        opposing: Option<Opposing>,
        path: &Path,
    ) -> Speeds {
        if stops {
            self.comes_to_rest(index, body);
        }
        if self.axes.len() != 1 {
            let [before, after] = [index + 1, index + 2].map(|instant| self.speed_of(body, instant));
            let after = if stops { Expr::zero() } else { after };
            let energies = [&before, &after].map(|speed| energy::specific_kinetic(std::slice::from_ref(speed)));
            return Speeds { before, after, energies, sign: 1 };
        }
        let sign = self.sense(direction, path);
        let axis = self.axes[0].0;
        let [start, end] = [index + 1, index + 2].map(|instant| self.velocity(body, instant, axis));
        let end = if stops { Expr::zero() } else { end };
        // A square has no sign, and the velocity itself is what the reader knows.
        let energies = [&start, &end].map(|velocity| energy::specific_kinetic(std::slice::from_ref(velocity)));
        let [before, after] = [start, end].map(|velocity| Expr::integer(sign) * velocity);
        self.moves_along(index, body, [&before, &after], opposing);
        Speeds { before, after, energies, sign }
    }

    /// In a plane, what acts along the velocity leaves its direction as it was.
    pub(super) fn keeps_its_direction(&mut self, index: usize, body: &str, way: &Speeds) {
        if self.axes.len() < 2 || way.after.is_zero() {
            return;
        }
        let [start, end] = [index + 1, index + 2].map(|instant| self.velocities(body, instant));
        for (start, end) in start.into_iter().zip(end) {
            let because = format!("nothing acts on {} across its motion", self.called(body));
            let sides = (end * way.before.clone(), start * way.after.clone());
            self.law_at(SECOND_COST, &kinematics::STRAIGHT, Some(index), because, sides);
        }
    }

    /// The speed of a body.
    fn speed_of(&mut self, body: &str, instant: usize) -> Expr {
        self.quantity(Name::of(QuantityKind::Speed, body).at(instant)).map_or_else(Expr::zero, Expr::from)
    }

    /// Along (1) or against (-1) the first axis.
    pub(super) fn sense(&mut self, direction: Option<&Term>, path: &Path) -> i64 {
        let Some(term) = direction else { return 1 };
        let path = path.key("direction");
        let direction = self.direction(term, &path);
        match self.components(&direction).first() {
            Some(part) if *part == Expr::one() => 1,
            Some(part) if *part == Expr::integer(-1) => -1,
            _ => {
                let fault = Fault::new(Code::Value, format!("`{}` is not a direction along the motion", term.0));
                self.faults.push(fault.help("write the words of the axis, or `+x` or `-x`").at_path(path));
                1
            }
        }
    }

    /// Every component of the velocity of a body is zero at the start of a stage.
    pub(super) fn starts_from_rest(&mut self, index: usize, body: &str) {
        let because = format!("{} from rest", self.does(body, ["starts", "start"]));
        for velocity in self.velocities(body, index + 1) {
            self.law(&separation::AT_REST, Some(index), because.clone(), (velocity, Expr::zero()));
        }
    }

    /// Every component of the velocity of a body is zero at the end of a stage.
    pub(super) fn comes_to_rest(&mut self, index: usize, body: &str) {
        let because = format!("{} to rest", self.does(body, ["comes", "come"]));
        for velocity in self.velocities(body, index + 2) {
            self.law(&kinematics::REST, Some(index), because.clone(), (velocity, Expr::zero()));
        }
    }

    /// The body moves the way that its stage says, from start to end.
    pub(super) fn moves_along(&mut self, index: usize, body: &str, ends: [&Expr; 2], opposing: Option<Opposing>) {
        let (name, phrase) = (self.called(body), self.stage_phrase(index));
        for (speed, end) in ends.into_iter().zip(["start", "end"]) {
            let reason = Reason::MovesBackAt(name.clone(), end.to_owned(), phrase.clone()).against(opposing);
            if !speed.is_zero() {
                self.require(speed.clone(), Relation::AtLeast, Expr::zero(), reason);
            }
        }
    }
}
