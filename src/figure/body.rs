//! A body with its name and the arrows attached to it.

use momentous_expr::Math;

use super::extent::Measure;
use super::geometry::arrow_head;
use super::input::Form;
use super::place::{Anchor, Canvas};
use super::{Point, Role, Shape};

const SMALLEST_RADIUS: f64 = 10.0;
/// A name that needs a larger disc is given a block.
const LARGEST_RADIUS: f64 = 20.0;
const BLOCK_HEIGHT: f64 = 20.0;
const BLOCK_WIDTH: f64 = 26.0;
const PADDING: f64 = 4.0;
/// A belt with its rollers, which are inside of it.
const BELT: Point = Point { x: 104.0, y: 16.0 };
const ROLLER: f64 = 5.5;
/// A length of rope, along the line of its motion.
const STRAND: Point = Point { x: 72.0, y: 4.0 };
/// Arrows closer in direction than this (cosine) get lanes beside each other.
const SAME_DIRECTION: f64 = 0.93;
const LANE: f64 = 7.0;
/// Below this sine of the angle between them arrows are parallel.
const PARALLEL: f64 = 1e-3;

/// The outline of a body, sized to hold its name.
#[derive(Clone, Debug)]
pub(super) struct Body {
    name: Math,
    outline: Outline,
    centre: Point,
    /// Its turn, for a block on a slope.
    angle: f64,
    /// Whether others stand on it.
    is_deck: bool,
    /// In which directions arrows lie already, seen from the centre.
    taken: Vec<Point>,
    /// The bodies of which it consists, where it is several in one.
    parts: Vec<Body>,
    /// Whether it has rollers at its ends.
    has_rollers: bool,
    /// Whether it is too thin to hold its name, which then lies beside it.
    is_thin: bool,
}

#[derive(Clone, Copy, Debug)]
enum Outline {
    Disc(f64),
    Block(Point),
}

/// On which side of the body its arrow lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attach {
    /// The tail at the body: where it goes, or how it is pulled.
    Leaving,
    /// The tip at the body: where it comes from, or how it is pushed.
    Arriving,
}

impl Body {
    pub(super) fn new(name: &Math, form: Form, centre: Point) -> Self {
        let size = Measure::of(name);
        let height = size.above + size.below;
        let radius = (libm::hypot(size.width, height) / 2.0 + 1.0).max(SMALLEST_RADIUS);
        let outline = if form == Form::Disc && radius <= LARGEST_RADIUS {
            Outline::Disc(radius)
        } else if form == Form::Belt {
            Outline::Block(Point::new(BELT.x.max(size.width + BELT.x / 2.0), BELT.y.max(height + PADDING)))
        } else if form == Form::Strand {
            Outline::Block(STRAND)
        } else {
            Outline::Block(Point::new(
                (size.width + 2.0 * PADDING).max(BLOCK_WIDTH),
                (height + 2.0 * PADDING).max(BLOCK_HEIGHT),
            ))
        };
        Self {
            name: name.clone(),
            outline,
            centre,
            angle: 0.0,
            is_deck: false,
            taken: Vec::new(),
            parts: Vec::new(),
            has_rollers: form == Form::Belt,
            is_thin: form == Form::Strand,
        }
    }

    /// Several bodies in one, each touching the next, with one floor under them.
    pub(super) fn joined(name: &Math, parts: &[(Math, Form)]) -> Self {
        let mut parts: Vec<Self> = parts.iter().map(|(name, form)| Self::new(name, *form, Point::ORIGIN)).collect();
        let half = |part: &Self| Point::new(part.support(Point::new(1.0, 0.0)), part.support(Point::new(0.0, 1.0)));
        let halves: Vec<Point> = parts.iter().map(half).collect();
        let width: f64 = halves.iter().map(|half| half.x).sum();
        let height = halves.iter().map(|half| half.y).fold(0.0, f64::max);
        let mut back = -width;
        for (part, half) in parts.iter_mut().zip(&halves) {
            part.centre = Point::new(back + half.x, half.y - height);
            back += 2.0 * half.x;
        }
        let outline = Outline::Block(Point::new(2.0 * width, 2.0 * height));
        let (name, centre) = (name.clone(), Point::ORIGIN);
        let (taken, has_rollers) = (Vec::new(), false);
        Self { name, outline, centre, angle: 0.0, is_deck: false, taken, parts, has_rollers, is_thin: false }
    }

