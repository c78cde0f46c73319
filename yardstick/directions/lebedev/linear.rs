//! Linear systems of the size of a rule.

/// The solution of `rows` · x = `right`, by elimination with partial pivoting; not finite if there is none.
pub fn solve(mut rows: Vec<Vec<f64>>, mut right: Vec<f64>) -> Vec<f64> {
    for at in 0..right.len() {
        let largest = (at..right.len()).max_by(|&one, &other| rows[one][at].abs().total_cmp(&rows[other][at].abs()));
        let pivot = largest.unwrap_or(at);
        rows.swap(at, pivot);
        right.swap(at, pivot);
        let (above, below) = rows.split_at_mut(at + 1);
        let (top, head) = (&above[at], right[at]);
        for (row, value) in below.iter_mut().zip(&mut right[at + 1..]) {
            let share = row[at] / top[at];
            row[at..].iter_mut().zip(&top[at..]).for_each(|(entry, over)| *entry -= share * over);
            *value -= share * head;
        }
    }
    for at in (0..right.len()).rev() {
        let known = dot(&rows[at][at + 1..], &right[at + 1..]);
        right[at] = (right[at] - known) / rows[at][at];
    }
    right
}

/// The x that brings `rows` · x closest to `right`, from orthogonal columns (Gram & Schmidt).
pub fn least_squares(rows: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let terms = rows.first().map_or(0, Vec::len);
    let mut columns: Vec<Vec<f64>> = vec![];
    let mut upper = vec![vec![0.0; terms]; terms];
    for at in 0..terms {
        let mut column: Vec<f64> = rows.iter().map(|row| row[at]).collect();
        for (before, done) in columns.iter().enumerate() {
            let share = dot(done, &column);
            upper[before][at] = share;
            column.iter_mut().zip(done).for_each(|(entry, over)| *entry -= share * over);
        }
        upper[at][at] = dot(&column, &column).sqrt();
        column.iter_mut().for_each(|entry| *entry /= upper[at][at]);
        columns.push(column);
    }
    solve(upper, columns.iter().map(|column| dot(column, right)).collect())
}

pub fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}
