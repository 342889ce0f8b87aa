//! The gravity of a fixed centre: energy from place to place, the shape of the orbit, the time along it.

use crate::Builder;
use crate::Name;
use crate::QuantityKind;
use crate::Reason;
use crate::alternative::Alternative;
use crate::builder::LAW_COST;
use crate::builder::SECOND_COST;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::kinematics;
use momentous_laws::orbit;
use momentous_quantity::Dimension;
use momentous_scene::Stage;
use momentous_scene::stage::Central;
use momentous_scene::stage::Orbit;
use momentous_solve::Relation;

/// Gravity's parameter GM.
const PARAMETER: Dimension = Dimension::new(0, 3, -2);

/// The terms that the laws of one orbit have in common.
struct OrbitTerms<'a> {
    index: usize,
    body: &'a str,
    name: String,
    centre: String,
    gravity: Expr,
    /// Distance, radial and transverse velocity at both instants.
    states: [[Expr; 3]; 2],
}

impl Builder<'_> {
    /// The equations of an orbit, and gravity's parameter.
    pub(crate) fn orbit(&mut self, index: usize, stage: &Central, path: &Path) -> Option<Expr> {
        let term = stage.gravity.as_ref()?;
        let (body, name, centre) = (stage.body.as_str(), self.called(&stage.body), self.point(&stage.about));
        let meaning = format!("gravity's parameter GM of {centre}");
        let gravity = self.read_positive(term, PARAMETER, &meaning, &path.key("gravity"));
        let states = [index + 1, index + 2].map(|instant| {
            let (radius, across) = self.polar_state(body, &stage.about, instant);
            let radial = self
                .quantity(Name::of(QuantityKind::Velocity, body).at(instant).along("r"))
                .map_or_else(Expr::zero, Expr::from);
            [radius, radial, across]
        });
        let speeds = [index + 1, index + 2].map(|instant| {
            self.quantity(Name::of(QuantityKind::Speed, body).at(instant)).map_or_else(Expr::zero, Expr::from)
        });
        if stage.orbit == Some(Orbit::Circle) {
            self.circle(&OrbitTerms { index, body, name, centre, gravity: gravity.clone(), states });
            return Some(gravity);
        }
        let energies = [0, 1].map(|side: usize| orbit::energy(&gravity, &states[side][0], &speeds[side]));
        let because = format!("gravity is the only force on {name}; the mass cancels");
        let [before, after] = energies.clone();
        self.law(&orbit::ORBIT_ENERGY, Some(index), because, (before, after));
        let orbit = OrbitTerms { index, body, name, centre, gravity, states };
        self.by_both_distances(&orbit);
        match stage.orbit {
            Some(Orbit::Ellipse) => self.ellipse(&orbit, energies),
            Some(Orbit::Parabola) => self.parabola(&orbit, energies),
            Some(Orbit::Circle) | None => {}
        }
        self.neglect_other_gravity();
        Some(orbit.gravity)
    }

    /// The name of what belongs to an orbit as a whole: with the stage where the body changes from one orbit to another.
    fn element(&self, kind: QuantityKind, index: usize, body: &str) -> Name {
        let is_on_an_orbit = |stage: &Stage| matches!(stage, Stage::Central(central) if central.body == body && central.gravity.is_some() && central.orbit.is_some());
        let stages = self.scene.stages.iter().enumerate();
        let orbits: Vec<usize> = stages.filter(|(_, stage)| is_on_an_orbit(stage)).map(|(place, _)| place).collect();
        let changes = orbits.windows(2).any(|pair| pair[0] + 1 < pair[1]);
        let stage = if changes { self.stage_label(index) } else { None };
        Name::of(kind, body).during(stage)
    }

    /// Least and, on an ellipse, greatest distance; heights above the surface where its radius is said.
    fn distance_of(&mut self, orbit: &OrbitTerms<'_>, which: &str, words: &str) -> Expr {
        let meaning = format!("the {words} distance of {} from {}", orbit.name, orbit.centre);
        self.positive(self.element(QuantityKind::Position, orbit.index, orbit.body).along(which), meaning).into()
    }

    fn ellipse(&mut self, orbit: &OrbitTerms<'_>, energies: [Expr; 2]) {
        // The shape of the orbit is no matter of the way from one position to the other.
        let (index, body, name) = (None, orbit.body, orbit.name.clone());
        let meaning = format!("the semi-major axis of the orbit of {name}");
        let axis = self.element(QuantityKind::SemiMajorAxis, orbit.index, body);
        let axis = Expr::from(self.positive(axis, meaning));
        let meaning = format!("the eccentricity of the orbit of {name}");
        let eccentricity = self.element(QuantityKind::Eccentricity, orbit.index, body);
        let eccentricity = Expr::from(self.positive(eccentricity, meaning));
        let meaning = format!("the period of the orbit of {name}");
        let period = Expr::from(self.positive(self.element(QuantityKind::Period, orbit.index, body), meaning));
        let [least, greatest] =
            [("min", "least"), ("max", "greatest")].map(|(which, words)| self.distance_of(orbit, which, words));
        let because: &str = &format!("the orbit is an ellipse with {} at a focus", orbit.centre);
        let one = Expr::one();
        let sides = [
            (least.clone(), axis.clone() * (one.clone() - eccentricity.clone())),
            (greatest.clone(), axis.clone() * (one + eccentricity.clone())),
            (Expr::integer(2) * axis.clone(), least.clone() + greatest.clone()),
        ];
        for sides in sides {
            self.law(&orbit::APSES, index, because, sides);
        }
        self.law(&orbit::PERIOD, index, because, orbit::period(&orbit.gravity, &axis, &period));
        let parameter = orbit::parameter(&axis, &eccentricity);
        let ends = [
            [least.clone(), greatest.clone()],
            [-1, 1].map(|sign| axis.clone() * (Expr::one() + Expr::integer(sign) * eccentricity.clone())),
        ];
        for ([radius, ..], [least, greatest]) in
            orbit.states.iter().flat_map(|state| ends.iter().map(move |end| (state, end)))
        {
            let reason = || Reason::OffTheOrbit(orbit.name.clone());
            self.require(radius.clone(), Relation::AtLeast, least.clone(), reason());
            self.require(greatest.clone(), Relation::AtLeast, radius.clone(), reason());
        }
        let bound = -(orbit.gravity.clone() / (Expr::integer(2) * axis.clone()));
        let mut times = Vec::new();
        for (side, (energy, [radius, radial, across])) in energies.into_iter().zip(&orbit.states).enumerate() {
            let instant = orbit.index + 1 + side;
            self.law(&orbit::VIS_VIVA, index, because, (energy, bound.clone()));
            let momentum = (radius.clone() * across.clone(), (orbit.gravity.clone() * parameter.clone()).sqrt());
            self.law(&orbit::ORBIT_SHAPE, index, because, momentum);
            let angle = self.angle_from_nearest(orbit, instant);
            self.recedes_behind_the_nearest(orbit, radial, &angle);
            let shape = Expr::one() + eccentricity.clone() * angle.cos();
            let from_focus = radius.clone() * shape.clone();
            self.law(&orbit::CONIC, index, because, (from_focus, parameter.clone()));
            self.speed_by_shape(orbit, instant, [radius, across], &shape);
            let meaning = format!("the eccentric anomaly of {name} {}", self.when(instant));
            let anomaly = Expr::from(self.symbol(Name::of(QuantityKind::EccentricAnomaly, body).at(instant), meaning));
            let value = orbit::anomaly(&orbit.gravity, &axis, radius, radial);
            self.law(&orbit::ORBIT_TIME, index, "it gives the position along the ellipse", (anomaly.clone(), value));
            let since = self.time_since_nearest(orbit, instant);
            let value = orbit::time_on_ellipse(&orbit.gravity, &axis, &anomaly, radius, radial);
            self.law(&orbit::ORBIT_TIME, index, "equal areas take equal times", (since.clone(), value));
            times.push(since);
        }
        self.time_between(orbit, &times, Some(&period));
    }

    /// Half a turn behind the nearest point a body moves outwards, on the other half inwards.
    fn recedes_behind_the_nearest(&mut self, orbit: &OrbitTerms<'_>, radial: &Expr, angle: &Expr) {
        let reason = Reason::RecedesElsewhere(orbit.name.clone());
        self.require(radial.clone() * angle.clone().sin(), Relation::AtLeast, Expr::zero(), reason);
    }

    /// Adds the transverse velocity where both radial ones are told, as at the nearest and the farthest point, energy and angular
    /// momentum together give the transverse one: each alone has two unknowns.
    fn by_both_distances(&mut self, orbit: &OrbitTerms<'_>) {
        let radial = |instant: usize| Name::of(QuantityKind::Velocity, orbit.body).at(instant).along("r").to_string();
        if ![1, 2].iter().all(|side| self.given.contains(&radial(orbit.index + side))) {
            return;
        }
        let [[near, inwards, across], [far, outwards, _]] = orbit.states.clone();
        let turning = |instant| Name::of(QuantityKind::Velocity, orbit.body).at(instant).along("theta").to_string();
        if ![1, 2].iter().any(|side| self.given.contains(&turning(orbit.index + side))) {
            self.require(across.clone(), Relation::AtLeast, Expr::zero(), Reason::MovesBack(orbit.name.clone()));
        }
        let two = || Expr::integer(2);
        let shares = Expr::one() - (near.clone() / far.clone()).power(two());
        let gained = two() * orbit.gravity.clone() * (near.powi(-1) - far.powi(-1));
        let gained = Expr::sum([gained, outwards.power(two()), -inwards.power(two())]);
        let because = "the transverse velocity at the second position, by the angular momentum, is substituted";
        self.law_at(
            SECOND_COST,
            &orbit::ORBIT_ENERGY,
            Some(orbit.index),
            because,
            (across.power(two()) * shares, gained),
        );
    }

    /// Adds the distance where eccentricity and transverse velocity are told: the parameter of the orbit drops out, and it
    /// follows at once.
    fn speed_by_shape(&mut self, orbit: &OrbitTerms<'_>, instant: usize, [radius, across]: [&Expr; 2], shape: &Expr) {
        let told = [
            self.element(QuantityKind::Eccentricity, orbit.index, orbit.body),
            Name::of(QuantityKind::Velocity, orbit.body).at(instant).along("theta"),
        ];
        if told.iter().all(|name| self.given.contains(&name.to_string())) {
            let because = "the angular momentum of the orbit is put into its equation";
            let sides =
                (radius.clone() * across.clone().power(Expr::integer(2)), orbit.gravity.clone() * shape.clone());
            self.law_at(SECOND_COST, &orbit::ORBIT_SHAPE, None, because, sides);
        }
    }

    fn neglect_other_gravity(&mut self) {
        self.neglect("the gravity of everything else", "it is small, or nearly the same for both bodies");
    }

    fn circle(&mut self, orbit: &OrbitTerms<'_>) {
        let index = Some(orbit.index);
        let meaning = format!("the period of the orbit of {}", orbit.name);
        let period = self.element(QuantityKind::Period, orbit.index, orbit.body);
        let period = Expr::from(self.positive(period, meaning));
        let [[radius, radial, across], [further, outwards, _]] = &orbit.states;
        let because = "the orbit is a circle";
        self.law(&orbit::CIRCLE, index, because, (further.clone(), radius.clone()));
        for velocity in [radial, outwards].into_iter().filter(|velocity| !velocity.is_zero()) {
            self.law(&orbit::CIRCLE, index, because, (velocity.clone(), Expr::zero()));
        }
        let held = (orbit.gravity.clone() / radius.clone()).sqrt();
        self.law(&orbit::CIRCLE, index, "gravity holds it on a circle", (across.clone(), held));
        self.law(&orbit::PERIOD, index, because, orbit::period(&orbit.gravity, radius, &period));
        self.neglect_other_gravity();
    }

    fn parabola(&mut self, orbit: &OrbitTerms<'_>, energies: [Expr; 2]) {
        let index = None;
        let least = self.distance_of(orbit, "min", "least");
        let because = "the orbit is a parabola, on which the speed is just enough to escape";
        let twice = Expr::integer(2) * least.clone();
        let mut times = Vec::new();
        for (side, (energy, [radius, radial, across])) in energies.into_iter().zip(&orbit.states).enumerate() {
            let instant = orbit.index + 1 + side;
            self.law(&orbit::ORBIT_ENERGY, index, because, (energy, Expr::zero()));
            let momentum = (radius.clone() * across.clone(), (orbit.gravity.clone() * twice.clone()).sqrt());
            self.law(&orbit::ORBIT_SHAPE, index, because, momentum);
            let angle = self.angle_from_nearest(orbit, instant);
            self.recedes_behind_the_nearest(orbit, radial, &angle);
            let from_focus = radius.clone() * (Expr::one() + angle.cos());
            self.law(&orbit::CONIC, index, because, (from_focus, twice.clone()));
            let since = self.time_since_nearest(orbit, instant);
            let value = orbit::time_on_parabola(&orbit.gravity, &least, radius, radial);
            self.law(&orbit::ORBIT_TIME, index, "equal areas take equal times", (since.clone(), value));
            times.push(since);
        }
        self.time_between(orbit, &times, None);
    }

    fn angle_from_nearest(&mut self, orbit: &OrbitTerms<'_>, instant: usize) -> Expr {
        let meaning = format!("the angle of {} from the nearest point {}", orbit.name, self.when(instant));
        self.symbol(Name::of(QuantityKind::TrueAnomaly, orbit.body).at(instant), meaning).into()
    }

    fn time_since_nearest(&mut self, orbit: &OrbitTerms<'_>, instant: usize) -> Expr {
        let meaning = format!("the time since {} passed the nearest point, {}", orbit.name, self.when(instant));
        self.symbol(Name::of(QuantityKind::Time, orbit.body).at(instant), meaning).into()
    }

    /// The time from one position to the other: on an ellipse a body that has passed the farthest point in between is counted towards the
    /// nearest point of the next revolution.
    fn time_between(&mut self, orbit: &OrbitTerms<'_>, times: &[Expr], period: Option<&Expr>) {
        let [before, after] = times else { return };
        let meaning = "the time from the first position to the second";
        let time = Expr::from(self.symbol(self.in_stage(QuantityKind::Duration, "", orbit.index), meaning));
        self.lasting[orbit.index] = Some(time.clone());
        let because = "both times are measured from the nearest point";
        let same = (time.clone(), after.clone() - before.clone());
        let early = Reason::EndsEarly(self.stage_phrase(orbit.index));
        let Some(period) = period else {
            self.law(&kinematics::CLOCK, Some(orbit.index), because, same);
            return self.require(after.clone(), Relation::AtLeast, before.clone(), early);
        };
        let next = (time, Expr::sum([after.clone(), period.clone(), -before.clone()]));
        let passes = format!("{because}, and the next nearest point is a period later");
        let late = Reason::EndsLate(self.stage_phrase(orbit.index));
        let ways = [
            ("does not pass the farthest point", because.to_owned(), same, Relation::AtLeast, early),
            ("passes the farthest point", passes, next, Relation::Less, late),
        ];
        let ways = ways.map(|(what, because, sides, relation, reason)| Alternative {
            what: format!("{} {what}", orbit.name),
            equations: vec![self.stated(LAW_COST, &kinematics::CLOCK, Some(orbit.index), because, sides, None)],
            conditions: vec![self.condition(after.clone(), relation, before.clone(), reason)],
            still: None,
        });
        self.choices.push(ways.into());
    }
}
