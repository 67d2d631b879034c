//! Expressions: one value that is shown in symbols, shown with numbers, handed on as JSON, and evaluated.

use std::fmt::Write;
use std::ops::{Add, Div, Mul, Neg, Sub};

use serde::ser::{Serialize, SerializeSeq, Serializer};

use crate::numbers::{Precision, Real, flush_tiny};
use crate::tree::Value;

/// A formula's right-hand side.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A value by its name.
    Name(&'static str),
    /// A constant.
    Number(f64),
    /// An operation on its operands, which are evaluated from the left.
    Apply(Operation, Vec<Expression>),
}

/// What is done to numbers and vectors. Every one rounds as often as IEEE 754 says, in the precision of the formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operation {
    /// Sum of two numbers, or of two vectors.
    Plus,
    /// Difference of two numbers, or of two vectors.
    Minus,
    /// Product of two numbers; of a vector and a number; of two colours, component by component.
    Times,
    /// Quotient of two numbers, or of a vector and a number.
    Over,
    /// The number or vector with its sign turned.
    Negative,
    /// Square root.
    Root,
    /// Magnitude.
    Magnitude,
    /// The scalar product `x x' + y y' + z z'`, summed from the left.
    Dot,
    /// The vector product.
    Cross,
    /// The first component.
    X,
    /// The second component.
    Y,
    /// The third component.
    Z,
    /// The largest of some numbers; of equal ones the first; what is not a number never counts.
    Largest,
    /// The smallest of some numbers; of equal ones the first; what is not a number never counts.
    Smallest,
    /// A number or vector brought between two others, component by component.
    Clamp,
    /// A power, as the library `libm` computes it.
    Power,
    /// The number or vector rounded to single precision.
    Single,
    /// The number or vector with 0 for components below 2^-126 in magnitude, -0 too, which exact arithmetic does not take.
    Flush,
    /// `if a < b then x else y`.
    IfLess,
}

impl Operation {
    /// All of them.
    pub const ALL: [Self; 19] = [
        Self::Plus,
        Self::Minus,
        Self::Times,
        Self::Over,
        Self::Negative,
        Self::Root,
        Self::Magnitude,
        Self::Dot,
        Self::Cross,
        Self::X,
        Self::Y,
        Self::Z,
        Self::Largest,
        Self::Smallest,
        Self::Clamp,
        Self::Power,
        Self::Single,
        Self::Flush,
        Self::IfLess,
    ];

    /// The word for it in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plus => "+",
            Self::Minus => "-",
            Self::Times => "*",
            Self::Over => "/",
            Self::Negative => "neg",
            Self::Root => "sqrt",
            Self::Magnitude => "abs",
            Self::Dot => "dot",
            Self::Cross => "cross",
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Largest => "max",
            Self::Smallest => "min",
            Self::Clamp => "clamp",
            Self::Power => "pow",
            Self::Single => "f32",
            Self::Flush => "flush",
            Self::IfLess => "if<",
        }
    }

    /// The sign between its two operands, and how tightly it binds.
    fn sign(self) -> Option<(&'static str, u8)> {
        match self {
            Self::Plus => Some(("+", SUM)),
            Self::Minus => Some(("-", SUM)),
            Self::Times => Some(("*", PRODUCT)),
            Self::Over => Some(("/", PRODUCT)),
            Self::Dot => Some((".", PRODUCT)),
            Self::Cross => Some(("x", PRODUCT)),
            _ => None,
        }
    }
}

/// How tightly the parts of a text bind.
const LOOSE: u8 = 0;
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const SIGN: u8 = 3;
const TIGHT: u8 = 4;

/// The value of this name.
pub(super) fn v(name: &'static str) -> Expression {
    Expression::Name(name)
}

/// A constant.
pub(super) fn number(x: f64) -> Expression {
    Expression::Number(x)
}

/// An operation on one operand.
pub(super) fn of(operation: Operation, a: Expression) -> Expression {
    Expression::Apply(operation, vec![a])
}

/// The square root.
pub(super) fn sqrt(a: Expression) -> Expression {
    of(Operation::Root, a)
}

/// The magnitude.
pub(super) fn abs(a: Expression) -> Expression {
    of(Operation::Magnitude, a)
}

