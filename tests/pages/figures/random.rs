//! Random figures: every kind, with zeros, tiny and huge values, unknowns, long labels and crowded directions.

use std::f64::consts::{PI, TAU};

use momentous::expr::Math;
use momentous::figure::*;

use super::scenes::{body, degrees, name, product, sub, valued, wording, xy};

/// `SplitMix64` (Steele, Lea and Flood 2014): small, and the same everywhere.
pub struct Dice(pub u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, count: u32) -> u32 {
        u32::try_from(self.roll() % u64::from(count)).unwrap_or(0)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.below(1_000_001)) / 1e6
    }

    fn chance(&mut self, percent: u32) -> bool {
        self.below(100) < percent
    }

    fn vector(&mut self) -> [f64; 2] {
        let size = match self.below(8) {
            0 => 0.0,
            1 => 0.02,
            2 => 50.0,
            _ => self.between(0.5, 9.0),
        };
        // Directions along the axes are what problems have most.
        let angle = if self.chance(60) { f64::from(self.below(4)) * PI / 2.0 } else { self.angle() };
        [size * angle.cos(), size * angle.sin()]
    }

    fn angle(&mut self) -> f64 {
        self.between(-PI, PI)
    }

    fn label(&mut self, short: Math) -> Math {
        if self.chance(40) { valued(short, "-12.50", "kg m/s") } else { short }
    }

    fn labelled(&mut self, short: Math) -> LabelledVector {
        let label = self.label(short);
        if self.chance(10) { LabelledVector::unknown(label) } else { LabelledVector::known(label, self.vector()) }
    }
}

fn body_name(dice: &mut Dice, number: usize) -> Math {
    let letter = ["A", "B", "C", "D"][number % 4];
    match dice.below(4) {
        0 => Math::Text("bullet".to_owned()),
        1 => Math::Text(format!("cart {letter}")),
        _ => name(letter),
    }
}

fn form(dice: &mut Dice) -> Form {
    if dice.chance(50) { Form::Disc } else { Form::Block }
}

pub fn momentum_diagram(dice: &mut Dice) -> Drawing {
    let bodies = (0..=dice.below(3) as usize).map(|number| BodyMomentum {
        name: body_name(dice, number),
        form: form(dice),
        surface: dice.chance(30).then(|| dice.angle()),
        line_of_impact: dice.chance(30).then(|| dice.angle()),
        before: dice.labelled(product("m", "v", "A", 1)),
        impulses: (0..dice.below(4)).map(|index| dice.labelled(sub("J", &index.to_string()))).collect(),
        after: dice.labelled(product("m", "v", "A", 2)),
    });
    let bodies = bodies.collect();
    MomentumDiagram { wording: wording("Random momenta"), bodies, axes: xy() }.drawing()
}

fn moving_body(dice: &mut Dice, number: usize) -> MovingBody {
    let mut moving = MovingBody::new(body_name(dice, number)).shaped(form(dice));
    for index in 0..dice.below(3) {
        let vector = dice.labelled(sub("v", &index.to_string()));
        let mut velocity = if dice.chance(70) { Moving::velocity(vector) } else { Moving::force(vector) };
        if dice.chance(40) {
            velocity = velocity.at_angle(f64::from(dice.below(4)) * PI / 2.0, degrees("38.5"));
        }
        moving = moving.with(velocity);
    }
    moving
}

