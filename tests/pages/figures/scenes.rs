//! Scenes for the figures' tests: a gallery of typical and extreme ones, and random ones.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use momentous::expr::Math;
use momentous::expr::Operator;
use momentous::figure::*;

pub fn name(text: &str) -> Math {
    Math::Identifier(text.to_owned())
}

pub fn sub(base: &str, below: &str) -> Math {
    Math::subscripted(base, below)
}

pub fn product(mass: &str, velocity: &str, body: &str, instant: u32) -> Math {
    Math::Row(vec![sub(mass, body), Math::Operator(Operator::Juxtapose), sub(velocity, &format!("{body}{instant}"))])
}

pub fn valued(label: Math, value: &str, unit: &str) -> Math {
    Math::relation(
        label,
        Operator::Equals,
        Math::Row(vec![Math::Number(value.to_owned()), Math::Text(unit.to_owned())]),
    )
}

pub fn wording(title: &str) -> Wording {
    Wording { title: title.to_owned(), description: format!("A figure of this: {title}."), caption: title.to_owned() }
}

pub fn xy() -> Vec<AxisMark> {
    vec![AxisMark::new("x", 0.0), AxisMark::new("y", FRAC_PI_2)]
}

pub fn row(body: &str, form: Form, before: [f64; 2], impulse: [f64; 2], after: [f64; 2]) -> BodyMomentum {
    BodyMomentum {
        name: name(body),
        form,
        surface: None,
        line_of_impact: None,
        before: LabelledVector::known(product("m", "v", body, 1), before),
        impulses: vec![LabelledVector::known(sub("J", body), impulse)],
        after: LabelledVector::known(product("m", "v", body, 2), after),
    }
}

pub fn momentum_diagrams() -> Vec<(&'static str, MomentumDiagram)> {
    let diagram = |title, bodies, axes| MomentumDiagram { wording: wording(title), bodies, axes };
    let x = || vec![AxisMark::new("x", 0.0)];
    let two_carts = vec![
        row("A", Form::Block, [9.0, 0.0], [-10.2, 0.0], [-1.2, 0.0]),
        row("B", Form::Block, [-4.0, 0.0], [10.2, 0.0], [6.2, 0.0]),
    ];
    let fifty = vec![
        row("A", Form::Disc, [50.0, 0.0], [-1.0, 0.0], [49.0, 0.0]),
        row("B", Form::Disc, [0.0, 0.0], [1.0, 0.0], [1.0, 0.0]),
    ];
    let (c, s) = (0.866_025_4, 0.5);
    let oblique = vec![
        BodyMomentum {
            line_of_impact: Some(PI / 6.0),
            ..row("A", Form::Disc, [8.0, 0.0], [-4.157 * c, -4.157 * s], [4.4, -2.08])
        },
        BodyMomentum {
            line_of_impact: Some(PI / 6.0),
            ..row("B", Form::Disc, [0.0, 0.0], [4.157 * c, 4.157 * s], [3.6, 2.08])
        },
    ];
    let wall = vec![BodyMomentum {
        surface: Some(PI),
        impulses: vec![LabelledVector::known(name("J"), [-8.0, 0.0])],
        ..row("A", Form::Disc, [5.0, 3.0], [-8.0, 0.0], [-3.0, 3.0])
    }];
    let three = vec![
        row("A", Form::Disc, [9.0, 0.0], [-9.0, 0.0], [0.0, 0.0]),
        row("B", Form::Disc, [0.0, 0.0], [4.5, 2.6], [4.5, 2.6]),
        row("C", Form::Disc, [0.0, 0.0], [4.5, -2.6], [4.5, -2.6]),
    ];
    let crate_on_floor = vec![BodyMomentum {
        name: Math::Text("crate".to_owned()),
        form: Form::Block,
        surface: Some(FRAC_PI_2),
        line_of_impact: None,
        before: LabelledVector::known(sub("mv", "1"), [2.0, 0.0]),
        impulses: vec![
            LabelledVector::known(
                Math::Row(vec![name("F"), Math::Operator(Operator::Juxtapose), name("t")]),
                [6.0, 0.0],
            ),
            LabelledVector::known(
                Math::Row(vec![name("W"), Math::Operator(Operator::Juxtapose), name("t")]),
                [0.0, -4.0],
            ),
            LabelledVector::known(
                Math::Row(vec![name("N"), Math::Operator(Operator::Juxtapose), name("t")]),
                [0.0, 4.0],
            ),
            LabelledVector::known(
                Math::Row(vec![sub("\u{3bc}", "k"), name("N"), Math::Operator(Operator::Juxtapose), name("t")]),
                [-1.5, 0.0],
            ),
        ],
        after: LabelledVector::unknown(sub("mv", "2")),
    }];
    let long = vec![BodyMomentum {
        before: LabelledVector::known(valued(product("m", "v", "A", 1), "12.50", "kg m/s"), [12.5, 0.0]),
        impulses: vec![LabelledVector::known(valued(sub("J", "A"), "-18.75", "N s"), [-18.75, 0.0])],
        after: LabelledVector::known(valued(product("m", "v", "A", 2), "-6.25", "kg m/s"), [-6.25, 0.0]),
        ..row("A", Form::Block, [12.5, 0.0], [-18.75, 0.0], [-6.25, 0.0])
    }];
    let floor =
        vec![BodyMomentum { surface: Some(FRAC_PI_2), ..row("A", Form::Disc, [0.0, -6.0], [0.0, 10.0], [0.0, 4.0]) }];
    let nt = || {
        let mut axes = xy();
        axes.push(AxisMark::new("n", PI / 6.0));
        axes.push(AxisMark::new("t", PI / 6.0 + FRAC_PI_2));
        axes
    };
    vec![
        ("two_carts", diagram("Two carts", two_carts, x())),
        ("fifty_to_one", diagram("One momentum fifty times the other", fifty, x())),
        ("oblique", diagram("Oblique impact", oblique, nt())),
        ("wall", diagram("A ball meets a wall", wall, xy())),
        ("three", diagram("Three pucks", three, xy())),
        ("crate", diagram("A crate is pushed", crate_on_floor, xy())),
        ("long_labels", diagram("Long labels", long, x())),
        ("floor", diagram("A ball meets the floor", floor, vec![AxisMark::new("y", FRAC_PI_2)])),
    ]
}