/// The scalar product.
pub(super) fn dot(a: Expression, b: Expression) -> Expression {
    Expression::Apply(Operation::Dot, vec![a, b])
}

/// The vector product.
pub(super) fn cross(a: Expression, b: Expression) -> Expression {
    Expression::Apply(Operation::Cross, vec![a, b])
}

/// The largest of some numbers.
pub(super) fn largest(all: impl IntoIterator<Item = Expression>) -> Expression {
    Expression::Apply(Operation::Largest, all.into_iter().collect())
}

/// The smallest of some numbers.
pub(super) fn smallest(all: impl IntoIterator<Item = Expression>) -> Expression {
    Expression::Apply(Operation::Smallest, all.into_iter().collect())
}

/// `x` brought between `least` and `most`.
pub(super) fn clamp(x: Expression, least: Expression, most: Expression) -> Expression {
    Expression::Apply(Operation::Clamp, vec![x, least, most])
}

/// `if a < b then x else y`.
pub(super) fn if_less(a: Expression, b: Expression, x: Expression, y: Expression) -> Expression {
    Expression::Apply(Operation::IfLess, vec![a, b, x, y])
}

macro_rules! operators {
    ($($name:ident :: $method:ident => $operation:ident),*) => { $(
        impl $name for Expression {
            type Output = Expression;
            fn $method(self, other: Expression) -> Expression {
                Expression::Apply(Operation::$operation, vec![self, other])
            }
        }
    )* };
}
operators!(Add::add => Plus, Sub::sub => Minus, Mul::mul => Times, Div::div => Over);

impl Neg for Expression {
    type Output = Expression;
    fn neg(self) -> Expression {
        of(Operation::Negative, self)
    }
}

impl Expression {
    /// The value, each operation rounded to `precision`; nothing where a name has no value, or an operation is not for
    /// what it is given.
    ///
    /// # Example
    /// ```
    /// use raytree::numbers::Precision;
    /// use raytree::steps::arithmetic::{Expression, Operation};
    /// use raytree::tree::Value;
    /// let third = Expression::Apply(Operation::Over, vec![Expression::Name("a"), Expression::Number(3.0)]);
    /// let value = |precision| third.evaluate(precision, &|name| (name == "a").then_some(Value::Number(1.0)));
    /// assert_eq!(value(Precision::F64), Some(Value::Number(1.0 / 3.0)));
    /// assert_eq!(value(Precision::F32), Some(Value::Number(f64::from(1.0_f32 / 3.0))));
    /// ```
    pub fn evaluate(&self, precision: Precision, value_of: &impl Fn(&str) -> Option<Value>) -> Option<Value> {
        match precision {
            Precision::F32 => self.value::<f32>(value_of),
            Precision::F64 => self.value::<f64>(value_of),
        }
    }

