//! Two readers of formulas that share no code with the library: one of the JSON, one of the printed text.

use serde_json::Value as Json;

/// A number or a vector.
#[derive(Clone, Copy, Debug)]
pub(super) enum Quantity {
    Number(f64),
    Vector([f64; 3]),
}

use Quantity::{Number, Vector};

impl Quantity {
    fn number(self) -> f64 {
        match self {
            Number(x) => x,
            Vector(v) => panic!("{v:?} is no number"),
        }
    }

    fn vector(self) -> [f64; 3] {
        match self {
            Vector(v) => v,
            Number(x) => panic!("{x} is no vector"),
        }
    }

    /// The same bits; all that are no numbers are alike.
    pub(super) fn is_same(self, other: Self) -> bool {
        let same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        match (self, other) {
            (Number(a), Number(b)) => same(a, b),
            (Vector(a), Vector(b)) => (0..3).all(|k| same(a[k], b[k])),
            _ => false,
        }
    }
}

/// Arithmetic in single or in double precision.
#[derive(Clone, Copy, Debug)]
pub(super) struct Machine {
    pub(super) single: bool,
}

impl Machine {
    fn binary(self, sign: &str, a: f64, b: f64) -> f64 {
        if self.single {
            let (a, b) = (a as f32, b as f32);
            return f64::from(match sign {
                "+" => a + b,
                "-" => a - b,
                "*" => a * b,
                "/" => a / b,
                _ => panic!("{sign}"),
            });
        }
        match sign {
            "+" => a + b,
            "-" => a - b,
            "*" => a * b,
            "/" => a / b,
            _ => panic!("{sign}"),
        }
    }

    fn sqrt(self, x: f64) -> f64 {
        if self.single { f64::from((x as f32).sqrt()) } else { x.sqrt() }
    }

    fn sum3(self, x: [f64; 3]) -> f64 {
        self.binary("+", self.binary("+", x[0], x[1]), x[2])
    }

    /// An operation on its operands.
    fn apply(self, operation: &str, operands: &[Quantity]) -> Quantity {
        let each = |a: [f64; 3], b: [f64; 3]| Vector(std::array::from_fn(|k| self.binary(operation, a[k], b[k])));
        match (operation, operands) {
            ("+" | "-" | "*" | "/", [Number(a), Number(b)]) => Number(self.binary(operation, *a, *b)),
            ("+" | "-" | "*", [Vector(a), Vector(b)]) => each(*a, *b),
            ("*", [Number(a), Vector(b)]) => each([*a; 3], *b),
            ("*" | "/", [Vector(a), Number(b)]) => each(*a, [*b; 3]),
            ("neg", [Number(a)]) => Number(-a),
            ("neg", [Vector(a)]) => Vector(a.map(|x| -x)),
            ("abs", [Number(a)]) => Number(a.abs()),
            ("sqrt", [a]) => Number(self.sqrt(a.number())),
            ("dot", [a, b]) => {
                let (a, b) = (a.vector(), b.vector());
                Number(self.sum3(std::array::from_fn(|k| self.binary("*", a[k], b[k]))))
            }
            ("cross", [a, b]) => {
                let (a, b) = (a.vector(), b.vector());
                let times = |i: usize, j: usize| self.binary("*", a[i], b[j]);
                Vector([(1, 2), (2, 0), (0, 1)].map(|(i, j)| self.binary("-", times(i, j), times(j, i))))
            }
            ("x", [a]) => Number(a.vector()[0]),
            ("y", [a]) => Number(a.vector()[1]),
            ("z", [a]) => Number(a.vector()[2]),
            ("max", all) => {
                Number(all.iter().map(|x| x.number()).fold(f64::NEG_INFINITY, |m, x| if x > m { x } else { m }))
            }
            ("min", all) => {
                Number(all.iter().map(|x| x.number()).fold(f64::INFINITY, |m, x| if x < m { x } else { m }))
            }
            ("clamp", [Number(x), Number(a), Number(b)]) => Number(x.clamp(*a, *b)),
            ("clamp", [Vector(x), Vector(a), Vector(b)]) => Vector(std::array::from_fn(|k| x[k].clamp(a[k], b[k]))),
            ("pow", [a, b]) => Number(libm::pow(a.number(), b.number())),
            ("f32", [Number(a)]) => Number(f64::from(*a as f32)),
            ("f32", [Vector(a)]) => Vector(a.map(|x| f64::from(x as f32))),
            ("flush", [Vector(a)]) => Vector(a.map(|x| if x.abs() < 2.0_f64.powi(-126) { 0.0 } else { x })),
            ("if<", [a, b, x, y]) => {
                if a.number() < b.number() {
                    *x
                } else {
                    *y
                }
            }
            _ => panic!("{operation} of {operands:?}"),
        }
    }