    /// A block of that size at least.
    pub(super) fn plank(name: &Math, size: Point) -> Self {
        let mut body = Self::new(name, Form::Block, Point::ORIGIN);
        if let Outline::Block(least) = body.outline {
            body.outline = Outline::Block(Point::new(least.x.max(size.x), least.y.max(size.y)));
        }
        body
    }

    /// A block of that size at least, on which others stand.
    pub(super) fn deck(name: &Math, size: Point) -> Self {
        Self { is_deck: true, ..Self::plank(name, size) }
    }

    /// The same body, turned about its centre; its name stays level, so a block grows to hold it.
    pub(super) fn turned(mut self, angle: f64) -> Self {
        if !self.parts.is_empty() || self.is_thin {
            self.angle = angle;
            return self;
        }
        if let Outline::Block(size) = self.outline {
            let name = Measure::of(&self.name);
            let (sine, cosine) = (libm::sin(angle).abs(), libm::cos(angle).abs());
            let height = name.above + name.below;
            let needed = Point::new(name.width * cosine + height * sine, name.width * sine + height * cosine);
            let padded = |needed: f64, least: f64| least.max(needed + PADDING);
            self.outline = Outline::Block(Point::new(padded(needed.x, size.x), padded(needed.y, size.y)));
            self.angle = angle;
        }
        self
    }

    pub(super) fn moved(mut self, centre: Point) -> Self {
        self.centre = centre;
        self
    }

    pub(super) fn centre(&self) -> Point {
        self.centre
    }

    /// Distance from the centre to the outline in a direction.
    pub(super) fn reach(&self, direction: Point) -> f64 {
        match self.outline {
            Outline::Disc(radius) => radius,
            Outline::Block(size) => {
                let turned = direction.rotated(-self.angle);
                let reach = |half: f64, part: f64| if part.abs() > 1e-9 { half / part.abs() } else { f64::INFINITY };
                reach(size.x / 2.0, turned.x).min(reach(size.y / 2.0, turned.y)) * direction.length()
            }
        }
    }

    /// Distance from the centre to the tangent line whose normal is that unit vector.
    pub(super) fn support(&self, normal: Point) -> f64 {
        match self.outline {
            Outline::Disc(radius) => radius,
            Outline::Block(size) => {
                let turned = normal.rotated(-self.angle);
                Point::new(turned.x.abs(), turned.y.abs()).dot(size * 0.5)
            }
        }
    }

    pub(super) fn draw(&self, canvas: &mut Canvas) {
        let (centre, role) = (self.centre, Role::Body);
        if !self.parts.is_empty() {
            for part in &self.parts {
                let place = centre + part.centre.rotated(self.angle);
                Self { centre: place, angle: self.angle, ..part.clone() }.draw(canvas);
            }
            if self.name == Math::Row(Vec::new()) {
                return;
            }
            let up = Point::new(0.0, 1.0);
            let above = Anchor::Around { at: centre, radius: self.support(up), prefer: up.angle() };
            return canvas.label(&self.name, role, above);
        }
        canvas.draw(match self.outline {
            Outline::Disc(radius) => Shape::Circle { centre, radius, role },
            Outline::Block(size) => Shape::Rectangle { centre, size, angle: self.angle, role },
        });
        if let (true, Outline::Block(size)) = (self.has_rollers, self.outline) {
            for side in [-1.0, 1.0] {
                let at = Point::new(side * (size.x / 2.0 - ROLLER - 2.0), 0.0).rotated(self.angle);
                canvas.draw(Shape::Circle { centre: centre + at, radius: ROLLER, role });
            }
        }
        if self.is_thin {
            let beside = Anchor::Around { at: centre, radius: self.support(Point::new(1.0, 0.0)), prefer: 0.0 };
            return canvas.label(&self.name, role, beside);
        }
        canvas.fixed_label(centre, &self.name, role);
    }

    /// Keeps the line through the centre free on that side.
    pub(super) fn occupy(&mut self, outward: Point) {
        self.taken.push(outward);
    }

