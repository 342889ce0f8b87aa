//! The pair of order 5 as a plain loop for one particle about a fixed centre: what the integrator is measured against.

/// Place and velocity.
pub type State = [f64; 4];

const NODES: [f64; 7] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0];

const STAGES: [[f64; 6]; 7] = [
    [0.0; 6],
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0, 0.0],
    [19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0, 0.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0, 0.0],
    [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];

const ERROR: [f64; 7] =
    [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];

/// The slope under the attraction of the centre.
fn slope(parameter: f64, [x, y, u, v]: State) -> State {
    let square = x * x + y * y;
    let pull = -parameter / (square * square.sqrt());
    [u, v, pull * x, pull * y]
}

/// The state at the end, and the number of times that the slope was worked out.
pub fn run(parameter: f64, start: State, end: f64, tolerance: f64) -> (State, usize) {
    let (mut time, mut state, mut length, mut evaluations) = (0.0, start, end / 100.0, 1);
    let mut slopes = [[0.0; 4]; 7];
    slopes[0] = slope(parameter, state);
    let (mut way, mut speed) = (0.0_f64, state[2].abs().max(state[3].abs()));
    while time < end {
        let last = length >= end - time;
        let step = if last { end - time } else { length };
        let mut next = state;
        for stage in 1..NODES.len() {
            for (place, (next, state)) in next.iter_mut().zip(state).enumerate() {
                let change: f64 = (0..stage).map(|before| STAGES[stage][before] * slopes[before][place]).sum();
                *next = state + step * change;
            }
            slopes[stage] = slope(parameter, next);
            evaluations += 1;
        }
        let gone = way.max((next[0] - start[0]).abs()).max((next[1] - start[1]).abs());
        let fast = speed.max(next[2].abs()).max(next[3].abs());
        let mut error = 0.0_f64;
        for place in 0..next.len() {
            let off: f64 = ERROR.iter().zip(&slopes).map(|(weight, slope)| weight * slope[place]).sum();
            error = error.max((step * off).abs() / (tolerance * if place < 2 { gone } else { fast }));
        }
        length = step * (0.9 * error.max(1e-10).powf(-0.2)).clamp(0.2, 5.0);
        if error > 1.0 {
            continue;
        }
        time = if last { end } else { time + step };
        (state, way, speed) = (next, gone, fast);
        slopes[0] = slopes[6];
    }
    (state, evaluations)
}