pub fn velocity(label: Math, value: [f64; 2]) -> Moving {
    Moving::velocity(LabelledVector::known(label, value))
}

pub fn degrees(value: &str) -> Math {
    Math::Row(vec![Math::Number(value.to_owned()), Math::Text("\u{b0}".to_owned())])
}

pub fn body(text: &str) -> MovingBody {
    MovingBody::new(name(text))
}

pub fn speed(body: &str, value: &str) -> Math {
    valued(sub("v", body), value, "m/s")
}

/// What stands around bodies.
pub fn surroundings() -> Vec<(&'static str, Situation)> {
    let figure = |title, layout, axes| Situation { wording: wording(title), layout, axes };
    let corner = Contact {
        walls: vec![FRAC_PI_2],
        line_of_impact: 0.0,
        show_line: false,
        angle: None,
        first: body("A").with(velocity(sub("v", "1"), [8.0, 5.0])),
        second: Partner::Surface,
    };
    let belt =
        Line { bodies: vec![body("B").shaped(Form::Belt).with(velocity(name("u"), [2.0, 0.0]))], ..Line::default() };
    let vane = Vane {
        name: name("V"),
        directions: [0.0, 2.2],
        jet: [Some(velocity(name("v"), [9.0, 0.0])), Some(velocity(name("w"), [-3.5, 4.9]))],
        vectors: vec![
            velocity(name("u"), [3.0, 0.0]),
            Moving::force(LabelledVector::known(sub("F", "V"), [5.0, -1.2])),
        ],
        angle: Some(AngleMark { from: 0.0, label: name("\u{3b8}") }),
    };
    vec![
        ("corner", figure("A puck in a corner", Layout::Contact(corner), xy())),
        ("belt", figure("A belt", Layout::Line(belt), vec![AxisMark::new("x", 0.0)])),
        ("vane", figure("A jet on a vane", Layout::Vane(vane), xy())),
    ]
}

