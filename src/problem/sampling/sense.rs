//! The two directions between which the sign of a quantity decides, in words.

use momentous_expr::Symbol;
use momentous_model::QuantityKind;
use momentous_scene::Axis;
use momentous_scene::Scene;
use momentous_scene::Senses;
use momentous_scene::Stage;

use super::super::compiling::planned::Problem;

impl Problem {
    /// The words for the two directions between which the sign of a quantity decides; none where the sign is no direction,
    /// as that of a place or an energy, or where the direction is given separately, as that of a thrust is.
    #[must_use]
    pub fn senses(&self, symbol: Symbol) -> Option<Senses> {
        let scene = &self.loaded().draft.scene;
        let name = Some(self.model().name(symbol)).filter(|name| !name.is_plain())?;
        if name.kind == QuantityKind::GuideImpulse {
            return scene.across_guide(&name.subject);
        }
        let is_directed = match name.kind {
            ref kind if kind.is_velocity() => true,
            QuantityKind::Momentum | QuantityKind::Impulse | QuantityKind::MeanForce => true,
            // The direction of a strength is given separately.
            QuantityKind::Force => scene.bodies.contains_key(&name.subject) && !has_thrust(scene, &name.subject),
            _ => false,
        };
        senses_of(scene, &self.model().symbols.entry(symbol).name).filter(|_| is_directed)
    }

    /// The words for the two directions of the axis along which a quantity is counted, those of places included: whoever takes the other
    /// direction as positive turns its sign.
    #[must_use]
    pub fn turns_with(&self, symbol: Symbol) -> Option<Senses> {
        let is_place = matches!(self.model().name(symbol).kind, QuantityKind::Position | QuantityKind::Coordinate(_));
        let along = || senses_of(&self.loaded().draft.scene, &self.model().symbols.entry(symbol).name);
        self.senses(symbol).or_else(|| along().filter(|_| is_place))
    }

    /// The directions in space of what is counted along a string and belongs to a body that hangs on it.
    #[must_use]
    pub fn hanging(&self, symbol: Symbol) -> Option<Senses> {
        self.senses(symbol)?;
        let body = &self.model().name(symbol).subject;
        let [down, up] = ["downwards", "upwards"].map(str::to_owned);
        self.loaded().draft.scene.stages.iter().find_map(|stage| {
            let Stage::Connected(connected) = stage else { return None };
            let [sinks, rises] =
                [&connected.leading, &connected.trailing].map(|strand| strand.hangs() && strand.body == *body);
            let [positive, negative] = if sinks { [&down, &up] } else { [&up, &down] }.map(Clone::clone);
            (sinks || rises).then_some(Senses { positive, negative })
        })
    }

    /// The letter of the axis along which a component is counted.
    #[must_use]
    pub fn axis(&self, symbol: Symbol) -> Option<char> {
        let name = &self.model().symbols.entry(symbol).name;
        axis_of(&self.loaded().draft.scene, name).and_then(|(axis, _)| axis.letter().chars().next())
    }
}

fn has_thrust(scene: &Scene, body: &str) -> bool {
    scene.stages.iter().any(|stage| matches!(stage, Stage::Thrust(thrust) if thrust.body == body))
}

/// The axis of a component, that in which its name ends or the only one, and the words for its two directions.
fn axis_of(scene: &Scene, name: &str) -> Option<(Axis, Senses)> {
    let axes = scene.axes.rectangular();
    let letter = name.rsplit_once('.').map(|(_, letter)| letter.split(['@', '[']).next().unwrap_or(letter));
    match letter {
        Some(letter) => axes.into_iter().find(|(axis, _)| axis.letter() == letter),
        None if axes.len() == 1 => axes.into_iter().next(),
        None => None,
    }
}

pub(super) fn senses_of(scene: &Scene, name: &str) -> Option<Senses> {
    axis_of(scene, name).map(|(_, senses)| senses)
}
