//! A student's code, run so that a panic in it is an answer and not the end.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

/// A panic in a student's code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Panicked {
    /// What it says.
    pub(super) message: String,
    /// `file:line`.
    pub(super) place: String,
}

impl Panicked {
    /// Whether it is the mark of what is still to be written.
    pub(super) fn is_unwritten(&self) -> bool {
        ["not yet implemented", "not implemented"].iter().any(|start| self.message.starts_with(start))
    }
}

thread_local! {
    /// The last panic on this thread while a student's code is run; nothing at other times.
    static WATCHED: RefCell<Option<Panicked>> = const { RefCell::new(None) };
    static IS_WATCHING: RefCell<bool> = const { RefCell::new(false) };
}

static HOOK: Once = Once::new();

/// What `work` returns, or how it panicked. Nothing is printed.
pub(super) fn attempt<T>(work: impl FnOnce() -> T) -> Result<T, Panicked> {
    HOOK.call_once(|| {
        let before = take_hook();
        set_hook(Box::new(move |info| {
            if !IS_WATCHING.with_borrow(|is| *is) {
                return before(info);
            }
            let message = info.payload_as_str().unwrap_or("no message").to_owned();
            let place = info.location().map_or(String::new(), |place| format!("{}:{}", place.file(), place.line()));
            WATCHED.set(Some(Panicked { message, place }));
        }));
    });
    let before = IS_WATCHING.replace(true);
    let done = catch_unwind(AssertUnwindSafe(work));
    IS_WATCHING.set(before);
    done.map_err(|_| {
        WATCHED.take().unwrap_or_else(|| Panicked { message: "no message".to_owned(), place: String::new() })
    })
}
