//! Puts mutants into source files, all at once: each is a branch that an environment variable chooses.
//!
//! `a < b` becomes `if crate::mutant(7) { a <= b } else { a < b }`, so one build serves all mutants, and trying one is
//! running the tests with `DELONE_MUTANT=7`. That makes hundreds of mutants cheap where a build takes minutes.
//!
//! Usage: `delone-mutants ROOT COUNT SKIPPED FILE...`, in a copy of the tree, never in the tree itself. `ROOT` is the
//! `lib.rs` that gets the function; of each group of files (groups are set apart by `--`) `COUNT` mutants are drawn:
//! those whose place and kind have the smallest hashes, so the sample is the same for everybody. `SKIPPED` lists numbers
//! that did not compile, set apart by commas. The list of mutants goes to standard output: number, group, place, kind.
//!
//! Mutated are comparisons, `&&` and `||`, arithmetic and bit operators, their assigning twins, and `!`; `next()` becomes
//! `prev()` and back, and statements that call or assign are left out: outside of tests, constants and macros.

use std::collections::BTreeSet;
use std::fs;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{BinOp, Expr, ExprBinary, ExprMethodCall, Stmt, UnOp, parse_quote};

/// A place that can be mutated.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Site {
    hash: u64,
    file: String,
    line: usize,
    column: usize,
    kind: String,
}

enum Task<'a> {
    List(&'a mut Vec<Site>),
    /// The chosen ones with their numbers.
    Apply(&'a [(usize, Site)]),
}

struct Visitor<'a> {
    file: &'a str,
    task: Task<'a>,
}

fn hash(text: &str) -> u64 {
    // FNV-1a, then mixed.
    let mut h = text.bytes().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| {
        (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3)
    });
    h ^= h >> 32;
    h.wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// What an operator becomes.
fn other(op: &BinOp) -> Option<(BinOp, &'static str)> {
    Some(match op {
        BinOp::Lt(_) => (parse_quote!(<=), "< to <="),
        BinOp::Le(_) => (parse_quote!(<), "<= to <"),
        BinOp::Gt(_) => (parse_quote!(>=), "> to >="),
        BinOp::Ge(_) => (parse_quote!(>), ">= to >"),
        BinOp::Eq(_) => (parse_quote!(!=), "== to !="),
        BinOp::Ne(_) => (parse_quote!(==), "!= to =="),
        BinOp::And(_) => (parse_quote!(||), "&& to ||"),
        BinOp::Or(_) => (parse_quote!(&&), "|| to &&"),
        BinOp::Add(_) => (parse_quote!(-), "+ to -"),
        BinOp::Sub(_) => (parse_quote!(+), "- to +"),
        BinOp::Mul(_) => (parse_quote!(+), "* to +"),
        BinOp::Div(_) => (parse_quote!(*), "/ to *"),
        BinOp::Rem(_) => (parse_quote!(/), "% to /"),
        BinOp::Shl(_) => (parse_quote!(>>), "<< to >>"),
        BinOp::Shr(_) => (parse_quote!(<<), ">> to <<"),
        BinOp::BitAnd(_) => (parse_quote!(|), "& to |"),
        BinOp::BitOr(_) => (parse_quote!(&), "| to &"),
        BinOp::BitXor(_) => (parse_quote!(&), "^ to &"),
        BinOp::AddAssign(_) => (parse_quote!(-=), "+= to -="),
        BinOp::SubAssign(_) => (parse_quote!(+=), "-= to +="),
        BinOp::ShlAssign(_) => (parse_quote!(>>=), "<<= to >>="),
        BinOp::ShrAssign(_) => (parse_quote!(<<=), ">>= to <<="),
        BinOp::BitOrAssign(_) => (parse_quote!(&=), "|= to &="),
        _ => return None,
    })
}

/// What a turn about a triangle becomes.
fn turned(call: &ExprMethodCall) -> Option<&'static str> {
    match call.method.to_string().as_str() {
        _ if !call.args.is_empty() => None,
        "next" => Some("prev"),
        "prev" => Some("next"),
        _ => None,
    }
}

/// Tells whether an expression binds names, as `if let` does in chains.
fn binds(e: &Expr) -> bool {
    match e {
        Expr::Let(_) => true,
        Expr::Binary(b) => binds(&b.left) || binds(&b.right),
        Expr::Paren(p) => binds(&p.expr),
        _ => false,
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| {
        a.path().is_ident("test")
            || (a.path().is_ident("cfg")
                && a.parse_args::<syn::Path>()
                    .is_ok_and(|p| p.is_ident("test")))
    })
}

impl Visitor<'_> {
    /// Notes a site, or returns its number if it is chosen.
    fn meet(&mut self, span: proc_macro2::Span, kind: &str) -> Option<usize> {
        let (line, column) = (span.start().line, span.start().column);
        match &mut self.task {
            Task::List(sites) => {
                sites.push(Site {
                    hash: hash(&format!("{}:{line}:{column}:{kind}", self.file)),
                    file: self.file.to_owned(),
                    line,
                    column,
                    kind: kind.to_owned(),
                });
                None
            }
            Task::Apply(chosen) => {
                let is_it = |s: &Site| {
                    s.file == self.file && (s.line, s.column) == (line, column) && s.kind == kind
                };
                chosen.iter().find(|(_, s)| is_it(s)).map(|(i, _)| *i)
            }
        }
    }
}