pub fn situation(dice: &mut Dice) -> Drawing {
    let angle = dice.chance(50).then(|| AngleMark { from: 0.0, label: degrees("30") });
    let layout = match dice.below(4) {
        0 => Layout::Line(Line {
            angle: if dice.chance(60) { 0.0 } else { dice.angle() },
            bodies: (0..=dice.below(3) as usize).map(|number| moving_body(dice, number)).collect(),
            floor: dice.chance(60),
            slope: angle.map(|angle| angle.label),
            spring: dice.chance(40).then(|| {
                let place = [LineSpring::Ahead, LineSpring::Behind, LineSpring::Between][dice.below(3) as usize];
                (place, dice.chance(60).then(|| name("k")))
            }),
            hung: dice.chance(20).then_some(0),
            tied: if dice.chance(20) {
                let tie = if dice.chance(50) { Tie::Slack } else { Tie::Firm };
                (0..3).map(|behind| (behind, tie)).collect()
            } else {
                Vec::new()
            },
            wall: dice.chance(20),
            grains: None,
            exhaust: None,
        }),
        1 => {
            let second = match dice.below(6) {
                0 | 1 => Partner::Surface,
                2 => Partner::Wedge(moving_body(dice, 1)),
                3 => Partner::Plate(moving_body(dice, 1)),
                _ => Partner::Body(moving_body(dice, 1)),
            };
            let is_wedge = matches!(second, Partner::Wedge(_));
            Layout::Contact(Contact {
                walls: Vec::new(),
                line_of_impact: if is_wedge { dice.between(-2.6, -1.8) } else { dice.angle() },
                show_line: dice.chance(60),
                angle,
                first: moving_body(dice, 0),
                second,
            })
        }
        2 => Layout::Central(Central {
            centre: name("O"),
            angle: dice.angle(),
            radius: dice.chance(70).then(|| valued(name("r"), "1.25", "m")),
            body: moving_body(dice, 2),
            path: dice.chance(60).then(|| if dice.chance(50) { CentralPath::Circle } else { CentralPath::Nearest }),
            legs: dice.chance(40).then(|| [sub("r", "x"), sub("r", "y")]),
            moment: dice.chance(50).then(|| Moment { label: name("M"), value: dice.between(-1.0, 1.0) }),
            other_end: dice.chance(40).then(|| sub("r", "max")),
        }),
        _ => Layout::Fall(Fall {
            end: None,
            body: moving_body(dice, 0),
            heights: (0..=dice.below(4))
                .map(|index| Height {
                    label: dice.chance(70).then(|| sub("h", &index.to_string())),
                    value: dice.between(1.5, 2.0) / f64::from(index + 1),
                })
                .collect(),
            ground: match dice.below(4) {
                0 => Ground::Level,
                1 => Ground::Slope(dice.between(-0.8, 0.8), dice.chance(70).then(|| name("\u{3b2}"))),
                2 => Ground::Sprung(moving_body(dice, 1)),
                _ => Ground::Body(moving_body(dice, 1)),
            },
        }),
    };
    Situation { wording: wording("A random situation"), layout, axes: xy() }.drawing()
}

/// Bodies on cords, strings, ramps and other bodies.
pub fn held(dice: &mut Dice) -> Drawing {
    let label = |dice: &mut Dice, text: &str| dice.chance(70).then(|| name(text));
    // None of them has vectors with angles of their own.
    let moving_body = |dice: &mut Dice, number| {
        let mut moving = moving_body(dice, number);
        moving.vectors.iter_mut().for_each(|vector| vector.angle = None);
        moving
    };
    let layout = match dice.below(4) {
        0 => Layout::Swing(Swing {
            body: MovingBody::new(body_name(dice, 0)).shaped(form(dice)),
            ends: (0..=dice.below(2))
                .map(|_| SwingEnd {
                    angle: if dice.chance(40) { 0.0 } else { dice.between(-2.0, 2.0) },
                    label: label(dice, "\u{3b8}"),
                    vectors: moving_body(dice, 0).vectors,
                })
                .collect(),
            length: label(dice, "L"),
            height: label(dice, "h"),
            by: match dice.below(3) {
                0 => SwingBy::Cord,
                1 => SwingBy::Track,
                _ => SwingBy::LevelTrack(dice.chance(60).then(|| MovingBody::new(body_name(dice, 1)))),
            },
        }),
        1 => {
            let side = |dice: &mut Dice, number| PulleySide {
                body: moving_body(dice, number),
                rest: match dice.below(3) {
                    0 => Rest::Hanging,
                    1 => Rest::Level,
                    _ => Rest::Slope(dice.between(0.1, 1.3), label(dice, "\u{3b1}")),
                },
                strands: u8::try_from(dice.below(7)).unwrap_or(1),
            };
            Layout::Pulley(Pulley { sides: [side(dice, 0), side(dice, 1)] })
        }
        2 => {
            let rightwards = dice.chance(50);
            let face = if dice.chance(50) {
                Face::Deck { way: label(dice, "L"), rightwards, floor: false }
            } else {
                let (angle, height) = (dice.between(0.1, 1.2), label(dice, "h"));
                Face::Slope { angle, label: label(dice, "\u{3b2}"), rightwards, height }
            };
            Layout::Ride(Ride { rider: moving_body(dice, 0), carrier: moving_body(dice, 1), face })
        }
        _ => Layout::Ramp(Ramp {
            body: MovingBody::new(body_name(dice, 0)).shaped(form(dice)),
            top: dice.chance(80).then(|| moving_body(dice, 0).vectors),
            foot: dice.chance(80).then(|| moving_body(dice, 0).vectors),
            rightwards: dice.chance(50),
            height: label(dice, "h"),
        }),
    };
    Situation { wording: wording("A random situation"), layout, axes: xy() }.drawing()
}

