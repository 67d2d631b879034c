//! Questions as a LaTeX document.

use std::fmt::Write;

use super::{Question, TOLERANCE};

const HEAD: &str = "\\documentclass[a4paper]{article}
\\usepackage[T1]{fontenc}
\\usepackage[utf8]{inputenc}
\\setlength{\\parindent}{0pt}
\\begin{document}
";

/// The questions, numbered, without their answers.
pub fn to_latex(questions: &[Question], title: &str) -> String {
    let mut page = format!("{HEAD}\\section*{{{title}}}\n\\begin{{enumerate}}\n");
    for question in questions {
        write!(page, "\\item \\textbf{{{}.}} {}\n  \\begin{{enumerate}}\n", question.kind.title(), question.given).ok();
        for part in &question.parts {
            writeln!(page, "  \\item {}: \\rule{{2cm}}{{0.4pt}}", part.asked).ok();
        }
        page += "  \\end{enumerate}\n";
    }
    page + "\\end{enumerate}\n\\end{document}\n"
}

/// The answers alone.
pub fn to_latex_answers(questions: &[Question], title: &str) -> String {
    let mut page = format!("{HEAD}\\section*{{{title}: answers}}\n");
    writeln!(page, "An answer counts if it is within {TOLERANCE} of the one here.\n\\begin{{enumerate}}").ok();
    for question in questions {
        write!(page, "\\item \\textbf{{{}.}}\n  \\begin{{enumerate}}\n", question.kind.title()).ok();
        for part in &question.parts {
            writeln!(page, "  \\item {}: ${}$", part.asked, part.answer_text()).ok();
        }
        page += "  \\end{enumerate}\n";
    }
    page + "\\end{enumerate}\n\\end{document}\n"
}