impl VisitMut for Visitor<'_> {
    fn visit_item_const_mut(&mut self, _: &mut syn::ItemConst) {}
    fn visit_item_static_mut(&mut self, _: &mut syn::ItemStatic) {}
    fn visit_impl_item_const_mut(&mut self, _: &mut syn::ImplItemConst) {}
    fn visit_type_mut(&mut self, _: &mut syn::Type) {}
    fn visit_generic_argument_mut(&mut self, _: &mut syn::GenericArgument) {}

    fn visit_expr_repeat_mut(&mut self, e: &mut syn::ExprRepeat) {
        self.visit_expr_mut(&mut e.expr);
    }

    fn visit_item_mod_mut(&mut self, m: &mut syn::ItemMod) {
        if !is_test(&m.attrs) {
            visit_mut::visit_item_mod_mut(self, m);
        }
    }

    fn visit_item_fn_mut(&mut self, f: &mut syn::ItemFn) {
        if f.sig.constness.is_none() && !is_test(&f.attrs) {
            visit_mut::visit_item_fn_mut(self, f);
        }
    }

    fn visit_impl_item_fn_mut(&mut self, f: &mut syn::ImplItemFn) {
        if f.sig.constness.is_none() {
            visit_mut::visit_impl_item_fn_mut(self, f);
        }
    }

    fn visit_stmt_mut(&mut self, s: &mut Stmt) {
        let site = match &*s {
            Stmt::Expr(
                Expr::MethodCall(_) | Expr::Call(_) | Expr::Assign(_) | Expr::Try(_),
                Some(end),
            ) => Some(end.span()),
            _ => None,
        };
        visit_mut::visit_stmt_mut(self, s);
        if let Some(number) = site.and_then(|span| self.meet(span, "statement left out")) {
            let number = proc_macro2::Literal::usize_unsuffixed(number);
            *s = parse_quote!(if !crate::mutant(#number) { #s });
        }
    }

    fn visit_expr_mut(&mut self, e: &mut Expr) {
        // Before the children change, for they have places of their own.
        let site = match &*e {
            Expr::Binary(b) if !binds(e) => other(&b.op).map(|(_, kind)| (b.op.span(), kind)),
            Expr::Unary(u) if matches!(u.op, UnOp::Not(_)) => Some((u.op.span(), "! dropped")),
            Expr::MethodCall(c) if turned(c).is_some() => {
                Some((c.method.span(), "next and prev swapped"))
            }
            _ => None,
        };
        visit_mut::visit_expr_mut(self, e);
        let Some(number) = site.and_then(|(span, kind)| self.meet(span, kind)) else {
            return;
        };
        let number = proc_macro2::Literal::usize_unsuffixed(number);
        let mutated: Expr = match &*e {
            Expr::Binary(b) => {
                let (op, _) = other(&b.op).expect("it was met");
                Expr::Binary(ExprBinary { op, ..b.clone() })
            }
            Expr::Unary(u) => (*u.expr).clone(),
            Expr::MethodCall(c) => {
                let method = syn::Ident::new(turned(c).expect("it was met"), c.method.span());
                Expr::MethodCall(ExprMethodCall {
                    method,
                    ..c.clone()
                })
            }
            _ => unreachable!("only these are met"),
        };
        *e = parse_quote!((if crate::mutant(#number) { #mutated } else { #e }));
    }
}

fn main() {
    let mut arguments = std::env::args().skip(1);
    let mut next = |what| {
        arguments
            .next()
            .unwrap_or_else(|| panic!("{what} is missing"))
    };
    let (root, count, skipped) = (next("ROOT"), next("COUNT"), next("SKIPPED"));
    let count: usize = count.parse().expect("COUNT is a number");
    let skipped: BTreeSet<usize> = skipped.split(',').filter_map(|s| s.parse().ok()).collect();
    let files: Vec<String> = arguments.collect();
    let mut chosen = Vec::new();
    for (group, files) in files.split(|f| f == "--").enumerate() {
        let mut sites = Vec::new();
        for file in files {
            let mut tree = parse(file);
            let task = Task::List(&mut sites);
            Visitor { file, task }.visit_file_mut(&mut tree);
        }
        sites.sort();
        let all = sites.len();
        eprintln!("group {group}: {all} places");
        for site in sites.into_iter().take(count) {
            let number = chosen.len() + 1;
            println!(
                "{number}\t{group}\t{}:{}:{}\t{}",
                site.file,
                site.line,
                site.column + 1,
                site.kind
            );
            chosen.push((number, site));
        }
    }
    chosen.retain(|(number, _)| !skipped.contains(number));
    for file in files.iter().filter(|f| *f != "--") {
        let mut tree = parse(file);
        let task = Task::Apply(&chosen);
        Visitor { file, task }.visit_file_mut(&mut tree);
        fs::write(file, prettyplease::unparse(&tree)).expect("the copy is writable");
    }
    let mut text = fs::read_to_string(&root).expect("ROOT is a file");
    text += "\n#[doc(hidden)]\n#[allow(missing_docs, dead_code)]\npub fn mutant(number: u32) -> bool {\n    \
             static ON: std::sync::OnceLock<u32> = std::sync::OnceLock::new();\n    \
             *ON.get_or_init(|| std::env::var(\"DELONE_MUTANT\").ok().and_then(|t| t.parse().ok()).unwrap_or(0)) == number\n}\n";
    fs::write(&root, text).expect("the copy is writable");
}

fn parse(file: &str) -> syn::File {
    let text = fs::read_to_string(file).unwrap_or_else(|e| panic!("{file}: {e}"));
    syn::parse_file(&text).unwrap_or_else(|e| panic!("{file}: {e}"))
}