pub fn situations() -> Vec<(&'static str, Situation)> {
    let figure = |title, layout, axes| Situation { wording: wording(title), layout, axes };
    let line = Line {
        angle: 0.0,
        bodies: vec![
            body("A").shaped(Form::Block).with(velocity(speed("A1", "4.0"), [4.0, 0.0])),
            body("B").shaped(Form::Block).with(velocity(speed("B1", "2.5"), [-2.5, 0.0])),
            body("C").shaped(Form::Block).with(velocity(sub("v", "C1"), [0.0, 0.0])),
        ],
        floor: true,
        ..Line::default()
    };
    let slope = Line {
        angle: PI / 9.0,
        bodies: vec![
            body("A").shaped(Form::Block).with(velocity(speed("A1", "4.0"), [4.0 * 0.9397, 4.0 * 0.342])),
            body("B").shaped(Form::Block).with(Moving::force(LabelledVector::known(name("F"), [-2.0, -0.7279]))),
        ],
        floor: true,
        slope: Some(degrees("20")),
        ..Line::default()
    };
    let oblique = Contact {
        walls: Vec::new(),
        line_of_impact: PI / 6.0,
        show_line: true,
        angle: Some(AngleMark { from: 0.0, label: degrees("30") }),
        first: body("A").with(velocity(speed("A1", "4.00"), [4.0, 0.0])),
        second: Partner::Body(body("B").with(velocity(speed("B1", "3.00"), [-1.5, 2.598]).at_angle(PI, degrees("60")))),
    };
    let wall = Contact {
        walls: Vec::new(),
        line_of_impact: -FRAC_PI_2,
        show_line: true,
        angle: None,
        first: MovingBody::new(Math::Text("ball".to_owned()))
            .with(velocity(speed("1", "12"), [8.0, -9.0]).at_angle(0.0, degrees("48.4")))
            .with(velocity(sub("v", "2"), [8.0, 5.0]).at_angle(0.0, name("\u{3b8}"))),
        second: Partner::Surface,
    };
    let straight_back = Contact {
        walls: Vec::new(),
        line_of_impact: 0.0,
        show_line: false,
        angle: None,
        first: body("A").with(velocity(sub("v", "1"), [8.0, 0.0])).with(velocity(sub("v", "2"), [-5.0, 0.0])),
        second: Partner::Surface,
    };
    let central = Central {
        centre: name("O"),
        angle: 0.6,
        radius: Some(valued(name("r"), "1.2", "m")),
        body: body("S")
            .with(velocity(sub("v", "r"), [1.65, 1.13]))
            .with(velocity(Math::Sub(Arc::new(name("v")), Arc::new(name("\u{3b8}"))), [-1.7, 2.48])),
        path: Some(CentralPath::Circle),
        legs: None,
        other_end: None,
        moment: Some(Moment { label: name("M"), value: 3.0 }),
    };
    let height = |label: &str, value| Height { label: Some(sub("h", label)), value };
    let bounces = Fall {
        body: MovingBody::new(Math::Text("ball".to_owned())),
        heights: vec![height("0", 2.0), height("1", 1.28), height("2", 0.82), Height { label: None, value: 0.5 }],
        ground: Ground::Level,
        end: None,
    };
    let pile = Fall {
        body: body("R").with(velocity(sub("v", "R"), [0.0, 0.0])),
        heights: vec![height("", 2.0)],
        ground: Ground::Body(body("P").shaped(Form::Block).with(velocity(sub("v", "P"), [0.0, 0.0]))),
        end: None,
    };
    let roof = Fall {
        body: MovingBody::new(Math::Text("ball".to_owned())),
        heights: vec![height("", 2.0)],
        ground: Ground::Slope(0.4, Some(name("\u{3b2}"))),
        end: None,
    };
    vec![
        ("line", figure("Three carts", Layout::Line(line), vec![AxisMark::new("x", 0.0)])),
        ("slope", figure("On a slope", Layout::Line(slope), Vec::new())),
        ("oblique", figure("Two pucks touch", Layout::Contact(oblique), xy())),
        ("wall", figure("A ball meets the floor", Layout::Contact(wall), xy())),
        ("back", figure("A ball meets a wall", Layout::Contact(straight_back), vec![AxisMark::new("x", 0.0)])),
        ("central", figure("A satellite", Layout::Central(central), Vec::new())),
        ("bounces", figure("A bouncing ball", Layout::Fall(bounces), Vec::new())),
        ("pile", figure("A ram above a pile", Layout::Fall(pile), Vec::new())),
        ("roof", figure("A ball above a roof", Layout::Fall(roof), xy())),
    ]
}

