//! The ray and a plane: [`plane_values`](crate::kernels::plane_values).

use super::Form;
use super::expression::{dot, v};
use crate::numbers::Precision;

pub(super) fn form(precision: Precision) -> Form {
    let lines = vec![
        ("n_dot_d", dot(v("n"), v("d"))),
        ("n_dot_o", dot(v("n"), v("o"))),
        ("t", (v("D") - v("n_dot_o")) / v("n_dot_d")),
    ];
    super::form("plane", "where the ray meets the plane", "p = o + t d put into n . p - D = 0", precision, lines)
}