    fn value<R: Real>(&self, value_of: &impl Fn(&str) -> Option<Value>) -> Option<Value> {
        use Value::{Number, Vector};
        let (operation, operands) = match self {
            Self::Name(name) => return value_of(name),
            Self::Number(x) => return Some(Number(*x)),
            Self::Apply(operation, operands) => (*operation, operands.as_slice()),
        };
        let operand = |i: usize| operands.get(i)?.value::<R>(value_of);
        let scalar = |i: usize| match operand(i)? {
            Number(x) => Some(x),
            Vector(_) => None,
        };
        let vector = |i: usize| match operand(i)? {
            Vector(x) => Some(x),
            Number(_) => None,
        };
        // Every operand is a number of the precision already, so that nothing is lost on the way in.
        let two = |a: f64, b: f64, f: fn(R, R) -> R| f(R::from_f64(a), R::from_f64(b)).to_f64();
        let each = |a: [f64; 3], b: [f64; 3], f: fn(R, R) -> R| Vector(std::array::from_fn(|k| two(a[k], b[k], f)));
        let alike = |f: fn(R, R) -> R| match (operand(0)?, operand(1)?) {
            (Number(a), Number(b)) => Some(Number(two(a, b, f))),
            (Vector(a), Vector(b)) => Some(each(a, b, f)),
            _ => None,
        };
        let one = |f: fn(f64) -> f64| match operand(0)? {
            Number(a) => Some(Number(f(a))),
            Vector(a) => Some(Vector(a.map(f))),
        };
        match operation {
            Operation::Plus => alike(|a, b| a + b),
            Operation::Minus => alike(|a, b| a - b),
            Operation::Times => match (operand(0)?, operand(1)?) {
                (Number(a), Number(b)) => Some(Number(two(a, b, |a, b| a * b))),
                (Vector(a), Number(b)) | (Number(b), Vector(a)) => Some(each(a, [b; 3], |a, b| a * b)),
                (Vector(a), Vector(b)) => Some(each(a, b, |a, b| a * b)),
            },
            Operation::Over => match (operand(0)?, scalar(1)?) {
                (Number(a), b) => Some(Number(two(a, b, |a, b| a / b))),
                (Vector(a), b) => Some(each(a, [b; 3], |a, b| a / b)),
            },
            Operation::Negative => one(|a| -a),
            Operation::Root => Some(Number(R::from_f64(scalar(0)?).sqrt().to_f64())),
            Operation::Magnitude => one(f64::abs),
            Operation::Dot => {
                let (a, b) = (vector(0)?.map(R::from_f64), vector(1)?.map(R::from_f64));
                Some(Number((a[0] * b[0] + a[1] * b[1] + a[2] * b[2]).to_f64()))
            }
            Operation::Cross => {
                let (a, b) = (vector(0)?.map(R::from_f64), vector(1)?.map(R::from_f64));
                let minor = |i: usize, j: usize| (a[i] * b[j] - b[i] * a[j]).to_f64();
                Some(Vector([minor(1, 2), minor(2, 0), minor(0, 1)]))
            }
            Operation::X => Some(Number(vector(0)?[0])),
            Operation::Y => Some(Number(vector(0)?[1])),
            Operation::Z => Some(Number(vector(0)?[2])),
            Operation::Largest | Operation::Smallest => {
                let is_largest = operation == Operation::Largest;
                let mut best = if is_largest { f64::NEG_INFINITY } else { f64::INFINITY };
                for i in 0..operands.len() {
                    let x = scalar(i)?;
                    if if is_largest { x > best } else { x < best } {
                        best = x;
                    }
                }
                Some(Number(best))
            }
            Operation::Clamp => {
                let between = |x: f64, least: f64, most: f64| {
                    let x = if x < least { least } else { x };
                    if x > most { most } else { x }
                };
                match (operand(0)?, operand(1)?, operand(2)?) {
                    (Number(x), Number(a), Number(b)) => Some(Number(between(x, a, b))),
                    (Vector(x), Vector(a), Vector(b)) => {
                        Some(Vector(std::array::from_fn(|k| between(x[k], a[k], b[k]))))
                    }
                    _ => None,
                }
            }
            Operation::Power => Some(Number(libm::pow(scalar(0)?, scalar(1)?))),
            Operation::Single => one(|a| f64::from(a as f32)),
            Operation::Flush => one(flush_tiny),
            Operation::IfLess => operand(if scalar(0)? < scalar(1)? { 2 } else { 3 }),
        }
    }

    /// The expression as text, the number or vector of each name that `value_of` knows instead of the name.
    pub(super) fn text(&self, precision: Precision, value_of: &impl Fn(&str) -> Option<Value>) -> String {
        let mut out = String::new();
        self.write(&mut out, LOOSE, precision, value_of);
        out
    }

