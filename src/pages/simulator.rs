//! The simulators. The page is whole as it is served; its script asks the engine again as controls move.

use serde::Serialize;

use momentous_exercise::calls::{
    COLLISION, CollisionResponse, Control, DISCS, DiscsResponse, Offered, RESTITUTION, Refused, RefusedKind,
    RestitutionResponse, SimulatorRequest, USUAL_STEP,
};

use super::parameters::Parameters;
use super::view::View;

/// Values under a name, as they stand in an address.
type Preset = (&'static str, &'static str);

const OF_COLLISION: [Preset; 6] = [
    ("Elastic", "e=1"),
    ("Plastic", "e=0"),
    ("Equal masses", "m_A=2&m_B=2&v_A=3&v_B=0&e=1"),
    ("Heavy on light", "m_A=12&m_B=1&v_A=2&v_B=0&e=1"),
    ("Light on heavy", "m_A=1&m_B=12&v_A=4&v_B=0&e=0.9"),
    ("B at rest", "v_B=0"),
];

const OF_DISCS: [Preset; 6] = [
    ("Head on", "b=0"),
    ("B at rest", "v_A=4&v_B=0&e=0.9"),
    ("Billiards", "m_A=2&m_B=2&v_A=4&v_B=0&b=0.4&e=1"),
    ("Grazing", "b=0.75"),
    ("Plastic", "e=0"),
    ("They miss", "b=0.9"),
];

const OF_RESTITUTION: [Preset; 6] = [
    ("Steel on steel", "e=0.95"),
    ("Tennis ball", "h=2&e=0.73"),
    ("Clay", "e=0"),
    ("Nothing lost", "e=1"),
    ("In air", "h=10&v_t=12"),
    ("Two balls", "e=0.85&e_2=0.6"),
];

#[derive(Serialize)]
struct SimulatorPage<Shown> {
    title: &'static str,
    /// The call of the engine, and the last part of the address.
    call: &'static str,
    controls: Vec<ControlField>,
    presets: &'static [Preset],
    methods: Vec<Offered>,
    method: String,
    step: f64,
    shown: Option<Shown>,
    /// Why nothing is shown, as sentences.
    refused: Option<Vec<String>>,
}

#[derive(Serialize)]
struct ControlField {
    control: &'static Control,
    value: String,
}

/// A simulator by its name, with the values of the address.
#[expect(clippy::needless_pass_by_value, reason = "every page of the table of routes takes its part of the address so")]
pub(super) fn simulator(view: &View<'_>, name: String, fields: &Parameters) -> Result<String, Refused> {
    let engine = view.engine();
    match name.as_str() {
        "collision" => {
            let page = page::<CollisionResponse>(("Collision", "collision"), COLLISION, &OF_COLLISION, fields);
            view.page("collision", &page.filled(fields, |request| engine.collision(request))?)
        }
        "discs" => {
            let page = page::<DiscsResponse>(("Collision in the plane", "discs"), DISCS, &OF_DISCS, fields);
            // The methods of the comparison move on a line.
            let page = SimulatorPage { methods: Vec::new(), ..page };
            view.page("discs", &page.filled(fields, |request| engine.discs(request))?)
        }
        "restitution" => {
            let page =
                page::<RestitutionResponse>(("Restitution", "restitution"), RESTITUTION, &OF_RESTITUTION, fields);
            view.page("restitution", &page.filled(fields, |request| engine.restitution(request))?)
        }
        _ => {
            let refused = Refused::new(RefusedKind::Unknown, format!("there is no simulator `{name}`"));
            Err(refused.help("there are `collision`, `discs` and `restitution`"))
        }
    }
}

fn page<Shown>(
    (title, call): (&'static str, &'static str),
    controls: &'static [Control],
    presets: &'static [Preset],
    fields: &Parameters,
) -> SimulatorPage<Shown> {
    let field = |control: &'static Control| ControlField {
        control,
        value: match fields.get(control.name) {
            Some(value) => value.to_owned(),
            None if control.is_optional || fields.is_empty(control.name) => String::new(),
            None => control.usual.to_string(),
        },
    };
    SimulatorPage {
        title,
        call,
        controls: controls.iter().map(field).collect(),
        presets,
        methods: Offered::all(),
        method: fields.text("method").to_owned(),
        step: USUAL_STEP,
        shown: None,
        refused: None,
    }
}

impl<Shown> SimulatorPage<Shown> {
    /// The page with what the engine says; values that it refuses stay in their fields, with the reason.
    fn filled(
        mut self,
        fields: &Parameters,
        call: impl FnOnce(&SimulatorRequest) -> Result<Shown, Refused>,
    ) -> Result<Self, Refused> {
        let request = request(&self.controls, fields);
        self.step = request.as_ref().ok().and_then(|request| request.step).unwrap_or(USUAL_STEP);
        match request.and_then(|request| call(&request)) {
            Ok(shown) => self.shown = Some(shown),
            Err(refused) if refused.kind == RefusedKind::Fault => return Err(refused),
            Err(refused) => self.refused = Some(refused.sentences()),
        }
        Ok(self)
    }
}

fn request(controls: &[ControlField], fields: &Parameters) -> Result<SimulatorRequest, Refused> {
    let mut request =
        SimulatorRequest { method: fields.get("method").map(str::to_owned), ..SimulatorRequest::default() };
    let is_said = |field: &&ControlField| !(field.control.is_optional && field.value.is_empty());
    for ControlField { control, value } in controls.iter().filter(is_said) {
        request.values.insert(control.name.to_owned(), number((control.name, control.label), value)?);
    }
    let step = fields.get("step").or_else(|| (request.method.is_some() && fields.is_empty("step")).then_some(""));
    request.step = step.map(|step| number(("step", "step"), step)).transpose()?;
    Ok(request)
}

/// A number of a field, which the page calls by its label. An empty one is not the usual value, which nobody typed.
fn number((name, label): (&str, &str), text: &str) -> Result<f64, Refused> {
    if text.trim().is_empty() {
        let message = format!("the field \u{201c}{label}\u{201d} holds no number");
        return Err(Refused::new(RefusedKind::Invalid, message).help("type one"));
    }
    let wrong = |_| Refused::new(RefusedKind::Invalid, format!("`{name}` is a number, not `{text}`"));
    text.trim().parse().map_err(wrong)
}
