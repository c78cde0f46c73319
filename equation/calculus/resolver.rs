//! One call's work: expressions taken to components, from the inside out.

use super::components::{Value, antisymmetric, dot, length};
use super::coordinates::{component, coordinate, is_coordinate, varies};
use super::given::{Calculus, Rule};
use super::refusal::{DEEPEST, LARGEST, Unresolved, face, measure};
use super::tidy::{negative, product, quotient, sum};
use crate::expr::{Expr, Function, Nabla, Node, Range};
use crate::symbol::{Rank, Symbol};
use std::collections::HashMap;

pub(super) struct Resolver<'a> {
    pub calculus: &'a Calculus<'a>,
    /// What each name was declared as first: fields, variables and constants are known by name.
    declared: HashMap<&'a str, &'a Symbol>,
    values: HashMap<Expr, Value>,
    /// Derivatives by variable.
    pub slopes: HashMap<String, HashMap<Expr, Expr>>,
    /// Derivatives of fields with the rules applied.
    pub reduced: HashMap<Expr, Expr>,
    /// What is being replaced.
    pub open: Vec<Expr>,
    depth: usize,
    steps: usize,
}

impl<'a> Resolver<'a> {
    /// Ready for `inputs`, which are not too large for it.
    pub fn new(calculus: &'a Calculus<'a>, inputs: &[&'a Expr]) -> Result<Self, Unresolved> {
        let mut resolver = Self {
            calculus,
            declared: HashMap::new(),
            values: HashMap::new(),
            slopes: HashMap::new(),
            reduced: HashMap::new(),
            open: Vec::new(),
            depth: 0,
            steps: 0,
        };
        let mut nodes = 0;
        for expr in inputs.iter().chain(&calculus.sources) {
            measure(expr, &mut nodes, LARGEST, 0)?;
            resolver.declare(expr);
        }
        Ok(resolver)
    }

    fn declare(&mut self, expr: &'a Expr) {
        if let Node::Symbol(symbol) | Node::Apply(symbol, _) = expr.node() {
            self.declared.entry(symbol.name()).or_insert(symbol);
        }
        for child in expr.children() {
            self.declare(child);
        }
    }

    /// Whether a result is small enough.
    pub fn check(&self, value: &Value) -> Result<(), Unresolved> {
        let mut nodes = 0;
        value.parts().iter().try_for_each(|part| measure(part, &mut nodes, LARGEST, 0))
    }

    /// Accounts for `steps` more.
    pub fn spend(&mut self, steps: usize) -> Result<(), Unresolved> {
        self.steps += steps;
        if self.steps > LARGEST { Err(Unresolved::TooLarge) } else { Ok(()) }
    }

    /// One level down, for `work`.
    pub fn deeper<T>(&mut self, work: impl FnOnce(&mut Self) -> Result<T, Unresolved>) -> Result<T, Unresolved> {
        self.spend(1)?;
        if self.depth == DEEPEST {
            return Err(Unresolved::TooDeep);
        }
        self.depth += 1;
        let result = work(self);
        self.depth -= 1;
        result
    }

    /// `work` on what stands for `expr`, which must not lead back to it.
    pub fn opened<T>(
        &mut self,
        expr: &Expr,
        work: impl FnOnce(&mut Self) -> Result<T, Unresolved>,
    ) -> Result<T, Unresolved> {
        if self.open.contains(expr) {
            return Err(Unresolved::Circular(face(expr)));
        }
        self.open.push(expr.clone());
        let result = work(self);
        self.open.pop();
        result
    }

    /// What `expr` is, carried out.
    pub fn value(&mut self, expr: &Expr) -> Result<Value, Unresolved> {
        if let Some(value) = self.values.get(expr) {
            return Ok(value.clone());
        }
        let given = self.given(expr);
        let value = self.deeper(|this| match given {
            Some(given) => this.opened(expr, |this| this.value(given)).and_then(|value| like(expr, value)),
            None => this.carry_out(expr),
        })?;
        // These alone can outgrow what is written.
        if given.is_some() || matches!(expr.node(), Node::Nabla(..) | Node::Partial(..)) {
            self.check(&value)?;
        }
        self.values.insert(expr.clone(), value.clone());
        Ok(value)
    }

    /// What a hypothesis puts in the place of `expr`.
    fn given(&self, expr: &Expr) -> Option<&'a Expr> {
        match expr.node() {
            Node::Symbol(symbol) => self.calculus.symbols.get(symbol.name()).copied(),
            _ if self.calculus.forms.is_empty() => None,
            _ => self.calculus.forms.get(expr).copied(),
        }
    }