    /// Places the next arrow along `arrow` beside those that lie there already.
    pub(super) fn attach(&mut self, arrow: Point, attach: Attach) -> (Point, Point) {
        let unit = arrow * (1.0 / arrow.length().max(1e-9));
        let outward = if attach == Attach::Leaving { unit } else { -unit };
        let close: Vec<f64> = self
            .taken
            .iter()
            .filter(|other| other.dot(outward) > SAME_DIRECTION)
            .map(|other| other.turned().dot(outward))
            .collect();
        self.taken.push(outward);
        // A second arrow lies on the side to which it points, so that the two do not cross.
        let shift = match close[..] {
            [turn] if turn.abs() > PARALLEL => LANE.copysign(turn),
            // Beside an arrow that is level it lies above, where no floor is in the way of its label.
            _ if outward.turned().y < -PARALLEL => -lane(close.len()),
            _ => lane(close.len()),
        };
        let shift = outward.turned() * shift;
        let start = self.centre + shift + outward * self.reach_beside(outward, shift.length());
        let end = start + outward * arrow.length();
        if attach == Attach::Leaving { (start, end) } else { (end, start) }
    }

    /// Like [`Self::reach`], on a line that passes the centre at a distance.
    fn reach_beside(&self, direction: Point, distance: f64) -> f64 {
        match self.outline {
            Outline::Disc(radius) => (radius * radius - distance * distance).max(0.0).sqrt(),
            Outline::Block(_) => self.reach(direction),
        }
    }

    /// Draws an arrow at the body and asks for a label beside it.
    pub(super) fn draw_arrow(
        &mut self,
        canvas: &mut Canvas,
        arrow: Point,
        attach: Attach,
        label: &Math,
        role: Role,
    ) -> (Point, Point) {
        let (from, to) = self.attach(arrow, attach);
        canvas.arrow(from, to, role);
        label_arrow(canvas, [from, to], attach, label, role);
        (from, to)
    }

    /// A label above the body, for what has no arrow; beside a deck, on which others stand.
    pub(super) fn draw_note(&self, canvas: &mut Canvas, note: &Math, role: Role) {
        let side = if self.is_deck { Point::new(1.0, 0.0) } else { Point::new(0.0, 1.0) };
        canvas.label(note, role, Anchor::Around { at: self.centre, radius: self.support(side), prefer: side.angle() });
    }
}

/// Asks for a label beside an arrow: at the shaft rather than the head, where there is room for that; else beyond the end
/// that is not at the body.
pub(super) fn label_arrow(canvas: &mut Canvas, [from, to]: [Point; 2], attach: Attach, label: &Math, role: Role) {
    let (_, base) = arrow_head(from, to);
    let tip = base.towards(to, 0.5);
    let (from, to) = if attach == Attach::Leaving { (from, tip) } else { (tip, from) };
    canvas.label(label, role, Anchor::Along { from, to });
}

/// Offsets 0, 1, -1, 2, -2, ... lanes.
fn lane(number: usize) -> f64 {
    let steps = u32::try_from(number.div_ceil(2)).unwrap_or(u32::MAX);
    let side = if number % 2 == 1 { 1.0 } else { -1.0 };
    LANE * f64::from(steps) * side
}

#[cfg(test)]
mod tests {
    use super::*;

    fn body(name: &str) -> Body {
        Body::new(&Math::Text(name.into()), Form::Disc, Point::ORIGIN)
    }

    #[test]
    fn a_long_name_makes_a_block() {
        assert!(matches!(body("A").outline, Outline::Disc(_)));
        assert!(matches!(body("ball and stick").outline, Outline::Block(_)));
    }

    #[test]
    fn arrows_in_nearly_the_same_direction_do_not_cross() {
        for turn in [0.1, -0.1] {
            let mut body = body("A");
            body.attach(Point::new(30.0, 0.0), Attach::Leaving);
            let (from, to) = body.attach(Point::polar(50.0, turn), Attach::Leaving);
            assert!(from.y * turn > 0.0 && to.y * turn > 0.0);
        }
    }

    #[test]
    fn a_second_arrow_in_the_same_direction_lies_beside_the_first() {
        let mut body = body("A");
        let push = Point::new(30.0, 0.0);
        let (first, _) = body.attach(push, Attach::Leaving);
        let (second, _) = body.attach(push, Attach::Leaving);
        assert!((first.y - second.y).abs() > 5.0);
    }
}
