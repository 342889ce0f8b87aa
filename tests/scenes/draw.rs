//! Random scenes, written as an author would write them.

use std::fmt::Write;

use rand::rngs::ChaCha8Rng;
use rand::{RngExt, SeedableRng};

use super::table::{Kind, Shape, Table, plain};

/// A scene with a question.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// The stages, each with its keys as they are written.
    pub stages: Vec<Written>,
    /// Its axes.
    pub frame: Frame,
    /// The bodies whose masses are given.
    pub bodies: Vec<String>,
    /// What is given, in the order of the sheet.
    pub given: Vec<(String, String)>,
    /// The guided body, if there is one, and the axis of its guide.
    pub guided: Option<(String, &'static str)>,
    /// What is written of the body that turns about an axis, where there is one.
    pub inertia: Option<&'static str>,
    /// What may be asked, each with its unit; the first that the scene knows is.
    pub questions: Vec<(String, String)>,
}

/// A stage as it is written: its kind, and its keys with their values.
#[derive(Clone, Debug)]
pub struct Written {
    /// The kind of stage.
    pub kind: String,
    /// The keys as the table calls them, with their values.
    pub keys: Vec<(String, String)>,
}

/// The axes of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    name: &'static str,
    axes: &'static str,
    /// The components of a velocity; nothing with one axis.
    components: &'static [&'static str],
    vertical: bool,
    /// The normal of a surface.
    normal: &'static str,
}

const FRAMES: &[Frame] = &[
    Frame { name: "line", axes: "{ x: to the right }", components: &[""], vertical: false, normal: "to the left" },
    Frame { name: "up", axes: "{ y: upwards }", components: &[""], vertical: true, normal: "upwards" },
    Frame { name: "down", axes: "{ y: downwards }", components: &[""], vertical: true, normal: "upwards" },
    Frame {
        name: "plane",
        axes: "{ x: to the right, y: away from you }",
        components: &[".x", ".y"],
        vertical: false,
        normal: "-x",
    },
    Frame {
        name: "upright",
        axes: "{ x: to the right, y: upwards }",
        components: &[".x", ".y"],
        vertical: true,
        normal: "upwards",
    },
    Frame {
        name: "space",
        axes: "{ x: [ahead, back], y: [to port, to starboard], z: upwards }",
        components: &[".x", ".y", ".z"],
        vertical: false,
        normal: "-x",
    },
    Frame { name: "slope", axes: "{ x: up the slope }", components: &[""], vertical: false, normal: "-x" },
    Frame {
        name: "slope-upright",
        axes: "{ x: down the slope, y: away from the slope }",
        components: &[".x", ".y"],
        vertical: true,
        normal: "+y",
    },
    Frame { name: "line-upright", axes: "{ x: to the right }", components: &[""], vertical: true, normal: "-x" },
    Frame {
        name: "string",
        axes: "{ x: [along the string, back along the string] }",
        components: &[""],
        vertical: false,
        normal: "-x",
    },
    Frame {
        name: "circle",
        axes: "{ x: [counter-clockwise, clockwise] }",
        components: &[""],
        vertical: false,
        normal: "-x",
    },
    Frame {
        name: "circle-upright",
        axes: "{ x: [counter-clockwise, clockwise] }",
        components: &[""],
        vertical: true,
        normal: "-x",
    },
    Frame { name: "polar", axes: "polar", components: &[".theta"], vertical: false, normal: "-x" },
    Frame { name: "polar-upright", axes: "polar", components: &[".theta"], vertical: true, normal: "-x" },
];

/// How many questions are tried until the scene knows what is asked.
const QUESTIONS: usize = 14;

/// What can be asked of every scene: a velocity, an energy, a momentum, a change.
const GENERAL: &[&str] =
    &["v_{A}{j}", "v_{A}{j}", "v_{B}{j}", "T_{A}{j}", "T_gained{s}", "p_{j}", "J_{A}{s}", "speed_{A}{j}"];

