//! The impulse-momentum diagram of two bodies on a string over a pulley, each along its own part of the string.

use std::f64::consts::FRAC_PI_2;
use std::f64::consts::PI;

use momentous_expr::Expr;
use momentous_expr::Math;
use momentous_expr::name_math;
use momentous_figure::BodyMomentum;
use momentous_figure::Drawing;
use momentous_figure::MomentumDiagram;
use momentous_figure::Rest;
use momentous_scene::stage::Connected;
use momentous_scene::stage::Strand;

use super::balance::Balance;
use super::balance::complete;
use super::compass::Compass;
use super::labels::body_math;
use super::labels::product;
use super::quantities::Quantities;
use super::sheet::pulley::Side;
use super::sheet::pulley::sides_of;
use super::vectors::Labelled;
use super::words::diagram_wording;

/// Momentum before + impulses = momentum after for both bodies, each along its own part of the string.
pub(super) fn diagram(quantities: &Quantities<'_>, index: usize, stage: &Connected) -> Option<Drawing> {
    let strands = [&stage.trailing, &stage.leading];
    let sides = sides_of(quantities, stage);
    let loads = sides.iter().zip(strands).map(|(side, strand)| Load::of(quantities, index, side, strand));
    let loads = loads.collect::<Option<Vec<Load>>>()?;
    let duration = stage.duration.as_ref().and_then(|term| quantities.term(term));
    let duration_name = quantities.staged("dt", index);
    let known = duration.as_ref().map_or_else(|| quantities.named(&duration_name), |term| quantities.evaluate(term));
    let lasting = Lasting {
        label: duration.map_or_else(|| name_math(&duration_name), |term| quantities.symbolic(&term)),
        time: known.or_else(|| time_of_gain(&sides, &loads)),
    };
    let loaded = sides.iter().zip(&loads);
    let mut balances: Vec<Balance> =
        loaded.map(|(side, load)| load.balance(quantities, index, side, &lasting)).collect();
    complete(&mut balances, false);
    let compass = Compass::paper();
    let rows = balances.iter().zip(&sides).enumerate().map(|(number, (balance, side))| BodyMomentum {
        name: body_math(&balance.body),
        form: quantities.form(&balance.body),
        surface: (side.rest != Rest::Hanging).then(|| {
            let normal = side.rest.angle() + FRAC_PI_2;
            // The trailing body lies to the left: the mirror image.
            if number == 0 { PI - normal } else { normal }
        }),
        line_of_impact: None,
        before: balance.before.placed(&compass),
        impulses: balance.impulses.iter().map(|impulse| impulse.placed(&compass)).collect(),
        after: balance.after.placed(&compass),
    });
    let wording = diagram_wording(quantities, &compass, index, &balances);
    let diagram = MomentumDiagram { wording, bodies: rows.collect(), axes: Vec::new() };
    Some(diagram.drawing())
}

/// How long the string pulls, and how that is written.
struct Lasting {
    label: Math,
    time: Option<f64>,
}

/// The forces on a body besides the string, and its velocities along the string.
struct Load {
    mass: f64,
    gravity: f64,
    friction: Option<(Expr, f64)>,
    speeds: [f64; 2],
}

impl Load {
    fn of(quantities: &Quantities<'_>, index: usize, side: &Side<'_>, strand: &Strand) -> Option<Self> {
        let speed = |instant: usize| quantities.named(&quantities.velocity_name(side.body, instant));
        let friction = match &strand.friction {
            Some(term) => {
                let term = quantities.term(term)?;
                let value = quantities.evaluate(&term)?;
                Some((term, value))
            }
            None => None,
        };
        let speeds = [speed(index + 1)?, speed(index + 2)?];
        Some(Self { mass: quantities.mass(side.body, index + 1)?, gravity: quantities.named("g")?, friction, speeds })
    }

    /// The normal force: none on a body that hangs.
    fn press(&self, side: &Side<'_>) -> f64 {
        if side.rest == Rest::Hanging { 0.0 } else { self.mass * self.gravity * libm::cos(side.rest.angle()) }
    }

    fn friction(&self, side: &Side<'_>) -> f64 {
        self.friction.as_ref().map_or(0.0, |(_, coefficient)| coefficient * self.press(side))
    }

    /// Weight and friction along the string, forwards.
    fn drive(&self, side: &Side<'_>) -> f64 {
        -self.mass * self.gravity * side.forwards[1] - self.friction(side)
    }

    fn balance(&self, quantities: &Quantities<'_>, index: usize, side: &Side<'_>, lasting: &Lasting) -> Balance {
        let body = side.body;
        let [x, y] = side.forwards;
        let impulse = |strength: Math, force: Option<[f64; 2]>| Labelled {
            label: product([strength, lasting.label.clone()]),
            value: force.zip(lasting.time).map(|(force, time)| force.map(|part| part * time)),
        };
        let tension = quantities.staged("tension", index);
        let pull = quantities
            .named(&tension)
            .map(|size| side.forwards.map(|part| part * size * side.pull * f64::from(side.strands)));
        let pulled = match side.strands {
            1 => name_math(&tension),
            several => product([Math::Number(several.to_string()), name_math(&tension)]),
        };
        let weight = Some([0.0, -self.mass * self.gravity]);
        let mut impulses = vec![impulse(pulled, pull), impulse(quantities.weight_math(body, index), weight)];
        if side.rest != Rest::Hanging {
            // A floor pushes at right angles to the way, upwards.
            let normal = if x < 0.0 { [y, -x] } else { [-y, x] };
            let name = name_math(&format!("N_{body}"));
            impulses.push(impulse(name.clone(), Some(normal.map(|part| part * self.press(side)))));
            if let Some((coefficient, _)) = &self.friction {
                let rub = side.forwards.map(|part| -part * self.friction(side));
                impulses.push(impulse(product([quantities.symbolic(coefficient), name]), Some(rub)));
            }
        }
        let momentum = |instant: usize, speed: f64| {
            let label = quantities.momentum(body, body, instant, None).label;
            Labelled { label, value: Some(side.forwards.map(|part| self.mass * speed * part)) }
        };
        let [before, after] = [momentum(index + 1, self.speeds[0]), momentum(index + 2, self.speeds[1])];
        Balance { body: body.to_owned(), before, impulses, after }
    }
}

/// The time for which a motion lasts of which both bodies' gain in momentum along the string is known.
fn time_of_gain(sides: &[Side<'_>], loads: &[Load]) -> Option<f64> {
    // A body moves by its share of what the string runs, and so what acts on it counts.
    let each = || sides.iter().zip(loads).map(|(side, load)| (side, load, 1.0 / f64::from(side.strands)));
    let gain: f64 = each().map(|(_, load, share)| share * load.mass * (load.speeds[1] - load.speeds[0])).sum();
    let drive: f64 = each().map(|(side, load, share)| share * load.drive(side)).sum();
    Some(gain / drive).filter(|time| time.is_finite())
}
