//! The contact of an impact, magnified: the force in the course of time, whose area is the impulse.

use serde::Serialize;

use momentous_simulate::{Body, Budget, Method, Penalty, World};

use super::{Amount, Curve, Row};

/// How long a contact without loss is made to last, in s.
const LASTS: f64 = 0.005;

/// The step of the run in s, and how many steps make a point of the plot.
const STEP: f64 = LASTS / 2000.0;
const EVERY: usize = 16;

/// The longest run in s: with a large loss bodies part slowly.
const LONGEST: f64 = 8.0 * LASTS;

/// A contact as a spring and a dashpot make it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Magnified {
    /// The force against the time in ms, down to the axis on both sides: while the bodies are pressed together, and while they part.
    pub force: Vec<Curve>,
    /// The greatest force in N.
    pub greatest: f64,
    /// How long it lasts, in ms.
    pub lasts: f64,
    /// Its numbers.
    pub rows: Vec<Row>,
}

/// The contact of the two bodies of a scene, from when they meet; nothing where a spring and a dashpot do not return its coefficient.
pub(super) fn magnified(scene: &World<1>) -> Option<Magnified> {
    let [first, second] = scene.bodies.as_slice() else { return None };
    let mut world = World::<1>::new(scene.restitution);
    for (body, place) in [(first, -first.radius), (second, second.radius)] {
        world.bodies.push(Body::sphere(&body.name, body.mass, body.radius, [place], [body.velocity.x]));
    }
    let (reduced, frequency) = (first.mass * second.mass / (first.mass + second.mass), std::f64::consts::PI / LASTS);
    let method = Penalty { step: STEP, stiffness: Some(reduced * frequency * frequency) };
    let run = method.run(&world, &Budget::until(LONGEST).at_most(1)).ok()?;
    // A run that reached its time has not seen the bodies part.
    run.impacts.first()?;
    let velocities = |body: usize| run.paths.get(body).into_iter().flatten().map(|segment| segment.motion.at(0.0).1.x);
    let mut parts = [Part::default(), Part::default()];
    for ((after, before), other) in velocities(1).skip(1).zip(velocities(1)).zip(velocities(0).skip(1)) {
        let [pressed, parting] = &mut parts;
        let part = if after < other { pressed } else { parting };
        part.push(second.mass * (after - before));
    }
    let [pressed, parting] = parts;
    let (middle, end) = (pressed.lasts, pressed.lasts + parting.lasts);
    let force = vec![
        pressed.curve(format!("deformation, {}", pressed.impulse_told()), "body-3", 0.0),
        parting.curve(format!("restitution, {}", parting.impulse_told()), "body-4", middle),
    ];
    let greatest = pressed.greatest().max(parting.greatest());
    let row = |what: &str, amount: Amount| Row { what: what.to_owned(), amount };
    let impulse = pressed.impulse + parting.impulse;
    let rows = vec![
        row("Impulse of deformation", Amount::new(pressed.impulse, impulse, "N\u{a0}s")),
        row("Impulse of restitution", Amount::new(parting.impulse, impulse, "N\u{a0}s")),
        row("Their ratio, which is e", Amount::new(parting.impulse / pressed.impulse, 1.0, "")),
        row("The whole area, which is J", Amount::new(impulse, impulse, "N\u{a0}s")),
        row("Greatest force", Amount::new(greatest, greatest, "N")),
        row("Duration", Amount::new(1e3 * end, end, "ms")),
    ];
    Some(Magnified { force, greatest, lasts: 1e3 * end, rows })
}

/// One of the two parts of a contact.
#[derive(Default)]
struct Part {
    /// The force of each step, in N.
    forces: Vec<f64>,
    /// Their impulse in N s.
    impulse: f64,
    /// How long it lasts, in s.
    lasts: f64,
}

impl Part {
    /// A step that gives this impulse.
    fn push(&mut self, impulse: f64) {
        if impulse > 0.0 {
            self.forces.push(impulse / STEP);
            self.impulse += impulse;
            self.lasts += STEP;
        }
    }

    fn greatest(&self) -> f64 {
        self.forces.iter().copied().fold(0.0, f64::max)
    }

    fn impulse_told(&self) -> String {
        Amount::new(self.impulse, self.impulse, "N\u{a0}s").text
    }

    /// The force as an area over the axis; times in ms, from a time in s.
    fn curve(&self, name: String, role: &'static str, from: f64) -> Curve {
        let end = from + self.lasts;
        let times = (0_u32..).map(|step| from + STEP * f64::from(step));
        let points = times.zip(&self.forces).step_by(EVERY).map(|(time, force)| [time, *force]);
        let last = self.forces.last().map(|force| [end, *force]);
        let all = [[from, 0.0]].into_iter().chain(points).chain(last).chain([[end, 0.0]]);
        Curve::new(name, role, all.map(|[time, force]| [1e3 * time, force]))
    }
}
