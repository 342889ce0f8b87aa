//! The methods by name, so that a table or a user can choose one.

use crate::method::Method;
use momentous_fault::did_you_mean;

use super::{
    ClosedForm, EventDriven, ExplicitEuler, LinearSolve, MoreauJean, Penalty, RungeKutta, SequentialImpulses,
    SymplecticEuler,
};

/// A numerical method, without its setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MethodKind {
    /// A formula.
    ClosedForm,
    /// The impact of bodies that touch, as one system of equations.
    LinearSolve,
    /// Exact motion between exactly located impacts.
    EventDriven,
    /// Adaptive, with a tolerance.
    RungeKutta,
    /// With a step.
    ExplicitEuler,
    /// With a step.
    SymplecticEuler,
    /// With a step.
    MoreauJean,
    /// With a step.
    Penalty,
    /// With a step.
    SequentialImpulses,
    /// A game engine, with a step.
    #[cfg(feature = "peer")]
    Rapier,
}

/// The meaning of a method's setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// It has none.
    None,
    /// The error of a step.
    Tolerance,
    /// The length of a step.
    Step,
}

impl MethodKind {
    /// All, cheapest first, in the order of tables and legends.
    pub const ALL: &[Self] = &[
        Self::ClosedForm,
        Self::LinearSolve,
        Self::EventDriven,
        Self::RungeKutta,
        Self::ExplicitEuler,
        Self::SymplecticEuler,
        Self::MoreauJean,
        Self::Penalty,
        Self::SequentialImpulses,
        #[cfg(feature = "peer")]
        Self::Rapier,
    ];

    /// Its name, as tables print it.
    #[must_use]
    pub fn name(self) -> &'static str {
        Method::<1>::name(self.with::<1>(1.0).as_ref())
    }

    /// The name as it is typed: small letters, hyphens for spaces, no order in brackets or at the end.
    #[must_use]
    pub fn typed(self) -> String {
        self.name().trim_end_matches(" 5(4)").to_lowercase().replace(' ', "-")
    }

    /// The method of that name.
    ///
    /// ```
    /// use momentous_simulate::MethodKind;
    /// assert_eq!(MethodKind::named("Runge_Kutta"), Ok(MethodKind::RungeKutta));
    /// ```
    ///
    /// # Errors
    /// What is meant, or which methods there are.
    pub fn named(text: &str) -> Result<Self, String> {
        let wanted = text.trim().to_lowercase().replace([' ', '_'], "-");
        if let Some(method) = Self::ALL.iter().find(|method| method.typed() == wanted) {
            return Ok(*method);
        }
        let names: Vec<String> = Self::ALL.iter().map(|method| method.typed()).collect();
        Err(match did_you_mean(&wanted, names.iter().map(String::as_str)) {
            Some(near) => format!("there is no such method; did you mean `{near}`?"),
            None => format!("the methods are {}", names.join(", ")),
        })
    }

    /// The meaning of its setting.
    #[must_use]
    pub fn setting(self) -> Setting {
        match self {
            Self::ClosedForm | Self::LinearSolve | Self::EventDriven => Setting::None,
            Self::RungeKutta => Setting::Tolerance,
            _ => Setting::Step,
        }
    }

    /// Whether it is a method of this program, and no other's engine.
    #[must_use]
    pub fn is_ours(self) -> bool {
        match self {
            #[cfg(feature = "peer")]
            Self::Rapier => false,
            _ => true,
        }
    }

    /// The setting where nothing is known of a scene: a step of a thousandth of the run, a tolerance of 1e-9.
    #[must_use]
    pub fn usual_setting(self) -> Option<f64> {
        match self.setting() {
            Setting::None => None,
            Setting::Tolerance => Some(1e-9),
            Setting::Step => Some(1e-3),
        }
    }

    /// A setting in words, where a step is a part of the run.
    #[must_use]
    pub fn setting_in_words(self, setting: Option<f64>) -> Option<String> {
        let setting = setting?;
        match self.setting() {
            Setting::None => None,
            Setting::Tolerance => Some(format!("tolerance {setting:.0e}")),
            Setting::Step => Some(format!("steps of 1/{:.0} of the run", 1.0 / setting)),
        }
    }

    /// The method at a setting of the table of costs, where a step is a part of a run that ends at a time (s).
    #[must_use]
    pub fn at<const D: usize>(self, setting: Option<f64>, end: f64) -> Box<dyn Method<D>> {
        let setting = setting.or(self.usual_setting()).unwrap_or(0.0);
        self.with(if self.setting() == Setting::Step { setting * end } else { setting })
    }

    /// The method with a step in s, or a tolerance; what has no setting leaves it aside.
    ///
    /// ```
    /// use momentous_simulate::{Method, MethodKind};
    /// assert_eq!(Method::<2>::name(MethodKind::Penalty.with(1e-3).as_ref()), "penalty");
    /// ```
    #[must_use]
    pub fn with<const D: usize>(self, setting: f64) -> Box<dyn Method<D>> {
        let step = setting;
        match self {
            Self::ClosedForm => Box::new(ClosedForm),
            Self::LinearSolve => Box::new(LinearSolve),
            Self::EventDriven => Box::new(EventDriven),
            Self::RungeKutta => Box::new(RungeKutta { tolerance: setting }),
            Self::ExplicitEuler => Box::new(ExplicitEuler { step }),
            Self::SymplecticEuler => Box::new(SymplecticEuler { step }),
            Self::MoreauJean => Box::new(MoreauJean { step }),
            Self::Penalty => Box::new(Penalty { step, stiffness: None }),
            Self::SequentialImpulses => Box::new(SequentialImpulses { step }),
            #[cfg(feature = "peer")]
            Self::Rapier => Box::new(super::Rapier { step }),
        }
    }
}
