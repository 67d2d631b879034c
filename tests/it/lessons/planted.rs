//! What the tests of all lessons set up alike: the lesson unsolved and solved, and solved but for one planted mistake.

/// The lesson of this module's `check` with the functions of `exercise`, and with those of `solution`.
macro_rules! course {
    ($($function:ident),+ $(,)?) => {
        pub(super) fn unsolved() -> raytree::lessons::Lesson {
            check::lesson(check::Student { $($function: exercise::$function),+ })
        }

        fn student() -> check::Student {
            check::Student { $($function: solution::$function),+ }
        }

        pub(super) fn solved() -> raytree::lessons::Lesson {
            check::lesson(student())
        }
    };
}

/// The solution with one function replaced, a pair for each: the name of the mistake, and the lesson with it.
macro_rules! planted {
    ($($id:literal: $function:ident = $wrong:expr),+ $(,)?) => {
        vec![$(($id, check::lesson(check::Student { $function: $wrong, ..student() }))),+]
    };
}
