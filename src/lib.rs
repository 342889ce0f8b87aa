//! **Momentous** writes, solves, explains and marks problems on impulse, momentum and restitution.
//!
//! A problem is a short YAML file that says what is in the scene and what is asked. Each phase of its way has a type of
//! its own, made only by the function that checks it:
//!
//! ```
//! use std::collections::BTreeMap;
//! use std::sync::Arc;
//!
//! use momentous::exercise::Exercise;
//! use momentous::fault::Source;
//! use momentous::grade::{DecimalMark, Verdict};
//! use momentous::problem::{compile, load};
//!
//! let file = "
//! id: impact/wagons
//! title: Two wagons couple
//! level: intro
//! scene:
//!   axes: { x: to the right }
//!   bodies:
//!     A: { name: wagon A }
//!     B: { name: wagon B }
//!   stages:
//!     - impact: { between: [A, B], plastic: true, becomes: C }
//! given:
//!   m_A: { min: 10, max: 30, step: 1, unit: t }
//!   m_B: { min: 10, max: 30, step: 1, unit: t }
//!   v_A1: { min: 1, max: 3, step: 0.5, unit: m/s }
//!   v_B1: 0 m/s
//! text: >
//!   Wagon A ({{ m_A }}) rolls {{ v_A1 | motion }} into wagon B ({{ m_B }}), which {{ v_B1 | motion }}; they couple.
//! ask:
//!   - { find: v_C2, unit: m/s }
//! ";
//! let loaded = load(Source::new("wagons.yaml", file))?;    // keys and kinds of value
//! let problem = Arc::new(compile(loaded, None)?);           // names, dimensions, equations, plans
//! let exercise = Exercise::draw(&problem, 0, 7)?;           // a seed's numbers, solved
//! let answer = exercise.printed(&exercise.worked().form.parts[0]);
//! let report = exercise.grade(&BTreeMap::from([("v_C2".to_owned(), answer)]), DecimalMark::Point);
//! assert_eq!(report.parts[0].verdict, Verdict::Right);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! From there [`exercise::Exercise::sheet`], [`exercise::Exercise::outline`] and [`exercise::Exercise::key`] give what
//! [`render::Renderer`] prints as Markdown, LaTeX or HTML. How the rooms depend on each other stands in
//! `docs/architecture.md`.

#[cfg(feature = "cli")]
pub mod cli;

pub use momentous_bank as bank;
#[cfg(feature = "courses")]
pub use momentous_course as course;
#[cfg(feature = "courses")]
pub use momentous_course_pages as course_pages;
pub use momentous_exercise as exercise;
pub use momentous_explain as explain;
#[cfg(feature = "cli")]
pub use momentous_export as export;
pub use momentous_expr as expr;
pub use momentous_fault as fault;
pub use momentous_figure as figure;
pub use momentous_grade as grade;
pub use momentous_laws as laws;
pub use momentous_model as model;
pub use momentous_problem as problem;
pub use momentous_quantity as quantity;
pub use momentous_render as render;
pub use momentous_scene as scene;
pub use momentous_simulate as simulate;
pub use momentous_solve as solve;
#[cfg(feature = "courses")]
pub use momentous_store as store;
#[cfg(feature = "serve")]
pub use momentous_web as web;
pub use momentous_witness as witness;
pub use momentous_work as work;
