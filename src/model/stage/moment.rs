//! A moment about a fixed point or the centre of mass: the angular momentum of all bodies before and after.

use crate::Builder;
use crate::Effect;
use crate::Influence;
use crate::Name;
use crate::QuantityKind;
use crate::Work;
use momentous_expr::Expr;
use momentous_fault::Path;
use momentous_laws::angular;
use momentous_quantity::Dimension;
use momentous_scene::Plane;
use momentous_scene::Strength;
use momentous_scene::stage::Moment;

impl Builder<'_> {
    pub(crate) fn moment(&mut self, index: usize, stage: &Moment, path: &Path) {
        let Some(centre) = self.centre(&stage.about) else { return };
        self.counts_turns("a moment", &path.key("value"));
        let (start, end) = self.duration(index, &stage.during, &path.key("during"));
        self.lasting[index] = Some(end.clone() - start.clone());
        let letters = self.axis_letters();
        let meaning = format!("the moment about {centre}");
        let at = path.key("value");
        let moments: Vec<(Option<&str>, Expr)> = match (&stage.value, &letters[..]) {
            (Strength::Components(components), [_, _, _]) => {
                let moments = self.strengths(components, Dimension::ENERGY, &meaning, &at);
                letters.iter().map(|letter| Some(*letter)).zip(moments).collect()
            }
            (value, [_, _]) => vec![(None, self.strength(value, Dimension::ENERGY, &meaning, &at))],
            _ => {
                let fault = momentous_fault::Fault::new(momentous_fault::Code::Value, "a moment in space is a vector");
                self.faults.push(fault.help("write its components: `value: { x: 3 N*m, z: M }`").at_path(at));
                return;
            }
        };
        let sizes: Vec<Expr> = moments.iter().map(|(_, moment)| moment.clone()).collect();
        self.moment_acts(index, &stage.about, &centre, &sizes);
        for (letter, moment) in moments {
            let about = Name::of(QuantityKind::AngularMomentum, &stage.about).along(letter);
            let [before, after] =
                [index + 1, index + 2].map(|instant| self.quantity(about.clone().at(instant)).map(Expr::from));
            let (Some(before), Some(after)) = (before, after) else { return };
            self.told_throughout(&meaning, &moment, &end);
            let (law, because) = if moment.is_zero() {
                let nothing = letter.map_or("is zero".to_owned(), |along| format!("has no {along}-component"));
                (&angular::CONSERVATION, format!("{meaning} {nothing}"))
            } else {
                (&angular::ANGULAR_IMPULSE, format!("only the moment changes the angular momentum about {centre}"))
            };
            let gained = self.angular_impulse(index, (&centre, letter), &moment, &start, &end);
            let gained = (!moment.is_zero()).then_some(gained);
            self.law(law, Some(index), because, (Expr::sum([before].into_iter().chain(gained)), after));
        }
        let has_rotor = self.scene.rotors().next().is_some();
        if has_rotor {
            self.neglect("friction in the bearings and air resistance", "the problem gives none");
        }
        if self.weight_acts_across() {
            let (what, why) = if has_rotor {
                ("weight and the force of the bearings", "they have no moment about the axis")
            } else {
                ("weight and everything else that acts across the motion", "it has no moment about the axis")
            };
            self.not_needed(what, why);
        }
    }

    /// The moment on the bodies together, and the forces by which they hold together; what holds a fixed point pushes, too.
    fn moment_acts(&mut self, index: usize, about: &str, centre: &str, moments: &[Expr]) {
        let bodies: Vec<String> = self.timeline.alive(index + 1).into_iter().map(str::to_owned).collect();
        for body in &bodies {
            let turning = Influence::outside(index, body, format!("the moment about {centre}"));
            let size = moments.iter().find(|moment| !moment.is_zero()).cloned().unwrap_or_else(Expr::zero);
            let turning = turning.force(vec![Expr::zero(); self.axes.len()]).moment(moments.to_vec());
            self.acts(turning.works(Effect::Of(size), "the moment does work as the system turns"));
            if about != "G" {
                self.acts(Influence::outside(index, body, format!("what holds {centre}")).workless().through(about));
            }
            if self.scene.plane == Plane::Vertical {
                let weight = self.some_weight_on(index, body);
                self.acts(weight);
            }
            let others: Vec<&str> = bodies.iter().filter(|other| *other != body).map(String::as_str).collect();
            if !others.is_empty() {
                let between = Influence::outside(index, body, "the force between the bodies").by(&others);
                self.acts(Influence { work: Work::OfForce, ..between });
            }
        }
    }
}
