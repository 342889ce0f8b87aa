//! Directions read from words, and vectors resolved along them and along the axes of an impact.

use momentous_expr::Expr;
use momentous_fault::Code;
use momentous_fault::Fault;
use momentous_fault::Path;
use momentous_laws::geometry;
use momentous_quantity::Dimension;
use momentous_scene::Axis;
use momentous_scene::Term;

use super::Because;
use super::Builder;
use super::Name;
use super::QuantityKind;
use super::frame::Direction;
use super::frame::Frame;
use super::frame::above_or_below;
use super::name::is_bare_name;

/// The components of the velocity of a body along and across a contact's normal.
pub(super) struct Split {
    /// Along n.
    pub along: Expr,
    /// Along t, where the scene has two dimensions.
    pub across: Option<Expr>,
}

impl Builder<'_> {
    /// Reads a direction: `to the left`, `+x`, `30 deg above +x`, `alpha below the horizontal`, `40 deg north of east`.
    pub(super) fn direction(&mut self, term: &Term, path: &Path) -> Direction {
        let text = term.0.trim();
        if let Some(direction) = self.axis_direction(text) {
            return direction;
        }
        if let Some((turn, sign_of_y, base)) = above_or_below(text) {
            if self.axes.len() > 2 {
                self.not_in_space(text, path);
                return self.first_axis();
            }
            return self.turned(turn, base, sign_of_y, path);
        }
        if let Some((turn, base)) = text.split_once(" from ") {
            self.counts_turns(&format!("`{text}`"), path);
            let base = self.base_direction(base, path);
            let turn = self.read_angle(turn, path);
            return Direction::turned(base.quarters, self.zero_if_so_written(turn));
        }
        if let Some((before, base)) = text.split_once(" of ")
            && let Some((turn, towards)) = before.rsplit_once(' ')
            && let (Some(base), Some(towards)) = (self.axis_direction(base), self.axis_direction(towards))
        {
            let sign = if (base.quarters + 1) % 4 == towards.quarters { 1 } else { -1 };
            let turn = Expr::integer(sign) * self.read_angle(turn, path);
            return Direction::turned(base.quarters, turn);
        }
        if is_bare_name(text) && self.resolve(text).is_none() {
            self.words.push((text.to_owned(), path.clone()));
        }
        // An angle is a term, and no phrase.
        if text.contains(' ') && text.split(' ').all(|word| word.chars().all(char::is_alphabetic)) {
            self.faults.push(self.no_direction(text).at_path(path.clone()));
            return self.first_axis();
        }
        self.counts_turns(&format!("the direction `{text}`"), path);
        let turn = self.read_angle(text, path);
        // An angle of exactly zero is an axis, along which no components n and t need be made.
        Direction::turned(0, self.zero_if_so_written(turn))
    }

    /// Angles counted counter-clockwise, from x to y, need axes that turn so.
    pub(super) fn counts_turns(&mut self, what: &str, path: &Path) {
        if self.scene.axes.are_left_handed() && self.defined.insert("left-handed axes".to_owned()) {
            let message = format!("{what} is counted counter-clockwise, but these axes turn clockwise from x to y");
            let help = "turn one of them round, such as `y: upwards` for `y: downwards`; a direction may also be told by words such as `30 deg above +x`";
            self.faults.push(Fault::new(Code::Value, message).help(help).at_path(path.clone()));
        }
    }

    /// The words that stand for a direction and are no axis, each with its place: names of angles, if they are given or asked.
    #[must_use]
    pub fn words(&self) -> &[(String, Path)] {
        &self.words
    }

    /// The fault of a word that is no direction.
    #[must_use]
    pub fn no_direction(&self, word: &str) -> Fault {
        let known = self.axes.iter().flat_map(|(_, senses)| [&senses.positive, &senses.negative]);
        let known: Vec<String> = known.map(|phrase| format!("`{phrase}`")).collect();
        let help = format!("its directions are {}; the name of an angle must be given or asked for", known.join(", "));
        Fault::new(Code::UnknownName, format!("`{word}` is not a direction of this scene")).help(help)
    }

    /// In three dimensions one angle does not tell a direction.
    fn not_in_space(&mut self, text: &str, path: &Path) {
        let fault = Fault::new(Code::Value, format!("`{text}` does not give a direction in three dimensions"));
        let help = "write an axis with its sign, such as `+z`, or give the components: `value: { x: 3 N, z: 4 N }`";
        self.faults.push(fault.help(help).at_path(path.clone()));
    }

    /// The axis from which an angle is counted.
    fn base_direction(&mut self, base: &str, path: &Path) -> Direction {
        let base = if base.trim() == "the horizontal" { "+x" } else { base };
        self.axis_direction(base).unwrap_or_else(|| {
            let known = self.axes.iter().map(|(axis, _)| format!("`+{0}` or `-{0}`", axis.letter()));
            let known = known.collect::<Vec<_>>().join(", ");
            let fault = Fault::new(Code::Value, format!("`{}` is not a direction of this scene", base.trim()));
            let help = format!(
                "measure an angle from {known}, or write the axis with both of its directions: `x: [ahead, back]`"
            );
            self.faults.push(fault.help(help).at_path(path.clone()));
            Direction::axis(0, false)
        })
    }

    fn turned(&mut self, turn: &str, base: &str, sign_of_y: i64, path: &Path) -> Direction {
        let base = self.base_direction(base, path);
        // Above is towards +y, or towards -y where that axis points down: counter-clockwise from +x, clockwise from -x.
        let falls = self.axes.iter().any(|(axis, senses)| *axis == Axis::Y && senses.rise() == Some(-1));
        let sign_of_y = if falls { -sign_of_y } else { sign_of_y };
        let sign = if base.quarters == 2 { -sign_of_y } else { sign_of_y };
        let turn = self.read_angle(turn, path);
        Direction::turned(base.quarters, Expr::integer(sign) * self.zero_if_so_written(turn))
    }

    /// The whole angle of a direction, counter-clockwise from the first axis; quarter turns as values in degrees.
    pub(super) fn whole_angle(&mut self, direction: &Direction) -> Expr {
        let quarters = direction.quarters % 4;
        if quarters == 0 {
            return direction.turn.clone();
        }
        let start = self.literal(&format!("{} deg", u16::from(quarters) * 90));
        start.map_or_else(Expr::zero, Expr::from) + direction.turn.clone()
    }

    /// Reads words that name a direction along or against an axis.
    pub(super) fn axis_direction(&self, text: &str) -> Option<Direction> {
        let text = text.trim();
        self.axes.iter().enumerate().find_map(|(position, (axis, senses))| {
            let word = |phrase: &str| {
                text == phrase
                    || phrase.strip_prefix("to the ") == Some(text)
                    || phrase.strip_suffix("wards") == Some(text)
            };
            let letter = axis.letter();
            let place = self.axis_place(position);
            if text == letter || text.strip_prefix('+') == Some(letter) || word(&senses.positive) {
                Some(Direction::axis(place, false))
            } else {
                (text.strip_prefix('-') == Some(letter) || word(&senses.negative)).then(|| Direction::axis(place, true))
            }
        })
    }

    pub(super) fn read_angle(&mut self, text: &str, path: &Path) -> Expr {
        let angle = self.read(&Term(text.trim().to_owned()), Dimension::NONE, "the angle", path);
        self.needs_unit(&angle, path);
        angle
    }

    /// The components of a direction along the scene's axes, in their order.
    pub(super) fn components(&self, direction: &Direction) -> Vec<Expr> {
        let [cos, sin] = direction.cosine_and_sine();
        let third = match (direction.across, direction.quarters) {
            (true, 0) => Expr::one(),
            (true, _) => -Expr::one(),
            (false, _) => Expr::zero(),
        };
        let along = [cos, sin, third];
        (0..self.axes.len()).filter_map(|position| along.get(self.axis_place(position)).cloned()).collect()
    }

    /// The place of the axis of that position among the axes of directions: a single axis y stands second.
    pub(super) fn axis_place(&self, position: usize) -> usize {
        match self.axes[..] {
            [(Axis::Y, _)] => 1,
            _ => position,
        }
    }

    /// The direction along the first axis.
    pub(super) fn first_axis(&self) -> Direction {
        Direction::axis(self.axis_place(0), false)
    }

    /// The velocity of a body at an instant, along and across a contact's normal.
    ///
    /// Where the normal lies along an axis the scene's own components serve; otherwise components n and t are made.
    pub(super) fn split(&mut self, body: &str, instant: usize, stage: usize, frame: &Frame) -> Split {
        let velocities = self.velocities(body, instant);
        let [x, y] = &velocities[..] else {
            let along = velocities.into_iter().zip(self.components(&frame.normal)).map(|(v, c)| v * c);
            return Split { along: Expr::sum(along), across: None };
        };
        if frame.normal.turn.is_zero() {
            let [cos, sin] = frame.normal.cosine_and_sine();
            let along = Expr::sum([cos.clone() * x.clone(), sin.clone() * y.clone()]);
            let across = Expr::sum([cos * y.clone(), -(sin * x.clone())]);
            return Split { along, across: Some(across) };
        }
        let since = self.timeline.naming_instant(body, instant);
        let [along, across] = ["n", "t"].map(|letter| {
            let name = Name::of(QuantityKind::Velocity, body).at(since).along(letter).during(self.frame_label(stage));
            Expr::Symbol(self.velocity_named(name, body, since))
        });
        self.turn_velocity(stage, frame, [x.clone(), y.clone()], [&along, &across]);
        Split { along, across: Some(across) }
    }

    /// The velocity that an impulse along a normal changes: along the normal, or along the only axis, so that in one
    /// dimension an impulse has the sign of its direction like every other component.
    pub(super) fn changed(&mut self, body: &str, instant: usize, split: &Split) -> Expr {
        match self.axes[..] {
            [(axis, _)] => self.velocity(body, instant, axis),
            _ => split.along.clone(),
        }
    }

    /// The components along the axes of an impulse along a normal.
    pub(super) fn resolved(&self, impulse: &Expr, frame: &Frame) -> Vec<Expr> {
        match self.axes[..] {
            [_] => vec![impulse.clone()],
            _ => self.components(&frame.normal).into_iter().map(|part| impulse.clone() * part).collect(),
        }
    }

    /// Relates the components n and t to x and y, both ways round.
    fn turn_velocity(&mut self, stage: usize, frame: &Frame, [x, y]: [Expr; 2], [n, t]: [&Expr; 2]) {
        let key = format!("turned {stage} {n:?}");
        if !self.defined.insert(key) {
            return;
        }
        let because = || Because::Definition;
        let [cos, sin] = frame.normal.cosine_and_sine();
        let [along, across] = geometry::turned([&cos, &sin], &x, &y);
        self.law(&geometry::ROTATION, Some(stage), because(), (n.clone(), along));
        self.law(&geometry::ROTATION, Some(stage), because(), (t.clone(), across));
        let back = geometry::turned_back([&cos, &sin], n, t);
        for (old, new) in [x, y].into_iter().zip(back) {
            self.law(&geometry::ROTATION, Some(stage), because(), (old, new));
        }
    }

    /// Distinguishes the n and t of several oblique impacts of one scene.
    fn frame_label(&self, stage: usize) -> Option<String> {
        let earlier = self.frames.iter().take(stage).flatten().any(|frame| !frame.normal.turn.is_zero());
        earlier.then(|| (stage + 1).to_string())
    }
}
