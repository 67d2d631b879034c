//! The known name nearest to a mistyped one.

/// The entry of `known` with the smallest edit distance to `word`, if that is at most a third of its length (and one at
/// least).
///
/// # Example
/// ```
/// use raytree::input::nearest;
/// assert_eq!(nearest("radus", ["center", "radius"]), Some("radius"));
/// assert_eq!(nearest("colour", ["center", "radius"]), None);
/// ```
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (word.chars().count() / 3).max(1);
    let mut best = None;
    for name in known {
        let distance = edit_distance(word, name);
        if distance <= limit && best.is_none_or(|(d, _)| distance < d) {
            best = Some((distance, name));
        }
    }
    best.map(|(_, name)| name)
}

/// The names as a list for a message: `"a", "b" or "c"`; at most twelve, then how many more.
pub fn one_of<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<String> = names.into_iter().map(|n| format!("`{n}`")).collect();
    match names.as_slice() {
        [] => "nothing: there are none".to_owned(),
        [only] => only.clone(),
        [most @ .., last] if most.len() < 16 => format!("{} or {last}", most.join(", ")),
        many => format!("{} or one of {} more", many[..16].join(", "), many.len() - 16),
    }
}

/// The number of characters to insert, delete, replace or swap with a neighbour to make `b` of `a`, case ignored.
fn edit_distance(a: &str, b: &str) -> usize {
    let a: Vec<char> = a.to_lowercase().chars().take(64).collect();
    let b: Vec<char> = b.to_lowercase().chars().take(64).collect();
    // Optimal string alignment over three rows.
    let mut before = vec![0; b.len() + 1];
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i; b.len() + 1];
        for j in 1..=b.len() {
            let substituted = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            row[j] = substituted.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}