pub fn angular_diagrams() -> Vec<(&'static str, AngularDiagram)> {
    let state = |radius: &str, at: [f64; 2], momentum: Math, value: [f64; 2]| AngularState {
        radius: LabelledVector::known(sub("r", radius), at),
        momenta: vec![LabelledVector::known(momentum, value)],
    };
    let diagram = |title, impulse, value| AngularDiagram {
        wording: wording(title),
        centre: name("O"),
        particles: vec![AngularMomentum {
            name: name("A"),
            before: state("1", [1.0, 0.0], product("m", "v", "A", 1), [0.0, 2.0]),
            impulse: AngularImpulse { label: impulse, value },
            after: state("2", [0.5, 0.3], product("m", "v", "A", 2), [-2.0, 3.0]),
        }],
        axes: xy(),
    };
    vec![
        ("pull", diagram("A cord is pulled in", sub("M", "O"), Some(0.0))),
        (
            "turn",
            diagram(
                "A moment acts",
                Math::Integral(
                    Arc::new(Math::Number("0".into())),
                    Arc::new(name("t")),
                    Arc::new(sub("M", "O")),
                    Arc::new(name("t")),
                ),
                Some(3.0),
            ),
        ),
        ("brake", diagram("A moment acts against it", sub("M", "O"), Some(-3.0))),
    ]
}

pub fn force_plots() -> Vec<(&'static str, ForcePlot)> {
    let plot = |title, points, marks| ForcePlot {
        wording: wording(title),
        time: PlotAxis { symbol: name("t"), unit: "s".to_owned(), told: Vec::new() },
        force: PlotAxis { symbol: name("F"), unit: "N".to_owned(), told: Vec::new() },
        points,
        area: Some(name("J")),
        marks,
    };
    let sine = (0..=60).map(|part| f64::from(part) / 60.0).map(|part| [0.004 * part, 250_000.0 * (PI * part).sin()]);
    vec![
        ("ramp", plot("A ramp", vec![[0.0, 0.0], [2.0, 36.0], [5.0, 36.0]], vec![(2.0, sub("t", "a"))])),
        ("pulse", plot("A short blow", sine.collect(), Vec::new())),
        (
            "told",
            ForcePlot {
                time: PlotAxis {
                    told: [0.0, 0.9, 1.8, 2.5, 2.55, 4.0].map(|time| (time, Math::Number(time.to_string()))).to_vec(),
                    ..plot("", Vec::new(), Vec::new()).time
                },
                force: PlotAxis {
                    told: vec![
                        (3.5, Math::Number("3.5".into())),
                        (-7.0, Math::Number("-7".into())),
                        (7.0, sub("F", "max")),
                        (7.2, Math::Number("7.2".into())),
                    ],
                    ..plot("", Vec::new(), Vec::new()).force
                },
                ..plot(
                    "Told by its graph",
                    vec![[0.0, 3.5], [0.9, 3.5], [0.9, -7.0], [1.8, -7.0], [2.5, 7.0], [2.55, 7.2], [4.0, 0.0]],
                    Vec::new(),
                )
            },
        ),
        ("both", plot("Forwards and back", vec![[0.0, 20.0], [1.0, 20.0], [3.0, -30.0], [4.0, 0.0]], Vec::new())),
    ]
}

pub fn mass_centres() -> Vec<(&'static str, MassCentre)> {
    let at = |text: &str, position, value: Option<[f64; 2]>| PlacedParticle {
        name: name(text),
        position,
        velocity: value.map(|value| LabelledVector::known(sub("v", text), value)),
        forces: Vec::new(),
    };
    let figure = |title, particles, centre| MassCentre {
        wording: wording(title),
        particles,
        centre,
        arrows: Travel::Velocity,
        origin: Some(name("O")),
        axes: xy(),
    };
    let three = vec![
        at("A", [0.0, 0.0], Some([3.0, 0.0])),
        at("B", [4.0, 0.0], Some([0.0, 2.0])),
        at("C", [1.0, 2.5], Some([0.0, 0.0])),
    ];
    let two = vec![at("A", [0.0, 0.0], Some([2.0, 0.0])), at("B", [3.0, 0.0], Some([-1.0, 0.0]))];
    vec![
        ("three", figure("Three particles", three, Some(at("G", [1.9, 0.7], Some([1.2, 0.8]))))),
        ("two", figure("Two particles", two, Some(at("G", [1.0, 0.0], Some([1.0, 0.0]))))),
    ]
}
