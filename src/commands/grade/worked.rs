//! The course's own functions in place of a student's that are not right, so that what builds on them can be checked.

/// The file that the course's functions stand in, beside the student's.
pub(super) const FILE: &str = "worked_solution.rs";

/// The student's file with these functions set aside and the course's used wherever they are called. Nothing where one of
/// them cannot be found.
pub(super) fn put_in(source: &[u8], functions: &[String]) -> Option<String> {
    let mut source = std::str::from_utf8(source).ok()?.to_owned();
    for function in functions {
        let name = definition(&source, function)?;
        source.replace_range(name..name + function.len(), &format!("{function}_as_handed_in"));
    }
    // At the end, so that the lines keep their numbers.
    let names = functions.join(", ");
    Some(format!("{source}\n#[path = \"{FILE}\"]\nmod worked_solution;\nuse worked_solution::{{{names}}};\n"))
}

/// The solution as a module: without its check and its main function.
pub(super) fn module(solution: &str) -> String {
    let functions = &solution[..solution.find("fn main()").unwrap_or(solution.len())];
    functions.lines().filter(|line| line.trim() != "mod check;").map(|line| format!("{line}\n")).collect()
}

/// Where the name of a function stands in its definition, outside of comments.
fn definition(source: &str, function: &str) -> Option<usize> {
    source.match_indices(function).map(|(place, _)| place).find(|place| {
        let line = &source[source[..*place].rfind('\n').map_or(0, |end| end + 1)..*place];
        let after = source[place + function.len()..].trim_start();
        line.trim_end().ends_with("fn")
            && !line.contains("//")
            && line.ends_with(char::is_whitespace)
            && after.starts_with(['(', '<'])
    })
}
