//! Words by which people look for problems, and those that problems have in their place.

/// The words typed, and those looked for instead: a problem that has one of these is found. Each is as [`super::spelling::plain`]
/// writes it, and finds every word that begins so.
pub(super) const RELATIVES: [(&[&str], &[&str]); 36] = [
    (
        &["coefficient of restitution", "restitution coefficient", "law of restitution", "cor", "bounciness"],
        &["restitution"],
    ),
    (&["elastic", "perfectly elastic", "completely elastic"], &["restitution", "elastic"]),
    (
        &[
            "perfectly inelastic",
            "completely inelastic",
            "totally inelastic",
            "plastic",
            "perfectly plastic",
            "stick together",
            "sticky",
        ],
        &["plastic", "couple", "coupling", "embed"],
    ),
    (&["inelastic", "partly elastic", "partially elastic"], &["restitution", "plastic", "couple", "coupling"]),
    (&["collision", "collisions", "collide", "crash", "smash"], &["impact", "collision", "collide"]),
    (&["head on", "one dimensional", "one dimension", "1d", "central impact", "direct impact"], &["direct"]),
    (&["glancing", "oblique", "off centre", "oblique impact"], &["oblique"]),
    (&["2d", "two dimensional", "two dimensions", "plane", "in the plane"], &["two dimensions", "vectors", "oblique"]),
    (&["3d", "three dimensional", "three dimensions"], &["three dimensions"]),
    (&["explosion", "explode", "explodes", "burst"], &["explosion", "burst", "separation", "recoil", "fly apart"]),
    (&["recoil", "gun", "cannon", "rifle"], &["recoil", "cannon"]),
    (
        &["centre of mass", "mass centre", "centre of gravity", "centroid", "barycentre", "com"],
        &["mass centre", "centre of mass", "system of particles"],
    ),
    (
        &["newtons cradle", "cradle"],
        &["three gliders", "successive impacts", "several stages direct", "who is fastest"],
    ),
    (&["ballistic pendulum"], &["ballistic pendulum"]),
    (&["pendulum"], &["pendulum", "swing"]),
    (&["variable mass", "changing mass", "mass flow", "open system"], &["variable mass", "changing mass", "streams"]),
    (&["rocket", "rockets", "propulsion", "thrust"], &["rocket", "thrust", "lander"]),
    (&["jet", "hose", "fluid", "water jet"], &["jet", "hose", "streams"]),
    (&["conveyor", "conveyor belt", "belt"], &["belt"]),
    (&["linear momentum"], &["momentum"]),
    (
        &["conservation of momentum", "momentum conservation", "conserved", "conservation"],
        &["conservation", "conserved"],
    ),
    (&["impulse momentum theorem", "impulse momentum", "impulse and momentum"], &["impulse"]),
    (
        &["average force", "mean force", "impact force", "impulsive force"],
        &["mean force", "average force", "impulsive"],
    ),
    (&["force time graph", "force against time", "f t graph"], &["variable force", "graph"]),
    (&["angular momentum", "moment of momentum"], &["angular momentum"]),
    (&["torque", "couple moment"], &["variable moment", "angular impulse", "moment"]),
    (&["rotation", "rotational", "spin", "spinning", "turning"], &["angular momentum", "angular velocity"]),
    (&["moment of inertia", "rotational inertia"], &["moment of inertia"]),
    (&["orbit", "orbits", "orbital", "kepler", "planet", "gravity assist"], &["central force", "orbit", "satellite"]),
    (&["kinetic energy", "energy loss", "energy lost", "loss of energy"], &["energy"]),
    (&["bounce", "bounces", "rebound", "bouncing ball"], &["bouncing", "bounce", "rebound"]),
    (&["rope", "ropes", "string", "strings", "cord", "cable"], &["string", "rope", "cord", "cable", "tension"]),
    (&["billiards", "billiard", "pool", "snooker"], &["billiard"]),
    (&["imperial", "us units", "customary units", "feet", "pounds"], &["us units"]),
    (&["in symbols", "symbolic", "algebra"], &["formula", "symbols"]),
    (&["skateboard", "railway", "train", "rail car", "railroad"], &["wagon", "train", "trolley"]),
];
