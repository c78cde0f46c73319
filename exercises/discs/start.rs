/// Share [1] of what leaves a disc of radius `r_1` that arrives at one of radius `r_2` at a distance `h` [m] on its axis.
pub fn form_factor(r_1: f64, r_2: f64, h: f64) -> f64 {
    todo!()
}
