//! How an expression is written down in Rust: operators, functions and the marks of calculus.

use super::{Expr, Function, Nabla, Node, Range};
use crate::rational::Rational;
use crate::symbol::Symbol;
use std::ops::{Add, Div, Mul, Neg, Sub};

macro_rules! operators {
    ($($left:ty),*) => {$(
        impl<R: Into<Expr>> Add<R> for $left {
            type Output = Expr;
            fn add(self, other: R) -> Expr {
                Expr::from(self).sum(other.into())
            }
        }
        impl<R: Into<Expr>> Sub<R> for $left {
            type Output = Expr;
            fn sub(self, other: R) -> Expr {
                // A subtracted sum stays together: a − (b + c).
                Expr::from(self).sum(other.into().negated())
            }
        }
        impl<R: Into<Expr>> Mul<R> for $left {
            type Output = Expr;
            fn mul(self, other: R) -> Expr {
                Expr::from(self).product(other.into())
            }
        }
        impl<R: Into<Expr>> Div<R> for $left {
            type Output = Expr;
            fn div(self, other: R) -> Expr {
                Expr::from(self).quotient(other.into())
            }
        }
        impl Neg for $left {
            type Output = Expr;
            fn neg(self) -> Expr {
                Expr::from(self).negated()
            }
        }
    )*};
}
operators!(Expr, &Expr, Symbol, &Symbol);

macro_rules! operators_on_integers {
    ($($right:ty),*) => {$(
        impl Add<$right> for i32 {
            type Output = Expr;
            fn add(self, other: $right) -> Expr {
                Expr::from(self) + other
            }
        }
        impl Sub<$right> for i32 {
            type Output = Expr;
            fn sub(self, other: $right) -> Expr {
                Expr::from(self) - other
            }
        }
        impl Mul<$right> for i32 {
            type Output = Expr;
            /// A sign that a program puts in, 1 or −1, is written as one.
            fn mul(self, other: $right) -> Expr {
                match self {
                    1 => other.into(),
                    -1 => -other,
                    _ => Expr::from(self) * other,
                }
            }
        }
        impl Div<$right> for i32 {
            type Output = Expr;
            fn div(self, other: $right) -> Expr {
                Expr::from(self) / other
            }
        }
    )*};
}
operators_on_integers!(Expr, &Expr, Symbol, &Symbol);

impl Symbol {
    /// Its power, an expression.
    pub fn pow(&self, exponent: impl Into<Rational>) -> Expr {
        Expr::from(self).pow(exponent)
    }

    /// Its value at `arguments`: `f_1.at([z - v * t])`.
    pub fn at(&self, arguments: impl Into<Vec<Expr>>) -> Expr {
        Expr::new(Node::Apply(self.clone(), arguments.into()))
    }
}

/// π
pub fn pi() -> Expr {
    Expr::new(Node::Pi)
}

/// i, the root of −1.
pub fn i() -> Expr {
    Expr::new(Node::ImaginaryUnit)
}

/// `numerator / denominator` as one number: ½ rather than a quotient of 1 and 2.
///
/// # Panics
/// If `denominator` is 0.
pub fn ratio(numerator: i64, denominator: i64) -> Expr {
    Expr::number(Rational::new(numerator, denominator).expect("a fraction within range"))
}

impl Function {
    /// Its value at `x`, an expression.
    pub fn of(self, x: impl Into<Expr>) -> Expr {
        Expr::new(Node::Function(self, x.into()))
    }
}

macro_rules! functions {
    ($($(#[$doc:meta])* $name:ident $function:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(x: impl Into<Expr>) -> Expr {
            Function::$function.of(x)
        }
    )*};
}
functions! {
    /// √x, with a real part ≥ 0.
    sqrt Sqrt;
    /// e^x
    exp Exp;
    /// sin x
    sin Sin;
    /// cos x
    cos Cos;
    /// tan x
    tan Tan;
    /// The principal arcsin x.
    asin Asin;
    /// The principal arccos x.
    acos Acos;
    /// The principal arctan x.
    atan Atan;
    /// Complex conjugate.
    conj Conj;
    /// Magnitude of a number or a vector.
    abs Abs;
    /// Real part.
    re Re;
    /// Imaginary part.
    im Im;
}

/// The vector with these Cartesian components.
pub fn vector(x: impl Into<Expr>, y: impl Into<Expr>, z: impl Into<Expr>) -> Expr {
    Expr::new(Node::Vector([x.into(), y.into(), z.into()]))
}

/// a·b
pub fn dot(a: impl Into<Expr>, b: impl Into<Expr>) -> Expr {
    Expr::new(Node::Dot(a.into(), b.into()))
}

/// a×b
pub fn cross(a: impl Into<Expr>, b: impl Into<Expr>) -> Expr {
    Expr::new(Node::Cross(a.into(), b.into()))
}

/// ∇f
pub fn gradient(f: impl Into<Expr>) -> Expr {
    Expr::new(Node::Nabla(Nabla::Gradient, f.into()))
}

/// ∇·a
pub fn divergence(a: impl Into<Expr>) -> Expr {
    Expr::new(Node::Nabla(Nabla::Divergence, a.into()))
}

/// ∇×a
pub fn curl(a: impl Into<Expr>) -> Expr {
    Expr::new(Node::Nabla(Nabla::Curl, a.into()))
}

/// ∇²f
pub fn laplacian(f: impl Into<Expr>) -> Expr {
    Expr::new(Node::Nabla(Nabla::Laplacian, f.into()))
}

/// ∂f/∂x. Nested calls make one higher derivative: `partial(partial(f, y), x)` is ∂²f/∂x∂y.
pub fn partial(f: impl Into<Expr>, x: impl Into<Expr>) -> Expr {
    let (f, x) = (f.into(), x.into());
    match f.node() {
        Node::Partial(of, by) => {
            Expr::new(Node::Partial(of.clone(), std::iter::once(x).chain(by.iter().cloned()).collect()))
        }
        _ => Expr::new(Node::Partial(f, vec![x])),
    }
}

/// dx. A total derivative is a quotient of two: `d(q) / d(t)`.
pub fn d(x: impl Into<Expr>) -> Expr {
    Expr::new(Node::Differential(x.into()))
}

/// ⟨f⟩, the average over time.
pub fn mean(f: impl Into<Expr>) -> Expr {
    Expr::new(Node::Mean(f.into()))
}

/// ∫ f dx dy … over `range`. Bounds belong to a single variable.
pub fn integral<const N: usize>(f: impl Into<Expr>, by: [Expr; N], range: Range) -> Expr {
    Expr::new(Node::Integral(f.into(), by.into(), range))
}

/// ∫ f dx from `from` to `to`.
pub fn integral_between(f: impl Into<Expr>, x: impl Into<Expr>, from: impl Into<Expr>, to: impl Into<Expr>) -> Expr {
    integral(f, [x.into()], Range::Between(from.into(), to.into()))
}
