//! Why a root or a way is not possible.

use momentous_scene::stage::UpOrDown;

use super::warning::Warning;

/// Forces against the motion of a body, whichever way it moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Opposing {
    /// Friction of bodies that slide.
    #[error("friction")]
    Friction,
    /// A resistance that grows with the square of the speed.
    #[error("the resistance")]
    Resistance,
}

/// Why a root is not a solution, or a way not the one that a scene takes: what would be so if a condition were broken.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Reason {
    /// A body would pass through another, or through a surface.
    #[error("{0} would pass through {1}")]
    PassesThrough(String, String),
    /// A body would run through another on their line.
    #[error("{0} and {1} would run through each other on their line")]
    RunsThrough(String, String),
    /// A spring that releases would not drive two bodies apart.
    #[error("{0} and {1} would not be pushed apart")]
    NotPushedApart(String, String),
    /// A body would not catch up with another.
    #[error("{0} would not catch up with {1}, so there would be no impact")]
    NoCatchingUp(String, String),
    /// Two bodies would not lie along the line of impact.
    #[error("{0} and {1} would not lie along the line of impact, where their positions are")]
    LiesBeside(String, String),
    /// Two bodies would not lie along the string, in the order in which they are named.
    #[error("{0} and {1} would not lie along the string, where their positions are")]
    OffTheString(String, String),
    /// A swing between two angles would end higher or lower than is said.
    #[error("{0} would end {what} than it began, not {other}", what = heights(*.1)[0], other = heights(*.1)[1])]
    EndsOnOtherSide(String, UpOrDown),
    /// The body that catches up would lie ahead of the other.
    #[error("{0} would lie ahead of {1}, and could not run into it")]
    LiesAhead(String, String),
    /// Weight would draw a body down that nothing is said to hold.
    #[error("{0} moves up or down, and weight would change its velocity during {1}, which does not name it")]
    Unsupported(String, String),
    /// Two bodies would not press the spring between them.
    #[error("{0} would not catch up with {1}, and the spring would not be compressed")]
    NotCompressed(String, String),
    /// A spring relaxes in a stage.
    #[error("the spring is deformed less at the end than at the start")]
    SpringRelaxes,
    /// A spring is deformed further in a stage.
    #[error("the spring is deformed more at the end than at the start")]
    SpringDeforms,
    /// The string between two bodies that was taut would have to stretch.
    #[error("the string between {0} and {1} is taut already and would have to stretch")]
    StringStretches(String, String),
    /// The string between two bodies would stay slack.
    #[error("{1} would not move away from {0}, and the string would stay slack")]
    StaysSlack(String, String),
    /// One of several strings that are jerked together would have to push.
    #[error(
        "the string between {0} and {1} would go slack in the jerk: its ends approach each other, and a string cannot push"
    )]
    GoesSlackInJerk(String, String),
    /// No string of several would be jerked.
    #[error("no string would be jerked: the ends of none move apart")]
    NoneIsJerked,
    /// A body would not meet another, or an arm.
    #[error("{0} would not meet {1}")]
    NotMet(String, String),
    /// Two bodies would part as if they had not met, or draw each other on.
    #[error("{0} and {1} would not push each other, so there would be no impact")]
    NothingExchanged(String, String),
    /// A body would not reach a surface.
    #[error("{0} would not reach {1}")]
    NotReached(String, String),
    /// A body would not come down on its floor.
    #[error("{0} would not move towards the floor")]
    NotTowardsFloor(String),
    /// A body would leave what it strikes faster than it came.
    #[error("{0} would leave {1} faster than it arrived (e above 1), and energy would be created")]
    LeavesFaster(String, String),
    /// A loss of energy is negative.
    #[error("a negative loss would create kinetic energy")]
    NegativeLoss,
    /// An impact would create kinetic energy.
    #[error("kinetic energy would be created")]
    CreatesEnergy,
    /// A coefficient of restitution is below 0.
    #[error("a coefficient of restitution cannot be negative")]
    NegativeRestitution,
    /// A coefficient of restitution is above 1.
    #[error("a coefficient of restitution above 1 would create energy")]
    RestitutionAboveOne,
    /// A body that throws mass away would gain some.
    #[error("{0} would gain mass")]
    GainsMass(String),
    /// A body would lose more mass than it has.
    #[error("{1} that leaves {0} would be at least as heavy as {0} with all that is in it")]
    RunsOutOfMass(String, String),
    /// A body would stop, and friction reverse.
    #[error("{0} would stop and friction would reverse before the end")]
    StopsEarly(String),
    /// Friction would not act against the motion.
    #[error("{0} would have to slide forwards for friction to act backwards")]
    SlidesBackwards(String),
    /// A body would slide on another one the other way than its stage says.
    #[error("{0} would slide on {1} the other way")]
    SlidesOtherWay(String, String),
    /// A body would move the other way than its stage says.
    #[error("{0} would move the other way")]
    MovesBack(String),
    /// The same at the start or the end of a stage.
    #[error("{0} would move the other way at the {1} of {2}")]
    MovesBackAt(String, String, String),
    /// A body would move the other way, against which friction or a resistance is not written.
    #[error("{0}, and {1} would act the other way, too")]
    Against(Box<Reason>, Opposing),
    /// A body would come to rest before the end of the way along which forces act on it.
    #[error("{0} would come to rest before it had gone the whole way")]
    TurnsBack(String),
    /// The forces besides a resistance are not what drives a body.
    #[error("the forces besides the resistance would hold {0} back")]
    HeldBack(String),
    /// The forces besides a resistance are not what holds a body back.
    #[error("the forces besides the resistance would drive {0} on")]
    DrivenOn(String),
    /// A body would swing the other way than its stage says.
    #[error("{0} would swing the other way")]
    SwingsBack(String),
    /// A body would have turned back on its way.
    #[error("{0} would already swing back")]
    AlreadySwingsBack(String),
    /// A body would slide up what it slides down.
    #[error("{0} would slide back up {1}")]
    SlidesUp(String, String),
    /// A body that falls moves downwards at the end.
    #[error("{0} downwards at the end of {1}")]
    Downwards(String, String),
    /// A string that can only pull would go slack.
    #[error("{0} would go slack")]
    Slack(String),
    /// The cord of a body that swings would go slack.
    #[error("the cord would go slack before {0} to the end of {1}")]
    CordSlack(String, String),
    /// A body on the inside of a track would lose contact with it.
    #[error("{0} would leave the track before the end of {1}")]
    LeavesTrack(String, String),
    /// Weight, which a short contact leaves out, would give too much; whether the stage can include it.
    #[error(
        "weight would give {0} 10 % or more of its change of momentum in {1}, where it is neglected{hint}",
        hint = if *.2 { " (`include: [weight]` takes it into account)" } else { "" }
    )]
    WeightNotNegligible(String, String, bool),
    /// The same where a question is about weight.
    #[error("weight would give 10 % or more of the change of momentum, too much to be called negligible")]
    WeightNotSmall,
    /// A push exceeds static friction before it begins.
    #[error("the push would exceed static friction before it began")]
    BeyondBeforeStart,
    /// A push exceeds static friction when it begins.
    #[error("the push exceeds static friction from the beginning")]
    BeyondFromStart,
    /// A push does not exceed static friction when it begins.
    #[error("the push does not exceed static friction when it begins")]
    NotBeyondAtStart,
    /// A push never exceeds static friction.
    #[error("the push never exceeds static friction, so {0} stays at rest")]
    NeverBeyond(String),
    /// A push exceeds static friction.
    #[error("the push exceeds static friction, so {0} does not stay at rest")]
    Beyond(String),
    /// A push exceeds static friction the other way.
    #[error("the push exceeds static friction backwards, so {0} does not stay at rest")]
    BeyondBackwards(String),
    /// Static friction is weaker than kinetic friction.
    #[error("the coefficient of static friction of {0} is below that of kinetic friction")]
    StaticBelowKinetic(String),
    /// A push lifts a body off its floor.
    #[error("the push would lift {0} off its floor before the end")]
    LeavesFloor(String),
    /// A body that slides on a level floor moves up or down.
    #[error("{0} would move up or down, off its level floor")]
    LeavesItsFloor(String),
    /// A body that moves round a point would not come so near to it, or so far from it.
    #[error("{0} would not reach that distance")]
    OutOfReach(String),
    /// A slope would be steeper than upright.
    #[error("the slope would lean over, beyond the upright")]
    Overhangs,
    /// A distance from the centre that an orbit does not have.
    #[error("{0} would not come to that distance: its orbit lies between its least and its greatest distance")]
    OffTheOrbit(String),
    /// A body would move away from the centre before its nearest point, or towards it behind it.
    #[error(
        "{0} moves away from the centre in the half turn behind its nearest point, and towards it in the other half"
    )]
    RecedesElsewhere(String),
    /// A body that a push finds at rest moves already.
    #[error("{0} moves when the push begins")]
    MovesAlready(String),
    /// A body that a push finds sliding forwards does not.
    #[error("{0} would have to slide forwards when the push begins")]
    RestsOrSlidesBack(String),
    /// A thrust does not lift a body at once.
    #[error("the thrust is less than the weight at the start, so {0} stays on the ground for a while")]
    WaitsOnGround(String),
    /// A thrust lifts a body at once.
    #[error("the thrust exceeds the weight from the start, so {0} does not wait")]
    LiftsAtOnce(String),
    /// A thrust never lifts a body.
    #[error("even at the end the weight exceeds the thrust, so {0} does not lift off")]
    NeverLifts(String),
    /// A thrust lifts a body before it ends.
    #[error("the thrust exceeds the weight before the end, so {0} lifts off")]
    LiftsInTime(String),
    /// The cord of a conical pendulum would point upwards.
    #[error("the cord would have to point upwards")]
    CordUpwards,
    /// A body in a bowl would lie above its centre.
    #[error("it would lie above the centre of the bowl")]
    AboveCentre,
    /// A stage takes some time.
    #[error("{0} must take some time")]
    TakesTime(String),
    /// A stage would end before it starts.
    #[error("{0} would end before it starts")]
    EndsEarly(String),
    /// A stage would last a period longer.
    #[error("{0} would end a period later")]
    EndsLate(String),
    /// A stage lasts longer than what acts in it is known.
    #[error("the stage lasts longer than the time for which {0} is given")]
    OutlastsForce(String),
    /// A stage begins before what acts in it is known.
    #[error("the stage begins before the time from which {0} is given")]
    PrecedesForce(String),
    /// The pieces of a force are in order.
    #[error("the pieces of a force must be in order of time")]
    PiecesInOrder,
    /// The points of a graph are in order.
    #[error("the points of a graph must be in order of time")]
    PointsInOrder,
    /// A condition of the author's own.
    #[error("the problem requires `{0}`")]
    Required(String),
    /// The author asks for the other solution.
    #[error("the problem asks for the other solution")]
    OtherSolutionAsked,
    /// The other solution would have this property, in the author's words.
    #[error("{0}")]
    Otherwise(String),
    /// It is what a question asks.
    #[error("the question asks for it")]
    Asked,
}

