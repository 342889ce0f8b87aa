//! What is printed can be computed with: the numbers of a sheet lead to its answers, and
//! each line of a worked solution can be computed again.

mod givens;
mod laws;
mod lines;
mod printed;
mod zeros;