/// Draws one thing after another.
struct Dice(ChaCha8Rng);

/// How often a scene is drawn with other numbers.
pub const NUMBERS: u64 = 8;

impl Dice {
    fn of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.0.random_range(0..all.len())]
    }

    fn once_in(&mut self, many: u32) -> bool {
        self.0.random_range(0..many) == 0
    }
}

/// Scene number `seed` with a stage of that kind, alone or before another.
pub fn draw(table: &Table, kind: &str, seed: u64) -> Drawn {
    draw_again(table, kind, seed, 0)
}

/// The same scene with other numbers.
pub fn draw_again(table: &Table, kind: &str, seed: u64, numbers: u64) -> Drawn {
    let mut number = Dice(ChaCha8Rng::seed_from_u64(seed ^ digest(&format!("{kind} {numbers}"))));
    let mut dice = Dice(ChaCha8Rng::seed_from_u64(seed ^ digest(kind)));
    let first = table.kind(kind);
    let shape = dice.of(&first.shapes).clone();
    let frame = *frame(dice.of::<String>(&shape.axes).as_str());
    let mut stages = vec![written(first, &shape, frame, &mut dice)];
    let mut given = Given::new(table, frame);
    if dice.once_in(3)
        && let Some((second, shape)) = follower(table, frame, &mut dice)
    {
        stages.push(written(second, &shape, frame, &mut dice));
    }
    let text = values(&stages);
    let patterns: String = shape.given.iter().map(|(pattern, _)| pattern.as_str()).collect();
    let mut bodies = bodies(&format!("{text}{patterns}"));
    for body in ["A", "B"] {
        // A drift and a moment act on every body of the scene.
        if bodies.len() < 1 + usize::from(shape.has("positions")) && !text.contains("{A}") {
            bodies.push(body.to_owned());
        }
    }
    let can_be_guided = frame.components == [".x", ".y"] && (shape.has("guided") || dice.once_in(4));
    let guided = can_be_guided.then(|| bodies.last().cloned().unwrap_or_else(|| "A".to_owned()));
    given.start(&shape, &bodies, guided.as_deref(), &mut number);
    for (_, value) in stages.iter().flat_map(|stage| &stage.keys) {
        given.within(value, &mut number);
    }
    let numbers = stages.len();
    let mut asked = Vec::new();
    for _ in 0..QUESTIONS {
        let at = dice.0.random_range(0..numbers);
        let kind = table.kind(&stages[at].kind);
        let ways: Vec<&str> = kind.finds.iter().map(String::as_str).collect();
        let pattern = if kind.asks_generally && dice.once_in(2) { *dice.of(GENERAL) } else { *dice.of(&ways) };
        let name = named(pattern, at, numbers, &stages[at]);
        let name = if pattern.starts_with("v_") && !pattern.contains('.') && frame.components.len() > 1 {
            format!("{name}{}", dice.of(frame.components))
        } else {
            name
        };
        let unit = table.unit(&name).to_owned();
        if given.all.iter().all(|(known, _)| *known != name) && asked.iter().all(|(other, _)| *other != name) {
            asked.push((name, unit));
        }
    }
    let guided = guided.map(|body| (body, "x"));
    let inertia = text.contains("{R}").then_some(", inertia: I_R");
    Drawn { stages, frame, bodies, given: given.all, guided, inertia, questions: asked }
}

/// The values of all keys, one after another.
fn values(stages: &[Written]) -> String {
    let values: Vec<&str> = stages.iter().flat_map(|stage| &stage.keys).map(|(_, value)| value.as_str()).collect();
    values.join(" ")
}

fn digest(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn frame(name: &str) -> &'static Frame {
    FRAMES.iter().find(|frame| frame.name == name).unwrap_or_else(|| panic!("no axes are called {name}"))
}

