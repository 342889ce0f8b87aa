//! The functions of a formula by name, in the functions that terms have.

use momentous_expr::Expr;
use momentous_expr::Function;

/// A function that may stand in a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Named {
    Sin,
    Cos,
    Tan,
    Cot,
    Sec,
    Csc,
    Arcsin,
    Arccos,
    Arctan,
    Arccot,
    Arcsec,
    Arccsc,
    /// The angle of the point (x, y), as our keys write it: `atan2(y, x)`.
    PointAngle,
    /// A power, as programs write it: `pow(x, 2)`.
    Pow,
    Sinh,
    Cosh,
    Tanh,
    Coth,
    Sech,
    Csch,
    Arsinh,
    Arcosh,
    Artanh,
    Exp,
    Ln,
    Log10,
    /// `log`, which has two meanings.
    Log,
    Abs,
    Sqrt,
    Cbrt,
}

use Named::{
    Abs, Arccos, Arccot, Arccsc, Arcosh, Arcsec, Arcsin, Arctan, Arsinh, Artanh, Cbrt, Cos, Cosh, Cot, Coth, Csc, Csch,
    Exp, Ln, Log, Log10, PointAngle, Pow, Sec, Sech, Sin, Sinh, Sqrt, Tan, Tanh,
};

/// Every spelling. Those that are not firm may as well be a product of the sheet's names: `lg`, `a sin`.
const SPELT: [(&str, Named, bool); 70] = [
    ("sin", Sin, true),
    ("cos", Cos, true),
    ("tan", Tan, true),
    ("tg", Tan, false),
    ("cot", Cot, true),
    ("ctg", Cot, false),
    ("sec", Sec, false),
    ("csc", Csc, true),
    ("cosec", Csc, true),
    ("arcsin", Arcsin, true),
    ("asin", Arcsin, false),
    ("arccos", Arccos, true),
    ("acos", Arccos, false),
    ("arctan", Arctan, true),
    ("atan", Arctan, false),
    ("arctg", Arctan, true),
    ("arccot", Arccot, true),
    ("acot", Arccot, false),
    ("arcsec", Arcsec, true),
    ("arccsc", Arccsc, true),
    ("atan2", PointAngle, true),
    ("arctan2", PointAngle, true),
    ("sinh", Sinh, false),
    ("cosh", Cosh, false),
    ("tanh", Tanh, false),
    ("coth", Coth, false),
    ("sech", Sech, false),
    ("csch", Csch, false),
    ("arsinh", Arsinh, true),
    ("asinh", Arsinh, false),
    ("arcsinh", Arsinh, true),
    ("arcosh", Arcosh, true),
    ("acosh", Arcosh, false),
    ("arccosh", Arcosh, true),
    ("artanh", Artanh, true),
    ("atanh", Artanh, false),
    ("arctanh", Artanh, true),
    ("exp", Exp, true),
    ("ln", Ln, true),
    ("lg", Log10, false),
    ("log10", Log10, true),
    ("log", Log, true),
    ("abs", Abs, true),
    ("sqrt", Sqrt, true),
    ("Sqrt", Sqrt, true),
    ("cbrt", Cbrt, true),
    ("Sin", Sin, true),
    ("Cos", Cos, true),
    ("Tan", Tan, true),
    ("Exp", Exp, true),
    ("Ln", Ln, true),
    ("cotan", Cot, true),
    ("asec", Arcsec, false),
    ("acsc", Arccsc, false),
    ("pow", Pow, true),
    ("power", Pow, true),
    ("Pow", Pow, true),
    ("Power", Pow, true),
    ("Abs", Abs, true),
    ("Cot", Cot, true),
    ("Sec", Sec, true),
    ("Csc", Csc, true),
    ("Sinh", Sinh, true),
    ("Cosh", Cosh, true),
    ("Tanh", Tanh, true),
    ("ArcSin", Arcsin, true),
    ("ArcCos", Arccos, true),
    ("ArcTan", Arctan, true),
    ("ArcSinh", Arsinh, true),
    ("ArcCosh", Arcosh, true),
];

