//! Sizes as expressions of x and y: `0.01 + 0.1*hypot(x, y)`.
//!
//! Functions are those of the crate `libm`, which computes alike on every machine. Powers bind closest
//! and to the right, then signs, then products, then sums, as on paper: −x² is not positive.

use delone::{Point, SizingField};
use pest::Parser;
use pest::error::{Error, ErrorVariant};
use pest::iterators::Pair;
use pest::pratt_parser::{Assoc, Op, PrattParser};
use pest_derive::Parser;
use std::sync::LazyLock;

/// Longest expression, in bytes: what is read and evaluated by recursion needs an end.
const LONGEST: usize = 1000;

#[derive(Parser)]
#[grammar = "sizing/expression.pest"]
struct Grammar;

static BINDING: LazyLock<PrattParser<Rule>> = LazyLock::new(|| {
    let left = |rule| Op::infix(rule, Assoc::Left);
    PrattParser::new()
        .op(left(Rule::plus) | left(Rule::minus))
        .op(left(Rule::times) | left(Rule::over))
        .op(Op::prefix(Rule::negate))
        .op(Op::infix(Rule::power, Assoc::Right))
});

/// A function of one number.
type Unary = fn(f64) -> f64;
/// A function of two numbers.
type Binary = fn(f64, f64) -> f64;

const UNARY: &[(&str, Unary)] = &[
    ("abs", libm::fabs),
    ("sqrt", libm::sqrt),
    ("exp", libm::exp),
    ("ln", libm::log),
    ("log10", libm::log10),
    ("sin", libm::sin),
    ("cos", libm::cos),
    ("tan", libm::tan),
    ("asin", libm::asin),
    ("acos", libm::acos),
    ("atan", libm::atan),
    ("tanh", libm::tanh),
];

const BINARY: &[(&str, Binary)] = &[
    ("hypot", libm::hypot),
    ("atan2", libm::atan2),
    ("pow", libm::pow),
];

/// Those of as many numbers as one likes.
const FOLDS: &[(&str, Binary)] = &[("min", libm::fmin), ("max", libm::fmax)];

/// A size for each place.
#[derive(Clone, Debug)]
pub struct Expression {
    root: Node,
}

#[derive(Clone, Debug)]
enum Node {
    Number(f64),
    X,
    Y,
    Unary(Unary, Box<Node>),
    Binary(Binary, Box<[Node; 2]>),
}

impl Expression {
    /// Reads an expression, or says what is wrong with it and where.
    pub fn parse(text: &str) -> Result<Self, String> {
        if text.len() > LONGEST {
            let length = text.len();
            return Err(format!(
                "{length} characters; expressions have at most {LONGEST}"
            ));
        }
        let parsed = Grammar::parse(Rule::field, text).map_err(explain)?;
        let formula = parsed
            .into_iter()
            .next()
            .expect("bug: a field is a formula");
        let root = Node::of(formula).map_err(explain)?;
        Ok(Self { root })
    }
}

impl SizingField for Expression {
    fn max_edge(&self, at: Point) -> f64 {
        self.root.value(at)
    }
}

impl Node {
    fn value(&self, at: Point) -> f64 {
        match self {
            Self::Number(number) => *number,
            Self::X => at.x,
            Self::Y => at.y,
            Self::Unary(function, of) => function(of.value(at)),
            Self::Binary(function, of) => function(of[0].value(at), of[1].value(at)),
        }
    }

    fn unary(function: Unary, of: Self) -> Self {
        Self::Unary(function, Box::new(of))
    }

    fn binary(function: Binary, left: Self, right: Self) -> Self {
        Self::Binary(function, Box::new([left, right]))
    }

    fn of(pair: Pair<Rule>) -> Result<Self, Error<Rule>> {
        match pair.as_rule() {
            Rule::formula => Self::of_formula(pair),
            Rule::call => Self::of_call(pair),
            Rule::name => Self::of_name(&pair),
            _ => {
                let number = pair.as_str().parse();
                Ok(Self::Number(
                    number.expect("bug: the grammar reads numbers"),
                ))
            }
        }
    }