    pub fn scalar(&mut self, expr: &Expr) -> Result<Expr, Unresolved> {
        self.value(expr)?.into_scalar(expr)
    }

    fn vector(&mut self, expr: &Expr) -> Result<[Expr; 3], Unresolved> {
        self.value(expr)?.into_vector(expr)
    }

    fn carry_out(&mut self, expr: &Expr) -> Result<Value, Unresolved> {
        match expr.node() {
            Node::Number(_) | Node::Pi | Node::ImaginaryUnit => Ok(Value::Scalar(expr.clone())),
            Node::Symbol(symbol) => self.symbol(symbol),
            Node::Apply(symbol, arguments) => self.apply(symbol, arguments),
            Node::Sum(terms) => self.sum(expr, terms),
            Node::Product(factors) => self.product(expr, factors),
            Node::Quotient(above, below) => self.quotient(expr, above, below),
            Node::Negate(of) => self.value(of)?.map(|part| Ok(negative(part))),
            Node::Power(base, exponent) => Ok(Value::Scalar(self.scalar(base)?.pow(*exponent))),
            Node::Function(function, of) => self.function(expr, *function, of),
            Node::Vector([x, y, z]) => Ok(Value::Vector([self.scalar(x)?, self.scalar(y)?, self.scalar(z)?])),
            Node::Dot(a, b) => {
                let (a, b) = (self.vector(a)?, self.vector(b)?);
                Ok(Value::Scalar(dot(&a, &b)))
            }
            Node::Cross(a, b) => {
                let (a, b) = (self.vector(a)?, self.vector(b)?);
                Ok(Value::Vector(antisymmetric(|i, j| Ok(product([a[i].clone(), b[j].clone()])))?))
            }
            Node::Nabla(nabla, of) => self.nabla(*nabla, of),
            Node::Partial(of, by) => self.partial(of, by),
            Node::Integral(of, by, Range::Between(from, to)) if by.len() == 1 => {
                self.integral(expr, of, &by[0], from, to)
            }
            Node::Differential(of) => match self.value(of)? {
                Value::Scalar(of) if matches!(of.node(), Node::Symbol(_)) => {
                    Ok(Value::Scalar(Expr::new(Node::Differential(of))))
                }
                _ => Err(Unresolved::Opaque(face(expr))),
            },
            Node::Mean(_) | Node::Integral(..) => Err(Unresolved::Opaque(face(expr))),
        }
    }

    fn symbol(&mut self, symbol: &Symbol) -> Result<Value, Unresolved> {
        let symbol = self.declared(symbol)?;
        match symbol.rank() {
            Rank::Scalar => Ok(Value::Scalar(symbol.into())),
            Rank::Vector => {
                let [x, y, z] = [0, 1, 2].map(|axis| Expr::from(component(&symbol, axis)));
                Ok(Value::Vector([self.scalar(&x)?, self.scalar(&y)?, self.scalar(&z)?]))
            }
        }
    }

    /// The symbol as it was declared first, so that one name is one atom.
    fn declared(&self, symbol: &Symbol) -> Result<Symbol, Unresolved> {
        let Some(&known) = self.declared.get(symbol.name()) else { return Ok(symbol.clone()) };
        let same_kind = known.rank() == symbol.rank() && known.is_field() == symbol.is_field();
        // A coordinate may be written in other units than metres and seconds.
        if same_kind && (known.dimension() == symbol.dimension() || is_coordinate(symbol)) {
            Ok(known.clone())
        } else {
            Err(Unresolved::Ambiguous(symbol.to_string()))
        }
    }