/// Where a swing would end, and where it is said to.
fn heights(way: UpOrDown) -> [&'static str; 2] {
    match way {
        UpOrDown::Up => ["lower", "higher"],
        UpOrDown::Down => ["higher", "lower"],
    }
}

impl Reason {
    /// The name by which an author may allow it; `None` where it only tells one way of a scene from another.
    #[must_use]
    pub fn warning(&self) -> Option<Warning> {
        Some(match self {
            Self::PassesThrough(..) | Self::RunsThrough(..) | Self::NotPushedApart(..) => Warning::PassesThrough,
            Self::NoCatchingUp(..)
            | Self::LiesAhead(..)
            | Self::NotCompressed(..)
            | Self::NotMet(..)
            | Self::NothingExchanged(..)
            | Self::NotReached(..)
            | Self::NotTowardsFloor(..) => Warning::NoImpact,
            Self::LeavesFaster(..)
            | Self::NegativeLoss
            | Self::CreatesEnergy
            | Self::NegativeRestitution
            | Self::RestitutionAboveOne => Warning::EnergyCreated,
            Self::MovesBack(..)
            | Self::MovesBackAt(..)
            | Self::SwingsBack(..)
            | Self::AlreadySwingsBack(..)
            | Self::SlidesUp(..) => Warning::Reverses,
            Self::CordSlack(..) | Self::LeavesTrack(..) => Warning::GoesSlack,
            Self::WeightNotNegligible(..) => Warning::WeightNeglected,
            _ => return None,
        })
    }