    /// Writes the expression, in parentheses where it binds less tightly than `needed`.
    fn write(&self, out: &mut String, needed: u8, precision: Precision, value_of: &impl Fn(&str) -> Option<Value>) {
        let (operation, operands) = match self {
            Self::Name(name) => {
                let word = value_of(name).map_or_else(|| (*name).to_owned(), |value| decimals(&value, precision));
                return in_place(out, &word, needed);
            }
            Self::Number(x) => return in_place(out, &decimal(*x, precision), needed),
            Self::Apply(operation, operands) => (*operation, operands.as_slice()),
        };
        let part = |out: &mut String, part: &Self, needed| part.write(out, needed, precision, value_of);
        match (operation, operands) {
            (_, [a, b]) if operation.sign().is_some() => {
                let Some((sign, binding)) = operation.sign() else { return };
                let opened = open(out, binding < needed);
                // Scalar and vector products stand for themselves: nothing else of their strength runs into them.
                let is_of_vectors = matches!(operation, Operation::Dot | Operation::Cross);
                let into = |a: &Self| match a {
                    Self::Apply(Operation::Dot | Operation::Cross, _) if binding == PRODUCT => TIGHT,
                    _ if is_of_vectors => TIGHT,
                    _ => binding,
                };
                part(out, a, into(a));
                write!(out, " {sign} ").ok();
                part(out, b, into(b).max(binding + 1));
                close(out, opened);
            }
            (Operation::Negative, [a]) => {
                let opened = open(out, SIGN < needed || out.ends_with("- "));
                out.push('-');
                part(out, a, TIGHT);
                close(out, opened);
            }
            (Operation::X | Operation::Y | Operation::Z, [a]) => {
                let axis = usize::from(operation == Operation::Y) + 2 * usize::from(operation == Operation::Z);
                let known = match a {
                    Self::Name(name) => value_of(name),
                    _ => None,
                };
                match known {
                    // With its numbers known, the component alone.
                    Some(Value::Vector(v)) => in_place(out, &decimal(v[axis], precision), needed),
                    _ => {
                        part(out, a, TIGHT);
                        write!(out, ".{}", operation.name()).ok();
                    }
                }
            }
            (Operation::IfLess, [a, b, x, y]) => {
                let opened = open(out, LOOSE < needed);
                for (word, operand) in [("if ", a), (" < ", b), (" then ", x), (" else ", y)] {
                    out.push_str(word);
                    part(out, operand, SUM);
                }
                close(out, opened);
            }
            _ => {
                out.push_str(operation.name());
                out.push('(');
                for (i, operand) in operands.iter().enumerate() {
                    out.push_str(if i == 0 { "" } else { ", " });
                    part(out, operand, LOOSE);
                }
                out.push(')');
            }
        }
    }
}

/// A name or a number where something is needed that binds so tightly: a negative number may want parentheses.
fn in_place(out: &mut String, word: &str, needed: u8) {
    let opened = open(out, word.starts_with('-') && needed > SUM);
    out.push_str(word);
    close(out, opened);
}

fn open(out: &mut String, is_needed: bool) -> bool {
    if is_needed {
        out.push('(');
    }
    is_needed
}

fn close(out: &mut String, opened: bool) {
    if opened {
        out.push(')');
    }
}

/// The shortest decimal that reads back to the same bits in this precision; `inf`, `-inf` and `nan` for the rest.
///
/// # Example
/// ```
/// use raytree::numbers::Precision;
/// use raytree::steps::arithmetic::decimal;
/// assert_eq!(decimal(0.1, Precision::F64), "0.1");
/// assert_eq!(decimal(f64::from(0.1_f32), Precision::F32), "0.1");
/// assert_eq!(decimal(f64::from(0.1_f32), Precision::F64), "0.10000000149011612");
/// assert_eq!(decimal(-2.0, Precision::F64), "-2");
/// ```
pub fn decimal(x: f64, precision: Precision) -> String {
    if x.is_nan() {
        return "nan".to_owned();
    }
    let single = x as f32;
    let text = match precision {
        Precision::F32 if f64::from(single) == x => format!("{single:?}"),
        _ => format!("{x:?}"),
    };
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

/// A number or the components of a vector, in parentheses, as [`decimal`] writes them.
pub fn decimals(value: &Value, precision: Precision) -> String {
    match value {
        Value::Number(x) => decimal(*x, precision),
        Value::Vector(x) => format!("({})", x.map(|x| decimal(x, precision)).join(", ")),
    }
}

impl Serialize for Expression {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Name(name) => serializer.serialize_str(name),
            Self::Number(x) => serializer.serialize_f64(*x),
            Self::Apply(operation, operands) => {
                let mut array = serializer.serialize_seq(Some(1 + operands.len()))?;
                array.serialize_element(operation.name())?;
                operands.iter().try_for_each(|operand| array.serialize_element(operand))?;
                array.end()
            }
        }
    }
}