    /// A function at arguments; vectors among them by their components.
    fn apply(&mut self, symbol: &Symbol, arguments: &[Expr]) -> Result<Value, Unresolved> {
        let symbol = self.declared(symbol)?;
        let mut scalars = Vec::new();
        for argument in arguments {
            match self.value(argument)? {
                Value::Scalar(argument) => scalars.push(argument),
                Value::Vector(parts) => scalars.extend(parts),
            }
        }
        let at = |symbol| Expr::new(Node::Apply(symbol, scalars.clone()));
        Ok(match symbol.rank() {
            Rank::Scalar => Value::Scalar(at(symbol)),
            Rank::Vector => Value::Vector([0, 1, 2].map(|axis| at(component(&symbol, axis)))),
        })
    }

    fn sum(&mut self, expr: &Expr, terms: &[Expr]) -> Result<Value, Unresolved> {
        self.spend(terms.len())?;
        let values = terms.iter().map(|term| self.value(term)).collect::<Result<Vec<_>, _>>()?;
        if values.iter().all(|value| matches!(value, Value::Scalar(_))) {
            return Ok(rebuilt(expr, values));
        }
        let parts = values.into_iter().zip(terms).map(|(value, term)| value.into_vector(term));
        let parts = parts.collect::<Result<Vec<_>, _>>()?;
        Ok(Value::Vector([0, 1, 2].map(|axis| sum(parts.iter().map(|part| part[axis].clone())))))
    }

    fn product(&mut self, expr: &Expr, factors: &[Expr]) -> Result<Value, Unresolved> {
        self.spend(factors.len())?;
        let values = factors.iter().map(|factor| self.value(factor)).collect::<Result<Vec<_>, _>>()?;
        let mut vectors = values.iter().enumerate().filter(|(_, value)| matches!(value, Value::Vector(_)));
        if vectors.next().is_none() {
            return Ok(rebuilt(expr, values));
        }
        if let Some((second, _)) = vectors.next() {
            return Err(Unresolved::Rank { face: face(&factors[second]), wanted: Rank::Scalar });
        }
        let along = |axis: usize| {
            product(values.iter().map(|value| match value {
                Value::Vector(parts) => parts[axis].clone(),
                Value::Scalar(factor) => factor.clone(),
            }))
        };
        Ok(Value::Vector([0, 1, 2].map(along)))
    }

    fn quotient(&mut self, expr: &Expr, above: &Expr, below: &Expr) -> Result<Value, Unresolved> {
        if let (Node::Differential(of), Node::Differential(by)) = (above.node(), below.node())
            && self.given(above).is_none()
            && self.given(below).is_none()
        {
            return self.total_derivative(expr, of, by);
        }
        match (self.value(above)?, self.scalar(below)?) {
            (Value::Scalar(above), below) => Ok(rebuilt(expr, vec![Value::Scalar(above), Value::Scalar(below)])),
            (parts, below) => parts.map(|part| Ok(quotient(part, below.clone()))),
        }
    }

    /// dq/dt. Where nothing ties q to t it is refused: the derivative would be 0, which nobody means by it.
    fn total_derivative(&mut self, expr: &Expr, of: &Expr, by: &Expr) -> Result<Value, Unresolved> {
        let variable = self.variable(by)?;
        let value = self.value(of)?;
        if value.parts().iter().any(|part| varies(part, &variable)) {
            self.slope_of(value, &variable)
        } else {
            Err(Unresolved::Opaque(face(expr)))
        }
    }