    fn of_formula(pair: Pair<Rule>) -> Result<Self, Error<Rule>> {
        BINDING
            .map_primary(Self::of)
            .map_prefix(|_, of| Ok(Self::unary(|a| -a, of?)))
            .map_infix(|left, operator, right| {
                let function: Binary = match operator.as_rule() {
                    Rule::plus => |a, b| a + b,
                    Rule::minus => |a, b| a - b,
                    Rule::times => |a, b| a * b,
                    Rule::over => |a, b| a / b,
                    _ => libm::pow,
                };
                Ok(Self::binary(function, left?, right?))
            })
            .parse(pair.into_inner())
    }

    fn of_name(pair: &Pair<Rule>) -> Result<Self, Error<Rule>> {
        match pair.as_str() {
            "x" => Ok(Self::X),
            "y" => Ok(Self::Y),
            "pi" => Ok(Self::Number(std::f64::consts::PI)),
            name => Err(wrong(pair, format!("{name} is none of x, y and pi"))),
        }
    }

    fn of_call(call: Pair<Rule>) -> Result<Self, Error<Rule>> {
        let mut parts = call.clone().into_inner();
        let name = parts
            .next()
            .expect("bug: a call names its function")
            .as_str();
        let arguments = parts.map(Self::of).collect::<Result<Vec<Self>, _>>()?;
        let given = arguments.len();
        let takes = |n| wrong(&call, format!("{name} takes {n}, and {given} are given"));
        if let Some(function) = find(UNARY, name) {
            let [of] = <[Self; 1]>::try_from(arguments).map_err(|_| takes("one number"))?;
            return Ok(Self::unary(function, of));
        }
        if let Some(function) = find(BINARY, name) {
            let [of, and] = <[Self; 2]>::try_from(arguments).map_err(|_| takes("two numbers"))?;
            return Ok(Self::binary(function, of, and));
        }
        let Some(function) = find(FOLDS, name) else {
            let known = functions();
            return Err(wrong(
                &call,
                format!("no function {name}; there are {known}"),
            ));
        };
        let folded = arguments
            .into_iter()
            .reduce(|all, next| Self::binary(function, all, next));
        Ok(folded.expect("bug: a call has an argument"))
    }
}

fn find<F: Copy>(table: &[(&str, F)], name: &str) -> Option<F> {
    table
        .iter()
        .find(|(known, _)| *known == name)
        .map(|&(_, function)| function)
}

/// Names all functions.
pub fn functions() -> String {
    let unary = UNARY.iter().map(|(name, _)| *name);
    let others = BINARY.iter().chain(FOLDS).map(|(name, _)| *name);
    unary.chain(others).collect::<Vec<_>>().join(", ")
}

fn wrong(pair: &Pair<Rule>, message: String) -> Error<Rule> {
    Error::new_from_span(ErrorVariant::CustomError { message }, pair.as_span())
}

