//! Repeated bounces of a body that arrives somehow on a smooth floor, level or sloping.

use crate::Builder;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::bounce_terms::BounceTerms;
use crate::incline::Fall;
use crate::stage::bounces::{COUNTED, IN_ALL, at_bounce, one_after_another};
use momentous_expr::Expr;
use momentous_expr::Symbol;
use momentous_fault::Path;
use momentous_laws::Law;
use momentous_laws::bouncing;
use momentous_laws::momentum;
use momentous_scene::Axis;
use momentous_scene::stage::Bounces;
use momentous_solve::Relation;

/// The bounces of one body: how it arrives, and what acts on it between.
struct Bouncing<'a> {
    index: usize,
    name: String,
    e: &'a Expr,
    count: &'a Expr,
    /// The speed towards the floor with which it first arrives.
    arrival: Expr,
    /// The acceleration towards the floor.
    press: Expr,
    /// Along the floor, where the scene has two axes.
    along: Option<Along>,
}

struct Along {
    axis: Axis,
    velocity: Expr,
    acceleration: Expr,
    from: Expr,
}

impl Builder<'_> {
    pub(super) fn bounces_after_arrival(&mut self, index: usize, stage: &Bounces, [e, count]: [&Expr; 2], path: &Path) {
        let body = stage.body.as_str();
        let Some(falls) = self.falling(index, stage.incline.as_ref(), path) else { return };
        let mut arrival = None;
        let mut along = None;
        for (axis, fall) in self.axes.clone().into_iter().map(|(axis, _)| axis).zip(falls) {
            let velocity = self.velocity(body, index + 1, axis);
            match fall {
                Fall::Towards { acceleration, down } => {
                    arrival = Some((Expr::integer(down) * velocity, Expr::integer(down) * acceleration));
                }
                Fall::Along(acceleration) => {
                    let from = self.place(body, index + 1, axis);
                    along = Some(Along { axis, velocity, acceleration, from });
                }
            }
        }
        let Some((arrival, press)) = arrival else { return };
        let name = self.called(body);
        let reason = Reason::NotTowardsFloor(name.clone());
        self.require(arrival.clone(), Relation::AtLeast, Expr::zero(), reason);
        let squared = arrival.clone().powi(2);
        let (body_of_all, count_of_all) = (body.to_owned(), Some(count.clone()));
        self.bounce_terms.push(BounceTerms {
            stage: index,
            body: body_of_all,
            e: e.clone(),
            squared,
            count: count_of_all,
        });
        let bouncing = Bouncing { index, name, e, count, arrival, press, along };
        self.speeds_and_times(&bouncing);
        self.places_of_bounces(body, &bouncing);
    }

    /// Speed, height and time of the n-th bounce, and when all are over.
    fn speeds_and_times(&mut self, bounces: &Bouncing<'_>) {
        let (name, e, press) = (&bounces.name, bounces.e, &bounces.press);
        let because = format!("each bounce multiplies the speed of {name} away from the floor by e");
        let speed = self.positive(
            at_bounce(QuantityKind::Velocity),
            format!("the speed of {name} away from the floor just after the n-th bounce"),
        );
        let value = bouncing::speed_after(e, bounces.count, &bounces.arrival);
        bounces.law(self, &bouncing::BOUNCE_SPEED, &because, (speed, value));
        let height = self.positive(
            at_bounce(QuantityKind::Height),
            format!("the greatest distance of {name} from the floor after the n-th bounce"),
        );
        let value = bouncing::height_of(&speed.into(), press);
        bounces.law(
            self,
            &bouncing::BOUNCE_HEIGHT,
            &format!("{name} rises until it no longer moves away from the floor"),
            (height, value),
        );
        let meaning = format!("the duration of the flight of {name} after the n-th bounce");
        let flight = self.positive(at_bounce(QuantityKind::Duration), meaning);
        let value = bouncing::flight(&speed.into(), press);
        bounces.law(
            self,
            &bouncing::BOUNCE_FLIGHT,
            &format!("{name} returns to the floor with the speed with which it left"),
            (flight, value),
        );
        let start = self.clock(bounces.index + 1).map_or_else(Expr::zero, Expr::from);
        let because = format!("{because}, hence the time of each flight by e");
        let whole = bounces.whole();
        let meaning = format!("the time of the n-th bounce of {name}");
        let time = self.positive(at_bounce(QuantityKind::Time), meaning);
        let value = start.clone() + bouncing::time_to(e, bounces.count, &whole);
        bounces.law(self, &bouncing::BOUNCE_TIME, &because, (time, value));
        let from_the_first = start.is_zero();
        if from_the_first {
            self.shows(one_after_another(&whole, e, Some(bounces.count)));
        }
        // A ball that loses nothing does not stop.
        if e.is_one() {
            return;
        }
        let meaning = format!("the time at which {name} stops bouncing");
        let total = self.positive(Name::of(QuantityKind::Time, IN_ALL), meaning);
        let value = start + bouncing::time_of_all(e, &whole);
        bounces.law(self, &bouncing::BOUNCE_TIME, &because, (total, value));
        if from_the_first {
            self.shows(one_after_another(&whole, e, None));
        }
    }

    /// The place of the n-th bounce along the floor, the distance to the next, and the place where all are over.
    fn places_of_bounces(&mut self, body: &str, bounces: &Bouncing<'_>) {
        let Some(along) = &bounces.along else { return };
        let letter = along.axis.letter();
        let level = along.acceleration.is_zero();
        let because = if level {
            format!("the floor is smooth and level: nothing changes the velocity of {} along it", bounces.name)
        } else {
            format!("the slope is smooth: along it, only weight accelerates {}", bounces.name)
        };
        let way = |time: &Expr| bouncing::along(&along.velocity, &along.acceleration, time);
        let mut times =
            vec![(COUNTED, "at its n-th bounce", bouncing::time_to(bounces.e, bounces.count, &bounces.whole()))];
        if !bounces.e.is_one() {
            let meaning = format!("the time for which {} bounces", bounces.name);
            let lasts = self.positive(Name::of(QuantityKind::Duration, IN_ALL), meaning);
            let each = format!("each flight of {} takes e times as long as the one before", bounces.name);
            bounces.law(
                self,
                &bouncing::BOUNCE_TIME,
                &each,
                (lasts, bouncing::time_of_all(bounces.e, &bounces.whole())),
            );
            self.shows(one_after_another(&bounces.whole(), bounces.e, None));
            times.push((IN_ALL, "where its bouncing ends", lasts.into()));
        }
        for (which, when, time) in times {
            let meaning = format!("the {letter}-component of the position of {} {when}", bounces.name);
            let place = self.symbol(Name::of(QuantityKind::Coordinate(along.axis), which), meaning);
            bounces.law(self, &bouncing::BOUNCE_PLACE, &because, (place, along.from.clone() + way(&time)));
        }
        let flight = self.positive(at_bounce(QuantityKind::Duration), String::new());
        let gained = bouncing::time_to(bounces.e, bounces.count, &bounces.whole()) * along.acceleration.clone();
        let leaving = if level { along.velocity.clone() } else { along.velocity.clone() + gained };
        let meaning = format!("the distance along the floor from the n-th bounce of {} to the next", bounces.name);
        let range = self.symbol(at_bounce(QuantityKind::Range), meaning);
        let value = bouncing::along(&leaving, &along.acceleration, &flight.into());
        bounces.law(self, &bouncing::BOUNCE_RANGE, &because, (range, value));
        if level {
            let after = self.velocity(body, bounces.index + 2, along.axis);
            self.law(&momentum::NO_IMPULSE, Some(bounces.index), because, (after, along.velocity.clone()));
        }
    }
}

impl Bouncing<'_> {
    /// The duration of a flight that begins with the speed of the first arrival.
    fn whole(&self) -> Expr {
        bouncing::flight(&self.arrival, &self.press)
    }

    fn law(&self, builder: &mut Builder<'_>, law: &'static Law, because: &str, (symbol, value): (Symbol, Expr)) {
        builder.law(law, Some(self.index), because, (symbol.into(), value));
    }
}