/// A stage that can stand behind another in these axes.
fn follower<'a>(table: &'a Table, frame: Frame, dice: &mut Dice) -> Option<(&'a Kind, Shape)> {
    let fits = |shape: &&Shape| {
        shape.axes.iter().any(|axes| axes == frame.name)
            && shape.given.is_empty()
            && shape.words.iter().all(|word| word == "positions")
    };
    let all: Vec<(&Kind, &Shape)> =
        table.stages.iter().flat_map(|kind| kind.shapes.iter().filter(fits).map(move |shape| (kind, shape))).collect();
    let (kind, shape) = *dice.of(if all.is_empty() { return None } else { &all });
    Some((kind, shape.clone()))
}

fn written(kind: &Kind, shape: &Shape, frame: Frame, dice: &mut Dice) -> Written {
    let mut keys: Vec<(String, String)> = Vec::new();
    let further: Vec<&String> = shape.further.iter().filter(|_| dice.once_in(3)).collect();
    for key in shape.needed.iter().chain(further) {
        let ways = kind.keys.get(key).unwrap_or_else(|| panic!("{}: no key {key}", kind.name));
        let mut value = dice.of(ways).clone();
        if frame.axes.starts_with("{ y") {
            value = value.replace("+x", "+y").replace("-x", "-y").replace("*x", "*y");
        }
        keys.push((key.clone(), value));
    }
    Written { kind: kind.name.clone(), keys }
}

/// The bodies that a text names, as `{A}`; those whose masses are given.
fn bodies(text: &str) -> Vec<String> {
    ["A", "B", "C"].into_iter().filter(|body| text.contains(&format!("{{{body}}}"))).map(str::to_owned).collect()
}

fn named(pattern: &str, at: usize, stages: usize, stage: &Written) -> String {
    let name = stage.keys.iter().find(|(key, _)| key == "name").map(|(_, name)| name.clone());
    let bracket = format!("[{}]", name.unwrap_or_else(|| (at + 1).to_string()));
    at_stage(pattern, at).replace("{s}", if stages > 1 { &bracket } else { "" })
}

/// What is given.
struct Given<'a> {
    table: &'a Table,
    frame: Frame,
    all: Vec<(String, String)>,
}

impl<'a> Given<'a> {
    fn new(table: &'a Table, frame: Frame) -> Self {
        Self { table, frame, all: Vec::new() }
    }

    fn add(&mut self, name: &str, kind: &str, dice: &mut Dice) {
        if self.all.iter().any(|(known, _)| known == name) {
            return;
        }
        let (unit, numbers) = self.table.values(kind);
        let value = format!("{} {unit}", dice.of(numbers));
        self.all.push((name.to_owned(), value.trim().to_owned()));
    }

    /// What is given of the bodies at the start: masses, velocities, places.
    fn start(&mut self, shape: &Shape, bodies: &[String], guided: Option<&str>, dice: &mut Dice) {
        for body in bodies {
            self.add(&format!("m_{body}"), "m", dice);
        }
        let components = self.frame.components;
        let free = |body: &str| guided.filter(|guided| *guided == body).map_or(components, |_| &components[..1]);
        if !shape.has("bare") && !shape.has("guided") {
            for body in bodies.iter().take(if shape.has("tied") { 1 } else { 3 }) {
                for component in free(body) {
                    self.add(&format!("v_{body}1{component}"), "v", dice);
                }
            }
        }
        if shape.has("positions") {
            for body in bodies {
                for component in components {
                    self.add(&format!("r_{body}1{component}"), "r", dice);
                }
            }
        }
        for (pattern, kind) in &shape.given {
            self.add(&at_stage(pattern, 0).replace("{s}", ""), kind, dice);
        }
    }