    /// The same where something acts against the motion: then another way of moving is no matter of what an author allows.
    pub(super) fn against(self, opposing: Option<Opposing>) -> Self {
        match opposing {
            Some(opposing) => Self::Against(Box::new(self), opposing),
            None => self,
        }
    }

    /// Whether it only tells one way in which a stage can go from the other one.
    #[must_use]
    pub fn tells_ways(&self) -> bool {
        matches!(self, Self::HeldBack(_) | Self::DrivenOn(_))
    }

    /// Whether it says in which stage it is so.
    #[must_use]
    pub fn names_its_stage(&self) -> bool {
        if let Self::Against(reason, _) = self {
            return reason.names_its_stage();
        }
        matches!(
            self,
            Self::MovesBackAt(..)
                | Self::Downwards(..)
                | Self::CordSlack(..)
                | Self::LeavesTrack(..)
                | Self::WeightNotNegligible(..)
                | Self::TakesTime(_)
                | Self::EndsEarly(_)
                | Self::Unsupported(..)
        )
    }

    /// Whether it is so because the motion goes the other way than its stage says.
    #[must_use]
    pub fn is_of_direction(&self) -> bool {
        match self {
            Self::Against(reason, _) => reason.is_of_direction(),
            // One that turns back on its way has no one direction.
            Self::MovesBackAt(_, end, _) => end == "start",
            _ => matches!(
                self,
                Self::MovesBack(_)
                    | Self::SlidesBackwards(_)
                    | Self::SlidesOtherWay(..)
                    | Self::SwingsBack(_)
                    | Self::AlreadySwingsBack(_)
            ),
        }
    }