    fn function(&mut self, expr: &Expr, function: Function, of: &Expr) -> Result<Value, Unresolved> {
        let value = self.value(of)?;
        let apply = |of| Expr::new(Node::Function(function, of));
        match (function, value) {
            (_, value @ Value::Scalar(_)) => Ok(rebuilt(expr, vec![value])),
            (Function::Conj | Function::Re | Function::Im, parts) => parts.map(|part| Ok(apply(part))),
            (Function::Abs, Value::Vector(parts)) => Ok(Value::Scalar(length(&parts))),
            (_, value) => value.into_scalar(of).map(Value::Scalar),
        }
    }

    fn nabla(&mut self, nabla: Nabla, of: &Expr) -> Result<Value, Unresolved> {
        let [x, y, z] = [0, 1, 2].map(|axis| Expr::from(coordinate(axis)));
        let axes = [self.variable(&x)?, self.variable(&y)?, self.variable(&z)?];
        match nabla {
            Nabla::Gradient => {
                let of = self.scalar(of)?;
                let [x, y, z] = &axes;
                Ok(Value::Vector([self.slope(&of, x)?, self.slope(&of, y)?, self.slope(&of, z)?]))
            }
            Nabla::Divergence => {
                let parts = self.vector(of)?;
                let terms = parts.iter().zip(&axes).map(|(part, axis)| self.slope(part, axis));
                Ok(Value::Scalar(sum(terms.collect::<Result<Vec<_>, _>>()?)))
            }
            Nabla::Curl => {
                let parts = self.vector(of)?;
                Ok(Value::Vector(antisymmetric(|i, j| self.slope(&parts[j], &axes[i]))?))
            }
            Nabla::Laplacian => self.value(of)?.map(|part| {
                let twice = axes.iter().map(|axis| self.slope(&part, axis).and_then(|slope| self.slope(&slope, axis)));
                Ok(sum(twice.collect::<Result<Vec<_>, _>>()?))
            }),
        }
    }

    /// A symbol that something may vary with: one that no hypothesis replaces.
    pub fn variable(&self, by: &Expr) -> Result<Symbol, Unresolved> {
        match by.node() {
            Node::Symbol(symbol) if symbol.rank() == Rank::Scalar && self.given(by).is_none() => self.declared(symbol),
            _ => Err(Unresolved::Variable(face(by))),
        }
    }

    fn partial(&mut self, of: &Expr, by: &[Expr]) -> Result<Value, Unresolved> {
        let mut value = self.value(of)?;
        for variable in by.iter().rev() {
            value = match self.variable(variable) {
                Ok(symbol) => self.slope_of(value, &symbol)?,
                Err(refusal) => {
                    let argument = self.scalar(variable)?;
                    value.map(|part| self.slope_by_argument(&part, &argument).unwrap_or(Err(refusal.clone())))?
                }
            };
        }
        Ok(value)
    }

    /// Each component's derivative.
    pub fn slope_of(&mut self, value: Value, by: &Symbol) -> Result<Value, Unresolved> {
        value.map(|part| self.slope(&part, by))
    }

    /// What the derivative that a rule is about is given as.
    pub fn given_slope(&mut self, rule: &Rule) -> Result<Expr, Unresolved> {
        match rule.axis {
            None => self.scalar(&rule.value),
            Some(axis) => self.vector(&rule.value).map(|parts| parts[axis].clone()),
        }
    }
}

/// `value`, which stands for `expr`, as what that is: a vector symbol may be given as 0.
fn like(expr: &Expr, value: Value) -> Result<Value, Unresolved> {
    match expr.node() {
        Node::Symbol(symbol) if symbol.rank() == Rank::Vector => value.into_vector(expr).map(Value::Vector),
        Node::Symbol(_) => value.into_scalar(expr).map(Value::Scalar),
        _ => Ok(value),
    }
}

/// The form of `expr` over these numbers instead of its own parts, with nothing left out: 0·(1/0) stays.
fn rebuilt(expr: &Expr, values: Vec<Value>) -> Value {
    let mut values = values.into_iter();
    Value::Scalar(expr.map(&mut |old| match values.next() {
        Some(Value::Scalar(new)) => new,
        _ => old.clone(),
    }))
}