    /// The names that the stages use.
    fn within(&mut self, text: &str, dice: &mut Dice) {
        let text = format!(" {text}");
        let words: Vec<&str> = text.split(|sign: char| !sign.is_alphanumeric() && sign != '_').collect();
        for pair in words.windows(2) {
            // Behind a number stands a unit.
            let is_unit = pair[0].starts_with(|sign: char| sign.is_ascii_digit());
            if let Some(kind) = self.table.kind_of(pair[1]).filter(|_| !is_unit) {
                self.add(pair[1], kind, dice);
            }
        }
        if text.contains("{R}") {
            self.add("I_R", "I", dice);
        }
        if text.contains("piston") {
            self.add("v_piston", "w", dice);
        }
    }
}

impl Shape {
    fn has(&self, word: &str) -> bool {
        self.words.iter().any(|listed| listed == word)
    }
}

impl Drawn {
    /// The endings of the names of its velocities and momenta, one for each axis.
    pub fn components(&self) -> &'static [&'static str] {
        self.frame.components
    }

    /// The scene as a problem file that asks one of its questions.
    pub fn file(&self, question: usize) -> String {
        self.asking(self.questions.get(question..=question).unwrap_or_default())
    }

    /// The scene as a problem file that asks for quantities, each with its unit.
    pub fn asking(&self, questions: &[(String, String)]) -> String {
        let text = values(&self.stages);
        let mut file = String::from("id: random/scene\ntitle: A random scene\nlevel: core\nscene:\n");
        let _ = writeln!(file, "  axes: {}", self.frame.axes);
        if self.frame.vertical {
            file.push_str("  plane: vertical\n");
        }
        file.push_str("  bodies:\n");
        for body in &self.bodies {
            let rail = |(_, axis): &(String, &str)| format!(", guide: {{ along: {axis}, by: the rail }}");
            let guide = self.guided.as_ref().filter(|(guided, _)| guided == body).map(rail).unwrap_or_default();
            let _ = writeln!(file, "    {body}: {{ name: body {body}{guide} }}");
        }
        if let Some(inertia) = self.inertia {
            let _ = writeln!(file, "    R: {{ name: the rotor{inertia} }}");
        }
        if text.contains("wall") {
            let _ = writeln!(file, "  surfaces:\n    wall: {{ name: the wall, normal: {} }}", self.frame.normal);
        }
        if text.contains("piston") {
            let normal = self.frame.normal;
            let _ =
                writeln!(file, "  surfaces:\n    piston: {{ name: the piston, normal: {normal}, velocity: v_piston }}");
        }
        let axes = self.frame.name;
        if axes.starts_with("circle") || axes.starts_with("polar") || text.split_whitespace().any(|word| word == "O") {
            file.push_str("  points:\n    O: { name: the point O }\n");
        }
        file.push_str("  stages:\n");
        for stage in &self.stages {
            let _ = writeln!(file, "    - {}:", stage.kind);
            for (key, value) in &stage.keys {
                let _ = writeln!(file, "        {}: {}", plain(key), with_bodies(value));
            }
        }
        file.push_str("given:\n");
        for (name, value) in &self.given {
            let _ = writeln!(file, "  {name}: {value}");
        }
        let told: Vec<String> = self.given.iter().map(|(name, _)| format!("{{{{ {name} | named }}}}")).collect();
        let _ = writeln!(file, "text: >\n  Given are {}. Find what is asked.", told.join(", "));
        file.push_str("allow: [one-sheet, one-answer, equals-given]\nask:\n");
        for (name, unit) in questions {
            let _ = writeln!(file, "  - {{ find: \"{name}\", unit: {unit} }}");
        }
        file
    }
}

/// A text with its bodies in place of `{A}`.
fn with_bodies(text: &str) -> String {
    ["A", "B", "C", "W", "R"].iter().fold(text.to_owned(), |text, body| text.replace(&format!("{{{body}}}"), body))
}

/// A name with its bodies, and the instants before and after a stage in place of `{i}` and `{j}`.
fn at_stage(pattern: &str, stage: usize) -> String {
    with_bodies(pattern).replace("{i}", &(stage + 1).to_string()).replace("{j}", &(stage + 2).to_string())
}