/// Bodies that begin a free flight.
pub fn launched(dice: &mut Dice) -> Drawing {
    let direction = dice.angle();
    let depth = |dice: &mut Dice| match dice.below(3) {
        0 => Depth::Nothing,
        _ => Depth::Below(dice.chance(70).then(|| sub("r", "y"))),
    };
    let velocity = Moving::velocity(LabelledVector::known(sub("v", "A1"), [direction.cos(), direction.sin()]));
    let stated = dice.chance(50).then(|| AngleMark { from: 0.0, label: degrees("30") });
    let body = MovingBody::new(body_name(dice, 0)).shaped(form(dice)).with(Moving { angle: stated, ..velocity });
    let target = match dice.below(4) {
        0 => Target::Top,
        1 => Target::Ground(depth(dice)),
        2 => Target::Slope(dice.between(-0.8, 0.8), dice.chance(70).then(|| name("\u{3b1}"))),
        _ => Target::Wall(dice.chance(70).then(|| name("d")), dice.chance(70).then(|| depth(dice))),
    };
    let end = dice.chance(50).then(|| [dice.between(-40.0, 40.0), dice.between(-20.0, 2.0)]);
    let resisted = dice.chance(30).then(|| Resisted { fading: dice.between(0.05, 4.0), end });
    let launch = Launch { body, direction: dice.chance(90).then_some(direction), target, resisted };
    Situation { wording: wording("A random flight"), layout: Layout::Launch(launch), axes: xy() }.drawing()
}

pub fn angular_diagram(dice: &mut Dice) -> Drawing {
    let state = |dice: &mut Dice| AngularState {
        radius: dice.labelled(name("r")),
        momenta: (0..=dice.below(2)).map(|index| dice.labelled(sub("mv", &index.to_string()))).collect(),
    };
    let particles = (0..=dice.below(2) as usize).map(|number| AngularMomentum {
        name: body_name(dice, number),
        before: state(dice),
        impulse: AngularImpulse {
            label: dice.label(sub("M", "O")),
            value: dice.chance(80).then(|| f64::from(dice.below(3)) - 1.0),
        },
        after: state(dice),
    });
    let particles = particles.collect();
    AngularDiagram { wording: wording("Random moments"), centre: name("O"), particles, axes: xy() }.drawing()
}

pub fn force_plot(dice: &mut Dice) -> Drawing {
    let scale = [1e-5, 1e-3, 1.0, 40.0, 2e6][dice.below(5) as usize];
    let mut time = 0.0;
    let points = (0..=dice.below(8)).map(|_| {
        let point = [time, scale * dice.between(if dice.0.is_multiple_of(2) { 0.0 } else { -5.0 }, 9.0)];
        time += scale * dice.between(0.0, 2.0);
        point
    });
    let points: Vec<[f64; 2]> = points.collect();
    let axis = |symbol: &str, unit: &str| PlotAxis { symbol: name(symbol), unit: unit.to_owned(), told: Vec::new() };
    ForcePlot {
        wording: wording("A random force"),
        time: axis("t", "s"),
        force: axis("F", "kN"),
        area: dice.chance(70).then(|| name("J")),
        marks: points.get(1).map(|[time, _]| (*time, sub("t", "a"))).into_iter().collect(),
        points,
    }
    .drawing()
}

