//! Long work that may not be wanted any more.

/// Asked again and again during long work, which ends without an answer once it says yes.
pub type IsCancelled<'a> = &'a (dyn Fn() -> bool + Sync);

/// Of work that nobody can cancel.
pub const NEVER: IsCancelled<'static> = &|| false;

/// Why such work always has an answer.
pub const NOT_CANCELLED: &str = "nobody can cancel this";