/// All spellings with their functions, and whether no product of names is meant by them.
pub(super) fn spellings() -> impl Iterator<Item = (&'static str, Named, bool)> {
    SPELT.iter().copied()
}

impl Named {
    /// The function of that name.
    pub(super) fn find(name: &str) -> Option<Self> {
        SPELT.iter().find(|(spelt, ..)| *spelt == name).map(|(_, function, _)| *function)
    }

    /// Whether its argument is an angle, for which a plain number is not enough.
    pub(super) fn takes_angle(self) -> bool {
        matches!(self, Sin | Cos | Tan | Cot | Sec | Csc)
    }

    /// Whether its argument is a pure number.
    pub(super) fn takes_pure(self) -> bool {
        !matches!(self, Abs | Sqrt | Cbrt | Pow)
    }

    /// How many functions of a term it takes, which are costly at many digits.
    pub(super) fn cost(self) -> usize {
        match self {
            Abs | Sqrt | Pow => 0,
            Sinh | Cosh | Sech | Csch | Tan | Cot | Cbrt | Arcsin | Arccos | Arctan | Arccot | Arcsec | Arccsc
            | PointAngle => 2,
            Tanh | Coth => 4,
            _ => 1,
        }
    }

    /// The meaning of the power -1 of its name.
    pub(super) fn inverse(self) -> Option<Self> {
        Some(match self {
            Sin => Arcsin,
            Cos => Arccos,
            Tan => Arctan,
            Cot => Arccot,
            Sec => Arcsec,
            Csc => Arccsc,
            Sinh => Arsinh,
            Cosh => Arcosh,
            Tanh => Artanh,
            _ => return None,
        })
    }

    /// Its value at an argument.
    pub(super) fn of(self, argument: Expr) -> Expr {
        let one = Expr::one;
        let half = || Expr::ratio(1, 2);
        let apply = Expr::apply;
        let exp = |argument: Expr| apply(Function::Exp, argument);
        let ln = |argument: Expr| apply(Function::Ln, argument);
        let over = |function: Self| one() / function.of(argument.clone());
        let square = || argument.clone().powi(2);
        match self {
            Sin => apply(Function::Sin, argument),
            Cos => apply(Function::Cos, argument),
            Tan => apply(Function::Tan, argument),
            Cot => Cos.of(argument.clone()) / Sin.of(argument),
            Sec => over(Cos),
            Csc => over(Sin),
            Arcsin => apply(Function::Asin, argument),
            Arccos => apply(Function::Acos, argument),
            Arctan | PointAngle => argument.atan2(one()),
            Arccot => one().atan2(argument),
            Arcsec => Arccos.of(one() / argument),
            Arccsc => Arcsin.of(one() / argument),
            Sinh => half() * (exp(argument.clone()) - exp(-argument)),
            Cosh => half() * (exp(argument.clone()) + exp(-argument)),
            Tanh => {
                let [up, down] = [exp(argument.clone()), exp(-argument)];
                (up.clone() - down.clone()) / (up + down)
            }
            Coth => over(Tanh),
            Sech => over(Cosh),
            Csch => over(Sinh),
            Arsinh => ln(argument.clone() + (square() + one()).sqrt()),
            Arcosh => ln(argument.clone() + (square() - one()).sqrt()),
            Artanh => half() * ln((one() + argument.clone()) / (one() - argument)),
            Exp => exp(argument),
            Ln | Log => ln(argument),
            Log10 => ln(argument) / ln(Expr::integer(10)),
            Abs => apply(Function::Abs, argument),
            Pow => argument,
            Sqrt => argument.sqrt(),
            Cbrt => argument.power(Expr::ratio(1, 3)),
        }
    }
}