    /// The value of an expression in JSON.
    pub(super) fn json(self, expression: &Json, value_of: &impl Fn(&str) -> Quantity) -> Quantity {
        match expression {
            Json::String(name) => value_of(name),
            Json::Number(x) => Number(x.as_f64().unwrap()),
            Json::Array(parts) => {
                let operands: Vec<Quantity> = parts[1..].iter().map(|part| self.json(part, value_of)).collect();
                self.apply(parts[0].as_str().unwrap(), &operands)
            }
            other => panic!("{other}"),
        }
    }

    /// The value of a printed text with numbers in it.
    pub(super) fn text(self, text: &str) -> Quantity {
        let mut reader = Reader { machine: self, rest: text };
        let value = reader.condition();
        assert_eq!(reader.rest.trim(), "", "{text}");
        value
    }
}

/// A value as JSON writes it, with `Infinity`, `-Infinity` and `NaN` as text.
pub(super) fn quantity(json: &Json) -> Quantity {
    let number = |json: &Json| match json {
        Json::String(word) => match word.as_str() {
            "Infinity" => f64::INFINITY,
            "-Infinity" => f64::NEG_INFINITY,
            "NaN" => f64::NAN,
            _ => panic!("{word}"),
        },
        _ => json.as_f64().unwrap(),
    };
    match json {
        Json::Array(v) => Vector([number(&v[0]), number(&v[1]), number(&v[2])]),
        _ => Number(number(json)),
    }
}

struct Reader<'t> {
    machine: Machine,
    rest: &'t str,
}

impl Reader<'_> {
    fn eats(&mut self, word: &str) -> bool {
        let rest = self.rest.trim_start();
        let Some(after) = rest.strip_prefix(word) else { return false };
        // A word of letters ends where letters end.
        let is_word = word.chars().all(char::is_alphanumeric);
        if is_word && after.starts_with(|c: char| c.is_alphanumeric()) {
            return false;
        }
        self.rest = after;
        true
    }

    fn must(&mut self, word: &str) {
        assert!(self.eats(word), "{word} is missing before {:?}", self.rest);
    }

    fn condition(&mut self) -> Quantity {
        if !self.eats("if") {
            return self.sum();
        }
        let a = self.sum();
        self.must("<");
        let b = self.sum();
        self.must("then");
        let x = self.sum();
        self.must("else");
        let y = self.sum();
        self.machine.apply("if<", &[a, b, x, y])
    }

    fn sum(&mut self) -> Quantity {
        let mut value = self.product();
        loop {
            let sign = if self.eats("+ ") {
                "+"
            } else if self.eats("- ") {
                "-"
            } else {
                return value;
            };
            let other = self.product();
            value = self.machine.apply(sign, &[value, other]);
        }
    }

    fn product(&mut self) -> Quantity {
        let mut value = self.signed();
        loop {
            let sign = if self.eats("* ") {
                "*"
            } else if self.eats("/ ") {
                "/"
            } else if self.eats(". ") {
                "dot"
            } else if self.eats("x ") {
                "cross"
            } else {
                return value;
            };
            let other = self.signed();
            value = self.machine.apply(sign, &[value, other]);
        }
    }

    fn signed(&mut self) -> Quantity {
        if self.eats("-") {
            let value = self.signed();
            return self.machine.apply("neg", &[value]);
        }
        let mut value = self.atom();
        for axis in ["x", "y", "z"] {
            if self.rest.starts_with(&format!(".{axis}")) {
                self.rest = &self.rest[2..];
                value = self.machine.apply(axis, &[value]);
            }
        }
        value
    }

    fn atom(&mut self) -> Quantity {
        if self.eats("(") {
            let list = self.list();
            return match list.as_slice() {
                [value] => *value,
                [x, y, z] => Vector([x.number(), y.number(), z.number()]),
                other => panic!("{other:?}"),
            };
        }
        for (word, value) in [("inf", f64::INFINITY), ("nan", f64::NAN)] {
            if self.eats(word) {
                return Number(value);
            }
        }
        for function in ["sqrt", "abs", "max", "min", "clamp", "pow", "f32", "flush"] {
            if self.eats(function) {
                self.must("(");
                let operands = self.list();
                return self.machine.apply(function, &operands);
            }
        }
        let rest = self.rest.trim_start();
        let mut end = 0;
        let bytes = rest.as_bytes();
        while end < bytes.len() {
            let after_e = end > 0 && bytes[end - 1] == b'e';
            match bytes[end] {
                b'0'..=b'9' | b'e' => end += 1,
                b'.' if bytes.get(end + 1).is_some_and(u8::is_ascii_digit) => end += 1,
                b'-' if after_e => end += 1,
                _ => break,
            }
        }
        let (digits, after) = rest.split_at(end);
        self.rest = after;
        Number(
            match self.machine.single {
                true => digits.parse::<f32>().map(f64::from),
                false => digits.parse::<f64>(),
            }
            .unwrap_or_else(|_| panic!("{rest:?}")),
        )
    }

    fn list(&mut self) -> Vec<Quantity> {
        let mut values = vec![self.condition()];
        while self.eats(",") {
            values.push(self.condition());
        }
        self.must(")");
        values
    }
}