/// Shows what is wrong under the text, in the user's words.
fn explain(error: Error<Rule>) -> String {
    let said = error.renamed_rules(|rule| {
        match rule {
            Rule::EOI => "the end",
            Rule::plus => "+",
            Rule::minus | Rule::negate => "-",
            Rule::times => "*",
            Rule::over => "/",
            Rule::power => "^",
            Rule::number => "a number",
            Rule::name => "x, y, pi",
            Rule::call => "a function",
            _ => "a number, x, y, pi, a function or (",
        }
        .to_owned()
    });
    format!("no expression of x and y\n{said}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, x: f64, y: f64) -> f64 {
        let expression = Expression::parse(text).unwrap_or_else(|e| panic!("{text}: {e}"));
        expression.max_edge(Point::new(x, y))
    }

    #[test]
    fn expressions_mean_what_they_mean_on_paper() {
        for (text, expected) in [
            ("1e-3", 1e-3),
            (".5 + 2.", 2.5),
            ("x+y*2", 13.0),
            ("(x+y)*2", 16.0),
            ("-x^2", -9.0),
            ("2^-1", 0.5),
            ("2^3^2", 512.0),
            ("2**3", 8.0),
            ("-2*-x", 6.0),
            ("10-x-y", 2.0),
            ("30/x/y", 2.0),
            ("--x", 3.0),
            ("max(min(x, y), 0.1)", 3.0),
            ("min(y, x, 2*min(x,y), 9)", 3.0),
            (" 0.01\t+ 0.1 * hypot( x+0, y-1 ) ", 0.51),
            ("sqrt(abs(-4)) + ln(exp(1)) + log10(100)", 5.0),
            (
                "sin(pi/2) + cos(0) + tan(0) + asin(0) + acos(1) + atan(0) + tanh(0)",
                2.0,
            ),
            ("atan2(0, 1) + pow(x, 2)", 9.0),
        ] {
            let value = at(text, 3.0, 5.0);
            assert!((value - expected).abs() < 1e-15, "{text}: {value}");
        }
    }

    /// Each with where the mark stands, and words that must be said.
    #[test]
    fn mistakes_are_shown_where_they_are() {
        for (text, column, said) in [
            ("", 1, "a number"),
            ("0.01 +", 7, "a number"),
            ("2x", 1, "a number"),
            ("1.2.3", 1, "a number"),
            ("x y", 3, "the end"),
            ("(x", 3, "+"),
            ("x)", 2, "the end"),
            ("0.1 + z", 7, "z is none of x, y and pi"),
            ("1 + log(x)", 5, "no function log; there are abs"),
            ("hypot(x)", 1, "hypot takes two numbers, and 1 are given"),
            ("sin(x, y)", 1, "sin takes one number, and 2 are given"),
            ("x < 3", 3, "the end"),
            ("é", 1, "a number"),
        ] {
            let error = Expression::parse(text).unwrap_err();
            assert!(
                error.contains(&format!("--> 1:{column}\n")),
                "{text}: {error}"
            );
            assert!(error.contains(said), "{text}: {error}");
        }
    }

    #[test]
    fn depth_has_an_end() {
        let nested = |n: usize| format!("{}x{}", "(".repeat(n), ")".repeat(n));
        assert_eq!(at(&nested(499), 2.0, 0.0), 2.0);
        assert!(
            Expression::parse(&nested(500))
                .unwrap_err()
                .contains("at most 1000")
        );
        let minus = format!("{}x", "-".repeat(998));
        assert_eq!(at(&minus, 2.0, 0.0), 2.0);
    }

    #[test]
    fn noise_never_panics() {
        const WORDS: &[&str] = &[
            "x",
            "y",
            "1",
            ".5",
            "2.",
            "1e9",
            "1e",
            "+",
            "-",
            "*",
            "/",
            "^",
            "**",
            "(",
            ")",
            ",",
            " ",
            "min(",
            "max(",
            "sqrt(",
            "hypot(",
            "abs(",
            "z",
            "_",
            "\u{e4}",
            "\u{1f600}",
            "\n",
            "0x1",
        ];
        let mut state = 1_u64;
        let mut right = 0;
        for _ in 0..20_000 {
            let mut text = String::new();
            for _ in 0..(state >> 60) {
                state = state
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1);
                text += WORDS[(state >> 33) as usize % WORDS.len()];
            }
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            if let Ok(expression) = Expression::parse(&text) {
                expression.max_edge(Point::new(0.5, -1.0));
                right += 1;
            }
        }
        assert!(right > 100, "{right}");
        // Nothing takes longer than its length deserves, and depth does not overflow the stack.
        for nested in ["(", "-", "x(", "min(x,", "x^", "(((x+", "sqrt("] {
            let text = nested.repeat(LONGEST / nested.len());
            assert!(Expression::parse(&text).is_err(), "{nested}");
        }
    }
}
