//! What every face owes its reader: LaTeX whose braces close, MathML whose elements nest, and a line of Unicode that
//! is read back as what was written.
//!
//! Whoever writes equations down holds them to it in a test; a formula that breaks it would break the page instead.

use super::Equation;
use super::expr::{Expr, Node, Range};
use super::parse::parse_equation;
use super::rational::Rational;
use super::symbol::Symbol;

/// Holds for an equation whose faces are well-formed in every format.
///
/// # Errors
/// The face that is not, and why.
pub fn well_formed(equation: &Equation) -> Result<(), String> {
    let line = equation.to_string();
    if !is_balanced(&line, &[('(', ')'), ('⟨', '⟩')]) {
        return Err(format!("brackets do not close: {line}"));
    }
    let latex = equation.latex();
    if !is_balanced(&latex, &[('{', '}'), ('(', ')')]) {
        return Err(format!("braces do not close: {latex}"));
    }
    if latex.matches(r"\left").count() != latex.matches(r"\right").count() {
        return Err(format!(r"\left without \right: {latex}"));
    }
    let mathml = equation.mathml();
    if !is_mathml(&mathml) {
        return Err(format!("elements do not nest: {mathml}"));
    }
    Ok(())
}

/// Holds for an equation that the reader takes from its line of Unicode as it was, given its symbols. Fractions that
/// are one number may come back as a quotient of two, which looks the same.
///
/// # Errors
/// What the reader says or makes of it.
pub fn read_back(equation: &Equation) -> Result<(), String> {
    let line = equation.to_string();
    let mut known = Vec::new();
    for side in [&equation.lhs, &equation.rhs] {
        known.extend(side.symbols().into_iter().cloned());
        regions(side, &mut known);
    }
    match parse_equation(&line, &known) {
        Err(fault) => Err(format!("{line}: {fault}")),
        Ok(read) if read != as_read(equation) => Err(format!("{line} reads as {read}")),
        Ok(_) => Ok(()),
    }
}

/// The names that integrals run over.
fn regions(expr: &Expr, found: &mut Vec<Symbol>) {
    if let Node::Integral(.., Range::Region(region)) = expr.node() {
        found.push(region.clone());
    }
    expr.children().into_iter().for_each(|child| regions(child, found));
}

/// The equation with every fraction that takes a stroke to write (3/2, but not ½ nor 1.25) as the quotient it reads as.
fn as_read(equation: &Equation) -> Equation {
    Equation { lhs: apart(&equation.lhs), rhs: apart(&equation.rhs), relation: equation.relation }
}

fn apart(expr: &Expr) -> Expr {
    match expr.node() {
        Node::Number(value) if expr.to_string().contains('/') => {
            let whole = |n: i64| Expr::number(Rational::integer(n));
            whole(value.numerator()) / whole(value.denominator())
        }
        _ => expr.map(&mut apart),
    }
}

/// Whether brackets close in order.
fn is_balanced(text: &str, pairs: &[(char, char)]) -> bool {
    let mut open = Vec::new();
    for c in text.chars() {
        if let Some((_, close)) = pairs.iter().find(|(o, _)| *o == c) {
            open.push(*close);
        } else if pairs.iter().any(|(_, close)| *close == c) && open.pop() != Some(c) {
            return false;
        }
    }
    open.is_empty()
}

/// Whether `text` is one element, every element closes and every one of fixed arity has its children.
fn is_mathml(text: &str) -> bool {
    let mut open: Vec<(&str, usize)> = vec![("", 0)];
    for tag in text.split('<').skip(1).filter_map(|part| part.split('>').next()) {
        if let Some(name) = tag.strip_prefix('/') {
            let Some((opened, children)) = open.pop() else { return false };
            let wanted = match name {
                "msub" | "msup" | "mfrac" => Some(2),
                "msubsup" => Some(3),
                _ => None,
            };
            if opened != name || wanted.is_some_and(|wanted| wanted != children) {
                return false;
            }
            continue;
        }
        let Some((_, children)) = open.last_mut() else { return false };
        *children += 1;
        if !tag.ends_with('/') {
            open.push((tag.split(' ').next().unwrap_or(tag), 0));
        }
    }
    open.len() == 1 && open[0].1 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dimension::Dimension;
    use crate::expr::{integral, ratio};

    #[test]
    fn tells_what_is_broken() {
        assert!(is_balanced("{(a)}", &[('{', '}'), ('(', ')')]));
        for broken in ["{(a})", "{a", "a}"] {
            assert!(!is_balanced(broken, &[('{', '}'), ('(', ')')]), "{broken}");
        }
        assert!(is_mathml(r#"<math display="inline"><mrow><mi>a</mi><mspace width="1em"/></mrow></math>"#));
        for broken in
            ["<math><mi>a</math>", "<mi>a</mi><mi>b</mi>", "<msup><mi>a</mi></msup>", "</mi>", "</mi></>", "a"]
        {
            assert!(!is_mathml(broken), "{broken}");
        }
    }

    #[test]
    fn fractions_and_regions_are_read_back_and_a_product_of_vectors_is_not() {
        let x = Symbol::scalar("x", Dimension::ONE);
        let u = Symbol::vector("u", Dimension::ONE);
        let over = Range::Region(Symbol::scalar("Omega", Dimension::ONE));
        let fair = Equation::new(integral(ratio(3, 2) * &x, [(&x).into()], over), ratio(7, 4) + ratio(1, 2));
        assert_eq!(read_back(&fair), Ok(()));
        assert!(read_back(&Equation::new(&u * &u, &x)).is_err_and(|why| why.contains("two vectors")));
    }
}
