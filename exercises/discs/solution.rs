/// Share [1] of what leaves a disc of radius `r_1` that arrives at one of radius `r_2` at a distance `h` [m] on its axis.
pub fn form_factor(r_1: f64, r_2: f64, h: f64) -> f64 {
    let (a, b) = (r_1 / h, r_2 / h);
    let s = 1.0 + (1.0 + b * b) / (a * a);
    // ½(s − √(s² − 4b²/a²)), the difference turned into a quotient.
    2.0 * (b / a).powi(2) / (s + (s * s - 4.0 * (b / a).powi(2)).sqrt())
}
