//! Functions that are called, and expressions that are proved.

use super::Request;
use super::help::HelpArg;
use super::values::assignment;
use crate::prove::Question;
use crate::stop::Stop;
use clap::{ArgAction, Args};

pub const EVAL_EXAMPLES: &str = "\
Examples:
  lesson eval --list
  lesson eval fresnel n_i=1 n_t=1.5 theta=56.3deg
  lesson eval fresnel n_i=1 n_t=gold wavelength=550nm theta=45deg --json
  lesson eval thin-film wavelength=550nm n_i=1 theta=0 pol=s \\
      'layers=[{\"n\":\"mgf2\",\"d\":\"99.6nm\"}]' 'substrate={\"n\":1.52}'
  echo '{\"n_i\":1,\"n_t\":1.5,\"theta\":0.98}' | lesson eval fresnel --json-lines

Every output is printed as `name value` with 17 significant digits, so that the
double survives. With --json-lines a bad line gives {\"error\": …} in its place,
and the exit status is 2 at the end.";

#[derive(Debug, Args)]
pub struct EvalArgs {
    /// The function; `--list` names them all.
    #[arg(required_unless_present = "list")]
    function: Option<String>,
    /// Its inputs: a number, a text with a unit such as 56.3deg, or JSON for structured fields.
    #[arg(value_name = "NAME=VALUE", value_parser = assignment, conflicts_with_all = ["json_lines", "list"])]
    arguments: Vec<(String, String)>,
    /// Read one JSON object a line from standard input and write one a line, in order.
    #[arg(long, conflicts_with = "list")]
    json_lines: bool,
    /// Document every function: inputs, units, domains, outputs.
    #[arg(long)]
    list: bool,
    /// The outputs, or with --list the documentation, as one JSON document.
    #[arg(long, conflicts_with = "json_lines")]
    json: bool,
    #[command(flatten)]
    help: HelpArg,
}

impl EvalArgs {
    pub fn into_request(self) -> Result<Request, Stop> {
        Ok(match self.function {
            _ if self.list => Request::Functions { json: self.json },
            Some(function) if self.json_lines => Request::EvalLines { function },
            Some(function) => Request::Eval { function, arguments: self.arguments, json: self.json },
            None => return Err(Stop::at("function", "missing; `lesson eval --list` names them")),
        })
    }
}

pub const PROVE_EXAMPLES: &str = "\
Examples:
  lesson prove \"sin(a)^2 - sin(b)^2\" \"sin(a+b)*sin(a-b)\"
  lesson prove \"n1*cos(t1)\" \"n2*cos(t2)\" --given \"n1*sin(t1)=n2*sin(t2)\"
  lesson prove \"x + y = 2\" \"y = 2 - x\"
  lesson prove \"sqrt(x^2)\" \"|x|\" --real x

Written as on paper: + - * / ^, brackets, 2x, sin 2x, sqrt(x), |x|, conj(z),
Re(z), e^(i x), pi, i; names theta_1, theta1, θ₁, E_1'. What could mean two
things is refused.

Every name stands for a positive number, unless --given says otherwise or --real
names it. Proved means for all of them, where what the answer names is not zero;
a refutation names a point. Of a --given product that is zero every factor may
be: what is proved holds in each case. Undecided are nested roots, and relations
between sines of different numbers.

Exit status: 0 if proved, 1 if refuted, 2 if undecided or unreadable.";

#[derive(Debug, Args)]
pub struct ProveArgs {
    /// An expression, or an equation.
    #[arg(allow_hyphen_values = true)]
    from: String,
    /// What it is equal to; or the equation that follows.
    #[arg(allow_hyphen_values = true)]
    to: String,
    /// An equation that holds besides.
    #[arg(long, value_name = "EQUATION", allow_hyphen_values = true)]
    given: Vec<String>,
    /// Names that stand for real numbers of either sign.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    real: Vec<String>,
    /// The single steps inside the lines.
    #[arg(long)]
    unfold: bool,
    /// The answer as one JSON document.
    #[arg(long)]
    json: bool,
    // No -h: it would be taken out of -theta.
    /// This.
    #[arg(long, action = ArgAction::Help)]
    help: Option<bool>,
}

impl From<ProveArgs> for Question {
    fn from(args: ProveArgs) -> Self {
        let ProveArgs { from, to, given, real, unfold, json, help: _ } = args;
        Self { from, to, given, real, unfold, json }
    }
}