pub fn mass_centre(dice: &mut Dice) -> Drawing {
    let mut particle = |label: &str| PlacedParticle {
        name: name(label),
        position: [dice.between(0.0, 5.0), if dice.chance(40) { 0.0 } else { dice.between(0.0, 4.0) }],
        velocity: dice.chance(80).then(|| dice.labelled(sub("v", label))),
        forces: Vec::new(),
    };
    let particles = ["A", "B", "C", "D"].map(&mut particle).to_vec();
    let centre = Some(particle("G"));
    let (arrows, origin) = (Travel::Velocity, Some(name("O")));
    MassCentre { wording: wording("Random particles"), particles, centre, arrows, origin, axes: xy() }.drawing()
}

/// What no scene has, but a fault upstream might send: nothing at all, and numbers that are none.
pub fn nonsense() -> Vec<Drawing> {
    let none = LabelledVector::known(name("p"), [f64::NAN, f64::INFINITY]);
    let row = BodyMomentum {
        name: Math::Row(Vec::new()),
        form: Form::Disc,
        surface: Some(f64::NAN),
        line_of_impact: Some(f64::INFINITY),
        before: none.clone(),
        impulses: vec![none.clone(), LabelledVector::known(name("J"), [1e300, -1e300])],
        after: LabelledVector::known(name("q"), [1e-300, 0.0]),
    };
    let moving = body("A").with(Moving::velocity(none).at_angle(f64::NAN, name("b")));
    let contact = Contact {
        walls: Vec::new(),
        line_of_impact: f64::NAN,
        show_line: true,
        angle: Some(AngleMark { from: f64::INFINITY, label: name("a") }),
        first: moving.clone(),
        second: Partner::Surface,
    };
    let end = SwingEnd { angle: f64::NAN, label: Some(name("a")), vectors: moving.vectors.clone() };
    let swing =
        Swing { body: moving.clone(), ends: vec![end], length: None, height: Some(name("h")), by: SwingBy::Cord };
    let side = || PulleySide { body: moving.clone(), rest: Rest::Slope(f64::NAN, Some(name("a"))), strands: 0 };
    let pulley = Pulley { sides: [side(), side()] };
    let face = Face::Slope { angle: f64::NAN, label: Some(name("a")), rightwards: true, height: None };
    let ride = Ride { rider: moving.clone(), carrier: moving.clone(), face };
    let launch = Launch {
        body: moving.clone(),
        direction: Some(f64::NAN),
        target: Target::Slope(f64::NAN, Some(name("a"))),
        resisted: None,
    };
    let fall = Fall {
        body: moving,
        heights: vec![Height { label: None, value: f64::NAN }],
        ground: Ground::Slope(f64::NAN, None),
        end: Some(Vec::new()),
    };
    let situation =
        |layout| Situation { wording: wording("Nonsense"), layout, axes: vec![AxisMark::new("x", f64::NAN)] };
    let axis = || PlotAxis { symbol: name("t"), unit: String::new(), told: Vec::new() };
    let plot = ForcePlot {
        wording: wording("Nonsense"),
        time: axis(),
        force: axis(),
        points: vec![[f64::NAN, 1.0], [TAU, f64::INFINITY]],
        area: Some(name("J")),
        marks: vec![(f64::NAN, name("t"))],
    };
    vec![
        MomentumDiagram { bodies: vec![row], ..MomentumDiagram::default() }.drawing(),
        MomentumDiagram::default().drawing(),
        situation(Layout::Contact(contact)).drawing(),
        situation(Layout::Fall(fall)).drawing(),
        situation(Layout::Launch(launch)).drawing(),
        situation(Layout::Swing(swing)).drawing(),
        situation(Layout::Pulley(pulley)).drawing(),
        situation(Layout::Ride(ride)).drawing(),
        plot.drawing(),
    ]
}