    /// Another name that an author may write for what happens then, where the scene has words for it.
    #[must_use]
    pub fn way_out(&self) -> Option<&'static str> {
        Some(match self {
            Self::Against(..) | Self::StopsEarly(_) | Self::SlidesBackwards(_) => {
                "a motion is told the way it goes, and one that turns back is a stage for each way"
            }
            Self::BeyondBeforeStart | Self::BeyondBackwards(_) => {
                "a body that starts against its axis needs a `direction` in that stage; otherwise give other values"
            }
            Self::SlidesOtherWay(..) => {
                "the upper body slides on in the way in which it is the faster one at the start; where the body below is the faster \
                    one, that is backwards, and so is its `direction`; a stage in which both come to move alike ends there: `until: together`"
            }
            Self::LiesBeside(..) | Self::OffTheString(..) => {
                "give the positions at which they meet, or on the straight string, and the direction from the first to the second; or leave the positions out"
            }
            Self::EndsOnOtherSide(..) => "write the other `way`, or leave it out",
            Self::Slack(_) => "it cannot push: let the stage end before it goes slack",
            Self::Unsupported(..) => "ask for nothing of it afterwards; a `push` can name it, too (`bodies`)",
            Self::StringStretches(..) => {
                "where the strings are jerked together, write one `taut` with all of them: `strings: [{ between: [A, B] }, { between: [B, C] }]`; where both move on together, one body with the mass of both, or a `tow` with the forces on each"
            }
            Self::GoesSlackInJerk(..) => {
                "leave that string out of `strings`: it goes slack at once, and the others are jerked as if it were not there"
            }
            _ => return None,
        })
    }

    /// The sentence of a check where the condition holds; `None` where that is not worth a word.
    #[must_use]
    pub fn what_holds(&self) -> Option<String> {
        match self {
            Self::PassesThrough(name, other) => Some(format!("{name} does not pass through {other}")),
            Self::NotPushedApart(first, second) => Some(format!("{first} and {second} are pushed apart")),
            Self::NeverBeyond(_) => Some("the push exceeds static friction before it ends".to_owned()),
            _ => None,
        }
    }
}
