//! Figures: impulse-momentum diagrams and plots, as one drawing model with an SVG and a `TikZ` writer.

mod angular_diagram;
mod arm;
mod body;
mod coil;
mod drawing;
mod extent;
mod force_diagram;
mod force_plot;
mod geometry;
mod input;
mod mass_centre;
mod momentum_diagram;
mod panels;
mod place;
mod scale;
mod situation;
mod style;
mod surface;
mod svg;
mod ticks;
mod tikz;
mod typeset;

pub use angular_diagram::{AngularDiagram, AngularImpulse, AngularMomentum, AngularState, TurnDiagram};
pub use arm::{Arm, ArmDiagram, OnArm};
pub use body::Attach;
pub use drawing::{Drawing, Point, Role, Shape};
pub use extent::{Extent, bounds, extent, label_extent};
pub use force_diagram::ForceDiagram;
pub use force_plot::{ForcePlot, PlotAxis};
pub use input::{AxisMark, Form, LabelledVector, Wording};
pub use mass_centre::{MassCentre, PlacedParticle, Travel};
pub use momentum_diagram::{BodyMomentum, MomentumDiagram};
pub use place::{Overlap, overlaps};
pub use situation::{
    Across, AngleMark, Bowl, Carried, CarriedBy, CarriedEnd, Central, CentralPath, Conical, Contact, Depth, Exhaust,
    Face, Fall, Grains, Ground, Height, Launch, Layout, Line, LineSpring, Moment, Moving, MovingBody, Partner, Pulley,
    PulleySide, Ramp, Resisted, Rest, Ride, Situation, Space, Strung, Swing, SwingBy, SwingEnd, Target, Tie, Vane,
    Wall,
};
pub use svg::{style_sheet, svg, svg_file, svg_paper, svg_unstyled};
pub use ticks::Ticks;
pub use tikz::tikz;
